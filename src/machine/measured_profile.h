// SPDX-License-Identifier: Apache-2.0
//
// Motion of an axis as it was recorded: speeds, and maybe forces, at instants. Between two samples the speed changes
// evenly, so each interval is a phase of one acceleration; an interval in which the axis turns round is two, and one in
// which it stands is a dwell, of which the largest force is kept.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace millwright::machine {

/// Of a rotary axis rad and N.m stand for m and N.
struct ProfilePhase {
  double begin = 0.0;         ///< s, where it first occurs in the recording
  double acceleration = 0.0;  ///< m/s^2 along the motion, negative while braking
  double speed = 0.0;         ///< m/s, the largest
  double mean_speed = 0.0;    ///< m/s
  double duration = 0.0;      ///< s
  double force = 0.0;         ///< N, positive against the motion
  bool backwards = false;     ///< position falls; on an axis with gravity, down
  /// Whether force, torque or share of the available torque can be the largest of the recording here, while no
  /// counterbalance pulls: then others are as large whatever is moved.
  bool may_govern = true;
};

/// Mean of the square of a phase's speed over its mean, as a share of its largest; it goes there from 2 * mean -
/// largest evenly. 0 where the phase stands.
inline double loss_share(const ProfilePhase& phase) {
  if (phase.mean_speed <= 0.0) return 0.0;
  const double spread = phase.speed - phase.mean_speed;
  return (phase.mean_speed + spread * spread / (3.0 * phase.mean_speed)) / phase.speed;
}

struct MeasuredProfile {
  std::vector<ProfilePhase> phases;
  std::vector<std::size_t> hardest;  ///< phases that no other exceeds in speed, acceleration and force
  double time = 0.0;                 ///< s, standstill included
  double travelled = 0.0;            ///< m
  double extent = 0.0;               ///< m, between the two ends of the travel
  double peak_speed = 0.0;           ///< m/s
  double largest_force = 0.0;        ///< N, with or against the motion
  double standing_force = 0.0;       ///< N, either way, the largest while it stands

  void scale_forces(double share);  ///< `share` positive
};

/// Speeds at the samples of a recording of positions: the slope of the parabola through each sample and its two
/// neighbours. At least three samples, times ascending.
std::vector<double> speeds_of_positions(std::span<const double> times, std::span<const double> positions);

/// The phases of a recording; `forces` may be empty. Where the force differs between two samples, each of its two
/// values counts with half the interval, and with such a part of the travel that products of speed and convex functions
/// of the force (work, cubed load) are not underestimated.
///
/// A recording of more than `exact_phases` phases is gathered on a grid of accelerations (an eighth of the largest) and
/// forces (a quarter): each phase is shared out among the corners of its cell so that time, travel and the means of
/// acceleration and force stay what they are. Convex functions of them (peak force, RMS, cubed load) only grow.
MeasuredProfile measured_profile(std::span<const double> times,
                                 std::span<const double> speeds,
                                 std::span<const double> forces);

inline constexpr std::size_t exact_phases = 64;

}  // namespace millwright::machine
