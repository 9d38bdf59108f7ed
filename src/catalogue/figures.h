// SPDX-License-Identifier: Apache-2.0
// What a part is worth recording of: its prices and figures, without what only says where they come from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "catalogue/table.h"

namespace millwright::catalogue {

/// "holding_torque" is "1.26 N.m"; of a curve "torque at 60 rpm".
struct NamedFigure {
  std::string name;
  std::string value;       ///< as cell_text() has it, to 15 digits
  text::SourceSpan where;  ///< of the cell
};

/// Of a part with these rows (more than one: the points of a curve), in the order of the columns.
std::vector<NamedFigure> figures_of(const Table& table, const std::vector<int>& rows);

/// The rows of the part of that maker, number and title (see part_title()), its points ascending. Empty if there is
/// none.
std::vector<int> rows_of_part(const Table& table,
                              std::string_view manufacturer,
                              std::string_view part_number,
                              std::string_view title);

/// Whether two values say the same: equal texts, or numbers of one unit that agree to 1e-12.
bool same_figure(const std::string& a, const std::string& b);

/// " (+9.1 %)" where both are numbers of one unit; else nothing.
std::string relative_note(const std::string& before, const std::string& after);

}  // namespace millwright::catalogue
