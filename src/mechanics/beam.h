// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Deflection, slope and bending moment of straight beams. Loads on one beam add up (the equations are linear); of
/// loads in two planes take the root of the sum of squares. Everything in SI. Valid, besides what a formula says:
/// linear elastic, small deflection, span over height above 8, constant section.
namespace millwright::mechanics::beam {

using namespace scalar;

enum class LoadCase {
  cantilever_point,
  cantilever_distributed,
  supported_point,
  supported_distributed,
  fixed_point,
  fixed_distributed
};

/// Deflection of a cantilever at its tip under a force there (m). [shigley, Table A-9]
template <class T>
T cantilever_tip_deflection(const T& force, const T& length, const T& elastic_modulus, const T& second_moment_of_area) {
  return force * cube(length) / (3.0 * elastic_modulus * second_moment_of_area);
}

/// Slope of a cantilever at its tip under a force there (rad). [shigley, Table A-9]
template <class T>
T cantilever_tip_slope(const T& force, const T& length, const T& elastic_modulus, const T& second_moment_of_area) {
  return force * square(length) / (2.0 * elastic_modulus * second_moment_of_area);
}

/// Deflection of a cantilever at its tip under a force between clamp and tip (m). Valid: force between clamp and tip.
/// [shigley, Table A-9]
template <class T>
T cantilever_tip_deflection_load_at(
    const T& force, const T& load_distance, const T& length, const T& elastic_modulus, const T& second_moment_of_area) {
  watch_validity<T>(
      "beam.cantilever_tip_deflection_load_at", force, load_distance, length, elastic_modulus, second_moment_of_area);
  return force * square(load_distance) * (3.0 * length - load_distance) /
         (6.0 * elastic_modulus * second_moment_of_area);
}

/// Deflection of a cantilever at its tip under an evenly distributed load (m). [shigley, Table A-9]
template <class T>
T cantilever_tip_deflection_distributed(const T& distributed_load,
                                        const T& length,
                                        const T& elastic_modulus,
                                        const T& second_moment_of_area) {
  return distributed_load * pow(length, 4.0) / (8.0 * elastic_modulus * second_moment_of_area);
}

/// Deflection of a cantilever at its tip under a moment there (m). [shigley, Table A-9]
template <class T>
T cantilever_tip_deflection_moment(const T& moment,
                                   const T& length,
                                   const T& elastic_modulus,
                                   const T& second_moment_of_area) {
  return moment * square(length) / (2.0 * elastic_modulus * second_moment_of_area);
}

/// Shear part of the tip deflection, to be added to the bending part in short beams (m). Shear coefficient 5/6 for a
/// rectangle, 0.9 for a circle, web area over area for tubes. Valid: linear elastic. [roark, chapter 8]
template <class T>
T cantilever_shear_deflection(
    const T& force, const T& length, const T& shear_coefficient, const T& shear_modulus, const T& area) {
  watch_validity<T>("beam.cantilever_shear_deflection", force, length, shear_coefficient, shear_modulus, area);
  return force * length / (shear_coefficient * shear_modulus * area);
}

/// Midspan deflection of a simply supported beam under a force there (m). [shigley, Table A-9]
template <class T>
T supported_deflection(const T& force, const T& length, const T& elastic_modulus, const T& second_moment_of_area) {
  return force * cube(length) / (48.0 * elastic_modulus * second_moment_of_area);
}

/// Deflection of a simply supported beam at any place under a force at any place (m). For a carriage on a beam the
/// middle is worst. Valid: both places on the span. [shigley, Table A-9]
template <class T>
T supported_deflection_at(const T& force,
                          const T& load_distance,
                          const T& position,
                          const T& length,
                          const T& elastic_modulus,
                          const T& second_moment_of_area) {
  watch_validity<T>(
      "beam.supported_deflection_at", force, load_distance, position, length, elastic_modulus, second_moment_of_area);
  const auto deflection = [&](const T& load_to_far_support, const T& from_support) -> T {
    return force * load_to_far_support * from_support *
           (square(length) - square(load_to_far_support) - square(from_support)) /
           (6.0 * elastic_modulus * second_moment_of_area * length);
  };
  return where_below(
      load_distance,
      position,
      [&] { return deflection(load_distance, length - position); },
      [&] { return deflection(length - load_distance, position); });
}

/// Largest deflection of a simply supported beam under a force at any place (m); it lies √((L² − b²)/3) from the
/// farther support. Valid: force on the span. [shigley, Table A-9]
template <class T>
T supported_largest_deflection(
    const T& force, const T& load_distance, const T& length, const T& elastic_modulus, const T& second_moment_of_area) {
  watch_validity<T>(
      "beam.supported_largest_deflection", force, load_distance, length, elastic_modulus, second_moment_of_area);
  const T shorter_part = named("b", smaller(load_distance, length - load_distance));
  return force * shorter_part * pow(square(length) - square(shorter_part), 1.5) /
         (9.0 * std::sqrt(3.0) * elastic_modulus * second_moment_of_area * length);
}

/// Midspan deflection of a simply supported beam under an evenly distributed load (m). [shigley, Table A-9]
template <class T>
T supported_deflection_distributed(const T& distributed_load,
                                   const T& length,
                                   const T& elastic_modulus,
                                   const T& second_moment_of_area) {
  return 5.0 * distributed_load * pow(length, 4.0) / (384.0 * elastic_modulus * second_moment_of_area);
}

/// Midspan deflection of a simply supported beam under two equal forces, each the same distance from its support (m).
/// Valid: distance at most half the span. [shigley, Table A-9]
template <class T>
T supported_deflection_two_loads(
    const T& force, const T& load_distance, const T& length, const T& elastic_modulus, const T& second_moment_of_area) {
  watch_validity<T>(
      "beam.supported_deflection_two_loads", force, load_distance, length, elastic_modulus, second_moment_of_area);
  return force * load_distance * (3.0 * square(length) - 4.0 * square(load_distance)) /
         (24.0 * elastic_modulus * second_moment_of_area);
}

/// Deflection at the tip of an overhang beyond a simply supported span under a force there (m). [shigley, Table A-9]
template <class T>
T overhang_tip_deflection(
    const T& force, const T& length, const T& overhang, const T& elastic_modulus, const T& second_moment_of_area) {
  return force * square(overhang) * (length + overhang) / (3.0 * elastic_modulus * second_moment_of_area);
}

/// Midspan deflection of a beam clamped at both ends under a force there (m). Bolted ends are never quite clamped: take
/// the simply supported value for safety. [shigley, Table A-9]
template <class T>
T fixed_deflection(const T& force, const T& length, const T& elastic_modulus, const T& second_moment_of_area) {
  return force * cube(length) / (192.0 * elastic_modulus * second_moment_of_area);
}

/// Deflection under a force at any place of a beam clamped at both ends (m). Valid: force on the span. [shigley, Table
///
template <class T>
T fixed_deflection_load_at(
    const T& force, const T& load_distance, const T& length, const T& elastic_modulus, const T& second_moment_of_area) {
  watch_validity<T>(
      "beam.fixed_deflection_load_at", force, load_distance, length, elastic_modulus, second_moment_of_area);
  return force * cube(load_distance) * cube(length - load_distance) /
         (3.0 * elastic_modulus * second_moment_of_area * cube(length));
}

/// Midspan deflection of a beam clamped at both ends under an evenly distributed load (m). [shigley, Table A-9]
template <class T>
T fixed_deflection_distributed(const T& distributed_load,
                               const T& length,
                               const T& elastic_modulus,
                               const T& second_moment_of_area) {
  return distributed_load * pow(length, 4.0) / (384.0 * elastic_modulus * second_moment_of_area);
}

/// Largest bending moment of the six standard cases from the total load (distributed load times length) (N·m).
/// [shigley, Table A-9]
template <class T>
T largest_moment(LoadCase load_case, const T& load, const T& length) {
  switch (load_case) {
    case LoadCase::cantilever_point:
      return load * length;
    case LoadCase::cantilever_distributed:
      return load * length / 2.0;
    case LoadCase::supported_point:
      return load * length / 4.0;
    case LoadCase::supported_distributed:
    case LoadCase::fixed_point:
      return load * length / 8.0;
    case LoadCase::fixed_distributed:
      return load * length / 12.0;
  }
  return load * length;
}

/// Largest bending moment of a beam clamped at both ends under a force wherever on it (N·m): F a (L - a)^2/L^2 at the
/// clamp nearer to it, which is largest at a = L/3. [shigley, Table A-9]
template <class T>
T fixed_moment_of_travelling_load(const T& force, const T& length) {
  return 4.0 / 27.0 * force * length;
}

/// Span over the height in the plane of bending: the deflections here leave out shear, which counts in stubby beams.
/// Valid: at least 8. [shigley, Table A-9]
template <class T>
T span_to_height(const T& length, const T& height) {
  watch_validity<T>("beam.span_to_height", length, height);
  return length / height;
}

/// Bending moment under a force at any place of a simply supported beam (N·m). Valid: force on the span. [shigley,
/// Table A-9]
template <class T>
T supported_moment_load_at(const T& force, const T& load_distance, const T& length) {
  watch_validity<T>("beam.supported_moment_load_at", force, load_distance, length);
  return force * load_distance * (length - load_distance) / length;
}

}  // namespace millwright::mechanics::beam
