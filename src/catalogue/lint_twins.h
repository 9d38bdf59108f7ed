// SPDX-License-Identifier: Apache-2.0
// Rows of one maker that share a size and a rating to the digit have the same balls in other housings (a bush by itself
// and in a block, a carriage with and without flange), so their other rating is the same too. One that differs is odd
// even where it lies within what makers differ by: C for 100 km of travel among others for 50.
#pragma once

#include <vector>

#include "catalogue/lint_row.h"
#include "catalogue/table.h"

namespace millwright::catalogue {

class Twins {
 public:
  /// Looks for twins in `table`, which must outlive this; in families without ball ratings there are none.
  explicit Twins(const Table& table);

  /// Warns if the row contradicts its twins; where two contradict each other, of both.
  void examine(int row, const LintRow& figures) const;

 private:
  struct Contradiction {
    int row;
    int twin;
    Column other;  ///< what differs
    Column same;
  };
  void look(Column size, Column same, Column other);

  const Table& table_;
  std::vector<Contradiction> found_;  ///< by row
};

}  // namespace millwright::catalogue
