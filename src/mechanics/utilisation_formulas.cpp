// SPDX-License-Identifier: Apache-2.0
#include "mechanics/formula_definition.h"
#include "mechanics/utilisation.h"

namespace millwright::mechanics {

void define_utilisation(FormulaList& list) {
  define(
      list,
      {.name = "utilisation.of_maximum",
       .handbook_id = "CONSTR-UTILISATION-MAX",
       .symbol = "u",
       .unit = "1",
       .title = "Demand over capacity",
       .source = "millwright_derivations, definition",
       .validity = "capacity above 0"},
      [](const auto&... x) { return utilisation::of_maximum(x...); },
      quantity("demand", "D", "any", "demand").rising(),
      quantity("capacity", "C", "any", "capacity in the same unit (> 0)").falling());

  define(
      list,
      {.name = "utilisation.of_minimum",
       .handbook_id = "CONSTR-UTILISATION-MIN",
       .symbol = "u",
       .unit = "1",
       .title = "Required value over actual value",
       .source = "millwright_derivations, definition",
       .validity = "actual value above 0"},
      [](const auto&... x) { return utilisation::of_minimum(x...); },
      quantity("required", "R", "any", "smallest acceptable value").rising(),
      quantity("actual", "A", "any", "actual value (> 0)").falling());
}

}  // namespace millwright::mechanics
