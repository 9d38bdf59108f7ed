// SPDX-License-Identifier: Apache-2.0
// Models as stages, on stacks of axes: against every pair of rows worked in plain numbers.
#include "solver/model_stage.h"

#include <random>

#include "benchmark/stack_instance.h"
#include "catch.h"
#include "sanitized.h"

namespace model_stage_test {

namespace {

using namespace millwright::solver;
using millwright::scalar::Interval;

/// Least worst utilisation of an axis with this screw and motor that carries `above`, over the ramp time: every
/// constraint written out once more, the ramp on a fine grid.
double worst_of_pair(
    const stack::Instance& instance, const stack::Axis& a, std::uint32_t screw, std::uint32_t motor, double above) {
  const double* s = instance.screws.row(screw);
  const double* q = instance.motors.row(motor);
  const double pi = 3.14159265358979323846;
  const double m = above + a.carriage, l = s[1], dr = s[2], ms = s[4] * a.length;
  const double screw_inertia = ms * std::pow((s[0] + dr) / 4.0, 2) / 2.0;
  const double force = a.force + m * 9.81 * (a.friction + a.gravity);
  const double second_moment = pi * std::pow(dr, 4) / 64.0;
  double least = 1e9;
  constexpr int grid = 4000;
  for (int i = 0; i <= grid; ++i) {
    const double t = a.shortest_ramp() + (a.longest_ramp() - a.shortest_ramp()) * i / grid;
    const double v = a.stroke / (a.move_time - t), acceleration = v / t;
    const double omega = v * 2.0 * pi / l, alpha = acceleration * 2.0 * pi / l;
    const double load = screw_inertia + m * std::pow(l / (2.0 * pi), 2);
    const double torque = force * l / (2.0 * pi * s[3]) + load * alpha;
    const double critical = 3.927 * 3.927 / (2.0 * pi * a.length * a.length) *
                            std::sqrt(206e9 * second_moment / (7850.0 * pi * dr * dr / 4.0));
    least = std::min(
        least,
        std::max({(torque + q[2] * alpha) / (0.7 * q[0] / (1.0 + std::pow(omega / q[1], 2))),
                  load / q[2] / 10.0,
                  v / l / (0.8 * critical),
                  (force + m * acceleration) / (0.5 * 2.0 * pi * pi * 206e9 * second_moment / (a.length * a.length)),
                  torque * a.length / (79e9 * pi * std::pow(dr, 4) / 32.0) / a.largest_twist,
                  16.0 * torque / (pi * std::pow(dr, 3)) / a.largest_shear}));
  }
  return least;
}

struct Total {
  double cost, mass;
};

/// All builds of two axes; nothing where some pair is too close to its limit to be judged on a grid.
std::optional<std::vector<Total>> all_builds(const stack::Instance& instance) {
  std::vector<Total> builds;
  const auto pairs = [&](const stack::Axis& axis, double above) -> std::optional<std::vector<Total>> {
    std::vector<Total> feasible;
    for (std::uint32_t s = 0; s < instance.screws.rows(); ++s)
      for (std::uint32_t q = 0; q < instance.motors.rows(); ++q) {
        const double worst = worst_of_pair(instance, axis, s, q, above);
        if (std::fabs(worst - 1.0) < 1e-4) return std::nullopt;
        if (worst > 1.0) continue;
        const double* screw = instance.screws.row(s);
        const double* motor = instance.motors.row(q);
        feasible.push_back({screw[5] + screw[6] * axis.length + motor[4], screw[4] * axis.length + motor[3]});
      }
    return feasible;
  };
  const auto upper = pairs(instance.axes[0], 0.0);
  if (!upper) return std::nullopt;
  for (const Total& above : *upper) {
    const auto lower = pairs(instance.axes[1], instance.axes[0].carriage + above.mass);
    if (!lower) return std::nullopt;
    for (const Total& below : *lower) builds.push_back({above.cost + below.cost, above.mass + below.mass});
  }
  return builds;
}

}  // namespace

TEST_CASE("Stacks of two axes are solved as by trying every pair") {
  int compared = 0, infeasible = 0;
  for (std::uint64_t seed = 0; seed < (millwright::sanitized ? 8U : 40U); ++seed) {
    const stack::Instance instance = stack::random_instance(2, 4, 4, seed);
    const auto builds = all_builds(instance);
    if (!builds) continue;
    const stack::Machine machine(instance);
    const Summary found = solve(machine.problem, {});
    INFO("seed " << seed << ", " << builds->size() << " builds");
    if (builds->empty()) {
      CHECK(found.status == Status::infeasible);
      ++infeasible;
      continue;
    }
    ++compared;
    double least = 1e9;
    for (const Total& build : *builds) least = std::min(least, build.cost);
    REQUIRE(found.status == Status::optimal);
    CHECK(found.builds.front().resources[0] == Approx(least).epsilon(1e-9));
    Options both;
    both.objectives = {0, 1};
    const Summary front = solve(machine.problem, both);
    REQUIRE(front.status == Status::optimal);
    // Two motors that change places may give the same sums in another order.
    constexpr double same = 1e-9;
    std::vector<Total> points;
    for (const Total& build : *builds) {
      const bool beaten = std::any_of(builds->begin(), builds->end(), [&](const Total& other) {
        return other.cost <= build.cost + same && other.mass <= build.mass + same &&
               (other.cost < build.cost - same || other.mass < build.mass - same);
      });
      const bool known = std::any_of(points.begin(), points.end(), [&](const Total& other) {
        return std::fabs(other.cost - build.cost) < same && std::fabs(other.mass - build.mass) < same;
      });
      if (beaten || known) continue;
      points.push_back(build);
      CHECK(std::any_of(front.builds.begin(), front.builds.end(), [&](const Build& b) {
        return std::fabs(b.resources[0] - build.cost) < same && std::fabs(b.resources[1] - build.mass) < same;
      }));
    }
    CHECK(front.builds.size() == points.size());
  }
  CHECK(compared >= (millwright::sanitized ? 2 : 10));
  CHECK(infeasible + compared >= 3);
}

TEST_CASE("Bounds of a model contain its answers, with rows read beforehand or not") {
  const stack::Instance instance = stack::random_instance(1, 30, 30, 7);
  const stack::Machine machine(instance);
  const Stage& stage = *machine.problem.stages.front();
  std::mt19937 random(3);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int n = 0; n < 2000; ++n) {
    std::vector<std::vector<Row>> rows(2);
    std::vector<std::vector<Interval>> readings(2);
    std::vector<RowsAlive> read, unread;
    for (std::size_t slot = 0; slot < 2; ++slot) {
      for (Row row = 0; row < 30; ++row)
        if (share() < 0.2 || (row == 29 && rows[slot].empty())) rows[slot].push_back(row);
      stage.read({}, slot, rows[slot], readings[slot]);
    }
    for (std::size_t slot = 0; slot < 2; ++slot) {
      read.emplace_back(rows[slot], readings[slot]);
      unread.emplace_back(rows[slot]);
    }
    const double ramp = 0.03 + 0.1 * share(), mass = share();
    const std::vector<Interval> time{Interval(ramp, ramp * (1.0 + share()))}, state{Interval(mass, mass + share())};
    Answer<Interval> bounds, same, slopes;
    stage.bound({{}, state, read, time}, bounds);
    stage.bound({{}, state, unread, time}, same);
    stage.slopes({{}, state, read, time}, {Input::Kind::inherited, 0}, slopes);
    REQUIRE(bounds.utilisation.size() == stage.constraints());
    const std::vector<Row> chosen{rows[0][random() % rows[0].size()], rows[1][random() % rows[1].size()]};
    const std::vector<double> t{time[0].lower + share() * (time[0].upper - time[0].lower)};
    const std::vector<double> light{state[0].lower}, heavy{state[0].upper};
    Answer<double> at_light, at_heavy, slope;
    stage.evaluate({{}, light, chosen, t}, at_light);
    stage.evaluate({{}, heavy, chosen, t}, at_heavy);
    stage.gradient({{}, light, chosen, t}, {Input::Kind::inherited, 0}, slope);
    for (std::size_t i = 0; i < bounds.utilisation.size(); ++i) {
      REQUIRE(bounds.utilisation[i].lower == same.utilisation[i].lower);
      REQUIRE(bounds.utilisation[i].upper == same.utilisation[i].upper);
      REQUIRE(contains(bounds.utilisation[i], at_light.utilisation[i]));
      REQUIRE(contains(bounds.utilisation[i], at_heavy.utilisation[i]));
      REQUIRE(contains(slopes.utilisation[i], slope.utilisation[i]));
      // More to carry never helps.
      REQUIRE(at_heavy.utilisation[i] >= at_light.utilisation[i]);
      const double secant = (at_heavy.utilisation[i] - at_light.utilisation[i]) / (heavy[0] - light[0]);
      REQUIRE(secant >= slopes.utilisation[i].lower - 1e-9 * std::fabs(secant));
      REQUIRE(secant <= slopes.utilisation[i].upper + 1e-9 * std::fabs(secant));
    }
  }
}

TEST_CASE("A model sees what all stages share") {
  // Two sizes of a rod that pulls 1000 N; the shared choice is its material: twice as strong at three times the price.
  const Columns rods{"rod", 2, {400.0, 1.0, 900.0, 2.0}};  // strength [N], price
  const auto stage = model_stage("rod", {&rods}, {}, 1, [](const auto& in, auto& out) {
    const double material = in.shared(0) == 1 ? 2.0 : 1.0;
    out.utilisation.push_back(1000.0 / (in.row(0, 0) * material));
    out.resources.push_back(in.row(0, 1) * (material == 2.0 ? 3.0 : 1.0));
    out.handed_on.push_back(in.state(0));
  });
  Problem problem;
  problem.shared = {{"material", 2}};
  problem.first_state = {0.0};
  problem.stages = {&stage};
  problem.resources = {{"price"}};
  const Summary found = solve(problem, {});
  REQUIRE(found.status == Status::optimal);
  // 900 N are too few of the weak material, 2 * 400 N of the strong one too; 2 * 900 N cost 3 * 2.
  CHECK(found.builds.front().shared == std::vector<Row>{1});
  CHECK(found.builds.front().stages.front().rows == std::vector<Row>{1});
  CHECK(found.builds.front().resources.front() == 6.0);
}

TEST_CASE("Of equally light designs of free thickness the cheapest is taken") {
  // Plates of one density and price by the kilogram, in two sizes of screw that weigh the same; only the price differs.
  const Columns plates{"plate", 2, {2.0, 9.0, 2.0, 4.0, 2.0, 7.0, 3.0, 1.0}};  // density, price
  const Columns screws{"screw", 2, {0.5, 3.0, 0.5, 2.0, 0.5, 5.0}};            // mass, price
  const auto stage =
      model_stage("plate", {&plates, &screws}, {{"thickness", 1.0, 4.0}}, 1, [](const auto& in, auto& out) {
        const auto& thickness = in.variable(0);
        out.utilisation.push_back(4.0 / (thickness * thickness));
        out.resources.assign({in.row(0, 1) + in.row(1, 1), in.row(0, 0) * thickness + in.row(1, 0)});
        out.handed_on.push_back(in.state(0));
      });
  Problem problem;
  problem.first_state = {0.0};
  problem.stages = {&stage};
  problem.resources = {{"price"}, {"mass"}};
  Options options;
  options.objectives = {1};
  options.ties = {0};
  const Summary found = solve(problem, options);
  REQUIRE(found.status == Status::optimal);
  // 2 thick: 2 * 2 + 0.5; of the light plates the second, of the screws too.
  CHECK(found.builds.front().resources[1] == Approx(4.5).epsilon(1e-5));
  CHECK(found.builds.front().resources[0] == 6.0);
  CHECK(found.builds.front().stages.front().rows == std::vector<Row>{1, 1});
}

TEST_CASE("A model with more slots than it may have is refused") {
  const Columns table{"part", 1, {1.0}};
  const auto model = [](const auto&, auto&) {};
  CHECK_THROWS_AS(model_stage("m", std::vector<const Columns*>(9, &table), {}, 0, model), std::invalid_argument);
}

}  // namespace model_stage_test
