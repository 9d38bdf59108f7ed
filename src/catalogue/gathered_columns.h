// SPDX-License-Identifier: Apache-2.0
// The columns of a file that is read some rows at a time.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "catalogue/table.h"

namespace millwright::catalogue {

class GatheredColumns {
 public:
  /// Of a family with so many columns, with room for so many rows.
  GatheredColumns(std::size_t columns, std::size_t room);

  /// Adds rows to those before. `rows.file` is the same each time, but for more texts that are not verbatim in it.
  void add(const TableColumns& rows);

  TableColumns take() { return std::move(all_); }

 private:
  void add_texts(std::vector<TextCell>& to, const std::vector<TextCell>& rows) const;

  TableColumns all_;
  std::size_t room_;
};

}  // namespace millwright::catalogue
