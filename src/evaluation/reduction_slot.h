// SPDX-License-Identifier: Apache-2.0
//
// The reductions that an axis states, as the last slot of its drive: the search chooses one. Price and mass are those
// of the problem; there is no catalogue of them. An axis without any has no such slot.
#pragma once

#include <optional>
#include <vector>

#include "evaluation/price_book.h"
#include "evaluation/slot_table.h"
#include "machine/problem.h"
#include "machine/reduction.h"

namespace millwright::evaluation {

class ReductionSlot {
 public:
  ReductionSlot(const machine::Axis& axis, const PriceBook& prices);
  /// Adds the slot to the drive's tables, if the axis states a reduction.
  void add_to(std::vector<SlotTable>& tables);

  /// Its place among the slots of the drive; none where the motor drives directly.
  [[nodiscard]] std::optional<std::size_t> slot() const { return slot_; }
  [[nodiscard]] bool is(std::size_t slot) const { return slot_ == slot; }
  [[nodiscard]] double shaft(solver::Row row) const { return reductions_[row].shaft; }
  /// Smallest and largest ratio, 1 without a reduction.
  [[nodiscard]] double least_ratio() const { return least_ratio_; }
  [[nodiscard]] double largest_ratio() const { return largest_ratio_; }

  /// Adds to the readings of a set of reductions what is read of it here.
  void read(std::span<const solver::Row> rows, std::vector<scalar::Interval>& readings) const {
    for (std::size_t field = 0; field < readings_.front().size(); ++field)
      readings.push_back(range_of(rows, [&](solver::Row row) { return readings_[row][field]; }));
  }

  template <class T>
  [[nodiscard]] machine::DriveReduction<T> reading(Alive rows) const {
    machine::DriveReduction<T> result;
    if (!slot_) return result;
    const RowsAlive& alive = rows[*slot_];
    result.present = true;
    std::size_t field = 0;
    const auto read = [&](T& x) {
      x = hull_of<T>(alive, total_count + field, [&](solver::Row row) { return readings_[row][field]; });
      ++field;
    };
    visit_reduction_reading(result, read);
    result.torque_is_rated = stated(alive, [](const machine::Reduction& r) { return r.rated_torque.has_value(); });
    result.speed_is_rated = stated(alive, [](const machine::Reduction& r) { return r.largest_speed.has_value(); });
    return result;
  }

 private:
  template <class States>
  [[nodiscard]] machine::Applies stated(std::span<const solver::Row> alive, States&& states) const {
    const bool first = states(reductions_[alive.front()]);
    for (const solver::Row row : alive)
      if (states(reductions_[row]) != first) return machine::Applies::some;
    return first ? machine::Applies::yes : machine::Applies::no;
  }

  std::vector<machine::Reduction> reductions_;
  SlotTable table_{"reduction", 0};
  std::vector<std::vector<double>> readings_;
  std::optional<std::size_t> slot_;
  double least_ratio_ = 1.0, largest_ratio_ = 1.0;
};

}  // namespace millwright::evaluation
