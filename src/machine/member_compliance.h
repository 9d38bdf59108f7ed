// SPDX-License-Identifier: Apache-2.0
//
// What a structure member gives way under the tool (tool_chain.h).
#pragma once

#include "machine/structure_member.h"
#include "machine/tool_chain.h"

namespace millwright::machine {

namespace detail {

/// Deflection of a member per force in its middle, of a cantilever at its tip [m/N].
template <class T>
T bending_compliance(const StructureMember<T>& d, const T& second_moment) {
  namespace bm = mechanics::beam;
  const T unit = scalar::in_unit<T>(1.0, scalar::dimension::force);
  switch (d.data->member.support) {
    case BeamSupport::cantilever:
      return bm::cantilever_tip_deflection(unit, d.length(), d.elastic_modulus(), second_moment) / unit;
    case BeamSupport::fixed:
      return bm::fixed_deflection(unit, d.length(), d.elastic_modulus(), second_moment) / unit;
    case BeamSupport::supported:
      break;
  }
  return bm::supported_deflection(unit, d.length(), d.elastic_modulus(), second_moment) / unit;
}

/// Twist of a member per torque in its middle, its ends held; of a cantilever at its tip [rad/(N.m)].
template <class T>
T twisting_compliance(const StructureMember<T>& d) {
  const T unit = scalar::in_unit<T>(1.0, scalar::dimension::torque);
  const T whole = mechanics::section::twist(unit, d.length(), d.shear_modulus(), d.section.torsion_constant) / unit;
  return d.data->member.support == BeamSupport::cantilever ? whole : T(0.25 * whole);
}

}  // namespace detail

/// Beams, bars, shafts, plates and portals bend under the tool force in their middle (cantilevers at the tip), upright
/// over their strong axis and sideways over their weak one, and twist at the lever arms of the tool. They lie along the
/// travel of their axis unless the file says otherwise. Portals sway in their plane on clamped feet, columns are
/// squeezed.
template <class T>
Compliance<T> tool_compliance(const StructureMember<T>& d, const ToolPlace& place) {
  using namespace scalar;
  const Member& m = d.data->member;
  Compliance<T> result = no_compliance<T>();
  if (m.kind == MemberKind::weld || m.kind == MemberKind::bolts || m.rotating) return result;
  if (m.kind == MemberKind::column) {
    result[upright] = d.length() / (m.count * d.elastic_modulus() * d.section.area);
    return result;
  }
  const std::size_t lies = m.along.value_or(place.travel);
  const std::size_t strong = lies == upright ? place.normal : upright;
  const std::size_t weak = 3 - lies - strong;
  std::array<double, 3> arm{};
  arm[place.travel] = place.along_arm;
  arm[place.across] = place.across_arm;
  arm[place.normal] = place.height_arm;
  const T share = T(1.0 / m.count);
  result[strong] = share * detail::bending_compliance(d, d.section.strong_second_moment);
  result[weak] = share * detail::bending_compliance(d, d.section.weak_second_moment);
  if (m.kind == MemberKind::portal_frame) {
    namespace col = mechanics::column;
    const T& second_moment = d.section.strong_second_moment;
    result[lies] =
        share / col::portal_stiffness(d.elastic_modulus(), second_moment, d.column_length(), second_moment, d.length());
    // Out of its plane both columns bend as cantilevers.
    result[weak] =
        result[weak] + share * cube(d.column_length()) / (6.0 * d.elastic_modulus() * d.section.weak_second_moment);
  }
  if (arm[weak] > 0.0 || arm[strong] > 0.0) {
    const T twist = share * detail::twisting_compliance(d);
    result[strong] = result[strong] + square(in_unit<T>(arm[weak], dimension::length)) * twist;
    result[weak] = result[weak] + square(in_unit<T>(arm[strong], dimension::length)) * twist;
  }
  return result;
}

}  // namespace millwright::machine
