// SPDX-License-Identifier: Apache-2.0
// Bills of materials that `check` and `compare` read.
#include <cmath>

#include "fuzz.h"
#include "machine/bill_of_materials.h"
#include "machine/problem_file.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const machine::Problem problem = [] {
    text::Diagnostics diagnostics;
    const auto text = text::SourceText::from_string("gantry.toml", fuzz::project_file("problems/gantry.toml"));
    return *machine::problem_of(*text::read_toml(text, diagnostics), diagnostics);
  }();
  text::Diagnostics diagnostics;
  const auto bom = machine::read_bill_of_materials(
      text::SourceText::from_string("bom.csv", std::string(fuzz::view(bytes, size))), problem, diagnostics);
  fuzz::require(bom.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
  fuzz::check(diagnostics);
  if (!bom) return 0;
  for (const machine::BomLine& line : bom->lines) {
    fuzz::require(line.is_dimension() == line.part_number.empty(), "a line is a part or a setting");
    for (const auto& figure : {line.quantity, line.length, line.value})
      fuzz::require(!figure || std::isfinite(*figure), "figures are finite");
    fuzz::check(line.where, "a line");
  }
  return 0;
}
