// SPDX-License-Identifier: Apache-2.0
#include "evaluation/bar_packing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace millwright::evaluation {
namespace {

constexpr double rounding = 1e-9;  // of a bar

/// Pieces as shares of a bar, with the saw's cut behind each: a bar holds a sum of 1.
class Packing {
 public:
  Packing(std::vector<double> shares, bool search) : shares_(std::move(shares)) {
    first_fit();
    least_ = lower_bound();
    if (search && bars_ > least_) {
      room_.assign(shares_.size(), 1.0);
      bar_.assign(shares_.size(), 0);
      place(0, 0);
      searched_ = steps_ <= most_steps;
    }
  }
  [[nodiscard]] const std::vector<std::size_t>& bars_of_pieces() const { return best_; }
  [[nodiscard]] std::size_t bars() const { return bars_; }
  /// Nothing needs fewer, or every way that could need fewer was tried.
  [[nodiscard]] bool is_fewest() const { return bars_ <= least_ || searched_; }

 private:
  static constexpr std::size_t most_steps = 200'000;

  void first_fit() {
    std::vector<double> room;
    for (const double share : shares_) {
      std::size_t bar = 0;
      while (bar < room.size() && share > room[bar] + rounding) ++bar;
      if (bar == room.size()) room.push_back(1.0);
      room[bar] -= share;
      best_.push_back(bar);
    }
    bars_ = room.size();
  }

  /// Weights that add up to no more than 1 on any bar, whatever is cut from it, add up to no more than the bars: the
  /// shares themselves, and shares rounded to parts of a bar (dual feasible functions, Fekete and Schepers 2001).
  [[nodiscard]] std::size_t lower_bound() const {
    double most = std::accumulate(shares_.begin(), shares_.end(), 0.0);
    for (int parts = 1; parts <= 30; ++parts) {
      double sum = 0.0;
      for (const double share : shares_) {
        const double whole = (parts + 1) * share;
        const bool is_whole = std::abs(whole - std::round(whole)) < 1e-8;  // there the function keeps the share
        sum += is_whole ? std::min(share, std::round(whole) / (parts + 1)) : std::floor(whole) / parts;
      }
      most = std::max(most, sum);
    }
    // Pieces longer than half a bar have one each, and of the shorter ones each bar takes what is left.
    for (const double small : shares_) {
      if (small > 0.5) continue;
      double sum = 0.0;
      for (const double share : shares_) sum += share > 1.0 - small + rounding ? 1.0 : share >= small ? share : 0.0;
      most = std::max(most, sum);
    }
    return static_cast<std::size_t>(std::ceil(most - 1e-6));
  }

  /// Puts the pieces from `piece` on into `used` bars and more, the longest first.
  bool place(std::size_t piece, std::size_t used) {
    if (piece == shares_.size()) {
      bars_ = used;
      best_ = bar_;
      return bars_ == least_;
    }
    if (++steps_ > most_steps) return true;
    // Of equal pieces the later one goes no further to the front.
    const bool again = piece > 0 && shares_[piece] == shares_[piece - 1];
    for (std::size_t bar = again ? bar_[piece - 1] : 0; bar <= used && bar + 1 < bars_; ++bar) {
      if (bar < used && shares_[piece] > room_[bar] + rounding) continue;
      const bool tried =
          bar < used && std::find(room_.begin(), room_.begin() + static_cast<std::ptrdiff_t>(bar), room_[bar]) !=
                            room_.begin() + static_cast<std::ptrdiff_t>(bar);
      if (tried && !again) continue;
      room_[bar] -= shares_[piece];
      bar_[piece] = bar;
      const bool done = place(piece + 1, std::max(used, bar + 1));
      room_[bar] = bar + 1 > used ? 1.0 : room_[bar] + shares_[piece];
      if (done) return true;
    }
    return false;
  }

  std::vector<double> shares_;  // descending
  std::vector<std::size_t> best_, bar_;
  std::vector<double> room_;
  std::size_t bars_ = 0, least_ = 0, steps_ = 0;
  bool searched_ = false;
};

}  // namespace

BarPlan cut_from_bars(std::span<const double> lengths, const BarSize& bar) {
  std::vector<std::size_t> order(lengths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
  std::vector<double> shares;
  for (const std::size_t piece : order)
    shares.push_back(std::min(1.0, (lengths[piece] + bar.cutting_loss) / (bar.stock_length + bar.cutting_loss)));
  const Packing packing(std::move(shares), lengths.size() <= pieces_searched);
  BarPlan plan{std::vector<std::vector<std::size_t>>(packing.bars()), packing.is_fewest()};
  for (std::size_t i = 0; i < order.size(); ++i) plan.bars[packing.bars_of_pieces()[i]].push_back(order[i]);
  return plan;
}

}  // namespace millwright::evaluation
