// SPDX-License-Identifier: Apache-2.0
// Arguments of `calc`: the first line names the formula, each other one is a word. What is understood is computed.
#include "app/calc_arguments.h"
#include "fuzz.h"
#include "report/calculation.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::string_view input = fuzz::view(bytes, size);
  const mechanics::Formula* formula = mechanics::find_formula(fuzz::first_line(input));
  if (formula == nullptr) formula = mechanics::find_formula("power_screw.raising_torque");
  text::Diagnostics diagnostics;
  const auto arguments = app::read_calc_arguments(*formula, fuzz::lines(input), diagnostics);
  fuzz::require(arguments.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
  fuzz::check(diagnostics);
  if (!arguments) return 0;
  (void)formula->violations(arguments->values);
  (void)formula->evaluate<double>(arguments->values);
  return 0;
}
