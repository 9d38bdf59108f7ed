// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "catalogue/files.h"
#include "catalogue/header.h"
#include "catalogue/lint_overlay.h"
#include "catalogue/lint_row.h"
#include "catalogue/lint_twins.h"
#include "catalogue/read_table.h"

namespace millwright::catalogue {
namespace {

bool is_missing(const Table& table, Column column, int row) {
  return declaration(column).kind == Kind::text ? table.text(column, row).empty()
                                                : std::isnan(table.number(column, row));
}

/// One warning for each file and expected column with holes.
void lint_missing(const Table& table, text::Diagnostics& diagnostics) {
  std::vector<int> rows_in_file(table.files().size(), 0);
  for (int row = 0; row < table.rows(); ++row) ++rows_in_file[table.file(row)];
  for (std::size_t index = 0; index < column_count(table.family()); ++index) {
    const Column each{table.family(), static_cast<std::uint8_t>(index)};
    if (declaration(each).need != Need::expected) continue;
    std::map<std::size_t, std::pair<int, int>> holes;  // file: first row, count
    for (int row = 0; row < table.rows(); ++row) {
      if (is_missing(table, each, row)) ++holes.try_emplace(table.file(row), row, 0).first->second.second;
    }
    for (const auto& [file, hole] : holes) {
      const auto& [first, count] = hole;
      const bool absent = table.files()[file].field_of_column[index] < 0;
      diagnostics.warning(
          absent ? text::whole(table.files()[file].text) : table.where(first, each),
          absent ? fmt::format("no column '{}' [missing]", declaration(each).name)
                 : fmt::format(
                       "{} is missing in {} of {} rows [missing]", declaration(each).name, count, rows_in_file[file]),
          fmt::format("{}: {}", header_cell(each), declaration(each).meaning));
    }
  }
}

/// A stepper's pull-out torque does not rise with speed (beyond what reading a chart by eye costs).
void lint_curves(const Table& table, Waivers& waivers, text::Diagnostics& diagnostics) {
  constexpr Column speed = column(Family::stepper_curves, "speed");
  constexpr Column torque = column(Family::stepper_curves, "torque");
  RowIndex curves(static_cast<std::size_t>(table.rows()));
  std::map<int, std::vector<int>> points_of_curve;
  for (int row = 0; row < table.rows(); ++row) {
    const auto same = [&](int there) { return table.same_part(row, table, there, Identity::group); };
    const int first = curves.insert(table.part_hash(row, Identity::group), row, same);
    points_of_curve[first == RowIndex::none ? row : first].push_back(row);
  }
  for (auto& [curve, points] : points_of_curve) {
    std::sort(
        points.begin(), points.end(), [&](int a, int b) { return table.number(speed, a) < table.number(speed, b); });
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double before = table.number(torque, points[i - 1]);
      const double here = table.number(torque, points[i]);
      const std::string message =
          fmt::format("pull-out torque rises from {:.4g} to {:.4g} N.m with speed", before, here);
      const LintRow row(table, points[i], waivers);
      row.demand("rising-torque", torque, !(here > 1.5 * before), message);
      row.expect("rising-torque", torque, !(here > 1.02 * before && here <= 1.5 * before), message);
      row.conclude(diagnostics);
    }
  }
}

}  // namespace

void lint(const Table& table, text::Diagnostics& diagnostics) {
  lint_missing(table, diagnostics);
  Waivers waivers(table, diagnostics);
  const Plausibility plausibility(table);
  const Twins twins(table);
  for (int row = 0; row < table.rows(); ++row) {
    const LintRow each(table, row, waivers);
    each.magnitudes();
    lint_drive(table.family(), each);
    lint_structure(table.family(), each);
    lint_designation(table.family(), each);
    twins.examine(row, each);
    each.conclude(plausibility, diagnostics);
  }
  if (table.family() == Family::stepper_curves) lint_curves(table, waivers, diagnostics);
  waivers.report_unneeded(diagnostics);
}

namespace {

/// The parts of all places, without what is said of stock and offers. What is wrong with them is told elsewhere.
Catalogue parts_of(const std::vector<std::filesystem::path>& beside, const std::vector<std::filesystem::path>& places) {
  text::Diagnostics told;
  std::vector<std::filesystem::path> files;
  for (const auto& each : {beside, places}) {
    for (const std::filesystem::path& place : each) {
      const bool overlay = is_stock_file(place) || is_supplier_file(place);
      for (const CatalogueFile& file : catalogue_files(overlay ? folder_of(place) : place, told))
        files.emplace_back(file.text->path());
    }
  }
  return Catalogue::load(files, told);
}

}  // namespace

LintSummary lint_files(const std::vector<std::filesystem::path>& places,
                       std::optional<Family> family,
                       text::Diagnostics& diagnostics,
                       const std::vector<std::filesystem::path>& beside) {
  LintSummary summary;
  const std::size_t errors = diagnostics.error_count();
  const std::size_t warnings = diagnostics.warning_count();
  std::map<Family, Table> tables;
  for (const std::filesystem::path& place : places) {
    std::vector<CatalogueFile> files;
    const std::size_t errors_before = diagnostics.error_count();
    std::error_code ignored;
    if (family && !std::filesystem::is_directory(place, ignored) && !is_stock_file(place) && !is_supplier_file(place)) {
      if (auto file = catalogue_file(place, family, diagnostics)) files.push_back(std::move(*file));
    } else {
      files = catalogue_files(place, diagnostics);
    }
    if (files.empty() && overlay_files({place}).empty() && diagnostics.error_count() == errors_before)
      report_no_files(place, diagnostics);
    for (const CatalogueFile& file : files) {
      ++summary.files;
      tables.try_emplace(file.family, file.family)
          .first->second.append(read_table(file.text, file.family, 0, diagnostics));
    }
  }
  for (auto& [each, table] : tables) {
    drop_duplicates(table, diagnostics);
    summary.rows += table.rows();
    lint(table, diagnostics);
  }
  if (const std::vector<std::filesystem::path> said = overlay_files(places); !said.empty()) {
    summary.files += static_cast<int>(said.size());
    lint_overlay(said, parts_of(beside, places), diagnostics);
  }
  summary.errors = diagnostics.error_count() - errors;
  summary.warnings = diagnostics.warning_count() - warnings;
  return summary;
}

}  // namespace millwright::catalogue
