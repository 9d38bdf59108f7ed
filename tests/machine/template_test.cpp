// SPDX-License-Identifier: Apache-2.0
// The templates of `millwright new`: what they offer behind a '#' can be used.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "catalogue/catalogue.h"
#include "catch.h"
#include "machine/problem_file.h"
#include "machine/references.h"
#include "text/document.h"

namespace millwright::machine::template_test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool is_optional(const std::string& line) { return line.size() > 1 && line[0] == '#' && line[1] != ' '; }

/// The text with the optional lines from `begin` to before `end` in use.
std::string with_lines(std::vector<std::string> lines, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i >= begin && i < end) lines[i].erase(0, 1);
    text += lines[i] + "\n";
  }
  return text;
}

/// The text with each optional line in use alone, or with the table that it begins.
std::vector<std::string> texts_with_options(const std::string& text) {
  const std::vector<std::string> lines = lines_of(text);
  std::vector<std::string> texts;
  for (std::size_t begin = 0; begin < lines.size(); ++begin) {
    if (!is_optional(lines[begin])) continue;
    std::size_t end = begin + 1;
    if (lines[begin][1] == '[')
      while (end < lines.size() && is_optional(lines[end])) ++end;
    texts.push_back(with_lines(lines, begin, end));
    begin = end - 1;
  }
  return texts;
}

/// What is wrong with a problem of this text; empty if nothing.
std::string complaints(const std::string& text, const catalogue::Catalogue& catalogue) {
  text::Diagnostics diagnostics;
  const auto document = text::read_toml(text::SourceText::from_string("template.toml", text), diagnostics);
  if (const auto problem = document ? problem_of(*document, diagnostics) : std::nullopt)
    check_references(*problem, catalogue, diagnostics);
  return diagnostics.has_errors() ? text::format(diagnostics) : "";
}

TEST_CASE("Each optional line of a template can be used once its '#' is taken away") {
  text::Diagnostics diagnostics;
  const auto catalogue = catalogue::Catalogue::load({MILLWRIGHT_SOURCE_DIR "/catalogues"}, diagnostics);
  REQUIRE_FALSE(diagnostics.has_errors());
  std::size_t templates = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MILLWRIGHT_SOURCE_DIR "/src/app/templates")) {
    if (entry.path().extension() != ".toml") continue;
    ++templates;
    std::ifstream stream(entry.path());
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    CAPTURE(entry.path().string());
    CHECK(complaints(text, catalogue).empty());
    const std::vector<std::string> texts = texts_with_options(text);
    CHECK(texts.size() > 25);
    for (const std::string& each : texts) {
      const std::string wrong = complaints(each, catalogue);
      CAPTURE(wrong);
      CHECK(wrong.empty());
    }
  }
  CHECK(templates == 5);
}

}  // namespace
}  // namespace millwright::machine::template_test
