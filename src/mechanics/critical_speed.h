// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "mechanics/buckling.h"
#include "scalar/elementary.h"

/// Whirling of a rotating screw. Everything in SI.
namespace millwright::mechanics::critical_speed {

using namespace scalar;
using buckling::EndCondition;

/// First root of the frequency equation of a beam with these ends. [shigley, section 7-6; khurmi_gupta2005]
inline double eigenvalue(EndCondition ends) {
  switch (ends) {
    case EndCondition::fixed_free:
      return 1.875104068711961;  // cos x cosh x = -1
    case EndCondition::supported_supported:
      return std::numbers::pi;  // sin x = 0
    case EndCondition::fixed_supported:
      return 3.926602312047919;  // tan x = tanh x
    case EndCondition::fixed_fixed:
      return 4.730040744862704;  // cos x cosh x = 1
  }
  return 1.875104068711961;
}

/// First critical speed (rad/s) of a uniform round shaft with the core diameter, between bearings `length` apart,
/// without axial load (compression lowers it). A rotating nut has no such limit. [thk_catalogue, permissible speed]
template <class T>
T critical_speed(
    const T& eigenvalue, const T& core_diameter, const T& length, const T& elastic_modulus, const T& density) {
  return square(eigenvalue / length) * core_diameter / 4.0 * sqrt(elastic_modulus / density);
}

}  // namespace millwright::mechanics::critical_speed
