// SPDX-License-Identifier: Apache-2.0
//
// How far the tool gives way under the process force: every axis between tool and workpiece adds its compliance (m/N)
// in each direction of the machine, from carriages, drive and structure, at the worst position of the travel. Chain and
// rotary springs as in [slocum1992], directions one by one: what a force in one direction moves the tool in another is
// left out.
//
// What one element adds is `tool_compliance(element, place)`, beside the element.
//
// Rigid here: the bearing of a rotary table, meshing teeth, joints (welds, bolts), columns under a lateral force (a
// portal_frame sways), rails on their base.
#pragma once

#include <array>

#include "machine/problem.h"
#include "scalar/scalars.h"

namespace millwright::machine {

/// Compliance along x, y and z [m/N].
template <class T>
using Compliance = std::array<T, 3>;

/// The tool as an axis sees it.
struct ToolPlace {
  std::size_t travel = 0, across = 1, normal = 2;  ///< directions of the machine
  /// Levers of the tool about the centre of the carriages [m], not negative, at the worst positions of all axes.
  double along_arm = 0.0, across_arm = 0.0, height_arm = 0.0;
  double force = 0.0;                  ///< N, of the tool along the travel, on the most loaded drive
  std::array<double, 3> tool_force{};  ///< N
  double drives = 1.0, load_share = 1.0;
  std::array<double, 3> step{};  ///< m/N, by which compliances are counted; 0 = no force in that direction
  double error_step = 0.0;       ///< m, by which position errors are counted; 0 = not asked
};

/// Every element's compliance, and every axis's position error, counts in whole steps, rounded up, of so much of what
/// is permitted: two motors whose fields differ by a hundredth of a micrometre at the tool then ask the same of the
/// rest of the machine. A little less than a hundredth: a hundred of them have to be no more than what is permitted
/// however they are added up, or nothing would be feasible at the limit and nothing proved to be infeasible there.
inline constexpr double compliance_step = 0.01 * (1.0 - 1e-12);

/// How axis `index` sees the problem's tool. The problem must have one, and the axis must be linear.
ToolPlace tool_place(const Problem& problem, std::size_t index);

/// How parallel drives of one stiffness give way together: the most loaded takes its share of the force and the others
/// the rest, so that the sum of (share of the force)^2/stiffness counts (Castigliano).
inline double sharing_factor(const ToolPlace& place) {
  if (place.drives <= 1.0) return 1.0;
  const double rest = 1.0 - place.load_share;
  return place.load_share * place.load_share + rest * rest / (place.drives - 1.0);
}

template <class T>
Compliance<T> no_compliance() {
  const T none = scalar::in_unit<T>(0.0, scalar::dimension::none / scalar::dimension::stiffness);
  return {none, none, none};
}

template <class T>
T whole_steps(const T& value, double step, const scalar::Dimension& dimension) {
  using namespace scalar;
  return up_to_whole(value, in_unit<T>(step, dimension));
}

}  // namespace millwright::machine
