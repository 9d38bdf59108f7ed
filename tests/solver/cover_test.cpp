// SPDX-License-Identifier: Apache-2.0
// What an inexact label leaves undecided (cover.h): of one stage whose least cost and power are known by hand.
#include "solver/cover.h"

#include <cmath>

#include "catch.h"
#include "solver/model_stage.h"
#include "solver/solver.h"

namespace cover_test {

namespace {

using namespace millwright::solver;

/// A choice of loads, 1 or 2, that the stage under test takes over, and a supply that reads its power.
template <class Model>
class Trial {
 public:
  Trial(Variable variable, std::size_t constraints, const Model& model)
      : under_test_("under test", {&only_}, {std::move(variable)}, constraints, model) {
    problem_.first_state = {0.0, 0.0};
    problem_.stages = {&loads_, &under_test_, &supply_};
    problem_.resources = {{"cost"}, {"energy"}};
    Options options;
    options.objectives = {0, 1};
    criteria_ = make_criteria(problem_, options);
    plans_ = make_plans(problem_, {}, criteria_, desk);
    REQUIRE(plans_.size() == 3);
    REQUIRE(is_covered(plans_[1]));
  }

  /// For a label of this load, which stands for all loads from another one on.
  LeafAnswer answer(double load, double from, double tolerance) {
    Label label = first_label(problem_, criteria_);
    label.stage = 1;
    label.state = {load, 0.0};
    label.enclosure = {{from, load}, {0.0, 0.0}};
    label.exact = load == from;
    const std::vector<Row> rows{0};
    const Region region = region_of(under_test_, {}, rows, plans_[1].region.variables);
    return solve_leaf({.plan = &plans_[1], .label = &label, .region = &region, .tolerance = tolerance}, desk);
  }

  Desk desk;

 private:
  struct TakeLoad {
    template <class Input, class Answer>
    void operator()(const Input& in, Answer& out) const {
      out.resources.push_back(3.0 - in.row(0, 0));
      out.resources.push_back(0.0 * in.row(0, 0));
      out.handed_on.push_back(in.row(0, 0));
      out.handed_on.push_back(in.state(1));
    }
  };
  struct Supply {
    template <class Input, class Answer>
    void operator()(const Input& in, Answer& out) const {
      out.utilisation.push_back((in.state(0) + in.state(1)) / in.row(0, 0));
      out.resources.push_back(in.row(0, 0));
      out.resources.push_back(0.0 * in.row(0, 0));
      for (std::size_t i = 0; i < 2; ++i) out.handed_on.push_back(in.state(i));
    }
  };
  Columns choices_{"load", 1, {1.0, 2.0}}, only_{"only", 1, {1.0}}, supplies_{"supply", 1, {2.0, 14.5, 40.0}};
  ModelStage<TakeLoad> loads_{"load", {&choices_}, {}, 0, {}};
  ModelStage<Model> under_test_;
  ModelStage<Supply> supply_{"supply", {&supplies_}, {}, 1, {}};
  Problem problem_;
  Criteria criteria_;
  std::vector<StagePlan> plans_;
};

/// A drive takes 12 watts for each unit of load, in whole ones, and with a ramp t 3 - t joules: best is the longest.
struct WholeWatts {
  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using millwright::scalar::floor_of;
    const auto& ramp = in.variable(0);
    out.utilisation.push_back(in.state(0) / (8.0 * ramp));
    out.resources.push_back(in.row(0, 0));
    out.resources.push_back(3.0 - ramp);
    out.handed_on.push_back(in.state(0));
    out.handed_on.push_back(in.state(1) - floor_of(-12.0 * in.state(0)));
  }
};

/// A rod of diameter d bears a load of d, and costs d^20.
struct SteepPrice {
  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    const auto& diameter = in.variable(0);
    const auto fourth = diameter * diameter * diameter * diameter;
    const auto tenth = fourth * fourth * diameter * diameter;
    out.utilisation.push_back(in.state(0) / diameter);
    out.resources.push_back(in.row(0, 0) * tenth * tenth);
    out.resources.push_back(in.row(0, 0) * diameter);
    out.handed_on.push_back(in.state(0));
    out.handed_on.push_back(in.state(1));
  }
};

}  // namespace

TEST_CASE("Boxes in which only the label decides are left undecided at once") {
  constexpr double tolerance = 2e-3;
  Trial<WholeWatts> trial({"ramp", 0.5, 1.0}, 1, {});
  for (const auto& [load, watts] : {std::pair{1.0, 12.0}, {1.0 + 1e-7, 13.0}}) {
    const LeafAnswer exact = trial.answer(load, load, tolerance);
    CHECK_FALSE(exact.undecided);
    REQUIRE(exact.points.size() == 1);
    CHECK(exact.points[0].state[1] == watts);
    CHECK(exact.points[0].resources[1] == Approx(2.0).epsilon(tolerance));
  }
  const std::uint64_t before = trial.desk.bounds + trial.desk.evaluations;
  const LeafAnswer inexact = trial.answer(1.0 + 1e-7, 1.0, tolerance);
  REQUIRE(inexact.undecided);
  CHECK(inexact.undecided_score[1] == Approx(2.0).epsilon(tolerance));
  REQUIRE(inexact.points.size() == 1);
  CHECK(inexact.points[0].state[1] == 13.0);
  // To divide them until the limit of boxes is reached takes some hundred thousand.
  CHECK(trial.desk.bounds + trial.desk.evaluations - before < 10000);
}

TEST_CASE("What an inexact label moves by some tolerances its best point stands for") {
  Trial<SteepPrice> trial({"diameter", 0.5, 3.0}, 1, {});
  constexpr double tolerance = 1e-5;
  const auto cost = [](double load) { return std::pow(load, 20.0); };
  // The label's loads differ by so many tolerances in cost; a point may be 16 worse.
  for (const double tolerances : {0.0, 0.5, 3.0, 12.0, 40.0}) {
    const double load = 1.5, from = load * (1.0 - tolerances * tolerance / 20.0);
    CAPTURE(tolerances);
    const LeafAnswer answer = trial.answer(load, from, tolerance);
    CHECK(answer.undecided == (tolerances > 16.0));
    REQUIRE(!answer.points.empty());
    double least = answer.points[0].score_lower[0], best = answer.points[0].resources[0];
    for (const StagePoint& point : answer.points) {
      least = std::min(least, point.score_lower[0]);
      best = std::min(best, point.resources[0]);
      CHECK(point.resources[0] >= cost(load) * (1.0 - 1e-12));  // feasible with the label's own load
    }
    CHECK(best <= cost(load) * (1.0 + 2.0 * tolerance));
    // Nothing that the label stands for costs less than is said.
    if (answer.undecided) least = std::min(least, answer.undecided_score[0]);
    CHECK(least <= cost(from) * (1.0 + 1e-12));
    CHECK(least >= cost(from) * (1.0 - 20.0 * tolerance));
  }
}

}  // namespace cover_test
