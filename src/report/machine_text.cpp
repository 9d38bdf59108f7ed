// SPDX-License-Identifier: Apache-2.0
#include "report/machine_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <span>

#include "report/alternatives.h"
#include "report/certificate_text.h"
#include "report/design_difference.h"
#include "report/design_text.h"
#include "report/incomplete.h"
#include "report/page_texts.h"
#include "report/rounded.h"
#include "report/steering.h"
#include "report/tolerance_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;
using evaluation::Verdict;

namespace {

constexpr int digits_of_sums = 7;

/// "Cheapest", "Lightest"; "Best" of a weighted sum.
std::string best_word(const std::string& objective) {
  const auto quantity = machine::objective_named(objective).single();
  return quantity ? std::string(machine::declaration(*quantity).best) : "Best";
}

/// A word of a heading inside a sentence.
std::string in_sentence(std::string word) {
  word.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(word.front())));
  return word;
}

/// All totals, that of the objective first; of a weighted sum "435.17 = 360.11 USD + 25 * 3.002 kg" before them.
std::string all_totals(const std::string& name, const Design& design) {
  const machine::Objective objective = machine::objective_named(name);
  if (const auto quantity = objective.single()) return totals_text(design, *quantity);
  std::vector<std::string> parts;
  for (const machine::ObjectiveTerm& term : objective.terms) {
    const std::string value = quantity_text(term.quantity, design.total(term.quantity), design.currency);
    parts.push_back(term.weight == 1.0 ? value : fmt::format("{} * {}", term.weight, value));
  }
  return fmt::format("{} = {}\n  {} = {}; {}",
                     name,
                     objective_text(name, design.total(objective), design.currency),
                     name,
                     fmt::join(parts, " + "),
                     totals_text(design));
}

/// ", preferred parts up to 5 % dearer"; nothing where none could be chosen.
std::string preference_words(const MachineResult& result) {
  if (!preference_counts(result)) return {};
  return fmt::format(", preferred parts up to {:.4g} % dearer", 100.0 * result.designs.front().preference->premium);
}

/// "Cheapest compliant build", "Best compliant build, preferred parts up to 5 % dearer".
std::string build_words(const MachineResult& result) {
  return best_word(result.objectives.front()) +
         (robust_to_something(result) ? " build compliant over all tolerances" : " compliant build") +
         preference_words(result) + (proof_gap(result) ? fmt::format(", to {} %", *proof_gap(result)) : "");
}

/// What a proof is about when the command line asks for more than the problem file.
const char* as_asked(const MachineResult& result) {
  return result.steering.empty() ? "" : ", with what was asked for above";
}

/// Checks that fail whatever is chosen.
std::string unmet_text(const MachineResult& result, const Style& style) {
  TextTable table({{"axis"}, {"id"}, {"check", Align::left, 44}, {"at least", Align::right}, {"set by"}});
  for (const evaluation::UnmetCheck& check : result.unmet)
    table.add({check.axis, check.id, check.title, least_text(check), check.requirement});
  return "\nProved: these checks fail whatever is chosen\n" + table.str(2, style);
}

/// "x: position_error 10 -> 163 um over 700 mm", and what the cheapest build costs then.
std::string ways_out_text(const MachineResult& result) {
  if (result.ways_out.empty()) return {};
  std::string out = "\nWays out, found by solving (to 1 %)\n";
  const scalar::Unit micrometre = scalar::Unit::of("um");
  const auto um = [&](double metres) { return scalar::format_number(micrometre.from_si(metres), 3); };
  for (const evaluation::WayOut& way : result.ways_out) {
    out += way.mapped ? "  with lead_error = \"mapped\" (the controller corrects the measured lead error)\n"
                      : "  with lead errors as made\n";
    for (const auto& change : way.changes)
      out += fmt::format("    {}: position_error {} -> {} um over {:.4g} mm\n",
                         change.axis,
                         um(change.from),
                         um(change.to),
                         1e3 * change.over);
    if (!way.least) out += "    (time was up: less may do)\n";
    out += fmt::format("    cheapest build then: {:.2f} {}, {:.3f} kg\n", way.cost, way.currency, way.mass);
  }
  return out;
}

/// What has to be known about checks that fail.
std::string failure_notes(const Design& design, const Style& style) {
  std::set<std::string> notes;
  for (const Check& check : design.checks)
    if (check.verdict == Verdict::violated && check.kind != machine::ConstraintKind::soft && !check.note.empty())
      notes.insert(check.id + ": " + check.note);
  std::string out;
  for (const std::string& note : notes) out += "  " + wrapped(note, style.width - 2, 4) + "\n";
  return out;
}

std::string failures_text(const MachineResult& result, const Design& design, const Style& style) {
  const bool wide = style.width >= wide_checks;
  TextTable table({{""},
                   {""},
                   {"", Align::left, 0, false, wide ? 0U : 2U},
                   {"", Align::right},
                   {"", Align::left, 0, true},
                   {"", Align::right},
                   {""}});
  for (const std::string& axis : checked_axes(result))
    for (const Check* check : checks_of(design, axis))
      if (check->verdict == Verdict::violated && check->kind != machine::ConstraintKind::soft)
        table.add({axis,
                   wide ? check->id : "",
                   wide ? title_of(design, *check) : check_cell(design, *check, check->id),
                   scalar::format_number(check->value),
                   fmt::format("> {}{}{}",
                               scalar::format_number(check->limit),
                               check->unit == "1" ? "" : " ",
                               check->unit == "1" ? "" : check->unit),
                   utilisation_text(*check),
                   wide ? worst_text(*check) : ""});
  if (table.empty()) return {};
  return style.bad("Failed checks") + "\n" + table.str(2, style) + failure_notes(design, style) + "\n";
}

/// The build of a front that is best in one of its objectives.
const Design& best_in(const MachineResult& result, const std::string& name) {
  const machine::Objective objective = machine::objective_named(name);
  return *std::min_element(result.designs.begin(), result.designs.end(), [&](const Design& a, const Design& b) {
    return a.total(objective) < b.total(objective);
  });
}

/// What a reader compares first, of the ends of a front.
std::string end_text(const MachineResult& result,
                     const Design& design,
                     const std::string& objective,
                     const Style& style) {
  const char* of = result.status == Status::limit ? " of these" : "";  // a better one may not have been met
  return style.heading(best_word(objective) + of + ": " + all_totals(objective, design)) + "\n\n" +
         parts_text(result, design, style) + governing_text(result, design, style);
}

/// What the page leaves out.
std::string more_text(const Design& design) {
  const std::string outside = design.outside_validity.empty()
                                  ? std::string()
                                  : fmt::format("{} formula{} outside the range that {} stated for, ",
                                                design.outside_validity.size(),
                                                design.outside_validity.size() == 1 ? " is used" : "s are used",
                                                design.outside_validity.size() == 1 ? "it is" : "they are");
  return fmt::format("--full: {}all {} checks, requirements and assumptions\n", outside, design.checks.size());
}

/// Of two or more: "cost and mass"; "cost, mass and energy".
std::string objectives_text(std::span<const std::string> names) {
  return fmt::format("{} and {}", fmt::join(names.first(names.size() - 1), ", "), names.back());
}

/// What the parts, ramps and dimensions are that a bill of materials leaves open.
std::string completion_text(const MachineResult& result) {
  constexpr std::string_view ended = "The search was ended (time, memory or Ctrl-C)";
  switch (result.completion) {
    case evaluation::Completion::best:
      if (!result.completed) return {};
      return fmt::format("What it leaves open was chosen so that the build is the {} compliant one{}.\n",
                         in_sentence(best_word(result.objectives.front())),
                         preference_words(result));
    case evaluation::Completion::compliant:
      if (!result.completed) return {};
      return fmt::format(
          "What it leaves open was chosen so that the build complies. {} before it was proved to be the "
          "{} one{}.\n",
          ended,
          in_sentence(best_word(result.objectives.front())),
          preference_words(result));
    case evaluation::Completion::refuted:
      if (!result.completed) return {};
      return "Nothing complies with what it holds (proved). What it leaves open was filled with the cheapest parts "
             "that fit.\n";
    case evaluation::Completion::open:
      break;
  }
  return fmt::format("{} before it was known whether anything complies with what it holds.{}\n",
                     ended,
                     result.completed ? " What it leaves open was filled with the cheapest parts that fit." : "");
}

}  // namespace

std::string title_text(const MachineResult& result, const Style& style) {
  const std::string title = result.title.empty() ? result.file : result.title + " (" + result.file + ")";
  return style.heading(title) + "\n\n" + steering_text(result, style);
}

std::string nothing_text(const MachineResult& result, const Style& style) {
  if (!result.missing.empty()) {
    std::string out = style.bad("No build is possible:") + "\n";
    for (const MissingSlot& slot : result.missing)
      out += fmt::format("  axis {}: no candidate for slot {} ({})\n", slot.axis, slot.slot, slot.reason);
    return out;
  }
  if (result.status == Status::limit)
    return "The search was ended before a compliant build was found; whether there is one is open.\n";
  if (result.robust)
    return style.bad("No build is compliant for every value within the stated tolerances") +
           fmt::format(" in these catalogues{}{}.\n",
                       as_asked(result),
                       std::isnan(result.robust_without)
                           ? ", nor with the figures as they stand; without --robust more is said"
                           : "; with the figures as they stand there is one");
  return style.bad("No compliant build exists") +
         fmt::format(" in these catalogues{}: every combination of parts fails at least one check.\n",
                     as_asked(result)) +
         (result.has_budget
              ? "  A limit of the whole machine counts too: without it, 'solve' says what a build takes.\n"
              : "") +
         (result.unmet.empty()
              ? "  'explain' finds which of the things asked contradict each other.\n"
                "  'check' with a bill of materials (and --complete) shows by how much.\n"
              : unmet_text(result, style) + ways_out_text(result) +
                    (result.ways_out.empty() ? "  'explain' finds by how much each of the things asked must give way.\n"
                                             : ""));
}

std::string objective_text(const std::string& objective, double value, const std::string& currency) {
  if (const auto quantity = machine::objective_named(objective).single())
    return quantity_text(*quantity, value, currency);
  return scalar::format_number(value, digits_of_sums);
}

std::string objective_bound_text(const std::string& objective, double bound, const std::string& currency) {
  if (const auto quantity = machine::objective_named(objective).single())
    return quantity_bound_text(*quantity, bound, currency);
  return scalar::format_number(rounded_down(bound, last_digit(bound, digits_of_sums)), digits_of_sums);
}

std::string gap_percent(double gap) { return fmt::format("{:.2f}", rounded_up(100.0 * gap, 0.01)); }

std::string objective_unit(const std::string& objective, const std::string& currency) {
  const auto quantity = machine::objective_named(objective).single();
  if (!quantity) return {};
  return *quantity == machine::Quantity::cost ? currency : std::string(machine::declaration(*quantity).unit);
}

std::string solve_text(const MachineResult& result, const Style& style) {
  std::string out = title_text(result, style);
  if (result.designs.empty()) {
    out += nothing_text(result, style) + "\n";
    return result.missing.empty() && !style.brief ? out + certificate_text(result, style) : out;
  }
  const Design& design = result.designs.front();
  const std::string& objective = result.objectives.front();
  out += best_is_proved(result)
             ? style.heading(build_words(result) + ": " + all_totals(objective, design)) + "\n\n"
             : style.heading("Best build found before the search was ended: " + all_totals(objective, design)) +
                   fmt::format("\n  proved so far: not below {}, gap {} %\n\n",
                               objective_bound_text(objective, result.lower_bound, design.currency),
                               gap_percent(result.gap));
  if (result.fixed_objective && result.status == Status::optimal)
    out += "  Moves state their times, so every build takes as long: this is the cheapest.\n\n";
  out += parts_text(result, design, style) + dimensions_text(design, style) + alternatives_text(result, style);
  if (style.brief) return out;
  if (!style.full)
    return out + closest_checks_text(result, design, style) + tolerances_text(result, design, style) +
           certificate_text(result, style) + more_text(design);
  return out + governing_text(result, design, style) + checks_text(result, design, style) +
         tolerances_text(result, design, style) + outside_validity_text(design, style) +
         requirements_text(result, style) + assumptions_text(design, style) + certificate_text(result, style);
}

std::string front_text(const MachineResult& result, const Style& style) {
  std::string out = title_text(result, style);
  if (result.designs.empty()) {
    out += nothing_text(result, style) + "\n";
    return result.missing.empty() ? out + certificate_text(result, style) : out;
  }
  out += style.heading(fmt::format("{} build{} that no other{} beats in {}{}",
                                   result.designs.size(),
                                   result.designs.size() == 1 ? "" : "s",
                                   result.status == Status::limit ? " found before the search was ended" : "",
                                   objectives_text(result.objectives),
                                   preference_words(result))) +
         "\n";
  std::vector<TableColumn> columns{
      {"", Align::right}, {result.designs.front().currency, Align::right}, {"kg", Align::right}};
  for (const evaluation::CountedTotal& each : result.designs.front().counted)
    columns.push_back({std::string(machine::declaration(each.quantity).name), Align::right});
  columns.push_back({"supply", Align::right});
  columns.push_back({"changes against the line above", Align::left, 60});
  TextTable table(columns);
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    const Design& design = result.designs[i];
    std::string changes;
    if (i > 0)
      for (const DesignDifference& each : differences(result.designs[i - 1], design))
        if (each.slot != "supply_voltage")  // has its own column
          changes += fmt::format("{}{}.{} {}", changes.empty() ? "" : ", ", each.axis, each.slot, each.short_now);
    std::vector<std::string> cells{
        std::to_string(i + 1), fmt::format("{:.2f}", design.cost), fmt::format("{:.3f}", design.mass)};
    for (const evaluation::CountedTotal& each : design.counted)
      cells.push_back(quantity_text(each.quantity, each.value, design.currency));
    cells.push_back(scalar::format(design.supply_voltage, scalar::Unit::of("V")));
    cells.push_back(changes);
    table.add(cells);
  }
  out += table.str(2, style) + "\n";
  if (const std::string robust = robust_front_text(result, Texts(Language::english)); !robust.empty())
    out += "  " + wrapped(robust, style.width - 2, 2) + "\n\n";
  if (style.brief) return out;
  for (std::size_t k = 0; k < result.objectives.size() && (k == 0 || result.designs.size() > 1); ++k)
    out += end_text(result, best_in(result, result.objectives[k]), result.objectives[k], style);
  return out + assumptions_text(result.designs.front(), style) + certificate_text(result, style);
}

std::string check_text(const MachineResult& result, const Style& style) {
  std::string out = title_text(result, style);
  if (result.designs.empty()) return out + nothing_text(result, style);
  const Design& design = result.designs.front();
  const auto failed = std::count_if(design.checks.begin(), design.checks.end(), [](const Check& check) {
    return check.verdict == Verdict::violated && check.kind != machine::ConstraintKind::soft;
  });
  out += fmt::format("Bill of materials: {}\n", result.bom_file);
  out += failed == 0 ? style.good("It satisfies every check.") + "\n"
                     : style.bad(fmt::format("It fails {} of {} checks.", failed, design.checks.size())) + "\n";
  out += completion_text(result) + fmt::format("Totals: {}\n\n", totals_text(design));
  out += failures_text(result, design, style);
  if (style.brief) return out;
  std::string left_out = incomplete_text(result.certificate.incomplete, style);
  if (!left_out.empty()) left_out += "\n";
  if (!style.full)
    return out + closest_checks_text(result, design, style, false) + parts_text(result, design, style) +
           dimensions_text(design, style) + tolerances_text(result, design, style) + left_out + more_text(design);
  return out + governing_text(result, design, style) + parts_text(result, design, style) +
         dimensions_text(design, style) + checks_text(result, design, style) + tolerances_text(result, design, style) +
         outside_validity_text(design, style) + requirements_text(result, style) + left_out +
         assumptions_text(design, style);
}

}  // namespace millwright::report
