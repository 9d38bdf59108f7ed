// SPDX-License-Identifier: Apache-2.0
//
// Ramps that decide how many steps of power a drive takes, and nothing else that is handed on (least_state.h): the best
// ramp of a design against a closed formula, and optima and fronts against every build with its best ramps.
//
// A drive of strength s that moves a load m in a ramp of time t:
//     (0.5 m/t + 0.2 m)/s <= 1,  t/longest <= 1,  power = whole steps of p0 + a m/t + b t.
// So t >= 0.5 m/(s - 0.2 m), and the power is least at sqrt(a m/b) or at the nearer end of what is left.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/front_of.h"
#include "solver/least_state.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace moved_state_test {

namespace {

using namespace millwright::solver;
using zoo::front_of;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double shortest = 0.05, longest = 2.0;  // s, of every variable
constexpr std::size_t machines = millwright::sanitized ? 8 : 120;

enum State : std::size_t { mass, power, state_size };
enum Frame : std::size_t { frame_price, frame_mass };
enum Drive : std::size_t {
  drive_price,
  drive_mass,
  drive_strength,
  drive_longest,
  drive_power,
  drive_work,
  drive_loss
};
enum Supply : std::size_t { supply_price, supply_mass, supply_power };

struct Parameters {
  double step = 1.0;  ///< of power
  double sign = 1.0;  ///< -1: what is left of a budget is handed on, more is better
};

/// Steps of a drive with the best ramp; infinity where none will do.
double least_steps(const double* drive, double load, const Parameters& p) {
  const double spare = drive[drive_strength] - 0.2 * load;
  if (spare <= 0.0) return infinity;
  const double from = std::max(0.5 * load / spare, shortest), to = std::min(drive[drive_longest], longest);
  if (from > to) return infinity;
  const double best = std::clamp(std::sqrt(drive[drive_work] * load / drive[drive_loss]), from, to);
  return std::ceil((drive[drive_power] + drive[drive_work] * load / best + drive[drive_loss] * best) / p.step);
}

class Machine {
 public:
  explicit Machine(unsigned seed) : rng_(seed) {
    parameters.step = uniform(0.5, 4.0);
    parameters.sign = seed % 3 == 1 ? -1.0 : 1.0;
    const std::size_t axes = 1 + rng_() % 3;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      frames.push_back(table("frame", 2, [&](std::vector<double>& row) {
        const double size = uniform(1.0, 4.0);
        row = {price(20.0 / size), size};
      }));
      drives.push_back(table("drive", 7, [&](std::vector<double>& row) {
        const double size = uniform(1.0, 6.0);
        row = {price(4.0 * size * uniform(0.7, 1.4)),
               0.4 * size * uniform(0.7, 1.4),
               4.0 * size,
               uniform(0.1, 1.5),
               uniform(2.0, 6.0) * size,
               uniform(0.05, 2.0),
               uniform(1.0, 20.0)};
      }));
      const auto drive = [p = parameters](const auto& in, auto& out) {
        using millwright::scalar::floor_of;
        const auto load = in.state(mass) + in.row(0, frame_mass);
        const auto& t = in.variable(0);
        out.utilisation.push_back((0.5 * load / t + 0.2 * load) / in.row(1, drive_strength));
        out.utilisation.push_back(t / in.row(1, drive_longest));
        out.resources.push_back(in.row(0, frame_price) + in.row(1, drive_price));
        out.resources.push_back(in.row(0, frame_mass) + in.row(1, drive_mass));
        out.handed_on.push_back(load + in.row(1, drive_mass));
        const auto taken = in.row(1, drive_power) + in.row(1, drive_work) * load / t + in.row(1, drive_loss) * t;
        out.handed_on.push_back(in.state(power) - p.sign * p.step * floor_of(-taken / p.step));
      };
      add(model_stage("drive", {frames.back(), drives.back()}, {{"ramp", shortest, longest}}, 2, drive));
    }
    supplies = table("supply", 3, [&](std::vector<double>& row) {
      const double share = uniform(0.2, 1.2);
      row = {price(20.0 * share), 2.0 * share * uniform(0.8, 1.2), share * 40.0 * static_cast<double>(axes)};
    });
    add(model_stage("supply", {supplies}, {}, 1, [p = parameters](const auto& in, auto& out) {
      out.utilisation.push_back(p.sign * in.state(power) / in.row(0, supply_power));
      out.resources.push_back(in.row(0, supply_price));
      out.resources.push_back(in.row(0, supply_mass));
      for (std::size_t i = 0; i < state_size; ++i) out.handed_on.push_back(in.state(i));
    }));
    problem.first_state = {uniform(0.5, 3.0), 0.0};
    problem.resources = {{"cost"}, {"mass"}};
  }

  Problem problem;
  Parameters parameters;
  std::vector<const Columns*> frames, drives;
  const Columns* supplies = nullptr;

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(rng_); }
  /// In whole numbers now and then, so that there are ties.
  double price(double value) { return rng_() % 3 == 0 ? std::ceil(value) : value; }

  template <class Fill>
  const Columns* table(const char* name, std::size_t width, Fill&& fill) {
    Columns& columns = *tables_.emplace_back(std::make_unique<Columns>());
    columns = {name, width, {}};
    const std::size_t rows = 3 + rng_() % 4;
    for (std::size_t i = 0; i < rows; ++i) {
      std::vector<double> row;
      fill(row);
      columns.numbers.insert(columns.numbers.end(), row.begin(), row.end());
    }
    return &columns;
  }
  template <class ModelStage>
  void add(ModelStage stage) {
    problem.stages.push_back(stages_.emplace_back(std::make_unique<ModelStage>(std::move(stage))).get());
  }

  std::mt19937 rng_;
  std::vector<std::unique_ptr<Columns>> tables_;
  std::vector<std::unique_ptr<Stage>> stages_;
};

struct Total {
  double cost = 0.0, mass = 0.0;
};

/// Of every build that complies with some ramps.
std::vector<Total> totals_of(const Machine& machine) {
  std::vector<Total> totals;
  const auto walk = [&](auto&& self, std::size_t axis, double load, double steps, Total sum) -> void {
    if (axis == machine.drives.size()) {
      for (Row row = 0; row < machine.supplies->rows(); ++row) {
        const double* supply = machine.supplies->row(row);
        if (steps * machine.parameters.step <= supply[supply_power] * (1.0 + 1e-12))
          totals.push_back({sum.cost + supply[supply_price], sum.mass + supply[supply_mass]});
      }
      return;
    }
    for (Row f = 0; f < machine.frames[axis]->rows(); ++f)
      for (Row d = 0; d < machine.drives[axis]->rows(); ++d) {
        const double* frame = machine.frames[axis]->row(f);
        const double* drive = machine.drives[axis]->row(d);
        const double moved = load + frame[frame_mass];
        const double own = least_steps(drive, moved, machine.parameters);
        if (own == infinity) continue;
        self(self,
             axis + 1,
             moved + drive[drive_mass],
             steps + own,
             {sum.cost + frame[frame_price] + drive[drive_price], sum.mass + frame[frame_mass] + drive[drive_mass]});
      }
  };
  walk(walk, 0, machine.problem.first_state[mass], 0.0, {});
  return totals;
}

/// Evaluated anew, stage by stage with its own ramps, it complies and hands on what is said, and its totals add up.
void complies(const Problem& problem, const Build& build) {
  std::vector<double> state = problem.first_state;
  std::vector<double> sum(problem.resources.size(), 0.0);
  Answer<double> answer;
  double worst = 0.0;
  for (std::size_t i = 0; i < problem.stages.size(); ++i) {
    const StageChoice& choice = build.stages[i];
    CHECK(choice.inherited == state);
    problem.stages[i]->evaluate({build.shared, state, choice.rows, choice.variables}, answer);
    for (const double u : answer.utilisation) worst = std::max(worst, u);
    for (std::size_t r = 0; r < sum.size(); ++r) sum[r] += answer.resources[r];
    state = answer.handed_on;
  }
  CHECK(worst <= 1.0);
  CHECK(build.worst_utilisation == Approx(worst).epsilon(1e-12));
  CHECK(build.resources == sum);
}

}  // namespace

TEST_CASE("The least that a design hands on is that of its best ramp, at one state and over a range") {
  std::size_t found = 0, none = 0, universal = 0, exact = 0;
  for (unsigned seed = 0; seed < static_cast<unsigned>(machines); ++seed) {
    const Machine machine(seed);
    Options options;
    const Criteria criteria = make_criteria(machine.problem, options);
    Desk desk;
    const std::vector<StagePlan> plans = make_plans(machine.problem, {}, criteria, desk);
    if (plans.empty()) continue;
    const StagePlan& plan = plans.front();

    REQUIRE(plan.moved_state == State::power);
    const double sign = machine.parameters.sign, step = machine.parameters.step;
    for (const Row f : plan.region.rows[0]->all())
      for (const Row d : plan.region.rows[1]->all()) {
        INFO("seed " << seed << ", rows " << f << " " << d);
        const std::vector<Row> rows{f, d};
        const std::vector<Interval> whole{Interval(shortest, longest)};
        const Region region = region_of(*plan.stage, plan.shared, rows, whole);
        const auto truth = [&](double carried) {
          const double load = carried + machine.frames[0]->row(f)[frame_mass];
          return step * least_steps(machine.drives[0]->row(d), load, machine.parameters);
        };
        const double carried = machine.problem.first_state[mass];
        std::vector<double> ramp;
        const std::vector<double> state{carried, 0.0};
        const LeastPoint point = find_least_point(plan, state, region, {}, ramp, desk);
        REQUIRE(point != LeastPoint::undecided);
        CHECK((point == LeastPoint::infeasible) == (truth(carried) == infinity));
        if (point == LeastPoint::found) {
          ++found;
          const auto& answer = desk.evaluate(*plan.stage, Point{plan.shared, state, rows, ramp});
          CHECK(worst_of(answer.utilisation) <= 1.0);
          CHECK(sign * answer.handed_on[power] == Approx(truth(carried)).epsilon(1e-12));
        } else {
          ++none;
        }
        for (const double width : {0.003, 0.1, 0.6}) {
          const std::vector<Interval> range{Interval(carried, carried * (1.0 + width)), Interval(-5.0, 2.0)};
          const LeastState over = find_least_state(plan, range, region, {}, 60, desk);
          const double shift = sign > 0.0 ? 5.0 : 2.0;  // what has been handed on before, at its best
          for (int i = 0; i <= 20; ++i) {
            const double here = truth(carried * (1.0 + width * i / 20.0));
            if (here == infinity) CHECK(!over.universal());
            CHECK(over.least <= here - shift + 1e-9);
            if (over.universal()) CHECK(here <= over.most + (sign > 0.0 ? -2.0 : -5.0) + 1e-9);
          }
          universal += over.universal() ? 1 : 0;
          exact += over.universal() && over.most - over.least <= 7.0 + 1e-9 ? 1 : 0;
        }
      }
  }
  CHECK(found > 3 * machines);
  CHECK(none > machines / 4);
  CHECK(universal > 3 * machines);
  CHECK(exact > machines);
}

// In steps or not, of one component or of two, and with a price or without: one best value only where a drive hands on
// one figure in steps.
TEST_CASE("There is one best value only of a single figure that changes in steps") {
  enum class Kind { steps, evenly, both, priced };
  for (const Kind kind : {Kind::steps, Kind::evenly, Kind::both, Kind::priced}) {
    const auto drive = model_stage("drive", {}, {{"ramp", shortest, longest}}, 1, [kind](const auto& in, auto& out) {
      const auto& t = in.variable(0);
      const auto nothing = 0.0 * in.state(mass);
      using millwright::scalar::floor_of;
      const auto stepped = floor_of(8.0 * t);
      out.utilisation.push_back(0.1 / t);
      out.resources.push_back(kind == Kind::priced ? nothing + t : nothing + 0.0 * t);
      out.handed_on.push_back(in.state(mass) + (kind == Kind::both ? stepped : 0.0 * stepped));
      out.handed_on.push_back(in.state(power) + (kind == Kind::evenly ? 3.0 * t : stepped));
    });
    const auto end = model_stage("end", {}, {}, 2, [](const auto& in, auto& out) {
      out.utilisation.push_back(in.state(mass) / 20.0);
      out.utilisation.push_back(in.state(power) / 4.0);
      out.resources.push_back(0.0 * in.state(mass));
      for (std::size_t i = 0; i < state_size; ++i) out.handed_on.push_back(in.state(i));
    });
    const Problem problem{{}, {8.0, 0.0}, {&drive, &end}, {{"cost"}}};
    const Criteria criteria = make_criteria(problem, {});
    Desk desk;
    const std::vector<StagePlan> plans = make_plans(problem, {}, criteria, desk);
    INFO("kind " << static_cast<int>(kind));
    REQUIRE(plans.size() == 2);
    CHECK(plans[0].any_moves_outcome);
    CHECK(plans[0].moved_state.has_value() == (kind == Kind::steps));
    CHECK(is_covered(plans[0]) == (kind != Kind::steps));
    Options options;
    const Summary summary = solve(problem, options);
    REQUIRE(summary.status == Status::optimal);
    complies(problem, summary.builds.front());
  }
}

TEST_CASE("Optima and fronts of drives whose ramps decide their power are those of all builds") {
  std::size_t points = 0, infeasible = 0, bound_by_power = 0;
  for (unsigned seed = 0; seed < static_cast<unsigned>(machines); ++seed) {
    const Machine machine(seed);
    const std::vector<Total> totals = totals_of(machine);
    const std::vector<Total> front = front_of(totals);
    for (const int way : {0, 1, 2, 3}) {
      INFO("seed " << seed << ", way " << way);
      Options options;
      options.stagewise = way != 3;
      options.threads = way == 1 ? 2 : 1;
      if (way == 2) options.patience = options.stage_patience = 0;
      options.look_first = way < 2;
      if (way == 3) options.labels_together = 1 + seed % 3;
      for (std::size_t score = 0; score < 2; ++score) {
        options.objectives = {score};
        options.ties = {1 - score};
        const Summary summary = solve(machine.problem, options);
        REQUIRE(summary.status == (totals.empty() ? Status::infeasible : Status::optimal));
        infeasible += totals.empty() ? 1 : 0;
        if (totals.empty()) continue;
        const Total& expected = score == 0 ? front.front() : front.back();
        const Build& build = summary.builds.front();
        complies(machine.problem, build);
        CHECK(summary.gap <= 1e-12);
        CHECK(build.resources[0] == Approx(expected.cost).epsilon(1e-9));
        CHECK(build.resources[1] == Approx(expected.mass).epsilon(1e-9));
        const std::vector<double>& last = build.stages.back().inherited;
        const double given = machine.supplies->row(build.stages.back().rows[0])[supply_power];
        bound_by_power += machine.parameters.sign * last[power] > given - machine.parameters.step ? 1 : 0;
      }
      options.objectives = {0, 1};
      options.ties = {};
      const Summary summary = solve(machine.problem, options);
      CHECK(summary.front_tolerance == 0.0);
      REQUIRE(summary.builds.size() == front.size());
      for (std::size_t i = 0; i < front.size(); ++i) {
        ++points;
        complies(machine.problem, summary.builds[i]);
        CHECK(summary.builds[i].resources[0] == Approx(front[i].cost).epsilon(1e-9));
        CHECK(summary.builds[i].resources[1] == Approx(front[i].mass).epsilon(1e-9));
      }
    }
  }
  INFO(points << " points, " << infeasible << " infeasible, " << bound_by_power << " bound by power");
  CHECK(points > 10 * machines);
  CHECK((millwright::sanitized || infeasible > 0));
  CHECK(infeasible < machines);
  CHECK(bound_by_power > machines / 4);
}

}  // namespace moved_state_test
