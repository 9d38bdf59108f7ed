// SPDX-License-Identifier: Apache-2.0
//
// Every build of a machine, tried one by one: all rows of all slots, and of the ramps with which they comply the one
// that takes least power (ramp_choice.h; cost, mass and what else is handed on do not depend on it, and a supply asks
// for nothing but that the power is not too much). Asks a stage for nothing but the answer to one design.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "evaluation/machine_model.h"
#include "evaluation/ramp_choice.h"

namespace millwright {

struct BuildValue {
  double cost = 0.0, mass = 0.0;
};

/// What a whole build costs less than the sum of its stages, by the rows of all stages.
using Discount = std::function<double(const std::vector<std::vector<solver::Row>>&)>;

class Exhaustive {
 public:
  explicit Exhaustive(const evaluation::MachineModel& model, Discount discount = {})
      : problem_(model.problem()), discount_(std::move(discount)), rows_(problem_.stages.size()) {
    for (solver::Row v = 0; v < problem_.shared.front().rows; ++v) {
      shared_ = {v};
      descend(0, problem_.first_state, {});
      greedy();
    }
  }

  std::vector<BuildValue> builds;     ///< compliant ones
  std::optional<double> greedy_cost;  ///< stage by stage the cheapest that complies
  [[nodiscard]] double least(double BuildValue::*what) const {
    double best = std::numeric_limits<double>::infinity();
    for (const BuildValue& b : builds) best = std::min(best, b.*what);
    return best;
  }
  /// Ascending in cost, strictly falling in mass.
  [[nodiscard]] std::vector<BuildValue> front() const {
    std::vector<BuildValue> sorted = builds, result;
    std::sort(sorted.begin(), sorted.end(), [](const BuildValue& a, const BuildValue& b) {
      return std::abs(a.cost - b.cost) > 1e-9 ? a.cost < b.cost : a.mass < b.mass;
    });
    for (const BuildValue& b : sorted)
      if (result.empty() || b.mass < result.back().mass - 1e-9) result.push_back(b);
    return result;
  }

 private:
  struct Step {
    std::vector<double> state;
    BuildValue own;
    std::vector<solver::Row> rows;
  };

  void descend(std::size_t stage, const std::vector<double>& state, BuildValue so_far) {
    if (stage == problem_.stages.size()) {
      if (discount_) so_far.cost -= discount_(rows_);
      builds.push_back(so_far);
      return;
    }
    for (const Step& step : steps(stage, state)) {
      rows_[stage] = step.rows;
      descend(stage + 1, step.state, {so_far.cost + step.own.cost, so_far.mass + step.own.mass});
    }
  }

  void greedy() {
    std::vector<double> state = problem_.first_state;
    double cost = 0.0;
    for (std::size_t stage = 0; stage < problem_.stages.size(); ++stage) {
      const auto all = steps(stage, state);
      if (all.empty()) return;
      const auto best = std::min_element(
          all.begin(), all.end(), [](const Step& a, const Step& b) { return a.own.cost < b.own.cost; });
      cost += best->own.cost;
      state = best->state;
    }
    if (!greedy_cost || cost < *greedy_cost) greedy_cost = cost;
  }

  std::vector<Step> steps(std::size_t index, const std::vector<double>& state) {
    const solver::Stage& stage = *problem_.stages[index];
    std::vector<Step> all;
    std::vector<solver::Row> rows(stage.slots().size(), 0);
    for (;;) {
      if (auto step = design(stage, state, rows)) all.push_back(std::move(*step));
      std::size_t slot = 0;
      while (slot < rows.size() && ++rows[slot] == stage.slots()[slot].rows) rows[slot++] = 0;
      if (slot == rows.size()) return all;
    }
  }

  std::optional<Step> design(const solver::Stage& stage,
                             const std::vector<double>& state,
                             const std::vector<solver::Row>& rows) {
    solver::Answer<double> answer;
    std::vector<double> x;
    for (const auto& v : stage.variables()) x.push_back(v.lower);
    const auto worst = [&] {
      stage.evaluate({shared_, state, rows, x}, answer);
      return *std::max_element(answer.utilisation.begin(), answer.utilisation.end());
    };
    if (x.empty()) {
      if (worst() > 1.0) return std::nullopt;
    } else {
      const double lower = stage.variables()[0].lower, upper = stage.variables()[0].upper;
      const auto at = [&](double time) {
        x[0] = time;
        return worst();
      };
      const double first = at(upper);
      const std::vector<double> last_state = answer.handed_on;
      const double least = at(lower);
      const std::optional<std::size_t> power = changed_component(last_state, answer.handed_on);
      // Without a supply to be sized any ramp will do.
      if (power || std::min(first, least) > 1.0) {
        const auto ramp = least_power_ramp(lower, upper, [&](double time) {
          const double u = at(time);
          return RampTried{u, power ? answer.handed_on[*power] : 0.0};
        });
        if (!ramp) return std::nullopt;
        at(*ramp);
      }
    }
    return Step{answer.handed_on, {answer.resources[0], answer.resources[1]}, rows};
  }

  const solver::Problem& problem_;
  Discount discount_;
  std::vector<std::vector<solver::Row>> rows_;  ///< of the build under way
  std::vector<solver::Row> shared_;
};

}  // namespace millwright
