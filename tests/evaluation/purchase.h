// SPDX-License-Identifier: Apache-2.0
// What pieces cost at least that several shops sell (market.h): ordered in every way there is.
#pragma once

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/exhaustive.h"
#include "evaluation/market.h"

namespace millwright {

/// A piece that a build takes, and what it costs by the catalogue.
using Piece = std::pair<std::string, double>;

/// The cheapest way to have these pieces: every piece from every shop and from the drawer, every set of orders. With
/// preferred parts, the best where what they cost is compared; minimum orders are about what is paid.
class Cheapest {
 public:
  Cheapest(const Market& market, std::vector<Piece> pieces)
      : market_(market),
        pieces_(std::move(pieces)),
        left_(market.owned),
        spent_(market.shops.size(), 0.0),
        compared_(spent_),
        count_(spent_.size(), 0) {
    take(0);
  }
  double price = std::numeric_limits<double>::infinity();

 private:
  void take(std::size_t at) {
    if (at == pieces_.size()) {
      double sum = 0.0;
      for (std::size_t i = 0; i < spent_.size(); ++i)
        if (count_[i] > 0)
          sum += market_.shops[i].fee + compared_[i] + std::max(0.0, market_.shops[i].minimum - spent_[i]);
      price = std::min(price, sum);
      return;
    }
    const auto& part = pieces_[at].first;
    const double usual = pieces_[at].second;
    const auto buy = [&](std::size_t shop, double price_there) {
      const double before = spent_[shop], compared_before = compared_[shop];
      spent_[shop] += price_there;
      compared_[shop] += market_.factor(part) * price_there;
      ++count_[shop];
      take(at + 1);
      --count_[shop];
      spent_[shop] = before;
      compared_[shop] = compared_before;
    };
    if (const auto there = left_.find(part); there != left_.end() && there->second > 0) {
      --there->second;
      take(at + 1);
      ++there->second;
    }
    buy(0, usual);
    if (const auto offered = market_.offers.find(part); offered != market_.offers.end())
      for (const auto& [shop, price_there] : offered->second) buy(shop, price_there);
  }

  const Market& market_;
  std::vector<Piece> pieces_;
  std::map<std::string, int> left_;
  std::vector<double> spent_, compared_;
  std::vector<int> count_;
};

/// What a build costs less than the sum of the catalogue's prices, ordered where that is cheapest.
inline Discount saving(const evaluation::MachineModel& model, const Market& market) {
  const auto known = std::make_shared<std::map<std::vector<Piece>, double>>();
  return [&model, &market, known](const std::vector<std::vector<solver::Row>>& rows) {
    std::vector<Piece> pieces;
    double others = 0.0;  // nobody else sells them
    for (std::size_t stage = 0; stage < rows.size(); ++stage)
      for (std::size_t slot = 0; slot < rows[stage].size(); ++slot)
        for (const evaluation::PartUse& use : model.candidate(stage, slot, rows[stage][slot]).parts) {
          const std::string part(model.catalogue().table(use.family).part_number(use.row));
          if (market.offers.contains(part) || market.owned.contains(part) || market.preferred.contains(part))
            pieces.emplace_back(part, use.price);
          else
            others += use.price;
        }
    std::sort(pieces.begin(), pieces.end());
    double usual = others;
    for (const Piece& piece : pieces) usual += piece.second;
    // Together with what only the shop without a name sells, as one piece.
    pieces.emplace_back("", others);
    const auto [found, is_new] = known->try_emplace(pieces, 0.0);
    if (is_new) found->second = Cheapest(market, pieces).price;
    return usual - found->second;
  };
}

}  // namespace millwright
