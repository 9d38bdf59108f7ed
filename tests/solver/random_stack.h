// SPDX-License-Identifier: Apache-2.0
//
// A zoo of small random problems for the search: stacks of axes as in machine tools, each with a screw, a motor and a
// coupling from small tables, an acceleration time, and sometimes a support shaft of free diameter that costs and
// weighs. An axis carries the moved mass of the axes before it; power adds up along the chain.
//
// Constraints of an axis (F external force, a acceleration, v speed, l lead, r = 2 pi/l, m carried mass):
//   torque     (F/(r e) + (J + m/r^2) a r + Jm a r) (1 + (v r/w)^2) <= 0.7 T_h
//   inertia    J + m/r^2 <= 10 Jm
//   whirl      v/l <= 0.8 f(screw)
//   buckling   F + m a <= 0.5 Euler load(screw)
//   power      power so far + own <= limit
//   coupling   F/(r e) <= torque of the coupling
//   stiffness  (m + 1) g L^3/(48 E I(diameter)) <= deflection          (shaft only)
//   ballast    least ratio * Jm <= J + m/r^2                           (variant: not monotone in the mass)
// Variants: gravity that helps (F falls with m), a voltage shared by all axes, a limit on a resource.
//
// In the acceleration time every left side is convex (sums and products of convex rising or log-convex functions), so
// the least worst utilisation is found by a search for the minimum of a convex function: that is what the independent
// enumeration (enumeration.h) does, and the solver does not know.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "scalar/dual.h"
#include "scalar/interval.h"
#include "solver/solver.h"

namespace zoo {

using millwright::scalar::Dual;
using millwright::scalar::Interval;
using namespace millwright::solver;

struct Screw {
  double root, lead, mass, inertia, price;
};
struct Motor {
  double torque, corner, inertia, mass, price, power;
};
struct Coupling {
  double torque, mass, price;
  int bore;
};
struct Axis {
  std::vector<Screw> screws;
  std::vector<Motor> motors;
  std::vector<Coupling> couplings;
  std::vector<int> motor_bore;
  double stroke = 0.3, length = 0.45, move_time = 0.8, carriage = 0.5, force = 20.0, friction = 0.05, gravity = 0.0;
  double least_ratio = 0.0;  ///< > 0: the ballast constraint
  double deflection = 0.0;   ///< > 0: the axis has a shaft
  bool only_shaft = false;   ///< no drive: a stage without slots that carries the load on its shaft
  double power_limit = 1e9;
  double time_low = 0.02, time_high = 0.3;
  std::vector<double> voltage{1.0};  ///< factor on corner speed and power
};

/// The numbers of one design, or intervals that contain those of a set.
template <class T>
struct Parts {
  T root, lead, screw_mass, screw_inertia, torque, corner, motor_inertia, part_mass, price, power, coupling_torque;
};

constexpr double gravity = 9.81;
constexpr double elasticity = 206e9;
constexpr double density = 7850.0;
constexpr double shaft_price = 12.0;  ///< per kg

template <class T>
void answer_of(const Axis& axis,
               double voltage,
               const Parts<T>& p,
               const T& time,
               const T& diameter,
               const T& carried,
               const T& power,
               Answer<T>& out) {
  using millwright::scalar::larger;
  using millwright::scalar::square;
  const double pi = std::numbers::pi;
  const double length = axis.length;
  const T mass = carried + axis.carriage;
  const T rest = axis.move_time - time;
  const T acceleration = axis.stroke / (time * rest);
  const T speed = axis.stroke / rest;
  const T r = (2.0 * pi) / p.lead;
  const T force = larger(T(1.0), axis.force + mass * (gravity * (axis.friction + axis.gravity)));
  const T inertia = p.screw_inertia + mass / square(r);
  const T steady = force / (r * 0.5);
  const T corner = p.corner * voltage;
  const T torque = steady + (inertia + p.motor_inertia) * acceleration * r;
  const T i_root = square(square(p.root)) * (pi / 64.0);
  const T total_power = power + p.power * voltage;
  const double whirl = 3.927 * 3.927 / (2.0 * pi * length * length) * std::sqrt(elasticity / density) / 4.0;
  auto& u = out.utilisation;
  u.clear();
  u.push_back(torque * (1.0 + square(speed * r / corner)) / (0.7 * p.torque));
  u.push_back(inertia / (10.0 * p.motor_inertia));
  u.push_back(speed / p.lead / (0.8 * whirl * p.root));
  u.push_back((force + mass * acceleration) / (pi * pi * elasticity * i_root / (length * length)));
  u.push_back(total_power / axis.power_limit);
  u.push_back(steady / p.coupling_torque);
  if (axis.least_ratio > 0.0) u.push_back(axis.least_ratio * p.motor_inertia / inertia);
  T shaft_mass(0.0);
  if (axis.deflection > 0.0) {
    const T i_shaft = square(square(diameter)) * (pi / 64.0);
    u.push_back((mass + 1.0) * (gravity * length * length * length) / (48.0 * elasticity * i_shaft) / axis.deflection);
    shaft_mass = square(diameter) * (pi / 4.0 * density * length);
  }
  const T own_mass = p.screw_mass + p.part_mass + shaft_mass;
  out.resources.assign({p.price + shaft_mass * shaft_price, own_mass, p.power * voltage});
  out.handed_on.assign({mass + own_mass, total_power});
}

/// A shaft of free diameter that stands under the load and weighs on what comes after.
template <class T>
void shaft_answer(const Axis& axis, const T& diameter, const T& carried, const T& power, Answer<T>& out) {
  using millwright::scalar::square;
  const double pi = std::numbers::pi;
  const double length = axis.length;
  const T i_shaft = square(square(diameter)) * (pi / 64.0);
  const T mass = square(diameter) * (pi / 4.0 * density * length);
  out.utilisation.assign(
      {(carried + 1.0) * (gravity * length * length * length) / (48.0 * elasticity * i_shaft) / axis.deflection});
  out.resources.assign({mass * shaft_price, mass, T(0.0)});
  out.handed_on.assign({carried + mass, power});
}

class AxisStage final : public Stage {
 public:
  explicit AxisStage(Axis axis) : axis_(std::move(axis)) {
    if (axis_.only_shaft) {
      variables_ = {{"shaft_diameter", 0.004, 0.04}};
      return;
    }
    slots_ = {{"screw", static_cast<Row>(axis_.screws.size())},
              {"motor", static_cast<Row>(axis_.motors.size())},
              {"coupling", static_cast<Row>(axis_.couplings.size())}};
    variables_ = {{"acceleration_time", axis_.time_low, axis_.time_high}};
    if (axis_.deflection > 0.0) variables_.push_back({"shaft_diameter", 0.004, 0.04});
  }
  [[nodiscard]] const Axis& axis() const { return axis_; }
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::span<const Slot> slots() const override { return slots_; }
  [[nodiscard]] std::span<const Variable> variables() const override { return variables_; }
  [[nodiscard]] std::size_t constraints() const override {
    if (axis_.only_shaft) return 1;
    return 6U + (axis_.least_ratio > 0.0 ? 1U : 0U) + (axis_.deflection > 0.0 ? 1U : 0U);
  }
  void evaluate(const Point& x, Answer<double>& out) const override {
    if (axis_.only_shaft) return shaft_answer(axis_, x.variables[0], x.inherited[0], x.inherited[1], out);
    const auto p = parts_of<double>(x.rows[0], x.rows[1], x.rows[2]);
    const double diameter = x.variables.size() > 1 ? x.variables[1] : 0.0;
    answer_of(axis_, voltage(x.shared), p, x.variables[0], diameter, x.inherited[0], x.inherited[1], out);
  }
  void bound(const Box& box, Answer<Interval>& out) const override {
    if (axis_.only_shaft) return shaft_answer(axis_, box.variables[0], box.inherited[0], box.inherited[1], out);
    const Interval diameter = box.variables.size() > 1 ? box.variables[1] : Interval(0.0);
    answer_of(
        axis_, voltage(box.shared), hull_of(box), box.variables[0], diameter, box.inherited[0], box.inherited[1], out);
    for (std::size_t c = 0; c < out.utilisation.size(); ++c)
      if (((box.kept >> (c % 64)) & 1U) != 0) out.utilisation[c] = Interval(0.0);
  }
  void slopes(const Box& box, Input input, Answer<Interval>& out) const override {
    const auto parts = axis_.only_shaft ? Parts<Dual<Interval>>{} : lift<Dual<Interval>>(hull_of(box));
    thread_local Answer<Dual<Interval>> answer;
    differentiate<Interval>(parts, box.shared, box.variables, box.inherited, input, answer);
    slope_of(answer, out);
  }
  void gradient(const Point& x, Input input, Answer<double>& out) const override {
    const auto parts = axis_.only_shaft ? Parts<Dual<double>>{}
                                        : lift<Dual<double>>(parts_of<double>(x.rows[0], x.rows[1], x.rows[2]));
    thread_local Answer<Dual<double>> answer;
    differentiate<double>(parts, x.shared, x.variables, x.inherited, input, answer);
    slope_of(answer, out);
  }
  [[nodiscard]] bool fits(std::span<const Row>, std::size_t a, Row i, std::size_t b, Row j) const override {
    if (a > b) return fits({}, b, j, a, i);
    if (a != 1 || b != 2) return true;
    return axis_.couplings[j].bore == axis_.motor_bore[i];
  }
  [[nodiscard]] FitKey fit_key(std::span<const Row> shared,
                               std::size_t slot,
                               Row row,
                               std::size_t other) const override {
    if (slot == 1 && other == 2) return {static_cast<double>(axis_.motor_bore[row]), 0.0};
    if (slot == 2 && other == 1) return {static_cast<double>(axis_.couplings[row].bore), 0.0};
    return Stage::fit_key(shared, slot, row, other);
  }

 private:
  [[nodiscard]] double voltage(std::span<const Row> shared) const {
    return shared.empty() ? 1.0 : axis_.voltage[shared[0]];
  }
  template <class T>
  [[nodiscard]] Parts<T> parts_of(Row i, Row j, Row k) const {
    const Screw& s = axis_.screws[i];
    const Motor& m = axis_.motors[j];
    const Coupling& c = axis_.couplings[k];
    return {s.root,
            s.lead,
            s.mass,
            s.inertia,
            m.torque,
            m.corner,
            m.inertia,
            m.mass + c.mass,
            s.price + m.price + c.price,
            m.power,
            c.torque};
  }
  template <class Row_, class Member>
  static Interval hull_of_column(const std::vector<Row_>& table, std::span<const Row> rows, Member member) {
    Interval all(table[rows[0]].*member);
    for (const Row row : rows) all = hull(all, Interval(table[row].*member));
    return all;
  }
  [[nodiscard]] Parts<Interval> hull_of(const Box& box) const {
    const auto s = [&](auto member) { return hull_of_column(axis_.screws, box.rows[0], member); };
    const auto m = [&](auto member) { return hull_of_column(axis_.motors, box.rows[1], member); };
    const auto c = [&](auto member) { return hull_of_column(axis_.couplings, box.rows[2], member); };
    return {s(&Screw::root),
            s(&Screw::lead),
            s(&Screw::mass),
            s(&Screw::inertia),
            m(&Motor::torque),
            m(&Motor::corner),
            m(&Motor::inertia),
            m(&Motor::mass) + c(&Coupling::mass),
            s(&Screw::price) + m(&Motor::price) + c(&Coupling::price),
            m(&Motor::power),
            c(&Coupling::torque)};
  }
  template <class D, class B>
  static Parts<D> lift(const Parts<B>& p) {
    return {D(p.root),
            D(p.lead),
            D(p.screw_mass),
            D(p.screw_inertia),
            D(p.torque),
            D(p.corner),
            D(p.motor_inertia),
            D(p.part_mass),
            D(p.price),
            D(p.power),
            D(p.coupling_torque)};
  }
  template <class B>
  void differentiate(const Parts<Dual<B>>& parts,
                     std::span<const Row> shared,
                     std::span<const B> variables,
                     std::span<const B> inherited,
                     Input input,
                     Answer<Dual<B>>& answer) const {
    const auto pick = [&](Input::Kind kind, std::size_t index, const B& value) {
      return input.kind == kind && input.index == index ? Dual<B>::variable(value, 0) : Dual<B>(value);
    };
    const Dual<B> time = pick(Input::Kind::variable, 0, variables[0]);
    const Dual<B> diameter = variables.size() > 1 ? pick(Input::Kind::variable, 1, variables[1]) : Dual<B>(B(0.0));
    const Dual<B> mass = pick(Input::Kind::inherited, 0, inherited[0]);
    const Dual<B> power = pick(Input::Kind::inherited, 1, inherited[1]);
    if (axis_.only_shaft) return shaft_answer(axis_, time, mass, power, answer);
    answer_of(axis_, voltage(shared), parts, time, diameter, mass, power, answer);
  }
  template <class B>
  static void slope_of(const Answer<Dual<B>>& from, Answer<B>& to) {
    const auto copy = [](const std::vector<Dual<B>>& a, std::vector<B>& b) {
      b.clear();
      for (const Dual<B>& x : a) b.push_back(x.slope[0]);
    };
    copy(from.utilisation, to.utilisation);
    copy(from.resources, to.resources);
    copy(from.handed_on, to.handed_on);
  }

  std::string name_ = "axis";
  Axis axis_;
  std::vector<Slot> slots_;
  std::vector<Variable> variables_;
};

/// What kinds of structure a stack may have.
struct StackSize {
  int stages = 2;
  int screws = 3, motors = 3, couplings = 2;
};

struct Stack {
  std::vector<std::unique_ptr<AxisStage>> axes;
  Problem problem;
  bool monotone = true;  ///< no ballast, no helping gravity
  bool priced = false;   ///< some diameter is free
};

inline double uniform(std::mt19937& rng, double a, double b) {
  return a + (b - a) * static_cast<double>(rng()) / 4294967296.0;
}

inline Screw random_screw(std::mt19937& rng, double length) {
  const double d = uniform(rng, 0.007, 0.02);
  const double mass = density * std::numbers::pi / 4.0 * d * d * length * uniform(rng, 0.6, 1.6);
  const double precision = uniform(rng, 0.5, 2.0);
  return {d, uniform(rng, 0.002, 0.016), mass, mass * d * d / 8.0, (5.0 + 2500.0 * d * std::sqrt(d)) * precision};
}

inline Motor random_motor(std::mt19937& rng) {
  const double torque = std::exp(uniform(rng, std::log(0.15), std::log(4.0)));
  const double dense = uniform(rng, -0.8, 0.8);  // light motors are dear
  return {torque,
          uniform(rng, 60.0, 220.0),
          2.2e-5 * std::pow(torque, 1.1) * std::exp(-0.2 * dense),
          2.2 * std::pow(torque, 0.8) * std::exp(-1.3 * dense),
          (5.0 + 22.0 * torque) * std::exp(0.15 * dense),
          20.0 + 25.0 * torque};
}

inline Axis random_axis(std::mt19937& rng, const StackSize& size, bool top) {
  Axis axis;
  axis.stroke = uniform(rng, 0.1, 0.5);
  axis.length = axis.stroke + 0.15;
  axis.move_time = axis.stroke / uniform(rng, 0.08, 0.25);
  axis.time_high = std::min(0.5, 0.5 * axis.move_time);
  axis.carriage = uniform(rng, 0.1, 0.4);
  axis.force = uniform(rng, 1.0, 12.0);
  axis.friction = uniform(rng, 0.01, 0.1);
  axis.gravity = top && rng() % 3 == 0 ? 1.0 : 0.0;
  for (int i = 0; i < size.screws; ++i) axis.screws.push_back(random_screw(rng, axis.length));
  for (int i = 0; i < size.motors; ++i) {
    axis.motors.push_back(random_motor(rng));
    axis.motor_bore.push_back(static_cast<int>(rng() % 2));
  }
  for (int i = 0; i < size.couplings; ++i) {
    axis.couplings.push_back({std::exp(uniform(rng, std::log(0.1), std::log(3.0))),
                              uniform(rng, 0.01, 0.1),
                              uniform(rng, 3.0, 12.0),
                              static_cast<int>(rng() % 2)});
  }
  return axis;
}

/// Gives an axis of two or three a cheaper but much heavier twin of its motors: what looks cheapest there makes the
/// axes below dear. The axes below get a ladder of motors, each just a little stronger.
inline void couple(std::mt19937& rng, Axis& axis, bool last) {
  if (!last) {
    for (Motor& motor : axis.motors) {
      if (&motor == &axis.motors.front()) continue;
      motor = axis.motors.front();
      motor.mass *= uniform(rng, 2.0, 7.0);
      motor.price *= uniform(rng, 0.9, 0.99);
    }
    std::fill(axis.motor_bore.begin(), axis.motor_bore.end(), 0);
  } else {
    axis.gravity = uniform(rng, 0.5, 1.0);
    axis.deflection = 0.0;
    const double base = uniform(rng, 0.4, 1.0);
    for (std::size_t i = 0; i < axis.motors.size(); ++i) {
      Motor& motor = axis.motors[i];
      motor.torque = base * (1.0 + 0.9 * static_cast<double>(i));
      motor.inertia = 1e-4 * (1.0 + static_cast<double>(i));
      motor.price = 10.0 + 25.0 * motor.torque;
      motor.mass = motor.torque;
      axis.motor_bore[i] = 0;
    }
  }
  for (Coupling& coupling : axis.couplings) {
    coupling.bore = 0;
    coupling.torque *= 3.0;
  }
}

/// A random stack. The features follow from the seed.
inline Stack random_stack(unsigned seed) {
  std::mt19937 rng(seed);
  Stack stack;
  const auto draw = rng() % 9;
  const int stages = draw == 0 ? 1 : draw < 6 ? 2 : 3;
  StackSize size{stages, 3, 3, 2};
  if (stages == 1) size = {1, 5, 6, 3};
  if (stages == 3) size = {3, 2, 3, 2};
  const bool coupled = stages > 1 && rng() % 8 != 0;
  const bool voltage = rng() % 4 == 0;
  const bool limited = rng() % 5 == 0;
  const auto variant = rng() % 6;  // 0: ballast, 1: gravity helps
  stack.monotone = variant > 1;
  std::vector<double> voltages{1.0};
  if (voltage) voltages = {0.8, 1.0, 1.3};
  const double power_limit = rng() % 5 == 0 ? uniform(rng, 40.0, 60.0 + 80.0 * stages) : 1e9;
  for (int i = 0; i < stages; ++i) {
    Axis axis = random_axis(rng, size, i == 0);
    axis.voltage = voltages;
    axis.power_limit = power_limit;
    const bool last = i + 1 == stages;
    if (rng() % 4 == 0 && (stack.monotone || last)) {
      axis.deflection = uniform(rng, 2e-5, 4e-4);
      stack.priced = true;
    }
    if (variant == 0 && i > 0) axis.least_ratio = uniform(rng, 0.1, 1.5);
    if (variant == 1 && i > 0) axis.gravity = -uniform(rng, 0.2, 1.0);
    if (coupled && variant != 1) {
      const bool priced = axis.deflection > 0.0;
      couple(rng, axis, last);
      if (priced && axis.deflection == 0.0) axis.deflection = uniform(rng, 2e-5, 4e-4);
    }
    stack.axes.push_back(std::make_unique<AxisStage>(std::move(axis)));
    stack.problem.stages.push_back(stack.axes.back().get());
  }
  if (voltage) stack.problem.shared.push_back({"voltage", 3});
  stack.problem.first_state = {uniform(rng, 0.0, 0.5), 0.0};
  const double infinity = std::numeric_limits<double>::infinity();
  const double limit = limited ? uniform(rng, 1.0, 2.0 + 2.0 * stages) : infinity;
  stack.problem.resources = {{"cost", infinity}, {"mass", limit}, {"power", infinity}};
  return stack;
}

}  // namespace zoo
