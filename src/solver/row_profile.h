// SPDX-License-Identifier: Apache-2.0
//
// How to split a set of rows in two so that the halves differ in what matters. The search does not know what a column
// means; it knows what each row does to the answers: with the row fixed and everything else left open, `bound` gives
// the least score, the state handed on and the range of each utilisation. These numbers are the row's profile. A region
// is split in the slot and the number with the largest spread among the rows still alive, at the middle of the spread:
// scores raise the bound of one half, utilisations make sets of alike parts, over which intervals are tight.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/box.h"

namespace millwright::solver {

class RowProfile {
 public:
  RowProfile() = default;
  RowProfile(const Stage& stage, std::span<const Row> shared, std::size_t scores);

  /// Records what `bound` answered with only this row alive in the slot.
  void record(
      std::size_t slot, Row row, std::size_t rows, std::span<const double> score, const Answer<Interval>& answer);
  /// To be called once when all rows are recorded: `score_scale` is what a spread in each score is compared with.
  void finish(const Region& region, std::span<const double> score_scale);

  struct Split {
    std::size_t slot = 0;
    RowSet left = nullptr, right = nullptr;
  };
  /// Not to be called on a region with a single row in every slot. `open` are the constraints still undecided; `worth`
  /// weighs the slots.
  [[nodiscard]] Split split(const Region& region, std::uint64_t open, std::span<const double> worth) const;

 private:
  /// The numbers of one slot's rows, row by row; `finish` keeps those that differ between rows.
  struct Features {
    std::vector<std::uint16_t> index;  ///< what each is: a score, or a constraint's least or largest utilisation
    std::size_t width = 0;             ///< index.size(), rounded up to what is compared at once
    std::vector<float> numbers;        ///< [row * width + i]
  };
  /// Numbers to tell whether a region has to be split there.
  struct Cut {
    std::size_t slot = 0;
    std::size_t number = 0;  ///< of the slot's features
    float at = 0.0F;
    double size = 0.0;  ///< weighed; 0: no number differs
  };
  [[nodiscard]] Cut best_cut(const Region& region, std::uint64_t open, std::span<const double> worth) const;
  [[nodiscard]] Split halves(const Rows& rows, const Cut& cut) const;

  const Stage* stage_ = nullptr;
  std::span<const Row> shared_;
  std::size_t scores_ = 0;
  std::size_t width_ = 0;
  std::vector<Features> features_;  ///< [slot]
  std::vector<double> weight_;      ///< [index]
};

}  // namespace millwright::solver
