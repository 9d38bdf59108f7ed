// SPDX-License-Identifier: Apache-2.0
// What usually holds between the figures of a part: products of powers of its columns that hardly vary from part to
// part (torque per volume, mass per envelope, C0/C, ...). Each is declared once, with its usual value, its spread and
// where they come from; plausibility.h judges rows by them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>

#include "catalogue/family.h"

namespace millwright::catalogue {

/// A column and the power it is raised to.
struct Term {
  std::string_view column;
  double exponent = 0.0;
  bool given = false;  ///< taken as it is: rules of its own judge it, and no relation blames it
};

/// One relation. `typical` is the usual value of the product of its terms, each figure in its declared unit. Logarithms
/// of the product scatter about that of `typical` with standard deviation `spread`, so 0.3 means about 30 %. The
/// exponents come from geometry and physics; where those leave a choice (torque grows a little faster than volume) they
/// were rounded from published parts.
struct Relation {
  std::string_view id;  ///< what a waiver names
  std::string_view title;
  double typical;
  double spread;
  double impossible;        ///< beyond this factor from `typical` a finding is an error
  std::string_view origin;  ///< where value and spread come from
  std::array<Term, 6> terms;
  /// Only rows of this kind (see kind_column); "rail*" = every kind that begins so, "!rail" = every other kind.
  std::string_view when = {};

  bool habit = false;  ///< a maker states it the same way in all rows, so one that differs is odd

  /// The terms that are set.
  constexpr std::span<const Term> used() const {
    std::size_t count = 0;
    while (count < terms.size() && !terms[count].column.empty()) ++count;
    return {terms.data(), count};
  }
};

/// The relations of a family; empty if there are none.
std::span<const Relation> relations(Family family);

/// The text column by whose content parts of a family are compared only with their like (the profile of a belt, the
/// role of a bearing); "" if all are alike.
constexpr std::string_view kind_column(Family family) {
  switch (family) {
    case Family::steppers:
      return "frame";
    case Family::lead_screws:
      return "thread_form";
    case Family::lead_nuts:
      return "material";
    case Family::threads:
      return "series";
    case Family::screws:
      return "property_class";
    case Family::support_bearings:
      return "role";
    case Family::couplings:
    case Family::pulleys:
      return "type";
    case Family::linear_guides:
    case Family::drivers:
    case Family::steel_sections:
      return "kind";
    case Family::belts:
      return "profile";
    case Family::materials:
      return "class";
    default:
      return {};
  }
}

/// Whether a relation speaks of rows of that kind.
constexpr bool applies(const Relation& relation, std::string_view kind) {
  if (relation.when.empty()) return true;
  if (relation.when.starts_with('!')) return relation.when.substr(1) != kind;
  if (!relation.when.ends_with('*')) return relation.when == kind;
  return kind.starts_with(relation.when.substr(0, relation.when.size() - 1));
}

namespace detail {

/// For static_assert beside the tables: every column is a number of that family, every figure makes sense.
constexpr bool sound(Family family, std::span<const Relation> table) {
  for (const Relation& each : table) {
    if (each.id.empty() || each.title.empty() || each.origin.empty() || each.used().empty()) return false;
    if (!(each.typical > 0) || !(each.spread > 0) || !(each.impossible > 1)) return false;
    if (!each.when.empty() && kind_column(family).empty()) return false;
    for (const Term& term : each.used()) {
      const auto column = find_column(family, term.column);
      if (!column || term.exponent == 0.0) return false;
      if (declaration(*column).kind != Kind::number && declaration(*column).kind != Kind::money) return false;
    }
  }
  return true;
}

}  // namespace detail

}  // namespace millwright::catalogue
