// SPDX-License-Identifier: Apache-2.0
//
// The answer by trying everything, in code that shares nothing with the solver: every shared choice, every row of every
// slot; the least diameter by bisection (stiffness falls with the diameter, cost and mass rise), the least worst
// utilisation over the acceleration time by ternary search on a convex function, both to 1e-9 and better.
#pragma once

#include <algorithm>
#include <optional>

#include "solver/front_of.h"
#include "solver/random_stack.h"

namespace zoo {

struct Total {
  double cost = 0.0, mass = 0.0;
};

struct Everything {
  std::vector<Total> designs;  ///< feasible ones
  double margin = 1.0;         ///< how near any design came to the edge of feasibility
  std::optional<double> greedy_cost;

  [[nodiscard]] double least(double Total::*what) const {
    double best = std::numeric_limits<double>::infinity();
    for (const Total& total : designs) best = std::min(best, total.*what);
    return best;
  }
  /// Ascending in cost, strictly falling in mass.
  [[nodiscard]] std::vector<Total> front() const { return front_of(designs); }
};

class Enumeration {
 public:
  explicit Enumeration(const Stack& stack) : stack_(stack) {}

  Everything run() {
    const Problem& problem = stack_.problem;
    const Row choices = problem.shared.empty() ? 1 : problem.shared[0].rows;
    for (Row choice = 0; choice < choices; ++choice) {
      shared_.assign(problem.shared.size(), choice);
      descend(0, problem.first_state, {});
      greedy();
    }
    return std::move(result_);
  }

 private:
  struct Step {
    std::vector<double> state;
    Total own;
  };

  void descend(std::size_t stage, const std::vector<double>& state, Total so_far) {
    if (stage == stack_.axes.size()) {
      const double limit = stack_.problem.resources[1].limit;
      note(so_far.mass / limit);
      if (so_far.mass <= limit) result_.designs.push_back(so_far);
      return;
    }
    for (const Step& step : steps(stage, state)) {
      descend(stage + 1, step.state, {so_far.cost + step.own.cost, so_far.mass + step.own.mass});
    }
  }

  /// Axis by axis the cheapest feasible design.
  void greedy() {
    std::vector<double> state = stack_.problem.first_state;
    Total total;
    for (std::size_t stage = 0; stage < stack_.axes.size(); ++stage) {
      std::optional<Step> best;
      for (const Step& step : steps(stage, state)) {
        if (!best || step.own.cost < best->own.cost) best = step;
      }
      if (!best) return;
      total.cost += best->own.cost;
      total.mass += best->own.mass;
      state = best->state;
    }
    if (total.mass > stack_.problem.resources[1].limit) return;
    if (!result_.greedy_cost || total.cost < *result_.greedy_cost) result_.greedy_cost = total.cost;
  }

  std::vector<Step> steps(std::size_t stage, const std::vector<double>& state) {
    const Axis& axis = stack_.axes[stage]->axis();
    std::vector<Step> all;
    if (axis.only_shaft) {
      if (auto step = shaft(stage, state)) all.push_back(*step);
      return all;
    }
    for (Row i = 0; i < axis.screws.size(); ++i) {
      for (Row j = 0; j < axis.motors.size(); ++j) {
        for (Row k = 0; k < axis.couplings.size(); ++k) {
          if (axis.couplings[k].bore != axis.motor_bore[j]) continue;
          if (auto step = design(stage, state, {i, j, k})) all.push_back(*step);
        }
      }
    }
    return all;
  }

  /// Least diameter at which the stiffness holds; it rises with the diameter.
  template <class Stiffness>
  static std::optional<double> least_diameter(Stiffness&& stiffness) {
    double low = 0.004;
    double high = 0.04;
    if (stiffness(high) > 1.0) return std::nullopt;
    if (stiffness(low) <= 1.0) return low;
    for (int n = 0; n < 60 && high - low > 1e-14; ++n)
      (stiffness(0.5 * (low + high)) <= 1.0 ? high : low) = 0.5 * (low + high);
    return high;
  }

  std::optional<Step> shaft(std::size_t stage, const std::vector<double>& state) {
    const auto diameter = least_diameter([&](double d) {
      evaluate(stage, state, {}, {d});
      return answer_.utilisation.back();
    });
    if (!diameter) return std::nullopt;
    evaluate(stage, state, {}, {*diameter});
    return Step{answer_.handed_on, {answer_.resources[0], answer_.resources[1]}};
  }

  std::optional<Step> design(std::size_t stage, const std::vector<double>& state, const std::vector<Row>& rows) {
    const Axis& axis = stack_.axes[stage]->axis();
    std::vector<double> x{axis.time_low};
    if (axis.deflection > 0.0) {
      const auto diameter = least_diameter([&](double d) {
        evaluate(stage, state, rows, {axis.time_low, d});
        return answer_.utilisation.back();
      });
      if (!diameter) return std::nullopt;
      x.push_back(*diameter);
    }
    const auto worst = [&](double time) {
      x[0] = time;
      evaluate(stage, state, rows, x);
      // The shaft is at its limit by construction; it does not depend on the time.
      const auto end = answer_.utilisation.end() - (axis.deflection > 0.0 ? 1 : 0);
      return *std::max_element(answer_.utilisation.begin(), end);
    };
    double low = axis.time_low;
    double high = axis.time_high;
    for (int n = 0; n < 70 && high - low > 1e-11; ++n) {
      const double a = low + (high - low) / 3.0;
      const double b = high - (high - low) / 3.0;
      const double at_a = worst(a);
      const double at_b = worst(b);
      if (at_a <= 1.0 - 1e-6 || at_b <= 1.0 - 1e-6) break;  // feasible with room
      (at_a < at_b ? high : low) = at_a < at_b ? b : a;
    }
    const double time = std::min({worst(low),
                                  worst(high),
                                  worst(0.5 * (low + high)),
                                  worst(low + (high - low) / 3.0),
                                  worst(high - (high - low) / 3.0)});
    note(time);
    if (time > 1.0) return std::nullopt;
    return Step{answer_.handed_on, {answer_.resources[0], answer_.resources[1]}};
  }

  void evaluate(std::size_t stage,
                const std::vector<double>& state,
                const std::vector<Row>& rows,
                const std::vector<double>& x) {
    stack_.axes[stage]->evaluate(Point{shared_, state, rows, x}, answer_);
  }
  void note(double utilisation) { result_.margin = std::min(result_.margin, std::fabs(utilisation - 1.0)); }

  const Stack& stack_;
  std::vector<Row> shared_;
  Answer<double> answer_;
  Everything result_;
};

}  // namespace zoo
