// SPDX-License-Identifier: Apache-2.0
//
// What has been found out about long tables and holds for other combinations of shared choices too: what a stage reads
// of all rows, and the parts of alike rows that a table was cut into when rows without hope were looked for
// (shaving.h). With another supply voltage a part is asked about once more; it need not be found once more.
//
// Belongs to one problem and to one thread.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "solver/box.h"
#include "solver/proved_directions.h"

namespace millwright::solver {

class TableMemory {
 public:
  /// Every row of every slot that can be chosen, in each at least one, and the whole range of every variable. The row
  /// sets are the caller's own (their notes belong to his profile).
  Region whole_region(const Stage& stage, std::span<const Row> shared);

  /// Sets that are together these rows of a slot: the parts that its table was cut into before, and one of the rows
  /// that are in none of them; empty where it was not. Nothing is noted of them (Rows::notes): RowProfile::cut_slot may
  /// cut them, ::split may not.
  std::vector<RowSet> parts(const Stage& stage, std::span<const Row> shared, std::size_t slot, const Rows& rows);
  /// Remembers parts if no others are remembered that have more rows together.
  void keep_parts(const Stage& stage, std::span<const Row> shared, std::size_t slot, std::vector<RowSet> parts);

  /// What a larger problem says of the stages (proved_directions.h), if this one is a part of it.
  DirectionsOf known_directions = {};

 private:
  struct Whole {
    std::vector<Row> shared, rows;
    std::vector<Interval> readings;
  };
  struct Table {
    std::vector<Whole> wholes;
    std::vector<RowSet> parts;
    std::vector<Row> shared;  ///< with which the parts were read
    std::size_t rows = 0;     ///< in all parts
  };
  std::map<std::pair<const Stage*, std::size_t>, Table> tables_;
};

}  // namespace millwright::solver
