// SPDX-License-Identifier: Apache-2.0
// The cells of one row of ours, made from a row of somebody's table.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/import_mapping.h"
#include "catalogue/import_unit.h"

namespace millwright::catalogue {

/// Appends a cell of a CSV file, quoted where it has to be.
void append_csv_cell(std::string& line, std::string_view text);

/// A column of the file that is written.
struct ImportField {
  enum class Kind {
    constant,
    text,
    frame,
    number,
    money,
    flag,
    confidence,
    currency,
    tolerance,
    kept
  } kind = Kind::text;
  std::string header;                 ///< "holding_torque [N.cm]"
  std::optional<std::size_t> source;  ///< column of the table
  std::string constant;
  std::string out_unit;
};

class ImportFields {
 public:
  ImportFields(const ImportMapping& mapping, text::Diagnostics& diagnostics);

  const std::vector<ImportField>& fields() const { return fields_; }
  std::string header_line() const;
  /// Appends the row as a line; false, and nothing appended, if something in it is wrong, which is reported.
  bool append(const SheetRows& row, std::string& lines);

 private:
  struct KnownUnit {
    std::string words;
    std::optional<ShopUnit> unit;
    std::string reason;
  };
  void add(Column target);
  void append_number(const SheetRows& row, const ImportField& field, std::string& line);
  void append_tolerance(const SheetRows& row, const ImportField& field, std::string& line);
  void append_flag(const SheetRows& row, const ImportField& field, std::string& line);
  void append_confidence(const SheetRows& row, const ImportField& field, std::string& line);
  void append_frame(std::string_view cell, std::string& line);
  std::string read_plain(const SheetRows& row, std::size_t source, std::string_view number, DecimalMark mark);
  bool take_own_unit(const SheetRows& row, std::size_t source, scalar::Unit& meaning);
  void take_currency(const SheetRows& row, const ImportField& field, const std::string& currency);
  std::string currency_of_row(const SheetRows& row, const ImportField& field);
  const KnownUnit& unit_of(const std::string& words, std::size_t source);
  void refuse(const SheetRows& row, std::size_t source, const std::string& message, const std::string& hint = {});

  const ImportMapping& mapping_;
  text::Diagnostics& diagnostics_;
  std::vector<ImportField> fields_;
  std::vector<std::vector<KnownUnit>> units_;  ///< of each source column
  std::string row_currency_;
  bool row_is_good_ = true;
};

}  // namespace millwright::catalogue
