// SPDX-License-Identifier: Apache-2.0
// On which side of 1 every requirement belongs, and on which side it is looser.
#include "machine/requirement.h"

namespace millwright::machine {

Side side_of(Requirement requirement) {
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
    case Requirement::start_rate_factor:
    case Requirement::nut_wear_fraction:
    case Requirement::largest_preload_fraction:
    case Requirement::lead_error_share:
    case Requirement::windup_share:
    case Requirement::thermal_growth_share:
    case Requirement::belt_stretch_share:
    case Requirement::resolution_fraction:
    case Requirement::guide_shaft_deflection_ratio:
    case Requirement::frame_deflection_ratio:
    case Requirement::column_factor:
    case Requirement::fatigue_reliability_factor:
    case Requirement::bolt_preload_fraction:
    case Requirement::spindle_power_factor:
      return Side::share;
    case Requirement::brake_factor:
    case Requirement::screw_safety_factor:
    case Requirement::screw_shear_safety_factor:
    case Requirement::thread_safety_factor:
    case Requirement::self_locking_factor:
    case Requirement::static_safety:
    case Requirement::fatigue_load_factor:
    case Requirement::supply_reserve:
    case Requirement::coupling_shock_factor:
    case Requirement::belt_service_factor:
    case Requirement::belt_preload_fraction:
    case Requirement::resonance_distance:
    case Requirement::torsional_frequency_factor:
    case Requirement::guide_static_safety:
    case Requirement::guide_load_factor:
    case Requirement::guide_shaft_safety_factor:
    case Requirement::frame_safety_factor:
    case Requirement::shaft_safety_factor:
    case Requirement::bushing_binding_factor:
    case Requirement::fatigue_safety_factor:
    case Requirement::bolt_proof_safety:
    case Requirement::bolt_separation_safety:
    case Requirement::bolt_slip_safety:
    case Requirement::bolt_shear_safety_factor:
      return Side::safety;
    default:
      return Side::any;
  }
}

Looser looser_side(Requirement requirement) {
  switch (requirement) {
    case Requirement::torque_margin:
    case Requirement::torque_margin_estimate:
    case Requirement::load_torque_factor:
    case Requirement::inertia_ratio:
    case Requirement::rms_torque_factor:
    case Requirement::step_rate:
    case Requirement::step_rate_factor:
    case Requirement::holding_factor:
    case Requirement::detent_factor:
    case Requirement::bearing_pressure_factor:
    case Requirement::pv_factor:
    case Requirement::buckling_factor:
    case Requirement::critical_speed_factor:
    case Requirement::twist_per_length:
    case Requirement::permissible_axial_stress:
    case Requirement::driver_voltage_factor:
    case Requirement::position_error:
    case Requirement::lost_motion:
    case Requirement::resolution_fraction:
    case Requirement::angle_error:
    case Requirement::lost_angle:
    case Requirement::start_rate_factor:
    case Requirement::winding_temperature_rise:
    case Requirement::output_power_factor:
    case Requirement::motor_radial_load:
    case Requirement::nut_wear_fraction:
    case Requirement::largest_preload_fraction:
    case Requirement::lead_error_share:
    case Requirement::thermal_growth_share:
    case Requirement::windup_share:
    case Requirement::belt_stretch_share:
    case Requirement::guide_shaft_deflection_ratio:
    case Requirement::frame_deflection_ratio:
    case Requirement::column_factor:
    case Requirement::weld_stress:
    case Requirement::bushing_slope:
    case Requirement::bushing_slope_self_aligning:
    case Requirement::frame_twist:
    case Requirement::ringing_amplitude:
    case Requirement::spindle_power_factor:
      return Looser::larger;
    case Requirement::brake_factor:
    case Requirement::screw_safety_factor:
    case Requirement::screw_shear_safety_factor:
    case Requirement::thread_safety_factor:
    case Requirement::self_locking_factor:
    case Requirement::life:
    case Requirement::static_safety:
    case Requirement::supply_reserve:
    case Requirement::coupling_shock_factor:
    case Requirement::belt_service_factor:
    case Requirement::belt_teeth_in_mesh:
    case Requirement::belt_frequency:
    case Requirement::efficiency:
    case Requirement::axial_stiffness:
    case Requirement::resonance_distance:
    case Requirement::torsional_frequency_factor:
    case Requirement::coupling_parallel_misalignment:
    case Requirement::coupling_angular_misalignment:
    case Requirement::coupling_axial_misalignment:
    case Requirement::reduction_service_factor:
    case Requirement::guide_static_safety:
    case Requirement::guide_shaft_safety_factor:
    case Requirement::frame_safety_factor:
    case Requirement::shaft_safety_factor:
    case Requirement::bushing_binding_factor:
    case Requirement::frame_natural_frequency:
    case Requirement::fatigue_safety_factor:
    case Requirement::bolt_proof_safety:
    case Requirement::bolt_separation_safety:
    case Requirement::bolt_slip_safety:
    case Requirement::bolt_shear_safety_factor:
      return Looser::smaller;
    // What is set or taken for granted (currents, preloads, shocks, travel, wear) and masses that are allowed for:
    // more of them helps one check and harms another.
    case Requirement::fatigue_load_factor:
    case Requirement::current_factor:
    case Requirement::overtravel:
    case Requirement::nut_mass_allowance:
    case Requirement::belt_mass_allowance:
    case Requirement::position_error_over:
    case Requirement::belt_preload_fraction:
    case Requirement::rack_drive_mass_allowance:
    case Requirement::start_rate:
    case Requirement::rated_temperature_rise:
    case Requirement::load_sharing_turns:
    case Requirement::nut_wear_rate:
    case Requirement::mapped_lead_error:
    case Requirement::screw_temperature_rise:
    case Requirement::rotating_nut_mass_allowance:
    case Requirement::guide_load_factor:
    case Requirement::fatigue_reliability_factor:
    case Requirement::bolt_preload_fraction:
    case Requirement::count_:
      break;
  }
  return Looser::neither;
}

}  // namespace millwright::machine
