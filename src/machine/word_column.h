// SPDX-License-Identifier: Apache-2.0
//
// Columns of the catalogues by whose texts a problem chooses parts (frame = ["NEMA23"]), and what a word has to be of
// such a text. Tables of candidates and warnings about words both ask here.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.h"

namespace millwright::machine {

struct WordColumn {
  catalogue::Family family;
  catalogue::Column column;
  bool whole;  ///< a word has to be all of the text, else some part of it ("bush" of "recirculating bush")

  [[nodiscard]] std::string_view text(const catalogue::Table& table, int row) const { return table.text(column, row); }

  [[nodiscard]] bool takes(std::string_view word, std::string_view text) const {
    return whole ? text == word : text.find(word) != std::string_view::npos;
  }
  /// Whether one of the words takes the text; no words = anything goes.
  [[nodiscard]] bool takes(const std::vector<std::string>& words, std::string_view text) const {
    return words.empty() ||
           std::any_of(words.begin(), words.end(), [&](const std::string& word) { return takes(word, text); });
  }
  /// The same for the text of a row of the table of `family`.
  [[nodiscard]] bool takes(const std::vector<std::string>& words, const catalogue::Table& table, int row) const {
    return takes(words, text(table, row));
  }
};

namespace word_columns {

constexpr WordColumn of(catalogue::Family family, std::string_view name, bool whole) {
  return {family, catalogue::column(family, name), whole};
}

inline constexpr WordColumn motor_frame = of(catalogue::Family::steppers, "frame", true);
inline constexpr WordColumn thread_form = of(catalogue::Family::lead_screws, "thread_form", false);
inline constexpr WordColumn nut_material = of(catalogue::Family::lead_nuts, "material", false);
inline constexpr WordColumn belt_profile = of(catalogue::Family::belts, "profile", true);
inline constexpr WordColumn guide_kind = of(catalogue::Family::linear_guides, "kind", false);
inline constexpr WordColumn section_kind = of(catalogue::Family::steel_sections, "kind", false);
inline constexpr WordColumn screw_size = of(catalogue::Family::screws, "designation", true);
inline constexpr WordColumn property_class = of(catalogue::Family::screws, "property_class", true);

}  // namespace word_columns

}  // namespace millwright::machine
