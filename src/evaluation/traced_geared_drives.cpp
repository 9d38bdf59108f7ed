// SPDX-License-Identifier: Apache-2.0
#include "evaluation/traced_motor.h"

namespace millwright::evaluation {

using scalar::Traced;

namespace {

constexpr FigureName belt_names[] = {{"m_l", "mass of the belt per length", "kg/m"},
                                     {"F_perm", "allowable tension of the belt", "N"},
                                     {"c_sp", "specific stiffness of the belt", "N"},
                                     {"z_min", "least teeth of a pulley for this belt", "1"},
                                     {"v_perm", "largest speed of the belt", "m/s"},
                                     {"L_b", "length of the belt", "mm"},
                                     {"m_b", "mass of the belt", "kg"},
                                     {"L_s", "free span between the pulleys", "mm"},
                                     {"z", "teeth of the drive pulley", "1"},
                                     {"d_p", "pitch diameter of the drive pulley", "mm"},
                                     {"J_1", "inertia of the drive pulley", "kg.cm2"},
                                     {"J_2", "inertia of the idler", "kg.cm2"},
                                     {"d_i", "pitch diameter of the idler", "mm"},
                                     {"d_b", "bore of the drive pulley", "mm"},
                                     {"b", "width of the belt", "mm"},
                                     {"n_k", "profiles and sizes among belt and pulleys", "1"}};
constexpr FigureName rack_names[] = {{"m_n", "module of the rack", "mm"},
                                     {"α_n", "pressure angle of the rack", "deg"},
                                     {"b_1", "face width of the rack", "mm"},
                                     {"σ_1", "allowable stress of the rack", "MPa"},
                                     {"e_p0", "pitch error of the rack per length", "um/m"},
                                     {"m_1", "mass of the rack", "kg"}};
constexpr FigureName pinion_names[] = {{"m_2n", "module of the pinion", "mm"},
                                       {"α_2n", "pressure angle of the pinion", "deg"},
                                       {"z", "teeth of the pinion", "1"},
                                       {"b_2", "face width of the pinion", "mm"},
                                       {"d_2b", "bore of the pinion", "mm"},
                                       {"σ_2", "allowable stress of the pinion", "MPa"},
                                       {"m_2", "mass of the pinion", "kg"},
                                       {"J_2", "inertia of the pinion", "kg.cm2"}};
constexpr FigureName carried{"m_c", "mass that the drive moves", "kg"};

}  // namespace

void write_calculation(const BeltDriveStage& stage,
                       const machine::BeltDrive<double>& element,
                       const ChosenRows& chosen,
                       ElementWorksheet& sheet) {
  GivenFigures given(sheet.given);
  machine::BeltDrive<Traced> d;
  d.data = element.data;
  given.take_all(
      belt_names, element.belt, d.belt, [](auto& r, auto&& visit) { machine::visit_belt_reading(r, visit); });
  trace_motor(stage, element, chosen, given, d);
  d.carried_mass = given.take(carried, element.carried_mass);
  d.derive();
  machine::belt_drive_constraints(CalculationVisitor(d, sheet));
  trace_derived(d, sheet);
}

void write_calculation(const RackDriveStage& stage,
                       const machine::RackDrive<double>& element,
                       const ChosenRows& chosen,
                       ElementWorksheet& sheet) {
  GivenFigures given(sheet.given);
  machine::RackDrive<Traced> d;
  d.data = element.data;
  given.take_all(
      rack_names, element.rack, d.rack, [](auto& r, auto&& visit) { machine::visit_rack_reading(r, visit); });
  given.take_all(
      pinion_names, element.pinion, d.pinion, [](auto& r, auto&& visit) { machine::visit_pinion_reading(r, visit); });
  trace_motor(stage, element, chosen, given, d);
  d.carried_mass = given.take(carried, element.carried_mass);
  d.derive();
  machine::rack_drive_constraints(CalculationVisitor(d, sheet));
  trace_derived(d, sheet);
}

void write_calculation(const RotaryDriveStage& stage,
                       const machine::RotaryDrive<double>& element,
                       const ChosenRows& chosen,
                       ElementWorksheet& sheet) {
  GivenFigures given(sheet.given);
  machine::RotaryDrive<Traced> d;
  d.data = element.data;
  trace_motor(stage, element, chosen, given, d);
  d.table_inertia = given.take({"J_w", "inertia of table and workpiece", "kg.m2"}, element.table_inertia);
  d.derive();
  machine::rotary_drive_constraints(CalculationVisitor(d, sheet));
  trace_derived(d, sheet);
}

}  // namespace millwright::evaluation
