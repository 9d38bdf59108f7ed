// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lint_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "catalogue/piece_price.h"
#include "catalogue/slip.h"
#include "scalar/unit.h"

namespace millwright::catalogue {
namespace {

/// An offer may be so many times dearer or cheaper than the catalogue's own price, which is often an estimate.
constexpr double usual_ratio = 5.0;
/// Of all that a supplier sells, one piece or metre each: a fee above this many of them, a minimum order above.
constexpr double most_fee = 1.0, most_minimum = 10.0;
/// Cutting a piece, or machining an end, may cost so many whole bars.
constexpr double most_work = 5.0;
/// More pieces of one part than a workshop has.
constexpr double most_owned = 1000.0;

/// Prices in US dollars and euros are near enough to each other; others are compared with none but their own.
std::string_view comparable(std::string_view currency) { return currency == "EUR" ? "USD" : currency; }

class OverlayLint {
 public:
  OverlayLint(const Catalogue& parts, const Suppliers& suppliers, text::Diagnostics& diagnostics)
      : parts_(parts), suppliers_(suppliers), diagnostics_(diagnostics) {}

  void judge() {
    for (const Offer& offer : suppliers_.offers) judge(offer);
    if (!suppliers_.suppliers.empty()) add_up();
    for (const Supplier& supplier : suppliers_.suppliers) judge(supplier);
  }

 private:
  void judge(const Offer& offer) {
    const FoundParts found = parts_.find(offer.part_number, offer.manufacturer);
    const auto part = std::find_if(
        found.parts.begin(), found.parts.end(), [&](const Part& each) { return each.family == offer.family; });
    if (part == found.parts.end()) return;  // its line is wrong, and reported
    const Price own = parts_.table(part->family).price(part->row);
    const bool same_money = comparable(own.currency) == comparable(offer.currency);
    compare(offer, "price", offer.price, same_money ? own.piece : std::nan(""));
    compare(offer, "price_per_length", offer.price_per_length, same_money ? own.length : std::nan(""));
    check_cutting(offer);
    const auto breaks = parse_price_breaks(offer.price_breaks);
    if (!breaks) return;
    double before = offer.price;
    for (const PriceBreak& each : *breaks) {
      if (each.price > before)
        diagnostics_.warning(offer.where,
                             fmt::format("{}: from {} pieces on each costs {} {}, more than the {} below that "
                                         "[price-breaks]",
                                         offer.part_number,
                                         each.pieces,
                                         each.price,
                                         offer.currency,
                                         before),
                             "is that the price of all of them? what stands there is that of one");
      before = each.price;
    }
  }

  /// The terms of cutting are those of the family's columns.
  void check_cutting(const Offer& offer) {
    const CuttingTerms& terms = offer.cutting;
    const auto check = [&](std::string_view name, double value) {
      const auto found = find_column(offer.family, name);
      if (!found || std::isnan(value)) return;
      const ColumnDeclaration& declared = declaration(*found);
      const bool is_length = declared.kind == Kind::number;
      const double shown = is_length ? scalar::Unit::of(declared.unit).from_si(value) : value;
      constexpr double rounding = 1e-9;
      const bool low = shown<declared.lower*(1.0 - rounding), high = shown> declared.upper * (1.0 + rounding);
      if (!low && !high) return;
      const std::string_view unit = is_length ? declared.unit : std::string_view(offer.currency);
      diagnostics_.warning(offer.where,
                           fmt::format("{}: {} {} {} is outside the plausible {} to {} [magnitude]",
                                       offer.part_number,
                                       name,
                                       scalar::format_number(shown, 5),
                                       unit,
                                       scalar::format_number(declared.lower),
                                       scalar::format_number(declared.upper)),
                           is_length ? fmt::format("what stands there is read in {}", declared.unit)
                                     : std::string("of one piece or end, in the offer's currency"));
    };
    check("stock_length", terms.stock_length);
    check("cutting_loss", terms.cutting_loss);
    check("cut_price", terms.cut_price);
    check("end_machining_price", terms.end_machining_price);
    dearer_than_a_bar(offer, "cut_price", terms.cut_price);
    dearer_than_a_bar(offer, "end_machining_price", terms.end_machining_price);
  }

  /// Work on one piece or end for which a whole bar could be had, where that much is known, is doubted.
  void dearer_than_a_bar(const Offer& offer, std::string_view name, double price) {
    const double bar = offer.cutting.stock_length * offer.price_per_length;
    if (!(price > most_work * bar)) return;
    diagnostics_.warning(offer.where,
                         fmt::format("{}: {} {} {} is more than {} bars cost there, {} [cutting-price]",
                                     offer.part_number,
                                     name,
                                     scalar::format_number(price, 5),
                                     offer.currency,
                                     scalar::format_number(most_work),
                                     scalar::format_number(most_work * bar, 5)),
                         "decimal point, or the price of all pieces? what stands there is of one");
  }

  void compare(const Offer& offer, std::string_view what, double price, double own) {
    if (price == 0.0) {
      diagnostics_.warning(offer.where,
                           fmt::format("{}: {} is 0 [offer-price]", offer.part_number, what),
                           "what you have costs nothing: say so in stock.csv (owned)");
      return;
    }
    if (!(own > 0.0) || !(price > 0.0)) return;
    const double ratio = price / own;
    if (ratio <= usual_ratio && ratio >= 1.0 / usual_ratio) return;
    diagnostics_.warning(offer.where,
                         fmt::format("{}: {} {} {} is {}, the catalogue's own is {} [offer-price]",
                                     offer.part_number,
                                     what,
                                     scalar::format_number(price, 5),
                                     offer.currency,
                                     times(ratio),
                                     scalar::format_number(own, 5)),
                         cause(offer, ratio));
  }

  static std::string cause(const Offer& offer, double ratio) {
    const auto about = [&](double factor) { return ratio > 0.7 * factor && ratio < 1.4 * factor; };
    if (offer.pack_size > 1.0 && about(offer.pack_size))
      return "the price of a pack? what stands there is of one piece";
    if (about(1000.0) || about(1e-3)) return "price of a thousand, or a millimetre for a metre?";
    if (about(100.0)) return "cents, or the price of a hundred?";
    if (about(10.0) || about(0.1)) return "decimal point, or the price of ten?";
    return "is it the same part?";
  }

  /// What one of each costs that a supplier sells, by its name and currency.
  void add_up() {
    const auto add = [&](std::string_view supplier, std::string_view currency, double amount) {
      if (!(amount > 0.0)) return;
      sold_[std::string(supplier)][std::string(comparable(currency))] += amount;
    };
    for (const Offer& offer : suppliers_.offers) {
      add(offer.supplier, offer.currency, offer.price);
      add(offer.supplier, offer.currency, offer.price_per_length);
    }
    for (const FamilyDeclaration& family : families) {
      if (!family.priced()) continue;
      const Table& table = parts_.table(family.family);
      for (int row = 0; row < table.rows(); ++row) {
        const Price price = table.price(row);
        for (const double amount : {price.piece, price.length})
          add(table.text("supplier", row), price.currency, amount);
      }
    }
  }

  void judge(const Supplier& supplier) {
    const auto found = sold_.find(supplier.name);
    if (found == sold_.end()) return;  // it sells nothing, and that is told
    const auto sum = found->second.find(std::string(comparable(supplier.currency)));
    const bool other_money = found->second.size() > 1 || sum == found->second.end();
    if (other_money) return;  // no rates here
    const auto too_much = [&](double amount, double most, std::string_view rule, std::string_view what) {
      if (amount > most * sum->second)
        diagnostics_.warning(supplier.where,
                             fmt::format("{} {} {} is more than {} of each of all that is sold there, {} [{}]",
                                         what,
                                         scalar::format_number(amount, 5),
                                         supplier.currency,
                                         most == 1.0 ? "one" : scalar::format_number(most, 3),
                                         scalar::format_number(most * sum->second, 5),
                                         rule),
                             "decimal point, or another currency?");
    };
    too_much(supplier.shipping_fee, most_fee, "shipping-fee", "a shipping fee of");
    too_much(supplier.minimum_order, most_minimum, "minimum-order", "a minimum order of");
  }

  const Catalogue& parts_;
  const Suppliers& suppliers_;
  text::Diagnostics& diagnostics_;
  std::map<std::string, std::map<std::string, double>> sold_;
};

void judge_stock(const Catalogue& parts, const Stock& stock, text::Diagnostics& diagnostics) {
  if (stock.empty()) return;
  for (const FamilyDeclaration& family : families) {
    const Table& table = parts.table(family.family);
    for (int row = 0; row < table.rows(); ++row) {
      const StockMark* mark = stock.find(family.family, table.manufacturer(row), table.part_number(row));
      if (mark == nullptr || !(mark->owned > most_owned)) continue;
      diagnostics.warning(mark->where,
                          fmt::format("{}: {} pieces are owned [stock]", table.part_number(row), mark->owned),
                          "is that the stock of a shop? what is owned costs nothing");
    }
  }
}

}  // namespace

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::vector<std::filesystem::path> overlay_files(const std::vector<std::filesystem::path>& places) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const std::filesystem::path& file) {
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  };
  for (const std::filesystem::path& place : places) {
    if (const auto stock = stock_file(place)) add(*stock);
    // Suppliers and their offers belong together, also where one of them is named alone.
    const bool alone = is_supplier_file(place) && std::filesystem::exists(place);
    for (const std::filesystem::path& file : supplier_files(alone ? folder_of(place) : place)) add(file);
  }
  return files;
}

void lint_overlay(const std::vector<std::filesystem::path>& files,
                  const Catalogue& parts,
                  text::Diagnostics& diagnostics) {
  Suppliers suppliers;
  for (const std::filesystem::path& file : files) {
    if (!is_stock_file(file)) {
      read_suppliers(file, parts, suppliers, diagnostics);
      continue;
    }
    Stock stock;
    read_stock(file, parts, stock, diagnostics);
    judge_stock(parts, stock, diagnostics);
  }
  check_suppliers(parts, suppliers, diagnostics);
  OverlayLint(parts, suppliers, diagnostics).judge();
}

}  // namespace millwright::catalogue
