// SPDX-License-Identifier: Apache-2.0
//
// Quantities that one or two constraints of a screw drive need and that are more than one formula.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "machine/error_budget.h"
#include "machine/frequency.h"
#include "machine/screw_drive.h"
#include "machine/tool_chain.h"
#include "mechanics/ball_screw_cycle.h"

namespace millwright::machine {

/// Thermal expansion of steel [1/K], as the carbon steels of the materials table.
inline constexpr double steel_expansion = 12e-6;

/// Pressure on the engaged thread flanks [Pa].
template <class T>
T bearing_pressure(const ScrewDrive<T>& d, const T& force) {
  return mechanics::power_screw::bearing_pressure(
      force, d.screw.mean_diameter, d.screw.thread_depth, d.screw.engaged_turns);
}

/// Sliding speed on the mean diameter at the largest screw speed [m/s].
template <class T>
T sliding_speed(const ScrewDrive<T>& d) {
  return mechanics::power_screw::sliding_speed(d.screw_speed, d.screw.mean_diameter, d.screw.lead);
}

/// Largest load of one raceway [N], preload included.
template <class T>
T static_load(const ScrewDrive<T>& d) {
  return mechanics::ball_screw::raceway_load(d.largest_force, d.screw.preload, d.data->preloaded);
}

/// Torque that a force along the travel puts on the motor shaft at standstill [N.m]; 0 when self-locking.
template <class T>
T back_driving_torque(const ScrewDrive<T>& d, const T& force) {
  return d.reduction.driven(mechanics::actuation::backdriving_torque(
      force, d.screw.lead, d.screw.reverse_efficiency, scalar::in_unit<T>(0.0, scalar::dimension::force), T(1.0)));
}

/// The same with power off, the weight against friction [N.m].
template <class T>
T power_off_torque(const ScrewDrive<T>& d) {
  return d.reduction.driven(mechanics::actuation::backdriving_torque(
      d.cycle.weight, d.screw.lead, d.screw.reverse_efficiency, d.cycle.friction_force, T(1.0)));
}

/// What comes through the thread of a sliding screw with power off [N.m], where its friction is less by the factor that
/// self-locking asks for.
template <class T>
T slippery_torque(const ScrewDrive<T>& d) {
  using namespace scalar;
  const T slope = d.screw.lead / (pi<T>() * d.screw.mean_diameter);
  const T friction = slope / (d.screw.self_locking_ratio * d.require(Requirement::self_locking_factor));
  const T efficiency = (slope - friction) / ((1.0 + friction * slope) * slope);
  return d.reduction.driven(mechanics::actuation::backdriving_torque(
      d.cycle.weight, d.screw.lead, efficiency, d.cycle.friction_force, T(1.0)));
}

/// What a brake on the motor of a sliding screw must hold with power off [N.m]: the back-driving torque with its
/// factor, or what comes through a more slippery thread; and at least what makes a brake one, so that a word of one
/// does not stand for a lock where friction or a counterbalance happen to hold.
template <class T>
T torque_on_brake(const ScrewDrive<T>& d) {
  using namespace scalar;
  const T with_factor = d.require(Requirement::brake_factor) * power_off_torque(d);
  return named("T_B", larger(larger(with_factor, slippery_torque(d)), in_unit<T>(smallest_brake, dimension::torque)));
}

/// How far the thread is from locking itself: tan of the lead angle over friction. Where a brake does it, and is loaded
/// less than that, what it must hold over what it can, as a part of the ratio that is permitted.
template <class T>
T unlocked_ratio(const ScrewDrive<T>& d) {
  using namespace scalar;
  if (!(d.data->brake_torque > 0.0)) return d.screw.self_locking_ratio;
  const T load = torque_on_brake(d) / in_unit<T>(d.data->brake_torque, dimension::torque);
  return smaller(d.screw.self_locking_ratio, named("u_B", load / d.require(Requirement::self_locking_factor)));
}

/// The key of the factor that decides whether the drive is locked (limiting_requirement).
template <class T>
std::string_view lock_requirement(const ScrewDrive<T>& d) {
  const bool by_brake = d.data->brake_torque > 0.0 && unlocked_ratio(d) < d.screw.self_locking_ratio;
  const bool by_factor = d.require(Requirement::brake_factor) * power_off_torque(d) > slippery_torque(d);
  return by_brake && by_factor ? "brake_factor" : "self_locking_factor";
}

/// Smallest of all speed limits of the drive, as a speed of the axis [m/s].
template <class T>
T speed_limit(const ScrewDrive<T>& d) {
  using namespace scalar;
  const T pulse = d.require(Requirement::step_rate_factor) * in_hertz<T>(d.data->require(Requirement::step_rate)) *
                  2.0 * pi<T>() / (4.0 * d.motor.rotor_teeth * d.data->microsteps);
  const bool turns = !d.data->nut_rotates;
  T limit = d.reduction.at_output(d.reduction.limited(pulse));
  if (d.data->has_coupling) limit = smaller(limit, d.coupling.largest_speed);
  if (turns) {
    limit = smaller(limit, d.support_fixed.largest_speed);
    limit = where_applies(d.sliding(), limit, [&] {
      return T(smaller(limit, d.require(Requirement::critical_speed_factor) * d.screw.critical_speed));
    });
  }
  limit = where_applies(d.ball(), limit, [&] {
    const T balls = d.screw.speed_value_limit / d.screw.pitch_circle;
    return T(smaller(limit, turns ? T(smaller(d.screw.critical_speed, balls)) : balls));
  });
  return limit * d.screw.lead / (2.0 * pi<T>());
}

/// Travel of one microstep [m].
template <class T>
T resolution(const ScrewDrive<T>& d) {
  return mechanics::accuracy::linear_resolution(
      d.screw.lead, 4.0 * d.motor.rotor_teeth, T(d.data->microsteps), d.reduction.ratio_or_one());
}

/// Stiffness of shaft and thrust bearings at the worst place of the nut [N/m]: the far end, or, with thrust taken at
/// both ends, where the two sides, each a length of shaft with its bearing, give way alike: there one quarter of the
/// compliance that shaft and bearings have in a row.
template <class T>
T held_stiffness(const ScrewDrive<T>& d) {
  using namespace scalar;
  namespace bs = mechanics::ball_screw;
  const T shaft = named("k_S",
                        mechanics::power_screw::axial_stiffness_one_end_fixed(
                            d.screw.elastic_modulus, d.screw.root_diameter, d.screw.supported_length));
  const std::array<T, 3> row{shaft, d.support_fixed.axial_stiffness, d.support_free.axial_stiffness};
  return named("k_SB",
               d.data->both_ends_fixed ? 4.0 * bs::chain_stiffness(std::span<const T>(row))
                                       : bs::chain_stiffness(std::span<const T>(row).first(2)));
}

/// The force under which a drive has to be stiff [N]: the least with which a move presses, so that a move which presses
/// more, or a harder ramp, does not stiffen a nut without preload; what moves the load at steady speed, if that is
/// more, as it is always there. At least one newton. Moves without a force do not count: where nothing presses, nothing
/// has to be stiff against it.
template <class T>
T working_force(const ScrewDrive<T>& d) {
  using namespace scalar;
  double least = std::numeric_limits<double>::infinity();
  for (const Move& move : d.data->motion.moves) {
    const double force = move.profile ? move.profile->largest_force : std::fabs(move.force);
    if (force > 0.0) least = std::min(least, force);
  }
  const T pressing = in_unit<T>(std::isfinite(least) ? std::max(least, 1.0) : 1.0, dimension::force);
  return named("F_w", larger(T(d.cycle.weight + d.cycle.friction_force), pressing));
}

/// Axial stiffness between motor and table at the worst place of the nut [N/m]. The ball nut at its preload, else at
/// the given force [N]. Lead nuts have no published stiffness and are left out (the estimate is then on the stiff
/// side).
template <class T>
T least_axial_stiffness(const ScrewDrive<T>& d, const T& force) {
  using namespace scalar;
  namespace bs = mechanics::ball_screw;
  const T held = held_stiffness(d);
  return where_applies(d.ball(), held, [&] {
    const T nut = named(
        "k_N",
        d.data->preloaded ? bs::preloaded_nut_stiffness(d.screw.nut_stiffness, d.screw.preload, d.screw.dynamic_rating)
                          : bs::nut_stiffness(d.screw.nut_stiffness, force, d.screw.dynamic_rating));
    const std::array<T, 2> chain{held, nut};
    return bs::chain_stiffness(std::span<const T>(chain));
  });
}

/// How far the table gives way to a force [m], the same chain: in single powers of the force, so that it is seen to
/// rise with it. A ball nut without preload counts as under at least one newton.
template <class T>
T axial_give(const ScrewDrive<T>& d, const T& force) {
  using namespace scalar;
  namespace bs = mechanics::ball_screw;
  const T held = force / held_stiffness(d);
  return where_applies(d.ball(), held, [&] {
    return T(held + (d.data->preloaded ? T(force / bs::preloaded_nut_stiffness(
                                                       d.screw.nut_stiffness, d.screw.preload, d.screw.dynamic_rating))
                                       : bs::nut_deflection(d.screw.nut_stiffness,
                                                            T(larger(force, in_unit<T>(1.0, dimension::force))),
                                                            d.screw.dynamic_rating)));
  });
}

/// Torque that friction costs the screw before anything moves [N.m]: of guides and nut, and half of what the weight
/// makes the thread ask more going up than it gives back going down.
template <class T>
T friction_torque_at_screw(const ScrewDrive<T>& d) {
  using namespace scalar;
  const T& weight = d.cycle.weight;
  const T raising = mechanics::ball_screw::drive_torque(weight, d.screw.lead, d.screw.efficiency);
  const T lowering = mechanics::ball_screw::backdriving_torque(weight, d.screw.lead, d.screw.reverse_efficiency);
  return mechanics::ball_screw::drive_torque(d.cycle.friction_force, d.screw.lead, d.screw.efficiency) +
         0.5 * (raising - lowering) + d.screw.drag_torque;
}

/// The same at the motor [N.m].
template <class T>
T friction_torque(const ScrewDrive<T>& d) {
  return d.reduction.driving(friction_torque_at_screw(d));
}

/// Travel of the nut until its thread is worn thin [m], under the mean force over the travel: wear grows with pressure
/// times distance.
template <class T>
T wear_travel(const ScrewDrive<T>& d) {
  using namespace scalar;
  T work = in_unit<T>(0.0, dimension::force * dimension::length);
  for (std::size_t i = 0; i < d.cycle.phases.size(); ++i)
    work = work + d.axial_forces[i] * d.cycle.phases[i].mean_speed * d.cycle.phases[i].duration;
  const T pressure =
      named("p_m",
            mechanics::power_screw::bearing_pressure(
                T(work / d.cycle.travelled), d.screw.mean_diameter, d.screw.thread_depth, d.screw.engaged_turns));
  const T wear = named("δ_w", d.require(Requirement::nut_wear_fraction) * d.screw.nut_root_thickness);
  return mechanics::power_screw::nut_wear_travel(
      d.screw.wear_rate, pressure, d.screw.flank_angle, wear, d.screw.mean_diameter, d.screw.lead);
}

/// Torsional stiffness between motor and nut at the far end of the travel, at the screw [N.m/rad]: coupling, screw and
/// reduction.
template <class T>
T torsional_stiffness(const ScrewDrive<T>& d) {
  const T shaft = mechanics::coupling::shaft_torsional_stiffness(
      d.screw.shear_modulus, d.screw.root_diameter, d.screw.supported_length);
  const std::array<T, 2> chain{shaft, d.coupling.stiffness};
  const T stiffness =
      mechanics::coupling::series_stiffness(std::span<const T>(chain).first(d.data->has_coupling ? 2 : 1));
  return d.reduction.present ? T(1.0 / (1.0 / stiffness + d.reduction.compliance)) : stiffness;
}

/// The same at the motor: one radian there is 1/i at the screw, and its torque i times as large.
template <class T>
T torsional_stiffness_at_motor(const ScrewDrive<T>& d) {
  return d.reduction.reflected(torsional_stiffness(d));
}

/// Lead error [m] over the stated travel (error_budget.h).
template <class T>
T lead_error(const ScrewDrive<T>& d) {
  return counted_travel(d.data->require, d.data->stroke, true) / rated_travel * d.screw.lead_error_300;
}

/// Twist of screw and coupling under a torque at the screw [rad].
template <class T>
T twist_of_screw(const ScrewDrive<T>& d, const T& torque) {
  const T twist = mechanics::power_screw::torsional_windup(
      torque, d.screw.supported_length, d.screw.shear_modulus, d.screw.root_diameter);
  return d.data->has_coupling ? T(twist + mechanics::coupling::windup(torque, d.coupling.stiffness)) : twist;
}

/// Position error from the twist of coupling, screw and reduction under the load torque [m]. A screw that stands while
/// its nut turns twists as well: its clamped end holds the torque of the nut.
template <class T>
T windup_error(const ScrewDrive<T>& d) {
  T twist = twist_of_screw(d, d.steady_torque);
  if (d.reduction.present) twist = twist + d.reduction.compliance * d.steady_torque;
  return mechanics::power_screw::windup_error(twist, d.screw.lead);
}

/// How far the rotor lags under a torque of the motor, as travel [m].
template <class T>
T motor_lag(const ScrewDrive<T>& d, const T& torque) {
  using namespace scalar;
  return mechanics::accuracy::load_lag(
      smaller(torque, d.motor.static_torque), d.motor.static_torque, d.motor.rotor_teeth, d.lead_of_motor());
}

/// What friction holds back between motor and nut, beside reversal_error [m]: the rotor's lag, the twist of screw and
/// coupling. On reversal it is lost twice.
template <class T>
T turning_give_under_friction(const ScrewDrive<T>& d) {
  return motor_lag(d, friction_torque(d)) +
         mechanics::power_screw::windup_error(twist_of_screw(d, friction_torque_at_screw(d)), d.screw.lead);
}

/// Growth of the screw over the stated travel against the frame [m].
template <class T>
T thermal_growth(const ScrewDrive<T>& d) {
  using namespace scalar;
  return mechanics::power_screw::thermal_growth(
      in_unit<T>(steel_expansion, dimension::none / dimension::temperature),
      in_unit<T>(accuracy_travel(d.data->require, d.data->stroke), dimension::length),
      d.require(Requirement::screw_temperature_rise, dimension::temperature));
}

/// Reversal error [m]: play and twice what the drive gives way under friction; of a reduction its play and twice its
/// wind-up under friction.
template <class T>
T reversal_error(const ScrewDrive<T>& d) {
  const T axial = d.screw.backlash + 2.0 * axial_give(d, d.cycle.friction_force);
  if (!d.reduction.present) return axial;
  const T wound_up = d.reduction.compliance * friction_torque_at_screw(d);
  return axial + mechanics::transmission::linear_backlash(T(d.reduction.backlash + 2.0 * wound_up), d.screw.lead);
}

/// Errors of the axis [m].
template <class T>
ErrorBudget<T> error_budget(const ScrewDrive<T>& d, UnderForce under_force = UnderForce::yes) {
  using namespace scalar;
  ErrorBudget<T> budget;
  budget.add_systematic("lead", named("e_l", lead_error(d)));
  budget.add_systematic("reversal", named("e_r", reversal_error(d)));
  if (under_force == UnderForce::yes && has_process_force(d.data->motion))
    budget.add_systematic("under force", named("e_F", axial_give(d, d.cycle.process_force)));
  budget.add_systematic("wind-up", named("e_w", windup_error(d)));
  budget.add_systematic("motor lag", named("e_s", motor_lag(d, d.load_torque)));
  budget.add_systematic("thermal growth", named("e_th", thermal_growth(d)));
  budget.add_random("step", named("e_t", 0.05 * d.lead_of_motor() / (4.0 * d.motor.rotor_teeth)));
  budget.add_random("resolution", named("e_q", 0.5 * resolution(d)));
  return budget;
}

/// How the free end sits in its support, 1 being the limit: a journal is turned from the root, so its bore must not
/// exceed the root; a pillow block may also clamp the unturned screw, whose outside must then be its bore.
template <class T>
T free_support_fit(const ScrewDrive<T>& d) {
  using namespace scalar;
  const T turned = d.support_free.bore / d.screw.root_diameter;
  const T clamped =
      larger(d.support_free.bore / d.screw.nominal_diameter, d.screw.nominal_diameter / d.support_free.bore);
  // What cannot clamp is as far from clamping as from fitting.
  const T clamping = clamped + (1.0 - d.support_free.clamps) * 1e3;
  return smaller(turned, clamping);
}

/// Screw, nut, thrust bearing, twist of screw and coupling, and the motor's field.
template <class T>
Compliance<T> tool_compliance(const ScrewDrive<T>& d, const ToolPlace& place) {
  using namespace scalar;
  const T per_angle = d.screw.lead / (2.0 * pi<T>());
  const T force = in_unit<T>(std::max(place.force, 1.0), dimension::force);
  const T turning = 1.0 / torsional_stiffness(d) + d.reduction.reflected(T(1.0 / motor_stiffness(d.motor)));
  const T one = 1.0 / least_axial_stiffness(d, force) + square(per_angle) * turning;
  Compliance<T> result = no_compliance<T>();
  result[place.travel] = sharing_factor(place) * one;
  return result;
}

}  // namespace millwright::machine
