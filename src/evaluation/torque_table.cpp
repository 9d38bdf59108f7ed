// SPDX-License-Identifier: Apache-2.0
#include "evaluation/torque_table.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/motor_torque.h"

namespace millwright::evaluation {

using scalar::Interval;

namespace {

std::vector<double> with_outer_ranges(std::vector<double> edges) {
  constexpr double beyond = 4.0;  // mostly sets of pinions ask for no more than that
  if (edges.front() > 0.0) edges.insert(edges.begin(), 0.0);
  edges.push_back(beyond * edges.back());
  return edges;
}

/// The largest number of single precision that is not above x.
float single_below(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) <= x ? nearest : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

}  // namespace

TorqueTable::TorqueTable(std::span<const MotorPair> pairs, std::size_t voltages, std::vector<double> speeds)
    : pairs_(pairs), speeds_(with_outer_ranges(std::move(speeds))), modelled_(speeds_) {
  const auto current_of = [&](solver::Row row) { return driver_current(pairs_[row]); };
  std::size_t of_motor = 0;  // first entry of the motor of the row before
  for (solver::Row row = 0; row < pairs_.size(); ++row) {
    if (row > 0 && pairs_[row].motor != pairs_[row - 1].motor) of_motor = row_of_.size();
    const auto alike = std::find_if(row_of_.begin() + static_cast<std::ptrdiff_t>(of_motor),
                                    row_of_.end(),
                                    [&](solver::Row other) { return current_of(other) == current_of(row); });
    entry_.push_back(static_cast<solver::Row>(alike - row_of_.begin()));
    if (alike == row_of_.end()) row_of_.push_back(row);
  }
  known_ = std::make_unique<std::atomic<bool>[]>(voltages * row_of_.size());
  bounds_ = std::make_unique_for_overwrite<float[]>(voltages * row_of_.size() * 2 * ranges());
}

std::size_t TorqueTable::range_of(double speed) const {
  const auto above = std::upper_bound(speeds_.begin(), speeds_.end(), speed);
  return std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - speeds_.begin() - 1, 0)), ranges() - 1);
}

void TorqueTable::work_out(const MotorPair& pair, std::size_t voltage, float* bounds) const {
  const auto note = [&](std::size_t range, double least, double most) {
    bounds[range] = single_below(least);
    bounds[ranges() + range] = single_below(-most);
  };
  // Torque never rises with speed: what it is at the edges bounds it between them.
  thread_local std::vector<Interval> at_edges;
  if (pair.is_modelled(voltage)) {
    modelled_.find(model_figures<Interval>(pair, voltage), driver_current(pair), at_edges);
  } else {
    at_edges.clear();
    for (const double speed : speeds_) at_edges.push_back(available_torque<Interval>(pair, voltage, Interval(speed)));
  }
  for (std::size_t r = 0; r < ranges(); ++r) note(r, at_edges[r + 1].lower, at_edges[r].upper);
}

const float* TorqueTable::bounds_of(std::size_t voltage, solver::Row row) const {
  const std::size_t entry = voltage * row_of_.size() + entry_[row];
  float* const bounds = bounds_.get() + entry * 2 * ranges();
  if (!known_[entry].load(std::memory_order_acquire)) {
    const std::lock_guard lock(working_out_[entry % working_out_.size()]);
    if (!known_[entry].load(std::memory_order_relaxed)) {
      work_out(pairs_[row_of_[entry_[row]]], voltage, bounds);
      known_[entry].store(true, std::memory_order_release);
    }
  }
  return bounds;
}

Interval TorqueTable::hull(std::span<const solver::Row> rows, std::size_t voltage, std::size_t range) const {
  float least = std::numeric_limits<float>::infinity(), least_turned = least;
  visit_unlike(rows, [&](solver::Row row) {
    const float* const bounds = bounds_of(voltage, row);
    least = std::min(least, bounds[range]);
    least_turned = std::min(least_turned, bounds[ranges() + range]);
  });
  return {least, -least_turned};
}

void TorqueTable::read(std::span<const solver::Row> rows, std::size_t voltage, std::vector<Interval>& readings) const {
  const std::size_t first = readings.size();
  readings.resize(first + ranges());
  const auto tell = [&](const float* bounds) {
    for (std::size_t r = 0; r < ranges(); ++r) readings[first + r] = {bounds[r], -bounds[ranges() + r]};
  };
  if (rows.size() == 1) return tell(bounds_of(voltage, rows.front()));  // long tables are read row by row, too
  const auto numbers = static_cast<Eigen::Index>(2 * ranges());
  Eigen::ArrayXf least = Eigen::ArrayXf::Constant(numbers, std::numeric_limits<float>::infinity());
  visit_unlike(rows,
               [&](solver::Row row) { least = least.min(Eigen::ArrayXf::Map(bounds_of(voltage, row), numbers)); });
  tell(least.data());
}

}  // namespace millwright::evaluation
