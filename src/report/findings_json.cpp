// SPDX-License-Identifier: Apache-2.0
#include "report/findings_json.h"

namespace millwright::report {

namespace {

const char* severity_name(text::Severity severity) {
  if (severity == text::Severity::error) return "error";
  return severity == text::Severity::warning ? "warning" : "note";
}

}  // namespace

Json findings_of(const text::Diagnostics& diagnostics) {
  Json findings = Json::array();
  for (const text::Diagnostic& each : diagnostics.all())
    findings.push_back({{"severity", severity_name(each.severity)},
                        {"file", each.where.text ? each.where.text->path() : std::string()},
                        {"line", each.where.line},
                        {"column", each.where.column},
                        {"message", each.message},
                        {"hint", each.hint}});
  return findings;
}

}  // namespace millwright::report
