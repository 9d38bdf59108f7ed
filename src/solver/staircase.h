// SPDX-License-Identifier: Apache-2.0
//
// Fronts in two scores, as sets of points of which none is at least as good as another in both, ascending in the first
// and falling in the second. They serve as bounds:
//
//     rest     every completion of a label adds at least some point of this set       (lower bounds, sum of stages)
//     corners  a total can change the known front only if it is below some corner of it
//     useful   = corners minus rest: a label can matter only if it is below some point of this set
#pragma once

#include <cstddef>
#include <vector>

namespace millwright::solver {

struct Pair {
  double first = 0.0, second = 0.0;
};

/// Keeps the points that no other is at least as good as, smaller being better; ascending in `first`.
std::vector<Pair> lower_staircase(std::vector<Pair> points);
/// Keeps the points that no other lies above in both; ascending in `first`, falling in `second`.
std::vector<Pair> upper_staircase(std::vector<Pair> points);

/// Every sum of a point of `a` and one of `b`, as a lower staircase of at most `most` points: neighbours beyond that
/// are merged into their common lower bound.
std::vector<Pair> sum_of_staircases(const std::vector<Pair>& a, const std::vector<Pair>& b, std::size_t most);
/// Every difference `upper` - `lower`, as an upper staircase.
std::vector<Pair> difference_of_staircases(const std::vector<Pair>& upper,
                                           const std::vector<Pair>& lower,
                                           std::size_t most);

/// Whether some point of an upper staircase is at least (first, second) in both.
bool below_staircase(const std::vector<Pair>& upper, double first, double second);
/// The least first of a lower staircase whose second is at most this; infinity where there is none.
double least_within(const std::vector<Pair>& lower, double second);

}  // namespace millwright::solver
