// SPDX-License-Identifier: Apache-2.0
//
// What an axis may be wrong by, contribution by contribution: systematic errors add up, random ones by root of sum of
// squares (C-ACC-TOTAL, C-ROT-TOTAL, C-TOOL-ERROR). Each drive has its `error_budget(drive, force)`.
//
// Not counted: straightness and angular errors of the guides, whose figures no catalogue here states; thermal growth of
// racks and belts, which lie on the frame or have a tension of their own; what the drive stretches under the weight,
// which does not change along the travel (its wind-up and the motor's lag under it do count, on the safe side).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "machine/axis_motion.h"
#include "machine/requirement.h"
#include "mechanics/accuracy.h"

namespace millwright::machine {

/// Whether the error counts with the tool pressed, or without, where tool_chain.h adds what a force does.
enum class UnderForce { no, yes };

template <class T>
class ErrorBudget {
 public:
  static constexpr std::size_t room = 6;

  /// `what` is a literal; `error` in m or rad, not negative.
  void add_systematic(std::string_view what, const T& error) {
    systematic_names_.at(systematic_count_) = what;
    systematic_[systematic_count_++] = error;
  }
  void add_random(std::string_view what, const T& error) {
    random_names_.at(random_count_) = what;
    random_[random_count_++] = error;
  }
  [[nodiscard]] T total() const {
    return mechanics::accuracy::mixed_error(std::span<const T>(systematic_).first(systematic_count_),
                                            std::span<const T>(random_).first(random_count_));
  }
  /// take(what, error) for each contribution.
  template <class Take>
  void visit(Take&& take) const {
    for (std::size_t i = 0; i < systematic_count_; ++i) take(systematic_names_[i], systematic_[i]);
    for (std::size_t i = 0; i < random_count_; ++i) take(random_names_[i], random_[i]);
  }

 private:
  std::array<T, room> systematic_{};
  std::array<T, room> random_{};
  std::array<std::string_view, room> systematic_names_, random_names_;
  std::size_t systematic_count_ = 0, random_count_ = 0;
};

/// Whether some move works against a process force.
inline bool has_process_force(const MotionData& motion) {
  for (const Move& move : motion.moves)
    if (move.force != 0.0 || (move.profile && move.profile->largest_force != 0.0)) return true;
  return false;
}

/// Travel over which a position error is stated [m]: that of the requirement, else the whole stroke.
inline double accuracy_travel(const Requirements& require, double stroke) {
  return require.known(Requirement::position_error_over) ? require(Requirement::position_error_over) : stroke;
}

/// Travel for which catalogues state errors of lead or pitch [m].
inline constexpr double rated_travel = 0.3;

/// Length of screw, rack or belt whose error of lead or pitch counts [m]: the stated travel, at least 300 mm where
/// `at_least_rated`, because a short piece may be off by as much. Where the controller maps the error, what is left of
/// that of 300 mm, and no more than there was.
inline double counted_travel(const Requirements& require, double stroke, bool at_least_rated) {
  const double over = accuracy_travel(require, stroke);
  const double made = at_least_rated && over < rated_travel ? rated_travel : over;
  if (!require.known(Requirement::mapped_lead_error)) return made;
  const double left = require(Requirement::mapped_lead_error) * rated_travel;
  return left < made ? left : made;
}

}  // namespace millwright::machine
