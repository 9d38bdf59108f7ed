// SPDX-License-Identifier: Apache-2.0
// Every word of the report page that is ours, in each language it is written in: one table, page_texts.cpp with
// page_texts_certificate.cpp and the like. What catalogues say of themselves stays in English.
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

/// What other rooms say in English: titles of constraints, phases, shares of an error, clauses of a proof's method.
/// `{}`: a number.
struct Saying {
  std::string_view english, indonesian;
};
const std::vector<Saying>& sayings();
/// The same of what requirements and the figures that a calculation starts from mean.
const std::vector<Saying>& meanings();

/// The texts of one language.
class Texts {
 public:
  explicit Texts(Language language) : language_(language) {}
  /// Throws std::logic_error for a key that is not in the table.
  [[nodiscard]] std::string operator()(std::string_view key) const;
  /// What a slot or an element is called; a member's name is its user's word.
  [[nodiscard]] std::string slot(std::string_view name) const;
  /// An axis's name, or what stands for the whole machine.
  [[nodiscard]] std::string axis(const std::string& name) const;
  /// A saying or meaning in this language; what is not in the tables stays as it is.
  [[nodiscard]] std::string said(std::string_view english) const;
  /// Sayings with "; " between them.
  [[nodiscard]] std::string clauses(std::string_view english) const;
  /// The phase of a move in which a check is worst, and the place: "lift up, accelerate; nut farthest ...".
  [[nodiscard]] std::string worst(std::string_view english) const;
  [[nodiscard]] Language language() const { return language_; }

 private:
  Language language_;
};

}  // namespace millwright::report
