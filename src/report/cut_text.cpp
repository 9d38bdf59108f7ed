// SPDX-License-Identifier: Apache-2.0
#include "report/cut_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "report/design_text.h"
#include "report/quantity_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Design;
using evaluation::PartLine;

std::string bars_text(const evaluation::BarPurchase& purchase) {
  std::vector<std::string> rests;
  for (const evaluation::CutBar& bar : purchase.bars)
    if (bar.left_over > 5e-4) rests.push_back(millimetres_text(bar.left_over));
  std::string out = fmt::format("{} bar{} of {} mm",
                                purchase.bars.size(),
                                purchase.bars.size() == 1 ? "" : "s",
                                millimetres_text(purchase.stock_length));
  if (!purchase.is_fewest) out += " (fewer may do)";
  if (!rests.empty()) out += fmt::format(", left over {} mm", fmt::join(rests, " + "));
  return out;
}

std::string bars_lines(const Design& design, const Style& style) {
  std::string out;
  for (const evaluation::BarPurchase& purchase : design.bars) {
    std::vector<std::string> bars;
    for (const evaluation::CutBar& bar : purchase.bars) {
      std::vector<std::string> pieces;
      for (const evaluation::BarPiece& piece : bar.pieces)
        pieces.push_back(fmt::format("{}.{} {}", piece.axis, piece.slot, millimetres_text(piece.length)));
      bars.push_back(fmt::format("{}", fmt::join(pieces, " + ")));
    }
    out += "  " +
           wrapped(fmt::format("Cut from {}: {} ({})",
                               bars_text(purchase),
                               part_name(purchase.manufacturer, purchase.part_number),
                               fmt::join(bars, "; ")),
                   style.width - 4,
                   4) +
           "\n";
  }
  return out;
}

std::string work_text(const Design& design) {
  double cutting = 0.0, machining = 0.0;
  for (const PartLine& part : design.parts) {
    for (const evaluation::Cut& cut : part.cuts) cutting += cut.count * part.cut_price;
    machining += part.ends * part.end_price;
  }
  std::vector<std::string> words;
  if (cutting > 0.0) words.push_back(fmt::format("{:.2f} for cutting to length", cutting));
  if (machining > 0.0) words.push_back(fmt::format("{:.2f} for machining screw ends", machining));
  return words.empty() ? std::string()
                       : fmt::format("  Of these prices, in {}: {}\n", design.currency, fmt::join(words, ", "));
}

const char* machining_assumption(const Design& design) {
  const bool stated = std::any_of(
      design.parts.begin(), design.parts.end(), [](const PartLine& part) { return part.ends * part.end_price > 0.0; });
  return stated ? "assume.machining_stated" : "assume.machining";
}

const char* length_assumption(const Design& design) {
  return design.bars.empty() ? "assume.length" : "assume.length_bars";
}

}  // namespace millwright::report
