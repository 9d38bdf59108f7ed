// SPDX-License-Identifier: Apache-2.0
// Every formula against values that were computed independently of this code.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "catch.h"
#include "mechanics/formula.h"
#include "scalar/unit.h"
#include "text/csv.h"

namespace check_values_test {

using namespace millwright;
using mechanics::Argument;
using mechanics::ArgumentKind;
using mechanics::ArgumentValue;
using mechanics::Formula;

namespace {

text::CsvTable check_values() {
  text::Diagnostics diagnostics;
  auto table = text::read_csv_file(MILLWRIGHT_SOURCE_DIR "/tests/mechanics/check_values.csv", diagnostics);
  REQUIRE_FALSE(diagnostics.has_errors());
  REQUIRE(table);
  return *table;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const auto end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    const auto first = part.find_first_not_of(' ');
    parts.emplace_back(first == std::string_view::npos ? "" : part.substr(first));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double number_in_si(const std::string& text, const Argument& argument) {
  std::string reason;
  const auto quantity =
      scalar::parse_quantity(text, scalar::Unit::of(argument.unit == "any" ? "" : argument.unit), reason);
  INFO(argument.name << " = '" << text << "': " << reason);
  REQUIRE(quantity);
  return quantity->si;
}

ArgumentValue<double> read_value(const std::string& text, const Argument& argument) {
  if (argument.kind == ArgumentKind::choice) {
    const auto found = std::find(argument.choices.begin(), argument.choices.end(), text);
    INFO(argument.name << " has no choice '" << text << "'");
    REQUIRE(found != argument.choices.end());
    return static_cast<int>(found - argument.choices.begin());
  }
  if (argument.kind == ArgumentKind::number) return number_in_si(text, argument);
  std::vector<double> list;
  for (const std::string& item : split(text, ',')) list.push_back(number_in_si(item, argument));
  return list;
}

std::vector<ArgumentValue<double>> read_arguments(const Formula& formula, std::string_view text) {
  std::vector<std::optional<ArgumentValue<double>>> values(formula.arguments().size());
  for (const std::string& item : split(text, ';')) {
    const auto equals = item.find('=');
    REQUIRE(equals != std::string::npos);
    const std::string name = item.substr(0, equals);
    const auto& arguments = formula.arguments();
    const auto found =
        std::find_if(arguments.begin(), arguments.end(), [&](const Argument& a) { return a.name == name; });
    INFO(formula.name() << " has no argument " << name);
    REQUIRE(found != arguments.end());
    values[static_cast<std::size_t>(found - arguments.begin())] = read_value(item.substr(equals + 1), *found);
  }
  std::vector<ArgumentValue<double>> complete;
  for (const auto& value : values) {
    INFO(formula.name() << ": an argument is missing");
    REQUIRE(value);
    complete.push_back(*value);
  }
  return complete;
}

}  // namespace

TEST_CASE("every formula gives its check values") {
  const text::CsvTable table = check_values();
  REQUIRE(table.columns().size() == 4);
  std::size_t run = 0;
  std::set<std::string> without_formula;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const Formula* formula = mechanics::find_formula(table.cell(row, 0));
    if (formula == nullptr) {
      without_formula.emplace(table.cell(row, 0));
      continue;
    }
    std::string reason;
    const scalar::Unit unit = scalar::Unit::of(table.cell(row, 3));
    const double expected = unit.to_si(*scalar::parse_number(table.cell(row, 2), reason));
    const double computed = formula->evaluate<double>(read_arguments(*formula, table.cell(row, 1)));
    INFO(formula->name() << " " << table.cell(row, 1) << ": expected " << expected << ", computed " << computed);
    if (formula->unit() != "any") CHECK(unit.dimension() == scalar::Unit::of(formula->unit()).dimension());
    CHECK(std::abs(computed - expected) <= 1e-9 * std::abs(expected));
    ++run;
  }
  WARN(fmt::format("{} check values run, {} formulas not registered yet", run, without_formula.size()));
  CHECK(run >= 150);
}

TEST_CASE("every formula of the handbook has a check value") {
  const text::CsvTable table = check_values();
  std::set<std::string> checked;
  for (std::size_t row = 0; row < table.row_count(); ++row) checked.emplace(table.cell(row, 0));
  for (const Formula& formula : mechanics::formulas()) {
    INFO(formula.name());
    if (!formula.handbook_id().empty()) CHECK(checked.count(formula.name()) == 1);
  }
}

}  // namespace check_values_test
