// SPDX-License-Identifier: Apache-2.0
#include "evaluation/counted_parts.h"

#include <algorithm>

namespace millwright::evaluation {
namespace {

auto is_of(const PartUse& use) {
  return [&use](const CountedPart& part) { return part.family == use.family && part.row == use.row; };
}

}  // namespace

catalogue::PiecePrice::Purchase CountedPart::purchase(double pieces) const {
  catalogue::PiecePrice::Purchase bought = price.purchase(std::max(0.0, pieces - owned));
  bought.price *= rate;
  return bought;
}

const CountedPart* CountedParts::find_or_add(const PartUse& use) {
  if (!use.stated.empty()) return nullptr;
  const catalogue::Table& table = catalogue_.table(use.family);
  if (!prices_.is_counted(table, use.row)) return nullptr;
  const auto known = std::find_if(parts_.begin(), parts_.end(), is_of(use));
  if (known != parts_.end()) return &*known;
  CountedPart part;
  part.family = use.family;
  part.row = use.row;
  part.owned = prices_.owned(table, use.row);
  part.only_owned = table.ownership(use.row) == catalogue::Ownership::only;
  part.price = table.piece_price(use.row);
  part.rate = prices_.rate(table.price(use.row).currency);
  part.least = prices_.least_piece(table, use.row);
  part.state = first_state_ + parts_.size();
  parts_.push_back(std::move(part));
  most_.push_back(0.0);
  return &parts_.back();
}

std::vector<PieceCount> CountedParts::counts(std::span<const SlotTable> tables) {
  std::vector<PieceCount> result;
  for (std::size_t slot = 0; slot < tables.size(); ++slot) {
    const SlotTable& table = tables[slot];
    const std::size_t first = result.size();
    for (std::size_t row = 0; row < table.rows(); ++row) {
      for (const PartUse& use : table.candidate(row).parts) {
        const CountedPart* part = find_or_add(use);
        if (part == nullptr) continue;
        auto count = std::find_if(result.begin() + static_cast<std::ptrdiff_t>(first),
                                  result.end(),
                                  [&](const PieceCount& each) { return each.state == part->state; });
        if (count == result.end())
          count = result.insert(result.end(), {slot, part->state, std::vector<double>(table.rows(), 0.0)});
        count->of_row[row] += use.pieces();
      }
    }
    for (std::size_t i = first; i < result.size(); ++i)
      most_[result[i].state - first_state_] += *std::max_element(result[i].of_row.begin(), result[i].of_row.end());
  }
  return result;
}

std::vector<CountedPart> CountedParts::finish() && {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    CountedPart& part = parts_[i];
    for (double pieces = 0.0; pieces < most_[i] + 1.0; pieces += 1.0)
      part.charge.push_back(part.only_owned && pieces > part.owned ? beyond_reach
                                                                   : part.purchase(pieces).price - pieces * part.least);
  }
  return std::move(parts_);
}

CountedPartsLedger::Share CountedPartsLedger::take(const PartUse& use) {
  const auto found = use.stated.empty() ? std::find_if(parts_.begin(), parts_.end(), is_of(use)) : parts_.end();
  if (found == parts_.end()) return {0.0, use.price};
  double& taken = taken_[static_cast<std::size_t>(found - parts_.begin())];
  const double left = std::max(0.0, found->owned - taken);
  const double before = found->purchase(taken).price;
  taken += use.pieces();
  return {std::min(left, use.pieces()), found->purchase(taken).price - before};
}

std::vector<Purchase> CountedPartsLedger::purchases(const catalogue::Catalogue& catalogue) const {
  std::vector<Purchase> result;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!(taken_[i] > 0.0)) continue;
    const catalogue::Table& table = catalogue.table(parts_[i].family);
    const auto bought = parts_[i].purchase(taken_[i]);
    result.push_back({std::string(catalogue::declaration(parts_[i].family).name),
                      std::string(table.manufacturer(parts_[i].row)),
                      std::string(table.part_number(parts_[i].row)),
                      std::string(table.text(catalogue::column(parts_[i].family, "supplier"), parts_[i].row)),
                      taken_[i],
                      std::min(taken_[i], parts_[i].owned),
                      bought.pieces,
                      bought.price});
  }
  return result;
}

}  // namespace millwright::evaluation
