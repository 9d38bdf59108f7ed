// SPDX-License-Identifier: Apache-2.0
// Columns of somebody's table that speak of the figures of another one: where they come from, how sure they are, within
// which tolerance they hold (companions.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "catalogue/import_mapping.h"

namespace millwright::catalogue {

/// Whether a header speaks of a column of the family instead of naming one: "Holding torque tolerance (%)", "Quelle
/// Haltemoment", "rotor_inertia_confidence". Where its table has that figure, and the figure can have that said of it,
/// it becomes a companion, else it is kept: "price_tolerance" is neither a price nor its breaks.
bool names_companion(std::string_view header, Family family);

/// The companion that a name of ours stands for ("rotor_inertia_tolerance"); none if it is not one of the family.
std::optional<ImportCompanion> companion_named(std::string_view name, Family family);

/// Among the columns that are no figures themselves, finds those that speak of one which the table has. `units`: the
/// row of units below the header, empty if there is none.
void take_companions(const ImportChoices& choices,
                     const std::vector<std::string>& units,
                     ImportMapping& mapping,
                     text::Diagnostics& diagnostics);

/// Whether a unit can be that of a tolerance of the figure: "%", or one of the figure. Its spelling of ours; none, and
/// why, if not.
std::optional<std::string> tolerance_unit(std::string_view words, Column figure, std::string& reason);

/// The tolerance in a cell as our file has it: without signs before it, with a decimal point, and with the unit that
/// stands in the cell where the column has none. Empty where the cell says that it is not known; none, and why, if it
/// is no tolerance.
std::optional<std::string> tolerance_cell(std::string_view cell,
                                          const SourceColumn& column,
                                          DecimalMark usual,
                                          std::string& reason);

}  // namespace millwright::catalogue
