// SPDX-License-Identifier: Apache-2.0
#include "report/order_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

#include "catalogue/family.h"
#include "report/conversion_text.h"
#include "report/cut_text.h"
#include "report/quantity_text.h"
#include "scalar/unit.h"
#include "text/characters.h"

namespace millwright::report {

using catalogue::Family;
using evaluation::Cut;
using evaluation::Design;
using evaluation::PartLine;

namespace {

constexpr std::size_t no_family = catalogue::family_count;  // what the problem itself states

std::size_t family_of(const PartLine& part) {
  const auto found = std::find_if(catalogue::families.begin(), catalogue::families.end(), [&](const auto& each) {
    return each.name == part.family;
  });
  return static_cast<std::size_t>(found - catalogue::families.begin());
}

/// One of a family, in the words of a shop. `cut`: of what is sold by length beside the pieces.
std::string_view word_for(std::size_t family, bool cut) {
  if (family == no_family) return "reduction, as the problem says";
  switch (catalogue::families[family].family) {
    case Family::steppers:
      return "stepper motor";
    case Family::ball_screws:
      return cut ? "ball screw shaft" : "ball screw nut";
    case Family::lead_screws:
      return "lead screw";
    case Family::lead_nuts:
      return "lead screw nut";
    case Family::screws:
      return "socket head screw";
    case Family::support_bearings:
      return "screw support";
    case Family::couplings:
      return "shaft coupling";
    case Family::linear_guides:
      return cut ? "guide rail" : "guide carriage";
    case Family::belts:
      return "timing belt";
    case Family::pulleys:
      return "timing pulley";
    case Family::racks:
      return "toothed rack";
    case Family::pinions:
      return "pinion";
    case Family::drivers:
      return "stepper driver";
    case Family::power_supplies:
      return "power supply";
    case Family::extrusions:
      return "aluminium profile";
    case Family::steel_sections:
      return "steel section";
    case Family::materials:
      return "bar stock";
    case Family::stepper_curves:
    case Family::threads:
      break;  // not for sale
  }
  return catalogue::families[family].title;
}

std::string description_of(const PartLine& part, std::size_t family, bool cut) {
  std::string words(word_for(family, cut));
  if (part.family == "materials" && part.cuts.empty()) words = "weld metal";
  if (part.cuts.empty() && part.length > 0.0) words += fmt::format(" {} mm", millimetres_text(part.length));
  return words;
}

bool same_price(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

bool is_same(const OrderLine& a, const OrderLine& b) {
  return a.family == b.family && a.unit == b.unit && a.description == b.description &&
         a.manufacturer == b.manufacturer && a.part_number == b.part_number && a.supplier == b.supplier &&
         a.price_date == b.price_date && a.price_estimate == b.price_estimate && a.converted_at == b.converted_at &&
         same_price(a.unit_price, b.unit_price);
}

void put(OrderList& list, OrderLine line) {
  const auto same =
      std::find_if(list.lines.begin(), list.lines.end(), [&](const OrderLine& each) { return is_same(each, line); });
  if (same == list.lines.end()) {
    list.lines.push_back(std::move(line));
    return;
  }
  same->quantity += line.quantity;
  same->total += line.total;
  same->used_for += ", " + line.used_for;
}

/// Lengths by the metre, made to measure by the kilogram, the rest by the piece; of a guide two lines.
void add_part(OrderList& list, const Design& design, const PartLine& part) {
  OrderLine line;
  line.family = family_of(part);
  line.manufacturer = part.manufacturer;
  line.part_number = part.part_number;
  // A reduction that the problem states without a name has none to order by.
  const bool unnamed = part.family.empty() && part.manufacturer.empty();
  if (unnamed) line.part_number.clear();
  line.supplier = part.supplier;
  line.price_date = price_date(part.price_basis);
  line.price_estimate = part.price_estimate;
  line.converted_at = rate_of(design, part.stated_currency);
  line.paper_only = part.paper_only;
  line.used_for = part.axis + "." + part.slot;
  if (part.spares > 0.0) line.used_for += fmt::format(" and {} spare", scalar::format_number(part.spares));
  double metres = 0.0, pieces = 0.0;
  for (const Cut& cut : part.cuts) {
    metres += cut.count * (cut.length + part.cutting_loss);
    pieces += cut.count;
  }
  const auto add = [&](bool cut, std::string_view unit, double quantity, double total) {
    line.unit = unit;
    line.description = description_of(part, line.family, cut);
    line.quantity = quantity;
    line.total = total;
    line.unit_price = total / quantity;
    if (quantity > 0.0) put(list, line);
  };
  if (part.family == "materials") {
    add(true, "kg", part.mass, part.price);
    return;
  }
  // A guide's carriages and rails are one line of a build. What is only cut has no pieces beside.
  if (part.cuts.empty() || part.family == "linear_guides")
    add(false, "pcs", part.quantity + part.spares - part.owned, part.price - part.length_price);
  if (!part.cuts.empty()) {
    const double cutting = pieces * part.cut_price, machining = part.ends * part.end_price;
    add(true, "m", metres, part.length_price - cutting - machining);
    const std::string words = line.description;
    const auto add_work = [&](std::string_view what, double quantity, double each) {
      line.unit = "pcs";
      line.description = words + std::string(what);
      line.quantity = quantity;
      line.unit_price = each;
      line.total = quantity * each;
      if (line.total > 0.0) put(list, line);
    };
    add_work(", cut to length", pieces, part.cut_price);
    add_work(", end machined", part.ends, part.end_price);
  }
  // What is there is listed, so that nobody looks for it in vain, and costs nothing.
  line.supplier = in_stock;
  line.price_estimate = false;
  line.converted_at.clear();
  line.paper_only = false;
  if (part.owned > 0.0) add(false, "pcs", part.owned, 0.0);
}

/// "diameter 12.4 mm, ..." of the dimensions that were chosen for a member.
std::string section_of(const Design& design, const PartLine& part, const Cut& cut) {
  std::string out;
  const std::string prefix = part.slot + ".";
  const auto add = [&](std::string_view name, double metres) {
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", name, scalar::format(metres, scalar::Unit::of("mm")));
  };
  for (const evaluation::DimensionLine& line : design.dimensions)
    if (line.axis == part.axis && line.name.rfind(prefix, 0) == 0 && line.unit == "m")
      add(line.name.substr(prefix.size()), line.value);
  if (cut.width > 0.0) add("width", cut.width);
  return out;
}

void add_cuts(OrderList& list, const Design& design, const PartLine& part) {
  if (part.from_bars) return;
  for (const Cut& cut : part.cuts)
    list.cuts.push_back({description_of(part, family_of(part), true),
                         part.manufacturer,
                         part.part_number,
                         part.axis,
                         part.slot,
                         section_of(design, part, cut),
                         cut.count,
                         cut.length});
}

/// Bar by bar what is cut from it.
void add_bars(OrderList& list, const evaluation::BarPurchase& purchase) {
  PartLine part;
  part.family = purchase.family;
  part.cuts.emplace_back();
  const std::string description = description_of(part, family_of(part), true);
  const auto is_same_stock = [&](const CutLine& line) {
    return line.description == description && line.manufacturer == purchase.manufacturer &&
           line.part_number == purchase.part_number;
  };
  std::size_t number = 0;
  for (const CutLine& line : list.cuts)
    if (is_same_stock(line)) number = std::max(number, line.bar);
  for (const evaluation::CutBar& bar : purchase.bars) {
    ++number;
    for (const evaluation::BarPiece& piece : bar.pieces) {
      const auto same = std::find_if(list.cuts.begin(), list.cuts.end(), [&](const CutLine& line) {
        return is_same_stock(line) && line.bar == number && line.axis == piece.axis && line.slot == piece.slot &&
               line.length == piece.length;
      });
      if (same != list.cuts.end())
        same->count += 1.0;
      else
        list.cuts.push_back({description,
                             purchase.manufacturer,
                             purchase.part_number,
                             piece.axis,
                             piece.slot,
                             {},
                             1.0,
                             piece.length,
                             number});
    }
  }
}

/// Whole bars in the place of their metres.
void settle(OrderList& list, const evaluation::BarPurchase& purchase) {
  const auto is_of = [&](const OrderLine& line) {
    return line.unit == "m" && line.family < catalogue::family_count &&
           catalogue::families[line.family].name == purchase.family && line.manufacturer == purchase.manufacturer &&
           line.part_number == purchase.part_number && line.supplier == purchase.supplier;
  };
  const auto first = std::find_if(list.lines.begin(), list.lines.end(), is_of);
  if (first == list.lines.end()) return;
  for (auto other = std::next(first); other != list.lines.end(); ++other)
    if (is_of(*other)) first->used_for += ", " + other->used_for;
  first->unit = "pcs";
  first->description += fmt::format(", bar of {} mm", millimetres_text(purchase.stock_length));
  first->quantity = static_cast<double>(purchase.bars.size());
  first->unit_price = purchase.bar_price;
  first->total = first->quantity * first->unit_price;
  list.lines.erase(std::remove_if(std::next(first), list.lines.end(), is_of), list.lines.end());
}

/// One line for a part whose price depends on how many are bought, with as many as it is cheapest to buy.
void settle(OrderList& list, const evaluation::Purchase& purchase) {
  const auto is_of = [&](const OrderLine& line) {
    const bool is_of_family =
        line.family < catalogue::family_count && catalogue::families[line.family].name == purchase.family;
    return is_of_family && line.manufacturer == purchase.manufacturer && line.part_number == purchase.part_number &&
           line.supplier == purchase.supplier && line.supplier != in_stock;
  };
  if (!(purchase.bought > 0.0)) return;
  const auto first = std::find_if(list.lines.begin(), list.lines.end(), is_of);
  if (first == list.lines.end()) return;
  for (auto other = std::next(first); other != list.lines.end(); ++other)
    if (is_of(*other)) first->used_for += ", " + other->used_for;
  first->quantity = purchase.bought;
  first->total = purchase.price;
  first->unit_price = purchase.price / purchase.bought;
  const double left_over = purchase.bought - (purchase.taken - purchase.owned);
  if (left_over > 0.0) first->used_for += fmt::format(", {} left over", scalar::format_number(left_over));
  list.lines.erase(std::remove_if(std::next(first), list.lines.end(), is_of), list.lines.end());
}

auto stock_of(const CutLine& cut) { return std::tie(cut.description, cut.manufacturer, cut.part_number); }
auto stock_of(const StockTotal& total) { return std::tie(total.description, total.manufacturer, total.part_number); }

void sort(OrderList& list) {
  std::stable_sort(list.lines.begin(), list.lines.end(), [](const OrderLine& a, const OrderLine& b) {
    const auto key = [](const OrderLine& line) {
      return std::tuple(line.supplier.empty(),
                        std::string_view(line.supplier),
                        line.family,
                        std::string_view(line.manufacturer),
                        std::string_view(line.part_number),
                        std::string_view(line.description));
    };
    return key(a) < key(b);
  });
  std::stable_sort(list.cuts.begin(), list.cuts.end(), [](const CutLine& a, const CutLine& b) {
    if (stock_of(a) != stock_of(b)) return stock_of(a) < stock_of(b);
    return a.bar != b.bar ? a.bar < b.bar : a.length > b.length;
  });
}

/// What is bought for a piece that comes from a bar; of each seller.
std::string bars_of(const Design& design, const CutLine& cut) {
  std::string out;
  if (cut.bar == 0) return out;
  for (const evaluation::BarPurchase& purchase : design.bars)
    if (purchase.manufacturer == cut.manufacturer && purchase.part_number == cut.part_number)
      out += (out.empty() ? "" : "; ") + bars_text(purchase);
  return out;
}

/// Without lines as yet.
SupplierTotal supplier_total(const Design& design, const std::string& supplier) {
  SupplierTotal total;
  total.supplier = supplier;
  for (const evaluation::ShopOrder& order : design.orders) {
    if (order.supplier != supplier) continue;
    total.shipping_fee = order.shipping_fee;
    total.minimum_order = order.minimum_order;
    total.top_up = order.top_up;
    total.converted_at = rate_of(design, order.stated_currency);
  }
  return total;
}

/// The text at `at` has this pattern of digits (0) and other characters, and no digit or hyphen goes on on either side.
bool matches(const std::string& text, std::size_t at, std::string_view pattern) {
  if (at + pattern.size() > text.size()) return false;
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (pattern[i] == '0' ? !text::is_digit(text[at + i]) : text[at + i] != pattern[i]) return false;
  const auto goes_on = [](char c) { return text::is_digit(c) || c == '-'; };
  if (at > 0 && goes_on(text[at - 1])) return false;
  return at + pattern.size() == text.size() || !goes_on(text[at + pattern.size()]);
}

}  // namespace

std::string price_date(const std::string& basis) {
  for (const std::string_view pattern : {"2000-00-00", "2000-2000", "2000"}) {
    // The first digits of a year stand for themselves.
    for (std::size_t at = basis.find("20"); at != std::string::npos; at = basis.find("20", at + 1))
      if (matches(basis, at, pattern)) return basis.substr(at, pattern.size());
  }
  return {};
}

OrderList order_list(const Design& design, const std::string& title) {
  OrderList list;
  list.title = title;
  list.currency = design.currency;
  list.total = design.cost;
  for (const PartLine& part : design.parts) {
    add_part(list, design, part);
    add_cuts(list, design, part);
  }
  for (const evaluation::Purchase& purchase : design.purchases) settle(list, purchase);
  for (const evaluation::BarPurchase& purchase : design.bars) {
    add_bars(list, purchase);
    settle(list, purchase);
  }
  sort(list);
  for (const OrderLine& line : list.lines) {
    if (line.supplier == in_stock) continue;
    if (list.supplier_totals.empty() || list.supplier_totals.back().supplier != line.supplier)
      list.supplier_totals.push_back(supplier_total(design, line.supplier));
    list.supplier_totals.back().total += line.total;
  }
  for (const CutLine& cut : list.cuts) {
    if (list.stock.empty() || stock_of(list.stock.back()) != stock_of(cut))
      list.stock.push_back({cut.description, cut.manufacturer, cut.part_number, 0.0, 0.0, bars_of(design, cut)});
    list.stock.back().pieces += cut.count;
    list.stock.back().length += cut.count * cut.length;
  }
  return list;
}

}  // namespace millwright::report
