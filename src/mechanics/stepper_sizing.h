// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "mechanics/corner_bounds.h"
#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Stepper motors beyond the torque curve (stepper.h): resolution, inertia, resonance, heating, supply. Everything in
/// SI. Valid, besides what a formula says: two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state.
namespace millwright::mechanics::stepper {

using namespace scalar;

/// Angle by which the rotor lags under a static load (rad); one full step when the load reaches the static torque.
/// Valid: load torque at most the static torque. [acarnley2002, chapter 5]
template <class T>
T load_angle(const T& load_torque, const T& static_torque, const T& rotor_teeth) {
  watch_validity<T>("stepper.load_angle", load_torque, static_torque, rotor_teeth);
  return asin(load_torque / static_torque) / rotor_teeth;
}

/// Slope of the torque curve at zero load (N·m/rad): the torsional spring between the commanded and the actual rotor
/// angle. [acarnley2002, chapter 5]
template <class T>
T static_stiffness(const T& static_torque, const T& rotor_teeth) {
  return rotor_teeth * static_torque;
}

/// Torque that one microstep of advance builds up (N·m): 9.8 % of the static torque at 1/16, 2.5 % at 1/64. Friction
/// above it swallows microsteps. [acarnley2002, chapter 5]
template <class T>
T microstep_torque(const T& static_torque, const T& microsteps) {
  return static_torque * sin(pi<T>() / (2.0 * microsteps));
}

/// Load inertia at the motor over rotor inertia. Usual limits: 10 for steppers, 5 for fast response, up to 30 for slow
/// screw axes. [parker_sizing; sander, eq. 21]
template <class T>
T inertia_ratio(const T& load_inertia, const T& rotor_inertia) {
  return load_inertia / rotor_inertia;
}

/// Torque that accelerates rotor and load (N·m); the load share passes the transmission. [sander, eq. 23]
template <class T>
T acceleration_torque(const T& rotor_inertia,
                      const T& load_inertia,
                      const T& efficiency,
                      const T& angular_acceleration) {
  watch_validity<T>("stepper.acceleration_torque", rotor_inertia, load_inertia, efficiency, angular_acceleration);
  return (rotor_inertia + load_inertia / efficiency) * angular_acceleration;
}

/// Root mean square torque over a cycle (N·m). For information on steppers, which draw their set current whatever the
/// load. [sander, eq. 25]
template <class T>
T rms_torque(std::span<const T> torques, std::span<const T> durations) {
  const std::size_t count = common_length(torques, durations);
  const T heating = sum_of(count, [&](std::size_t n) { return square(torques[n]) * durations[n]; });
  return sqrt(heating / sum_of(count, [&](std::size_t n) { return durations[n]; }));
}

/// Highest pulse rate at which the loaded motor starts and stops without a ramp, from the rate of the bare motor (Hz).
/// [oriental_motor_sizing]
template <class T>
T start_rate(const T& no_load_start_rate, const T& load_inertia, const T& rotor_inertia) {
  return no_load_start_rate / sqrt(1.0 + load_inertia / rotor_inertia);
}

/// Highest speed jump from standstill for which the rotor stays in the potential well of the field (rad/s). Undamped
/// estimate for motors without a published start rate: use half of it. Valid: undamped; load torque at most the static
/// torque. [millwright_derivations, definition]
template <class T>
T start_speed(const T& static_torque, const T& load_torque, const T& rotor_teeth, const T& inertia) {
  watch_validity<T>("stepper.start_speed", static_torque, load_torque, rotor_teeth, inertia);
  const T load_angle = named("δ_0", asin(load_torque / static_torque));
  const T barrier =
      named("ΔU", (2.0 * static_torque * cos(load_angle) - load_torque * (pi<T>() - 2.0 * load_angle)) / rotor_teeth);
  return sqrt(2.0 * barrier / inertia);
}

/// With x = T_L/T_s the barrier is T_s/N_r g(x), g = 2 (√(1 - x²) - x acos x), which falls from 2 to 0: its slope is
/// -2 acos x. So the speed rises with the static torque and falls with load, teeth and inertia; 0 where the load
/// reaches the static torque.
inline Interval start_speed(const Interval& static_torque,
                            const Interval& load_torque,
                            const Interval& rotor_teeth,
                            const Interval& inertia) {
  if (load_torque.lower < 0.0 || load_torque.lower > static_torque.upper ||
      !corner_bounds::all_positive(static_torque, rotor_teeth, inertia))
    return start_speed<Interval>(static_torque, load_torque, rotor_teeth, inertia);
  // Rounding of g in double stays below 4e-15: no term exceeds 3.2.
  constexpr double rounding_of_g = 1e-14;
  const auto g = [](double x) { return x < 1.0 ? 2.0 * (std::sqrt((1.0 - x) * (1.0 + x)) - x * std::acos(x)) : 0.0; };
  const Interval x = load_torque / static_torque;
  const Interval shares(larger(g(x.upper) - rounding_of_g, 0.0), g(x.lower) + rounding_of_g);
  return sqrt(2.0 * shares * static_torque / (rotor_teeth * inertia));
}
/// The derivatives of the barrier with their parts cancelled, so that their signs show.
template <int N>
Dual<Interval, N> start_speed(const Dual<Interval, N>& static_torque,
                              const Dual<Interval, N>& load_torque,
                              const Dual<Interval, N>& rotor_teeth,
                              const Dual<Interval, N>& inertia) {
  const Interval speed = start_speed(static_torque.value, load_torque.value, rotor_teeth.value, inertia.value);
  const Interval angle = asin(load_torque.value / static_torque.value);
  // Neither is negative below a quarter turn, whatever rounding makes of the end.
  const Interval by_static = larger(2.0 * cos(angle), Interval(0.0));
  const Interval by_load = larger(pi<Interval>() - 2.0 * angle, Interval(0.0));
  // The square of the speed is 2 ΔU/J with ΔU = (...)/N_r.
  const Interval half_square = 0.5 * square(speed);
  Dual<Interval, N> squared(2.0 * half_square);
  for (std::size_t n = 0; n < static_cast<std::size_t>(N); ++n) {
    const Interval of_torques =
        slopes::product(static_torque.slope[n], by_static) - slopes::product(load_torque.slope[n], by_load);
    squared.slope[n] = 2.0 * (of_torques / (rotor_teeth.value * inertia.value) -
                              slopes::product(rotor_teeth.slope[n], half_square / rotor_teeth.value) -
                              slopes::product(inertia.slope[n], half_square / inertia.value));
  }
  return corner_bounds::with_value(sqrt(squared), speed);
}

/// Natural frequency of rotor and rigidly coupled inertia on the magnetic spring (Hz). Cross it quickly or microstep.
/// [acarnley2002, chapter 6]
template <class T>
T resonant_frequency(const T& static_torque, const T& rotor_teeth, const T& inertia) {
  return sqrt(rotor_teeth * static_torque / inertia) / (2.0 * pi<T>());
}

/// Copper loss of both phases with sinusoidal currents (W): two times half I_p² R. [acarnley2002, chapter 5]
template <class T>
T copper_loss(const T& current_amplitude, const T& resistance) {
  return square(current_amplitude) * resistance;
}

/// Copper loss with both phases at a steady current (W): the rated loss, and that of a full-step standstill.
/// [acarnley2002, chapter 5]
template <class T>
T copper_loss_two_phases_on(const T& current, const T& resistance) {
  return 2.0 * square(current) * resistance;
}

/// Winding resistance at a temperature (ohm); copper gains 0.393 % per kelvin above 20 °C. Valid: copper windings, 0 to
/// 200 °C. [millwright_derivations, definition]
template <class T>
T hot_resistance(const T& resistance_at_20_celsius, const T& winding_temperature) {
  watch_validity<T>("stepper.hot_resistance", resistance_at_20_celsius, winding_temperature);
  const T warmer = winding_temperature - in_unit<T>(293.15, dimension::temperature);
  return resistance_at_20_celsius * (1.0 + in_unit<T>(0.00393, dimension::none / dimension::temperature) * warmer);
}

/// Winding temperature at a mean loss (K). Class B windings stand 130 °C; design for 100 °C. Valid: steady state.
/// [millwright_derivations, definition]
template <class T>
T winding_temperature(const T& ambient_temperature, const T& power_loss, const T& thermal_resistance) {
  watch_validity<T>("stepper.winding_temperature", ambient_temperature, power_loss, thermal_resistance);
  return ambient_temperature + power_loss * thermal_resistance;
}

/// Thermal resistance winding to ambient, from the temperature rise the catalogue allows at rated current (80 K for
/// class B) (K/W). Valid: as mounted by the maker when rating. [millwright_derivations, definition]
template <class T>
T thermal_resistance(const T& rated_temperature_rise, const T& rated_current, const T& resistance_at_20_celsius) {
  const T hot = 1.0 + in_unit<T>(0.00393, dimension::none / dimension::temperature) * rated_temperature_rise;
  return rated_temperature_rise / (2.0 * square(rated_current) * resistance_at_20_celsius * hot);
}

/// Power a drive takes from its supply (W): copper loss, shaft power, iron loss, over the driver efficiency (0.9 to
/// 0.95). [millwright_derivations, definition]
template <class T>
T drive_input_power(
    const T& copper_loss, const T& torque, const T& angular_speed, const T& iron_loss, const T& driver_efficiency) {
  watch_validity<T>("stepper.drive_input_power", copper_loss, torque, angular_speed, iron_loss, driver_efficiency);
  return (copper_loss + torque * angular_speed + iron_loss) / driver_efficiency;
}

/// Power rating needed of a supply (W): all drives that work together, times a reserve of 1.25.
/// [millwright_derivations, definition]
template <class T>
T supply_power(std::span<const T> input_powers, const T& reserve_factor) {
  watch_validity<T>("stepper.supply_power", input_powers, reserve_factor);
  return reserve_factor * sum_of(input_powers.size(), [&](std::size_t n) { return input_powers[n]; });
}

/// Supply current by rule of thumb, two thirds of the rated phase currents, because a chopper draws less than the
/// winding current (A). Valid: rule of thumb for chopper drives. [gecko_step_motor_basics]
template <class T>
T supply_current(std::span<const T> rated_currents) {
  return 2.0 / 3.0 * sum_of(rated_currents.size(), [&](std::size_t n) { return rated_currents[n]; });
}

/// Highest sensible supply voltage by the rule 32 √(L in mH) (V); above it iron losses heat the motor. The constants
/// carry volts and millihenries. Valid: rule of thumb. [gecko_step_motor_basics]
template <class T>
T recommended_voltage(const T& inductance) {
  return in_unit<T>(32.0, dimension::voltage) * sqrt(inductance / in_unit<T>(1e-3, dimension::inductance));
}

/// Bus voltage after braking energy has charged the capacitors (V). Keep below 0.95 of the driver limit. Valid: no
/// brake resistor, all energy returned. [millwright_derivations, definition]
template <class T>
T braking_bus_voltage(const T& voltage, const T& kinetic_energy, const T& capacitance) {
  return sqrt(square(voltage) + 2.0 * kinetic_energy / capacitance);
}

}  // namespace millwright::mechanics::stepper
