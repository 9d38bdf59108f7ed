// SPDX-License-Identifier: Apache-2.0
// Where the cells of CSV records begin and end. Most bytes of a table are plain; they are skipped 64 at a time, and
// only separators, line ends and quotes are looked at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "text/diagnostic.h"
#include "text/source_text.h"

namespace millwright::text {

class CsvScanner {
 public:
  /// Reads records from `begin` on. The text must be smaller than 4 GiB. A record of more cells than `cell_limit` is
  /// reported and skipped, so that a line of nothing but separators costs no memory.
  CsvScanner(std::shared_ptr<const SourceText> text,
             char separator,
             std::size_t begin,
             Diagnostics& diagnostics,
             std::size_t cell_limit = std::numeric_limits<std::uint32_t>::max());

  bool at_end() const { return position_ >= bytes_.size(); }
  std::size_t position() const { return position_; }

  /// Appends to `starts` where each cell of the next record begins, and one past the character that ends the last one.
  /// A record with bad quotes or too many cells is reported, skipped and gives false; `starts` then holds a part of it.
  bool next(std::vector<std::uint32_t>& starts);

  /// Goes on with the next line, whatever the rest of this one holds.
  void skip_line() { give_up_line(position_); }

  /// Content of cells with doubled quotes, by where the cell begins.
  std::unordered_map<std::uint32_t, std::string>& unescaped() { return unescaped_; }
  const std::unordered_map<std::uint32_t, std::string>& unescaped() const { return unescaped_; }

 private:
  std::uint64_t mask_at(std::size_t offset) const;
  std::size_t next_special();
  std::size_t next_quote();
  void seek(std::size_t offset);
  bool quoted_cell(std::size_t cell_begin, std::size_t quote);
  bool check_after_quote(std::size_t opening, std::size_t closing);
  void unescape(std::size_t cell_begin, std::size_t opening, std::size_t closing);
  bool give_up_line(std::size_t offset);
  bool too_many_cells(std::size_t record);

  std::shared_ptr<const SourceText> text_;
  std::string_view bytes_;
  Diagnostics& diagnostics_;
  char separator_;
  std::size_t cell_limit_;
  std::size_t position_;
  std::size_t block_ = 0;
  std::uint64_t mask_ = 0;
  int unclosed_ = 0;
  std::unordered_map<std::uint32_t, std::string> unescaped_;
};

}  // namespace millwright::text
