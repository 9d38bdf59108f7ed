// SPDX-License-Identifier: Apache-2.0
#include "report/design_json.h"

#include "report/conversion_text.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;

namespace {

const char* kind_name(machine::ConstraintKind kind) { return kind == machine::ConstraintKind::soft ? "soft" : "hard"; }

Json quantity(double value, const std::string& unit) { return Json{{"value", number(value)}, {"unit", unit}}; }

Json part_of(const Design& design, const evaluation::PartLine& part) {
  Json json{{"axis", part.axis},
            {"slot", part.slot},
            {"family", part.family},
            {"manufacturer", part.manufacturer},
            {"part_number", part.part_number},
            {"quantity", number(part.quantity)},
            {"length_m", part.length > 0.0 ? number(part.length) : Json(nullptr)},
            {"unit_price", number(part.unit_price)},
            {"price", number(part.price)},
            {"currency", part.currency},
            {"mass_kg", number(part.mass)},
            {"estimate", part.estimate},
            {"row", part.where}};
  if (part.spares > 0.0) json["spares"] = number(part.spares);
  if (part.owned > 0.0) json["owned"] = number(part.owned);
  double pieces = 0.0;
  for (const evaluation::Cut& cut : part.cuts) pieces += cut.count;
  if (part.cut_price > 0.0) json["cutting_price"] = number(pieces * part.cut_price);
  if (part.ends * part.end_price > 0.0) json["end_machining_price"] = number(part.ends * part.end_price);
  if (const evaluation::Conversion* from = conversion_from(design, part.stated_currency))
    json["stated_price"] = quantity(part.price / from->rate, from->currency);
  if (part.preferred) json["preferred"] = true;
  if (part.paper_only) json["known_from_paper_only"] = true;
  if (!part.supplier.empty()) json["supplier"] = part.supplier;
  if (!part.origin.empty()) json["origin"] = part.origin;
  return json;
}

Json check_of(const Check& check) {
  Json json{{"axis", check.axis},
            {"element", check.element},
            {"id", check.id},
            {"title", check.title},
            {"kind", kind_name(check.kind)},
            {"value", number(check.value)},
            {"limit", number(check.limit)},
            {"unit", check.unit},
            {"utilisation", number(check.utilisation)},
            {"verdict", verdict_name(check.verdict)},
            {"phase", check.phase},
            {"position", check.position},
            {"source", check.source}};
  if (!check.requirement.empty()) json["requirement"] = check.requirement;
  if (!check.note.empty()) json["note"] = check.note;
  for (const evaluation::Contribution& part : check.contributions)
    json["contributions"].push_back({{"what", part.what}, {"value", number(part.value)}});
  return json;
}

}  // namespace

const char* verdict_name(evaluation::Verdict verdict) {
  switch (verdict) {
    case evaluation::Verdict::satisfied:
      return "satisfied";
    case evaluation::Verdict::violated:
      return "violated";
    case evaluation::Verdict::not_evaluated:
      return "not evaluated";
  }
  return "";
}

std::string unit_of(machine::Quantity counted, const std::string& currency) {
  return counted == machine::Quantity::cost ? currency : std::string(machine::declaration(counted).unit);
}

void add_catalogues(const MachineResult& result, Json& json) {
  if (!result.catalogues.layers.empty()) json["catalogues"] = catalogues_json(result.catalogues);
}

Json totals_of(const Design& design) {
  Json totals{{"cost", quantity(design.cost, design.currency)}, {"mass", quantity(design.mass, "kg")}};
  for (const evaluation::CountedTotal& each : design.counted) {
    Json total = quantity(each.value, unit_of(each.quantity, design.currency));
    if (each.quantity == machine::Quantity::energy) total["estimate"] = true;
    totals[std::string(machine::declaration(each.quantity).name)] = std::move(total);
  }
  return totals;
}

/// The bars that are bought of one part, with what is cut from each.
Json bars_of(const evaluation::BarPurchase& purchase, const std::string& currency) {
  Json bars = Json::array();
  for (const evaluation::CutBar& bar : purchase.bars) {
    Json pieces = Json::array();
    for (const evaluation::BarPiece& piece : bar.pieces)
      pieces.push_back({{"axis", piece.axis}, {"slot", piece.slot}, {"length_m", number(piece.length)}});
    bars.push_back({{"pieces", pieces}, {"left_over_m", number(bar.left_over)}});
  }
  return {{"family", purchase.family},
          {"manufacturer", purchase.manufacturer},
          {"part_number", purchase.part_number},
          {"supplier", purchase.supplier},
          {"stock_length_m", number(purchase.stock_length)},
          {"cutting_loss_m", number(purchase.cutting_loss)},
          {"bar_price", number(purchase.bar_price)},
          {"currency", currency},
          {"bars", bars},
          {"fewest_proved", purchase.is_fewest}};
}

Json build_of(const Design& design) {
  Json parts = Json::array();
  for (const evaluation::PartLine& part : design.parts) parts.push_back(part_of(design, part));
  Json dimensions = Json::array();
  for (const evaluation::DimensionLine& line : design.dimensions)
    dimensions.push_back(
        {{"axis", line.axis}, {"name", line.name}, {"value", number(line.value)}, {"unit", line.unit}});
  Json json{{"parts", parts}, {"dimensions", dimensions}};
  for (const evaluation::StatedOnly& each : design.stated_only)
    json["not_included"].push_back({{"axis", each.axis},
                                    {"brake_torque", number(each.brake_torque)},
                                    {"counterbalance_force", number(each.counterbalance_force)}});
  for (const evaluation::BarPurchase& purchase : design.bars)
    json["bars"].push_back(bars_of(purchase, design.currency));
  for (const evaluation::ShopOrder& order : design.orders) {
    Json each{{"supplier", order.supplier},
              {"goods", number(order.goods)},
              {"shipping_fee", number(order.shipping_fee)},
              {"minimum_order", number(order.minimum_order)},
              {"top_up", number(order.top_up)},
              {"currency", design.currency}};
    if (!order.stated_currency.empty()) each["stated_currency"] = order.stated_currency;
    json["orders"].push_back(std::move(each));
  }
  for (const evaluation::Conversion& each : design.conversions)
    json["conversions"].push_back({{"currency", each.currency},
                                   {"rate", number(each.rate)},
                                   {"into", design.currency},
                                   {"date", each.date.empty() ? Json(nullptr) : Json(each.date)}});
  return json;
}

Json checks_json(const MachineResult& result, const Design& design) {
  Json checks = Json::array();
  for (const std::string& axis : checked_axes(result))
    for (const Check* check : checks_of(design, axis)) checks.push_back(check_of(*check));
  return checks;
}

Json governing_of(const MachineResult& result, const Design& design) {
  Json governing = Json::array();
  for (const std::string& axis : checked_axes(result))
    if (const Check* check = design.governing(axis))
      governing.push_back({{"axis", axis}, {"id", check->id}, {"utilisation", number(check->utilisation)}});
  return governing;
}

}  // namespace millwright::report
