// SPDX-License-Identifier: Apache-2.0
#include "solver/criteria.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace millwright::solver {
namespace {

std::vector<double> unit_weight(std::size_t resources, std::size_t index, const char* option) {
  if (index >= resources) {
    throw std::invalid_argument(std::string(option) + " names resource " + std::to_string(index) + " but there are " +
                                std::to_string(resources));
  }
  std::vector<double> weight(resources, 0.0);
  weight[index] = 1.0;
  return weight;
}

/// Adds a score, or the limit to an equal one that is already there.
void add_limit(Criteria& criteria, const std::vector<double>& weight, double limit) {
  for (std::size_t k = 0; k < criteria.size(); ++k) {
    if (criteria.weight[k] == weight) {
      criteria.limit[k] = limit;
      return;
    }
  }
  criteria.weight.push_back(weight);
  criteria.limit.push_back(limit);
}

}  // namespace

bool Criteria::reads(std::size_t resource) const {
  for (const auto& row : weight) {
    if (row[resource] != 0.0) return true;
  }
  return false;
}

void Criteria::least_scores(std::span<const Interval> resources, std::span<double> out) const {
  using scalar::rounding::product_down;
  using scalar::rounding::sum_down;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    double sum = 0.0;
    bool first = true;
    for (std::size_t r = 0; r < resources.size(); ++r) {
      const double w = weight[k][r];
      if (w == 0.0) continue;
      const double share = w == 1.0 ? resources[r].lower : product_down(w, resources[r].lower);
      sum = first ? share : sum_down(sum, share);
      first = false;
    }
    out[k] = sum;
  }
}

bool Criteria::is_as_good(std::span<const double> score, std::span<const double> than, double part) const {
  for (std::size_t k = 0; k < objectives; ++k)
    if (score[k] > than[k] + part * std::fabs(than[k])) return false;
  return true;
}

void Criteria::lower_guides(std::span<double> score) const {
  using scalar::rounding::product_down;
  using scalar::rounding::sum_down;
  for (std::size_t g = 0; g < guides; ++g) {
    double sum = 0.0;
    for (std::size_t k = 0; k < guide_mix[g].size(); ++k)
      if (guide_mix[g][k] != 0.0) sum = sum_down(sum, product_down(guide_mix[g][k], score[k]));
    double& guide = score[size() - guides + g];
    guide = std::min(guide, sum);
  }
}

bool Criteria::has_to_be_kept_low(std::size_t score) const { return std::isfinite(limit[score]) || is_floor(score); }

bool Criteria::is_less_by_floors(std::size_t score, std::span<const double> less, std::span<const double> than) const {
  return std::all_of(floors.begin(), floors.end(), [&](const Floor& floor) {
    return floor.resource != score || rounded(less[floor.bound]) < rounded(than[floor.bound]);
  });
}

void Criteria::raise(std::span<double> total) const {
  for (const Floor& floor : floors) total[floor.resource] = std::max(total[floor.resource], total[floor.bound]);
  for (std::size_t g = 0; g < limit_worth.size(); ++g)
    total[0] = std::max(total[0], total_down(total[size() - guides + g], -limit_worth[g]));
}

namespace {

void add_guide(Criteria& criteria, std::vector<double> mix) {
  std::vector<double> weight(criteria.weight[0].size(), 0.0);
  for (std::size_t r = 0; r < weight.size(); ++r)
    for (std::size_t k = 0; k < mix.size(); ++k) weight[r] += mix[k] * criteria.weight[k][r];
  criteria.weight.push_back(std::move(weight));
  criteria.limit.push_back(infinity);
  criteria.guide_mix.push_back(std::move(mix));
  ++criteria.guides;
}

}  // namespace

void add_guides(Criteria& criteria, std::span<const double> apart) {
  // So much of each objective, as shares of what builds differ by.
  static const std::vector<std::vector<double>> of_two = {
      {1, 0.1}, {1, 0.3}, {1, 0.6}, {1, 1}, {1, 1.7}, {1, 3}, {1, 10}};
  static const std::vector<std::vector<double>> of_three = {{1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  for (const std::vector<double>& shares : apart.size() == 2 ? of_two : of_three) {
    std::vector<double> mix;
    bool useful = true;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      useful = useful && (shares[k] == 0.0 || (apart[k] > 0.0 && std::isfinite(apart[k])));
      mix.push_back(shares[k] == 0.0 ? 0.0 : shares[k] / apart[k]);
    }
    if (useful) add_guide(criteria, std::move(mix));
  }
}

void add_limit_prices(Criteria& criteria, std::size_t score, std::span<const double> prices) {
  for (const double price : prices) {
    std::vector<double> mix(score + 1, 0.0);
    mix.front() = 1.0;
    mix.back() = price;
    // Totals may exceed a limit by rounding (within_limit).
    const double worth = price * criteria.limit[score];
    criteria.limit_worth.push_back(worth + bound_slack * std::fabs(worth));
    add_guide(criteria, std::move(mix));
  }
}

namespace {

/// Of each score: the same with floors for the resources that have some. Ties need them only where designs are not
/// compared in states because there are floors.
void add_floors(Criteria& criteria, const Problem& problem) {
  const std::size_t scores = criteria.size();
  const auto reads_floored = [&](std::size_t k) {
    return std::any_of(problem.floors.begin(), problem.floors.end(), [&](const Floor& floor) {
      return criteria.weight[k][floor.resource] != 0.0;
    });
  };
  bool any = false;
  for (std::size_t k = 0; k < scores; ++k)
    any = any || ((k < criteria.objectives || std::isfinite(criteria.limit[k])) && reads_floored(k));
  for (std::size_t k = 0; any && k < scores; ++k)
    for (const Floor& floor : problem.floors) {
      std::vector<double> weight = criteria.weight[k];
      if (weight[floor.resource] == 0.0) continue;
      weight[floor.bound] += std::exchange(weight[floor.resource], 0.0);
      criteria.floors.push_back({k, criteria.size()});
      criteria.weight.push_back(std::move(weight));
      criteria.limit.push_back(criteria.limit[k]);
    }
  if (criteria.floors.empty()) return;
  criteria.states_in_floors.assign(problem.first_state.size(), false);
  for (const std::size_t component : problem.states_in_floors) criteria.states_in_floors[component] = true;
}

}  // namespace

Criteria make_criteria(const Problem& problem, const Options& options) {
  const std::size_t resources = problem.resources.size();
  Criteria criteria;
  if (!options.weights.empty()) {
    if (options.weights.size() != resources) {
      throw std::invalid_argument("Options::weights needs one weight for each of the " + std::to_string(resources) +
                                  " resources");
    }
    for (const double weight : options.weights) {
      if (!(weight >= 0.0) || !std::isfinite(weight)) {
        throw std::invalid_argument("Options::weights must be finite and not negative");
      }
    }
    criteria.weight.push_back(options.weights);
  } else {
    if (options.objectives.empty()) throw std::invalid_argument("Options::objectives is empty");
    for (const std::size_t index : options.objectives) {
      criteria.weight.push_back(unit_weight(resources, index, "Options::objectives"));
    }
  }
  criteria.objectives = criteria.weight.size();
  for (const std::size_t index : options.ties) {
    criteria.weight.push_back(unit_weight(resources, index, "Options::ties"));
  }
  criteria.ties = criteria.weight.size() - criteria.objectives;
  criteria.limit.assign(criteria.weight.size(), infinity);
  for (std::size_t r = 0; r < resources; ++r) {
    if (problem.resources[r].limit < infinity) {
      add_limit(criteria, unit_weight(resources, r, "Problem::resources"), problem.resources[r].limit);
    }
  }
  add_floors(criteria, problem);
  return criteria;
}

}  // namespace millwright::solver
