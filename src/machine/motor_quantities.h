// SPDX-License-Identifier: Apache-2.0
//
// Quantities of a motor that one or two constraints of any drive need and that are more than one formula.
#pragma once

#include <span>
#include <vector>

#include "machine/axis_motion.h"
#include "machine/frequency.h"
#include "machine/motor.h"
#include "machine/requirement.h"

namespace millwright::machine {

/// Air around a machine for which motors are rated [K], 40 °C, IEC 60034-1.
inline constexpr double standard_ambient_temperature = 313.15;

/// Mean speed of the motor over the first full step of its hardest ramp [rad/s]: a constant acceleration from the speed
/// at which the controller begins. The reciprocal of the time this step takes is the first step rate of the profile.
template <class Drive>
auto first_step_speed(const Drive& d) {
  using namespace scalar;
  using T = std::remove_cvref_t<decltype(d.peak_speed)>;
  const T step = named("θ_s", T(0.5 * pi<T>()) / d.motor.rotor_teeth);
  const T square_of_gain = 2.0 * d.peak_acceleration * step;
  if (!d.data->require.known(Requirement::start_rate)) return T(0.5 * sqrt(square_of_gain));
  const T start = named("ω_0", in_hertz<T>(d.data->require(Requirement::start_rate)) * step / T(d.data->microsteps));
  return T(0.5 * (start + sqrt(square(start) + square_of_gain)));
}

/// Speed to which the field may jump from standstill so that the rotor follows [rad/s], against the steady load with
/// all the inertia; nearly none when the load is as strong as the motor.
template <class Drive>
auto start_stop_speed(const Drive& d) {
  using namespace scalar;
  using T = std::remove_cvref_t<decltype(d.peak_speed)>;
  const T load = smaller(d.load_torque, d.motor.static_torque);
  const T inertia = named("J", d.motor.rotor_inertia + d.load_inertia);
  const T speed = mechanics::stepper::start_speed(d.motor.static_torque, load, d.motor.rotor_teeth, inertia);
  return T(larger(speed, in_unit<T>(1e-9, dimension::angular_speed)));
}

/// Root mean square of the motor's torque over the cycle [N.m], [sander, eq. 25; millwright_derivations]. While the
/// axis stands, the motor holds what would drive it back: the weight, and the largest force of measured profiles at
/// rest. A brake, which may engage with power off only, takes none of it; a self-locking screw all.
template <class Drive>
auto rms_torque(const Drive& d) {
  using namespace scalar;
  using T = std::remove_cvref_t<decltype(d.peak_speed)>;
  std::vector<T> torques = d.motor_torques, durations;
  make_room(torques.size() + 1, torques, durations);
  for (const auto& phase : d.cycle.phases) durations.push_back(phase.duration);
  if (d.cycle.standing_time > 0.0) {
    const T force = d.cycle.weight + in_unit<T>(d.cycle.standing_force, motion_dimensions(d.data->motion.rotary).force);
    torques.push_back(named("T_h", back_driving_torque(d, force)));
    durations.push_back(in_unit<T>(d.cycle.standing_time, dimension::time));
  }
  return T(named("T_rms", mechanics::stepper::rms_torque(std::span<const T>(torques), std::span<const T>(durations))));
}

/// Winding above ambient temperature [K] with the resistance it has at the permitted temperature: so it exceeds the
/// permitted rise exactly when the heat balance does, which need not be solved. Full current all the time, iron loss
/// over the cycle.
template <class Drive>
auto steady_winding_rise(const Drive& d) {
  using namespace scalar;
  using T = std::remove_cvref_t<decltype(d.peak_speed)>;
  namespace st = mechanics::stepper;
  T energy = in_unit<T>(0.0, dimension::torque);
  for (std::size_t i = 0; i < d.cycle.phases.size(); ++i) {
    const auto& phase = d.cycle.phases[i];
    const T mean = d.angular_speeds[i] * phase.mean_speed / phase.speed;
    const T drag = st::loss_torque(d.motor.holding_torque,
                                   T(phase.loss_share * d.angular_speeds[i]),
                                   T(constant_loss),
                                   in_unit<T>(speed_loss, dimension::time));
    energy = energy + drag * mean * phase.duration;
  }
  const T ambient = in_unit<T>(standard_ambient_temperature, dimension::temperature);
  const T permitted = ambient + d.require(Requirement::winding_temperature_rise, dimension::temperature);
  const T hot = st::hot_resistance(d.motor.resistance, permitted);
  const T copper = named("P_Cu", st::copper_loss(d.motor.current, hot));
  const T resistance =
      named("R_th",
            st::thermal_resistance(d.require(Requirement::rated_temperature_rise, dimension::temperature),
                                   d.motor.rated_current,
                                   d.motor.resistance));
  return T(st::winding_temperature(ambient, T(copper + energy / d.cycle.total_time), resistance) - ambient);
}

/// Smallest distance of the step rate from the resonance, over all constant speeds, as a logarithm of their ratio.
template <class Drive>
auto distance_from_resonance(const Drive& d) {
  using namespace scalar;
  using T = std::remove_cvref_t<decltype(d.peak_speed)>;
  namespace st = mechanics::stepper;
  const T resonance = named(
      "f_n",
      st::resonant_frequency(d.motor.static_torque, d.motor.rotor_teeth, T(d.motor.rotor_inertia + d.load_inertia)));
  std::vector<T> distances;
  for (const T& omega : d.angular_speeds)
    distances.push_back(absolute(log(st::pulse_rate(d.motor.rotor_teeth, T(d.data->microsteps), omega) / resonance)));
  return smallest(distances);
}

/// Largest product of torque and speed over the phases of the cycle [W].
template <class Drive>
auto largest_output_power(const Drive& d) {
  using namespace scalar;
  using T = std::remove_cvref_t<decltype(d.peak_speed)>;
  Largest<T> power;
  for (std::size_t i = 0; i < d.motor_torques.size(); ++i)
    power.take(mechanics::actuation::power(T(absolute(d.motor_torques[i])), d.angular_speeds[i]));
  return power.value();
}

}  // namespace millwright::machine
