// SPDX-License-Identifier: Apache-2.0
#include "evaluation/design_bill.h"

#include <utility>

namespace millwright::evaluation {

machine::BillOfMaterials bill_of(const Design& design) {
  machine::BillOfMaterials bill;
  for (const PartLine& part : design.parts) {
    if (part.family == "materials" || (part.family.empty() && part.manufacturer.empty())) continue;
    machine::BomLine& line = bill.lines.emplace_back();
    line.axis = part.axis;
    line.slot = part.slot;
    line.manufacturer = part.manufacturer;
    line.part_number = part.part_number;
    line.quantity = part.quantity;
    if (part.length > 0.0) line.length = part.length;
  }
  for (const DimensionLine& dimension : design.dimensions) {
    machine::BomLine& line = bill.lines.emplace_back();
    line.axis = dimension.axis;
    line.slot = dimension.name;
    line.value = dimension.value;
  }
  return bill;
}

}  // namespace millwright::evaluation
