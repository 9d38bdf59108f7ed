// SPDX-License-Identifier: Apache-2.0
#include "solver/row_dominance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "solver/archive.h"

namespace millwright::solver {
namespace {

class DominatedRows {
 public:
  DominatedRows(const StagePlan& plan, std::size_t slot, Desk& desk)
      : plan_(plan),
        slot_(slot),
        graded_(plan.stage->graded_readings(slot)),
        desk_(desk),
        question_{plan.stage, plan.shared, plan.criteria, &plan.region, plan.inherited, plan.after},
        directions_(graded_) {}

  /// The rows that are left.
  std::vector<Row> others() {
    std::map<std::pair<std::size_t, std::uint32_t>, std::vector<Row>> comparable;
    for (const Row row : *plan_.region.rows[slot_]) {
      const std::uint32_t fit = plan_.fits.everything_fits() ? 0 : plan_.fits.kinds(slot_)[row];
      comparable[{plan_.stage->row_kind(slot_, row), fit}].push_back(row);
    }
    std::vector<Row> left;
    for (const auto& [kind, rows] : comparable) keep_best(rows, left);
    std::sort(left.begin(), left.end());
    return left;
  }

 private:
  void keep_best(const std::vector<Row>& rows, std::vector<Row>& left) {
    if (rows.size() < 2) {
      left.insert(left.end(), rows.begin(), rows.end());
      return;
    }
    const std::size_t dimensions = find_coordinates(rows);
    const auto of_row = [&](std::size_t i) {
      return std::span<const double>(coordinates_.data() + i * dimensions, dimensions);
    };
    // What is at most another one in all coordinates comes before it, among equals the smaller number.
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
      const auto of = of_row(i);
      // What is not known compares with nothing.
      if (std::any_of(of.begin(), of.end(), [](double coordinate) { return std::isnan(coordinate); }))
        left.push_back(rows[i]);
      else
        order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::lexicographical_compare(of_row(a).begin(), of_row(a).end(), of_row(b).begin(), of_row(b).end());
    });
    Archive best(dimensions);
    for (const std::uint32_t i : order) {
      if (best.dominates(of_row(i))) continue;
      best.add(of_row(i));
      left.push_back(rows[i]);
    }
  }

  /// Coordinates of rows that are all to be small where one row stands in for another; returns how many a row has. What
  /// has to be equal is two of them, one with either sign; what is equal in all rows is none.
  std::size_t find_coordinates(const std::vector<Row>& rows) {
    const std::size_t width = read(rows);
    std::vector<std::pair<std::size_t, double Interval::*>> ends;
    std::vector<double> sign;
    const auto add = [&](std::size_t reading, double Interval::*end, double with_sign) {
      ends.emplace_back(reading, end);
      sign.push_back(with_sign);
    };
    for (std::size_t r = 0; r < width; ++r) {
      if (!differs(r, width)) continue;
      const Direction direction = r < graded_ ? direction_of(r) : Direction::equal_only;
      if (direction == Direction::irrelevant) continue;
      if (direction != Direction::larger_is_better) add(r, &Interval::upper, 1.0);
      if (direction != Direction::smaller_is_better) add(r, &Interval::lower, -1.0);
      if (direction == Direction::equal_only) {
        add(r, &Interval::upper, -1.0);
        add(r, &Interval::lower, 1.0);
      }
    }
    coordinates_.clear();
    for (std::size_t first = 0; first < readings_.size(); first += width)
      for (std::size_t d = 0; d < ends.size(); ++d)
        coordinates_.push_back(sign[d] * (readings_[first + ends[d].first].*ends[d].second));
    return ends.size();
  }

  /// What is read of each row by itself, one after the other; returns how much of each.
  std::size_t read(const std::vector<Row>& rows) {
    readings_.clear();
    for (const Row& row : rows) {
      plan_.stage->read(plan_.shared, slot_, std::span(&row, 1), of_one_);
      readings_.insert(readings_.end(), of_one_.begin(), of_one_.end());
    }
    return of_one_.size();
  }

  [[nodiscard]] bool differs(std::size_t reading, std::size_t width) const {
    const Interval& first = readings_[reading];
    for (std::size_t at = reading; at < readings_.size(); at += width)
      if (readings_[at].lower != first.lower || readings_[at].upper != first.upper) return true;
    return false;
  }

  Direction direction_of(std::size_t reading) {
    std::optional<Direction>& known = directions_[reading];
    if (!known) known = prove_reading_direction(question_, slot_, reading, desk_);
    return *known;
  }

  const StagePlan& plan_;
  std::size_t slot_;
  std::size_t graded_;
  Desk& desk_;
  MonotonicityQuestion question_;
  std::vector<std::optional<Direction>> directions_;  ///< [graded reading]
  std::vector<Interval> readings_, of_one_;           ///< [row][reading]
  std::vector<double> coordinates_;                   ///< [row][dimension]
};

/// The rows of a slot that are left; nothing where all are.
RowSet others_of(const StagePlan& plan, std::size_t slot, Desk& desk) {
  const std::size_t rows = plan.region.rows[slot]->size();
  if (rows < 2 || plan.stage->graded_readings(slot) == 0) return nullptr;
  std::vector<Row> left = DominatedRows(plan, slot, desk).others();
  return left.size() < rows ? make_rows(*plan.stage, plan.shared, slot, std::move(left)) : nullptr;
}

}  // namespace

void leave_out_dominated_rows(std::vector<StagePlan>& plans, Desk& desk) {
  for (StagePlan& plan : plans) {
    std::vector<RowSet> rows;  // all of a plan or none: it may be interrupted
    for (std::size_t slot = 0; slot < plan.region.rows.size(); ++slot) rows.push_back(others_of(plan, slot, desk));
    bool fewer = false;
    for (std::size_t slot = 0; slot < rows.size(); ++slot) {
      if (rows[slot] == nullptr) continue;
      plan.region.rows[slot] = std::move(rows[slot]);
      fewer = true;
    }
    if (fewer) keep_within_region(plan);
  }
}

}  // namespace millwright::solver
