// SPDX-License-Identifier: Apache-2.0
//
// Keys, words and names: what must be there, what must not, and what an axis may be called.
#include "machine/name_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/characters.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;

namespace {

bool is_name_character(char c) { return text::is_letter(c) || text::is_digit(c) || c == '_' || c == '-'; }

/// Bytes of the character that begins here.
std::size_t character_length(const std::string& word, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < word.size() && (static_cast<unsigned char>(word[end]) & 0xC0U) == 0x80U) ++end;
  return end - begin;
}

std::string repaired(const std::string& word) {
  std::string name;
  for (std::size_t i = 0; i < word.size(); i += character_length(word, i))
    name += is_name_character(word[i]) ? word[i] : '_';
  if (!text::is_letter(name.front())) name.insert(0, "x");
  return name;
}

}  // namespace

bool check_name(const Node& node, const std::string& what, Diagnostics& diagnostics) {
  const std::string word = node.as_string().value_or("");
  if (word.empty()) return false;
  std::size_t wrong = 0;
  while (wrong < word.size() && (wrong == 0 ? text::is_letter(word[0]) : is_name_character(word[wrong]))) ++wrong;
  if (wrong == word.size()) return true;
  diagnostics.error(node.part_span(wrong, character_length(word, wrong)),
                    fmt::format("name: {} cannot be called {}", what, text::in_quotes(word)),
                    fmt::format("names stand in bills of materials and in --set: a letter, then letters, digits, _ "
                                "and -, for example \"{}\"",
                                repaired(word)));
  return false;
}

const Node* QuantityReader::required(const text::Key& key, std::string_view example) {
  text::Question asked;
  asked.key = key.name;
  asked.meaning = key.meaning;
  asked.required = true;
  table_.describe(asked);
  const Node* node = table_.find(key.name);
  if (node == nullptr && table_.node().is_table())
    diagnostics_.error(table_.node().span(),
                       fmt::format("{} needs the key '{}'", table_.title(), key.name),
                       fmt::format("add {}", example));
  return node;
}

std::string QuantityReader::required_text(const text::Key& key, std::string_view example) {
  const Node* node = required(key.name, example);
  const auto word = table_.string(key);
  if (node == nullptr) return "";
  if (word && word->empty())
    diagnostics_.error(node->span(), fmt::format("{}: is empty", key.name), fmt::format("write {}", example));
  return word.value_or("");
}

std::vector<std::string> QuantityReader::words(const text::Key& key, const std::vector<std::string>& allowed) {
  if (!allowed.empty()) {
    text::Question asked;
    asked.expected = text::Expected::words;
    asked.key = key.name;
    asked.meaning = key.meaning;
    asked.words = allowed;
    table_.describe(asked);
  }
  std::vector<std::string> words = allowed.empty() ? table_.strings(key) : table_.strings(key.name);
  std::vector<std::string> seen;
  for (const Node* node : table_.list(key.name)) {
    const auto word = node->as_string();
    if (!word) continue;
    if (word->empty())
      diagnostics_.error(
          node->span(), fmt::format("{}: an empty word", key.name), "leave it out, or write what is wanted");
    else if (text::without_blanks(*word).size() != word->size())
      diagnostics_.error(node->span(),
                         fmt::format("{}: {} begins or ends with a blank", key.name, text::in_quotes(*word)),
                         "write the word without it");
    if (!word->empty() && std::find(seen.begin(), seen.end(), *word) != seen.end())
      diagnostics_.error(
          node->span(), fmt::format("{}: {} is there twice", key.name, text::in_quotes(*word)), "leave one out");
    seen.push_back(*word);
  }
  const Node* list = table_.find(key.name);
  if (list != nullptr && list->is_array() && list->size() == 0)
    diagnostics_.error(list->span(), fmt::format("{}: the list is empty", key.name), "leave the key out to allow all");
  return words;
}

void QuantityReader::refuse(std::initializer_list<std::string_view> keys,
                            const std::string& because,
                            const std::string& hint) {
  for (const std::string_view key : keys) {
    text::Question asked;
    asked.expected = text::Expected::not_allowed;
    asked.key = key;
    asked.meaning = hint;
    table_.describe(asked);
    if (table_.node().find(key) == nullptr) continue;
    (void)table_.has(key);
    diagnostics_.error(table_.node().key_span(key), fmt::format("{}: {}", key, because), hint);
  }
}

}  // namespace millwright::machine
