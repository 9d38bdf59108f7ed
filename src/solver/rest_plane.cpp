// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "solver/rest_prices.h"

namespace millwright::solver {
namespace {

constexpr int iterations = 30;
constexpr int most_planes = 4;  // kept: the last of those that raised the bound

}  // namespace

RestPlanes::Prices::Prices(const Problem& problem,
                           std::vector<StagePlan>& plans,
                           std::span<const StateForm> forms,
                           Desk& desk)
    : problem_(problem), plans_(plans), forms_(forms.begin(), forms.end()), desk_(desk) {
  if (!std::all_of(forms.begin(), forms.end(), [](const StateForm& form) { return form.additive; })) return;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    stages_.push_back({&plans[i], &forms_[i], {}, std::nullopt});
    find_ends(i);
    const bool has_steps = std::any_of(
        stages_[i].ends.begin(), stages_[i].ends.end(), [](const Allowance& end) { return !end.from.empty(); });
    if (!has_steps) stages_[i].pool.emplace(plans[i], plans[i].best_inherited);
    allowances_ += stages_[i].ends.size();
  }
  has_had_price_.assign(allowances_, false);
}

double RestPlanes::Prices::find(const Mix& mix, double known) {
  const auto own = [mix](const auto& plane) { return plane.mix == mix; };
  for (StagePlan& plan : plans_) std::erase_if(plan.planes, own);
  std::erase_if(kept_, own);
  mix_ = mix;
  first_ = 0;
  state_ = problem_.first_state;
  double best = -infinity;
  climb(known, [&](double bound) {
    keep(bound);
    best = bound - sum_slack * before_.room;
  });
  for (std::size_t a = 0; a < allowances_; ++a) has_had_price_[a] = has_had_price_[a] || best_price_[a] > 0.0;
  find_stairs();
  return best;
}

double RestPlanes::Prices::find_from(const Mix& mix, double known, std::size_t stage, std::span<const double> state) {
  mix_ = mix;
  first_ = stage;
  state_.assign(state.begin(), state.end());
  std::optional<RestPlane> best;
  const double bound = climb(known, [&](double) { best = rest_plane(before_); });
  if (best) plans_[stage - 1].planes.push_back(std::move(*best));
  return bound;
}

/// Moves the prices as long as the bound at the first stage rises, and tells when it has. The best bound.
double RestPlanes::Prices::climb(double known, const std::function<void(double bound)>& risen) {
  std::vector<double> price(allowances_, 0.0);  // of a whole limit
  std::vector<double> slope(allowances_, 0.0);
  double best = -infinity;
  best_price_.assign(allowances_, 0.0);
  double length = 1.0;
  int idle = 0;
  for (int i = 0; i < iterations && allowances_ > 0; ++i) {
    const double bound = evaluate(price, slope);
    if (!std::isfinite(bound)) return best;  // nothing is feasible: the search will find out
    if (i == 0 || bound > best + 1e-9 * std::fabs(best)) {
      risen(bound);
      best_price_ = price;
      best = bound;
      idle = 0;
    } else if (++idle == 3) {
      length *= 0.5;
      idle = 0;
    }
    double norm = 0.0;
    for (std::size_t a = 0; a < allowances_; ++a) {
      if (price[a] == 0.0 && slope[a] < 0.0) slope[a] = 0.0;
      norm += slope[a] * slope[a];
    }
    const double missing = (std::isfinite(known) ? known : best + 0.3 * std::fabs(best)) - bound;
    if (!(norm > 1e-12) || !(missing > 1e-6 * std::fabs(best))) break;
    for (std::size_t a = 0; a < allowances_; ++a)
      price[a] = std::max(0.0, price[a] + length * missing / norm * slope[a]);
  }
  return best;
}

void RestPlanes::Prices::find_ends(std::size_t stage) {
  const StagePlan& plan = plans_[stage];
  if (stage == 0) return;
  for (std::size_t c = 0; c < plan.before.size(); ++c) {
    const bool ends = plan.before[c] == Direction::smaller_is_better && plan.after[c] == Direction::irrelevant;
    const double limit = plans_[stage - 1].most_after[c];
    if (!ends || !std::isfinite(limit) || !(limit > 0.0)) continue;
    Allowance end{c, limit * (1.0 + sum_slack)};
    if (has_few_designs(plan) && stages_[stage].ends.empty()) find_steps(stage, end);
    stages_[stage].ends.push_back(std::move(end));
  }
}

/// Where an objective's least rises with the amount that arrives, if a curve (rest_curve.h) says so.
void RestPlanes::Prices::find_steps(std::size_t stage, Allowance& end) {
  const StagePlan& plan = plans_[stage];
  std::vector<double> from{plan.best_inherited[end.component].lower};
  for (const RestCurve& curve : plans_[stage - 1].curves)
    if (curve.component == end.component) from.insert(from.end(), curve.from.begin(), curve.from.end());
  std::sort(from.begin(), from.end());
  std::erase_if(from, [&](double amount) { return amount < from.front() || amount >= end.limit; });
  from.erase(std::unique(from.begin(), from.end()), from.end());
  if (from.size() < 2) return;
  for (const double amount : from) {
    std::vector<Interval> inherited = plan.best_inherited;
    inherited[end.component] = amount;
    end.pool.emplace_back(plan, std::move(inherited));
  }
  end.from = std::move(from);
}

/// The bound at the tool for these prices, and how it changes with them.
double RestPlanes::Prices::evaluate(std::span<const double> price, std::span<double> slope) {
  planes_.assign(plans_.size(), {});
  chosen_.assign(plans_.size(), {});
  used_.assign(plans_.size(), {});
  least_.assign(plans_.size(), 0.0);
  unit_.assign(plans_.size(), {});
  paid_.assign(plans_.size(), 0.0);
  Plane plane;
  plane.weight.assign(state_.size(), 0.0);
  std::size_t allowance = allowances_;
  for (std::size_t i = plans_.size(); i-- > first_;) {
    planes_[i] = plane;
    allowance -= stages_[i].ends.size();
    if (!pass(i, price.subspan(allowance, stages_[i].ends.size()), plane)) return infinity;
  }
  before_ = plane;
  std::vector<double> state = state_;
  std::fill(slope.begin(), slope.end(), 0.0);
  for (std::size_t i = first_; i < plans_.size(); ++i) {
    for (std::size_t e = 0; e < stages_[i].ends.size(); ++e) {
      const Allowance& end = stages_[i].ends[e];
      slope[allowance++] = (state[end.component] - used_[i][e]) / end.limit;
    }
    state = after(i, state);
  }
  double bound = plane.constant;
  for (std::size_t c = 0; c < plane.weight.size(); ++c) bound += plane.weight[c] * state_[c];
  return bound;
}

RestPlanes::Prices::Addition RestPlanes::Prices::least_addition(RegionPool& pool,
                                                                const StateForm& form,
                                                                std::span<const double> weight) {
  RegionPool::Least least = pool.least(mix_, weight, desk_);
  Addition addition{least.value, least.value, std::fabs(least.value), std::move(least.handed_on)};
  for (std::size_t h = 0; h < addition.state.size(); ++h) {
    const double inherited = flow(form, h, pool.inherited()).upper;
    addition.state[h] -= inherited;
    if (weight[h] == 0.0) continue;
    addition.value -= weight[h] * inherited;
    addition.room += std::fabs(weight[h] * inherited);
  }
  return addition;
}

/// From after a stage to before it. False where no design is feasible, or a weight would become negative.
bool RestPlanes::Prices::pass(std::size_t stage, std::span<const double> price, Plane& plane) {
  PricedStage& own = stages_[stage];
  used_[stage].clear();
  for (const Allowance& end : own.ends) used_[stage].push_back(end.limit);
  Addition least;
  least.value = infinity;
  if (own.pool) least = least_addition(*own.pool, *own.form, plane.weight);
  for (std::size_t e = 0; e < own.ends.size(); ++e) {
    Allowance& end = own.ends[e];
    double value = infinity;
    for (std::size_t k = 0; k < end.from.size(); ++k) {
      const double up_to = end.up_to(k);
      Addition here = least_addition(end.pool[k], *own.form, plane.weight);
      const double own_value = here.value - price[e] / end.limit * up_to;
      if (!(own_value < value)) continue;
      value = own_value;
      used_[stage][e] = up_to;
      least = std::move(here);
    }
  }
  if (!(least.value < infinity)) return false;
  plane.constant += least.value;
  least_[stage] = least.priced;
  plane.room += least.room;
  chosen_[stage] = std::move(least.state);
  std::vector<double> weight(plane.weight.size(), 0.0);
  for (std::size_t h = 0; h < weight.size(); ++h)
    for (std::size_t c = 0; c < weight.size(); ++c) weight[c] += plane.weight[h] * own.form->slope[h][c];
  for (std::size_t e = 0; e < own.ends.size(); ++e) {
    const double unit = price[e] / own.ends[e].limit;
    unit_[stage].push_back(unit);
    paid_[stage] += unit * used_[stage][e];
    plane.constant -= unit * used_[stage][e];
    plane.room += unit * used_[stage][e];
    weight[own.ends[e].component] += unit;
  }
  plane.weight = std::move(weight);
  return std::all_of(plane.weight.begin(), plane.weight.end(), [](double w) { return w >= 0.0; });
}

std::vector<double> RestPlanes::Prices::after(std::size_t stage, const std::vector<double>& state) const {
  std::vector<double> next = chosen_[stage];
  for (std::size_t h = 0; h < next.size(); ++h)
    for (std::size_t c = 0; c < state.size(); ++c) next[h] += stages_[stage].form->slope[h][c] * state[c];
  return next;
}

RestPlane RestPlanes::Prices::rest_plane(const Plane& plane) const {
  return {mix_, plane.constant - sum_slack * plane.room, plane.weight};
}

void RestPlanes::Prices::keep(double bound) {
  const auto own = [this](const auto& plane) { return plane.mix == mix_; };
  const bool full = std::count_if(kept_.begin(), kept_.end(), own) >= most_planes;
  if (full) kept_.erase(std::find_if(kept_.begin(), kept_.end(), own));
  Kept& kept = kept_.emplace_back();
  kept.mix = mix_;
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    kept.without.push_back(bound - sum_slack * before_.room - least_[i]);
    kept.weight.push_back(planes_[i].weight);
    std::vector<RestPlane>& planes = plans_[i].planes;
    if (full) planes.erase(std::find_if(planes.begin(), planes.end(), own));
    planes.push_back(rest_plane(planes_[i]));
  }
}

RestPlanes::RestPlanes(const Problem& problem,
                       std::vector<StagePlan>& plans,
                       std::span<const StateForm> forms,
                       Desk& desk)
    : prices_(std::make_unique<Prices>(problem, plans, forms, desk)) {}
RestPlanes::~RestPlanes() = default;
double RestPlanes::find(const Mix& mix, double known) { return prices_->find(mix, known); }
double RestPlanes::find_from(const Mix& mix, double known, std::size_t stage, std::span<const double> state) {
  return prices_->find_from(mix, known, stage, state);
}
bool RestPlanes::restrict_to(const std::vector<Pair>& corners) { return prices_->restrict_to(corners); }
void RestPlanes::tighten_limits() { prices_->tighten_limits(); }
bool RestPlanes::find_vectors(const std::vector<Pair>& corners) { return prices_->find_vectors(corners); }
void RestPlanes::keep_regions() { prices_->keep_regions(); }

}  // namespace millwright::solver
