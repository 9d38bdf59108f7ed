// SPDX-License-Identifier: Apache-2.0
#include "report/explanation_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/design_text.h"
#include "report/explanation_checks.h"
#include "report/explanation_conflicts.h"
#include "report/incomplete.h"
#include "report/machine_text.h"
#include "report/tolerance_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Design;
using evaluation::Explanation;
using evaluation::Price;
using evaluation::SlotChoice;
using machine::Condition;

namespace {

constexpr std::size_t line_width = 78;
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

/// What is written beside those settings that alone would replace something else.
std::string beside_text(const Explanation& explanation) {
  std::vector<std::string> beside;
  for (const Price& price : explanation.prices)
    if (const std::string& said = explanation.conditions[price.condition].beside; !said.empty()) beside.push_back(said);
  if (beside.empty()) return {};
  return "  " +
         wrapped(fmt::format("torque_margin alone would replace torque_margin_estimate: where it is eased, write {} "
                             "as well.",
                             fmt::join(beside, ", ")),
                 line_width - 2,
                 2) +
         "\n";
}

std::string prices_text(const Explanation& explanation, const std::string& currency, const Style& style) {
  const std::string unit = heading_unit(explanation, currency);
  std::string out = style.heading("What each thing that is asked costs, all else as it is") + "\n";
  TextTable table({{"axis"},
                   {"asked", Align::left, 22},
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
                   line_width - 2,
                   2) +
           "\n";
  if (std::any_of(explanation.prices.begin(), explanation.prices.end(), [&](const Price& price) {
        return explanation.conditions[price.condition].no_part;
      }))
    out += "  A brake is none of the parts: what it costs itself is to be taken off.\n";
  out += beside_text(explanation);
  std::string open;
  for (const std::size_t i : explanation.unsettled)
    open += fmt::format(
        "{}{}: {}", open.empty() ? "" : "; ", explanation.conditions[i].axis, explanation.conditions[i].name);
  if (explanation.unsettled.size() == 1)
    out += fmt::format("  What {} costs took too long to find out.\n", open);
  else if (!open.empty())
    out += "  " + wrapped("What these cost took too long to find out: " + open + ".", line_width - 2, 2) + "\n";
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
  return out + "  " + wrapped(words, line_width - 2, 2) + "\n\n";
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
  if (limited) out += style.bad("The search was ended before all was found out.") + " What is said is proved.\n\n";
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
    if (!limited || !explanation.prices.empty() || !explanation.unsettled.empty())
      out += prices_text(explanation, result.currency, style);
  } else if (!limited || !explanation.conflicts.empty() || !explanation.unmet.empty() ||
             !explanation.empty_slots.empty()) {
    out += conflicts_text(result, explanation, style);
  }
  out += withheld_text(explanation) + named_checks_text(explanation, style) +
         incomplete_text(result.certificate.incomplete, style);
  return out + fmt::format("time: {:.2f} s, solved {} times\n", explanation.seconds, explanation.solves);
}

}  // namespace millwright::report
