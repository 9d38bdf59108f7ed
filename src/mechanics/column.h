// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/corner_bounds.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Buckling of columns, and the lateral stiffness of a portal frame. Use the smallest second moment of area.
/// Everything in SI.
namespace millwright::mechanics::column {

using namespace scalar;

/// Elastic buckling load (N). End fixity: 0.25 fixed-free, 1 supported-supported, 2 fixed-supported, 4 fixed-fixed.
/// Valid: straight, centrally loaded column; slender. [khurmi_gupta2005, chapter 16]
template <class T>
T euler_load(const T& end_fixity, const T& elastic_modulus, const T& second_moment_of_area, const T& length) {
  watch_validity<T>("column.euler_load", end_fixity, elastic_modulus, second_moment_of_area, length);
  return end_fixity * square(pi<T>()) * elastic_modulus * second_moment_of_area / square(length);
}

/// Buckling load of a stocky column by the Johnson parabola (N). Valid: straight, centrally loaded column; slenderness
/// below the transition √(2 C π² E / σ_y). [shigley, 4-13]
template <class T>
T johnson_load(const T& end_fixity,
               const T& elastic_modulus,
               const T& yield_strength,
               const T& area,
               const T& second_moment_of_area,
               const T& length) {
  watch_validity<T>(
      "column.johnson_load", end_fixity, elastic_modulus, yield_strength, area, second_moment_of_area, length);
  return area * yield_strength *
         (1.0 - yield_strength * square(length) * area /
                    (4.0 * end_fixity * square(pi<T>()) * elastic_modulus * second_moment_of_area));
}

/// Buckling load (N): Euler above the transition slenderness, Johnson below. Frames free to sway: end fixity 0.25.
/// Usual limit: a third of it. Valid: straight, centrally loaded column. [shigley, 4-12, 4-13]
template <class T>
T critical_load(const T& end_fixity,
                const T& elastic_modulus,
                const T& yield_strength,
                const T& area,
                const T& second_moment_of_area,
                const T& length) {
  watch_validity<T>(
      "column.critical_load", end_fixity, elastic_modulus, yield_strength, area, second_moment_of_area, length);
  const T slenderness = named("λ", length / sqrt(second_moment_of_area / area));
  const T transition = named("λ_t", sqrt(2.0 * end_fixity * square(pi<T>()) * elastic_modulus / yield_strength));
  return where_below(
      transition,
      slenderness,
      [&] { return euler_load(end_fixity, elastic_modulus, second_moment_of_area, length); },
      [&] { return johnson_load(end_fixity, elastic_modulus, yield_strength, area, second_moment_of_area, length); });
}

/// As with u = (slenderness / transition slenderness)² the load is A σ_y f(u), f = 1 - u/2 (u <= 1) or 1/(2u), and u
/// grows with A and σ_y, the load rises with C, E, I and, because f + u f' is never negative, with A and σ_y; it falls
/// with L. So two corners of a box span the range.
inline Interval critical_load(const Interval& end_fixity,
                              const Interval& elastic_modulus,
                              const Interval& yield_strength,
                              const Interval& area,
                              const Interval& second_moment_of_area,
                              const Interval& length) {
  using namespace corner_bounds;
  if (!all_positive(end_fixity, elastic_modulus, yield_strength, area, second_moment_of_area, length))
    return critical_load<Interval>(end_fixity, elastic_modulus, yield_strength, area, second_moment_of_area, length);
  return between_corners([](const auto&... x) { return critical_load<Interval>(x...); },
                         Rising{end_fixity},
                         Rising{elastic_modulus},
                         Rising{yield_strength},
                         Rising{area},
                         Rising{second_moment_of_area},
                         Falling{length});
}

/// Lateral stiffness of a portal with clamped feet under a force at beam level (N/m): two cantilevers when the beam is
/// soft, four times that when it is rigid. Valid: plane frame, axial strain neglected. [millwright_derivations,
/// definition]
template <class T>
T portal_stiffness(const T& elastic_modulus,
                   const T& column_second_moment,
                   const T& column_height,
                   const T& beam_second_moment,
                   const T& beam_span) {
  const T stiffness_ratio = named("κ", (beam_second_moment / beam_span) / (column_second_moment / column_height));
  return 24.0 * elastic_modulus * column_second_moment / cube(column_height) * (6.0 * stiffness_ratio + 1.0) /
         (6.0 * stiffness_ratio + 4.0);
}

/// Moment at the clamped feet of a portal under a lateral force at beam level (N·m). Stiffness ratio as for the lateral
/// stiffness, (I_b/L)/(I_c/h). By the slope-deflection equations F h/2 · (3κ + 1)/(6κ + 1). Valid: plane frame, axial
/// strain neglected. [millwright_derivations, definition]
template <class T>
T portal_foot_moment(const T& force, const T& column_height, const T& stiffness_ratio) {
  return force * column_height / 4.0 * (1.0 + 1.0 / (6.0 * stiffness_ratio + 1.0));
}

/// Moment at the upper corners of a portal with clamped feet under a lateral force at beam level (N·m). By the
/// slope-deflection equations F h/2 · 3κ/(6κ + 1). Valid: plane frame, axial strain neglected. [millwright_derivations,
/// definition]
template <class T>
T portal_corner_moment(const T& force, const T& column_height, const T& stiffness_ratio) {
  return force * column_height / 4.0 * (1.0 - 1.0 / (6.0 * stiffness_ratio + 1.0));
}

/// Moment at the upper corners of a portal with clamped feet under a force on the middle of its beam (N·m); half of it
/// arrives at the feet. Valid: plane frame, axial strain neglected. [millwright_derivations, definition]
template <class T>
T portal_corner_moment_of_beam_load(const T& force, const T& beam_span, const T& stiffness_ratio) {
  return force * beam_span / (4.0 * (stiffness_ratio + 2.0));
}

namespace detail {
/// F L/2 times the largest x (1 - x) (even + odd (1 - 2x)) of a force at x L: what its clamped-end moments that are
/// alike and those that differ turn into. At the smaller root of the derivative, a quadratic.
template <class T>
T largest_portal_moment(const T& force, const T& beam_span, const T& even, const T& odd) {
  const T root = sqrt(square(even) + 3.0 * square(odd));
  const T place = (even + 3.0 * odd - root) / (6.0 * odd);
  return force * beam_span / 2.0 * place * (1.0 - place) * (even + odd * (1.0 - 2.0 * place));
}
}  // namespace detail

/// Largest moment at the upper corners of a portal with clamped feet under a force that may stand anywhere on its beam
/// (N·m); the frame sways away from a force beside the middle. Valid: plane frame, axial strain neglected.
/// [millwright_derivations, definition]
template <class T>
T portal_corner_moment_of_moving_load(const T& force, const T& beam_span, const T& stiffness_ratio) {
  return detail::largest_portal_moment(
      force, beam_span, T(2.0 / (stiffness_ratio + 2.0)), T(1.0 / (6.0 * stiffness_ratio + 1.0)));
}

/// The same at the clamped feet (N·m). [millwright_derivations, definition]
template <class T>
T portal_foot_moment_of_moving_load(const T& force, const T& beam_span, const T& stiffness_ratio) {
  return detail::largest_portal_moment(
      force, beam_span, T(1.0 / (stiffness_ratio + 2.0)), T(1.0 / (6.0 * stiffness_ratio + 1.0)));
}

/// Buckling load of a stocky column by the Johnson parabola, from area and radius of gyration (N). Outside its range it
/// falls and turns negative; critical_load changes over. Valid: straight, centrally loaded; slenderness below the
/// transition √(2 C π² E / σ_y). [fdm_printer, eq. 11; khurmi_gupta2005, chapter 16]
template <class T>
T johnson_load_of_radius(const T& end_fixity,
                         const T& elastic_modulus,
                         const T& yield_strength,
                         const T& area,
                         const T& length,
                         const T& radius_of_gyration) {
  watch_validity<T>(
      "column.johnson_load_of_radius", end_fixity, elastic_modulus, yield_strength, area, length, radius_of_gyration);
  const T slenderness = named("λ", length / radius_of_gyration);
  return area * yield_strength *
         (1.0 - yield_strength / (4.0 * end_fixity * square(pi<T>()) * elastic_modulus) * square(slenderness));
}

/// Elastic buckling load from area and radius of gyration (N). Valid: straight, centrally loaded, slender.
/// [khurmi_gupta2005, chapter 16]
template <class T>
T euler_load_of_radius(
    const T& end_fixity, const T& elastic_modulus, const T& area, const T& length, const T& radius_of_gyration) {
  watch_validity<T>("column.euler_load_of_radius", end_fixity, elastic_modulus, area, length, radius_of_gyration);
  return end_fixity * square(pi<T>()) * elastic_modulus * area / square(length / radius_of_gyration);
}

}  // namespace millwright::mechanics::column
