// SPDX-License-Identifier: Apache-2.0
//
// Rack and pinion drive. Usually motor and pinion ride on the axis and the rack stands on its parent; with motor_rides
// = false it is the other way round, and the rack is what rides.
#pragma once

#include <span>

#include "machine/geared_drive.h"
#include "machine/tool_chain.h"
#include "mechanics/rack.h"

namespace millwright::machine {

/// Rack of the length that the axis needs, joined from whole pieces.
template <class T>
struct RackReading {
  T module{}, pressure_angle{}, face_width{}, allowable_stress{}, pitch_error_per_length{}, mass{};
};

template <class Reading, class Visit>
void visit_rack_reading(Reading& r, Visit&& visit) {
  for (auto* field :
       {&r.module, &r.pressure_angle, &r.face_width, &r.allowable_stress, &r.pitch_error_per_length, &r.mass})
    visit(*field);
}
inline constexpr std::size_t rack_reading_fields = 6;

template <class T>
struct PinionReading {
  T module{}, pressure_angle{}, teeth{}, face_width{}, bore{}, allowable_stress{}, mass{}, inertia{};
};

template <class Reading, class Visit>
void visit_pinion_reading(Reading& r, Visit&& visit) {
  for (auto* field :
       {&r.module, &r.pressure_angle, &r.teeth, &r.face_width, &r.bore, &r.allowable_stress, &r.mass, &r.inertia})
    visit(*field);
}
inline constexpr std::size_t pinion_reading_fields = 8;

template <class T>
struct RackDrive : GearedDrive<T> {
  RackReading<T> rack;
  PinionReading<T> pinion;
  T carried_mass{};

  T riding_mass{};  ///< kg, of this drive: what of it moves with the axis
  T moved_mass{};   ///< kg
  T face_width{};   ///< m, of the teeth in mesh
  T rack_stress{}, pinion_stress{}, velocity_factor{};

  void derive();
};

template <class T>
void RackDrive<T>::derive() {
  using namespace scalar;
  namespace rk = mechanics::rack;
  const GearedDriveData& given = *this->data;
  const T turning = this->reduction.present ? T(pinion.mass + this->reduction.mass) : pinion.mass;
  riding_mass = given.motor_rides ? named("m_r", this->motor_mass + turning) : rack.mass;
  moved_mass = named("m", carried_mass + given.moved_share * riding_mass);
  this->derive_gears(moved_mass, named("r", 0.5 * rk::pitch_diameter(pinion.module, pinion.teeth)), pinion.inertia);
  face_width = smaller(rack.face_width, pinion.face_width);
  velocity_factor = named("C_v", rk::velocity_factor(this->cycle.peak_speed));
  pinion_stress = rk::lewis_stress(this->largest_force, face_width, pinion.module, rk::lewis_form_factor(pinion.teeth));
  // The teeth of a rack are those of an endlessly large gear: the form factor without its part 0.912/z.
  rack_stress = rk::lewis_stress(this->largest_force, face_width, rack.module, 0.154 * pi<T>());
}

/// What the teeth push at the motor's shaft [N]; nothing where the bearings of a reduction bear it.
template <class T>
T shaft_pull(const RackDrive<T>& d) {
  using namespace scalar;
  return d.reduction.present ? in_unit<T>(0.0, dimension::force) : T(d.largest_force / cos(d.pinion.pressure_angle));
}

/// Errors of the axis [m]. The pitch error counts over at least 0.3 m: that of a few teeth is no smaller share of it.
/// The teeth are taken as rigid: what a force does is the wind-up of a reduction and the lag of the motor.
template <class T>
ErrorBudget<T> error_budget(const RackDrive<T>& d, UnderForce /*under_force*/ = UnderForce::yes) {
  using namespace scalar;
  ErrorBudget<T> budget;
  const T counted = in_unit<T>(counted_travel(d.data->require, d.data->stroke, true), dimension::length);
  budget.add_systematic("pitch", named("e_p", d.rack.pitch_error_per_length * counted));
  add_gear_errors(d, reversal_error(d), budget);
  return budget;
}

/// A reduction and the motor's field: the teeth are taken as rigid.
template <class T>
Compliance<T> tool_compliance(const RackDrive<T>& d, const ToolPlace& place) {
  Compliance<T> result = no_compliance<T>();
  using scalar::square;
  result[place.travel] = sharing_factor(place) * square(d.radius) * turning_compliance(d);
  return result;
}

}  // namespace millwright::machine
