// SPDX-License-Identifier: Apache-2.0
#include "solver/stage_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "solver/relaxation.h"

namespace millwright::solver {
namespace {

constexpr int slices = 4;                  // a slice of a variable that is tested for being empty of feasible designs
constexpr std::size_t state_nodes = 200;   // spent on the best value of one state component
constexpr std::size_t score_nodes = 4000;  // spent on the least of one score

/// A slice that is not empty will hardly be so when the region has been halved once; the further from it, the later.
/// (Of machines and stacks tried, this asks least in all.)
std::uint8_t patience_after(double worst) { return worst > 0.95 ? 1 : worst > 0.6 ? 2 : 4; }

/// Cuts slices of one variable off, from below or from above, while nothing in them is feasible. False when all of the
/// interval is cut off.
bool cut_slices(const StagePlan& plan,
                std::span<const Interval> inherited,
                Region& region,
                std::size_t variable,
                bool from_below,
                Desk& desk) {
  std::uint8_t& wait = region.patience[(2 * variable + (from_below ? 0 : 1)) % region.patience.size()];
  if (wait > 0) {
    --wait;
    return true;
  }
  const Interval whole = region.variables[variable];
  std::vector<Interval>& trial = desk.trial;
  trial = region.variables;
  const double step = (whole.upper - whole.lower) / slices;
  for (int i = 0; i < slices; ++i) {
    Interval& slice = trial[variable];
    const bool last = i + 1 == slices;
    if (from_below) {
      slice = {whole.lower + i * step, last ? whole.upper : whole.lower + (i + 1) * step};
    } else {
      slice = {last ? whole.lower : whole.upper - (i + 1) * step, whole.upper - i * step};
    }
    const auto& answer = desk.bound(*plan.stage, plan.shared, inherited, region, trial);
    const double worst = worst_lower(answer.utilisation);
    if (worst <= 1.0) {
      if (i == 0) wait = patience_after(worst);
      (from_below ? region.variables[variable].lower : region.variables[variable].upper) =
          from_below ? slice.lower : slice.upper;
      return true;
    }
  }
  return false;
}

/// Whether an answer shows that nothing it was given for is feasible, or leads to something that is.
bool hopeless(const StagePlan& plan, const Answer<Interval>& answer) {
  return worst_lower(answer.utilisation) > 1.0 || !bearable(plan, answer.handed_on);
}
/// Whether no design of the region is feasible, or leads to one, at any of the inherited states.
bool hopeless(const StagePlan& plan, std::span<const Interval> inherited, const Region& region, Desk& desk) {
  return hopeless(plan, desk.bound(*plan.stage, plan.shared, inherited, region));
}

}  // namespace

void read_bounds(const StagePlan& plan, const Answer<Interval>& answer, Bounds& bounds) {
  bounds.score.resize(plan.criteria->size());
  plan.criteria->least_scores(answer.resources, bounds.score);
  bounds.handed_on = answer.handed_on;
  bounds.utilisation = worst_lower(answer.utilisation);
  if (!bearable(plan, answer.handed_on)) bounds.utilisation = std::numeric_limits<double>::infinity();
  bounds.open = 0;
  bounds.telling = 0;
  for (std::size_t c = 0; c < answer.utilisation.size(); ++c) {
    const double most = answer.utilisation[c].upper;
    if (!(most <= 1.0)) bounds.open |= std::uint64_t{1} << (c % 64);
    if (!(most <= 1.0) || most > bounds.utilisation) bounds.telling |= std::uint64_t{1} << (c % 64);
  }
}

bool assess(const StagePlan& plan, std::span<const Interval> inherited, Region& region, Bounds& bounds, Desk& desk) {
  read_bounds(plan, desk.bound(*plan.stage, plan.shared, inherited, region), bounds);
  if (bounds.utilisation > 1.0) return false;
  return cut_variables(plan, inherited, region, bounds, desk);
}

bool cut_variables(
    const StagePlan& plan, std::span<const Interval> inherited, Region& region, Bounds& bounds, Desk& desk) {
  if (region.variables.empty() || bounds.open == 0) return true;
  bool cut = false;
  for (std::size_t v = 0; v < region.variables.size(); ++v) {
    const Interval before = region.variables[v];
    if (!(before.upper > before.lower)) continue;
    if (!cut_slices(plan, inherited, region, v, true, desk)) return false;
    if (!cut_slices(plan, inherited, region, v, false, desk)) return false;
    cut = cut || region.variables[v].lower != before.lower || region.variables[v].upper != before.upper;
  }
  if (cut) read_bounds(plan, desk.bound(*plan.stage, plan.shared, inherited, region), bounds);
  return bounds.utilisation <= 1.0;
}

namespace {

/// Whether rows of a slot have partners in all others of the plan's region; rows of one kind are asked about once.
class Partners {
 public:
  Partners(const StagePlan& plan, std::size_t slot) : plan_(plan), slot_(slot) {}

  bool of(Row row, const std::vector<Interval>& readings) {
    if (plan_.fits.everything_fits()) return true;
    const std::uint32_t kind = plan_.fits.kinds(slot_)[row];
    if (kind >= known_.size()) known_.resize(kind + std::size_t{1});
    if (!known_[kind]) {
      Region region = plan_.region;
      region.rows[slot_] = std::make_shared<const Rows>(std::vector<Row>(1, row), readings);
      known_[kind] = plan_.fits.possible(region, slot_);
    }
    return *known_[kind];
  }

 private:
  const StagePlan& plan_;
  std::size_t slot_;
  std::vector<std::optional<bool>> known_;  ///< [kind]
};

}  // namespace

namespace {

/// Finds out what tells a slot's rows apart at these states.
void find_profile(
    const StagePlan& plan, std::span<const Interval> inherited, std::size_t slot, RowProfile& profile, Desk& desk) {
  Bounds bounds;
  read_bounds(plan, desk.bound(*plan.stage, plan.shared, inherited, plan.region), bounds);
  profile.find(plan.region,
               slot,
               bounds.score,
               [&](std::size_t, const RowsAlive& rows, std::span<double> score) -> const Answer<Interval>& {
                 const auto& answer = desk.bound_with(*plan.stage, plan.shared, inherited, plan.region, slot, rows);
                 plan.criteria->least_scores(answer.resources, score);
                 return answer;
               });
}

/// Removes rows that have no hope at any of the inherited states.
class Shaving {
 public:
  Shaving(StagePlan& plan, std::span<const Interval> inherited, Desk& desk)
      : plan_(plan), inherited_(inherited), desk_(desk) {}

  /// False: nothing is left.
  bool run() {
    const std::size_t slots = plan_.region.rows.size();
    for (bool again = true; again;) {
      again = false;
      for (std::size_t slot = 0; slot < slots; ++slot) {
        const RowSet all = plan_.region.rows[slot];
        const bool is_long = all->size() >= long_table;
        if (is_long && sample_has_hope(slot)) continue;
        std::vector<Row> kept = is_long ? sieved(slot) : hopeful_rows(slot);
        if (kept.empty()) return false;
        if (kept.size() == all->size()) continue;
        // Fewer rows here may leave others without hope; a few fewer are not worth asking about all others again.
        again = again || 2 * kept.size() <= all->size();
        plan_.region.rows[slot] = make_rows(*plan_.stage, plan_.shared, slot, std::move(kept));
        if (!plan_.fits.filter(plan_.region, is_long ? slots : slot)) return false;
      }
    }
    return !hopeless(plan_, inherited_, plan_.region, desk_);
  }

 private:
  static constexpr std::size_t long_table = 1024;

  const Answer<Interval>& ask(std::size_t slot, const RowsAlive& rows) {
    return desk_.bound_with(*plan_.stage, plan_.shared, inherited_, plan_.region, slot, rows);
  }
  bool hopeless_alone(std::size_t slot, const Row& row) {
    const std::span<const Row> alone(&row, 1);
    plan_.stage->read(plan_.shared, slot, alone, readings_);
    return hopeless(plan_, ask(slot, {alone, readings_}));
  }

  std::vector<Row> hopeful_rows(std::size_t slot) {
    std::vector<Row> kept;
    Partners partners(plan_, slot);
    for (const Row& row : *plan_.region.rows[slot])
      if (!hopeless_alone(slot, row) && partners.of(row, readings_)) kept.push_back(row);
    return kept;
  }

  /// A long table of which no row in a sample is without hope is left as it is.
  bool sample_has_hope(std::size_t slot) {
    constexpr std::size_t sample = 128;
    const std::vector<Row>& rows = plan_.region.rows[slot]->all();
    for (std::size_t i = 0; i < sample; ++i)
      if (hopeless_alone(slot, rows[i * rows.size() / sample])) return false;
    return true;
  }

  /// Of any other, sets of rows that are alike are asked about instead of rows.
  std::vector<Row> sieved(std::size_t slot) {
    constexpr std::size_t few = 16;
    RowProfile profile(*plan_.stage, plan_.shared);
    find_profile(plan_, inherited_, slot, profile, desk_);
    Region region = plan_.region;
    for (std::size_t other = 0; other < region.rows.size(); ++other)
      if (other != slot) region.rows[other] = only(*plan_.stage, plan_.shared, other, region.rows[other]->front());
    const std::vector<double> worth(region.rows.size(), 1.0);
    std::vector<RowSet> open{plan_.region.rows[slot]};
    std::vector<Row> kept;
    Bounds bounds;
    while (!open.empty()) {
      region.rows[slot] = std::move(open.back());
      open.pop_back();
      const auto& answer = ask(slot, region.rows[slot]->alive());
      if (hopeless(plan_, answer)) continue;
      if (region.rows[slot]->size() <= few) {
        kept.insert(kept.end(), region.rows[slot]->begin(), region.rows[slot]->end());
        continue;
      }
      read_bounds(plan_, answer, bounds);
      RowProfile::Split split = profile.split(region, bounds.open, worth);
      open.push_back(std::move(split.left));
      open.push_back(std::move(split.right));
    }
    std::sort(kept.begin(), kept.end());
    return kept;
  }

  StagePlan& plan_;
  std::span<const Interval> inherited_;
  Desk& desk_;
  std::vector<Interval> readings_;  ///< of the row asked about last
};

}  // namespace

bool shave(StagePlan& plan, std::span<const Interval> inherited, Desk& desk) {
  return Shaving(plan, inherited, desk).run();
}

namespace {

/// Drops rows without hope at the best state that can arrive, and finds out what tells the others apart.
bool shave_and_profile(StagePlan& plan, Desk& desk) {
  if (!shave(plan, plan.best_inherited, desk)) return false;
  plan.profile = RowProfile(*plan.stage, plan.shared);
  for (std::size_t slot = 0; slot < plan.region.rows.size(); ++slot)
    find_profile(plan, plan.best_inherited, slot, plan.profile, desk);
  return true;
}

/// The states that can arrive, from the tool to the base; false when no row of some slot fits anything.
bool find_states(const Problem& problem, std::vector<StagePlan>& plans, Desk& desk) {
  std::vector<Interval> state(problem.first_state.begin(), problem.first_state.end());
  for (StagePlan& plan : plans) {
    plan.inherited = state;
    if (!plan.fits.filter(plan.region, plan.region.rows.size())) return false;
    state = desk.bound(*plan.stage, plan.shared, plan.inherited, plan.region).handed_on;
  }
  return true;
}

/// The least value of a component from which on nothing is feasible, as far as bounds prove it.
double most_bearable(const StagePlan& plan, std::size_t component, Desk& desk) {
  std::vector<Interval> state = plan.inherited;
  const Interval whole = state[component];
  const auto refused_from = [&](double value) {
    state[component] = {value, whole.upper};
    return hopeless(plan, state, plan.region, desk);
  };
  if (!(whole.upper > whole.lower) || !std::isfinite(whole.upper) || !refused_from(whole.upper)) return whole.upper;
  double bearable_at = whole.lower;
  double refused_at = whole.upper;
  constexpr int halvings = 20;
  for (int i = 0; i < halvings; ++i) {
    const double value = 0.5 * (bearable_at + refused_at);
    (refused_from(value) ? refused_at : bearable_at) = value;
  }
  return refused_at;
}

/// Whether some side of a range of states has become a good deal narrower.
bool narrower(std::span<const Interval> now, std::span<const Interval> before) {
  constexpr double good_deal = 0.9;
  for (std::size_t c = 0; c < now.size(); ++c) {
    if (now[c].upper - now[c].lower < good_deal * (before[c].upper - before[c].lower)) return true;
  }
  return false;
}

/// Whether later stages cannot bear everything that a stage may hand on.
bool limits(const StagePlan& plan, std::span<const Interval> handed_on) {
  for (std::size_t c = 0; c < handed_on.size(); ++c) {
    if (plan.most_after[c] < handed_on[c].upper) return true;
  }
  return false;
}

/// States handed on less those that no later stage can bear.
std::vector<Interval> bearable_part(const StagePlan& plan, std::vector<Interval> state) {
  for (std::size_t c = 0; c < state.size(); ++c) {
    const double most = plan.most_after[c] + 1e-11 * std::fabs(plan.most_after[c]);
    state[c].upper = std::max(std::min(state[c].upper, most), state[c].lower);
  }
  return state;
}

/// What later stages can bear, from the base to the tool; then the states that can still arrive, and the rows that can
/// still be chosen. False when nothing is left.
bool find_limits(std::vector<StagePlan>& plans, Desk& desk) {
  std::vector<double> most(plans.empty() ? 0 : plans.front().inherited.size(), std::numeric_limits<double>::infinity());
  for (auto plan = plans.rbegin(); plan != plans.rend(); ++plan) {
    plan->most_after = most;
    for (std::size_t c = 0; c < most.size(); ++c) most[c] = most_bearable(*plan, c, desk);
  }
  std::vector<Interval> state = plans.empty() ? std::vector<Interval>{} : plans.front().inherited;
  for (StagePlan& plan : plans) {
    const bool changed = narrower(state, plan.inherited);
    plan.inherited = state;
    state = desk.bound(*plan.stage, plan.shared, plan.inherited, plan.region).handed_on;
    if ((changed || limits(plan, state)) && !shave(plan, plan.inherited, desk)) return false;
    state = bearable_part(plan, desk.bound(*plan.stage, plan.shared, plan.inherited, plan.region).handed_on);
  }
  return true;
}

/// From the base to the tool: directions, and which variables move what matters.
void find_directions(std::vector<StagePlan>& plans, Desk& desk) {
  std::vector<Direction> next(plans.empty() ? 0 : plans.front().inherited.size(), Direction::irrelevant);
  for (auto plan = plans.rbegin(); plan != plans.rend(); ++plan) {
    plan->after = next;
    plan->before.clear();
    plan->priced.clear();
    const MonotonicityQuestion question{
        plan->stage, plan->shared, plan->criteria, &plan->region, plan->inherited, plan->after};
    for (std::size_t c = 0; c < next.size(); ++c) {
      // A state that is known exactly needs no direction.
      const bool known = plan->inherited[c].lower == plan->inherited[c].upper;
      plan->before.push_back(known ? Direction::irrelevant : prove_direction(question, c, desk));
    }
    for (std::size_t v = 0; v < plan->region.variables.size(); ++v) {
      const bool fixed = plan->region.variables[v].lower == plan->region.variables[v].upper;
      plan->priced.push_back(!fixed && !moves_feasibility_only(question, v, desk));
      plan->any_priced = plan->any_priced || plan->priced.back();
    }
    next = plan->before;
  }
}

/// The best state that can follow a stage whose best inherited state is known.
std::vector<Interval> best_after(const StagePlan& plan, Desk& desk) {
  std::vector<Interval> state = desk.bound(*plan.stage, plan.shared, plan.best_inherited, plan.region).handed_on;
  for (std::size_t c = 0; c < state.size(); ++c) {
    const Direction direction = plan.after[c];
    if (direction == Direction::equal_only || state[c].lower == state[c].upper) continue;
    if (direction == Direction::irrelevant) {
      state[c] = state[c].lower;
      continue;
    }
    const double least = relax(plan, {RelaxedTarget::Kind::state, c}, state_nodes, desk).least;
    if (!std::isfinite(least)) continue;  // no design is feasible: the search for the least score will say so
    const bool smaller = direction == Direction::smaller_is_better;
    state[c] = smaller ? std::max(state[c].lower, least) : std::min(state[c].upper, -least);
  }
  return state;
}

/// Least of each score, with the frontier of the first; false when the stage has no feasible design.
bool find_least(StagePlan& plan, Desk& desk) {
  const std::size_t scores = plan.criteria->size();
  plan.least.resize(scores);
  for (std::size_t k = 0; k < scores; ++k) {
    const bool worth_a_search =
        k < plan.criteria->objectives || plan.criteria->limit[k] < 1e300 || k + plan.criteria->guides >= scores;
    Relaxation relaxation =
        relax(plan, {RelaxedTarget::Kind::score, k}, worth_a_search ? score_nodes : state_nodes, desk);
    if (relaxation.open.empty()) return false;
    plan.least[k] = relaxation.least;
    if (k == 0) plan.frontier = std::move(relaxation.open);
  }
  std::stable_sort(plan.frontier.begin(), plan.frontier.end(), [](const OpenRegion& a, const OpenRegion& b) {
    return a.bounds.score[0] < b.bounds.score[0];
  });
  return true;
}

}  // namespace

void look_again(const Problem& problem, std::vector<StagePlan>& plans, Desk& desk) {
  std::vector<Interval> state(problem.first_state.begin(), problem.first_state.end());
  for (StagePlan& plan : plans) {
    plan.inherited = state;
    state = bearable_part(plan, desk.bound(*plan.stage, plan.shared, plan.inherited, plan.region).handed_on);
  }
  find_directions(plans, desk);
}

std::vector<StagePlan> make_plans(const Problem& problem,
                                  std::span<const Row> shared,
                                  const Criteria& criteria,
                                  Desk& desk) {
  std::vector<StagePlan> plans;
  if (!all_offered(problem, shared)) return plans;
  for (const Stage* stage : problem.stages) plans.emplace_back(*stage, shared, criteria);
  if (!find_states(problem, plans, desk) || !find_limits(plans, desk)) return {};
  find_directions(plans, desk);
  std::vector<Interval> best(problem.first_state.begin(), problem.first_state.end());
  for (StagePlan& plan : plans) {
    plan.best_inherited = best;
    if (!shave_and_profile(plan, desk)) return {};
    best = best_after(plan, desk);
    if (!find_least(plan, desk)) return {};
  }
  std::vector<double> rest(criteria.size(), 0.0);
  for (auto plan = plans.rbegin(); plan != plans.rend(); ++plan) {
    plan->rest = rest;
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] += plan->least[k];
  }
  return plans;
}

}  // namespace millwright::solver
