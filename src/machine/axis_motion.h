// SPDX-License-Identifier: Apache-2.0
//
// The duty cycle of an axis as a list of phases: every move is split into accelerate, cruise and brake, and, where
// gravity acts along the travel, done once against it (up) and once with it (down); the other axes of a coordinated
// move that climbs go there and back with it. A force is positive when it opposes the motion. The cycle of a rotary
// axis is the same, of angles, torques and its inertia.
//
// The parts of a ramp: ramp.h. A measured profile is its phases (measured_profile.h), run once as it was recorded.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "machine/constraint.h"
#include "machine/largest.h"
#include "machine/problem.h"
#include "machine/ramp.h"
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
  T loss_share{};    ///< of `speed`: the mean of the speed's square over its mean
  /// Whether force and torque can be the largest of their move here. While no counterbalance pulls, that is so in the
  /// first ramp against gravity alone: force m(a + g sin) + friction + process is the largest |F| of the move, the
  /// motor both lifts and accelerates, and a load that runs back gives |T| = |F| l/(2 pi) * |reverse efficiency| < |F|
  /// l/(2 pi eta). The other phases need not be bounded. Nor need those of a measured profile that others cover
  /// (measured_profile.h).
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

/// The largest acceleration at which moves may be driven [m/s^2]: that of the shortest ramp which the axis may take.
double largest_acceleration(const MotionData& data);

/// What of it is upwards [m/s^2]; 0 where no gravity acts along the travel. It goes up while a ramp lifts the load, and
/// while one stops its way down.
double climbing_acceleration(const MotionData& data);

/// What a mass that its axis moves pulls down with [N]: its weight and what it takes to speed it up on its way.
template <class T>
T pull_of_mass(const T& mass, double climbing_acceleration) {
  using namespace scalar;
  const T gravity = in_unit<T>(standard_gravity, dimension::acceleration);
  if (climbing_acceleration <= 0.0) return mass * gravity;
  return mass * (gravity + named("a_u", in_unit<T>(climbing_acceleration, dimension::acceleration)));
}

/// "moves[0] up, accelerate": names of the phases in the order of `phases`.
std::vector<std::string> phase_names(const MotionData& data);

/// Positions of two phases that are each other's mirror image, the same acceleration up and down for the same time at
/// the same mean speed, and of the constant speed between them. Bounds of loads know how the two make up for each other
/// (ball_screw_cycle.h).
struct MirroredPhases {
  std::size_t accelerate = 0, cruise = 0, brake = 0;
};

/// What the drive takes most for in one move: the end of its ramp, at the full speed and the peak acceleration. Of a
/// measured profile the hardest of its phases.
template <class T>
struct PowerDemand {
  T speed{};         ///< m/s
  T acceleration{};  ///< m/s^2, not negative
  T force{};         ///< N, of the process
  /// m^2/s^3, acceleration times speed; filled in for intervals only, of which the product says less.
  T acceleration_times_speed{};
};

template <class T>
struct Cycle {
  std::vector<Phase<T>> phases;
  std::vector<PowerDemand<T>> demands;
  std::vector<MirroredPhases> mirrored;  ///< where T encloses: numbers need none
  T peak_speed{};                        ///< m/s, over all moves
  T total_time{};                        ///< s, moves and dwells
  T travelled{};                         ///< m in one cycle
  T time_ratio{};                        ///< worst of needed over allowed time
  T gravity_force{};                     ///< N along the travel, positive downwards pull
  T weight{};                            ///< N, its size: a counterbalance that outweighs the load pulls upwards
  T friction_force{};                    ///< N
  T process_force{};                     ///< N, the largest
  double standing_time = 0.0;            ///< s, of total_time
  double standing_force = 0.0;           ///< N, the process's largest while the axis stands, of measured profiles
};

/// Room for so many elements in each of the vectors: growing step by step was a tenth of an evaluation.
template <class... Vectors>
void make_room(std::size_t count, Vectors&... vectors) {
  (vectors.reserve(count), ...);
}

/// Whether the weight pulls along the travel.
inline bool has_gravity_along(const MotionData& data) {
  return data.inclination != 0.0 && std::sin(data.inclination) > 1e-9;
}

/// Times that a move is done in a cycle: up and down where gravity acts, there and back if it returns.
inline int runs(const MotionData& data, const Move& move) {
  return !move.profile && (move.returns || has_gravity_along(data)) ? 2 : 1;
}

/// How many phases the cycle has.
inline std::size_t phase_count(const MotionData& data) {
  std::size_t count = 0;
  for (const Move& move : data.moves)
    count +=
        move.profile ? move.profile->phases.size() : static_cast<std::size_t>(runs(data, move)) * (move.jerk ? 7 : 3);
  return count;
}

namespace detail {
/// Adds moves to a cycle whose forces of gravity and friction are known.
template <class T>
class CycleBuilder {
 public:
  CycleBuilder(const MotionData& data, const T& mass, Cycle<T>& cycle)
      : data_(data), mass_(mass), of_(motion_dimensions(data.rotary)), cycle_(cycle) {
    // While no counterbalance pulls, see Phase::may_govern.
    every_ = data.counterbalance_force > 0.0;
  }

  void add(const Move& move, const T& ramp) {
    using namespace scalar;
    const T distance = si<T>(move.distance, of_.distance);
    const T force = si<T>(move.force, of_.force);
    // With equal ramps the distance is speed * (time - ramp), jerk-limited or not.
    const T speed = named("v",
                          move.speed ? si<T>(*move.speed, of_.speed)
                                     : distance / larger(si<T>(*move.time, dimension::time) - ramp,
                                                         si<T>(1e-3 * *move.time, dimension::time)));
    const T constant_time = named("t_v", larger(distance / speed - ramp, si<T>(0.0, dimension::time)));
    // The profile exists while the ramps leave no negative cruise; a time limit on a given speed counts as well.
    if (move.speed) cycle_.time_ratio = larger(cycle_.time_ratio, ramp * speed / distance);
    if (move.time) {
      const T allowed = si<T>(*move.time, dimension::time);
      cycle_.time_ratio =
          larger(cycle_.time_ratio, move.speed ? (distance / speed + ramp) / allowed : 2.0 * ramp / allowed);
    }
    const T jerk = si<T>(move.jerk.value_or(1.0), of_.acceleration / dimension::time);
    if (move.jerk) cycle_.time_ratio = larger(cycle_.time_ratio, 2.0 * sqrt(speed / jerk) / ramp);
    RampParts<T> ramp_up = ramp_parts(speed, ramp, move.jerk ? &jerk : nullptr);
    const std::span<const RampPart<T>> parts = ramp_up.all();
    PowerDemand<T> demand{speed, parts.front().acceleration, force};
    if constexpr (std::is_same_v<T, scalar::Interval>) {
      demand.acceleration_times_speed = speed * demand.acceleration;
      if (!move.speed && !move.jerk && ramp.upper <= 0.5 * *move.time) narrow(move, ramp, demand);
      ramp_up.places.front().acceleration = demand.acceleration;
    }
    cycle_.peak_speed = larger(cycle_.peak_speed, speed);
    cycle_.process_force = larger(cycle_.process_force, absolute(force));
    cycle_.demands.push_back(demand);
    for (int direction = 0; direction < runs(data_, move); ++direction) {
      const T weight = direction == 0 ? cycle_.gravity_force : -cycle_.gravity_force;
      const std::size_t first = cycle_.phases.size();
      for (const RampPart<T>& part : parts)
        add_phase(part.acceleration,
                  weight,
                  force,
                  {speed, 0.5 * speed, part.duration, ramp_up.loss_share},
                  part.peak && (every_ || direction == 0));
      add_phase(si<T>(0.0, of_.acceleration), weight, force, {speed, speed, constant_time, T(1.0)}, every_);
      for (const RampPart<T>& part : parts)
        add_phase(-part.acceleration,
                  weight,
                  force,
                  {speed, 0.5 * speed, part.duration, ramp_up.loss_share},
                  part.peak && every_);
      const std::size_t cruise = first + parts.size();
      if constexpr (scalar::Enclosing<T>)
        for (std::size_t i = 0; i < parts.size(); ++i) cycle_.mirrored.push_back({first + i, cruise, cruise + 1 + i});
      cycle_.total_time = cycle_.total_time + (2.0 * ramp + constant_time) + si<T>(move.dwell, dimension::time);
      cycle_.travelled = cycle_.travelled + distance;
      cycle_.standing_time += move.dwell;
    }
  }

  void add_profile(const Move& move) {
    using namespace scalar;
    const MeasuredProfile& profile = *move.profile;
    double moving = 0.0;
    for (const ProfilePhase& phase : profile.phases) {
      moving += phase.duration;
      const T weight = phase.backwards ? -cycle_.gravity_force : cycle_.gravity_force;
      add_phase(si<T>(phase.acceleration, of_.acceleration),
                weight,
                si<T>(phase.force, of_.force),
                {si<T>(phase.speed, of_.speed),
                 si<T>(phase.mean_speed, of_.speed),
                 si<T>(phase.duration, dimension::time),
                 T(loss_share(phase))},
                every_ || phase.may_govern);
    }
    for (const std::size_t i : profile.hardest) {
      const ProfilePhase& phase = profile.phases[i];
      cycle_.demands.push_back({si<T>(phase.speed, of_.speed),
                                si<T>(std::max(phase.acceleration, 0.0), of_.acceleration),
                                si<T>(phase.force, of_.force)});
      if constexpr (std::is_same_v<T, scalar::Interval>)
        cycle_.demands.back().acceleration_times_speed =
            cycle_.demands.back().acceleration * cycle_.demands.back().speed;
    }
    cycle_.peak_speed = larger(cycle_.peak_speed, si<T>(profile.peak_speed, of_.speed));
    cycle_.process_force = larger(cycle_.process_force, si<T>(profile.largest_force, of_.force));
    cycle_.standing_force = std::max(cycle_.standing_force, profile.standing_force);
    cycle_.total_time = cycle_.total_time + si<T>(profile.time + move.dwell, dimension::time);
    cycle_.standing_time += std::max(profile.time - moving, 0.0) + move.dwell;
    cycle_.travelled = cycle_.travelled + si<T>(profile.travelled, of_.distance);
  }

 private:
  /// Speed rises and acceleration falls with the ramp t of a move of d in T, so that intervals of them know less than
  /// a = d/(t (T - t)), which falls up to T/2, and a v = d^2/(t (T - t)^2), which falls up to T/3 and then rises.
  static void narrow(const Move& move, const T& ramp, PowerDemand<T>& demand) {
    const auto speed = [&](const T& time) { return T(move.distance) / (T(*move.time) - time); };
    const auto take = [](const T& known, T& of) { of = intersect(of, known).value_or(of); };
    take(over_ramps(ramp, *move.time, [&](const T& time) { return speed(time) / time; }), demand.acceleration);
    take(over_ramps(ramp, *move.time / 3.0, [&](const T& time) { return speed(time) * (speed(time) / time); }),
         demand.acceleration_times_speed);
  }

  struct Pace {
    T speed, mean_speed, duration, loss_share;
  };
  void add_phase(const T& acceleration, const T& weight, const T& force, const Pace& pace, bool may_govern) {
    const T along = scalar::named(
        "F_x", mechanics::actuation::axial_force(mass_, acceleration, weight, cycle_.friction_force, T(1.0), force));
    cycle_.phases.push_back(
        {along, acceleration, pace.speed, pace.mean_speed, pace.duration, pace.loss_share, may_govern});
  }

  const MotionData& data_;
  const T& mass_;
  MotionDimensions of_;
  bool every_ = false;
  Cycle<T>& cycle_;
};
}  // namespace detail

/// The duty cycle for a moved mass [kg], of a rotary axis an inertia [kg.m2], and a ramp time [s].
template <class T>
Cycle<T> duty_cycle(const MotionData& data, const T& mass, const T& acceleration_time) {
  using namespace scalar;
  using detail::si;
  const MotionDimensions of = motion_dimensions(data.rotary);
  Cycle<T> cycle;
  const T zero_force = si<T>(0.0, of.force);
  const T inclination = T(data.inclination);
  const bool gravity = has_gravity_along(data);
  cycle.gravity_force =
      gravity
          ? named("F_g",
                  mechanics::actuation::gravity_force(mass, inclination, si<T>(data.counterbalance_force, of.force)))
          : zero_force;
  cycle.weight = data.counterbalance_force > 0.0 ? absolute(cycle.gravity_force) : cycle.gravity_force;
  // Normal to the travel only the component of the weight across it presses on the guides.
  const double across = std::abs(std::cos(data.inclination)) < 1e-9 ? 0.0 : std::cos(data.inclination);
  cycle.friction_force = si<T>(data.guide_drag, of.force);
  if (data.guide_friction * across != 0.0)
    cycle.friction_force = named(
        "F_f",
        cycle.friction_force + data.guide_friction * across * mass * si<T>(standard_gravity, dimension::acceleration));
  cycle.process_force = zero_force;
  cycle.total_time = si<T>(0.0, dimension::time);
  cycle.travelled = si<T>(0.0, of.distance);
  cycle.peak_speed = si<T>(0.0, of.speed);
  cycle.time_ratio = T(0.0);
  make_room(phase_count(data), cycle.phases);
  if constexpr (Enclosing<T>) make_room(phase_count(data), cycle.mirrored);
  make_room(data.moves.size(), cycle.demands);
  detail::CycleBuilder<T> builder(data, mass, cycle);
  for (const Move& move : data.moves) {
    if (move.profile)
      builder.add_profile(move);
    else
      builder.add(move, move.acceleration_time ? si<T>(*move.acceleration_time, dimension::time) : acceleration_time);
  }
  return cycle;
}

/// What an axis that stands bears of its process, its weight and what rubs: all that is between tool and motor has to
/// bear it. The motor has to hold it (process_force has it, too), but does not turn against it.
template <class T>
T standing_load(const Cycle<T>& cycle, const scalar::Dimension& force) {
  return scalar::named("F_st", cycle.weight + cycle.friction_force + scalar::in_unit<T>(cycle.standing_force, force));
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

}  // namespace millwright::machine
