// SPDX-License-Identifier: Apache-2.0
//
// Motor, driver and reduction of a drive on numbers that remember their formulas, for the drives of traced_drives.cpp
// and traced_geared_drives.cpp.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>

#include "evaluation/traced_elements.h"

namespace millwright::evaluation {

inline constexpr FigureName motor_names[] = {{"T_H", "holding torque of the motor", "N.m"},
                                             {"T_det", "detent torque of the motor", "N.m"},
                                             {"I_r", "rated current of the motor", "A"},
                                             {"R", "resistance of a winding", "ohm"},
                                             {"L_w", "inductance of a winding", "mH"},
                                             {"J_r", "rotor inertia", "kg.cm2"},
                                             {"N_r", "teeth of the rotor", "1"},
                                             {"I_d", "largest current of the driver", "A"},
                                             {"V_max", "largest voltage of the driver", "V"},
                                             {"V_min", "least voltage of the driver", "V"},
                                             {"V", "supply voltage", "V"},
                                             {"I_a", "current asked for", "A"}};

inline constexpr auto walk_motor_figures = [](auto& f, auto&& visit) {
  for (auto* field : {&f.holding_torque,
                      &f.detent_torque,
                      &f.rated_current,
                      &f.resistance,
                      &f.inductance,
                      &f.rotor_inertia,
                      &f.rotor_teeth,
                      &f.driver_peak_current,
                      &f.driver_largest_voltage,
                      &f.driver_least_voltage,
                      &f.voltage,
                      &f.asked_current})
    visit(*field);
};

inline constexpr FigureName reduction_names[] = {{"i", "ratio of the reduction", "1"},
                                                 {"η_g", "efficiency of the reduction", "1"},
                                                 {"J_g", "inertia of the reduction at its input", "kg.cm2"},
                                                 {"β_g", "play of the reduction at its output", "deg"},
                                                 {"c_g", "compliance of the reduction at its output", "rad/(N.m)"},
                                                 {"T_g", "rated torque of the reduction", "N.m"},
                                                 {"ω_g", "largest input speed of the reduction", "rpm"},
                                                 {"d_g", "output shaft of the reduction", "mm"},
                                                 {"m_g", "mass of the reduction", "kg"}};

/// Torques of published curves, each a given figure: the sheet has the curve's name, not its points.
struct CurveReader {
  const char* symbol;   ///< "T_po"
  const char* meaning;  ///< "torque of the published curve at {}"
  GivenFigures& given;
  std::map<double, scalar::Traced> known = {};  ///< by speed [rad/s]

  scalar::Traced operator()(double speed, double torque) {
    if (const auto place = known.find(speed); place != known.end()) return place->second;
    const std::string each = fmt::format("{},{}", symbol, known.size() + 1);
    const std::string said = fmt::format(fmt::runtime(meaning), scalar::format(speed, scalar::Unit::of("rpm"), 4));
    return known[speed] = given.take({each.c_str(), said.c_str(), "N.m"}, torque);
  }
};

/// The available torque of a motor, as torque_beside has it.
struct TracedTorque {
  const MotorPair& pair;
  std::size_t voltage;
  machine::MotorFigures<scalar::Traced> figures;
  scalar::Traced current;
  std::function<double(double)> value;
  CurveReader curve, ceiling;
  std::optional<scalar::Traced> share = std::nullopt;

  scalar::Traced operator()(const scalar::Traced& omega) {
    const mechanics::PullOutCurve *below = pair.curve_at(voltage), *above = pair.ceiling_at(voltage);
    if (below != nullptr && omega.value < below->end()) return curve(omega.value, value(omega.value));
    scalar::Traced torque = machine::modelled_torque(figures, current, omega);
    if (pair.is_modelled(voltage)) return scalar::named("T_av", torque);
    if (!share)
      share = curve.given.take({"k_e", "share of the estimated torque that counts beside published curves", "1"},
                               pair.at->model_share);
    torque = *share * torque;
    if (above != nullptr) torque = smaller(torque, ceiling(omega.value, (*above)(omega.value)));
    if (below != nullptr) torque = smaller(torque, curve(below->last_speed(), below->points().back().torque));
    return scalar::named("T_av", torque);
  }
};

/// What the moves and the supply start from: force and feed of the cuts, and the input of a drive.
template <class TracedDrive>
void trace_derived(const TracedDrive& d, ElementWorksheet& sheet) {
  using scalar::Traced;
  const std::vector<machine::Move>& moves = d.data->motion.moves;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!moves[i].cutting) continue;
    const std::string name = moves[i].name.empty() ? fmt::format("move {}", i + 1) : moves[i].name;
    sheet.derived.push_back({name,
                             "Cutting force along the axis, every tooth in the cut at its thickest chip",
                             "F_c",
                             "N",
                             machine::cutting_force<Traced>(*moves[i].cutting)});
    sheet.derived.push_back({name, "Feed of the cut", "v_f", "mm/s", machine::cutting_feed<Traced>(*moves[i].cutting)});
  }
  sheet.derived.push_back(
      {"", "Electrical input of the drive in its hardest ramp, rounded up to whole watts", "P_in", "W", d.input_power});
}

/// Motor, driver and reduction of `from` for the drive `to`, from the figures of the catalogue on.
template <class Stage, class Drive, class TracedDrive>
void trace_motor(
    const Stage& stage, const Drive& from, const ChosenRows& chosen, GivenFigures& given, TracedDrive& to) {
  using scalar::Traced;
  const MotorPair& pair = stage.motors().pairs()[chosen.rows[Stage::motor_slot]];
  machine::MotorFigures<Traced> figures;
  given.take_all(motor_names, pair.figures_at(chosen.voltage), figures, walk_motor_figures);
  to.motor = machine::motor_reading(
      figures, given.take({"k_T", "permitted share of the available torque", "1"}, from.motor.torque_margin));
  to.motor_shaft = given.take({"d_m", "shaft of the motor", "mm"}, from.motor_shaft);
  to.motor_mass = given.take({"m_m", "mass of the motor", "kg"}, from.motor_mass);
  to.available_torque = TracedTorque{pair,
                                     chosen.voltage,
                                     figures,
                                     to.motor.current,
                                     from.available_torque,
                                     {"T_po", "torque of the published curve at {}", given},
                                     {"T_hi", "torque published at more voltage or current, at {}", given}};
  to.reduction.present = from.reduction.present;
  to.reduction.torque_is_rated = from.reduction.torque_is_rated;
  to.reduction.speed_is_rated = from.reduction.speed_is_rated;
  if (from.reduction.present)
    given.take_all(reduction_names, from.reduction, to.reduction, [](auto& r, auto&& visit) {
      machine::visit_reduction_reading(r, visit);
    });
  to.acceleration_time = given.take({"t_a", "time of a ramp", "s"}, from.acceleration_time);
}

}  // namespace millwright::evaluation
