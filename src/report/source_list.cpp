// SPDX-License-Identifier: Apache-2.0
#include "report/source_list.h"

#include "report/page_assets.h"

namespace millwright::report {

namespace {

/// The value of a field in an entry: what its outermost braces hold, without inner ones, escapes and ends of lines.
std::string field(std::string_view entry, std::string_view name) {
  const std::string start = "\n  " + std::string(name) + " = {";
  std::size_t at = entry.find(start);
  if (at == std::string_view::npos) return "";
  at += start.size();
  std::string value;
  for (int depth = 1; at < entry.size(); ++at) {
    depth += entry[at] == '{' ? 1 : entry[at] == '}' ? -1 : 0;
    if (depth == 0) break;
    const char c = entry[at] == '\n' ? ' ' : entry[at];
    const bool again = c == ' ' && !value.empty() && value.back() == ' ';
    if (c != '{' && c != '}' && c != '\\' && !again) value += c;
  }
  return value;
}

/// BibTeX's " and " between names is a semicolon for people.
std::string names(std::string text) {
  constexpr std::string_view between = " and ";
  for (std::size_t at = text.find(between); at != std::string::npos; at = text.find(between))
    text.replace(at, between.size(), "; ");
  return text;
}

}  // namespace

std::string citation(std::string_view key) {
  static const std::string all = sources_bib();
  const std::string head = "{" + std::string(key) + ",\n";
  const std::size_t begin = all.find(head);
  if (begin == std::string::npos) return "";
  const std::string_view entry = std::string_view(all).substr(begin, all.find("\n}", begin) - begin);
  std::string text = names(field(entry, "author"));
  if (!text.empty()) text += ": ";
  text += field(entry, "title");
  for (const char* name : {"edition", "journal", "publisher", "institution", "year", "note"}) {
    const std::string value = field(entry, name);
    if (value.empty()) continue;
    text += ", " + value;
    if (std::string_view(name) == "edition") text += ". edition";
  }
  return text;
}

}  // namespace millwright::report
