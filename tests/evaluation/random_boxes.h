// SPDX-License-Identifier: Apache-2.0
//
// Random sets of designs of a stage, and random members of such a set.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "solver/stage.h"

namespace millwright {

using scalar::Interval;
using solver::Row;

/// One design with the storage its spans point into.
struct SampledPoint {
  std::vector<Row> shared, rows;
  std::vector<double> inherited, variables;
  [[nodiscard]] solver::Point point() const { return {shared, inherited, rows, variables}; }
};

/// A set of designs with the storage its spans point into.
struct SampledBox {
  std::vector<Row> shared;
  std::vector<Interval> inherited, variables;
  std::vector<std::vector<Row>> rows;
  std::vector<solver::RowsAlive> alive;
  std::vector<std::vector<scalar::Interval>> readings;
  const solver::Stage* stage = nullptr;
  [[nodiscard]] solver::Box box(bool with_readings = true) {
    readings.assign(rows.size(), {});
    alive.clear();
    for (std::size_t slot = 0; slot < rows.size(); ++slot) {
      if (with_readings) stage->read(shared, slot, rows[slot], readings[slot]);
      alive.emplace_back(rows[slot], readings[slot]);
    }
    return {shared, inherited, alive, variables};
  }
};

class BoxSampler {
 public:
  BoxSampler(const solver::Stage& stage, std::size_t voltages, std::size_t states, unsigned seed)
      : stage_(stage), voltages_(voltages), states_(states), random_(seed) {}

  SampledBox box() {
    SampledBox b;
    b.stage = &stage_;
    b.shared = {static_cast<Row>(below(voltages_))};
    for (std::size_t i = 0; i < states_; ++i) b.inherited.push_back(range(0.5, 80.0));
    for (const solver::Slot& slot : stage_.slots()) b.rows.push_back(subset(slot.rows));
    for (const solver::Variable& v : stage_.variables()) b.variables.push_back(range(v.lower, v.upper));
    return b;
  }

  SampledPoint point(const SampledBox& b) {
    SampledPoint p;
    p.shared = b.shared;
    for (const Interval& x : b.inherited) p.inherited.push_back(within(x));
    for (const Interval& x : b.variables) p.variables.push_back(within(x));
    for (const auto& alive : b.rows) p.rows.push_back(alive[below(alive.size())]);
    return p;
  }

  /// Ends are drawn too: there a bound is tight.
  double within(const Interval& x) {
    const double u = uniform();
    if (u < 0.15) return x.lower;
    if (u > 0.85) return x.upper;
    return std::clamp(x.lower + uniform() * (x.upper - x.lower), x.lower, x.upper);
  }
  std::size_t below(std::size_t n) {
    return std::min(n - 1, static_cast<std::size_t>(uniform() * static_cast<double>(n)));
  }
  double uniform() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }

 private:
  /// Part of a positive range: a number, a narrow range, a wide one, all of it.
  Interval range(double lower, double upper) {
    const double kind = uniform();
    const double a = lower * std::pow(upper / lower, uniform());
    if (kind < 0.25) return {a, a};
    if (kind > 0.9) return {lower, upper};
    return {a, std::min(upper, a * (1.0 + (kind < 0.6 ? 0.1 : 3.0) * uniform()))};
  }
  std::vector<Row> subset(Row rows) {
    const double kind = uniform();
    std::vector<Row> alive;
    if (kind > 0.93) {
      for (Row r = 0; r < rows; ++r) alive.push_back(r);
      return alive;
    }
    const std::size_t wanted = kind < 0.35 ? 1 : kind < 0.75 ? 2 + below(3) : 5 + below(30);
    // Neighbours in the catalogue are alike, so their hull is tight; strangers give mixed sets.
    const bool neighbours = uniform() < 0.6;
    Row next = static_cast<Row>(below(rows));
    for (std::size_t i = 0; i < wanted; ++i) {
      alive.push_back(next);
      next = neighbours ? (next + 1) % rows : static_cast<Row>(below(rows));
    }
    std::sort(alive.begin(), alive.end());
    alive.erase(std::unique(alive.begin(), alive.end()), alive.end());
    return alive;
  }

  const solver::Stage& stage_;
  std::size_t voltages_, states_;
  std::mt19937_64 random_;
};

}  // namespace millwright
