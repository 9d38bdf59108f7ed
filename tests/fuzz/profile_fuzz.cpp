// SPDX-License-Identifier: Apache-2.0
// Measured motions: CSV files that a move of a problem file names.
#include <cmath>

#include "fuzz.h"
#include "machine/problem_file.h"

using namespace millwright;

namespace {

std::string problem_with(const std::string& profile) {
  return R"(title = "press"
[objective]
minimise = "cost"
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
direction = "vertical"
stroke = "2 m"
structure_mass = "3 kg"
mechanism = { kind = "screw", screw = ["lead_screws"], ends = "fixed-supported" }
motor = { from = "steppers" }
guide = { from = "linear_guides", friction = 0.01 }
[[axis.moves]]
profile = ")" +
         profile + "\"\n";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const fuzz::MemoryFile file;
  static const auto document = [] {
    text::Diagnostics diagnostics;
    return *text::read_toml(text::SourceText::from_string("press.toml", problem_with(file.path())), diagnostics);
  }();
  file.hold(fuzz::view(bytes, size));
  text::Diagnostics diagnostics;
  const auto problem = machine::problem_of(document, diagnostics);
  fuzz::require(problem.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
  fuzz::check(diagnostics);
  if (!problem) return 0;
  const auto& profile = problem->axes.front().moves.front().profile;
  fuzz::require(profile.has_value(), "the motion is there");
  for (const machine::ProfilePhase& phase : profile->phases)
    fuzz::require(std::isfinite(phase.acceleration) && std::isfinite(phase.speed) && std::isfinite(phase.force) &&
                      phase.duration > 0.0 && std::isfinite(phase.duration),
                  "phases are finite");
  return 0;
}
