// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "report/design_json.h"
#include "report/explanation_checks.h"
#include "report/explanation_conflicts.h"
#include "report/explanation_text.h"
#include "report/incomplete.h"
#include "report/json_value.h"
#include "report/steering.h"
#include "report/tolerance_json.h"

namespace millwright::report {

using evaluation::Explanation;
using machine::Condition;
using machine::ConditionKind;

namespace {

Json condition_of(const Condition& condition, const std::string& currency) {
  Json json{{"axis", condition.axis},
            {"name", condition.name},
            {"default", !condition.given},
            {"place", place_text(condition)}};
  if (!condition.setting.empty()) json["setting"] = condition.setting;
  if (!condition.beside.empty()) json["setting_beside"] = condition.beside;
  if (!condition.meaning.empty()) json["meaning"] = condition.meaning;
  if (condition.kind == ConditionKind::choice) {
    json["value"] = condition.present;
  } else {
    json["value"] = number(condition.value);
    json["unit"] = condition.unit.empty() ? currency : condition.unit;
  }
  return json;
}

Json conflicts_of(const Explanation& explanation, const std::string& currency) {
  Json conflicts = Json::array();
  for (const evaluation::Conflict& conflict : explanation.conflicts) {
    Json members = Json::array(), ways = Json::array();
    for (const std::size_t i : conflict.conditions)
      members.push_back(condition_of(explanation.conditions[i], currency));
    for (const evaluation::Relaxation& way : conflict.ways) {
      const Condition& condition = way.changed(explanation.conditions);
      Json json{{"axis", condition.axis}, {"name", condition.name}, {"enough", way.enough}, {"to", number(way.to)}};
      if (way.instead) {
        json["instead_of"] = explanation.conditions[way.condition].name;
        json["not_enough"] = Json::array();
        for (const double value : way.refused) json["not_enough"].push_back(number(value));
      }
      if (!condition.setting.empty()) json["setting"] = condition.setting;
      if (!condition.beside.empty()) json["setting_beside"] = condition.beside;
      json["breaks"] = Json::array();
      for (const evaluation::Check& check : way.broken)
        json["breaks"].push_back({{"axis", check.axis},
                                  {"id", check.id},
                                  {"title", check.title},
                                  {"utilisation", number(check.utilisation)}});
      if (way.design) {
        json["totals"] = totals_of(*way.design);
        json["build"] = build_of(*way.design);
      }
      ways.push_back(std::move(json));
    }
    conflicts.push_back({{"conditions", members}, {"ways_out", ways}});
  }
  return conflicts;
}

void add_infeasible(const MachineResult& result, const Explanation& explanation, Json& json) {
  json["catalogue_lacks"] = explanation.catalogue_lacks;
  json["conflicts"] = conflicts_of(explanation, result.currency);
  if (explanation.all_resolved) json["all_resolved"] = {{"totals", totals_of(*explanation.all_resolved)}};
  if (explanation.too_little_together) json["all_resolved"] = nullptr;
  json["missing"] = Json::array();
  for (const evaluation::EmptySlot& slot : explanation.empty_slots)
    json["missing"].push_back({{"axis", slot.axis}, {"slot", slot.slot}, {"reason", slot.reason}});
  json["unmet"] = Json::array();
  for (const evaluation::UnmetCheck& check : explanation.unmet)
    json["unmet"].push_back({{"axis", check.axis},
                             {"element", check.element},
                             {"id", check.id},
                             {"title", check.title},
                             {"requirement", check.requirement},
                             {"least_utilisation", number(check.least_utilisation)},
                             {"slot", check.slot},
                             {"nearest", check.nearest}});
}

void add_feasible(const MachineResult& result, const Explanation& explanation, Json& json) {
  json["totals"] = totals_of(*explanation.design);
  json["build"] = build_of(*explanation.design);
  json["choices"] = Json::array();
  for (const evaluation::SlotChoice& choice : explanation.choices)
    json["choices"].push_back({{"axis", choice.axis},
                               {"slot", choice.slot},
                               {"part", choice.part},
                               {"forced", !choice.next_best.has_value()},
                               {"settled", choice.settled},
                               {"next_best", number(choice.next_best)},
                               {"at_most", number(choice.at_most)},
                               {"instead", choice.instead}});
  json["prices"] = Json::array();
  for (const evaluation::Price& price : explanation.prices) {
    Json line = condition_of(explanation.conditions[price.condition], result.currency);
    line["eased_to"] = number(price.to);
    line["saving"] = number(price.saving);
    line["saving_without"] = number(price.at_most);
    json["prices"].push_back(std::move(line));
  }
  json["unsettled"] = Json::array();
  for (const std::size_t i : explanation.unsettled)
    json["unsettled"].push_back(condition_of(explanation.conditions[i], result.currency));
  json["rates"] = Json::array();
  for (const evaluation::Rate& rate : explanation.rates) {
    Json line = condition_of(explanation.conditions[rate.condition], result.currency);
    line["slope"] = number(rate.slope);
    json["rates"].push_back(std::move(line));
  }
  json["rates_hold_for"] = Json::array();
  for (const evaluation::DimensionLine& each : explanation.moving)
    json["rates_hold_for"].push_back(
        {{"axis", each.axis}, {"name", each.name}, {"value", number(each.value)}, {"unit", each.unit}});
  json["costless"] = explanation.costless;
  add_tolerances(result, explanation, json);
}

}  // namespace

std::string explanation_json(const MachineResult& result, const Explanation& explanation) {
  Json json = result_of("explain");
  json["problem"] = {{"title", result.title}, {"file", result.file}};
  add_catalogues(result, json);
  add_steering(result, json);
  json["status"] = to_string(explanation.status == solver::Status::optimal      ? Status::optimal
                             : explanation.status == solver::Status::infeasible ? Status::infeasible
                                                                                : Status::limit);
  json["objective"] = explanation.objective;
  if (explanation.design && explanation.design->preference)
    json["preference"] = number(explanation.design->preference->premium);
  if (explanation.design)
    add_feasible(result, explanation, json);
  else
    add_infeasible(result, explanation, json);
  json["not_eased"] = withheld_kinds(explanation);
  json["checks"] = Json::array();
  for (const NamedCheck& check : named_checks(explanation))
    json["checks"].push_back(
        {{"id", check.id}, {"title", check.title}, {"requirement", check.requirement}, {"source", check.source}});
  json["incomplete"] = incomplete_of(result.certificate.incomplete);
  json["solves"] = explanation.solves;
  json["timing_s"] = {{"total", explanation.seconds}};
  return text_of(json);
}

}  // namespace millwright::report
