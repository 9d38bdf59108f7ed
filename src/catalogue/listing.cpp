// SPDX-License-Identifier: Apache-2.0
#include "catalogue/listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "catalogue/cell_text.h"
#include "catalogue/column_unit.h"

namespace millwright::catalogue {
namespace {

bool is_number(Column column) {
  const Kind kind = declaration(column).kind;
  return kind == Kind::number || kind == Kind::money;
}

template <class Visit>
void for_each_column(Family family, const Visit& visit) {
  for (std::size_t index = 0; index < column_count(family); ++index)
    visit(Column{family, static_cast<std::uint8_t>(index)});
}

void add_price(const Table& table, Column column, int row, double value, std::vector<PriceRange>& ranges) {
  const std::string_view currency = table.text("currency", row);
  const auto found = std::find_if(ranges.begin(), ranges.end(), [&](const PriceRange& each) {
    return each.column == declaration(column).name && each.currency == currency;
  });
  if (found == ranges.end()) {
    ranges.push_back(PriceRange{declaration(column).name, declaration(column).unit, currency, value, value, 1});
    return;
  }
  found->lowest = std::min(found->lowest, value);
  found->highest = std::max(found->highest, value);
  ++found->rows;
}

/// As many digits as a catalogue gives: the shortest decimal that is the value to 12 digits.
std::string shortest_decimal(double value) { return scalar::format_number(value, 12); }

std::string place_of(const text::SourceSpan& span, bool with_column) {
  const std::string line = fmt::format("{}:{}", span.text ? span.text->path() : std::string(), span.line);
  return with_column ? fmt::format("{}:{}", line, span.column) : line;
}

}  // namespace

FamilySummary summarise(const Table& table) {
  const FamilyDeclaration& declared = declaration(table.family());
  FamilySummary summary{table.family(), declared.name, declared.title, table.rows(), 0, {}, 0.0, 0.0, 0.0};
  std::set<std::string_view> makers;
  int figures = 0, estimates = 0, prices = 0, estimated_prices = 0, low = 0;
  for (int row = 0; row < table.rows(); ++row) {
    makers.insert(table.manufacturer(row));
    low += table.confidence(row) == "low";
    for_each_column(table.family(), [&](Column each) {
      if (!is_number(each)) return;
      const double value = table.number(each, row);
      if (std::isnan(value)) return;
      const bool money = declaration(each).kind == Kind::money;
      (money ? prices : figures) += 1;
      (money ? estimated_prices : estimates) += table.is_estimate(row, each);
      if (money) add_price(table, each, row, display_unit(each).from_si(value), summary.prices);
    });
  }
  const auto share = [](int part, int whole) { return whole == 0 ? 0.0 : static_cast<double>(part) / whole; };
  summary.manufacturers = static_cast<int>(makers.size());
  summary.estimated_share = share(estimates, figures);
  summary.estimated_price_share = share(estimated_prices, prices);
  summary.low_confidence_share = share(low, table.rows());
  return summary;
}

std::vector<FamilySummary> summarise(const Catalogue& catalogue) {
  std::vector<FamilySummary> all;
  for (const FamilyDeclaration& each : families) all.push_back(summarise(catalogue.table(each.family)));
  return all;
}

std::vector<PartLine> list_parts(const Table& table) {
  std::vector<PartLine> lines;
  for (int row = 0; row < table.rows(); ++row) {
    std::string figures;
    for_each_column(table.family(), [&](Column each) {
      const ColumnDeclaration& declared = declaration(each);
      if (declared.need != Need::required || declared.kind != Kind::number) return;
      const std::string unit = shown_unit(table, each, row);
      figures += fmt::format("{}{} {}{}{}",
                             figures.empty() ? "" : ", ",
                             declared.name,
                             scalar::format_number(display_unit(each).from_si(table.number(each, row)), 5),
                             unit.empty() ? "" : " ",
                             unit);
    });
    lines.push_back(PartLine{row,
                             table.manufacturer(row),
                             table.part_number(row),
                             std::move(figures),
                             table.price(row),
                             table.is_price_estimate(row),
                             table.confidence(row)});
  }
  return lines;
}

PartSheet show(const Table& table, int row) {
  PartSheet sheet{
      table.family(), row, table.manufacturer(row), table.part_number(row), place_of(table.where(row), false), {}};
  for_each_column(table.family(), [&](Column each) {
    const ColumnDeclaration& declared = declaration(each);
    Figure figure;
    figure.column = declared.name;
    figure.meaning = declared.meaning;
    figure.place = place_of(table.where(row, each), true);
    if (declared.kind == Kind::text) {
      figure.value = table.text(each, row);
      figure.si = figure.tolerance = std::nan("");
      if (figure.value.empty()) return;
    } else {
      figure.si = table.number(each, row);
      if (std::isnan(figure.si)) return;
      figure.value = declared.kind == Kind::flag ? (figure.si != 0.0 ? "yes" : "no")
                                                 : shortest_decimal(display_unit(each).from_si(figure.si));
      figure.unit = shown_unit(table, each, row);
      figure.standing = table.standing(row, each);
      figure.estimate = table.is_estimate(row, each);
      figure.tolerance = table.tolerance(row, each);
      figure.confidence = table.figure_confidence(row, each);
      figure.basis = table.figure_source(row, each);
      if (figure.basis.empty() && !declared.basis.empty()) figure.basis = table.text(declared.basis, row);
    }
    sheet.figures.push_back(std::move(figure));
  });
  return sheet;
}

}  // namespace millwright::catalogue
