// SPDX-License-Identifier: Apache-2.0
#include "catalogue/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "catalogue/files.h"
#include "catalogue/read_table.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

std::vector<Table> empty_tables() {
  std::vector<Table> tables;
  for (const FamilyDeclaration& each : families) tables.emplace_back(each.family);
  return tables;
}

std::vector<Table> load_layer(const std::filesystem::path& place, int layer, text::Diagnostics& diagnostics) {
  std::vector<Table> tables = empty_tables();
  const std::size_t errors = diagnostics.error_count();
  const std::vector<CatalogueFile> files = catalogue_files(place, diagnostics);
  if (files.empty() && !stock_file(place) && supplier_files(place).empty() && diagnostics.error_count() == errors) {
    report_no_files(place, diagnostics);
  }
  std::vector<double> bytes(family_count, 0.0);
  for (const CatalogueFile& file : files)
    bytes[static_cast<std::size_t>(file.family)] += static_cast<double>(file.text->contents().size());
  for (const CatalogueFile& file : files) {
    // The first file of a family makes room for the rows of all, a little more for those that are shorter.
    Table& table = tables[static_cast<std::size_t>(file.family)];
    const double all = 1.02 * bytes[static_cast<std::size_t>(file.family)];
    const double room = table.empty() ? all / static_cast<double>(file.text->contents().size() + 1) : 1.0;
    table.append(read_table(file.text, file.family, layer, diagnostics, room));
  }
  for (Table& table : tables) drop_duplicates(table, diagnostics);
  return tables;
}

}  // namespace

Catalogue::Catalogue() : tables_(empty_tables()) {}

Catalogue Catalogue::load_parts(const std::vector<std::filesystem::path>& places, text::Diagnostics& diagnostics) {
  Catalogue catalogue;
  for (const std::filesystem::path& place : places) {
    if (place.empty()) {
      diagnostics.error("the shipped catalogues were not found", "set MILLWRIGHT_CATALOGUES to their folder");
      continue;
    }
    const int layer = static_cast<int>(catalogue.layers_.size());
    std::vector<Table> tables = load_layer(place, layer, diagnostics);
    catalogue.layers_.push_back(place);
    for (std::size_t family = 0; family < family_count; ++family) {
      if (!tables[family].empty()) catalogue.tables_[family].overlay(std::move(tables[family]));
    }
  }
  return catalogue;
}

Catalogue Catalogue::load(const std::vector<std::filesystem::path>& places, text::Diagnostics& diagnostics) {
  Catalogue catalogue = load_parts(places, diagnostics);
  for (const std::filesystem::path& place : places)
    if (const auto file = stock_file(place)) read_stock(*file, catalogue, catalogue.stock_, diagnostics);
  for (const std::filesystem::path& place : places)
    for (const std::filesystem::path& file : supplier_files(place))
      read_suppliers(file, catalogue, catalogue.suppliers_, diagnostics);
  check_suppliers(catalogue, catalogue.suppliers_, diagnostics);
  catalogue.add_offers();
  if (catalogue.rows() == 0 && !diagnostics.has_errors()) diagnostics.error("no parts: no catalogue was given");
  return catalogue;
}

int Catalogue::rows() const {
  int rows = 0;
  for (const Table& each : tables_) rows += each.rows();
  return rows;
}

FoundParts Catalogue::find(std::string_view part_number, std::string_view manufacturer) const {
  FoundParts found;
  std::vector<std::string_view> names;
  std::string family_problem;
  std::string family_hint;
  for (const Table& table : tables_) {
    const Found here = table.find(part_number, manufacturer);
    for (const int row : here.rows) found.parts.push_back(Part{table.family(), row});
    if (here.problem == Found::Problem::ambiguous || here.problem == Found::Problem::other_maker) {
      family_problem = here.error;
      family_hint = here.hint;
    }
    for (int row = 0; row < table.rows(); ++row) names.push_back(table.part_number(row));
  }
  if (!found.parts.empty()) return found;
  found.error =
      family_problem.empty() ? "no part " + text::in_quotes(part_number) + " in the catalogues" : family_problem;
  found.hint = family_problem.empty() ? text::did_you_mean(part_number, names) : family_hint;
  return found;
}

FoundParts Catalogue::find_named(std::string_view name) const {
  FoundParts found = find(name);
  if (!found.parts.empty()) return found;
  // Both makers and part numbers may hold blanks.
  std::optional<FoundParts> other_maker;
  for (std::size_t blank = name.find(' '); blank != std::string_view::npos; blank = name.find(' ', blank + 1)) {
    const std::string_view part_number = name.substr(blank + 1);
    FoundParts split = find(part_number, name.substr(0, blank));
    if (!split.parts.empty()) return split;
    if (!other_maker && !find(part_number).parts.empty()) other_maker = std::move(split);
  }
  if (other_maker) return *std::move(other_maker);
  if (!found.hint.empty()) return found;
  std::vector<std::string> names;
  for (const Table& table : tables_)
    for (int row = 0; row < table.rows(); ++row)
      names.push_back(std::string(table.manufacturer(row)) + " " + std::string(table.part_number(row)));
  found.hint = text::did_you_mean(name, names, "'millwright catalogue list FAMILY' shows what there is");
  return found;
}

Catalogue Catalogue::only(const std::vector<Part>& parts) const {
  std::vector<std::vector<int>> rows(family_count);
  for (const Part& part : parts) rows[static_cast<std::size_t>(part.family)].push_back(part.row);
  Catalogue result;
  for (std::size_t family = 0; family < family_count; ++family) {
    std::sort(rows[family].begin(), rows[family].end());
    result.tables_[family] = tables_[family].only(rows[family]);
  }
  result.layers_ = layers_;
  result.stock_ = stock_;
  result.suppliers_ = suppliers_;
  result.has_offers_ = has_offers_;
  result.add_offers();
  return result;
}

void Catalogue::drop(const std::vector<Part>& parts) {
  for (Table& table : tables_) {
    std::vector<bool> keep(static_cast<std::size_t>(table.rows()), true);
    for (const Part& part : parts)
      if (part.family == table.family()) keep[static_cast<std::size_t>(part.row)] = false;
    if (std::find(keep.begin(), keep.end(), false) != keep.end()) table.keep_only(keep);
  }
  add_offers();
}

}  // namespace millwright::catalogue
