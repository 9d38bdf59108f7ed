// SPDX-License-Identifier: Apache-2.0
#include "catalogue/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "catalogue/file_names.h"
#include "catalogue/stock.h"
#include "catalogue/suppliers.h"
#include "text/csv_reader.h"
#include "text/nearest.h"
#include "text/table_size.h"

namespace millwright::catalogue {
namespace {

namespace fs = std::filesystem;

std::vector<std::string_view> family_names() {
  std::vector<std::string_view> names;
  for (const FamilyDeclaration& each : families) names.push_back(each.name);
  return names;
}

std::string all_family_names() {
  std::string names;
  for (const FamilyDeclaration& each : families) names += (names.empty() ? "" : ", ") + std::string(each.name);
  return names;
}

std::optional<Family> family_by_path(const fs::path& file) {
  std::error_code ignored;
  const fs::path full = fs::absolute(file, ignored);
  if (const auto by_folder = find_family(full.parent_path().filename().string())) return by_folder;
  return find_family(full.stem().string());
}

/// The one family that has all columns of the header and whose required columns are all there.
std::optional<Family> family_by_header(const std::shared_ptr<const text::SourceText>& text) {
  text::Diagnostics unused;
  const text::CsvTable csv = text::CsvReader(text, unused, 1).take();  // its header is enough
  std::optional<Family> only;
  for (const FamilyDeclaration& each : families) {
    const bool all_known = std::all_of(csv.columns().begin(), csv.columns().end(), [&](const text::CsvColumn& cell) {
      return find_column(each.family, cell.name).has_value() || is_own_column(cell.name);
    });
    const bool all_there =
        std::all_of(each.columns.begin(), each.columns.end(), [&](const ColumnDeclaration& declared) {
          return declared.need != Need::required || csv.find_column(declared.name).has_value();
        });
    if (!all_known || !all_there || csv.columns().empty()) continue;
    if (only) return std::nullopt;
    only = each.family;
  }
  return only;
}

/// The visible entries of a folder by name, so that nothing depends on the order on the disk.
std::vector<fs::path> entries(const fs::path& folder, text::Diagnostics& diagnostics) {
  std::vector<fs::path> found;
  std::error_code problem;
  for (fs::directory_iterator each(folder, problem), end; !problem && each != end; each.increment(problem)) {
    if (!each->path().filename().string().starts_with('.')) found.push_back(each->path());
  }
  if (problem)
    diagnostics.error(
        fmt::format("cannot read folder {}: {}", text::in_quotes(folder.string(), 200), problem.message()));
  std::sort(found.begin(), found.end());
  return found;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

void add_file(const fs::path& file,
              std::optional<Family> family,
              std::vector<CatalogueFile>& files,
              text::Diagnostics& diagnostics) {
  if (auto loaded = catalogue_file(file, family, diagnostics)) files.push_back(std::move(*loaded));
}

void add_family_folder(const fs::path& folder,
                       Family family,
                       std::vector<CatalogueFile>& files,
                       text::Diagnostics& diagnostics) {
  for (const fs::path& entry : entries(folder, diagnostics)) {
    if (is_csv_name(entry)) add_file(entry, family, files, diagnostics);
  }
}

}  // namespace

void report_no_files(const fs::path& place, text::Diagnostics& diagnostics) {
  diagnostics.error(
      fmt::format("the catalogue {} is empty: it holds no CSV file", text::in_quotes(place.string(), 200)),
      "a catalogue has a folder for each part family, for example steppers/my-motors.csv");
}

std::optional<CatalogueFile> catalogue_file(const fs::path& file,
                                            std::optional<Family> family,
                                            text::Diagnostics& diagnostics) {
  auto text = text::SourceText::load(file.string(), diagnostics, text::table_size_limit);
  if (!text) return std::nullopt;
  if (!family) family = family_by_path(file);
  if (!family) family = family_by_header(text);
  if (!family) {
    const std::string stem = file.stem().string();
    diagnostics.error(
        text::whole(text),
        "cannot tell which part family this file belongs to",
        text::did_you_mean(stem, family_names(), "put it into a folder named as one of " + all_family_names()));
    return std::nullopt;
  }
  return CatalogueFile{std::move(text), *family};
}

std::vector<CatalogueFile> catalogue_files(const fs::path& place, text::Diagnostics& diagnostics) {
  std::vector<CatalogueFile> files;
  if (is_stock_file(place) || is_supplier_file(place)) return files;
  if (!is_folder(place)) {
    add_file(place, std::nullopt, files, diagnostics);
    return files;
  }
  std::error_code ignored;
  const fs::path full = fs::canonical(place, ignored);
  if (const auto family = find_family(full.filename().string())) {
    add_family_folder(place, *family, files, diagnostics);
    return files;
  }
  for (const fs::path& entry : entries(place, diagnostics)) {
    const std::string name = entry.filename().string();
    if (!is_folder(entry)) {
      if (is_csv_name(entry) && !is_stock_file(entry) && !is_supplier_file(entry))
        add_file(entry, std::nullopt, files, diagnostics);
      continue;
    }
    if (const auto family = find_family(name)) {
      add_family_folder(entry, *family, files, diagnostics);
    } else {
      text::Diagnostic unknown;
      unknown.severity = text::Severity::warning;
      unknown.message =
          fmt::format("folder {} is not a part family and is ignored", text::in_quotes(entry.string(), 200));
      unknown.hint = text::did_you_mean(name, family_names());
      diagnostics.add(std::move(unknown));
    }
  }
  return files;
}

}  // namespace millwright::catalogue
