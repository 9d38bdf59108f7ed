// SPDX-License-Identifier: Apache-2.0
//
// A made-up machine of real size, to see how the search scales: three drive stages with seven slots of catalogue size
// (about 250 screws, 40 nuts, 174 motors, 41 drivers, 36 couplings, 35 and 26 supports) and an acceleration time, then
// a stage that chooses the supply. The state is the load of each axis and the power drawn so far. The catalogues are
// seeded random numbers in the proportions of real ones: sizes and bores in steps, prices that follow size with noise.
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

namespace zoo::large {

using millwright::scalar::Dual;
using millwright::scalar::Interval;
using namespace millwright::solver;

/// One row of any table: what it costs and weighs, its size in steps, and up to six numbers of its own.
struct Part {
  double price = 0.0, mass = 0.0;
  int size = 0, bore = 0;
  double number[6] = {0, 0, 0, 0, 0, 0};
};
using Table = std::vector<Part>;

struct Catalogue {
  Table screws, nuts, motors, drivers, couplings, fixed, free, supplies;
};

class Random {
 public:
  explicit Random(unsigned seed) : rng_(seed) {}
  double between(double a, double b) { return a + (b - a) * static_cast<double>(rng_()) / 4294967296.0; }
  double around(double x, double factor) { return x * std::exp(between(-std::log(factor), std::log(factor))); }
  int upto(int n) { return static_cast<int>(rng_() % static_cast<unsigned>(n)); }

 private:
  std::mt19937 rng_;
};

inline double rounded_price(double price) { return std::round(price * 100.0) / 100.0; }

inline Catalogue random_catalogue(unsigned seed, int copies = 1) {
  Random random(seed);
  Catalogue c;
  const double diameters[] = {0.008, 0.010, 0.012, 0.016, 0.020, 0.025, 0.032};
  const double leads[] = {0.002, 0.004, 0.005, 0.008, 0.010, 0.016, 0.020};
  for (int i = 0; i < 250 * copies; ++i) {  // root, lead, efficiency, mass per length, price per length
    const int size = random.upto(7);
    const double d = diameters[size];
    const double lead = leads[random.upto(7)];
    const bool ball = random.upto(2) == 0;
    const double per_length = random.around((20.0 + 4000.0 * d) * (ball ? 2.2 : 1.0), 1.4);
    c.screws.push_back({rounded_price(random.around(10.0, 1.5)),
                        0.0,
                        size,
                        0,
                        {d * random.between(0.75, 0.9),
                         lead,
                         ball ? 0.9 : random.between(0.3, 0.7),
                         7850.0 * 0.7 * d * d * random.between(0.8, 1.1),
                         per_length,
                         0}});
  }
  for (int i = 0; i < 40 * copies; ++i) {  // axial capacity
    const int size = i % 7;
    const double d = diameters[size];
    c.nuts.push_back({rounded_price(random.around(8.0 + 1500.0 * d, 1.5)),
                      random.around(20.0 * d, 1.4),
                      size,
                      0,
                      {random.around(3e5 * d, 2.0)}});
  }
  for (int i = 0; i < 174 * copies; ++i) {  // torque, corner speed at 1 A, inertia, current
    const double torque = std::exp(random.between(std::log(0.2), std::log(12.0)));
    const int bore = torque < 0.6 ? 0 : torque < 2.5 ? random.upto(2) : torque < 6 ? 2 : 3;
    c.motors.push_back({rounded_price(random.around(10.0 + 12.0 * torque, 1.3)),
                        random.around(0.5 * std::pow(torque, 0.8), 1.2),
                        bore,
                        bore,
                        {torque,
                         random.around(110.0, 1.5),
                         2e-5 * random.around(std::pow(torque, 1.1), 1.2),
                         random.between(1.0, 2.0) + 0.4 * torque}});
  }
  for (int i = 0; i < 41 * copies; ++i) {  // current
    const double current = random.between(1.2, 8.5);
    c.drivers.push_back({rounded_price(random.around(10.0 + 12.0 * current, 1.5)), 0.1, 0, 0, {current}});
  }
  for (int i = 0; i < 36 * copies; ++i) {  // torque
    const double torque = random.around(5.0, 4.0);
    c.couplings.push_back({rounded_price(random.around(5.0 + 0.6 * torque, 1.6)),
                           0.03 + 0.01 * torque,
                           random.upto(4),
                           random.upto(4),
                           {torque}});
  }
  for (int i = 0; i < 61 * copies; ++i) {  // axial capacity
    const int size = i % 6;
    const Part support{rounded_price(random.around(12.0 + 8.0 * size, 1.8)),
                       random.around(0.1 + 0.1 * size, 1.3),
                       size,
                       0,
                       {random.around(1500.0 * (1 + size), 1.5)}};
    (i < 35 * copies ? c.fixed : c.free).push_back(support);
  }
  for (int i = 0; i < 20; ++i)
    c.supplies.push_back({15.0 + 12.0 * i + random.between(0, 9), 0.4 + 0.1 * i, 0, 0, {60.0 + 60.0 * i}});
  return c;
}

struct Drive {
  std::size_t axis = 0;  ///< which load of the state it carries
  double stroke = 0.3, length = 0.5, move_time = 1.0, carriage = 2.0, force = 50.0, friction = 0.05, gravity = 0.0;
};

/// Sums and extremes over a set of rows, per number.
template <class T>
struct Numbers {
  T price, mass, root, lead, efficiency, per_length, price_per_length, nut_capacity, torque, corner, inertia, current,
      driver_current, coupling_torque, fixed_capacity, moving_mass;
};

template <class T>
void drive_answer(const Drive& drive, const Numbers<T>& n, const T& time, std::span<const T> state, Answer<T>& out) {
  using millwright::scalar::square;
  const double pi = std::numbers::pi;
  const double length = drive.length;
  const T mass = state[drive.axis] + drive.carriage + n.moving_mass;
  const T rest = drive.move_time - time;
  const T acceleration = drive.stroke / (time * rest);
  const T speed = drive.stroke / rest;
  const T r = (2.0 * pi) / n.lead;
  const T force = drive.force + mass * (9.81 * (drive.friction + drive.gravity));
  const T screw_mass = n.per_length * length;
  const T screw_inertia = screw_mass * square(n.root) / 7.0;
  const T inertia = screw_inertia + mass / square(r);
  const T steady = force / (r * n.efficiency);
  const T torque = steady + (inertia + n.inertia) * acceleration * r;
  const T thrust = force + mass * acceleration;
  const T root4 = square(square(n.root));
  const double whirl = 3.927 * 3.927 / (2.0 * pi * length * length) * std::sqrt(206e9 / 7850.0) / 4.0;
  auto& u = out.utilisation;
  u.clear();
  u.push_back(torque * (1.0 + square(speed * r / n.corner)) / (0.7 * n.torque));
  u.push_back(inertia / (10.0 * n.inertia));
  u.push_back(speed / n.lead / (0.8 * whirl * n.root));
  u.push_back(thrust / (206e9 * pi * pi * pi / 64.0 / (length * length) * root4));
  u.push_back(steady * length / (79e9 * pi / 32.0 * root4) / 0.01);
  u.push_back(16.0 * steady / (pi * square(n.root) * n.root) / 40e6);
  u.push_back(thrust / n.nut_capacity);
  u.push_back(thrust / n.fixed_capacity);
  u.push_back(n.current / n.driver_current);
  u.push_back(torque / n.coupling_torque);
  u.push_back(speed / 1.0);
  u.push_back(speed * r / 300.0);
  const T own = n.mass + screw_mass;
  out.resources.assign({n.price + n.price_per_length * length, own});
  out.handed_on.assign(state.begin(), state.end());
  for (std::size_t axis = drive.axis + 1; axis + 1 < state.size(); ++axis) {
    out.handed_on[axis] = out.handed_on[axis] + own + drive.carriage;
  }
  out.handed_on.back() = out.handed_on.back() + n.current * 12.0;
}

class DriveStage final : public Stage {
 public:
  enum SlotIndex { screw, nut, motor, driver, coupling, fixed, free_end, count };

  DriveStage(const Catalogue& catalogue, const Drive& drive) : drive_(drive) {
    tables_ = {&catalogue.screws,
               &catalogue.nuts,
               &catalogue.motors,
               &catalogue.drivers,
               &catalogue.couplings,
               &catalogue.fixed,
               &catalogue.free};
    const char* names[] = {"screw", "nut", "motor", "driver", "coupling", "support_fixed", "support_free"};
    for (std::size_t s = 0; s < count; ++s) slots_.push_back({names[s], static_cast<Row>(tables_[s]->size())});
    variables_ = {{"acceleration_time", 0.02, std::min(0.5, 0.5 * drive.move_time)}};
  }
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::span<const Slot> slots() const override { return slots_; }
  [[nodiscard]] std::span<const Variable> variables() const override { return variables_; }
  [[nodiscard]] std::size_t constraints() const override { return 12; }
  void evaluate(const Point& x, Answer<double>& out) const override {
    drive_answer<double>(drive_,
                         numbers<double>([&](std::size_t s, auto get) { return get((*tables_[s])[x.rows[s]]); }),
                         x.variables[0],
                         x.inherited,
                         out);
  }
  void bound(const Box& box, Answer<Interval>& out) const override {
    drive_answer<Interval>(drive_, hulls(box), box.variables[0], box.inherited, out);
  }
  void slopes(const Box& box, Input input, Answer<Interval>& out) const override {
    differentiate<Interval>(hulls(box), box.variables, box.inherited, input, out);
  }
  void gradient(const Point& x, Input input, Answer<double>& out) const override {
    differentiate<double>(numbers<double>([&](std::size_t s, auto get) { return get((*tables_[s])[x.rows[s]]); }),
                          x.variables,
                          x.inherited,
                          input,
                          out);
  }
  [[nodiscard]] bool fits(std::span<const Row>, std::size_t a, Row i, std::size_t b, Row j) const override {
    if (a > b) return fits({}, b, j, a, i);
    const Part& left = (*tables_[a])[i];
    const Part& right = (*tables_[b])[j];
    if (a == screw && b == nut) return left.size == right.size;
    if (a == motor && b == coupling) return left.bore == right.bore;
    if (a == screw && b == coupling) return right.size <= left.size;
    if (a == screw && (b == fixed || b == free_end)) return right.size <= left.size && right.size + 3 > left.size;
    return true;
  }

 private:
  /// `get(slot, read)` gives the number that `read` takes from the slot's row, or its hull over the rows.
  template <class T, class Get>
  [[nodiscard]] Numbers<T> numbers(Get get) const {
    const auto number = [&](std::size_t s, int i) { return get(s, [i](const Part& p) { return p.number[i]; }); };
    const auto price = [](const Part& p) { return p.price; };
    const auto mass = [](const Part& p) { return p.mass; };
    Numbers<T> n;
    n.price = get(screw, price);
    n.mass = get(nut, mass);
    n.moving_mass = n.mass;
    for (std::size_t s = 1; s < count; ++s) n.price = n.price + get(s, price);
    for (std::size_t s = 2; s < count; ++s) n.mass = n.mass + get(s, mass);
    n.root = number(screw, 0);
    n.lead = number(screw, 1);
    n.efficiency = number(screw, 2);
    n.per_length = number(screw, 3);
    n.price_per_length = number(screw, 4);
    n.nut_capacity = number(nut, 0);
    n.torque = number(motor, 0);
    n.corner = number(motor, 1);
    n.inertia = number(motor, 2);
    n.current = number(motor, 3);
    n.driver_current = number(driver, 0);
    n.coupling_torque = number(coupling, 0);
    n.fixed_capacity = number(fixed, 0);
    return n;
  }
  [[nodiscard]] Numbers<Interval> hulls(const Box& box) const {
    return numbers<Interval>([&](std::size_t s, auto read) {
      Interval all(read((*tables_[s])[box.rows[s][0]]));
      for (const Row row : box.rows[s]) {
        const double x = read((*tables_[s])[row]);
        all.lower = std::min(all.lower, x);
        all.upper = std::max(all.upper, x);
      }
      return all;
    });
  }
  template <class B>
  void differentiate(const Numbers<B>& n,
                     std::span<const B> variables,
                     std::span<const B> inherited,
                     Input input,
                     Answer<B>& out) const {
    using D = Dual<B>;
    const Numbers<D> lifted{D(n.price),
                            D(n.mass),
                            D(n.root),
                            D(n.lead),
                            D(n.efficiency),
                            D(n.per_length),
                            D(n.price_per_length),
                            D(n.nut_capacity),
                            D(n.torque),
                            D(n.corner),
                            D(n.inertia),
                            D(n.current),
                            D(n.driver_current),
                            D(n.coupling_torque),
                            D(n.fixed_capacity),
                            D(n.moving_mass)};
    std::vector<D> state(inherited.begin(), inherited.end());
    D time(variables[0]);
    D& with_respect_to = input.kind == Input::Kind::variable ? time : state[input.index];
    with_respect_to.slope[0] = B(1.0);
    Answer<D> answer;
    drive_answer<D>(drive_, lifted, time, state, answer);
    const auto copy = [](const std::vector<D>& from, std::vector<B>& to) {
      to.clear();
      for (const D& x : from) to.push_back(x.slope[0]);
    };
    copy(answer.utilisation, out.utilisation);
    copy(answer.resources, out.resources);
    copy(answer.handed_on, out.handed_on);
  }

  std::string name_ = "drive";
  Drive drive_;
  std::vector<const Table*> tables_;
  std::vector<Slot> slots_;
  std::vector<Variable> variables_;
};

class SupplyStage final : public Stage {
 public:
  explicit SupplyStage(const Catalogue& catalogue) : table_(&catalogue.supplies) {
    slots_ = {{"supply", static_cast<Row>(table_->size())}};
  }
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::span<const Slot> slots() const override { return slots_; }
  [[nodiscard]] std::span<const Variable> variables() const override { return {}; }
  [[nodiscard]] std::size_t constraints() const override { return 1; }
  void evaluate(const Point& x, Answer<double>& out) const override {
    const Part& p = (*table_)[x.rows[0]];
    out.utilisation.assign(1, x.inherited.back() / p.number[0]);
    out.resources.assign({p.price, p.mass});
    out.handed_on.assign(x.inherited.begin(), x.inherited.end());
  }
  void bound(const Box& box, Answer<Interval>& out) const override {
    const Part& first = (*table_)[box.rows[0][0]];
    Interval price(first.price);
    Interval mass(first.mass);
    Interval power(first.number[0]);
    for (const Row row : box.rows[0]) {
      price = hull(price, Interval((*table_)[row].price));
      mass = hull(mass, Interval((*table_)[row].mass));
      power = hull(power, Interval((*table_)[row].number[0]));
    }
    out.utilisation.assign(1, box.inherited.back() / power);
    out.resources.assign({price, mass});
    out.handed_on.assign(box.inherited.begin(), box.inherited.end());
  }
  void slopes(const Box& box, Input input, Answer<Interval>& out) const override {
    Interval power((*table_)[box.rows[0][0]].number[0]);
    for (const Row row : box.rows[0]) power = hull(power, Interval((*table_)[row].number[0]));
    const bool last = input.index + 1 == box.inherited.size();
    out.utilisation.assign(1, last ? 1.0 / power : Interval(0.0));
    out.resources.assign(2, Interval(0.0));
    out.handed_on.assign(box.inherited.size(), Interval(0.0));
    out.handed_on[input.index] = 1.0;
  }
  void gradient(const Point&, Input, Answer<double>&) const override {}

 private:
  std::string name_ = "supply";
  const Table* table_;
  std::vector<Slot> slots_;
};

struct Machine {
  Catalogue catalogue;
  std::vector<std::unique_ptr<Stage>> stages;
  Problem problem;
};

inline Machine random_machine(unsigned seed, int axes = 3, int copies = 1) {
  Machine machine;
  machine.catalogue = random_catalogue(seed, copies);
  Random random(seed + 1000);
  const double infinity = std::numeric_limits<double>::infinity();
  for (int i = 0; i < axes; ++i) {
    Drive drive;
    drive.axis = static_cast<std::size_t>(i);
    drive.stroke = random.between(0.15, 0.7);
    drive.length = drive.stroke + 0.15;
    drive.move_time = drive.stroke / random.between(0.08, 0.3);
    drive.carriage = random.between(1.0, 4.0);
    drive.force = random.between(10.0, 120.0);
    drive.gravity = i == 0 ? 1.0 : 0.0;
    machine.stages.push_back(std::make_unique<DriveStage>(machine.catalogue, drive));
  }
  machine.stages.push_back(std::make_unique<SupplyStage>(machine.catalogue));
  for (const auto& stage : machine.stages) machine.problem.stages.push_back(stage.get());
  machine.problem.first_state.assign(static_cast<std::size_t>(axes) + 1, 0.0);
  machine.problem.first_state[0] = 2.0;
  machine.problem.resources = {{"cost", infinity}, {"mass", infinity}};
  return machine;
}

}  // namespace zoo::large
