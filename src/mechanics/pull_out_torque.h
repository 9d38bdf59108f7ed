// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "scalar/dual.h"
#include "scalar/elementary.h"
#include "scalar/interval.h"

/// The pull-out torque of a stepper motor: the formula (for every scalar) and its range over a box.
///
/// In the rotor's frame, with the q axis along the back-EMF, the phase currents are a vector i = (i_d, i_q), and
///     v_d = R i_d - X i_q,   v_q = R i_q + X i_d + E,   X = N_r ω L,   E = K_m ω,   torque = K_m i_q.
/// The driver limits |i| to I_p, the supply limits |v| to V: two discs in the plane of the currents, one around the
/// origin, one of radius V/Z around c = (-X E/Z², -R E/Z²), Z² = R² + X². The largest i_q in both is what the motor
/// gives before the rotor slips, whatever the load angle.
///
/// Ranges. |v|² = R²|i|² + 2 K ω R i_q + ω²[(λ i_d + K)² + λ² i_q²] with λ = N_r L. For i_q >= 0 this rises with R and
/// with ω, so the largest i_q falls with both; it rises with V and I_p, which only widen the discs. It falls with K:
/// given the best current at a greater K, i_d can be moved towards 0 to keep v_q and lessen |v_d| and |i|. And λ i_q
/// rises with λ: over the flux linkages y = λ i the term in brackets is (y_d + K)² + y_q², free of λ, and the other
/// terms and the current limit |y| <= λ I_p loosen. That leaves only torque = K i_q and i_q = (λ i_q)/λ, products of
/// two monotone factors, to bound piece by piece.
namespace millwright::mechanics::stepper {

using namespace scalar;

/// Largest current square to the flux (A), 0 where the motor has no torque. [acarnley2002, chapter 5]
template <class T>
T largest_torque_current(
    const T& voltage, const T& resistance, const T& reactance, const T& back_emf, const T& current_amplitude) {
  const auto voltage_limited = [&]() -> T {
    const T impedance_squared = named("Z²", square(resistance) + square(reactance));
    const T radius = named("r", voltage / sqrt(impedance_squared));
    const T centre_d = named("c_d", -(reactance * back_emf) / impedance_squared);
    const T centre_q = named("c_q", -(resistance * back_emf) / impedance_squared);
    const T top = named("c_q + r", centre_q + radius);
    const auto crossing = [&]() -> T {  // the upper point where the two circles meet
      const T distance = named("D", sqrt(square(centre_d) + square(centre_q)));
      const T chord = named("a", (square(current_amplitude) - square(radius) + square(distance)) / (2.0 * distance));
      const T half_chord = named("h", sqrt(larger(square(current_amplitude) - square(chord), T(0.0))));
      const auto meeting = [&]() -> T { return (chord * centre_q + half_chord * absolute(centre_d)) / distance; };
      return where_below(distance, current_amplitude + radius, meeting, T(0.0));
    };
    const T reachable = where_below(square(current_amplitude), square(centre_d) + square(top), crossing, top);
    return larger(reachable, T(0.0));
  };
  const T needed =
      named("v²", square(resistance * current_amplitude + back_emf) + square(reactance * current_amplitude));
  return where_below(square(voltage), needed, voltage_limited, current_amplitude);
}

/// Pull-out torque (N·m): the largest torque at a speed over all load angles, for an ideal drive. Constant up to the
/// corner speed, then falling. [acarnley2002, chapter 5; millwright_derivations, above]
template <class T>
T pull_out_torque(const T& voltage,
                  const T& resistance,
                  const T& inductance,
                  const T& rotor_teeth,
                  const T& torque_constant,
                  const T& current_amplitude,
                  const T& angular_speed) {
  const T back_emf = named("E", torque_constant * angular_speed);
  const T reactance = named("X", rotor_teeth * angular_speed * inductance);
  return torque_constant * largest_torque_current(voltage, resistance, reactance, back_emf, current_amplitude);
}

/// The torque over a box, and its partial derivatives by the seven arguments in their order.
struct PullOutRange {
  Interval torque;
  std::array<Interval, 7> slope;
};

/// Range of the pull-out torque over a box; negative parts of the arguments are left out. Exact to parts in 1e9 where
/// inductance, teeth and torque constant are numbers (any ranges of the other four), else within a few per cent.
Interval pull_out_torque(const Interval& voltage,
                         const Interval& resistance,
                         const Interval& inductance,
                         const Interval& rotor_teeth,
                         const Interval& torque_constant,
                         const Interval& current_amplitude,
                         const Interval& angular_speed);

/// A box of motors and operating points, nothing in it below zero; `linkage` is λ = N_r L.
struct WindingBox {
  Interval voltage, resistance, linkage, constant, current, speed;
};

/// The same at one speed after the other: what does not hang on the speed is worked out once.
class PullOutTorques {
 public:
  PullOutTorques(const Interval& voltage,
                 const Interval& resistance,
                 const Interval& inductance,
                 const Interval& rotor_teeth,
                 const Interval& torque_constant,
                 const Interval& current_amplitude);
  [[nodiscard]] Interval at(const Interval& angular_speed) const;
  /// What that is worked out from.
  [[nodiscard]] WindingBox box_at(const Interval& angular_speed) const;

 private:
  WindingBox at_rest_;
};

/// With the derivatives (hulls of the one-sided ones at kinks): never positive for resistance and speed, never negative
/// for voltage and current.
PullOutRange pull_out_torque_and_slopes(const Interval& voltage,
                                        const Interval& resistance,
                                        const Interval& inductance,
                                        const Interval& rotor_teeth,
                                        const Interval& torque_constant,
                                        const Interval& current_amplitude,
                                        const Interval& angular_speed);

template <int N>
Dual<Interval, N> pull_out_torque(const Dual<Interval, N>& voltage,
                                  const Dual<Interval, N>& resistance,
                                  const Dual<Interval, N>& inductance,
                                  const Dual<Interval, N>& rotor_teeth,
                                  const Dual<Interval, N>& torque_constant,
                                  const Dual<Interval, N>& current_amplitude,
                                  const Dual<Interval, N>& angular_speed) {
  const std::array<const Dual<Interval, N>*, 7> arguments{
      &voltage, &resistance, &inductance, &rotor_teeth, &torque_constant, &current_amplitude, &angular_speed};
  const PullOutRange range = pull_out_torque_and_slopes(voltage.value,
                                                        resistance.value,
                                                        inductance.value,
                                                        rotor_teeth.value,
                                                        torque_constant.value,
                                                        current_amplitude.value,
                                                        angular_speed.value);
  Dual<Interval, N> result(range.torque);
  for (std::size_t n = 0; n < result.slope.size(); ++n)
    for (std::size_t k = 0; k < arguments.size(); ++k)
      result.slope[n] = result.slope[n] + arguments[k]->slope[n] * range.slope[k];
  return result;
}

}  // namespace millwright::mechanics::stepper
