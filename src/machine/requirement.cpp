// SPDX-License-Identifier: Apache-2.0
#include "machine/requirement.h"

#include <algorithm>
#include <cmath>

#include "machine/drive_requirements.h"

namespace millwright::machine {
namespace {

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
}};

constexpr std::array<RequirementDeclaration, requirement_count> table = [] {
  std::array<RequirementDeclaration, requirement_count> all{};
  std::copy(drive_requirements.begin(), drive_requirements.end(), all.begin());
  std::copy(structure_requirements.begin(), structure_requirements.end(), all.begin() + drive_requirements.size());
  return all;
}();

constexpr bool in_order() {
  for (std::size_t i = 0; i < table.size(); ++i)
    if (static_cast<std::size_t>(table[i].requirement) != i) return false;
  return true;
}
static_assert(in_order(), "the table must follow the enumeration");

}  // namespace

std::span<const RequirementDeclaration> requirements() { return table; }

const RequirementDeclaration* find_requirement(std::string_view key) {
  for (const RequirementDeclaration& declaration : table)
    if (declaration.key == key) return &declaration;
  return nullptr;
}

Requirements::Requirements() {
  for (std::size_t i = 0; i < table.size(); ++i) values_[i] = table[i].default_value;
}

void Requirements::set(Requirement requirement, double value) {
  values_[static_cast<std::size_t>(requirement)] = value;
  given_[static_cast<std::size_t>(requirement)] = true;
}

bool Requirements::known(Requirement requirement) const { return !std::isnan((*this)(requirement)); }

}  // namespace millwright::machine
