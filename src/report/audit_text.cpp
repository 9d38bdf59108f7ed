// SPDX-License-Identifier: Apache-2.0
#include "report/audit_text.h"

#include <fmt/format.h>

#include "scalar/unit.h"

namespace millwright::report {

using evaluation::AuditReport;
using evaluation::AuditRow;
using evaluation::AuditVerdict;

namespace {

std::string number_text(const std::optional<double>& value, int significant = 6) {
  return value ? scalar::format_number(*value, significant) : std::string("-");
}

std::string verdict_text(AuditVerdict verdict, const Style& style) {
  const std::string word = to_string(verdict);
  switch (verdict) {
    case AuditVerdict::agrees:
      return style.good(word);
    case AuditVerdict::unit:
    case AuditVerdict::differs:
      return style.bad(word);
    case AuditVerdict::rounding:
    case AuditVerdict::missing_input:
      break;
  }
  return word;
}

std::string remark(const AuditRow& row) {
  if (!row.missing.empty()) return row.missing;
  return row.factor_name;
}

std::string computed_text(const AuditRow& row) {
  return number_text(row.computed) + (row.computed && row.unit != "1" ? " " + row.unit : "");
}

/// The unit is said once where both figures have it.
std::string computed_beside(const AuditRow& row) {
  const bool same = row.computed && row.printed_text.ends_with(" " + row.unit);
  return same ? number_text(row.computed) : computed_text(row);
}

/// Everything in a line.
std::string wide_table(const AuditReport& report, const Style& style) {
  TextTable table({{"axis"},
                   {"id"},
                   {"quantity", Align::left, 28},
                   {"printed", Align::right},
                   {"computed", Align::right},
                   {"ratio", Align::right},
                   {"verdict"},
                   {"", Align::left, 40}});
  for (const AuditRow& row : report.rows)
    table.add({row.axis,
               row.id,
               row.quantity,
               row.printed_text,
               computed_text(row),
               number_text(row.ratio),
               verdict_text(row.verdict, style),
               remark(row)});
  return table.str(2, style) + "\n";
}

/// A table of each axis, remarks below the quantities.
std::string narrow_tables(const AuditReport& report, const Style& style) {
  std::string out;
  for (std::size_t i = 0; i < report.rows.size();) {
    const std::string& axis = report.rows[i].axis;
    TextTable table({{"id", Align::left, 0, true},
                     {"quantity", Align::left, 28, false, 2},
                     {"printed", Align::right},
                     {"computed", Align::right},
                     {"ratio", Align::right},
                     {"verdict", Align::left, 0, true}});
    for (; i < report.rows.size() && report.rows[i].axis == axis; ++i) {
      const AuditRow& row = report.rows[i];
      const std::string why = remark(row);
      table.add({row.id,
                 row.quantity + (why.empty() ? "" : "\n(" + why + ")"),
                 row.printed_text,
                 computed_beside(row),
                 number_text(row.ratio, 4),
                 verdict_text(row.verdict, style)});
    }
    out += style.heading(axis) + "\n" + table.str(2, style) + "\n";
  }
  return out;
}

std::string derivation_text(const AuditRow& row, const Style& style) {
  std::string out = fmt::format("{}  {}  {}\n", style.heading(row.id), row.quantity, style.faint(row.formula));
  for (const scalar::DerivationLine& line : row.derivation) out += equation(scalar::to_string(line), 4, style.width);
  for (const std::string& violation : row.violations) out += "    outside the formula's validity: " + violation + "\n";
  return out + fmt::format("    printed {}, {}: {}{}\n\n",
                           row.printed_text,
                           row.computed ? "computed " + computed_text(row) : "not computed",
                           verdict_text(row.verdict, style),
                           remark(row).empty() ? "" : " (" + remark(row) + ")");
}

}  // namespace

std::string audit_text(const AuditReport& report, bool derive, const Style& style) {
  std::string out = style.heading(report.title) + "\n\n";
  const bool room = style.width >= 120;
  if (!style.brief) out += room ? wide_table(report, style) : narrow_tables(report, style);
  if (derive)
    for (const AuditRow& row : report.rows) out += derivation_text(row, style);
  out += fmt::format("{} results:", report.rows.size());
  const char* separator = " ";
  for (const AuditVerdict verdict : {AuditVerdict::agrees,
                                     AuditVerdict::rounding,
                                     AuditVerdict::unit,
                                     AuditVerdict::differs,
                                     AuditVerdict::missing_input}) {
    out += fmt::format("{}{} {}", separator, report.count(verdict), to_string(verdict));
    separator = ", ";
  }
  return out + "\n";
}

}  // namespace millwright::report
