// SPDX-License-Identifier: Apache-2.0
//
// The candidates of one slot: what each would put on the bill of materials, what it costs and weighs, and the readings
// that constraints take of it. Readings are computed per row once; a set of rows is bounded by the hull of its
// readings.
#pragma once

#include <algorithm>
#include <cstdint>
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

struct Candidate {
  std::vector<PartUse> parts;
  std::vector<Setting> settings;
  double price = 0.0;
  double mass = 0.0;           ///< kg, of all its parts
  double riding_mass = 0.0;    ///< kg that moves with the axis
  double standing_mass = 0.0;  ///< kg on the axis's parent; the rest (a driver in its cabinet) burdens nobody
  /// Rows of the same table that are never worse, whatever else is chosen; where such rows are left out there are none.
  std::vector<solver::Row> covered_by;
};

/// What is added up over the slots of a stage.
enum class Total : std::size_t { price, mass, riding_mass, standing_mass, burden };
/// The readings of every slot are its table's fields, then these, then what the stage adds.
inline constexpr std::size_t total_count = 5;
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

/// So many of a candidate.
inline Candidate times(double count, Candidate candidate) {
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

  /// Adds a candidate with its readings, as many as fields.
  void add(Candidate candidate, std::span<const double> readings) {
    candidates_.push_back(std::move(candidate));
    readings_.insert(readings_.end(), readings.begin(), readings.end());
  }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Candidate& change(std::size_t row) { return candidates_[row]; }
  /// Says which rows are never worse than this one.
  void cover(std::size_t row, std::vector<solver::Row> by) { candidates_[row].covered_by = std::move(by); }
  [[nodiscard]] std::size_t rows() const { return candidates_.size(); }
  [[nodiscard]] const Candidate& candidate(std::size_t row) const { return candidates_[row]; }
  [[nodiscard]] double reading(std::size_t row, std::size_t field) const { return readings_[row * fields_ + field]; }
  [[nodiscard]] std::size_t fields() const { return fields_; }
  /// Of a reading over rows alive.
  template <class T>
  [[nodiscard]] T read(const solver::RowsAlive& alive, std::size_t field) const;

  /// Takes so many of every candidate; the readings stay those of one.
  void multiply(double count) {
    for (Candidate& candidate : candidates_) candidate = times(count, std::move(candidate));
  }

  /// Keeps only the candidates for which keep(row) holds.
  template <class Keep>
  void filter(Keep&& keep) {
    std::size_t to = 0;
    for (std::size_t row = 0; row < candidates_.size(); ++row) {
      if (!keep(row)) continue;
      if (to != row) {
        candidates_[to] = std::move(candidates_[row]);
        std::copy_n(readings_.begin() + static_cast<std::ptrdiff_t>(row * fields_),
                    fields_,
                    readings_.begin() + static_cast<std::ptrdiff_t>(to * fields_));
      }
      ++to;
    }
    candidates_.resize(to);
    readings_.resize(to * fields_);
  }

 private:
  std::string name_;
  std::size_t fields_ = 0;
  std::vector<Candidate> candidates_;
  std::vector<double> readings_;
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

/// The hull of one quantity over the rows alive: what was read of them as number `reading`, if they were read. For
/// point scalars the only row's value.
template <class T, class Value>
T hull_of(const RowsAlive& alive, std::size_t reading, Value&& value) {
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, scalar::Dual<double, 1>>) {
    return T(value(alive.front()));
  } else {
    return T(reading < alive.readings.size() ? alive.readings[reading] : range_of(alive.rows, value));
  }
}

template <class T>
T SlotTable::read(const RowsAlive& alive, std::size_t field) const {
  return hull_of<T>(alive, field, [&](solver::Row row) { return reading(row, field); });
}

}  // namespace millwright::evaluation
