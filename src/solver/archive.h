// SPDX-License-Identifier: Apache-2.0
//
// A set of points in which one asks "is some member at most this in every coordinate?". Members are kept in the leaves
// of a tree, alike ones together, and each part of the tree with the lower bound of all that is in it: a part whose
// bound is above the point in some coordinate is passed by whole. A leaf that has become full is divided in the
// coordinate in which its members differ most.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace millwright::solver {

class Archive {
 public:
  using Name = std::uint32_t;

  explicit Archive(std::size_t dimensions)
      : dimensions_(dimensions),
        least_(dimensions, std::numeric_limits<double>::infinity()),
        highest_(dimensions, -std::numeric_limits<double>::infinity()) {}

  void add(std::span<const double> point, Name name = 0) {
    for (std::size_t d = 0; d < dimensions_; ++d) highest_[d] = std::max(highest_[d], point[d]);
    std::size_t place = 0;
    for (;;) {
      double* const least = least_.data() + place * dimensions_;
      for (std::size_t d = 0; d < dimensions_; ++d) least[d] = std::min(least[d], point[d]);
      if (places_[place].is_leaf()) break;
      place = places_[place].part_of(point);
    }
    Block& block = blocks_[places_[place].block];
    block.points.insert(block.points.end(), point.begin(), point.end());
    block.names.push_back(name);
    ++size_;
    if (block.names.size() > block.most) divide(place);
  }

  /// Whether some member is at most `point`.
  [[nodiscard]] bool dominates(std::span<const double> point) const {
    return any_at_most(point, [](Name) { return true; });
  }
  /// The same of members that are accepted by their names.
  template <class Accepted>
  [[nodiscard]] bool any_at_most(std::span<const double> point, Accepted&& accepted) const {
    return any_leaf(point, [&](std::size_t index) {
      const Block& block = blocks_[index];
      const double* member = block.points.data();
      for (const Name name : block.names) {
        if (at_most(member, point) && accepted(name)) return true;
        member += dimensions_;
      }
      return false;
    });
  }

  /// Removes the member that was added so.
  void remove(std::span<const double> point, Name name) {
    Block& block = blocks_[places_[leaf_of(point)].block];
    const auto found = std::find(block.names.begin(), block.names.end(), name);
    if (found != block.names.end()) erase(block, static_cast<std::size_t>(found - block.names.begin()));
  }
  /// Removes members that are at most `point` where `removed(name)` says so.
  template <class Removed>
  void remove_at_most(std::span<const double> point, Removed&& removed) {
    any_leaf(point, [&](std::size_t index) {
      Block& block = blocks_[index];
      for (std::size_t i = block.names.size(); i-- > 0;) {
        if (at_most(block.points.data() + i * dimensions_, point) && removed(block.names[i])) erase(block, i);
      }
      return false;
    });
  }

  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  static constexpr std::size_t block_size = 32;
  struct Block {
    std::vector<double> points;  ///< [member * dimensions_ + coordinate]
    std::vector<Name> names;
    std::size_t most = block_size;  ///< members
  };
  /// A leaf, or two parts that are told apart by one coordinate.
  struct Place {
    std::size_t block = 0;       ///< of a leaf
    std::size_t coordinate = 0;  ///< else
    double from = 0.0;           ///< of the coordinate, for the second part
    std::size_t first = 0;       ///< part, followed by the second; 0: a leaf

    [[nodiscard]] bool is_leaf() const { return first == 0; }
    [[nodiscard]] std::size_t part_of(std::span<const double> point) const {
      return point[coordinate] < from ? first : first + 1;
    }
  };

  /// Calls `found(block)` for the leaves whose lower bound is at most `point`, until it returns true.
  template <class Found>
  bool any_leaf(std::span<const double> point, Found&& found) const {
    thread_local std::vector<std::size_t> parts;  // left to look at; `found` may ask another archive
    const std::size_t before = parts.size();
    parts.push_back(0);
    while (parts.size() > before) {
      const std::size_t at = parts.back();
      parts.pop_back();
      if (!at_most(least_.data() + at * dimensions_, point)) continue;
      const Place& place = places_[at];
      if (!place.is_leaf()) {
        parts.push_back(place.first + 1);
        parts.push_back(place.first);
      } else if (found(place.block)) {
        parts.resize(before);
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool at_most(const double* member, std::span<const double> point) const {
    for (std::size_t d = 0; d < dimensions_; ++d) {
      if (member[d] > point[d]) return false;
    }
    return true;
  }

  [[nodiscard]] std::size_t leaf_of(std::span<const double> point) const {
    std::size_t at = 0;
    while (!places_[at].is_leaf()) at = places_[at].part_of(point);
    return at;
  }

  void erase(Block& block, std::size_t i) {
    const std::size_t last = block.names.size() - 1;
    std::copy_n(block.points.begin() + static_cast<std::ptrdiff_t>(last * dimensions_),
                dimensions_,
                block.points.begin() + static_cast<std::ptrdiff_t>(i * dimensions_));
    block.points.resize(last * dimensions_);
    block.names[i] = block.names[last];
    block.names.pop_back();
    --size_;
  }

  /// The coordinate in which members of a block differ most, as a share of what all members differ by (of what they are
  /// where some are infinite); dimensions_ where they do not differ.
  [[nodiscard]] std::size_t widest(const Block& block) const {
    std::size_t widest = dimensions_;
    double most = 0.0;
    for (std::size_t d = 0; d < dimensions_; ++d) {
      double low = block.points[d];
      double high = low;
      for (std::size_t i = d; i < block.points.size(); i += dimensions_) {
        low = std::min(low, block.points[i]);
        high = std::max(high, block.points[i]);
      }
      const double all = highest_[d] - least_[d];
      const double share = (high - low) / (std::isfinite(all) ? all : std::max(std::fabs(low), std::fabs(high)));
      if (!(share > most) || !std::isfinite(share)) continue;
      widest = d;
      most = share;
    }
    return widest;
  }

  void divide(std::size_t place) {
    const std::size_t index = places_[place].block;
    const std::size_t coordinate = widest(blocks_[index]);
    if (coordinate == dimensions_) {
      blocks_[index].most *= 2;
      return;
    }
    std::vector<double> values;
    for (std::size_t i = coordinate; i < blocks_[index].points.size(); i += dimensions_)
      values.push_back(blocks_[index].points[i]);
    std::sort(values.begin(), values.end());
    double from = values[values.size() / 2];
    if (from == values.front()) from = *std::upper_bound(values.begin(), values.end(), from);

    const Block whole = std::move(blocks_[index]);
    blocks_[index] = {};
    blocks_.emplace_back();
    places_[place].coordinate = coordinate;
    places_[place].from = from;
    places_[place].first = places_.size();
    places_.push_back({.block = index});
    places_.push_back({.block = blocks_.size() - 1});
    least_.insert(least_.end(), 2 * dimensions_, std::numeric_limits<double>::infinity());
    size_ -= whole.names.size();
    for (std::size_t i = 0; i < whole.names.size(); ++i)
      add(std::span(whole.points).subspan(i * dimensions_, dimensions_), whole.names[i]);
  }

  std::size_t dimensions_;
  std::size_t size_ = 0;
  std::vector<Block> blocks_ = std::vector<Block>(1);
  std::vector<Place> places_ = std::vector<Place>(1);  ///< the first is the whole
  std::vector<double> least_;                          ///< [place * dimensions_ + coordinate] of all that were added
  std::vector<double> highest_;                        ///< [coordinate] likewise
};

}  // namespace millwright::solver
