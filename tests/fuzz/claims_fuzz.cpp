// SPDX-License-Identifier: Apache-2.0
// Claims files. What was accepted is audited: that cannot fail.
#include "evaluation/audit.h"
#include "fuzz.h"
#include "machine/claims.h"
#include "text/document.h"

using namespace millwright;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view input = fuzz::view(bytes, size);
  const bool is_json = input.starts_with("{");
  text::Diagnostics diagnostics;
  const auto text = text::SourceText::from_string(is_json ? "claims.json" : "claims.toml", std::string(input));
  const auto document = is_json ? text::read_json(text, diagnostics) : text::read_toml(text, diagnostics);
  fuzz::require(document || diagnostics.has_errors(), "a text that is refused is complained about");
  if (document) {
    const auto claims = machine::read_claims(*document, diagnostics);
    fuzz::require(claims.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
    if (claims)
      fuzz::require(evaluation::audit(*claims, true).rows.size() == claims->claims.size(), "every claim is judged");
  }
  fuzz::check(diagnostics);
  return 0;
}
