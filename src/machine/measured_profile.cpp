// SPDX-License-Identifier: Apache-2.0
#include "machine/measured_profile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace millwright::machine {

namespace {

/// Of the largest speed: less is none.
constexpr double speed_rounding = 1e-9;

struct Sample {
  double time = 0.0, speed = 0.0, force = 0.0;
};

class ProfileBuilder {
 public:
  /// An interval in which the speed keeps its sign.
  void add(const Sample& from, const Sample& to) {
    const double duration = to.time - from.time;
    if (!(duration > 0.0)) return;
    if (from.speed == 0.0 && to.speed == 0.0) {
      standing_force = std::max({standing_force, std::abs(from.force), std::abs(to.force)});
      return;
    }
    const double v0 = std::abs(from.speed), v1 = std::abs(to.speed);
    ProfilePhase phase;
    phase.begin = from.time;
    phase.acceleration = (v1 - v0) / duration;
    phase.speed = std::max(v0, v1);
    phase.mean_speed = 0.5 * (v0 + v1);
    phase.duration = duration;
    phase.force = from.force;
    phase.backwards = from.speed + to.speed < 0.0;
    if (from.force == to.force) return push(phase);
    // A convex function of the force is at most the straight line between its two ends; that line times the speed over
    // the interval gives the ends these weights.
    phase.duration = 0.5 * duration;
    phase.mean_speed = (2.0 * v0 + v1) / 3.0;
    push(phase);
    phase.begin = from.time + phase.duration;
    phase.force = to.force;
    phase.mean_speed = (v0 + 2.0 * v1) / 3.0;
    push(phase);
  }

  std::vector<ProfilePhase> phases;
  double standing_force = 0.0;

 private:
  /// Joins what goes on alike: a ramp or a constant speed that was sampled many times.
  void push(const ProfilePhase& next) {
    if (!phases.empty()) {
      ProfilePhase& last = phases.back();
      // Alike: over the next stretch the difference changes the speed by no more than 1e-9 of itself.
      const double alike = 1e-9 * std::max(last.speed, next.speed) / next.duration;
      const bool follows = std::abs(last.begin + last.duration - next.begin) <= 1e-9 * next.duration;
      if (follows && last.backwards == next.backwards && last.force == next.force &&
          std::abs(last.acceleration - next.acceleration) <= alike) {
        const double travel = last.mean_speed * last.duration + next.mean_speed * next.duration;
        const double gain = last.acceleration * last.duration + next.acceleration * next.duration;
        last.duration += next.duration;
        last.acceleration = gain / last.duration;
        last.mean_speed = travel / last.duration;
        last.speed = std::max(last.speed, next.speed);
        return;
      }
    }
    phases.push_back(next);
  }
};

/// The two neighbours of a value on a grid, with their weights.
struct Neighbours {
  long below = 0;
  double share_above = 0.0;
};
Neighbours on_grid(double value, double step) {
  if (step == 0.0) return {};
  const double place = value / step;
  const double below = std::floor(place);
  return {static_cast<long>(below), place - below};
}

std::vector<ProfilePhase> gathered(const std::vector<ProfilePhase>& phases) {
  double acceleration = 0.0, force = 0.0;
  for (const ProfilePhase& phase : phases) {
    acceleration = std::max(acceleration, std::abs(phase.acceleration));
    force = std::max(force, std::abs(phase.force));
  }
  const double acceleration_step = acceleration / 8.0, force_step = force / 4.0;
  std::map<std::tuple<bool, long, long>, ProfilePhase> nodes;
  for (const ProfilePhase& phase : phases) {
    const Neighbours a = on_grid(phase.acceleration, acceleration_step);
    const Neighbours f = on_grid(phase.force, force_step);
    for (const long up : {0L, 1L})
      for (const long over : {0L, 1L}) {
        const double weight =
            (up == 1 ? a.share_above : 1.0 - a.share_above) * (over == 1 ? f.share_above : 1.0 - f.share_above);
        if (weight == 0.0) continue;
        const auto [found, added] = nodes.try_emplace({phase.backwards, a.below + up, f.below + over});
        ProfilePhase& node = found->second;
        if (added) {
          node.begin = phase.begin;
          node.backwards = phase.backwards;
          node.acceleration = static_cast<double>(a.below + up) * acceleration_step;
          node.force = static_cast<double>(f.below + over) * force_step;
        }
        node.speed = std::max(node.speed, phase.speed);
        node.duration += weight * phase.duration;
        node.mean_speed += weight * phase.duration * phase.mean_speed;  // the travel, until all is added up
      }
  }
  std::vector<ProfilePhase> result;
  for (auto& [place, node] : nodes) {
    node.mean_speed /= node.duration;
    result.push_back(node);
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
  return result;
}

std::vector<std::size_t> hardest_of(const std::vector<ProfilePhase>& phases) {
  const auto exceeds = [&](std::size_t i, std::size_t k) {
    const ProfilePhase &a = phases[i], &b = phases[k];
    if (a.speed < b.speed || a.acceleration < b.acceleration || a.force < b.force) return false;
    return a.speed > b.speed || a.acceleration > b.acceleration || a.force > b.force || i < k;
  };
  std::vector<std::size_t> hardest;
  for (std::size_t k = 0; k < phases.size(); ++k) {
    bool least = false;
    for (std::size_t i = 0; i < phases.size() && !least; ++i) least = i != k && exceeds(i, k);
    if (!least) hardest.push_back(k);
  }
  return hardest;
}

/// Whether the phases `others` keep a phase from governing: one in which the force is at least as large where its own
/// opposes the motion, and one, not down, for where it pulls and for what brakes, in which mass and weight oppose the
/// motion by as much as they can help it here. (See Phase::may_govern: what runs back takes less torque than what is
/// driven, and available torque never rises with speed.)
bool is_covered(const ProfilePhase& phase, const std::vector<const ProfilePhase*>& others) {
  const auto opposes = [&](const ProfilePhase* other) {
    return other != &phase && (phase.backwards || !other->backwards) && other->speed >= phase.speed &&
           other->acceleration >= phase.acceleration && other->force >= phase.force;
  };
  const auto outweighs = [&](const ProfilePhase* other) {
    return other != &phase && !other->backwards && other->speed >= phase.speed &&
           other->acceleration >= std::abs(phase.acceleration) && other->force >= std::max(-phase.force, 0.0);
  };
  return std::ranges::any_of(others, opposes) && std::ranges::any_of(others, outweighs);
}

/// One by one, so that what stands for a phase is never one that it stands for.
void leave_out_covered(std::vector<ProfilePhase>& phases) {
  std::vector<const ProfilePhase*> left;
  for (const ProfilePhase& phase : phases) left.push_back(&phase);
  for (ProfilePhase& phase : phases) {
    phase.may_govern = !is_covered(phase, left);
    if (!phase.may_govern) std::erase(left, &phase);
  }
}

}  // namespace

void MeasuredProfile::scale_forces(double share) {
  for (ProfilePhase& phase : phases) phase.force *= share;
  largest_force *= share;
  standing_force *= share;
}

std::vector<double> speeds_of_positions(std::span<const double> times, std::span<const double> positions) {
  const std::size_t count = times.size();
  std::vector<double> speeds(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t middle = std::clamp<std::size_t>(i, 1, count - 2);
    const double before = times[middle] - times[middle - 1], after = times[middle + 1] - times[middle];
    const double slope_before = (positions[middle] - positions[middle - 1]) / before;
    const double slope_after = (positions[middle + 1] - positions[middle]) / after;
    const double curvature = (slope_after - slope_before) / (before + after);  // half the acceleration
    // Of the parabola through the three, at its own sample.
    const double at_middle = slope_before + curvature * before;
    speeds[i] = at_middle + 2.0 * curvature * (times[i] - times[middle]);
  }
  return speeds;
}

MeasuredProfile measured_profile(std::span<const double> times,
                                 std::span<const double> speeds,
                                 std::span<const double> forces) {
  MeasuredProfile profile;
  ProfileBuilder builder;
  double position = 0.0, lowest = 0.0, highest = 0.0;
  const auto travel = [&](const Sample& from, const Sample& to) {
    builder.add(from, to);
    position += 0.5 * (from.speed + to.speed) * (to.time - from.time);
    profile.travelled += 0.5 * std::abs(from.speed + to.speed) * (to.time - from.time);
    lowest = std::min(lowest, position);
    highest = std::max(highest, position);
  };
  // What differences of positions leave of a standstill is rounding, and no motion of 1e-14 s the other way.
  double fastest = 0.0;
  for (const double speed : speeds) fastest = std::max(fastest, std::abs(speed));
  const auto sample = [&](std::size_t i) -> Sample {
    const bool stands = std::abs(speeds[i]) <= speed_rounding * fastest;
    return {times[i], stands ? 0.0 : speeds[i], forces.empty() ? 0.0 : forces[i]};
  };
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Sample now = sample(i);
    profile.peak_speed = std::max(profile.peak_speed, std::abs(now.speed));
    profile.largest_force = std::max(profile.largest_force, std::abs(now.force));
    if (i == 0) continue;
    const Sample last = sample(i - 1);
    if (last.speed * now.speed < 0.0) {
      const double share = last.speed / (last.speed - now.speed);
      const Sample turn{last.time + share * (now.time - last.time), 0.0, last.force + share * (now.force - last.force)};
      travel(last, turn);
      travel(turn, now);
    } else {
      travel(last, now);
    }
  }
  profile.time = times.back() - times.front();
  profile.extent = highest - lowest;
  profile.standing_force = builder.standing_force;
  profile.phases = std::move(builder.phases);
  if (profile.phases.size() > exact_phases) profile.phases = gathered(profile.phases);
  profile.hardest = hardest_of(profile.phases);
  leave_out_covered(profile.phases);
  return profile;
}

}  // namespace millwright::machine
