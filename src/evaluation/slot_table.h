// SPDX-License-Identifier: Apache-2.0
//
// The candidates of one slot: what each would put on the bill of materials, what it costs and weighs, and the readings
// that constraints take of it. Readings are computed per row once; a set of rows is bounded by the hull of its
// readings.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "catalogue/family.h"
#include "scalar/scalars.h"
#include "solver/stage.h"

namespace millwright::evaluation {

/// One line that a candidate puts on the bill of materials.
struct PartUse {
  std::string slot;  ///< "screw", "nut", ...
  catalogue::Family family{};
  int row = 0;            ///< in the catalogue's table
  double quantity = 1.0;  ///< pieces in the machine
  double length = 0.0;    ///< m to cut, 0 for whole pieces
  double price = 0.0;     ///< of the line, in the problem's currency
  double mass = 0.0;      ///< kg, of the line
  /// What the problem itself states is of no catalogue: its name there; empty for everything else.
  std::string stated = {};
  double spares = 0.0;  ///< pieces bought beside those in the machine: priced, not weighed
  [[nodiscard]] double pieces() const { return quantity + spares; }
  [[nodiscard]] bool is_named() const { return stated != unnamed; }
  /// What stands for the name of the only one there is.
  static constexpr const char* unnamed = "as the problem states it";
};

/// What is set at a part and neither bought nor weighed: the current of a driver.
struct Setting {
  std::string name;
  double value = 0.0;  ///< SI
  std::string unit;    ///< SI unit
};

/// What is added up over the slots of a stage.
enum class Total : std::size_t { price, mass, riding_mass, standing_mass, burden };
/// The readings of every slot are its table's fields, then these, then what the stage adds.
inline constexpr std::size_t total_count = 5;

/// The intervals of a candidate of which figures are only known within a tolerance (catalogue::Table::range).
struct CandidateRanges {
  std::vector<scalar::Interval> readings;                 ///< as many as fields
  std::array<scalar::Interval, total_count> totals = {};  ///< by Total
};

struct Candidate {
  std::vector<PartUse> parts;  ///< none: nothing is bought here, since another slot's part serves
  std::vector<Setting> settings;
  std::string form;  ///< tells apart what is the same parts: a belt for pulleys of one size or another
  double price = 0.0;
  double mass = 0.0;           ///< kg, of all its parts
  double riding_mass = 0.0;    ///< kg that moves with the axis
  double standing_mass = 0.0;  ///< kg on the axis's parent; the rest (a driver in its cabinet) burdens nobody
  /// Rows of the same table that are never worse, whatever else is chosen; where such rows are left out there are none.
  std::vector<solver::Row> covered_by;
  /// Null where every figure is what it is: then the numbers above and the readings say all.
  std::shared_ptr<const CandidateRanges> ranges = {};
};

/// A row of a catalogue's table.
struct CatalogueRow {
  catalogue::Family family{};
  int row = 0;
  friend bool operator==(const CatalogueRow&, const CatalogueRow&) = default;
};

/// A row that cannot be chosen because it lacks something.
struct IncompleteRow {
  CatalogueRow part;
  std::vector<catalogue::Column> missing;  ///< figures that were asked for in vain, prices not among them
};

/// Whether nothing that a check reads is missing (NaN) - neither of the readings nor `also` nor the mass - and the
/// price is a number.
inline bool can_be_added(const Candidate& candidate, std::span<const double> readings, double also = 0.0) {
  return std::isfinite(candidate.price) && !std::isnan(candidate.mass + also) &&
         std::none_of(readings.begin(), readings.end(), [](double x) { return std::isnan(x); });
}

inline double total_of(const Candidate& candidate, Total what) {
  switch (what) {
    case Total::price:
      return candidate.price;
    case Total::mass:
      return candidate.mass;
    case Total::riding_mass:
      return candidate.riding_mass;
    case Total::standing_mass:
      return candidate.standing_mass;
    case Total::burden:  // on the axis's parent
      return candidate.riding_mass + candidate.standing_mass;
  }
  return 0.0;
}

/// The interval of a total: the number itself where no range is given.
inline scalar::Interval range_of_total(const Candidate& candidate, Total what) {
  return candidate.ranges ? candidate.ranges->totals[static_cast<std::size_t>(what)]
                          : scalar::Interval(total_of(candidate, what));
}

/// The ranges of a candidate with these readings: masses [kg] that ride, that stand on the parent, and of the rest.
inline std::shared_ptr<const CandidateRanges> candidate_ranges(std::span<const scalar::Interval> readings,
                                                               double price,
                                                               const scalar::Interval& riding,
                                                               const scalar::Interval& standing,
                                                               const scalar::Interval& cabinet = {}) {
  auto ranges = std::make_shared<CandidateRanges>();
  ranges->readings.assign(readings.begin(), readings.end());
  ranges->totals = {price, riding + standing + cabinet, riding, standing, riding + standing};
  return ranges;
}

/// So many of a candidate.
inline Candidate times(double count, Candidate candidate) {
  if (candidate.ranges) {
    auto ranges = std::make_shared<CandidateRanges>(*candidate.ranges);
    for (scalar::Interval& total : ranges->totals) total = count * total;
    candidate.ranges = std::move(ranges);
  }
  for (PartUse& part : candidate.parts) {
    part.quantity *= count;
    part.price *= count;
    part.mass *= count;
  }
  candidate.price *= count;
  candidate.mass *= count;
  candidate.riding_mass *= count;
  candidate.standing_mass *= count;
  return candidate;
}

class SlotTable {
 public:
  explicit SlotTable(std::string name = {}, std::size_t fields = 0) : name_(std::move(name)), fields_(fields) {}

  void reserve(std::size_t rows) {
    candidates_.reserve(rows);
    numbers_.reserve(rows * width());
  }
  /// Adds a candidate with its readings, as many as fields.
  void add(Candidate candidate, std::span<const double> readings) {
    has_ranges_ = has_ranges_ || candidate.ranges != nullptr;
    for (const PartUse& part : candidate.parts)
      if (part.stated.empty()) note(added_, {part.family, part.row}, [](const CatalogueRow& row) { return row; });
    candidates_.push_back(std::move(candidate));
    numbers_.insert(numbers_.end(), readings.begin(), readings.end());
    numbers_.resize(candidates_.size() * width());
    note_totals(candidates_.size() - 1);
  }
  /// Whether a candidate can be added (can_be_added). Where something is missing its rows are noted as incomplete;
  /// `missing`: the figures that they do not have.
  bool admits(const Candidate& candidate,
              std::span<const double> readings,
              const std::vector<catalogue::Column>& missing,
              double also = 0.0) {
    if (can_be_added(candidate, readings, also)) return true;
    if (std::isinf(candidate.price)) return false;  // it does not fit
    for (const PartUse& part : candidate.parts) note_incomplete({{part.family, part.row}, missing});
    return false;
  }
  void note_incomplete(IncompleteRow row) {
    note(incomplete_, std::move(row), [](const IncompleteRow& each) { return each.part; });
  }
  /// Rows that candidates were made of, whether these were kept or not. Some more than once.
  [[nodiscard]] std::span<const CatalogueRow> added() const { return added_; }
  /// Rows that the problem would take, but something is missing; of a pair, both. Some more than once.
  [[nodiscard]] std::span<const IncompleteRow> incomplete() const { return incomplete_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// What a candidate puts on the bill of materials. Its total price is changed by add_to_price.
  [[nodiscard]] std::span<PartUse> change_parts(std::size_t row) { return candidates_[row].parts; }
  /// Makes a candidate dearer, or cheaper.
  void add_to_price(std::size_t row, double more) {
    Candidate& candidate = candidates_[row];
    candidate.price += more;
    if (candidate.ranges) {
      auto ranges = std::make_shared<CandidateRanges>(*candidate.ranges);
      scalar::Interval& price = ranges->totals[static_cast<std::size_t>(Total::price)];
      price = price + scalar::Interval(more);
      candidate.ranges = std::move(ranges);
    }
    note_totals(row);
  }
  /// Says which rows are never worse than this one.
  void cover(std::size_t row, std::vector<solver::Row> by) { candidates_[row].covered_by = std::move(by); }
  [[nodiscard]] std::size_t rows() const { return candidates_.size(); }
  [[nodiscard]] const Candidate& candidate(std::size_t row) const { return candidates_[row]; }
  /// All numbers of a row, side by side: its readings, then its totals.
  [[nodiscard]] const double* numbers(std::size_t row) const { return numbers_.data() + row * width(); }
  [[nodiscard]] std::size_t width() const { return fields_ + total_count; }
  [[nodiscard]] double reading(std::size_t row, std::size_t field) const { return numbers(row)[field]; }
  [[nodiscard]] double total(std::size_t row, Total what) const {
    return numbers(row)[fields_ + static_cast<std::size_t>(what)];
  }
  /// The interval of a reading: the number itself where no range is given.
  [[nodiscard]] scalar::Interval range(std::size_t row, std::size_t field) const {
    const auto& ranges = candidates_[row].ranges;
    return ranges ? ranges->readings[field] : scalar::Interval(reading(row, field));
  }
  /// Whether a candidate has ranges.
  [[nodiscard]] bool has_ranges() const { return has_ranges_; }
  [[nodiscard]] std::size_t fields() const { return fields_; }
  /// Of a reading over rows alive.
  template <class T>
  [[nodiscard]] T read(const solver::RowsAlive& alive, std::size_t field) const;

  /// Takes so many of every candidate; the readings stay those of one.
  void multiply(double count) {
    if (count == 1.0) return;
    for (std::size_t row = 0; row < candidates_.size(); ++row) {
      candidates_[row] = times(count, std::move(candidates_[row]));
      note_totals(row);
    }
  }

  /// Keeps only the candidates for which keep(row) holds.
  template <class Keep>
  void filter(Keep&& keep) {
    std::size_t to = 0;
    for (std::size_t row = 0; row < candidates_.size(); ++row) {
      if (!keep(row)) continue;
      if (to != row) {
        candidates_[to] = std::move(candidates_[row]);
        std::copy_n(numbers(row), width(), numbers_.begin() + static_cast<std::ptrdiff_t>(to * width()));
      }
      ++to;
    }
    candidates_.resize(to);
    numbers_.resize(to * width());
  }

 private:
  /// Next to each other stand one row with a partner and with the next.
  template <class Note, class Row>
  static void note(std::vector<Note>& notes, Note next, Row&& row_of) {
    for (std::size_t back = 1; back <= std::min<std::size_t>(2, notes.size()); ++back)
      if (row_of(notes[notes.size() - back]) == row_of(next)) return;
    notes.push_back(std::move(next));
  }

  void note_totals(std::size_t row) {
    double* const totals = numbers_.data() + row * width() + fields_;
    for (std::size_t i = 0; i < total_count; ++i) totals[i] = total_of(candidates_[row], static_cast<Total>(i));
  }

  std::string name_;
  std::size_t fields_ = 0;
  bool has_ranges_ = false;
  std::vector<Candidate> candidates_;
  std::vector<CatalogueRow> added_;
  std::vector<IncompleteRow> incomplete_;
  std::vector<double> numbers_;  ///< row by row; totals stand here again because long tables are read by these alone
};

/// Rows alive of every slot; a single design has one each.
using Alive = std::span<const solver::RowsAlive>;
using solver::RowsAlive;

/// The smallest and the largest of what `value` says of these rows.
template <class Value>
scalar::Interval range_of(std::span<const solver::Row> rows, Value&& value) {
  double lower = value(rows.front());
  double upper = lower;
  for (const solver::Row row : rows.subspan(1)) {
    const double x = value(row);
    lower = std::min(lower, x);
    upper = std::max(upper, x);
  }
  return {lower, upper};
}

/// Appends the smallest and the largest of each of `width` quantities; `numbers(row)` is where those of a row lie side
/// by side. One pass over the rows: long tables do not fit into the processor's cache.
template <class Numbers>
void append_ranges(std::span<const solver::Row> rows,
                   std::size_t width,
                   Numbers&& numbers,
                   std::vector<scalar::Interval>& ranges) {
  const std::size_t first = ranges.size();
  const auto* const of_first = numbers(rows.front());
  ranges.insert(ranges.end(), of_first, of_first + width);
  scalar::Interval* const out = ranges.data() + first;
  for (const solver::Row row : rows.subspan(1)) {
    const auto* const own = numbers(row);
    for (std::size_t i = 0; i < width; ++i) {
      out[i].lower = std::min(out[i].lower, own[i]);
      out[i].upper = std::max(out[i].upper, own[i]);
    }
  }
}

/// The same of a quantity that is an interval of each row.
template <class Value>
scalar::Interval hull_of_ranges(std::span<const solver::Row> rows, Value&& value) {
  scalar::Interval result = value(rows.front());
  for (const solver::Row row : rows.subspan(1)) result = hull(result, value(row));
  return result;
}

/// The hull of one quantity over the rows alive: what was read of them as number `reading`, if they were read. For
/// point scalars the only row's value.
template <class T, class Value>
T hull_of(const RowsAlive& alive, std::size_t reading, Value&& value) {
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, scalar::Dual<double, 1>>) {
    return T(value(alive.front()));
  } else {
    T hull = T(reading < alive.readings.size() ? alive.readings[reading] : range_of(alive.rows, value));
    if constexpr (std::is_same_v<T, scalar::Dual<scalar::Interval, 1>>)
      if (reading == alive.with_respect_to) hull.slope[0] = scalar::Interval(1.0);
    return hull;
  }
}

template <class T>
T SlotTable::read(const RowsAlive& alive, std::size_t field) const {
  return hull_of<T>(alive, field, [&](solver::Row row) { return reading(row, field); });
}

}  // namespace millwright::evaluation
