// SPDX-License-Identifier: Apache-2.0
//
// A joint of screws that holds an axis on an upright face. Its share of the carried weight and an extra force pull down
// along the face, a lateral force across it; both at a lever arm from the face, so that they shear the joint and tilt
// it about its edges. What is checked is the worst screw, as if it were in the worst place of every load at once.
//
// A joint may hold a motor or a carriage instead. A motor turns its flange by the largest torque that it has, weighs on
// it, and is pulled sideways by what a belt or a pinion at its shaft does. A carriage loads its screws as much as the
// guide, straight off the slide and along it at once, for it may come from any side.
//
// Screws that do not fill their holes hold the shear by friction; fitted ones in their shanks.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "machine/constraint.h"
#include "machine/motor_constraints.h"
#include "machine/problem.h"
#include "mechanics/bolt.h"
#include "mechanics/material.h"

namespace millwright::machine {

template <class T>
struct BoltReading {
  T diameter{}, stress_area{}, proof_strength{};
  T yield_strength{};  ///< read of fitted screws only, else 0
};

template <class Reading, class Visit>
void visit_bolt_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.diameter, &r.stress_area, &r.proof_strength, &r.yield_strength}) visit(*field);
}
inline constexpr std::size_t bolt_reading_fields = 4;

struct BoltedJointData {
  Member member;
  Requirements require;
  double riding_mass = 0.0;            ///< kg, allowance for the nut or belt of the axis that it carries
  double climbing_acceleration = 0.0;  ///< m/s^2, the hardest of the axis, what of it is upwards
};

template <class T>
struct BoltedJoint {
  const BoltedJointData* data = nullptr;
  BoltReading<T> bolt;
  T carried_mass{};  ///< read where the joint holds the burden of its axis
  T held_force{};    ///< N, of a motor or a carriage, on one joint
  T held_torque{};   ///< N.m, of a motor, on one joint

  T force{};    ///< N, down along the face, on one joint
  T preload{};  ///< N, of a screw
  T tension{};  ///< N, external, on the worst screw
  T shear{};    ///< N, on the worst screw

  [[nodiscard]] T require(Requirement requirement, const scalar::Dimension& dimension = scalar::dimension::none) const {
    return scalar::in_unit<T>(data->require(requirement), dimension);
  }
  void derive();

 private:
  /// Places of the screws along one side of the pattern: of each screw, from `first` on.
  [[nodiscard]] std::vector<T> places(bool upwards, double first) const;
  [[nodiscard]] Held holds() const { return data->member.bolts.holds; }
  [[nodiscard]] bool loaded() const {
    return holds() != Held::burden || data->member.load_share > 0.0 || data->member.extra_force > 0.0;
  }
  [[nodiscard]] T borne() const;
  [[nodiscard]] T turning() const;
  void derive_tension(const T& lateral);
  void derive_shear(const T& lateral);
};

template <class T>
std::vector<T> BoltedJoint<T>::places(bool upwards, double first) const {
  const BoltPattern& p = data->member.bolts;
  std::vector<T> result;
  for (int row = 0; row < static_cast<int>(p.rows); ++row)
    for (int column = 0; column < static_cast<int>(p.columns); ++column)
      result.push_back(scalar::in_unit<T>(first + (upwards ? row * p.row_spacing : column * p.column_spacing),
                                          scalar::dimension::length));
  return result;
}

template <class T>
void BoltedJoint<T>::derive_tension(const T& lateral) {
  using namespace scalar;
  namespace bt = mechanics::bolt;
  const Member& m = data->member;
  const T arm = in_unit<T>(m.lever_arm, dimension::length);
  T sum = in_unit<T>(m.bolts.pull_force / (m.count * m.bolts.count()), dimension::force);
  const auto add = [&](const T& load, bool upwards) {
    const std::vector<T> distances = places(upwards, m.bolts.edge_distance);
    sum = sum + bt::group_tension(load * arm, std::span<const T>(distances));
  };
  if (m.lever_arm > 0.0 && loaded()) add(force, true);
  if (m.lever_arm > 0.0 && m.lateral_force > 0.0) add(lateral, false);
  if (holds() == Held::carriage) sum = sum + held_force / m.bolts.count();
  tension = named("P", sum);
}

/// What a torque adds to the shear of the outermost screw (N): M r / Σ r². Its direction may be any other's. [shigley,
/// chapter 8, "Shear joints with eccentric loading"]
template <class T>
T BoltedJoint<T>::turning() const {
  using namespace scalar;
  const BoltPattern& p = data->member.bolts;
  double farthest = 0.0, square_sum = 0.0;
  for (int row = 0; row < static_cast<int>(p.rows); ++row)
    for (int column = 0; column < static_cast<int>(p.columns); ++column) {
      const double distance = std::hypot((column - 0.5 * (p.columns - 1.0)) * p.column_spacing,
                                         (row - 0.5 * (p.rows - 1.0)) * p.row_spacing);
      farthest = std::max(farthest, distance);
      square_sum += distance * distance;
    }
  return held_torque / in_unit<T>(square_sum / farthest, dimension::length);
}

template <class T>
void BoltedJoint<T>::derive_shear(const T& lateral) {
  using namespace scalar;
  const Member& m = data->member;
  const BoltPattern& p = m.bolts;
  T down = force / p.count();
  if (p.eccentricity > 0.0 && loaded()) {
    const std::vector<T> x = places(false, -0.5 * (p.columns - 1.0) * p.column_spacing);
    const std::vector<T> y = places(true, -0.5 * (p.rows - 1.0) * p.row_spacing);
    down = mechanics::bolt::group_shear(
        force, in_unit<T>(p.eccentricity, dimension::length), std::span<const T>(x), std::span<const T>(y));
  }
  if (holds() == Held::motor) down = down + turning();
  const T across = lateral / p.count();
  if (m.lateral_force == 0.0)
    shear = named("F_k", down);
  else if (p.eccentricity > 0.0 || holds() == Held::motor)
    shear = named("F_k", down + across);  // the worst screw may be pushed just that way
  else
    shear = named("F_k", sqrt(square(down) + square(across)));
}

/// What pulls down along the face of one joint.
template <class T>
T BoltedJoint<T>::borne() const {
  using namespace scalar;
  const Member& m = data->member;
  const T extra = in_unit<T>(m.extra_force, dimension::force);
  if (holds() != Held::burden) return held_force + extra / m.count;
  const T burden = carried_mass + in_unit<T>(data->riding_mass, dimension::mass);
  const T weight = pull_of_mass(burden, data->climbing_acceleration);
  return (m.load_share * weight + extra) / m.count;
}

template <class T>
void BoltedJoint<T>::derive() {
  using namespace scalar;
  namespace bt = mechanics::bolt;
  const Member& m = data->member;
  force = named("F", borne());
  const T lateral = in_unit<T>(m.lateral_force / m.count, dimension::force);
  derive_tension(lateral);
  derive_shear(lateral);
  if (m.bolts.tightening_torque)
    preload =
        named("F_i",
              bt::preload_of_torque(
                  in_unit<T>(*m.bolts.tightening_torque, dimension::torque), T(m.bolts.nut_factor), bolt.diameter));
  else
    preload =
        named("F_i", bt::preload(bolt.stress_area, bolt.proof_strength, require(Requirement::bolt_preload_fraction)));
}

template <class Visit>
void bolted_joint_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  namespace bt = mechanics::bolt;
  // A joint that nothing pulls or pushes is safe without end: one newton keeps the safety finite and harmless.
  constexpr auto at_least_a_newton = [](const auto& x) { return larger(x, in_unit_like(x, 1.0, dimension::force)); };
  constexpr auto constant = [](const auto& d) { return decltype(d.force)(d.data->member.bolts.joint_constant); };
  visit(
      Declaration{.id = "C-BOLT-PROOF",
                  .title = "Proof load of the screws",
                  .symbol = "n_p",
                  .unit = "1",
                  .source = "shigley, chapter 8",
                  .requirement = "bolt_proof_safety"},
      always,
      [](const auto& d) { return d.require(bolt_proof_safety); },
      [=](const auto& d) {
        return bt::proof_safety(d.bolt.stress_area, d.bolt.proof_strength, d.preload, constant(d), d.tension);
      });
  visit(
      Declaration{.id = "C-BOLT-SEP",
                  .title = "Opening of the joint",
                  .symbol = "n_0",
                  .unit = "1",
                  .source = "shigley, chapter 8; khurmi_gupta2005, 11.18",
                  .requirement = "bolt_separation_safety"},
      always,
      [](const auto& d) { return d.require(bolt_separation_safety); },
      [=](const auto& d) { return bt::separation_safety(d.preload, constant(d), at_least_a_newton(d.tension)); });
  visit(
      Declaration{.id = "C-BOLT-SLIP",
                  .title = "Slip of the joint",
                  .symbol = "n_s",
                  .unit = "1",
                  .source = "shigley, chapter 8",
                  .requirement = "bolt_slip_safety"},
      [](const auto& d) { return d.data->member.bolts.fitted ? Applies::no : Applies::yes; },
      [](const auto& d) { return d.require(bolt_slip_safety); },
      [=](const auto& d) {
        // The worst screw: as much shear on each of them, and as much tension.
        using T = decltype(d.force);
        const T one = T(1.0);
        const T friction = T(d.data->member.bolts.friction);
        return bt::slip_safety(one, friction, d.preload, d.tension, constant(d), at_least_a_newton(d.shear));
      });
  visit(
      Declaration{.id = "C-BOLT-SHEAR",
                  .title = "Shear of fitted bolts, with their tension",
                  .symbol = "τ_e",
                  .unit = "MPa",
                  .source = "shigley, chapter 8; khurmi_gupta2005, chapter 11",
                  .requirement = "bolt_shear_safety_factor"},
      [](const auto& d) { return d.data->member.bolts.fitted ? Applies::yes : Applies::no; },
      // The thread may lie in the joint: its stress area is the safe one. What pulls at the screw counts with it,
      // (sigma/sigma_a)^2 + (tau/tau_a)^2 <= 1 with sigma_a = sqrt(3) tau_a.
      [=](const auto& d) {
        const auto shear = bt::shear_stress(at_least_a_newton(d.shear), d.bolt.stress_area, decltype(d.force)(1.0));
        return sqrt(square(shear) + square(d.tension / d.bolt.stress_area) / 3.0);
      },
      [](const auto& d) {
        return mechanics::material::von_mises_shear_yield(d.bolt.yield_strength) / d.require(bolt_shear_safety_factor);
      });
}

}  // namespace millwright::machine
