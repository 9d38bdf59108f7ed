// SPDX-License-Identifier: Apache-2.0
#include "report/explanation_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/design_text.h"
#include "report/machine_text.h"
#include "report/tolerance_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Conflict;
using evaluation::Design;
using evaluation::Explanation;
using evaluation::Price;
using evaluation::Relaxation;
using evaluation::SlotChoice;
using evaluation::UnmetCheck;
using machine::Condition;

namespace {

constexpr std::size_t width = 78;
constexpr std::string_view option_text = "command line";  ///< the name of the text of what `--set` says

/// "1.20 USD" as "1.20": amounts of the objective, their unit stands in the heading.
std::string amount(const Explanation& explanation, double value, const std::string& currency) {
  const auto quantity = machine::objective_named(explanation.objective).single();
  if (quantity == machine::Quantity::cost) return fmt::format("{:.2f}", value);
  if (quantity == machine::Quantity::mass) return fmt::format("{:.3f}", value);
  const std::string text = objective_text(explanation.objective, value, currency);
  return text.substr(0, text.find(' '));
}

std::string heading_unit(const Explanation& explanation, const std::string& currency) {
  const std::string unit = objective_unit(explanation.objective, currency);
  return unit.empty() ? explanation.objective : unit;
}

/// A value of the objective, or a difference, in the unit of the heading.
double objective_value(const std::string& objective, double value) {
  const auto quantity = machine::objective_named(objective).single();
  if (!quantity || *quantity == machine::Quantity::cost) return value;
  return scalar::Unit::of(machine::declaration(*quantity).unit).from_si(value);
}

/// Where a build shows what a lifted choice was replaced by.
std::string taken(const Condition& condition, const Design& design) {
  if (condition.slot == "supply_voltage") return scalar::format(design.supply_voltage, scalar::Unit::of("V"));
  for (const evaluation::PartLine& part : design.parts)
    if (part.axis == condition.axis && part.slot == condition.slot) return part_name(part);
  for (const evaluation::DimensionLine& line : design.dimensions)
    if (line.axis == condition.axis && line.name == condition.slot)
      return scalar::format(line.value, scalar::Unit::of(line.unit));
  return {};
}

std::string way_words(const Explanation& explanation, const Relaxation& way, const std::string& currency) {
  const Condition& condition = way.changed(explanation.conditions);
  const std::string from = shown(condition, condition.value, currency);
  std::string to = "any";
  if (way.to) {
    to = shown(condition, *way.to, currency);
  } else if (condition.name == "--without") {
    to = "may be used";
  } else if (way.design) {
    if (const std::string part = taken(condition, *way.design); !part.empty())
      to = condition.slot == "supply_voltage" ? part : fmt::format("any; the build has {}", part);
  }
  return fmt::format("{}: {} {} -> {}", condition.axis, condition.name, from, to);
}

/// "; near its limit: z C-ST-TORQUE, Torque at speed, worst phase (99.6 %)": what stands behind the conflict.
std::string tightest_text(const Design& design) {
  const evaluation::Check* tightest = nullptr;
  for (const evaluation::Check& check : design.checks) {
    const bool counts = check.kind == machine::ConstraintKind::hard && std::isfinite(check.utilisation) &&
                        check.utilisation < 1.0 && check.id != "C-SYS-COST" && check.id != "C-SYS-MASS";
    if (counts && (tightest == nullptr || check.utilisation > tightest->utilisation)) tightest = &check;
  }
  if (tightest == nullptr || tightest->utilisation < 0.95) return {};
  return fmt::format(
      "; near its limit: {} {}, {} ({})", tightest->axis, tightest->id, tightest->title, utilisation_text(*tightest));
}

/// "as asked it fails z C-ST-BACK, Back-driving with power off (2145.1 %)": what the condition blocks by.
std::string broken_text(const Relaxation& way) {
  constexpr std::size_t named = 3;
  std::vector<std::string> checks;
  for (const evaluation::Check& check : way.broken)
    if (checks.size() < named)
      checks.push_back(fmt::format("{} {}, {} ({})", check.axis, check.id, check.title, utilisation_text(check)));
  if (checks.empty()) return {};
  const std::size_t more = way.broken.size() - checks.size();
  return fmt::format(
      "without that it fails {}{}", fmt::join(checks, "; "), more == 0 ? "" : fmt::format("; and {} more", more));
}

/// What is said of one way out below what is changed.
std::string way_details(const Relaxation& way, const Condition& changed, const std::string& currency) {
  std::vector<std::string> details;
  if (way.design)
    details.push_back(fmt::format("cheapest build then: {:.2f} {}, {:.3f} kg{}",
                                  way.design->cost,
                                  currency,
                                  way.design->mass,
                                  tightest_text(*way.design)));
  if (changed.no_part) details.push_back("what it takes is none of the parts: not in this price and mass");
  if (std::string broken = broken_text(way); !broken.empty()) details.push_back(std::move(broken));
  std::string out;
  for (const std::string& detail : details) out += "      " + wrapped(detail, width - 6, 8) + "\n";
  return out;
}

std::string conflict_text(const Explanation& explanation,
                          const Conflict& conflict,
                          const std::string& currency,
                          const Style& style) {
  std::string out;
  TextTable table({{"axis"}, {"what is asked", Align::left, 26}, {"", Align::right}, {"where", Align::left, 28}});
  for (const std::size_t i : conflict.conditions) {
    const Condition& condition = explanation.conditions[i];
    table.add({condition.axis,
               condition.name + (condition.meaning.empty() ? "" : ": " + condition.meaning),
               shown(condition, condition.value, currency),
               place_text(condition)});
  }
  out += table.str(2, style);
  if (conflict.ways.empty()) return out + "\n";
  out += conflict.ways.size() == 1 ? "\n  This is enough, proved by solving (numbers to 1 %):\n"
                                   : "\n  Any one of these is enough, proved by solving (numbers to 1 %):\n";
  std::string useless;
  for (const Relaxation& way : conflict.ways) {
    if (!way.enough) {
      const Condition& condition = explanation.conditions[way.condition];
      useless +=
          "    " +
          wrapped(fmt::format("not enough alone, another conflict is left: {}: {}", condition.axis, condition.name),
                  width - 4,
                  6) +
          "\n";
      continue;
    }
    out += "    " + wrapped(way_words(explanation, way, currency), width - 4, 6) + "\n";
    out += way_details(way, way.changed(explanation.conditions), currency);
  }
  return out + useless + "\n";
}

std::string unmet_text(const Explanation& explanation, const Style& style) {
  TextTable table(
      {{"axis"}, {"check"}, {"", Align::left, 22}, {"at least", Align::right}, {"nearest", Align::left, 19}});
  for (const UnmetCheck& check : explanation.unmet)
    table.add({check.axis,
               check.id,
               check.title,
               least_text(check),
               check.nearest.empty() ? "" : check.slot + " " + check.nearest});
  if (table.empty()) return {};
  return style.heading("Checks that fail whatever is chosen, proved") + "\n" + table.str(2, style) + "\n";
}

std::string empty_text(const Explanation& explanation) {
  std::string out;
  for (const evaluation::EmptySlot& slot : explanation.empty_slots)
    out += "  " + wrapped(fmt::format("{}.{}: {}", slot.axis, slot.slot, slot.reason), width - 2, 4) + "\n";
  return out.empty() ? out : "Slots without any candidate\n" + out + "\n";
}

std::string infeasible_text(const MachineResult& result, const Explanation& explanation, const Style& style) {
  std::string out = style.bad("No compliant build exists in these catalogues.") + "\n";
  if (explanation.catalogue_lacks) {
    out +=
        wrapped(
            "Not even with all that is asked and could be eased (limits, times, loads, kinds of parts) lifted: parts "
            "are missing in the catalogues, or what they are to do is beyond all of them.",
            width,
            0) +
        "\n\n";
    return out + empty_text(explanation) + unmet_text(explanation, style);
  }
  const std::size_t count = explanation.conflicts.size();
  if (count == 0)
    return out + "Why was not found out before the limit.\n\n" + empty_text(explanation) +
           unmet_text(explanation, style);
  out += count == 1 ? "\n" : fmt::format("There are {} separate conflicts; each must be resolved.\n\n", count);
  for (std::size_t i = 0; i < count; ++i) {
    const Conflict& conflict = explanation.conflicts[i];
    const std::size_t members = conflict.conditions.size();
    const std::string number = count == 1 ? "" : fmt::format("{}. ", i + 1);
    out += style.heading(number + (members == 1 ? std::string("This cannot be met, proved")
                                                : fmt::format("These {} contradict each other, and no fewer do, proved",
                                                              members))) +
           "\n" + conflict_text(explanation, conflict, result.currency, style);
  }
  if (explanation.all_resolved)
    out += fmt::format("With the first way out of each: {:.2f} {}, {:.3f} kg, proved by solving.\n\n",
                       explanation.all_resolved->cost,
                       result.currency,
                       explanation.all_resolved->mass);
  return out + empty_text(explanation) + unmet_text(explanation, style);
}

/// "+4.25", "free" where another choice is as good, "forced".
std::string extra_text(const Explanation& explanation,
                       const SlotChoice& choice,
                       const std::string& currency,
                       const Style& style) {
  if (!choice.next_best) return style.bad("forced");
  const std::string text = amount(explanation, *choice.next_best, currency);
  const bool nothing = text.find_first_of("123456789") == std::string::npos;
  if (!choice.settled) return nothing ? std::string("?") : "+" + text + " ?";
  return nothing ? style.good("free") : "+" + text;
}

std::string instead_text(const Explanation& explanation, const SlotChoice& choice, const std::string& currency) {
  if (choice.only) return "no other candidate";
  if (!choice.next_best) return "nothing is compliant";
  if (choice.settled) return choice.instead;
  if (!choice.at_most) return "none found yet";
  return fmt::format("at most +{}: {}", amount(explanation, *choice.at_most, currency), choice.instead);
}

std::string choices_text(const Explanation& explanation, const std::string& currency, const Style& style) {
  if (explanation.choices.empty()) return {};
  std::vector<const SlotChoice*> order;
  for (const SlotChoice& choice : explanation.choices) order.push_back(&choice);
  const auto extra = [](const SlotChoice* choice) {
    return choice->next_best.value_or(std::numeric_limits<double>::infinity());
  };
  std::stable_sort(
      order.begin(), order.end(), [&](const SlotChoice* a, const SlotChoice* b) { return extra(a) > extra(b); });
  TextTable table({{"slot"},
                   {"chosen", Align::left, 21},
                   {heading_unit(explanation, currency), Align::right},
                   {"best without it", Align::left, 21}});
  for (const SlotChoice* choice : order)
    table.add({choice->axis + "." + choice->slot,
               choice->part,
               extra_text(explanation, *choice, currency, style),
               instead_text(explanation, *choice, currency)});
  const bool all_settled =
      std::all_of(order.begin(), order.end(), [](const SlotChoice* choice) { return choice->settled; });
  return style.heading("Choices: by how much the best build is worse without each part") + "\n" + table.str(2, style) +
         (all_settled ? "" : "  ? took too long: so much or more is proved\n") + "\n";
}

/// Set by `--set`, whose words are a text of their own.
bool is_option(const Condition& condition) { return condition.where.text->path() == option_text; }

/// "line 14"; short, because all are of one file.
std::string short_place(const Condition& condition) {
  if (!condition.given) return "default";
  if (condition.where.line == 0 || !condition.where.text) return "option";
  if (is_option(condition)) return "--set";
  return fmt::format("line {}", condition.where.line);
}

std::string prices_text(const Explanation& explanation, const std::string& currency, const Style& style) {
  const std::string unit = heading_unit(explanation, currency);
  std::string out = style.heading("What each thing that is asked costs, all else as it is") + "\n";
  TextTable table({{"axis"},
                   {"asked", Align::left, 18},
                   {"at"},
                   {"now", Align::right, 10},
                   {"eased to", Align::right},
                   {"saves", Align::right},
                   {"at most", Align::right}});
  for (const Price& price : explanation.prices) {
    const Condition& condition = explanation.conditions[price.condition];
    table.add({condition.axis,
               condition.name,
               short_place(condition),
               shown(condition, condition.value, currency),
               price.to ? shown(condition, *price.to, currency) : "any",
               amount(explanation, price.saving, currency),
               amount(explanation, price.at_most, currency)});
  }
  out += table.str(2, style);
  if (!table.empty())
    out += "  " +
           wrapped(fmt::format("{}, proved by solving: eased by a fifth, or where that saves nothing by as much as it "
                               "takes (to 1 %); at most: without it",
                               unit),
                   width - 2,
                   2) +
           "\n";
  if (std::any_of(explanation.prices.begin(), explanation.prices.end(), [&](const Price& price) {
        return explanation.conditions[price.condition].no_part;
      }))
    out += "  A brake is none of the parts: what it costs itself is to be taken off.\n";
  for (const std::size_t i : explanation.unsettled)
    out += fmt::format("  What {}: {} costs took too long to find out.\n",
                       explanation.conditions[i].axis,
                       explanation.conditions[i].name);
  if (explanation.status == solver::Status::optimal)
    out += fmt::format("  {} cost{} nothing on {} own.\n",
                       explanation.prices.empty() && explanation.unsettled.empty()
                           ? "All"
                           : fmt::format("The other {}", explanation.costless),
                       explanation.costless == 1 ? "s" : "",
                       explanation.costless == 1 ? "its" : "their");
  return out + "\n";
}

/// "-2.31 USD per mm", "0.012 kg per 1": a slope in the units that people read.
std::string slope_text(const Explanation& explanation, const evaluation::Rate& rate, const std::string& currency) {
  const Condition& condition = explanation.conditions[rate.condition];
  const machine::ShownUnit unit = machine::shown_unit(condition, currency);
  const double objective = objective_value(explanation.objective, rate.slope * unit.in_si);
  return fmt::format("{:+.4g} per {}", objective, unit.name);
}

/// What a little of each condition is worth; nothing where all that can be chosen is discrete.
std::string rates_text(const Explanation& explanation, const std::string& currency, const Style& style) {
  if (explanation.rates_undetermined)
    return "The free dimensions are held by more than they need, or at a kink: no derivatives.\n\n";
  if (explanation.moving.empty()) return {};
  const std::string unit = heading_unit(explanation, currency);
  std::string out = style.heading("What a little of each is worth, with these parts: derivatives") + "\n";
  TextTable table({{"axis"},
                   {"asked", Align::left, 24},
                   {"at", Align::left, 8},
                   {"now", Align::right, 10},
                   {unit, Align::right},
                   {"1 % looser", Align::right}});
  for (const evaluation::Rate& rate : explanation.rates) {
    const Condition& condition = explanation.conditions[rate.condition];
    const double one_percent = rate.slope * (condition.eased(1.01) - condition.value);
    table.add({condition.axis,
               condition.name,
               short_place(condition),
               shown(condition, condition.value, currency),
               slope_text(explanation, rate, currency),
               fmt::format("{:+.4f}", objective_value(explanation.objective, one_percent))});
  }
  out += table.str(2, style);
  std::string words = explanation.rates.empty() ? "Nothing that is asked moves it smoothly. " : "";
  words += "For the same parts, whose free dimensions follow:";
  for (std::size_t i = 0; i < explanation.moving.size(); ++i) {
    const evaluation::DimensionLine& line = explanation.moving[i];
    const scalar::Unit readable = scalar::readable_unit(scalar::Unit::of(line.unit).dimension(), line.value);
    words += fmt::format("{} {} {} {}", i == 0 ? "" : ",", line.axis, line.name, scalar::format(line.value, readable));
  }
  if (!explanation.holding.empty()) words += "; held by";
  for (std::size_t i = 0; i < explanation.holding.size(); ++i)
    words += fmt::format("{} {} {} {}",
                         i == 0 ? "" : ",",
                         explanation.holding[i].axis,
                         explanation.holding[i].element,
                         explanation.holding[i].id);
  words += ". Each was tried by settling the same parts with a thousandth more.";
  if (!explanation.rough.empty()) words += " It has steps or kinks in";
  for (std::size_t i = 0; i < explanation.rough.size(); ++i) {
    const Condition& condition = explanation.conditions[explanation.rough[i]];
    words += fmt::format("{} {}: {}", i == 0 ? "" : ",", condition.axis, condition.name);
  }
  if (!explanation.rough.empty()) words += ".";
  return out + "  " + wrapped(words, width - 2, 2) + "\n\n";
}

}  // namespace

std::string place_text(const Condition& condition) {
  if (!condition.given) return "default: " + condition.source;
  if (condition.where.line == 0 || !condition.where.text) return "command line";
  if (is_option(condition)) return "command line";
  return fmt::format("{}:{}:{}", condition.where.text->path(), condition.where.line, condition.where.column);
}

std::string explanation_text(const MachineResult& result, const Explanation& explanation, const Style& style) {
  std::string out = title_text(result, style);
  const bool limited = explanation.status == solver::Status::limit;
  if (limited) out += style.bad("The limit was reached before all was found out.") + " What is said is proved.\n\n";
  if (explanation.design) {
    const Design& design = *explanation.design;
    const auto quantity = machine::objective_named(explanation.objective).single();
    out += style.heading(fmt::format("The best build by {}: {}",
                                     explanation.objective,
                                     totals_text(design, quantity.value_or(machine::Quantity::cost)))) +
           "\n\n";
    if (design.preference)
      out += fmt::format("  Costs are compared below with the prices of preferred parts divided by {:.4g}.\n\n",
                         1.0 + design.preference->premium);
    out += governing_text(result, design, style) + choices_text(explanation, result.currency, style);
    out += rates_text(explanation, result.currency, style);
    out += tolerance_choices_text(result, explanation, style);
    if (!limited || !explanation.prices.empty()) out += prices_text(explanation, result.currency, style);
  } else if (!limited || !explanation.conflicts.empty() || !explanation.unmet.empty() ||
             !explanation.empty_slots.empty()) {
    out += infeasible_text(result, explanation, style);
  }
  return out + fmt::format("time: {:.2f} s, solved {} times\n", explanation.seconds, explanation.solves);
}

}  // namespace millwright::report
