// SPDX-License-Identifier: Apache-2.0
// How far a figure can be trusted, read from what the catalogue says about where it comes from.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace millwright::catalogue {

/// published: read from a maker's or shop's table. remembered: general knowledge of a data sheet, not re-read.
/// computed: by a simplified model (a solid cylinder for a pulley). estimated: assumed, interpolated, typical.
/// unstated: nothing is said.
enum class Standing { unstated, published, remembered, computed, estimated };

/// The standing that a basis text ("datasheet", "family_estimate +-25 %", "computed: d - 0.83*ball diameter")
/// expresses.
Standing standing_of(std::string_view basis);

/// The word of the closed list (high, medium, low) that a confidence cell says, upper and lower case alike; none if it
/// says another one.
std::optional<std::string_view> confidence_word(std::string_view cell);

/// The word that is allowed and near what a cell says, or all that are: for the hint of a diagnostic.
std::string confidence_hint(std::string_view cell);

/// Whether a figure has to be shown as an estimate: estimated or computed ones, and those that nothing better is said
/// about than that the row's confidence is low.
bool counts_as_estimate(Standing standing, std::string_view confidence);

/// The relative tolerance that a basis text states ("+-30 %" is 0.3); NaN if it states none.
double stated_tolerance(std::string_view basis);

/// "published", "estimated", ...
std::string_view to_string(Standing standing);

}  // namespace millwright::catalogue
