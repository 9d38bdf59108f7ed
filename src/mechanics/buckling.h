// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/corner_bounds.h"
#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Buckling of a screw under axial compression, on its core diameter; `length` is the largest distance between the nut
/// and the support that takes the thrust. Everything in SI.
namespace millwright::mechanics::buckling {

using namespace scalar;

/// How the two ends of a shaft are held: fixed = two bearings or a preloaded pair, supported = one radial bearing.
enum class EndCondition { fixed_free, supported_supported, fixed_supported, fixed_fixed };

/// End-fixity coefficient C of theory and of the vendors' tables. [khurmi_gupta2005, chapter 16; shigley, table 4-2]
inline double theoretical_end_fixity(EndCondition ends) {
  switch (ends) {
    case EndCondition::fixed_free:
      return 0.25;
    case EndCondition::supported_supported:
      return 1.0;
    case EndCondition::fixed_supported:
      return 2.0;
    case EndCondition::fixed_fixed:
      return 4.0;
  }
  return 0.25;
}

/// End-fixity coefficient C recommended where no end is ever quite fixed. [shigley, table 4-2]
inline double practical_end_fixity(EndCondition ends) {
  switch (ends) {
    case EndCondition::fixed_free:
      return 0.25;
    case EndCondition::supported_supported:
      return 1.0;
    case EndCondition::fixed_supported:
    case EndCondition::fixed_fixed:
      return 1.2;
  }
  return 0.25;
}

/// Length over radius of gyration of a round core. [khurmi_gupta2005, chapter 16]
template <class T>
T slenderness(const T& length, const T& core_diameter) {
  return 4.0 * length / core_diameter;
}

/// Slenderness above which Euler holds, below which Johnson. [shigley, section 4-13]
template <class T>
T transition_slenderness(const T& end_fixity, const T& elastic_modulus, const T& yield_strength) {
  return sqrt(2.0 * end_fixity * square(pi<T>()) * elastic_modulus / yield_strength);
}

/// Critical load (N) after Euler; holds above the transition slenderness only. [khurmi_gupta2005, section 16.4;
/// shigley, section 4-12]
template <class T>
T euler_load(const T& end_fixity, const T& elastic_modulus, const T& core_diameter, const T& length) {
  const T second_moment = named("I", pi<T>() * square(square(core_diameter)) / 64.0);
  return end_fixity * square(pi<T>()) * elastic_modulus * second_moment / square(length);
}

/// Critical load (N) after Johnson; holds below the transition slenderness only, meaningless (even negative) above.
/// [khurmi_gupta2005, section 16.10; shigley, section 4-13]
template <class T>
T johnson_load(
    const T& end_fixity, const T& elastic_modulus, const T& yield_strength, const T& core_diameter, const T& length) {
  watch_validity<T>("buckling.johnson_load", end_fixity, elastic_modulus, yield_strength, core_diameter, length);
  const T area = named("A", pi<T>() * square(core_diameter) / 4.0);
  const T ratio = named("L/k", slenderness(length, core_diameter));
  return area * yield_strength *
         (1.0 - yield_strength * square(ratio) / (4.0 * end_fixity * square(pi<T>()) * elastic_modulus));
}

/// Critical load (N): Johnson up to the transition slenderness, Euler above; the two meet with the same slope.
/// [shigley, sections 4-12 and 4-13]
template <class T>
T critical_load(
    const T& end_fixity, const T& elastic_modulus, const T& yield_strength, const T& core_diameter, const T& length) {
  return where_below(
      slenderness(length, core_diameter),
      transition_slenderness(end_fixity, elastic_modulus, yield_strength),
      [&] { return johnson_load(end_fixity, elastic_modulus, yield_strength, core_diameter, length); },
      [&] { return euler_load(end_fixity, elastic_modulus, core_diameter, length); });
}

/// With u the square of slenderness over transition slenderness, the load is A σ_y f(u), f = 1 - u/2 (Johnson) or
/// 1/(2u) (Euler): falling in u, hence rising in C, E and d and falling in L; and σ_y f(u) rises with σ_y, because
/// f + u f' is 1 - u (u <= 1) or 0. So two corners of a box span the range.
inline Interval critical_load(const Interval& end_fixity,
                              const Interval& elastic_modulus,
                              const Interval& yield_strength,
                              const Interval& core_diameter,
                              const Interval& length) {
  using namespace corner_bounds;
  if (!all_positive(end_fixity, elastic_modulus, yield_strength, core_diameter, length))
    return critical_load<Interval>(end_fixity, elastic_modulus, yield_strength, core_diameter, length);
  return between_corners([](const auto&... x) { return critical_load<Interval>(x...); },
                         Rising{end_fixity},
                         Rising{elastic_modulus},
                         Rising{yield_strength},
                         Rising{core_diameter},
                         Falling{length});
}
template <int N>
Dual<Interval, N> critical_load(const Dual<Interval, N>& end_fixity,
                                const Dual<Interval, N>& elastic_modulus,
                                const Dual<Interval, N>& yield_strength,
                                const Dual<Interval, N>& core_diameter,
                                const Dual<Interval, N>& length) {
  return corner_bounds::with_value(
      critical_load<Dual<Interval, N>>(end_fixity, elastic_modulus, yield_strength, core_diameter, length),
      critical_load(end_fixity.value, elastic_modulus.value, yield_strength.value, core_diameter.value, length.value));
}

}  // namespace millwright::mechanics::buckling
