// SPDX-License-Identifier: Apache-2.0
#include "report/problem_reference.h"

#include <set>
#include <sstream>

#include "catch.h"
#include "machine/requirement.h"
#include "report/source_list.h"

namespace millwright::report::problem_reference_test {
namespace {

TEST_CASE("A citation is read from the list of sources") {
  CHECK(citation("acarnley2002") ==
        "Acarnley, Paul: Stepping Motors: A Guide to Theory and Practice, 4. edition, Institution of Electrical "
        "Engineers, 2002");
  CHECK(citation("biagiotti_melchiorri2008").rfind("Biagiotti, Luigi; Melchiorri, Claudio: Trajectory Planning", 0) ==
        0);
  CHECK(citation("asme_b1_5") == "ASME: B1.5: Acme Screw Threads");
  CHECK(citation("no_such_source").empty());
  CHECK(citation("").empty());
}

TEST_CASE("The reference has every requirement with its default, and cites every source once") {
  const std::string text = problem_reference();
  const std::string sources = text.substr(text.find("## Sources\n"));
  for (const machine::RequirementDeclaration& each : machine::requirements()) {
    CAPTURE(each.key);
    CHECK(text.find("| `" + std::string(each.key) + "` | ") != std::string::npos);
    if (each.source.empty() || each.default_value != each.default_value) continue;
    const std::string entry = "\n- " + std::string(each.source) + ": ";
    const std::size_t at = sources.find(entry);
    REQUIRE(at != std::string::npos);
    CHECK(sources.find(entry, at + 1) == std::string::npos);
    const std::string words = sources.substr(at + entry.size(), sources.find('\n', at + 1) - at - entry.size());
    CHECK(words.size() > 10);
    CHECK(words.find_first_of("{}\\") == std::string::npos);
    CHECK(words.find("  ") == std::string::npos);
  }
}

TEST_CASE("Every row of the reference has four cells") {
  std::istringstream lines(problem_reference());
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] != '|') continue;
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
    CAPTURE(line);
    CHECK(bars == 5);
    ++rows;
  }
  CHECK(rows > 250);
}

}  // namespace
}  // namespace millwright::report::problem_reference_test
