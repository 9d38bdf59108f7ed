// SPDX-License-Identifier: Apache-2.0
//
// The (cost, mass) front of a machine over all of its builds, tried one by one, stage after stage: all rows of all
// slots and, of free dimensions that move cost and mass, a grid. Asks a stage for nothing but the answer to one design.
// Nothing is assumed about what a load does to anything: of partial builds only those are left out that hand on exactly
// the same state as another one that is neither dearer nor heavier. Of the ramps with which a design complies the one
// that takes least power is kept (ramp_choice.h): a supply asks for nothing but that the power is not too much.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include "evaluation/machine_model.h"
#include "evaluation/ramp_choice.h"

namespace millwright {

class EveryBuild {
 public:
  struct Value {
    double cost = 0.0, mass = 0.0;
  };
  /// Thrown when there are more designs of stages than can be evaluated.
  struct TooMany : std::runtime_error {
    TooMany() : std::runtime_error("too many builds") {}
  };

  explicit EveryBuild(const evaluation::MachineModel& model, std::size_t most = 500000)
      : problem_(model.problem()), left_(most) {
    while (!try_all()) front_.clear();
    merge_equals();
  }

  /// Ascending in cost, strictly falling in mass.
  [[nodiscard]] const std::vector<Value>& front() const { return front_; }
  /// Whether a dimension was tried on a grid only.
  [[nodiscard]] bool on_grid() const { return on_grid_; }
  /// Whether a ramp was tried on a grid only: it decides what complies and what power is taken, and nothing else.
  [[nodiscard]] bool ramps_on_grid() const { return ramps_on_grid_; }
  /// Designs of stages that were evaluated.
  [[nodiscard]] std::size_t tried() const { return tried_; }

 private:
  using State = std::vector<double>;
  using Labels = std::map<State, std::vector<Value>>;

  /// Sums of the same parts in another order differ in the last digits: such builds are one.
  void merge_equals() {
    constexpr double rounding = 1e-9;
    std::sort(front_.begin(), front_.end(), [](const Value& a, const Value& b) { return a.cost < b.cost; });
    std::vector<Value> merged;
    for (const Value& value : front_) {
      if (!merged.empty() && value.mass > merged.back().mass * (1.0 - rounding)) continue;
      if (!merged.empty() && value.cost < merged.back().cost * (1.0 + rounding)) merged.pop_back();
      merged.push_back(value);
    }
    front_ = std::move(merged);
  }

  static void keep(std::vector<Value>& front, const Value& value) {
    for (const Value& there : front)
      if (there.cost <= value.cost && there.mass <= value.mass) return;
    std::erase_if(front, [&](const Value& there) { return value.cost <= there.cost && value.mass <= there.mass; });
    front.push_back(value);
  }

  /// Whether it came through; if not, a ramp turned out to move more of what is handed on than the power, and it has to
  /// be tried as a dimension.
  bool try_all() {
    for (solver::Row v = 0; v < problem_.shared.front().rows; ++v) {
      shared_ = {v};
      Labels labels;
      labels[problem_.first_state] = {Value{}};
      for (const solver::Stage* stage : problem_.stages) {
        const std::size_t before = moving_ramps_.size();
        labels = after(*stage, labels);
        if (moving_ramps_.size() > before) return false;
      }
      for (const auto& [state, values] : labels)
        for (const Value& value : values) keep(front_, value);
    }
    return true;
  }

  Labels after(const solver::Stage& stage, const Labels& before) {
    Labels result;
    for (const auto& label : before) {
      const State& state = label.first;
      const std::vector<Value>& values = label.second;
      std::vector<solver::Row> rows(stage.slots().size(), 0);
      for (const solver::Slot& slot : stage.slots())
        if (slot.rows == 0) return {};
      for (;;) {
        dimensions(stage, state, rows, [&](const solver::Answer<double>& answer) {
          for (const Value& value : values)
            keep(result[answer.handed_on], {value.cost + answer.resources[0], value.mass + answer.resources[1]});
        });
        std::size_t slot = 0;
        while (slot < rows.size() && ++rows[slot] == stage.slots()[slot].rows) rows[slot++] = 0;
        if (slot == rows.size()) break;
      }
    }
    return result;
  }

  /// Every value of the free dimensions on the grid for which some ramp complies.
  template <class Found>
  void dimensions(const solver::Stage& stage, const State& state, const std::vector<solver::Row>& rows, Found&& found) {
    const auto variables = stage.variables();
    std::vector<double> x;
    std::vector<std::size_t> free;
    std::size_t ramp = variables.size();
    for (std::size_t v = 0; v < variables.size(); ++v) {
      x.push_back(variables[v].lower);
      if (variables[v].name == "acceleration_time" && moving_ramps_.count(&stage) == 0)
        ramp = v;
      else if (variables[v].lower < variables[v].upper)
        free.push_back(v);
    }
    const int grid = free.size() > 1 ? 12 : 40;
    if (!free.empty()) on_grid_ = true;
    std::vector<int> at(free.size(), 0);
    for (;;) {
      for (std::size_t i = 0; i < free.size(); ++i) {
        const solver::Variable& v = variables[free[i]];
        x[free[i]] = at[i] == grid ? v.upper : v.lower * std::pow(v.upper / v.lower, at[i] / double(grid));
      }
      if (complies(stage, state, rows, x, ramp)) found(answer_);
      std::size_t i = 0;
      while (i < at.size() && ++at[i] > grid) at[i++] = 0;
      if (i == at.size()) return;
    }
  }

  double worst(const solver::Stage& stage,
               const State& state,
               const std::vector<solver::Row>& rows,
               const std::vector<double>& x) {
    if (left_-- == 0) throw TooMany();
    ++tried_;
    stage.evaluate({shared_, state, rows, x}, answer_);
    double most = 0.0;
    for (const double u : answer_.utilisation) most = std::max(most, u);
    return most;
  }

  /// Whether some ramp complies; then the answer is that with the ramp that takes least power.
  bool complies(const solver::Stage& stage,
                const State& state,
                const std::vector<solver::Row>& rows,
                std::vector<double>& x,
                std::size_t ramp) {
    if (ramp == x.size()) return worst(stage, state, rows, x) <= 1.0;
    const double lower = stage.variables()[ramp].lower, upper = stage.variables()[ramp].upper;
    const auto at = [&](double time) {
      x[ramp] = time;
      return worst(stage, state, rows, x);
    };
    const double longest = at(upper);
    const solver::Answer<double> last = answer_;
    const double shortest = at(lower);
    if (answer_.resources != last.resources) throw std::logic_error("a ramp moves cost or mass");
    std::optional<std::size_t> power;
    try {
      power = changed_component(last.handed_on, answer_.handed_on);
    } catch (const MovesMore&) {
      moving_ramps_.insert(&stage);
      return false;
    }
    if (!power && shortest <= 1.0) return true;
    if (!power && longest <= 1.0) return at(upper) <= 1.0;
    ramps_on_grid_ = true;
    const auto best = least_power_ramp(lower, upper, [&](double time) {
      const double u = at(time);
      return RampTried{u, power ? answer_.handed_on[*power] : 0.0};
    });
    return best && at(*best) <= 1.0;
  }

  const solver::Problem& problem_;
  std::vector<solver::Row> shared_;
  solver::Answer<double> answer_;
  std::vector<Value> front_;
  std::size_t left_, tried_ = 0;
  std::set<const solver::Stage*> moving_ramps_;
  bool on_grid_ = false, ramps_on_grid_ = false;
};

/// Whether one of some builds is no worse than this one, but for a part of what it is itself.
inline bool any_covers(const std::vector<EveryBuild::Value>& builds, const EveryBuild::Value& value, double part) {
  return std::ranges::any_of(builds, [&](const EveryBuild::Value& build) {
    return (1.0 - part) * build.cost <= value.cost && (1.0 - part) * build.mass <= value.mass;
  });
}

}  // namespace millwright
