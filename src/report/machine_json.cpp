// SPDX-License-Identifier: Apache-2.0
#include "report/alternatives.h"
#include "report/design_json.h"
#include "report/incomplete.h"
#include "report/json.h"
#include "report/json_value.h"
#include "report/steering.h"
#include "report/tolerance_json.h"

namespace millwright::report {

using evaluation::Design;

namespace {

Json outside_validity_of(const Design& design) {
  Json lines = Json::array();
  for (const evaluation::OutsideValidity& line : design.outside_validity) {
    Json values = Json::array();
    for (const evaluation::OutsideValidity::Value& value : line.values) {
      Json numbers = Json::array();
      for (const double x : value.numbers) numbers.push_back(number(x));
      values.push_back({{"name", value.name}, {"values", numbers}, {"unit", value.unit}});
    }
    Json json{{"axis", line.axis},
              {"element", line.element},
              {"formula", line.formula},
              {"title", line.title},
              {"limit", line.sentence},
              {"arguments", values},
              {"source", line.source}};
    if (!line.constraint.empty()) json["id"] = line.constraint;
    lines.push_back(std::move(json));
  }
  return lines;
}

Json requirements_of(const MachineResult& result) {
  Json lines = Json::array();
  for (const RequirementLine& line : result.requirements)
    lines.push_back({{"name", line.key},
                     {"axes", line.axes},
                     {"value", number(line.value)},
                     {"unit", line.unit},
                     {"default", !line.given},
                     {"source", line.given ? "problem file" : line.source}});
  return lines;
}

Json problem_of(const MachineResult& result) { return Json{{"title", result.title}, {"file", result.file}}; }

Json timing_of(const MachineResult& result) {
  return Json{{"read", result.timing.read}, {"solve", result.timing.solve}, {"total", result.timing.total}};
}

Json certificate_of(const MachineResult& result) {
  return Json{{"combinations", number(result.certificate.combinations)},
              {"nodes", result.certificate.nodes},
              {"evaluations", result.certificate.evaluations},
              {"method", result.certificate.method},
              {"incomplete", incomplete_of(result.certificate.incomplete)}};
}

void add_missing(const MachineResult& result, Json& json) {
  if (result.missing.empty()) return;
  json["missing"] = Json::array();
  for (const MissingSlot& slot : result.missing)
    json["missing"].push_back({{"axis", slot.axis}, {"slot", slot.slot}, {"reason", slot.reason}});
}

void add_unmet(const MachineResult& result, Json& json) {
  if (result.status != Status::infeasible) return;
  json["unmet"] = Json::array();
  for (const evaluation::UnmetCheck& check : result.unmet)
    json["unmet"].push_back({{"axis", check.axis},
                             {"element", check.element},
                             {"id", check.id},
                             {"title", check.title},
                             {"requirement", check.requirement},
                             {"least_utilisation", number(check.least_utilisation)}});
  json["ways_out"] = Json::array();
  for (const evaluation::WayOut& way : result.ways_out) {
    Json changes = Json::array();
    for (const auto& change : way.changes)
      changes.push_back({{"axis", change.axis},
                         {"requirement", "position_error"},
                         {"from", number(change.from)},
                         {"to", number(change.to)},
                         {"unit", "m"},
                         {"over", number(change.over)}});
    json["ways_out"].push_back({{"lead_error", way.mapped ? "mapped" : "as made"},
                                {"least", way.least},
                                {"changes", changes},
                                {"cost", {{"value", number(way.cost)}, {"unit", way.currency}}},
                                {"mass", {{"value", number(way.mass)}, {"unit", "kg"}}}});
  }
}

/// The terms of a weighted sum, with what they amount to.
Json terms_of(const machine::Objective& objective, const Design& design) {
  Json terms = Json::array();
  for (const machine::ObjectiveTerm& term : objective.terms) {
    const double value = design.total(term.quantity);
    terms.push_back({{"name", machine::declaration(term.quantity).name},
                     {"weight", number(term.weight)},
                     {"value", number(value)},
                     {"unit", unit_of(term.quantity, design.currency)},
                     {"weighted", number(term.weight * value)}});
  }
  return terms;
}

Json objective_of(const MachineResult& result) {
  const std::string& name = result.objectives.front();
  const machine::Objective objective = machine::objective_named(name);
  const auto single = objective.single();
  const Design* design = result.designs.empty() ? nullptr : &result.designs.front();
  Json json{{"name", name},
            {"value", nullptr},
            {"unit", single ? unit_of(*single, result.currency) : "1"},
            {"lower_bound", nullptr},
            {"gap", nullptr}};
  if (design != nullptr) {
    json["value"] = number(design->total(objective));
    json["gap"] = number(result.gap);
    if (result.fixed_objective) json["fixed"] = true;
    if (!single) json["terms"] = terms_of(objective, *design);
    if (preference_counts(result)) {  // bound and gap are of what was compared
      json["compared_value"] = number(design->compared(objective));
      json["preference"] = number(design->preference->premium);
    }
  }
  if (result.status != Status::infeasible) json["lower_bound"] = number(result.lower_bound);
  return json;
}

/// The values of a front's objectives, by name.
Json objectives_of(const MachineResult& result, const Design& design) {
  Json values = Json::object();
  for (const std::string& name : result.objectives) values[name] = number(design.total(machine::objective_named(name)));
  return values;
}

void add_design(const MachineResult& result, const Design& design, Json& json) {
  json["totals"] = totals_of(design);
  json["build"] = build_of(design);
  json["checks"] = checks_json(result, design);
  json["outside_validity"] = outside_validity_of(design);
  json["formulas_watched"] = design.formulas_watched;
  json["governing"] = governing_of(result, design);
  add_tolerances(result, design, json);
  json["requirements"] = requirements_of(result);
}

/// What is known of the rest of a bill of materials.
std::string_view completion_name(evaluation::Completion completion) {
  switch (completion) {
    case evaluation::Completion::best:
      return "optimal";
    case evaluation::Completion::compliant:
      return "limit";
    case evaluation::Completion::refuted:
      return "infeasible";
    case evaluation::Completion::open:
      break;
  }
  return "open";
}

}  // namespace

std::string solve_json(const MachineResult& result) {
  Json json = result_of("solve");
  json["problem"] = problem_of(result);
  add_catalogues(result, json);
  add_steering(result, json);
  json["status"] = to_string(result.status);
  json["objective"] = objective_of(result);
  if (!result.designs.empty()) add_design(result, result.designs.front(), json);
  add_alternatives(result, json);
  add_missing(result, json);
  add_unmet(result, json);
  json["certificate"] = certificate_of(result);
  json["timing_s"] = timing_of(result);
  return text_of(json);
}

std::string front_json(const MachineResult& result) {
  Json json = result_of("pareto");
  json["problem"] = problem_of(result);
  add_catalogues(result, json);
  add_steering(result, json);
  json["status"] = to_string(result.status);
  json["objectives"] = result.objectives;
  if (preference_counts(result)) json["preference"] = number(result.designs.front().preference->premium);
  json["front"] = Json::array();
  for (const Design& design : result.designs) {
    Json point{{"objectives", objectives_of(result, design)},
               {"totals", totals_of(design)},
               {"build", build_of(design)},
               {"governing", governing_of(result, design)}};
    if (preference_counts(result)) point["compared_cost"] = number(design.preference->compared_cost);
    add_tolerances(result, design, point);
    json["front"].push_back(std::move(point));
  }
  json["complete"] = result.status != Status::limit;
  json["tolerance"] = number(result.certificate.front_tolerance);
  add_missing(result, json);
  add_unmet(result, json);
  json["certificate"] = certificate_of(result);
  json["timing_s"] = timing_of(result);
  return text_of(json);
}

std::string check_json(const MachineResult& result) {
  Json json = result_of("check");
  json["problem"] = problem_of(result);
  add_catalogues(result, json);
  add_steering(result, json);
  json["bill_of_materials"] = result.bom_file;
  const bool satisfied = !result.designs.empty() && result.designs.front().satisfied();
  json["satisfied"] = satisfied;
  json["completed"] = result.completed;
  if (!result.designs.empty()) json["completion"] = completion_name(result.completion);
  json["incomplete"] = incomplete_of(result.certificate.incomplete);
  if (!result.designs.empty()) add_design(result, result.designs.front(), json);
  add_missing(result, json);
  json["timing_s"] = timing_of(result);
  return text_of(json);
}

}  // namespace millwright::report
