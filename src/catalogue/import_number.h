// SPDX-License-Identifier: Apache-2.0
// Numbers as shops print them: "1,26", "1.234,50", "178 oz.in", "2.8A", "EUR 24.33", "$ 19". What a comma means is
// never assumed: a number either tells, or it is ambiguous and the rest of its column has to.
#pragma once

#include <string>
#include <string_view>

namespace millwright::catalogue {

enum class DecimalMark { unknown, point, comma };

/// A cell cut into what stands before a number, the number, and what stands behind it; blanks between are dropped.
/// `number` is empty if there is none.
struct CellParts {
  std::string_view before;
  std::string_view number;
  std::string_view after;
};
CellParts cut_cell(std::string_view cell);

/// What the marks in a number tell: nothing (there is none), which one is the decimal mark, or that "1,234" may be
/// either.
enum class MarkEvidence { none, point, comma, ambiguous, contradictory };
MarkEvidence mark_evidence(std::string_view number);

/// The number with a decimal point and without thousands separators, its digits as they are; empty if it is none with
/// that decimal mark. A number without marks needs none.
std::string plain_number(std::string_view number, DecimalMark mark);

/// Whether a cell says that a value is not known: "-", "n/a", "tbd".
bool says_unknown(std::string_view cell);

}  // namespace millwright::catalogue
