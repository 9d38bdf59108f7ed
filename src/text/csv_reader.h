// SPDX-License-Identifier: Apache-2.0
// Reads a CSV text some rows at a time: where the cells of a million rows begin takes as much memory as the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text/csv.h"
#include "text/csv_scanner.h"

namespace millwright::text {

/// Checks the text, reads the header, gathers the records and reports those that do not fit it, each at its place.
class CsvReader {
 public:
  /// As many rows as stay in a processor's cache with their text.
  static constexpr std::size_t few = 4096;

  /// Reads the header and the first rows, all of them by default.
  CsvReader(std::shared_ptr<const SourceText> text,
            Diagnostics& diagnostics,
            std::size_t rows_at_a_time = std::numeric_limits<std::size_t>::max());

  /// The header and the rows that were read last. No columns: there is no (good) header.
  const CsvTable& table() const { return table_; }
  CsvTable take() { return std::move(table_); }

  /// Reads the next rows; false if there are no more.
  bool next();

  /// The whole text has no more rows than that.
  std::size_t most_rows() const;

 private:
  void error(SourceSpan where, std::string message, std::string hint = {});
  bool read_head();
  void check_line_ends(std::string_view contents);
  std::string_view slice(const std::vector<std::uint32_t>& starts, std::size_t cell) const;
  bool read_header(std::size_t begin);
  CsvColumn header_cell(std::size_t column);
  void check_names();
  void read_rows();
  void check_comment(std::size_t mark);
  void reserve(std::size_t begin);
  bool accept(std::size_t first, std::size_t cells);
  void report_length(std::size_t first, std::size_t cells);

  Diagnostics& diagnostics_;
  std::size_t rows_at_a_time_;
  CsvTable table_;
  std::optional<CsvScanner> scanner_;  ///< none: nothing more is to be read
  std::size_t rows_begin_ = 0;         ///< byte behind the header
  std::size_t cells_before_ = 0;       ///< in the rows that are gone
};

}  // namespace millwright::text
