// SPDX-License-Identifier: Apache-2.0
//
// What rack, belt and rotary drives have in common: a motor, maybe through a reduction, turns an output shaft, and the
// axis travels in proportion. The travel of a radian of the output is `radius`: the pitch radius of a pinion or pulley,
// and 1 of a table, whose travel is its angle; then forces are torques and the moved mass is an inertia (see
// axis_motion.h).
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "machine/axis_motion.h"
#include "machine/error_budget.h"
#include "machine/frequency.h"
#include "machine/motor.h"
#include "machine/reduction.h"
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
  double efficiency = 1.0;  ///< of rack and pinion, of the belt along the travel
  double backlash = 0.0;    ///< m, of rack and pinion
  bool vertical = false;
  bool motor_rides = false;
  double moved_share = 1.0;  ///< of what rides of a single drive, that this drive moves
};

template <class T>
struct GearedDrive {
  const GearedDriveData* data = nullptr;
  MotorReading<T> motor;
  DriveReduction<T> reduction;
  T motor_shaft{}, motor_mass{};
  std::function<T(const T&)> available_torque;
  T acceleration_time{};

  Cycle<T> cycle;
  T radius{}, load_inertia{};
  T travelling_mass{};   ///< kg; of a table its inertia
  T rotating_inertia{};  ///< of all that turns, at the motor
  T efficiency{};        ///< from the motor to the travel
  std::vector<T> axial_forces, motor_torques, angular_speeds, torque_ratios;
  T input_power{};  ///< W, drive input that the supply must be ready for
  T largest_force{}, largest_torque{}, peak_speed{}, load_torque{}, holding_force{};
  T driven_force{};       ///< the largest while it moves; largest_force is that of standing, too
  T standing_torque{};    ///< at the output, under the force of standing; only where there is one
  T peak_acceleration{};  ///< of the motor, rad/s^2
  T output_torque{};      ///< the largest at the output of the reduction; only where it has one

  [[nodiscard]] T require(Requirement requirement, const scalar::Dimension& dimension = scalar::dimension::none) const {
    return scalar::in_unit<T>(data->require(requirement), dimension);
  }
  [[nodiscard]] MotionDimensions dimensions() const { return motion_dimensions(data->motion.rotary); }
  /// Shaft of reduction or motor, on which pinion or pulley sits [m].
  [[nodiscard]] const T& output_shaft() const { return reduction.present ? reduction.shaft : motor_shaft; }
  /// Travel of a radian of the motor [m, 1].
  [[nodiscard]] T travel_of_motor() const { return reduction.at_output(radius); }

  /// `moved`: mass or inertia on the travel side; `output_inertia`: of what turns with the output shaft beside it.
  void derive_gears(const T& moved, const T& travel_per_radian, const T& output_inertia);

 private:
  void derive_phases(const T& output_inertia);
  [[nodiscard]] T supply_power(const T& weight) const;
};

/// Motor torque for a force along the travel at constant speed [N.m].
template <class T>
T driving_torque(const GearedDrive<T>& d, const T& force) {
  return d.reduction.driving(force * d.radius / T(d.data->efficiency));
}

template <class T>
void GearedDrive<T>::derive_gears(const T& moved, const T& travel_per_radian, const T& output_inertia) {
  using namespace scalar;
  travelling_mass = moved;
  radius = travel_per_radian;
  efficiency = reduction.present ? T(data->efficiency * reduction.efficiency) : T(data->efficiency);
  cycle = duty_cycle(data->motion, moved, acceleration_time);
  const T turning = named("J_t", reduction.with_own(reduction.reflected(output_inertia)));
  rotating_inertia = named("J_rot", motor.rotor_inertia + reduction.with_own(reduction.sped_up(output_inertia)));
  load_inertia = named("J_L", turning + reduction.reflected(mechanics::transmission::belt_load_inertia(moved, radius)));
  derive_phases(output_inertia);
  peak_speed = named("ω", reduction.at_motor(cycle.peak_speed / radius));
  const T& weight = cycle.weight;
  load_torque = named("T_L", driving_torque(*this, T(weight + cycle.friction_force + cycle.process_force)));
  holding_force = named("F_h", weight + cycle.process_force);
  input_power = named("P_in", whole_watts(supply_power(weight)));
}

template <class T>
void GearedDrive<T>::derive_phases(const T& output_inertia) {
  using namespace scalar;
  namespace act = mechanics::actuation;
  axial_forces.clear();
  motor_torques.clear();
  angular_speeds.clear();
  torque_ratios.clear();
  Largest<T> most_force, most_torque, most_acceleration, most_output_torque;
  make_room(cycle.phases.size(), axial_forces, motor_torques, angular_speeds, torque_ratios);
  const T no_torque = in_unit<T>(0.0, dimension::torque);
  const T ratio = reduction.ratio_or_one();
  for (const Phase<T>& phase : cycle.phases) {
    axial_forces.push_back(absolute(phase.force));
    angular_speeds.push_back(reduction.at_motor(phase.speed / radius));
    motor_torques.push_back(no_torque);
    torque_ratios.push_back(T(0.0));
    if (!phase.may_govern && !wants_everything<T>(data->require)) continue;
    const T output_alpha = phase.acceleration / radius;
    const T alpha = reduction.at_motor(output_alpha);
    motor_torques.back() = named(
        "T_m", act::belt_motor_torque(phase.force, radius, efficiency, rotating_inertia, alpha, no_torque, ratio));
    if (!phase.may_govern) continue;
    const T needed = absolute(motor_torques.back());
    most_acceleration.take(alpha);
    most_force.take(axial_forces.back());
    most_torque.take(needed);
    torque_ratios.back() =
        needed / larger(available_torque(angular_speeds.back()), in_unit<T>(1e-9, dimension::torque));
    // The same balance at the output: without rotor and reduction, and the losses behind it only.
    if (reduction.present)
      most_output_torque.take(absolute(act::belt_motor_torque(
          phase.force, radius, T(data->efficiency), output_inertia, output_alpha, no_torque, T(1.0))));
  }
  peak_acceleration = named("α", most_acceleration.value());
  driven_force = named("F_t", most_force.value());
  if (cycle.standing_force > 0.0) {
    const T load = standing_load(cycle, dimensions().force);
    const T still = in_unit<T>(0.0, dimension::angular_acceleration);
    most_force.take(load);
    standing_torque = named(
        "T_st", act::belt_motor_torque(load, radius, T(data->efficiency), output_inertia, still, no_torque, T(1.0)));
    if (reduction.present) most_output_torque.take(standing_torque);
  }
  largest_force = named("F_t", most_force.value());
  largest_torque = named("T", most_torque.value());
  if (reduction.present) output_torque = named("T_2", most_output_torque.value());
}

/// What the supply must be ready for in the hardest of the moves [W], before it is rounded.
template <class T>
T GearedDrive<T>::supply_power(const T& weight) const {
  using namespace scalar;
  Largest<T> power;
  for (const PowerDemand<T>& demand : cycle.demands) {
    const T& acceleration = demand.acceleration;
    const T force = travelling_mass * acceleration + weight + cycle.friction_force + demand.force;
    const T driving = driving_torque(*this, force) + rotating_inertia * reduction.at_motor(acceleration / radius);
    const T omega = reduction.at_motor(demand.speed / radius);
    if constexpr (std::is_same_v<T, Interval>) {
      // The torque is linear in the acceleration, and acceleration times speed is known better than both apart.
      const T together = reduction.at_motor(demand.acceleration_times_speed / radius);
      const T steady = driving_torque(*this, T(weight + cycle.friction_force + demand.force)) * omega;
      const T accelerating = driving_torque(*this, T(travelling_mass * together)) +
                             rotating_inertia * reduction.at_motor(together / radius);
      power.take(drive_power(motor, driving, omega, T(steady + accelerating)));
    } else {
      power.take(drive_power(motor, driving, omega));
    }
  }
  return power.value();
}

template <class T>
T back_driving_torque(const GearedDrive<T>& d, const T& force) {
  return d.reduction.driven(force * d.radius * T(d.data->efficiency));
}

template <class T>
T power_off_torque(const GearedDrive<T>& d) {
  using namespace scalar;
  return back_driving_torque(d,
                             T(larger(d.cycle.weight - d.cycle.friction_force, in_unit<T>(0.0, d.dimensions().force))));
}

/// Torque that friction costs the motor before anything moves [N.m]: that of the guides, and half of what the weight
/// makes belt and reduction ask more going up than they give back going down.
template <class T>
T friction_torque(const GearedDrive<T>& d) {
  const T& weight = d.cycle.weight;
  return driving_torque(d, d.cycle.friction_force) + 0.5 * (driving_torque(d, weight) - back_driving_torque(d, weight));
}

/// Speed of the axis at the controller's highest pulse rate, and at that of the reduction [m/s, rad/s].
template <class T>
T speed_limit(const GearedDrive<T>& d) {
  using namespace scalar;
  const T pulse = d.require(Requirement::step_rate_factor) * in_hertz<T>(d.data->require(Requirement::step_rate)) *
                  2.0 * pi<T>() / (4.0 * d.motor.rotor_teeth * d.data->microsteps);
  return d.reduction.at_output(d.reduction.limited(pulse)) * d.radius;
}

/// Travel of one microstep [m, rad].
template <class T>
T resolution(const GearedDrive<T>& d) {
  return mechanics::accuracy::linear_resolution(
      2.0 * scalar::pi<T>() * d.radius, 4.0 * d.motor.rotor_teeth, T(d.data->microsteps), d.reduction.ratio_or_one());
}

/// Travel lost on reversal in the reduction [m, rad]: its play, and twice its wind-up under friction.
template <class T>
T reversal_in_reduction(const GearedDrive<T>& d) {
  const T friction = d.cycle.friction_force * d.radius / T(d.data->efficiency);
  return (d.reduction.backlash + 2.0 * d.reduction.compliance * friction) * d.radius;
}

/// Reversal error [m, rad]: the play of the mesh, and what the reduction adds. Shafts and teeth count as stiff.
template <class T>
T reversal_error(const GearedDrive<T>& d) {
  using namespace scalar;
  const T mesh = in_unit<T>(d.data->backlash, d.dimensions().distance);
  return d.reduction.present ? T(mesh + reversal_in_reduction(d)) : mesh;
}

/// Travel by which the reduction winds up under the steady load [m, rad]; 0 without one.
template <class T>
T reduction_windup(const GearedDrive<T>& d) {
  using namespace scalar;
  if (!d.reduction.present) return in_unit<T>(0.0, d.dimensions().distance);
  const T steady = (d.cycle.weight + d.cycle.friction_force + d.cycle.process_force) * d.radius / T(d.data->efficiency);
  return d.reduction.compliance * steady * d.radius;
}

/// How far the rotor lags under a torque of the motor, as travel [m, rad].
template <class T>
T motor_lag(const GearedDrive<T>& d, const T& torque) {
  using namespace scalar;
  return mechanics::accuracy::load_lag(smaller(torque, d.motor.static_torque),
                                       d.motor.static_torque,
                                       d.motor.rotor_teeth,
                                       2.0 * pi<T>() * d.travel_of_motor());
}

/// What friction holds back in the motor, beside reversal_error [m, rad]. On reversal it is lost twice.
template <class T>
T turning_give_under_friction(const GearedDrive<T>& d) {
  return motor_lag(d, friction_torque(d));
}

/// Adds what all geared drives have [m, rad]: reversal, wind-up of a reduction, lag of the motor, and at random 5 % of
/// a full step and half a microstep.
template <class T>
void add_gear_errors(const GearedDrive<T>& d, const T& reversal, ErrorBudget<T>& budget) {
  using namespace scalar;
  const T travel = 2.0 * pi<T>() * d.travel_of_motor();
  budget.add_systematic("reversal", named("e_r", reversal));
  if (d.reduction.present) budget.add_systematic("wind-up", named("e_w", reduction_windup(d)));
  budget.add_systematic("motor lag", named("e_s", motor_lag(d, d.load_torque)));
  budget.add_random("step", named("e_t", 0.05 * travel / (4.0 * d.motor.rotor_teeth)));
  budget.add_random("resolution", named("e_q", 0.5 * resolution(d)));
}

/// Turn of the output per torque on it, of the reduction and the motor's field [rad/(N.m)].
template <class T>
T turning_compliance(const GearedDrive<T>& d) {
  const T field = d.reduction.reflected(T(1.0 / motor_stiffness(d.motor)));
  return d.reduction.present ? T(field + d.reduction.compliance) : field;
}

}  // namespace millwright::machine
