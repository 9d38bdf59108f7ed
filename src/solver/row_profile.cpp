// SPDX-License-Identifier: Apache-2.0
#include "solver/row_profile.h"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace millwright::solver {
namespace {

/// Nearly the logarithm to base 2: exact at powers of two, a straight line between them.
double nearly_log2(double x) {
  constexpr double fraction = 0x1p-52, bias = 1023.0;
  return static_cast<double>(std::bit_cast<std::int64_t>(x)) * fraction - bias;
}

double nearly_log(double x) { return std::numbers::ln2 * nearly_log2(x); }

/// Utilisations are compared as logarithms, between one per mille and a thousand.
double log_utilisation(double u) { return nearly_log(std::clamp(u == u ? u : 1e3, 1e-3, 1e3)); }

/// Numbers are kept and compared four at a time.
using Four = Eigen::Array4f;
constexpr std::size_t at_once = 4;
std::size_t in_fours(std::size_t numbers) { return (numbers + at_once - 1) / at_once * at_once; }

/// Least and largest of each of `width` numbers among rows; `width` is a multiple of four.
struct Ranges {
  std::vector<float> low, high;

  /// `of_row(row)`: where the numbers of a row lie side by side.
  template <class OfRow>
  void find(std::span<const Row> rows, std::size_t width, OfRow&& of_row) {
    low.resize(width);
    high.resize(width);
    for (std::size_t first = 0; first < width; first += at_once) {
      Four least = Four::Map(of_row(rows.front()) + first);
      Four most = least;
      for (const Row row : rows) {
        const Four own = Four::Map(of_row(row) + first);
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

double finite(double x) { return std::clamp(x == x ? x : 0.0, -1e30, 1e30); }

}  // namespace

/// Of a set of rows: the ranges of their numbers, and the halves that they were cut into last.
struct RowNotes {
  Ranges ranges;
  std::size_t number = 0;
  RowSet left = nullptr, right = nullptr;
};

RowProfile::RowProfile(const Stage& stage, std::span<const Row> shared)
    : stage_(&stage), shared_(shared), features_(stage.slots().size()) {}

namespace {

/// What is compared of an answer: scores, then of each constraint the least and the largest utilisation as logarithms.
void compare(std::span<const double> score, const Answer<Interval>& answer, std::vector<double>& numbers) {
  numbers.clear();
  for (const double value : score) numbers.push_back(finite(value));
  for (const Interval& u : answer.utilisation) {
    numbers.push_back(log_utilisation(u.lower));
    numbers.push_back(log_utilisation(u.upper));
  }
}

/// What a change of 1 in each of them weighs. A utilisation's least value decides whether a set can be left out, its
/// largest only whether a constraint need not be looked at any more. (Chosen by trial on machines and stacks: good on
/// the whole, not the best for each.)
std::vector<double> weights(std::span<const double> score_scale, std::size_t constraints) {
  constexpr double of_score = 0.5, of_other_scores = 0.125, of_least = 1.0, of_largest = 0.25;
  std::vector<double> weights;
  for (const double scale : score_scale)
    weights.push_back((weights.empty() ? of_score : of_other_scores) / std::max(std::fabs(scale), 1e-12));
  for (std::size_t c = 0; c < constraints; ++c) weights.insert(weights.end(), {of_least, of_largest});
  return weights;
}

}  // namespace

void RowProfile::find(const Region& region, std::size_t slot, std::span<const double> score_scale, const Asked& asked) {
  Features& features = features_[slot];
  features = {};
  weigh(features, *region.rows[slot], weights(score_scale, stage_->constraints()), score_scale.size(), asked);
  take_numbers(features, slot, *region.rows[slot]);
}

void RowProfile::weigh(Features& features,
                       const Rows& rows,
                       std::span<const double> weight,
                       std::size_t scores,
                       const Asked& asked) const {
  constexpr double little = 1e-6;
  std::vector<Interval> readings(rows.alive().readings.begin(), rows.alive().readings.end());
  std::vector<double> score(scores), low, high;
  for (std::size_t r = 0; r < readings.size(); ++r) {
    const Interval whole = readings[r];
    if (!(whole.upper > whole.lower) || !std::isfinite(whole.upper - whole.lower)) continue;
    Number number{.reading = r, .logarithmic = whole.lower > 0.0};
    const double cut = number.logarithmic
                           ? std::clamp(std::sqrt(whole.lower) * std::sqrt(whole.upper), whole.lower, whole.upper)
                           : middle(whole);
    readings[r] = {whole.lower, cut};
    compare(score, asked({rows.all(), readings}, score), low);
    readings[r] = {cut, whole.upper};
    compare(score, asked({rows.all(), readings}, score), high);
    readings[r] = whole;
    double most = 0.0;
    for (std::size_t i = 0; i < low.size(); ++i) {
      const double change = weight[i] * std::fabs(high[i] - low[i]);
      if (!(change > little)) continue;
      most = std::max(most, change);
      if (i < scores)
        number.of_score = true;
      else
        number.constraints |= std::uint64_t{1} << (((i - scores) / 2) % 64);
    }
    const double spread =
        number.logarithmic ? nearly_log(whole.upper) - nearly_log(whole.lower) : whole.upper - whole.lower;
    if (!(most > 0.0) || !(spread > 0.0)) continue;
    number.weight = most / (0.5 * spread);
    features.of.push_back(number);
  }
}

void RowProfile::take_numbers(Features& features, std::size_t slot, const Rows& rows) const {
  features.width = in_fours(features.of.size());
  features.place.resize(rows.all().back() + std::size_t{1});
  features.numbers = std::make_shared_for_overwrite<float[]>(rows.size() * features.width);
  float* out = features.numbers.get();
  std::uint32_t place = 0;
  std::vector<Interval> readings;
  for (const Row& row : rows) {
    stage_->read(shared_, slot, std::span(&row, 1), readings);
    // Of a single row a stage may read less than of several (what it works out exactly when it is asked): then these
    // numbers say nothing.
    const bool alike = readings.size() == rows.alive().readings.size();
    features.place[row] = place++;
    for (const Number& number : features.of) {
      const double value = alike ? middle(readings[number.reading]) : 1.0;
      *out++ = static_cast<float>(number.logarithmic ? nearly_log(value) : finite(value));
    }
    out = std::fill_n(out, features.width - features.of.size(), 0.0F);
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
    const auto of_row = [&](Row row) { return features.of_row(row); };
    std::shared_ptr<const RowNotes> notes = rows.size() < worth_notes ? nullptr : rows.notes.load();
    if (rows.size() < worth_notes) {
      here.find(rows.all(), features.width, of_row);
    } else if (notes == nullptr) {
      auto made = std::make_shared<RowNotes>();
      made->ranges.find(rows.all(), features.width, of_row);
      notes = std::move(made);
      rows.notes.store(notes);
    }
    const Ranges& ranges = notes != nullptr ? notes->ranges : here;
    for (std::size_t i = 0; i < features.of.size(); ++i) {
      const Number& number = features.of[i];
      if (!matters(number, open)) continue;
      const double size = number.weight * (static_cast<double>(ranges.high[i]) - static_cast<double>(ranges.low[i]));
      if (size * worth[slot] > best_size) {
        best_size = size * worth[slot];
        best = {slot, i, 0.5F * ranges.low[i] + 0.5F * ranges.high[i], size};
      }
    }
  }
  return best;
}

RowProfile::Halves RowProfile::halves(std::span<const Row> rows, const Cut& cut) const {
  const Features& features = features_[cut.slot];
  const auto goes_left = [&](Row row) { return cut.size > 0.0 && features.of_row(row)[cut.number] <= cut.at; };
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
  return {std::move(left), std::move(right)};
}

RowProfile::Split RowProfile::read(std::size_t slot, Halves halves) const {
  return {slot,
          make_rows(*stage_, shared_, slot, std::move(halves.left)),
          make_rows(*stage_, shared_, slot, std::move(halves.right))};
}

RowProfile::Halves RowProfile::cut_slot(std::span<const Row> rows, std::size_t slot, std::uint64_t open) const {
  const Features& features = features_[slot];
  Ranges ranges;
  ranges.find(rows, features.width, [&](Row row) { return features.of_row(row); });
  Cut best{slot, 0, 0.0F, 0.0};
  for (std::size_t i = 0; i < features.of.size(); ++i) {
    if (!matters(features.of[i], open)) continue;
    const double size =
        features.of[i].weight * (static_cast<double>(ranges.high[i]) - static_cast<double>(ranges.low[i]));
    if (size > best.size) best = {slot, i, 0.5F * ranges.low[i] + 0.5F * ranges.high[i], size};
  }
  return halves(rows, best);
}

RowProfile::Split RowProfile::split_slot(const Rows& rows, std::size_t slot, std::uint64_t open) const {
  return read(slot, cut_slot(rows.all(), slot, open));
}

RowProfile::Split RowProfile::split(const Region& region, std::uint64_t open, std::span<const double> worth) const {
  const Cut cut = best_cut(region, open, worth);
  const Rows& rows = *region.rows[cut.slot];
  if (rows.size() < worth_notes || !(cut.size > 0.0)) return read(cut.slot, halves(rows.all(), cut));
  const std::shared_ptr<const RowNotes> notes = rows.notes.load();
  if (notes->left != nullptr && notes->number == cut.number) return {cut.slot, notes->left, notes->right};
  Split split = read(cut.slot, halves(rows.all(), cut));
  rows.notes.store(std::make_shared<const RowNotes>(RowNotes{notes->ranges, cut.number, split.left, split.right}));
  return split;
}

}  // namespace millwright::solver
