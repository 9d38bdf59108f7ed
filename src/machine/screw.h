// SPDX-License-Identifier: Apache-2.0
//
// A screw with its nut on a given axis: from catalogue figures to the quantities that the drive's constraints read.
// These depend on the row and the axis only, so bounds over a set of rows take the hull of the readings and not of the
// raw figures.
#pragma once

#include "machine/constraint.h"
#include "machine/problem.h"
#include "mechanics/ball_screw.h"
#include "mechanics/buckling.h"
#include "mechanics/critical_speed.h"
#include "mechanics/material.h"
#include "mechanics/power_screw.h"
#include "mechanics/power_screw_strength.h"
#include "scalar/scalars.h"

namespace millwright::machine {

enum class ScrewKind { ball, sliding, mixed };

/// End-fixity factor of buckling (theoretical), K&G ch. 16.
double end_fixity(Ends ends);
/// Eigenvalue of the first bending mode of a uniform beam [blevins].
double bending_eigenvalue(Ends ends);

/// Catalogue figures of one screw and its nut, SI. Fields that its kind does not have are 0 (sliding: ratings; ball:
/// thread data).
template <class T>
struct ScrewFigures {
  T nominal_diameter{}, mean_diameter{}, root_diameter{}, nut_thread_diameter{}, pitch{}, lead{}, flank_angle{},
      thread_depth{};
  T ball_circle_diameter{};  ///< of the centres of the balls
  T friction{};              ///< of the thread, or of the balls
  T wear_rate{};             ///< m^2/N, specific, of the nut; NaN where nothing is known of its material
  T yield_strength{};        ///< screw
  T nut_yield_strength{};
  T mass_per_length{}, nut_mass{}, nut_length{};
  T lead_error_300{};  ///< m in 300 mm
  T backlash{}, drag_torque{};
  T allowable_pressure{}, pv_limit{}, sliding_speed_limit{};
  T dynamic_rating{}, static_rating{}, nut_stiffness{}, speed_value_limit{};
  T largest_length{};  ///< m, stock length
  T elastic_modulus{}, shear_modulus{}, density{};
};

/// What the axis contributes to the readings.
struct ScrewSite {
  ScrewKind kind = ScrewKind::sliding;
  double stroke = 0.0, overtravel = 0.0, end_allowance = 0.0;
  double length = 0.0;  ///< supported length if given, else 0
  Ends ends = Ends::fixed_supported;
  double preload_fraction = 0.0;
  double permissible_axial_stress = 147e6;
  double load_sharing_turns = 10.0;
};

/// Quantities of one screw with its nut on this axis.
template <class T>
struct ScrewReading {
  T lead{}, mean_diameter{}, root_diameter{}, nominal_diameter{};
  T supported_length{}, cut_length{}, travel{};
  T screw_mass{}, nut_mass{}, inertia{};
  T efficiency{}, reverse_efficiency{}, drag_torque{};
  T buckling_load{}, critical_speed{}, speed_value{}, speed_value_limit{}, permissible_axial_load{};
  T yield_strength{}, nut_yield_strength{}, elastic_modulus{}, shear_modulus{};
  T self_locking_ratio{};
  T engaged_turns{}, thread_depth{}, screw_root_thickness{}, nut_root_thickness{}, nut_thread_diameter{};
  T allowable_pressure{}, pv_limit{}, sliding_speed_limit{};
  T dynamic_rating{}, static_rating{}, preload{}, nut_stiffness{};
  T lead_error_300{}, backlash{}, pitch_circle{};
  // What only soft checks read, and the search therefore does not fill in.
  T nut_turns{};  ///< in mesh, whether or not they share the load
  T flank_angle{}, wear_rate{};
};

/// Every field of a reading, in one place: hulls, conversions and tests walk it.
template <class Reading, class Visit>
void visit_screw_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.lead,
                      &r.mean_diameter,
                      &r.root_diameter,
                      &r.nominal_diameter,
                      &r.supported_length,
                      &r.cut_length,
                      &r.travel,
                      &r.screw_mass,
                      &r.nut_mass,
                      &r.inertia,
                      &r.efficiency,
                      &r.reverse_efficiency,
                      &r.drag_torque,
                      &r.buckling_load,
                      &r.critical_speed,
                      &r.speed_value,
                      &r.speed_value_limit,
                      &r.permissible_axial_load,
                      &r.yield_strength,
                      &r.nut_yield_strength,
                      &r.elastic_modulus,
                      &r.shear_modulus,
                      &r.self_locking_ratio,
                      &r.engaged_turns,
                      &r.thread_depth,
                      &r.screw_root_thickness,
                      &r.nut_root_thickness,
                      &r.nut_thread_diameter,
                      &r.allowable_pressure,
                      &r.pv_limit,
                      &r.sliding_speed_limit,
                      &r.dynamic_rating,
                      &r.static_rating,
                      &r.preload,
                      &r.nut_stiffness,
                      &r.lead_error_300,
                      &r.backlash,
                      &r.pitch_circle})
    visit(*field);
}
inline constexpr std::size_t screw_reading_fields = 38;

template <class Reading, class Visit>
void visit_shown_screw_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.nut_turns, &r.flank_angle, &r.wear_rate}) visit(*field);
}
inline constexpr std::size_t shown_screw_reading_fields = 3;

/// From figures to readings.
template <class T>
ScrewReading<T> screw_reading(const ScrewFigures<T>& f, const ScrewSite& site) {
  using namespace scalar;
  namespace ps = mechanics::power_screw;
  namespace bs = mechanics::ball_screw;
  const auto length = [](double metres) { return in_unit<T>(metres, dimension::length); };
  ScrewReading<T> r;
  r.lead = f.lead;
  r.mean_diameter = f.mean_diameter;
  r.root_diameter = f.root_diameter;
  r.nominal_diameter = f.nominal_diameter;
  r.nut_mass = f.nut_mass;
  r.supported_length = site.length > 0.0 ? length(site.length)
                                         : named("L_s", length(site.stroke + 2.0 * site.overtravel) + f.nut_length);
  r.cut_length = named("L", r.supported_length + length(site.end_allowance));
  r.travel = f.largest_length - length(site.end_allowance) - f.nut_length;
  r.screw_mass = named("m_s", f.mass_per_length * r.cut_length);
  r.inertia = named("J_s", ps::inertia(f.density, f.mean_diameter, r.cut_length));
  // Balls roll up the thread where their centres are.
  const T& on = site.kind == ScrewKind::ball ? f.ball_circle_diameter : f.mean_diameter;
  const T lead_angle = named("λ", ps::lead_angle(f.lead, on));
  const T fixity = T(end_fixity(site.ends));
  const T eigenvalue = T(bending_eigenvalue(site.ends));
  if (site.kind == ScrewKind::ball) {
    r.efficiency = named("η", bs::efficiency(f.friction, lead_angle));
    r.reverse_efficiency = named("η_r", bs::reverse_efficiency(f.friction, lead_angle));
    r.preload = site.preload_fraction * f.dynamic_rating;
    r.drag_torque = site.preload_fraction > 0.0
                        ? named("T_d", f.drag_torque + bs::preload_torque(r.preload, f.lead, lead_angle))
                        : f.drag_torque;
    r.permissible_axial_load = named(
        "F_perm",
        bs::permissible_axial_load(in_unit<T>(site.permissible_axial_stress, dimension::pressure), f.root_diameter));
    // The catalogue rules have E and the density of bearing steel and their factors 0.5 and 0.8 inside.
    r.buckling_load = named("P_perm", bs::permissible_buckling_load(fixity, f.root_diameter, r.supported_length));
    r.critical_speed = named("ω_perm", bs::permissible_speed(eigenvalue, f.root_diameter, r.supported_length));
    r.speed_value_limit = f.speed_value_limit;
  } else {
    const T friction = named("μ_e", ps::effective_friction(f.friction, f.flank_angle));
    // Asked for its range only.
    if constexpr (mechanics::is_watched<T>) (void)ps::exact_friction_ratio(f.flank_angle, lead_angle);
    r.efficiency = named("η", ps::thread_efficiency(lead_angle, friction));
    r.reverse_efficiency = named("η_r", ps::reverse_efficiency(lead_angle, friction));
    r.self_locking_ratio = named("u", ps::self_locking_ratio(lead_angle, friction));
    r.drag_torque = f.drag_torque;
    r.buckling_load = named("W_cr",
                            mechanics::buckling::critical_load(
                                fixity, f.elastic_modulus, f.yield_strength, f.root_diameter, r.supported_length));
    r.critical_speed = named("ω_c",
                             mechanics::critical_speed::critical_speed(
                                 eigenvalue, f.root_diameter, r.supported_length, f.elastic_modulus, f.density));
    r.nut_turns = named("n_H", ps::engaged_turns(f.nut_length, f.pitch));
    r.engaged_turns = named("n", smaller(r.nut_turns, T(site.load_sharing_turns)));
    r.flank_angle = f.flank_angle;
    r.wear_rate = f.wear_rate;
    r.thread_depth = f.thread_depth;
    r.screw_root_thickness =
        named("t_r", ps::thread_root_thickness(f.pitch, f.flank_angle, f.mean_diameter, f.root_diameter));
    r.nut_root_thickness =
        named("t_n", ps::thread_root_thickness(f.pitch, f.flank_angle, f.mean_diameter, f.nut_thread_diameter));
  }
  r.yield_strength = f.yield_strength;
  r.nut_yield_strength = f.nut_yield_strength;
  r.elastic_modulus = f.elastic_modulus;
  r.shear_modulus = f.shear_modulus;
  r.nut_thread_diameter = f.nut_thread_diameter;
  r.allowable_pressure = f.allowable_pressure;
  r.pv_limit = f.pv_limit;
  r.sliding_speed_limit = f.sliding_speed_limit;
  r.dynamic_rating = f.dynamic_rating;
  r.static_rating = f.static_rating;
  r.nut_stiffness = f.nut_stiffness;
  r.lead_error_300 = f.lead_error_300;
  r.backlash = f.backlash;
  r.pitch_circle = f.nominal_diameter;
  return r;
}

}  // namespace millwright::machine
