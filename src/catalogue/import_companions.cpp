// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_companions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "catalogue/import_names.h"
#include "catalogue/import_unit.h"
#include "text/nearest.h"

namespace millwright::catalogue {
namespace {

/// How surely the rest of a header has to name the figure.
constexpr double least_match = 0.85;

struct Word {
  std::string_view text;
  CompanionKind kind;
};
constexpr std::array<Word, 14> words_of_companions = {{{"source", CompanionKind::source},
                                                       {"quelle", CompanionKind::source},
                                                       {"sumber", CompanionKind::source},
                                                       {"confidence", CompanionKind::confidence},
                                                       {"konfidenz", CompanionKind::confidence},
                                                       {"vertrauen", CompanionKind::confidence},
                                                       {"vertrauensw\xC3\xBCrdigkeit", CompanionKind::confidence},
                                                       {"keyakinan", CompanionKind::confidence},
                                                       {"tolerance", CompanionKind::tolerance},
                                                       {"tol", CompanionKind::tolerance},
                                                       {"toleranz", CompanionKind::tolerance},
                                                       {"toleransi", CompanionKind::tolerance},
                                                       {"uncertainty", CompanionKind::tolerance},
                                                       {"unsicherheit", CompanionKind::tolerance}}};

std::optional<CompanionKind> kind_of(const std::string& word) {
  for (const Word& each : words_of_companions)
    if (word == each.text) return each.kind;
  return std::nullopt;
}

/// A reading of a header as one that speaks of a figure: the words that name it, and what may be the unit.
struct Reading {
  CompanionKind kind = CompanionKind::source;
  std::vector<std::string> figure;
  std::string_view unit;
};

std::vector<Reading> readings_of(std::string_view header) {
  std::vector<Reading> result;
  for (const HeaderReading& each : header_readings(header)) {
    std::vector<std::string> words = words_of(each.name);
    if (words.size() < 2) continue;
    if (const auto last = kind_of(words.back())) {
      words.pop_back();
      result.push_back({*last, std::move(words), each.unit});
    } else if (const auto first = kind_of(words.front())) {
      words.erase(words.begin());
      result.push_back({*first, std::move(words), each.unit});
    }
  }
  return result;
}

bool may_have(Column figure, CompanionKind kind) {
  return is_number_column(figure) && (kind != CompanionKind::tolerance || takes_tolerance(figure));
}

/// Whether the words name a column of the family, one that can have such a companion or not.
bool names_column(const Reading& reading, Family family) {
  for (std::size_t index = 0; index < column_count(family); ++index)
    if (name_match(reading.figure, Column{family, static_cast<std::uint8_t>(index)}) >= least_match) return true;
  return false;
}

class Companions {
 public:
  Companions(const ImportChoices& choices,
             const std::vector<std::string>& units,
             ImportMapping& mapping,
             text::Diagnostics& diagnostics)
      : choices_(choices), units_(units), mapping_(mapping), diagnostics_(diagnostics) {}

  void take() {
    for (const GivenCompanion& each : choices_.companions) take_given(each);
    if (choices_.complete) return;
    for (std::size_t i = 0; i < mapping_.columns.size(); ++i)
      if (!mapping_.columns[i].target && !mapping_.columns[i].companion) look_at(i);
  }

 private:
  [[nodiscard]] bool is_taken(const ImportCompanion& companion) const {
    return std::any_of(mapping_.columns.begin(), mapping_.columns.end(), [&](const SourceColumn& each) {
      return each.companion && each.companion->figure == companion.figure && each.companion->kind == companion.kind;
    });
  }
  [[nodiscard]] const SourceColumn* column_of(Column figure) const {
    for (const SourceColumn& each : mapping_.columns)
      if (each.target == figure) return &each;
    return nullptr;
  }

  void take_given(const GivenCompanion& given) {
    const auto found = std::find_if(mapping_.columns.begin(), mapping_.columns.end(), [&](const SourceColumn& each) {
      return each.header == given.from && each.occurrence == given.occurrence;
    });
    if (found == mapping_.columns.end()) {
      std::vector<std::string> headers;
      for (const SourceColumn& each : mapping_.columns) headers.push_back(each.header);
      diagnostics_.error(given.where,
                         fmt::format("the table has no column {}", text::in_quotes(given.from, 80)),
                         text::did_you_mean(given.from, headers, "its header is another: make a new mapping"));
      return;
    }
    const std::string_view figure = declaration(given.companion.figure).name;
    if (found->target || found->companion)
      diagnostics_.error(given.where, fmt::format("the column {} is used twice", text::in_quotes(given.from, 80)));
    else if (column_of(given.companion.figure) == nullptr)
      diagnostics_.error(given.where,
                         fmt::format("what is said of {} needs a column {}", figure, figure),
                         fmt::format("name the column of {} too", figure));
    else
      settle(*found, given.companion, given.unit.value_or(""), 1.0, "as the mapping says");
  }

  void look_at(std::size_t index) {
    SourceColumn& column = mapping_.columns[index];
    for (const Reading& reading : readings_of(column.header)) {
      const auto figure = figure_of(reading);
      if (!figure) continue;
      const ImportCompanion companion{figure->first, reading.kind};
      if (is_taken(companion)) return;
      std::string reason;
      const std::string_view words = !reading.unit.empty()   ? reading.unit
                                     : index < units_.size() ? std::string_view(units_[index])
                                                             : std::string_view();
      const bool tolerance = reading.kind == CompanionKind::tolerance;
      const auto unit =
          words.empty() || !tolerance ? std::optional<std::string>("") : tolerance_unit(words, figure->first, reason);
      if (!unit || (!tolerance && !reading.unit.empty())) continue;
      settle(column, companion, *unit, figure->second, fmt::format("header {:.0f} %", 100.0 * figure->second));
      return;
    }
  }

  /// A figure of the table: the column whose header has just these words, or else the one that they name.
  [[nodiscard]] std::optional<std::pair<Column, double>> figure_of(const Reading& reading) const {
    std::optional<std::pair<Column, double>> best;
    for (const SourceColumn& each : mapping_.columns) {
      if (!each.target || !may_have(*each.target, reading.kind)) continue;
      double match = name_match(reading.figure, *each.target);
      for (const HeaderReading& header : header_readings(each.header))
        if (words_of(header.name) == reading.figure) match = 1.0;
      if (match >= least_match && (!best || match > best->second)) best = {*each.target, match};
    }
    return best;
  }

  static void settle(
      SourceColumn& column, const ImportCompanion& companion, std::string unit, double confidence, std::string reason) {
    column.companion = companion;
    column.kept_name = companion_name(companion.figure, companion.kind);
    column.unit = std::move(unit);
    column.unit_origin = column.unit.empty() ? UnitOrigin::none : UnitOrigin::header;
    column.confidence = confidence;
    column.reasons.push_back(std::move(reason));
  }

  const ImportChoices& choices_;
  const std::vector<std::string>& units_;
  ImportMapping& mapping_;
  text::Diagnostics& diagnostics_;
};

}  // namespace

bool names_companion(std::string_view header, Family family) {
  const std::vector<Reading> readings = readings_of(header);
  return std::any_of(readings.begin(), readings.end(), [&](const Reading& each) { return names_column(each, family); });
}

std::optional<ImportCompanion> companion_named(std::string_view name, Family family) {
  for (std::size_t index = 0; index < column_count(family); ++index) {
    const Column each{family, static_cast<std::uint8_t>(index)};
    for (const CompanionKind kind : {CompanionKind::source, CompanionKind::confidence, CompanionKind::tolerance})
      if (may_have(each, kind) && companion_name(each, kind) == name) return ImportCompanion{each, kind};
  }
  return std::nullopt;
}

void take_companions(const ImportChoices& choices,
                     const std::vector<std::string>& units,
                     ImportMapping& mapping,
                     text::Diagnostics& diagnostics) {
  Companions(choices, units, mapping, diagnostics).take();
}

std::optional<std::string> tolerance_unit(std::string_view words, Column figure, std::string& reason) {
  std::string trimmed(words);
  for (const std::string_view mark : {std::string_view("+-"), std::string_view("+/-"), std::string_view("\u00B1")})
    if (trimmed.starts_with(mark)) trimmed.erase(0, mark.size());
  while (!trimmed.empty() && trimmed.front() == ' ') trimmed.erase(0, 1);
  if (trimmed == "%" || trimmed == "percent" || trimmed == "Prozent") return "%";
  const auto unit = shop_unit(trimmed, figure, reason);
  return unit ? std::optional(unit->unit) : std::nullopt;
}

std::optional<std::string> tolerance_cell(std::string_view cell,
                                          const SourceColumn& column,
                                          DecimalMark usual,
                                          std::string& reason) {
  if (cell.empty() || says_unknown(cell)) return "";
  std::string_view text = cell;
  for (const std::string_view mark : {std::string_view("+-"), std::string_view("+/-"), std::string_view("\u00B1")})
    if (text.starts_with(mark)) {
      text.remove_prefix(mark.size());
      while (text.starts_with(' ')) text.remove_prefix(1);
      break;
    }
  const CellParts parts = cut_cell(text);
  const MarkEvidence evidence = mark_evidence(parts.number);
  const DecimalMark mark = evidence == MarkEvidence::comma       ? DecimalMark::comma
                           : evidence == MarkEvidence::ambiguous ? usual
                                                                 : DecimalMark::point;
  const std::string number = parts.number.empty() ? std::string() : plain_number(parts.number, mark);
  if (number.empty() || !parts.before.empty() || number.front() == '-') {
    reason = fmt::format("{} is no tolerance", text::in_quotes(cell));
    return std::nullopt;
  }
  if (parts.after.empty()) return number;
  const auto unit = tolerance_unit(parts.after, column.companion->figure, reason);
  if (!unit) return std::nullopt;
  if (column.unit.empty()) return number + " " + *unit;
  if (*unit == column.unit) return number;
  reason = fmt::format("{} has another unit than its column, {}", text::in_quotes(cell), column.unit);
  return std::nullopt;
}

}  // namespace millwright::catalogue
