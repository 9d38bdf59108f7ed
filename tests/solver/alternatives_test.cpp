// SPDX-License-Identifier: Apache-2.0
//
// The best, second best, ... builds of random stacks against all their builds (enumeration.h), sorted.
#include <algorithm>
#include <atomic>
#include <memory>
#include <set>

#include "catch.h"
#include "sanitized.h"
#include "solver/alternatives.h"
#include "solver/enumeration.h"
#include "solver/forwarding_stage.h"
#include "solver/row_worth.h"

namespace alternatives_test {

namespace {

using namespace zoo;

constexpr unsigned instances = millwright::sanitized ? 10 : 60;

Options by_cost(unsigned threads = 1) {
  Options options;
  options.objectives = {0};
  options.ties = {1};
  options.gap = 1e-7;
  options.confirm = false;
  options.threads = threads;
  return options;
}

bool same(double a, double b, double tolerance) { return std::fabs(a - b) <= tolerance * std::fabs(b); }

/// The stack with other axes.
template <class Change>
Stack changed(const Stack& stack, Change&& change) {
  Stack result;
  result.problem = stack.problem;
  result.problem.stages.clear();
  result.monotone = stack.monotone;
  result.priced = stack.priced;
  for (const auto& stage : stack.axes) {
    Axis axis = stage->axis();
    change(axis);
    result.axes.push_back(std::make_unique<AxisStage>(std::move(axis)));
    result.problem.stages.push_back(result.axes.back().get());
  }
  return result;
}

std::vector<Row> choices_of(const Build& build) {
  std::vector<Row> choices = build.shared;
  for (const StageChoice& stage : build.stages) choices.insert(choices.end(), stage.rows.begin(), stage.rows.end());
  return choices;
}

/// Feasible and worth what it says, evaluated from the first state on.
void check_build(const Stack& stack, const Build& build) {
  std::vector<double> state = stack.problem.first_state;
  std::vector<double> total(stack.problem.resources.size(), 0.0);
  Answer<double> answer;
  for (std::size_t i = 0; i < stack.axes.size(); ++i) {
    const StageChoice& choice = build.stages[i];
    stack.axes[i]->evaluate(Point{build.shared, state, choice.rows, choice.variables}, answer);
    for (const double u : answer.utilisation) REQUIRE(u <= 1.0);
    for (std::size_t r = 0; r < total.size(); ++r) total[r] += answer.resources[r];
    REQUIRE(stack.axes[i]->fits(build.shared, 1, choice.rows[1], 2, choice.rows[2]));
    state = answer.handed_on;
  }
  REQUIRE(total == build.resources);
  REQUIRE(total[1] <= stack.problem.resources[1].limit);
}

std::vector<Total> sorted(std::vector<Total> designs) {
  std::sort(designs.begin(), designs.end(), [](const Total& a, const Total& b) {
    return same(a.cost, b.cost, 1e-11) ? a.mass < b.mass : a.cost < b.cost;
  });
  return designs;
}

/// The first of `all`, sorted, all distinct; with one thread as with two.
void check_best(const Stack& stack,
                const std::vector<Total>& all,
                std::size_t count,
                const CoveringRows& covering = {}) {
  const Alternatives found = best_builds(stack.problem, by_cost(), count, covering);
  REQUIRE(found.status == (all.empty() ? Status::infeasible : Status::optimal));
  REQUIRE(found.builds.size() == std::min(count, all.size()));
  REQUIRE(found.proved == found.builds.size());
  std::set<std::vector<Row>> distinct;
  for (std::size_t i = 0; i < found.builds.size(); ++i) {
    const Build& build = found.builds[i];
    CAPTURE(i);
    REQUIRE(same(build.resources[0], all[i].cost, stack.priced ? 3e-7 : 1e-10));
    if (!stack.priced) REQUIRE(same(build.resources[1], all[i].mass, 1e-10));
    check_build(stack, build);
    REQUIRE(distinct.insert(choices_of(build)).second);
  }
  const Alternatives two = best_builds(stack.problem, by_cost(2), count, covering);
  REQUIRE(two.builds.size() == found.builds.size());
  REQUIRE(two.parts == found.parts);
  for (std::size_t i = 0; i < two.builds.size(); ++i) {
    REQUIRE(choices_of(two.builds[i]) == choices_of(found.builds[i]));
    REQUIRE(two.builds[i].resources == found.builds[i].resources);
  }
}

TEST_CASE("The best builds of random stacks are the first of all builds sorted") {
  unsigned tested = 0, priced = 0, several = 0, fewer = 0;
  for (unsigned seed = 1; tested < instances; ++seed) {
    const Stack stack = random_stack(seed);
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-9) continue;
    const std::size_t count = 1 + seed % 12;
    CAPTURE(seed, count);
    check_best(stack, sorted(all.designs), count);
    ++tested;
    priced += stack.priced ? 1 : 0;
    several += all.designs.size() > count && count > 2 ? 1 : 0;
    fewer += all.designs.size() < count && !all.designs.empty() ? 1 : 0;
  }
  CHECK(priced >= instances / 10);
  CHECK(several >= instances / 4);
  if (!millwright::sanitized) CHECK(fewer > 0);  // there are too few instances there
}

TEST_CASE("Builds of equal cost come in the order of their mass, none left out") {
  unsigned tested = 0, ties = 0;
  for (unsigned seed = 1; tested < instances / 4; ++seed) {
    const Stack plain = random_stack(seed);
    if (plain.priced) continue;
    // Whole multiples, so that many sums are the same.
    const Stack stack = changed(plain, [](Axis& axis) {
      const auto round = [](auto& parts, double step) {
        for (auto& part : parts) part.price = step * std::ceil(part.price / step);
      };
      round(axis.screws, 4.0);
      round(axis.motors, 16.0);
      round(axis.couplings, 4.0);
    });
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-9 || all.designs.size() < 6) continue;
    const std::vector<Total> order = sorted(all.designs);
    CAPTURE(seed);
    check_best(stack, order, 6);
    ++tested;
    for (std::size_t i = 1; i < 6; ++i) ties += order[i].cost == order[i - 1].cost ? 1 : 0;
  }
  CHECK(ties > tested);
}

TEST_CASE("Rows that another covers are looked at when their turn comes") {
  unsigned tested = 0;
  for (unsigned seed = 1; tested < instances / 8; ++seed) {
    const Stack plain = random_stack(seed);
    // Every motor twice more: the same, a little dearer each time.
    Row motors = 0;
    const Stack stack = changed(plain, [&](Axis& axis) {
      motors = static_cast<Row>(axis.motors.size());
      for (const double dearer : {0.5, 1.25})
        for (Row i = 0; i < motors; ++i) {
          axis.motors.push_back(axis.motors[i]);
          axis.motors.back().price += dearer;
          axis.motor_bore.push_back(axis.motor_bore[i]);
        }
    });
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-9 || all.designs.empty()) continue;
    const auto covering = [&](std::size_t, std::size_t slot, Row row) {
      std::vector<Row> better;
      if (slot == 1)
        for (Row by = row % motors; by < row; by += motors) better.push_back(by);
      return better;
    };
    CAPTURE(seed);
    check_best(stack, sorted(all.designs), 10, covering);
    ++tested;
  }
}

/// Sets a flag after so many questions.
class Stopping final : public zoo::ForwardingStage {
 public:
  Stopping(const Stage& inner, std::atomic<int>& left, std::atomic<bool>& stop)
      : zoo::ForwardingStage(inner), left_(left), stop_(stop) {}
  void bound(const Box& box, Answer<Interval>& out) const override {
    if (--left_ < 0) stop_ = true;
    zoo::ForwardingStage::bound(box, out);
  }

 private:
  std::atomic<int>& left_;
  std::atomic<bool>& stop_;
};

TEST_CASE("Stopped early, what is called proved is, and the rest are builds") {
  unsigned some = 0, none = 0;
  for (unsigned seed = 1; seed <= (millwright::sanitized ? 20U : 60U); ++seed) {
    const Stack stack = random_stack(seed);
    const Everything all = Enumeration(stack).run();
    if (all.margin < 1e-9 || all.designs.size() < 8) continue;
    const std::vector<Total> order = sorted(all.designs);
    for (const int questions : {100, 500, 2000, 8000}) {
      std::atomic<int> left = questions;
      std::atomic<bool> stop = false;
      std::vector<std::unique_ptr<Stopping>> stages;
      Problem problem = stack.problem;
      for (const Stage*& stage : problem.stages) {
        stages.push_back(std::make_unique<Stopping>(*stage, left, stop));
        stage = stages.back().get();
      }
      Options options = by_cost();
      options.stop = &stop;
      const Alternatives found = best_builds(problem, options, 8);
      CAPTURE(seed, questions);
      if (found.status == Status::optimal) {
        REQUIRE(found.proved == 8);
        continue;
      }
      REQUIRE(found.status == Status::limit);
      REQUIRE(found.proved <= found.builds.size());
      for (std::size_t i = 0; i < found.builds.size(); ++i) {
        check_build(stack, found.builds[i]);
        if (i < found.proved) REQUIRE(same(found.builds[i].resources[0], order[i].cost, stack.priced ? 3e-7 : 1e-10));
      }
      some += found.proved > 0 && found.proved < 8 ? 1 : 0;
      none += found.proved == 0 ? 1 : 0;
    }
  }
  CHECK(some > 2);
  CHECK(none > 2);
}

/// Counts questions, and says stop at one of them.
class Counted final : public ForwardingStage {
 public:
  struct Count {
    std::uint64_t asked = 0, stop_at = 0;
    std::atomic<bool> stop = false;
  };
  Counted(const Stage& stage, Count& count) : ForwardingStage(stage), count_(&count) {}
  void bound(const Box& box, Answer<Interval>& answer) const override {
    if (++count_->asked == count_->stop_at) count_->stop = true;
    inner_.bound(box, answer);
  }

 private:
  Count* count_;
};

TEST_CASE("With a certain row no build is worth less than is said, and nothing is said when time is up") {
  constexpr std::uint64_t asked_between = 256;
  constexpr unsigned seeds = 30;
  unsigned builds = 0, stopped = 0, fewer = 0;
  std::size_t dearer = 0, together = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Stack stack = random_stack(seed);
    Counted::Count count;
    std::vector<std::unique_ptr<Counted>> stages;
    Problem problem = stack.problem;
    for (const Stage*& stage : problem.stages) {
      stages.push_back(std::make_unique<Counted>(*stage, count));
      stage = stages.back().get();
    }
    Options options = by_cost();
    options.stop = &count.stop;
    std::uint64_t evaluations = 0;
    CAPTURE(seed);
    const std::vector<RowWorth> worths = row_worths(problem, options, infinity, evaluations);
    const std::uint64_t asked = count.asked;
    for (const Build& build : best_builds(stack.problem, by_cost(), 6, {}).builds) {
      const auto worth =
          std::find_if(worths.begin(), worths.end(), [&](const RowWorth& each) { return each.shared == build.shared; });
      REQUIRE(worth != worths.end());
      const double most = build.resources[0] * (1.0 + 1e-9);
      REQUIRE(worth->least <= most);
      for (std::size_t i = 0; i < build.stages.size(); ++i)
        for (std::size_t slot = 0; slot < build.stages[i].rows.size(); ++slot)
          REQUIRE(worth->rows[i][slot][build.stages[i].rows[slot]] <= most);
      ++builds;
      // Known to this worth: rows up to it as before, of dearer ones only that they are dearer.
      count.asked = 0;
      const std::vector<RowWorth> up_to = row_worths(problem, options, build.resources[0], evaluations);
      REQUIRE(up_to.size() == worths.size());
      for (std::size_t n = 0; n < worths.size(); ++n)
        for (std::size_t i = 0; i < worths[n].rows.size(); ++i)
          for (std::size_t slot = 0; slot < worths[n].rows[i].size(); ++slot)
            for (std::size_t row = 0; row < worths[n].rows[i][slot].size(); ++row) {
              const double before = worths[n].rows[i][slot][row], now = up_to[n].rows[i][slot][row];
              REQUIRE(now <= before);
              const bool is_dear = now > build.resources[0] * (1.0 + 1e-12);
              REQUIRE((is_dear || now == before));
              dearer += is_dear ? 1 : 0;
              together += now < before ? 1 : 0;
            }
      fewer += count.asked < asked ? 1 : 0;
    }
    if (asked < 4 * asked_between) continue;
    count.stop_at = 1 + asked / 3;
    count.asked = 0;
    REQUIRE(row_worths(problem, options, infinity, evaluations).empty());
    REQUIRE(count.asked <= count.stop_at + asked_between);
    ++stopped;
  }
  CHECK(builds > seeds);
  CHECK(stopped > 2);
  INFO(dearer << " " << together << " " << fewer);
  CHECK(dearer > 1000);
  CHECK(together > 100);
  CHECK(fewer > builds / 2);
}

TEST_CASE("The best builds need one objective") {
  const Stack stack = random_stack(1);
  Options options;
  options.objectives = {0, 1};
  CHECK_THROWS_AS(best_builds(stack.problem, options, 3), std::invalid_argument);
}

}  // namespace

}  // namespace alternatives_test
