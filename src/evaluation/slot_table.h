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
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/family.h"
#include "scalar/scalars.h"
#include "solver/stage.h"

namespace millwright::evaluation {

/// One line that a candidate puts on the bill of materials. There are hundreds of thousands of them: their words are
/// kept by the table that they stand in.
struct PartUse {
  std::string_view slot;  ///< "screw", "nut", ...
  catalogue::Family family{};
  int row = 0;            ///< in the catalogue's table
  double quantity = 1.0;  ///< pieces in the machine
  double length = 0.0;    ///< m to cut, 0 for whole pieces
  double price = 0.0;     ///< of the line, in the problem's currency
  double mass = 0.0;      ///< kg, of the line
  /// What the problem itself states is of no catalogue: its name there; empty for everything else.
  std::string_view stated = {};
  double spares = 0.0;  ///< pieces bought beside those in the machine: priced, not weighed
  [[nodiscard]] double pieces() const { return quantity + spares; }
  [[nodiscard]] bool is_named() const { return stated != unnamed; }
  /// What stands for the name of the only one there is.
  static constexpr std::string_view unnamed = "as the problem states it";
};

/// What is set at a part and neither bought nor weighed: the current of a driver.
struct Setting {
  std::string_view name;  ///< lives as long as the program
  double value = 0.0;     ///< SI
  std::string_view unit;  ///< SI unit; lives as long as the program
  friend bool operator==(const Setting&, const Setting&) = default;
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

/// A candidate before it stands in a table.
struct CandidateDraft {
  std::vector<PartUse> parts;  ///< none: nothing is bought here, since another slot's part serves
  std::vector<Setting> settings;
  std::string form;  ///< tells apart what is the same parts: a belt for pulleys of one size or another
  double price = 0.0;
  double mass = 0.0;           ///< kg, of all its parts
  double riding_mass = 0.0;    ///< kg that moves with the axis
  double standing_mass = 0.0;  ///< kg on the axis's parent; the rest (a driver in its cabinet) burdens nobody
  /// Null where every figure is what it is: then the numbers above and the readings say all.
  std::shared_ptr<const CandidateRanges> ranges = {};
};

/// A candidate as it stands in a table, and while that lives and is not changed.
struct Candidate {
  std::span<const PartUse> parts;
  std::span<const Setting> settings;
  std::string_view form;
  double price = 0.0, mass = 0.0;
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
inline bool can_be_added(const CandidateDraft& candidate, std::span<const double> readings, double also = 0.0) {
  return std::isfinite(candidate.price) && !std::isnan(candidate.mass + also) &&
         std::none_of(readings.begin(), readings.end(), [](double x) { return std::isnan(x); });
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

class SlotTable {
 public:
  explicit SlotTable(std::string name = {}, std::size_t fields = 0) : name_(std::move(name)), fields_(fields) {}

  /// Room for so many candidates, of so many parts each.
  void reserve(std::size_t rows, std::size_t parts) {
    parts_end_.reserve(rows);
    parts_.reserve(rows * parts);
    numbers_.reserve(rows * width());
  }
  /// Adds a candidate with its readings. Throws std::logic_error unless these are as many as fields.
  void add(CandidateDraft candidate, std::span<const double> readings) {
    if (readings.size() != fields_) throw std::logic_error("not as many readings as " + name_ + " has fields");
    const std::size_t row = rows();
    for (PartUse& part : candidate.parts) {
      if (part.stated.empty()) note(added_, {part.family, part.row}, [](const CatalogueRow& each) { return each; });
      part.slot = kept_word(part.slot);
      part.stated = kept_word(part.stated);
      parts_.push_back(part);
    }
    parts_end_.push_back(static_cast<std::uint32_t>(parts_.size()));
    put(forms_, row, std::move(candidate.form));
    put(settings_, row, std::move(candidate.settings));
    numbers_.insert(numbers_.end(), readings.begin(), readings.end());
    numbers_.insert(numbers_.end(),
                    {candidate.price,
                     candidate.mass,
                     candidate.riding_mass,
                     candidate.standing_mass,
                     candidate.riding_mass + candidate.standing_mass});
    put(ranges_, row, std::move(candidate.ranges));
  }
  /// Whether a candidate can be added (can_be_added). Where something is missing its rows are noted as incomplete;
  /// `missing`: the figures that they do not have.
  bool admits(const CandidateDraft& candidate,
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
  [[nodiscard]] std::span<PartUse> change_parts(std::size_t row) {
    return std::span(parts_).subspan(parts_begin(row), parts_end_[row] - parts_begin(row));
  }
  /// Makes a candidate dearer, or cheaper.
  void add_to_price(std::size_t row, double more) {
    change_total(row, Total::price) += more;
    if (row >= ranges_.size() || !ranges_[row]) return;
    auto ranges = std::make_shared<CandidateRanges>(*ranges_[row]);
    scalar::Interval& price = ranges->totals[static_cast<std::size_t>(Total::price)];
    price = price + scalar::Interval(more);
    ranges_[row] = std::move(ranges);
  }
  /// Says which rows are never worse than this one, whatever else is chosen; where such rows are left out there are
  /// none.
  void cover(std::size_t row, std::vector<solver::Row> by) { put(covered_by_, row, std::move(by)); }
  [[nodiscard]] std::span<const solver::Row> covered_by(std::size_t row) const { return said_of(covered_by_, row); }
  [[nodiscard]] std::size_t rows() const { return parts_end_.size(); }
  [[nodiscard]] Candidate candidate(std::size_t row) const {
    return {std::span(parts_).subspan(parts_begin(row), parts_end_[row] - parts_begin(row)),
            said_of(settings_, row),
            said_of(forms_, row),
            total(row, Total::price),
            total(row, Total::mass)};
  }
  /// All numbers of a row, side by side: its readings, then its totals.
  [[nodiscard]] const double* numbers(std::size_t row) const { return numbers_.data() + row * width(); }
  [[nodiscard]] std::size_t width() const { return fields_ + total_count; }
  [[nodiscard]] double reading(std::size_t row, std::size_t field) const { return numbers(row)[field]; }
  [[nodiscard]] double total(std::size_t row, Total what) const {
    return numbers(row)[fields_ + static_cast<std::size_t>(what)];
  }
  /// The interval of a reading: the number itself where no range is given.
  [[nodiscard]] scalar::Interval range(std::size_t row, std::size_t field) const {
    return row < ranges_.size() && ranges_[row] ? ranges_[row]->readings[field] : scalar::Interval(reading(row, field));
  }
  /// The same of a total.
  [[nodiscard]] scalar::Interval range(std::size_t row, Total what) const {
    return row < ranges_.size() && ranges_[row] ? ranges_[row]->totals[static_cast<std::size_t>(what)]
                                                : scalar::Interval(total(row, what));
  }
  /// Whether a candidate has ranges.
  [[nodiscard]] bool has_ranges() const { return !ranges_.empty(); }
  [[nodiscard]] std::size_t fields() const { return fields_; }
  /// Of a reading over rows alive.
  template <class T>
  [[nodiscard]] T read(const solver::RowsAlive& alive, std::size_t field) const;

  /// Takes so many of every candidate; the readings stay those of one.
  void multiply(double count) {
    if (count == 1.0) return;
    for (PartUse& part : parts_) {
      part.quantity *= count;
      part.price *= count;
      part.mass *= count;
    }
    for (std::size_t row = 0; row < rows(); ++row) {
      for (const Total each : {Total::price, Total::mass, Total::riding_mass, Total::standing_mass})
        change_total(row, each) *= count;
      change_total(row, Total::burden) = total(row, Total::riding_mass) + total(row, Total::standing_mass);
    }
    for (auto& each : ranges_) {
      if (!each) continue;
      auto ranges = std::make_shared<CandidateRanges>(*each);
      for (scalar::Interval& total : ranges->totals) total = count * total;
      each = std::move(ranges);
    }
  }

  /// Keeps only the candidates for which keep(row) holds.
  template <class Keep>
  void filter(Keep&& keep) {
    SlotTable kept(name_, fields_);
    kept.added_ = std::move(added_);
    kept.incomplete_ = std::move(incomplete_);
    kept.words_ = std::move(words_);
    for (std::size_t row = 0; row < rows(); ++row) {
      if (!keep(row)) continue;
      const std::size_t to = kept.rows();
      const std::span<const PartUse> parts = candidate(row).parts;
      kept.parts_.insert(kept.parts_.end(), parts.begin(), parts.end());
      kept.parts_end_.push_back(static_cast<std::uint32_t>(kept.parts_.size()));
      kept.numbers_.insert(kept.numbers_.end(), numbers(row), numbers(row) + width());
      if (row < forms_.size()) put(kept.forms_, to, std::move(forms_[row]));
      if (row < settings_.size()) put(kept.settings_, to, std::move(settings_[row]));
      if (row < ranges_.size()) put(kept.ranges_, to, std::move(ranges_[row]));
    }
    *this = std::move(kept);
  }

 private:
  /// Next to each other stand one row with a partner and with the next.
  template <class Note, class Row>
  static void note(std::vector<Note>& notes, Note next, Row&& row_of) {
    for (std::size_t back = 1; back <= std::min<std::size_t>(2, notes.size()); ++back)
      if (row_of(notes[notes.size() - back]) == row_of(next)) return;
    notes.push_back(std::move(next));
  }

  /// Notes what few rows have; up to the last of them there is a place for each.
  template <class Said>
  static void put(std::vector<Said>& of_rows, std::size_t row, Said said) {
    if (said == Said{}) return;
    if (of_rows.size() <= row) of_rows.resize(row + 1);
    of_rows[row] = std::move(said);
  }
  template <class Said>
  static const Said& said_of(const std::vector<Said>& of_rows, std::size_t row) {
    static const Said nothing{};
    return row < of_rows.size() ? of_rows[row] : nothing;
  }

  [[nodiscard]] std::size_t parts_begin(std::size_t row) const { return row == 0 ? 0 : parts_end_[row - 1]; }
  double& change_total(std::size_t row, Total what) {
    return numbers_[row * width() + fields_ + static_cast<std::size_t>(what)];
  }
  /// The same word, where it lives as long as the table and all its copies.
  std::string_view kept_word(std::string_view word) {
    if (word.empty()) return {};
    for (const auto& known : words_)
      if (*known == word) return *known;
    words_.push_back(std::make_shared<const std::string>(word));
    return *words_.back();
  }

  std::string name_;
  std::size_t fields_ = 0;
  std::vector<std::shared_ptr<const std::string>> words_;
  std::vector<PartUse> parts_;            ///< row by row
  std::vector<std::uint32_t> parts_end_;  ///< [row]
  std::vector<std::string> forms_;
  std::vector<std::vector<Setting>> settings_;
  std::vector<std::vector<solver::Row>> covered_by_;
  std::vector<std::shared_ptr<const CandidateRanges>> ranges_;
  std::vector<CatalogueRow> added_;
  std::vector<IncompleteRow> incomplete_;
  std::vector<double> numbers_;  ///< row by row: readings, then totals; long tables are read by these alone
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
