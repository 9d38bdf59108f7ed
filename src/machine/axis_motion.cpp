// SPDX-License-Identifier: Apache-2.0
#include "machine/axis_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace millwright::machine {

namespace {

/// Parts of a ramp in the order of `detail::ramp_parts`.
std::vector<std::string> ramp_names(const char* ramp, const Move& move) {
  std::vector<std::string> names{ramp};
  if (move.jerk)
    for (const double share : rising_shares) names.push_back(fmt::format("{} at {:.0f} %", ramp, 100.0 * share));
  return names;
}

/// Acceleration at the peak of a ramp; of a jerk-limited one not shorter than its jerk allows.
double peak_acceleration(double speed, double ramp, const Move& move) {
  if (!move.jerk) return speed / ramp;
  const double least = 2.0 * std::sqrt(speed / *move.jerk);
  const double time = std::max(ramp, least);
  return 2.0 * speed / (time + std::sqrt(std::max(0.0, time * time - least * least)));
}

}  // namespace

std::vector<std::string> phase_names(const MotionData& data) {
  std::vector<std::string> names;
  const bool gravity = has_gravity_along(data);
  for (std::size_t i = 0; i < data.moves.size(); ++i) {
    const Move& move = data.moves[i];
    const std::string name = move.name.empty() ? fmt::format("move {}", i + 1) : move.name;
    if (move.profile) {
      for (const ProfilePhase& phase : move.profile->phases)
        names.push_back(fmt::format("{}, from {:.4g} s", name, phase.begin));
      continue;
    }
    std::vector<std::string> parts = ramp_names("accelerate", move);
    parts.emplace_back("cruise");
    for (std::string& part : ramp_names("brake", move)) parts.push_back(std::move(part));
    const bool twice = runs(data, move) == 2;
    const std::array<const char*, 2> ways = gravity ? std::array{"up", "down"} : std::array{"there", "back"};
    for (const char* way : std::span(ways).first(twice ? 2 : 1))
      for (const std::string& part : parts)
        names.push_back(twice ? fmt::format("{} {}, {}", name, way, part) : fmt::format("{}, {}", name, part));
  }
  return names;
}

double largest_acceleration(const MotionData& data) {
  double largest = 0.0;
  for (const Move& move : data.moves) {
    if (move.profile) {
      for (const std::size_t i : move.profile->hardest)
        largest = std::max(largest, move.profile->phases[i].acceleration);
      continue;
    }
    const double ramp = move.acceleration_time.value_or(data.acceleration_time.lower);
    // A ramp longer than half the time of the move is refused by C-SYS-TIME.
    const double speed = move.speed ? *move.speed : move.distance / (*move.time - std::min(ramp, 0.5 * *move.time));
    largest = std::max(largest, peak_acceleration(speed, ramp, move));
  }
  return largest;
}

double climbing_acceleration(const MotionData& data) {
  if (!has_gravity_along(data)) return 0.0;
  double largest = largest_acceleration(data);
  for (const Move& move : data.moves)
    if (move.profile)
      for (const ProfilePhase& phase : move.profile->phases)
        largest = std::max(largest, phase.backwards ? -phase.acceleration : phase.acceleration);
  return std::sin(data.inclination) * largest;
}

}  // namespace millwright::machine
