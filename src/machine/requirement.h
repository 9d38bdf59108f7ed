// SPDX-License-Identifier: Apache-2.0
//
// Every factor and limit that a user may set, declared once: key in the problem file, unit, default and where the
// default comes from.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace millwright::machine {

enum class Requirement : std::size_t {
  torque_margin,
  torque_margin_estimate,
  load_torque_factor,
  inertia_ratio,
  rms_torque_factor,
  step_rate,
  step_rate_factor,
  holding_factor,
  detent_factor,
  brake_factor,
  screw_safety_factor,
  screw_shear_safety_factor,
  thread_safety_factor,
  bearing_pressure_factor,
  pv_factor,
  buckling_factor,
  critical_speed_factor,
  twist_per_length,
  self_locking_factor,
  life,
  static_safety,
  permissible_axial_stress,
  fatigue_load_factor,
  current_factor,
  driver_voltage_factor,
  supply_reserve,
  coupling_shock_factor,
  overtravel,
  nut_mass_allowance,
  belt_mass_allowance,
  position_error,
  position_error_over,
  lost_motion,
  resolution_fraction,
  angle_error,
  lost_angle,
  belt_service_factor,
  belt_teeth_in_mesh,
  belt_preload_fraction,
  rack_drive_mass_allowance,
  start_rate,
  start_rate_factor,
  winding_temperature_rise,
  rated_temperature_rise,
  resonance_distance,
  output_power_factor,
  motor_radial_load,
  load_sharing_turns,
  nut_wear_fraction,
  nut_wear_rate,
  efficiency,
  largest_preload_fraction,
  lead_error_share,
  mapped_lead_error,
  axial_stiffness,
  screw_temperature_rise,
  thermal_growth_share,
  coupling_parallel_misalignment,
  coupling_angular_misalignment,
  coupling_axial_misalignment,
  torsional_frequency_factor,
  windup_share,
  belt_stretch_share,
  belt_frequency,
  reduction_service_factor,
  rotating_nut_mass_allowance,
  guide_static_safety,
  guide_load_factor,
  guide_shaft_safety_factor,
  guide_shaft_deflection_ratio,
  frame_safety_factor,
  frame_deflection_ratio,
  column_factor,
  weld_stress,
  shaft_safety_factor,
  shaft_bending_factor,
  shaft_torsion_factor,
  bushing_slope,
  bushing_slope_self_aligning,
  bushing_binding_factor,
  frame_twist,
  frame_natural_frequency,
  ringing_amplitude,
  fatigue_safety_factor,
  fatigue_reliability_factor,
  bolt_preload_fraction,
  bolt_proof_safety,
  bolt_separation_safety,
  bolt_slip_safety,
  bolt_shear_safety_factor,
  spindle_power_factor,
  count_
};

inline constexpr std::size_t requirement_count = static_cast<std::size_t>(Requirement::count_);

/// What is left of the lead error in 300 mm once it is mapped: the wobble within a revolution and what changes from one
/// point of the map to the next. Of grade 3 of ISO 3408-3, 6 of 12 um; of grade 5, 8 of 23; of C5 of JIS B 1192, 8
/// of 18.
inline constexpr double usual_mapped_lead_error = 0.5;

struct RequirementDeclaration {
  Requirement requirement;
  std::string_view key;   ///< in [axis.require] or [require] of the problem file
  std::string_view unit;  ///< UDUNITS text; "1" for a bare number
  double default_value;   ///< SI; NaN = no default: the checks that need it are made only when it is given
  std::string_view meaning;
  std::string_view source;  ///< of the default
};

/// All requirements, in the order of the enumeration.
std::span<const RequirementDeclaration> requirements();

/// The declaration with this key, if any.
const RequirementDeclaration* find_requirement(std::string_view key);

/// The kind of factor tells which side of 1 it belongs on; the other side is legal, for what-if questions, but odd.
enum class Side { any, share, safety };
Side side_of(Requirement requirement);

/// On which side a requirement is looser; `neither` for what describes the machine instead of asking something of it,
/// or acts both ways.
enum class Looser { larger, smaller, neither };
Looser looser_side(Requirement requirement);

/// The requirements of one axis: defaults, overridden by the problem file.
class Requirements {
 public:
  Requirements();
  void set(Requirement requirement, double value);
  /// Back to the default, as if nothing had been given.
  void forget(Requirement requirement);
  [[nodiscard]] double operator()(Requirement requirement) const {
    return values_[static_cast<std::size_t>(requirement)];
  }
  [[nodiscard]] bool given(Requirement requirement) const { return given_[static_cast<std::size_t>(requirement)]; }
  /// What limits the torque of a motor of which only a model is known: a margin that the problem states holds for
  /// curve and model alike, unless it states the model's as well.
  [[nodiscard]] Requirement margin_of_model() const {
    return given(Requirement::torque_margin) && !given(Requirement::torque_margin_estimate)
               ? Requirement::torque_margin
               : Requirement::torque_margin_estimate;
  }
  /// Whether there is a value and it counts: not where another requirement stands for it (margin_of_model).
  [[nodiscard]] bool counts(Requirement requirement) const {
    return known(requirement) && (requirement != Requirement::torque_margin_estimate ||
                                  margin_of_model() == Requirement::torque_margin_estimate);
  }
  /// Another value for what is given or a default, which stays one.
  void change(Requirement requirement, double value) { values_[static_cast<std::size_t>(requirement)] = value; }
  /// Whether there is a value at all (a default or a given one).
  [[nodiscard]] bool known(Requirement requirement) const;

  /// Makes a constraint that is only reported by default one that must hold.
  void enforce(std::string_view constraint);
  [[nodiscard]] bool enforces(std::string_view constraint) const;
  [[nodiscard]] bool enforces_any() const { return !enforced_.empty(); }

 private:
  std::array<double, requirement_count> values_{};
  std::array<bool, requirement_count> given_{};
  std::vector<std::string> enforced_;  ///< ids of constraints
};

}  // namespace millwright::machine
