// SPDX-License-Identifier: Apache-2.0
#include "report/findings_json.h"
#include "report/import_text.h"

namespace millwright::report {

namespace {

using catalogue::SourceColumn;
using catalogue::UnitOrigin;

const char* name_of(UnitOrigin origin) {
  switch (origin) {
    case UnitOrigin::none:
      return "none";
    case UnitOrigin::header:
      return "header";
    case UnitOrigin::units_row:
      return "units row";
    case UnitOrigin::cells:
      return "cells";
    case UnitOrigin::given:
      return "given";
    case UnitOrigin::assumed:
      return "assumed";
  }
  return "";
}

Json column_json(const SourceColumn& column) {
  Json json{{"header", column.header}, {"occurrence", column.occurrence}};
  json["column"] = column.target      ? Json(catalogue::declaration(*column.target).name)
                   : column.companion ? Json(column.kept_name)
                                      : Json(nullptr);
  if (!column.target && !column.companion) {
    json["kept_as"] = column.kept_name;
    return json;
  }
  json["confidence"] = number(column.confidence);
  json["reasons"] = column.reasons;
  json["unit"] = column.unit;
  json["unit_origin"] = name_of(column.unit_origin);
  if (!column.currency.empty()) json["currency"] = column.currency;
  if (column.target && catalogue::is_number_column(*column.target))
    json["decimal"] = column.mark == catalogue::DecimalMark::comma ? "comma" : "point";
  return json;
}

}  // namespace

std::string import_json(const ImportOutcome& outcome, const text::Diagnostics& diagnostics) {
  Json json = result_of("catalogue import");
  json["file"] = outcome.file;
  json["family"] = nullptr;
  if (outcome.mapping != nullptr) {
    const catalogue::ImportMapping& mapping = *outcome.mapping;
    json["family"] = catalogue::declaration(mapping.family).name;
    json["rows"] = mapping.rows;
    json["columns"] = Json::array();
    for (const SourceColumn& column : mapping.columns) json["columns"].push_back(column_json(column));
    json["constants"] = Json::object();
    for (const auto& [column, value] : mapping.constants)
      json["constants"][std::string(catalogue::declaration(column).name)] = value;
    json["missing"] = mapping.missing;
    json["remarks"] = mapping.remarks;
  }
  json["written"] = outcome.written.empty() ? Json(nullptr) : Json(outcome.written);
  if (!outcome.written.empty()) {
    json["rows_written"] = outcome.rows_written;
    json["lines_left_out"] = outcome.lines_left_out;
  }
  json["errors"] = diagnostics.error_count();
  json["warnings"] = diagnostics.warning_count();
  json["findings"] = findings_of(diagnostics);
  return text_of(json);
}

}  // namespace millwright::report
