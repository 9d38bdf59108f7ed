// SPDX-License-Identifier: Apache-2.0
#include "evaluation/reduction_slot.h"

#include <algorithm>

namespace millwright::evaluation {

namespace {

std::vector<double> readings_of(const machine::Reduction& stated) {
  machine::ReductionReading<double> r;
  r.ratio = stated.ratio;
  r.efficiency = stated.efficiency;
  r.inertia = stated.inertia;
  r.backlash = stated.backlash;
  r.compliance = stated.stiffness ? 1.0 / *stated.stiffness : 0.0;
  r.rated_torque = stated.rated_torque.value_or(0.0);
  r.largest_speed = stated.largest_speed.value_or(0.0);
  r.shaft = stated.shaft;
  r.mass = stated.mass;
  std::vector<double> values;
  visit_reduction_reading(r, [&](const double& x) { values.push_back(x); });
  return values;
}

}  // namespace

ReductionSlot::ReductionSlot(const machine::Axis& axis, const PriceBook& prices)
    : reductions_(axis.mechanism.reductions) {
  if (reductions_.empty()) return;
  for (const machine::Reduction& r : reductions_) {
    readings_.push_back(readings_of(r));
    PartUse use;
    use.slot = "reduction";
    use.stated = r.name.empty() ? PartUse::unnamed : std::string_view(r.name);
    use.price = r.price > 0.0 ? r.price * prices.rate(r.currency) : 0.0;
    use.mass = r.mass;
    // Where the motor rides, the drive's own moved mass has it; the parent bears it either way.
    CandidateDraft candidate;
    candidate.price = use.price;
    candidate.mass = candidate.standing_mass = use.mass;
    candidate.parts.push_back(use);
    table_.add(std::move(candidate), {});
  }
  const auto [least, largest] = std::minmax_element(
      reductions_.begin(), reductions_.end(), [](const auto& a, const auto& b) { return a.ratio < b.ratio; });
  least_ratio_ = least->ratio;
  largest_ratio_ = largest->ratio;
}

void ReductionSlot::add_to(std::vector<SlotTable>& tables) {
  if (reductions_.empty()) return;
  slot_ = tables.size();
  tables.push_back(table_);
}

}  // namespace millwright::evaluation
