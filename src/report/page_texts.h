// SPDX-License-Identifier: Apache-2.0
// Every word of the report page that is ours, in each language it is written in: one table, page_texts.cpp. What
// constraints, requirements and catalogues say of themselves stays in English.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace millwright::report {

enum class Language { english, indonesian };

/// "en", "id".
std::string_view code(Language language);
std::optional<Language> language_of(std::string_view code);
std::vector<std::string> language_codes();

struct PageText {
  std::string_view key, english, indonesian;
};
const std::vector<PageText>& page_texts();

/// The texts of one language.
class Texts {
 public:
  explicit Texts(Language language) : language_(language) {}
  /// Throws std::logic_error for a key that is not in the table.
  [[nodiscard]] std::string operator()(std::string_view key) const;
  [[nodiscard]] Language language() const { return language_; }

 private:
  Language language_;
};

}  // namespace millwright::report
