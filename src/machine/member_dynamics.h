// SPDX-License-Identifier: Apache-2.0
//
// How a structure member twists and swings, and how a rotating shaft tires.
#pragma once

#include "machine/frequency.h"
#include "machine/structure_member.h"
#include "mechanics/vibration.h"

namespace millwright::machine {

/// Torque on one member. A cantilever takes it at its tip; a member held at both ends in its middle, half to each side.
template <class T>
T twist(const StructureMember<T>& d) {
  using namespace scalar;
  const Member& m = d.data->member;
  const double part = m.support == BeamSupport::cantilever ? 1.0 : 0.5;
  return mechanics::section::twist(in_unit<T>(part * m.torque / m.count, dimension::torque),
                                   part * d.length(),
                                   d.shear_modulus(),
                                   d.section.torsion_constant);
}

/// The stated frequency or, without one, that above which the hardest acceleration of the axis (the shortest ramp it
/// may choose) leaves no more ringing than is permitted.
template <class T>
T required_frequency(const StructureMember<T>& d) {
  using namespace scalar;
  if (d.data->require.known(Requirement::frame_natural_frequency))
    return in_hertz<T>(d.data->require(Requirement::frame_natural_frequency));
  return mechanics::vibration::required_natural_frequency(in_unit<T>(d.data->acceleration, dimension::acceleration),
                                                          d.require(Requirement::ringing_amplitude, dimension::length));
}

/// A portal sways with what it carries, its beam and the part of its columns that takes part (13/35 each, as in a
/// clamped beam: never less than they really take).
template <class T>
T portal_natural_frequency(const StructureMember<T>& d) {
  using namespace scalar;
  const T& second_moment = d.section.strong_second_moment;
  const T stiffness = mechanics::column::portal_stiffness(
      d.elastic_modulus(), second_moment, d.column_length(), second_moment, d.length());
  const T swinging =
      d.mass_on_member() + d.section.mass_per_length * (d.length() + 2.0 * 13.0 / 35.0 * d.column_length());
  return mechanics::vibration::natural_frequency(named("k", stiffness), named("m", swinging));
}

/// First natural frequency, in the plane in which the member is softer, of the member with the mass it carries.
template <class T>
T natural_frequency(const StructureMember<T>& d) {
  using namespace scalar;
  namespace vib = mechanics::vibration;
  const Member& m = d.data->member;
  if (m.kind == MemberKind::portal_frame) return portal_natural_frequency(d);
  const T& second_moment = d.section.least_second_moment;
  const T own = d.section.mass_per_length * d.length();
  switch (m.support) {
    case BeamSupport::cantilever:
      return vib::cantilever_natural_frequency(d.elastic_modulus(), second_moment, d.length(), d.mass_on_member(), own);
    case BeamSupport::fixed:
      return vib::fixed_natural_frequency(d.elastic_modulus(), second_moment, d.length(), d.mass_on_member(), own);
    case BeamSupport::supported:
      break;
  }
  return vib::supported_natural_frequency(d.elastic_modulus(), second_moment, d.length(), d.mass_on_member(), own);
}

/// Endurance limit of the shaft: of steel by its tensile strength, of other metals as measured, times the factors of
/// surface, size and reliability; bending, so the load factor is 1.
template <class T>
T endurance_limit(const StructureMember<T>& d) {
  using namespace scalar;
  namespace mat = mechanics::material;
  struct Finish {
    double coefficient, exponent;
  };
  const Finish finish = d.data->member.surface == SurfaceFinish::ground       ? Finish{1.58, -0.085}
                        : d.data->member.surface == SurfaceFinish::hot_rolled ? Finish{57.7, -0.718}
                        : d.data->member.surface == SurfaceFinish::forged     ? Finish{272.0, -0.995}
                                                                              : Finish{4.51, -0.265};
  const T strength = in_unit<T>(d.data->ultimate_strength, dimension::pressure);
  const T surface = named("k_a", mat::surface_factor(strength, T(finish.coefficient), T(finish.exponent)));
  const T factors =
      named("k", surface * mat::size_factor(d.diameter) * d.require(Requirement::fatigue_reliability_factor));
  if (d.data->endurance_limit > 0.0) return factors * in_unit<T>(d.data->endurance_limit, dimension::pressure);
  return mat::endurance_limit(strength, factors);
}

/// Bending turns with the shaft and is fully reversed; torsion, if there is any, is steady.
template <class T>
T fatigue_safety(const StructureMember<T>& d) {
  using namespace scalar;
  namespace sec = mechanics::section;
  namespace mat = mechanics::material;
  const Member& m = d.data->member;
  const T amplitude = named(
      "σ_a", m.notch_factor * sec::bending_stress_of_modulus(d.resultant_moment(), d.section.strong_section_modulus));
  T mean = in_unit<T>(0.0, dimension::pressure);
  if (m.torque > 0.0)
    mean = named("σ_m",
                 mat::von_mises_stress(
                     in_unit<T>(0.0, dimension::pressure),
                     sec::round_torsional_stress(in_unit<T>(m.torque / m.count, dimension::torque), d.diameter)));
  return mat::goodman_safety(
      amplitude, mean, named("S_e", endurance_limit(d)), in_unit<T>(d.data->ultimate_strength, dimension::pressure));
}

}  // namespace millwright::machine
