// SPDX-License-Identifier: Apache-2.0
//
// Where the state vector holds what concerns an axis: loads, and what is counted at the tool; and where the resources
// hold what an objective or a limit counts beside cost and mass.
#pragma once

#include <array>
#include <optional>

#include "machine/carried_forces.h"
#include "machine/drive_energy.h"
#include "machine/error_budget.h"
#include "machine/tool_chain.h"
#include "solver/stage.h"

namespace millwright::evaluation {

/// Where the state vector holds, along x, y and z, what is counted at the tool.
struct ToolStates {
  std::array<std::optional<std::size_t>, 3> compliance;  ///< where the tool is pressed and a deflection is asked for
  std::array<std::optional<std::size_t>, 3> error;       ///< where a position error is asked for
  std::size_t count = 0;
};

/// Where the resources of a stage hold what is counted beside cost and mass; nothing where nobody asks.
struct CountedResources {
  std::optional<std::size_t> cycle_time, energy;
  std::optional<std::size_t> position_error;  ///< of the axes; where the tool's counts, the last stage knows
};

/// Where an axis stands in the machine: its load and its parent's in the state vector.
struct AxisPlace {
  std::size_t load_state = 0;
  std::optional<std::size_t> parent_load_state;
  std::optional<machine::ToolPlace> tool;  ///< where compliance counts
  machine::CarriedForces carried_forces;   ///< on its guides
  double lifting_acceleration = 0.0;       ///< m/s^2, of the axes that carry it together, what of it is upwards
  ToolStates states;                       ///< what is counted at the tool; empty where nothing is
  CountedResources counted;
  /// Where joints of screws hold its motors or carriages: what one of them has to bear.
  std::optional<std::size_t> motor_force_state, motor_torque_state, carriage_state;
  /// N; motors that load their joints by less are alike to every screw that may be taken.
  double harmless_motor_force = 0.0;
};

/// Adds what an element gives way under the tool: as compliance, or, where only the position error is asked for, as
/// part of that.
template <class T, class Element>
void add_compliance(const AxisPlace& place, const Element& element, solver::Answer<T>& out) {
  namespace dimension = scalar::dimension;
  if (!place.tool) return;
  const machine::Compliance<T> compliance = tool_compliance(element, *place.tool);
  for (std::size_t i = 0; i < compliance.size(); ++i) {
    if (!place.states.compliance[i] && !place.states.error[i]) continue;
    if (place.tool->step[i] <= 0.0) continue;
    const T counted = machine::whole_steps(compliance[i], place.tool->step[i], dimension::none / dimension::stiffness);
    if (place.states.compliance[i]) {
      out.handed_on[*place.states.compliance[i]] = out.handed_on[*place.states.compliance[i]] + counted;
    } else {
      const T force = scalar::in_unit<T>(place.tool->tool_force[i], dimension::force);
      out.handed_on[*place.states.error[i]] = out.handed_on[*place.states.error[i]] + force * counted;
    }
  }
}

/// Adds what a drive gives way under the tool, and its own position error: less what the process force of its moves
/// does where the tool's takes its place. Wind-up and lag of the motor under that force stay in, on the safe side.
template <class T, class Drive>
void add_to_tool(const AxisPlace& place, const Drive& drive, solver::Answer<T>& out) {
  add_compliance(place, drive, out);
  if (!place.tool || !place.states.error[place.tool->travel]) return;
  const std::size_t travel = place.tool->travel;
  const bool pressed = place.tool->tool_force[travel] > 0.0;
  const auto budget = error_budget(drive, pressed ? machine::UnderForce::no : machine::UnderForce::yes);
  T& sum = out.handed_on[*place.states.error[travel]];
  sum = sum + machine::whole_steps(budget.total(), place.tool->error_step, scalar::dimension::length);
}

/// The drive's share of what is counted beside cost and mass: the time of its axis in the machine's cycle, the
/// energy of `drives` equal drives (each taken to be as loaded as the most loaded), the axis's position error.
template <class T, class Drive>
void count_cycle(const AxisPlace& place, const Drive& drive, double drives, solver::Answer<T>& out) {
  const CountedResources& counted = place.counted;
  if (counted.cycle_time)
    out.resources[*counted.cycle_time] =
        machine::moving_time(drive.data->motion, drive.acceleration_time, machine::Timed::machine);
  if (counted.energy) out.resources[*counted.energy] = drives * machine::cycle_energy(drive);
  if (counted.position_error && !drive.data->motion.rotary) {
    // Without a stiffness, which C-ACC-TOTAL refuses, the error is endless: here it ends at a metre.
    using namespace scalar;
    out.resources[*counted.position_error] = smaller(error_budget(drive).total(), in_unit<T>(1.0, dimension::length));
  }
}

}  // namespace millwright::evaluation
