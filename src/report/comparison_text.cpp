// SPDX-License-Identifier: Apache-2.0
// Two builds side by side in 80 columns, and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/comparison.h"
#include "report/design_json.h"
#include "report/design_text.h"
#include "report/json_value.h"
#include "report/quantity_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;
using evaluation::PartLine;

namespace {

constexpr const char* nothing = "–";
constexpr std::size_t most_checks = 20;  ///< listed, beside those that fail in one only

std::string percent_text(double a, double b) {
  if (!(std::abs(a) > 0.0) || !std::isfinite(b)) return {};
  const std::string text = signed_text(100.0 * (b - a) / std::abs(a), 1);
  return text == "=" ? "" : text + " %";
}

std::string difference_text(machine::Quantity quantity, double a, double b, const std::string& currency) {
  std::string text = quantity_text(quantity, std::abs(b - a), currency);
  const std::string number = text.substr(0, text.find(' '));
  if (number.find_first_of("123456789") == std::string::npos) return "=";
  return (b > a ? "+" : "-") + text;
}

std::string failed_text(const Design& design, const Style& style) {
  const std::size_t failed = failed_checks(design);
  const std::string text = fmt::format("{} of {}", failed, design.checks.size());
  return failed == 0 ? text : style.bad(text);
}

/// What one looks at first. What one of both did not count is no difference; its JSON has it.
std::string headline(const ComparedBuild& a, const ComparedBuild& b, const Style& style) {
  TextTable table({{""}, {"A", Align::right}, {"B", Align::right}, {"B - A", Align::right}, {"", Align::right}});
  for (const machine::QuantityDeclaration& each : machine::quantities()) {
    const double in_a = a.design.total(each.quantity), in_b = b.design.total(each.quantity);
    if (std::isnan(in_a) || std::isnan(in_b)) continue;
    const auto shown = [&](double value) { return quantity_text(each.quantity, value, a.design.currency); };
    table.add({std::string(each.name),
               shown(in_a),
               shown(in_b),
               difference_text(each.quantity, in_a, in_b, a.design.currency),
               percent_text(in_a, in_b)});
  }
  table.add({"checks that fail", failed_text(a.design, style), failed_text(b.design, style)});
  return table.str(2, style);
}

/// "DFU2505-4", "4 x MGN9H", and the length where that is what differs.
std::string part_cell(const PartLine* part, const PartLine* other) {
  if (part == nullptr) return nothing;
  const bool same_name = other != nullptr && part_name(*part) == part_name(*other);
  const bool same_number = other != nullptr && part->part_number == other->part_number;
  std::string text = same_number && !same_name ? part_name(*part) : part->part_number;
  const bool count_differs = other == nullptr || part->quantity != other->quantity;
  if (count_differs && part->quantity != 1.0) text = scalar::format_number(part->quantity) + " x " + text;
  const bool length_differs = same_name && std::abs(part->length - other->length) > 5e-5;
  if (length_differs) text += ", " + millimetres_text(part->length) + " mm";
  return text;
}

std::string parts_section(const Comparison& comparison, const std::string& currency, const Style& style) {
  std::string out = style.heading("Parts that differ") + "\n";
  TextTable table(
      {{"slot"}, {"A", Align::left, 20}, {"B", Align::left, 20}, {currency, Align::right}, {"kg", Align::right}});
  for (const PartChange& change : comparison.parts)
    table.add({change.axis + "." + change.slot,
               part_cell(change.a, change.b),
               part_cell(change.b, change.a),
               signed_text(change.price(), 2),
               signed_text(change.mass(), 3)});
  out += comparison.parts.empty() ? std::string("  none\n") : table.str(2, style);
  return out + fmt::format("  The same parts in {} slots.\n\n", comparison.same_parts);
}

std::string dimensions_section(const Comparison& comparison, const Style& style) {
  TextTable table({{"setting"}, {"A", Align::right}, {"B", Align::right}});
  for (const DimensionChange& change : comparison.dimensions) {
    const auto shown = [&](const std::optional<double>& value) {
      return value ? scalar::format(*value, scalar::Unit::of(change.unit == "m" ? "mm" : change.unit))
                   : std::string(nothing);
    };
    table.add({change.axis + "." + change.name, shown(change.a), shown(change.b)});
  }
  return table.empty() ? std::string()
                       : style.heading("Dimensions and settings that differ") + "\n" + table.str(2, style) + "\n";
}

std::string used_text(const Check* check) {
  if (check == nullptr) return nothing;
  return std::isinf(check->utilisation) ? std::string("> 999 %") : utilisation_text(*check);
}

std::string turn_text(const CheckChange& change, const Style& style) {
  if (!change.turns()) return {};
  const bool worse = change.b != nullptr && change.b->verdict == evaluation::Verdict::violated;
  const bool soft = change.either().kind == machine::ConstraintKind::soft;
  if (soft) return worse ? "B over" : "A over";
  return worse ? style.bad("B FAILS") : style.good("A FAILS");
}

std::string checks_section(const Comparison& comparison, const Style& style) {
  std::string out = style.heading("Checks that are used differently") + "\n";
  TextTable table({{"axis"}, {"id"}, {"check", Align::left, 24}, {"A", Align::right}, {"B", Align::right}, {""}});
  std::size_t shown = 0, others = 0;
  for (const CheckChange& change : comparison.checks) {
    if (!change.turns() && ++others > most_checks) continue;
    ++shown;
    const Check& check = change.either();
    table.add({check.axis, check.id, check.title, used_text(change.a), used_text(change.b), turn_text(change, style)});
  }
  out += comparison.checks.empty() ? std::string("  none\n") : table.str(2, style);
  if (shown < comparison.checks.size())
    out += fmt::format("  {} more change less; --json has them all.\n", comparison.checks.size() - shown);
  return out + fmt::format("  {} are used alike, to 0.01 % of the limit.\n", comparison.same_checks);
}

std::string origin_text(const char* name, const ComparedBuild& build) {
  return fmt::format("  {}  {}\n", name, wrapped(build.file + ": " + build.origin, 74, 5));
}

Json side_of(const ComparedBuild& build) {
  return {{"file", build.file},
          {"figures", build.origin},
          {"title", build.title},
          {"totals", totals_of(build.design)},
          {"satisfied", failed_checks(build.design) == 0},
          {"failed", failed_checks(build.design)},
          {"checks", build.design.checks.size()}};
}

Json part_of(const PartLine* part) {
  if (part == nullptr) return nullptr;
  return {{"manufacturer", part->manufacturer},
          {"part_number", part->part_number},
          {"quantity", number(part->quantity)},
          {"length_m", part->length > 0.0 ? number(part->length) : Json(nullptr)},
          {"price", number(part->price)},
          {"mass_kg", number(part->mass)}};
}

Json used_of(const Check* check) {
  if (check == nullptr) return nullptr;
  return {{"value", number(check->value)},
          {"limit", number(check->limit)},
          {"utilisation", number(check->utilisation)},
          {"verdict", verdict_name(check->verdict)}};
}

}  // namespace

std::string comparison_text(const ComparedBuild& a, const ComparedBuild& b, const Style& style) {
  const Comparison comparison = compare(a, b);
  std::string out = style.heading(a.title == b.title ? a.title : a.title + " / " + b.title) + "\n";
  out += origin_text("A", a) + origin_text("B", b);
  if (a.title != b.title) out += "  Their problems have different titles: they may ask for different things.\n";
  return out + "\n" + headline(a, b, style) + "\n" + parts_section(comparison, a.design.currency, style) +
         dimensions_section(comparison, style) + checks_section(comparison, style);
}

std::string comparison_json(const ComparedBuild& a, const ComparedBuild& b) {
  const Comparison comparison = compare(a, b);
  Json json = result_of("compare");
  json["a"] = side_of(a);
  json["b"] = side_of(b);
  json["parts"] = Json::array();
  for (const PartChange& change : comparison.parts)
    json["parts"].push_back({{"axis", change.axis},
                             {"slot", change.slot},
                             {"a", part_of(change.a)},
                             {"b", part_of(change.b)},
                             {"price_difference", number(change.price())},
                             {"currency", a.design.currency},
                             {"mass_difference_kg", number(change.mass())}});
  json["parts_alike"] = comparison.same_parts;
  json["dimensions"] = Json::array();
  for (const DimensionChange& change : comparison.dimensions)
    json["dimensions"].push_back({{"axis", change.axis},
                                  {"name", change.name},
                                  {"a", number(change.a)},
                                  {"b", number(change.b)},
                                  {"unit", change.unit}});
  json["checks"] = Json::array();
  for (const CheckChange& change : comparison.checks) {
    const Check& check = change.either();
    json["checks"].push_back({{"axis", check.axis},
                              {"element", check.element},
                              {"id", check.id},
                              {"title", check.title},
                              {"unit", check.unit},
                              {"a", used_of(change.a)},
                              {"b", used_of(change.b)},
                              {"turns", change.turns()}});
  }
  json["checks_alike"] = comparison.same_checks;
  return text_of(json);
}

}  // namespace millwright::report
