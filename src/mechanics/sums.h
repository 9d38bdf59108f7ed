// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>

namespace millwright::mechanics {

/// term(0) + term(1) + ... + term(count - 1). Throws std::invalid_argument for an empty sum, which would have no
/// dimension.
template <class Term>
auto sum_of(std::size_t count, Term term) {
  if (count == 0) throw std::invalid_argument("a list of phases or parts is empty");
  auto total = term(std::size_t{0});
  for (std::size_t i = 1; i < count; ++i) total = total + term(i);
  return total;
}

/// The common length of lists that belong together. Throws std::invalid_argument when they differ.
template <class T, class... Lists>
std::size_t common_length(std::span<const T> first, const Lists&... others) {
  if (((others.size() != first.size()) || ...))
    throw std::invalid_argument("lists that belong together differ in length");
  return first.size();
}

/// Elements in series: 1/k is the sum of 1/k_i.
template <class T>
T series_stiffness(std::span<const T> stiffnesses) {
  return 1.0 / sum_of(stiffnesses.size(), [&](std::size_t i) { return T(1.0 / stiffnesses[i]); });
}

}  // namespace millwright::mechanics
