// SPDX-License-Identifier: Apache-2.0
#include "catalogue/piece_price.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "text/characters.h"

namespace millwright::catalogue {
namespace {

std::optional<double> number_of(std::string_view text) {
  text = text::without_blanks(text, " ");
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<std::vector<PriceBreak>> parse_price_breaks(std::string_view text) {
  std::vector<PriceBreak> breaks;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    const std::string_view item = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t colon = item.find(':');
    if (colon == item.npos) return std::nullopt;
    const auto pieces = number_of(item.substr(0, colon));
    const auto price = number_of(item.substr(colon + 1));
    if (!pieces || !price || *pieces < 1.0 || *pieces != std::floor(*pieces) || *price < 0.0) return std::nullopt;
    if (!breaks.empty() && *pieces <= breaks.back().pieces) return std::nullopt;
    breaks.push_back({*pieces, *price});
  }
  return breaks;
}

bool PiecePrice::is_plain_up_to(double pieces) const {
  for (double n = 1.0; n <= pieces; n += 1.0)
    if (purchase(n).price != n * single) return false;
  return true;
}

double PiecePrice::least(double most) const {
  double least = single;
  for (double n = 1.0; n <= most; n += 1.0) least = std::min(least, purchase(n).price / n);
  return least;
}

PiecePrice::Purchase PiecePrice::purchase(double needed) const {
  if (!(needed > 0.0)) return {};
  const auto in_packs = [&](double pieces) { return pack > 1.0 ? pack * std::ceil(pieces / pack) : pieces; };
  const auto of = [&](double pieces) {
    double each = single;
    for (const PriceBreak& at : breaks)
      if (pieces >= at.pieces) each = at.price;
    return Purchase{pieces, pieces * each};
  };
  Purchase best = of(in_packs(needed));
  for (const PriceBreak& at : breaks) {
    if (at.pieces <= needed) continue;
    const Purchase more = of(in_packs(at.pieces));
    if (more.price < best.price) best = more;
  }
  return best;
}

}  // namespace millwright::catalogue
