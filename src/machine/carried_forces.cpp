// SPDX-License-Identifier: Apache-2.0
#include "machine/carried_forces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "machine/tool_chain.h"

namespace millwright::machine {

namespace {

bool carries(const Problem& problem, std::size_t index, std::size_t other) {
  for (std::optional<std::size_t> at = problem.axes[other].carried_by; at; at = problem.axes[*at].carried_by)
    if (*at == index) return true;
  return false;
}

double largest_process_force(const Axis& axis) {
  double result = 0.0;
  for (const Move& move : axis.moves)
    result = std::max(result, move.profile ? move.profile->largest_force : std::abs(move.force));
  return result;
}

std::optional<std::size_t> direction_of(const Axis& axis) {
  if (!axis.along && axis.direction == Direction::vertical) return upright;
  return axis.along;
}

}  // namespace

CarriedForces carried_forces(const Problem& problem, std::size_t index) {
  const Axis& axis = problem.axes[index];
  CarriedForces result;
  for (std::size_t other = 0; other < problem.axes.size(); ++other) {
    const Axis& above = problem.axes[other];
    if (is_rotary(above) || !carries(problem, index, other)) continue;
    const double force = largest_process_force(above);
    const std::optional<std::size_t> direction = direction_of(above);
    if (direction && direction == direction_of(axis)) continue;
    (direction && direction == axis.normal ? result.pressing : result.sideways) += force;
  }
  const GuideChoice& guide = *axis.guide;
  result.along_arm = std::abs(guide.load_offset_x);
  result.across_arm = std::abs(guide.load_offset_y);
  result.height_arm = std::abs(guide.force_height);
  if (problem.tool && guide.tool_at) {
    const ToolPlace tool = tool_place(problem, index);
    result.along_arm = tool.along_arm;
    result.across_arm = tool.across_arm;
    result.height_arm = tool.height_arm;
  }
  return result;
}

}  // namespace millwright::machine
