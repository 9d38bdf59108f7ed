// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Stiffness between tool and workpiece. Compliances of the elements in the chain add, each times the square of the
/// force (or moment) it sees per unit of tool force, by Castigliano's theorem. Everything in SI.
/// Valid, besides what a formula says: linear elastic.
namespace millwright::mechanics::tool_point {

using namespace scalar;

/// Compliance at the tool of elements in the chain between tool and workpiece (m/N); each sees its transmission ratio
/// of the tool force. [slocum1992, chapter 2; roark, chapter 8]
template <class T>
T chain_compliance(std::span<const T> stiffnesses, std::span<const T> force_ratios) {
  return sum_of(common_length(stiffnesses, force_ratios),
                [&](std::size_t n) { return square(force_ratios[n]) / stiffnesses[n]; });
}

/// Compliance at the tool of a rotary spring under a lever arm (m/N). [slocum1992, chapter 2; roark, chapter 8]
template <class T>
T rotary_compliance(const T& lever_arm, const T& rotary_stiffness) {
  return square(lever_arm) / rotary_stiffness;
}

/// Deflection at the tool (m). [slocum1992, chapter 2; roark, chapter 8]
template <class T>
T deflection(const T& force, const T& compliance) {
  return force * compliance;
}

/// Stiffness of an end mill as a cantilever of reduced diameter (0.8) (N/m). Carbide 600 GPa, high-speed steel 210 GPa.
/// [slocum1992, chapter 2; roark, chapter 8]
template <class T>
T end_mill_stiffness(const T& elastic_modulus, const T& diameter, const T& diameter_ratio, const T& overhang) {
  watch_validity<T>("tool_point.end_mill_stiffness", elastic_modulus, diameter, diameter_ratio, overhang);
  return 3.0 * elastic_modulus * pi<T>() * pow(diameter_ratio * diameter, 4.0) / 64.0 / cube(overhang);
}

}  // namespace millwright::mechanics::tool_point
