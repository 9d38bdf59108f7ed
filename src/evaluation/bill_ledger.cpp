// SPDX-License-Identifier: Apache-2.0
#include "evaluation/bill_ledger.h"

#include <cmath>
#include <set>

#include "evaluation/cuts.h"

namespace millwright::evaluation {
namespace {

/// What is done to the pieces that are cut, and what of the line's price is paid for them.
void add_work(const MachineModel& model,
              const catalogue::Table& table,
              const PartUse& use,
              const std::string& axis_name,
              PartLine& line) {
  if (line.cuts.empty() || use.family == catalogue::Family::materials) return;
  const PieceWork work = model.prices().work(table, use.row);
  line.length_price = line.price;
  if (use.family == catalogue::Family::linear_guides && !std::isnan(table.price(use.row).piece))
    line.length_price -= model.prices().line(table, use.row, use.pieces(), 0.0);
  line.from_bars = model.prices().bar(table, use.row).has_value();
  line.cutting_loss = line.from_bars ? 0.0 : work.cutting_loss;
  line.cut_price = work.cutting;
  line.end_price = work.machined_end;
  if (!(work.machined_end > 0.0)) return;
  for (const machine::Axis& axis : model.machine().axes)
    if (axis.name == axis_name) line.ends = use.pieces() * machined_ends(axis);
}

/// In which currency the price of a part is stated.
std::string stated_currency(const MachineModel& model, const PartUse& use, const std::string& axis_name) {
  if (use.stated.empty()) return std::string(model.catalogue().table(use.family).price(use.row).currency);
  for (const machine::Axis& axis : model.machine().axes)
    for (const machine::Reduction& reduction : axis.mechanism.reductions)
      if (axis.name == axis_name && (reduction.name == use.stated || !use.is_named())) return reduction.currency;
  return {};
}

/// A line of the bill of materials: what the catalogue says of a part of a build, and its share of the price.
PartLine part_line(const MachineModel& model,
                   const PartUse& use,
                   const std::string& axis,
                   const std::string& currency,
                   const CountedPartsLedger::Share& share) {
  PartLine line;
  line.axis = axis;
  line.slot = use.slot;
  line.quantity = use.quantity;
  line.spares = use.spares;
  line.length = use.length;
  line.price = share.price;
  line.owned = share.owned;
  line.unit_price = line.owned < use.pieces() ? line.price / (use.pieces() - line.owned) : 0.0;
  line.currency = currency;
  if (line.price > 0.0) line.stated_currency = stated_currency(model, use, axis);
  if (line.stated_currency == currency) line.stated_currency.clear();
  line.mass = use.mass;
  if (!use.stated.empty()) {
    line.manufacturer = use.is_named() ? "generic" : "";
    line.part_number = use.stated;
    line.price_basis = "stated in the problem";
    return line;
  }
  const catalogue::Table& table = model.catalogue().table(use.family);
  line.family = catalogue::declaration(use.family).name;
  line.manufacturer = table.manufacturer(use.row);
  line.part_number = table.part_number(use.row);
  const auto where = table.where(use.row);
  line.where = where.text ? where.text->path() + ":" + std::to_string(where.line) : std::string();
  line.price_basis = table.text(catalogue::column(use.family, "price_basis"), use.row);
  line.confidence = table.confidence(use.row);
  line.supplier = table.text(catalogue::column(use.family, "supplier"), use.row);
  line.source = table.text(catalogue::column(use.family, "source"), use.row);
  line.price_estimate = table.is_price_estimate(use.row);
  line.paper_only = table.text(catalogue::column(use.family, "evidence"), use.row) == "paper";
  line.preferred = catalogue::is_preferred(table, use.row, model.catalogue().stock());
  line.estimate = line.price_estimate || line.confidence == "low";
  line.cuts = cuts_of(model.machine(), use, axis);
  add_work(model, table, use, axis, line);
  return line;
}

}  // namespace

BillLedger::BillLedger(const MachineModel& model,
                       const solver::Build& build,
                       std::span<const CountedPart> counted_parts,
                       const Shops& shops,
                       Design& design)
    : model_(model), counted_(counted_parts), bars_(model.bars(), model.catalogue()), shops_(shops), design_(design) {
  for (const machine::Axis& axis : model.machine().axes)
    if (axis.motor.brake_torque > 0.0 || axis.counterbalance_force > 0.0)
      design.stated_only.push_back({axis.name, axis.motor.brake_torque, axis.counterbalance_force});
  for (std::size_t i = 0; i < model.entries().size(); ++i)
    for (std::size_t slot = 0; slot < model.entries()[i].tables().size(); ++slot)
      for (const PartUse& use : model.entries()[i].tables()[slot].candidate(build.stages[i].rows[slot]).parts) {
        counted_.take(use);
        const std::string& axis = model.entries()[i].axis;
        bars_.take({i, slot}, axis, use, cuts_of(model.machine(), use, axis));
      }
  bars_.finish();
}

void BillLedger::add_parts(const StageEntry& entry, std::span<const solver::Row> rows) {
  const auto& tables = entry.tables();
  const auto stage = static_cast<std::size_t>(&entry - model_.entries().data());
  for (std::size_t slot = 0; slot < tables.size(); ++slot) {
    const Candidate& candidate = tables[slot].candidate(rows[slot]);
    for (const PartUse& use : candidate.parts) {
      CountedPartsLedger::Share share = counted_.share(use);
      share.price += bars_.share({stage, slot}, use, cuts_of(model_.machine(), use, entry.axis));
      shops_.take(use, share.owned, share.price);
      design_.parts.push_back(part_line(model_, use, entry.axis, design_.currency, share));
      design_.cost += share.price - use.price;
      if (use.stated.empty())
        saved_by_preference_ +=
            (1.0 - model_.prices().preference(model_.catalogue().table(use.family), use.row)) * share.price;
    }
    for (const Setting& setting : candidate.settings)
      design_.dimensions.push_back({entry.axis, std::string(setting.name), setting.value, std::string(setting.unit)});
    design_.cost += candidate.price;
    design_.mass += candidate.mass;
  }
}

void BillLedger::add_custom_member(const StageEntry& entry, const machine::StructureMember<double>& member) {
  const catalogue::Table& materials = model_.catalogue().table(catalogue::Family::materials);
  const catalogue::Found found = materials.find(member.data->member.material);
  const double price = member.mass * member.data->price_per_mass;
  design_.mass += member.mass;
  design_.cost += price;
  if (!found || found.rows.empty()) return;
  design_.parts.push_back(part_line(model_,
                                    {.slot = member.data->member.name,
                                     .family = catalogue::Family::materials,
                                     .row = found.rows.front(),
                                     .quantity = member.data->member.count,
                                     .length = member.data->member.length,
                                     .price = price,
                                     .mass = member.mass},
                                    entry.axis,
                                    design_.currency,
                                    {0.0, price}));
}

void BillLedger::charge_orders() {
  design_.orders = shops_.orders();
  for (ShopOrder& order : design_.orders) {
    design_.cost += order.shipping_fee + order.top_up;
    const catalogue::Supplier* supplier = model_.catalogue().suppliers().find(order.supplier);
    if (supplier != nullptr && supplier->currency != design_.currency) order.stated_currency = supplier->currency;
  }
}

void BillLedger::finish() {
  if (design_.preference) design_.preference->compared_cost = design_.cost - saved_by_preference_;
  design_.purchases = counted_.purchases(model_.catalogue());
  design_.bars = bars_.purchases();
  design_.all_fewest_bars = model_.bars().all_fewest();
  add_conversions();
}

void BillLedger::add_conversions() {
  std::set<std::string> stated;
  for (const PartLine& line : design_.parts) stated.insert(line.stated_currency);
  for (const ShopOrder& order : design_.orders) stated.insert(order.stated_currency);
  for (const auto& [currency, rate] : model_.machine().currencies)
    if (stated.contains(currency)) design_.conversions.push_back({currency, rate.rate, rate.date});
}

}  // namespace millwright::evaluation
