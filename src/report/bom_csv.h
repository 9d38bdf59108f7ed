// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "evaluation/ledger.h"

namespace millwright::report {

/// The design as a bill of materials that `check` reads back to the very same design: parts with cut lengths, then
/// dimensions and settings. Numbers that decide a check are written with all the digits they need; a ramp of
/// 0.30000000000000004 s is 0.3 s where no check is so near its limit that the last bit could matter.
std::string bom_csv(const evaluation::Design& design);

/// A CSV cell, quoted where it must be (separators, quotes, line ends, blanks at its ends, a leading #).
std::string csv_cell(std::string_view text);

/// `si` as text in `unit`, or in `si_unit` where the detour through `unit` would change a bit: "820 mm".
std::string exact_quantity(double si, std::string_view unit, std::string_view si_unit);

}  // namespace millwright::report
