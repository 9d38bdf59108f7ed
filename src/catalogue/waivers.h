// SPDX-License-Identifier: Apache-2.0
// What the rows of a catalogue are excused from: column `waiver`, "rule: reason", several divided by semicolons.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "catalogue/table.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

class Waivers {
 public:
  /// Reads the waivers of `table`, which must outlive this. A waiver without a reason or of a rule that does not exist
  /// is an error.
  Waivers(const Table& table, text::Diagnostics& diagnostics);

  /// Whether the row is excused from the rule; asking does not count as need.
  bool excuses(int row, std::string_view rule) const;
  /// The same, when the rule has found fault with the row: the waiver is needed.
  bool excuse(int row, std::string_view rule);
  /// Marks those of the row's waivers as needed of whose rule `odd` says that the row is at odds with it.
  template <class Odd>
  void need_where(int row, const Odd& odd) {
    if (of_row_.empty()) return;
    const auto found = of_row_.find(row);
    if (found == of_row_.end()) return;
    for (Waiver& each : found->second) each.needed |= odd(each.rule);
  }
  /// Warns of each waiver that nothing needed.
  void report_unneeded(text::Diagnostics& diagnostics) const;

 private:
  struct Waiver {
    std::string_view rule;
    bool needed = false;
  };
  const Table& table_;
  Column column_;
  std::unordered_map<int, std::vector<Waiver>> of_row_;
  std::vector<int> rows_;  ///< that have waivers, ascending
};

}  // namespace millwright::catalogue
