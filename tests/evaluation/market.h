// SPDX-License-Identifier: Apache-2.0
// Shops for tests of orders: who sells which part of the tiny catalogue for how much, what an order there costs, and
// what is in the drawer.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "catalogue/temporary_folder.h"
#include "catch.h"
#include "evaluation/synthesis.h"

namespace millwright {

/// What an order costs beside its goods.
struct Shop {
  std::string name;
  double fee = 0.0, minimum = 0.0;
};

/// What the tiny catalogue asks for parts that other shops sell, too.
inline const std::map<std::string, double> usual_prices = {
    {"M17", 9.0}, {"M23", 16.0}, {"D2", 6.0}, {"D4", 20.0}, {"K8", 2.0}};

/// Who sells what. The shop without a name sells everything at the catalogue's price.
struct Market {
  std::vector<Shop> shops = {{"", 0.0, 0.0}};
  std::map<std::string, std::map<std::size_t, double>> offers;  ///< [part][shop]: price
  std::map<std::string, int> owned;
  std::map<std::string, double> preferred = {};  ///< [part]: by how much of its price it may be dearer, one for all

  [[nodiscard]] double factor(const std::string& part) const {
    const auto found = preferred.find(part);
    return found == preferred.end() ? 1.0 : 1.0 / (1.0 + found->second);
  }

  /// [shop]: what a piece of one of `usual_prices` costs there.
  [[nodiscard]] std::map<std::size_t, double> prices(const std::string& part) const {
    std::map<std::size_t, double> all = {{0, usual_prices.at(part)}};
    if (const auto offered = offers.find(part); offered != offers.end())
      all.insert(offered->second.begin(), offered->second.end());
    return all;
  }

  void write(const TemporaryFolder& folder) const {
    std::string text = "supplier,shipping_fee,minimum_order,currency\n";
    for (const Shop& shop : shops) text += fmt::format("{},{},{},USD\n", shop.name, shop.fee, shop.minimum);
    folder.write("suppliers.csv", text);
    text = "part_number,supplier,price,currency\n";
    for (const auto& [part, by] : offers)
      for (const auto& [shop, price] : by) text += fmt::format("{},{},{},USD\n", part, shops[shop].name, price);
    folder.write("offers.csv", text);
    text = "part_number,owned,available\n";
    for (const auto& [part, pieces] : owned)
      text += fmt::format("{},{},{}\n", part, pieces, preferred.contains(part) ? "preferred" : "");
    for (const auto& [part, premium] : preferred)
      if (!owned.contains(part)) text += fmt::format("{},,preferred\n", part);
    if (!owned.empty() || !preferred.empty()) folder.write("stock.csv", text);
  }
};

/// Three shops, the first of which sells everything.
inline Market random_market(std::mt19937& random, unsigned seed) {
  const auto between = [&](double low, double high) {
    return std::round(100.0 * (low + (high - low) * static_cast<double>(random() >> 8U) / 16777216.0)) / 100.0;
  };
  Market market;
  market.shops.push_back({"Shop A", between(0.0, 6.0), 0.0});
  market.shops.push_back({"Shop B", between(0.0, 3.0), seed % 3 == 0 ? 0.0 : between(5.0, 40.0)});
  if (seed % 4 == 1) market.shops[0] = {"", between(1.0, 8.0), 0.0};
  if (seed % 4 == 2) market.shops[0] = {"", between(1.0, 4.0), between(50.0, 200.0)};
  for (const auto& [part, price] : usual_prices)
    for (const std::size_t shop : {std::size_t{1}, std::size_t{2}})
      if (random() % 3 != 0) market.offers[part][shop] = std::round(100.0 * between(0.5, 1.1) * price) / 100.0;
  for (const char* part : {"M17", "D2", "K8"})
    if (random() % 4 == 0) market.owned[part] = 1 + static_cast<int>(random() % 2);
  return market;
}

/// Lines and orders of a design add up to its cost, and every order is what its lines say.
inline void require_sound(const evaluation::Design& design, const Market& market) {
  double cost = 0.0;
  std::map<std::string, double> goods;
  for (const evaluation::PartLine& part : design.parts) {
    cost += part.price;
    if (part.owned < part.quantity + part.spares) goods[part.supplier] += part.price;
  }
  for (const evaluation::ShopOrder& order : design.orders) {
    const auto shop = std::find_if(
        market.shops.begin(), market.shops.end(), [&](const Shop& each) { return each.name == order.supplier; });
    REQUIRE(shop != market.shops.end());
    CHECK(order.shipping_fee == shop->fee);
    REQUIRE(goods.count(order.supplier) == 1);
    CHECK(order.goods == Approx(goods[order.supplier]).margin(1e-9));
    CHECK(order.top_up == Approx(std::max(0.0, shop->minimum - order.goods)).margin(1e-9));
    cost += order.shipping_fee + order.top_up;
  }
  CHECK(design.cost == Approx(cost).epsilon(1e-12));
}

}  // namespace millwright
