// SPDX-License-Identifier: Apache-2.0
// Jerk-limited ramps and measured profiles as phases of a duty cycle, against values of the handbook's kinematics, hand
// calculations and plain numerical integration.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.h"
#include "machine/axis_motion.h"
#include "mechanics/actuation.h"

namespace motion_cycle_test {

using namespace millwright;
using machine::Cycle;
using machine::MeasuredProfile;
using machine::MotionData;
using machine::Move;

namespace {

template <class T = double>
Cycle<T> cycle_of(const Move& move, double mass, double drag = 0.0, double inclination = 0.0) {
  MotionData data;
  data.moves = {move};
  data.inclination = inclination;
  data.guide_drag = drag;
  return machine::duty_cycle(data, T(mass), T(0.1));
}

Move jerk_limited(double distance, double speed, double ramp, double jerk) {
  Move move;
  move.distance = distance;
  move.speed = speed;
  move.acceleration_time = ramp;
  move.jerk = jerk;
  return move;
}

Move measured(const std::vector<double>& times,
              const std::vector<double>& speeds,
              const std::vector<double>& forces = {}) {
  Move move;
  move.profile = machine::measured_profile(times, speeds, forces);
  return move;
}

template <class Value>
double sum(const Cycle<double>& cycle, Value value) {
  double total = 0.0;
  for (const auto& phase : cycle.phases) total += value(phase);
  return total;
}
double time_of(const Cycle<double>& cycle) {
  return sum(cycle, [](const auto& p) { return p.duration; });
}
double travel_of(const Cycle<double>& cycle) {
  return sum(cycle, [](const auto& p) { return p.mean_speed * p.duration; });
}
double rms_acceleration(const Cycle<double>& cycle) {
  return std::sqrt(sum(cycle, [](const auto& p) { return p.acceleration * p.acceleration * p.duration; }) /
                   cycle.total_time);
}
double largest_acceleration(const Cycle<double>& cycle) {
  double a = 0.0;
  for (const auto& phase : cycle.phases) a = std::max(a, phase.acceleration);
  return a;
}

}  // namespace

// Biagiotti and Melchiorri, double-S: s = 0.4 m, v = 0.25 m/s, a = 2 m/s2, j = 40 m/s3 takes 1.775 s with an RMS
// acceleration of 0.6987581204 m/s2; its ramp takes v/a + a/j = 0.175 s.
TEST_CASE("A jerk-limited move has the time, peak and RMS of the seven-segment profile") {
  const Cycle<double> cycle = cycle_of(jerk_limited(0.4, 0.25, 0.175, 40.0), 3.0);
  CHECK(cycle.total_time == Approx(1.775).epsilon(1e-12));
  CHECK(time_of(cycle) == Approx(1.775).epsilon(1e-12));
  CHECK(travel_of(cycle) == Approx(0.4).epsilon(1e-12));
  CHECK(largest_acceleration(cycle) == Approx(2.0).epsilon(1e-12));
  CHECK(rms_acceleration(cycle) == Approx(0.6987581204).epsilon(1e-9));
  CHECK(cycle.phases.front().force == Approx(6.0).epsilon(1e-12));
  // Two ramps of 0.175 s in 1.775 s; for the jerk alone 2 sqrt(0.25/40) = 0.158 s would do.
  CHECK(cycle.time_ratio == Approx(2.0 * std::sqrt(0.25 / 40.0) / 0.175).epsilon(1e-12));
}

// The limit of acceleration is never reached: s = 0.02 m, v = 0.05 m/s, j = 40 m/s3 takes 0.4707106781 s, with a peak
// of sqrt(j v) = 1.414213562 m/s2 and an RMS of 0.4475430777 m/s2; the ramp of 2 sqrt(v/j) is just long enough.
TEST_CASE("A ramp just long enough for its jerk has no constant acceleration") {
  const double ramp = 2.0 * std::sqrt(0.05 / 40.0);
  const Cycle<double> cycle = cycle_of(jerk_limited(0.02, 0.05, ramp, 40.0), 1.0);
  CHECK(cycle.total_time == Approx(0.4707106781).epsilon(1e-9));
  CHECK(largest_acceleration(cycle) == Approx(1.414213562).epsilon(1e-6));
  CHECK(rms_acceleration(cycle) == Approx(0.4475430777).epsilon(1e-6));
  CHECK(cycle.time_ratio == Approx(1.0).epsilon(1e-9));
}

// 2 sqrt(0.25/40) = 0.1581139 s are needed, 0.05 s are there: 3.162278.
TEST_CASE("A ramp too short for its jerk is refused by the time ratio and stays a number") {
  const Cycle<double> cycle = cycle_of(jerk_limited(0.4, 0.25, 0.05, 40.0), 3.0);
  CHECK(cycle.time_ratio == Approx(3.16227766).epsilon(1e-8));
  CHECK(largest_acceleration(cycle) == Approx(2.0 * 0.25 / 0.05));
  for (const auto& phase : cycle.phases) CHECK(std::isfinite(phase.force));
  using Slope = scalar::Dual<double, 1>;
  MotionData data;
  data.moves = {jerk_limited(0.4, 0.25, 0.05, 40.0)};
  data.moves[0].acceleration_time.reset();
  for (const double ramp : {0.05, 2.0 * std::sqrt(0.25 / 40.0), 0.16, 0.3}) {
    const Cycle<Slope> slopes = machine::duty_cycle(data, Slope(3.0), Slope(ramp, {1.0}));
    for (const auto& phase : slopes.phases) CHECK_FALSE(std::isnan(phase.force.slope[0]));
  }
}

// Mean cubes of a load b + m a(t), weighted with the speed, by summing up the ramp in 200000 steps.
TEST_CASE("Mean loads of a jerk-limited ramp are those of the whole S-curve") {
  const double v = 0.25, ramp = 0.175, peak = 2.0, jerk = 40.0, mass = 2.0, drag = 10.0;
  const double rise = peak / jerk, constant = ramp - 2.0 * rise;
  double cubes = 0.0, speed = 0.0;
  constexpr int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) * ramp / steps;
    const double a = t < rise ? jerk * t : t < rise + constant ? peak : jerk * (ramp - t);
    const double before = speed;
    speed += a * ramp / steps;
    cubes += 0.5 * (before + speed) * std::pow(drag + mass * a, 3.0) * ramp / steps;
  }
  CHECK(speed == Approx(v).epsilon(1e-8));
  const Cycle<double> cycle = cycle_of(jerk_limited(0.4, v, ramp, jerk), mass, drag);
  double of_phases = 0.0;
  for (const auto& phase : cycle.phases)
    if (phase.acceleration > 0.0) of_phases += phase.mean_speed * phase.duration * std::pow(phase.force, 3.0);
  CHECK(of_phases == Approx(cubes).epsilon(1e-6));
  // By hand: 14^3 at the peak, and (14^4 - 10^4)/(4*4) = 1776 as the mean of the rising and the falling part.
  CHECK(of_phases == Approx(0.5 * v * (constant * 2744.0 + 2.0 * rise * 1776.0)).epsilon(1e-12));
}

// Squares of the speed against the speed, by summing up the ramp in 200000 steps. Bounds contain what is inside.
TEST_CASE("Losses of a jerk-limited ramp are those of the whole S-curve") {
  const double v = 0.25, ramp = 0.2;
  std::vector<double> shares;
  for (const double rise : {1e-9, 0.01, 0.05, 0.08, 0.1}) {
    const double peak = v / (ramp - rise);
    double squares = 0.0, way = 0.0, speed = 0.0;
    constexpr int steps = 200000;
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 0.5) * ramp / steps;
      const double before = speed;
      speed += peak * std::min({1.0, t / rise, (ramp - t) / rise}) * ramp / steps;
      const double mean = 0.5 * (before + speed);
      squares += mean * mean;
      way += mean;
    }
    CHECK(speed == Approx(v).epsilon(1e-6));
    INFO(rise);
    const Move move = jerk_limited(0.4, v, ramp, rise < 0.1 ? peak / rise : peak / rise * (1.0 + 1e-15));
    for (const auto& phase : cycle_of(move, 2.0).phases) {
      if (phase.acceleration == 0.0) continue;
      CHECK(phase.loss_share * v == Approx(squares / way).epsilon(1e-6));
      shares.push_back(phase.loss_share);
    }
  }
  CHECK(shares.front() == Approx(2.0 / 3.0));
  CHECK(shares.back() == Approx(23.0 / 30.0).epsilon(1e-6));
  MotionData data;
  data.moves = {jerk_limited(0.4, v, ramp, 0.25 / (0.15 * 0.05))};
  data.moves[0].acceleration_time.reset();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0.18, 0.9);
  for (int n = 0; n < 300; ++n) {
    const auto [from, to] = std::minmax({any(random), any(random)});
    const auto over = machine::duty_cycle(data, scalar::Interval(2.0), scalar::Interval(from, to));
    for (const double share : {0.0, 0.1, 0.5, 1.0}) {
      const auto point = machine::duty_cycle(data, 2.0, from + share * (to - from));
      for (std::size_t i = 0; i < point.phases.size(); ++i)
        CHECK(contains(over.phases[i].loss_share, point.phases[i].loss_share));
    }
  }
}

TEST_CASE("The two ramps of a move are paired, whatever their parts") {
  for (const bool limited : {false, true}) {
    Move move = jerk_limited(0.4, 0.25, 0.175, 40.0);
    if (!limited) move.jerk.reset();
    const Cycle<double> cycle = cycle_of(move, 2.0, 0.0, 0.5);
    const auto pairs = cycle_of<scalar::Interval>(move, 2.0, 0.0, 0.5).mirrored;
    CHECK(pairs.size() == (limited ? 6U : 2U));  // up and down
    for (const auto& pair : pairs) {
      const auto &up = cycle.phases[pair.accelerate], &down = cycle.phases[pair.brake];
      CHECK(up.acceleration == -down.acceleration);
      CHECK(up.duration == down.duration);
      CHECK(cycle.phases[pair.cruise].acceleration == 0.0);
      CHECK(0.5 * (up.force + down.force) == Approx(cycle.phases[pair.cruise].force));
    }
    CHECK(machine::phase_names({.moves = {move}, .inclination = 0.5}).size() == cycle.phases.size());
  }
}

// Up in 0.2 s to 0.1 m/s, 0.8 s there, down in 0.2 s: 0.5 m/s2, 0.1 m in 1.2 s. 4 kg and 3 N of drag: 5, 3 and 1 N.
TEST_CASE("A trapezoid that was sampled is the trapezoid") {
  const Move move = measured({5.0, 5.1, 5.2, 5.5, 6.0, 6.2}, {0.0, 0.05, 0.1, 0.1, 0.1, 0.0});
  const Cycle<double> cycle = cycle_of(move, 4.0, 3.0);
  REQUIRE(cycle.phases.size() == 3);  // samples of one ramp are joined
  CHECK(cycle.phases[0].force == Approx(5.0));
  CHECK(cycle.phases[1].force == Approx(3.0));
  CHECK(cycle.phases[2].force == Approx(1.0));
  CHECK(cycle.phases[0].duration == Approx(0.2));
  CHECK(cycle.phases[0].mean_speed == Approx(0.05));
  CHECK(cycle.phases[1].duration == Approx(0.8));
  CHECK(cycle.total_time == Approx(1.2));
  CHECK(cycle.travelled == Approx(0.1));
  CHECK(cycle.peak_speed == Approx(0.1));
  CHECK(move.profile->extent == Approx(0.1));
  CHECK(cycle.time_ratio == 0.0);  // ramps that are chosen do not matter to it
  CHECK(cycle.mirrored.empty());
}

// 0.2 m/s up turns into 0.2 m/s down within 1 s, so 0.4 m/s2: 0.05 m up and back. 2 kg: 2 (9.80665 - 0.4) N both ways.
TEST_CASE("Where a profile turns round, gravity turns from burden to help") {
  const Move move = measured({0.0, 1.0, 2.0, 3.0}, {0.2, -0.2, 0.0, 0.0});
  const Cycle<double> cycle = cycle_of(move, 2.0, 0.0, std::numbers::pi / 2.0);
  REQUIRE(cycle.phases.size() == 3);
  CHECK(cycle.phases[0].acceleration == Approx(-0.4));
  CHECK(cycle.phases[0].force == Approx(18.8133));
  CHECK(cycle.phases[1].acceleration == Approx(0.4));
  CHECK(cycle.phases[1].force == Approx(-18.8133));
  CHECK(cycle.phases[2].force == Approx(2.0 * (-0.2 - 9.80665)));
  CHECK(cycle.total_time == Approx(3.0));  // standing still counts
  CHECK(cycle.travelled == Approx(0.05 + 0.05 + 0.1));
  CHECK(move.profile->extent == Approx(0.15));  // 0.05 m above the start, 0.1 m below it
}

// A force that rises from 0 to 30 N while the speed rises from 0 to 1 m/s does the work of 30 t times t: 10 J. Its cube
// times the speed, 27000 t^4, is 5400; on the safe side 27000/3 = 9000.
TEST_CASE("A force that changes within an interval counts with both of its ends") {
  const Cycle<double> cycle = cycle_of(measured({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}, {0.0, 30.0, 30.0}), 0.001);
  REQUIRE(cycle.phases.size() == 3);
  double work = 0.0, cubes = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& phase = cycle.phases[i];
    const double force = phase.force - 0.001 * phase.acceleration;
    work += force * phase.mean_speed * phase.duration;
    cubes += force * force * force * phase.mean_speed * phase.duration;
  }
  CHECK(work == Approx(10.0));
  CHECK(cubes == Approx(9000.0));
  CHECK(travel_of(cycle) == Approx(1.0));
  CHECK(cycle.process_force == Approx(30.0));
}

TEST_CASE("The largest force of a standstill is kept, not that of what moves") {
  const Cycle<double> cycle = cycle_of(
      measured({0.0, 1.0, 2.0, 3.0, 4.0, 5.0}, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, {0.0, 30.0, 20.0, -70.0, 10.0, 0.0}),
      0.001);
  CHECK(cycle.standing_force == 70.0);
  CHECK(machine::standing_load(cycle, scalar::dimension::force) == Approx(70.0));
  machine::MeasuredProfile shared = *measured({0.0, 1.0, 2.0, 3.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 8.0, 6.0}).profile;
  shared.scale_forces(0.5);
  CHECK(shared.standing_force == 4.0);
  CHECK(cycle_of(measured({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}, {5.0, 30.0, 9.0}), 0.001).standing_force == 0.0);
}

// x = t^2, unevenly sampled: the parabola through any three samples is it.
TEST_CASE("Speeds of positions are exact for an even acceleration") {
  const std::vector<double> times{0.0, 0.1, 0.3, 0.6, 0.7};
  std::vector<double> positions;
  for (const double t : times) positions.push_back(t * t);
  const std::vector<double> speeds = machine::speeds_of_positions(times, positions);
  for (std::size_t i = 0; i < times.size(); ++i) CHECK(speeds[i] == Approx(2.0 * times[i]).margin(1e-12));
}

// A sine forth and back under a force of its own rhythm: time, travel and means are kept, the rest is at least what the
// samples say, and not much more.
TEST_CASE("A long profile is gathered on the safe side") {
  constexpr int samples = 4001;
  const double mass = 5.0, swing = 0.2, turn = 2.0 * std::numbers::pi;
  std::vector<double> times, speeds, forces;
  for (int i = 0; i < samples; ++i) {
    const double t = i / 4000.0;
    times.push_back(t);
    speeds.push_back(swing * std::sin(turn * t));
    forces.push_back(20.0 + 10.0 * std::sin(5.0 * turn * t));
  }
  const Move move = measured(times, speeds, forces);
  CHECK(move.profile->phases.size() <= 2 * 17 * 9);
  CHECK(move.profile->phases.size() > 20);
  const Cycle<double> cycle = cycle_of(move, mass);
  double time = 0.0, travel = 0.0, squares = 0.0, force_time = 0.0, cubes = 0.0, force_squares = 0.0, largest = 0.0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double dt = times[i + 1] - times[i], v0 = std::abs(speeds[i]), v1 = std::abs(speeds[i + 1]);
    const double a = (v1 - v0) / dt, force = 0.5 * (forces[i] + forces[i + 1]), load = std::abs(mass * a + force);
    time += dt;
    travel += 0.5 * (v0 + v1) * dt;
    squares += a * a * dt;
    force_time += force * dt;
    cubes += 0.5 * (v0 + v1) * dt * load * load * load;
    force_squares += load * load * dt;
    largest = std::max(largest, load);
  }
  CHECK(time_of(cycle) == Approx(time).epsilon(1e-9));
  CHECK(travel_of(cycle) == Approx(travel).epsilon(1e-9));
  CHECK(travel == Approx(4.0 * swing / turn).epsilon(1e-5));  // 2/pi of the peak speed over 1 s
  CHECK(cycle.peak_speed == Approx(swing).epsilon(1e-6));
  const auto integral = [&](auto value) { return sum(cycle, value); };
  CHECK(integral([&](const auto& p) { return (p.force - mass * p.acceleration) * p.duration; }) ==
        Approx(force_time).epsilon(1e-9));
  const double all_squares = integral([](const auto& p) { return p.acceleration * p.acceleration * p.duration; });
  CHECK(all_squares >= squares);
  CHECK(all_squares <= 1.03 * squares);
  const double all_cubes =
      integral([](const auto& p) { return std::pow(std::abs(p.force), 3.0) * p.mean_speed * p.duration; });
  CHECK(all_cubes >= cubes);
  CHECK(all_cubes <= 1.1 * cubes);
  const double all_loads = integral([](const auto& p) { return p.force * p.force * p.duration; });
  CHECK(all_loads >= force_squares);
  CHECK(all_loads <= 1.1 * force_squares);
  double of_cycle = 0.0;
  for (const auto& phase : cycle.phases) of_cycle = std::max(of_cycle, std::abs(phase.force));
  CHECK(of_cycle >= largest);
  // At most a cell more: an eighth of the largest acceleration and a quarter of the largest force.
  CHECK(of_cycle <= largest + mass * swing * turn / 8.0 + 30.0 / 4.0);
}

// A thread of lead angle l and friction angle r drives at tan(l)/tan(l + r) and yields at tan(l - r)/tan(l), negative
// where it locks.
TEST_CASE("Phases of a profile that others cover are never the hardest for force, torque or share of the torque") {
  std::mt19937 random(11);
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  const auto chance = [&](double share) { return uniform(0.0, 1.0) < share; };
  std::size_t left_out = 0, phases = 0, backwards = 0, locking = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::vector<double> times, speeds, forces;
    const bool returns = chance(0.7), pushed = chance(0.7);
    const int samples = static_cast<int>(uniform(3.0, 25.0));
    double speed = 0.0;
    for (int i = 0; i < samples; ++i) {
      times.push_back(i == 0 ? 0.0 : times.back() + uniform(0.02, 0.1));
      if (chance(0.6)) speed = returns ? uniform(-0.3, 0.3) : uniform(0.0, 0.3);
      speeds.push_back(i == 0 || i == samples - 1 ? 0.0 : speed);
      forces.push_back(pushed && chance(0.5) ? uniform(-30.0, 90.0) : 0.0);
    }
    const Move move = measured(times, speeds, forces);
    const double mass = std::exp(uniform(std::log(0.2), std::log(30.0)));
    const Cycle<double> cycle =
        cycle_of(move, mass, chance(0.5) ? uniform(0.0, 20.0) : 0.0, chance(0.5) ? uniform(0.0, 1.57) : 0.0);
    const double lead_angle = uniform(0.02, 0.4), friction_angle = uniform(0.01, 0.25);
    const double efficiency = std::tan(lead_angle) / std::tan(lead_angle + friction_angle);
    const double reverse = std::tan(lead_angle - friction_angle) / std::tan(lead_angle);
    const double ratio = uniform(0.5, 5.0), gears = uniform(0.7, 1.0), inertia = std::exp(uniform(-16.0, -6.0));
    const double drag = chance(0.5) ? uniform(0.0, 0.2) : 0.0, lead = uniform(0.002, 0.02);
    const double fall = uniform(0.0, 1.0);
    struct Hardest {
      double force = 0.0, torque = 0.0, share = 0.0, belt = 0.0, acceleration = 0.0;
    } all, governing;
    for (const auto& phase : cycle.phases) {
      const double turned = phase.acceleration * 2.0 * std::numbers::pi / lead * ratio;
      namespace act = mechanics::actuation;
      const double torque = std::abs(
          act::screw_motor_torque(phase.force, lead, efficiency, reverse, inertia, turned, drag, ratio, gears));
      const double belt = std::abs(act::belt_motor_torque(phase.force, 0.01, gears, inertia, turned, 0.0, ratio));
      const double available = 1.0 / (1.0 + fall * phase.speed * ratio / lead);  // falls with speed
      const auto note = [&](Hardest& hardest) {
        hardest.force = std::max(hardest.force, std::abs(phase.force));
        hardest.torque = std::max(hardest.torque, torque);
        hardest.share = std::max(hardest.share, torque / available);
        hardest.belt = std::max(hardest.belt, belt / available);
        hardest.acceleration = std::max(hardest.acceleration, std::abs(phase.acceleration));
      };
      note(all);
      if (phase.may_govern) note(governing);
    }
    left_out += static_cast<std::size_t>(
        std::ranges::count_if(cycle.phases, [](const auto& phase) { return !phase.may_govern; }));
    phases += cycle.phases.size();
    backwards += static_cast<std::size_t>(
        std::ranges::count_if(move.profile->phases, [](const auto& phase) { return phase.backwards; }));
    locking += reverse < 0.0 ? 1 : 0;
    CAPTURE(trial, mass, reverse, ratio, inertia, drag);
    CHECK(governing.force >= all.force * (1.0 - 1e-12));
    CHECK(governing.torque >= all.torque * (1.0 - 1e-12));
    CHECK(governing.share >= all.share * (1.0 - 1e-12));
    CHECK(governing.belt >= all.belt * (1.0 - 1e-12));
    CHECK(governing.acceleration == all.acceleration);
  }
  CHECK(left_out > phases / 4);
  CHECK(left_out < phases);
  CHECK(backwards > phases / 8);
  CHECK(locking > 500);
}

// Down 80 N press at 0.02 m/s; up it is faster, with nothing to press. 3 kg: up 29.4 N + 0.3 N, down 80 - 29.4 N.
TEST_CASE("A counterbalance lets every phase of a profile govern") {
  const Move move = measured({0.0, 0.5, 1.5, 2.0, 2.5, 3.5, 4.0},
                             {0.0, -0.02, -0.02, 0.0, 0.05, 0.05, 0.0},
                             {0.0, 0.0, 80.0, 80.0, 0.0, 0.0, 0.0});
  MotionData data;
  data.moves = {move};
  data.inclination = std::numbers::pi / 2.0;
  const auto left = [&] {
    const Cycle<double> cycle = machine::duty_cycle(data, 3.0, 0.1);
    return std::pair(std::ranges::count_if(cycle.phases, [](const auto& phase) { return phase.may_govern; }),
                     static_cast<std::ptrdiff_t>(cycle.phases.size()));
  };
  CHECK(left().first < left().second);
  data.counterbalance_force = 40.0;  // the weight is negative then: what is down may be the hardest
  CHECK(left().first == left().second);
}

// Jerk-limited to 0.25 m/s in 0.2 s: 0.04 - 4*0.25/40 = 0.015 s2 stay constant, so at most 2*0.25/(0.2 + sqrt(0.015)).
// 0.4 m in 2 s with ramps of t: v = 0.4/(2 - t), a = v/t.
TEST_CASE("A supply is sized for the peak of the ramp that is chosen and the hardest phases of a profile") {
  MotionData data;
  machine::Move timed;
  timed.distance = 0.4;
  timed.time = 2.0;
  data.moves = {jerk_limited(0.4, 0.25, 0.2, 40.0), measured({0.0, 1.0, 2.0, 3.0}, {0.0, 0.5, 0.6, 0.0}), timed};
  for (const double ramp : {0.1, 0.5}) {
    const auto demands = machine::duty_cycle(data, 3.0, ramp).demands;
    REQUIRE(demands.size() == 4);
    CHECK(demands[0].acceleration == Approx(0.5 / (0.2 + std::sqrt(0.015))));
    CHECK(demands[0].speed == Approx(0.25));
    CHECK(demands[1].acceleration == Approx(0.5));
    CHECK(demands[1].speed == Approx(0.5));
    CHECK(demands[2].acceleration == Approx(0.1));  // faster; the braking of the third second asks for less than this
    CHECK(demands[2].speed == Approx(0.6));
    CHECK(demands[3].speed == Approx(0.4 / (2.0 - ramp)));
    CHECK(demands[3].acceleration == Approx(0.4 / (2.0 - ramp) / ramp));
  }
}

// v = d/(T - t), a = v/t and a v of every ramp t in an interval, and hardly more than these.
TEST_CASE("What the power of a move hangs on is known of an interval of ramps as closely as can be") {
  using scalar::Interval;
  MotionData data;
  machine::Move timed;
  timed.distance = 0.4;
  timed.time = 2.0;
  data.moves = {timed};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.01, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    const auto [shortest, longest] = std::minmax({anywhere(random), anywhere(random)});
    CAPTURE(shortest, longest);
    const auto known = machine::duty_cycle(data, Interval(3.0), Interval(shortest, longest)).demands.front();
    Interval accelerations = machine::duty_cycle(data, 3.0, shortest).demands.front().acceleration;
    Interval products = accelerations * Interval(0.4 / (2.0 - shortest));
    constexpr int samples = 400;
    for (int i = 0; i <= samples; ++i) {
      const double ramp = std::min(shortest + (longest - shortest) * i / samples, longest);
      const auto demand = machine::duty_cycle(data, 3.0, ramp).demands.front();
      const double product = demand.acceleration * demand.speed;
      CHECK((known.acceleration.lower <= demand.acceleration && demand.acceleration <= known.acceleration.upper));
      CHECK((known.acceleration_times_speed.lower <= product && product <= known.acceleration_times_speed.upper));
      accelerations = hull(accelerations, Interval(demand.acceleration));
      products = hull(products, Interval(product));
    }
    CHECK(known.acceleration.lower == Approx(accelerations.lower).epsilon(1e-12));
    CHECK(known.acceleration.upper == Approx(accelerations.upper).epsilon(1e-12));
    CHECK(known.acceleration_times_speed.lower == Approx(products.lower).epsilon(1e-4));
    CHECK(known.acceleration_times_speed.upper == Approx(products.upper).epsilon(1e-12));
  }
}

// The shortest ramp: 0.4/(2 - 0.1)/0.1 = 2.105 m/s2; with a jerk a ramp is not shorter than 2 sqrt(0.25/40) = 0.158 s.
TEST_CASE("The largest acceleration of an axis is that of the shortest ramp it may take") {
  MotionData data;
  data.acceleration_time = {0.1, 0.5};
  machine::Move timed;
  timed.distance = 0.4;
  timed.time = 2.0;
  data.moves = {timed};
  CHECK(machine::largest_acceleration(data) == Approx(0.4 / 1.9 / 0.1));
  data.moves.push_back(jerk_limited(0.4, 0.25, 0.05, 40.0));
  CHECK(machine::largest_acceleration(data) == Approx(std::sqrt(10.0)));
}

TEST_CASE("Every number of a cycle has its dimension") {
  namespace dimension = scalar::dimension;
  using scalar::Dimensioned;
  MotionData data;
  data.inclination = 0.3;
  data.moves = {jerk_limited(0.4, 0.25, 0.175, 40.0), measured({0.0, 1.0, 2.0}, {0.0, 1.0, 0.0}, {0.0, 30.0, 30.0})};
  for (const bool rotary : {false, true}) {
    data.rotary = rotary;
    data.inclination = rotary ? 0.0 : 0.3;
    const auto of = machine::motion_dimensions(rotary);
    const auto cycle =
        machine::duty_cycle(data,
                            scalar::in_unit<Dimensioned>(3.0, rotary ? dimension::inertia : dimension::mass),
                            scalar::in_unit<Dimensioned>(0.1, dimension::time));
    for (const auto& phase : cycle.phases) {
      CHECK(phase.force.dimension == of.force);
      CHECK(phase.acceleration.dimension == of.acceleration);
      CHECK(phase.mean_speed.dimension == of.speed);
      CHECK(phase.duration.dimension == dimension::time);
    }
    CHECK(cycle.travelled.dimension == of.distance);
    CHECK(cycle.time_ratio.dimension == dimension::none);
  }
}

}  // namespace motion_cycle_test
