// SPDX-License-Identifier: Apache-2.0
//
// The least weighted total of a machine over all of its builds, tried one by one, where the ramp time moves what is
// counted: for each choice of rows the best complying ramp, on a grid that is refined round its best point. Of what is
// handed on the ramp may change the power only (that is looked at); so after the best ramp comes the best of those that
// take at least a watt less, and so on, and each of them is tried with all that can follow.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "evaluation/machine_model.h"
#include "evaluation/ramp_choice.h"

namespace millwright {

class PricedExhaustive {
 public:
  /// Totals of the best build of one choice of rows.
  struct Total {
    double weighted = 0.0;
    double cost = 0.0;
  };

  /// `weights`: one per resource of the model.
  PricedExhaustive(const evaluation::MachineModel& model, std::vector<double> weights)
      : problem_(model.problem()), weights_(std::move(weights)) {
    for (solver::Row v = 0; v < problem_.shared.front().rows; ++v) {
      shared_ = {v};
      descend(0, problem_.first_state, {});
    }
  }

  std::vector<Total> builds;  ///< of every choice of rows that can comply
  [[nodiscard]] double least() const {
    double best = std::numeric_limits<double>::infinity();
    for (const Total& total : builds) best = std::min(best, total.weighted);
    return best;
  }
  /// Ascending in cost, strictly falling in the weighted total.
  [[nodiscard]] std::vector<Total> front() const {
    std::vector<Total> sorted = builds, result;
    std::sort(sorted.begin(), sorted.end(), [](const Total& a, const Total& b) {
      return std::abs(a.cost - b.cost) > 1e-9 ? a.cost < b.cost : a.weighted < b.weighted;
    });
    for (const Total& total : sorted)
      if (result.empty() || total.weighted < result.back().weighted * (1.0 - 1e-9)) result.push_back(total);
    return result;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Step {
    std::vector<double> state;
    Total own;
  };

  void descend(std::size_t stage, const std::vector<double>& state, Total so_far) {
    if (stage == problem_.stages.size()) {
      builds.push_back(so_far);
      return;
    }
    for (const Step& step : steps(*problem_.stages[stage], state))
      descend(stage + 1, step.state, {so_far.weighted + step.own.weighted, so_far.cost + step.own.cost});
  }

  std::vector<Step> steps(const solver::Stage& stage, const std::vector<double>& state) {
    std::vector<Step> all;
    std::vector<solver::Row> rows(stage.slots().size(), 0);
    for (;;) {
      // The best ramp, then the best of those that take less power, ...
      for (most_power_ = infinity; most_power_ > 0.0;) {
        Step step{{}, {infinity, 0.0}};
        best_ramp(stage, state, rows, step);
        if (!std::isfinite(step.own.weighted)) break;
        most_power_ = power_ ? step.state[*power_] - 0.5 : 0.0;
        all.push_back(std::move(step));
      }
      std::size_t slot = 0;
      while (slot < rows.size() && ++rows[slot] == stage.slots()[slot].rows) rows[slot++] = 0;
      if (slot == rows.size()) return all;
    }
  }

  /// What of the state the ramp changes, if anything.
  void find_power(const solver::Stage& stage,
                  const std::vector<double>& state,
                  const std::vector<solver::Row>& rows,
                  double lower,
                  double upper) {
    const std::vector<double> shortest{lower}, longest{upper};
    stage.evaluate({shared_, state, rows, shortest}, answer_);
    const std::vector<double> of_shortest = answer_.handed_on;
    stage.evaluate({shared_, state, rows, longest}, answer_);
    power_ = changed_component(of_shortest, answer_.handed_on);
  }

  void best_ramp(const solver::Stage& stage,
                 const std::vector<double>& state,
                 const std::vector<solver::Row>& rows,
                 Step& best) {
    if (stage.variables().size() > 1) throw std::logic_error("more than a ramp is free");
    if (stage.variables().empty()) {
      power_.reset();
      return look(stage, state, rows, {}, best);
    }
    double lower = stage.variables()[0].lower, upper = stage.variables()[0].upper;
    find_power(stage, state, rows, lower, upper);
    for (int round = 0; round < 7; ++round) {
      constexpr int grid = 24;
      const double step = (upper - lower) / grid;
      const double before = best.own.weighted;
      double at = lower;
      for (int i = 0; i <= grid; ++i) {
        const double time = std::clamp(lower + i * step, stage.variables()[0].lower, stage.variables()[0].upper);
        const double least = best.own.weighted;
        look(stage, state, rows, {time}, best);
        if (best.own.weighted < least) at = time;
      }
      if (!std::isfinite(best.own.weighted)) return;
      if (round > 0 && !(best.own.weighted < before)) at = last_;
      last_ = at;
      lower = std::max(at - step, stage.variables()[0].lower);
      upper = std::min(at + step, stage.variables()[0].upper);
    }
  }

  void look(const solver::Stage& stage,
            const std::vector<double>& state,
            const std::vector<solver::Row>& rows,
            const std::vector<double>& variables,
            Step& best) {
    stage.evaluate({shared_, state, rows, variables}, answer_);
    for (const double u : answer_.utilisation)
      if (u > 1.0) return;
    if (power_ && answer_.handed_on[*power_] > most_power_) return;
    double weighted = 0.0;
    for (std::size_t r = 0; r < weights_.size(); ++r) weighted += weights_[r] * answer_.resources[r];
    if (!(weighted < best.own.weighted)) return;
    best.own = {weighted, answer_.resources[0]};
    best.state = answer_.handed_on;
  }

  const solver::Problem& problem_;
  std::vector<double> weights_;
  std::vector<solver::Row> shared_;
  solver::Answer<double> answer_;
  std::optional<std::size_t> power_;  ///< of the state, where the ramp changes it
  double most_power_ = infinity;      ///< that is looked at
  double last_ = 0.0;
};

}  // namespace millwright
