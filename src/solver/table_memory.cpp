// SPDX-License-Identifier: Apache-2.0
#include "solver/table_memory.h"

#include <algorithm>

namespace millwright::solver {

Region TableMemory::whole_region(const Stage& stage, std::span<const Row> shared) {
  Region region;
  for (std::size_t slot = 0; slot < stage.slots().size(); ++slot) {
    const bool everywhere = !stage.reads_shared(slot);
    std::vector<Row> rows = offered_rows(stage, shared, slot);
    std::vector<Whole>& known = tables_[{&stage, slot}].wholes;
    auto whole = std::find_if(known.begin(), known.end(), [&](const Whole& each) {
      return everywhere ? each.rows == rows : std::equal(shared.begin(), shared.end(), each.shared.begin());
    });
    if (whole == known.end()) {
      Whole made{{shared.begin(), shared.end()}, everywhere ? rows : std::vector<Row>(), {}};
      stage.read(shared, slot, rows, made.readings);
      whole = known.insert(known.end(), std::move(made));
    }
    region.rows.push_back(std::make_shared<const Rows>(std::move(rows), whole->readings));
  }
  for (const Variable& variable : stage.variables()) region.variables.emplace_back(variable.lower, variable.upper);
  return region;
}

std::vector<RowSet> TableMemory::parts(const Stage& stage,
                                       std::span<const Row> shared,
                                       std::size_t slot,
                                       const Rows& rows) {
  const Table& table = tables_[{&stage, slot}];
  std::vector<bool> missing(stage.slots()[slot].rows, false);
  for (const Row row : rows) missing[row] = true;
  const bool as_read =
      !stage.reads_shared(slot) || std::equal(shared.begin(), shared.end(), table.shared.begin(), table.shared.end());
  std::vector<RowSet> result;
  const auto add = [&](std::vector<Row> part) {
    if (!part.empty()) result.push_back(make_rows(stage, shared, slot, std::move(part)));
  };
  for (const RowSet& part : table.parts) {
    std::vector<Row> left;
    for (const Row row : *part) {
      if (!missing[row]) continue;
      left.push_back(row);
      missing[row] = false;
    }
    if (as_read && left.size() == part->size())
      result.push_back(part);
    else
      add(std::move(left));
  }
  if (result.empty()) return {};
  std::vector<Row> others;
  for (const Row row : rows)
    if (missing[row]) others.push_back(row);
  add(std::move(others));
  return result;
}

void TableMemory::keep_parts(const Stage& stage,
                             std::span<const Row> shared,
                             std::size_t slot,
                             std::vector<RowSet> parts) {
  Table& table = tables_[{&stage, slot}];
  std::size_t rows = 0;
  for (const RowSet& part : parts) rows += part->size();
  if (rows < table.rows) return;
  table.rows = rows;
  table.parts = std::move(parts);
  table.shared.assign(shared.begin(), shared.end());
}

}  // namespace millwright::solver
