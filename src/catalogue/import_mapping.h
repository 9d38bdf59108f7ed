// SPDX-License-Identifier: Apache-2.0
// Which column of somebody's table is which of ours, in what unit, and how sure that is. Proposed from header words,
// units and figures; confirmed by a person, or read from a mapping file (import_mapping_file.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalogue/companions.h"
#include "catalogue/family.h"
#include "catalogue/import_number.h"
#include "catalogue/import_sheet.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

/// Where the unit of the figures of a column without a unit of their own comes from. `assumed`: nothing says it.
enum class UnitOrigin { none, header, units_row, cells, given, assumed };

/// What an import knows of one of our columns from the command line or a mapping file.
struct GivenColumn {
  Column target{};
  std::string from;                 ///< header, as it is written; empty: only the unit is given
  int occurrence = 1;               ///< of columns of that header the first, second, ...
  std::optional<std::string> unit;  ///< of figures without a unit of their own
  DecimalMark mark = DecimalMark::unknown;
  text::SourceSpan where;  ///< where that is said
};

/// What a column says of the figure of another one.
struct ImportCompanion {
  Column figure{};
  CompanionKind kind = CompanionKind::source;
};

/// What a mapping file knows of such a column.
struct GivenCompanion {
  ImportCompanion companion;
  std::string from;
  int occurrence = 1;
  std::optional<std::string> unit;  ///< of tolerances, as our header takes it
  text::SourceSpan where;
};

/// What a person says about a table; all of it may be empty.
struct ImportChoices {
  Family family = Family::steppers;
  std::vector<GivenColumn> columns;
  std::vector<GivenCompanion> companions;
  std::vector<std::pair<Column, std::string>> constants;  ///< of columns that the table does not have
  DecimalMark mark = DecimalMark::unknown;                ///< of all columns
  bool complete = false;  ///< a mapping file: columns it does not name are kept as they are, not guessed
};

/// A column of the table.
struct SourceColumn {
  std::string header;  ///< as written; empty if it has none
  int occurrence = 1;
  text::SourceSpan span;
  std::optional<Column> target;  ///< none: a companion, or kept under `kept_name`
  std::optional<ImportCompanion> companion;
  std::string kept_name;    ///< x_...; of a companion its name
  double confidence = 1.0;  ///< 0 to 1
  std::vector<std::string> reasons;

  // Of numbers and prices, and of tolerances the unit:
  std::string unit;      ///< of figures without a unit of their own, as our header takes it
  std::string currency;  ///< of a price, if header or units row say it; "?" for $
  UnitOrigin unit_origin = UnitOrigin::none;
  DecimalMark mark = DecimalMark::unknown;
  std::vector<std::string> cell_units;  ///< that stand in the cells, as written
  bool has_bare_figures = false;        ///< without a unit of their own
  bool converts = false;                ///< to our unit, because the cells have several
};

/// The table as it will be read.
struct ImportMapping {
  Family family = Family::steppers;
  std::vector<SourceColumn> columns;
  std::vector<std::pair<Column, std::string>> constants;
  std::vector<std::string> titles;  ///< lines above the header
  text::SourceSpan header;
  std::size_t data_begin = 0;  ///< byte where the first row of parts begins
  std::size_t rows = 0;
  std::vector<std::string> remarks;  ///< what was found out, for people
  std::vector<std::string> missing;  ///< columns of ours that a table must have, or should
};

/// Finds the header and proposes a mapping. Reports what cannot be settled: no header, a column that a mapping file
/// names and the table lacks, a required column from nowhere, decimal marks that contradict each other or stay
/// ambiguous, a unit that does not fit. Nothing if there is no header.
std::optional<ImportMapping> propose_mapping(const ImportSheet& sheet,
                                             const ImportChoices& choices,
                                             text::Diagnostics& diagnostics);

/// Columns whose unit nothing says.
std::vector<const SourceColumn*> assumed_units(const ImportMapping& mapping);

/// What headers or cells of other rows say that prices are in, of a row of which no price is known: it has a currency
/// though that prices nothing. Empty if nothing says it, and where a price stands in the row: a bare figure has none.
std::string currency_without_price(const SheetRows& row, const ImportMapping& mapping);

/// The column of the table that by its name holds what a constant states for all rows; it is kept as x_NAME.
std::optional<std::size_t> column_beside_constant(const ImportMapping& mapping, Column target);

inline bool is_number_column(Column column) {
  return declaration(column).kind == Kind::number || declaration(column).kind == Kind::money;
}

/// Whether figures of the column mean nothing without a unit (or a currency).
inline bool wants_unit(Column column) {
  return declaration(column).kind == Kind::money ||
         (declaration(column).kind == Kind::number && declaration(column).unit != "1");
}

/// Adds where the rows come from, and reports what is missing. See propose_mapping().
void complete_mapping(const ImportSheet& sheet,
                      const ImportChoices& choices,
                      ImportMapping& mapping,
                      text::Diagnostics& diagnostics);

/// Looks through all rows: decimal marks, units in the cells. See propose_mapping().
void survey_columns(const ImportSheet& sheet,
                    const ImportChoices& choices,
                    ImportMapping& mapping,
                    text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
