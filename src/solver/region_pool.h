// SPDX-License-Identifier: Apache-2.0
//
// The regions that cover the designs of a stage at one state, refined wherever some weighing of a score and of what is
// handed on is least. What `bound` says of a region does not depend on the weights, so what one weighing has refined
// serves the next.
#pragma once

#include <functional>

#include "solver/split_worth.h"
#include "solver/stage_plan.h"

namespace millwright::solver {

/// Scores and what is handed on, at these weights. What has no weight may be unbounded.
inline double priced(const Bounds& bounds, const Mix& mix, std::span<const double> weight) {
  double value = mix.of(bounds.score);
  for (std::size_t c = 0; c < weight.size(); ++c) {
    if (weight[c] > 0.0) value += weight[c] * bounds.handed_on[c].lower;
  }
  return value;
}

class RegionPool {
 public:
  /// At the best state that can arrive, or another that no label's is better than.
  RegionPool(const StagePlan& plan, std::vector<Interval> inherited);

  using Useful = std::function<bool(const Bounds&)>;
  [[nodiscard]] const std::vector<Interval>& inherited() const { return inherited_; }

  struct Least {
    double value = 0.0;             ///< infinity: no design is feasible
    std::vector<double> handed_on;  ///< there
  };
  /// What a region adds, coordinate by coordinate.
  using Key = std::function<std::vector<double>(const Bounds&)>;
  /// Refines at most so many regions, in ascending order of the weighed sum of their coordinates, where no single
  /// design is at least as good in all; leaves out what `useful` says no to. False when nothing is left.
  bool refine_front(
      const Key& key, std::span<const double> weights, const Useful& useful, std::size_t most_nodes, Desk& desk);
  /// What is left, ascending in the first score.
  [[nodiscard]] std::vector<OpenRegion> regions() const;
  /// Leaves out what `useful` says no to, refining what it does not. False when nothing is left.
  bool keep_only(const Useful& useful, Desk& desk);
  /// Tells the bounds of everything that is left.
  template <class Told>
  void for_each(Told&& told) const {
    for (const Part& part : parts_)
      if (part.alive) told(part.open.bounds);
  }
  /// The least of every component that what is left hands on.
  [[nodiscard]] std::vector<double> least_handed_on() const;
  /// To the rows that are left.
  void narrow(Region& region) const;
  /// A lower bound of scores + weight * handed on over all feasible designs; weights are not negative.
  Least least(const Mix& mix, std::span<const double> weight, Desk& desk);

 private:
  /// Of a heap that has the least first.
  struct Entry {
    double value = 0.0;
    std::size_t index = 0;
    bool operator<(const Entry& other) const {
      return value != other.value ? value > other.value : index < other.index;
    }
  };
  struct Part {
    OpenRegion open;
    bool bounded = false;
    bool undecided = false;  ///< a single design that could not be proved infeasible
    bool alive = true;
  };
  /// Offers the numbers of what a part became.
  template <class Offer>
  void refine(std::size_t index, const Useful& useful, Desk& desk, Offer&& offer);
  bool bound(Part& part, const Useful& useful, Desk& desk) const;

  const StagePlan* plan_;
  std::vector<Interval> inherited_;
  SplitWorth worth_;
  std::vector<Part> parts_;
};

}  // namespace millwright::solver
