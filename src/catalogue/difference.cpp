// SPDX-License-Identifier: Apache-2.0
#include "catalogue/difference.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <numeric>
#include <tuple>

#include "catalogue/cell_text.h"
#include "catalogue/column_unit.h"
#include "catalogue/standing.h"
#include "scalar/unit.h"

namespace millwright::catalogue {
namespace {

std::vector<Column> columns_of(Family family, Identity identity) {
  std::vector<Column> columns;
  for (std::size_t index = 0; index < column_count(family); ++index) {
    const Column each{family, static_cast<std::uint8_t>(index)};
    if (declaration(each).identity == identity) columns.push_back(each);
  }
  return columns;
}

/// To 13 digits in the customary unit: what says which row this is has to be equal exactly, also where it was converted
/// from another unit.
double rounded(double value) {
  if (!std::isfinite(value) || value == 0.0) return 0.0;
  constexpr int digits = 13;
  const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(scale) && scale > 0.0 ? std::round(value * scale) / scale : value;
}

/// The rows of a table by what tells them apart: those of a part beside each other, its points ascending.
class SortedRows {
 public:
  explicit SortedRows(const Table& table)
      : table_(table),
        group_(columns_of(table.family(), Identity::group)),
        point_(columns_of(table.family(), Identity::point)),
        keys_(column_count(table.family())),
        rows_(static_cast<std::size_t>(table.rows())) {
    for (const auto* columns : {&group_, &point_})
      for (const Column each : *columns)
        if (declaration(each).kind != Kind::text) round(each);
    std::iota(rows_.begin(), rows_.end(), 0);
    std::sort(rows_.begin(), rows_.end(), [this](int one, int other) {
      const auto order = compare(group_, one, *this, other);
      return std::is_neq(order) ? std::is_lt(order) : std::is_lt(compare(point_, one, *this, other));
    });
  }

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  int operator[](std::size_t place) const { return rows_[place]; }
  [[nodiscard]] const Table& table() const { return table_; }

  /// Behind the last row of the part that begins at `first`.
  [[nodiscard]] std::size_t end_of_part(std::size_t first) const {
    std::size_t end = first + 1;
    while (end < rows_.size() && std::is_eq(compare(group_, rows_[first], *this, rows_[end]))) ++end;
    return end;
  }
  [[nodiscard]] std::weak_ordering part(int row, const SortedRows& other, int other_row) const {
    return compare(group_, row, other, other_row);
  }
  [[nodiscard]] std::weak_ordering point(int row, const SortedRows& other, int other_row) const {
    return compare(point_, row, other, other_row);
  }
  [[nodiscard]] std::string point_text(int row) const {
    std::string text;
    for (const Column each : point_) text += (text.empty() ? "" : ", ") + cell_text(table_, each, row);
    return text;
  }

 private:
  void round(Column column) {
    std::vector<double>& keys = keys_[column.index];
    const scalar::Unit& unit = display_unit(column);
    for (const double si : table_.numbers(column)) keys.push_back(rounded(unit.from_si(si)));
  }
  [[nodiscard]] std::weak_ordering compare(const std::vector<Column>& columns,
                                           int row,
                                           const SortedRows& other,
                                           int other_row) const {
    for (const Column each : columns) {
      if (declaration(each).kind == Kind::text) {
        const auto order = table_.text(each, row) <=> other.table_.text(each, other_row);
        if (std::is_neq(order)) return order;
        continue;
      }
      const double mine = keys_[each.index][static_cast<std::size_t>(row)];
      const double theirs = other.keys_[each.index][static_cast<std::size_t>(other_row)];
      if (mine != theirs) return mine < theirs ? std::weak_ordering::less : std::weak_ordering::greater;
    }
    return std::weak_ordering::equivalent;
  }

  const Table& table_;
  std::vector<Column> group_, point_;
  std::vector<std::vector<double>> keys_;
  std::vector<int> rows_;
};

bool same_cell(const Table& a, int a_row, const Table& b, int b_row, Column column) {
  if (declaration(column).kind == Kind::text) return a.text(column, a_row) == b.text(column, b_row);
  return same_value(a.number(column, a_row), b.number(column, b_row));
}

double relative_change(const Table& a, int a_row, const Table& b, int b_row, Column column) {
  const Kind kind = declaration(column).kind;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (kind == Kind::text || kind == Kind::flag) return none;
  if (kind == Kind::money && a.text("currency", a_row) != b.text("currency", b_row)) return none;
  if (display_unit(column).kind() == scalar::UnitKind::temperature) return none;  // its zero is a convention
  const double before = a.number(column, a_row), after = b.number(column, b_row);
  return before == 0.0 ? none : (after - before) / std::abs(before);
}

CellChange change_of(const Table& a, int a_row, const Table& b, int b_row, Column column) {
  constexpr int all_digits = 17;
  CellChange change{column, {}, cell_text(a, column, a_row), cell_text(b, column, b_row), 0.0, {}, {}};
  if (change.a == change.b) {
    change.a = cell_text(a, column, a_row, all_digits);
    change.b = cell_text(b, column, b_row, all_digits);
  }
  change.relative = relative_change(a, a_row, b, b_row, column);
  change.a_where = a.where(a_row, column);
  change.b_where = b.where(b_row, column);
  return change;
}

/// The tolerance that the figure's own companion states; NaN where none does.
double own_tolerance(const Table& table, int row, Column column) {
  const double share = table.tolerance(row, column);
  return same_value(share, stated_tolerance(table.basis(row, column))) ? std::nan("") : share;
}

std::string tolerance_text(double share, int digits) {
  return std::isnan(share) ? std::string() : scalar::format_number(100.0 * share, digits) + " %";
}

/// What changed of what is said of one figure.
void compare_companions(
    const Table& a, int a_row, const Table& b, int b_row, Column column, std::vector<CellChange>& cells) {
  const auto add = [&](CompanionKind kind, std::string before, std::string after) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    cells.push_back({column,
                     {},
                     std::move(before),
                     std::move(after),
                     none,
                     a.where(a_row, column, kind),
                     b.where(b_row, column, kind),
                     kind});
  };
  const auto text = [&](CompanionKind kind, std::string_view before, std::string_view after) {
    if (before != after) add(kind, std::string(before), std::string(after));
  };
  text(CompanionKind::source, a.figure_source(a_row, column), b.figure_source(b_row, column));
  text(CompanionKind::confidence, a.figure_confidence(a_row, column), b.figure_confidence(b_row, column));
  // A share stays the same where it is the same share, or the same width about another figure.
  const double before = own_tolerance(a, a_row, column), after = own_tolerance(b, b_row, column);
  if (same_value(before, after)) return;
  if (!std::isnan(before) && same_value(a.half_width(a_row, column), b.half_width(b_row, column))) return;
  const bool alike = tolerance_text(before, 4) == tolerance_text(after, 4);
  add(CompanionKind::tolerance, tolerance_text(before, alike ? 17 : 4), tolerance_text(after, alike ? 17 : 4));
}

/// Compares two parts, whose rows are `[a_begin, a_end)` and `[b_begin, b_end)` of the sorted ones.
class PartComparison {
 public:
  PartComparison(const SortedRows& a, const SortedRows& b)
      : a_(a), b_(b), columns_(columns_of(a.table().family(), Identity::none)) {}

  PartChange compare(std::size_t a_begin, std::size_t a_end, std::size_t b_begin, std::size_t b_end) const {
    PartChange part{a_[a_begin], b_[b_begin], static_cast<int>(a_end - a_begin), static_cast<int>(b_end - b_begin), {}};
    std::size_t pairs = 0;
    for (std::size_t i = a_begin, j = b_begin; i < a_end || j < b_end;) {
      const auto order = i == a_end   ? std::weak_ordering::greater
                         : j == b_end ? std::weak_ordering::less
                                      : a_.point(a_[i], b_, b_[j]);
      if (std::is_lt(order)) {
        lone_point(a_, a_[i++], true, part.cells);
      } else if (std::is_gt(order)) {
        lone_point(b_, b_[j++], false, part.cells);
      } else {
        pair(a_[i++], b_[j++], part.cells);
        ++pairs;
      }
    }
    if (pairs > 1) gather(pairs, part.cells);
    return part;
  }

 private:
  void pair(int a_row, int b_row, std::vector<CellChange>& cells) const {
    const std::size_t before = cells.size();
    for (const Column each : columns_) {
      if (!same_cell(a_.table(), a_row, b_.table(), b_row, each))
        cells.push_back(change_of(a_.table(), a_row, b_.table(), b_row, each));
      const Kind kind = declaration(each).kind;
      if (kind == Kind::number || kind == Kind::money)
        compare_companions(a_.table(), a_row, b_.table(), b_row, each, cells);
    }
    for (std::size_t i = before; i < cells.size(); ++i) cells[i].point = a_.point_text(a_row);
  }

  void lone_point(const SortedRows& side, int row, bool in_a, std::vector<CellChange>& cells) const {
    for (const Column each : columns_) {
      const ColumnDeclaration& declared = declaration(each);
      if (declared.kind != Kind::number || std::isnan(side.table().number(each, row))) continue;
      CellChange change{each, side.point_text(row), {}, {}, std::numeric_limits<double>::quiet_NaN(), {}, {}};
      (in_a ? change.a : change.b) = cell_text(side.table(), each, row);
      (in_a ? change.a_where : change.b_where) = side.table().where(row, each);
      cells.push_back(std::move(change));
    }
  }

  /// What changed alike at every point that both have is said once.
  static void gather(std::size_t pairs, std::vector<CellChange>& cells) {
    std::vector<CellChange> everywhere, rest;
    std::vector<std::size_t> order;  // a point that only one has is said as such
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (cells[i].a_where.text && cells[i].b_where.text) order.push_back(i);
    const auto key = [&](std::size_t i) {
      return std::tie(cells[i].column.index, cells[i].companion, cells[i].a, cells[i].b);
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
    std::vector<bool> gathered(cells.size(), false);
    for (std::size_t begin = 0; begin < order.size();) {
      std::size_t end = begin + 1;
      while (end < order.size() && key(order[begin]) == key(order[end])) ++end;
      if (end - begin == pairs) {
        everywhere.push_back(cells[order[begin]]);
        everywhere.back().point.clear();
        for (std::size_t i = begin; i < end; ++i) gathered[order[i]] = true;
      }
      begin = end;
    }
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (!gathered[i]) rest.push_back(std::move(cells[i]));
    cells = std::move(everywhere);
    cells.insert(cells.end(), std::make_move_iterator(rest.begin()), std::make_move_iterator(rest.end()));
  }

  const SortedRows& a_;
  const SortedRows& b_;
  std::vector<Column> columns_;
};

}  // namespace

std::string changed_column(const CellChange& change) {
  return change.companion ? companion_name(change.column, *change.companion)
                          : std::string(declaration(change.column).name);
}

bool same_value(double a, double b) {
  constexpr double tolerance = 1e-12;
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b || std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

FamilyDifference difference(const Table& a, const Table& b) {
  FamilyDifference found{a.family(), {}, {}, {}, 0};
  const SortedRows in_a(a), in_b(b);
  const PartComparison comparison(in_a, in_b);
  for (std::size_t i = 0, j = 0; i < in_a.size() || j < in_b.size();) {
    const auto order = i == in_a.size()   ? std::weak_ordering::greater
                       : j == in_b.size() ? std::weak_ordering::less
                                          : in_a.part(in_a[i], in_b, in_b[j]);
    const std::size_t a_end = std::is_lteq(order) ? in_a.end_of_part(i) : i;
    const std::size_t b_end = std::is_gteq(order) ? in_b.end_of_part(j) : j;
    if (std::is_lt(order)) {
      found.removed.push_back(in_a[i]);
    } else if (std::is_gt(order)) {
      found.added.push_back(in_b[j]);
    } else if (PartChange part = comparison.compare(i, a_end, j, b_end); part.cells.empty()) {
      ++found.same;
    } else {
      found.changed.push_back(std::move(part));
    }
    i = a_end;
    j = b_end;
  }
  return found;
}

std::vector<FamilyDifference> difference(const Catalogue& a, const Catalogue& b, std::optional<Family> only) {
  std::vector<FamilyDifference> all;
  for (const FamilyDeclaration& each : families) {
    if (only ? each.family != *only : a.table(each.family).empty() && b.table(each.family).empty()) continue;
    all.push_back(difference(a.table(each.family), b.table(each.family)));
  }
  return all;
}

std::string part_title(const Table& table, int row) {
  std::string more;
  for (const Column each : columns_of(table.family(), Identity::group)) {
    const std::string_view name = declaration(each).name;
    const std::string text = cell_text(table, each, row);
    if (name != "manufacturer" && name != "part_number" && !text.empty()) more += (more.empty() ? "" : ", ") + text;
  }
  std::string title = std::string(table.manufacturer(row)) + " " + std::string(table.part_number(row));
  return more.empty() ? title : title + " (" + more + ")";
}

}  // namespace millwright::catalogue
