// SPDX-License-Identifier: Apache-2.0
//
// Variants of stack_model.h that break what makes the family easy: a special program that tabulates what each pair can
// carry would have to be written anew for each. Here each is a few lines more in a model. With m the moved mass:
//   shared_supply   one of three voltages for all axes, which motors turn faster with; a budget of power
//   same_motor      each axis its own motor, or the same on all of them and cheaper
//   resonance       no screw may turn at 2/3 to 3/2 of the frequency of the mass m on the axis's feet
//   least_inertia   the inertia that is driven is at least twice that of the rotor: more mass may help
//   belt            a reduction of the motor's speed between motor and screw, from a table of its own
//   several_loads   three loads, each with its time and its ramp
//   error_budget    lead error, give and twist of all screws together within a budget
//   free_diameter   the screw is made to measure: its diameter is free, costs and weighs
#pragma once

#include <array>

#include "benchmark/stack_instance.h"
#include "benchmark/stack_model.h"

namespace stack::broken {

/// A voltage that all axes share: what it makes of every corner speed, and what its supply costs.
struct Voltage {
  double factor, price;
};
inline constexpr std::array<Voltage, 3> voltages{{{0.75, 14.0}, {1.0, 21.0}, {1.3, 33.0}}};
inline constexpr double power_share = 0.3;  ///< of holding torque times corner speed: what a motor takes

inline constexpr double discounted = 0.8;  ///< of a motor's price, where all are the same

inline constexpr double resonance_band = 1.5;  ///< times or divided by the frequency

inline constexpr double least_inertia_ratio = 2.0;

enum BeltColumn { belt_ratio, belt_inertia, belt_torque, belt_mass, belt_price, belt_width };
enum BeltSlot { belt_slot = 2 };
inline constexpr double belt_efficiency = 0.96;

/// What the tool carries beside its own mass [kg], the time of the move and the force, as factors of the axis's.
struct LoadCase {
  double payload, time, force;
};
inline constexpr std::array<LoadCase, 3> load_cases{{{0.0, 1.0, 1.0}, {1.5, 1.6, 0.5}, {0.3, 2.5, 3.0}}};

inline Axis under(const LoadCase& load, Axis axis) {
  axis.move_time *= load.time;
  axis.force *= load.force;
  return axis;
}

/// Columns behind those of CutScrewColumn.
enum ErrorColumn { cut_error = cut_width, error_width };
/// Behind lead and efficiency: thickness of the core, mass per length and square of the diameter, prices.
enum BlankColumn {
  blank_lead,
  blank_efficiency,
  blank_core,
  blank_mass,
  blank_price,
  blank_price_per_mass,
  blank_width
};
inline constexpr double least_diameter = 6e-3, largest_diameter = 45e-3;

/// Belts with toothed wheels of one to four turns of the motor for one of the screw.
inline Columns random_belts(int count, std::uint64_t seed) {
  Random random(seed ^ 0x62656c74U);
  Columns belts{"belt", belt_width, {}};
  for (int i = 0; i < count; ++i) {
    const double ratio = rounded(random.between(1.0, 4.0), 0.05);
    const double torque = std::exp(random.between(std::log(0.5), std::log(20.0)));
    belts.numbers.insert(belts.numbers.end(),
                         {ratio,
                          2e-6 * (1.0 + torque) * random.between(0.7, 1.4),
                          torque,
                          0.03 * (1.0 + torque) * random.between(0.7, 1.4),
                          rounded((3.0 + 1.5 * torque + ratio) * random.between(0.8, 1.3), 0.01)});
  }
  return belts;
}

/// The screws' lead errors over an axis's stroke: the exacter, the dearer.
inline Columns screws_with_errors(const Columns& screws, const Axis& axis) {
  const Columns cut = cut_screws(screws, axis.length);
  Columns result{"screw", error_width, {}};
  Random random(screws.rows());
  for (std::uint32_t i = 0; i < cut.rows(); ++i) {
    std::vector<double> row(cut.row(i), cut.row(i) + cut_width);
    const double worse = std::floor(random.between(0.0, 5.0));
    row[cut_price] *= 1.6 / (1.0 + 0.15 * worse);
    row.push_back(10e-6 * std::exp2(worse) * random.between(0.8, 1.2) * (0.3 + axis.stroke) / 0.6);
    result.numbers.insert(result.numbers.end(), row.begin(), row.end());
  }
  return result;
}

inline Columns blanks(const Columns& screws) {
  Columns result{"blank", blank_width, {}};
  for (std::uint32_t i = 0; i < screws.rows(); ++i) {
    const double* s = screws.row(i);
    result.numbers.insert(result.numbers.end(),
                          {s[lead],
                           s[efficiency],
                           s[root] / s[diameter],
                           s[mass_per_length] / (s[diameter] * s[diameter]),
                           s[price],
                           s[price_per_length] / s[mass_per_length]});
  }
  return result;
}

/// Readings of the motor's row that every variant makes.
template <class T>
struct Motor {
  T holding, corner, rotor, mass, price;
};
template <class T, class Input>
Motor<T> motor_of(const Input& in) {
  return {in.row(motor_slot, holding_torque),
          in.row(motor_slot, corner_speed),
          in.row(motor_slot, rotor_inertia),
          in.row(motor_slot, motor_mass),
          in.row(motor_slot, motor_price)};
}

/// Of a drive whose screw is from a table cut to length.
template <class T, class Input>
Motion<T> motion_in(const Input& in, const Axis& axis, const T& mass, const T& ramp) {
  return motion_of<T>(axis,
                      in.row(screw_slot, cut_lead),
                      in.row(screw_slot, cut_efficiency),
                      in.row(screw_slot, cut_inertia),
                      mass,
                      ramp);
}
/// A motor straight on its screw.
template <class T>
void hold_drive(const Axis& axis,
                const T& lead,
                const T& root,
                const Motor<T>& motor,
                const Motion<T>& motion,
                std::vector<T>& utilisation) {
  hold_motor<T>(motion.torque,
                motion.inertia,
                motion.acceleration * motion.turns,
                motion.speed * motion.turns,
                motor.rotor,
                motor.corner,
                motor.holding,
                utilisation);
  hold_screw<T>(axis, lead, root, motion, utilisation);
}
template <class T, class Input>
void hold_drive(
    const Input& in, const Axis& axis, const Motor<T>& motor, const Motion<T>& motion, std::vector<T>& utilisation) {
  hold_drive<T>(axis, in.row(screw_slot, cut_lead), in.row(screw_slot, cut_root), motor, motion, utilisation);
}
/// `screw`, `price`: its mass and what it costs.
template <class T, class Answer>
void add_up(const T& screw, const T& price, const Motor<T>& motor, const T& mass, Answer& out) {
  const T own = screw + motor.mass;
  out.resources.push_back(price + motor.price);
  out.resources.push_back(own);
  out.handed_on.push_back(mass + own);
}
template <class T, class Input, class Answer>
void add_up(const Input& in, const Motor<T>& motor, const T& mass, Answer& out) {
  add_up<T>(in.row(screw_slot, cut_mass), in.row(screw_slot, cut_price), motor, mass, out);
}
template <class T, class Input>
T price_of_blank(const Input& in, const T& mass) {
  return in.row(screw_slot, blank_price) + in.row(screw_slot, blank_price_per_mass) * mass;
}

struct SharedSupply {
  Axis axis;
  bool pays_supply;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using T = std::decay_t<decltype(in.state(0))>;
    const Voltage& voltage = voltages[in.shared(0)];
    Motor<T> motor = motor_of<T>(in);
    motor.corner = motor.corner * voltage.factor;
    if (pays_supply) motor.price = motor.price + voltage.price;
    const T mass = in.state(0) + axis.carriage;
    hold_drive(in, axis, motor, motion_in(in, axis, mass, in.variable(0)), out.utilisation);
    add_up(in, motor, mass, out);
    out.resources.push_back(power_share * motor.holding * motor.corner);
  }
};

/// The shared choice is 0 for each axis its own motor, else one more than the row of the motor on all of them; then the
/// slot for an axis's own is not read.
struct SameMotor {
  Axis axis;
  const Columns* motors;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using T = std::decay_t<decltype(in.state(0))>;
    Motor<T> motor;
    if (in.shared(0) == 0) {
      motor = motor_of<T>(in);
    } else {
      const double* row = motors->row(in.shared(0) - 1);
      motor = {
          row[holding_torque], row[corner_speed], row[rotor_inertia], row[motor_mass], discounted * row[motor_price]};
    }
    const T mass = in.state(0) + axis.carriage;
    hold_drive(in, axis, motor, motion_in(in, axis, mass, in.variable(0)), out.utilisation);
    add_up(in, motor, mass, out);
  }
};

struct Resonance {
  Axis axis;
  double stiffness;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using T = std::decay_t<decltype(in.state(0))>;
    using millwright::scalar::absolute;
    using millwright::scalar::square;
    using std::log;
    const Motor<T> motor = motor_of<T>(in);
    const T mass = in.state(0) + axis.carriage;
    const Motion<T> motion = motion_in(in, axis, mass, in.variable(0));
    hold_drive(in, axis, motor, motion, out.utilisation);
    // Square of the ratio of frequencies; equal ones give a utilisation without end.
    const T ratio = square(motion.speed * motion.turns) * mass / stiffness;
    out.utilisation.push_back(2.0 * std::log(resonance_band) / absolute(log(ratio)));
    add_up(in, motor, mass, out);
  }
};

struct LeastInertia {
  Axis axis;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using T = std::decay_t<decltype(in.state(0))>;
    const Motor<T> motor = motor_of<T>(in);
    const T mass = in.state(0) + axis.carriage;
    const Motion<T> motion = motion_in(in, axis, mass, in.variable(0));
    hold_drive(in, axis, motor, motion, out.utilisation);
    out.utilisation.push_back(least_inertia_ratio * motor.rotor / motion.inertia);
    add_up(in, motor, mass, out);
  }
};

struct Belt {
  Axis axis;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using T = std::decay_t<decltype(in.state(0))>;
    using millwright::scalar::square;
    Motor<T> motor = motor_of<T>(in);
    const T ratio = in.row(belt_slot, belt_ratio);
    const T wheels = in.row(belt_slot, belt_inertia);
    const T mass = in.state(0) + axis.carriage;
    const Motion<T> motion = motion_in(in, axis, mass, in.variable(0));
    const T acceleration = motion.acceleration * motion.turns * ratio;
    hold_motor<T>(motion.torque / (ratio * belt_efficiency) + wheels * acceleration,
                  motion.inertia / square(ratio) + wheels,
                  acceleration,
                  motion.speed * motion.turns * ratio,
                  motor.rotor,
                  motor.corner,
                  motor.holding,
                  out.utilisation);
    hold_screw<T>(axis, in.row(screw_slot, cut_lead), in.row(screw_slot, cut_root), motion, out.utilisation);
    out.utilisation.push_back(motion.torque / in.row(belt_slot, belt_torque));
    motor.price = motor.price + in.row(belt_slot, belt_price);
    motor.mass = motor.mass + in.row(belt_slot, belt_mass);
    add_up(in, motor, mass, out);
  }
};

struct SeveralLoads {
  Axis axis;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using T = std::decay_t<decltype(in.state(0))>;
    const Motor<T> motor = motor_of<T>(in);
    const T mass = in.state(0) + axis.carriage;
    for (std::size_t i = 0; i < load_cases.size(); ++i) {
      const Axis loaded = under(load_cases[i], axis);
      const T whole = mass + load_cases[i].payload;
      hold_drive(in, loaded, motor, motion_in(in, loaded, whole, in.variable(i)), out.utilisation);
    }
    add_up(in, motor, mass, out);
  }
};

struct ErrorBudget {
  Axis axis;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using T = std::decay_t<decltype(in.state(0))>;
    using millwright::scalar::square;
    constexpr double pi = std::numbers::pi, young = 206e9, shear = 79e9;
    const Motor<T> motor = motor_of<T>(in);
    const T mass = in.state(0) + axis.carriage;
    const Motion<T> motion = motion_in(in, axis, mass, in.variable(0));
    hold_drive(in, axis, motor, motion, out.utilisation);
    add_up(in, motor, mass, out);
    // At constant speed: the screw is pressed shorter and wound up by the torque of the force.
    const T area = square(in.row(screw_slot, cut_root));
    const T wound = motion.force / (square(motion.turns) * in.row(screw_slot, cut_efficiency));
    out.resources.push_back(in.row(screw_slot, cut_error) + motion.force * axis.length / (young * pi / 4.0 * area) +
                            wound * axis.length / (shear * pi / 32.0 * square(area)));
  }
};

struct FreeDiameter {
  Axis axis;

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using T = std::decay_t<decltype(in.state(0))>;
    using millwright::scalar::square;
    const Motor<T> motor = motor_of<T>(in);
    const T& wide = in.variable(1);
    const T core = in.row(screw_slot, blank_core);
    const T step = in.row(screw_slot, blank_lead);
    const T screw = in.row(screw_slot, blank_mass) * square(wide) * axis.length;
    const T mass = in.state(0) + axis.carriage;
    const Motion<T> motion = motion_of<T>(axis,
                                          step,
                                          in.row(screw_slot, blank_efficiency),
                                          screw * square(wide * (1.0 + core)) / 32.0,
                                          mass,
                                          in.variable(0));
    hold_drive<T>(axis, step, wide * core, motor, motion, out.utilisation);
    add_up<T>(screw, price_of_blank<T>(in, screw), motor, mass, out);
  }
};

}  // namespace stack::broken
