// SPDX-License-Identifier: Apache-2.0
#include "catalogue/table.h"

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>

#include "text/large_pages.h"

namespace millwright::catalogue {
namespace {

constexpr std::uint8_t manufacturer_index = column(Family::steppers, "manufacturer").index;
constexpr std::uint8_t part_number_index = column(Family::steppers, "part_number").index;
constexpr std::uint8_t confidence_index = column(Family::steppers, "confidence").index;

bool is_text(const ColumnDeclaration& declared) { return declared.kind == Kind::text; }

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  hash ^= value + 0x9e3779b97f4a7c15ULL + (hash << 6U) + (hash >> 2U);
  hash *= 0xff51afd7ed558ccdULL;
  return hash ^ (hash >> 33U);
}

std::uint64_t hash_of(std::string_view text) { return mix(0, std::hash<std::string_view>()(text)); }

/// The columns that say which row this is.
std::vector<Column> identity_columns(Family family, Identity level) {
  std::vector<Column> columns;
  for (std::size_t index = 0; index < column_count(family); ++index) {
    const Column each{family, static_cast<std::uint8_t>(index)};
    const Identity identity = declaration(each).identity;
    if (identity == Identity::group || (level == Identity::point && identity == Identity::point))
      columns.push_back(each);
  }
  return columns;
}

/// The same, worked out once: they are looked at for every row that is read.
const std::vector<Column>& identity_columns_of(Family family, Identity level) {
  static const std::array<std::array<std::vector<Column>, 2>, family_count> all = [] {
    std::array<std::array<std::vector<Column>, 2>, family_count> columns;
    for (const FamilyDeclaration& each : families) {
      auto& of_family = columns[static_cast<std::size_t>(each.family)];
      of_family = {identity_columns(each.family, Identity::group), identity_columns(each.family, Identity::point)};
    }
    return columns;
  }();
  return all[static_cast<std::size_t>(family)][level == Identity::point ? 1 : 0];
}

/// Byte range of field `wanted` of the record that begins at `offset`.
std::pair<std::size_t, std::size_t> field_range(std::string_view contents,
                                                std::size_t offset,
                                                int wanted,
                                                char separator) {
  std::size_t begin = offset;
  bool quoted = false;
  std::size_t at = offset;
  for (int field = 0; at < contents.size(); ++at) {
    const char c = contents[at];
    if (c == '"') quoted = !quoted;
    if (quoted || (c != separator && c != '\n' && c != '\r')) continue;
    if (field == wanted || c != separator) break;
    ++field;
    begin = at + 1;
  }
  return {begin, at - begin};
}

/// Appends `from` to `to`, either of which may be empty for "column not given".
template <class T>
void append_column(std::vector<T>& to, std::vector<T>&& from, std::size_t rows, std::size_t more, const T& filler) {
  if (to.empty() && from.empty()) return;
  if (rows == 0) {
    to = std::move(from);
    return;
  }
  if (to.capacity() < rows + more) {
    std::vector<T> both;
    text::reserve_large(both, rows + more);
    both.insert(both.end(), to.begin(), to.end());
    to = std::move(both);
  }
  to.resize(rows, filler);
  to.insert(to.end(), from.begin(), from.end());
  to.resize(rows + more, filler);
}

/// Of these rows; a column that is not given, or a single text of all, stays as it is.
template <class T>
std::vector<T> values_of(std::span<const int> rows, const std::vector<T>& values, bool single_is_of_all = false) {
  if (values.empty() || (single_is_of_all && values.size() == 1)) return values;
  std::vector<T> result;
  result.reserve(rows.size());
  for (const int row : rows) result.push_back(values[static_cast<std::size_t>(row)]);
  return result;
}

}  // namespace

std::string_view content_of(TextCell cell, const SourceFile& file) {
  if (cell.length == 0) return {};
  if (cell.length == TextCell::unescaped) return (*file.unescaped)[cell.begin];
  return file.text->contents().substr(cell.begin, cell.length);
}

Table::Table(Family family)
    : family_(family),
      numbers_(column_count(family)),
      texts_(column_count(family)),
      tolerances_(column_count(family)),
      figure_sources_(column_count(family)),
      figure_confidences_(column_count(family)) {}

Table::Table(Family family, TableColumns columns)
    : family_(family),
      numbers_(std::move(columns.numbers)),
      texts_(std::move(columns.texts)),
      tolerances_(std::move(columns.tolerances)),
      figure_sources_(std::move(columns.sources)),
      figure_confidences_(std::move(columns.confidences)),
      offsets_(std::move(columns.offsets)),
      file_of_(offsets_.size(), 0) {
  numbers_.resize(column_count(family));
  texts_.resize(column_count(family));
  tolerances_.resize(column_count(family));
  figure_sources_.resize(column_count(family));
  figure_confidences_.resize(column_count(family));
  files_.push_back(std::move(columns.file));
  note_absent_columns();
}

void Table::check(Column column, bool wants_text) const {
  const bool shared = column.index < shared_columns;
  if ((!shared && column.family != family_) || is_text(declaration(Column{family_, column.index})) != wants_text) {
    throw std::logic_error("catalogue column '" + std::string(declaration(column).name) + "' asked of a table of " +
                           std::string(declaration(family_).name) + (wants_text ? " as a text" : " as a number"));
  }
}

std::span<const double> Table::numbers(Column column) const {
  check(column, false);
  const std::vector<double>& given = numbers_[column.index];
  return given.empty() ? absent_ : given;
}

std::optional<bool> Table::flag(Column column, int row) const {
  const double value = number(column, row);
  if (std::isnan(value)) return std::nullopt;
  return value != 0.0;
}

std::string_view Table::text(Column column, int row) const {
  check(column, true);
  return content(texts_[column.index], row);
}

std::string_view Table::content(const std::vector<TextCell>& cells, int row) const {
  const auto at = static_cast<std::size_t>(row);
  if (cells.empty()) return {};
  return content_of(cells[cells.size() == 1 ? 0 : at], files_[file_of_[at]]);
}

std::string_view Table::manufacturer(int row) const { return text(Column{family_, manufacturer_index}, row); }
std::string_view Table::part_number(int row) const { return text(Column{family_, part_number_index}, row); }
std::string_view Table::confidence(int row) const { return text(Column{family_, confidence_index}, row); }

Price Table::price(int row) const {
  constexpr std::uint8_t piece = column(Family::steppers, "price").index;
  constexpr std::uint8_t length = column(Family::steppers, "price_per_length").index;
  constexpr std::uint8_t mass = column(Family::steppers, "price_per_mass").index;
  constexpr std::uint8_t currency = column(Family::steppers, "currency").index;
  Price price;
  price.piece = number(Column{family_, piece}, row);
  price.length = number(Column{family_, length}, row);
  price.mass = number(Column{family_, mass}, row);
  price.currency = text(Column{family_, currency}, row);
  return price;
}

bool Table::is_price_estimate(int row) const {
  constexpr std::uint8_t piece = column(Family::steppers, "price").index;
  return is_estimate(row, Column{family_, piece});
}

PiecePrice Table::piece_price(int row) const {
  constexpr std::uint8_t piece = column(Family::steppers, "price").index;
  constexpr std::uint8_t breaks = column(Family::steppers, "price_breaks").index;
  constexpr std::uint8_t pack = column(Family::steppers, "pack_size").index;
  PiecePrice price{number(Column{family_, piece}, row), {}, 1.0};
  if (const std::string_view written = text(Column{family_, breaks}, row); !written.empty())
    price.breaks = parse_price_breaks(written).value_or(std::vector<PriceBreak>());
  if (const double pieces = number(Column{family_, pack}, row); pieces > 1.0) price.pack = pieces;
  return price;
}

text::SourceSpan Table::where(int row) const { return where(row, Column{family_, part_number_index}); }

text::SourceSpan Table::where(int row, Column column) const {
  return place_of_field(row, files_[file_of_[static_cast<std::size_t>(row)]].field_of_column[column.index]);
}

text::SourceSpan Table::place_of_field(int row, int field) const {
  const auto at = static_cast<std::size_t>(row);
  const SourceFile& file = files_[file_of_[at]];
  const auto [begin, bytes] = field_range(file.text->contents(), offsets_[at], field < 0 ? 0 : field, file.separator);
  return text::span_at(file.text, begin, bytes);
}

bool Table::same_part(int row, const Table& other, int other_row, Identity level) const {
  for (const Column each : identity_columns_of(family_, level)) {
    if (is_text(declaration(each)) ? text(each, row) != other.text(each, other_row)
                                   : number(each, row) != other.number(each, other_row)) {
      return false;
    }
  }
  return true;
}

std::uint64_t Table::part_hash(int row, Identity level) const {
  std::uint64_t hash = 0;
  for (const Column each : identity_columns_of(family_, level)) {
    hash = mix(
        hash,
        is_text(declaration(each)) ? hash_of(text(each, row)) : std::bit_cast<std::uint64_t>(number(each, row) + 0.0));
  }
  return hash;
}

Table Table::only(std::span<const int> rows) const {
  Table result(family_);
  for (std::size_t index = 0; index < numbers_.size(); ++index) {
    result.numbers_[index] = values_of(rows, numbers_[index]);
    result.tolerances_[index] = values_of(rows, tolerances_[index]);
    result.texts_[index] = values_of(rows, texts_[index], true);
    result.figure_sources_[index] = values_of(rows, figure_sources_[index], true);
    result.figure_confidences_[index] = values_of(rows, figure_confidences_[index], true);
  }
  result.offsets_ = values_of(rows, offsets_);
  result.file_of_ = values_of(rows, file_of_);
  result.ownership_ = values_of(rows, ownership_);
  result.files_ = files_;
  result.note_absent_columns();
  return result;
}

void Table::keep_only(const std::vector<bool>& keep) {
  std::vector<int> rows;
  for (int row = 0; row < this->rows(); ++row)
    if (keep[static_cast<std::size_t>(row)]) rows.push_back(row);
  *this = only(rows);
}

void Table::spread_texts() {
  for (auto* columns : {&texts_, &figure_sources_, &figure_confidences_})
    for (std::vector<TextCell>& cells : *columns)
      if (cells.size() == 1) cells.assign(offsets_.size(), TextCell(cells.front()));
}

void Table::append(Table&& other) {
  if (files_.empty()) {
    *this = std::move(other);
    return;
  }
  spread_texts();
  other.spread_texts();
  const std::size_t rows = offsets_.size();
  const std::size_t more = other.offsets_.size();
  for (std::size_t index = 0; index < numbers_.size(); ++index) {
    append_column(numbers_[index], std::move(other.numbers_[index]), rows, more, not_known);
    append_column(texts_[index], std::move(other.texts_[index]), rows, more, TextCell());
    append_column(tolerances_[index], std::move(other.tolerances_[index]), rows, more, not_known);
    append_column(figure_sources_[index], std::move(other.figure_sources_[index]), rows, more, TextCell());
    append_column(figure_confidences_[index], std::move(other.figure_confidences_[index]), rows, more, TextCell());
  }
  offsets_.insert(offsets_.end(), other.offsets_.begin(), other.offsets_.end());
  const auto first_file = static_cast<std::uint32_t>(files_.size());
  for (const std::uint32_t file : other.file_of_) file_of_.push_back(first_file + file);
  for (SourceFile& file : other.files_) files_.push_back(std::move(file));
  note_absent_columns();
  ranges_.clear();
  forget();
}

void Table::overlay(Table&& upper) {
  if (empty()) {
    *this = std::move(upper);
    return;
  }
  // The rows below are indexed, which are few (the shipped ones) when those above are many.
  RowIndex groups(offsets_.size());
  std::vector<std::int32_t> first_of_group(offsets_.size());
  for (int row = 0; row < rows(); ++row) {
    const auto same = [&](int there) { return same_part(row, *this, there, Identity::group); };
    const std::int32_t first = groups.insert(part_hash(row, Identity::group), row, same);
    first_of_group[static_cast<std::size_t>(row)] = first == RowIndex::none ? row : first;
  }
  std::vector<bool> replaced(offsets_.size(), false);
  bool any_replaced = false;
  for (int row = 0; row < upper.rows(); ++row) {
    const auto same = [&](int there) { return upper.same_part(row, *this, there, Identity::group); };
    const std::int32_t first = groups.find(upper.part_hash(row, Identity::group), same);
    if (first != RowIndex::none) replaced[static_cast<std::size_t>(first)] = any_replaced = true;
  }
  if (any_replaced) {
    std::vector<bool> keep(offsets_.size());
    for (std::size_t row = 0; row < keep.size(); ++row)
      keep[row] = !replaced[static_cast<std::size_t>(first_of_group[row])];
    keep_only(keep);
  }
  append(std::move(upper));
}

/// They answer NaN without being asked for, all of them with the same ones: a family has many columns, and of a million
/// rows each took as much memory as one that is given.
void Table::note_absent_columns() {
  bool any = false;
  for (std::size_t index = 0; index < numbers_.size(); ++index)
    any = any || (numbers_[index].empty() && !is_text(declaration(Column{family_, static_cast<std::uint8_t>(index)})));
  absent_.resize(any ? offsets_.size() : 0, not_known);
}

void Table::forget() {
  parts_.forget();
  order_.forget();
}

void Table::make_column(std::size_t index) {
  if (numbers_[index].empty()) numbers_[index].assign(offsets_.size(), not_known);
}

std::vector<int> Table::rows_of(std::string_view part_number_wanted) const {
  return parts_.find(part_number_wanted, rows(), [&](int row) { return part_number(row); });
}

}  // namespace millwright::catalogue
