// SPDX-License-Identifier: Apache-2.0
// Every constraint, and every default of a requirement, can be looked up where it comes from.
#include <set>
#include <sstream>

#include "catch.h"
#include "evaluation/declared_constraints.h"
#include "machine/requirement.h"
#include "rules/source_tree.h"

namespace millwright::rules::constraint_sources_test {
namespace {

std::set<std::string> bibliography_keys() {
  std::set<std::string> keys;
  const auto file = read_project_file(std::filesystem::path(MILLWRIGHT_SOURCE_DIR) / "src/mechanics/sources.bib");
  for (const std::string& line : lines_of(file.content)) {
    if (line.empty() || line.front() != '@') continue;
    const std::size_t open = line.find('{');
    keys.insert(line.substr(open + 1, line.find(',', open) - open - 1));
  }
  return keys;
}

/// What is wrong with a source "key, place; key, place", empty if nothing is.
std::string fault_of(std::string_view id, std::string_view source, const std::set<std::string>& keys) {
  std::istringstream sources{std::string(source)};
  bool any = false;
  for (std::string one; std::getline(sources, one, ';');) {
    const std::size_t start = one.find_first_not_of(' ');
    if (start == std::string::npos) continue;
    const std::string key = one.substr(start, one.find(',', start) - start);
    if (keys.count(key) == 0) return std::string(id) + ": the bibliography has no '" + key + "'";
    any = true;
  }
  return any ? std::string() : std::string(id) + " names no source";
}

TEST_CASE("Every constraint names a source that the bibliography has") {
  const auto keys = bibliography_keys();
  REQUIRE(keys.size() > 20);
  std::vector<std::string> findings;
  std::size_t constraints = 0;
  for (const DeclaringElement& element : declaring_elements())
    for (const machine::Declaration& declaration : element.constraints) {
      ++constraints;
      std::string fault = fault_of(declaration.id, declaration.source, keys);
      if (!fault.empty()) findings.push_back(std::string(declaration.file) + ": " + std::move(fault));
    }
  INFO(joined(findings));
  CHECK(findings.empty());
  CHECK(constraints > 60);
}

TEST_CASE("Every default of a requirement names a source that the bibliography has") {
  const auto keys = bibliography_keys();
  std::vector<std::string> findings;
  for (const machine::RequirementDeclaration& declaration : machine::requirements()) {
    // A requirement without a default needs no source, and has none.
    if (std::isnan(declaration.default_value) != declaration.source.empty())
      findings.push_back(std::string(declaration.key) + ": a default and its source go together");
    if (declaration.source.empty()) continue;
    std::string fault = fault_of(declaration.key, declaration.source, keys);
    if (!fault.empty()) findings.push_back(std::move(fault));
  }
  INFO(joined(findings));
  CHECK(findings.empty());
}

TEST_CASE("The constraint source rule finds what has no source") {
  const std::set<std::string> keys{"known2001", "other"};
  CHECK(fault_of("C-X", "known2001, p. 3; other", keys).empty());
  CHECK(fault_of("C-X", "other", keys).empty());
  CHECK(fault_of("C-X", "", keys) == "C-X names no source");
  CHECK(fault_of("C-X", " ; ", keys) == "C-X names no source");
  CHECK(fault_of("C-X", "handbook, section 3", keys) == "C-X: the bibliography has no 'handbook'");
  CHECK(fault_of("C-X", "known2001, p. 3; Other", keys) == "C-X: the bibliography has no 'Other'");
}

}  // namespace
}  // namespace millwright::rules::constraint_sources_test
