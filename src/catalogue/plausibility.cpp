// SPDX-License-Identifier: Apache-2.0
#include "catalogue/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scalar/unit.h"

namespace millwright::catalogue {
namespace {

/// How often a given figure is wrong, before anything is looked at: one in fifty.
constexpr double wrong_before = 0.02;
/// Of wrong figures, how many are so by no usual slip (typing errors); such factors spread over a thousandth to a
/// thousandfold.
constexpr double share_of_others = 0.3;
constexpr double width_of_others = 13.8;
/// What falsifies a figure by less than half is no slip but a part that is a little different.
constexpr double least_of_others = 0.405;
/// Two neighbouring figures, two of the same unit, any two: how often a pair is swapped.
constexpr double swapped_neighbours = 3e-3, swapped_alike = 5e-4, swapped_any = 1e-5;
/// Beyond the declared limits of a relation, whatever the odds.
constexpr double certainty_of_impossible = 0.95;

/// Rows of which no figure promises to explain more than this, and no relation is farther off than so many spreads,
/// are not looked into: e^-4 is less than what all hypotheses together would need.
constexpr double promise_needed = 4.0;
constexpr double far_off = 4.5;

/// Minus the logarithm of Student's t density, up to a constant.
constexpr double freedom = 8.0;
constexpr double power = (freedom + 1.0) / 2.0;
double surprise(double residual, double spread) {
  const double scaled = residual / spread;
  return power * std::log(1.0 + scaled * scaled / freedom);
}

}  // namespace

struct Plausibility::Evidence {
  std::array<Reference, most> references;
  std::array<double, most> logs;
  std::array<double, most> residuals;
  std::array<double, most> surprises;  ///< of the relations as they are
  std::array<double, most> promise;    ///< of the columns: about the most that a change of it could explain
  std::size_t torque = most;           ///< the column whose logarithm is not that of the figure as it is written
  double more_torque = 0.0;            ///< but by so much larger

  double added(std::size_t a) const { return a == torque ? more_torque : 0.0; }
  /// The logarithm of the figure as it is written.
  double written(std::size_t a) const { return logs[a] - added(a); }

  /// How much better the relations are explained if column `a` is off by `by` (logarithm).
  double gain(const Kind& kind, std::size_t a, double by) const {
    double sum = 0.0;
    for (const Part& part : kind.of_column[a]) {
      if (std::isnan(residuals[part.slot])) continue;
      sum += surprises[part.slot] - surprise(residuals[part.slot] - part.exponent * by, references[part.slot].spread);
    }
    return sum;
  }

  /// The same if `a` and `b` stand in each other's place.
  double gain_of_swap(const Kind& kind, std::size_t a, std::size_t b) const {
    const double by = written(a) - written(b);
    double sum = gain(kind, a, by) + gain(kind, b, -by);
    for (const Part& one : kind.of_column[a]) {  // relations that both stand in were counted twice, and wrongly
      for (const Part& other : kind.of_column[b]) {
        if (one.slot != other.slot || std::isnan(residuals[one.slot])) continue;
        const double spread = references[one.slot].spread, residual = residuals[one.slot];
        sum += surprise(residual - one.exponent * by, spread) + surprise(residual + other.exponent * by, spread) -
               surprises[one.slot] - surprise(residual - (one.exponent - other.exponent) * by, spread);
      }
    }
    return sum;
  }
};

std::optional<Suspicion> Plausibility::examine(int row, const std::function<bool(std::string_view)>& excused) const {
  const Group& group = groups_[group_of_row_[static_cast<std::size_t>(row)]];
  const Kind& kind = kinds_[group.kind];
  Evidence evidence;
  logarithms(kind, row, evidence.logs.data());
  evidence.torque = kind.torque;
  evidence.more_torque = with_all_phases(kind, kind.torque, row);
  bool strange = false;
  for (std::size_t i = 0; i < kind.relations.size(); ++i) {
    double sum = 0.0;
    for (const Part& part : kind.relations[i].parts) sum += part.exponent * evidence.logs[part.slot];
    evidence.references[i] = reference_for(group, kind, i, row, sum);
    const Reference& reference = evidence.references[i];
    const double residual = sum - reference.centre;
    evidence.residuals[i] = residual;
    strange |=
        residual < reference.least || residual > reference.greatest || std::abs(residual) > far_off * reference.spread;
  }
  // Most rows are in order. What a figure could explain at the most is, near enough, what it would by the normal
  // distribution, which needs no logarithms; where a relation is far off that is no measure.
  for (std::size_t a = 0; a < kind.columns.size(); ++a) {
    double pull = 0.0, precision = 0.0;
    for (const Part& part : kind.of_column[a]) {
      const double residual = evidence.residuals[part.slot], spread = evidence.references[part.slot].spread;
      if (std::isnan(residual)) continue;
      const double weight = part.exponent / (spread * spread);
      pull += weight * residual;
      precision += weight * part.exponent;
    }
    evidence.promise[a] = precision > 0.0 ? 0.5 * pull * pull / precision : 0.0;
    strange |= evidence.promise[a] > promise_needed;
  }
  if (!strange) return std::nullopt;
  for (std::size_t i = 0; i < kind.relations.size(); ++i) {
    if (excused(kind.relations[i].relation->id)) evidence.residuals[i] = not_known;
    const double spread = evidence.references[i].spread;
    evidence.surprises[i] = surprise(evidence.residuals[i], spread);
    const double residual = evidence.residuals[i];
    const bool impossible = residual < evidence.references[i].least || residual > evidence.references[i].greatest;
    if (!impossible && !(std::abs(residual) > far_off * spread)) continue;
    for (const Part& part : kind.relations[i].parts) evidence.promise[part.slot] = evidence.surprises[i] + 99.0;
  }
  Suspicion found = describe(kind, evidence);
  if (found.certainty < certainty_to_report) return std::nullopt;
  return found;
}

namespace {

double swap_prior(Column a, Column b) {
  if (std::abs(static_cast<int>(a.index) - static_cast<int>(b.index)) == 1) return swapped_neighbours;
  return declaration(a).unit == declaration(b).unit ? swapped_alike : swapped_any;
}

}  // namespace

/// A hypothesis: figure `a` is `exp(by)` times what it should be; or it was swapped with `b`.
struct Plausibility::Fault {
  std::size_t a = 0;
  std::size_t b = 0;  ///< = a: not swapped
  double by = 0.0;
  std::string_view cause;
  double weight = 0.0;  ///< logarithm of prior times likelihood, that of "all is well" being 0
};

std::vector<Plausibility::Fault> Plausibility::faults_of(const Kind& kind, const Evidence& row) {
  const std::size_t slots = kind.columns.size();
  std::vector<Fault> faults;
  for (std::size_t a = 0; a < slots; ++a) {
    if (kind.given[a] || std::isnan(row.logs[a]) || row.promise[a] < 0.5 * promise_needed) continue;
    double precision = 0.0;
    Fault best{a, a, 0.0, {}, 0.0};
    for (const Part& part : kind.of_column[a]) {
      if (std::isnan(row.residuals[part.slot])) continue;
      const double spread = row.references[part.slot].spread / std::abs(part.exponent);
      precision += 1.0 / (spread * spread);
      const double by = row.residuals[part.slot] / part.exponent;
      if (std::abs(by) < least_of_others) continue;
      const double gain = row.gain(kind, a, by);
      if (gain > best.weight) best = {a, a, by, {}, gain};
    }
    if (precision == 0.0) continue;  // no relation that counts says anything of it
    for (const Slip& slip : slips(kind.columns[a])) {
      const double by = std::log(slip.factor);
      faults.push_back({a, a, by, slip.words, std::log(wrong_before * slip.weight) + row.gain(kind, a, by)});
    }
    best.weight +=
        std::log(wrong_before * share_of_others * std::min(1.0, 2.5 / std::sqrt(precision) / width_of_others));
    faults.push_back(best);
    for (std::size_t b = 0; b < slots; ++b) {
      const double by = row.written(a) - row.written(b);
      if (b == a || kind.given[b] || std::isnan(by) || std::abs(by) < 0.05) continue;
      if (b < a && row.promise[b] >= 0.5 * promise_needed) continue;  // seen from b
      const double prior = std::log(swap_prior(kind.columns[a], kind.columns[b]));
      if (prior + 1.5 * (row.promise[a] + row.promise[b]) < -4.0) continue;
      faults.push_back({a, b, by, {}, prior + row.gain_of_swap(kind, a, b)});
    }
  }
  return faults;
}

bool Plausibility::explain(const Kind& kind, const Evidence& row, const Fault& fault, Suspicion& found) {
  // What the other figures say, each relation by its spread, and less the farther it is from the fault's own guess.
  const double guess = row.logs[fault.a] - fault.by;
  double sum = 0.0, weights = 0.0;
  std::vector<std::pair<double, std::size_t>> off;
  for (std::size_t i = 0; i < kind.relations.size(); ++i) {
    if (std::isnan(row.residuals[i])) continue;
    const double scaled = std::abs(row.residuals[i]) / row.references[i].spread;
    for (const Part& part : kind.relations[i].parts) {
      if (part.slot == fault.b && fault.a != fault.b && scaled > 2.0) off.emplace_back(-scaled, i);
      if (part.slot != fault.a) continue;
      const double spread = row.references[i].spread / std::abs(part.exponent);
      const double says = row.logs[fault.a] - row.residuals[i] / part.exponent;
      const double away = (says - guess) / spread;
      const double weight = 1.0 / (spread * spread * (1.0 + 0.25 * away * away));
      sum += weight * says;
      weights += weight;
      off.emplace_back(-scaled, i);
      found.impossible |= row.references[i].excludes(row.residuals[i]);
    }
  }
  if (off.empty() || !(weights > 0.0)) return false;
  const double middle = sum / weights;
  const double margin = 2.0 * std::max(0.02, 1.0 / std::sqrt(weights));
  found.expected_low = std::exp(middle - row.added(fault.a) - margin);
  found.expected_high = std::exp(middle - row.added(fault.a) + margin);
  found.factor = std::exp(fault.cause.empty() ? row.logs[fault.a] - middle : fault.by);
  std::sort(off.begin(), off.end());
  for (const auto& [scaled, i] : off) {
    const std::string_view id = kind.relations[i].relation->id;
    if (!found.rules.empty() && scaled > -2.0) break;
    if (std::find(found.rules.begin(), found.rules.end(), id) == found.rules.end()) found.rules.push_back(id);
  }
  const std::size_t worst = off.front().second;
  const Relation& relation = *kind.relations[worst].relation;
  const std::size_t peers = row.references[worst].peers;
  const double excess = std::exp(row.residuals[worst]);
  found.evidence = fmt::format("{} is {} {} the usual ({})",
                               relation.title,
                               scalar::format_number(excess >= 1.0 ? excess : 1.0 / excess, 3),
                               excess >= 1.0 ? "times" : "times below",
                               peers > 0 ? fmt::format("of {} rows like it", peers) : std::string(relation.origin));
  return true;
}

/// Where nothing but its price speaks of a figure, the price is odd in the first place: it is what varies, and what no
/// other figure of the row follows from. Else the figure itself.
std::size_t Plausibility::price_in_question(const Kind& kind, const Evidence& row, std::size_t figure) {
  const auto is_money = [&](std::size_t slot) {
    return declaration(kind.columns[slot]).kind == catalogue::Kind::money && !kind.given[slot];
  };
  std::size_t price = figure;
  if (is_money(figure)) return figure;
  for (const Part& stands : kind.of_column[figure]) {
    if (std::isnan(row.residuals[stands.slot])) continue;
    if (!kind.relations[stands.slot].priced) return figure;
    for (const Part& part : kind.relations[stands.slot].parts)
      if (is_money(part.slot)) price = part.slot;
  }
  return price;
}

Suspicion Plausibility::describe(const Kind& kind, const Evidence& row) {
  const std::size_t slots = kind.columns.size();
  const std::vector<Fault> faults = faults_of(kind, row);
  double top = 0.0;
  for (const Fault& each : faults) top = std::max(top, each.weight);
  double wrong = 0.0;
  std::array<double, most> of_slot{};
  for (const Fault& each : faults) {
    const double weight = std::exp(each.weight - top);
    wrong += weight;
    of_slot[each.a] += each.a == each.b ? weight : 0.0;
  }
  Suspicion found{};
  found.certainty = wrong / (wrong + std::exp(-top));
  bool any_impossible = false;
  for (std::size_t i = 0; i < kind.relations.size(); ++i)
    any_impossible |= row.references[i].excludes(row.residuals[i]);
  if (any_impossible) found.certainty = std::max(found.certainty, certainty_of_impossible);
  if (found.certainty < certainty_to_report) return found;

  auto culprit = static_cast<std::size_t>(std::max_element(of_slot.begin(), of_slot.end()) - of_slot.begin());
  if (const std::size_t price = price_in_question(kind, row, culprit); of_slot[price] > 0.0) culprit = price;
  const Fault* fault = nullptr;
  for (const Fault& each : faults) {
    const bool candidate = each.a == each.b ? each.a == culprit : std::exp(each.weight - top) > of_slot[culprit];
    if (candidate && (fault == nullptr || each.weight > fault->weight)) fault = &each;
  }
  if (fault == nullptr) return {};
  found.column = kind.columns[fault->a];
  found.cause = fault->cause;
  if (fault->a != fault->b) found.swapped = kind.columns[fault->b];
  double second = 0.4 * of_slot[culprit];
  for (std::size_t slot = 0; slot < slots && !found.swapped; ++slot) {
    if (slot == culprit || of_slot[slot] < second) continue;
    second = of_slot[slot];
    found.instead = kind.columns[slot];
  }
  found.value = std::exp(row.written(fault->a));
  return explain(kind, row, *fault, found) ? found : Suspicion{};
}

}  // namespace millwright::catalogue
