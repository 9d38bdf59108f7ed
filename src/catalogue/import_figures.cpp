// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_figures.h"

#include <optional>
#include <string>

#include "catalogue/column_unit.h"
#include "catalogue/import_unit.h"
#include "text/number.h"

namespace millwright::catalogue {

Figures look_at(const std::vector<TableHead::Sample>& samples,
                Column target,
                const scalar::Unit& bare,
                DecimalMark usual) {
  Figures figures;
  const ColumnDeclaration& declared = declaration(target);
  for (const TableHead::Sample& sample : samples) {
    const CellParts parts = cut_cell(sample.cell);
    if (parts.number.empty()) continue;
    const std::string words = std::string(parts.before) + std::string(parts.after);
    std::string reason;
    const auto own = words.empty() ? std::nullopt : shop_unit(words, target, reason);
    if (!words.empty() && !own) continue;
    ++figures.numbers;
    if (own) ++figures.with_unit;
    const scalar::Unit& unit = own ? own->meaning : bare;
    const auto fits = [&](DecimalMark mark) -> std::optional<bool> {
      const auto value = text::parse_number(plain_number(parts.number, mark));
      if (!value) return std::nullopt;
      const double shown = display_unit(target).from_si(unit.to_si(*value));
      return shown >= declared.lower * 0.999 && shown <= declared.upper * 1.001;
    };
    // What "1,234" means only the whole table tells: until then it is given the benefit of the doubt.
    const MarkEvidence evidence = mark_evidence(parts.number);
    const bool open = evidence == MarkEvidence::ambiguous && usual == DecimalMark::unknown;
    const bool comma =
        evidence == MarkEvidence::comma || (evidence == MarkEvidence::ambiguous && usual == DecimalMark::comma);
    const auto first = fits(comma ? DecimalMark::comma : DecimalMark::point);
    const auto second = open ? fits(DecimalMark::comma) : std::nullopt;
    if (!first && !second) continue;
    ++figures.judged;
    if (first.value_or(false) || second.value_or(false)) ++figures.plausible;
  }
  return figures;
}

}  // namespace millwright::catalogue
