// SPDX-License-Identifier: Apache-2.0
//
// Belt axis drive: a timing belt from a drive pulley on the shaft of the motor, or of a reduction behind it, round an
// idler, the carriage clamped to it.
#pragma once

#include <array>
#include <span>

#include "machine/geared_drive.h"
#include "machine/tool_chain.h"
#include "mechanics/belt.h"

namespace millwright::machine {

/// Belt with both pulleys on this axis.
template <class T>
struct BeltReading {
  T mass_per_length{}, allowable_tension{}, specific_stiffness{}, least_teeth{}, largest_speed{};
  T belt_length{}, belt_mass{}, span{};
  T teeth{}, pitch_diameter{}, pulley_inertia{}, idler_inertia{}, idler_diameter{};
  T bore{};
  T width{};
  T kinds{};  ///< profiles and sizes among belt and pulleys: 1, and 1 for each pulley that does not run with the belt
};

template <class Reading, class Visit>
void visit_belt_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.mass_per_length,
                      &r.allowable_tension,
                      &r.specific_stiffness,
                      &r.least_teeth,
                      &r.largest_speed,
                      &r.belt_length,
                      &r.belt_mass,
                      &r.span,
                      &r.teeth,
                      &r.pitch_diameter,
                      &r.pulley_inertia,
                      &r.idler_inertia,
                      &r.idler_diameter,
                      &r.bore,
                      &r.width,
                      &r.kinds})
    visit(*field);
}

template <class T>
struct BeltDrive : GearedDrive<T> {
  BeltReading<T> belt;
  T carried_mass{};

  T moved_mass{};
  T pretension{}, wrap{}, teeth_in_mesh{};

  void derive();
};

template <class T>
void BeltDrive<T>::derive() {
  using namespace scalar;
  namespace bt = mechanics::belt;
  moved_mass = named("m", carried_mass + belt.belt_mass);
  const T pulleys =
      named("J_p", belt.pulley_inertia + belt.idler_inertia * square(belt.pitch_diameter / belt.idler_diameter));
  this->derive_gears(moved_mass, named("r", 0.5 * belt.pitch_diameter), pulleys);
  pretension = named("F_0",
                     this->require(Requirement::belt_preload_fraction) * this->largest_force +
                         bt::centrifugal_tension(belt.mass_per_length, this->cycle.peak_speed));
  const T larger_diameter = larger(belt.pitch_diameter, belt.idler_diameter);
  wrap = named("φ", bt::wrap_angle(larger_diameter, belt.pitch_diameter, belt.span));
  teeth_in_mesh = named("z_m", bt::teeth_in_mesh(belt.teeth, wrap));
}

/// Force along the travel at constant speed [N]: weight, friction, process.
template <class T>
T steady_force(const BeltDrive<T>& d) {
  using namespace scalar;
  return d.cycle.weight + d.cycle.friction_force + d.cycle.process_force;
}

/// Stiffness of the carriage on its belt where it is softest [N/m].
template <class T>
T belt_stiffness(const BeltDrive<T>& d) {
  return mechanics::belt::least_stiffness(d.belt.specific_stiffness, 2.0 * d.belt.span);
}

/// Smallest of all speed limits of the drive [m/s]: motor, reduction and belt.
template <class T>
T speed_limit(const BeltDrive<T>& d) {
  using namespace scalar;
  return smaller(speed_limit<T>(static_cast<const GearedDrive<T>&>(d)), d.belt.largest_speed);
}

/// What the belt pulls at the motor's shaft [N] with the carriage next to it; nothing where the bearings of a reduction
/// bear it.
template <class T>
T shaft_pull(const BeltDrive<T>& d) {
  if (d.reduction.present) return scalar::in_unit<T>(0.0, scalar::dimension::force);
  return mechanics::belt::pulling_shaft_load(d.pretension, d.largest_force, d.wrap);
}

/// Reversal error [m]: twice the stretch of the belt under friction at its softest position, and what a reduction adds.
template <class T>
T reversal_error(const BeltDrive<T>& d) {
  const T stretch = 2.0 * mechanics::belt::position_error(d.cycle.friction_force, belt_stiffness(d));
  return d.reduction.present ? T(stretch + reversal_in_reduction(d)) : stretch;
}

/// Errors of the axis [m]; the belt's pitch error is 0.2 mm/m, a usual figure.
template <class T>
ErrorBudget<T> error_budget(const BeltDrive<T>& d, UnderForce under_force = UnderForce::yes) {
  using namespace scalar;
  ErrorBudget<T> budget;
  const double counted = counted_travel(d.data->require, d.data->stroke, false);
  budget.add_systematic("pitch", named("e_p", in_unit<T>(2e-4 * counted, dimension::length)));
  if (under_force == UnderForce::yes && has_process_force(d.data->motion))
    budget.add_systematic("under force",
                          named("e_F", mechanics::belt::position_error(d.cycle.process_force, belt_stiffness(d))));
  add_gear_errors(d, reversal_error(d), budget);
  return budget;
}

/// The belt at its longest span, a reduction and the motor's field.
template <class T>
Compliance<T> tool_compliance(const BeltDrive<T>& d, const ToolPlace& place) {
  using scalar::square;
  const T one = 1.0 / belt_stiffness(d) + square(d.radius) * turning_compliance(d);
  Compliance<T> result = no_compliance<T>();
  result[place.travel] = sharing_factor(place) * one;
  return result;
}

}  // namespace millwright::machine
