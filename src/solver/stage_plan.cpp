// SPDX-License-Identifier: Apache-2.0
#include "solver/stage_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "solver/relaxation.h"
#include "solver/row_dominance.h"
#include "solver/shaving.h"

namespace millwright::solver {
namespace {

constexpr int slices = 4;                  // a slice of a variable that is tested for being empty of feasible designs
constexpr std::size_t state_nodes = 200;   // spent on the best value of one state component
constexpr std::size_t score_nodes = 4000;  // spent on the least of one score

/// Of the ends of equal slices, ascending, the one with number `end`. What a variable does goes by ratios, where it has
/// them: halving a time of acceleration asks as much more of a motor wherever it was.
double end_of_slice(const Interval& whole, int end) {
  static_assert(slices == 4);
  if (end == 0) return whole.lower;
  if (end == slices) return whole.upper;
  double at = whole.lower + static_cast<double>(end) / slices * (whole.upper - whole.lower);
  if (whole.lower > 0.0) {  // by roots, which are cheaper than a power; there are many slices
    const double half = std::sqrt(whole.upper / whole.lower);
    at = whole.lower * (end == 2 ? half : end == 1 ? std::sqrt(half) : half * std::sqrt(half));
  }
  return std::clamp(at, whole.lower, whole.upper);
}

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
  for (int i = 0; i < slices; ++i) {
    Interval& slice = trial[variable];
    const int first = from_below ? i : slices - 1 - i;
    slice = {end_of_slice(whole, first), end_of_slice(whole, first + 1)};
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

/// Drops rows without hope at the best state that can arrive, and finds out what tells the others apart.
bool shave_and_profile(StagePlan& plan, Desk& desk, TableMemory& tables) {
  if (!shave(plan, plan.best_inherited, desk, tables)) return false;
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
    const double most = plan.most_after[c] + bound_slack * std::fabs(plan.most_after[c]);
    state[c].upper = std::max(std::min(state[c].upper, most), state[c].lower);
  }
  return state;
}

/// What later stages can bear, from the base to the tool; then the states that can still arrive, and the rows that can
/// still be chosen. False when nothing is left.
bool find_limits(std::vector<StagePlan>& plans, Desk& desk, TableMemory& tables) {
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
    if ((changed || limits(plan, state)) && !shave(plan, plan.inherited, desk, tables)) return false;
    state = bearable_part(plan, desk.bound(*plan.stage, plan.shared, plan.inherited, plan.region).handed_on);
  }
  return true;
}

/// Which variables move what matters.
void find_moving(StagePlan& plan, const MonotonicityQuestion& question, Desk& desk) {
  bool scores = false, in_steps = true;
  std::vector<std::size_t> states;
  plan.moves_outcome.clear();
  plan.any_moves_outcome = false;
  for (std::size_t v = 0; v < plan.region.variables.size(); ++v) {
    const bool fixed = plan.region.variables[v].lower == plan.region.variables[v].upper;
    const Moved moved = fixed ? Moved{} : what_moves(question, v, desk);
    plan.moves_outcome.push_back(!moved.nothing());
    plan.any_moves_outcome = plan.any_moves_outcome || plan.moves_outcome.back();
    scores = scores || moved.scores;
    in_steps = in_steps && moved.in_steps;
    states.insert(states.end(), moved.states.begin(), moved.states.end());
  }
  const bool one = !states.empty() && std::all_of(states.begin(), states.end(), [&](auto s) { return s == states[0]; });
  plan.moved_state.reset();
  if (!scores && in_steps && one && plan.after[states[0]] != Direction::equal_only) plan.moved_state = states[0];
}

/// Takes over what a larger problem says, unless it says it of other states. What cannot arrive there in a feasible
/// build cannot here.
bool take_known_directions(StagePlan& plan) {
  if (plan.known_directions == nullptr) return false;
  const StageDirections& known = *plan.known_directions;
  std::vector<Interval> inherited = plan.inherited;
  for (std::size_t c = 0; c < inherited.size(); ++c) {
    const bool as_there = plan.after[c] == known.after[c] || plan.after[c] == Direction::irrelevant ||
                          known.after[c] == Direction::equal_only;
    const std::optional<Interval> both = intersect(inherited[c], known.inherited[c]);
    if (!as_there || !both) return false;
    inherited[c] = *both;
  }
  for (std::size_t v = 0; v < known.variables.size(); ++v) {
    const Interval& here = plan.region.variables[v];
    if (here.lower < known.variables[v].lower || here.upper > known.variables[v].upper) return false;
  }
  // In place: questions about the stage look at it.
  std::copy(inherited.begin(), inherited.end(), plan.inherited.begin());
  for (std::size_t c = 0; c < known.most_after.size(); ++c)
    plan.most_after[c] = std::min(plan.most_after[c], known.most_after[c]);
  plan.before = known.before;
  return true;
}

/// From the base to the tool: directions, and which variables move what matters. Of very long tables only the rows that
/// no other one stands in for are kept, if so `planned`.
void find_directions(std::vector<StagePlan>& plans, PlannedRows planned, Desk& desk) {
  constexpr std::size_t very_long = 20000;  // shorter tables cost less than it takes to compare their rows
  std::vector<Direction> next(plans.empty() ? 0 : plans.front().inherited.size(), Direction::irrelevant);
  for (auto plan = plans.rbegin(); plan != plans.rend(); ++plan) {
    plan->after = next;
    plan->before.clear();
    if (planned == PlannedRows::best_of_very_long) leave_out_dominated_rows(*plan, desk, very_long);
    RowHalves halves(RowProfile(*plan->stage, plan->shared), [&](std::size_t slot, RowProfile& profile) {
      find_profile(*plan, plan->inherited, slot, profile, desk);
    });
    const MonotonicityQuestion question{
        plan->stage, plan->shared, plan->criteria, &plan->region, plan->inherited, plan->after, &halves};
    const bool taken_over = take_known_directions(*plan);
    for (std::size_t c = 0; c < next.size(); ++c) {
      // A state that is known exactly needs no direction.
      const bool known = plan->inherited[c].lower == plan->inherited[c].upper;
      if (!taken_over)
        plan->before.push_back(known ? Direction::irrelevant : prove_direction(question, c, desk));
      else if (known)
        plan->before[c] = Direction::irrelevant;
    }
    find_moving(*plan, question, desk);
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

/// Least of each score, with what is left open for the first; false when the stage has no feasible design.
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
    if (k == 0) plan.open_regions = std::move(relaxation.open);
  }
  std::stable_sort(plan.open_regions.begin(), plan.open_regions.end(), [](const OpenRegion& a, const OpenRegion& b) {
    return a.bounds.score[0] < b.bounds.score[0];
  });
  return true;
}

}  // namespace

void keep_within_region(StagePlan& plan, std::size_t slot) {
  std::vector<bool> allowed(plan.stage->slots()[slot].rows, false);
  for (const Row row : *plan.region.rows[slot]) allowed[row] = true;
  std::map<RowSet, RowSet> left;  // by what there was: regions share most of their sets
  for (OpenRegion& open : plan.open_regions) {
    RowSet& own = open.region.rows[slot];
    const auto [found, is_new] = left.try_emplace(own, own);
    if (is_new) {
      std::vector<Row> rows;
      std::copy_if(own->begin(), own->end(), std::back_inserter(rows), [&](Row row) { return allowed[row]; });
      if (rows.empty())
        found->second = nullptr;
      else if (rows.size() < own->size())
        found->second = make_rows(*plan.stage, plan.shared, slot, std::move(rows));
    }
    own = found->second;
  }
  std::erase_if(plan.open_regions, [&](const OpenRegion& open) { return open.region.rows[slot] == nullptr; });
}

void keep_within_region(StagePlan& plan) {
  for (std::size_t slot = 0; slot < plan.region.rows.size(); ++slot) keep_within_region(plan, slot);
}

void look_again(const Problem& problem, std::vector<StagePlan>& plans, Desk& desk) {
  std::vector<Interval> state(problem.first_state.begin(), problem.first_state.end());
  for (StagePlan& plan : plans) {
    plan.inherited = state;
    state = bearable_part(plan, desk.bound(*plan.stage, plan.shared, plan.inherited, plan.region).handed_on);
  }
  find_directions(plans, PlannedRows::all, desk);
}

std::vector<StagePlan> make_plans(const Problem& problem,
                                  std::span<const Row> shared,
                                  const Criteria& criteria,
                                  Desk& desk,
                                  TableMemory& tables,
                                  PlannedRows planned) {
  std::vector<StagePlan> plans;
  if (!all_offered(problem, shared)) return plans;
  for (const Stage* stage : problem.stages) plans.emplace_back(*stage, shared, criteria, tables);
  if (!find_states(problem, plans, desk) || !find_limits(plans, desk, tables)) return {};
  if (tables.known_directions) {
    const std::span<const StageDirections> known = tables.known_directions(shared, desk);
    for (std::size_t i = 0; i < known.size(); ++i) plans[i].known_directions = &known[i];
  }
  find_directions(plans, planned, desk);
  std::vector<Interval> best(problem.first_state.begin(), problem.first_state.end());
  for (StagePlan& plan : plans) {
    // More may be better only as far as later stages can bear it.
    for (std::size_t c = 0; c < best.size(); ++c)
      best[c] = intersect(best[c], plan.inherited[c]).value_or(plan.inherited[c]);
    plan.best_inherited = best;
    if (!shave_and_profile(plan, desk, tables)) return {};
    best = best_after(plan, desk);
    if (!find_least(plan, desk)) return {};
  }
  std::vector<double> rest(criteria.size(), 0.0);
  for (auto plan = plans.rbegin(); plan != plans.rend(); ++plan) {
    plan->rest = rest;
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = total_down(rest[k], plan->least[k]);
  }
  return plans;
}

std::vector<StageDirections> directions_of(const Problem& problem,
                                           std::span<const Row> shared,
                                           const Criteria& criteria,
                                           Desk& desk) {
  TableMemory tables;
  std::vector<StagePlan> plans;
  std::vector<StageDirections> directions;
  if (!all_offered(problem, shared)) return directions;
  for (const Stage* stage : problem.stages) plans.emplace_back(*stage, shared, criteria, tables);
  if (!find_states(problem, plans, desk) || !find_limits(plans, desk, tables)) return directions;
  find_directions(plans, PlannedRows::all, desk);
  for (const StagePlan& plan : plans)
    directions.push_back({plan.inherited, plan.region.variables, plan.before, plan.after, plan.most_after});
  return directions;
}

}  // namespace millwright::solver
