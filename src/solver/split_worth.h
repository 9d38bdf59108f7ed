// SPDX-License-Identifier: Apache-2.0
//
// What it has been worth so far in a search to divide each slot of a stage. A row's profile (row_profile.h) is taken
// with all other slots open; deep in a search, where those have few rows left, it tells little of what a slot still
// decides. So a search learns: a slot whose divisions leave regions out, or bring them nearer to it, is divided before
// others whose rows seem to differ as much. (Pseudo-costs: Benichou et al., Mathematical Programming 1 (1971) 76-94.)
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace millwright::solver {

/// How near a region that is not left out is to being so.
struct Reached {
  double utilisation = 0.0;  ///< least worst
  double value = 0.0;  ///< that is to be small: regions are taken in the ascending order of it, or of a sum with it
};

class SplitWorth {
 public:
  explicit SplitWorth(std::size_t slots) : progress_(slots, as_if), parts_(slots, as_if), worth_(slots, 1.0) {}

  /// [slot]: what a spread of profiles is to be multiplied by.
  [[nodiscard]] std::span<const double> of_slots() const { return worth_; }

  /// A region was divided in this slot. `part`: nothing where it was left out.
  void count(std::size_t slot, const Reached& whole, const std::optional<Reached>& part) {
    progress_[slot] += part ? progress(whole, *part) : 1.0;
    parts_[slot] += 1.0;
    const double share = progress_[slot] / parts_[slot];
    worth_[slot] = std::max(share * share, least_worth);
  }

 private:
  static constexpr double as_if = 2.0;         // before a slot is divided: so many parts, all left out
  static constexpr double least_worth = 0.02;  // no slot is given up for good
  static constexpr double large_rise = 0.25;   // of a value, relative: counts as much as being left out

  /// From 0 to 1: of the way of the utilisation to 1, or of that of the value to a large rise.
  static double progress(const Reached& whole, const Reached& part) {
    const double strain =
        whole.utilisation < 1.0 ? (part.utilisation - whole.utilisation) / (1.0 - whole.utilisation) : 0.0;
    const double rise = (part.value - whole.value) / (large_rise * std::max(std::fabs(whole.value), 1e-12));
    return std::clamp(std::max(strain, rise), 0.0, 1.0);
  }

  std::vector<double> progress_, parts_, worth_;
};

}  // namespace millwright::solver
