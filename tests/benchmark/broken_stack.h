// SPDX-License-Identifier: Apache-2.0
//
// The variants of broken_models.h as problems for the search, from an instance of the family.
#pragma once

#include <limits>
#include <stdexcept>
#include <utility>

#include "benchmark/broken_models.h"

namespace stack::broken {

enum class Variant {
  shared_supply,
  same_motor,
  resonance,
  least_inertia,
  belt,
  several_loads,
  error_budget,
  free_diameter
};

inline constexpr std::array<std::pair<Variant, const char*>, 8> variants{{
    {Variant::shared_supply, "shared supply, power budget"},
    {Variant::same_motor, "same motor at a discount"},
    {Variant::resonance, "forbidden resonance band"},
    {Variant::least_inertia, "least inertia ratio"},
    {Variant::belt, "belt between motor and screw"},
    {Variant::several_loads, "three load cases"},
    {Variant::error_budget, "error budget over all axes"},
    {Variant::free_diameter, "free screw diameter"},
}};

/// What a variant is given beside the instance.
struct Surroundings {
  double budget = std::numeric_limits<double>::infinity();  ///< of power [W] or error [m]
  std::vector<double> feet;                                 ///< stiffness under each axis [N/m]
};

/// Whether a variant has a budget, the third of its resources.
inline bool has_budget(Variant variant) {
  return variant == Variant::shared_supply || variant == Variant::error_budget;
}

/// The stages of a variant; the instance and the belts must outlive them.
class Stack {
 public:
  using Row = millwright::solver::Row;
  using Variable = millwright::solver::Variable;

  Stack(const Instance& instance, Variant variant, const Columns& belts, const Surroundings& given)
      : instance_(instance), belts_(belts) {
    problem.first_state = {0.0};
    problem.resources = {{"cost"}, {"mass"}};
    if (variant == Variant::shared_supply) problem.shared = {{"voltage", static_cast<Row>(voltages.size())}};
    if (variant == Variant::same_motor) problem.shared = {{"motor", instance.motors.rows() + 1}};
    if (has_budget(variant)) problem.resources.push_back({"budget", given.budget});
    for (const Axis& axis : instance.axes) {
      tables_.push_back(
          std::make_unique<Columns>(variant == Variant::error_budget    ? screws_with_errors(instance.screws, axis)
                                    : variant == Variant::free_diameter ? blanks(instance.screws)
                                                                        : cut_screws(instance.screws, axis.length)));
      add(variant, axis, given);
    }
  }

  /// Of axis `i`: the screws, or what stands for them.
  [[nodiscard]] const Columns& screws(std::size_t i) const { return *tables_[i]; }

  millwright::solver::Problem problem;

 private:
  void add(Variant variant, const Axis& axis, const Surroundings& given) {
    const Variable ramp{"acceleration_time", axis.shortest_ramp(), axis.longest_ramp()};
    switch (variant) {
      case Variant::shared_supply:
        return add(SharedSupply{axis, stages_.empty()}, constraints, {ramp});
      case Variant::same_motor:
        return add(SameMotor{axis, &instance_.motors}, constraints, {ramp});
      case Variant::resonance:
        return add(Resonance{axis, given.feet[stages_.size()]}, constraints + 1, {ramp});
      case Variant::least_inertia:
        return add(LeastInertia{axis}, constraints + 1, {ramp});
      case Variant::belt:
        return add(Belt{axis}, constraints + 1, {ramp}, &belts_);
      case Variant::several_loads: {
        std::vector<Variable> ramps;
        for (const LoadCase& load : load_cases) {
          const Axis loaded = under(load, axis);
          ramps.push_back({"acceleration_time", loaded.shortest_ramp(), loaded.longest_ramp()});
        }
        return add(SeveralLoads{axis}, constraints * load_cases.size(), std::move(ramps));
      }
      case Variant::error_budget:
        return add(ErrorBudget{axis}, constraints, {ramp});
      case Variant::free_diameter:
        return add(FreeDiameter{axis}, constraints, {ramp, {"diameter", least_diameter, largest_diameter}});
    }
    throw std::invalid_argument("no such variant");
  }

  template <class Model>
  void add(Model model, std::size_t count, std::vector<Variable> variables, const Columns* third = nullptr) {
    std::vector<const Columns*> tables{tables_.back().get(), &instance_.motors};
    if (third != nullptr) tables.push_back(third);
    stages_.push_back(std::make_unique<millwright::solver::ModelStage<Model>>(
        "axis " + std::to_string(stages_.size() + 1), std::move(tables), std::move(variables), count, model));
    problem.stages.push_back(stages_.back().get());
  }

  const Instance& instance_;
  const Columns& belts_;
  std::vector<std::unique_ptr<Columns>> tables_;  ///< [axis]
  std::vector<std::unique_ptr<Stage>> stages_;
};

/// Surroundings that matter: as budget a share of what the best build takes without one, and feet on which the best
/// build without the variant is in resonance half way between its shortest and its longest ramps.
inline Surroundings surroundings(const Instance& instance, Variant variant, const Columns& belts, double share) {
  using millwright::solver::solve;
  Surroundings given;
  if (variant == Variant::resonance) {
    const auto plain = solve(Machine(instance).problem, {});
    for (std::size_t i = 0; i < instance.axes.size(); ++i) {
      const Axis& axis = instance.axes[i];
      const double ramp = 0.5 * (axis.shortest_ramp() + axis.longest_ramp());
      const double speed = axis.stroke / (axis.move_time - ramp);
      double mass = 2.0, turns = 2.0 * std::numbers::pi / 0.01;  // where there is no build
      if (!plain.builds.empty()) {
        const auto& choice = plain.builds[0].stages[i];
        mass = choice.inherited[0] + axis.carriage;
        turns = 2.0 * std::numbers::pi / instance.screws.row(choice.rows[screw_slot])[lead];
      }
      given.feet.push_back(mass * speed * speed * turns * turns);
    }
  }
  if (has_budget(variant)) {
    const Stack free(instance, variant, belts, given);
    const auto best = solve(free.problem, {});
    if (!best.builds.empty()) given.budget = share * best.builds[0].resources[2];
  }
  return given;
}

}  // namespace stack::broken
