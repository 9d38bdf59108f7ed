// SPDX-License-Identifier: Apache-2.0
#include "evaluation/part_line.h"

#include "evaluation/cuts.h"

namespace millwright::evaluation {

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
  line.estimate = price.estimate || line.confidence == "low";
  line.cuts = cuts_of(model.machine(), use, axis);
  line.length_price = length_price_of(price, use, line.cuts);
  return line;
}

}  // namespace millwright::evaluation
