// SPDX-License-Identifier: Apache-2.0
// The benchmark against peers in a small size: its own parts agree with the search, and it survives what peers do.
#include <unistd.h>

#include <cstdlib>

#include "benchmark/peers/peer.h"
#include "benchmark/stack_instance.h"
#include "catch.h"

namespace peers_test {

namespace {

using namespace stack::peers;

Outcome asked(const stack::Instance& instance, const Table& table, const Peer& peer, double seconds) {
  return run_isolated(peer, {instance, table, seconds, {}});
}

}  // namespace

TEST_CASE("Brute force and the search agree on stacks, and the exact model accepts both") {
  int feasible = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const stack::Instance instance = stack::random_instance(seed % 2 == 0 ? 2 : 3, 12, 12, seed);
    const stack::Machine machine(instance);
    const auto best = millwright::solver::solve(machine.problem, {});
    const Table table = make_table(instance);
    CAPTURE(seed);
    const bool nothing =
        std::any_of(table.all.begin(), table.all.end(), [](const auto& pairs) { return pairs.empty(); });
    const Outcome outcome = asked(instance, table, brute_force(), 60.0);
    CHECK_FALSE(outcome.crashed);
    REQUIRE(outcome.design.has_value() == !best.builds.empty());
    if (best.builds.empty()) continue;
    CHECK_FALSE(nothing);
    ++feasible;
    CHECK(outcome.claimed);
    const Worth worth = worth_of(instance, *outcome.design);
    CHECK(worth.excess <= 1e-9);
    CHECK(best.status == millwright::solver::Status::optimal);
    CHECK(worth.cost == Approx(best.builds[0].resources[0]).epsilon(1e-9));
    Design own;
    for (const auto& choice : best.builds[0].stages)
      own.push_back({choice.rows[0], choice.rows[1], choice.variables[0]});
    CHECK(worth_of(instance, own).excess <= 0.0);
    CHECK(worth_of(instance, own).mass == Approx(best.builds[0].resources[1]).epsilon(1e-12));
  }
  CHECK(feasible >= 3);
}

TEST_CASE("What a pair can carry by the prepared table is what the model says, at its ramp and at every other") {
  const stack::Instance instance = stack::random_instance(1, 15, 15, 5);
  const stack::Machine machine(instance);
  const stack::Axis& axis = instance.axes[0];
  const Table table = make_table(instance);
  REQUIRE(table.all[0].size() >= 5);
  REQUIRE(table.useful[0].size() <= table.all[0].size());
  const auto worst = [&](const Pair& pair, double moved, double ramp) {
    millwright::solver::Answer<double> answer;
    const std::vector<double> above{moved - axis.carriage}, variables{ramp};
    const std::vector<std::uint32_t> rows{pair.screw, pair.motor};
    machine.problem.stages[0]->evaluate({{}, above, rows, variables}, answer);
    return *std::max_element(answer.utilisation.begin(), answer.utilisation.end());
  };
  for (const Pair& pair : table.all[0]) {
    const auto [ramp, capacity] = best_ramp(axis, instance.screws.row(pair.screw), instance.motors.row(pair.motor));
    CHECK(capacity == pair.capacity);
    CHECK(worst(pair, capacity * (1.0 - 1e-9), ramp) <= 1.0 + 1e-9);
    for (int i = 0; i <= 400; ++i) {
      const double other = axis.shortest_ramp() + (axis.longest_ramp() - axis.shortest_ramp()) * i / 400.0;
      CHECK(worst(pair, capacity * (1.0 + 1e-5), other) > 1.0);
    }
  }
}

TEST_CASE("A peer that crashes, hangs, or says something and then hangs is reported as such") {
  const stack::Instance instance = stack::random_instance(1, 2, 2, 1);
  const Table table = make_table(instance);
  const Peer crashes{"crashes", "", true, [](const Question&, const Report&) { _exit(9); }};
  const Outcome crashed = asked(instance, table, crashes, 5.0);
  CHECK(crashed.crashed);
  CHECK_FALSE(crashed.design.has_value());
  const Peer hangs{"hangs", "", true, [](const Question&, const Report& report) {
                     report.found({{1, 0, 0.25}});
                     while (true) sleep(1);
                   }};
  const Outcome stopped = asked(instance, table, hangs, 0.2);
  CHECK(stopped.stopped);
  CHECK_FALSE(stopped.crashed);
  CHECK_FALSE(stopped.claimed);
  REQUIRE(stopped.design.has_value());
  CHECK((*stopped.design)[0].screw == 1);
  CHECK((*stopped.design)[0].ramp == 0.25);
  const Peer claims{"claims", "", true, [](const Question&, const Report& report) {
                      report.found({{0, 0, 0.25}});
                      report.claim();
                    }};
  CHECK(asked(instance, table, claims, 5.0).claimed);
}

}  // namespace peers_test
