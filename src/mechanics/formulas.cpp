// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>
#include <unordered_map>

#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

// One function for each machine element, in <element>_formulas.cpp. Called by name rather than collected by global
// constructors: those vanish when a linker takes only what it needs from a static library.
void define_motion(FormulaList&);
void define_power_screw(FormulaList&);
void define_power_screw_strength(FormulaList&);
void define_buckling(FormulaList&);
void define_critical_speed(FormulaList&);
void define_ball_screw(FormulaList&);
void define_ball_screw_drive(FormulaList&);
void define_coupling(FormulaList&);
void define_transmission(FormulaList&);
void define_belt(FormulaList&);
void define_rack(FormulaList&);
void define_material(FormulaList&);
void define_stepper(FormulaList&);
void define_stepper_sizing(FormulaList&);
void define_guide(FormulaList&);
void define_beam(FormulaList&);
void define_section(FormulaList&);
void define_section_stress(FormulaList&);
void define_column(FormulaList&);
void define_vibration(FormulaList&);
void define_weld(FormulaList&);
void define_bolt(FormulaList&);
void define_shaft(FormulaList&);
void define_tool_point(FormulaList&);
void define_actuation(FormulaList&);
void define_actuation_steps(FormulaList&);
void define_cutting(FormulaList&);
void define_accuracy(FormulaList&);
void define_utilisation(FormulaList&);
void define_arithmetic(FormulaList&);
void define_square_thread(FormulaList&);
void define_timing_belt(FormulaList&);

namespace {

using Index = std::unordered_map<std::string_view, const Formula*>;

FormulaList all_formulas() {
  FormulaList list;
  define_motion(list);
  define_power_screw(list);
  define_power_screw_strength(list);
  define_buckling(list);
  define_critical_speed(list);
  define_ball_screw(list);
  define_ball_screw_drive(list);
  define_coupling(list);
  define_transmission(list);
  define_belt(list);
  define_rack(list);
  define_material(list);
  define_stepper(list);
  define_stepper_sizing(list);
  define_guide(list);
  define_beam(list);
  define_section(list);
  define_section_stress(list);
  define_column(list);
  define_vibration(list);
  define_weld(list);
  define_bolt(list);
  define_shaft(list);
  define_tool_point(list);
  define_actuation(list);
  define_actuation_steps(list);
  define_cutting(list);
  define_accuracy(list);
  define_utilisation(list);
  define_arithmetic(list);
  define_square_thread(list);
  define_timing_belt(list);
  return list;
}

Index index_of(const FormulaList& list) {
  Index index;
  for (const Formula& formula : list) {
    if (!index.emplace(formula.name(), &formula).second)
      throw std::logic_error("two formulas are called " + formula.name());
    if (!formula.handbook_id().empty() && !index.emplace(formula.handbook_id(), &formula).second)
      throw std::logic_error("two formulas have the handbook id " + formula.handbook_id());
  }
  return index;
}

}  // namespace

const std::vector<Formula>& formulas() {
  static const FormulaList list = all_formulas();
  return list;
}

const Formula* find_formula(std::string_view name_or_handbook_id) {
  static const Index index = index_of(formulas());
  const auto found = index.find(name_or_handbook_id);
  return found == index.end() ? nullptr : found->second;
}

}  // namespace millwright::mechanics
