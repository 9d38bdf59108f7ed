// SPDX-License-Identifier: Apache-2.0
//
// What a rack drive and a rotary table have in common: a motor, maybe through a reduction, turns an output shaft, and
// the axis travels in proportion. The travel of a radian of the output is `radius`: the pitch radius of a pinion, and 1
// of a table, whose travel is its angle; then forces are torques and the moved mass is an inertia (see axis_motion.h).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "machine/axis_motion.h"
#include "machine/motor.h"
#include "machine/requirement.h"
#include "mechanics/accuracy.h"
#include "mechanics/actuation.h"
#include "mechanics/stepper.h"
#include "mechanics/transmission.h"

namespace millwright::machine {

struct GearedDriveData {
  MotionData motion;
  Requirements require;
  double stroke = 0.0;
  double microsteps = 16.0;
  double brake_torque = 0.0;
  double efficiency = 1.0;  ///< of rack and pinion
  double backlash = 0.0;    ///< m, of rack and pinion
  bool vertical = false;
  bool motor_rides = false;
  double moved_share = 1.0;  ///< of what rides of a single drive, that this drive moves
  Reduction reduction = {};  ///< ratio 1 without losses where there is none
};

template <class T>
struct GearedDrive {
  const GearedDriveData* data = nullptr;
  MotorReading<T> motor;
  std::function<T(const T&)> available_torque;
  T acceleration_time{};

  Cycle<T> cycle;
  T radius{}, ratio{}, efficiency{}, load_inertia{};
  std::vector<T> axial_forces, motor_torques, angular_speeds, torque_ratios;
  T input_power{};  ///< W, drive input that the supply must be ready for
  T largest_force{}, largest_torque{}, peak_speed{}, load_torque{}, rms_torque{}, holding_force{};
  T peak_acceleration{};  ///< of the motor, rad/s^2

  [[nodiscard]] T require(Requirement requirement, const scalar::Dimension& dimension = scalar::dimension::none) const {
    return scalar::in_unit<T>(data->require(requirement), dimension);
  }
  [[nodiscard]] MotionDimensions dimensions() const { return motion_dimensions(data->motion.rotary); }

  /// `moved`: mass or inertia on the travel side; `output_inertia`: of what turns with the output shaft beside it.
  void derive_gears(const T& moved, const T& travel_per_radian, const T& output_inertia);

 private:
  void derive_phases(const T& rotating);
  [[nodiscard]] T supply_power(const T& moved, const T& weight, const T& rotating) const;
};

template <class T>
void GearedDrive<T>::derive_gears(const T& moved, const T& travel_per_radian, const T& output_inertia) {
  using namespace scalar;
  const Reduction& reduction = data->reduction;
  radius = travel_per_radian;
  ratio = T(reduction.ratio);
  efficiency = T(data->efficiency * reduction.efficiency);
  cycle = duty_cycle(data->motion, moved, acceleration_time);
  const T turning = named("J_t",
                          in_unit<T>(reduction.inertia, dimension::inertia) +
                              mechanics::transmission::reflected_inertia(output_inertia, ratio));
  const T rotating = named("J_rot", motor.rotor_inertia + turning);
  load_inertia = named("J_L",
                       turning + mechanics::transmission::reflected_inertia(
                                     mechanics::transmission::belt_load_inertia(moved, radius), ratio));
  derive_phases(rotating);
  peak_speed = named("ω", cycle.peak_speed * ratio / radius);
  const T weight = larger(cycle.gravity_force, in_unit<T>(0.0, dimensions().force));
  load_torque = named("T_L", (weight + cycle.friction_force + cycle.process_force) * radius / (ratio * efficiency));
  holding_force = named("F_h", weight + cycle.process_force);
  input_power = named("P_in", whole_watts(supply_power(moved, weight, rotating)));
}

template <class T>
void GearedDrive<T>::derive_phases(const T& rotating) {
  using namespace scalar;
  namespace act = mechanics::actuation;
  axial_forces.clear();
  motor_torques.clear();
  angular_speeds.clear();
  torque_ratios.clear();
  std::vector<T> governing_forces, governing_torques, governing_accelerations;
  const T no_torque = in_unit<T>(0.0, dimension::torque);
  T sum = in_unit<T>(0.0, dimension::torque * dimension::torque * dimension::time);
  for (const Phase<T>& phase : cycle.phases) {
    axial_forces.push_back(absolute(phase.force));
    angular_speeds.push_back(phase.speed * ratio / radius);
    motor_torques.push_back(no_torque);
    torque_ratios.push_back(T(0.0));
    if (!phase.may_govern && !wants_everything<T>(data->require)) continue;
    const T alpha = phase.acceleration * ratio / radius;
    motor_torques.back() = act::belt_motor_torque(phase.force, radius, efficiency, rotating, alpha, no_torque, ratio);
    sum = sum + square(motor_torques.back()) * phase.duration;
    if (!phase.may_govern) continue;
    governing_accelerations.push_back(alpha);
    governing_forces.push_back(axial_forces.back());
    governing_torques.push_back(absolute(motor_torques.back()));
    torque_ratios.back() =
        governing_torques.back() / larger(available_torque(angular_speeds.back()), in_unit<T>(1e-9, dimension::torque));
  }
  peak_acceleration = named("α", largest(governing_accelerations));
  largest_force = named("F_t", largest(governing_forces));
  largest_torque = named("T", largest(governing_torques));
  rms_torque = named("T_rms", sqrt(sum / cycle.total_time));
}

/// What the supply must be ready for in the hardest of the moves [W], before it is rounded.
template <class T>
T GearedDrive<T>::supply_power(const T& moved, const T& weight, const T& rotating) const {
  using namespace scalar;
  std::vector<T> powers;
  for (const SupplyDemand& demand : supply_demands(data->motion)) {
    const T acceleration = in_unit<T>(demand.acceleration, dimensions().acceleration);
    const T force = moved * acceleration + weight + cycle.friction_force + in_unit<T>(demand.force, dimensions().force);
    const T driving = force * radius / (ratio * efficiency) + rotating * acceleration * ratio / radius;
    powers.push_back(drive_power(motor, driving, in_unit<T>(demand.speed, dimensions().speed) * ratio / radius));
  }
  return largest(powers);
}

template <class T>
T back_driving_torque(const GearedDrive<T>& d, const T& force) {
  return force * d.radius * d.efficiency / d.ratio;
}

template <class T>
T power_off_torque(const GearedDrive<T>& d) {
  using namespace scalar;
  return back_driving_torque(
      d, larger(d.cycle.gravity_force - d.cycle.friction_force, in_unit<T>(0.0, d.dimensions().force)));
}

/// Torque that friction costs the motor before anything moves [N.m].
template <class T>
T friction_torque(const GearedDrive<T>& d) {
  return d.cycle.friction_force * d.radius / (d.ratio * d.efficiency);
}

/// Speed of the axis at the controller's highest pulse rate [m/s, rad/s].
template <class T>
T speed_limit(const GearedDrive<T>& d) {
  using namespace scalar;
  const T pulse = d.require(Requirement::step_rate_factor) * d.require(Requirement::step_rate, dimension::frequency) *
                  2.0 * pi<T>() / (4.0 * d.motor.rotor_teeth * d.data->microsteps);
  return pulse * d.radius / d.ratio;
}

/// Travel of one microstep [m, rad].
template <class T>
T resolution(const GearedDrive<T>& d) {
  return mechanics::accuracy::linear_resolution(
      2.0 * scalar::pi<T>() * d.radius, 4.0 * d.motor.rotor_teeth, T(d.data->microsteps), d.ratio);
}

/// Reversal error [m, rad]: the play of mesh and reduction. Shafts and teeth count as stiff.
template <class T>
T reversal_error(const GearedDrive<T>& d) {
  using namespace scalar;
  const T mesh = in_unit<T>(d.data->backlash, d.dimensions().distance);
  return mesh + d.data->reduction.backlash * d.radius;
}

/// Error of the motor under load [m, rad]: how far its rotor lags.
template <class T>
T motor_lag(const GearedDrive<T>& d) {
  using namespace scalar;
  return mechanics::accuracy::load_lag(smaller(d.load_torque, d.motor.static_torque),
                                       d.motor.static_torque,
                                       d.motor.rotor_teeth,
                                       2.0 * pi<T>() * d.radius / d.ratio);
}

/// Random errors of motor and microstepping [m, rad]: 5 % of a full step, half a microstep.
template <class T>
std::array<T, 2> step_errors(const GearedDrive<T>& d) {
  using namespace scalar;
  const T travel = 2.0 * pi<T>() * d.radius / d.ratio;
  return {named("e_t", 0.05 * travel / (4.0 * d.motor.rotor_teeth)), named("e_q", 0.5 * resolution(d))};
}

}  // namespace millwright::machine
