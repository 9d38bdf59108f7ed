// SPDX-License-Identifier: Apache-2.0
//
// `name=value` behind an option of the command line (`--limit cost=400`), as a text in which a complaint can point at
// the very characters.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "text/diagnostic.h"
#include "text/source_text.h"

namespace millwright::machine {

struct OptionWord {
  std::shared_ptr<const text::SourceText> text;  ///< "--limit cost=400"
  std::string name, value;                       ///< without the blanks around them
  std::size_t name_at = 0, value_at = 0;         ///< bytes of the text where they begin
  [[nodiscard]] text::SourceSpan name_span() const { return text::span_at(text, name_at, name.size()); }
  [[nodiscard]] text::SourceSpan value_span() const { return value_span(0, value.size()); }
  [[nodiscard]] text::SourceSpan value_span(std::size_t offset, std::size_t bytes) const {
    return text::span_at(text, value_at + offset, bytes > 0 ? bytes : 1);
  }
};

/// Takes `word` apart at its first '='. Without one, or with nothing on a side of it: reported, with `example` as the
/// hint ("--limit cost='400 USD'"), and nothing.
std::optional<OptionWord> read_option_word(std::string_view option,
                                           std::string_view word,
                                           const std::string& example,
                                           text::Diagnostics& diagnostics);

/// A word without '=' ("--without PART"): the whole of it is the value.
OptionWord plain_option_word(std::string_view option, std::string_view word);

}  // namespace millwright::machine
