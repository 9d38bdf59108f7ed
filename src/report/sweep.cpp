// SPDX-License-Identifier: Apache-2.0
#include "report/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/bom_csv.h"
#include "report/design_difference.h"
#include "report/design_json.h"
#include "report/design_text.h"
#include "report/incomplete.h"
#include "report/machine_text.h"
#include "report/quantity_text.h"
#include "report/steering.h"

namespace millwright::report {

using evaluation::Design;

namespace {

double objective_value(const SweepPoint& point, const std::string& objective) {
  return point.design()->total(machine::objective_named(objective));
}

const evaluation::CountedTotal* counted_of(const SweepPoint& point, machine::Quantity quantity) {
  if (point.design() == nullptr) return nullptr;
  const std::vector<evaluation::CountedTotal>& counted = point.design()->counted;
  const auto found = std::ranges::find(counted, quantity, &evaluation::CountedTotal::quantity);
  return found == counted.end() ? nullptr : &*found;
}

std::string proof_text(const SweepPoint& point) {
  if (!point.solved) return "not tried";
  if (point.proved()) return proof_gap(point.result) ? fmt::format("to {} %", *proof_gap(point.result)) : "proved";
  return point.design() == nullptr ? "open" : fmt::format("gap {} %", percent_rounded_up(point.result.gap));
}

/// "axis.x.moves[0].time" as "time".
std::string last_key(const std::string& path) { return path.substr(path.find_last_of('.') + 1); }

const char* status_word(const SweepPoint& point) { return point.solved ? to_string(point.result.status) : "not tried"; }

}  // namespace

bool has_own_column(const std::string& objective) {
  return objective != "cost" && objective != "mass" && objective != "cycle_time";
}

std::vector<machine::Quantity> further_columns(const Sweep& sweep) {
  std::vector<machine::Quantity> columns;
  for (const machine::Quantity quantity : sweep.counted) {
    const std::string name(machine::declaration(quantity).name);
    if (has_own_column(name) && name != sweep.first().objectives.front()) columns.push_back(quantity);
  }
  return columns;
}

std::string counted_text(const SweepPoint& point, machine::Quantity quantity) {
  const evaluation::CountedTotal* total = counted_of(point, quantity);
  const std::string name(machine::declaration(quantity).name);
  return total == nullptr ? std::string() : objective_text(name, total->value, point.result.currency);
}

std::string no_build_reason(const SweepPoint& point) {
  if (!point.solved) return "the search was ended before this value";
  if (point.design() != nullptr) return {};
  const MachineResult& result = point.result;
  if (result.status == Status::limit) return "no build was found before the search was ended";
  std::vector<std::string> parts;
  for (const MissingSlot& slot : result.missing)
    parts.push_back(fmt::format("no candidate for {}.{} ({})", slot.axis, slot.slot, slot.reason));
  for (const evaluation::UnmetCheck& check : result.unmet)
    parts.push_back(
        check.least_utilisation < machine::useless_utilisation
            ? fmt::format("{} {} is at least {:.0f} %", check.axis, check.id, 100.0 * check.least_utilisation)
            : fmt::format("{} {}: no part will do", check.axis, check.id));
  if (parts.empty()) return "every combination of parts fails a check";
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<evaluation::IncompleteParts> incomplete_in(const Sweep& sweep) {
  std::vector<evaluation::IncompleteParts> all;
  for (const SweepPoint& point : sweep.points) {
    const auto& more = point.result.certificate.incomplete;
    all.insert(all.end(), more.begin(), more.end());
  }
  return evaluation::united(all);
}

std::vector<std::string> sweep_changes(const Sweep& sweep) {
  std::vector<std::string> out;
  const Design* before = nullptr;
  for (const SweepPoint& point : sweep.points) {
    std::vector<std::string> changes;
    if (point.design() != nullptr && before != nullptr)
      for (const DesignDifference& each : differences(*before, *point.design()))
        changes.push_back(fmt::format("{}.{} {}", each.axis, each.slot, each.short_now));
    out.push_back(fmt::format("{}", fmt::join(changes, ", ")));
    if (point.design() != nullptr) before = point.design();
  }
  return out;
}

/// How the builds were compared, where parts are preferred.
std::string preference_note(const Sweep& sweep) {
  for (const SweepPoint& point : sweep.points)
    if (preference_counts(point.result))
      return "  Compared with the prices of preferred parts divided by 1 + preference; the\n  prices shown are the "
             "real "
             "ones.\n";
  return {};
}

std::string sweep_text(const Sweep& sweep, const Style& style) {
  const MachineResult& first = sweep.first();
  const std::string& objective = first.objectives.front();
  std::string out =
      style.heading(first.title.empty() ? first.file : first.title + " (" + first.file + ")") + "\n\n" +
      (first.robust ? "  Builds compliant for every value within the stated tolerances (--robust).\n\n" : "") +
      steering_text(first, style);
  out += style.heading(fmt::format("{} from {} to {}: the build of least {} at each value",
                                   sweep.path,
                                   sweep.points.front().text,
                                   sweep.points.back().text,
                                   objective)) +
         "\n" + preference_note(sweep);
  std::vector<TableColumn> columns{{last_key(sweep.path), Align::right}};
  if (has_own_column(objective)) columns.push_back({objective, Align::right});
  const std::vector<machine::Quantity> further = further_columns(sweep);
  for (const machine::Quantity quantity : further)
    columns.push_back({std::string(machine::declaration(quantity).name), Align::right});
  for (const std::string& title : {first.currency, std::string("kg"), std::string("cycle")})
    columns.push_back({title, Align::right});
  columns.push_back({"proof"});
  columns.push_back({"changes against the line above", Align::left, 32});
  TextTable table(columns);
  const std::vector<std::string> changes = sweep_changes(sweep);
  bool open = false;
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    const SweepPoint& point = sweep.points[i];
    const Design* design = point.design();
    std::vector<std::string> cells{point.text};
    if (has_own_column(objective))
      cells.push_back(design == nullptr ? ""
                                        : objective_text(objective, objective_value(point, objective), first.currency));
    for (const machine::Quantity quantity : further) cells.push_back(counted_text(point, quantity));
    if (design == nullptr) {
      cells.insert(cells.end(), {point.proved() ? style.bad("none") : "-", "", ""});
    } else {
      cells.insert(cells.end(),
                   {fmt::format("{:.2f}", design->cost),
                    fmt::format("{:.3f}", design->mass),
                    fmt::format("{:.4g} s", point.cycle_time)});
    }
    cells.push_back(proof_text(point));
    cells.push_back(design == nullptr ? no_build_reason(point) : changes[i]);
    open = open || !point.proved();
    table.add(cells);
  }
  out += table.str(2, style);
  if (style.brief) return out;
  out += incomplete_text(incomplete_in(sweep), style);
  if (open) out += "  gap: a build may exist that is so much better; none is proved where it says open.\n";
  const bool built = std::any_of(
      sweep.points.begin(), sweep.points.end(), [](const SweepPoint& point) { return point.design() != nullptr; });
  if (built) out += "  cycle: every move of every axis with its dwell, one after the other.\n";
  return out + fmt::format("time: {:.2f} s reading, {:.2f} s solving\n", sweep.timing.read, sweep.timing.solve);
}

std::string sweep_csv(const Sweep& sweep) {
  const std::string& objective = sweep.first().objectives.front();
  std::string out = csv_cell(sweep.unit.empty() ? sweep.path : fmt::format("{} [{}]", sweep.path, sweep.unit)) +
                    ",status,proved,cost,currency,mass [kg],cycle_time [s],";
  if (has_own_column(objective)) out += csv_cell(objective) + ",";
  const std::vector<machine::Quantity> further = further_columns(sweep);
  for (const machine::Quantity quantity : further) {
    const std::string name(machine::declaration(quantity).name);
    out += csv_cell(fmt::format("{} [{}]", name, objective_unit(name, sweep.first().currency))) + ",";
  }
  // What bound and proof are of, where parts are preferred.
  const bool preferred = std::any_of(sweep.points.begin(), sweep.points.end(), [](const SweepPoint& point) {
    return preference_counts(point.result);
  });
  out += preferred ? "compared_value,compared_lower_bound,changes,reason\n" : "lower_bound,changes,reason\n";
  const std::vector<std::string> changes = sweep_changes(sweep);
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    const SweepPoint& point = sweep.points[i];
    out += fmt::format("{},{},{},", point.value, status_word(point), point.proved() ? "yes" : "no");
    if (const Design* design = point.design())
      out += fmt::format("{:.12g},{},{:.12g},{:.12g},", design->cost, design->currency, design->mass, point.cycle_time);
    else
      out += ",,,,";
    if (has_own_column(objective))
      out += point.design() == nullptr ? "," : fmt::format("{:.12g},", objective_value(point, objective));
    for (const machine::Quantity quantity : further) {
      const evaluation::CountedTotal* total = counted_of(point, quantity);
      out += total == nullptr ? "," : fmt::format("{:.12g},", total->value);
    }
    if (preferred && point.design() != nullptr)
      out += fmt::format("{:.12g}", point.design()->compared(machine::objective_named(objective)));
    if (preferred) out += ",";
    if (point.design() != nullptr) out += fmt::format("{:.12g}", point.result.lower_bound);
    out += "," + csv_cell(changes[i]) + "," + csv_cell(no_build_reason(point)) + "\n";
  }
  return out;
}

std::string sweep_json(const Sweep& sweep) {
  const MachineResult& first = sweep.first();
  Json json = result_of("sweep");
  json["problem"] = {{"title", first.title}, {"file", first.file}};
  json["objective"] = {{"name", first.objectives.front()},
                       {"unit", objective_unit(first.objectives.front(), first.currency)}};
  add_steering(first, json);
  json["setting"] = {{"path", sweep.path}, {"unit", sweep.unit}};
  json["points"] = Json::array();
  const std::vector<std::string> changes = sweep_changes(sweep);
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    const SweepPoint& point = sweep.points[i];
    Json line{{"value", number(point.value)},
              {"text", point.text},
              {"status", status_word(point)},
              {"proved", point.proved()}};
    if (const Design* design = point.design()) {
      line["objective"] = {{"value", number(objective_value(point, first.objectives.front()))},
                           {"lower_bound", number(point.result.lower_bound)},
                           {"gap", number(point.result.gap)}};
      if (preference_counts(point.result)) {  // bound and gap are of what was compared
        line["objective"]["compared_value"] =
            number(design->compared(machine::objective_named(first.objectives.front())));
        line["objective"]["compared_cost"] = number(design->preference->compared_cost);
        line["objective"]["preference"] = number(design->preference->premium);
      }
      line["totals"] = totals_of(*design);
      line["cycle_time_s"] = number(point.cycle_time);
      line["changes"] = changes[i];
      line["build"] = build_of(*design);
    } else {
      line["reason"] = no_build_reason(point);
    }
    json["points"].push_back(std::move(line));
  }
  json["incomplete"] = incomplete_of(incomplete_in(sweep));
  json["timing_s"] = {{"read", sweep.timing.read}, {"solve", sweep.timing.solve}, {"total", sweep.timing.total}};
  return text_of(json);
}

}  // namespace millwright::report
