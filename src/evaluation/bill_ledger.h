// SPDX-License-Identifier: Apache-2.0
//
// The bill of materials of a build, stage by stage: lines, what they share of the order, what the order costs beside
// them, and what the machine has by the problem's word only.
#pragma once

#include <span>

#include "evaluation/counted_parts.h"
#include "evaluation/machine_model.h"
#include "evaluation/shops.h"
#include "machine/structure_member.h"

namespace millwright::evaluation {

class BillLedger {
 public:
  /// Adds to `design`, of this build in rows of the model's entries. All must outlive this.
  BillLedger(const MachineModel& model,
             const solver::Build& build,
             std::span<const CountedPart> counted_parts,
             const Shops& shops,
             Design& design);

  /// What the rows of a stage put on the bill.
  void add_parts(const StageEntry& entry, std::span<const solver::Row> rows);
  /// A member made to measure is bar or shaft stock of its material, sold by mass.
  void add_custom_member(const StageEntry& entry, const machine::StructureMember<double>& member);
  /// After all parts that are ordered: shipping, and what orders are filled up by.
  void charge_orders();
  /// What has to be bought of parts that are counted, and the rates at which prices were converted.
  void finish();

 private:
  void add_conversions();

  const MachineModel& model_;
  CountedPartsLedger counted_;
  StockBarsLedger bars_;
  ShopLedger shops_;
  Design& design_;
  double saved_by_preference_ = 0.0;  ///< what the compared cost is below the cost
};

}  // namespace millwright::evaluation
