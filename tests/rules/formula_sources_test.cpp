// SPDX-License-Identifier: Apache-2.0
// Every formula can be looked up where it comes from.
#include <set>

#include "catch.h"
#include "mechanics/formula.h"
#include "rules/source_tree.h"

namespace millwright::rules::formula_sources_test {
namespace {

/// Keys of the entries of a .bib file: "@book{acarnley2002," -> "acarnley2002".
std::set<std::string> bibliography_keys(const std::string& bibliography) {
  std::set<std::string> keys;
  for (const std::string& line : lines_of(bibliography)) {
    if (line.empty() || line.front() != '@') continue;
    const std::size_t open = line.find('{');
    const std::size_t comma = line.find(',', open);
    if (open != std::string::npos && comma != std::string::npos) keys.insert(line.substr(open + 1, comma - open - 1));
  }
  return keys;
}

/// What is wrong with a formula's source, empty if nothing is.
std::string fault_of(const mechanics::Formula& formula, const std::set<std::string>& keys) {
  if (formula.source_keys().empty()) return formula.name() + " names no source";
  for (const std::string& key : formula.source_keys())
    if (keys.count(key) == 0) return formula.name() + ": the bibliography has no '" + key + "'";
  return {};
}

mechanics::Formula formula_with_source(const std::string& source) {
  return {{.name = "belt.tension", .unit = "N", .source = source}, {}, {}};
}

TEST_CASE("Every formula names a source that the bibliography has") {
  const auto keys = bibliography_keys(
      read_project_file(std::filesystem::path(MILLWRIGHT_SOURCE_DIR) / "src/mechanics/sources.bib").content);
  REQUIRE_FALSE(keys.empty());
  REQUIRE_FALSE(mechanics::formulas().empty());
  std::vector<std::string> findings;
  for (const mechanics::Formula& formula : mechanics::formulas()) {
    std::string fault = fault_of(formula, keys);
    if (!fault.empty()) findings.push_back(std::move(fault));
  }
  INFO(joined(findings));
  CHECK(findings.empty());
}

TEST_CASE("The bibliography lists no source twice") {
  const auto file = read_project_file(std::filesystem::path(MILLWRIGHT_SOURCE_DIR) / "src/mechanics/sources.bib");
  std::size_t entries = 0;
  for (const std::string& line : lines_of(file.content)) entries += !line.empty() && line.front() == '@' ? 1 : 0;
  CHECK(bibliography_keys(file.content).size() == entries);
}

TEST_CASE("The source rule finds a formula without a source") {
  const auto keys = bibliography_keys("% @book{commented,\n@book{known2001,\n  title = {x},\n}\n@misc{other,\n}\n");
  CHECK(keys == std::set<std::string>{"known2001", "other"});
  CHECK(fault_of(formula_with_source("known2001, p. 12; other, section 3"), keys).empty());
  CHECK_THROWS(formula_with_source(""));
  CHECK_FALSE(fault_of(formula_with_source(","), keys).empty());
  CHECK_FALSE(fault_of(formula_with_source("unknown, p. 1"), keys).empty());
  CHECK_FALSE(fault_of(formula_with_source("known2001, p. 12; commented"), keys).empty());
}

}  // namespace
}  // namespace millwright::rules::formula_sources_test
