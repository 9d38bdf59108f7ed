// SPDX-License-Identifier: Apache-2.0
#include "report/design_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/conversion_text.h"
#include "report/cut_text.h"
#include "report/quantity_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;
using evaluation::PartLine;
using evaluation::Verdict;
using machine::ConstraintKind;

namespace {

std::string length_text(double metres) { return metres > 0.0 ? millimetres_text(metres) : std::string(); }

std::string mass_text(double kilograms) { return kilograms > 0.0 ? fmt::format("{:.3f}", kilograms) : std::string(); }

std::vector<std::string> axes_with_parts(const MachineResult& result, const Design& design) {
  std::vector<std::string> axes = result.axes;
  axes.emplace_back("machine");
  const auto has_none = [&](const std::string& axis) {
    return std::none_of(
        design.parts.begin(), design.parts.end(), [&](const PartLine& part) { return part.axis == axis; });
  };
  axes.erase(std::remove_if(axes.begin(), axes.end(), has_none), axes.end());
  return axes;
}

/// What the parts do not account for: members that are made to measure and priced by their mass.
std::string made_to_measure(const Design& design) {
  double cost = design.cost;
  double mass = design.mass;
  for (const PartLine& part : design.parts) {
    cost -= part.price;
    mass -= part.mass;
  }
  for (const evaluation::ShopOrder& order : design.orders) cost -= order.shipping_fee + order.top_up;
  if (cost < 0.005 && mass < 5e-4) return {};
  return fmt::format("  Members made to measure, by their mass: {:.2f} {}, {:.3f} kg\n", cost, design.currency, mass);
}

std::string verdict_text(const Check& check, const Style& style) {
  switch (check.verdict) {
    case Verdict::satisfied:
      return style.good("ok");
    case Verdict::violated:
      return check.kind == ConstraintKind::soft ? std::string("over") : style.bad("FAIL");
    case Verdict::not_evaluated:
      return "open";
  }
  return {};
}

std::string value_text(double value) { return std::isnan(value) ? "-" : scalar::format_number(value, 4); }

std::string unit_text(const std::string& unit) { return unit == "1" ? std::string() : unit; }

/// "In stock: 1 of Acme M23 (y.motor)", a line for each part that is owned; empty if none is.
std::string in_stock_text(const Design& design) {
  std::string out;
  for (const PartLine& part : design.parts)
    if (part.owned > 0.0)
      out += fmt::format(
          "  In stock: {} of {} ({}.{})\n", scalar::format_number(part.owned), part_name(part), part.axis, part.slot);
  return out;
}

/// "Preferred: Acme M23 (y.motor)", a line for each such part.
std::string preferred_text(const Design& design) {
  std::string out;
  for (const PartLine& part : design.parts)
    if (part.preferred) out += fmt::format("  Preferred: {} ({}.{})\n", part_name(part), part.axis, part.slot);
  return out;
}

/// "Spare: 1 more of Acme M23 (y.motor)", a line for each part.
std::string spares_text(const Design& design) {
  std::string out;
  for (const PartLine& part : design.parts)
    if (part.spares > 0.0)
      out += fmt::format("  Spare: {} more of {} ({}.{})\n",
                         scalar::format_number(part.spares),
                         part_name(part),
                         part.axis,
                         part.slot);
  return out;
}

/// "Order from Shop A: goods 38.20, shipping 12.00 USD", a line for each supplier that charges for the order.
std::string orders_text(const Design& design) {
  std::string out;
  for (const evaluation::ShopOrder& order : design.orders) {
    out += fmt::format("  Order {}: goods {:.2f}, shipping {:.2f}",
                       order.supplier.empty() ? "of what names no supplier" : "from " + order.supplier,
                       order.goods,
                       order.shipping_fee);
    if (order.top_up > 0.0)
      out += fmt::format(", filled up to the minimum of {:.2f} by {:.2f}", order.minimum_order, order.top_up);
    out += fmt::format(" {}\n", design.currency);
  }
  return out;
}

}  // namespace

std::string part_name(const std::string& manufacturer, const std::string& part_number) {
  return manufacturer.empty() ? part_number : manufacturer + " " + part_number;
}

std::string part_name(const PartLine& part) { return part_name(part.manufacturer, part.part_number); }

std::string signed_text(double difference, int digits) {
  const std::string text = fmt::format("{:+.{}f}", difference, digits);
  return text.find_first_of("123456789") == std::string::npos ? std::string("=") : text;
}

std::string worst_text(const Check& check) {
  const bool both = !check.phase.empty() && !check.position.empty();
  return check.phase + (both ? "; " : "") + check.position;
}

std::string element_named(const Design& design, const Check& check) {
  const bool several = std::any_of(design.checks.begin(), design.checks.end(), [&](const Check& each) {
    return each.id == check.id && each.axis == check.axis && each.element != check.element;
  });
  return several ? check.element : std::string();
}

std::string title_of(const Design& design, const Check& check) {
  const std::string element = element_named(design, check);
  return element.empty() ? check.title : check.title + " (" + element + ")";
}

std::string check_cell(const Design& design, const Check& check, const std::string& id) {
  const std::string worst = worst_text(check);
  return id + " " + title_of(design, check) + (worst.empty() ? "" : "\n(" + worst + ")");
}

std::string utilisation_text(const Check& check) {
  if (check.verdict == Verdict::not_evaluated || std::isnan(check.utilisation)) return "-";
  if (check.utilisation > 9.99) return "> 999 %";
  const double percent = 100.0 * check.utilisation;
  // 100.004 % fails and must not look like the limit itself.
  if (percent > 100.0 && percent < 100.05) return "> 100 %";
  return fmt::format("{:.1f} %", percent);
}

std::string least_text(const evaluation::UnmetCheck& check) {
  if (!(check.least_utilisation < machine::useless_utilisation)) return "no part";
  return fmt::format("{:.1f} %", std::floor(1e3 * check.least_utilisation) / 10.0);
}

std::vector<std::string> stated_only_lines(const Design& design, const Texts& t) {
  std::vector<std::string> lines;
  for (const evaluation::StatedOnly& each : design.stated_only) {
    const auto add = [&](const char* key, double value) {
      if (value > 0.0) lines.push_back(fmt::format(fmt::runtime(t(key)), each.axis, scalar::format_number(value)));
    };
    add("assume.brake", each.brake_torque);
    add("assume.counterbalance", each.counterbalance_force);
  }
  return lines;
}

std::string parts_text(const MachineResult& result, const Design& design, const Style& style) {
  std::string out = style.heading("Parts") + "\n";
  bool estimates = false;
  TextTable table({{"axis"},
                   {"slot"},
                   {"part", Align::left, 34},
                   {"qty", Align::right},
                   {"mm", Align::right},
                   {design.currency, Align::right},
                   {"kg", Align::right},
                   {"origin"}});
  for (const std::string& axis : axes_with_parts(result, design)) {
    std::string shown = axis;
    for (const PartLine& part : design.parts) {
      if (part.axis != axis) continue;
      estimates = estimates || part.estimate;
      table.add({shown,
                 part.slot + (part.paper_only ? " !" : ""),
                 part_name(part),
                 scalar::format_number(part.quantity),
                 length_text(part.length),
                 fmt::format("{}{:.2f}", part.estimate ? "~" : "", part.price),
                 mass_text(part.mass),
                 part.origin});
      shown.clear();
    }
  }
  out += table.str(2, style) + made_to_measure(design) + work_text(design);
  out += preferred_text(design) + in_stock_text(design) + spares_text(design) + bars_lines(design, style) +
         orders_text(design) + conversion_lines(design, style.width - 4);
  out += fmt::format("  Total: {}\n", totals_text(design));
  for (const std::string& line : stated_only_lines(design, Texts(Language::english)))
    out += "  " + style.bad("not included") + ": " + wrapped(line, style.width - 16, 4) + "\n";
  if (std::any_of(design.parts.begin(), design.parts.end(), [](const PartLine& part) { return part.paper_only; }))
    out += "  ! known only from a paper, from no maker: verify before ordering\n";
  if (estimates) out += "  ~ the price, or a figure of the part that matters, is an estimate\n";
  return out + "\n";
}

std::string totals_text(const Design& design, machine::Quantity first) {
  std::vector<std::string> parts{quantity_text(first, design.total(first), design.currency)};
  for (const machine::QuantityDeclaration& each : machine::quantities()) {
    const double value = design.total(each.quantity);
    if (each.quantity == first || std::isnan(value)) continue;
    parts.push_back(quantity_text(each.quantity, value, design.currency));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string dimensions_text(const Design& design, const Style& style) {
  if (design.dimensions.empty()) return {};
  TextTable table({{""}, {""}, {"", Align::right}});
  for (const evaluation::DimensionLine& line : design.dimensions)
    table.add(
        {line.axis, line.name, scalar::format(line.value, scalar::Unit::of(line.unit == "m" ? "mm" : line.unit))});
  return style.heading("Dimensions and settings") + "\n" + table.str(2, style) + "\n";
}

std::string governing_text(const MachineResult& result, const Design& design, const Style& style) {
  TextTable table({{""}, {""}, {""}, {"", Align::right}, {""}});
  for (const std::string& axis : checked_axes(result))
    if (const Check* check = design.governing(axis))
      table.add({axis, check->id, title_of(design, *check), utilisation_text(*check), verdict_text(*check, style)});
  return table.empty() ? std::string()
                       : style.heading("Governing check of each axis") + "\n" + table.str(2, style) + "\n";
}

/// "C-ACC-TOTAL: lead 58.2, reversal 3.1, ... um"
std::string contributions_text(const Check& check) {
  std::vector<std::string> parts;
  for (const evaluation::Contribution& part : check.contributions)
    if (part.value > 0.0) parts.push_back(part.what + " " + scalar::format_number(part.value, 3));
  return fmt::format("{}: {} {}", check.id, fmt::join(parts, ", "), check.unit);
}

std::string checks_text(const MachineResult& result, const Design& design, const Style& style) {
  std::string out;
  std::set<std::string> notes;
  bool soft = false;
  bool open = false;
  for (const std::string& axis : checked_axes(result)) {
    const bool wide = style.width >= wide_checks;
    TextTable table({{wide ? "id" : ""},
                     {"check", Align::left, wide ? 36U : 0U, false, wide ? 0U : 2U},
                     {"value", Align::right},
                     {"limit", Align::right},
                     {"", Align::left, 0, true},
                     {"used", Align::right},
                     {"", Align::left, 0, true},
                     {wide ? "worst in" : ""}});
    for (const Check* check : checks_of(design, axis)) {
      const bool is_soft = check->kind == ConstraintKind::soft;
      soft = soft || is_soft;
      open = open || check->verdict == Verdict::not_evaluated;
      if (!check->note.empty()) notes.insert(check->id + ": " + check->note);
      const std::string id = check->id + (is_soft ? "*" : "");
      table.add({wide ? id : "",
                 wide ? title_of(design, *check) : check_cell(design, *check, id),
                 value_text(check->value),
                 value_text(check->limit),
                 unit_text(check->unit),
                 utilisation_text(*check),
                 verdict_text(*check, style),
                 wide ? worst_text(*check) : ""});
    }
    out += style.heading(axis == "machine" ? "Checks of the machine" : "Checks of axis " + axis) + "\n";
    out += table.str(2, style);
    for (const Check* check : checks_of(design, axis))
      if (!check->contributions.empty()) out += "  " + contributions_text(*check) + "\n";
    out += "\n";
  }
  if (soft) out += "  * reported, not enforced\n";
  if (open) out += "  open: a figure that the check needs is not known\n";
  for (const std::string& note : notes) out += "  " + note + "\n";
  return soft || open || !notes.empty() ? out + "\n" : out;
}

std::string closest_checks_text(const MachineResult& result,
                                const Design& design,
                                const Style& style,
                                bool with_failures) {
  constexpr std::size_t most = 10;
  constexpr double close = 0.5;
  const std::vector<TableColumn> columns{{""}, {""}, {"", Align::left, 46}, {"", Align::right}, {""}};
  TextTable table(columns), over(columns);
  for (const std::string& axis : checked_axes(result)) {
    std::size_t count = 0, count_over = 0;
    const Check* governing = design.governing(axis);
    for (const Check* check : checks_of(design, axis)) {
      const bool violated = check->verdict == Verdict::violated;
      if (check->kind == ConstraintKind::soft) {
        if (violated)
          over.add({count_over++ == 0 ? axis : "", check->id, title_of(design, *check), utilisation_text(*check), ""});
        continue;
      }
      if (violated && !with_failures) continue;
      // Fits are met or not: that they are met is no news, however close.
      const bool is_fit = check->id.rfind("F-", 0) == 0;
      const bool counts = check == governing || (!is_fit && check->utilisation >= close && count < most);
      if (!violated && !counts) continue;
      table.add({count++ == 0 ? axis : "",
                 check->id,
                 title_of(design, *check),
                 utilisation_text(*check),
                 violated ? verdict_text(*check, style) : ""});
    }
  }
  std::string out;
  if (!table.empty())
    out += style.heading("Checks next to their limits, those that govern first") + "\n" + table.str(2, style) + "\n";
  if (!over.empty())
    out += style.heading("Reported, not enforced, and over (enforce = [\"ID\"] in [axis.require] binds)") + "\n" +
           over.str(2, style) + "\n";
  return out;
}

std::string outside_validity_text(const Design& design, const Style& style) {
  TextTable table({{"axis"}, {"of"}, {"check"}, {"formula"}, {"limit", Align::left, 44}});
  for (const evaluation::OutsideValidity& line : design.outside_validity)
    table.add({line.axis, line.element, line.constraint, line.formula, line.sentence});
  if (table.empty()) return {};
  return style.heading("Outside the range a formula is stated for") + "\n" + table.str(2, style) + "\n";
}

std::string requirements_text(const MachineResult& result, const Style& style) {
  TextTable table({{"requirement"}, {"value", Align::right}, {"axes"}, {"from"}, {"meaning", Align::left, 44}});
  for (const RequirementLine& line : result.requirements)
    table.add({line.key,
               shown_value(line),
               fmt::format("{}", fmt::join(line.axes, " ")),
               line.given ? "problem" : "default: " + line.source,
               line.meaning});
  return table.empty() ? std::string()
                       : style.heading("Requirements behind the checks") + "\n" + table.str(2, style) + "\n";
}

std::string assumptions_text(const Design& design, const Style& style) {
  std::set<std::string> bases;
  for (const PartLine& part : design.parts)
    if (!part.price_basis.empty()) bases.insert(part.price_basis);
  std::string out = style.heading("Assumptions") + "\n";
  const Texts t(Language::english);
  out += "  " + t(machining_assumption(design)) + "\n  " + t(length_assumption(design)) + "\n";
  const auto counts = [&](machine::Quantity quantity) { return !std::isnan(design.total(quantity)); };
  if (counts(machine::Quantity::cycle_time))
    out +=
        "  Cycle time: every move of every axis, and its dwell, one after the other; coordinated moves once,\n"
        "  there and back where one of their axes climbs.\n";
  if (counts(machine::Quantity::energy))
    out +=
        "  Energy is an estimate, of the drives' input while their own axis goes through its cycle: copper losses at\n"
        "  full current, usual iron losses, driver efficiency 0.9; nothing is fed back.\n";
  if (!bases.empty())
    out += "  Prices: " + wrapped(fmt::format("{}", fmt::join(bases, "; ")), style.width - 10, 10) + "\n";
  return out + "\n";
}

}  // namespace millwright::report
