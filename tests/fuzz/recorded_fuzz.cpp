// SPDX-License-Identifier: Apache-2.0
// Results that `compare` reads (JSON), and two of them side by side.
#include "fuzz.h"
#include "report/comparison.h"
#include "report/recorded_build.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  text::Diagnostics diagnostics;
  const auto text = text::SourceText::from_string("result.json", std::string(fuzz::view(bytes, size)));
  const auto build = report::read_recorded_build(text, diagnostics);
  fuzz::require(build.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
  if (build) {
    const report::ComparedBuild a{"a.json", "recorded", build->title, build->axes, build->design};
    report::ComparedBuild b = a;
    b.design.parts.resize(b.design.parts.size() / 2);
    b.design.checks.resize(b.design.checks.size() / 2);
    const report::Comparison same = report::compare(a, a);
    fuzz::require(same.parts.empty() && same.dimensions.empty() && same.checks.empty(), "a build is like itself");
    fuzz::require(fuzz::is_printable(report::comparison_text(a, b, report::Style{})), "a comparison can be printed");
    (void)report::comparison_json(a, b);
  }
  fuzz::check(diagnostics);
  return 0;
}
