// SPDX-License-Identifier: Apache-2.0
// What is usual among the rows of a table: the half of Plausibility that learns.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "catalogue/column_unit.h"
#include "catalogue/plausibility.h"

namespace millwright::catalogue {
namespace {

/// Rows that show a maker's habit.
constexpr std::size_t habit_needs = 5;

/// Rows looked at to learn what is usual; more would not make it surer.
constexpr std::size_t sample = 4096;

double element(std::vector<double>& values, std::size_t at) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

/// Every n-th of `rows`, so that at most `sample` remain.
std::vector<int> thinned(const std::vector<int>& rows) {
  if (rows.size() <= sample) return rows;
  std::vector<int> few;
  const double step = static_cast<double>(rows.size()) / static_cast<double>(sample);
  for (std::size_t i = 0; i < sample; ++i) few.push_back(rows[static_cast<std::size_t>(static_cast<double>(i) * step)]);
  return few;
}

/// The logarithm of the product of a relation's terms; NaN if one is not known.
template <class Parts>
double logarithm_of(const Parts& parts, const double* logs) {
  double sum = 0.0;
  for (const auto& part : parts) sum += part.exponent * logs[part.slot];
  return sum;
}

/// How far logarithms of a relation scatter about their centre. Leaves `values` changed.
double spread_about(double centre, std::vector<double>& values, const Relation& relation, double least) {
  for (double& value : values) value = std::abs(value - centre);
  // The middle deviation, or that of 85 % where most rows agree to the digit; of a normal scatter both are the same.
  const double middle = 1.4826 * element(values, values.size() / 2);
  const double wide = element(values, static_cast<std::size_t>(0.85 * static_cast<double>(values.size() - 1))) / 1.44;
  const double few = 1.0 + 2.0 / static_cast<double>(values.size());
  // Nor does a column that is wrong at random in many rows make a law of having none.
  const double most = 1.5 * relation.spread;
  return std::max({std::min(few * std::max(middle, wide), most), least});
}

}  // namespace

/// Few parts do not make a law of what only happens to be usual; a single figure has no law at all.
double Plausibility::least_spread(const Relation& relation) {
  return std::max((relation.habit ? 0.2 : relation.used().size() == 1 ? 0.7 : 0.33) * relation.spread, 0.02);
}

Plausibility::Kind Plausibility::make_kind(std::string_view name) const {
  Kind kind;
  const std::span<const Relation> all = relations(table_.family());
  for (std::size_t index = 0; index < all.size(); ++index) {
    const Relation& relation = all[index];
    if (!applies(relation, name)) continue;
    Active active{&relation, {}, index, false};
    double money = 0.0;
    for (const Term& term : relation.used()) {
      const Column wanted = column(table_.family(), term.column);
      auto at = std::find(kind.columns.begin(), kind.columns.end(), wanted);
      if (at == kind.columns.end()) {
        at = kind.columns.insert(at, wanted);
        kind.given.push_back(true);
      }
      if (!term.given) kind.given[static_cast<std::size_t>(at - kind.columns.begin())] = false;
      if (declaration(wanted).kind == catalogue::Kind::money) money += term.exponent;
      active.parts.push_back({static_cast<std::uint8_t>(at - kind.columns.begin()), term.exponent});
    }
    active.priced = money != 0.0;
    kind.relations.push_back(std::move(active));
  }
  if (kind.relations.size() > most || kind.columns.size() > most)
    throw std::logic_error("too many relations in a part family");
  kind.of_column.resize(kind.columns.size());
  for (std::size_t i = 0; i < kind.relations.size(); ++i) {
    for (const Part& part : kind.relations[i].parts)
      kind.of_column[part.slot].push_back({static_cast<std::uint8_t>(i), part.exponent});
  }
  for (const Column each : kind.columns) {
    kind.numbers.push_back(table_.numbers(each));
    kind.offsets.push_back(std::log(display_unit(each).from_si(1.0)));
  }
  if (table_.family() == Family::steppers) {
    const auto at = std::find(kind.columns.begin(), kind.columns.end(), column(Family::steppers, "holding_torque"));
    if (at != kind.columns.end()) kind.torque = static_cast<std::size_t>(at - kind.columns.begin());
    kind.phases = table_.numbers(column(Family::steppers, "phases_on"));
  }
  return kind;
}

void Plausibility::logarithms(const Kind& kind, int row, double* logs) const {
  for (std::size_t slot = 0; slot < kind.columns.size(); ++slot) {
    const double value = kind.numbers[slot][static_cast<std::size_t>(row)];
    logs[slot] = value > 0.0 ? std::log(value) + kind.offsets[slot] : not_known;
  }
  if (kind.torque < most) logs[kind.torque] += with_all_phases(kind, kind.torque, row);
}

/// The logarithm of what a torque stated with one phase on is taken times: relations speak of two.
double Plausibility::with_all_phases(const Kind& kind, std::size_t slot, int row) const {
  constexpr double half_ln_2 = 0.34657359027997264;
  if (slot >= most || slot != kind.torque) return 0.0;
  return kind.phases[static_cast<std::size_t>(row)] == 1.0 ? half_ln_2 : 0.0;
}

std::vector<Plausibility::Reference> Plausibility::learn(const Kind& kind,
                                                         const std::vector<int>& rows,
                                                         const std::vector<Reference>& otherwise) const {
  std::vector<Reference> learnt = otherwise;
  if (rows.size() < habit_needs) return learnt;
  std::vector<std::vector<double>> seen(kind.relations.size());
  std::array<double, most> logs;
  for (const int row : thinned(rows)) {
    logarithms(kind, row, logs.data());
    const bool foreign = !groups_[group_of_row_[static_cast<std::size_t>(row)]].currency.empty();
    for (std::size_t i = 0; i < kind.relations.size(); ++i) {
      if (foreign && kind.relations[i].priced) continue;
      const double sum = logarithm_of(kind.relations[i].parts, logs.data());
      if (!std::isnan(sum)) seen[i].push_back(sum);
    }
  }
  for (std::size_t i = 0; i < kind.relations.size(); ++i) {
    std::vector<double>& values = seen[i];
    const Relation& relation = *kind.relations[i].relation;
    if (values.size() < (relation.habit ? habit_needs : peers_needed)) continue;
    const double centre = element(values, values.size() / 2);
    if (std::abs(centre - std::log(relation.typical)) > 2.5 * relation.spread) continue;
    const double shift = learnt[i].centre - centre;
    learnt[i] = {centre,
                 spread_about(centre, values, relation, least_spread(relation)),
                 rows.size(),
                 learnt[i].least + shift,
                 learnt[i].greatest + shift};
  }
  return learnt;
}

/// What is usual of prices in one currency, over all kinds; only of relations that enough rows speak of.
Plausibility::OwnPrices Plausibility::learn_prices(const std::vector<int>& rows) const {
  OwnPrices usual;
  if (rows.size() < peers_needed) return usual;
  std::unordered_map<const Relation*, std::vector<double>> seen;
  std::array<double, most> logs;
  for (const int row : thinned(rows)) {
    const Kind& kind = kinds_[groups_[group_of_row_[static_cast<std::size_t>(row)]].kind];
    logarithms(kind, row, logs.data());
    for (const Active& each : kind.relations) {
      if (!each.priced) continue;
      const double sum = logarithm_of(each.parts, logs.data());
      if (!std::isnan(sum)) seen[each.relation].push_back(sum);
    }
  }
  for (auto& [relation, values] : seen) {
    if (values.size() < peers_needed) continue;
    const std::size_t peers = values.size();
    const double centre = element(values, peers / 2);
    const double limit = std::log(relation->impossible);
    usual[relation] = {centre, spread_about(centre, values, *relation, least_spread(*relation)), peers, -limit, limit};
  }
  return usual;
}

void Plausibility::group_rows(std::vector<std::vector<int>>& rows_of_group) {
  const std::string_view kind_name = kind_column(table_.family());
  const std::optional<Column> kind_of =
      kind_name.empty() ? std::nullopt : std::optional(column(table_.family(), kind_name));
  const std::optional<Column> currency_of = find_column(table_.family(), "currency");
  using Makers = std::unordered_map<std::string_view, std::uint32_t>;
  std::unordered_map<std::string_view, std::uint32_t> kinds;
  std::vector<std::unordered_map<std::string_view, Makers>> makers;  // by kind, then by currency
  group_of_row_.resize(static_cast<std::size_t>(table_.rows()));
  for (int row = 0; row < table_.rows(); ++row) {
    const std::string_view name = kind_of ? table_.text(*kind_of, row) : std::string_view();
    const auto [kind, new_kind] = kinds.try_emplace(name, static_cast<std::uint32_t>(kinds_.size()));
    if (new_kind) {
      kinds_.push_back(make_kind(name));
      makers.emplace_back();
    }
    std::string_view currency = currency_of ? table_.text(*currency_of, row) : std::string_view();
    if (currency == "USD" || currency == "EUR") currency = {};
    const auto [group, new_group] = makers[kind->second][currency].try_emplace(
        table_.manufacturer(row), static_cast<std::uint32_t>(groups_.size()));
    if (new_group) {
      groups_.push_back({kind->second, {}, currency});
      rows_of_group.emplace_back();
    }
    group_of_row_[static_cast<std::size_t>(row)] = group->second;
    rows_of_group[group->second].push_back(row);
  }
}

Plausibility::Plausibility(const Table& table) : table_(table) {
  std::vector<std::vector<int>> rows_of_group;
  group_rows(rows_of_group);
  std::vector<std::vector<std::uint32_t>> groups_of_kind(kinds_.size());
  std::unordered_map<std::string_view, std::vector<int>> foreign_rows;
  for (std::uint32_t g = 0; g < groups_.size(); ++g) {
    groups_of_kind[groups_[g].kind].push_back(g);
    if (groups_[g].currency.empty()) continue;
    std::vector<int>& rows = foreign_rows[groups_[g].currency];
    rows.insert(rows.end(), rows_of_group[g].begin(), rows_of_group[g].end());
  }
  std::unordered_map<std::string_view, OwnPrices> prices;
  for (const auto& [currency, rows] : foreign_rows) prices[currency] = learn_prices(rows);
  for (std::uint32_t k = 0; k < kinds_.size(); ++k) {
    const Kind& kind = kinds_[k];
    std::vector<Reference> declared;
    for (const Active& each : kind.relations) {
      const double limit = std::log(each.relation->impossible);
      declared.push_back({std::log(each.relation->typical), each.relation->spread, 0, -limit, limit});
    }
    std::vector<int> all;
    for (const std::uint32_t g : groups_of_kind[k])
      all.insert(all.end(), rows_of_group[g].begin(), rows_of_group[g].end());
    const std::vector<Reference> of_kind = learn(kind, all, declared);
    for (const std::uint32_t g : groups_of_kind[k]) {
      Group& group = groups_[g];
      group.references = learn(kind, rows_of_group[g], of_kind);
      if (group.currency.empty()) continue;
      const OwnPrices& own = prices[group.currency];
      for (std::size_t i = 0; i < kind.relations.size(); ++i) {
        if (!kind.relations[i].priced) continue;
        const auto found = own.find(kind.relations[i].relation);
        // Without a centre all that is derived from it is not known, and no figure is judged by it.
        if (found != own.end())
          group.references[i] = found->second;
        else
          group.references[i].centre = not_known;
      }
    }
  }
  rows_of_group.clear();  // of many rows as large as what is learnt next
  learn_kinships();
}

}  // namespace millwright::catalogue
