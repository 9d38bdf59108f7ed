// SPDX-License-Identifier: Apache-2.0
// What a file says about single figures: columns beside them, named after them.
//
//   rotor_inertia [g.cm2],rotor_inertia_source,rotor_inertia_confidence,rotor_inertia_tolerance
//   280,measured by pendulum 2026-02,high,8 %
//
// A tolerance is a share of the figure ("25 %", "+-0.25") or a width in its unit ("20 g.cm2"); with a unit in the
// header
// (`rotor_inertia_tolerance [%]`, `[g.cm2]`) its cells are plain numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/family.h"
#include "scalar/unit.h"
#include "text/csv.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

enum class CompanionKind { source, confidence, tolerance };

/// A column of a file that belongs to the figure of another one.
struct Companion {
  Column figure{};
  CompanionKind kind = CompanionKind::source;
  std::size_t field = 0;             ///< of a record
  std::optional<scalar::Unit> unit;  ///< of a tolerance, where the header gives one
};

/// Whether a figure can be off by a share of it. What is counted, chosen to match another part, or a guaranteed
/// minimum is taken as it stands.
bool takes_tolerance(Column column);

/// A header cell that names no column of the family, if it names a companion of one that the file has. Reports one
/// whose figure does not exist, is not in the file, or takes no such companion; `is_companion` says whether the name
/// has the form of one.
std::optional<Companion> match_companion(const text::CsvTable& csv,
                                         std::size_t field,
                                         Family family,
                                         text::Diagnostics& diagnostics);
bool is_companion(std::string_view name);

/// The name of such a column: `rotor_inertia_tolerance`.
std::string companion_name(Column figure, CompanionKind kind);

/// Half the width [SI] of the tolerance that a cell states for a figure [SI]. On failure nothing, and why in `reason`.
std::optional<double> parse_tolerance(std::string_view cell,
                                      const Companion& companion,
                                      double figure,
                                      std::string& reason);

}  // namespace millwright::catalogue
