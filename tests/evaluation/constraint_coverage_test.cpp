// SPDX-License-Identifier: Apache-2.0
// The machines of problems/ with their bills of materials put every declared constraint to work. The table says where:
// test_evaluation "The shipped machines*" -s
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "catch.h"
#include "evaluation/declared_constraints.h"
#include "evaluation/machines.h"
#include "evaluation/synthesis.h"
#include "machine/bill_of_materials.h"
#include "text/source_text.h"

namespace constraint_coverage_test {

using namespace millwright;
using evaluation::Check;
using evaluation::Verdict;

namespace {

const std::filesystem::path problems = std::filesystem::path(MILLWRIGHT_SOURCE_DIR) / "problems";
constexpr double active_from = 0.9;  // of what is permitted

/// What the machines make of one constraint.
struct Exercise {
  std::set<std::string> axes;  ///< "machine axis"
  double utilisation = 0.0;    ///< the largest
  std::string place;           ///< where that is
};
using Exercises = std::map<std::string, Exercise, std::less<>>;

std::set<std::string> declared_ids() {
  std::set<std::string> ids;
  for (const DeclaringElement& element : declaring_elements())
    for (const machine::Declaration& d : element.constraints) ids.emplace(d.id);
  return ids;
}

/// Every declared constraint, so far without exercise.
Exercises nothing_exercised(const std::set<std::string>& ids) {
  Exercises result;
  for (const std::string& id : ids) result[id];
  return result;
}

/// Counts the checks of a machine. A check without numbers, or one of which nothing is demanded, exercises nothing.
void count(Exercises& exercises, const std::string& machine, const std::vector<Check>& checks) {
  for (const Check& check : checks) {
    const auto exercise = exercises.find(check.id);
    if (exercise == exercises.end())
      throw std::runtime_error(fmt::format(
          "{} of {}, axis {}, is declared by no element (declared_constraints.h)", check.id, machine, check.axis));
    if (check.verdict == Verdict::not_evaluated || !std::isfinite(check.value) || check.utilisation <= 0.0) continue;
    Exercise& e = exercise->second;
    e.axes.insert(machine + " " + check.axis);
    if (check.utilisation <= e.utilisation) continue;
    e.utilisation = check.utilisation;
    e.place = fmt::format("{} {} {}", machine, check.axis, check.element);
  }
}

std::vector<std::string> never_exercised(const Exercises& exercises) {
  std::vector<std::string> ids;
  for (const auto& [id, exercise] : exercises)
    if (exercise.axes.empty()) ids.push_back(id);
  return ids;
}

/// By id: axes (of all machines) that exercise it, the largest utilisation, whether it is active, and where.
std::string table_of(const Exercises& exercises) {
  std::string table = fmt::format("{:<21}{:>4}{:>9}         {}\n", "id", "axes", "highest", "where");
  for (const auto& [id, e] : exercises)
    table += fmt::format("{:<21}{:>4}{:>9}{:<9}{}\n",
                         id,
                         e.axes.size(),
                         e.utilisation > 9.995 ? "> 999 %" : fmt::format("{:.1f} %", 100.0 * e.utilisation),
                         e.utilisation >= active_from ? " active" : "",
                         e.place);
  return table;
}

struct CheckedMachine {
  std::string name;
  std::vector<Check> checks;
  std::string bill;  ///< what is written in the bill of materials
};

CheckedMachine checked(const std::filesystem::path& problem_file) {
  CheckedMachine result;
  result.name = problem_file.stem().string();
  const machine::Problem problem = shipped_problem(result.name);
  std::vector<std::filesystem::path> places{std::string(MILLWRIGHT_SOURCE_DIR) + "/catalogues"};
  for (const std::string& overlay : problem.catalogues) places.push_back(problems / overlay);

  const std::string file = (problems / (result.name + "-bom.csv")).string();
  text::Diagnostics diagnostics;
  const auto source = text::SourceText::load(file, diagnostics);
  const auto bom = source ? machine::read_bill_of_materials(source, problem, diagnostics) : std::nullopt;
  if (!bom || diagnostics.count() > 0) throw std::runtime_error(text::format(diagnostics));
  result.bill = std::string(source->contents());

  const auto outcome = evaluation::check(problem, catalogue_of(places), *bom, false, {});
  for (const auto& p : outcome.problems) throw std::runtime_error(file + ": " + p.message);
  result.checks = outcome.design.checks;
  return result;
}

const std::vector<CheckedMachine>& machines() {
  static const std::vector<CheckedMachine> all = [] {
    std::set<std::filesystem::path> files;  // in the same order everywhere
    for (const auto& entry : std::filesystem::directory_iterator(problems))
      if (entry.path().extension() == ".toml") files.insert(entry.path());
    std::vector<CheckedMachine> result;
    for (const auto& file : files) result.push_back(checked(file));
    return result;
  }();
  return all;
}

/// Ids of constraints in the comment at the top of a bill of materials.
std::set<std::string> named_in_comment(const std::string& bill) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-";
  std::set<std::string> ids;
  for (std::size_t begin = 0; begin < bill.size() && bill[begin] == '#';) {
    const std::size_t end = std::min(bill.find('\n', begin), bill.size());
    const std::string line = bill.substr(begin, end - begin);
    for (std::size_t at = 1; at + 2 < line.size(); ++at) {
      const bool starts = line[at - 1] == ' ' || line[at - 1] == '(';
      if (!starts || (line[at] != 'C' && line[at] != 'F') || line[at + 1] != '-') continue;
      const std::size_t stop = std::min(line.find_first_not_of(letters, at), line.size());
      ids.insert(line.substr(at, stop - at));
    }
    begin = end + 1;
  }
  return ids;
}

Check made_up(const std::string& id, double value, double limit, Verdict verdict) {
  Check check;
  check.axis = "x";
  check.element = "drive";
  check.id = id;
  check.value = value;
  check.limit = limit;
  check.utilisation = value / limit;
  check.verdict = verdict;
  return check;
}

}  // namespace

TEST_CASE("The shipped machines exercise every constraint") {
  Exercises exercises = nothing_exercised(declared_ids());
  for (const CheckedMachine& each : machines()) count(exercises, each.name, each.checks);
  INFO(table_of(exercises));
  const std::vector<std::string> none;  // compared, so that a failure names them
  CHECK(never_exercised(exercises) == none);
}

TEST_CASE("What a bill of materials fails is said at its top, and nothing else") {
  for (const CheckedMachine& each : machines()) {
    const std::set<std::string> named = named_in_comment(each.bill);
    std::set<std::string> violated;
    for (const Check& check : each.checks) {
      if (check.verdict != Verdict::violated) continue;
      violated.insert(check.id);
      INFO(fmt::format(
          "problems/{}-bom.csv fails {} on axis {}: say why in its comment", each.name, check.id, check.axis));
      if (check.kind != machine::ConstraintKind::soft) CHECK(named.count(check.id) == 1);
    }
    for (const std::string& id : named) {
      INFO(fmt::format("problems/{}-bom.csv does not fail {}, which its comment names", each.name, id));
      CHECK(violated.count(id) == 1);
    }
  }
}

TEST_CASE("A constraint without machine is found, and so is one that nothing declares") {
  Exercises exercises = nothing_exercised({"C-A", "C-B", "C-C", "F-D"});
  count(exercises,
        "mill",
        {made_up("C-A", 0.95, 1.0, Verdict::satisfied),
         made_up("C-B", 1.0, 0.0, Verdict::not_evaluated),
         made_up("C-C", 0.0, 1.0, Verdict::satisfied)});
  count(exercises, "press", {made_up("C-A", 3.0, 4.0, Verdict::satisfied)});
  CHECK(never_exercised(exercises) == std::vector<std::string>{"C-B", "C-C", "F-D"});
  CHECK(exercises["C-A"].axes == std::set<std::string>{"mill x", "press x"});
  CHECK(exercises["C-A"].place == "mill x drive");
  CHECK(exercises["C-A"].utilisation == 0.95);
  const std::string table = table_of(exercises);
  CHECK(table.find("C-A                     2   95.0 % active  mill x drive\n") != std::string::npos);
  CHECK(table.find("C-B                     0    0.0 %         \n") != std::string::npos);
  CHECK_THROWS_AS(count(exercises, "mill", {made_up("C-E", 1.0, 2.0, Verdict::satisfied)}), std::runtime_error);
}

TEST_CASE("Ids are read from the comment at the top of a bill of materials") {
  CHECK(named_in_comment("# It fails (C-ST-INERTIA of Y, F-SUPPORT-FIXED);\n# and C-BS-DN. Not ABC-X\naxis\nC-NO\n") ==
        std::set<std::string>{"C-ST-INERTIA", "F-SUPPORT-FIXED", "C-BS-DN"});
}

}  // namespace constraint_coverage_test
