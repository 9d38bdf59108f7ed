// SPDX-License-Identifier: Apache-2.0
#include "report/page_texts.h"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>

namespace millwright::report {

std::string_view code(Language language) { return language == Language::indonesian ? "id" : "en"; }

std::optional<Language> language_of(std::string_view code) {
  if (code == "en") return Language::english;
  if (code == "id") return Language::indonesian;
  return std::nullopt;
}

std::vector<std::string> language_codes() { return {"en", "id"}; }

std::string Texts::operator()(std::string_view key) const {
  for (const PageText& text : page_texts())
    if (text.key == key) return std::string(language_ == Language::indonesian ? text.indonesian : text.english);
  throw std::logic_error(fmt::format("the page has no text '{}'", key));
}

namespace {

/// Numbers as gaps, and what stood there.
std::string with_gaps(std::string_view text, std::vector<std::string>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const bool begins = std::isdigit(static_cast<unsigned char>(text[i])) != 0 && (i == 0 || text[i - 1] == ' ');
    std::size_t end = i;
    while (begins && end < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.' || text[end] == '+' ||
            text[end] == '-'))
      ++end;
    if (!begins) {
      out += text[i++];
      continue;
    }
    numbers.emplace_back(text.substr(i, end - i));
    out += "{}";
    i = end;
  }
  return out;
}

std::string filled(std::string_view text, const std::vector<std::string>& numbers) {
  std::string out;
  std::size_t next = 0;
  for (std::size_t gap = text.find("{}"); gap != std::string_view::npos && next < numbers.size();
       gap = text.find("{}")) {
    out += std::string(text.substr(0, gap)) + numbers[next++];
    text.remove_prefix(gap + 2);
  }
  return out + std::string(text);
}

}  // namespace

std::string Texts::slot(std::string_view name) const {
  if (language_ == Language::english) return std::string(name);
  const std::string key = fmt::format("slot.{}", name);
  for (const PageText& text : page_texts())
    if (text.key == key) return std::string(text.indonesian);
  return std::string(name);
}

std::string Texts::axis(const std::string& name) const { return name == "machine" ? (*this)("machine") : name; }

std::string Texts::said(std::string_view english) const {
  if (language_ == Language::english) return std::string(english);
  for (const Saying& meaning : meanings())
    if (meaning.english == english) return std::string(meaning.indonesian);
  std::vector<std::string> numbers;
  const std::string form = with_gaps(english, numbers);
  for (const Saying& saying : sayings()) {
    if (saying.english == english) return std::string(saying.indonesian);
    if (saying.english == form) return filled(saying.indonesian, numbers);
  }
  return std::string(english);
}

std::string Texts::clauses(std::string_view english) const {
  std::string out;
  while (true) {
    const std::size_t end = english.find("; ");
    out += said(english.substr(0, end));
    if (end == std::string_view::npos) return out;
    out += "; ";
    english.remove_prefix(end + 2);
  }
}

namespace {

/// A move with its phase, or a place: "plunge up, accelerate at 79 %". A move's name is its user's word.
std::string said_place(const Texts& t, std::string_view english) {
  const std::size_t comma = english.rfind(", ");
  if (comma == std::string_view::npos) return t.said(english);
  std::string_view move = english.substr(0, comma), direction;
  for (const std::string_view each : {" up", " down", " there", " back"})
    if (move.ends_with(each)) {
      direction = each.substr(1);
      move.remove_suffix(each.size());
    }
  std::string out = move.starts_with("move ") ? t.said(move) : std::string(move);
  if (!direction.empty()) out += " " + t.said(direction);
  return out + ", " + t.said(english.substr(comma + 2));
}

}  // namespace

std::string Texts::worst(std::string_view english) const {
  if (language_ == Language::english) return std::string(english);
  const std::size_t end = english.find("; ");
  if (end == std::string_view::npos) return said_place(*this, english);
  return said_place(*this, english.substr(0, end)) + "; " + worst(english.substr(end + 2));
}

}  // namespace millwright::report
