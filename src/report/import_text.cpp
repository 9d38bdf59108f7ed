// SPDX-License-Identifier: Apache-2.0
#include "report/import_text.h"

#include <fmt/format.h>

#include "text/diagnostic.h"

namespace millwright::report {

namespace {

using catalogue::SourceColumn;
using catalogue::UnitOrigin;

std::string column_unit(const SourceColumn& column) {
  std::string unit = column.currency.empty() ? column.unit : column.currency == "?" ? "$" : column.currency;
  if (!column.currency.empty() && column.unit.size() > 2) unit += column.unit.substr(1);
  switch (column.unit_origin) {
    case UnitOrigin::none:
    case UnitOrigin::header:
      return unit;
    case UnitOrigin::units_row:
      return unit + ", units row";
    case UnitOrigin::cells:
      return column.converts ? "in the cells" : unit + (unit.empty() ? "in the cells" : ", in the cells");
    case UnitOrigin::given:
      return unit + ", given";
    case UnitOrigin::assumed:
      return unit + "? assumed";
  }
  return unit;
}

}  // namespace

std::string import_text(const catalogue::ImportMapping& mapping, const Style& style) {
  std::string text = style.heading(fmt::format("{} {} of {}",
                                               mapping.rows,
                                               mapping.rows == 1 ? "row" : "rows",
                                               catalogue::declaration(mapping.family).title)) +
                     "\n";
  for (const std::string& remark : mapping.remarks) text += fmt::format("  {}\n", remark);
  TextTable columns({{"their column"}, {"our column"}, {"unit"}, {"sure", Align::right}, {"why", Align::left, 44}});
  std::string kept;
  for (const SourceColumn& column : mapping.columns) {
    const std::string header = text::printable(column.header.empty() ? "(no header)" : column.header, 40) +
                               (column.occurrence > 1 ? fmt::format(" ({})", column.occurrence) : "");
    if (!column.target && !column.companion) {
      kept += fmt::format("  {}: kept as {}\n", header, column.kept_name);
      continue;
    }
    columns.add({header,
                 column.target ? std::string(catalogue::declaration(*column.target).name) : column.kept_name,
                 column_unit(column),
                 fmt::format("{:.0f} %", 100.0 * column.confidence),
                 fmt::format("{}", fmt::join(column.reasons, "; "))});
  }
  text += "\n" + columns.str(2, style);
  if (!kept.empty()) text += "\nNot ours\n" + kept;
  if (!mapping.constants.empty()) text += "\nThe same for all rows\n";
  for (const auto& [column, value] : mapping.constants)
    text += fmt::format(
        "  {}: {}\n", catalogue::declaration(column).name, value.empty() ? "(not known)" : text::printable(value));
  if (!mapping.missing.empty())
    text += fmt::format("\nNot given, though parts should have it: {}\n", fmt::join(mapping.missing, ", "));
  return text;
}

}  // namespace millwright::report
