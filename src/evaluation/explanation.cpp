// SPDX-License-Identifier: Apache-2.0
#include "evaluation/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluation/condition_prices.h"
#include "evaluation/condition_trials.h"
#include "evaluation/design_bill.h"
#include "evaluation/machine_stages.h"
#include "evaluation/rates.h"
#include "evaluation/slot_choices.h"
#include "evaluation/tolerance_choices.h"
#include "machine/condition_loads.h"

namespace millwright::evaluation {

namespace {

using machine::Asked;
using machine::Condition;
using machine::ConditionKind;

ConditionSet without(const ConditionSet& set, const ConditionSet& others) {
  ConditionSet result;
  std::set_difference(set.begin(), set.end(), others.begin(), others.end(), std::back_inserter(result));
  return result;
}

std::string title_of(const Condition& condition) { return condition.axis + ": " + condition.name; }

/// Nothing is compliant.
class Contradictions {
 public:
  Contradictions(ConditionTrials& trials, Explanation& result) : trials_(trials), result_(result) {}

  void find() {
    note_unmet(trials_.all());
    if (!trials_.possible(ConditionSet{})) {
      result_.catalogue_lacks = true;
      note_unmet({});
      return;
    }
    ConditionSet rest = trials_.all();
    while (!trials_.possible(rest)) {
      const ConditionSet conflict =
          minimal_conflict(rest, [&](const ConditionSet& set) { return trials_.possible(set); });
      result_.conflicts.push_back({conflict, {}});
      rest = without(rest, conflict);
    }
    for (std::size_t i = 0; i < result_.conflicts.size(); ++i) resolve(i);
    if (result_.conflicts.size() > 1) resolve_all();
  }

 private:
  /// What single checks and slots say, with only these conditions imposed.
  void note_unmet(const ConditionSet& imposed) {
    Asked asked = trials_.asked();
    trials_.lift_others(imposed, asked);
    const MachineModel model(asked.problem, trials_.catalogue_for(asked), {}, {.fixed = asked.fixed});
    result_.empty_slots = model.empty_slots();
    result_.unmet.clear();
    if (result_.empty_slots.empty() && model.problems().empty()) result_.unmet = unmet_checks(model);
  }

  /// The others' members do not count while one conflict is looked at.
  [[nodiscard]] ConditionSet background(std::size_t conflict) const {
    ConditionSet set = trials_.all();
    for (std::size_t i = 0; i < result_.conflicts.size(); ++i)
      if (i != conflict) set = without(set, result_.conflicts[i].conditions);
    return set;
  }

  void resolve(std::size_t index) {
    Conflict& conflict = result_.conflicts[index];
    const ConditionSet imposed = background(index);
    for (const std::size_t member : conflict.conditions) {
      // What is not answered in time is no way out, and is not said to be none either.
      const bool enough = trials_.possible(without(imposed, {member}));
      conflict.ways.push_back({member, enough, std::nullopt, std::nullopt, std::nullopt, {}});
      if (enough) ease(imposed, conflict.ways.back());
      // What costs nothing here may well be more than the least that is enough.
      if (auto way = cheapest_of(imposed, member); way && way->to != conflict.ways.back().to)
        conflict.ways.push_back(std::move(*way));
      for (std::size_t i = 0; i < trials_.conditions()[member].instead.size(); ++i)
        if (auto way = instead_of(imposed, member, i)) conflict.ways.push_back(std::move(*way));
    }
    for (Relaxation& way : conflict.ways) way.broken = broken_without(imposed, way);
    const auto cost = [](const Relaxation& way) {
      return way.design ? way.design->cost : std::numeric_limits<double>::infinity();
    };
    std::stable_sort(conflict.ways.begin(), conflict.ways.end(), [&](const Relaxation& a, const Relaxation& b) {
      return cost(a) < cost(b);
    });
  }

  /// How far a condition whose giving way is enough has to, and the cheapest build then.
  void ease(const ConditionSet& imposed, Relaxation& way) {
    const Condition& condition = trials_.conditions()[way.condition];
    const std::string what = "a way out by " + title_of(condition);
    const auto eased = [&](Asked& asked, double to) {
      trials_.lift_others(imposed, asked);
      condition.set(asked, to);
      asked.problem.preference.reset();  // the cheapest at real prices
    };
    if (condition.kind == ConditionKind::choice) {
      way.design = trials_.best_by("cost", what, [&](Asked& asked) {
        trials_.lift_others(without(imposed, {way.condition}), asked);
        asked.problem.preference.reset();
      });
      return;
    }
    if (condition.kind == ConditionKind::budget) {  // exact: the least that any build takes
      const machine::Quantity quantity = condition.quantity;
      way.design = trials_.best_by(std::string(declaration(quantity).name), what, [&](Asked& asked) {
        trials_.lift_others(without(imposed, {way.condition}), asked);
        asked.problem.preference.reset();  // the least cost itself is asked for
      });
      if (way.design) way.to = rounded_looser(condition, way.design->total(quantity));
      if (way.design && quantity != machine::Quantity::cost)  // of the builds within that, as shown, the cheapest
        way.design = trials_.best_by("cost", what, [&](Asked& asked) { eased(asked, *way.to); });
      return;
    }
    const double factor = least_factor(
        condition, [&](double to) { return trials_.possible(what, [&](Asked& asked) { eased(asked, to); }); });
    for (const double to : {rounded_looser(condition, condition.eased(factor)), condition.eased(factor)}) {
      way.to = to;
      way.design = trials_.best_by("cost", what, [&](Asked& asked) { eased(asked, to); });
      if (way.design) return;
    }
    way.to.reset();  // lifted it is enough, and no number that was tried
  }

  /// Of what is no part here, more costs nothing here: the least with which the build is as cheap as with any.
  std::optional<Relaxation> cheapest_of(const ConditionSet& imposed, std::size_t member) {
    const Condition& condition = trials_.conditions()[member];
    if (!condition.no_part) return std::nullopt;
    const std::string what = "a way out by " + title_of(condition);
    const auto lifted = trials_.best_by("cost", what, [&](Asked& asked) {
      trials_.lift_others(without(imposed, {member}), asked);
      asked.problem.preference.reset();
    });
    if (!lifted) return std::nullopt;
    const auto eased = [&](Asked& asked, double to) {
      trials_.lift_others(imposed, asked);
      condition.set(asked, to);
      asked.problem.preference.reset();  // the cheapest at real prices
    };
    const double factor = least_factor(condition, [&](double to) {
      return trials_.possible(what, [&](Asked& asked) {
        eased(asked, to);
        std::optional<double>& limit = asked.problem.limits[machine::Quantity::cost];
        const double as_cheap = lifted->cost * (1.0 + 1e-6);
        limit = std::min(limit.value_or(as_cheap), as_cheap);
      });
    });
    const double to = rounded_looser(condition, condition.eased(factor));
    auto design = trials_.best_by("cost", what, [&](Asked& asked) { eased(asked, to); });
    if (!design) return std::nullopt;
    return Relaxation{member, true, to, std::move(design), std::nullopt, {}};
  }

  /// What may be had instead of a condition's giving way: from the first of its stops that is enough as far back as it
  /// is, with all that was found not to be. Nothing where none is.
  std::optional<Relaxation> instead_of(const ConditionSet& imposed, std::size_t member, std::size_t index) {
    const Condition& condition = trials_.conditions()[member].instead[index];
    const std::string what = "a way out by " + title_of(condition);
    const auto eased = [&](Asked& asked, double to) {
      trials_.lift_others(imposed, asked);
      condition.set(asked, to);
      asked.problem.preference.reset();  // the cheapest at real prices
    };
    const auto enough = [&](double to) { return trials_.possible(what, [&](Asked& asked) { eased(asked, to); }); };
    std::vector<double> refused{condition.value};
    for (const double stop : condition.stops) {
      if (!enough(stop)) {
        refused.push_back(stop);
        continue;
      }
      double accepted = stop;
      while (accepted - refused.back() > (smallest_change - 1.0) * accepted) {
        const double middle = 0.5 * (accepted + refused.back());
        if (enough(middle))
          accepted = middle;
        else
          refused.push_back(middle);
      }
      for (const double to : {rounded_looser(condition, accepted), accepted})
        if (auto design = trials_.best_by("cost", what, [&](Asked& asked) { eased(asked, to); }))
          return Relaxation{member, true, to, std::move(design), index, {}, std::move(refused)};
    }
    return std::nullopt;
  }

  /// What the build of a way out fails by where its condition has not given way: that is what the condition blocks by.
  std::vector<Check> broken_without(const ConditionSet& imposed, const Relaxation& way) {
    std::vector<Check> broken;
    if (!way.design) return broken;
    Asked asked = trials_.asked();
    trials_.lift_others(imposed, asked);
    const BomCheck judged = check(asked.problem,
                                  trials_.catalogue_for(asked),
                                  bill_of(*way.design),
                                  false,
                                  trials_.begin(title_of(way.changed(trials_.conditions()))));
    for (const Check& each : judged.design.checks)
      if (each.kind != machine::ConstraintKind::soft && each.verdict == Verdict::violated) broken.push_back(each);
    std::stable_sort(
        broken.begin(), broken.end(), [](const Check& a, const Check& b) { return a.utilisation > b.utilisation; });
    return broken;
  }

  /// To 1 %; the furthest is known to be enough.
  template <class Enough>
  static double least_factor(const Condition& condition, Enough&& enough) {
    double refused = 1.0, accepted = std::min(1.1, condition.furthest);
    while (accepted < condition.furthest && !enough(condition.eased(accepted))) {
      refused = accepted;
      accepted = std::min(accepted * accepted, condition.furthest);
    }
    while (accepted / refused > smallest_change) {
      const double middle = std::sqrt(accepted * refused);
      (enough(condition.eased(middle)) ? accepted : refused) = middle;
    }
    return accepted;
  }

  void resolve_all() {
    std::vector<const Relaxation*> taken;
    for (const Conflict& conflict : result_.conflicts) {
      if (conflict.ways.empty() || !conflict.ways.front().enough) return;
      taken.push_back(&conflict.ways.front());
    }
    result_.all_resolved = trials_.best_by("cost", "all ways out together", [&](Asked& asked) {
      for (const Relaxation* way : taken) {
        const Condition& condition = way->changed(trials_.conditions());
        way->to ? condition.set(asked, *way->to) : condition.lift(asked);
      }
      asked.problem.preference.reset();
    });
    result_.too_little_together = !result_.all_resolved;
  }

  ConditionTrials& trials_;
  Explanation& result_;
};

}  // namespace

Explanation explain(const Asked& asked,
                    const catalogue::Catalogue& catalogue,
                    std::vector<Condition> conditions,
                    const SearchOptions& options,
                    const ExplanationProgress& progress,
                    double patience) {
  Explanation result;
  result.conditions = std::move(conditions);
  result.objective = options.objectives.front();
  for (const machine::Axis& axis : asked.problem.axes)
    if (NotEased each{axis.name,
                      machine::softens_under_less(axis),
                      machine::failed_by_slower(axis),
                      machine::failed_by_lighter(axis)};
        each.softens || !each.slower.empty() || !each.lighter.empty())
      result.not_eased.push_back(std::move(each));
  ConditionTrials trials(asked, catalogue, result.conditions, options, progress, patience);
  try {
    result.design = trials.best("the machine as it is asked for", {}, true);
    if (result.design) {
      result.status = solver::Status::optimal;
      find_rates(trials, result);
      const BestBuild best = find_best(trials, result.objective);
      find_choices(trials, best, result);
      find_prices(trials, best, result);
      find_figure_ends(trials, patience_with_tolerances, result);
    } else {
      Contradictions(trials, result).find();
    }
  } catch (const TimeIsUp&) {
    result.status = solver::Status::limit;
  } catch (const Unsettled&) {  // only where all the time there is was given
    result.status = solver::Status::limit;
  }
  // Where it had not even been found out which conditions cost anything, all of them are open.
  const bool asked_for_prices = result.costless > 0 || !result.prices.empty() || !result.unsettled.empty();
  if (result.status == solver::Status::limit && result.design && !asked_for_prices) result.unsettled = trials.all();
  result.solves = trials.solves();
  result.seconds = trials.seconds();
  return result;
}

}  // namespace millwright::evaluation
