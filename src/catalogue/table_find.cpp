// SPDX-License-Identifier: Apache-2.0
// How a part is found by the number a person writes.
#include <algorithm>

#include "catalogue/table.h"
#include "text/diagnostic.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

std::string listed(const std::vector<std::string_view>& names) {
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) result += i + 1 == names.size() ? " and " : ", ";
    result += text::printable(names[i], 60);
  }
  return result;
}

void keep_unique(std::vector<std::string_view>& names) {
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
}

/// Whether `name` is one of the semicolon-separated `aliases`.
bool has_alias(std::string_view aliases, std::string_view name) {
  while (!aliases.empty()) {
    const std::size_t end = std::min(aliases.find(';'), aliases.size());
    std::string_view alias = aliases.substr(0, end);
    while (!alias.empty() && alias.front() == ' ') alias.remove_prefix(1);
    while (!alias.empty() && alias.back() == ' ') alias.remove_suffix(1);
    if (alias == name) return true;
    aliases.remove_prefix(std::min(end + 1, aliases.size()));
  }
  return false;
}

}  // namespace

std::vector<int> Table::rows_by_alias(std::string_view name) const {
  std::vector<int> found;
  const std::optional<Column> aliases = find_column(family_, "aliases");
  for (int row = 0; aliases && row < rows(); ++row) {
    if (has_alias(text(*aliases, row), name)) found.push_back(row);
  }
  return found;
}

Found Table::find(std::string_view part_number_wanted, std::string_view manufacturer_wanted) const {
  const std::string family_name(declaration(family_).name);
  const std::string wanted = text::in_quotes(part_number_wanted);
  std::vector<int> there = rows_of(part_number_wanted);
  const bool by_alias = there.empty();
  if (by_alias) there = rows_by_alias(part_number_wanted);
  Found found;
  if (there.empty()) {
    std::vector<std::string_view> names;
    for (int row = 0; row < rows(); ++row) names.push_back(part_number(row));
    found.problem = Found::Problem::unknown;
    found.error = "no part " + wanted + " in " + family_name;
    found.hint = text::did_you_mean(part_number_wanted, names);
    return found;
  }
  std::vector<std::string_view> makers;
  std::vector<std::string_view> parts;
  for (const int row : there) {
    makers.push_back(manufacturer(row));
    if (!manufacturer_wanted.empty() && manufacturer(row) != manufacturer_wanted) continue;
    found.rows.push_back(row);
    parts.push_back(part_number(row));
  }
  keep_unique(makers);
  if (found.rows.empty()) {
    found.problem = Found::Problem::other_maker;
    found.error = "no part " + wanted + " by " + text::in_quotes(manufacturer_wanted) + " in " + family_name;
    found.hint = "it is made by " + listed(makers);
  } else if (manufacturer_wanted.empty() && makers.size() > 1) {
    found.problem = Found::Problem::ambiguous;
    found.error = "part number " + wanted + " is ambiguous in " + family_name;
    found.hint = "name the manufacturer: " + listed(makers);
  } else if (by_alias && parts.size() > 1) {
    found.problem = Found::Problem::ambiguous;
    found.error = "the name " + wanted + " is ambiguous in " + family_name;
    found.hint = "write one of " + listed(parts);
  }
  if (!found) found.rows.clear();
  return found;
}

}  // namespace millwright::catalogue
