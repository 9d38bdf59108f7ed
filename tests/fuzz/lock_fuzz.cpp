// SPDX-License-Identifier: Apache-2.0
// Locks. Whoever edits one by hand breaks its seal, which is put right here so that all else is read too.
#include "fuzz.h"
#include "report/lock.h"
#include "report/lock_seal.h"

using namespace millwright;

namespace {

std::string sealed(std::string contents) {
  constexpr std::string_view key = "seal = \"";
  const std::size_t line = contents.find(key);
  if (line == std::string::npos) return contents;
  const std::size_t end = contents.find('"', line + key.size());
  if (end == std::string::npos) return contents;
  contents.replace(line + key.size(), end - line - key.size(), report::seal_of(contents));
  return contents;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  text::Diagnostics diagnostics;
  const auto text = text::SourceText::from_string("x.lock", sealed(std::string(fuzz::view(bytes, size))));
  const auto lock = report::read_lock(text, diagnostics);
  fuzz::require(lock.has_value() == !diagnostics.has_errors(), "what is refused is complained about");
  fuzz::check(diagnostics);
  if (!lock) return 0;
  text::Diagnostics again;
  const std::string written = report::lock_toml(*lock);
  const auto read = report::read_lock(text::SourceText::from_string("y.lock", written), again);
  fuzz::require(read.has_value(), "what was read can be written and read again", text::format(again));
  fuzz::require(report::lock_toml(*read) == written, "what is written is written again", written);
  return 0;
}
