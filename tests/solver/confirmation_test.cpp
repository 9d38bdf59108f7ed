// SPDX-License-Identifier: Apache-2.0
//
// A bar with free width w and height h: the deflections in its two planes are A/(w h^3) and B/(h w^3), their resultant
// is limited, the cost is w h. With the area q = w h and t = h^4 the square of the resultant is A^2/(q^2 t) + B^2
// t/q^6; its least over t is 2 A B/q^4, at t = A q^2/B. So the least area is q = (2 A B)^(1/4)/sqrt(limit), at h =
// (A/B)^(1/4) sqrt(q): inside both ranges, on a curved edge, with no single variable at its end.
#include "solver/confirmation.h"

#include <cmath>

#include "catch.h"
#include "scalar/dual.h"
#include "solver/solver.h"

namespace confirmation_test {

namespace {

using namespace millwright::solver;
using millwright::scalar::Dual;
using millwright::scalar::Interval;

class Bar final : public Stage {
 public:
  Bar(double vertical, double lateral, double limit) : vertical_(vertical), lateral_(lateral), limit_(limit) {}
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::span<const Slot> slots() const override { return {}; }
  [[nodiscard]] std::span<const Variable> variables() const override { return variables_; }
  [[nodiscard]] std::size_t constraints() const override { return 1; }
  void evaluate(const Point& p, Answer<double>& out) const override { answer<double>(p.variables, p.inherited, out); }
  void bound(const Box& b, Answer<Interval>& out) const override { answer<Interval>(b.variables, b.inherited, out); }
  void slopes(const Box& b, Input input, Answer<Interval>& out) const override {
    differentiate<Interval>(b.variables, b.inherited, input, out);
  }
  void gradient(const Point& p, Input input, Answer<double>& out) const override {
    differentiate<double>(p.variables, p.inherited, input, out);
  }
  [[nodiscard]] double least_area() const { return std::pow(2.0 * vertical_ * lateral_, 0.25) / std::sqrt(limit_); }
  [[nodiscard]] double best_height() const { return std::pow(vertical_ / lateral_, 0.25) * std::sqrt(least_area()); }

 private:
  template <class T>
  void answer(std::span<const T> x, std::span<const T> state, Answer<T>& out) const {
    using millwright::scalar::cube;
    using millwright::scalar::sqrt;
    using millwright::scalar::square;
    const T vertical = vertical_ / (x[0] * cube(x[1]));
    const T lateral = lateral_ / (x[1] * cube(x[0]));
    out.utilisation.assign(1, sqrt(square(vertical) + square(lateral)) / limit_);
    out.resources.assign(1, x[0] * x[1]);
    out.handed_on.assign(1, state[0] + x[0] * x[1]);
  }
  template <class B>
  void differentiate(std::span<const B> x, std::span<const B> state, Input input, Answer<B>& out) const {
    using D = Dual<B>;
    std::vector<D> variables;
    for (const B& value : x) variables.emplace_back(value);
    std::vector<D> inherited{D(state[0])};
    (input.kind == Input::Kind::variable ? variables : inherited)[input.index].slope[0] = B(1.0);
    Answer<D> duals;
    answer<D>(variables, inherited, duals);
    const auto take = [](const auto& from, auto& to) {
      to.clear();
      for (const auto& value : from) to.push_back(value.slope[0]);
    };
    take(duals.utilisation, out.utilisation);
    take(duals.resources, out.resources);
    take(duals.handed_on, out.handed_on);
  }

  double vertical_, lateral_, limit_;
  std::string name_ = "bar";
  std::vector<Variable> variables_{{"width", 0.2, 20.0}, {"height", 0.2, 20.0}};
};

bool near(double a, double b, double tolerance) { return std::fabs(a - b) <= tolerance * std::fabs(b); }

TEST_CASE("A bar of free width and height has the area derived by hand and both local solvers agree") {
  for (const auto& [vertical, lateral, limit] : {std::tuple{4.0, 1.0, 0.5}, {1.0, 3.0, 0.2}, {9.0, 0.3, 0.05}}) {
    const Bar bar(vertical, lateral, limit);
    Problem problem;
    problem.first_state = {0.0};
    problem.stages = {&bar};
    problem.resources = {{"cost"}};
    const Summary summary = solve(problem, Options{});
    CAPTURE(vertical, lateral, limit, summary.evaluations, summary.seconds, summary.method);
    REQUIRE(summary.status == Status::optimal);
    CHECK(summary.gap <= 1e-6);
    CHECK(summary.lower_bound <= bar.least_area() * (1.0 + 1e-12));
    CHECK(near(summary.builds[0].resources[0], bar.least_area(), 1e-6));
    REQUIRE(summary.confirmations.size() == 1);
    const Confirmation& c = summary.confirmations[0];
    CHECK(c.stage == 0);
    CHECK(near(c.objective, bar.least_area(), 1e-6));
    CHECK(near(c.objective_by_ipopt, bar.least_area(), 1e-6));
    CHECK(near(c.objective_by_nlopt, bar.least_area(), 1e-6));
    CHECK(near(c.variables_by_ipopt[1], bar.best_height(), 1e-3));
    CHECK(near(c.variables_by_nlopt[1], bar.best_height(), 1e-3));
    CHECK(summary.method.find("Ipopt ends at") != std::string::npos);
  }
}

TEST_CASE("A limit on the objective that is closer to its least than the tolerance leaves a design") {
  const Bar bar(2.0, 0.5, 1.7), other(1.0, 1.5, 2.2);
  const double least = bar.least_area() + other.least_area();
  Problem problem;
  problem.stages = {&bar, &other};
  problem.first_state = {0.0};
  for (const double above : {1e-7, 1e-9, 1e-10, 1e-11}) {
    const double limit = least * (1.0 + above);
    problem.resources = {{"area", limit}};
    const Summary within = solve(problem, Options{});
    INFO("above: " << above << ", seconds: " << within.seconds);
    CHECK(within.status != Status::infeasible);
    CHECK(within.lower_bound <= limit);
    if (above >= 1e-7) REQUIRE(within.status == Status::optimal);
    for (const Build& build : within.builds) CHECK(build.resources[0] <= limit);
  }
  problem.resources = {{"area", least * (1.0 - 1e-7)}};
  const Summary beyond = solve(problem, Options{});
  CHECK(beyond.builds.empty());
  CHECK(beyond.status == Status::infeasible);
}

}  // namespace

}  // namespace confirmation_test
