// SPDX-License-Identifier: Apache-2.0
// Problem files, TOML and JSON, up to the names of catalogues and materials in them.
#include <cmath>

#include "catalogue/catalogue.h"
#include "fuzz.h"
#include "machine/problem_file.h"
#include "machine/references.h"

using namespace millwright;

namespace {

const catalogue::Catalogue& shipped() {
  static const catalogue::Catalogue catalogue = [] {
    text::Diagnostics diagnostics;
    return catalogue::Catalogue::load({MILLWRIGHT_SOURCE_DIR "/catalogues"}, diagnostics);
  }();
  return catalogue;
}

/// What was read can be reckoned with.
void check_sound(const machine::Problem& problem) {
  fuzz::require(!problem.axes.empty() && problem.order.size() == problem.axes.size(), "every axis has its turn");
  fuzz::require(!problem.supply_voltages.empty(), "there is a voltage");
  for (const machine::Axis& axis : problem.axes) {
    fuzz::require(!axis.name.empty(), "an axis has a name");
    fuzz::require(std::isfinite(axis.stroke) && axis.stroke > 0.0, "a stroke is above zero");
    fuzz::require(std::isfinite(axis.structure_mass) && axis.structure_mass >= 0.0, "a mass is not negative");
    fuzz::require(axis.acceleration_time.lower > 0.0, "ramps take time");
    fuzz::require(axis.acceleration_time.upper >= axis.acceleration_time.lower, "ranges ascend");
    fuzz::require(!axis.moves.empty(), "an axis moves");
    for (const machine::Move& move : axis.moves)
      fuzz::require(std::isfinite(move.distance) && move.distance <= axis.stroke * 1.000001, "moves fit the stroke");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view input = fuzz::view(bytes, size);
  const bool is_json = input.starts_with("{");
  text::Diagnostics diagnostics;
  const auto text = text::SourceText::from_string(is_json ? "problem.json" : "problem.toml", std::string(input));
  const auto document = is_json ? text::read_json(text, diagnostics) : text::read_toml(text, diagnostics);
  fuzz::require(document || diagnostics.has_errors(), "a text that is refused is complained about");
  if (document) {
    auto problem = machine::problem_of(*document, diagnostics);
    fuzz::require(problem.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
    if (problem) {
      check_sound(*problem);
      machine::check_references(*problem, shipped(), diagnostics);
    }
  }
  fuzz::check(diagnostics);
  return 0;
}
