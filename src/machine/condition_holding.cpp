// SPDX-License-Identifier: Apache-2.0
#include "machine/condition_holding.h"

#include <fmt/format.h>

#include <cmath>

#include "machine/carrying.h"
#include "machine/constraint.h"

namespace millwright::machine {

namespace {

constexpr int stops_to_balance = 4;  ///< quarters of the stated weight

Condition stated(
    const Problem& problem, std::size_t axis, const char* path, const text::Node* node, const Places& places) {
  Condition condition;
  condition.axis = problem.axes[axis].name;
  condition.setting = fmt::format("axis.{}.{}", condition.axis, path);
  condition.where = places.of(node);
  condition.given = node != nullptr;
  condition.no_part = true;
  return condition;
}

/// More of it is looser until it carries the whole weight, and worse beyond.
Condition counterbalance(const Problem& problem, std::size_t axis, const Places& places) {
  const Axis& own = problem.axes[axis];
  Condition result =
      stated(problem, axis, "counterbalance_force", Places::find(places.axis(axis), {"counterbalance_force"}), places);
  result.name = "counterbalance_force";
  result.meaning = "of a spring or weight that carries a part of it";
  result.source = "none is stated";
  result.value = own.counterbalance_force;
  result.unit = "N";
  const double weight = stated_mass(problem, axis) * standard_gravity * std::sin(own.inclination);
  for (int i = 1; i <= stops_to_balance; ++i)
    if (const double force = weight * i / stops_to_balance; force > own.counterbalance_force)
      result.stops.push_back(force);
  result.set = [axis](Asked& asked, double to) { asked.problem.axes[axis].counterbalance_force = to; };
  return result;
}

}  // namespace

std::optional<Condition> brake_condition(const Problem& problem, std::size_t axis, const Places& places) {
  const Axis& own = problem.axes[axis];
  if (is_rotary(own) || !(own.inclination > 0.0)) return std::nullopt;
  Condition result =
      stated(problem, axis, "motor.brake_torque", Places::find(places.axis(axis), {"motor", "brake_torque"}), places);
  result.name = "brake_torque";
  result.meaning = "of a holding brake";
  result.source = "none is stated";
  result.value = own.motor.brake_torque;
  result.unit = "N.m";
  if (!(result.value >= smallest_brake)) result.from_zero = smallest_brake;
  result.set = [axis](Asked& asked, double to) { asked.problem.axes[axis].motor.brake_torque = to; };
  result.instead.push_back(counterbalance(problem, axis, places));
  return result;
}

}  // namespace millwright::machine
