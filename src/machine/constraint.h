// SPDX-License-Identifier: Apache-2.0
//
// How a constraint is declared: once, in the element that owns it, as a pair of generic functions of the element's
// design.
//
//     visit({.id = "C-SCR-VM", .title = "Core stress, von Mises", .symbol = "σ_v", .unit = "MPa",
//            .source = "shigley, section 5-5"},
//           [](const auto& d) { return power_screw::von_mises_stress(d.axial_load, d.torque, d.screw.root_diameter); },
//           // demand
//           [](const auto& d) { return d.screw.yield_strength / d.require(Requirement::screw_safety_factor); }); //
//           capacity
//
// Each element has one function template `<element>_constraints(visit)` that calls `visit` once per constraint. Whoever
// needs them (evaluation on a scalar, bounds over a box, slopes, the calculation sheet, dimension tests) passes its own
// visitor; the functions are instantiated for its scalar and inlined. utilisation = demand / capacity, satisfied when
// <= 1.
#pragma once

#include <string_view>

#include "machine/requirement.h"

namespace millwright::machine {

/// hard: must hold for a compliant build. soft: reported, not enforced. fit: two parts that must go together; hard.
enum class ConstraintKind { hard, soft, fit };

/// In which phase of the duty cycle a constraint is worst: where this quantity is largest, or what it is about.
enum class WorstPhase {
  none,
  force,
  driven_force,
  torque,
  output_torque,
  torque_ratio,
  speed,
  load,
  steady,
  standstill,
  cycle
};

/// At which position of the travel a constraint is worst. The formulas take that position; this names it.
enum class WorstPlace { none, nut_far, nut_softest, long_belt, drive_pulley, mid_span, most_bent, travel_ends };

/// What is said about a constraint besides its two functions. All strings are literals.
struct Declaration {
  std::string_view id = {};      ///< stable id, as printed in reports ("C-SCR-VM", "F-COUPLING-BORE")
  std::string_view title = {};   ///< in words
  std::string_view symbol = {};  ///< of the demand
  std::string_view unit = {};    ///< in which demand and capacity are shown
  ConstraintKind kind = ConstraintKind::hard;
  std::string_view source = {};       ///< bibliography key, with section
  std::string_view requirement = {};  ///< key of the requirement that sets its factor or limit, empty if none
  WorstPhase worst = WorstPhase::none;
  WorstPlace place = WorstPlace::none;
  /// Another hard constraint that never holds where this one does not: the search holds that one only.
  std::string_view implied_by = {};
  /// A limit of the whole machine, which the solver holds itself: the search need not evaluate it.
  bool held_by_limit = false;
  std::string_view file = __builtin_FILE();
  int line = __builtin_LINE();
};

/// Whether the search has to hold a constraint: all but those that are only reported, or that another one implies.
constexpr bool is_searched(const Declaration& declaration) {
  return declaration.kind != ConstraintKind::soft && declaration.implied_by.empty() && !declaration.held_by_limit;
}
/// The same where the problem file makes some of those that are only reported binding.
inline bool is_searched(const Declaration& declaration, const Requirements& require) {
  if (is_searched(declaration)) return true;
  return declaration.kind == ConstraintKind::soft && require.enforces_any() && require.enforces(declaration.id);
}

/// Whether a constraint concerns a design, or some, all or none of a set of designs.
enum class Applies { no, yes, some };

/// Acceleration of free fall [m/s^2], ISO 80000-3.
inline constexpr double standard_gravity = 9.80665;

inline constexpr double smallest_brake = 1e-3;  ///< N.m, below which no brake is worth its name

/// The capacity is limited from below, so that a useless capacity gives a large finite utilisation and not infinity.
inline constexpr double useless_utilisation = 1e9;

}  // namespace millwright::machine
