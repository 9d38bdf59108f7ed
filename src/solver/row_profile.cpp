// SPDX-License-Identifier: Apache-2.0
#include "solver/row_profile.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {
namespace {

/// Utilisations are compared as logarithms, between one per mille and a thousand.
float log_utilisation(double u) { return static_cast<float>(std::log(std::clamp(u == u ? u : 1e3, 1e-3, 1e3))); }

float finite(double x) { return static_cast<float>(std::clamp(x == x ? x : 0.0, -1e30, 1e30)); }

}  // namespace

RowProfile::RowProfile(const Stage& stage, std::span<const Row> shared, std::size_t scores)
    : stage_(&stage),
      shared_(shared),
      scores_(scores),
      width_(scores + 2 * stage.constraints()),
      features_(stage.slots().size()) {}

void RowProfile::record(
    std::size_t slot, Row row, std::size_t rows, std::span<const double> score, const Answer<Interval>& answer) {
  std::vector<float>& table = features_[slot];
  table.resize(rows * width_);
  float* out = table.data() + row * width_;
  for (const double value : score) *out++ = finite(value);
  for (const Interval& u : answer.utilisation) {
    *out++ = log_utilisation(u.lower);
    *out++ = log_utilisation(u.upper);
  }
}

void RowProfile::finish(const Region& region, std::span<const double> score_scale) {
  // A doubling of a utilisation weighs as much as two thirds of the whole score.
  constexpr double score_weight = 1.0;
  weight_.assign(width_, 1.0);
  for (std::size_t k = 0; k < scores_; ++k) {
    weight_[k] = score_weight / std::max(std::fabs(score_scale[k]), 1e-12);
    if (k > 0) weight_[k] *= 0.25;
  }
  relevant_.resize(features_.size());
  for (std::size_t slot = 0; slot < features_.size(); ++slot) {
    for (std::size_t index = 0; index < width_; ++index) {
      float middle = 0.0F;
      if (spread(region, slot, index, middle) > 1e-6) relevant_[slot].push_back(static_cast<std::uint16_t>(index));
    }
  }
}

double RowProfile::spread(const Region& region, std::size_t slot, std::size_t index, float& middle) const {
  float low = std::numeric_limits<float>::infinity();
  float high = -low;
  const float* column = features_[slot].data() + index;
  for (const Row row : *region.rows[slot]) {
    const float value = column[row * width_];
    low = std::min(low, value);
    high = std::max(high, value);
  }
  middle = 0.5F * low + 0.5F * high;
  return weight_[index] * (static_cast<double>(high) - static_cast<double>(low));
}

RowProfile::Split RowProfile::split(const Region& region, std::uint64_t open) const {
  double largest = 0.0;
  std::size_t chosen_slot = region.rows.size();
  std::size_t chosen_index = 0;
  float cut = 0.0F;
  for (std::size_t slot = 0; slot < region.rows.size(); ++slot) {
    if (region.rows[slot]->size() < 2) continue;
    if (chosen_slot == region.rows.size()) chosen_slot = slot;  // in case nothing differs any more
    for (const std::size_t index : relevant_[slot]) {
      if (index >= scores_ && ((open >> (((index - scores_) / 2) % 64)) & 1U) == 0) continue;
      float middle = 0.0F;
      const double size = spread(region, slot, index, middle);
      if (size > largest) {
        largest = size;
        chosen_slot = slot;
        chosen_index = index;
        cut = middle;
      }
    }
  }
  const std::vector<Row>& rows = region.rows[chosen_slot]->all();
  std::vector<Row> left;
  std::vector<Row> right;
  for (const Row row : rows) {
    const bool low = largest > 0.0 ? feature(chosen_slot, row, chosen_index) <= cut : left.size() < rows.size() / 2;
    (low ? left : right).push_back(row);
  }
  if (left.empty() || right.empty()) {  // the spread is below the resolution of the middle
    left.assign(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2));
    right.assign(rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2), rows.end());
  }
  return {chosen_slot,
          make_rows(*stage_, shared_, chosen_slot, std::move(left)),
          make_rows(*stage_, shared_, chosen_slot, std::move(right))};
}

}  // namespace millwright::solver
