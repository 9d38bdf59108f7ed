// SPDX-License-Identifier: Apache-2.0
//
// Constraints of motor, driver and accuracy that every drive has. They are generic over the drive's design, which
// offers motor, cycle, torque_ratios, load_torque, load_inertia, peak_speed and the functions
// back_driving_torque, power_off_torque, speed_limit, resolution, reversal_error, turning_give_under_friction,
// error_budget and friction_torque.
#pragma once

#include <numbers>

#include "machine/axis_motion.h"
#include "machine/constraint.h"
#include "machine/motor_quantities.h"
#include "machine/requirement.h"
#include "mechanics/stepper.h"
#include "scalar/scalars.h"

namespace millwright::machine {

inline constexpr auto always = [](const auto&) { return Applies::yes; };

/// A constant of the same scalar as `like`.
template <class T>
T in_unit_like(const T& /*like*/, double value, const scalar::Dimension& dimension) {
  return scalar::in_unit<T>(value, dimension);
}

/// What the assumed holding brake may be loaded with [N.m]; none without one.
template <class Drive>
auto brake_capacity(const Drive& d) {
  using T = std::remove_cvref_t<decltype(d.peak_speed)>;
  const T brake = scalar::in_unit<T>(d.data->brake_torque, scalar::dimension::torque);
  return d.data->brake_torque > 0.0 ? T(brake / d.require(Requirement::brake_factor)) : brake;
}

/// The key of the requirement that sets the limit of a drive's check: with power off either the brake holds or the
/// magnets of the motor do, whichever is stronger.
template <class Drive>
std::string_view limiting_requirement(const Drive& d, const Declaration& declaration) {
  if constexpr (requires { lock_requirement(d); })
    if (declaration.requirement == "self_locking_factor") return lock_requirement(d);
  if (declaration.requirement != "detent_factor") return declaration.requirement;
  return brake_capacity(d) > d.require(Requirement::detent_factor) * d.motor.detent_torque ? "brake_factor"
                                                                                           : declaration.requirement;
}

/// Whether the moves can be made in their time: every drive.
template <class Visit>
void move_time_constraint(Visit&& visit) {
  visit(
      Declaration{.id = "C-SYS-TIME",
                  .title = "Ramps and cruise fit into the move",
                  .symbol = "t/t_allowed",
                  .unit = "1",
                  .source = "millwright_derivations, kinematics of equal ramps"},
      always,
      [](const auto& d) { return d.cycle.time_ratio; },
      [](const auto& d) { return decltype(d.cycle.time_ratio)(1.0); });
}

/// Motor and driver.
template <class Visit>
void motor_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  namespace st = mechanics::stepper;
  visit(
      Declaration{.id = "C-ST-TORQUE",
                  .title = "Torque at speed, worst phase",
                  .symbol = "T/T_av",
                  .unit = "1",
                  .source = "oriental_motor_sizing, safety factor",
                  .requirement = "torque_margin",
                  .worst = WorstPhase::torque_ratio},
      always,
      [](const auto& d) { return largest(d.torque_ratios); },
      [](const auto& d) { return d.motor.torque_margin; });
  visit(
      Declaration{.id = "C-ST-80",
                  .title = "Load torque, 80 % rule",
                  .symbol = "T_L",
                  .unit = "N.m",
                  .source = "sander, eq. 22",
                  .requirement = "load_torque_factor",
                  .worst = WorstPhase::steady},
      always,
      [](const auto& d) { return d.load_torque; },
      [](const auto& d) { return d.require(load_torque_factor) * d.motor.holding_torque; });
  visit(
      Declaration{.id = "C-ST-INERTIA",
                  .title = "Load inertia over rotor inertia",
                  .symbol = "J_L",
                  .unit = "kg.cm2",
                  .source = "parker_sizing, inertia ratio; sander, eq. 21",
                  .requirement = "inertia_ratio"},
      always,
      [](const auto& d) { return d.load_inertia; },
      [](const auto& d) { return d.require(inertia_ratio) * d.motor.rotor_inertia; });
  visit(
      Declaration{.id = "C-ST-RMS",
                  .title = "RMS torque",
                  .symbol = "T_rms",
                  .unit = "N.m",
                  .kind = ConstraintKind::soft,
                  .source = "sander, eq. 25",
                  .requirement = "rms_torque_factor",
                  .worst = WorstPhase::cycle},
      always,
      [](const auto& d) { return rms_torque(d); },
      [](const auto& d) { return d.require(rms_torque_factor) * d.motor.holding_torque; });
  visit(
      Declaration{.id = "C-ST-STEPRATE",
                  .title = "Step pulse rate",
                  .symbol = "f",
                  .unit = "kHz",
                  .source = "acarnley2002, chapter 5",
                  .requirement = "step_rate",
                  .worst = WorstPhase::speed},
      always,
      [](const auto& d) {
        return st::pulse_rate(d.motor.rotor_teeth, decltype(d.peak_speed)(d.data->microsteps), d.peak_speed);
      },
      [](const auto& d) {
        return d.require(step_rate_factor) * in_hertz<decltype(d.peak_speed)>(d.data->require(step_rate));
      });
  visit(
      Declaration{.id = "C-ST-HOLD",
                  .title = "Holding at standstill",
                  .symbol = "T_h",
                  .unit = "N.m",
                  .source = "acarnley2002, chapter 5",
                  .requirement = "holding_factor",
                  .worst = WorstPhase::standstill},
      always,
      [](const auto& d) { return back_driving_torque(d, d.holding_force); },
      [](const auto& d) { return d.require(holding_factor) * d.motor.static_torque; });
  visit(
      Declaration{.id = "C-ST-BACK",
                  .title = "Back-driving with power off",
                  .symbol = "T_b",
                  .unit = "N.m",
                  .source = "thk_catalogue, rotational torque; sander, 4.2",
                  .requirement = "detent_factor",
                  .worst = WorstPhase::standstill},
      [](const auto& d) { return d.data->vertical ? Applies::yes : Applies::no; },
      [](const auto& d) { return power_off_torque(d); },
      [](const auto& d) { return larger(d.require(detent_factor) * d.motor.detent_torque, brake_capacity(d)); });
  visit(
      Declaration{.id = "C-ST-START",
                  .title = "Speed over the first full step of a ramp against the start-stop speed",
                  .symbol = "ω_1",
                  .unit = "rpm",
                  .source = "millwright_derivations, energy of the rotor in the field's potential well",
                  .requirement = "start_rate_factor"},
      always,
      [](const auto& d) { return first_step_speed(d); },
      [](const auto& d) { return d.require(start_rate_factor) * start_stop_speed(d); });
  visit(
      Declaration{.id = "C-DR-VOLT",
                  .title = "Driver voltage",
                  .symbol = "V",
                  .unit = "V",
                  .source = "millwright_derivations, braking raises the bus voltage",
                  .requirement = "driver_voltage_factor"},
      always,
      [](const auto& d) { return d.motor.voltage; },
      [](const auto& d) { return d.require(driver_voltage_factor) * d.motor.driver_largest_voltage; });
  visit(
      Declaration{.id = "F-DRIVER-VOLTAGE-MIN",
                  .title = "Driver runs at the supply voltage",
                  .symbol = "V",
                  .unit = "V",
                  .kind = ConstraintKind::fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.motor.driver_least_voltage; },
      [](const auto& d) { return d.motor.voltage; });
}

/// The speed of an axis whose travel is a length.
template <class Visit>
void travel_speed_constraint(Visit&& visit) {
  visit(
      Declaration{.id = "C-SYS-SPEED",
                  .title = "Rapid speed against every speed limit",
                  .symbol = "v",
                  .unit = "mm/s",
                  .source = "millwright_derivations, smallest of the speed limits",
                  .worst = WorstPhase::speed},
      always,
      [](const auto& d) { return d.cycle.peak_speed; },
      [](const auto& d) { return speed_limit(d); });
}

/// Current and heat of the motor, and what else is reported of it.
template <class Visit>
void motor_current_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  namespace st = mechanics::stepper;
  visit(
      Declaration{.id = "C-DR-CURRENT",
                  .title = "Driver gives the current asked for",
                  .symbol = "k I_r",
                  .unit = "A",
                  .kind = ConstraintKind::soft,
                  .source = "millwright_derivations, current that a driver gives",
                  .requirement = "current_factor"},
      always,
      [](const auto& d) { return d.motor.asked_current; },
      [](const auto& d) { return d.motor.driver_peak_current; });
  // A sine of the amplitude sqrt(2) I_r in both phases heats like direct currents I_r in both, for which makers rate.
  visit(
      Declaration{.id = "C-DR-MOTORI",
                  .title = "Current set at the driver over the motor's rated current",
                  .symbol = "I_p/I_r",
                  .unit = "1",
                  .source = "acarnley2002, chapter 5",
                  .requirement = "current_factor"},
      always,
      [](const auto& d) { return d.motor.current_ratio; },
      [](const auto& d) { return decltype(d.peak_speed)(std::numbers::sqrt2); });
  visit(
      Declaration{.id = "C-ST-TEMP",
                  .title = "Winding above ambient temperature",
                  .symbol = "ΔT_w",
                  .unit = "K",
                  .kind = ConstraintKind::soft,
                  .source = "millwright_derivations, heat balance of the winding; iec60034_1",
                  .requirement = "winding_temperature_rise",
                  .worst = WorstPhase::cycle},
      always,
      [](const auto& d) { return steady_winding_rise(d); },
      [](const auto& d) { return d.require(winding_temperature_rise, dimension::temperature); });
  visit(
      Declaration{.id = "C-ST-RES",
                  .title = "Step rate away from the motor's resonance, full and half steps",
                  .symbol = "ln r",
                  .unit = "1",
                  .kind = ConstraintKind::soft,
                  .source = "acarnley2002, chapter 6",
                  .requirement = "resonance_distance"},
      [](const auto& d) { return d.data->microsteps <= 2.0 ? Applies::yes : Applies::no; },
      [](const auto& d) { return log(d.require(resonance_distance)); },
      [](const auto& d) { return distance_from_resonance(d); });
  visit(
      Declaration{.id = "C-ST-POWER",
                  .title = "Output power against the rating of a winding, paper rule",
                  .symbol = "P",
                  .unit = "W",
                  .kind = ConstraintKind::soft,
                  .source = "torch_table, motor power",
                  .requirement = "output_power_factor",
                  .worst = WorstPhase::torque},
      [](const auto& d) { return d.data->require.known(output_power_factor) ? Applies::yes : Applies::no; },
      [](const auto& d) { return largest_output_power(d); },
      [](const auto& d) {
        return d.require(output_power_factor) * st::copper_loss(d.motor.rated_current, d.motor.resistance);
      });
}

/// Resolution, lost motion and the error budget: checked where the problem states what is required.
template <class Visit>
void accuracy_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  visit(
      Declaration{.id = "C-ACC-RES",
                  .title = "Resolution",
                  .symbol = "Δx",
                  .unit = "um",
                  .source = "sander, travel of one step",
                  .requirement = "resolution_fraction"},
      [](const auto& d) { return d.data->require.known(position_error) ? Applies::yes : Applies::no; },
      [](const auto& d) { return resolution(d); },
      [](const auto& d) { return d.require(resolution_fraction) * d.require(position_error, dimension::length); });
  visit(
      Declaration{.id = "C-ACC-TOTAL",
                  .title = "Position error budget",
                  .symbol = "e",
                  .unit = "um",
                  .source = "slocum1992, chapter 2",
                  .requirement = "position_error",
                  .worst = WorstPhase::steady,
                  .place = WorstPlace::nut_softest},
      [](const auto& d) { return d.data->require.known(position_error) ? Applies::yes : Applies::no; },
      [](const auto& d) { return error_budget(d).total(); },
      [](const auto& d) { return d.require(position_error, dimension::length); });
  visit(
      Declaration{.id = "C-ACC-LOST",
                  .title = "Lost motion on reversal",
                  .symbol = "Δ",
                  .unit = "um",
                  .source = "millwright_derivations, lost motion",
                  .requirement = "lost_motion",
                  .place = WorstPlace::nut_softest},
      [](const auto& d) { return d.data->require.known(lost_motion) ? Applies::yes : Applies::no; },
      [](const auto& d) { return reversal_error(d) + 2.0 * turning_give_under_friction(d); },
      [](const auto& d) { return d.require(lost_motion, dimension::length); });
  visit(
      Declaration{.id = "C-ACC-MICRO",
                  .title = "Friction against the torque of one microstep",
                  .symbol = "T_f",
                  .unit = "N.m",
                  .kind = ConstraintKind::soft,
                  .source = "acarnley2002, chapter 5"},
      always,
      [](const auto& d) { return friction_torque(d); },
      [](const auto& d) {
        return mechanics::stepper::microstep_torque(d.motor.static_torque, decltype(d.peak_speed)(d.data->microsteps));
      });
}

}  // namespace millwright::machine
