// SPDX-License-Identifier: Apache-2.0
#include "evaluation/fixed_choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scalar/unit.h"

namespace millwright::evaluation {

namespace {

using machine::BomLine;

bool equal(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }

std::string shown(double value, const std::string& slot) {
  return scalar::format(value, scalar::Unit::of(machine::unit_of_setting(slot)));
}

std::string shown(const std::vector<double>& values, const std::string& slot) {
  std::vector<std::string> all;
  for (const double value : values) all.push_back(shown(value, slot));
  return fmt::format("{}", fmt::join(all, ", "));
}

/// Keeps only the fixed value of a list of choices.
void narrow(std::vector<double>& choices, const BomLine& line, std::vector<BomProblem>& problems) {
  const auto found =
      std::find_if(choices.begin(), choices.end(), [&](double choice) { return equal(choice, *line.value); });
  if (found == choices.end())
    problems.push_back(
        {line.where,
         fmt::format("{} {} is not among those of the problem", line.slot, shown(*line.value, line.slot)),
         fmt::format("it permits {}", shown(choices, line.slot))});
  else
    choices = {*found};
}

const machine::Axis* axis_of(const machine::Problem& problem, const std::string& name) {
  for (const machine::Axis& axis : problem.axes)
    if (axis.name == name) return &axis;
  return nullptr;
}

/// The variable that a line fixes; null if the problem leaves no choice there.
const solver::Variable* variable_of(const MachineModel& model, const BomLine& line) {
  for (const StageEntry& entry : model.entries()) {
    if (entry.axis != line.axis) continue;
    for (const solver::Variable& variable : entry.as_stage().variables())
      if (line.slot == (entry.element == "drive" ? variable.name : entry.element + "." + variable.name))
        return &variable;
  }
  return nullptr;
}

}  // namespace

void take_fixed_settings(machine::Problem& problem,
                         const machine::BillOfMaterials& fixed,
                         std::vector<BomProblem>& problems) {
  for (const BomLine& line : fixed.lines) {
    if (line.axis == "machine" && line.slot == "supply_voltage") {
      const auto found = std::find_if(problem.supply_voltages.begin(),
                                      problem.supply_voltages.end(),
                                      [&](double voltage) { return equal(voltage, *line.value); });
      if (found != problem.supply_voltages.end()) problem.supply_voltages = {*found};  // else held_parts.cpp complains
    }
    if (line.slot != "motor_current") continue;
    for (machine::Axis& axis : problem.axes) {
      if (axis.name != line.axis) continue;
      // Without a list the problem asks for the rated current; another one is as good a wish.
      if (axis.motor.currents.empty())
        axis.motor.currents = {*line.value};
      else
        narrow(axis.motor.currents, line, problems);
    }
  }
}

std::vector<BomProblem> values_out_of_range(const MachineModel& model, const machine::BillOfMaterials& fixed) {
  std::vector<BomProblem> problems;
  for (const BomLine& line : fixed.lines) {
    if (!line.value || line.axis == "machine" || line.slot == "motor_current") continue;
    if (const solver::Variable* variable = variable_of(model, line); variable != nullptr) {
      if (*line.value >= variable->lower * (1.0 - 1e-9) && *line.value <= variable->upper * (1.0 + 1e-9)) continue;
      problems.push_back(
          {line.where,
           fmt::format(
               "{}.{}: {} is not within the problem's range", line.axis, line.slot, shown(*line.value, line.slot)),
           fmt::format("it goes from {} to {}", shown(variable->lower, line.slot), shown(variable->upper, line.slot))});
      continue;
    }
    const machine::Axis* axis = axis_of(model.machine(), line.axis);
    if (axis == nullptr || line.slot != "acceleration_time") continue;
    if (axis->acceleration_time.fixed() && equal(axis->acceleration_time.lower, *line.value)) continue;
    problems.push_back(
        {line.where,
         fmt::format("the problem leaves no choice of {}.{}", line.axis, line.slot),
         fmt::format("change it with --set axis.{}.{}='{}'", line.axis, line.slot, shown(*line.value, line.slot))});
  }
  return problems;
}

}  // namespace millwright::evaluation
