// SPDX-License-Identifier: Apache-2.0
//
// stack(k, S, M), a family of problems to measure the search with: k axes carry each other, the first one on top. Each
// chooses one of S screws and one of M motors from the same two tables, and an acceleration time.
//
// With the moved mass m, the trapezoid a = X/(t (T - t)), v = X/(T - t), r = 2 pi/lead:
//   force F = F0 + m g (mu + gravity); screw torque T_s = F/(r e) + (J_s + m/r^2) a r
//   torque    T_s + J_m a r <= 0.7 T_h/(1 + (v r/w_c)^2)      inertia   J_s + m/r^2 <= 10 J_m
//   whirl     v/lead <= 0.8 f                                 buckling  F + m a <= half of Euler's load,
//   fixed-supported twist     T_s L/(G I_p) <= twist_max                      shear     16 T_s/(pi d_r^3) <= tau_max
// The stages are plain models over rows (model_stage.h): nothing is tabulated, and no structure is hinted at.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "solver/model_stage.h"
#include "solver/solver.h"

namespace stack {

using millwright::solver::Columns;
using millwright::solver::Stage;

struct Axis {
  double stroke = 0.0, length = 0.0, move_time = 0.0, carriage = 0.0, force = 0.0, friction = 0.0, gravity = 0.0;
  double largest_twist = 0.0, largest_shear = 0.0;
  [[nodiscard]] double shortest_ramp() const { return 0.02; }
  [[nodiscard]] double longest_ramp() const { return std::min(0.5, 0.5 * move_time); }
};

enum ScrewColumn { diameter, lead, root, efficiency, mass_per_length, price, price_per_length, screw_width };
enum MotorColumn { holding_torque, corner_speed, rotor_inertia, motor_mass, motor_price, motor_width };
enum Slot { screw_slot, motor_slot };

struct Instance {
  std::vector<Axis> axes;
  Columns screws{"screw", screw_width, {}};
  Columns motors{"motor", motor_width, {}};
};

/// What an axis reads of a screw: as long as the axis needs it.
enum CutScrewColumn { cut_lead, cut_root, cut_efficiency, cut_mass, cut_inertia, cut_price, cut_width };

inline Columns cut_screws(const Columns& screws, double length) {
  Columns cut{"screw", cut_width, {}};
  cut.numbers.reserve(cut_width * screws.rows());
  for (std::uint32_t i = 0; i < screws.rows(); ++i) {
    const double* s = screws.row(i);
    const double mass = s[mass_per_length] * length;
    const double radius = 0.25 * (s[diameter] + s[root]);
    cut.numbers.insert(
        cut.numbers.end(),
        {s[lead], s[root], s[efficiency], mass, 0.5 * mass * radius * radius, s[price] + s[price_per_length] * length});
  }
  return cut;
}

/// An axis under way: the screw's turns in rad for a metre of travel, the inertia that it drives, the force along it
/// and the torque in it while accelerating.
template <class T>
struct Motion {
  T mass, acceleration, speed, turns, inertia, force, torque;
};

template <class T>
Motion<T> motion_of(const Axis& axis, const T& lead, const T& efficiency, const T& inertia, const T& mass, const T& t) {
  using millwright::scalar::square;
  constexpr double gravity = 9.81;
  const T rest = axis.move_time - t;
  const T speed = axis.stroke / rest;
  const T acceleration = speed / t;
  const T turns = 2.0 * std::numbers::pi / lead;
  const T driven = inertia + mass / square(turns);
  const T force = axis.force + mass * (gravity * (axis.friction + axis.gravity));
  return {
      mass, acceleration, speed, turns, driven, force, force / (turns * efficiency) + driven * acceleration * turns};
}

/// Torque of the motor and inertia ratio, of what the motor drives seen at its shaft: the torque without its own rotor.
template <class T>
void hold_motor(const T& torque,
                const T& inertia,
                const T& acceleration,
                const T& speed,
                const T& rotor,
                const T& corner,
                const T& holding,
                std::vector<T>& utilisation) {
  using millwright::scalar::square;
  const T whole = torque + rotor * acceleration;
  utilisation.push_back(whole * (1.0 + square(speed / corner)) / (0.7 * holding));
  utilisation.push_back(inertia / (10.0 * rotor));
}

/// Whirl, buckling, twist and shear of the screw.
template <class T>
void hold_screw(const Axis& axis, const T& lead, const T& root, const Motion<T>& motion, std::vector<T>& utilisation) {
  using millwright::scalar::square;
  constexpr double pi = std::numbers::pi, young = 206e9, shear = 79e9, density = 7850.0;
  const double length = axis.length;
  const T d2 = square(root), d4 = square(d2);
  const double whirl = 3.927 * 3.927 / (2.0 * pi * length * length) * std::sqrt(young / density) / 4.0;
  utilisation.push_back(motion.speed / lead / (0.8 * whirl * root));
  utilisation.push_back((motion.force + motion.mass * motion.acceleration) /
                        (pi * pi * young * pi / 64.0 / (length * length) * d4));
  utilisation.push_back(motion.torque * length / (shear * pi / 32.0 * axis.largest_twist * d4));
  utilisation.push_back(16.0 * motion.torque / (pi * axis.largest_shear * (root * d2)));
}

/// Constraints, cost and mass of one axis; what it hands on is the mass on the next.
struct AxisModel {
  Axis axis;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    const auto lead_of = in.row(screw_slot, cut_lead);
    const auto mass = in.state(0) + axis.carriage;
    const auto motion = motion_of(
        axis, lead_of, in.row(screw_slot, cut_efficiency), in.row(screw_slot, cut_inertia), mass, in.variable(0));
    hold_motor(motion.torque,
               motion.inertia,
               motion.acceleration * motion.turns,
               motion.speed * motion.turns,
               in.row(motor_slot, rotor_inertia),
               in.row(motor_slot, corner_speed),
               in.row(motor_slot, holding_torque),
               out.utilisation);
    hold_screw(axis, lead_of, in.row(screw_slot, cut_root), motion, out.utilisation);
    const auto own = in.row(screw_slot, cut_mass) + in.row(motor_slot, motor_mass);
    out.resources.push_back(in.row(screw_slot, cut_price) + in.row(motor_slot, motor_price));
    out.resources.push_back(own);
    out.handed_on.push_back(mass + own);
  }
};
inline constexpr std::size_t constraints = 6;

/// The stages of an instance, which must outlive them, as the search takes them.
struct Machine {
  explicit Machine(const Instance& instance) {
    for (const Axis& axis : instance.axes) screws.push_back(cut_screws(instance.screws, axis.length));
    for (std::size_t i = 0; i < instance.axes.size(); ++i) {
      const Axis& axis = instance.axes[i];
      stages.push_back(std::make_unique<millwright::solver::ModelStage<AxisModel>>(
          "axis " + std::to_string(i + 1),
          std::vector<const Columns*>{&screws[i], &instance.motors},
          std::vector<millwright::solver::Variable>{{"acceleration_time", axis.shortest_ramp(), axis.longest_ramp()}},
          constraints,
          AxisModel{axis}));
      problem.stages.push_back(stages.back().get());
    }
    problem.first_state = {0.0};
    problem.resources = {{"cost"}, {"mass"}};
  }
  std::vector<Columns> screws;  ///< [axis]
  std::vector<std::unique_ptr<Stage>> stages;
  millwright::solver::Problem problem;
};

}  // namespace stack
