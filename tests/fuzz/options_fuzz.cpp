// SPDX-License-Identifier: Apache-2.0
// What the command line says about a machine: lines `set ...`, `limit ...`, `fix ...`, `without ...`.
#include <cmath>

#include "fuzz.h"
#include "machine/problem_file.h"
#include "machine/setting_range.h"
#include "machine/steering.h"

using namespace millwright;

namespace {

std::vector<std::string> values_of(std::string_view option, const std::vector<std::string>& lines) {
  std::vector<std::string> values;
  for (const std::string& line : lines)
    if (line.starts_with(option)) values.push_back(line.substr(option.size()));
  return values;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const catalogue::Catalogue shipped = [] {
    text::Diagnostics diagnostics;
    return catalogue::Catalogue::load({MILLWRIGHT_SOURCE_DIR "/catalogues"}, diagnostics);
  }();
  static const text::Document original = [] {
    text::Diagnostics diagnostics;
    const auto text = text::SourceText::from_string("lifter.toml", fuzz::project_file("problems/lifter.toml"));
    return *text::read_toml(text, diagnostics);
  }();
  static const machine::Problem sound = [] {
    text::Diagnostics diagnostics;
    return *machine::problem_of(original, diagnostics);
  }();
  const std::vector<std::string> lines = fuzz::lines(fuzz::view(bytes, size));
  text::Diagnostics diagnostics;
  text::Document document = original;
  const std::vector<std::string> settings = values_of("set ", lines);
  for (const std::string& setting : settings) {
    if (machine::is_setting_range(setting)) {
      const auto range = machine::read_setting_range(setting, diagnostics);
      fuzz::require(range || diagnostics.has_errors(), "what is refused is complained about");
      if (range)
        for (const double value : range->values) fuzz::require(std::isfinite(value), "values of a range are finite");
    } else {
      const std::size_t errors = diagnostics.error_count();
      const bool good = document.set(setting, diagnostics);
      fuzz::require(good == (diagnostics.error_count() == errors), "what is refused is complained about");
    }
  }
  auto problem = settings.empty() ? std::optional(sound) : machine::problem_of(document, diagnostics);
  if (problem) {
    for (const machine::LimitOption& limit : machine::add_limits(values_of("limit ", lines), *problem, diagnostics))
      fuzz::require(std::isfinite(limit.value) && limit.value > 0.0, "limits are above zero");
    const auto without = machine::read_excluded(values_of("without ", lines), *problem, shipped, diagnostics);
    (void)machine::read_fixed(values_of("fix ", lines), *problem, shipped, without, diagnostics);
  }
  fuzz::check(diagnostics);
  return 0;
}
