// SPDX-License-Identifier: Apache-2.0
//
// Life of a ball screw over the duty cycle of its axis.
#pragma once

#include <span>
#include <vector>

#include "machine/screw_drive.h"
#include "mechanics/ball_screw_cycle.h"
#include "mechanics/power_screw.h"
#include "scalar/scalars.h"

namespace millwright::machine {

/// The forces of the cycle: the two ramps of a move together where the cycle is mirrored (ball_screw_cycle.h), as
/// `ramps(turned in one of them, steady force, inertia force)`, and every other phase as `phase(turned, force)`.
template <class T, class Ramps, class Single>
void visit_nut_forces(const ScrewDrive<T>& d, Ramps ramps, Single single) {
  const std::vector<Phase<T>>& phases = d.cycle.phases;
  const auto turned = [&](const Phase<T>& phase) {
    return T(mechanics::power_screw::angular_speed(phase.mean_speed, d.screw.lead) * phase.duration);
  };
  std::vector<bool> counted(phases.size(), false);
  for (const MirroredPhases& pair : d.cycle.mirrored) {
    const Phase<T>& up = phases[pair.accelerate];
    ramps(turned(up), phases[pair.cruise].force, T(d.moved_mass * up.acceleration));
    counted[pair.accelerate] = counted[pair.brake] = true;
  }
  for (std::size_t i = 0; i < phases.size(); ++i)
    if (!counted[i]) single(turned(phases[i]), phases[i].force);
}

/// Cubic mean over the cycle of the load of the raceway that governs [N].
template <class T>
T ball_screw_mean_load(const ScrewDrive<T>& d) {
  using namespace scalar;
  namespace bs = mechanics::ball_screw;
  if constexpr (Enclosing<T>) {
    T weighted = T(0.0), turns = T(0.0);
    visit_nut_forces(
        d,
        [&](const T& turned, const T& steady, const T& inertia) {
          weighted = weighted + turned * bs::cubed_ramp_loads(steady, inertia, d.screw.preload, d.data->preloaded);
          turns = turns + 2.0 * turned;
        },
        [&](const T& turned, const T& force) {
          weighted = weighted + turned * cube(bs::raceway_load(T(absolute(force)), d.screw.preload, d.data->preloaded));
          turns = turns + turned;
        });
    return cbrt(weighted / turns);
  } else {
    const std::vector<Phase<T>>& phases = d.cycle.phases;
    std::vector<T> forces, speeds, durations;
    make_room(phases.size(), forces, speeds, durations);
    for (std::size_t i = 0; i < phases.size(); ++i) {
      forces.push_back(bs::raceway_load(d.axial_forces[i], d.screw.preload, d.data->preloaded));
      speeds.push_back(mechanics::power_screw::angular_speed(phases[i].mean_speed, d.screw.lead));
      durations.push_back(phases[i].duration);
    }
    return bs::mean_load(std::span<const T>(forces), std::span<const T>(speeds), std::span<const T>(durations));
  }
}

/// Load of the raceway of a preloaded nut that the force takes from [N]. From lift-off on hardly anything is left; a
/// thousandth of the preload keeps roots and slopes defined.
template <class T>
T other_raceway_load(const T& force, const T& preload) {
  using namespace scalar;
  return larger(mechanics::ball_screw::unloaded_side_force(force, preload), T(1e-3 * preload));
}

/// The same of the other raceway of a preloaded nut [N], as if every force pressed the first one: of one sum of the
/// cubed loads of both, the more uneven share is the shorter life together.
template <class T>
T other_raceway_mean_load(const ScrewDrive<T>& d) {
  using namespace scalar;
  namespace bs = mechanics::ball_screw;
  std::vector<T> loads, speeds, durations;
  make_room(d.cycle.phases.size(), loads, speeds, durations);
  for (const Phase<T>& phase : d.cycle.phases) {
    loads.push_back(other_raceway_load(T(absolute(phase.force)), d.screw.preload));
    speeds.push_back(mechanics::power_screw::angular_speed(phase.mean_speed, d.screw.lead));
    durations.push_back(phase.duration);
  }
  return bs::mean_load(std::span<const T>(loads), std::span<const T>(speeds), std::span<const T>(durations));
}

namespace detail {
inline const scalar::Interval& range_of(const scalar::Interval& x) { return x; }
template <int N>
const scalar::Interval& range_of(const scalar::Dual<scalar::Interval, N>& x) {
  return x.value;
}

/// Bounds of the load [N] under which one raceway lives as long as both do under the cycle: the 3/10th power of
/// A^(10/9) + B^(10/9), of A the mean of the cubed loads F_1 of the loaded side, of B of F_2 = F_1 - F.
///
/// It rises with the size of every force: A >= B, and F_1^2 dF_1/dF >= F_2^2 |dF_2/dF|, as the slope of F_1 stays above
/// 1/2. The excess of the one over the other grows with the force, so that of the two ramps of a move, steady force b
/// and inertia force c, it rises with both (see ball_screw_cycle.h). It rises with the preload as well, as both loads
/// do. So its bounds are at the ends of these, which naive bounds of A and B would take from opposite ends.
template <class T>
scalar::Interval combined_load_range(const ScrewDrive<T>& d) {
  using namespace scalar;
  namespace bs = mechanics::ball_screw;
  const auto at = [&](double Interval::*end) {
    const auto end_of = [&](const Interval& x) { return Interval(x.*end); };
    const Interval preload = end_of(range_of(d.screw.preload));
    Interval loaded(0.0), other(0.0), turns(0.0);
    const auto add = [&](const Interval& weight, const Interval& force) {
      loaded = loaded + weight * cube(bs::loaded_side_force(absolute(force), preload));
      other = other + weight * cube(other_raceway_load(absolute(force), preload));
      turns = turns + weight;
    };
    visit_nut_forces(
        d,
        [&](const T& turned, const T& steady, const T& inertia) {
          const Interval b = end_of(absolute(range_of(steady))), c = end_of(range_of(inertia));
          add(range_of(turned), b + c);
          add(range_of(turned), b - c);
        },
        [&](const T& turned, const T& force) { add(range_of(turned), end_of(absolute(range_of(force)))); });
    return Interval(pow(pow(loaded / turns, 10.0 / 9.0) + pow(other / turns, 10.0 / 9.0), 0.3));
  };
  return {at(&Interval::lower).lower, at(&Interval::upper).upper};
}

inline scalar::Interval combined_load(const ScrewDrive<scalar::Interval>& d) { return combined_load_range(d); }

/// The same with its slopes: those of A^(10/9) + B^(10/9) are 10/9 B^(1/9) times those of k A + B, of k = (A/B)^(1/9).
template <int N>
scalar::Dual<scalar::Interval, N> combined_load(const ScrewDrive<scalar::Dual<scalar::Interval, N>>& d) {
  using namespace scalar;
  using T = Dual<Interval, N>;
  const Interval range = combined_load_range(d);
  const Interval loaded = cube(ball_screw_mean_load(d).value), other = cube(other_raceway_mean_load(d).value);
  const Interval weight = pow(loaded / other, 1.0 / 9.0);
  T weighted(0.0), turns(0.0);
  const auto add = [&](const T& turned, const T& steady, const T& inertia) {
    weighted = weighted + turned * mechanics::ball_screw::uneven_ramp_loads(steady, inertia, d.screw.preload, weight);
    turns = turns + 2.0 * turned;
  };
  // A phase by itself is half of two ramps without inertia.
  visit_nut_forces(d, add, [&](const T& turned, const T& force) { add(T(0.5 * turned), force, T(0.0)); });
  T load(range);
  const Interval factor = pow(other, 1.0 / 9.0) / (3.0 * pow(range, 7.0 / 3.0));
  const T mean = weighted / turns;
  for (std::size_t i = 0; i < load.slope.size(); ++i) load.slope[i] = mean.slope[i] * factor;
  return load;
}
}  // namespace detail

/// Life of the ball screw [s]: cubic mean load over the cycle, of a preloaded nut both raceways together, at the mean
/// speed of the cycle, dwells included.
template <class T>
T ball_screw_life(const ScrewDrive<T>& d) {
  using namespace scalar;
  namespace bs = mechanics::ball_screw;
  const auto life_under = [&](const T& mean_load) {
    return bs::life_revolutions(d.screw.dynamic_rating, mean_load, d.require(Requirement::fatigue_load_factor));
  };
  T revolutions;
  if (!d.data->preloaded) {
    revolutions = named("L", life_under(named("F_m", ball_screw_mean_load(d))));
  } else if constexpr (Enclosing<T>) {
    revolutions = life_under(detail::combined_load(d));
  } else {
    const T other = named("L_2", life_under(named("F_m2", other_raceway_mean_load(d))));
    revolutions =
        named("L_r", bs::combined_life(named("L_1", life_under(named("F_m", ball_screw_mean_load(d)))), other));
  }
  const T mean_speed = named("ω_m", d.cycle.travelled * 2.0 * pi<T>() / d.screw.lead / d.cycle.total_time);
  return bs::life_time(revolutions, mean_speed);
}

}  // namespace millwright::machine
