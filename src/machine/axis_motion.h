// SPDX-License-Identifier: Apache-2.0
//
// The duty cycle of an axis as a list of phases: every move is split into accelerate, cruise and brake, and, where
// gravity acts along the travel, done once against it (up) and once with it (down). A force is positive when it opposes
// the motion. The cycle of a rotary axis is the same, of angles, torques and its inertia.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "machine/constraint.h"
#include "machine/problem.h"
#include "mechanics/actuation.h"
#include "scalar/scalars.h"

namespace millwright::machine {

template <class T>
struct Phase {
  T force{};         ///< N along the motion, positive opposing it
  T acceleration{};  ///< m/s^2, negative while braking
  T speed{};         ///< m/s, the largest in this phase
  T mean_speed{};    ///< m/s
  T duration{};      ///< s
  /// Whether force and torque can be the largest of their move here. While no counterbalance pulls, that is so in the
  /// first ramp against gravity alone: force m(a + g sin) + friction + process is the largest |F| of the move, the
  /// motor both lifts and accelerates, and a load that runs back gives |T| = |F| l/(2 pi) * |reverse efficiency| < |F|
  /// l/(2 pi eta). The other phases need not be bounded.
  bool may_govern = true;
};

/// The numbers of an axis that do not depend on what is chosen; T only so that every scalar gets constants of its kind.
struct MotionData {
  std::vector<Move> moves;
  double inclination = 0.0;
  double guide_friction = 0.0;
  double guide_drag = 0.0;
  double counterbalance_force = 0.0;
  Range acceleration_time{0.05, 0.5};
  bool rotary = false;  ///< distances are angles, forces torques and the mass is an inertia
};

/// What the numbers of an axis measure: of a rotary axis rad, rad/s, N.m where others have m, m/s, N.
struct MotionDimensions {
  scalar::Dimension distance, speed, acceleration, force;
};
inline constexpr MotionDimensions motion_dimensions(bool rotary) {
  namespace dimension = scalar::dimension;
  if (rotary) return {dimension::angular, dimension::angular_speed, dimension::angular_acceleration, dimension::torque};
  return {dimension::length, dimension::speed, dimension::acceleration, dimension::force};
}

/// What the supply must be ready for in one move, whichever ramp of the range is chosen: the speed of the longest ramp
/// and the acceleration that the shortest ramp gives it. The power a drive asks for then does not hang on the ramp.
struct SupplyDemand {
  double speed = 0.0;         ///< m/s
  double acceleration = 0.0;  ///< m/s^2
  double force = 0.0;         ///< N, of the process
};
std::vector<SupplyDemand> supply_demands(const MotionData& data);

/// "moves[0] up, accelerate": names of the phases in the order of `phases`.
std::vector<std::string> phase_names(const MotionData& data);

template <class T>
struct Cycle {
  std::vector<Phase<T>> phases;
  T peak_speed{};      ///< m/s, over all moves
  T total_time{};      ///< s, moves and dwells
  T travelled{};       ///< m in one cycle
  T time_ratio{};      ///< worst of needed over allowed time
  T gravity_force{};   ///< N along the travel, positive downwards pull
  T friction_force{};  ///< N
  T process_force{};   ///< N, the largest
};

namespace detail {
template <class T>
T si(double value, const scalar::Dimension& dimension) {
  return scalar::in_unit<T>(value, dimension);
}
}  // namespace detail

/// The duty cycle for a moved mass [kg], of a rotary axis an inertia [kg.m2], and a ramp time [s].
template <class T>
Cycle<T> duty_cycle(const MotionData& data, const T& mass, const T& acceleration_time) {
  using namespace scalar;
  using detail::si;
  namespace act = mechanics::actuation;
  const MotionDimensions of = motion_dimensions(data.rotary);
  Cycle<T> cycle;
  const T zero_force = si<T>(0.0, of.force);
  const T inclination = T(data.inclination);
  const bool gravity = std::sin(data.inclination) > 1e-9;
  cycle.gravity_force =
      gravity ? act::gravity_force(mass, inclination, si<T>(data.counterbalance_force, of.force)) : zero_force;
  // Normal to the travel only the component of the weight across it presses on the guides.
  const double across = std::abs(std::cos(data.inclination)) < 1e-9 ? 0.0 : std::cos(data.inclination);
  cycle.friction_force = si<T>(data.guide_drag, of.force);
  if (data.guide_friction * across != 0.0)
    cycle.friction_force =
        cycle.friction_force + data.guide_friction * across * mass * si<T>(standard_gravity, dimension::acceleration);
  cycle.process_force = zero_force;
  cycle.total_time = si<T>(0.0, dimension::time);
  cycle.travelled = si<T>(0.0, of.distance);
  cycle.peak_speed = si<T>(0.0, of.speed);
  cycle.time_ratio = T(0.0);
  for (const Move& move : data.moves) {
    const T ramp = move.acceleration_time ? si<T>(*move.acceleration_time, dimension::time) : acceleration_time;
    const T distance = si<T>(move.distance, of.distance);
    const T force = si<T>(move.force, of.force);
    // With equal ramps the distance is speed * (time - ramp).
    const T speed = move.speed ? si<T>(*move.speed, of.speed)
                               : distance / larger(si<T>(*move.time, dimension::time) - ramp,
                                                   si<T>(1e-3 * *move.time, dimension::time));
    const T constant_time = larger(distance / speed - ramp, si<T>(0.0, dimension::time));
    const T acceleration = speed / ramp;
    // The profile exists while the ramps leave no negative cruise; a time limit on a given speed counts as well.
    if (move.speed) cycle.time_ratio = larger(cycle.time_ratio, ramp * speed / distance);
    if (move.time) {
      const T allowed = si<T>(*move.time, dimension::time);
      cycle.time_ratio =
          larger(cycle.time_ratio, move.speed ? (distance / speed + ramp) / allowed : 2.0 * ramp / allowed);
    }
    cycle.peak_speed = larger(cycle.peak_speed, speed);
    cycle.process_force = larger(cycle.process_force, absolute(force));
    const int directions = gravity ? 2 : 1;
    for (int direction = 0; direction < directions; ++direction) {
      const T weight = direction == 0 ? cycle.gravity_force : -cycle.gravity_force;
      const T none = si<T>(0.0, of.acceleration);
      const T one = T(1.0);
      const bool every = data.counterbalance_force > 0.0;
      const auto add = [&](const T& a, const T& mean, const T& duration, bool may_govern) {
        const T along = act::axial_force(mass, a, weight, cycle.friction_force, one, force);
        cycle.phases.push_back({along, a, speed, mean, duration, may_govern});
      };
      add(acceleration, 0.5 * speed, ramp, every || direction == 0);
      add(none, speed, constant_time, every);
      add(-acceleration, 0.5 * speed, ramp, every);
      cycle.total_time = cycle.total_time + (2.0 * ramp + constant_time) + si<T>(move.dwell, dimension::time);
      cycle.travelled = cycle.travelled + distance;
    }
  }
  return cycle;
}

/// Whether a scalar is asked for one design, of which everything is wanted, and not for bounds or slopes in the search.
template <class T>
inline constexpr bool shows_everything =
    std::is_same_v<T, double> || std::is_same_v<T, scalar::Traced> || std::is_same_v<T, scalar::Dimensioned>;

/// The same, or soft constraints are enforced, which read what the search leaves out otherwise.
template <class T>
bool wants_everything(const Requirements& require) {
  return shows_everything<T> || require.enforces_any();
}

/// The largest of a list. Bounds and derivatives go through `larger`; a traced value keeps only the winner, so that a
/// calculation sheet shows the phase that governs and not a chain of comparisons.
template <class T>
T largest(const std::vector<T>& values) {
  using namespace scalar;
  T result = values.front();
  for (std::size_t i = 1; i < values.size(); ++i) {
    if constexpr (std::is_same_v<T, Traced>) {
      if (values[i].value > result.value) result = values[i];
    } else {
      result = larger(result, values[i]);
    }
  }
  return result;
}

/// The smallest of a list, as `largest`.
template <class T>
T smallest(const std::vector<T>& values) {
  std::vector<T> negative;
  for (const T& value : values) negative.push_back(-value);
  return -largest(negative);
}

}  // namespace millwright::machine
