// SPDX-License-Identifier: Apache-2.0
//
// The stack family for solvers of real numbers: per axis a screw, a motor and a ramp, each from 0 to 1; rows by
// rounding in tables sorted by price.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>

#include "benchmark/peers/peer.h"

namespace stack::peers {

class RoundedModel {
 public:
  struct Answer {
    Design design;
    double cost = 0.0;
    double excess = 0.0;  ///< of the worst constraint; 0 and less: a design
  };

  explicit RoundedModel(const Instance& instance) : instance_(instance), machine_(instance) {
    const auto by = [](const Columns& table, auto key) {
      std::vector<std::uint32_t> order(table.rows());
      std::iota(order.begin(), order.end(), 0U);
      std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return key(table.row(a)) < key(table.row(b));
      });
      return order;
    };
    screws_ = by(instance.screws, [](const double* s) { return s[price] + 0.5 * s[price_per_length]; });
    motors_ = by(instance.motors, [](const double* q) { return q[motor_price]; });
  }

  [[nodiscard]] std::size_t dimensions() const { return 3 * instance_.axes.size(); }

  [[nodiscard]] Answer answer(std::span<const double> x) const {
    Answer result;
    result.excess = -1.0;
    std::vector<double> state = machine_.problem.first_state;
    millwright::solver::Answer<double> answer;
    for (std::size_t i = 0; i < instance_.axes.size(); ++i) {
      const Axis& axis = instance_.axes[i];
      const Choice choice{
          row(screws_, x[3 * i]),
          row(motors_, x[3 * i + 1]),
          axis.shortest_ramp() + std::clamp(x[3 * i + 2], 0.0, 1.0) * (axis.longest_ramp() - axis.shortest_ramp())};
      const std::vector<std::uint32_t> rows{choice.screw, choice.motor};
      const std::vector<double> ramp{choice.ramp};
      machine_.problem.stages[i]->evaluate({{}, state, rows, ramp}, answer);
      for (const double u : answer.utilisation) result.excess = std::max(result.excess, u - 1.0);
      result.cost += answer.resources[0];
      state = answer.handed_on;
      result.design.push_back(choice);
    }
    return result;
  }

 private:
  static std::uint32_t row(const std::vector<std::uint32_t>& order, double x) {
    const auto size = static_cast<double>(order.size());
    return order[static_cast<std::size_t>(std::clamp(x * size, 0.0, size - 1.0))];
  }

  const Instance& instance_;
  Machine machine_;
  std::vector<std::uint32_t> screws_, motors_;
};

}  // namespace stack::peers
