// SPDX-License-Identifier: Apache-2.0
// Random tables of every family, in random units, column order and quoting: what was written is what is read.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "catalogue/read_table.h"
#include "catch.h"

namespace random_tables_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

/// For a customary unit: other spellings with the factor to SI, written down by hand.
const std::map<std::string_view, std::vector<std::pair<std::string_view, double>>> spellings = {
    {"mm", {{"mm", 1e-3}, {"m", 1.0}, {"cm", 1e-2}, {"um", 1e-6}, {"in", 0.0254}}},
    {"N.m", {{"N.m", 1.0}, {"N.cm", 1e-2}, {"mN.m", 1e-3}, {"oz.in", 0.028349523125 * 9.80665 * 0.0254}, {"Nm", 1.0}}},
    {"g.cm2", {{"g.cm2", 1e-7}, {"kg.m2", 1.0}, {"kg.cm^2", 1e-4}}},
    {"kg", {{"kg", 1.0}, {"g", 1e-3}}},
    {"N", {{"N", 1.0}, {"kN", 1e3}, {"kgf", 9.80665}}},
    {"MPa", {{"MPa", 1e6}, {"N/mm^2", 1e6}, {"GPa", 1e9}, {"kgf/mm2", 9.80665e6}}},
    {"rpm", {{"rpm", 2 * 3.14159265358979323846 / 60}, {"rad/s", 1.0}}},
    {"A", {{"A", 1.0}, {"mA", 1e-3}}},
    {"mH", {{"mH", 1e-3}, {"H", 1.0}, {"uH", 1e-6}}},
    {"N/um", {{"N/um", 1e6}, {"N/m", 1.0}, {"kgf/um", 9.80665e6}}},
    {"%", {{"%", 1e-2}}},
    {"1", {{"1", 1.0}}},
    {"degC", {}},
};

std::string quoted_cell(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace

TEST_CASE("random tables survive") {
  std::mt19937 random(42);
  const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::vector<std::string> words = {"x", "a,b", "say \"hi\"", "é", "line\nbreak", "1.5", "#3", "A B"};
  for (int round = 0; round < 170; ++round) {
    const Family family = static_cast<Family>(round % static_cast<int>(family_count));
    std::vector<Column> columns;
    for (std::size_t i = 0; i < column_count(family); ++i) {
      const Column each{family, static_cast<std::uint8_t>(i)};
      const ColumnDeclaration& declared = declaration(each);
      const bool needed =
          declared.need == Need::required || declared.kind == Kind::money || declared.name == "currency";
      const bool has_rules = declared.name == "price_breaks" || declared.name == "pack_size" ||
                             declared.name == "owned_quantity" || declared.name == "availability";  // piece_price_test
      if (declared.unit == "degC" || has_rules || (!needed && pick(3) == 0)) continue;
      columns.push_back(each);
    }
    std::shuffle(columns.begin(), columns.end(), random);
    std::string csv = pick(2) == 0 ? "# comment\n" : "";
    std::vector<double> factors(columns.size(), 1.0);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const ColumnDeclaration& declared = declaration(columns[i]);
      std::string unit(declared.unit);
      if (declared.kind == Kind::number && !spellings.contains(declared.unit))
        factors[i] = std::nan("");  // not checked
      if (const auto known = spellings.find(declared.unit); declared.kind == Kind::number && known != spellings.end()) {
        const auto& [name, factor] = known->second[pick(known->second.size())];
        unit = name;
        factors[i] = factor;
      }
      csv += fmt::format("{}{}{}", i == 0 ? "" : ",", declared.name, unit.empty() ? "" : " [" + unit + "]");
    }
    csv += '\n';
    const std::size_t rows = 1 + pick(40);
    std::vector<std::vector<double>> numbers(rows, std::vector<double>(columns.size()));
    std::vector<std::vector<std::string>> texts(rows, std::vector<std::string>(columns.size()));
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const ColumnDeclaration& declared = declaration(columns[i]);
        std::string cell;
        if (declared.kind == Kind::flag) {
          numbers[row][i] = static_cast<double>(pick(2));
          cell = numbers[row][i] == 1.0 ? "yes" : "no";
        } else if (declared.kind == Kind::text) {
          texts[row][i] = declared.name == "part_number"                   ? fmt::format("P\"{}\"", row)
                          : declared.name == "currency"                    ? "EUR"
                          : declared.name == "confidence"                  ? "medium"
                          : declared.need == Need::required || pick(4) > 0 ? words[pick(words.size())]
                                                                           : "";
          cell = texts[row][i].empty() ? "" : quoted_cell(texts[row][i]);
        } else {
          const bool hole = declared.need == Need::optional && declared.kind == Kind::number && pick(4) == 0;
          numbers[row][i] = hole ? std::nan("") : std::exp(std::uniform_real_distribution<double>(-12, 12)(random));
          cell = hole ? "" : fmt::format("{}", numbers[row][i]);
        }
        csv += (i == 0 ? "" : ",") + cell;
      }
      csv += pick(2) == 0 ? "\n" : "\r\n";
    }
    text::Diagnostics diagnostics;
    const Table table = read_table(text::SourceText::from_string("random.csv", csv), family, 0, diagnostics);
    INFO(text::format(diagnostics) << csv.substr(0, 2000));
    REQUIRE_FALSE(diagnostics.has_errors());
    REQUIRE(table.rows() == static_cast<int>(rows));
    bool same = true;
    for (std::size_t row = 0; row < rows; ++row) {
      const int at = static_cast<int>(row);
      for (std::size_t i = 0; i < columns.size(); ++i) {
        if (declaration(columns[i]).kind == Kind::text) {
          same = same && table.text(columns[i], at) == texts[row][i];
          continue;
        }
        const double value = table.number(columns[i], at);
        const double expected = numbers[row][i] * factors[i];
        if (std::isnan(factors[i])) continue;
        same = same &&
               (std::isnan(expected) ? std::isnan(value) : std::abs(value - expected) <= 4e-15 * std::abs(expected));
      }
      const std::string name = fmt::format("P\"{}\"", row);
      const text::SourceSpan place = table.where(at);
      same = same && place.text->line(place.line).find(fmt::format("P\"\"{}\"\"", row)) != std::string_view::npos;
      same = same && table.find(name).rows == std::vector<int>{at};
    }
    CHECK(same);
  }
}

}  // namespace random_tables_test
