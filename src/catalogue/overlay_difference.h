// SPDX-License-Identifier: Apache-2.0
// What changed between the stock files, suppliers and offers of two catalogues: lines that came, went or say something
// else. A line is known by the part, the supplier or both that it names, as written; of several places on one side the
// later one's line counts. The parts that lines name need not be among the catalogues.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "text/diagnostic.h"

namespace millwright::catalogue {

/// A cell of a line that is not the same in both; numbers are compared as numbers.
struct LineCell {
  std::string column;  ///< with the unit of its header
  std::string a, b;    ///< as written; empty where a side does not give it
};

struct LineChange {
  std::string title;                  ///< "OMC 17HS19, Shop A"; of a line without a name "(no name)"
  text::SourceSpan a_where, b_where;  ///< without text where a side has no such line
  std::vector<LineCell> cells;        ///< of a line that both have
};

/// Of one kind of file. Lines ascend by what they name.
struct FileDifference {
  std::string file;  ///< "stock.csv"
  std::vector<LineChange> added, removed, changed;
  std::size_t same = 0;
  [[nodiscard]] bool equal() const { return added.empty() && removed.empty() && changed.empty(); }
};

/// The files that one of both has. Reported: what cannot be read, a file that does not name what its lines are about, a
/// line that stands twice.
std::vector<FileDifference> overlay_difference(const std::vector<std::filesystem::path>& a,
                                               const std::vector<std::filesystem::path>& b,
                                               text::Diagnostics& diagnostics);

}  // namespace millwright::catalogue
