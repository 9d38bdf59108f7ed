// SPDX-License-Identifier: Apache-2.0
// One look through all rows before they are written: which decimal mark each column has, and which units stand in its
// cells. What only some rows tell must not be decided by the first ones.
#include <fmt/format.h>

#include <algorithm>

#include "catalogue/import_mapping.h"
#include "catalogue/import_unit.h"
#include "text/number.h"

namespace millwright::catalogue {
namespace {

/// More units in one column than this, and they are no units.
constexpr std::size_t most_units = 24;

struct Tally {
  std::size_t column = 0;
  bool money = false;
  std::size_t points = 0, commas = 0, ambiguous = 0, unknown = 0, typed_numbers = 0;
  std::optional<text::SourceSpan> point, comma, doubtful;
  std::string comma_cell, doubtful_cell;
};

/// The usual cell: digits with at most one mark.
std::optional<MarkEvidence> quick_evidence(std::string_view cell) {
  std::size_t mark = std::string_view::npos;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (cell[i] >= '0' && cell[i] <= '9') continue;
    if ((cell[i] != '.' && cell[i] != ',') || mark != std::string_view::npos) return std::nullopt;
    mark = i;
  }
  if (mark == std::string_view::npos) return MarkEvidence::none;
  if (mark == 0 || mark + 1 == cell.size()) return std::nullopt;
  if (cell.size() - mark - 1 == 3 && mark <= 3 && cell[0] != '0') return MarkEvidence::ambiguous;
  return cell[mark] == '.' ? MarkEvidence::point : MarkEvidence::comma;
}

class Survey {
 public:
  Survey(const ImportSheet& sheet, const ImportChoices& choices, ImportMapping& mapping, text::Diagnostics& diagnostics)
      : sheet_(sheet), choices_(choices), mapping_(mapping), diagnostics_(diagnostics) {
    for (std::size_t i = 0; i < mapping.columns.size(); ++i) {
      const auto target = mapping.columns[i].target;
      if (!target || !is_number_column(*target)) continue;
      Tally tally;
      tally.column = i;
      tally.money = declaration(*target).kind == Kind::money;
      tallies_.push_back(tally);
    }
  }

  void run() {
    text::Diagnostics bad_quotes;  // reported when the rows are written
    SheetRows row(sheet_, bad_quotes, mapping_.data_begin);
    std::size_t rows = 0;
    std::size_t numbers_as_names = 0;
    const auto name = std::find_if(mapping_.columns.begin(), mapping_.columns.end(), [&](const SourceColumn& each) {
      return each.target == column(mapping_.family, "part_number");
    });
    while (row.next()) {
      ++rows;
      for (Tally& tally : tallies_) look(row, tally);
      if (name != mapping_.columns.end() && row.is_number(static_cast<std::size_t>(name - mapping_.columns.begin())))
        ++numbers_as_names;
    }
    mapping_.rows = rows;
    if (numbers_as_names > 0)
      mapping_.remarks.push_back(fmt::format(
          "part_number: {} are numbers in the workbook; zeros that may have stood before them are lost there",
          numbers_as_names));
    for (Tally& tally : tallies_) check_units(tally);
    decide_marks();
  }

 private:
  SourceColumn& of(const Tally& tally) { return mapping_.columns[tally.column]; }

  void look(const SheetRows& row, Tally& tally) {
    const std::string_view cell = row.cell(tally.column);
    if (cell.empty()) return;
    const bool typed = row.is_number(tally.column);
    std::optional<MarkEvidence> evidence = quick_evidence(cell);
    bool bare = true;
    if (!evidence) {
      if (says_unknown(cell)) {
        ++tally.unknown;
        return;
      }
      const CellParts parts = cut_cell(cell);
      if (parts.number.empty()) return;  // reported when the row is written
      evidence = mark_evidence(parts.number);
      bare = parts.before.empty() && parts.after.empty();
      if (!bare) note_unit(row, tally, parts);
    }
    of(tally).has_bare_figures = of(tally).has_bare_figures || bare;
    if (typed) {
      ++tally.typed_numbers;
      return;
    }
    if (*evidence == MarkEvidence::point && tally.points++ == 0) tally.point = row.span(tally.column);
    if (*evidence == MarkEvidence::comma && tally.commas++ == 0) {
      tally.comma = row.span(tally.column);
      tally.comma_cell = std::string(cell);
    }
    if (*evidence == MarkEvidence::ambiguous && tally.ambiguous++ == 0) {
      tally.doubtful = row.span(tally.column);
      tally.doubtful_cell = std::string(cell);
    }
  }

  void note_unit(const SheetRows& row, Tally& tally, const CellParts& parts) {
    std::vector<std::string>& units = of(tally).cell_units;
    const std::size_t length = parts.before.size() + parts.after.size();
    for (const std::string& known : units)
      if (known.size() == length && known.starts_with(parts.before) && known.ends_with(parts.after)) return;
    if (units.size() >= most_units) return;
    const std::string words = std::string(parts.before) + std::string(parts.after);
    std::string reason;
    const auto unit = shop_unit(words, *of(tally).target, reason);
    if (!unit) return;  // reported when the row is written
    units.push_back(words);
    if (!unit->remark.empty()) of(tally).reasons.push_back("unit " + unit->remark);
    (void)row;
  }

  /// One unit in all cells is written as it is; several are converted to ours.
  void check_units(Tally& tally) {
    SourceColumn& column = of(tally);
    std::vector<std::string> meant;
    std::string reason;
    for (const std::string& words : column.cell_units) {
      const auto unit = shop_unit(words, *column.target, reason);
      if (std::find(meant.begin(), meant.end(), unit->unit) == meant.end()) meant.push_back(unit->unit);
    }
    const bool known = column.unit_origin != UnitOrigin::none && column.unit_origin != UnitOrigin::cells;
    if (column.has_bare_figures && known && !meant.empty() &&
        std::find(meant.begin(), meant.end(), column.unit) == meant.end())
      meant.push_back(column.unit);
    if (!tally.money || !column.unit.empty() || meant.size() > 1) {
      if (meant.size() == 1) column.unit = meant.front();
      if (meant.size() > 1) {
        column.converts = true;
        column.reasons.push_back(fmt::format("units in the cells: {}; converted", fmt::join(meant, ", ")));
      }
    }
    if (!meant.empty() && (column.unit_origin == UnitOrigin::none || column.unit_origin == UnitOrigin::assumed) &&
        !column.has_bare_figures)
      column.unit_origin = UnitOrigin::cells;
    if (tally.unknown > 0) column.reasons.push_back(fmt::format("{} cells such as '-' left empty", tally.unknown));
  }

  void decide_marks() {
    std::size_t pointed = 0;
    std::size_t comma = 0;
    for (const Tally& tally : tallies_) {
      pointed += tally.points > 0 ? 1 : 0;
      comma += tally.commas > 0 ? 1 : 0;
    }
    for (Tally& tally : tallies_) {
      SourceColumn& column = of(tally);
      const auto said = std::find_if(choices_.columns.begin(), choices_.columns.end(), [&](const GivenColumn& each) {
        return each.target == *column.target && each.mark != DecimalMark::unknown;
      });
      if (said != choices_.columns.end() || choices_.mark != DecimalMark::unknown) {
        column.mark = said != choices_.columns.end() ? said->mark : choices_.mark;
      } else if (tally.points > 0 && tally.commas > 0) {
        contradiction(tally);
      } else if (tally.points > 0 || tally.commas > 0) {
        column.mark = tally.commas > 0 ? DecimalMark::comma : DecimalMark::point;
        if (tally.ambiguous > 0)
          column.reasons.push_back(fmt::format("{} is read with a decimal {}, as other rows show",
                                               text::in_quotes(tally.doubtful_cell),
                                               tally.commas > 0 ? "comma" : "point"));
        else if (tally.commas > 0)
          column.reasons.emplace_back("decimal comma");
      } else if (tally.ambiguous > 0) {
        undecided(tally, pointed, comma);
      } else {
        column.mark = DecimalMark::point;
      }
    }
  }

  void contradiction(const Tally& tally) {
    of(tally).mark = DecimalMark::unknown;
    const bool commas_are_few = tally.commas <= tally.points;
    text::Diagnostic diagnostic;
    diagnostic.where = commas_are_few ? *tally.comma : *tally.point;
    diagnostic.message =
        fmt::format("{}: decimal commas and decimal points in one column", declaration(*of(tally).target).name);
    diagnostic.hint = fmt::format("use one decimal mark throughout, or say --decimal point or --decimal comma");
    diagnostic.related = commas_are_few ? *tally.point : *tally.comma;
    diagnostic.related_message = "the other mark is here";
    diagnostics_.add(std::move(diagnostic));
  }

  void undecided(const Tally& tally, std::size_t pointed, std::size_t comma) {
    SourceColumn& column = of(tally);
    if ((pointed > 0) != (comma > 0)) {
      column.mark = comma > 0 ? DecimalMark::comma : DecimalMark::point;
      column.reasons.push_back(fmt::format("{} is read with a decimal {}, as in the other columns",
                                           text::in_quotes(tally.doubtful_cell),
                                           comma > 0 ? "comma" : "point"));
      return;
    }
    diagnostics_.error(*tally.doubtful,
                       fmt::format("{}: {} may have a decimal mark or separate thousands, and no other row tells",
                                   declaration(*column.target).name,
                                   text::in_quotes(tally.doubtful_cell)),
                       "say --decimal point or --decimal comma");
  }

  const ImportSheet& sheet_;
  const ImportChoices& choices_;
  ImportMapping& mapping_;
  text::Diagnostics& diagnostics_;
  std::vector<Tally> tallies_;
};

}  // namespace

void survey_columns(const ImportSheet& sheet,
                    const ImportChoices& choices,
                    ImportMapping& mapping,
                    text::Diagnostics& diagnostics) {
  Survey(sheet, choices, mapping, diagnostics).run();
}

}  // namespace millwright::catalogue
