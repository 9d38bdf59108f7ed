// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lint_twins.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "scalar/unit.h"

namespace millwright::catalogue {
namespace {

/// Ratings of twins are equal up to this: tables are rounded, and housings carry a little differently.
constexpr double equal_up_to = 1.18;

bool differ(double a, double b) { return !(a < b * equal_up_to && b < a * equal_up_to); }

/// The figure that two twins contradict each other in least: in order, the middle one; of an even number, the lower.
double middle(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

Twins::Twins(const Table& table) : table_(table) {
  const Family family = table.family();
  const std::string_view size = family == Family::linear_guides      ? "size"
                                : family == Family::support_bearings ? "bore"
                                                                     : "";
  if (size.empty()) return;
  const Column static_rating = column(family, "static_load_rating");
  const Column dynamic_rating = column(family, "dynamic_load_rating");
  look(column(family, size), static_rating, dynamic_rating);
  look(column(family, size), dynamic_rating, static_rating);
  std::stable_sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) { return a.row < b.row; });
}

void Twins::look(Column size, Column same, Column other) {
  std::unordered_map<std::uint64_t, std::vector<int>> twins;
  const auto sizes = table_.numbers(size), ratings = table_.numbers(same), others = table_.numbers(other);
  for (int row = 0; row < table_.rows(); ++row) {
    const auto at = static_cast<std::size_t>(row);
    if (std::isnan(sizes[at]) || !(ratings[at] > 0) || !(others[at] > 0)) continue;
    std::uint64_t key = std::hash<std::string_view>{}(table_.manufacturer(row));
    for (const double each : {sizes[at], ratings[at]})
      key = (key ^ std::bit_cast<std::uint64_t>(each)) * 0x9e3779b97f4a7c15ULL + (key >> 29U);
    twins[key].push_back(row);
  }
  for (const auto& [key, rows] : twins) {
    std::vector<double> values;
    for (const int row : rows) values.push_back(others[static_cast<std::size_t>(row)]);
    const double usual = middle(values);
    // Of two that differ nobody knows which is right; of more, the fewer are odd.
    const auto agreeing = [&](int row) { return !differ(others[static_cast<std::size_t>(row)], usual); };
    const auto sound = std::count_if(rows.begin(), rows.end(), agreeing);
    if (sound == static_cast<std::ptrdiff_t>(rows.size())) continue;
    const bool tie = 2 * sound <= static_cast<std::ptrdiff_t>(rows.size());
    for (const int row : rows) {
      if (agreeing(row) && !tie) continue;
      const auto twin = std::find_if(rows.begin(), rows.end(), [&](int each) {
        return differ(others[static_cast<std::size_t>(each)], others[static_cast<std::size_t>(row)]);
      });
      if (twin != rows.end()) found_.push_back({row, *twin, other, same});
    }
  }
}

void Twins::examine(int row, const LintRow& figures) const {
  auto each =
      std::lower_bound(found_.begin(), found_.end(), row, [](const Contradiction& a, int b) { return a.row < b; });
  for (; each != found_.end() && each->row == row; ++each) {
    const ColumnDeclaration& declared = declaration(each->other);
    const LintRow& mine = figures;
    const double factor = table_.number(each->other, row) / table_.number(each->other, each->twin);
    mine.expect("load-ratings",
                each->other,
                false,
                fmt::format("{} {} {} is {:.3g} times that of {}, which has the same size and {}",
                            declared.name,
                            scalar::format_number(mine(each->other), 5),
                            declared.unit,
                            factor,
                            table_.part_number(each->twin),
                            declaration(each->same).name));
  }
}

}  // namespace millwright::catalogue
