// SPDX-License-Identifier: Apache-2.0
// What changed between two catalogues: parts that came, went or have other figures. Neither the order of rows nor the
// units of headers count; a torque curve is one part with many points.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "catalogue/companions.h"

namespace millwright::catalogue {

/// Numbers that are the same but for the rounding of a conversion (126 N.cm, 1.26 N.m): to 1e-12 of the larger one, in
/// whatever unit. What is not known (NaN) is the same as what is not known.
bool same_value(double a, double b);

/// A cell that is not the same in both.
struct CellChange {
  Column column;
  std::string point;      ///< of a curve: "300 rpm"; empty for a plain part, and for what changed at every point alike
  std::string a, b;       ///< as cell_text() has it; empty where a side does not give it
  double relative = 0.0;  ///< (b - a) / |a|; NaN where that means nothing: texts, other currencies, nothing before
  /// Of the cell; of the row, or of a companion the figure, where a side has no such column; without text: no such row.
  text::SourceSpan a_where, b_where;
  /// What changed is what is said of the figure (companions.h), not the figure.
  std::optional<CompanionKind> companion = std::nullopt;
};

/// The name of the column that changed: `rotor_inertia`, or `rotor_inertia_tolerance`.
std::string changed_column(const CellChange& change);

/// A part of both with cells that are not the same; a point that only one side has is a changed cell too.
struct PartChange {
  int a_row, b_row;  ///< of a curve its first point
  int a_points, b_points;
  std::vector<CellChange> cells;  ///< in the order of the columns; of a curve, first what changed everywhere
};

/// Of one family. Parts ascend by manufacturer, part number and what else tells them apart.
struct FamilyDifference {
  Family family;
  std::vector<int> added;    ///< rows of b; of a curve its first point
  std::vector<int> removed;  ///< rows of a
  std::vector<PartChange> changed;
  int same = 0;  ///< parts
  bool equal() const { return added.empty() && removed.empty() && changed.empty(); }
};

FamilyDifference difference(const Table& a, const Table& b);

/// The families that one of both has parts of, or only the one that is asked for.
std::vector<FamilyDifference> difference(const Catalogue& a, const Catalogue& b, std::optional<Family> only = {});

/// Maker, part number and what else tells the part from others: "Acme M1 (24 V, 2 A, TB6600, half)".
std::string part_title(const Table& table, int row);

}  // namespace millwright::catalogue
