// SPDX-License-Identifier: Apache-2.0
#include "report/design_json.h"
#include "report/findings_json.h"
#include "report/json.h"
#include "report/json_value.h"

namespace millwright::report {

namespace {

Json derivation_of(const std::vector<scalar::DerivationLine>& lines) {
  Json json = Json::array();
  for (const scalar::DerivationLine& line : lines)
    json.push_back({{"symbol", line.symbol},
                    {"expression", line.expression},
                    {"substituted", line.substituted},
                    {"value", number(line.unit.from_si(line.value))},
                    {"unit", line.unit.name()}});
  return json;
}

Json audit_row(const evaluation::AuditRow& row) {
  Json json{{"axis", row.axis},
            {"id", row.id},
            {"quantity", row.quantity},
            {"printed", number(row.printed)},
            {"computed", number(row.computed)},
            {"line_value", number(row.line_value)},
            {"unit", row.unit},
            {"ratio", number(row.ratio)},
            {"verdict", evaluation::to_string(row.verdict)},
            {"printed_text", row.printed_text},
            {"formula", row.formula}};
  if (!row.factor_name.empty()) json["factor"] = row.factor_name;
  if (!row.missing.empty()) json["missing"] = row.missing;
  if (!row.violations.empty()) json["violations"] = row.violations;
  if (!row.derivation.empty()) json["derivation"] = derivation_of(row.derivation);
  return json;
}

/// A value in SI of what is said in degrees Celsius is in kelvins.
std::string name_in_si(const std::string& unit) { return unit == "degC" ? "K" : unit; }

Json input_of(const CalculationInput& input) {
  Json value = nullptr;
  if (!input.word.empty()) {
    value = input.word;
  } else if (input.is_list) {
    value = Json::array();
    for (const double each : input.values) value.push_back(number(each));
  } else if (!input.values.empty()) {
    value = number(input.values.front());
  }
  return Json{{"name", input.name},
              {"symbol", input.symbol},
              {"value", value},
              {"unit", name_in_si(input.unit)},
              {"given", input.given}};
}

Json figure_of(const catalogue::Figure& figure) {
  return Json{{"column", figure.column},
              {"meaning", figure.meaning},
              {"value", figure.value},
              {"unit", figure.unit},
              {"si", number(figure.si)},
              {"estimate", figure.estimate},
              {"standing", catalogue::to_string(figure.standing)},
              {"basis", figure.basis},
              {"confidence", figure.confidence},
              {"tolerance", number(figure.tolerance)},
              {"place", figure.place}};
}

}  // namespace

std::string audit_json(const evaluation::AuditReport& report, const std::string& file) {
  using evaluation::AuditVerdict;
  Json json = result_of("audit");
  json["problem"] = {{"title", report.title}, {"file", file}};
  json["source"] = report.source;
  json["rows"] = Json::array();
  for (const evaluation::AuditRow& row : report.rows) json["rows"].push_back(audit_row(row));
  for (const AuditVerdict verdict : {AuditVerdict::agrees,
                                     AuditVerdict::rounding,
                                     AuditVerdict::unit,
                                     AuditVerdict::differs,
                                     AuditVerdict::missing_input})
    json["counts"][evaluation::to_string(verdict)] = report.count(verdict);
  return text_of(json);
}

std::string calculation_json(const Calculation& calculation) {
  Json json = result_of("calc");
  json["formula"] = calculation.formula->name();
  json["handbook_id"] = calculation.formula->handbook_id();
  json["inputs"] = Json::array();
  for (const CalculationInput& input : calculation.inputs) json["inputs"].push_back(input_of(input));
  json["value"] = number(calculation.unit.from_si(calculation.value));
  json["unit"] = calculation.unit.name();
  json["value_si"] = number(calculation.value);
  json["unit_si"] = name_in_si(calculation.si_unit.name());
  json["derivation"] = derivation_of(calculation.derivation);
  json["warnings"] = calculation.warnings;
  json["source"] = calculation.formula->source();
  return text_of(json);
}

std::string formulas_json(const std::vector<const mechanics::Formula*>& formulas) {
  Json json = result_of("formulas");
  json["formulas"] = Json::array();
  for (const mechanics::Formula* formula : formulas) {
    Json arguments = Json::array();
    for (const mechanics::Argument& argument : formula->arguments()) {
      Json entry{
          {"name", argument.name}, {"symbol", argument.symbol}, {"unit", argument.unit}, {"meaning", argument.meaning}};
      if (argument.kind == mechanics::ArgumentKind::list) entry["list"] = true;
      if (argument.kind == mechanics::ArgumentKind::choice) entry["choices"] = argument.choices;
      arguments.push_back(std::move(entry));
    }
    json["formulas"].push_back({{"name", formula->name()},
                                {"handbook_id", formula->handbook_id()},
                                {"title", formula->title()},
                                {"symbol", formula->symbol()},
                                {"arguments", std::move(arguments)},
                                {"unit", formula->unit()},
                                {"display_unit", formula->display_unit()},
                                {"validity", formula->validity()},
                                {"source", formula->source()}});
  }
  return text_of(json);
}

Json catalogues_json(const catalogue::Inventory& inventory) {
  Json list = Json::array();
  for (const catalogue::LayerRecord& layer : inventory.layers) {
    list.push_back({{"place", layer.place}, {"files", layer.files}, {"rows", layer.rows}, {"sha256", layer.sha256}});
    for (const catalogue::RemarkFile& each : layer.remarks)
      list.back()["remarks"].push_back({{"file", each.name}, {"lines", each.lines}, {"sha256", each.sha256}});
  }
  return list;
}

std::string families_json(const std::vector<catalogue::FamilySummary>& families,
                          const catalogue::Inventory& inventory) {
  Json json = result_of("catalogue list");
  json["catalogues"] = catalogues_json(inventory);
  json["families"] = Json::array();
  for (const catalogue::FamilySummary& family : families) {
    Json prices = Json::array();
    for (const catalogue::PriceRange& price : family.prices)
      prices.push_back({{"column", price.column},
                        {"per", price.per},
                        {"currency", price.currency},
                        {"lowest", number(price.lowest)},
                        {"highest", number(price.highest)},
                        {"rows", price.rows}});
    json["families"].push_back({{"name", family.name},
                                {"title", family.title},
                                {"rows", family.rows},
                                {"manufacturers", family.manufacturers},
                                {"prices", std::move(prices)},
                                {"estimated_share", number(family.estimated_share)},
                                {"estimated_price_share", number(family.estimated_price_share)},
                                {"low_confidence_share", number(family.low_confidence_share)}});
  }
  return text_of(json);
}

std::string parts_json(std::string_view family, const std::vector<catalogue::PartLine>& parts) {
  Json json = result_of("catalogue list");
  json["family"] = family;
  json["parts"] = Json::array();
  for (const catalogue::PartLine& part : parts)
    json["parts"].push_back({{"manufacturer", part.manufacturer},
                             {"part_number", part.part_number},
                             {"figures", part.figures},
                             {"price", number(part.price.piece)},
                             {"price_per_metre", number(part.price.length)},
                             {"price_per_kilogram", number(part.price.mass)},
                             {"currency", part.price.currency},
                             {"confidence", part.confidence}});
  return text_of(json);
}

std::string sheets_json(const std::vector<catalogue::PartSheet>& sheets) {
  Json json = result_of("catalogue show");
  json["parts"] = Json::array();
  for (const catalogue::PartSheet& sheet : sheets) {
    Json figures = Json::array();
    for (const catalogue::Figure& figure : sheet.figures) figures.push_back(figure_of(figure));
    json["parts"].push_back({{"family", catalogue::declaration(sheet.family).name},
                             {"manufacturer", sheet.manufacturer},
                             {"part_number", sheet.part_number},
                             {"place", sheet.place},
                             {"figures", std::move(figures)}});
  }
  return text_of(json);
}

std::string lint_json(const text::Diagnostics& diagnostics, int files, int rows) {
  Json json = result_of("catalogue lint");
  json["files"] = files;
  json["rows"] = rows;
  json["errors"] = diagnostics.error_count();
  json["warnings"] = diagnostics.warning_count();
  json["findings"] = findings_of(diagnostics);
  return text_of(json);
}

}  // namespace millwright::report
