// SPDX-License-Identifier: Apache-2.0
// Numbers as people type them, and what they may have meant when it is none.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace millwright::text {

enum class DecimalMark { point, point_or_comma };

/// A finite decimal number that fills the whole of `text` (blanks and tabs around it allowed): sign, digits, decimal
/// mark, exponent. No thousands separators, hexadecimal, infinity or NaN, nothing beyond the range of double.
std::optional<double> parse_number(std::string_view text, DecimalMark mark = DecimalMark::point);

/// Where a number is looked for: in a cell of a table, or by itself (an option, a value of a problem file).
enum class NumberPlace { cell, alone };

/// Why `text` is no number and what to write instead ("letter O where a zero was meant: 10.5"); a general hint if
/// nothing better is known.
std::string number_hint(std::string_view text, NumberPlace place = NumberPlace::cell);

}  // namespace millwright::text
