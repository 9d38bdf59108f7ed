// SPDX-License-Identifier: Apache-2.0
//
// What an axis slides on: carriages on profile rails, or ball bushings on round shafts. Four carriages share the load
// by the rigid-table formulas; a single carriage takes the moments itself.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "machine/axis_motion.h"
#include "machine/carried_forces.h"
#include "machine/constraint.h"
#include "machine/motor_constraints.h"
#include "machine/tool_chain.h"
#include "mechanics/guide.h"
#include "mechanics/tool_point.h"

namespace millwright::machine {

template <class T>
struct GuideReading {
  T dynamic_rating{}, static_rating{}, rating_distance{};
  T roll_moment_rating{}, pitch_moment_rating{}, yaw_moment_rating{};
  T carriage_mass{}, rail_mass{}, rail_length{}, largest_rail_length{};
  T shaft_diameter{};    ///< unsupported round shaft, else 0
  T friction{};          ///< of a bushing; NaN where the catalogue has none
  T radial_stiffness{};  ///< N/m, of a carriage; read where a tool must not give way
};

template <class Reading, class Visit>
void visit_guide_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.dynamic_rating,
                      &r.static_rating,
                      &r.rating_distance,
                      &r.roll_moment_rating,
                      &r.pitch_moment_rating,
                      &r.yaw_moment_rating,
                      &r.carriage_mass,
                      &r.rail_mass,
                      &r.rail_length,
                      &r.largest_rail_length,
                      &r.shaft_diameter,
                      &r.friction,
                      &r.radial_stiffness})
    visit(*field);
}
inline constexpr std::size_t guide_reading_fields = 13;
inline constexpr std::size_t guide_readings_needed = 11;  ///< the next is for a soft check only

/// Whether the rails of an axis that is not vertical stand on a face. An inclined axis leans on a direction only if it
/// is known which one it travels in.
inline bool rails_on_face(const Axis& axis) {
  const bool known = axis.direction == Direction::horizontal || (axis.direction == Direction::inclined && axis.along);
  return known && axis.normal && *axis.normal != upright;
}

struct GuideData {
  GuideChoice choice;
  MotionData motion;
  Requirements require;
  double riding_mass = 0.0;  ///< kg, allowance for the nut or belt, chosen after the guide
  bool on_face = false;      ///< weight draws across the rails, not on them
  CarriedForces carried = {};
  double lifting_acceleration = 0.0;  ///< m/s^2, of the axes that carry this one, what of it is upwards
};

/// Round guide shafts are hardened bearing steel; E as in the materials table, and the core's yield as of the C45 it is
/// drawn from.
inline constexpr double guide_shaft_modulus = 206e9;
inline constexpr double guide_shaft_yield = 345e6;

template <class T>
struct GuideSystem {
  const GuideData* data = nullptr;
  GuideReading<T> guide;
  Applies unsupported_shaft = Applies::no;
  Applies bushings = Applies::no;  ///< slide on round shafts, supported or not
  T carried_mass{}, acceleration_time{};

  T moved_mass{};
  Cycle<T> cycle;
  std::vector<T> carriage_loads;  ///< N, on the most loaded carriage, phase by phase; empty if it is the same in all
  T largest_load{}, static_load{}, life_load{};
  T shaft_force{}, sloping_force{};  ///< N, on one round shaft, that bend it or its slope as far

  [[nodiscard]] T require(Requirement requirement, const scalar::Dimension& dimension = scalar::dimension::none) const {
    return scalar::in_unit<T>(data->require(requirement), dimension);
  }
  void derive();
};

template <class T>
void GuideSystem<T>::derive() {
  using namespace scalar;
  namespace gd = mechanics::guide;
  const auto length = [](double metres) { return in_unit<T>(metres, dimension::length); };
  const GuideChoice& c = data->choice;
  moved_mass = named("m", carried_mass + guide.carriage_mass + in_unit<T>(data->riding_mass, dimension::mass));
  cycle = duty_cycle(data->motion, moved_mass, acceleration_time);
  const T weight = named("G", pull_of_mass(moved_mass, data->lifting_acceleration));
  const T none = in_unit<T>(0.0, dimension::force);
  // On a slope one part of the weight presses on the guides and the other pulls along them.
  const double steep = std::sin(data->motion.inclination);
  const double level = std::abs(std::cos(data->motion.inclination));
  const T across = level < 1e-9 ? none : level * weight;
  const auto carried = [&](const char* symbol, double newtons) {
    return newtons == 0.0 ? none : T(named(symbol, in_unit<T>(newtons, dimension::force)));
  };
  const T from_above = carried("F_n", data->carried.pressing);
  const T from_aside = carried("F_q", data->carried.sideways);
  const T pressing = data->on_face ? none : across;
  const T sideways = data->on_face ? across : none;
  const T pulling = steep < 1e-9 ? none : steep * weight;
  // What pulls, and the mass where it accelerates, turns the slide by its height above the line of the drive; on a
  // steep axis an offset along x is the distance from the rails and such a lever too.
  const double height = std::max(std::abs(c.load_height), steep < 1e-9 ? 0.0 : std::abs(c.load_offset_x));
  const T steady_pitch = named("M_y",
                               pressing * length(std::abs(c.load_offset_x)) + pulling * length(height) +
                                   cycle.process_force * length(data->carried.own_height_arm) +
                                   from_above * length(data->carried.along_arm));
  const T roll =
      named("M_x",
            pressing * length(std::abs(c.load_offset_y)) + sideways * length(std::abs(c.load_height)) +
                from_above * length(data->carried.across_arm) + from_aside * length(data->carried.height_arm));
  const T steady_yaw = named(
      "M_z",
      pulling * length(std::abs(c.load_offset_y)) + sideways * length(std::abs(c.load_offset_x)) +
          cycle.process_force * length(data->carried.own_across_arm) + from_aside * length(data->carried.along_arm));
  const T on_rails = pressing + from_above, across_rails = sideways + from_aside;
  const auto load = [&](const T& inertia) {
    const T pitch = steady_pitch + inertia * length(height);
    const T yaw = steady_yaw + inertia * length(std::abs(c.load_offset_y));
    if (c.carriages > 1.0)
      return gd::largest_carriage_load(
          on_rails, roll, pitch, across_rails, yaw, length(c.carriage_spacing), length(c.rail_spacing));
    const std::array<T, 3> moments{roll, pitch, yaw};
    const std::array<T, 3> ratings{guide.roll_moment_rating, guide.pitch_moment_rating, guide.yaw_moment_rating};
    return gd::equivalent_load_with_moments(
        on_rails, across_rails, std::span<const T>(moments), std::span<const T>(ratings), guide.static_rating);
  };
  // A carriage that carries nothing lives for ever: one newton keeps the life finite and harmless.
  const T one = in_unit<T>(1.0, dimension::force);
  if (height == 0.0 && c.load_offset_y == 0.0) {  // accelerating loads the carriages no more than resting
    largest_load = named("P", load(none));
    life_load = larger(largest_load, one);
  } else {
    T damage = in_unit<T>(0.0, power(dimension::force, 3.0) * dimension::length);
    make_room(cycle.phases.size(), carriage_loads);
    for (const Phase<T>& phase : cycle.phases) {
      carriage_loads.push_back(load(moved_mass * absolute(phase.acceleration)));
      damage = damage + cube(T(larger(carriage_loads.back(), one))) * phase.mean_speed * phase.duration;
    }
    largest_load = named("P", largest(carriage_loads));
    life_load = named("P_m", cbrt(damage / cycle.travelled));
  }
  static_load = larger(largest_load, one);
  T turning = steady_pitch + steady_yaw;
  if (height != 0.0 || c.load_offset_y != 0.0) {
    Largest<T> inertia;
    for (const Phase<T>& phase : cycle.phases) inertia.take(moved_mass * absolute(phase.acceleration));
    turning = turning + inertia.value() * length(height + std::abs(c.load_offset_y));
  }
  // What presses on a shaft is halved by its two bushings; a rolling moment presses one shaft down and lifts the other.
  // A moment about an axis across the travel, upright or sideways, is a couple of forces on its bushings: over its
  // whole way it bends a shaft of the length L no more than M (L - s)/L, and by no more than M L^2/(9 sqrt 3 EI), which
  // 4 M/L more of force in the middle exceeds. The slope of a bushing in the middle is M L/(12 EI) at most.
  shaft_force = sloping_force = (across + cycle.process_force + from_above + from_aside) / c.rails;
  if (c.carriages > 1.0) {
    const T even = shaft_force + roll / length(c.rail_spacing);
    const T couple = named("M_s", turning / c.rails);
    shaft_force = even + 4.0 * couple / guide.rail_length;
    sloping_force = even + couple / length(c.carriage_spacing);
  }
  shaft_force = named("F_s", shaft_force);
  sloping_force = named("F_φ", sloping_force);
}

/// Whether bushings run freely on their shafts: reported, not enforced.
template <class Visit>
void guide_bushing_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  namespace gd = mechanics::guide;
  visit(
      Declaration{.id = "C-GD-SLOPE",
                  .title = "Slope of the guide shaft at its bushings",
                  .symbol = "φ",
                  .unit = "deg",
                  .kind = ConstraintKind::soft,
                  .source = "shigley, Table A-9; thomson_round_rail",
                  .requirement = "bushing_slope",
                  .place = WorstPlace::mid_span},
      [](const auto& d) { return d.unsupported_shaft; },
      [](const auto& d) {
        return gd::shaft_slope(d.sloping_force,
                               d.guide.rail_length,
                               in_unit_like(d.life_load, d.data->choice.carriage_spacing, dimension::length),
                               in_unit_like(d.life_load, guide_shaft_modulus, dimension::pressure),
                               d.guide.shaft_diameter);
      },
      [](const auto& d) {
        return d.require(d.data->choice.self_aligning ? bushing_slope_self_aligning : bushing_slope);
      });
  visit(
      Declaration{.id = "C-GD-BIND",
                  .title = "Bearing length against jamming of the bushings",
                  .symbol = "2μe",
                  .unit = "mm",
                  .kind = ConstraintKind::soft,
                  .source = "millwright_derivations, couple of a driving force beside the guide",
                  .requirement = "bushing_binding_factor"},
      [](const auto& d) { return d.data->choice.drive_offset ? d.bushings : Applies::no; },
      [](const auto& d) {
        using T = std::remove_cvref_t<decltype(d.life_load)>;
        const GuideChoice& c = d.data->choice;
        return gd::required_bushing_length(c.bushing_friction ? T(*c.bushing_friction) : d.guide.friction,
                                           in_unit<T>(c.drive_offset.value_or(0.0), dimension::length),
                                           d.require(bushing_binding_factor));
      },
      // The couple is taken by the two bushings of a shaft, from middle to middle.
      [](const auto& d) { return in_unit_like(d.life_load, d.data->choice.carriage_spacing, dimension::length); });
}

template <class Visit>
void guide_constraints(Visit&& visit) {
  using namespace scalar;
  using enum Requirement;
  namespace gd = mechanics::guide;
  constexpr auto on_shaft = [](const auto& d) { return d.unsupported_shaft; };
  visit(
      Declaration{.id = "C-GD-LIFE",
                  .title = "Guide life",
                  .symbol = "L_h",
                  .unit = "h",
                  .source = "hiwin_linear_guideway, service life; iso14728_1",
                  .requirement = "life",
                  .worst = WorstPhase::cycle},
      always,
      [](const auto& d) { return d.require(life, dimension::time); },
      [](const auto& d) {
        const auto distance = gd::ball_life_distance(d.guide.dynamic_rating,
                                                     d.life_load,
                                                     d.require(guide_load_factor),
                                                     decltype(d.life_load)(1.0),
                                                     d.guide.rating_distance);
        return gd::life_time(distance, d.cycle.travelled / d.cycle.total_time);
      });
  visit(
      Declaration{.id = "C-GD-STATIC",
                  .title = "Guide static safety",
                  .symbol = "f_s P",
                  .unit = "N",
                  .source = "thk_lm_guide, static safety factor",
                  .requirement = "guide_static_safety",
                  .worst = WorstPhase::load},
      always,
      [](const auto& d) { return d.require(guide_static_safety) * d.static_load; },
      [](const auto& d) { return d.guide.static_rating; });
  visit(
      Declaration{.id = "C-GD-DEFL",
                  .title = "Guide shaft deflection",
                  .symbol = "δ",
                  .unit = "mm",
                  .source = "shigley, Table A-9",
                  .requirement = "guide_shaft_deflection_ratio",
                  .place = WorstPlace::mid_span},
      on_shaft,
      [](const auto& d) {
        return gd::shaft_deflection(d.shaft_force,
                                    d.guide.rail_length,
                                    in_unit_like(d.life_load, d.data->choice.carriage_spacing, dimension::length),
                                    in_unit_like(d.life_load, guide_shaft_modulus, dimension::pressure),
                                    d.guide.shaft_diameter);
      },
      [](const auto& d) { return d.require(guide_shaft_deflection_ratio) * d.guide.rail_length; });
  visit(
      Declaration{.id = "C-GD-STRESS",
                  .title = "Guide shaft bending stress",
                  .symbol = "σ",
                  .unit = "MPa",
                  .source = "torch_table, eq. 13 and 14; khurmi_gupta2005, chapter 14",
                  .requirement = "guide_shaft_safety_factor",
                  .place = WorstPlace::mid_span},
      on_shaft,
      [](const auto& d) {
        return gd::shaft_stress(d.shaft_force,
                                d.guide.rail_length,
                                in_unit_like(d.life_load, d.data->choice.carriage_spacing, dimension::length),
                                d.guide.shaft_diameter);
      },
      [](const auto& d) {
        return in_unit_like(d.life_load, guide_shaft_yield, dimension::pressure) / d.require(guide_shaft_safety_factor);
      });
  guide_bushing_constraints(visit);
  visit(
      Declaration{.id = "C-SYS-RAIL",
                  .title = "Rail is sold in this length",
                  .symbol = "L",
                  .unit = "mm",
                  .source = "millwright_derivations, usable travel"},
      always,
      [](const auto& d) { return d.guide.rail_length; },
      [](const auto& d) { return d.guide.largest_rail_length; });
}

/// Four carriages: they press evenly, and a force beside them tilts them about the three axes. The lateral stiffness of
/// a carriage is taken as the radial one (rails with four equally loaded rows).
template <class T>
Compliance<T> tool_compliance(const GuideSystem<T>& d, const ToolPlace& place) {
  using namespace scalar;
  namespace tp = mechanics::tool_point;
  const auto arm = [](double metres) { return in_unit<T>(metres, dimension::length); };
  const GuideChoice& c = d.data->choice;
  const T& carriage = d.guide.radial_stiffness;
  const T all = c.carriages * carriage;
  const T pitch = mechanics::guide::pitch_stiffness(carriage, arm(c.carriage_spacing));
  const T roll = mechanics::guide::pitch_stiffness(carriage, arm(c.rail_spacing));
  const auto tilt = [&](double lever, const T& stiffness) { return T(tp::rotary_compliance(arm(lever), stiffness)); };
  Compliance<T> result = no_compliance<T>();
  result[place.travel] = tilt(place.height_arm, pitch);
  // Two drives side by side hold the table straight themselves.
  if (place.drives <= 1.0) result[place.travel] = result[place.travel] + tilt(place.across_arm, pitch);
  result[place.across] = 1.0 / all + tilt(place.height_arm, roll) + tilt(place.along_arm, pitch);
  result[place.normal] = 1.0 / all + tilt(place.across_arm, roll) + tilt(place.along_arm, pitch);
  return result;
}

}  // namespace millwright::machine
