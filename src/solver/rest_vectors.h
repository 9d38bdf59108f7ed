// SPDX-License-Identifier: Apache-2.0
//
// What stages add in several things at once: two scores, and what they take of allowances that they share
// (rest_plane.h). A price says something of a sum and a staircase of one allowance; a set of vectors says it of all of
// them together: every design adds, coordinate by coordinate, at least what some vector of the set says.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "solver/staircase.h"

namespace millwright::solver {

/// Vectors of equal size; smaller is better in every coordinate.
class VectorSet {
 public:
  VectorSet() = default;
  explicit VectorSet(std::size_t dimensions) : dimensions_(dimensions) {}

  [[nodiscard]] std::size_t dimensions() const { return dimensions_; }
  [[nodiscard]] std::size_t size() const { return dimensions_ == 0 ? 0 : values_.size() / dimensions_; }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] std::span<const double> operator[](std::size_t i) const {
    return {values_.data() + i * dimensions_, dimensions_};
  }
  void add(std::span<const double> vector) { values_.insert(values_.end(), vector.begin(), vector.end()); }
  /// The least of each coordinate; infinity where there is nothing.
  [[nodiscard]] std::vector<double> least() const;

 private:
  std::size_t dimensions_ = 0;
  std::vector<double> values_;
};

/// Those than which no other is at least as good in every coordinate, in ascending order; neighbours are merged into
/// their common lower bound until there are no more than `most`.
VectorSet lower_vectors(const VectorSet& all, std::size_t most);

using KeepsVector = std::function<bool(std::span<const double>)>;
/// Of every sum of a vector of `a` and one of `b` that `keep` says yes to, the lower vectors.
VectorSet sum_of_vectors(const VectorSet& a, const VectorSet& b, std::size_t most, const KeepsVector& keep);

/// What all stages after one add at least, with what is handed to them.
struct RestVectors {
  std::vector<double> limit;             ///< [allowance]
  std::vector<std::vector<double>> use;  ///< [allowance][component]: of the state, none negative
  VectorSet add;                         ///< two scores, then of each allowance; empty: nothing is known

  /// Tells every vector that is within what this state leaves of the allowances. `lower(component)`: the least that is
  /// handed on. `told` says no to stop; then this says no.
  template <class Lower, class Told>
  bool for_each_within(Lower&& lower, Told&& told) const {
    std::vector<double> left(limit);
    for (std::size_t a = 0; a < left.size(); ++a)
      for (std::size_t c = 0; c < use[a].size(); ++c)
        if (use[a][c] > 0.0) left[a] -= use[a][c] * lower(c);
    for (std::size_t i = 0; i < add.size(); ++i) {
      const std::span<const double> vector = add[i];
      std::size_t a = 0;
      while (a < left.size() && vector[2 + a] <= left[a]) ++a;
      if (a == left.size() && !told(vector)) return false;
    }
    return true;
  }
  /// Whether some of them lead from these scores to a total below some corner of an upper staircase.
  template <class Lower>
  [[nodiscard]] bool reach(const Pair& score, Lower&& lower, const std::vector<Pair>& corners) const {
    return !for_each_within(lower, [&](std::span<const double> vector) {
      return !below_staircase(corners, score.first + vector[0], score.second + vector[1]);
    });
  }
  /// The least weighted sum of such a total; infinity where there is none.
  template <class Weights, class Lower>
  [[nodiscard]] double least(const Weights& mix,
                             const Pair& score,
                             Lower&& lower,
                             const std::vector<Pair>& corners) const {
    double least = std::numeric_limits<double>::infinity();
    for_each_within(lower, [&](std::span<const double> vector) {
      const std::array<double, 2> sum{score.first + vector[0], score.second + vector[1]};
      if (below_staircase(corners, sum[0], sum[1])) least = std::min(least, mix.of(sum));
      return true;
    });
    return least;
  }
};

}  // namespace millwright::solver
