// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "mechanics/sums.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Preloaded bolts and groups of bolts. Everything in SI.
/// Valid, besides what a formula says: ISO metric thread, elastic joint, equal bolts.
namespace millwright::mechanics::bolt {

using namespace scalar;

/// Tensile stress area of a metric thread (m²). Valid: ISO metric thread. [iso898_1]
template <class T>
T stress_area(const T& diameter, const T& pitch) {
  const T pitch_diameter = named("d_2", diameter - 0.649519052838329 * pitch);
  const T minor_diameter = named("d_3", diameter - 1.226869322027954 * pitch);
  return pi<T>() / 4.0 * square((pitch_diameter + minor_diameter) / 2.0);
}

/// Preload as a share of the proof load (N): 0.75 for joints to be reopened, 0.90 for permanent ones. [shigley, 8-9]
template <class T>
T preload(const T& stress_area, const T& proof_strength, const T& proof_fraction) {
  watch_validity<T>("bolt.preload", stress_area, proof_strength, proof_fraction);
  return proof_fraction * stress_area * proof_strength;
}

/// Tightening torque (N·m). Nut factor 0.20 dry, 0.15 lubricated. [shigley, chapter 8]
template <class T>
T tightening_torque(const T& nut_factor, const T& preload, const T& diameter) {
  return nut_factor * preload * diameter;
}

/// Preload that a tightening torque gives (N). Nut factor 0.20 dry, 0.15 lubricated. [shigley, chapter 8]
template <class T>
T preload_of_torque(const T& tightening_torque, const T& nut_factor, const T& diameter) {
  return tightening_torque / (nut_factor * diameter);
}

/// Share of an external tension that the bolt feels: 0.2 to 0.25 in steel, 0.3 to 0.4 in aluminium members. [shigley,
/// chapter 8]
template <class T>
T joint_constant(const T& bolt_stiffness, const T& member_stiffness) {
  return bolt_stiffness / (bolt_stiffness + member_stiffness);
}

/// Tension in a preloaded bolt under an external force (N). [shigley, chapter 8]
template <class T>
T largest_tension(const T& preload, const T& joint_constant, const T& external_tension) {
  watch_validity<T>("bolt.largest_tension", preload, joint_constant, external_tension);
  return preload + joint_constant * external_tension;
}

/// Margin of the preload against opening of the joint; at least 1.5. [shigley, chapter 8]
template <class T>
T separation_safety(const T& preload, const T& joint_constant, const T& external_tension) {
  watch_validity<T>("bolt.separation_safety", preload, joint_constant, external_tension);
  return preload / (external_tension * (1.0 - joint_constant));
}

/// Proof load over the tension in the bolt; at least 1.1 to 1.2. [shigley, chapter 8]
template <class T>
T proof_safety(const T& stress_area,
               const T& proof_strength,
               const T& preload,
               const T& joint_constant,
               const T& external_tension) {
  watch_validity<T>("bolt.proof_safety", stress_area, proof_strength, preload, joint_constant, external_tension);
  return proof_strength * stress_area / largest_tension(preload, joint_constant, external_tension);
}

/// Margin against sliding of a joint that carries shear by friction; at least 1.5. Friction 0.15 steel dry, 0.12
/// aluminium, 0.10 painted. Valid: joint not open. [shigley, chapter 8]
template <class T>
T slip_safety(const T& bolt_count,
              const T& friction,
              const T& preload,
              const T& external_tension,
              const T& joint_constant,
              const T& shear_force) {
  watch_validity<T>("bolt.slip_safety", bolt_count, friction, preload, external_tension, joint_constant, shear_force);
  return bolt_count * friction * (preload - (1.0 - joint_constant) * external_tension) / shear_force;
}

/// Shear stress in a fitted bolt (Pa). Valid: fitted bolts. [shigley, chapter 8]
template <class T>
T shear_stress(const T& shear_force, const T& shear_area, const T& shear_planes) {
  return shear_force / (shear_area * shear_planes);
}

/// Tension in the bolt farthest from the edge about which a bracket tilts (N). Valid: rigid bracket. [khurmi_gupta2005,
/// 11.18]
template <class T>
T group_tension(const T& moment, std::span<const T> edge_distances) {
  T farthest = edge_distances[0];
  for (const T& distance : edge_distances) farthest = larger(farthest, distance);
  return moment * farthest / sum_of(edge_distances.size(), [&](std::size_t n) { return square(edge_distances[n]); });
}

/// Force on the worst bolt of a group under an in-plane force along +y off the centroid (N). Positions are relative to
/// the centroid. Valid: rigid plates. [shigley, chapter 8]
template <class T>
T group_shear(const T& force, const T& eccentricity, std::span<const T> bolt_x, std::span<const T> bolt_y) {
  const std::size_t count = common_length(bolt_x, bolt_y);
  const T square_sum = named("S", sum_of(count, [&](std::size_t n) { return square(bolt_x[n]) + square(bolt_y[n]); }));
  const T share = force / static_cast<double>(count);
  const auto on_bolt = [&](std::size_t n) -> T {
    return sqrt(square(force * eccentricity * bolt_y[n] / square_sum) +
                square(share + force * eccentricity * bolt_x[n] / square_sum));
  };
  T largest = on_bolt(0);
  for (std::size_t n = 1; n < count; ++n) largest = larger(largest, on_bolt(n));
  return largest;
}

}  // namespace millwright::mechanics::bolt
