// SPDX-License-Identifier: Apache-2.0
#include "machine/carried_forces.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "machine/carrying.h"
#include "machine/tool_chain.h"

namespace millwright::machine {

namespace {

double largest_process_force(const Axis& axis) {
  double result = 0.0;
  for (const Move& move : axis.moves)
    result = std::max(result, move.profile ? move.profile->largest_force : std::abs(move.force));
  return result;
}

}  // namespace

CarriedForces carried_forces(const Problem& problem, std::size_t index) {
  const Axis& axis = problem.axes[index];
  CarriedForces result;
  for (std::size_t other = 0; other < problem.axes.size(); ++other) {
    const Axis& above = problem.axes[other];
    const std::vector<std::size_t> below = carriers(problem, other);
    if (other == index || is_rotary(above) || std::find(below.begin(), below.end(), index) == below.end()) continue;
    if (above.along && above.along == axis.along) continue;
    (above.along && above.along == axis.normal ? result.pressing : result.sideways) += largest_process_force(above);
  }
  const GuideChoice& guide = *axis.guide;
  result.along_arm = std::abs(guide.load_offset_x);
  result.across_arm = std::abs(guide.load_offset_y);
  result.height_arm = std::abs(guide.force_height);
  result.own_across_arm = guide.tool_at ? std::abs((*guide.tool_at)[1]) : result.across_arm;
  result.own_height_arm = std::max(result.height_arm, guide.tool_at ? std::abs((*guide.tool_at)[2]) : 0.0);
  if (problem.tool && guide.tool_at) {
    const ToolPlace tool = tool_place(problem, index);
    result.along_arm = tool.along_arm;
    result.across_arm = tool.across_arm;
    result.height_arm = tool.height_arm;
    result.own_across_arm = tool.across_arm;
    result.own_height_arm = std::max(result.own_height_arm, tool.height_arm);
  }
  return result;
}

}  // namespace millwright::machine
