// SPDX-License-Identifier: Apache-2.0
//
// The constraints of a structure member, each declared once (see constraint.h).
#pragma once

#include "machine/member_dynamics.h"
#include "machine/structure_member.h"

namespace millwright::machine {

/// Whether a member is judged by the bending of a frame and not as a guide shaft.
inline bool bends_as_frame(const Member& member) {
  return member.kind != MemberKind::column && member.kind != MemberKind::weld && !member.is_guide;
}

/// The checks of strength and stiffness that every compliant design passes.
template <class Visit>
void member_strength_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  constexpr auto bends = [](const auto& d) { return d.is(bends_as_frame(d.data->member)); };
  constexpr auto guides = [](const auto& d) { return d.is(d.data->member.is_guide); };
  visit(
      Declaration{.id = "C-FR-STRESS",
                  .title = "Stress of the frame member",
                  .symbol = "σ",
                  .unit = "MPa",
                  .source = "khurmi_gupta2005, chapter 5; fdm_printer, eq. 6",
                  .requirement = "frame_safety_factor",
                  .place = WorstPlace::most_bent},
      bends,
      [](const auto& d) { return d.stress; },
      [](const auto& d) {
        return mechanics::material::allowable_stress(d.yield_strength(), d.require(frame_safety_factor));
      });
  visit(
      Declaration{.id = "C-FR-DEFL",
                  .title = "Deflection of the frame member",
                  .symbol = "δ",
                  .unit = "mm",
                  .source = "shigley, Table A-9; slocum1992",
                  .requirement = "frame_deflection_ratio",
                  .place = WorstPlace::mid_span},
      bends,
      [](const auto& d) { return d.deflection; },
      [](const auto& d) { return d.require(frame_deflection_ratio) * d.length(); });
  visit(
      Declaration{.id = "C-GD-STRESS",
                  .title = "Guide shaft bending stress",
                  .symbol = "σ",
                  .unit = "MPa",
                  .source = "torch_table, eq. 13 and 14",
                  .requirement = "guide_shaft_safety_factor",
                  .place = WorstPlace::most_bent},
      guides,
      [](const auto& d) { return d.stress; },
      [](const auto& d) {
        return mechanics::material::allowable_stress(d.yield_strength(), d.require(guide_shaft_safety_factor));
      });
  visit(
      Declaration{.id = "C-GD-DEFL",
                  .title = "Guide shaft deflection",
                  .symbol = "δ",
                  .unit = "mm",
                  .source = "shigley, Table A-9",
                  .requirement = "guide_shaft_deflection_ratio",
                  .place = WorstPlace::mid_span},
      guides,
      [](const auto& d) { return d.deflection; },
      [](const auto& d) { return d.require(guide_shaft_deflection_ratio) * d.length(); });
  visit(
      Declaration{.id = "C-SH-DIAM",
                  .title = "Shaft diameter against the required one",
                  .symbol = "d",
                  .unit = "mm",
                  .source = "torch_table, eq. 14; khurmi_gupta2005, section 14.11",
                  .requirement = "shaft_safety_factor",
                  .place = WorstPlace::most_bent},
      [](const auto& d) { return d.is(d.data->member.kind == MemberKind::round_shaft); },
      [](const auto& d) {
        // A shaft that stands bears what is put on it once, and gradually.
        const auto factor = [&](Requirement of_rotating) {
          using Factor = decltype(d.require(of_rotating));
          return d.data->member.rotating ? d.require(of_rotating) : Factor(1.0);
        };
        return mechanics::shaft::required_diameter_von_mises(
            d.resultant_moment(),
            in_unit_like(d.mass, d.data->member.torque / d.data->member.count, dimension::torque),
            factor(shaft_bending_factor),
            factor(shaft_torsion_factor),
            mechanics::material::allowable_stress(d.yield_strength(), d.require(shaft_safety_factor)));
      },
      [](const auto& d) { return d.diameter; });
  visit(
      Declaration{.id = "C-FR-BUCK",
                  .title = "Column buckling",
                  .symbol = "F",
                  .unit = "N",
                  .source = "fdm_printer, eq. 8; khurmi_gupta2005, chapter 16",
                  .requirement = "column_factor"},
      [](const auto& d) {
        return d.is(d.data->member.kind == MemberKind::column || d.data->member.kind == MemberKind::portal_frame);
      },
      [](const auto& d) { return d.axial_force; },
      [](const auto& d) {
        return d.require(column_factor) * mechanics::column::critical_load(decltype(d.mass)(d.data->member.end_fixity),
                                                                           d.elastic_modulus(),
                                                                           d.yield_strength(),
                                                                           d.section.area,
                                                                           d.section.least_second_moment,
                                                                           d.column_length());
      });
  visit(
      Declaration{.id = "C-WELD",
                  .title = "Weld stress on the throat",
                  .symbol = "τ",
                  .unit = "MPa",
                  .source = "khurmi_gupta2005, chapter 10",
                  .requirement = "weld_stress"},
      [](const auto& d) { return d.is(d.data->member.kind == MemberKind::weld); },
      [](const auto& d) { return d.stress; },
      [](const auto& d) { return d.require(weld_stress, dimension::pressure); });
}

/// The checks of a portal frame as a whole.
template <class Visit>
void portal_constraints(Visit&& visit) {
  using enum Requirement;
  constexpr auto portal = [](const auto& d) { return d.is(d.data->member.kind == MemberKind::portal_frame); };
  visit(
      Declaration{.id = "C-FR-SWAY",
                  .title = "Lateral deflection of the portal frame",
                  .symbol = "δ_s",
                  .unit = "mm",
                  .source = "millwright_derivations, slope-deflection of a clamped portal; slocum1992",
                  .requirement = "frame_deflection_ratio"},
      portal,
      [](const auto& d) { return d.sway; },
      [](const auto& d) { return d.require(frame_deflection_ratio) * d.column_length(); });
  visit(
      Declaration{.id = "C-FR-COLUMN",
                  .title = "Stress in the columns of the portal frame",
                  .symbol = "σ_c",
                  .unit = "MPa",
                  .source = "millwright_derivations, slope-deflection of a clamped portal; khurmi_gupta2005, chapter 5",
                  .requirement = "frame_safety_factor"},
      portal,
      [](const auto& d) { return d.column_stress; },
      [](const auto& d) {
        return mechanics::material::allowable_stress(d.yield_strength(), d.require(frame_safety_factor));
      });
}

/// Twist, natural frequency and fatigue: made where the problem says what is needed.
template <class Visit>
void member_dynamics_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  visit(
      Declaration{.id = "C-FR-TWIST",
                  .title = "Twist of the frame member",
                  .symbol = "θ",
                  .unit = "deg",
                  .kind = ConstraintKind::soft,
                  .source = "khurmi_gupta2005, chapter 5",
                  .requirement = "frame_twist"},
      [](const auto& d) { return d.is(d.data->member.torque > 0.0 && d.data->require.known(frame_twist)); },
      [](const auto& d) { return twist(d); },
      [](const auto& d) { return d.require(frame_twist); });
  visit(
      Declaration{.id = "C-FR-FREQ",
                  .title = "First natural frequency of the frame member",
                  .symbol = "f_1",
                  .unit = "Hz",
                  .kind = ConstraintKind::soft,
                  .source = "machine_frame_lab; blevins",
                  .requirement = "frame_natural_frequency"},
      [](const auto& d) {
        return d.is(bends_as_frame(d.data->member) &&
                    (d.data->require.known(frame_natural_frequency) || d.data->require.known(ringing_amplitude)));
      },
      [](const auto& d) { return required_frequency(d); },
      [](const auto& d) { return natural_frequency(d); });
  visit(
      Declaration{.id = "C-SH-FAT",
                  .title = "Fatigue of the rotating shaft, after Goodman",
                  .symbol = "n_f",
                  .unit = "1",
                  .source = "shigley, sections 6-7 and 6-12",
                  .requirement = "fatigue_safety_factor",
                  .place = WorstPlace::most_bent},
      [](const auto& d) { return d.is(d.data->member.rotating); },
      [](const auto& d) { return d.require(fatigue_safety_factor); },
      [](const auto& d) { return fatigue_safety(d); });
}

template <class Visit>
void member_constraints(Visit&& visit) {
  member_strength_constraints(visit);
  portal_constraints(visit);
  member_dynamics_constraints(visit);
}

}  // namespace millwright::machine
