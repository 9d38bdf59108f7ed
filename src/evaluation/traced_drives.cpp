// SPDX-License-Identifier: Apache-2.0
#include "evaluation/traced_motor.h"

namespace millwright::evaluation {

using scalar::Traced;

namespace {

constexpr FigureName screw_names[] = {{"d", "outside diameter of the screw", "mm"},
                                      {"d_2", "mean diameter of the screw", "mm"},
                                      {"d_3", "root diameter of the screw", "mm"},
                                      {"D_n", "thread diameter of the nut", "mm"},
                                      {"p", "pitch of the thread", "mm"},
                                      {"l", "lead of the screw", "mm"},
                                      {"β", "flank angle of the thread", "deg"},
                                      {"h", "depth of the thread", "mm"},
                                      {"μ", "friction of thread or balls", "1"},
                                      {"k_w", "specific wear rate of the nut", "mm3/(N.m)"},
                                      {"R_e", "yield strength of the screw", "MPa"},
                                      {"R_n", "yield strength of the nut", "MPa"},
                                      {"m_l", "mass of the screw per length", "kg/m"},
                                      {"m_n", "mass of the nut", "kg"},
                                      {"L_n", "length of the nut", "mm"},
                                      {"e_300", "lead error in 300 mm", "um"},
                                      {"Δ_0", "play of the nut", "um"},
                                      {"T_0", "drag torque of the nut", "N.m"},
                                      {"p_perm", "allowable pressure of the nut", "MPa"},
                                      {"pv_perm", "allowable pressure times speed of the nut", "MPa.m/s"},
                                      {"v_perm", "allowable sliding speed of the nut", "m/s"},
                                      {"C_a", "dynamic load rating of the nut", "N"},
                                      {"C_0a", "static load rating of the nut", "N"},
                                      {"K_n", "stiffness of the nut at its rated load", "N/um"},
                                      {"DN_perm", "permissible speed value", "m/s"},
                                      {"L_max", "longest screw that is sold", "mm"},
                                      {"E", "elastic modulus of the screw", "GPa"},
                                      {"G", "shear modulus of the screw", "GPa"},
                                      {"ρ", "density of the screw", "kg/m3"},
                                      {"d_pw", "diameter of the ball pitch circle", "mm"}};

constexpr auto walk_screw_figures = [](auto& f, auto&& visit) {
  for (auto* field : {&f.nominal_diameter,    &f.mean_diameter,  &f.root_diameter,
                      &f.nut_thread_diameter, &f.pitch,          &f.lead,
                      &f.flank_angle,         &f.thread_depth,   &f.friction,
                      &f.wear_rate,           &f.yield_strength, &f.nut_yield_strength,
                      &f.mass_per_length,     &f.nut_mass,       &f.nut_length,
                      &f.lead_error_300,      &f.backlash,       &f.drag_torque,
                      &f.allowable_pressure,  &f.pv_limit,       &f.sliding_speed_limit,
                      &f.dynamic_rating,      &f.static_rating,  &f.nut_stiffness,
                      &f.speed_value_limit,   &f.largest_length, &f.elastic_modulus,
                      &f.shear_modulus,       &f.density,        &f.ball_circle_diameter})
    visit(*field);
};

constexpr FigureName coupling_names[] = {{"J_c", "inertia of the coupling", "kg.cm2"},
                                         {"T_c", "rated torque of the coupling", "N.m"},
                                         {"k_c", "torsional stiffness of the coupling", "N.m/rad"},
                                         {"ω_max", "largest speed of the coupling", "rpm"},
                                         {"d_cmin", "least bore of the coupling", "mm"},
                                         {"d_cmax", "largest bore of the coupling", "mm"},
                                         {"Δ_r", "permissible parallel misalignment", "mm"},
                                         {"Δ_α", "permissible angular misalignment", "deg"},
                                         {"Δ_a", "permissible axial misalignment", "mm"}};

constexpr auto walk_coupling = [](auto& c, auto&& visit) {
  for (auto* field : {&c.inertia,
                      &c.rated_torque,
                      &c.stiffness,
                      &c.largest_speed,
                      &c.least_bore,
                      &c.largest_bore,
                      &c.parallel_misalignment,
                      &c.angular_misalignment,
                      &c.axial_misalignment})
    visit(*field);
};

constexpr FigureName fixed_support_names[] = {{"d_B", "bore of the fixed support", "mm"},
                                              {"F_B", "permissible axial load of the fixed support", "N"},
                                              {"k_B", "axial stiffness of the fixed support", "N/um"},
                                              {"ω_B", "largest speed of the fixed support", "rpm"},
                                              {"q_B", "fixed support clamps the plain screw (1) or not (0)", "1"}};
constexpr FigureName free_support_names[] = {{"d_A", "bore of the far support", "mm"},
                                             {"F_A", "permissible axial load of the far support", "N"},
                                             {"k_A", "axial stiffness of the far support", "N/um"},
                                             {"ω_A", "largest speed of the far support", "rpm"},
                                             {"q_A", "far support clamps the plain screw (1) or not (0)", "1"}};

constexpr auto walk_support = [](auto& s, auto&& visit) {
  for (auto* field : {&s.bore, &s.permissible_axial_load, &s.axial_stiffness, &s.largest_speed, &s.clamps})
    visit(*field);
};

}  // namespace

void write_calculation(const ScrewDriveStage& stage,
                       const machine::ScrewDrive<double>& element,
                       const ChosenRows& chosen,
                       ElementWorksheet& sheet) {
  GivenFigures given(sheet.given);
  machine::ScrewDrive<Traced> d;
  d.data = element.data;
  d.kind = element.kind;
  const solver::Row screw = chosen.rows[ScrewDriveStage::screw_slot];
  machine::ScrewFigures<Traced> figures;
  given.take_all(screw_names, stage.screws().figures(screw), figures, walk_screw_figures);
  d.screw = machine::screw_reading(figures, stage.screws().site(screw));
  trace_motor(stage, element, chosen, given, d);
  if (element.data->has_coupling) given.take_all(coupling_names, element.coupling, d.coupling, walk_coupling);
  given.take_all(fixed_support_names, element.support_fixed, d.support_fixed, walk_support);
  given.take_all(free_support_names, element.support_free, d.support_free, walk_support);
  d.carried_mass = given.take({"m_c", "mass that the drive moves beside its nut", "kg"}, element.carried_mass);
  d.derive();
  machine::screw_drive_constraints(CalculationVisitor(d, sheet));
  trace_derived(d, sheet);
}

}  // namespace millwright::evaluation
