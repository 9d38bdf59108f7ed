// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "mechanics/corner_bounds.h"
#include "mechanics/pull_out_torque.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Two-phase hybrid stepper motors: what torque at what speed. `current_amplitude` is the peak of the sinusoidal phase
/// current set at the driver (√2 times its RMS value); the holding torque is the catalogue's, with both phases on at
/// the rated current. `resistance` is that of the phase circuit. Everything in SI. Valid, besides what a formula says:
/// two-phase hybrid motor with linear magnetics, sinusoidal flux, steady state.
namespace millwright::mechanics::stepper {

using namespace scalar;

/// Frequency of the phase currents, a quarter of the full-step rate (Hz). [acarnley2002, chapter 5]
template <class T>
T electrical_frequency(const T& rotor_teeth, const T& angular_speed) {
  return rotor_teeth * angular_speed / (2.0 * pi<T>());
}

/// Step pulses per second the controller has to send (Hz). Typical limits: 30 kHz (grbl on an 8-bit board), 25 to 45
/// kHz (parallel port), 100 kHz and more (32-bit boards), 200 kHz (driver input). [acarnley2002, chapter 5]
template <class T>
T pulse_rate(const T& rotor_teeth, const T& microsteps, const T& angular_speed) {
  return 4.0 * rotor_teeth * microsteps * angular_speed / (2.0 * pi<T>());
}

/// Torque per ampere of phase-current amplitude, and at the same time the peak back-EMF per rad/s of one phase (N·m/A).
/// The holding torque is taken with both phases on, each at the rated direct current: a current vector of length √2
/// I_r. Saturation makes it 10 to 18 % larger at small currents. [acarnley2002, chapter 5]
template <class T>
T torque_constant(const T& holding_torque, const T& rated_current) {
  return holding_torque / (sqrt(T(2.0)) * rated_current);
}

/// Torque amplitude at standstill and low speed at the current set at the driver (N·m). With an amplitude equal to the
/// rated current it is only 0.707 of the holding torque. [acarnley2002, chapter 5]
template <class T>
T static_torque(const T& torque_constant, const T& current_amplitude) {
  return torque_constant * current_amplitude;
}

/// Peak voltage induced in one phase (V). [acarnley2002, chapter 5]
template <class T>
T back_emf(const T& torque_constant, const T& angular_speed) {
  return torque_constant * angular_speed;
}

/// Time constant of the current in one phase (s). [acarnley2002, chapter 5]
template <class T>
T electrical_time_constant(const T& inductance, const T& resistance) {
  return inductance / resistance;
}

/// Highest speed at which the supply can still drive the full current with the current vector square to the flux
/// (rad/s): (R I_p + K_m ω)² + (N_r L ω I_p)² = V². 0 if the resistance alone takes the voltage. Design rule: rapid
/// speed below about 1.5 times this. [acarnley2002, chapter 5]
template <class T>
T corner_speed(const T& voltage,
               const T& resistance,
               const T& inductance,
               const T& rotor_teeth,
               const T& torque_constant,
               const T& current_amplitude) {
  const auto beyond_zero = [&]() -> T {
    const T a = square(torque_constant) + square(rotor_teeth * inductance * current_amplitude);
    const T b = resistance * current_amplitude * torque_constant;
    const T c = square(resistance * current_amplitude) - square(voltage);
    return (sqrt(square(b) - a * c) - b) / a;
  };
  return where_below(resistance * current_amplitude, voltage, beyond_zero, T(0.0));
}

/// (R I_p + K_m ω)² + (N_r L ω I_p)² rises with every argument but the voltage, so two corners of a box span the range.
inline Interval corner_speed(const Interval& voltage,
                             const Interval& resistance,
                             const Interval& inductance,
                             const Interval& rotor_teeth,
                             const Interval& torque_constant,
                             const Interval& current_amplitude) {
  using namespace corner_bounds;
  if (!all_positive(voltage, resistance, inductance, rotor_teeth, torque_constant, current_amplitude))
    return corner_speed<Interval>(voltage, resistance, inductance, rotor_teeth, torque_constant, current_amplitude);
  return between_corners([](const auto&... x) { return corner_speed<Interval>(x...); },
                         Rising{voltage},
                         Falling{resistance},
                         Falling{inductance},
                         Falling{rotor_teeth},
                         Falling{torque_constant},
                         Falling{current_amplitude});
}

/// Pull-out torque when only the voltage limits (case B of pull_out_torque) (N·m). Negative above the no-load speed.
/// [acarnley2002, chapter 5]
template <class T>
T voltage_limited_torque(const T& voltage,
                         const T& resistance,
                         const T& inductance,
                         const T& rotor_teeth,
                         const T& torque_constant,
                         const T& angular_speed) {
  const T reactance = named("X", rotor_teeth * angular_speed * inductance);
  const T impedance = named("Z", sqrt(square(resistance) + square(reactance)));
  return torque_constant * (voltage / impedance - resistance * torque_constant * angular_speed / square(impedance));
}

/// Pull-out torque of a drive that keeps the current square to the flux (no field weakening) (N·m): a lower bound of
/// pull_out_torque, and 0 where the back-EMF reaches the supply. [acarnley2002, chapter 5]
template <class T>
T quadrature_torque(const T& voltage,
                    const T& resistance,
                    const T& inductance,
                    const T& rotor_teeth,
                    const T& torque_constant,
                    const T& current_amplitude,
                    const T& angular_speed) {
  const T emf = named("E", torque_constant * angular_speed);
  const T reactance = named("X", rotor_teeth * angular_speed * inductance);
  const T impedance_squared = named("Z²", square(resistance) + square(reactance));
  const T radicand = named("D", square(voltage) * impedance_squared - square(reactance * emf));
  const auto reachable = [&](const T& positive) -> T {
    const T current = (sqrt(positive) - resistance * emf) / impedance_squared;
    return torque_constant * larger(smaller(current_amplitude, current), T(0.0));
  };
  return where_below(radicand, T(0.0), T(0.0), reachable);
}

/// Torque lost to iron losses, hysteresis and friction, as fractions of the holding torque (N·m). Defaults 0.03 and
/// 0.0005 s/rad were fitted to published curves. Valid: empirical, fitted to two motors. [millwright_derivations, fit
/// to published pull-out curves]
template <class T>
T loss_torque(const T& holding_torque, const T& angular_speed, const T& constant_loss, const T& speed_loss) {
  watch_validity<T>("stepper.loss_torque", holding_torque, angular_speed, constant_loss, speed_loss);
  return holding_torque * (constant_loss + speed_loss * angular_speed);
}

/// Pull-out torque at the usable share of the supply voltage (default 0.9) less the losses (N·m): what the axis may
/// count on. Compared with published curves the error is 4 to 7 % of the holding torque, at worst 12 % just above the
/// corner speed; prefer a published curve where there is one. [acarnley2002, chapter 5]
template <class T>
T available_torque(const T& supply_voltage,
                   const T& voltage_fraction,
                   const T& resistance,
                   const T& inductance,
                   const T& rotor_teeth,
                   const T& holding_torque,
                   const T& rated_current,
                   const T& current_amplitude,
                   const T& angular_speed,
                   const T& constant_loss,
                   const T& speed_loss) {
  watch_validity<T>("stepper.available_torque",
                    supply_voltage,
                    voltage_fraction,
                    resistance,
                    inductance,
                    rotor_teeth,
                    holding_torque,
                    rated_current,
                    current_amplitude,
                    angular_speed,
                    constant_loss,
                    speed_loss);
  const T constant = named("K_m", torque_constant(holding_torque, rated_current));
  const T pull_out = named("T_p",
                           pull_out_torque(voltage_fraction * supply_voltage,
                                           resistance,
                                           inductance,
                                           rotor_teeth,
                                           constant,
                                           current_amplitude,
                                           angular_speed));
  return larger(pull_out - loss_torque(holding_torque, angular_speed, constant_loss, speed_loss), T(0.0));
}

/// Speed at which the ideal motor has no torque left (rad/s); infinite for usual motors, whose resistance is small:
/// there the losses set the limit. [acarnley2002, chapter 5]
template <class T>
T no_load_speed(
    const T& voltage, const T& resistance, const T& inductance, const T& rotor_teeth, const T& torque_constant) {
  watch_validity<T>("stepper.no_load_speed", voltage, resistance, inductance, rotor_teeth, torque_constant);
  const T margin = named("q", square(resistance * torque_constant) - square(voltage * rotor_teeth * inductance));
  const T endless = in_unit<T>(std::numeric_limits<double>::infinity(), dimension::angular_speed);
  return where_below(
      T(0.0), margin, [&]() -> T { return voltage * resistance / sqrt(margin); }, endless);
}

/// Shaft speed at a pulse rate (rad/s). [torch_table, eq. 4]
template <class T>
T angular_speed(const T& pulse_rate, const T& pulses_per_revolution) {
  return 2.0 * pi<T>() * pulse_rate / pulses_per_revolution;
}

}  // namespace millwright::mechanics::stepper
