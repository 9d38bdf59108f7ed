// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string_view>

namespace millwright::catalogue {

/// What the cells of a column hold. `money` is a number in the currency of its row, per `unit` ("" a piece, "1/m",
/// "1/kg").
enum class Kind { number, text, flag, money };

/// required: a row without it is refused. expected: lint reports it missing. optional: may be absent.
enum class Need { required, expected, optional };

/// How a column takes part in saying which row this is. Rows that agree in every `group` and `point` column are
/// duplicates; an overlay replaces all rows that agree in the `group` columns (so a new torque curve replaces the old
/// one as a whole).
enum class Identity { none, group, point };

/// One column of a part family, declared once: reader, lint, list and show follow from it.
struct ColumnDeclaration {
  std::string_view name;
  Kind kind = Kind::text;
  std::string_view
      unit;  ///< Customary unit (shown, and the dimension that a header's unit must have); memory holds SI.
  Need need = Need::optional;
  double lower =
      -std::numeric_limits<double>::infinity();  ///< Plausible range in `unit`; outside it lint doubts the value.
  double upper = std::numeric_limits<double>::infinity();
  std::string_view meaning;
  std::string_view
      basis;  ///< Text column of the same family that says where this figure comes from; "" = the row's confidence.
  Identity identity = Identity::none;
};

/// A number column.
constexpr ColumnDeclaration number(std::string_view name,
                                   std::string_view unit,
                                   Need need,
                                   double lower,
                                   double upper,
                                   std::string_view meaning,
                                   std::string_view basis = {},
                                   Identity identity = Identity::none) {
  return {name, Kind::number, unit, need, lower, upper, meaning, basis, identity};
}

/// A text column.
constexpr ColumnDeclaration text(std::string_view name,
                                 Need need,
                                 std::string_view meaning,
                                 Identity identity = Identity::none) {
  ColumnDeclaration column;
  column.name = name;
  column.need = need;
  column.meaning = meaning;
  column.identity = identity;
  return column;
}

/// A column of yes or no.
constexpr ColumnDeclaration flag(std::string_view name, Need need, std::string_view meaning) {
  ColumnDeclaration column = text(name, need, meaning);
  column.kind = Kind::flag;
  return column;
}

/// A price column, `unit` as for Kind::money.
constexpr ColumnDeclaration money(std::string_view name, std::string_view unit, std::string_view meaning) {
  ColumnDeclaration column = text(name, Need::optional, meaning);
  column.kind = Kind::money;
  column.unit = unit;
  column.lower = 0;
  column.upper = 1e6;
  column.basis = "price_basis";
  return column;
}

}  // namespace millwright::catalogue
