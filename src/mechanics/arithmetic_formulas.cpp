// SPDX-License-Identifier: Apache-2.0
#include "mechanics/arithmetic.h"
#include "mechanics/formula_definition.h"

namespace millwright::mechanics {

void define_arithmetic(FormulaList& list) {
  define(
      list,
      {.name = "arithmetic.value",
       .symbol = "x",
       .unit = "any",
       .title = "A quantity taken over as it stands",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return arithmetic::value(x...); },
      quantity("value", "x", "any", "the quantity").any_sign().rising());

  define(
      list,
      {.name = "arithmetic.sum",
       .symbol = "Σ",
       .unit = "any",
       .title = "Sum of like quantities",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return arithmetic::sum(x...); },
      list_of("values", "x", "any", "the summands").any_sign());

  define(
      list,
      {.name = "arithmetic.difference",
       .symbol = "Δ",
       .unit = "any",
       .title = "Difference of like quantities",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return arithmetic::difference(x...); },
      quantity("minuend", "a", "any", "from which is taken").any_sign().rising(),
      quantity("subtrahend", "b", "any", "what is taken").any_sign().falling());

  define(
      list,
      {.name = "arithmetic.mean",
       .symbol = "m",
       .unit = "any",
       .title = "Mean of two like quantities",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return arithmetic::mean(x...); },
      quantity("first", "a", "any", "one").any_sign().rising(),
      quantity("second", "b", "any", "the other").any_sign().rising());

  define(
      list,
      {.name = "arithmetic.multiple",
       .symbol = "x",
       .unit = "any",
       .title = "A quantity times a pure number",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return arithmetic::multiple(x...); },
      quantity("value", "x", "any", "the quantity").any_sign().rising(),
      quantity("factor", "c", "1", "pure number"));

  define(
      list,
      {.name = "arithmetic.quotient",
       .symbol = "x",
       .unit = "any",
       .title = "A quantity divided by a pure number",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return arithmetic::quotient(x...); },
      quantity("value", "x", "any", "the quantity").any_sign().rising(),
      quantity("divisor", "c", "1", "pure number"));

  define(
      list,
      {.name = "arithmetic.ratio",
       .symbol = "r",
       .unit = "1",
       .title = "Ratio of like quantities",
       .source = "millwright_derivations, definition"},
      [](const auto&... x) { return arithmetic::ratio(x...); },
      quantity("numerator", "a", "any", "above the line").any_sign().rising(),
      quantity("denominator", "b", "any", "below the line"));
}

}  // namespace millwright::mechanics
