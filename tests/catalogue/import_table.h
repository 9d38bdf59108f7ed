// SPDX-License-Identifier: Apache-2.0
// A table on its way through an import, as a test sees it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "catalogue/import_mapping_file.h"
#include "catalogue/import_write.h"
#include "catalogue/read_table.h"
#include "catalogue/temporary_folder.h"

namespace millwright::catalogue {

struct Imported {
  std::optional<ImportMapping> mapping;
  std::string text;
  std::string complaints;
  ImportSummary summary;
  bool good = false;

  /// The file that was written, read back.
  Table table(Family family) const {
    text::Diagnostics diagnostics;
    Table read = read_table(text::SourceText::from_string("written.csv", text), family, 0, diagnostics);
    if (diagnostics.has_errors()) throw std::runtime_error(text::format(diagnostics));
    return read;
  }
  const SourceColumn& column(const std::string& header) const {
    for (const SourceColumn& each : mapping->columns)
      if (each.header == header) return each;
    throw std::runtime_error("no column " + header);
  }
  /// The name of our column, or the one it is kept under.
  std::string meaning(const std::string& header) const {
    const SourceColumn& found = column(header);
    return found.target ? std::string(declaration(*found.target).name) : found.kept_name;
  }
  bool says(const std::string& words) const { return complaints.find(words) != std::string::npos; }
};

inline Imported import_request(const std::string& path, ImportRequest request) {
  Imported result;
  text::Diagnostics diagnostics;
  request.choices.family = *request.family;
  if (const auto sheet = load_sheet(path, request.format, diagnostics)) {
    result.mapping = propose_mapping(*sheet, request.choices, diagnostics);
    if (result.mapping)
      result.summary = write_import(
          *sheet,
          *result.mapping,
          [&](std::string_view lines) {
            result.text += lines;
            return true;
          },
          diagnostics);
  }
  result.good = !diagnostics.has_errors();
  result.complaints = text::format(diagnostics);
  return result;
}

/// Steppers, unless another family is said; `said` are constants and units, `unit:` before the latter.
inline ImportRequest asking(const std::vector<std::pair<std::string, std::string>>& said = {},
                            Family family = Family::steppers) {
  ImportRequest request;
  request.family = family;
  text::Diagnostics diagnostics;
  for (const auto& [name, value] : said) {
    if (name.starts_with("unit:"))
      add_unit(request, name.substr(5), value, {}, diagnostics);
    else
      add_constant(request, name, value, {}, diagnostics);
  }
  if (diagnostics.has_errors()) throw std::runtime_error(text::format(diagnostics));
  return request;
}

inline Imported import_csv(const std::string& contents, const ImportRequest& request = asking()) {
  const TemporaryFolder folder;
  return import_request(folder.write("table.csv", contents).string(), request);
}

}  // namespace millwright::catalogue
