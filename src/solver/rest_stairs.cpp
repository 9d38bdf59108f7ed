// SPDX-License-Identifier: Apache-2.0
//
// One allowance kept as it is while the others have prices (rest_prices.h), and what is left out for it.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "solver/rest_curve.h"
#include "solver/rest_prices.h"

namespace millwright::solver {
namespace {

constexpr std::size_t most_points = 300;  // of a staircase

/// Weights of the state before a stage, from those after it.
std::vector<double> before(const StateForm& form, const std::vector<double>& after) {
  std::vector<double> weight(after.size());
  for (std::size_t h = 0; h < after.size(); ++h)
    for (std::size_t c = 0; c < after.size(); ++c) weight[c] += after[h] * form.slope[h][c];
  return weight;
}

}  // namespace

/// What a handed-on component takes over from inherited states.
Interval flow(const StateForm& form, std::size_t component, std::span<const Interval> states) {
  double least = 0.0;
  double most = 0.0;
  for (std::size_t c = 0; c < states.size(); ++c) {
    const double slope = form.slope[component][c];
    if (slope == 0.0) continue;
    least += slope * (slope > 0.0 ? states[c].lower : states[c].upper);
    most += slope * (slope > 0.0 ? states[c].upper : states[c].lower);
  }
  return {least, most};
}

/// For each allowance with a price: its staircase.
void RestPlanes::Prices::find_stairs() {
  const auto own = [this](const auto& stairs) { return stairs.mix == mix_; };
  for (StagePlan& plan : plans_) std::erase_if(plan.stairs, own);
  std::erase_if(kept_stairs_, own);
  const std::vector<double> price = best_price_;
  std::vector<double> slope(allowances_, 0.0);
  std::size_t number = 0;
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    for (const Allowance& end : stages_[i].ends) {
      const std::size_t at = number++;
      if (!(price[at] > 0.0)) continue;
      std::vector<double> others = price;
      others[at] = 0.0;
      KeptStairs kept;
      kept.mix = mix_;
      kept.end_stage = i;
      kept.limit = end.limit;
      if (auto use = find_use(i, end)) {
        kept.use = std::move(*use);
        if (std::isfinite(evaluate(others, slope))) keep_stairs(std::move(kept), end);
      }
    }
  }
}

/// What states and additions to them take of an allowance. Nothing: something makes room for it.
std::optional<std::vector<std::vector<double>>> RestPlanes::Prices::find_use(std::size_t end_stage,
                                                                             const Allowance& end) const {
  std::vector<std::vector<double>> use(stages_.size() + 1, std::vector<double>(state_.size()));
  for (std::size_t i = end_stage + 1; i-- > 0;) {
    use[i] = before(*stages_[i].form, use[i + 1]);
    if (i == end_stage) use[i][end.component] += 1.0;
    if (std::any_of(use[i].begin(), use[i].end(), [](double each) { return each < 0.0; })) return std::nullopt;
  }
  return use;
}

/// What a stage may add to scores and priced state, and what that takes of the allowance.
std::vector<Pair> RestPlanes::Prices::points(std::size_t stage, const Allowance& end, const KeptStairs& kept) {
  const PricedStage& own = stages_[stage];
  const std::vector<double>& weight = planes_[stage].weight;
  const std::vector<double>& use = kept.use[stage + 1];
  std::vector<Pair> found;
  const auto add_all = [&](const RegionPool& pool, double value, double taken) {
    for (std::size_t h = 0; h < weight.size(); ++h) {
      if (weight[h] == 0.0 && use[h] == 0.0) continue;
      const double inherited = flow(*own.form, h, pool.inherited()).upper;
      if (weight[h] != 0.0) value -= weight[h] * inherited;
      if (use[h] != 0.0) taken -= use[h] * inherited;
    }
    pool.for_each([&](const Bounds& bounds) {
      found.push_back({value + priced(bounds, kept.mix, weight), taken + used(bounds, use)});
    });
  };
  if (own.pool) {
    add_all(*own.pool, 0.0, 0.0);
    return lower_staircase(std::move(found));
  }
  const auto has_steps = [](const Allowance& each) { return !each.from.empty(); };
  const auto steps = std::find_if(own.ends.begin(), own.ends.end(), has_steps);
  const std::size_t number = static_cast<std::size_t>(steps - own.ends.begin());
  // What the evaluation has paid is for the step that it has chosen; a dearer step is one that leaves more of it.
  for (std::size_t k = 0; k < steps->pool.size(); ++k) {
    const double paid_more = unit_[stage][number] * (used_[stage][number] - steps->up_to(k));
    add_all(steps->pool[k], paid_more, &*steps == &end ? end.limit - steps->up_to(k) : 0.0);
  }
  return lower_staircase(std::move(found));
}

/// Of the evaluation under way, in which this allowance has no price.
void RestPlanes::Prices::keep_stairs(KeptStairs kept, const Allowance& end) {
  const std::size_t stages = stages_.size();
  std::vector<std::vector<Pair>> own(stages), suffix(stages + 1, {Pair{}}), prefix(stages + 1, {Pair{}});
  for (std::size_t i = 0; i < stages; ++i) {
    own[i] = points(i, end, kept);
    if (own[i].empty()) return;  // nothing is feasible: the search will find out
    prefix[i + 1] = sum_of_staircases(prefix[i], own[i], most_points);
  }
  const double limit = kept.limit;
  double paid = 0.0;
  for (std::size_t i = stages; i-- > 0;) {
    const double room = planes_[i].room + std::fabs(paid) + std::fabs(suffix[i + 1].back().first);
    if (i < kept.end_stage)
      plans_[i].stairs.push_back(
          {kept.mix, limit, -paid - sum_slack * room, planes_[i].weight, kept.use[i + 1], suffix[i + 1]});
    suffix[i] = sum_of_staircases(own[i], suffix[i + 1], most_points);
    paid += paid_[i];
  }
  const double room = before_.room + std::fabs(paid) + std::fabs(suffix[0].back().first);
  kept.constant = -paid - sum_slack * room;
  kept.limit += sum_slack * std::fabs(limit);
  for (std::size_t c = 0; c < state_.size(); ++c) {
    kept.constant += before_.weight[c] * state_[c];
    kept.limit -= kept.use[0][c] * state_[c];
  }
  for (std::size_t i = 0; i < stages; ++i) {
    kept.weight.push_back(planes_[i].weight);
    kept.without.push_back(sum_of_staircases(prefix[i], suffix[i + 1], most_points));
  }
  kept_stairs_.push_back(std::move(kept));
}

/// What a build with a design of these bounds must come to at least.
double RestPlanes::Prices::least_total(const KeptStairs& stairs, std::size_t stage, const Bounds& bounds) const {
  const RegionPool& pool = *stages_[stage].pool;
  double total = stairs.constant + priced(bounds, stairs.mix, stairs.weight[stage]);
  const std::vector<double>& use = stairs.use[stage + 1];
  double taken = used(bounds, use);
  for (std::size_t h = 0; h < use.size(); ++h) {
    if (stairs.weight[stage][h] == 0.0 && use[h] == 0.0) continue;
    const double inherited = flow(*stages_[stage].form, h, pool.inherited()).upper;
    if (stairs.weight[stage][h] != 0.0) total -= stairs.weight[stage][h] * inherited;
    if (use[h] != 0.0) taken -= use[h] * inherited;
  }
  return total + least_within(stairs.without[stage], stairs.limit - taken);
}

bool RestPlanes::Prices::restrict_to(const std::vector<Pair>& corners) {
  for (std::size_t i = 0; i < stages_.size() && !kept_.empty(); ++i) {
    if (!stages_[i].pool) continue;
    const auto may_lead = [&](const Bounds& bounds) {
      constexpr double unknown = -std::numeric_limits<double>::max();
      LeastTotals totals(unknown, unknown);
      for (const Kept& kept : kept_) totals.add(kept.mix, kept.without[i] + priced(bounds, kept.mix, kept.weight[i]));
      for (const KeptStairs& kept : kept_stairs_) totals.add(kept.mix, least_total(kept, i, bounds));
      return totals.below(corners) && vectors_reach(i, bounds, corners);
    };
    if (!stages_[i].pool->keep_only(may_lead, desk_)) return false;
    stages_[i].pool->narrow(plans_[i].region);
    keep_within_region(plans_[i]);
  }
  return true;
}

/// What the stages can bear, now that some designs are left out.
void RestPlanes::Prices::tighten_limits() {
  for (std::size_t i = stages_.size(); i-- > 1;) {
    if (!stages_[i].pool) continue;
    const std::vector<double> handed_on = stages_[i].pool->least_handed_on();
    for (std::size_t h = 0; h < handed_on.size(); ++h) {
      if (!std::isfinite(plans_[i].most_after[h])) continue;
      const StateForm& form = *stages_[i].form;
      const std::vector<double>& slope = form.slope[h];
      const double own = handed_on[h] - flow(form, h, stages_[i].pool->inherited()).upper;
      const double inherited = flow(form, h, plans_[i].inherited).lower;
      for (std::size_t c = 0; c < slope.size(); ++c) {
        if (!(slope[c] > 0.0)) continue;
        const double others = inherited - slope[c] * plans_[i].inherited[c].lower;
        const double room = std::fabs(plans_[i].most_after[h]) + std::fabs(own) + std::fabs(others);
        const double most = (plans_[i].most_after[h] - own - others + sum_slack * room) / slope[c];
        plans_[i - 1].most_after[c] = std::min(plans_[i - 1].most_after[c], most);
      }
    }
  }
}

}  // namespace millwright::solver
