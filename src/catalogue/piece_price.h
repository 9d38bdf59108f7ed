// SPDX-License-Identifier: Apache-2.0
//
// What pieces of a part cost when the price depends on how many are bought: price breaks ("10: 4.50; 100: 3.90") and
// packs.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace millwright::catalogue {

/// From so many pieces on, each costs so much.
struct PriceBreak {
  double pieces = 0.0;
  double price = 0.0;
};

/// "10: 4.50; 100: 3.90", ascending in pieces, prices not negative. Nothing if it is not written like that.
std::optional<std::vector<PriceBreak>> parse_price_breaks(std::string_view text);

struct PiecePrice {
  double single = 0.0;             ///< of one piece below the first break; NaN if it is not known
  std::vector<PriceBreak> breaks;  ///< ascending
  double pack = 1.0;               ///< pieces in a pack: only whole packs are sold

  [[nodiscard]] bool is_plain() const { return breaks.empty() && pack <= 1.0; }
  /// Whether each of up to so many pieces costs the same.
  [[nodiscard]] bool is_plain_up_to(double pieces) const;
  /// Of a piece, if at most so many are needed.
  [[nodiscard]] double least(double most) const;

  struct Purchase {
    double pieces = 0.0;
    double price = 0.0;
  };
  /// The cheapest way to have at least so many pieces: whole packs, and more than needed where that costs less.
  [[nodiscard]] Purchase purchase(double needed) const;
};

}  // namespace millwright::catalogue
