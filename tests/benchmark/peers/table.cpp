// SPDX-License-Identifier: Apache-2.0
// What is worked out for the peers beforehand: what each pair can carry. For a given ramp every constraint is linear in
// the moved mass; what is left, a maximum over the ramp, has one peak.
#include <algorithm>

#include "benchmark/peers/peer.h"

namespace stack::peers {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double nothing = -std::numeric_limits<double>::infinity();

double ratio(double room, double demand) { return demand > 0.0 ? room / demand : room >= 0.0 ? 1e9 : nothing; }

/// The largest mass that the pair can move with this ramp.
double carried(const Axis& a, const double* s, const double* q, double t) {
  const double v = a.stroke / (a.move_time - t), acceleration = v / t;
  const double turns = 2.0 * pi / s[lead], d = s[root];
  const double screw_mass = s[mass_per_length] * a.length;
  const double radius = 0.25 * (s[diameter] + d), inertia = 0.5 * screw_mass * radius * radius;
  const double weight = 9.81 * (a.friction + a.gravity);
  const double fixed = a.force / (turns * s[efficiency]) + inertia * acceleration * turns;
  const double rising = weight / (turns * s[efficiency]) + acceleration / turns;
  const double speed = v * turns / q[corner_speed];
  const double second_moment = pi * d * d * d * d / 64.0;
  const double whirl = 3.927 * 3.927 / (2.0 * pi * a.length * a.length) * (d / 4.0) * std::sqrt(206e9 / 7850.0);
  if (v / s[lead] > 0.8 * whirl) return nothing;
  const double motor = 0.7 * q[holding_torque] / (1.0 + speed * speed) - q[rotor_inertia] * acceleration * turns;
  const double twist = a.largest_twist * 79e9 * 2.0 * second_moment / a.length;
  const double shear = a.largest_shear * pi * d * d * d / 16.0;
  const double buckling = pi * pi * 206e9 * second_moment / (a.length * a.length) - a.force;
  return std::min({ratio(std::min({motor, twist, shear}) - fixed, rising),
                   (10.0 * q[rotor_inertia] - inertia) * turns * turns,
                   ratio(buckling, weight + acceleration)});
}

}  // namespace

std::pair<double, double> best_ramp(const Axis& axis, const double* screw, const double* motor) {
  const double d = screw[root];
  const double whirl = 3.927 * 3.927 / (2.0 * pi * axis.length * axis.length) * (d / 4.0) * std::sqrt(206e9 / 7850.0);
  double low = axis.shortest_ramp();
  double high = std::min(axis.longest_ramp(), axis.move_time - axis.stroke / (0.8 * whirl * screw[lead]) - 1e-12);
  if (high < low) return {low, nothing};
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = carried(axis, screw, motor, left), at_right = carried(axis, screw, motor, right);
  for (int n = 0; n < 45; ++n) {
    if (at_left > at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = carried(axis, screw, motor, left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = carried(axis, screw, motor, right);
    }
  }
  std::pair<double, double> best{left, at_left};
  for (const double t : {right, low, high}) {
    const double mass = carried(axis, screw, motor, t);
    if (mass > best.second) best = {t, mass};
  }
  return best;
}

Table make_table(const Instance& instance) {
  Table table;
  for (const Axis& axis : instance.axes) {
    std::vector<Pair> all;
    for (std::uint32_t i = 0; i < instance.screws.rows(); ++i)
      for (std::uint32_t j = 0; j < instance.motors.rows(); ++j) {
        const double* s = instance.screws.row(i);
        const double* q = instance.motors.row(j);
        const double capacity = best_ramp(axis, s, q).second;
        if (capacity < axis.carriage) continue;
        all.push_back({i,
                       j,
                       s[price] + s[price_per_length] * axis.length + q[motor_price],
                       s[mass_per_length] * axis.length + q[motor_mass],
                       capacity});
      }
    std::stable_sort(all.begin(), all.end(), [](const Pair& a, const Pair& b) { return a.cost < b.cost; });
    std::vector<Pair> useful;
    for (const Pair& pair : all) {
      const bool beaten = std::any_of(useful.begin(), useful.end(), [&](const Pair& other) {
        return other.mass <= pair.mass && other.capacity >= pair.capacity;
      });
      if (!beaten) useful.push_back(pair);
    }
    table.all.push_back(std::move(all));
    table.useful.push_back(std::move(useful));
  }
  return table;
}

Worth worth_of(const Instance& instance, const Design& design) {
  const Machine machine(instance);
  Worth worth{-1.0, 0.0, 0.0};
  std::vector<double> state = machine.problem.first_state;
  millwright::solver::Answer<double> answer;
  for (std::size_t i = 0; i < design.size(); ++i) {
    const std::vector<std::uint32_t> rows{design[i].screw, design[i].motor};
    const std::vector<double> ramp{design[i].ramp};
    machine.problem.stages[i]->evaluate({{}, state, rows, ramp}, answer);
    for (const double u : answer.utilisation) worth.excess = std::max(worth.excess, u - 1.0);
    const Axis& axis = instance.axes[i];
    worth.excess = std::max({worth.excess, axis.shortest_ramp() - ramp[0], ramp[0] - axis.longest_ramp()});
    worth.cost += answer.resources[0];
    worth.mass += answer.resources[1];
    state = answer.handed_on;
  }
  return worth;
}

}  // namespace stack::peers
