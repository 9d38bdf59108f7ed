// SPDX-License-Identifier: Apache-2.0
#include "catalogue/waivers.h"

#include <fmt/format.h>

#include <algorithm>

#include "catalogue/rules.h"
#include "text/characters.h"
#include "text/nearest.h"

namespace millwright::catalogue {
Waivers::Waivers(const Table& table, text::Diagnostics& diagnostics)
    : table_(table), column_{table.family(), column(Family::steppers, "waiver").index} {
  for (int row = 0; row < table.rows(); ++row) {
    std::string_view rest = table.text(column_, row);
    if (rest.empty()) continue;
    std::vector<Waiver> waivers;
    while (!text::without_blanks(rest, " \t").empty()) {
      const std::string_view one = text::without_blanks(rest.substr(0, rest.find(';')), " \t");
      rest = rest.find(';') == rest.npos ? std::string_view() : rest.substr(rest.find(';') + 1);
      if (one.empty()) continue;
      const std::string_view rule = text::without_blanks(one.substr(0, one.find(':')), " \t");
      const std::string_view reason =
          one.find(':') == one.npos ? "" : text::without_blanks(one.substr(one.find(':') + 1), " \t");
      const std::vector<std::string_view>& names = rule_names();
      if (std::find(names.begin(), names.end(), rule) == names.end()) {
        diagnostics.error(table.where(row, column_),
                          fmt::format("waiver: there is no rule {}", text::in_quotes(rule)),
                          text::did_you_mean(rule, names, "a waiver is 'rule: reason', the rule as lint names it"));
      } else if (reason.empty()) {
        diagnostics.error(table.where(row, column_),
                          fmt::format("waiver of {} without a reason", rule),
                          fmt::format("write '{}: why this row is right'", rule));
      } else {
        waivers.push_back({rule, false});
      }
    }
    if (waivers.empty()) continue;
    of_row_.emplace(row, std::move(waivers));
    rows_.push_back(row);
  }
}

bool Waivers::excuses(int row, std::string_view rule) const {
  if (of_row_.empty()) return false;
  const auto found = of_row_.find(row);
  return found != of_row_.end() &&
         std::any_of(found->second.begin(), found->second.end(), [&](const Waiver& each) { return each.rule == rule; });
}

bool Waivers::excuse(int row, std::string_view rule) {
  bool excused = false;
  const auto found = of_row_.empty() ? of_row_.end() : of_row_.find(row);
  if (found == of_row_.end()) return false;
  for (Waiver& each : found->second) {
    if (each.rule != rule) continue;
    each.needed = true;
    excused = true;
  }
  return excused;
}

void Waivers::report_unneeded(text::Diagnostics& diagnostics) const {
  for (const int row : rows_) {
    for (const Waiver& each : of_row_.at(row)) {
      if (!each.needed)
        diagnostics.warning(table_.where(row, column_),
                            fmt::format("waiver of {} that this row does not need", each.rule),
                            "remove it, so that it cannot hide a later mistake");
    }
  }
}

}  // namespace millwright::catalogue
