// SPDX-License-Identifier: Apache-2.0
//
// Constraints of a ball screw, each declared once (see constraint.h).
#pragma once

#include "machine/ball_screw_life.h"
#include "machine/motor_constraints.h"
#include "machine/screw_drive_quantities.h"

namespace millwright::machine {

inline constexpr auto when_ball = [](const auto& d) { return d.ball(); };
inline constexpr auto when_preloaded = [](const auto& d) { return d.data->preloaded ? d.ball() : Applies::no; };

/// Life, static safety, stability, speed and preload of a ball screw.
template <class Visit>
void ball_screw_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  namespace bs = mechanics::ball_screw;
  visit(
      Declaration{.id = "C-BS-LIFE",
                  .title = "Ball screw life",
                  .symbol = "L_h",
                  .unit = "h",
                  .source = "iso3408_5, clause 7",
                  .requirement = "life",
                  .worst = WorstPhase::cycle},
      when_ball,
      [](const auto& d) { return d.require(life, dimension::time); },
      [](const auto& d) { return ball_screw_life(d); });
  visit(
      Declaration{.id = "C-BS-STATIC",
                  .title = "Ball screw static safety",
                  .symbol = "f_s F",
                  .unit = "N",
                  .source = "thk_catalogue, A15",
                  .requirement = "static_safety",
                  .worst = WorstPhase::force},
      when_ball,
      [](const auto& d) { return d.require(static_safety) * static_load(d); },
      [](const auto& d) { return d.screw.static_rating; });
  visit(
      Declaration{.id = "C-BS-AXIAL",
                  .title = "Axial stress of the ball screw shaft",
                  .symbol = "F",
                  .unit = "N",
                  .source = "thk_catalogue, A15",
                  .requirement = "permissible_axial_stress",
                  .worst = WorstPhase::force},
      when_ball,
      [](const auto& d) { return d.largest_force; },
      [](const auto& d) { return d.screw.permissible_axial_load; });
  visit(
      Declaration{.id = "C-BS-BUCK",
                  .title = "Ball screw buckling",
                  .symbol = "F",
                  .unit = "N",
                  .source = "thk_catalogue, A15",
                  .worst = WorstPhase::force,
                  .place = WorstPlace::nut_far},
      when_ball,
      [](const auto& d) { return d.largest_force; },
      [](const auto& d) { return d.screw.buckling_load; });
  visit(
      Declaration{.id = "C-BS-NCRIT",
                  .title = "Ball screw critical speed",
                  .symbol = "ω",
                  .unit = "rpm",
                  .source = "thk_catalogue, A15",
                  .worst = WorstPhase::speed,
                  .place = WorstPlace::nut_far},
      [](const auto& d) { return d.data->nut_rotates ? Applies::no : d.ball(); },
      [](const auto& d) { return d.screw_speed; },
      [](const auto& d) { return d.screw.critical_speed; });
  visit(
      Declaration{.id = "C-BS-DN",
                  .title = "Ball speed (DN value)",
                  .symbol = "DN",
                  .unit = "mm.rpm",
                  .source = "thk_catalogue, A15",
                  .worst = WorstPhase::speed},
      when_ball,
      [](const auto& d) { return bs::speed_value(d.screw.pitch_circle, d.screw_speed); },
      [](const auto& d) { return d.screw.speed_value_limit; });
  visit(
      Declaration{.id = "C-BS-PREMIN",
                  .title = "Preload keeps the nut free of play",
                  .symbol = "F_pr",
                  .unit = "N",
                  .kind = ConstraintKind::soft,
                  .source = "iso3408_5, section 7.1.3",
                  .worst = WorstPhase::force},
      when_preloaded,
      [](const auto& d) { return bs::required_preload(d.largest_force); },
      [](const auto& d) { return d.screw.preload; });
  visit(
      Declaration{.id = "C-BS-PREMAX",
                  .title = "Preload over the dynamic load rating",
                  .symbol = "F_pr/C",
                  .unit = "1",
                  .source = "thk_catalogue, preload",
                  .requirement = "largest_preload_fraction"},
      when_preloaded,
      [](const auto& d) { return decltype(d.peak_speed)(d.data->preload_fraction); },
      [](const auto& d) { return d.require(largest_preload_fraction); });
}

}  // namespace millwright::machine
