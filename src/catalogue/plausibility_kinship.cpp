// SPDX-License-Identifier: Apache-2.0
// Which rows are siblings, and what they say: the part of Plausibility that compares closely.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "catalogue/plausibility.h"

namespace millwright::catalogue {
namespace {

/// Relations of a wider spread are compared with those of all makers only.
constexpr double widest_law = 0.4;
/// Of the declared spread, what prices of the same maker scatter at least.
constexpr double least_of_prices = 0.5;

/// Numbers for pairs of a group and a text, in the order of their first row.
class Numbering {
 public:
  std::uint32_t of(std::uint32_t group, std::string_view text) {
    if (last_ != none && group == last_group_ && text == last_text_) return last_;  // rows of a series stand together
    std::uint64_t key = std::hash<std::string_view>{}(text);
    key ^= (group + 0x9e3779b97f4a7c15ULL) + (key << 6U) + (key >> 2U);
    last_ = numbers_.try_emplace(key, static_cast<std::uint32_t>(numbers_.size())).first->second;
    last_group_ = group;
    last_text_ = text;
    return last_;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  /// By hash alone: that two of a few thousand names share 64 bits does not happen, and would merely mix two series.
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  std::uint32_t last_ = none, last_group_ = 0;
  std::string_view last_text_;
};

}  // namespace

std::vector<std::uint32_t> Plausibility::groups_by_series() const {
  const std::optional<Column> series = find_column(table_.family(), "series");
  std::vector<std::uint32_t> group_of_row;
  if (!series) return group_of_row;
  Numbering numbering;
  group_of_row.reserve(group_of_row_.size());
  for (int row = 0; row < table_.rows(); ++row)
    group_of_row.push_back(numbering.of(group_of_row_[static_cast<std::size_t>(row)], table_.text(*series, row)));
  return group_of_row;
}

std::vector<std::uint32_t> Plausibility::groups_by_maker() const {
  std::unordered_map<std::string_view, std::uint32_t> currencies{{std::string_view(), 0}};
  Numbering numbering;
  std::vector<std::uint32_t> group_of_row;
  group_of_row.reserve(group_of_row_.size());
  for (int row = 0; row < table_.rows(); ++row) {
    const Group& group = groups_[group_of_row_[static_cast<std::size_t>(row)]];
    const auto currency = currencies.try_emplace(group.currency, static_cast<std::uint32_t>(currencies.size())).first;
    group_of_row.push_back(numbering.of(currency->second, table_.manufacturer(row)));
  }
  return group_of_row;
}

Plausibility::Kinship Plausibility::learn_kinship(std::vector<std::uint32_t> group_of_row) const {
  Kinship kinship;
  kinship.group_of_row = std::move(group_of_row);
  const std::size_t count = relations(table_.family()).size();
  kinship.siblings = Siblings(count);
  std::vector<std::uint32_t> sizes;
  for (const std::uint32_t group : kinship.group_of_row) {
    if (group >= sizes.size()) sizes.resize(group + 1, 0);
    ++sizes[group];
  }
  // The first rows of each group that suffice, or, of a large one, every n-th.
  std::vector<std::vector<int>> chosen(sizes.size());
  std::vector<std::uint32_t> met(sizes.size(), 0);
  for (int row = 0; row < table_.rows(); ++row) {
    const std::uint32_t group = kinship.group_of_row[static_cast<std::size_t>(row)];
    if (sizes[group] <= Siblings::needed) continue;
    const auto step = static_cast<std::uint32_t>((sizes[group] + Siblings::sample - 1) / Siblings::sample);
    if (met[group]++ % step == 0) chosen[group].push_back(row);
  }
  kinship.place_of_group.assign(sizes.size(), none);
  std::vector<std::vector<float>> seen(count);
  std::array<double, most> logs;
  std::uint32_t places = 0;
  for (std::size_t group = 0; group < chosen.size(); ++group) {
    if (chosen[group].empty()) continue;
    for (const int row : chosen[group]) {
      const Kind& kind = kinds_[groups_[group_of_row_[static_cast<std::size_t>(row)]].kind];
      logarithms(kind, row, logs.data());
      for (const Active& each : kind.relations) {
        double sum = 0.0;
        for (const Part& part : each.parts) sum += part.exponent * logs[part.slot];
        if (!std::isnan(sum)) seen[each.index].push_back(static_cast<float>(sum));
      }
    }
    kinship.siblings.add_group(seen, sizes[group] > Siblings::sample);
    kinship.place_of_group[group] = places++;
  }
  return kinship;
}

void Plausibility::learn_kinships() {
  if (std::vector<std::uint32_t> groups = groups_by_series(); !groups.empty())
    kinships_.push_back(learn_kinship(std::move(groups)));
  kinships_.push_back(learn_kinship(group_of_row_));
  kinships_.push_back(learn_kinship(groups_by_maker()));
}

Plausibility::Reference Plausibility::reference_for(
    const Group& group, const Kind& kind, std::size_t relation, int row, double sum) const {
  Reference reference = group.references[relation];
  if (std::isnan(sum) || std::isnan(reference.centre)) return reference;
  const Active& active = kind.relations[relation];
  const Relation& declared = *active.relation;
  // What scatters widely over all parts is the designer's choice, and that siblings chose alike is no law. But a maker
  // prices all its parts alike, and states its figures in one way.
  const bool custom = active.priced || declared.habit;
  if (!custom && declared.spread > widest_law) return reference;
  const double least = active.priced ? least_of_prices * declared.spread : least_spread(declared);
  for (const Kinship& each : kinships_) {
    if (&each == &kinships_.back() && !custom) break;  // of other kinds
    const std::uint32_t place = each.place_of_group[each.group_of_row[static_cast<std::size_t>(row)]];
    if (place == none) continue;
    const auto view = each.siblings.without(place, active.index, sum);
    if (!view) continue;
    const double spread = std::max(view->spread, least);
    // Siblings that are wrong all together are no measure, nor are those that differ more than others do.
    if (std::abs(view->centre - std::log(declared.typical)) > 2.5 * declared.spread) break;
    if (spread >= reference.spread) break;
    const double shift = reference.centre - view->centre;
    return {view->centre, spread, view->count, reference.least + shift, reference.greatest + shift};
  }
  return reference;
}

bool Plausibility::is_unusual(int row, std::string_view rule) const {
  constexpr double unusual = 1.0;
  const Group& group = groups_[group_of_row_[static_cast<std::size_t>(row)]];
  const Kind& kind = kinds_[group.kind];
  std::array<double, most> logs;
  logarithms(kind, row, logs.data());
  for (std::size_t i = 0; i < kind.relations.size(); ++i) {
    if (kind.relations[i].relation->id != rule) continue;
    double sum = 0.0;
    for (const Part& part : kind.relations[i].parts) sum += part.exponent * logs[part.slot];
    const Reference reference = reference_for(group, kind, i, row, sum);
    if (std::abs(sum - reference.centre) > unusual * reference.spread) return true;
  }
  return false;
}

}  // namespace millwright::catalogue
