// SPDX-License-Identifier: Apache-2.0
// What every file of the project keeps to.
#include <set>

#include "catch.h"
#include "rules/source_tree.h"

namespace millwright::rules::source_files_test {
namespace {

constexpr std::size_t most_lines = 400;
const std::set<std::string> names_without_meaning = {"util", "utils", "common", "core", "base", "misc", "helpers"};
const std::string licence_line = "SPDX-License-Identifier: Apache-2.0";

bool too_long(const ProjectFile& file) { return lines_of(file.content).size() > most_lines; }

bool has_meaningless_name(const std::string& path) {
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '/');)
    if (names_without_meaning.count(part.substr(0, part.find('.'))) != 0) return true;
  return false;
}

bool states_licence(const ProjectFile& file) {
  return file.content.substr(0, file.content.find('\n')) == "// " + licence_line;
}

// Folders in which somebody's checkout lies, and the material the project was written from: a path that starts there
// works on one machine only. A path is taken to start where no letter, digit or dot stands before the slash.
bool names_developer_path(const std::string& content) {
  for (const char* folder : {"/home"
                             "/",
                             "/work"
                             "/",
                             "/root"
                             "/",
                             "/Users"
                             "/",
                             "../"
                             "shared/"}) {
    const std::string start = folder;
    for (std::size_t at = content.find(start); at != std::string::npos; at = content.find(start, at + 1)) {
      const char before = at == 0 ? ' ' : content[at - 1];
      const bool inside_word = std::isalnum(static_cast<unsigned char>(before)) != 0 || before == '.' || before == '_';
      if (start.front() != '/' || !inside_word) return true;
    }
  }
  return false;
}

// ctest's list of tests is separated by semicolons: a test with one in its name would become two that match nothing and
// pass.
std::vector<std::string> test_names_with_semicolon(const std::string& content) {
  std::vector<std::string> names;
  for (const std::string& line : lines_of(content)) {
    const std::size_t macro = std::min(line.find("TEST_CASE(\""), line.find("SCENARIO(\""));
    if (macro == std::string::npos) continue;
    const std::size_t open = line.find('"', macro);
    const std::string name = line.substr(open, line.find('"', open + 1) - open);
    if (name.find(';') != std::string::npos) names.push_back(name);
  }
  return names;
}

template <class Broken>
std::vector<std::string> paths_where(const std::vector<ProjectFile>& files, Broken broken) {
  std::vector<std::string> paths;
  for (const ProjectFile& file : files)
    if (broken(file)) paths.push_back(file.path);
  return paths;
}

TEST_CASE("No source file is over 400 lines") {
  const auto findings = paths_where(cpp_files("src"), too_long);
  INFO(joined(findings));
  CHECK(findings.empty());
  CHECK(too_long({"src/text/a.h", std::string(401, '\n')}));
  CHECK_FALSE(too_long({"src/text/a.h", std::string(400, '\n')}));
}

TEST_CASE("No file or folder has a name without meaning") {
  const auto findings =
      paths_where(project_files("src"), [](const auto& file) { return has_meaningless_name(file.path); });
  INFO(joined(findings));
  CHECK(findings.empty());
  CHECK(has_meaningless_name("src/common/a.h"));
  CHECK(has_meaningless_name("src/text/utils.h"));
  CHECK(has_meaningless_name("src/core/x/a.cpp"));
  CHECK_FALSE(has_meaningless_name("src/mechanics/basement.h"));
}

TEST_CASE("Every source file states its licence") {
  std::vector<ProjectFile> files = cpp_files("src");
  for (ProjectFile& file : cpp_files("tests")) files.push_back(std::move(file));
  const auto findings = paths_where(files, [](const auto& file) { return !states_licence(file); });
  INFO(joined(findings));
  CHECK(findings.empty());
  CHECK_FALSE(states_licence({"a.h", "#pragma once\n// " + licence_line + "\n"}));
  CHECK_FALSE(states_licence({"a.h", ""}));
}

TEST_CASE("No file names a folder of one developer's machine") {
  const auto findings =
      paths_where(tracked_files(), [](const auto& file) { return names_developer_path(file.content); });
  INFO(joined(findings));
  CHECK(findings.empty());
  CHECK(
      names_developer_path("see /ho"
                           "me/ana/x.csv"));
  CHECK(
      names_developer_path("/wo"
                           "rk/main"));
  CHECK(
      names_developer_path("\"../sha"
                           "red/x.json\""));
  CHECK_FALSE(
      names_developer_path("https://shop.example/ho"
                           "me/motors"));
  CHECK_FALSE(names_developer_path("force/work/energy"));
}

TEST_CASE("No test name holds a semicolon") {
  const auto findings = paths_where(cpp_files("tests"),
                                    [](const auto& file) { return !test_names_with_semicolon(file.content).empty(); });
  INFO(joined(findings));
  CHECK(findings.empty());
  CHECK(test_names_with_semicolon("TEST_"
                                  "CASE(\"a; b\") {}\n")
            .size() == 1);
  CHECK(test_names_with_semicolon("TEST_"
                                  "CASE(\"a, b\") { f(); }\n")
            .empty());
}

}  // namespace
}  // namespace millwright::rules::source_files_test
