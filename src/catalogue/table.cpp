// SPDX-License-Identifier: Apache-2.0
#include "catalogue/table.h"

#include <bit>
#include <cmath>
#include <functional>
#include <iterator>

namespace millwright::catalogue {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
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

bool takes_part(const ColumnDeclaration& declared, Identity level) {
  return declared.identity == Identity::group || (level == Identity::point && declared.identity == Identity::point);
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
  to.resize(rows, filler);
  if (from.empty()) {
    to.resize(rows + more, filler);
  } else if (to.empty()) {
    to = std::move(from);
  } else {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  }
}

template <class T>
void keep_in(std::vector<T>& values, const std::vector<bool>& keep) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t row = 0; row < keep.size(); ++row) {
    if (keep[row]) values[kept++] = std::move(values[row]);
  }
  values.resize(kept);
}

}  // namespace

Table::Table(Family family) : family_(family), numbers_(column_count(family)), texts_(column_count(family)) {}

Table::Table(Family family, TableColumns columns)
    : family_(family),
      numbers_(std::move(columns.numbers)),
      texts_(std::move(columns.texts)),
      offsets_(std::move(columns.offsets)),
      file_of_(offsets_.size(), 0) {
  numbers_.resize(column_count(family));
  texts_.resize(column_count(family));
  files_.push_back(std::move(columns.file));
  index_parts();
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
  return numbers_[column.index];
}

std::optional<bool> Table::flag(Column column, int row) const {
  const double value = number(column, row);
  if (std::isnan(value)) return std::nullopt;
  return value != 0.0;
}

std::string_view Table::text(Column column, int row) const {
  check(column, true);
  const auto& texts = texts_[column.index];
  return texts.empty() ? std::string_view() : texts[static_cast<std::size_t>(row)];
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
  price.estimate = is_estimate(row, Column{family_, piece});
  return price;
}

std::string_view Table::basis(int row, Column column) const {
  const std::string_view name = declaration(column).basis;
  return name.empty() ? std::string_view() : text(name, row);
}

Standing Table::standing(int row, Column column) const { return standing_of(basis(row, column)); }

bool Table::is_estimate(int row, Column column) const {
  if (is_text(declaration(column))) return false;
  return counts_as_estimate(standing(row, column), confidence(row));
}

double Table::tolerance(int row, Column column) const { return stated_tolerance(basis(row, column)); }

text::SourceSpan Table::where(int row) const { return where(row, Column{family_, part_number_index}); }

text::SourceSpan Table::where(int row, Column column) const {
  const auto at = static_cast<std::size_t>(row);
  const SourceFile& file = files_[file_of_[at]];
  const int field = file.field_of_column[column.index];
  const auto [begin, bytes] = field_range(file.text->contents(), offsets_[at], field < 0 ? 0 : field, file.separator);
  return text::span_at(file.text, begin, bytes);
}

bool Table::same_part(int row, const Table& other, int other_row, Identity level) const {
  for (std::size_t index = 0; index < numbers_.size(); ++index) {
    const Column each{family_, static_cast<std::uint8_t>(index)};
    const ColumnDeclaration& declared = declaration(each);
    if (!takes_part(declared, level)) continue;
    if (is_text(declared) ? text(each, row) != other.text(each, other_row)
                          : number(each, row) != other.number(each, other_row)) {
      return false;
    }
  }
  return true;
}

std::uint64_t Table::part_hash(int row, Identity level) const {
  std::uint64_t hash = 0;
  for (std::size_t index = 0; index < numbers_.size(); ++index) {
    const Column each{family_, static_cast<std::uint8_t>(index)};
    const ColumnDeclaration& declared = declaration(each);
    if (!takes_part(declared, level)) continue;
    hash =
        mix(hash, is_text(declared) ? hash_of(text(each, row)) : std::bit_cast<std::uint64_t>(number(each, row) + 0.0));
  }
  return hash;
}

void Table::keep_only(const std::vector<bool>& keep) {
  for (auto& values : numbers_) keep_in(values, keep);
  for (auto& values : texts_) keep_in(values, keep);
  keep_in(offsets_, keep);
  keep_in(file_of_, keep);
  index_parts();
}

void Table::append(Table&& other) {
  const std::size_t rows = offsets_.size();
  const std::size_t more = other.offsets_.size();
  for (std::size_t index = 0; index < numbers_.size(); ++index) {
    append_column(numbers_[index], std::move(other.numbers_[index]), rows, more, not_known);
    append_column(texts_[index], std::move(other.texts_[index]), rows, more, std::string_view());
  }
  offsets_.insert(offsets_.end(), other.offsets_.begin(), other.offsets_.end());
  const auto first_file = static_cast<std::uint32_t>(files_.size());
  for (const std::uint32_t file : other.file_of_) file_of_.push_back(first_file + file);
  for (SourceFile& file : other.files_) files_.push_back(std::move(file));
  index_parts();
}

void Table::overlay(Table&& upper) {
  RowIndex replaced(static_cast<std::size_t>(upper.rows()));
  for (int row = 0; row < upper.rows(); ++row) {
    replaced.insert(upper.part_hash(row, Identity::group), row, [&](int there) {
      return upper.same_part(row, upper, there, Identity::group);
    });
  }
  std::vector<bool> keep(offsets_.size(), true);
  for (int row = 0; row < rows(); ++row) {
    const auto same = [&](int there) { return same_part(row, upper, there, Identity::group); };
    keep[static_cast<std::size_t>(row)] = replaced.find(part_hash(row, Identity::group), same) == RowIndex::none;
  }
  keep_only(keep);
  append(std::move(upper));
}

void Table::index_parts() {
  const std::size_t count = offsets_.size();
  for (std::size_t index = 0; index < numbers_.size(); ++index) {  // absent columns answer NaN to the hot path
    const Column each{family_, static_cast<std::uint8_t>(index)};
    if (!is_text(declaration(each))) numbers_[index].resize(count, not_known);
  }
  first_of_part_ = RowIndex(count);
  next_row_.assign(count, RowIndex::none);
  std::vector<std::int32_t> last(count, RowIndex::none);
  for (std::int32_t row = 0; row < rows(); ++row) {
    const std::string_view part = part_number(row);
    const auto same = [&](std::int32_t there) { return part_number(there) == part; };
    const std::int32_t first = first_of_part_.insert(hash_of(part), row, same);
    if (first == RowIndex::none) {
      last[static_cast<std::size_t>(row)] = row;
    } else {
      next_row_[static_cast<std::size_t>(last[static_cast<std::size_t>(first)])] = row;
      last[static_cast<std::size_t>(first)] = row;
    }
  }
}

std::vector<int> Table::rows_of(std::string_view part_number_wanted) const {
  std::vector<int> found;
  const auto same = [&](std::int32_t there) { return part_number(there) == part_number_wanted; };
  for (std::int32_t row = first_of_part_.find(hash_of(part_number_wanted), same); row != RowIndex::none;
       row = next_row_[static_cast<std::size_t>(row)]) {
    found.push_back(row);
  }
  return found;
}

}  // namespace millwright::catalogue
