// SPDX-License-Identifier: Apache-2.0
#include "catalogue/companions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "catalogue/column_unit.h"
#include "catalogue/header.h"
#include "text/characters.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

struct Suffix {
  std::string_view text;
  CompanionKind kind;
};
constexpr std::array<Suffix, 3> suffixes = {{{"_source", CompanionKind::source},
                                             {"_confidence", CompanionKind::confidence},
                                             {"_tolerance", CompanionKind::tolerance}}};

const Suffix* suffix_of(std::string_view name) {
  for (const Suffix& each : suffixes)
    if (name.size() > each.text.size() && name.ends_with(each.text)) return &each;
  return nullptr;
}

bool is_figure(Column column) {
  const Kind kind = declaration(column).kind;
  return kind == Kind::number || kind == Kind::money;
}

std::vector<std::string_view> figures_of(Family family) {
  std::vector<std::string_view> names;
  for (std::size_t index = 0; index < column_count(family); ++index) {
    const Column each{family, static_cast<std::uint8_t>(index)};
    if (is_figure(each)) names.push_back(declaration(each).name);
  }
  return names;
}

bool is_relative(const scalar::Unit& unit) { return unit.dimension() == scalar::dimension::none; }

}  // namespace

bool takes_tolerance(Column column) {
  const ColumnDeclaration& declared = declaration(column);
  if (declared.kind != Kind::number || declared.identity != Identity::none) return false;
  // Standards guarantee what materials bear; threads are standard geometry.
  if (column.family == Family::materials || column.family == Family::threads) return false;
  constexpr std::array<std::string_view, 26> exact = {"step_angle",
                                                      "phases_on",
                                                      "starts",
                                                      "teeth",
                                                      "turns_per_circuit",
                                                      "circuits",
                                                      "module",
                                                      "pressure_angle",
                                                      "pitch",
                                                      "lead",
                                                      "minimum_pulley_teeth",
                                                      "maximum_microsteps",
                                                      "pack_size",
                                                      "owned_quantity",
                                                      "piece_length",
                                                      "output_voltage",
                                                      "rating_distance",
                                                      "bore",
                                                      "belt_width",
                                                      "shaft_diameter",
                                                      "stock_length",
                                                      "cutting_loss",
                                                      "minimum_bore",
                                                      "maximum_bore",
                                                      "nominal_diameter",
                                                      "size"};
  if (std::find(exact.begin(), exact.end(), declared.name) != exact.end()) return false;
  return !(column.family == Family::belts && declared.name == "width");
}

bool is_companion(std::string_view name) { return suffix_of(name) != nullptr; }

std::string companion_name(Column figure, CompanionKind kind) {
  const auto suffix =
      std::find_if(suffixes.begin(), suffixes.end(), [&](const Suffix& each) { return each.kind == kind; });
  return fmt::format("{}{}", declaration(figure).name, suffix->text);
}

std::optional<Companion> match_companion(const text::CsvTable& csv,
                                         std::size_t field,
                                         Family family,
                                         text::Diagnostics& diagnostics) {
  const text::CsvColumn& cell = csv.columns()[field];
  const Suffix& suffix = *suffix_of(cell.name);
  const std::string_view stem = std::string_view(cell.name).substr(0, cell.name.size() - suffix.text.size());
  const std::optional<Column> figure = find_column(family, stem);
  if (!figure || !is_figure(*figure)) {
    diagnostics.error(cell.name_span,
                      fmt::format("{} have no figure {} that {} could belong to",
                                  declaration(family).name,
                                  text::in_quotes(stem),
                                  text::in_quotes(cell.name)),
                      text::did_you_mean(stem, figures_of(family), "a column of your own begins with x_"));
    return std::nullopt;
  }
  if (!csv.find_column(stem)) {
    diagnostics.error(cell.name_span,
                      fmt::format("{} without the column {}", text::in_quotes(cell.name), text::in_quotes(stem)),
                      fmt::format("add {}, or leave {} out", header_cell(*figure), cell.name));
    return std::nullopt;
  }
  Companion companion{*figure, suffix.kind, field, std::nullopt};
  if (suffix.kind != CompanionKind::tolerance) return companion;
  if (!takes_tolerance(*figure)) {
    diagnostics.error(cell.name_span,
                      fmt::format("{} of {} takes no tolerance", stem, declaration(family).name),
                      "prices, counts, sizes that must match and guaranteed minimum values are taken as they stand");
    return std::nullopt;
  }
  if (!cell.unit) return companion;
  std::string reason;
  companion.unit = scalar::Unit::parse(*cell.unit, reason);
  if (companion.unit && (is_relative(*companion.unit) || companion.unit->fits(display_unit(*figure), reason)))
    return companion;
  diagnostics.error(
      cell.unit_span, fmt::format("column '{}': {}", cell.name, reason), fmt::format("for example {} [%]", cell.name));
  return std::nullopt;
}

std::optional<double> parse_tolerance(std::string_view cell,
                                      const Companion& companion,
                                      double figure,
                                      std::string& reason) {
  std::string_view text = text::without_blanks(cell, " \t");
  for (const std::string_view mark : {std::string_view("+-"), std::string_view("+/-"), std::string_view("\u00B1")})
    if (text.starts_with(mark)) text = text::without_blanks(text.substr(mark.size()), " \t");
  double number = 0.0;
  const auto [rest, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || !std::isfinite(number) || number < 0.0) {
    reason = "is no tolerance";
    return std::nullopt;
  }
  const std::string_view written =
      text::without_blanks(text.substr(static_cast<std::size_t>(rest - text.data())), " \t");
  if (!written.empty() && companion.unit) {
    reason = "has a unit, and so has the column";
    return std::nullopt;
  }
  std::optional<scalar::Unit> unit = companion.unit;
  if (!unit) unit = scalar::Unit::parse(written, reason);
  if (!unit) return std::nullopt;
  if (!is_relative(*unit) && !unit->fits(display_unit(companion.figure), reason)) return std::nullopt;
  const double half = is_relative(*unit) ? unit->to_si(number) * std::abs(figure) : unit->to_si(number);
  if (half < std::abs(figure) || half == 0.0) return half;
  reason = "is as large as the figure itself";
  return std::nullopt;
}

}  // namespace millwright::catalogue
