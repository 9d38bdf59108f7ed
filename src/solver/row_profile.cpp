// SPDX-License-Identifier: Apache-2.0
#include "solver/row_profile.h"

#include <Eigen/Core>
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

/// Numbers are kept and compared four at a time.
using Four = Eigen::Array4f;
constexpr std::size_t at_once = 4;
std::size_t in_fours(std::size_t numbers) { return (numbers + at_once - 1) / at_once * at_once; }

/// Least and largest of each of `width` numbers among rows; `width` is a multiple of four.
struct Ranges {
  std::vector<float> low, high;

  void find(std::span<const float> numbers, std::size_t width, const Rows& rows) {
    low.resize(width);
    high.resize(width);
    for (std::size_t first = 0; first < width; first += at_once) {
      const float* const column = numbers.data() + first;
      Four least = Four::Map(column + rows.front() * width);
      Four most = least;
      for (const Row row : rows) {
        const Four own = Four::Map(column + row * width);
        least = least.min(own);
        most = most.max(own);
      }
      Four::Map(low.data() + first) = least;
      Four::Map(high.data() + first) = most;
    }
  }
};

/// Smaller sets are looked at again sooner than their notes are found.
constexpr std::size_t worth_notes = 12;

float finite(double x) { return static_cast<float>(std::clamp(x == x ? x : 0.0, -1e30, 1e30)); }

}  // namespace

/// Of a set of rows: the ranges of their numbers, and the halves that they were cut into last.
struct RowNotes {
  Ranges ranges;
  std::size_t number = 0;
  RowSet left = nullptr, right = nullptr;
};

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
    features.width = in_fours(width_);
    features.numbers.resize(rows * features.width);
  }
  float* out = features.numbers.data() + row * features.width;
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
  Ranges ranges;
  for (std::size_t slot = 0; slot < features_.size(); ++slot) {
    const Features all = std::move(features_[slot]);
    Features& relevant = features_[slot];
    relevant = {};
    ranges.find(all.numbers, all.width, *region.rows[slot]);
    for (std::size_t i = 0; i < all.index.size(); ++i) {
      const double spread = static_cast<double>(ranges.high[i]) - static_cast<double>(ranges.low[i]);
      if (weight_[i] * spread > 1e-6) relevant.index.push_back(all.index[i]);
    }
    relevant.width = in_fours(relevant.index.size());
    relevant.numbers.resize((region.rows[slot]->all().back() + std::size_t{1}) * relevant.width);
    for (const Row row : *region.rows[slot]) {
      const float* const from = all.numbers.data() + row * all.width;
      float* const to = relevant.numbers.data() + row * relevant.width;
      for (std::size_t i = 0; i < relevant.index.size(); ++i) to[i] = from[relevant.index[i]];
    }
  }
}

RowProfile::Cut RowProfile::best_cut(const Region& region, std::uint64_t open, std::span<const double> worth) const {
  thread_local Ranges here;
  Cut best{region.rows.size(), 0, 0.0F, 0.0};
  double best_size = 0.0;
  for (std::size_t slot = 0; slot < region.rows.size(); ++slot) {
    const Rows& rows = *region.rows[slot];
    if (rows.size() < 2) continue;
    if (best.slot == region.rows.size()) best.slot = slot;  // in case nothing differs any more
    const Features& features = features_[slot];
    std::shared_ptr<const RowNotes> notes = rows.size() < worth_notes ? nullptr : rows.notes.load();
    if (rows.size() < worth_notes) {
      here.find(features.numbers, features.width, rows);
    } else if (notes == nullptr) {
      auto made = std::make_shared<RowNotes>();
      made->ranges.find(features.numbers, features.width, rows);
      notes = std::move(made);
      rows.notes.store(notes);
    }
    const Ranges& ranges = notes != nullptr ? notes->ranges : here;
    for (std::size_t i = 0; i < features.index.size(); ++i) {
      const std::size_t index = features.index[i];
      if (index >= scores_ && ((open >> (((index - scores_) / 2) % 64)) & 1U) == 0) continue;
      const double size = weight_[index] * (static_cast<double>(ranges.high[i]) - static_cast<double>(ranges.low[i]));
      if (size * worth[slot] > best_size) {
        best_size = size * worth[slot];
        best = {slot, i, 0.5F * ranges.low[i] + 0.5F * ranges.high[i], size};
      }
    }
  }
  return best;
}

RowProfile::Split RowProfile::halves(const Rows& rows, const Cut& cut) const {
  const Features& features = features_[cut.slot];
  const float* const number = features.numbers.data() + cut.number;
  const auto goes_left = [&](Row row) { return cut.size > 0.0 && number[row * features.width] <= cut.at; };
  std::vector<Row> left;
  std::vector<Row> right;
  const auto leftward = static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), goes_left));
  left.reserve(leftward);
  right.reserve(rows.size() - leftward);
  for (const Row row : rows) (goes_left(row) ? left : right).push_back(row);
  if (left.empty() || right.empty()) {  // no number differs, or by less than the resolution of the middle
    const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
    left.assign(rows.begin(), middle);
    right.assign(middle, rows.end());
  }
  return {cut.slot,
          make_rows(*stage_, shared_, cut.slot, std::move(left)),
          make_rows(*stage_, shared_, cut.slot, std::move(right))};
}

RowProfile::Split RowProfile::split(const Region& region, std::uint64_t open, std::span<const double> worth) const {
  const Cut cut = best_cut(region, open, worth);
  const Rows& rows = *region.rows[cut.slot];
  if (rows.size() < worth_notes || !(cut.size > 0.0)) return halves(rows, cut);
  const std::shared_ptr<const RowNotes> notes = rows.notes.load();
  if (notes->left != nullptr && notes->number == cut.number) return {cut.slot, notes->left, notes->right};
  Split split = halves(rows, cut);
  rows.notes.store(std::make_shared<const RowNotes>(RowNotes{notes->ranges, cut.number, split.left, split.right}));
  return split;
}

}  // namespace millwright::solver
