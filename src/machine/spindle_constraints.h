// SPDX-License-Identifier: Apache-2.0
//
// Whether the spindle is strong enough for the cuts of the moves: made where a cut states the spindle's power.
#pragma once

#include "machine/axis_motion.h"
#include "machine/constraint.h"
#include "machine/requirement.h"

namespace millwright::machine {

/// The cut that takes the largest share of its spindle's power, null if none states a spindle.
inline const CuttingProcess* hardest_cut(const MotionData& motion) {
  const CuttingProcess* hardest = nullptr;
  const auto share = [](const CuttingProcess& cut) { return cutting_power<double>(cut) / cut.spindle_power; };
  for (const Move& move : motion.moves)
    if (move.cutting && move.cutting->spindle_power > 0.0 &&
        (hardest == nullptr || share(*move.cutting) > share(*hardest)))
      hardest = &*move.cutting;
  return hardest;
}

template <class Visit>
void spindle_constraints(Visit&& visit) {
  using namespace scalar;
  visit(
      Declaration{.id = "C-TOOL-POWER",
                  .title = "Cutting power against the spindle's",
                  .symbol = "P_c",
                  .unit = "W",
                  .source = "sandvik_milling, cutting power",
                  .requirement = "spindle_power_factor"},
      [](const auto& d) { return hardest_cut(d.data->motion) != nullptr ? Applies::yes : Applies::no; },
      [](const auto& d) {
        using T = std::remove_cvref_t<decltype(d.cycle.peak_speed)>;
        return cutting_power<T>(*hardest_cut(d.data->motion));
      },
      [](const auto& d) {
        using T = std::remove_cvref_t<decltype(d.cycle.peak_speed)>;
        return d.require(Requirement::spindle_power_factor) *
               in_unit<T>(hardest_cut(d.data->motion)->spindle_power, dimension::power_output);
      });
}

}  // namespace millwright::machine
