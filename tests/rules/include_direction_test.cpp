// SPDX-License-Identifier: Apache-2.0
// Which room may include which, and which library may be seen from where.
#include <map>
#include <set>

#include "catch.h"
#include "rules/source_tree.h"

namespace millwright::rules::include_direction_test {
namespace {

// A room always sees itself. The rooms of DESIGN stand in a row and see to the left; where a room must not know
// something that stands to its left, it is not in its line here.
const std::map<std::string, std::set<std::string>> visible_rooms = {
    {"text", {}},
    {"scalar", {}},
    {"solver", {"scalar"}},
    {"mechanics", {"scalar"}},
    {"catalogue", {"text", "scalar", "mechanics"}},
    {"machine", {"text", "scalar", "mechanics", "catalogue"}},
    {"evaluation", {"scalar", "solver", "mechanics", "catalogue", "machine"}},
    {"report", {"text", "scalar", "mechanics", "catalogue", "machine", "evaluation"}},
    {"app", {"text", "scalar", "solver", "mechanics", "catalogue", "machine", "evaluation", "report"}},
};

// Headers, by the start of their name, that only the rooms named may include.
const std::vector<std::pair<std::string, std::set<std::string>>> confined_headers = {
    {"toml++/", {"text"}},
    {"nlohmann/", {"text", "report", "app"}},
    {"udunits2", {"scalar"}},
    {"Ip", {"solver"}},
    {"coin/", {"solver"}},
    {"nlopt", {"solver"}},
    {"CLI/", {"app"}},
    {"Eigen/", {"scalar", "solver", "evaluation"}},
    {"fstream", {"text", "catalogue", "report", "app"}},
    {"filesystem", {"text", "catalogue", "machine", "report", "app"}},
    {"iostream", {"app"}},
    {"catch", {}},
};

struct Include {
  std::string name;
  bool own = false;  // "..." rather than <...>
};

std::vector<Include> includes_of(const std::string& content) {
  std::vector<Include> includes;
  for (const std::string& line : lines_of(content)) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const std::size_t open = line.find_first_of("<\"", word + 7);
    if (open == std::string::npos) continue;
    const std::size_t close = line.find(line[open] == '<' ? '>' : '"', open + 1);
    if (close != std::string::npos) includes.push_back({line.substr(open + 1, close - open - 1), line[open] == '"'});
  }
  return includes;
}

std::vector<std::string> forbidden_room_includes(const ProjectFile& file) {
  std::vector<std::string> findings;
  const std::string room = room_of(file.path);
  const auto visible = visible_rooms.find(room);
  if (visible == visible_rooms.end()) return {file.path + ": is in no room"};
  for (const Include& include : includes_of(file.content)) {
    const std::string target = include.name.substr(0, include.name.find('/'));
    if (visible_rooms.count(target) == 0) {
      if (include.own) findings.push_back(file.path + ": \"" + include.name + "\" does not start with a room");
    } else if (target != room && visible->second.count(target) == 0) {
      findings.push_back(file.path + ": " + room + " must not include " + include.name);
    }
  }
  return findings;
}

std::vector<std::string> forbidden_library_includes(const ProjectFile& file) {
  std::vector<std::string> findings;
  for (const Include& include : includes_of(file.content)) {
    if (include.own) continue;
    for (const auto& [start, rooms] : confined_headers)
      if (include.name.rfind(start, 0) == 0 && rooms.count(room_of(file.path)) == 0)
        findings.push_back(file.path + ": must not include <" + include.name + ">");
  }
  return findings;
}

TEST_CASE("Rooms include only rooms to their left") {
  std::vector<std::string> findings;
  const std::vector<ProjectFile> files = cpp_files("src");
  REQUIRE(files.size() > 20);
  for (const ProjectFile& file : files)
    for (std::string& finding : forbidden_room_includes(file)) findings.push_back(std::move(finding));
  INFO(joined(findings));
  CHECK(findings.empty());
}

TEST_CASE("Libraries are included only where they are at home") {
  std::vector<std::string> findings;
  for (const ProjectFile& file : cpp_files("src"))
    for (std::string& finding : forbidden_library_includes(file)) findings.push_back(std::move(finding));
  INFO(joined(findings));
  CHECK(findings.empty());
}

TEST_CASE("The include rule finds a step to the right") {
  const auto count = [](const std::string& path, const std::string& line) {
    return forbidden_room_includes({path, "#pragma once\n" + line + "\n"}).size();
  };
  CHECK(count("src/text/csv.h", "#include \"scalar/unit.h\"") == 1);
  CHECK(count("src/scalar/unit.cpp", "#include \"text/diagnostic.h\"") == 1);
  CHECK(count("src/solver/box.h", "  #  include \"mechanics/belt.h\"") == 1);
  CHECK(count("src/solver/box.h", "#include <evaluation/axis.h>") == 1);
  CHECK(count("src/machine/axis.h", "#include \"solver/stage.h\"") == 1);
  CHECK(count("src/evaluation/axis.cpp", "#include \"text/csv.h\"") == 1);
  CHECK(count("src/report/sheet.cpp", "#include \"solver/solver.h\"") == 1);
  CHECK(count("src/report/sheet.cpp", "#include \"app/options.h\"") == 1);
  CHECK(count("src/mechanics/belt.h", "#include \"screw.h\"") == 1);
  CHECK(count("src/helpers.h", "") == 1);
  CHECK(count("src/tools/csv.h", "") == 1);
  CHECK(count("src/evaluation/axis.cpp", "#include \"evaluation/axis.h\"") == 0);
  CHECK(count("src/app/main.cpp", "#include \"text/csv.h\"\n#include <vector>") == 0);
}

TEST_CASE("The library rule finds a library away from home") {
  const auto count = [](const std::string& path, const std::string& line) {
    return forbidden_library_includes({path, line + "\n"}).size();
  };
  CHECK(count("src/machine/problem.cpp", "#include <toml++/toml.h>") == 1);
  CHECK(count("src/machine/problem.cpp", "#include <nlohmann/json.hpp>") == 1);
  CHECK(count("src/text/csv.cpp", "#include <udunits2.h>") == 1);
  CHECK(count("src/evaluation/axis.cpp", "#include <IpTNLP.hpp>") == 1);
  CHECK(count("src/evaluation/axis.cpp", "#include <nlopt.hpp>") == 1);
  CHECK(count("src/mechanics/belt.h", "#include <fstream>") == 1);
  CHECK(count("src/report/sheet.cpp", "#include <CLI/CLI.hpp>") == 1);
  CHECK(count("src/text/document.cpp", "#include <toml++/toml.h>") == 0);
  CHECK(count("src/scalar/unit.cpp", "#include <udunits2.h>\n#include <fmt/format.h>") == 0);
}

}  // namespace
}  // namespace millwright::rules::include_direction_test
