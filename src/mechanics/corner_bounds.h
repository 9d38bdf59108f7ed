// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scalar/dual.h"
#include "scalar/interval.h"

/// Exact ranges for formulas whose naive interval is useless because an argument occurs several times: where the
/// result is known (proved in the formula's comment) to rise or fall with each argument, its range over a box is
/// spanned by its values in two corners.
namespace millwright::mechanics::corner_bounds {

struct Rising {
  scalar::Interval range;
  scalar::Interval at_least() const { return {range.lower}; }
  scalar::Interval at_most() const { return {range.upper}; }
};

struct Falling {
  scalar::Interval range;
  scalar::Interval at_least() const { return {range.upper}; }
  scalar::Interval at_most() const { return {range.lower}; }
};

/// The range of `function` (generic, evaluated on point intervals, so rounding is covered) over the box.
template <class Function, class... Direction>
scalar::Interval between_corners(Function function, const Direction&... directions) {
  const scalar::Interval least = function(directions.at_least()...);
  const scalar::Interval most = function(directions.at_most()...);
  return {least.lower, most.upper};
}

/// All arguments of a formula that is stated for positive numbers only are positive.
template <class... Ranges>
bool all_positive(const Ranges&... ranges) {
  return ((ranges.lower > 0.0) && ...);
}

/// The dual result of the naive formula, its value cut down to the better enclosure.
template <int N>
scalar::Dual<scalar::Interval, N> with_value(scalar::Dual<scalar::Interval, N> naive, const scalar::Interval& value) {
  naive.value = scalar::Interval(value.lower > naive.value.lower ? value.lower : naive.value.lower,
                                 value.upper < naive.value.upper ? value.upper : naive.value.upper);
  return naive;
}

}  // namespace millwright::mechanics::corner_bounds
