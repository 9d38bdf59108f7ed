// SPDX-License-Identifier: Apache-2.0
//
// A stepper with its driver at a supply voltage: what the drive's constraints read of the pair.
//
// Current: I_p = min(driver peak, asked for), which is k * rated, k = 1 unless the problem says otherwise, or one of
// the currents that the problem lets set (amplitude and direct current are taken as equal, as drivers are set). Torque
// at speed: a published pull-out curve governs when supply and current are at or above its own; below its speed range
// its first value is held, above its range the smaller of model and last point counts. Otherwise the winding model,
// marked as an estimate.
#pragma once

#include "machine/constraint.h"
#include "mechanics/stepper.h"
#include "mechanics/stepper_sizing.h"
#include "mechanics/torque_curve.h"
#include "scalar/scalars.h"

namespace millwright::machine {

/// Catalogue figures of motor and driver, SI.
template <class T>
struct MotorFigures {
  T holding_torque{}, detent_torque{}, rated_current{}, resistance{}, inductance{}, rotor_inertia{}, rotor_teeth{};
  T driver_peak_current{}, driver_largest_voltage{}, driver_least_voltage{};
  T voltage{};        ///< of the supply
  T asked_current{};  ///< peak amplitude: k * rated, or what the problem lets set
};

inline constexpr double voltage_fraction = 0.9;   ///< k_V: usable share of the bus, less drops
inline constexpr double constant_loss = 0.03;     ///< c_0 of STEP-LOSS-TORQUE
inline constexpr double speed_loss = 0.0005;      ///< c_1 of STEP-LOSS-TORQUE, s/rad
inline constexpr double driver_efficiency = 0.9;  ///< lower end of the usual 0.9 to 0.95

template <class T>
struct MotorReading {
  T rotor_inertia{}, holding_torque{}, detent_torque{}, rotor_teeth{};
  T current_ratio{};  ///< I_p over the rated current
  T driver_largest_voltage{}, driver_least_voltage{}, voltage{};
  T static_torque{};  ///< K_m * I_p
  T copper_loss{};
  T torque_margin{};  ///< permitted share of the available torque: lower where the torque is an estimate
  // What only soft checks read, and the search therefore does not fill in.
  T current{};        ///< I_p
  T asked_current{};  ///< more than a weak driver gives
  T driver_peak_current{}, rated_current{}, resistance{};
};

template <class Reading, class Visit>
void visit_motor_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.rotor_inertia,
                      &r.holding_torque,
                      &r.detent_torque,
                      &r.rotor_teeth,
                      &r.current_ratio,
                      &r.driver_largest_voltage,
                      &r.driver_least_voltage,
                      &r.voltage,
                      &r.static_torque,
                      &r.copper_loss,
                      &r.torque_margin})
    visit(*field);
}
inline constexpr std::size_t motor_reading_fields = 11;

template <class Reading, class Visit>
void visit_shown_motor_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.current, &r.asked_current, &r.driver_peak_current, &r.rated_current, &r.resistance})
    visit(*field);
}
inline constexpr std::size_t shown_motor_reading_fields = 5;

template <class T>
MotorReading<T> motor_reading(const MotorFigures<T>& f, const T& torque_margin) {
  using namespace scalar;
  namespace st = mechanics::stepper;
  MotorReading<T> r;
  r.rotor_inertia = f.rotor_inertia;
  r.holding_torque = f.holding_torque;
  r.detent_torque = f.detent_torque;
  r.rotor_teeth = f.rotor_teeth;
  r.asked_current = f.asked_current;
  r.current = named("I_p", smaller(f.driver_peak_current, r.asked_current));
  r.current_ratio = named("I_p/I_r", r.current / f.rated_current);
  r.driver_peak_current = f.driver_peak_current;
  r.rated_current = f.rated_current;
  r.resistance = f.resistance;
  r.driver_largest_voltage = f.driver_largest_voltage;
  r.driver_least_voltage = f.driver_least_voltage;
  r.voltage = f.voltage;
  r.static_torque = named("T_s", st::static_torque(st::torque_constant(f.holding_torque, f.rated_current), r.current));
  r.copper_loss = named("P_Cu", st::copper_loss(r.current, f.resistance));
  r.torque_margin = torque_margin;
  return r;
}

/// Iron losses of the motor [W].
template <class T>
T iron_loss(const MotorReading<T>& motor, const T& angular_speed) {
  using namespace scalar;
  return mechanics::stepper::loss_torque(
             motor.holding_torque, angular_speed, T(constant_loss), in_unit<T>(speed_loss, dimension::time)) *
         angular_speed;
}

/// Electrical input of the drive [W] at a torque and speed: copper and iron losses and the shaft's work over the
/// driver's efficiency.
template <class T>
T drive_power(const MotorReading<T>& motor, const T& torque, const T& angular_speed) {
  return mechanics::stepper::drive_input_power(
      motor.copper_loss, torque, angular_speed, iron_loss(motor, angular_speed), T(driver_efficiency));
}

/// The same where the power of the shaft is known better than its torque and speed: between intervals of both.
template <class T>
T drive_power(const MotorReading<T>& motor, const T& torque, const T& angular_speed, const T& shaft_power) {
  const T power = drive_power(motor, torque, angular_speed);
  return intersect(power,
                   mechanics::stepper::drive_input_power(
                       motor.copper_loss, shaft_power, T(1.0), iron_loss(motor, angular_speed), T(driver_efficiency)))
      .value_or(power);
}

/// A power rounded up to whole watts. Supplies are budgeted so: two drives that differ by a milliwatt ask the same of a
/// supply, and one of them need not be kept in mind because of that milliwatt.
template <class T>
T whole_watts(const T& power) {
  using namespace scalar;
  return up_to_whole(power, in_unit<T>(1.0, dimension::power_output));
}

/// Pull-out torque by the winding model. (ModelledTorques bounds the same for many motors at once: what changes here
/// changes there.)
template <class T>
T modelled_torque(const MotorFigures<T>& f, const T& current, const T& angular_speed) {
  using namespace scalar;
  return mechanics::stepper::available_torque(f.voltage,
                                              T(voltage_fraction),
                                              f.resistance,
                                              f.inductance,
                                              f.rotor_teeth,
                                              f.holding_torque,
                                              f.rated_current,
                                              current,
                                              angular_speed,
                                              T(constant_loss),
                                              in_unit<T>(speed_loss, dimension::time));
}

/// Magnetic stiffness of a stepper that holds its position without load [N.m/rad]: slope of its static torque over the
/// load angle.
template <class T>
T motor_stiffness(const MotorReading<T>& motor) {
  return motor.rotor_teeth * motor.static_torque;
}

}  // namespace millwright::machine
