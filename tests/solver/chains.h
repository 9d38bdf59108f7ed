// SPDX-License-Identifier: Apache-2.0
//
// Every feasible build of a problem by trying everything, told stage by stage.
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "solver/stage.h"

namespace zoo {

using namespace millwright::solver;

/// Every feasible chain of designs with the variables on a grid, by code that asks stages for nothing but one design.
class Chains {
 public:
  /// `score`: the resource that is meant by cost.
  explicit Chains(const Problem& problem, std::size_t score = 0) : problem_(problem), score_(score) {}

  /// Calls visit(stage, state handed on by it, cost of all later stages, cost up to and with it) for every stage of
  /// every feasible chain.
  template <class Visit>
  void run(std::vector<Row> shared, Visit&& visit) {
    shared_ = std::move(shared);
    states_.assign(problem_.stages.size(), {});
    costs_.assign(problem_.stages.size(), 0.0);
    rows_.assign(problem_.stages.size(), {});
    descend(0, problem_.first_state, visit);
  }

  /// Of the chain that is being visited.
  [[nodiscard]] const std::vector<Row>& rows(std::size_t stage) const { return rows_[stage]; }

 private:
  template <class Visit>
  void descend(std::size_t index, const std::vector<double>& state, Visit& visit) {
    if (index == problem_.stages.size()) {
      double later = 0.0;
      const double whole = std::accumulate(costs_.begin(), costs_.end(), 0.0);
      for (std::size_t i = index; i-- > 0; later += costs_[i]) visit(i, states_[i], later, whole - later);
      return;
    }
    const Stage& stage = *problem_.stages[index];
    std::vector<Row> rows(stage.slots().size(), 0);
    for (;;) {
      if (fit(stage, rows)) at_grid(index, state, rows, visit);
      std::size_t slot = 0;
      while (slot < rows.size() && ++rows[slot] == stage.slots()[slot].rows) rows[slot++] = 0;
      if (slot == rows.size()) return;
    }
  }
  template <class Visit>
  void at_grid(std::size_t index, const std::vector<double>& state, const std::vector<Row>& rows, Visit& visit) {
    constexpr int points = 5;
    const Stage& stage = *problem_.stages[index];
    const auto variables = stage.variables();
    int combinations = 1;
    for (std::size_t v = 0; v < variables.size(); ++v) combinations *= points;
    for (int c = 0; c < combinations; ++c) {
      std::vector<double> x;
      for (int v = 0, rest = c; v < static_cast<int>(variables.size()); ++v, rest /= points) {
        const Variable& variable = variables[static_cast<std::size_t>(v)];
        x.push_back(variable.lower + (variable.upper - variable.lower) * (rest % points) / (points - 1.0));
      }
      Answer<double> answer;
      stage.evaluate({shared_, state, rows, x}, answer);
      if (std::any_of(answer.utilisation.begin(), answer.utilisation.end(), [](double u) { return u > 1.0; })) continue;
      states_[index] = answer.handed_on;
      costs_[index] = answer.resources[score_];
      rows_[index] = rows;
      descend(index + 1, answer.handed_on, visit);
      if (x.size() < 2) return;  // a ramp time moves neither cost nor state: one that does is as good as another
    }
  }
  bool fit(const Stage& stage, const std::vector<Row>& rows) const {
    for (std::size_t a = 0; a < rows.size(); ++a)
      for (std::size_t b = a + 1; b < rows.size(); ++b)
        if (!stage.fits(shared_, a, rows[a], b, rows[b])) return false;
    return true;
  }

  const Problem& problem_;
  std::size_t score_;
  std::vector<Row> shared_;
  std::vector<std::vector<double>> states_;
  std::vector<double> costs_;
  std::vector<std::vector<Row>> rows_;
};

}  // namespace zoo
