// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "mechanics/formula_definition.h"
#include "mechanics/motion.h"
#include "mechanics/s_curve.h"

namespace millwright::mechanics {

void define_motion(FormulaList& list) {
  define(
      list,
      {.name = "motion.trapezoidal_peak_speed",
       .handbook_id = "MOTION-TRAP-PEAK-SPEED",
       .symbol = "v_p",
       .unit = "m/s",
       .title = "Peak speed of a trapezoidal or triangular move",
       .source = "biagiotti_melchiorri2008, section 3.2"},
      [](const auto&... x) { return motion::trapezoidal_peak_speed(x...); },
      quantity("distance", "s", "m", "distance of the move").rising(),
      quantity("speed_limit", "v_lim", "m/s", "speed limit").rising(),
      quantity("acceleration", "a", "m/s^2", "acceleration").rising(),
      quantity("deceleration", "d", "m/s^2", "deceleration, positive").rising());

  define(
      list,
      {.name = "motion.trapezoidal_time",
       .handbook_id = "MOTION-TRAP-TIME",
       .symbol = "t",
       .unit = "s",
       .title = "Duration of a trapezoidal or triangular move",
       .source = "millwright_derivations"},
      [](const auto&... x) { return motion::trapezoidal_time(x...); },
      quantity("distance", "s", "m", "distance of the move").rising(),
      quantity("speed_limit", "v_lim", "m/s", "speed limit").falling(),
      quantity("acceleration", "a", "m/s^2", "acceleration").falling(),
      quantity("deceleration", "d", "m/s^2", "deceleration, positive").falling());

  define(
      list,
      {.name = "motion.required_acceleration",
       .handbook_id = "MOTION-TRAP-ACC-REQUIRED",
       .symbol = "a",
       .unit = "m/s^2",
       .title = "Acceleration that covers a distance in a time",
       .source = "millwright_derivations, inversion of trapezoidal_time",
       .validity = "speed_limit * time > distance"},
      [](const auto&... x) { return motion::required_acceleration(x...); },
      quantity("distance", "s", "m", "distance of the move").rising(),
      quantity("time", "t", "s", "time allowed for the move").falling(),
      quantity("speed_limit", "v_lim", "m/s", "speed limit").falling())
      .valid_when("speed_limit * time > distance",
                  [](double distance, double time, double speed_limit) { return speed_limit * time > distance; });

  define(
      list,
      {.name = "motion.trapezoidal_rms_speed",
       .handbook_id = "MOTION-TRAP-RMS-SPEED",
       .symbol = "v_rms",
       .unit = "m/s",
       .title = "RMS speed of a trapezoidal move",
       .source = "millwright_derivations"},
      [](const auto&... x) { return motion::trapezoidal_rms_speed(x...); },
      quantity("distance", "s", "m", "distance of the move").rising(),
      quantity("speed_limit", "v_lim", "m/s", "speed limit"),
      quantity("acceleration", "a", "m/s^2", "acceleration"),
      quantity("deceleration", "d", "m/s^2", "deceleration, positive"));

  define(
      list,
      {.name = "motion.trapezoidal_rms_acceleration",
       .handbook_id = "MOTION-TRAP-RMS-ACC",
       .symbol = "a_rms",
       .unit = "m/s^2",
       .title = "RMS acceleration of a trapezoidal move",
       .source = "millwright_derivations"},
      [](const auto&... x) { return motion::trapezoidal_rms_acceleration(x...); },
      quantity("distance", "s", "m", "distance of the move").falling(),
      quantity("speed_limit", "v_lim", "m/s", "speed limit").rising(),
      quantity("acceleration", "a", "m/s^2", "acceleration").rising(),
      quantity("deceleration", "d", "m/s^2", "deceleration, positive").rising());

  define(
      list,
      {.name = "motion.s_curve_peak_speed",
       .handbook_id = "MOTION-SCURVE-PEAK-SPEED",
       .symbol = "v_p",
       .unit = "m/s",
       .title = "Peak speed of a jerk-limited move",
       .source = "biagiotti_melchiorri2008, section 3.4"},
      [](const auto&... x) { return motion::s_curve_peak_speed(x...); },
      quantity("distance", "s", "m", "distance of the move").rising(),
      quantity("speed_limit", "v_lim", "m/s", "speed limit").rising(),
      quantity("acceleration_limit", "a", "m/s^2", "acceleration limit").rising(),
      quantity("jerk_limit", "j", "m/s^3", "jerk limit").rising());

  define(
      list,
      {.name = "motion.s_curve_time",
       .handbook_id = "MOTION-SCURVE-TIME",
       .symbol = "t",
       .unit = "s",
       .title = "Duration of a jerk-limited move",
       .source = "biagiotti_melchiorri2008, section 3.4"},
      [](const auto&... x) { return motion::s_curve_time(x...); },
      quantity("distance", "s", "m", "distance of the move").rising(),
      quantity("speed_limit", "v_lim", "m/s", "speed limit").falling(),
      quantity("acceleration_limit", "a", "m/s^2", "acceleration limit").falling(),
      quantity("jerk_limit", "j", "m/s^3", "jerk limit").falling());

  define(
      list,
      {.name = "motion.s_curve_peak_acceleration",
       .handbook_id = "MOTION-SCURVE-PEAK-ACC",
       .symbol = "a_p",
       .unit = "m/s^2",
       .title = "Peak acceleration of a jerk-limited move",
       .source = "biagiotti_melchiorri2008, section 3.4"},
      [](const auto&... x) { return motion::s_curve_peak_acceleration(x...); },
      quantity("distance", "s", "m", "distance of the move").rising(),
      quantity("speed_limit", "v_lim", "m/s", "speed limit").rising(),
      quantity("acceleration_limit", "a", "m/s^2", "acceleration limit").rising(),
      quantity("jerk_limit", "j", "m/s^3", "jerk limit").rising());

  define(
      list,
      {.name = "motion.s_curve_rms_acceleration",
       .handbook_id = "MOTION-SCURVE-RMS-ACC",
       .symbol = "a_rms",
       .unit = "m/s^2",
       .title = "RMS acceleration of a jerk-limited move",
       .source = "biagiotti_melchiorri2008, section 3.4"},
      [](const auto&... x) { return motion::s_curve_rms_acceleration(x...); },
      quantity("distance", "s", "m", "distance of the move"),
      quantity("speed_limit", "v_lim", "m/s", "speed limit"),
      quantity("acceleration_limit", "a", "m/s^2", "acceleration limit"),
      quantity("jerk_limit", "j", "m/s^3", "jerk limit"));

  define(
      list,
      {.name = "motion.s_curve_rms_speed",
       .handbook_id = "MOTION-SCURVE-RMS-SPEED",
       .symbol = "v_rms",
       .unit = "m/s",
       .title = "RMS speed of a jerk-limited move",
       .source = "biagiotti_melchiorri2008, section 3.4"},
      [](const auto&... x) { return motion::s_curve_rms_speed(x...); },
      quantity("distance", "s", "m", "distance of the move").rising(),
      quantity("speed_limit", "v_lim", "m/s", "speed limit"),
      quantity("acceleration_limit", "a", "m/s^2", "acceleration limit"),
      quantity("jerk_limit", "j", "m/s^3", "jerk limit"));

  define(
      list,
      {.name = "motion.s_curve_position",
       .handbook_id = "MOTION-SCURVE-POSITION",
       .symbol = "x",
       .unit = "m",
       .title = "Position during a jerk-limited move",
       .source = "biagiotti_melchiorri2008, section 3.4"},
      [](const auto&... x) { return motion::s_curve_position(x...); },
      quantity("time", "τ", "s", "time since the start").rising(),
      quantity("distance", "s", "m", "distance of the move"),
      quantity("speed_limit", "v_lim", "m/s", "speed limit"),
      quantity("acceleration_limit", "a", "m/s^2", "acceleration limit"),
      quantity("jerk_limit", "j", "m/s^3", "jerk limit"));

  define(
      list,
      {.name = "motion.cycle_rms",
       .handbook_id = "MOTION-DUTY-RMS",
       .symbol = "x_rms",
       .unit = "any",
       .title = "RMS of a quantity over a duty cycle",
       .source = "oriental_motor_sizing, effective load torque"},
      [](const auto&... x) { return motion::cycle_rms(x...); },
      list_of("values", "x", "any", "value in each phase").any_sign(),
      list_of("durations", "t", "s", "duration of each phase, dwells included").as_long_as(0));

  define(
      list,
      {.name = "motion.cycle_mean_speed",
       .handbook_id = "MOTION-DUTY-MEAN-SPEED",
       .symbol = "v_m",
       .unit = "m/s",
       .title = "Mean speed over a duty cycle",
       .source = "millwright_derivations"},
      [](const auto&... x) { return motion::cycle_mean_speed(x...); },
      list_of("distances", "s", "m", "distance of each phase").any_sign(),
      list_of("durations", "t", "s", "duration of each phase, dwells included").as_long_as(0));

  define(
      list,
      {.name = "motion.ramp_rms",
       .handbook_id = "MOTION-RAMP-RMS",
       .symbol = "x_rms",
       .unit = "any",
       .title = "RMS of a linear ramp",
       .source = "millwright_derivations"},
      [](const auto&... x) { return motion::ramp_rms(x...); },
      quantity("start_value", "x_1", "any", "value at the start of the ramp").any_sign(),
      quantity("end_value", "x_2", "any", "value at its end").any_sign());

  define(
      list,
      {.name = "motion.pulse_rms",
       .handbook_id = "MOTION-PULSE-RMS",
       .symbol = "x_rms",
       .unit = "any",
       .title = "RMS of an interrupted load",
       .source = "millwright_derivations"},
      [](const auto&... x) { return motion::pulse_rms(x...); },
      quantity("value", "x", "any", "value while it acts").rising(),
      quantity("on_fraction", "q", "1", "fraction of the time it acts").between(0, 1).rising());

  define(
      list,
      {.name = "motion.duty_factor",
       .handbook_id = "MOTION-DUTY-FACTOR",
       .symbol = "q",
       .unit = "1",
       .title = "Duty factor",
       .source = "millwright_derivations",
       .validity = "on_time <= cycle_time"},
      [](const auto&... x) { return motion::duty_factor(x...); },
      quantity("on_time", "t_on", "s", "time under load in a cycle").rising(),
      quantity("cycle_time", "t_cycle", "s", "duration of the cycle").falling())
      .valid_when("on_time <= cycle_time", [](double on_time, double cycle_time) { return on_time <= cycle_time; });

  define(
      list,
      {.name = "motion.arc_speed",
       .handbook_id = "MOTION-ARC-SPEED",
       .symbol = "v",
       .unit = "m/s",
       .title = "Largest path speed on an arc",
       .source = "millwright_derivations"},
      [](const auto&... x) { return motion::arc_speed(x...); },
      quantity("acceleration", "a", "m/s^2", "permissible centripetal acceleration of the slower axis").rising(),
      quantity("radius", "r", "m", "radius of the path").rising());

  define(
      list,
      {.name = "motion.corner_speed",
       .handbook_id = "MOTION-CORNER-SPEED",
       .symbol = "v",
       .unit = "m/s",
       .title = "Largest path speed through a corner",
       .source = "grbl_planner"},
      [](const auto&... x) { return motion::corner_speed(x...); },
      quantity("acceleration", "a", "m/s^2", "acceleration").rising(),
      quantity("deviation", "δ", "m", "permitted deviation from the corner").rising(),
      quantity("corner_angle", "θ", "rad", "angle between the segments, pi is straight on")
          .between(0, std::numbers::pi)
          .typical(0.1, 3.0));
}

}  // namespace millwright::mechanics
