// SPDX-License-Identifier: Apache-2.0
#include "catalogue/header.h"

#include <fmt/format.h>

#include "catalogue/column_unit.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

std::vector<std::string_view> known_names(Family family) {
  std::vector<std::string_view> names;
  for (std::size_t index = 0; index < column_count(family); ++index) {
    names.push_back(declaration(Column{family, static_cast<std::uint8_t>(index)}).name);
  }
  return names;
}

/// The unit of a number column as its header cell gives it; reported and none if there is no usable one.
std::optional<scalar::Unit> unit_of(const text::CsvColumn& cell, Column column, text::Diagnostics& diagnostics) {
  const ColumnDeclaration& declared = declaration(column);
  const scalar::Unit& expected = display_unit(column);
  if (!cell.unit) {
    if (declared.unit.empty() || declared.unit == "1") return expected;
    diagnostics.error(
        cell.span, fmt::format("column '{}' has no unit", declared.name), fmt::format("write {}", header_cell(column)));
    return std::nullopt;
  }
  std::string reason;
  const std::optional<scalar::Unit> unit = scalar::Unit::parse(*cell.unit, reason);
  if (unit && unit->fits(expected, reason)) return unit;
  const std::string hint =
      declared.kind == Kind::money
          ? fmt::format("write {}; the currency stands in the column currency", header_cell(column))
          : fmt::format("for example {}", header_cell(column));
  diagnostics.error(cell.unit_span, fmt::format("column '{}': {}", declared.name, reason), hint);
  return std::nullopt;
}

void require(bool there,
             std::string_view name,
             const text::CsvTable& csv,
             Family family,
             bool& complete,
             text::Diagnostics& diagnostics) {
  if (there) return;
  complete = false;
  const std::string_view family_name = declaration(family).name;
  diagnostics.error(csv.header_span(),
                    fmt::format("no column '{}', which {} need", name, family_name),
                    fmt::format("add {}", header_cell(column(family, name))));
}

}  // namespace

std::string header_cell(Column column) {
  const ColumnDeclaration& declared = declaration(column);
  return declared.unit.empty() ? std::string(declared.name) : fmt::format("{} [{}]", declared.name, declared.unit);
}

std::optional<Header> match_header(const text::CsvTable& csv, Family family, text::Diagnostics& diagnostics) {
  Header header;
  header.field_of_column.assign(column_count(family), -1);
  header.units.resize(column_count(family));
  bool complete = true;
  for (std::size_t field = 0; field < csv.columns().size(); ++field) {
    const text::CsvColumn& cell = csv.columns()[field];
    const std::optional<Column> known = find_column(family, cell.name);
    if (!known) {
      if (is_own_column(cell.name)) continue;
      if (is_companion(cell.name)) {
        if (const auto companion = match_companion(csv, field, family, diagnostics))
          header.companions.push_back(*companion);
        continue;
      }
      diagnostics.warning(
          cell.name_span,
          fmt::format("{} have no column {}; it is ignored", declaration(family).name, text::in_quotes(cell.name)),
          text::did_you_mean(cell.name, known_names(family)));
      continue;
    }
    header.field_of_column[known->index] = static_cast<int>(field);
    const Kind kind = declaration(*known).kind;
    if (kind == Kind::number || kind == Kind::money) {
      header.units[known->index] = unit_of(cell, *known, diagnostics);
      if (!header.units[known->index]) complete = false;
    } else if (cell.unit && !cell.unit->empty()) {
      diagnostics.warning(
          cell.unit_span, fmt::format("column '{}' takes no unit", cell.name), "leave the brackets out");
    }
  }
  const auto has = [&](std::string_view name) { return header.field_of_column[column(family, name).index] >= 0; };
  for (std::size_t index = 0; index < column_count(family); ++index) {
    const ColumnDeclaration& declared = declaration(Column{family, static_cast<std::uint8_t>(index)});
    if (declared.need == Need::required) require(has(declared.name), declared.name, csv, family, complete, diagnostics);
  }
  const FamilyDeclaration& sold = declaration(family);
  if (sold.priced_per_piece) require(has("price"), "price", csv, family, complete, diagnostics);
  if (sold.priced_per_length) require(has("price_per_length"), "price_per_length", csv, family, complete, diagnostics);
  if (sold.priced_per_mass) require(has("price_per_mass"), "price_per_mass", csv, family, complete, diagnostics);
  if (sold.priced()) require(has("currency"), "currency", csv, family, complete, diagnostics);
  if (!complete) return std::nullopt;
  return header;
}

}  // namespace millwright::catalogue
