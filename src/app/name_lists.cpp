// SPDX-License-Identifier: Apache-2.0
#include "app/name_lists.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "app/templates.h"
#include "machine/objective.h"

namespace millwright::app {

std::string all_quantities() {
  std::vector<std::string_view> names;
  for (const machine::QuantityDeclaration& each : machine::quantities()) names.push_back(each.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string all_templates() {
  std::vector<std::string_view> names;
  for (const Template& each : templates()) names.push_back(each.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace millwright::app
