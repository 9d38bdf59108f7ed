// SPDX-License-Identifier: Apache-2.0
//
// A member of the structure: a shaft, bar, beam, plate, column, portal frame or weld that carries an axis, of a
// catalogue section or with free dimensions. Loads: its share of the carried weight, an extra force, a lateral force
// (two planes are added vectorially) and its own weight.
//
// A plate bends as a strip between its two rails; the load is spread along the rails, so that what happens close around
// a single foot on it is not covered. A portal frame has two columns and a beam of one section, clamped at the feet.
#pragma once

#include <algorithm>

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

/// A cross-section: from the catalogue, or from free dimensions. Second moments and section moduli are those that it
/// bends with under a load over its height (strong) or its width (weak).
template <class T>
struct SectionReading {
  T area{}, strong_second_moment{}, weak_second_moment{};
  T least_second_moment{};  ///< about whichever axis: a column buckles and a beam swings that way
  T strong_section_modulus{}, weak_section_modulus{};
  T height{}, width{}, mass_per_length{};
  T elastic_modulus{}, yield_strength{};  ///< of what it is made of
  T torsion_width{};                      ///< times torque over torsion constant: the largest shear stress, or more
  T torsion_constant{};                   ///< NaN where the catalogue has none
  T shear_modulus{};                      ///< NaN where the catalogue has none
};

template <class Reading, class Visit>
void visit_section_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.area,
                      &r.strong_second_moment,
                      &r.weak_second_moment,
                      &r.least_second_moment,
                      &r.strong_section_modulus,
                      &r.weak_section_modulus,
                      &r.height,
                      &r.width,
                      &r.mass_per_length,
                      &r.elastic_modulus,
                      &r.yield_strength,
                      &r.torsion_width,
                      &r.torsion_constant,
                      &r.shear_modulus})
    visit(*field);
}
inline constexpr std::size_t section_reading_fields = 14;
inline constexpr std::size_t section_readings_needed = 12;  ///< the last two are for what twists only

/// A plate wider than this times its span does not help a load in its middle any more: its deflection there tends to
/// 0.01695 F L²/D, that of a strip of 1.229 L [timoshenko_plates, Table 23].
inline constexpr double plate_effective_width = 1.229;

struct MemberData {
  Member member;
  Requirements require;
  double riding_mass = 0.0;  ///< kg, allowance for the nut or belt of the axis that it carries
  double elastic_modulus = 0.0, yield_strength = 0.0, density = 0.0, price_per_mass = 0.0;
  double shear_modulus = 0.0;          ///< NaN where the catalogue has none
  double ultimate_strength = 0.0;      ///< of a rotating shaft
  double endurance_limit = 0.0;        ///< Pa, of a polished rotating bar; 0 = steel, from its tensile strength
  double acceleration = 0.0;           ///< m/s^2, the hardest of the axis
  double climbing_acceleration = 0.0;  ///< m/s^2, what of it is upwards, with that of the axes that carry this one
  double lifting_acceleration = 0.0;   ///< m/s^2, of those alone
};

template <class T>
struct StructureMember {
  const MemberData* data = nullptr;
  SectionReading<T> section;
  T carried_mass{};
  T diameter{}, width{}, height{}, leg{}, thickness{};  ///< free dimensions of its kind

  T mass{};   ///< kg, all members of the group
  T force{};  ///< N, on one member
  T moment{}, lateral_moment{};
  T deflection{}, stress{};
  T axial_force{};            ///< N, in one column
  T sway{}, column_stress{};  ///< of a portal frame

  [[nodiscard]] T require(Requirement requirement, const scalar::Dimension& dimension = scalar::dimension::none) const {
    return scalar::in_unit<T>(data->require(requirement), dimension);
  }
  [[nodiscard]] Applies is(bool condition) const { return condition ? Applies::yes : Applies::no; }
  [[nodiscard]] T length() const { return scalar::in_unit<T>(data->member.length, scalar::dimension::length); }
  /// Height of a column, alone or of a portal frame.
  [[nodiscard]] T column_length() const {
    return data->member.kind == MemberKind::portal_frame
               ? scalar::in_unit<T>(data->member.column_height, scalar::dimension::length)
               : length();
  }
  [[nodiscard]] T lateral_force() const {
    return scalar::in_unit<T>(data->member.lateral_force / data->member.count, scalar::dimension::force);
  }
  /// At which the member itself is sped up upwards.
  [[nodiscard]] double own_climbing() const {
    return data->member.rides ? data->climbing_acceleration : data->lifting_acceleration;
  }
  /// Mass that one member carries.
  [[nodiscard]] T mass_on_member() const {
    return data->member.load_share / data->member.count *
           (carried_mass + scalar::in_unit<T>(data->riding_mass, scalar::dimension::mass));
  }
  [[nodiscard]] T elastic_modulus() const {
    return has_section() ? section.elastic_modulus
                         : scalar::in_unit<T>(data->elastic_modulus, scalar::dimension::pressure);
  }
  [[nodiscard]] T yield_strength() const {
    return has_section() ? section.yield_strength
                         : scalar::in_unit<T>(data->yield_strength, scalar::dimension::pressure);
  }
  [[nodiscard]] T shear_modulus() const {
    return has_section() ? section.shear_modulus : scalar::in_unit<T>(data->shear_modulus, scalar::dimension::pressure);
  }
  /// Of both planes: what a round section feels.
  [[nodiscard]] T resultant_moment() const {
    using namespace scalar;
    return data->member.lateral_force == 0.0 ? moment : sqrt(square(moment) + square(lateral_moment));
  }
  void derive();

 private:
  /// Cut of a section of the catalogue, which says what it is made of; not of the material by itself.
  [[nodiscard]] bool has_section() const {
    const MemberKind kind = data->member.kind;
    return kind == MemberKind::section_beam || kind == MemberKind::column || kind == MemberKind::portal_frame;
  }
  void take_section();
  T deflection_of(const T& point, const T& distributed, const T& second_moment, const T& bent_height) const;
  T moment_of(const T& point, const T& distributed) const;
  void add_twisting();
  void derive_bending();
  void derive_portal();
  void derive_weld();
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
    section.strong_second_moment = named("I", sec::round_second_moment(diameter, hollow));
    section.weak_second_moment = section.least_second_moment = section.strong_second_moment;
    section.height = section.width = diameter;
    section.mass_per_length = density * section.area;
    section.torsion_constant = named("J", sec::round_torsion_constant(diameter, hollow));
  } else if (data->member.kind == MemberKind::rectangular_bar) {
    section.area = named("A", width * height);
    section.strong_second_moment = named("I_y", sec::rectangle_second_moment(width, height));
    section.weak_second_moment = named("I_z", sec::rectangle_second_moment(height, width));
    section.height = height;
    section.width = width;
    section.mass_per_length = density * section.area;
    section.torsion_constant = named("J", sec::rectangle_torsion_constant(width, height));
    section.torsion_width = smaller(width, height);
  } else if (data->member.kind == MemberKind::plate) {
    const double whole = data->member.plate_width;
    const T strip = in_unit<T>(std::min(whole, plate_effective_width * data->member.length), dimension::length);
    section.area = named("A", in_unit<T>(whole, dimension::length) * thickness);
    section.strong_second_moment = named("I_y", sec::rectangle_second_moment(strip, thickness));
    section.weak_second_moment = named("I_z", sec::rectangle_second_moment(thickness, strip));
    section.height = thickness;
    section.width = strip;
    section.mass_per_length = density * section.area;
    section.torsion_constant = named("J", sec::rectangle_torsion_constant(strip, thickness));
  } else {
    return;  // of a catalogue's section
  }
  if (data->member.kind == MemberKind::round_shaft) {
    section.strong_section_modulus = named("W", sec::modulus(section.strong_second_moment, 0.5 * diameter));
    section.weak_section_modulus = section.strong_section_modulus;
    return;
  }
  section.least_second_moment = smaller(section.strong_second_moment, section.weak_second_moment);
  section.strong_section_modulus = named("W_y", sec::modulus(section.strong_second_moment, 0.5 * section.height));
  section.weak_section_modulus = named("W_z", sec::modulus(section.weak_second_moment, 0.5 * section.width));
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
      return bm::fixed_moment_of_travelling_load(point, length()) +
             bm::largest_moment(LoadCase::fixed_distributed, total, length());
    case BeamSupport::supported:
      break;
  }
  return bm::largest_moment(LoadCase::supported_point, point, length()) +
         bm::largest_moment(LoadCase::supported_distributed, total, length());
}

template <class T>
T StructureMember<T>::deflection_of(const T& point,
                                    const T& distributed,
                                    const T& second_moment,
                                    [[maybe_unused]] const T& bent_height) const {
  namespace bm = mechanics::beam;
  // Asked for its range only: the deflections know nothing of the height.
  if constexpr (mechanics::is_watched<T>) (void)bm::span_to_height(length(), bent_height);
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

/// Of a bar or a beam that is twisted as well. Of shafts C-SH-DIAM knows the torque.
template <class T>
void StructureMember<T>::add_twisting() {
  using namespace scalar;
  const bool twists = data->member.kind == MemberKind::rectangular_bar || data->member.kind == MemberKind::section_beam;
  if (!twists || data->member.torque == 0.0) return;
  // Between two held ends each bears half of it.
  const double part = data->member.support == BeamSupport::cantilever ? 1.0 : 0.5;
  const T torque = in_unit<T>(part * data->member.torque / data->member.count, dimension::torque);
  const T shear = named("τ", torque * section.torsion_width / section.torsion_constant);
  stress = named("σ_e", mechanics::section::stress_root(stress, shear));
}

template <class T>
void StructureMember<T>::derive_bending() {
  using namespace scalar;
  namespace sec = mechanics::section;
  const T own = pull_of_mass(section.mass_per_length, own_climbing());
  const T no_load = in_unit<T>(0.0, dimension::force / dimension::length);
  const T lateral = lateral_force();
  moment = named("M", moment_of(force, own));
  lateral_moment = named("M_z", moment_of(lateral, no_load));
  const T down = deflection_of(force, own, section.strong_second_moment, section.height);
  const T stress_down = sec::bending_stress_of_modulus(moment, section.strong_section_modulus);
  if (data->member.lateral_force == 0.0) {
    deflection = named("δ", down);
    stress = named("σ", stress_down);
    return add_twisting();
  }
  const T sideways = deflection_of(lateral, no_load, section.weak_second_moment, section.width);
  deflection = named("δ", sqrt(square(down) + square(sideways)));
  // A round section has its two maxima on different fibres; adding them is safe.
  stress = named("σ", stress_down + sec::bending_stress_of_modulus(lateral_moment, section.weak_section_modulus));
  add_twisting();
}

template <class T>
void StructureMember<T>::derive_portal() {
  using namespace scalar;
  namespace col = mechanics::column;
  namespace sec = mechanics::section;
  const T own = pull_of_mass(section.mass_per_length, own_climbing());
  const T lateral = lateral_force();
  const T rise = column_length();
  const T& second_moment = section.strong_second_moment;
  // Beam and columns are of one section.
  const T ratio = named("κ", T(data->member.column_height / data->member.length));
  // In its middle the beam is taken as supported; its corners bend by the load on it, which may stand anywhere, by its
  // own weight (lumped in its middle, which is safe) and by the sway.
  moment = named("M", moment_of(force, own));
  deflection = named("δ", deflection_of(force, own, second_moment, section.height));
  const T beam = own * length();
  const T of_beam = named("M_b", col::portal_corner_moment_of_beam_load(beam, length(), ratio));
  const T swaying = named("M_s", col::portal_corner_moment(lateral, rise, ratio));
  const T corner = named("M_c", col::portal_corner_moment_of_moving_load(force, length(), ratio) + of_beam + swaying);
  const T foot = named("M_f",
                       col::portal_foot_moment_of_moving_load(force, length(), ratio) + 0.5 * of_beam +
                           col::portal_foot_moment(lateral, rise, ratio));
  stress = named("σ", sec::bending_stress_of_modulus(larger(moment, corner), section.strong_section_modulus));
  // The load may stand over one of the columns. The corners' moments of the sway make a couple in them, which presses
  // on one and pulls the other.
  axial_force = named("N", force + 0.5 * beam + own * rise + 2.0 * swaying / length());
  column_stress = named("σ_c",
                        sec::direct_stress(axial_force, section.area) +
                            sec::bending_stress_of_modulus(larger(corner, foot), section.strong_section_modulus));
  sway = named("δ_s", lateral / col::portal_stiffness(elastic_modulus(), second_moment, rise, second_moment, length()));
  mass = named("m_b", data->member.count * section.mass_per_length * (2.0 * rise + length()));
}

template <class T>
void StructureMember<T>::derive_weld() {
  using namespace scalar;
  namespace wd = mechanics::weld;
  const Member& m = data->member;
  // Two legs' worth of triangle along the joint.
  const T joint = in_unit<T>(2.0 * (m.joint_width + m.joint_depth), dimension::length);
  mass = m.count * 0.5 * square(leg) * joint *
         in_unit<T>(data->density, dimension::mass / (dimension::length * dimension::length * dimension::length));
  const T throat = named("t", wd::throat(leg));
  const T modulus = wd::rectangle_section_modulus(
      throat, in_unit<T>(m.joint_width, dimension::length), in_unit<T>(m.joint_depth, dimension::length));
  moment = named("M", force * in_unit<T>(m.lever_arm, dimension::length));
  stress = named("τ",
                 wd::combined_stress(
                     wd::direct_stress(force, leg, joint), moment / modulus, in_unit<T>(0.0, dimension::pressure)));
}

template <class T>
void StructureMember<T>::derive() {
  using namespace scalar;
  const Member& m = data->member;
  const T burden = carried_mass + in_unit<T>(data->riding_mass, dimension::mass);
  const T weight = pull_of_mass(burden, data->climbing_acceleration);
  force = named("F", (m.load_share * weight + in_unit<T>(m.extra_force, dimension::force)) / m.count);
  take_section();
  if (m.kind == MemberKind::weld) return derive_weld();
  if (m.kind == MemberKind::portal_frame) return derive_portal();
  mass = named("m_b", m.count * section.mass_per_length * length());
  if (m.kind == MemberKind::column)
    axial_force = force;
  else
    derive_bending();
}

}  // namespace millwright::machine
