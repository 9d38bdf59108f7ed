// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "catalogue/column.h"
#include "catalogue/drive_columns.h"
#include "catalogue/structure_columns.h"

namespace millwright::catalogue {

/// The part families, named as their folders.
enum class Family : std::uint8_t {
  steppers,
  stepper_curves,
  ball_screws,
  lead_screws,
  lead_nuts,
  threads,
  screws,
  support_bearings,
  couplings,
  linear_guides,
  belts,
  pulleys,
  racks,
  pinions,
  drivers,
  power_supplies,
  extrusions,
  steel_sections,
  materials
};
inline constexpr std::size_t family_count = 19;

/// One family: what it is, its own columns (beside those of every family), and which prices a row has to give (all of
/// `needs_prices`; none for what is not for sale).
struct FamilyDeclaration {
  Family family;
  std::string_view name;
  std::string_view title;
  std::span<const ColumnDeclaration> columns;
  bool priced_per_piece = false;
  bool priced_per_length = false;
  bool priced_per_mass = false;
  constexpr bool priced() const { return priced_per_piece || priced_per_length || priced_per_mass; }
};

inline constexpr std::array<FamilyDeclaration, family_count> families = {{
    {Family::steppers, "steppers", "stepper motors", columns::steppers, true, false, false},
    {Family::stepper_curves, "stepper_curves", "pull-out torque curves", columns::stepper_curves, false, false, false},
    {Family::ball_screws, "ball_screws", "ball screws with nut", columns::ball_screws, true, true, false},
    {Family::lead_screws, "lead_screws", "lead screws", columns::lead_screws, false, true, false},
    {Family::lead_nuts, "lead_nuts", "nuts for lead screws", columns::lead_nuts, true, false, false},
    {Family::threads, "threads", "ISO metric threads", columns::threads, false, false, false},
    {Family::screws, "screws", "fasteners", columns::screws, true, false, false},
    {Family::support_bearings,
     "support_bearings",
     "screw supports and bearings",
     columns::support_bearings,
     true,
     false,
     false},
    {Family::couplings, "couplings", "shaft couplings", columns::couplings, true, false, false},
    {Family::linear_guides, "linear_guides", "linear guides", columns::linear_guides, true, true, false},
    {Family::belts, "belts", "timing belts", columns::belts, false, true, false},
    {Family::pulleys, "pulleys", "timing pulleys", columns::pulleys, true, false, false},
    {Family::racks, "racks", "toothed racks", columns::racks, false, true, false},
    {Family::pinions, "pinions", "pinions for racks", columns::pinions, true, false, false},
    {Family::drivers, "drivers", "stepper drivers", columns::drivers, true, false, false},
    {Family::power_supplies, "power_supplies", "power supplies", columns::power_supplies, true, false, false},
    {Family::extrusions, "extrusions", "aluminium profiles", columns::extrusions, false, true, false},
    {Family::steel_sections, "steel_sections", "steel sections", columns::steel_sections, false, true, false},
    {Family::materials, "materials", "materials", columns::materials, false, false, true},
}};

/// The declaration of a family.
constexpr const FamilyDeclaration& declaration(Family family) { return families[static_cast<std::size_t>(family)]; }

/// A column of a family: an index into the columns of every family followed by the family's own.
struct Column {
  Family family;
  std::uint8_t index;
  friend constexpr bool operator==(const Column&, const Column&) = default;
};

inline constexpr std::size_t shared_columns = std::size(columns::every_family);

/// How many columns the family has, shared ones included.
constexpr std::size_t column_count(Family family) { return shared_columns + declaration(family).columns.size(); }

/// The declaration of a column.
constexpr const ColumnDeclaration& declaration(Column column) {
  return column.index < shared_columns ? columns::every_family[column.index]
                                       : declaration(column.family).columns[column.index - shared_columns];
}

/// The column of that name, if the family has one.
constexpr std::optional<Column> find_column(Family family, std::string_view name) {
  for (std::size_t index = 0; index < column_count(family); ++index) {
    const Column column{family, static_cast<std::uint8_t>(index)};
    if (declaration(column).name == name) return column;
  }
  return std::nullopt;
}

/// Whether a column belongs to whoever wrote the file: it is kept there, and nobody reads or doubts it.
constexpr bool is_own_column(std::string_view name) { return name.starts_with("x_"); }

/// The column of that name; `constexpr auto inertia = column(Family::steppers, "rotor_inertia");` does not compile if
/// it is misspelt. Throws std::logic_error at run time.
constexpr Column column(Family family, std::string_view name) {
  const std::optional<Column> found = find_column(family, name);
  if (!found) throw std::logic_error("no such catalogue column: " + std::string(name));
  return *found;
}

/// The family of a folder or command line name.
constexpr std::optional<Family> find_family(std::string_view name) {
  for (const FamilyDeclaration& each : families) {
    if (each.name == name) return each.family;
  }
  return std::nullopt;
}

namespace detail {
constexpr bool declarations_are_sound() {
  for (std::size_t i = 0; i < family_count; ++i) {
    const Family family = families[i].family;
    if (static_cast<std::size_t>(family) != i || column_count(family) > 255) return false;
    for (const ColumnDeclaration& each : families[i].columns) {
      if (!each.basis.empty() && !find_column(family, each.basis)) return false;
      if (!(each.lower <= each.upper)) return false;
    }
  }
  return true;
}
static_assert(declarations_are_sound());
}  // namespace detail

}  // namespace millwright::catalogue
