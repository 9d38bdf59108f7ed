// SPDX-License-Identifier: Apache-2.0
#include "report/explanation_conflicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/design_text.h"
#include "report/explanation_checks.h"
#include "report/explanation_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Conflict;
using evaluation::Design;
using evaluation::Explanation;
using evaluation::NotEased;
using evaluation::Relaxation;
using evaluation::UnmetCheck;
using machine::Condition;

namespace {

constexpr std::size_t paragraph_width = 78;

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
  } else if (condition.kind != machine::ConditionKind::choice) {
    to = "eased; how far was not found out before the search was ended";
  }
  return fmt::format("{}: {} {} -> {}", condition.axis, condition.name, from, to);
}

/// "; near its limit: z C-ST-TORQUE, Torque at speed, worst phase (99.6 %)": what stands behind the conflict.
std::string tightest_text(const Design& design) {
  const evaluation::Check* tightest = tightest_check(design);
  if (tightest == nullptr) return {};
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

/// "proved: nothing is compliant with 0 N, 49 N or 61 N; not tried is what lies between those": of a counterbalance.
std::string refused_text(const Relaxation& way, const Condition& changed, const std::string& currency) {
  std::vector<std::string> values;
  for (const double value : way.refused) values.push_back(shown(changed, value, currency));
  if (values.empty()) return {};
  const std::string last = values.back();
  values.pop_back();
  return fmt::format("proved: nothing is compliant with {}{}{}; not tried is what lies between those",
                     fmt::join(values, ", "),
                     values.empty() ? "" : " or ",
                     last);
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
  if (!changed.beside.empty())
    details.push_back(fmt::format("write {} as well: torque_margin alone would replace that too", changed.beside));
  if (changed.no_part) details.push_back("what it takes is none of the parts: not in this price and mass");
  if (std::string refused = refused_text(way, changed, currency); !refused.empty())
    details.push_back(std::move(refused));
  if (std::string broken = broken_text(way); !broken.empty()) details.push_back(std::move(broken));
  std::string out;
  for (const std::string& detail : details) out += "      " + wrapped(detail, paragraph_width - 6, 8) + "\n";
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
  const auto enough = std::ranges::count_if(conflict.ways, &Relaxation::enough);
  out += enough == 0   ? "\n  Taken alone, none of these is enough:\n"
         : enough == 1 ? "\n  This is enough, proved by solving (numbers to 1 %):\n"
                       : "\n  Any one of these is enough, proved by solving (numbers to 1 %):\n";
  std::string useless;
  for (const Relaxation& way : conflict.ways) {
    if (!way.enough) {
      const Condition& condition = explanation.conditions[way.condition];
      useless +=
          "    " +
          wrapped(fmt::format("not enough alone, another conflict is left: {}: {}", condition.axis, condition.name),
                  paragraph_width - 4,
                  6) +
          "\n";
      continue;
    }
    out += "    " + wrapped(way_words(explanation, way, currency), paragraph_width - 4, 6) + "\n";
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
    out += "  " + wrapped(fmt::format("{}.{}: {}", slot.axis, slot.slot, slot.reason), paragraph_width - 2, 4) + "\n";
  return out.empty() ? out : "Slots without any candidate\n" + out + "\n";
}

}  // namespace

namespace {

bool limits(const Explanation& explanation, machine::Quantity quantity) {
  return std::ranges::any_of(explanation.conditions, [&](const Condition& condition) {
    return condition.kind == machine::ConditionKind::budget && condition.quantity == quantity;
  });
}

}  // namespace

std::vector<std::string> withheld_kinds(const Explanation& explanation) {
  const bool energy = limits(explanation, machine::Quantity::energy);
  const auto some = [&](auto&& is_withheld) { return std::ranges::any_of(explanation.not_eased, is_withheld); };
  std::vector<std::string> kinds;
  if (energy || limits(explanation, machine::Quantity::cycle_time) ||
      some([](const NotEased& each) { return !each.slower.empty(); }))
    kinds = {"times", "speeds"};
  if (energy || some([](const NotEased& each) { return each.softens; })) kinds.emplace_back("forces");
  if (energy || some([](const NotEased& each) { return each.softens || !each.lighter.empty(); }))
    kinds.emplace_back("loads");
  return kinds;
}

std::string withheld_text(const Explanation& explanation) {
  std::string out;
  const auto say = [&](const std::string& words) {
    out += "  " + wrapped(words + " 'solve --set' tries them.", paragraph_width - 2, 2) + "\n\n";
  };
  const bool energy = limits(explanation, machine::Quantity::energy);
  const bool time = limits(explanation, machine::Quantity::cycle_time);
  if (energy)
    say("Moves (times, speeds, forces) and loads are taken as they are asked: with others a cycle may take more "
        "energy, which is limited.");
  else if (time)
    say("Times and speeds of moves are taken as they are asked: with others the cycle may take longer, and its time is "
        "limited.");
  for (const NotEased& each : explanation.not_eased) {
    if (energy) break;
    if (each.softens)
      say(
          fmt::format("Forces and loads of {}, and loads of what it carries, are taken as they are asked: under less a "
                      "ball nut without preload is softer, and axial_stiffness is asked for.",
                      each.axis));
    if (!time && !each.slower.empty())
      say(
          fmt::format("Times and speeds of moves of {} are taken as they are asked: slower ones need not keep {}, "
                      "which it enforces.",
                      each.axis,
                      fmt::join(each.slower, ", ")));
    if (!each.softens && !each.lighter.empty())
      say(
          fmt::format("Loads of {} and of what it carries are taken as they are asked: with lighter ones it need not "
                      "keep {}, which it enforces.",
                      each.axis,
                      fmt::join(each.lighter, ", ")));
  }
  return out;
}

std::string conflicts_text(const MachineResult& result, const Explanation& explanation, const Style& style) {
  std::string out = style.bad("No compliant build exists in these catalogues.") + "\n";
  if (explanation.catalogue_lacks) {
    out += wrapped(fmt::format("Not even with all that is asked and could be eased (limits, {}kinds of parts) lifted: "
                               "parts are missing in the catalogues, or what they are to do is beyond all of them.",
                               withheld_text(explanation).empty() ? "times, loads, " : ""),
                   paragraph_width,
                   0) +
           "\n\n";
    return out + empty_text(explanation) + unmet_text(explanation, style);
  }
  const std::size_t count = explanation.conflicts.size();
  if (count == 0)
    return out + "Why was not found out before the search was ended.\n\n" + empty_text(explanation) +
           unmet_text(explanation, style);
  out += count == 1 ? "\n"
                    : wrapped(fmt::format("There are {} separate conflicts; each must be resolved. The ways out of one "
                                          "are found without what the others ask for: their builds and prices need not "
                                          "meet that.",
                                          count),
                              paragraph_width,
                              0) +
                          "\n\n";
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
  if (explanation.too_little_together)
    out += wrapped(
               "The first way out of each, all together, is too little, proved: eased no further they still "
               "contradict each other. Ease one of them (--set) and ask again what the rest takes.",
               paragraph_width,
               0) +
           "\n\n";
  return out + empty_text(explanation) + unmet_text(explanation, style);
}

}  // namespace millwright::report
