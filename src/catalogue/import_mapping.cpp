// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_mapping.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "catalogue/column_unit.h"
#include "catalogue/import_companions.h"
#include "catalogue/import_figures.h"
#include "catalogue/import_head.h"
#include "catalogue/import_names.h"
#include "catalogue/import_unit.h"
#include "text/nearest.h"
#include "text/number.h"

namespace millwright::catalogue {
namespace {

/// Below this a likeness of names is none.
constexpr double least_confidence = 0.5;
constexpr double confidence_without_unit = 0.4;

/// A source column seen as one of ours.
struct Candidate {
  std::size_t source = 0;
  Column target{};
  double score = 0.0;
  std::string unit;
  std::string currency;
  UnitOrigin origin = UnitOrigin::none;
  std::vector<std::string> reasons;
  double score_of_name = 0.0;  ///< and unit: the score before its figures were doubted
};

class Proposal {
 public:
  Proposal(const ImportSheet& sheet,
           const TableHead& head,
           const ImportChoices& choices,
           text::Diagnostics& diagnostics)
      : sheet_(sheet), head_(head), choices_(choices), diagnostics_(diagnostics) {}

  ImportMapping make() {
    mapping_.family = choices_.family;
    mapping_.constants = choices_.constants;
    mapping_.titles = head_.titles;
    mapping_.header = head_.span;
    mapping_.data_begin = head_.data_begin;
    mapping_.remarks = sheet_.remarks;
    if (!head_.units.empty()) mapping_.remarks.emplace_back("the row below the header holds units");
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < head_.cells.size(); ++i) {
      SourceColumn column;
      column.header = head_.cells[i];
      column.occurrence = ++seen[column.header];
      column.span = head_.spans[i];
      mapping_.columns.push_back(std::move(column));
    }
    take_given();
    if (!choices_.complete) take_best(candidates());
    take_companions(choices_, head_.units, mapping_, diagnostics_);
    name_kept();
    if (!choices_.complete) {
      remark_on_quantities();
      remark_on_doubted();
    }
    return std::move(mapping_);
  }

 private:
  bool is_constant(Column column) const {
    return std::any_of(
        choices_.constants.begin(), choices_.constants.end(), [&](const auto& each) { return each.first == column; });
  }
  bool is_taken(Column column) const {
    return std::any_of(mapping_.columns.begin(), mapping_.columns.end(), [&](const SourceColumn& each) {
      return each.target == column;
    });
  }
  const GivenColumn* given(Column column) const {
    for (const GivenColumn& each : choices_.columns)
      if (each.target == column) return &each;
    return nullptr;
  }

  void take_given() {
    for (const GivenColumn& each : choices_.columns) {
      if (each.from.empty()) continue;
      const auto found =
          std::find_if(mapping_.columns.begin(), mapping_.columns.end(), [&](const SourceColumn& column) {
            return column.header == each.from && column.occurrence == each.occurrence;
          });
      if (found == mapping_.columns.end()) {
        diagnostics_.error(each.where,
                           fmt::format("the table has no column {}", text::in_quotes(each.from, 80)),
                           text::did_you_mean(each.from, head_.cells, "its header is another: make a new mapping"));
        continue;
      }
      if (found->target) {
        diagnostics_.error(each.where, fmt::format("the column {} is used twice", text::in_quotes(each.from, 80)));
        continue;
      }
      const auto index = static_cast<std::size_t>(found - mapping_.columns.begin());
      Candidate candidate{index, each.target, 1.0, {}, {}, UnitOrigin::none, {}};
      find_unit(candidate);
      found->reasons.emplace_back("as the mapping says");
      settle(*found, candidate);
    }
  }

  /// Where the unit of the figures comes from, for a column of that target: given, header, row of units.
  void find_unit(Candidate& candidate) const {
    if (!wants_unit(candidate.target)) return;
    const GivenColumn* said = given(candidate.target);
    std::string reason;
    if (said != nullptr && said->unit) {
      candidate.origin = UnitOrigin::given;
      if (const auto unit = shop_unit(*said->unit, candidate.target, reason)) {
        candidate.unit = unit->unit;
        candidate.currency = unit->currency;
      } else {
        candidate.unit = *said->unit;  // reported where it was said
      }
      return;
    }
    for (const HeaderReading& reading : header_readings(head_.cells[candidate.source]))
      if (take_unit(candidate, reading.unit, UnitOrigin::header)) return;
    if (!head_.units.empty()) take_unit(candidate, head_.units[candidate.source], UnitOrigin::units_row);
  }

  static bool take_unit(Candidate& candidate, std::string_view words, UnitOrigin origin) {
    std::string reason;
    if (words.empty()) return false;
    const auto unit = shop_unit(words, candidate.target, reason);
    if (!unit) return false;
    candidate.unit = unit->unit;
    candidate.currency = unit->currency;
    candidate.origin = origin;
    if (!unit->remark.empty()) candidate.reasons.push_back("unit " + unit->remark);
    return true;
  }

  Candidate judge(std::size_t source, Column target) const {
    Candidate candidate{source, target, 0.0, {}, {}, UnitOrigin::none, {}};
    if (declaration(target).kind == Kind::money && has_quantity(head_.cells[source])) return candidate;
    double name = 0.0;
    std::string_view read;
    for (const HeaderReading& reading : header_readings(head_.cells[source])) {
      // Words that are the unit count for it only where they fit.
      std::string reason;
      const bool fits = reading.unit.empty() || !is_number_column(target) || shop_unit(reading.unit, target, reason);
      const double match = name_match(words_of(reading.name), target) * (fits ? 1.0 : 0.85);
      if (match > name) read = reading.name;
      name = std::max(name, match);
    }
    if (name < least_confidence) return candidate;
    candidate.reasons.push_back(fmt::format("header {:.0f} %", name * 100.0));
    candidate.score = name;
    const auto& samples = head_.samples[source];
    if (is_number_column(target)) judge_figures(candidate, samples);
    if (!is_number_column(target) && candidate.score > 0.0) judge_words(candidate, samples);
    return candidate;
  }

  /// Whether the header, or the row of units, states a unit of another quantity: then this is another quantity.
  bool has_foreign_unit(const Candidate& candidate) const {
    const std::string& header = head_.cells[candidate.source];
    std::string reason;
    if (declaration(candidate.target).kind == Kind::money) {
      // EUR/m is no price of a piece.
      for (const HeaderReading& reading : header_readings(header))
        for (const std::string_view per : {"price_per_length", "price_per_mass"}) {
          const Column other = column(choices_.family, per);
          if (other != candidate.target && shop_unit(reading.unit, other, reason)) return true;
        }
    }
    if (candidate.origin != UnitOrigin::none) return false;
    if (!head_.units.empty() && is_any_unit(head_.units[candidate.source])) return true;
    const bool bracketed = header.ends_with(')') || header.ends_with(']');
    return bracketed && is_any_unit(header_readings(header).front().unit);
  }

  void judge_figures(Candidate& candidate, const std::vector<TableHead::Sample>& samples) const {
    find_unit(candidate);
    if (wants_unit(candidate.target) && has_foreign_unit(candidate)) {
      candidate.score = 0.0;
      return;
    }
    const scalar::Unit& expected = display_unit(candidate.target);
    std::string reason;
    std::optional<scalar::Unit> bare;
    if (candidate.origin != UnitOrigin::none) bare = scalar::Unit::parse(candidate.unit, reason);
    const Figures figures =
        look_at(samples, candidate.target, bare && bare->fits(expected, reason) ? *bare : expected, choices_.mark);
    if (!samples.empty() && 2 * figures.numbers < samples.size()) {
      candidate.score = 0.0;
      return;
    }
    if (candidate.origin == UnitOrigin::none && wants_unit(candidate.target)) {
      const bool money = declaration(candidate.target).kind == Kind::money;
      if (figures.with_unit > 0) {
        candidate.origin = UnitOrigin::cells;
      } else if (!(money && expected.dimension() == scalar::dimension::none)) {
        candidate.origin = UnitOrigin::assumed;
        candidate.unit = declaration(candidate.target).unit;
        candidate.score *= 0.85;
      }
    }
    // A unit that somebody gave is not doubted here; lint looks at what comes out.
    if (figures.judged == 0 || candidate.origin == UnitOrigin::given) return;
    const double share = static_cast<double>(figures.plausible) / static_cast<double>(figures.judged);
    candidate.score_of_name = candidate.score;
    candidate.score *= 0.4 + 0.6 * share;
    if (share < 1.0)
      candidate.reasons.push_back(
          fmt::format("{} of {} figures are not plausible", figures.judged - figures.plausible, figures.judged));
  }

  /// A column of texts whose header ends in a unit, above figures, is another quantity.
  void judge_words(Candidate& candidate, const std::vector<TableHead::Sample>& samples) const {
    const auto readings = header_readings(head_.cells[candidate.source]);
    const bool unit = readings.size() > 1 && is_any_unit(readings.front().unit);
    const auto figures = std::count_if(samples.begin(), samples.end(), [](const auto& sample) {
      return cut_cell(sample.cell).number.size() == sample.cell.size();
    });
    if (unit && 2 * static_cast<std::size_t>(figures) > samples.size()) candidate.score *= 0.4;
  }

  std::vector<Candidate> candidates() {
    std::vector<Candidate> all;
    for (std::size_t source = 0; source < mapping_.columns.size(); ++source) {
      const std::string& header = mapping_.columns[source].header;
      if (mapping_.columns[source].target || header.empty() || is_price_of_many(header)) continue;
      if (names_companion(header, choices_.family)) continue;
      for (std::size_t index = 0; index < column_count(choices_.family); ++index) {
        const Column target{choices_.family, static_cast<std::uint8_t>(index)};
        if (is_taken(target) || is_constant(target)) continue;
        Candidate candidate = judge(source, target);
        constexpr double least_score = least_confidence * 0.85;
        if (candidate.score >= least_score)
          all.push_back(std::move(candidate));
        else if (candidate.score_of_name >= least_score)
          doubted_.push_back(std::move(candidate));
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    return all;
  }

  void take_best(const std::vector<Candidate>& all) {
    for (const Candidate& each : all) {
      SourceColumn& column = mapping_.columns[each.source];
      if (column.target || is_taken(each.target)) continue;
      settle(column, each);
      // The next best that could have been meant instead.
      for (const Candidate& other : all) {
        const bool rival = (other.source == each.source) != (other.target == each.target);
        if (!rival || other.score < each.score - 0.1 || other.score > each.score) continue;
        const SourceColumn& theirs = mapping_.columns[other.source];
        if (other.source != each.source && theirs.target) continue;
        if (other.source == each.source && is_taken(other.target)) continue;
        column.confidence *= 0.8;
        column.reasons.push_back(other.source == each.source
                                     ? fmt::format("could be {}", declaration(other.target).name)
                                     : fmt::format("so could {}", text::in_quotes(theirs.header)));
        break;
      }
    }
  }

  void settle(SourceColumn& column, const Candidate& candidate) const {
    column.target = candidate.target;
    column.confidence = candidate.score;
    column.reasons.insert(column.reasons.end(), candidate.reasons.begin(), candidate.reasons.end());
    column.unit = candidate.unit;
    column.currency = candidate.currency;
    column.unit_origin = candidate.origin;
    if (candidate.origin == UnitOrigin::assumed)
      column.confidence = std::min(column.confidence, confidence_without_unit);
  }

  /// Whether the header names a price, rather than anything else, of a number of pieces.
  bool is_price_of_many(const std::string& header) const {
    if (!has_quantity(header)) return false;
    double price = 0.0;
    double other = 0.0;
    for (const HeaderReading& reading : header_readings(header)) {
      const std::vector<std::string> words = words_of(reading.name);
      for (std::size_t index = 0; index < column_count(choices_.family); ++index) {
        const Column target{choices_.family, static_cast<std::uint8_t>(index)};
        double& best = declaration(target).kind == Kind::money ? price : other;
        best = std::max(best, name_match(words, target));
      }
    }
    return price >= least_confidence && price >= other;
  }

  /// Says which columns were not taken for what their headers say, only because of their figures.
  void remark_on_doubted() {
    std::stable_sort(doubted_.begin(), doubted_.end(), [](const Candidate& a, const Candidate& b) {
      return a.score_of_name > b.score_of_name;
    });
    std::set<std::size_t> remarked;  // sources
    for (const Candidate& each : doubted_) {
      SourceColumn& column = mapping_.columns[each.source];
      if (column.target || column.companion || is_taken(each.target) || !remarked.insert(each.source).second) continue;
      mapping_.remarks.push_back(fmt::format(
          "{} looks like {}, but {}: kept as {}, not taken; --unit {}={} or a mapping file takes it all the same",
          text::in_quotes(column.header, 80),
          declaration(each.target).name,
          each.reasons.back(),
          column.kept_name,
          declaration(each.target).name,
          each.unit.empty() ? declaration(each.target).unit : each.unit));
    }
  }

  /// Says of each such column why it is no price.
  void remark_on_quantities() {
    for (const SourceColumn& column : mapping_.columns)
      if (!column.target && !column.companion && is_price_of_many(column.header))
        mapping_.remarks.push_back(fmt::format(
            "{} has a number in its header and may be the price of so many: kept as {}, not taken as price; "
            "a mapping file can name it",
            text::in_quotes(column.header, 80),
            column.kept_name));
  }

  void name_kept() {
    std::set<std::string> names;
    for (std::size_t i = 0; i < mapping_.columns.size(); ++i) {
      SourceColumn& column = mapping_.columns[i];
      if (column.target || column.companion) continue;
      std::string slug = "x";
      for (const char c : column.header) {
        const bool letter =
            (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (static_cast<unsigned char>(c) & 0x80U) != 0;
        if (c >= 'A' && c <= 'Z')
          slug += slug.size() == 1 ? "_" : "", slug += static_cast<char>(c - 'A' + 'a');
        else if (letter)
          slug += slug.size() == 1 ? "_" : "", slug += c;
        else if (slug.back() != '_')
          slug += '_';
        if (slug.size() > 60 && (static_cast<unsigned char>(c) & 0x80U) == 0) break;
      }
      while (slug.back() == '_') slug.pop_back();
      if (slug == "x") slug = fmt::format("x_column_{}", i + 1);
      column.kept_name = slug;
      for (int n = 2; !names.insert(column.kept_name).second; ++n) column.kept_name = fmt::format("{}_{}", slug, n);
    }
  }

  const ImportSheet& sheet_;
  const TableHead& head_;
  const ImportChoices& choices_;
  text::Diagnostics& diagnostics_;
  ImportMapping mapping_;
  std::vector<Candidate> doubted_;  ///< because of their figures
};

}  // namespace

std::optional<ImportMapping> propose_mapping(const ImportSheet& sheet,
                                             const ImportChoices& choices,
                                             text::Diagnostics& diagnostics) {
  const auto head = find_head(sheet, choices, diagnostics);
  if (!head) return std::nullopt;
  ImportMapping mapping = Proposal(sheet, *head, choices, diagnostics).make();
  survey_columns(sheet, choices, mapping, diagnostics);
  complete_mapping(sheet, choices, mapping, diagnostics);
  return mapping;
}

}  // namespace millwright::catalogue
