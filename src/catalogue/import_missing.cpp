// SPDX-License-Identifier: Apache-2.0
// What a mapping lacks: units that nobody said, columns that parts must have.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "catalogue/import_mapping.h"
#include "catalogue/import_names.h"
#include "catalogue/import_unit.h"

namespace millwright::catalogue {
namespace {

/// A mapping file that leaves a unit open is not complete.
void demand_units(const ImportChoices& choices, const ImportMapping& mapping, text::Diagnostics& diagnostics) {
  for (const GivenColumn& given : choices.columns) {
    if (given.from.empty() || !wants_unit(given.target)) continue;
    for (const SourceColumn& column : mapping.columns) {
      const bool open =
          column.target == given.target && column.has_bare_figures && column.unit_origin == UnitOrigin::none;
      const bool price_of_piece =
          declaration(given.target).kind == Kind::money && declaration(given.target).unit.empty();
      if (open && !price_of_piece)
        diagnostics.error(given.where,
                          fmt::format("nothing says the unit of {}", declaration(given.target).name),
                          fmt::format("add unit = \"{}\", if that is its unit", declaration(given.target).unit));
    }
  }
}

/// Adds what is known without asking, and tells what is missing.
void complete(const ImportSheet& sheet, ImportMapping& mapping, text::Diagnostics& diagnostics) {
  const auto provided = [&](std::string_view name) {
    const Column wanted = column(mapping.family, name);
    return std::any_of(mapping.columns.begin(),
                       mapping.columns.end(),
                       [&](const auto& each) { return each.target == wanted; }) ||
           std::any_of(mapping.constants.begin(), mapping.constants.end(), [&](const auto& each) {
             return each.first == wanted;
           });
  };
  if (!provided("source")) {
    std::string origin = "imported from " + std::filesystem::path(sheet.text->path()).filename().string();
    if (!sheet.sheet.empty()) origin += ", sheet " + sheet.sheet;
    mapping.constants.emplace_back(column(mapping.family, "source"), text::printable(origin));
  }
  const auto demand = [&](std::string_view name, const std::string& hint) {
    if (provided(name)) return;
    diagnostics.error(
        mapping.header,
        fmt::format("nothing in the table gives {}, which {} need", name, declaration(mapping.family).name),
        hint);
  };
  for (std::size_t index = 0; index < column_count(mapping.family); ++index) {
    const ColumnDeclaration& declared = declaration(Column{mapping.family, static_cast<std::uint8_t>(index)});
    if (declared.need == Need::required)
      demand(
          declared.name,
          fmt::format("say --constant {}='...' if it is the same for all rows: {}", declared.name, declared.meaning));
    if (declared.need == Need::expected && !provided(declared.name)) mapping.missing.emplace_back(declared.name);
  }
  const FamilyDeclaration& sold = declaration(mapping.family);
  const std::string unknown = "say --constant {0}='...', or --constant {0}= if it is not known";
  if (sold.priced_per_piece) demand("price", fmt::format(fmt::runtime(unknown), "price"));
  if (sold.priced_per_length) demand("price_per_length", fmt::format(fmt::runtime(unknown), "price_per_length"));
  if (sold.priced_per_mass) demand("price_per_mass", fmt::format(fmt::runtime(unknown), "price_per_mass"));
  const bool in_prices = std::any_of(mapping.columns.begin(), mapping.columns.end(), [](const SourceColumn& each) {
    return each.target && declaration(*each.target).kind == Kind::money &&
           ((!each.currency.empty() && each.currency != "?") || !each.cell_units.empty());
  });
  if (sold.priced() && !in_prices) demand("currency", "say for example --constant currency=EUR");
}

}  // namespace

void complete_mapping(const ImportSheet& sheet,
                      const ImportChoices& choices,
                      ImportMapping& mapping,
                      text::Diagnostics& diagnostics) {
  demand_units(choices, mapping, diagnostics);
  complete(sheet, mapping, diagnostics);
}

std::vector<const SourceColumn*> assumed_units(const ImportMapping& mapping) {
  std::vector<const SourceColumn*> columns;
  for (const SourceColumn& each : mapping.columns)
    if (each.target && each.unit_origin == UnitOrigin::assumed && each.has_bare_figures) columns.push_back(&each);
  return columns;
}

std::string currency_without_price(const SheetRows& row, const ImportMapping& mapping) {
  std::string found;
  for (std::size_t i = 0; i < mapping.columns.size(); ++i) {
    const SourceColumn& column = mapping.columns[i];
    if (!column.target || declaration(*column.target).kind != Kind::money) continue;
    if (!row.cell(i).empty() && !says_unknown(row.cell(i))) return {};
    std::vector<std::string> said{column.currency};
    for (const std::string& unit : column.cell_units) {
      std::string reason;
      if (const auto known = shop_unit(unit, *column.target, reason)) said.push_back(known->currency);
    }
    for (const std::string& currency : said)
      if (found.empty() && currency != "?") found = currency;
  }
  return found;
}

std::optional<std::size_t> column_beside_constant(const ImportMapping& mapping, Column target) {
  constexpr double surely = 0.9;
  for (std::size_t i = 0; i < mapping.columns.size(); ++i) {
    const SourceColumn& column = mapping.columns[i];
    if (!column.target && !column.companion && name_match(words_of(column.header), target) >= surely) return i;
  }
  return std::nullopt;
}

}  // namespace millwright::catalogue
