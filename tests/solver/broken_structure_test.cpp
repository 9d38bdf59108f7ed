// SPDX-License-Identifier: Apache-2.0
//
// Variants of the stack family that break its structure (benchmark/broken_models.h), small ones: optimum and front
// against trying everything (broken_enumeration.h).
#include "catch.h"
#include "sanitized.h"
#include "solver/broken_enumeration.h"
#include "solver/front_of.h"

namespace broken_structure_test {

namespace {

using namespace stack::broken;
using namespace millwright::solver;
using zoo::front_of;

/// How many instances of a variant were compared, and of these had no design at all.
struct Tally {
  int compared = 0, infeasible = 0, binding = 0;
};

bool close(double a, double b, double tolerance) { return std::fabs(a - b) <= tolerance * std::fabs(b); }

/// A build is what it says, by the enumeration's own reckoning.
Total checked(Enumeration& everything, const Build& build) {
  const auto total = everything.judge(build);
  REQUIRE(total.has_value());
  REQUIRE(close(build.resources[0], total->cost, 1e-9));
  REQUIRE(close(build.resources[1], total->mass, 1e-9));
  if (build.resources.size() > 2) REQUIRE(close(build.resources[2], total->budget, 1e-9));
  return *total;
}

void compare(const stack::Instance& instance, Variant variant, const Columns& belts, double share, Tally& tally) {
  const Surroundings given = surroundings(instance, variant, belts, share);
  Enumeration everything(instance, variant, belts, given);
  everything.run();
  const bool free = variant == Variant::free_diameter;
  if (!free && everything.margin < 1e-9) return;  // on the edge rounding decides
  const Stack stack(instance, variant, belts, given);
  Options options;
  options.gap = 1e-7;
  options.confirm = false;
  const Summary cheapest = solve(stack.problem, options);
  options.objectives = {1};
  const Summary lightest = solve(stack.problem, options);
  options.objectives = {0, 1};
  const Summary front = solve(stack.problem, options);
  ++tally.compared;
  if (everything.designs.empty()) {
    ++tally.infeasible;
    // On a grid of ramps a free diameter may be missed: then what is found must stand by itself.
    if (!free || cheapest.builds.empty()) {
      REQUIRE(cheapest.status == Status::infeasible);
      REQUIRE(lightest.status == Status::infeasible);
      REQUIRE(front.status == Status::infeasible);
      return;
    }
  }
  REQUIRE(cheapest.status == Status::optimal);
  REQUIRE(lightest.status == Status::optimal);
  REQUIRE(front.status == Status::optimal);
  const std::vector<Total> exact = front_of(everything.designs);
  const double least_cost = checked(everything, cheapest.builds.front()).cost;
  const double least_mass = checked(everything, lightest.builds.front()).mass;
  for (const Build& build : front.builds) checked(everything, build);
  if (exact.empty()) return;
  // What the search returns is a design; so it is right as soon as nothing that was tried is better, and without a
  // free diameter everything was tried.
  const double tolerance = free ? 2e-7 : 1e-9;
  REQUIRE(least_cost <= exact.front().cost * (1.0 + tolerance));
  REQUIRE(least_mass <= exact.back().mass * (1.0 + tolerance));
  REQUIRE(cheapest.lower_bound <= least_cost * (1.0 + 1e-12));
  const double spacing = free ? 1.001e-3 : 1e-9;
  for (const Total& point : exact) {
    REQUIRE(std::any_of(front.builds.begin(), front.builds.end(), [&](const Build& build) {
      return build.resources[0] <= point.cost * (1.0 + spacing) && build.resources[1] <= point.mass * (1.0 + spacing);
    }));
  }
  if (free) return;
  REQUIRE(close(least_cost, exact.front().cost, tolerance));
  REQUIRE(close(least_mass, exact.back().mass, tolerance));
  REQUIRE(front.builds.size() == exact.size());
}

/// Without the variant's extra: to see that it decides something.
double plain_cost(const stack::Instance& instance) {
  const stack::Machine machine(instance);
  const Summary found = solve(machine.problem, {});
  return found.builds.empty() ? 0.0 : found.builds.front().resources[0];
}

struct Size {
  int axes, screws, motors, belts;
};

Tally compare_many(Variant variant, const Size& size, unsigned seeds, double share = 1.0) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= (millwright::sanitized ? (seeds + 7) / 8 : seeds); ++seed) {
    CAPTURE(seed, size.axes);
    const stack::Instance instance = stack::random_instance(size.axes, size.screws, size.motors, seed);
    const Columns belts = random_belts(size.belts, seed);
    compare(instance, variant, belts, share, tally);
    const Stack stack(instance, variant, belts, surroundings(instance, variant, belts, share));
    const Summary found = solve(stack.problem, {});
    const double cost = found.builds.empty() ? 0.0 : found.builds.front().resources[0];
    tally.binding += cost != plain_cost(instance) ? 1 : 0;
  }
  UNSCOPED_INFO(tally.compared << " compared, " << tally.infeasible << " infeasible, " << tally.binding << " binding");
  return tally;
}

void check_tally(const Tally& tally, unsigned seeds) {
  const int expected = static_cast<int>(millwright::sanitized ? seeds / 16 : seeds / 2);
  CHECK(tally.compared >= expected);
  CHECK(tally.compared - tally.infeasible >= expected / 2);
  if (!millwright::sanitized) CHECK(tally.binding >= expected / 8);
}

}  // namespace

TEST_CASE("Broken structure: a shared supply with a power budget is solved as by trying everything") {
  check_tally(compare_many(Variant::shared_supply, {2, 8, 8, 0}, 60, 0.9), 60);
  check_tally(compare_many(Variant::shared_supply, {3, 7, 7, 0}, 30, 0.9), 30);
}

TEST_CASE("Broken structure: the same motor at a discount is solved as by trying everything") {
  check_tally(compare_many(Variant::same_motor, {2, 7, 7, 0}, 60), 60);
  check_tally(compare_many(Variant::same_motor, {3, 7, 7, 0}, 30), 30);
}

TEST_CASE("Broken structure: a resonance band is solved as by trying everything") {
  check_tally(compare_many(Variant::resonance, {2, 8, 8, 0}, 80), 80);
  check_tally(compare_many(Variant::resonance, {3, 7, 7, 0}, 30), 30);
}

TEST_CASE("Broken structure: a least inertia ratio is solved as by trying everything") {
  check_tally(compare_many(Variant::least_inertia, {2, 8, 8, 0}, 80), 80);
  check_tally(compare_many(Variant::least_inertia, {3, 7, 7, 0}, 30), 30);
}

TEST_CASE("Broken structure: belts between motor and screw are solved as by trying everything") {
  check_tally(compare_many(Variant::belt, {2, 4, 4, 4}, 40), 40);
}

TEST_CASE("Broken structure: three load cases are solved as by trying everything") {
  check_tally(compare_many(Variant::several_loads, {2, 6, 6, 0}, 40), 40);
}

TEST_CASE("Broken structure: an error budget is solved as by trying everything") {
  check_tally(compare_many(Variant::error_budget, {2, 8, 8, 0}, 60, 0.7), 60);
  check_tally(compare_many(Variant::error_budget, {3, 7, 7, 0}, 30, 0.9), 30);
}

TEST_CASE("Broken structure: free screw diameters are as good as any that were tried") {
  check_tally(compare_many(Variant::free_diameter, {2, 3, 3, 0}, 24), 24);
}

/// The front as least costs under limits of mass, which another search finds.
void compare_with_limits(const Stack& stack, const std::vector<Build>& front) {
  constexpr double within = 1.0 + 1e-3 + 1e-5;
  for (const std::size_t place : {front.size() / 5, front.size() / 2, 4 * front.size() / 5}) {
    Problem limited = stack.problem;
    limited.resources[1].limit = front[place].resources[1] * (1.0 + 1e-4);
    const Summary cheapest = solve(limited, {});
    REQUIRE(cheapest.status == Status::optimal);
    CAPTURE(place, cheapest.builds[0].resources[0], front[place].resources[0]);
    CHECK(cheapest.builds[0].resources[0] <= front[place].resources[0] * (1.0 + 1e-6));
    CHECK(std::any_of(front.begin(), front.end(), [&](const Build& build) {
      return build.resources[0] <= cheapest.builds[0].resources[0] * within &&
             build.resources[1] <= cheapest.builds[0].resources[1] * within;
    }));
  }
}

// Designs of these are feasible only just where they are best, and what an inexact label stands for moves that.
TEST_CASE("Broken structure: fronts with free screw diameters come to an end") {
  struct Instance {
    int screws, motors;
    std::uint64_t seed;
  };
  std::vector<Instance> instances{{60, 20, 299}};
  if (!millwright::sanitized)
    for (const Instance& more :
         {Instance{60, 20, 127}, {60, 20, 377}, {200, 50, 64}, {200, 50, 219}, {200, 50, 338}, {200, 50, 348}})
      instances.push_back(more);
  for (const Instance& each : instances) {
    CAPTURE(each.screws, each.seed);
    const stack::Instance instance = stack::random_instance(3, each.screws, each.motors, each.seed);
    const Columns none = random_belts(0, each.seed);
    const Surroundings given = surroundings(instance, Variant::free_diameter, none, 1.0);
    const Stack stack(instance, Variant::free_diameter, none, given);
    Options options;
    options.objectives = {0, 1};
    const Summary front = solve(stack.problem, options);
    REQUIRE(front.status == Status::optimal);
    Enumeration everything(instance, Variant::free_diameter, none, given);
    for (const Build& build : front.builds) checked(everything, build);
    compare_with_limits(stack, front.builds);
  }
}

}  // namespace broken_structure_test
