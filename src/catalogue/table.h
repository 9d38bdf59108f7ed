// SPDX-License-Identifier: Apache-2.0
// One family's parts as columns of numbers in SI and texts; every cell knows the file and place it was read from.
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "catalogue/family.h"
#include "catalogue/part_index.h"
#include "catalogue/piece_price.h"
#include "catalogue/standing.h"
#include "catalogue/worked_out.h"
#include "scalar/interval.h"
#include "text/source_text.h"

namespace millwright::catalogue {

/// A figure that a row does not give.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// What a row costs, in its own currency (conversion needs the problem file's rates). NaN: not sold that way, or not
/// known.
struct Price {
  double piece = std::numeric_limits<double>::quiet_NaN();   ///< per piece
  double length = std::numeric_limits<double>::quiet_NaN();  ///< per metre
  double mass = std::numeric_limits<double>::quiet_NaN();    ///< per kilogram
  std::string_view currency;
};

/// The rows that answer to a part number, or why there is none.
struct Found {
  enum class Problem { none, unknown, other_maker, ambiguous };
  std::vector<int> rows;  ///< one row; all points of a torque curve
  Problem problem = Problem::none;
  std::string error;
  std::string hint;
  explicit operator bool() const { return problem == Problem::none; }
};

enum class CompanionKind;  // companions.h

/// Where in a file's records stands what is said of one figure.
struct CompanionField {
  std::uint8_t figure;  ///< Column.index
  CompanionKind kind;
  int field;
};

/// A file that rows come from.
struct SourceFile {
  std::shared_ptr<const text::SourceText> text;
  int layer = 0;  ///< 0 = the first folder given to Catalogue::load (the shipped one), 1 = its first overlay, ...
  char separator = ',';
  std::vector<int>
      field_of_column;  ///< for each Column.index the field of a record it stands in, -1 = not in this file
  std::vector<CompanionField> companions;
  std::shared_ptr<const std::deque<std::string>>
      unescaped;  ///< texts that are not verbatim in the file (doubled quotes)
};

/// Where a text stands: bytes of SourceFile::text, or an element of SourceFile::unescaped. A text of no length is not
/// given. A view would be twice as long, and texts are half of a catalogue.
struct TextCell {
  std::uint32_t begin = 0;  ///< byte, or index of the unescaped text
  std::uint32_t length = 0;
  static constexpr std::uint32_t unescaped = std::numeric_limits<std::uint32_t>::max();  ///< as the length
};

/// Empty = not given.
std::string_view content_of(TextCell cell, const SourceFile& file);

/// What a seller of a length asks beside its price: the columns stock_length, cutting_loss, cut_price and
/// end_machining_price. NaN = nothing.
struct CuttingTerms {
  double stock_length = std::numeric_limits<double>::quiet_NaN();  ///< m
  double cutting_loss = std::numeric_limits<double>::quiet_NaN();  ///< m
  double cut_price = std::numeric_limits<double>::quiet_NaN();
  double end_machining_price = std::numeric_limits<double>::quiet_NaN();
};

/// A row once more, as somebody else sells the part.
struct OfferedRow {
  int row = 0;
  double price = 0.0, price_per_length = 0.0, pack_size = 0.0;  ///< NaN = none
  std::string supplier, currency, price_basis, price_breaks;
  bool owned_pieces = false;  ///< it stands for the pieces that are owned and no others
  CuttingTerms cutting = {};
};

/// Which pieces of a part that are owned a row of it stands for.
enum class Ownership : std::uint8_t {
  usual,  ///< first those that are owned, then bought ones
  none,   ///< bought ones
  only    ///< only those that are owned
};

/// What a reader hands over: one vector a column (by Column.index; empty = column not given), all of the same length. A
/// single text is that of all rows.
struct TableColumns {
  std::vector<std::vector<double>> numbers;  ///< SI; flags 1 and 0; NaN = not known
  std::vector<std::vector<TextCell>> texts;
  /// What companions say of single figures, by the figure's Column.index; empty = there is no such companion.
  std::vector<std::vector<double>> tolerances;  ///< half widths, SI; NaN = not stated
  std::vector<std::vector<TextCell>> sources, confidences;
  std::vector<std::uint32_t> offsets;  ///< byte where each record begins
  SourceFile file;
};

class Table {
 public:
  explicit Table(Family family);
  /// Takes over the columns of one file.
  Table(Family family, TableColumns columns);

  Family family() const { return family_; }
  int rows() const { return static_cast<int>(offsets_.size()); }
  bool empty() const { return offsets_.empty(); }

  /// A number, flag (1, 0) or money column, SI, one value a row; NaN = not known. Throws std::logic_error for a column
  /// of another family or of texts.
  std::span<const double> numbers(Column column) const;
  double number(Column column, int row) const { return numbers(column)[static_cast<std::size_t>(row)]; }
  std::optional<bool> flag(Column column, int row) const;
  /// A text; empty = not given.
  std::string_view text(Column column, int row) const;
  /// The same by name, for tests and listings; throws std::logic_error on an unknown name.
  double number(std::string_view name, int row) const { return number(column(family_, name), row); }
  std::string_view text(std::string_view name, int row) const { return text(column(family_, name), row); }

  std::string_view manufacturer(int row) const;
  std::string_view part_number(int row) const;
  std::string_view confidence(int row) const;
  Price price(int row) const;
  /// is_estimate() of the price.
  bool is_price_estimate(int row) const;
  /// Of what is sold by the piece: with price breaks and packs.
  PiecePrice piece_price(int row) const;

  /// What is said about where the figure comes from: its own companion `_source`, else its basis column; empty if
  /// nothing is.
  std::string_view basis(int row, Column column) const;
  /// The same as a standing.
  Standing standing(int row, Column column) const;
  /// Whether the figure must be shown as an estimate, see counts_as_estimate(). False for texts.
  bool is_estimate(int row, Column column) const;
  /// Stated relative tolerance of the figure, by its own companion or else in its basis; NaN if none.
  double tolerance(int row, Column column) const;
  /// The same as half its width [SI]; NaN too where the figure is not known, or cannot be off (takes_tolerance()).
  double half_width(int row, Column column) const;
  /// Whether any figure can be off.
  bool has_tolerances() const;
  /// What is said of the figure alone, by its companions; empty where nothing is.
  std::string_view figure_source(int row, Column column) const;
  std::string_view figure_confidence(int row, Column column) const;

  /// Takes another number [SI] for a figure: what if. Rows keep their places.
  void set_number(int row, Column column, double value);
  /// Lets a figure be anywhere in an interval: bounds of what is made of it have to hold for all of it, while number()
  /// stays what it is. Forgotten when rows are dropped or added.
  void set_range(int row, Column column, const scalar::Interval& range);
  /// The interval of a figure: itself where none was set.
  scalar::Interval range(Column column, int row) const;
  bool has_ranges() const { return !ranges_.empty(); }

  /// The place of the row (its part number) or of one cell; of the whole row if the file has no such column.
  text::SourceSpan where(int row) const;
  text::SourceSpan where(int row, Column column) const;
  /// The place of what is said of a figure alone; of the figure if the file has no such column.
  text::SourceSpan where(int row, Column column, CompanionKind kind) const;
  /// The files that rows come from, with their layers; for file hashes and lists.
  const std::vector<SourceFile>& files() const { return files_; }
  /// The index in files() of the row's file.
  std::size_t file(int row) const { return file_of_[static_cast<std::size_t>(row)]; }
  /// The number of the folder that the row comes from, in the order given to Catalogue::load.
  int layer(int row) const { return files_[file_of_[static_cast<std::size_t>(row)]].layer; }

  /// The rows of a part: exact (manufacturer, part number), or the part number alone if only one maker has it; else by
  /// an alias (materials). On failure the error names the makers, or the nearest part number.
  Found find(std::string_view part_number, std::string_view manufacturer = {}) const;

  /// All rows by manufacturer and part number (bytes, not numbers: "M10" is before "M4"), and those of the same name by
  /// their other cells, column by column; what is not known comes last. Rows that agree in all of that keep their
  /// order. Where parts are equally good, which one is named must not hang on where it stands in a file, or in which
  /// file. Lives until the table changes.
  std::span<const int> rows_in_order() const;

  /// Whether two rows (of this and another table) agree in all columns of that identity or above it.
  bool same_part(int row, const Table& other, int other_row, Identity level) const;
  std::uint64_t part_hash(int row, Identity level) const;

  [[nodiscard]] Ownership ownership(int row) const {
    return ownership_.empty() ? Ownership::usual : ownership_[static_cast<std::size_t>(row)];
  }
  /// Appends rows once more with other prices (table_offers.cpp). Of a row with owned pieces only those are taken; the
  /// row that it repeats goes on to stand for owned pieces first.
  void append_offers(const std::vector<OfferedRow>& offers);

  /// A table of these rows, ascending, and no others.
  Table only(std::span<const int> rows) const;
  /// Drops the rows with keep[row] == false.
  void keep_only(const std::vector<bool>& keep);
  /// Appends the rows of another file of the same layer; duplicates are the caller's business.
  void append(Table&& other);
  /// An overlay: rows of `upper` replace those of the same part (group identity), others are added.
  void overlay(Table&& upper);

 private:
  void check(Column column, bool wants_text) const;
  /// Rows or figures changed: what has been worked out of them is of no use any more.
  void forget();
  /// Gives each row a text of its own where one is that of all, for rows to be added.
  void spread_texts();
  void note_absent_columns();
  /// Gives a column that no file has its own numbers, none of them known: some will be set.
  void make_column(std::size_t index);
  std::vector<int> rows_of(std::string_view part_number) const;
  std::vector<int> rows_by_alias(std::string_view name) const;
  std::string_view content(const std::vector<TextCell>& cells, int row) const;
  text::SourceSpan place_of_field(int row, int field) const;

  struct Range {
    int row = 0;
    std::uint8_t column = 0;
    scalar::Interval values;
  };
  Family family_;
  std::vector<std::vector<double>> numbers_;  // empty: no file has the column
  std::vector<double> absent_;                // what such a column answers
  std::vector<std::vector<TextCell>> texts_;  // a single one is that of all rows
  void repeat_companions(std::size_t row);
  void set_cutting_terms(const CuttingTerms& terms);

  std::vector<std::vector<double>> tolerances_;
  std::vector<std::vector<TextCell>> figure_sources_, figure_confidences_;
  std::vector<Range> ranges_;
  std::vector<std::uint32_t> offsets_;
  std::vector<std::uint32_t> file_of_;
  std::vector<SourceFile> files_;
  std::vector<Ownership> ownership_;  // empty: usual of all
  PartIndex parts_;                   // by part number alone
  WorkedOut<std::vector<int>> order_;
};

}  // namespace millwright::catalogue
