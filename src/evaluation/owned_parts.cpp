// SPDX-License-Identifier: Apache-2.0
#include "evaluation/owned_parts.h"

#include <algorithm>

namespace millwright::evaluation {
namespace {

auto is_of(const PartUse& use) {
  return [&use](const OwnedPart& part) { return part.family == use.family && part.row == use.row; };
}

}  // namespace

const OwnedPart* OwnedParts::find_or_add(const PartUse& use) {
  if (!use.stated.empty()) return nullptr;
  const catalogue::Table& table = catalogue_.table(use.family);
  const double owned = prices_.owned(table, use.row);
  if (!(owned > 0.0)) return nullptr;
  const auto known = std::find_if(parts_.begin(), parts_.end(), is_of(use));
  if (known != parts_.end()) return &*known;
  parts_.push_back({use.family, use.row, owned, prices_.piece(table, use.row), first_state_ + parts_.size()});
  return &parts_.back();
}

std::vector<PieceCount> OwnedParts::counts(std::span<const SlotTable> tables) {
  std::vector<PieceCount> result;
  for (std::size_t slot = 0; slot < tables.size(); ++slot) {
    const SlotTable& table = tables[slot];
    const std::size_t first = result.size();
    for (std::size_t row = 0; row < table.rows(); ++row) {
      for (const PartUse& use : table.candidate(row).parts) {
        const OwnedPart* part = find_or_add(use);
        if (part == nullptr) continue;
        auto count = std::find_if(result.begin() + static_cast<std::ptrdiff_t>(first),
                                  result.end(),
                                  [&](const PieceCount& each) { return each.state == part->state; });
        if (count == result.end())
          count = result.insert(result.end(), {slot, part->state, std::vector<double>(table.rows(), 0.0)});
        count->of_row[row] += use.quantity;
      }
    }
  }
  return result;
}

OwnedPartsLedger::Share OwnedPartsLedger::take(const PartUse& use) {
  const auto found = use.stated.empty() ? std::find_if(parts_.begin(), parts_.end(), is_of(use)) : parts_.end();
  if (found == parts_.end()) return {};
  double& taken = taken_[static_cast<std::size_t>(found - parts_.begin())];
  const double left = std::max(0.0, found->pieces - taken);
  const double before = charge(*found, taken);
  taken += use.quantity;
  return {std::min(left, use.quantity), charge(*found, taken) - before};
}

}  // namespace millwright::evaluation
