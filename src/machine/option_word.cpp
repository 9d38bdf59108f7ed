// SPDX-License-Identifier: Apache-2.0
#include "machine/option_word.h"

namespace millwright::machine {

namespace {

/// Where the word without the blanks around it begins, and how long it is.
std::pair<std::size_t, std::size_t> without_blanks(std::string_view word) {
  const std::size_t first = word.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {0, 0};
  return {first, word.find_last_not_of(" \t") - first + 1};
}

}  // namespace

OptionWord plain_option_word(std::string_view option, std::string_view word) {
  OptionWord result;
  const std::string before = std::string(option) + " ";
  result.text = text::SourceText::from_string("command line", before + std::string(word));
  const auto [first, length] = without_blanks(word);
  result.value = word.substr(first, length);
  result.value_at = before.size() + first;
  return result;
}

std::optional<OptionWord> read_option_word(std::string_view option,
                                           std::string_view word,
                                           const std::string& example,
                                           text::Diagnostics& diagnostics) {
  OptionWord result = plain_option_word(option, word);
  const std::size_t begin = option.size() + 1;
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos) {
    diagnostics.error(text::span_at(result.text, begin, word.size()), "'=' is missing", "write " + example);
    return std::nullopt;
  }
  const auto [name_first, name_length] = without_blanks(word.substr(0, equals));
  const auto [value_first, value_length] = without_blanks(word.substr(equals + 1));
  result.name = word.substr(name_first, name_length);
  result.name_at = begin + name_first;
  result.value = word.substr(equals + 1 + value_first, value_length);
  result.value_at = begin + equals + 1 + value_first;
  if (!result.name.empty() && !result.value.empty()) return result;
  diagnostics.error(text::span_at(result.text, begin + equals, 1),
                    result.name.empty() ? "there is no name before '='" : "there is nothing behind '='",
                    "write " + example);
  return std::nullopt;
}

}  // namespace millwright::machine
