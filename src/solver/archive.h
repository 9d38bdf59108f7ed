// SPDX-License-Identifier: Apache-2.0
//
// A set of points in which one asks "is some member at most this in every coordinate?". Members are kept in blocks with
// their common lower bound, so that most blocks are passed by after one comparison, and the member that answered last
// is asked first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace millwright::solver {

class Archive {
 public:
  explicit Archive(std::size_t dimensions) : dimensions_(dimensions) {}

  void add(std::span<const double> point) {
    if (size_ % block == 0) least_.insert(least_.end(), dimensions_, std::numeric_limits<double>::infinity());
    double* least = least_.data() + (size_ / block) * dimensions_;
    for (std::size_t d = 0; d < dimensions_; ++d) least[d] = std::min(least[d], point[d]);
    members_.insert(members_.end(), point.begin(), point.end());
    ++size_;
  }

  [[nodiscard]] bool dominates(std::span<const double> point) const {
    if (latest_ < size_ && at_most(members_.data() + latest_ * dimensions_, point)) return true;
    for (std::size_t first = 0; first < size_; first += block) {
      if (!at_most(least_.data() + (first / block) * dimensions_, point)) continue;
      const std::size_t end = std::min(first + block, size_);
      for (std::size_t i = first; i < end; ++i) {
        if (!at_most(members_.data() + i * dimensions_, point)) continue;
        latest_ = i;
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  static constexpr std::size_t block = 32;
  [[nodiscard]] bool at_most(const double* member, std::span<const double> point) const {
    for (std::size_t d = 0; d < dimensions_; ++d) {
      if (member[d] > point[d]) return false;
    }
    return true;
  }

  std::size_t dimensions_;
  std::size_t size_ = 0;
  std::vector<double> members_;  ///< [member * dimensions_ + coordinate]
  std::vector<double> least_;    ///< [block * dimensions_ + coordinate]
  mutable std::size_t latest_ = 0;
};

}  // namespace millwright::solver
