// SPDX-License-Identifier: Apache-2.0
//
// Catalogues many times as long as those shipped: every row with seeded copies of which prices, masses, torques,
// stiffnesses and the like differ by some percent, while everything that decides what fits what stays.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "text/csv.h"

namespace growth {

/// Families that are norms and not wares: they stay as they are.
inline bool is_norm(const std::string& family) {
  static const std::set<std::string> norms{"materials", "threads"};
  return norms.count(family) > 0;
}

/// Whether copies of a row differ in this column (its name without unit).
inline bool may_differ(std::string_view column) {
  for (const char* part : {"mass", "torque", "inertia", "rating", "stiffness", "inductance", "resistance"})
    if (column.find(part) != std::string_view::npos) return column != "tightening_torque";
  return column.rfind("price", 0) == 0;
}

inline std::string in_quotes(std::string_view cell) {
  if (cell.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(cell);
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

inline std::string differing(std::string_view cell, std::mt19937_64& random) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return in_quotes(cell);
  constexpr double spread = 0.08;
  const double share = static_cast<double>(random() >> 11U) * 0x1p-53;
  return fmt::format("{:.6g}", value * std::exp(spread * (2.0 * share - 1.0)));
}

/// Writes one catalogue file, `times` as long; returns its rows. Throws std::runtime_error if it cannot be read.
inline std::size_t multiply_file(const std::filesystem::path& from,
                                 const std::filesystem::path& to,
                                 int times,
                                 std::mt19937_64& random) {
  using namespace millwright::text;
  Diagnostics diagnostics;
  const auto source = SourceText::load(from.string(), diagnostics);
  if (source == nullptr) throw std::runtime_error(format(diagnostics));
  const CsvTable table = read_csv(source, diagnostics);
  if (diagnostics.error_count() > 0) throw std::runtime_error(format(diagnostics));
  std::vector<std::string> names;
  std::vector<bool> differs;
  std::vector<std::vector<std::string_view>> columns;
  std::ofstream out(to);
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const CsvColumn& column = table.columns()[i];
    names.push_back(column.name);
    differs.push_back(may_differ(names.back()));
    const auto cells = table.text_column(i);
    columns.emplace_back(cells.begin(), cells.end());
    out << (i > 0 ? "," : "") << in_quotes(column.unit ? column.name + " [" + *column.unit + "]" : column.name);
  }
  out << "\n";
  for (int copy = 0; copy < times; ++copy)
    for (std::size_t row = 0; row < table.row_count(); ++row) {
      for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string_view cell = columns[i][row];
        out << (i > 0 ? "," : "");
        if (copy > 0 && names[i] == "part_number")
          out << in_quotes(std::string(cell) + "~" + std::to_string(copy));
        else
          out << (copy > 0 && differs[i] ? differing(cell, random) : in_quotes(cell));
      }
      out << "\n";
    }
  return table.row_count() * static_cast<std::size_t>(times);
}

/// All catalogues of a folder into another; returns the rows written.
inline std::size_t multiply_catalogues(const std::filesystem::path& from, const std::filesystem::path& to, int times) {
  std::mt19937_64 random(7);
  std::size_t rows = 0;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(from))
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const auto family = file.parent_path().filename();
    std::filesystem::create_directories(to / family);
    rows += multiply_file(file, to / family / file.filename(), is_norm(family.string()) ? 1 : times, random);
  }
  return rows;
}

}  // namespace growth
