// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "mechanics/sums.h"
#include "scalar/elementary.h"

/// Natural frequencies (Hz) of simple structures. Everything in SI.
/// Valid, besides what a formula says: undamped, small amplitude.
namespace millwright::mechanics::vibration {

using namespace scalar;

/// Natural frequency of a mass on a spring (Hz). [blevins]
template <class T>
T natural_frequency(const T& stiffness, const T& mass) {
  return sqrt(stiffness / mass) / (2.0 * pi<T>());
}

/// Natural frequency from the static deflection under one g in the direction of vibration (Hz). [blevins]
template <class T>
T natural_frequency_of_static_deflection(const T& static_deflection) {
  return sqrt(in_unit<T>(9.80665, dimension::acceleration) / static_deflection) / (2.0 * pi<T>());
}

/// First natural frequency of a cantilever with a mass at its tip (Hz). [blevins]
template <class T>
T cantilever_natural_frequency(
    const T& elastic_modulus, const T& second_moment_of_area, const T& length, const T& tip_mass, const T& beam_mass) {
  return sqrt(3.0 * elastic_modulus * second_moment_of_area / (cube(length) * (tip_mass + 33.0 / 140.0 * beam_mass))) /
         (2.0 * pi<T>());
}

/// First natural frequency of a simply supported beam with a mass in the middle (Hz). [blevins]
template <class T>
T supported_natural_frequency(const T& elastic_modulus,
                              const T& second_moment_of_area,
                              const T& length,
                              const T& midspan_mass,
                              const T& beam_mass) {
  return sqrt(48.0 * elastic_modulus * second_moment_of_area /
              (cube(length) * (midspan_mass + 17.0 / 35.0 * beam_mass))) /
         (2.0 * pi<T>());
}

/// First natural frequency of a beam clamped at both ends with a mass in the middle (Hz). 13/35 of the beam counts, by
/// Rayleigh's quotient of its static deflection. [blevins]
template <class T>
T fixed_natural_frequency(const T& elastic_modulus,
                          const T& second_moment_of_area,
                          const T& length,
                          const T& midspan_mass,
                          const T& beam_mass) {
  return sqrt(192.0 * elastic_modulus * second_moment_of_area /
              (cube(length) * (midspan_mass + 13.0 / 35.0 * beam_mass))) /
         (2.0 * pi<T>());
}

/// First natural frequency of a uniform beam (Hz). Eigenvalue 1.8751 fixed-free, π supported-supported, 3.9266 fixed-
/// supported, 4.7300 fixed-fixed. [blevins]
template <class T>
T uniform_beam_natural_frequency(const T& eigenvalue,
                                 const T& elastic_modulus,
                                 const T& second_moment_of_area,
                                 const T& mass_per_length,
                                 const T& length) {
  return square(eigenvalue) / (2.0 * pi<T>() * square(length)) *
         sqrt(elastic_modulus * second_moment_of_area / mass_per_length);
}

/// Lower bound of the first natural frequency from those of partial systems (Hz). [blevins]
template <class T>
T dunkerley_frequency(std::span<const T> partial_frequencies) {
  return 1.0 /
         sqrt(sum_of(partial_frequencies.size(), [&](std::size_t n) { return 1.0 / square(partial_frequencies[n]); }));
}

/// Natural frequency above which a step of acceleration leaves at most the permitted ringing (Hz). [machine_frame_lab]
template <class T>
T required_natural_frequency(const T& acceleration, const T& ringing_amplitude) {
  return sqrt(acceleration / ringing_amplitude) / (2.0 * pi<T>());
}

}  // namespace millwright::mechanics::vibration
