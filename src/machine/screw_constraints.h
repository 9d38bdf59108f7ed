// SPDX-License-Identifier: Apache-2.0
//
// Constraints of a screw with its nut, each declared once (see constraint.h): what every screw must hold, and sliding
// nuts; ball screws are in ball_screw_constraints.h. `visit(declaration, applies, demand, capacity)`.
#pragma once

#include "machine/motor_constraints.h"
#include "machine/screw_drive_quantities.h"

namespace millwright::machine {

inline constexpr auto when_sliding = [](const auto& d) { return d.sliding(); };

/// Travel, time, and strength of the core: every screw.
template <class Visit>
void screw_shaft_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  namespace ps = mechanics::power_screw;
  visit(
      Declaration{.id = "C-SYS-TRAVEL",
                  .title = "Usable travel",
                  .symbol = "s",
                  .unit = "mm",
                  .source = "millwright_derivations, usable travel",
                  .requirement = "overtravel"},
      always,
      [](const auto& d) {
        return in_unit_like(d.screw.lead, d.data->stroke + 2.0 * d.data->require(overtravel), dimension::length);
      },
      [](const auto& d) { return d.screw.travel; });
  move_time_constraint(visit);
  visit(
      Declaration{.id = "C-SCR-VM",
                  .title = "Core stress, von Mises",
                  .symbol = "σ_v",
                  .unit = "MPa",
                  .source = "shigley, section 5-5",
                  .requirement = "screw_safety_factor",
                  .worst = WorstPhase::force},
      always,
      [](const auto& d) { return ps::von_mises_stress(d.largest_force, d.screw_torque, d.screw.root_diameter); },
      [](const auto& d) {
        return mechanics::material::allowable_stress(d.screw.yield_strength, d.require(screw_safety_factor));
      });
  visit(
      Declaration{.id = "C-SCR-TMAX",
                  .title = "Core stress, maximum shear",
                  .symbol = "τ_max",
                  .unit = "MPa",
                  .source = "torch_table, eq. 21 to 23",
                  .requirement = "screw_shear_safety_factor",
                  .worst = WorstPhase::force},
      always,
      [](const auto& d) { return ps::maximum_shear_stress(d.largest_force, d.screw_torque, d.screw.root_diameter); },
      [](const auto& d) {
        return mechanics::material::von_mises_shear_yield(d.screw.yield_strength) /
               d.require(screw_shear_safety_factor);
      });
  visit(
      Declaration{.id = "C-SCR-SIGMA",
                  .title = "Core stress, maximum principal",
                  .symbol = "σ_max",
                  .unit = "MPa",
                  .source = "torch_table, eq. 20 and 22",
                  .requirement = "screw_shear_safety_factor",
                  .worst = WorstPhase::force},
      always,
      [](const auto& d) {
        return ps::maximum_principal_stress(d.largest_force, d.screw_torque, d.screw.root_diameter);
      },
      [](const auto& d) {
        return mechanics::material::allowable_stress(d.screw.yield_strength, d.require(screw_shear_safety_factor));
      });
  visit(
      Declaration{.id = "C-SCR-DC",
                  .title = "Core diameter, first sizing without torsion",
                  .symbol = "d_c",
                  .unit = "mm",
                  .source = "torch_table, eq. 15",
                  .requirement = "screw_shear_safety_factor",
                  .worst = WorstPhase::force,
                  .implied_by = "C-SCR-SIGMA"},  // the largest principal stress is at least the direct stress
      always,
      [](const auto& d) {
        return ps::required_core_diameter(
            d.largest_force, d.require(screw_shear_safety_factor), d.screw.yield_strength);
      },
      [](const auto& d) { return d.screw.root_diameter; });
  visit(
      Declaration{.id = "C-SCR-EFF",
                  .title = "Efficiency of the screw",
                  .symbol = "η",
                  .unit = "1",
                  .kind = ConstraintKind::soft,
                  .source = "khurmi_gupta2005, section 17.6; thk_catalogue, efficiency",
                  .requirement = "efficiency"},
      [](const auto& d) { return d.data->require.known(efficiency) ? Applies::yes : Applies::no; },
      [](const auto& d) { return d.require(efficiency); },
      [](const auto& d) { return d.screw.efficiency; });
  visit(
      Declaration{.id = "C-SCR-TWIST",
                  .title = "Twist of the screw",
                  .symbol = "θ",
                  .unit = "deg",
                  .source = "sularso_suga, shafts; mini_mill, eq. 19",
                  .requirement = "twist_per_length",
                  .worst = WorstPhase::force,
                  .place = WorstPlace::nut_far},
      always,
      [](const auto& d) {
        return ps::torsional_windup(
            d.screw_torque, d.screw.supported_length, d.screw.shear_modulus, d.screw.root_diameter);
      },
      [](const auto& d) {
        return d.require(twist_per_length, dimension::none / dimension::length) * d.screw.supported_length;
      });
}

/// Thread, stability and speed of a lead screw with a sliding nut.
template <class Visit>
void sliding_screw_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  namespace ps = mechanics::power_screw;
  visit(
      Declaration{.id = "C-SCR-PB",
                  .title = "Thread bearing pressure",
                  .symbol = "p_b",
                  .unit = "MPa",
                  .source = "khurmi_gupta2005, section 17.13",
                  .requirement = "bearing_pressure_factor",
                  .worst = WorstPhase::force},
      when_sliding,
      [](const auto& d) { return bearing_pressure(d, d.largest_force); },
      [](const auto& d) { return d.require(bearing_pressure_factor) * d.screw.allowable_pressure; });
  visit(
      Declaration{.id = "C-SCR-PV",
                  .title = "Nut pressure times sliding speed",
                  .symbol = "PV",
                  .unit = "MPa.m/s",
                  .source = "thomson_pv",
                  .requirement = "pv_factor",
                  .worst = WorstPhase::driven_force},
      when_sliding,
      [](const auto& d) { return ps::pressure_velocity(bearing_pressure(d, d.driven_force), sliding_speed(d)); },
      [](const auto& d) { return d.require(pv_factor) * d.screw.pv_limit; });
  visit(
      Declaration{.id = "C-SCR-VS",
                  .title = "Nut sliding speed",
                  .symbol = "v_s",
                  .unit = "m/s",
                  .source = "thomson_pv; millwright_derivations, sliding speed",
                  .requirement = "pv_factor",
                  .worst = WorstPhase::speed},
      when_sliding,
      [](const auto& d) { return sliding_speed(d); },
      [](const auto& d) { return d.require(pv_factor) * d.screw.sliding_speed_limit; });
  visit(
      Declaration{.id = "C-SCR-SHS",
                  .title = "Thread shear, screw",
                  .symbol = "τ_s",
                  .unit = "MPa",
                  .source = "khurmi_gupta2005, section 17.13",
                  .requirement = "thread_safety_factor",
                  .worst = WorstPhase::force},
      when_sliding,
      [](const auto& d) {
        return ps::thread_shear_stress(
            d.largest_force, d.screw.root_diameter, d.screw.screw_root_thickness, d.screw.engaged_turns);
      },
      [](const auto& d) {
        return mechanics::material::von_mises_shear_yield(d.screw.yield_strength) / d.require(thread_safety_factor);
      });
  visit(
      Declaration{.id = "C-SCR-SHN",
                  .title = "Thread shear, nut",
                  .symbol = "τ_n",
                  .unit = "MPa",
                  .source = "khurmi_gupta2005, section 17.13",
                  .requirement = "thread_safety_factor",
                  .worst = WorstPhase::force},
      when_sliding,
      [](const auto& d) {
        return ps::thread_shear_stress(
            d.largest_force, d.screw.nut_thread_diameter, d.screw.nut_root_thickness, d.screw.engaged_turns);
      },
      [](const auto& d) {
        return mechanics::material::von_mises_shear_yield(d.screw.nut_yield_strength) / d.require(thread_safety_factor);
      });
  visit(
      Declaration{.id = "C-SCR-BEND",
                  .title = "Thread bending, screw",
                  .symbol = "σ_b",
                  .unit = "MPa",
                  .source = "shigley, eq. 8-11",
                  .requirement = "thread_safety_factor",
                  .worst = WorstPhase::force},
      when_sliding,
      [](const auto& d) {
        return ps::thread_bending_stress(d.largest_force,
                                         d.screw.root_diameter,
                                         d.screw.thread_depth,
                                         d.screw.screw_root_thickness,
                                         d.screw.engaged_turns);
      },
      [](const auto& d) {
        return mechanics::material::allowable_stress(d.screw.yield_strength, d.require(thread_safety_factor));
      });
  visit(
      Declaration{.id = "C-SCR-NTURNS",
                  .title = "Turns of the nut that share the load",
                  .symbol = "n",
                  .unit = "1",
                  .kind = ConstraintKind::soft,
                  .source = "khurmi_gupta2005, section 17.13",
                  .requirement = "load_sharing_turns"},
      when_sliding,
      [](const auto& d) { return d.screw.nut_turns; },
      [](const auto& d) { return d.require(load_sharing_turns); });
  visit(
      Declaration{.id = "C-SCR-WEAR",
                  .title = "Travel until the nut is worn, order of magnitude",
                  .symbol = "s",
                  .unit = "km",
                  .kind = ConstraintKind::soft,
                  .source = "tribology_abc; millwright_derivations, wear of a nut",
                  .requirement = "nut_wear_fraction",
                  .worst = WorstPhase::cycle},
      when_sliding,
      [](const auto& d) { return d.require(life, dimension::time) * d.cycle.travelled / d.cycle.total_time; },
      [](const auto& d) { return wear_travel(d); });
  visit(
      Declaration{.id = "C-SCR-BUCK",
                  .title = "Screw buckling",
                  .symbol = "F",
                  .unit = "N",
                  .source = "khurmi_gupta2005, section 16.4",
                  .requirement = "buckling_factor",
                  .worst = WorstPhase::force,
                  .place = WorstPlace::nut_far},
      when_sliding,
      [](const auto& d) { return d.largest_force; },
      [](const auto& d) { return d.require(buckling_factor) * d.screw.buckling_load; });
  visit(
      Declaration{.id = "C-SCR-NCRIT",
                  .title = "Screw critical speed",
                  .symbol = "ω",
                  .unit = "rpm",
                  .source = "thk_catalogue, permissible speed",
                  .requirement = "critical_speed_factor",
                  .worst = WorstPhase::speed,
                  .place = WorstPlace::nut_far},
      [](const auto& d) { return d.data->nut_rotates ? Applies::no : d.sliding(); },
      [](const auto& d) { return d.screw_speed; },
      [](const auto& d) { return d.require(critical_speed_factor) * d.screw.critical_speed; });
  visit(
      Declaration{.id = "C-SCR-LOCK",
                  .title = "Self-locking or braked",
                  .symbol = "u",
                  .unit = "1",
                  .source = "khurmi_gupta2005, section 17.9",
                  .requirement = "self_locking_factor",
                  .worst = WorstPhase::standstill},
      [](const auto& d) { return d.data->vertical ? d.sliding() : Applies::no; },
      [](const auto& d) { return unlocked_ratio(d); },
      [](const auto& d) { return 1.0 / d.require(self_locking_factor); });
}

}  // namespace millwright::machine
