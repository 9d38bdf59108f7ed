// SPDX-License-Identifier: Apache-2.0
#include "solver/row_profile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace millwright::solver {
namespace {

/// Nearly the logarithm to base 2: exact at powers of two, a straight line between them.
double nearly_log2(double x) {
  constexpr double fraction = 0x1p-52, bias = 1023.0;
  return static_cast<double>(std::bit_cast<std::int64_t>(x)) * fraction - bias;
}

/// Utilisations are compared as logarithms, between one per mille and a thousand.
float log_utilisation(double u) {
  return static_cast<float>(std::numbers::ln2 * nearly_log2(std::clamp(u == u ? u : 1e3, 1e-3, 1e3)));
}

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
  Features& features = features_[slot];
  if (features.index.empty()) {
    features.index.resize(width_);
    std::iota(features.index.begin(), features.index.end(), std::uint16_t{0});
    features.numbers.resize(rows * width_);
  }
  float* out = features.numbers.data() + row * width_;
  for (const double value : score) *out++ = finite(value);
  for (const Interval& u : answer.utilisation) {
    *out++ = log_utilisation(u.lower);
    *out++ = log_utilisation(u.upper);
  }
}

void RowProfile::find_ranges(const Features& features,
                             const Rows& rows,
                             std::vector<float>& low,
                             std::vector<float>& high) {
  const std::size_t width = features.index.size();
  low.assign(width, std::numeric_limits<float>::infinity());
  high.assign(width, -std::numeric_limits<float>::infinity());
  float* const least = low.data();
  float* const most = high.data();
  for (const Row row : rows) {
    const float* const numbers = features.numbers.data() + row * width;
    for (std::size_t i = 0; i < width; ++i) {
      least[i] = numbers[i] < least[i] ? numbers[i] : least[i];
      most[i] = numbers[i] > most[i] ? numbers[i] : most[i];
    }
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
  std::vector<float> low;
  std::vector<float> high;
  for (std::size_t slot = 0; slot < features_.size(); ++slot) {
    const Features all = std::move(features_[slot]);
    Features& relevant = features_[slot];
    relevant = {};
    find_ranges(all, *region.rows[slot], low, high);
    for (std::size_t i = 0; i < all.index.size(); ++i) {
      const double spread = static_cast<double>(high[i]) - static_cast<double>(low[i]);
      if (weight_[i] * spread > 1e-6) relevant.index.push_back(all.index[i]);
    }
    const std::size_t width = relevant.index.size();
    relevant.numbers.resize((region.rows[slot]->all().back() + std::size_t{1}) * width);
    for (const Row row : *region.rows[slot]) {
      const float* const from = all.numbers.data() + row * width_;
      float* const to = relevant.numbers.data() + row * width;
      for (std::size_t i = 0; i < width; ++i) to[i] = from[relevant.index[i]];
    }
  }
}

RowProfile::Split RowProfile::split(const Region& region, std::uint64_t open) const {
  thread_local std::vector<float> low;
  thread_local std::vector<float> high;
  double largest = 0.0;
  std::size_t chosen_slot = region.rows.size();
  std::size_t chosen = 0;
  float cut = 0.0F;
  for (std::size_t slot = 0; slot < region.rows.size(); ++slot) {
    if (region.rows[slot]->size() < 2) continue;
    if (chosen_slot == region.rows.size()) chosen_slot = slot;  // in case nothing differs any more
    const Features& features = features_[slot];
    find_ranges(features, *region.rows[slot], low, high);
    for (std::size_t i = 0; i < features.index.size(); ++i) {
      const std::size_t index = features.index[i];
      if (index >= scores_ && ((open >> (((index - scores_) / 2) % 64)) & 1U) == 0) continue;
      const double size = weight_[index] * (static_cast<double>(high[i]) - static_cast<double>(low[i]));
      if (size > largest) {
        largest = size;
        chosen_slot = slot;
        chosen = i;
        cut = 0.5F * low[i] + 0.5F * high[i];
      }
    }
  }
  const Features& features = features_[chosen_slot];
  const auto number = [&](Row row) { return features.numbers[row * features.index.size() + chosen]; };
  const std::vector<Row>& rows = region.rows[chosen_slot]->all();
  std::vector<Row> left;
  std::vector<Row> right;
  for (const Row row : rows) {
    const bool goes_left = largest > 0.0 ? number(row) <= cut : left.size() < rows.size() / 2;
    (goes_left ? left : right).push_back(row);
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
