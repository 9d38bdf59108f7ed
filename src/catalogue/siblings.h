// SPDX-License-Identifier: Apache-2.0
// What the siblings of a row say of it: rows of the same maker and series hold the same ratios far more tightly than
// all parts of a kind do. The row that is judged is left out, so that it shapes neither the middle nor the spread that
// it is held against; both are order statistics, which a few wrong siblings hardly move.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace millwright::catalogue {

/// Groups of rows and, of each group and relation, a few logarithms in order.
class Siblings {
 public:
  /// Rows besides the judged one that must speak of a relation before it is heard.
  static constexpr std::size_t needed = 4;
  /// Rows looked at in a group; more would not make it surer.
  static constexpr std::size_t sample = 32;

  struct View {
    double centre;  ///< the middle of the others
    double spread;  ///< as standard deviation, larger where they are few
    std::size_t count;
  };

  Siblings() = default;
  /// Room for so many relations a group.
  explicit Siblings(std::size_t relations) : relations_(relations) {}

  /// Adds the next group: for each relation what its rows' logarithms are, in any order; the vectors are left empty.
  /// `sampled`: they are some rows of many, so that none of them weighs much and all are seen alike.
  void add_group(std::vector<std::vector<float>>& seen, bool sampled = false);

  /// What the members of a group but one whose logarithm is `own` say of a relation.
  std::optional<View> without(std::uint32_t group, std::size_t relation, double own) const;

 private:
  std::size_t relations_ = 0;
  std::vector<float> values_;
  std::vector<std::uint32_t> ends_;         ///< of each group and relation, into values_
  std::vector<std::optional<View>> views_;  ///< of each relation of the groups that are sampled
  std::vector<std::uint32_t> view_of_;      ///< of each group, the first of its views; none if it is not sampled
};

}  // namespace millwright::catalogue
