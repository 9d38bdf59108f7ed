// SPDX-License-Identifier: Apache-2.0
//
// Belt axis drive: a timing belt from a drive pulley on the motor shaft round an idler, the carriage clamped to it.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "machine/tool_chain.h"
#include "machine/axis_motion.h"
#include "machine/motor.h"
#include "mechanics/accuracy.h"
#include "mechanics/actuation.h"
#include "mechanics/ball_screw.h"
#include "mechanics/belt.h"
#include "mechanics/stepper.h"
#include "mechanics/transmission.h"

namespace millwright::machine {

/// Belt with both pulleys on this axis.
template <class T>
struct BeltReading {
  T mass_per_length{}, allowable_tension{}, specific_stiffness{}, least_teeth{}, largest_speed{};
  T belt_length{}, belt_mass{}, span{};
  T teeth{}, pitch_diameter{}, pulley_inertia{}, idler_inertia{}, idler_diameter{};
  T bore{};
  T width{};
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
                      &r.width})
    visit(*field);
}
inline constexpr std::size_t belt_reading_fields = 15;

struct BeltDriveData {
  MotionData motion;
  Requirements require;
  double stroke = 0.0;
  double microsteps = 16.0;
  double brake_torque = 0.0;
  double efficiency = 0.95;
  bool vertical = false;
};

template <class T>
struct BeltDrive {
  const BeltDriveData* data = nullptr;
  BeltReading<T> belt;
  MotorReading<T> motor;
  T motor_shaft{};
  std::function<T(const T&)> available_torque;
  T carried_mass{};
  T acceleration_time{};

  T moved_mass{};
  Cycle<T> cycle;
  T load_inertia{}, radius{};
  std::vector<T> axial_forces, motor_torques, angular_speeds, torque_ratios;
  T input_power{};  ///< W, drive input that the supply must be ready for
  T largest_force{}, largest_torque{}, peak_speed{}, load_torque{}, rms_torque{}, holding_force{};
  T peak_acceleration{};  ///< of the motor, rad/s^2
  T pretension{}, wrap{}, teeth_in_mesh{};

  [[nodiscard]] T require(Requirement requirement, const scalar::Dimension& dimension = scalar::dimension::none) const {
    return scalar::in_unit<T>(data->require(requirement), dimension);
  }
  void derive();
};

template <class T>
void BeltDrive<T>::derive() {
  using namespace scalar;
  namespace act = mechanics::actuation;
  namespace bt = mechanics::belt;
  moved_mass = named("m", carried_mass + belt.belt_mass);
  cycle = duty_cycle(data->motion, moved_mass, acceleration_time);
  radius = named("r", 0.5 * belt.pitch_diameter);
  const T pulleys =
      named("J_p", belt.pulley_inertia + belt.idler_inertia * square(belt.pitch_diameter / belt.idler_diameter));
  const T rotating = named("J_rot", motor.rotor_inertia + pulleys);
  load_inertia = named("J_L", pulleys + mechanics::transmission::belt_load_inertia(moved_mass, radius));
  axial_forces.clear();
  motor_torques.clear();
  angular_speeds.clear();
  torque_ratios.clear();
  std::vector<T> governing_forces, governing_torques, governing_accelerations;
  const T no_torque = in_unit<T>(0.0, dimension::torque);
  T sum = in_unit<T>(0.0, dimension::torque * dimension::torque * dimension::time);
  for (const Phase<T>& phase : cycle.phases) {
    axial_forces.push_back(absolute(phase.force));
    angular_speeds.push_back(phase.speed / radius);
    motor_torques.push_back(no_torque);
    torque_ratios.push_back(T(0.0));
    if (!phase.may_govern && !wants_everything<T>(data->require)) continue;
    const T alpha = phase.acceleration / radius;
    motor_torques.back() =
        act::belt_motor_torque(phase.force, radius, T(data->efficiency), rotating, alpha, no_torque, T(1.0));
    sum = sum + square(motor_torques.back()) * phase.duration;
    if (!phase.may_govern) continue;
    governing_accelerations.push_back(alpha);
    governing_forces.push_back(axial_forces.back());
    governing_torques.push_back(absolute(motor_torques.back()));
    torque_ratios.back() =
        governing_torques.back() / larger(available_torque(angular_speeds.back()), in_unit<T>(1e-9, dimension::torque));
  }
  peak_speed = named("ω", cycle.peak_speed / radius);
  peak_acceleration = named("α", largest(governing_accelerations));
  largest_force = named("F_e", largest(governing_forces));
  largest_torque = named("T", largest(governing_torques));
  rms_torque = named("T_rms", sqrt(sum / cycle.total_time));
  const T weight = larger(cycle.gravity_force, in_unit<T>(0.0, dimension::force));
  load_torque = named("T_L", (weight + cycle.friction_force + cycle.process_force) * radius / T(data->efficiency));
  holding_force = named("F_h", weight + cycle.process_force);
  std::vector<T> powers;
  for (const SupplyDemand& demand : supply_demands(data->motion)) {
    const T acceleration = in_unit<T>(demand.acceleration, dimension::acceleration);
    const T force =
        moved_mass * acceleration + weight + cycle.friction_force + in_unit<T>(demand.force, dimension::force);
    const T driving = force * radius / T(data->efficiency) + rotating * acceleration / radius;
    powers.push_back(drive_power(motor, driving, in_unit<T>(demand.speed, dimension::speed) / radius));
  }
  input_power = named("P_in", whole_watts(largest(powers)));
  pretension = named("F_0",
                     require(Requirement::belt_preload_fraction) * largest_force +
                         bt::centrifugal_tension(belt.mass_per_length, cycle.peak_speed));
  const T larger_diameter = larger(belt.pitch_diameter, belt.idler_diameter);
  wrap = named("φ", bt::wrap_angle(larger_diameter, belt.pitch_diameter, belt.span));
  teeth_in_mesh = named("z_m", bt::teeth_in_mesh(belt.teeth, wrap));
}

template <class T>
T back_driving_torque(const BeltDrive<T>& d, const T& force) {
  return force * d.radius * T(d.data->efficiency);
}

template <class T>
T power_off_torque(const BeltDrive<T>& d) {
  using namespace scalar;
  return larger(d.cycle.gravity_force - d.cycle.friction_force, in_unit<T>(0.0, dimension::force)) * d.radius *
         T(d.data->efficiency);
}

/// Torque that friction costs the motor before anything moves [N.m].
template <class T>
T friction_torque(const BeltDrive<T>& d) {
  return d.cycle.friction_force * d.radius / T(d.data->efficiency);
}

/// Force along the travel at constant speed [N]: weight, friction, process.
template <class T>
T steady_force(const BeltDrive<T>& d) {
  using namespace scalar;
  const T weight = larger(d.cycle.gravity_force, in_unit<T>(0.0, dimension::force));
  return weight + d.cycle.friction_force + d.cycle.process_force;
}

/// Stiffness of the carriage on its belt where it is softest [N/m].
template <class T>
T belt_stiffness(const BeltDrive<T>& d) {
  return mechanics::belt::least_stiffness(d.belt.specific_stiffness, 2.0 * d.belt.span);
}

/// Smallest of all speed limits of the drive [m/s]: pulse rate and belt speed.
template <class T>
T speed_limit(const BeltDrive<T>& d) {
  using namespace scalar;
  const T pulse = d.require(Requirement::step_rate_factor) *
                  d.require(Requirement::step_rate, dimension::none / dimension::time) * 2.0 * pi<T>() /
                  (4.0 * d.motor.rotor_teeth * d.data->microsteps);
  return smaller(pulse * d.radius, d.belt.largest_speed);
}

/// Travel of one microstep [m]; a belt's travel per turn is its pulley's pitch circumference.
template <class T>
T resolution(const BeltDrive<T>& d) {
  return mechanics::accuracy::linear_resolution(
      2.0 * scalar::pi<T>() * d.radius, 4.0 * d.motor.rotor_teeth, T(d.data->microsteps), T(1.0));
}

/// Reversal error [m]: twice the stretch of the belt under friction at its softest position.
template <class T>
T reversal_error(const BeltDrive<T>& d) {
  return 2.0 * mechanics::belt::position_error(d.cycle.friction_force, belt_stiffness(d));
}

/// Error budget of the axis [m]: belt pitch error (0.2 mm/m, a usual figure), stretch and motor lag
/// systematically, step accuracy and resolution at random.
template <class T>
T position_error_budget(const BeltDrive<T>& d) {
  using namespace scalar;
  const double over = d.data->require.known(Requirement::position_error_over)
                          ? d.data->require(Requirement::position_error_over)
                          : d.data->stroke;
  const T travel = 2.0 * pi<T>() * d.radius;
  const T lag = mechanics::accuracy::load_lag(
      smaller(d.load_torque, d.motor.static_torque), d.motor.static_torque, d.motor.rotor_teeth, travel);
  const std::array<T, 3> systematic{
      named("e_p", in_unit<T>(2e-4 * over, dimension::length)), named("e_r", reversal_error(d)), named("e_s", lag)};
  const std::array<T, 2> random{named("e_t", 0.05 * travel / (4.0 * d.motor.rotor_teeth)),
                                named("e_q", 0.5 * resolution(d))};
  return mechanics::accuracy::mixed_error(std::span<const T>(systematic), std::span<const T>(random));
}

/// The belt at its longest span and the motor's field.
template <class T>
Compliance<T> tool_compliance(const BeltDrive<T>& d, const ToolPlace& place) {
  const T one = 1.0 / belt_stiffness(d) + along_travel(T(0.5 * d.belt.pitch_diameter), motor_stiffness(d.motor));
  Compliance<T> result = no_compliance<T>();
  result[place.travel] = sharing_factor(place) * one;
  return result;
}

}  // namespace millwright::machine
