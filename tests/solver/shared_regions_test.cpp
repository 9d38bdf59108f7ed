// SPDX-License-Identifier: Apache-2.0
//
// What shared_regions.h promises, against designs of random stacks at states inside a cell: every feasible one is in
// some part, and the bounds of all parts on the way there hold for it.
#include "solver/shared_regions.h"

#include <cmath>
#include <limits>

#include "catch.h"
#include "sanitized.h"
#include "solver/random_stack.h"
#include "solver/rest_curve.h"

namespace shared_regions_test {

namespace {

using namespace zoo;

struct Counts {
  std::size_t feasible = 0, parts = 0, cells = 0;
  std::size_t exact = 0, equal = 0;  ///< components that a design hands on exactly; where what was said counts as equal
};

/// What a part says of designs that hand this on, from these states.
struct Claim {
  std::vector<double> score;
  std::vector<Interval> handed_on;
};

class Walk {
 public:
  Walk(const StagePlan& plan, Desk& desk, std::mt19937& random)
      : plan_(plan),
        desk_(desk),
        random_(random),
        form_(find_state_form(plan, desk)),
        shared_(plan, desk),
        worth_(plan.region.rows.size()) {}

  /// `wide`: what arrives is known within bounds.
  void run(Counts& counts, bool wide) {
    constexpr double width = 1e-3;  // relative
    std::vector<double> state;
    std::vector<Interval> states;
    for (std::size_t c = 0; c < plan_.inherited.size(); ++c) {
      Interval range = plan_.inherited[c];  // of which nothing better than the best can arrive
      if (plan_.before[c] == Direction::smaller_is_better) range.lower = plan_.best_inherited[c].lower;
      if (plan_.before[c] == Direction::larger_is_better) range.upper = plan_.best_inherited[c].upper;
      state.push_back(uniform(random_, range.lower, range.upper));
      const double reach = wide ? width * uniform(random_, 0.0, std::fabs(state.back())) : 0.0;
      states.emplace_back(std::max(state.back() - reach, range.lower), std::min(state.back() + reach, range.upper));
    }
    SharedRegions::Cell* const cell = shared_.cell_of(states);
    REQUIRE(cell != nullptr);
    REQUIRE(shared_.cell_of(states) == cell);
    CHECK(cell->labels >= 2);
    for (std::size_t c = 0; c < state.size(); ++c)
      CHECK((contains(cell->states[c], states[c].lower) && contains(cell->states[c], states[c].upper)));
    leaves_.clear();
    std::vector<Claim> claims;
    for (std::size_t region = 0; region < plan_.open_regions.size(); ++region) {
      SharedPart* const part = shared_.part_of(*cell, region, desk_);
      REQUIRE(shared_.part_of(*cell, region, desk_) == part);  // once for all
      if (part != nullptr) walk(*cell, *part, states, claims);
    }
    counts.parts += leaves_.size();
    ++counts.cells;
    for (int trial = 0; trial < 400; ++trial) {
      if (wide)
        for (std::size_t c = 0; c < state.size(); ++c) state[c] = uniform(random_, states[c].lower, states[c].upper);
      counts.feasible += check_one(state, wide, counts) ? 1 : 0;
    }
  }

 private:
  struct Leaf {
    const SharedPart* part;
    std::vector<Claim> claims;  ///< of itself and of all that it is a part of
  };

  void walk(SharedRegions::Cell& cell, SharedPart& part, std::span<const Interval> states, std::vector<Claim>& claims) {
    Claim& claim = claims.emplace_back();
    claim.score = part.bounds.score;
    REQUIRE(part.least.size() == claim.score.size());
    for (std::size_t k = 0; k < claim.score.size(); ++k) {
      const double all = std::max(claim.score[k], plan_.least[k]) + rest_after(plan_, k, part.bounds.handed_on);
      CHECK(part.least[k] <= all);
      CHECK(part.least[k] >= all * (1.0 - 1e-12));
    }
    shared_.hand_on(cell, states, part.bounds, claim.handed_on);
    if (part.single_design) {
      leaves_.push_back({&part, claims});
    } else {
      REQUIRE(shared_.divide(cell, part, worth_, desk_));
      REQUIRE(shared_.divide(cell, part, worth_, desk_));  // once for all
      for (const auto& half : part.halves)
        if (half != nullptr) walk(cell, *half, states, claims);
    }
    claims.pop_back();
  }

  /// A random design at the state; whether it is feasible there.
  bool check_one(const std::vector<double>& state, bool wide, Counts& counts) {
    std::vector<Row> rows;
    std::vector<double> variables;
    for (const RowSet& set : plan_.region.rows) rows.push_back(set->all()[random_() % set->size()]);
    for (const Interval& side : plan_.region.variables) variables.push_back(uniform(random_, side.lower, side.upper));
    for (std::size_t a = 0; a < rows.size(); ++a)
      for (std::size_t b = a + 1; b < rows.size(); ++b)
        if (!plan_.stage->fits(plan_.shared, a, rows[a], b, rows[b])) return false;
    Answer<double> answer;
    plan_.stage->evaluate(Point{plan_.shared, state, rows, variables}, answer);
    if (!(worst_of(answer.utilisation) <= 1.0) || !bearable(plan_, answer.handed_on)) return false;
    std::vector<double> score(plan_.criteria->size());
    plan_.criteria->scores<double>(answer.resources, score);
    bool found = false;
    for (const Leaf& leaf : leaves_) {
      const Region& region = leaf.part->region;
      bool inside = true;
      for (std::size_t slot = 0; slot < rows.size(); ++slot)
        inside = inside && region.rows[slot]->front() == rows[slot];
      for (std::size_t v = 0; v < variables.size(); ++v) inside = inside && contains(region.variables[v], variables[v]);
      if (!inside) continue;
      found = true;
      for (const Claim& claim : leaf.claims) {
        for (std::size_t k = 0; k < score.size(); ++k) CHECK(claim.score[k] <= score[k]);
        for (std::size_t h = 0; h < answer.handed_on.size(); ++h)
          CHECK(contains(claim.handed_on[h], answer.handed_on[h]));
      }
      for (std::size_t h = 0; h < answer.handed_on.size(); ++h) {
        if (!form_.exact[h] || plan_.any_moves_outcome || wide) continue;
        ++counts.exact;
        counts.equal += rounded(leaf.claims.back().handed_on[h].lower) == rounded(answer.handed_on[h]) ? 1 : 0;
      }
    }
    CHECK(found);
    return true;
  }

  const StagePlan& plan_;
  Desk& desk_;
  std::mt19937& random_;
  StateForm form_;
  SharedRegions shared_;
  SplitWorth worth_;
  std::vector<Leaf> leaves_;
};

}  // namespace

TEST_CASE("Every design that is feasible for a label is in a part of its cell, and all bounds hold for it") {
  Counts counts;
  const unsigned stacks = millwright::sanitized ? 40 : 400;
  for (unsigned seed = 1; seed <= stacks; ++seed) {
    const Stack stack = random_stack(seed);
    Options options;
    options.objectives = {0, 1};
    const Criteria criteria = make_criteria(stack.problem, options);
    Desk desk;
    std::vector<Row> shared(stack.problem.shared.size(), 0);
    std::mt19937 random(seed);
    const std::vector<StagePlan> plans = make_plans(stack.problem, shared, criteria, desk);
    for (std::size_t i = 1; i < plans.size(); ++i) {
      CAPTURE(seed, i);
      Walk walk(plans[i], desk, random);
      for (int state = 0; state < 4; ++state) walk.run(counts, state % 2 == 1);
    }
  }
  CHECK(counts.cells > stacks / 2);
  CHECK(counts.feasible > 20 * stacks);
  CHECK(counts.parts > 10 * stacks);
  // Else what is the same as a label known would never be as good.
  CHECK(counts.exact > 20 * stacks);
  CHECK(static_cast<double>(counts.equal) > 0.98 * static_cast<double>(counts.exact));
}

TEST_CASE("A label whose states lie outside what can arrive, or in a range without an end, is in no cell") {
  const Stack stack = random_stack(3);
  Options options;
  options.objectives = {0, 1};
  const Criteria criteria = make_criteria(stack.problem, options);
  Desk desk;
  const std::vector<Row> shared(stack.problem.shared.size(), 0);
  std::vector<StagePlan> plans = make_plans(stack.problem, shared, criteria, desk);
  REQUIRE(plans.size() > 1);
  std::vector<Interval> states = plans[1].inherited;
  SharedRegions regions(plans[1], desk);
  CHECK(regions.cell_of(states) != nullptr);
  states[0].upper = 2.0 * states[0].upper + 1.0;
  CHECK(regions.cell_of(states) == nullptr);
  states = plans[1].inherited;
  plans[1].inherited[0].upper = std::numeric_limits<double>::infinity();
  SharedRegions endless(plans[1], desk);
  CHECK(endless.cell_of(states) == nullptr);
}

}  // namespace shared_regions_test
