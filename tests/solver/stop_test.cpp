// SPDX-License-Identifier: Apache-2.0
//
// Stopped anywhere, after any number of questions, a search says what is true: its bound is one, its builds are
// feasible, and it claims to be done only if it is. The optimum comes from exhaustive enumeration.
#include <algorithm>
#include <atomic>
#include <limits>

#include "catch.h"
#include "sanitized.h"
#include "solver/enumeration.h"
#include "solver/forwarding_stage.h"
#include "solver/shared_choices.h"

namespace stop_test {

namespace {

using namespace zoo;

/// Counts down the questions that a search may ask, then stops it.
struct Patience {
  std::int64_t left = 0;
  std::atomic<bool> stop = false;
  void spend() {
    if (left-- <= 0) stop = true;
  }
};

/// A stage that spends patience with every question. The problem has one more shared choice, the last, whose second row
/// costs far more at the first stage: a combination that nobody would take, but that may not hide what is still open.
class CountedStage final : public zoo::ForwardingStage {
 public:
  static constexpr double surcharge = 1e6;

  CountedStage(const Stage& stage, Patience& patience, bool charges)
      : zoo::ForwardingStage(stage), patience_(&patience), charges_(charges) {}

  void read(std::span<const Row> shared,
            std::size_t slot,
            std::span<const Row> rows,
            std::vector<Interval>& readings) const override {
    inner_.read(own(shared), slot, rows, readings);
  }
  void evaluate(const Point& point, Answer<double>& answer) const override {
    patience_->spend();
    inner_.evaluate({own(point.shared), point.inherited, point.rows, point.variables}, answer);
    answer.resources[0] += charge(point.shared);
  }
  void bound(const Box& box, Answer<Interval>& answer) const override {
    patience_->spend();
    inner_.bound(own(box), answer);
    answer.resources[0] += Interval(charge(box.shared));
  }
  void slopes(const Box& box, Input input, Answer<Interval>& answer) const override {
    patience_->spend();
    inner_.slopes(own(box), input, answer);
  }
  void gradient(const Point& point, Input input, Answer<double>& answer) const override {
    inner_.gradient({own(point.shared), point.inherited, point.rows, point.variables}, input, answer);
  }
  [[nodiscard]] bool fits(
      std::span<const Row> shared, std::size_t slot_a, Row row_a, std::size_t slot_b, Row row_b) const override {
    return inner_.fits(own(shared), slot_a, row_a, slot_b, row_b);
  }

 private:
  static std::span<const Row> own(std::span<const Row> shared) { return shared.first(shared.size() - 1); }
  static Box own(const Box& box) { return {own(box.shared), box.inherited, box.rows, box.variables, box.kept}; }
  [[nodiscard]] double charge(std::span<const Row> shared) const {
    return charges_ && shared.back() == 1 ? surcharge : 0.0;
  }

  Patience* patience_;
  bool charges_;
};

Summary solve_impatiently(const Stack& stack, Options options, std::int64_t questions, Row surcharges = 2) {
  Patience patience;
  patience.left = questions;
  std::vector<std::unique_ptr<Stage>> stages;
  Problem problem = stack.problem;
  problem.shared.push_back({"surcharge", surcharges});
  for (const Stage*& stage : problem.stages) {
    stages.push_back(std::make_unique<CountedStage>(*stage, patience, stages.empty()));
    stage = stages.back().get();
  }
  options.stop = &patience.stop;
  return solve(problem, options);
}

}  // namespace

TEST_CASE("Stopped after any number of questions a search has a valid bound and feasible builds") {
  std::size_t stopped = 0, with_build = 0, before_any = 0;
  for (unsigned seed = 0; seed < (millwright::sanitized ? 30 : 150); ++seed) {
    const Stack stack = random_stack(seed);
    const Everything everything = Enumeration(stack).run();
    Options options;
    options.confirm = false;
    const double gap = options.gap;
    if (everything.margin < 1e-9) continue;                 // feasibility itself hangs on rounding
    const double optimum = everything.least(&Total::cost);  // infinite where nothing is feasible
    for (const bool stagewise : {true, false}) {
      options.stagewise = stagewise;
      options.patience = seed % 2 == 0 ? 12000 : 0;
      for (std::int64_t questions = 1; questions < 100000; questions += 1 + questions / 2) {
        const Summary summary = solve_impatiently(stack, options, questions);
        INFO("seed " << seed << ", " << questions << " questions");
        REQUIRE(summary.lower_bound <= optimum * (1.0 + gap));
        for (const Build& build : summary.builds) REQUIRE(build.resources[0] >= optimum * (1.0 - gap));
        if (summary.status != Status::limit) {
          REQUIRE((summary.status == Status::optimal) == !everything.designs.empty());
          break;
        }
        ++stopped;
        ++(summary.builds.empty() ? before_any : with_build);
      }
    }
  }
  CHECK(stopped > (millwright::sanitized ? 300U : 1500U));
  CHECK(with_build > 10);
  CHECK(before_any > 10);
}

TEST_CASE("Stopped among very many combinations of shared choices a search claims nothing") {
  const Stack stack = random_stack(3);
  for (const std::vector<std::size_t>& objectives :
       {std::vector<std::size_t>{0}, std::vector<std::size_t>{0, 1}, std::vector<std::size_t>{0, 1, 2}}) {
    Options options;
    options.objectives = objectives;
    CAPTURE(objectives.size());
    const Summary summary = solve_impatiently(stack, options, 1, 5000);
    CHECK(summary.status == Status::limit);
    CHECK(summary.builds.empty());
    if (objectives.size() == 1)
      CHECK(summary.lower_bound == -std::numeric_limits<double>::infinity());
    else
      CHECK(summary.front_tolerance == std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("Combinations of shared choices are gone through once each") {
  Problem problem;
  problem.shared = {{"voltage", 2}, {"shops", 3}, {"rate", 1}};
  std::vector<Row> shared(3, 0);
  std::vector<std::vector<Row>> seen;
  do seen.push_back(shared);
  while (next_combination(problem, shared));
  CHECK(seen.size() == 6);
  CHECK(std::is_sorted(seen.begin(), seen.end()));
  CHECK(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
  CHECK(shared == std::vector<Row>(3, 0));
}

}  // namespace stop_test
