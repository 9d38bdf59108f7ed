// SPDX-License-Identifier: Apache-2.0
#include "machine/requirement.h"

#include <algorithm>
#include <cmath>

#include "machine/drive_requirements.h"

namespace millwright::machine {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

// Those of drives come first (drive_requirements.h). One line a requirement; the order is that of the enumeration
// (checked in Requirements::Requirements).
constexpr std::array<RequirementDeclaration, requirement_count - drive_requirements.size()> structure_requirements{{
    {Requirement::guide_static_safety,
     "guide_static_safety",
     "1",
     2.0,
     "static rating of a carriage over its largest load",
     "thk_lm_guide"},
    {Requirement::guide_load_factor,
     "guide_load_factor",
     "1",
     1.5,
     "load factor f_w of guide life",
     "hiwin_linear_guideway"},
    {Requirement::guide_shaft_safety_factor,
     "guide_shaft_safety_factor",
     "1",
     3.0,
     "yield strength over bending stress of a guide shaft",
     "khurmi_gupta2005"},
    {Requirement::guide_shaft_deflection_ratio,
     "guide_shaft_deflection_ratio",
     "1",
     1.0 / 3000.0,
     "deflection of a guide shaft over its span",
     "hiwin_linear_guideway"},
    {Requirement::frame_safety_factor,
     "frame_safety_factor",
     "1",
     2.0,
     "yield strength over bending stress of frame members",
     "khurmi_gupta2005"},
    {Requirement::frame_deflection_ratio,
     "frame_deflection_ratio",
     "1",
     1.0 / 1000.0,
     "deflection of a frame member over its span",
     "slocum1992"},
    {Requirement::column_factor,
     "column_factor",
     "1",
     1.0 / 3.0,
     "compressive load over buckling load of a column",
     "khurmi_gupta2005"},
    {Requirement::weld_stress,
     "weld_stress",
     "Pa",
     80e6,
     "allowable shear stress on a weld throat",
     "khurmi_gupta2005"},
    {Requirement::shaft_safety_factor,
     "shaft_safety_factor",
     "1",
     3.0,
     "yield strength over equivalent stress of a shaft",
     "khurmi_gupta2005"},
    {Requirement::shaft_bending_factor,
     "shaft_bending_factor",
     "1",
     1.5,
     "shock factor on the bending moment of a rotating shaft",
     "khurmi_gupta2005"},
    {Requirement::shaft_torsion_factor,
     "shaft_torsion_factor",
     "1",
     1.0,
     "shock factor on the torque of a rotating shaft",
     "khurmi_gupta2005"},
    {Requirement::bushing_slope,
     "bushing_slope",
     "rad",
     0.1 * degree,
     "slope of a round guide shaft at its bushings",
     "thomson_round_rail"},
    {Requirement::bushing_slope_self_aligning,
     "bushing_slope_self_aligning",
     "rad",
     0.5 * degree,
     "the same where the bushings align themselves",
     "thomson_round_rail"},
    {Requirement::bushing_binding_factor,
     "bushing_binding_factor",
     "1",
     1.0,
     "bearing length over that at which bushings jam",
     "millwright_derivations"},
    {Requirement::frame_twist,
     "frame_twist",
     "rad",
     no_default,
     "largest twist of a frame member under its torque",
     ""},
    {Requirement::frame_natural_frequency,
     "frame_natural_frequency",
     "Hz",
     no_default,
     "least natural frequency of a frame member with what it carries",
     ""},
    {Requirement::ringing_amplitude,
     "ringing_amplitude",
     "m",
     no_default,
     "ringing that the hardest acceleration may leave; asks for a natural frequency",
     ""},
    {Requirement::fatigue_safety_factor,
     "fatigue_safety_factor",
     "1",
     1.5,
     "safety of a rotating shaft against fatigue after Goodman",
     "shigley"},
    {Requirement::fatigue_reliability_factor,
     "fatigue_reliability_factor",
     "1",
     0.814,
     "reliability factor of the endurance limit (99 %)",
     "shigley"},
    {Requirement::bolt_preload_fraction,
     "bolt_preload_fraction",
     "1",
     0.75,
     "preload of a screw over its proof load",
     "shigley"},
    {Requirement::bolt_proof_safety,
     "bolt_proof_safety",
     "1",
     1.15,
     "proof load over the tension in a screw",
     "shigley"},
    {Requirement::bolt_separation_safety,
     "bolt_separation_safety",
     "1",
     1.5,
     "load that opens a joint over the load",
     "shigley"},
    {Requirement::bolt_slip_safety,
     "bolt_slip_safety",
     "1",
     1.5,
     "shear that a joint holds by friction over the shear",
     "shigley"},
    {Requirement::bolt_shear_safety_factor,
     "bolt_shear_safety_factor",
     "1",
     2.0,
     "shear yield strength over shear stress of fitted bolts",
     "khurmi_gupta2005"},
    {Requirement::spindle_power_factor,
     "spindle_power_factor",
     "1",
     0.8,
     "cutting power over the power of the spindle",
     "sandvik_milling"},
}};

constexpr std::array<RequirementDeclaration, requirement_count> declared = [] {
  std::array<RequirementDeclaration, requirement_count> all{};
  std::copy(drive_requirements.begin(), drive_requirements.end(), all.begin());
  std::copy(structure_requirements.begin(), structure_requirements.end(), all.begin() + drive_requirements.size());
  return all;
}();

constexpr bool in_order() {
  for (std::size_t i = 0; i < declared.size(); ++i)
    if (static_cast<std::size_t>(declared[i].requirement) != i) return false;
  return true;
}
static_assert(in_order(), "the table must follow the enumeration");

}  // namespace

std::span<const RequirementDeclaration> requirements() { return declared; }

const RequirementDeclaration* find_requirement(std::string_view key) {
  for (const RequirementDeclaration& declaration : declared)
    if (declaration.key == key) return &declaration;
  return nullptr;
}

Requirements::Requirements() {
  for (std::size_t i = 0; i < declared.size(); ++i) values_[i] = declared[i].default_value;
}

void Requirements::forget(Requirement requirement) {
  const auto index = static_cast<std::size_t>(requirement);
  values_[index] = requirements()[index].default_value;
  given_[index] = false;
}

void Requirements::set(Requirement requirement, double value) {
  values_[static_cast<std::size_t>(requirement)] = value;
  given_[static_cast<std::size_t>(requirement)] = true;
}

void Requirements::enforce(std::string_view constraint) {
  if (!enforces(constraint)) enforced_.emplace_back(constraint);
}

bool Requirements::enforces(std::string_view constraint) const {
  return std::find(enforced_.begin(), enforced_.end(), constraint) != enforced_.end();
}

bool Requirements::known(Requirement requirement) const { return !std::isnan((*this)(requirement)); }

}  // namespace millwright::machine
