// SPDX-License-Identifier: Apache-2.0
// On which side of 1 every requirement belongs, and on which side it is looser.
#include "machine/requirement.h"

namespace millwright::machine {
namespace {

enum class Kind {
  share,           ///< usable part of something, at most 1: a larger one is looser
  safety,          ///< on top of what is needed, at least 1: a smaller one is looser
  highest,         ///< the largest value allowed
  lowest,          ///< the smallest value allowed
  assumed_share,   ///< at most 1; what is set or taken for granted: more of it helps one check and harms another
  assumed_factor,  ///< the same, at least 1
  assumed,         ///< the same, of any size (currents, wear, travel, masses that are allowed for)
};

// No default: the compiler asks for the kind of a new requirement.
Kind kind_of(Requirement requirement) {
  switch (requirement) {
    case Requirement::torque_margin:
    case Requirement::torque_margin_estimate:
    case Requirement::load_torque_factor:
    case Requirement::step_rate_factor:
    case Requirement::holding_factor:
    case Requirement::detent_factor:
    case Requirement::bearing_pressure_factor:
    case Requirement::pv_factor:
    case Requirement::buckling_factor:
    case Requirement::critical_speed_factor:
    case Requirement::driver_voltage_factor:
    case Requirement::resolution_fraction:
    case Requirement::start_rate_factor:
    case Requirement::nut_wear_fraction:
    case Requirement::largest_preload_fraction:
    case Requirement::lead_error_share:
    case Requirement::thermal_growth_share:
    case Requirement::windup_share:
    case Requirement::belt_stretch_share:
    case Requirement::guide_shaft_deflection_ratio:
    case Requirement::frame_deflection_ratio:
    case Requirement::column_factor:
    case Requirement::spindle_power_factor:
      return Kind::share;
    case Requirement::brake_factor:
    case Requirement::screw_safety_factor:
    case Requirement::screw_shear_safety_factor:
    case Requirement::thread_safety_factor:
    case Requirement::self_locking_factor:
    case Requirement::static_safety:
    case Requirement::supply_reserve:
    case Requirement::coupling_shock_factor:
    case Requirement::belt_service_factor:
    case Requirement::resonance_distance:
    case Requirement::torsional_frequency_factor:
    case Requirement::guide_static_safety:
    case Requirement::guide_shaft_safety_factor:
    case Requirement::frame_safety_factor:
    case Requirement::shaft_safety_factor:
    case Requirement::shaft_bending_factor:
    case Requirement::shaft_torsion_factor:
    case Requirement::bushing_binding_factor:
    case Requirement::fatigue_safety_factor:
    case Requirement::bolt_proof_safety:
    case Requirement::bolt_separation_safety:
    case Requirement::bolt_slip_safety:
    case Requirement::bolt_shear_safety_factor:
      return Kind::safety;
    case Requirement::inertia_ratio:
    case Requirement::rms_torque_factor:
    case Requirement::step_rate:
    case Requirement::twist_per_length:
    case Requirement::permissible_axial_stress:
    case Requirement::position_error:
    case Requirement::lost_motion:
    case Requirement::angle_error:
    case Requirement::lost_angle:
    case Requirement::winding_temperature_rise:
    case Requirement::output_power_factor:
    case Requirement::motor_radial_load:
    case Requirement::weld_stress:
    case Requirement::bushing_slope:
    case Requirement::bushing_slope_self_aligning:
    case Requirement::frame_twist:
    case Requirement::ringing_amplitude:
      return Kind::highest;
    case Requirement::life:
    case Requirement::belt_teeth_in_mesh:
    case Requirement::belt_frequency:
    case Requirement::efficiency:
    case Requirement::axial_stiffness:
    case Requirement::coupling_parallel_misalignment:
    case Requirement::coupling_angular_misalignment:
    case Requirement::coupling_axial_misalignment:
    case Requirement::reduction_service_factor:
    case Requirement::frame_natural_frequency:
      return Kind::lowest;
    case Requirement::fatigue_reliability_factor:
    case Requirement::bolt_preload_fraction:
      return Kind::assumed_share;
    case Requirement::fatigue_load_factor:
    case Requirement::belt_preload_fraction:
    case Requirement::guide_load_factor:
      return Kind::assumed_factor;
    case Requirement::current_factor:
    case Requirement::overtravel:
    case Requirement::nut_mass_allowance:
    case Requirement::belt_mass_allowance:
    case Requirement::position_error_over:
    case Requirement::rack_drive_mass_allowance:
    case Requirement::start_rate:
    case Requirement::rated_temperature_rise:
    case Requirement::load_sharing_turns:
    case Requirement::nut_wear_rate:
    case Requirement::mapped_lead_error:
    case Requirement::screw_temperature_rise:
    case Requirement::rotating_nut_mass_allowance:
      return Kind::assumed;
    case Requirement::count_:
      break;
  }
  return Kind::assumed;
}

}  // namespace

Side side_of(Requirement requirement) {
  switch (kind_of(requirement)) {
    case Kind::share:
    case Kind::assumed_share:
      return Side::share;
    case Kind::safety:
    case Kind::assumed_factor:
      return Side::safety;
    case Kind::highest:
    case Kind::lowest:
    case Kind::assumed:
      break;
  }
  return Side::any;
}

Looser looser_side(Requirement requirement) {
  switch (kind_of(requirement)) {
    case Kind::share:
    case Kind::highest:
      return Looser::larger;
    case Kind::safety:
    case Kind::lowest:
      return Looser::smaller;
    case Kind::assumed_share:
    case Kind::assumed_factor:
    case Kind::assumed:
      break;
  }
  return Looser::neither;
}

}  // namespace millwright::machine
