// SPDX-License-Identifier: Apache-2.0
#include "evaluation/counted_parts.h"

#include <algorithm>
#include <cmath>

namespace millwright::evaluation {
namespace {

auto is_of(const PartUse& use) {
  return [&use](const CountedPart& part) { return part.family == use.family && part.row == use.row; };
}

/// What is paid for the first so many of the pieces that are bought, all at the same price. Where cents do not come out
/// even they are rounded here, so that the shares of the lines are whole cents and still add up to the order.
double part_of_order(double order, double pieces, double of) {
  if (pieces >= of) return order;
  const auto is_whole = [](double value) { return std::abs(value - std::round(value)) <= 1e-6; };
  const double share = order * pieces / of;
  const bool round = is_whole(100.0 * order) && !is_whole(10000.0 * order / of);
  return round ? std::round(100.0 * share) / 100.0 : share;
}

}  // namespace

catalogue::PiecePrice::Purchase CountedPart::purchase(double pieces) const {
  catalogue::PiecePrice::Purchase bought = price.purchase(std::max(0.0, pieces - owned));
  bought.price *= rate;
  return bought;
}

std::optional<std::size_t> CountedParts::find_or_add(catalogue::Family family, int row) {
  const catalogue::Table& table = catalogue_.table(family);
  if (!prices_.is_counted(table, row)) return std::nullopt;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (parts_[i].family == family && parts_[i].row == row) return i;
  const std::size_t index = parts_.size();
  CountedPart part;
  part.family = family;
  part.row = row;
  part.owned = prices_.owned(table, row);
  part.only_owned = table.ownership(row) == catalogue::Ownership::only;
  part.price = table.piece_price(row);
  part.rate = prices_.rate(table.price(row).currency);
  part.least = prices_.least_piece(table, row);
  part.preference = prices_.preference(table, row);
  part.state = first_state_ + index;
  parts_.push_back(std::move(part));
  most_.push_back(0.0);
  if (!parts_[index].only_owned) return index;
  for (int other = 0; other < table.rows() && !parts_[index].whole; ++other)
    if (table.ownership(other) == catalogue::Ownership::usual &&
        table.same_part(other, table, row, catalogue::Identity::point) && prices_.owned(table, other) > 0.0) {
      const auto whole = find_or_add(family, other);
      parts_[index].whole = whole;
    }
  return index;
}

std::vector<PieceCount> CountedParts::counts(std::span<const SlotTable> tables) {
  std::vector<PieceCount> result;
  for (std::size_t slot = 0; slot < tables.size(); ++slot) {
    const SlotTable& table = tables[slot];
    const std::size_t first = result.size();
    const auto add = [&](std::size_t row, std::size_t part, double pieces) {
      const std::size_t state = first_state_ + part;
      auto count = std::find_if(result.begin() + static_cast<std::ptrdiff_t>(first),
                                result.end(),
                                [&](const PieceCount& each) { return each.state == state; });
      if (count == result.end())
        count = result.insert(result.end(), {slot, state, std::vector<double>(table.rows(), 0.0)});
      count->of_row[row] += pieces;
    };
    for (std::size_t row = 0; row < table.rows(); ++row) {
      for (const PartUse& use : table.candidate(row).parts) {
        const auto part = use.stated.empty() ? find_or_add(use.family, use.row) : std::nullopt;
        if (!part) continue;
        add(row, *part, use.pieces());
        if (parts_[*part].whole) add(row, *parts_[*part].whole, use.pieces());
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
    part.summarise();
  }
  return std::move(parts_);
}

CountedPartsLedger::CountedPartsLedger(std::span<const CountedPart> parts)
    : parts_(parts), taken_(parts.size(), 0.0), set_aside_(taken_), listed_(taken_), charged_(taken_) {}

std::optional<std::size_t> CountedPartsLedger::find(const PartUse& use) const {
  const auto found = use.stated.empty() ? std::find_if(parts_.begin(), parts_.end(), is_of(use)) : parts_.end();
  if (found == parts_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - parts_.begin());
}

void CountedPartsLedger::take(const PartUse& use) {
  const auto index = find(use);
  if (!index) return;
  taken_[*index] += use.pieces();
  if (parts_[*index].whole) set_aside_[*parts_[*index].whole] += use.pieces();
}

double CountedPartsLedger::owned(std::size_t part) const {
  return std::min(taken_[part], std::max(0.0, parts_[part].owned - set_aside_[part]));
}

CountedPartsLedger::Share CountedPartsLedger::share(const PartUse& use) {
  const auto index = find(use);
  if (!index) return {0.0, use.price};
  const double mine = std::min(std::max(0.0, owned(*index) - listed_[*index]), use.pieces());
  const double to_buy = taken_[*index] - owned(*index);
  const double before = std::max(0.0, listed_[*index] - owned(*index));
  listed_[*index] += use.pieces();
  const double order = parts_[*index].purchase(set_aside_[*index] + taken_[*index]).price -
                       parts_[*index].purchase(set_aside_[*index]).price;
  const double charged = charged_[*index];
  charged_[*index] = part_of_order(order, before + use.pieces() - mine, to_buy);
  return {mine, charged_[*index] - charged};
}

std::vector<Purchase> CountedPartsLedger::purchases(const catalogue::Catalogue& catalogue) const {
  std::vector<Purchase> result;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!(taken_[i] > 0.0)) continue;
    const catalogue::Table& table = catalogue.table(parts_[i].family);
    const auto bought = parts_[i].purchase(taken_[i] + set_aside_[i]);
    result.push_back({std::string(catalogue::declaration(parts_[i].family).name),
                      std::string(table.manufacturer(parts_[i].row)),
                      std::string(table.part_number(parts_[i].row)),
                      std::string(table.text(catalogue::column(parts_[i].family, "supplier"), parts_[i].row)),
                      taken_[i],
                      owned(i),
                      bought.pieces,
                      bought.price});
  }
  return result;
}

}  // namespace millwright::evaluation
