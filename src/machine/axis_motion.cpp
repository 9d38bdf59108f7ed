// SPDX-License-Identifier: Apache-2.0
#include "machine/axis_motion.h"

#include <fmt/format.h>

#include <algorithm>

namespace millwright::machine {

std::vector<std::string> phase_names(const MotionData& data) {
  std::vector<std::string> names;
  const bool gravity = std::sin(data.inclination) > 1e-9;
  for (std::size_t i = 0; i < data.moves.size(); ++i) {
    const std::string move = data.moves[i].name.empty() ? fmt::format("move {}", i + 1) : data.moves[i].name;
    for (int direction = 0; direction < (gravity ? 2 : 1); ++direction)
      for (const char* part : {"accelerate", "cruise", "brake"})
        names.push_back(gravity ? fmt::format("{} {}, {}", move, direction == 0 ? "up" : "down", part)
                                : fmt::format("{}, {}", move, part));
  }
  return names;
}

std::vector<SupplyDemand> supply_demands(const MotionData& data) {
  std::vector<SupplyDemand> demands;
  for (const Move& move : data.moves) {
    const double shortest = move.acceleration_time.value_or(data.acceleration_time.lower);
    const double longest = move.acceleration_time.value_or(data.acceleration_time.upper);
    // A ramp longer than half the time of the move is refused by C-SYS-TIME anyway.
    const double speed = move.speed ? *move.speed : move.distance / (*move.time - std::min(longest, 0.5 * *move.time));
    demands.push_back({speed, speed / shortest, move.force});
  }
  return demands;
}

}  // namespace millwright::machine
