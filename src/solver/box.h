// SPDX-License-Identifier: Apache-2.0
//
// A set of designs of one stage as the search keeps it: the rows alive of each slot and an interval for each continuous
// variable. Row sets are immutable and shared: a child of a split differs from its parent in a few slots only and keeps
// the others by reference.
//
// `Desk` is the working place of one thread: the spans and answers that asking a stage needs, allocated once.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/stage.h"

namespace millwright::solver {

using RowSet = std::shared_ptr<const std::vector<Row>>;  ///< ascending, never empty

struct Region {
  std::vector<RowSet> rows;
  std::vector<Interval> variables;

  [[nodiscard]] bool one_design_per_slot() const {
    for (const RowSet& set : rows) {
      if (set->size() != 1) return false;
    }
    return true;
  }
  [[nodiscard]] double combinations() const {
    double product = 1.0;
    for (const RowSet& set : rows) product *= static_cast<double>(set->size());
    return product;
  }
};

/// Every row of every slot and the whole range of every variable.
inline Region whole_region(const Stage& stage) {
  Region region;
  for (const Slot& slot : stage.slots()) {
    std::vector<Row> rows(slot.rows);
    for (Row row = 0; row < slot.rows; ++row) rows[row] = row;
    region.rows.push_back(std::make_shared<const std::vector<Row>>(std::move(rows)));
  }
  for (const Variable& variable : stage.variables()) region.variables.emplace_back(variable.lower, variable.upper);
  return region;
}

inline RowSet only(Row row) { return std::make_shared<const std::vector<Row>>(1, row); }

class Desk {
 public:
  /// The answers of the latest question.
  Answer<Interval> interval;
  Answer<double> number;
  std::uint64_t bounds = 0;  ///< how often `bound` or `slopes` was asked
  std::uint64_t evaluations = 0;

  const Answer<Interval>& bound(const Stage& stage,
                                std::span<const Row> shared,
                                std::span<const Interval> inherited,
                                const Region& region) {
    return bound(stage, shared, inherited, region, region.variables);
  }
  /// As above with other intervals for the variables.
  const Answer<Interval>& bound(const Stage& stage,
                                std::span<const Row> shared,
                                std::span<const Interval> inherited,
                                const Region& region,
                                std::span<const Interval> variables) {
    ++bounds;
    stage.bound(box(shared, inherited, region, variables), interval);
    return interval;
  }
  const Answer<Interval>& slopes(const Stage& stage,
                                 std::span<const Row> shared,
                                 std::span<const Interval> inherited,
                                 const Region& region,
                                 Input input) {
    ++bounds;
    stage.slopes(box(shared, inherited, region, region.variables), input, interval);
    return interval;
  }
  const Answer<double>& evaluate(const Stage& stage, const Point& point) {
    ++evaluations;
    stage.evaluate(point, number);
    return number;
  }
  const Answer<double>& gradient(const Stage& stage, const Point& point, Input input) {
    ++evaluations;
    stage.gradient(point, input, number);
    return number;
  }

 private:
  Box box(std::span<const Row> shared,
          std::span<const Interval> inherited,
          const Region& region,
          std::span<const Interval> variables) {
    spans_.clear();
    for (const RowSet& set : region.rows) spans_.emplace_back(*set);
    return Box{shared, inherited, spans_, variables};
  }

  std::vector<std::span<const Row>> spans_;
};

/// The largest entry, 0 for none; NaN counts as infinite.
inline double worst_of(std::span<const double> utilisation) {
  double worst = 0.0;
  for (const double u : utilisation) {
    if (!(u <= worst)) worst = u == u ? u : std::numeric_limits<double>::infinity();
  }
  return worst;
}
/// A lower bound of the worst utilisation of every design: above 1 proves that none is feasible.
inline double worst_lower(std::span<const Interval> utilisation) {
  double worst = 0.0;
  for (const Interval& u : utilisation) {
    if (u.lower > worst) worst = u.lower;
  }
  return worst;
}

}  // namespace millwright::solver
