// SPDX-License-Identifier: Apache-2.0
//
// Boxes of the continuous variables of one design, kept in the order in which they are looked at.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solver/labels.h"

namespace millwright::solver {

constexpr double narrowest = 1e-12;  ///< of a variable's range: a narrower side is not halved

struct VariableBox {
  std::vector<Interval> side;
  double value = 0.0;  ///< the smaller, the sooner
  Bounds bounds = {};
  OpenBox::Origin origin = 0;
  /// [variable]: of those that are divided by themselves (relief.h) what is left of the side, ascending; none: all.
  std::vector<std::vector<Interval>> parts = {};
};

struct LaterBox {
  bool operator()(const VariableBox& a, const VariableBox& b) const { return a.value > b.value; }
};

class BoxHeap {
 public:
  void push(VariableBox box) {
    boxes_.push_back(std::move(box));
    std::push_heap(boxes_.begin(), boxes_.end(), LaterBox{});
  }
  VariableBox pop() {
    std::pop_heap(boxes_.begin(), boxes_.end(), LaterBox{});
    VariableBox box = std::move(boxes_.back());
    boxes_.pop_back();
    return box;
  }
  [[nodiscard]] bool empty() const { return boxes_.empty(); }
  [[nodiscard]] const std::vector<VariableBox>& all() const { return boxes_; }

 private:
  std::vector<VariableBox> boxes_;
};

/// The side that is widest relative to the variable's range; box.size() where none is wider than `least`.
inline std::size_t widest_side(const Stage& stage, std::span<const Interval> box, double least = narrowest) {
  double most = least;
  std::size_t widest = box.size();
  for (std::size_t v = 0; v < box.size(); ++v) {
    const Variable& variable = stage.variables()[v];
    const double range = variable.upper - variable.lower;
    const double size = range > 0.0 ? (box[v].upper - box[v].lower) / range : 0.0;
    if (size > most) {
      most = size;
      widest = v;
    }
  }
  return widest;
}

inline std::pair<std::vector<Interval>, std::vector<Interval>> halves(std::span<const Interval> box, std::size_t side) {
  std::pair<std::vector<Interval>, std::vector<Interval>> result{{box.begin(), box.end()}, {box.begin(), box.end()}};
  const double cut = middle(box[side]);
  result.first[side].upper = cut;
  result.second[side].lower = cut;
  return result;
}

inline std::vector<double> middle_of(std::span<const Interval> box) {
  std::vector<double> x;
  for (const Interval& side : box) x.push_back(middle(side));
  return x;
}

/// What a box and the region that it is in have in common. (Where the region has been cut since a box was left open
/// nothing is feasible, and what is known of the region, such as its groups, holds nowhere else.)
inline std::optional<std::vector<Interval>> common_part(std::span<const Interval> box,
                                                        std::span<const Interval> region) {
  std::vector<Interval> common;
  for (std::size_t v = 0; v < box.size(); ++v) {
    const auto side = intersect(box[v], region[v]);
    if (!side) return std::nullopt;
    common.push_back(*side);
  }
  return common;
}

}  // namespace millwright::solver
