// SPDX-License-Identifier: Apache-2.0
//
// How to split a set of rows in two so that the halves differ in what matters. The search does not know what a column
// means; it has what the stage reads of each row (Stage::read), and finds out what each reading matters to: with
// everything left open `bound` is asked about its lower and about its upper part, and what changes in scores and in
// utilisations is what a reading weighs. (Nothing is proved from such an answer.) A region is split in the slot and the
// reading with the largest weighed spread among the rows still alive, at the middle of the spread: scores raise the
// bound of one half, utilisations make sets of alike parts, over which intervals are tight.
//
// Rows of a stage that tells no readings are split in the order of the table.
//
// What a profile has found out about splitting a set of rows is noted there (Rows::notes): a set that one profile has
// split must not be given to another.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "solver/box.h"

namespace millwright::solver {

class RowProfile {
 public:
  RowProfile() = default;
  RowProfile(const Stage& stage, std::span<const Row> shared);

  /// What `bound` says of the region with these readings of one slot's rows, and its least scores.
  using Asked = std::function<const Answer<Interval>&(const RowsAlive& rows, std::span<double> score)>;
  /// Weighs the readings of a slot's rows. `score_scale`: what a spread in each score is compared with.
  void find(const Region& region, std::size_t slot, std::span<const double> score_scale, const Asked& asked);

  struct Split {
    std::size_t slot = 0;
    RowSet left = nullptr, right = nullptr;
  };
  /// Not to be called on a region with a single row in every slot. `open` are the constraints still undecided, `worth`
  /// weighs the slots.
  [[nodiscard]] Split split(const Region& region, std::uint64_t open, std::span<const double> worth) const;
  /// Of at least two rows of one slot, by what they differ in most of what matters to scores and `open`. Nothing is
  /// noted: the plan's profile may split the same sets.
  [[nodiscard]] Split split_slot(const Rows& rows, std::size_t slot, std::uint64_t open = ~std::uint64_t{0}) const;

  struct Halves {
    std::vector<Row> left, right;
  };
  /// The same, without reading the halves.
  [[nodiscard]] Halves cut_slot(std::span<const Row> rows, std::size_t slot, std::uint64_t open) const;

 private:
  /// A reading that rows differ in.
  struct Number {
    std::size_t reading = 0;
    bool logarithmic = false;
    bool of_score = false;          ///< it matters to one
    double weight = 0.0;            ///< of a spread of 1
    std::uint64_t constraints = 0;  ///< (modulo 64) that it matters to
  };
  /// The numbers of one slot's rows, row by row.
  struct Features {
    std::vector<Number> of;
    std::size_t width = 0;             ///< of.size(), rounded up to what is compared at once
    std::vector<std::uint32_t> place;  ///< [row]: among those that have numbers
    std::shared_ptr<float[]> numbers;  ///< [place * width + i]
    [[nodiscard]] const float* of_row(Row row) const { return numbers.get() + place[row] * width; }
  };
  /// Numbers to tell whether a region has to be split there.
  struct Cut {
    std::size_t slot = 0;
    std::size_t number = 0;  ///< of the slot's features
    float at = 0.0F;
    double size = 0.0;  ///< weighed; 0: no number differs
  };
  [[nodiscard]] static bool matters(const Number& number, std::uint64_t open) {
    return number.of_score || (number.constraints & open) != 0;
  }
  void weigh(Features& features,
             const Rows& rows,
             std::span<const double> weight,
             std::size_t scores,
             const Asked& asked) const;
  void take_numbers(Features& features, std::size_t slot, const Rows& rows) const;
  [[nodiscard]] Cut best_cut(const Region& region, std::uint64_t open, std::span<const double> worth) const;
  [[nodiscard]] Halves halves(std::span<const Row> rows, const Cut& cut) const;
  [[nodiscard]] Split read(std::size_t slot, Halves halves) const;

  const Stage* stage_ = nullptr;
  std::span<const Row> shared_;
  std::vector<Features> features_;  ///< [slot]
};

}  // namespace millwright::solver
