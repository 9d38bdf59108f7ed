// SPDX-License-Identifier: Apache-2.0
#include "evaluation/traced_elements.h"

#include <cmath>

namespace millwright::evaluation {

using scalar::Traced;

namespace {

constexpr FigureName guide_names[] = {{"C", "dynamic load rating of a carriage", "N"},
                                      {"C_0", "static load rating of a carriage", "N"},
                                      {"L_0", "distance that the rating is stated for", "km"},
                                      {"M_x0", "static roll moment rating", "N.m"},
                                      {"M_y0", "static pitch moment rating", "N.m"},
                                      {"M_z0", "static yaw moment rating", "N.m"},
                                      {"m_w", "mass of the carriages", "kg"},
                                      {"m_s", "mass of the rails", "kg"},
                                      {"L_r", "length of a rail", "mm"},
                                      {"L_max", "longest rail that is sold", "mm"},
                                      {"d_s", "diameter of the guide shaft", "mm"},
                                      {"μ_b", "friction of a bushing", "1"},
                                      {"k_r", "radial stiffness of a carriage", "N/um"}};
constexpr FigureName section_names[] = {{"A", "area of the section", "mm2"},
                                        {"I_y", "second moment about the strong axis; of an angle the least", "mm^4"},
                                        {"I_z", "second moment about the weak axis; of an angle the least", "mm^4"},
                                        {"I_v", "least second moment, about whichever axis", "mm^4"},
                                        {"W_y", "section modulus about the strong axis; 0.77 of an angle's", "mm^3"},
                                        {"W_z", "section modulus about the weak axis; 0.77 of an angle's", "mm^3"},
                                        {"h", "height of the section", "mm"},
                                        {"b", "width of the section", "mm"},
                                        {"m_l", "mass per length", "kg/m"},
                                        {"E", "elastic modulus", "GPa"},
                                        {"σ_y", "yield strength", "MPa"},
                                        {"c_t", "width by which torsion shears the section", "mm"},
                                        {"J", "torsion constant of the section", "mm^4"},
                                        {"G", "shear modulus", "GPa"}};
constexpr FigureName bolt_names[] = {{"d", "nominal diameter of the screw", "mm"},
                                     {"A_s", "tensile stress area", "mm2"},
                                     {"S_p", "proof strength", "MPa"},
                                     {"R_e", "yield strength", "MPa"}};
constexpr FigureName carried_by_member{"m_c", "mass that is carried", "kg"};

}  // namespace

void write_calculation(const machine::GuideSystem<double>& element, ElementWorksheet& sheet) {
  GivenFigures given(sheet.given);
  machine::GuideSystem<Traced> d;
  d.data = element.data;
  d.unsupported_shaft = element.unsupported_shaft;
  d.bushings = element.bushings;
  given.take_all(
      guide_names, element.guide, d.guide, [](auto& r, auto&& visit) { machine::visit_guide_reading(r, visit); });
  d.carried_mass = given.take(carried_by_member, element.carried_mass);
  d.acceleration_time = given.take({"t_a", "shortest time of a ramp", "s"}, element.acceleration_time);
  d.derive();
  machine::guide_constraints(CalculationVisitor(d, sheet));
}

void write_calculation(const machine::StructureMember<double>& element, ElementWorksheet& sheet) {
  GivenFigures given(sheet.given);
  machine::StructureMember<Traced> d;
  d.data = element.data;
  using machine::MemberKind;
  switch (element.data->member.kind) {
    case MemberKind::round_shaft:
      d.diameter = given.take({"d", "diameter", "mm"}, element.diameter);
      break;
    case MemberKind::rectangular_bar:
      d.width = given.take({"b", "width", "mm"}, element.width);
      d.height = given.take({"h", "height", "mm"}, element.height);
      break;
    case MemberKind::weld:
      d.leg = given.take({"a", "leg of the weld", "mm"}, element.leg);
      break;
    case MemberKind::plate:
      d.thickness = given.take({"t", "thickness", "mm"}, element.thickness);
      break;
    case MemberKind::section_beam:
    case MemberKind::column:
    case MemberKind::portal_frame:
    case MemberKind::bolts:
      given.take_all(section_names, element.section, d.section, [](auto& r, auto&& visit) {
        machine::visit_section_reading(r, visit);
      });
      break;
  }
  d.carried_mass = given.take(carried_by_member, element.carried_mass);
  d.derive();
  machine::member_constraints(CalculationVisitor(d, sheet));
}

void write_calculation(const machine::BoltedJoint<double>& element, ElementWorksheet& sheet) {
  GivenFigures given(sheet.given);
  machine::BoltedJoint<Traced> d;
  d.data = element.data;
  given.take_all(
      bolt_names, element.bolt, d.bolt, [](auto& r, auto&& visit) { machine::visit_bolt_reading(r, visit); });
  switch (element.data->member.bolts.holds) {
    case machine::Held::burden:
      d.carried_mass = given.take(carried_by_member, element.carried_mass);
      break;
    case machine::Held::motor:
      d.held_force = given.take({"F_m", "weight of the motor and pull at its shaft", "N"}, element.held_force);
      d.held_torque = given.take({"T_m", "largest torque of the motor", "N.m"}, element.held_torque);
      break;
    case machine::Held::carriage:
      d.held_force = given.take({"P_c", "load of the most loaded carriage", "N"}, element.held_force);
      break;
  }
  d.derive();
  machine::bolted_joint_constraints(CalculationVisitor(d, sheet));
}

void write_calculation(const Supply<double>& element, ElementWorksheet& sheet) {
  GivenFigures given(sheet.given);
  Supply<Traced> d;
  d.data = element.data;
  Traced power;
  for (std::size_t i = 0; i < element.drive_powers.size(); ++i) {
    const auto& [axis, watts] = element.drive_powers[i];
    const std::string symbol = "P_" + std::to_string(i + 1);
    power = power + given.take_of(axis, {symbol.c_str(), "input of a drive, from its own calculation", "W"}, watts);
  }
  const std::array<Traced, 1> powers{scalar::named("P_in", power)};
  const Traced reserve = given.take({"k_s", "reserve of the supply", "1"}, element.data->reserve);
  d.demanded_power = scalar::named("P_d", mechanics::stepper::supply_power(std::span<const Traced>(powers), reserve));
  d.rated_power = given.take({"P_s", "rated power of the supply", "W"}, element.rated_power);
  d.voltage = given.take({"V_s", "voltage of the supply", "V"}, element.voltage);
  d.required_voltage = given.take({"V", "voltage of the drives", "V"}, element.required_voltage);
  for (std::size_t i = 0; i < element.motor_currents.size(); ++i) {
    const std::string symbol = "I_" + std::to_string(i + 1);
    d.motor_currents.push_back(
        given.take({symbol.c_str(), "rated current of a motor", "A"}, element.motor_currents[i]));
  }
  d.rated_current = given.take({"I_s", "rated current of the supply", "A"}, element.rated_current);
  supply_constraints(CalculationVisitor(d, sheet));
}

void write_calculation(const WholeMachine<double>& element, ElementWorksheet& sheet) {
  GivenFigures given(sheet.given);
  WholeMachine<Traced> d;
  d.data = element.data;
  constexpr FigureName compliances[] = {{"c_x", "compliance of axes and structure along x", "um/N"},
                                        {"c_y", "compliance of axes and structure along y", "um/N"},
                                        {"c_z", "compliance of axes and structure along z", "um/N"}};
  constexpr FigureName errors[] = {{"e_x", "position error of the axes along x", "um"},
                                   {"e_y", "position error of the axes along y", "um"},
                                   {"e_z", "position error of the axes along z", "um"}};
  for (std::size_t i = 0; i < 3; ++i) {
    d.compliance[i] = given.take(compliances[i], element.compliance[i]);
    d.error[i] = given.take(errors[i], element.error[i]);
  }
  constexpr FigureName totals[] = {{"K", "sum of all prices", "1"},
                                   {"m", "sum of all masses", "kg"},
                                   {"t", "sum of the times of all moves", "s"},
                                   {"E", "sum of the energies of all drives", "J"},
                                   {"e", "sum of all position errors", "um"}};
  for (std::size_t i = 0; i < machine::quantity_count; ++i)
    if (!std::isnan(element.totals[i])) d.totals[i] = given.take(totals[i], element.totals[i]);
  whole_constraints(CalculationVisitor(d, sheet));
}

}  // namespace millwright::evaluation
