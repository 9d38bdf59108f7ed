// SPDX-License-Identifier: Apache-2.0
//
// A set of designs of one stage as the search keeps it: the rows alive of each slot and an interval for each continuous
// variable. Row sets are immutable and shared: a child of a split differs from its parent in a few slots only and keeps
// the others by reference, with what the stage reads of them.
//
// `Desk` is the working place of one thread: the spans and answers that asking a stage needs, allocated once.
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "solver/stage.h"

namespace millwright::solver {

struct RowNotes;  // row_profile.cpp

/// Rows of one slot, ascending, never empty, and what the stage reads of them.
class Rows {
 public:
  /// What has been found out about splitting them. Searches begin with the same sets again and again.
  mutable std::atomic<std::shared_ptr<const RowNotes>> notes = nullptr;

  Rows(const Stage& stage, std::span<const Row> shared, std::size_t slot, std::vector<Row> rows)
      : rows_(std::move(rows)) {
    stage.read(shared, slot, rows_, readings_);
  }
  /// With what has been read of them.
  Rows(std::vector<Row> rows, std::vector<Interval> readings)
      : rows_(std::move(rows)), readings_(std::move(readings)) {}
  [[nodiscard]] const std::vector<Row>& all() const { return rows_; }
  [[nodiscard]] RowsAlive alive() const { return {rows_, readings_}; }
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] Row front() const { return rows_.front(); }
  [[nodiscard]] auto begin() const { return rows_.begin(); }
  [[nodiscard]] auto end() const { return rows_.end(); }

 private:
  std::vector<Row> rows_;
  std::vector<Interval> readings_;
};
using RowSet = std::shared_ptr<const Rows>;

inline RowSet make_rows(const Stage& stage, std::span<const Row> shared, std::size_t slot, std::vector<Row> rows) {
  return std::make_shared<const Rows>(stage, shared, slot, std::move(rows));
}
inline RowSet only(const Stage& stage, std::span<const Row> shared, std::size_t slot, Row row) {
  return make_rows(stage, shared, slot, std::vector<Row>(1, row));
}

struct Region {
  std::vector<RowSet> rows;
  std::vector<Interval> variables;

  /// Constraints (modulo 64) that every design in it keeps at all states that the search it belongs to asks about: they
  /// need not be worked out again. A region that is handed to another search has to forget them.
  std::uint64_t kept = 0;

  /// For each end of each variable (modulo the size): so many divisions of the region are waited before slices are
  /// cut off there again.
  std::array<std::uint8_t, 8> patience{};

  /// How often it is divided in its rows, at least, until one of each slot is left.
  [[nodiscard]] double divisions() const {
    double all = 0.0;
    for (const RowSet& set : rows) all += std::log2(static_cast<double>(set->size()));
    return all;
  }
  [[nodiscard]] bool one_design_per_slot() const {
    for (const RowSet& set : rows) {
      if (set->size() != 1) return false;
    }
    return true;
  }
};

/// One row of each slot, with these intervals for the variables.
inline Region region_of(const Stage& stage,
                        std::span<const Row> shared,
                        std::span<const Row> rows,
                        const std::vector<Interval>& variables) {
  Region region;
  for (std::size_t slot = 0; slot < rows.size(); ++slot) region.rows.push_back(only(stage, shared, slot, rows[slot]));
  region.variables = variables;
  return region;
}

/// The rows of a slot that can be chosen with these shared choices.
inline std::vector<Row> offered_rows(const Stage& stage, std::span<const Row> shared, std::size_t slot) {
  std::vector<Row> rows;
  for (Row row = 0; row < stage.slots()[slot].rows; ++row)
    if (stage.offered(shared, slot, row)) rows.push_back(row);
  return rows;
}

/// Whether every slot of every stage has a row that can be chosen with these shared choices.
inline bool all_offered(const Problem& problem, std::span<const Row> shared) {
  for (const Stage* stage : problem.stages)
    for (std::size_t slot = 0; slot < stage->slots().size(); ++slot) {
      bool any = false;
      for (Row row = 0; row < stage->slots()[slot].rows && !any; ++row) any = stage->offered(shared, slot, row);
      if (!any) return false;
    }
  return true;
}

/// Thrown out of whatever asks questions when `Desk::interrupt` says so.
struct OutOfTime {};

class Desk {
 public:
  /// Asked now and then between questions, if set: true throws OutOfTime. For what has no use for half an answer and is
  /// done by one thread: an exception must not leave another.
  std::function<bool()> interrupt;
  /// For what takes long without a question.
  void look_at_time() const {
    if (interrupt && interrupt()) throw OutOfTime{};
  }
  /// The answers of the latest question.
  Answer<Interval> interval;
  Answer<double> number;
  std::vector<Interval> trial;  ///< for whoever asks about parts of a region's variables
  std::uint64_t bounds = 0;     ///< how often `bound` or `slopes` was asked
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
    count_question();
    stage.bound(box(shared, inherited, region, variables), interval);
    return interval;
  }
  /// As above with other rows in one slot.
  const Answer<Interval>& bound_with(const Stage& stage,
                                     std::span<const Row> shared,
                                     std::span<const Interval> inherited,
                                     const Region& region,
                                     std::size_t slot,
                                     const RowsAlive& rows) {
    count_question();
    const Box all = box(shared, inherited, region, region.variables);
    spans_[slot] = rows;
    stage.bound(all, interval);
    return interval;
  }
  const Answer<Interval>& slopes(const Stage& stage,
                                 std::span<const Row> shared,
                                 std::span<const Interval> inherited,
                                 const Region& region,
                                 Input input) {
    count_question();
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
    for (const RowSet& set : region.rows) spans_.push_back(set->alive());
    return Box{shared, inherited, spans_, variables, region.kept};
  }

  void count_question() {
    constexpr std::uint64_t now_and_then = 256;
    if (++bounds % now_and_then == 0) look_at_time();
  }

  std::vector<RowsAlive> spans_;
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
