// SPDX-License-Identifier: Apache-2.0
#include "machine/condition_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "machine/carrying.h"
#include "machine/constraint.h"

namespace millwright::machine {

namespace {

/// By how much all stated masses may be divided until the first counterbalance below an axis carries all of them. (What
/// is chosen weighs something as well.)
double furthest_of_masses(const Problem& problem, std::size_t axis) {
  double furthest = Condition{}.furthest;
  for (std::optional<std::size_t> each = axis; each; each = problem.axes[*each].carried_by) {
    const Axis& own = problem.axes[*each];
    if (!(own.counterbalance_force > 0.0) || !(own.inclination > 0.0)) continue;
    const double weight = stated_mass(problem, *each) * standard_gravity * std::sin(own.inclination);
    furthest = std::min(furthest, weight / own.counterbalance_force);
  }
  return furthest;
}

/// Those of these checks that an axis enforces and has: finer than half steps a motor passes its resonance without one,
/// and only screws have one of the drive line.
std::vector<std::string> enforced_of(const Axis& axis, std::initializer_list<const char*> checks) {
  std::vector<std::string> ids;
  for (const std::string id : checks)
    if (axis.require.enforces(id) && !(id == "C-ST-RES" && axis.motor.microsteps > 2.0) &&
        !(id == "C-CP-RES" && axis.mechanism.kind != MechanismKind::screw))
      ids.push_back(id);
  return ids;
}

}  // namespace

bool softens_under_less(const Axis& axis) {
  const Mechanism& drive = axis.mechanism;
  return drive.kind == MechanismKind::screw && !(drive.preload_fraction > 0.0) &&
         axis.require.known(Requirement::axial_stiffness);
}

std::vector<std::string> failed_by_slower(const Axis& axis) { return enforced_of(axis, {"C-ST-RMS", "C-ST-RES"}); }

bool slower_is_looser(const Problem& problem, std::span<const std::pair<std::size_t, std::size_t>> moves) {
  return !problem.limits[Quantity::cycle_time] && !problem.limits[Quantity::energy] &&
         std::ranges::all_of(moves,
                             [&](const auto& each) { return failed_by_slower(problem.axes[each.first]).empty(); });
}

std::vector<std::string> failed_by_lighter(const Axis& axis) { return enforced_of(axis, {"C-ST-RES", "C-CP-RES"}); }

std::vector<Condition> load_conditions(const Problem& problem, std::size_t axis, const Places& places) {
  const Axis& own = problem.axes[axis];
  std::vector<Condition> result;
  for (std::optional<std::size_t> each = axis; each; each = problem.axes[*each].carried_by)
    if (softens_under_less(problem.axes[*each]) || !failed_by_lighter(problem.axes[*each]).empty()) return result;
  const auto load = [&](const char* key, double Axis::*value, const char* unit, double furthest) {
    if (!(own.*value > 0.0) || !(furthest > 1.0)) return;
    const text::Node* const node = Places::find(places.axis(axis), {key});
    Condition condition;
    condition.axis = own.name;
    condition.name = key;
    condition.where = places.of(node != nullptr ? node : places.axis(axis));
    if (node != nullptr) condition.setting = fmt::format("axis.{}.{}", own.name, key);
    condition.kind = ConditionKind::number;
    condition.value = own.*value;
    condition.unit = unit;
    condition.larger_is_looser = false;
    condition.furthest = furthest;
    condition.set = [axis, value](Asked& asked, double to) { asked.problem.axes[axis].*value = to; };
    result.push_back(std::move(condition));
  };
  const double of_masses = furthest_of_masses(problem, axis);
  const double of_others = Condition{}.furthest;
  load("payload_mass", &Axis::payload_mass, "kg", of_masses);
  load("structure_mass", &Axis::structure_mass, "kg", of_masses);
  // Of a table and what is clamped on it together, where both are stated.
  const bool clamped = Places::find(places.axis(axis), {"payload_inertia"}) != nullptr;
  load(clamped ? "inertia" : "structure_inertia", &Axis::inertia, "kg.m2", of_others);
  load("friction_torque", &Axis::friction_torque, "N.m", of_others);
  return result;
}

}  // namespace millwright::machine
