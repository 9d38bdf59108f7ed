// SPDX-License-Identifier: Apache-2.0
//
// A member of the structure: a shaft, bar, beam, column or weld that carries an axis, of a catalogue section or with
// free dimensions. Loads: its share of the carried weight, an extra force, a lateral force (two planes are added
// vectorially) and its own weight.
#pragma once

#include "machine/constraint.h"
#include "machine/motor_constraints.h"
#include "machine/problem.h"
#include "mechanics/actuation.h"
#include "mechanics/beam.h"
#include "mechanics/column.h"
#include "mechanics/guide.h"
#include "mechanics/material.h"
#include "mechanics/section.h"
#include "mechanics/section_stress.h"
#include "mechanics/shaft.h"
#include "mechanics/weld.h"

namespace millwright::machine {

/// A cross-section: from the catalogue, or from free dimensions.
template <class T>
struct SectionReading {
  T area{}, strong_second_moment{}, weak_second_moment{}, height{}, width{}, mass_per_length{};
};

template <class Reading, class Visit>
void visit_section_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.area, &r.strong_second_moment, &r.weak_second_moment, &r.height, &r.width, &r.mass_per_length})
    visit(*field);
}
inline constexpr std::size_t section_reading_fields = 6;

struct MemberData {
  Member member;
  Requirements require;
  double riding_mass = 0.0;  ///< kg, allowance for the nut or belt of the axis that it carries
  double elastic_modulus = 0.0, yield_strength = 0.0, density = 0.0, price_per_mass = 0.0;
};

template <class T>
struct StructureMember {
  const MemberData* data = nullptr;
  SectionReading<T> section;
  T carried_mass{};
  T diameter{}, width{}, height{}, leg{};  ///< free dimensions of its kind

  T mass{};   ///< kg, all members of the group
  T force{};  ///< N, on one member
  T moment{}, lateral_moment{};
  T deflection{}, stress{};

  [[nodiscard]] T require(Requirement requirement, const scalar::Dimension& dimension = scalar::dimension::none) const {
    return scalar::in_unit<T>(data->require(requirement), dimension);
  }
  [[nodiscard]] Applies is(bool condition) const { return condition ? Applies::yes : Applies::no; }
  [[nodiscard]] T length() const { return scalar::in_unit<T>(data->member.length, scalar::dimension::length); }
  [[nodiscard]] T elastic_modulus() const {
    return scalar::in_unit<T>(data->elastic_modulus, scalar::dimension::pressure);
  }
  [[nodiscard]] T yield_strength() const {
    return scalar::in_unit<T>(data->yield_strength, scalar::dimension::pressure);
  }
  /// Of both planes: what a round section feels.
  [[nodiscard]] T resultant_moment() const {
    using namespace scalar;
    return data->member.lateral_force == 0.0 ? moment : sqrt(square(moment) + square(lateral_moment));
  }
  void derive();

 private:
  void take_section();
  T deflection_of(const T& point, const T& distributed, const T& second_moment) const;
  T moment_of(const T& point, const T& distributed) const;
  void derive_bending();
};

template <class T>
void StructureMember<T>::take_section() {
  using namespace scalar;
  namespace sec = mechanics::section;
  const T hollow = in_unit<T>(0.0, dimension::length);
  const T density =
      in_unit<T>(data->density, dimension::mass / (dimension::length * dimension::length * dimension::length));
  if (data->member.kind == MemberKind::round_shaft) {
    section.area = named("A", 0.25 * pi<T>() * square(diameter));
    section.strong_second_moment = section.weak_second_moment = named("I", sec::round_second_moment(diameter, hollow));
    section.height = section.width = diameter;
    section.mass_per_length = density * section.area;
  } else if (data->member.kind == MemberKind::rectangular_bar) {
    section.area = named("A", width * height);
    section.strong_second_moment = named("I_y", sec::rectangle_second_moment(width, height));
    section.weak_second_moment = named("I_z", sec::rectangle_second_moment(height, width));
    section.height = height;
    section.width = width;
    section.mass_per_length = density * section.area;
  }
}

template <class T>
T StructureMember<T>::moment_of(const T& point, const T& distributed) const {
  namespace bm = mechanics::beam;
  using bm::LoadCase;
  const T total = distributed * length();
  switch (data->member.support) {
    case BeamSupport::cantilever:
      return bm::largest_moment(LoadCase::cantilever_point, point, length()) +
             bm::largest_moment(LoadCase::cantilever_distributed, total, length());
    case BeamSupport::fixed:
      return bm::largest_moment(LoadCase::fixed_point, point, length()) +
             bm::largest_moment(LoadCase::fixed_distributed, total, length());
    case BeamSupport::supported:
      break;
  }
  return bm::largest_moment(LoadCase::supported_point, point, length()) +
         bm::largest_moment(LoadCase::supported_distributed, total, length());
}

template <class T>
T StructureMember<T>::deflection_of(const T& point, const T& distributed, const T& second_moment) const {
  namespace bm = mechanics::beam;
  const T E = elastic_modulus();
  switch (data->member.support) {
    case BeamSupport::cantilever:
      return bm::cantilever_tip_deflection(point, length(), E, second_moment) +
             bm::cantilever_tip_deflection_distributed(distributed, length(), E, second_moment);
    case BeamSupport::fixed:
      return bm::fixed_deflection(point, length(), E, second_moment) +
             bm::fixed_deflection_distributed(distributed, length(), E, second_moment);
    case BeamSupport::supported:
      break;
  }
  return bm::supported_deflection(point, length(), E, second_moment) +
         bm::supported_deflection_distributed(distributed, length(), E, second_moment);
}

template <class T>
void StructureMember<T>::derive_bending() {
  using namespace scalar;
  const T gravity = in_unit<T>(standard_gravity, dimension::acceleration);
  const T own = section.mass_per_length * gravity;
  const T no_load = in_unit<T>(0.0, dimension::force / dimension::length);
  const T lateral = in_unit<T>(data->member.lateral_force / data->member.count, dimension::force);
  moment = named("M", moment_of(force, own));
  lateral_moment = named("M_z", moment_of(lateral, no_load));
  const T down = deflection_of(force, own, section.strong_second_moment);
  const T stress_down = mechanics::section::bending_stress(moment, section.strong_second_moment, 0.5 * section.height);
  if (data->member.lateral_force == 0.0) {
    deflection = named("δ", down);
    stress = named("σ", stress_down);
    return;
  }
  const T sideways = deflection_of(lateral, no_load, section.weak_second_moment);
  deflection = named("δ", sqrt(square(down) + square(sideways)));
  const T stress_sideways =
      mechanics::section::bending_stress(lateral_moment, section.weak_second_moment, 0.5 * section.width);
  // A round section has its two maxima on different fibres; adding them is safe.
  stress = named("σ", stress_down + stress_sideways);
}

template <class T>
void StructureMember<T>::derive() {
  using namespace scalar;
  const Member& m = data->member;
  const T burden = carried_mass + in_unit<T>(data->riding_mass, dimension::mass);
  const T weight = burden * in_unit<T>(standard_gravity, dimension::acceleration);
  force = named("F", (m.load_share * weight + in_unit<T>(m.extra_force, dimension::force)) / m.count);
  take_section();
  if (m.kind == MemberKind::weld) {
    // Two legs' worth of triangle along the joint.
    const T joint = in_unit<T>(2.0 * (m.joint_width + m.joint_depth), dimension::length);
    mass = m.count * 0.5 * square(leg) * joint *
           in_unit<T>(data->density, dimension::mass / (dimension::length * dimension::length * dimension::length));
    const T throat = named("t", mechanics::weld::throat(leg));
    const T modulus = mechanics::weld::rectangle_section_modulus(
        throat, in_unit<T>(m.joint_width, dimension::length), in_unit<T>(m.joint_depth, dimension::length));
    moment = named("M", force * in_unit<T>(m.lever_arm, dimension::length));
    stress = named(
        "τ",
        mechanics::weld::combined_stress(
            mechanics::weld::direct_stress(force, leg, joint), moment / modulus, in_unit<T>(0.0, dimension::pressure)));
    return;
  }
  mass = named("m_b", m.count * section.mass_per_length * length());
  if (m.kind != MemberKind::column) derive_bending();
}

template <class Visit>
void member_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  constexpr auto bends = [](const auto& d) {
    return d.is(d.data->member.kind != MemberKind::column && d.data->member.kind != MemberKind::weld &&
                !d.data->member.is_guide);
  };
  constexpr auto guides = [](const auto& d) { return d.is(d.data->member.is_guide); };
  visit(
      Declaration{.id = "C-FR-STRESS",
                  .title = "Bending stress of the frame member",
                  .symbol = "σ",
                  .unit = "MPa",
                  .source = "khurmi_gupta2005, chapter 5; fdm_printer, eq. 6",
                  .requirement = "frame_safety_factor"},
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
                  .requirement = "frame_deflection_ratio"},
      bends,
      [](const auto& d) { return d.deflection; },
      [](const auto& d) { return d.require(frame_deflection_ratio) * d.length(); });
  visit(
      Declaration{.id = "C-GD-STRESS",
                  .title = "Guide shaft bending stress",
                  .symbol = "σ",
                  .unit = "MPa",
                  .source = "torch_table, eq. 13 and 14",
                  .requirement = "guide_shaft_safety_factor"},
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
                  .requirement = "guide_shaft_deflection_ratio"},
      guides,
      [](const auto& d) { return d.deflection; },
      [](const auto& d) { return d.require(guide_shaft_deflection_ratio) * d.length(); });
  visit(
      Declaration{.id = "C-SH-DIAM",
                  .title = "Shaft diameter against the required one",
                  .symbol = "d",
                  .unit = "mm",
                  .source = "torch_table, eq. 14; khurmi_gupta2005, section 14.11",
                  .requirement = "shaft_safety_factor"},
      [](const auto& d) { return d.is(d.data->member.kind == MemberKind::round_shaft); },
      [](const auto& d) {
        const auto one = decltype(d.mass)(1.0);
        return mechanics::shaft::required_diameter_von_mises(
            d.resultant_moment(),
            in_unit_like(d.mass, 0.0, dimension::torque),
            one,
            one,
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
      [](const auto& d) { return d.is(d.data->member.kind == MemberKind::column); },
      [](const auto& d) { return d.force; },
      [](const auto& d) {
        return d.require(column_factor) * mechanics::column::critical_load(decltype(d.mass)(d.data->member.end_fixity),
                                                                           d.elastic_modulus(),
                                                                           d.yield_strength(),
                                                                           d.section.area,
                                                                           d.section.weak_second_moment,
                                                                           d.length());
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

}  // namespace millwright::machine
