// SPDX-License-Identifier: Apache-2.0
#include "evaluation/bill_ledger.h"

#include "evaluation/cuts.h"

namespace millwright::evaluation {
namespace {

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
  const catalogue::Price price = table.price(use.row);
  line.price_estimate = price.estimate;
  line.paper_only = table.text(catalogue::column(use.family, "evidence"), use.row) == "paper";
  line.estimate = price.estimate || line.confidence == "low";
  line.cuts = cuts_of(model.machine(), use, axis);
  line.length_price = length_price_of(price, use, line.cuts);
  return line;
}

}  // namespace

BillLedger::BillLedger(const MachineModel& model,
                       const solver::Build& build,
                       std::span<const CountedPart> counted_parts,
                       const Shops& shops,
                       Design& design)
    : model_(model), counted_(counted_parts), shops_(shops), design_(design) {
  for (const machine::Axis& axis : model.machine().axes)
    if (axis.motor.brake_torque > 0.0 || axis.counterbalance_force > 0.0)
      design.stated_only.push_back({axis.name, axis.motor.brake_torque, axis.counterbalance_force});
  for (std::size_t i = 0; i < model.entries().size(); ++i)
    for (std::size_t slot = 0; slot < model.entries()[i].tables().size(); ++slot)
      for (const PartUse& use : model.entries()[i].tables()[slot].candidate(build.stages[i].rows[slot]).parts)
        counted_.set_aside(use);
}

void BillLedger::add_parts(const StageEntry& entry, std::span<const solver::Row> rows) {
  const auto& tables = entry.tables();
  for (std::size_t slot = 0; slot < tables.size(); ++slot) {
    const Candidate& candidate = tables[slot].candidate(rows[slot]);
    for (const PartUse& use : candidate.parts) {
      const CountedPartsLedger::Share share = counted_.take(use);
      shops_.take(use, share.owned, share.price);
      design_.parts.push_back(part_line(model_, use, entry.axis, design_.currency, share));
      design_.cost += share.price - use.price;
    }
    for (const Setting& setting : candidate.settings)
      design_.dimensions.push_back({entry.axis, setting.name, setting.value, setting.unit});
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
  for (const ShopOrder& order : design_.orders) design_.cost += order.shipping_fee + order.top_up;
}

void BillLedger::finish() { design_.purchases = counted_.purchases(model_.catalogue()); }

}  // namespace millwright::evaluation
