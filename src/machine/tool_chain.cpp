// SPDX-License-Identifier: Apache-2.0
#include "machine/tool_chain.h"

#include <algorithm>
#include <vector>

#include "machine/carrying.h"

namespace millwright::machine {

/// Axes between the carriages and the tool move it over them. Where the work rides on the axis instead, the tool stands
/// in space: the axis's own travel, that of what carries it and that of all tool axes count.
ToolPlace tool_place(const Problem& problem, std::size_t index) {
  const Axis& axis = problem.axes[index];
  ToolPlace place;
  place.travel = axis.along.value_or(0);
  place.normal = axis.normal.value_or(upright);
  place.across = 3 - place.travel - place.normal;
  const Tool& tool = *problem.tool;
  const double deflection = tool.deflection_scale.value_or(tool.deflection.value_or(0.0));
  const double error = tool.position_error_scale.value_or(tool.position_error.value_or(0.0));
  // What gives way counts in both.
  const double finer = deflection > 0.0 && error > 0.0 ? std::min(deflection, error) : std::max(deflection, error);
  for (std::size_t i = 0; i < place.step.size(); ++i)
    if (tool.force[i] > 0.0) place.step[i] = compliance_step * finer / tool.force[i];
  place.error_step = compliance_step * error;
  place.tool_force = problem.tool->force;
  place.force = axis.mechanism.load_share * problem.tool->force[place.travel];
  place.drives = axis.mechanism.drives;
  place.load_share = axis.mechanism.load_share;
  if (!axis.guide || !axis.guide->tool_at) return place;
  std::array<double, 3> arm{};
  arm[place.travel] = std::abs((*axis.guide->tool_at)[0]);
  arm[place.across] = std::abs((*axis.guide->tool_at)[1]);
  arm[place.normal] = std::abs((*axis.guide->tool_at)[2]);
  const auto shift = [&](std::size_t other) {
    if (const Axis& moving = problem.axes[other]; moving.along) arm[*moving.along] += 0.5 * moving.stroke;
  };
  const std::vector<std::size_t> tool_axes = carriers(problem, problem.tool->axis);
  const auto here = std::find(tool_axes.begin(), tool_axes.end(), index);
  std::for_each(tool_axes.begin(), here, shift);
  if (here == tool_axes.end()) {
    for (const std::size_t other : carriers(problem, index))
      if (std::find(tool_axes.begin(), tool_axes.end(), other) == tool_axes.end()) shift(other);
  }
  place.along_arm = arm[place.travel];
  place.across_arm = arm[place.across];
  place.height_arm = arm[place.normal];
  return place;
}

}  // namespace millwright::machine
