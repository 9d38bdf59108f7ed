// SPDX-License-Identifier: Apache-2.0
// Units as shops print them: "Nm", "oz-in", "gcm2", "KG", "A/phase", "EUR/m".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "catalogue/family.h"
#include "scalar/unit.h"

namespace millwright::catalogue {

struct ShopUnit {
  std::string unit;      ///< as our header takes it; "" for a plain number or a price per piece
  scalar::Unit meaning;  ///< its conversion, without the currency
  std::string currency;  ///< of a price: ISO 4217, or "?" for a sign that several currencies share
  std::string remark;    ///< what was taken for what, if it is not the same: "kg.cm as kgf.cm"
};

/// What the words around a number, or in a header, mean for this column; none (and why) if they are no unit that fits
/// it. Brackets around them do not count.
std::optional<ShopUnit> shop_unit(std::string_view words, Column column, std::string& reason);

/// Whether the words are any unit at all, of whatever dimension, or a currency.
bool is_any_unit(std::string_view words);

/// "EUR" for "EUR", "€"; "?" for "$"; empty if it is no currency.
std::string currency_of(std::string_view words);

}  // namespace millwright::catalogue
