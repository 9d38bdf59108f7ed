// SPDX-License-Identifier: Apache-2.0
// How fast stacks of axes (stack_model.h) are solved to proven optimality, read from CSV, on one thread.
// Usage: stack_benchmark [FOLDER...]: instances with axes.csv, screws.csv and motors.csv; without, seeded random ones.
#include <fmt/format.h>

#include <filesystem>

#include "benchmark/measure.h"
#include "benchmark/stack_instance.h"

namespace {

using namespace millwright::solver;
using measure::median;

/// Stage by stage the cheapest that complies: what a builder gets who sizes one axis at a time. NaN: stuck.
double greedy(const stack::Machine& machine) {
  double cost = 0.0;
  std::vector<double> state = machine.problem.first_state;
  for (const Stage* stage : machine.problem.stages) {
    Problem single = machine.problem;
    single.stages = {stage};
    single.first_state = state;
    const Summary summary = solve(single, {});
    if (summary.builds.empty()) return std::nan("");
    cost += summary.builds[0].resources[0];
    Answer<double> answer;
    const StageChoice& choice = summary.builds[0].stages[0];
    stage->evaluate({{}, choice.inherited, choice.rows, choice.variables}, answer);
    state = answer.handed_on;
  }
  return cost;
}

void solve_instance(const std::string& name, const std::filesystem::path& folder, int runs) {
  std::vector<double> reading, solving, front;
  Summary best, all;
  double by_greed = 0.0;
  for (int run = 0; run < runs; ++run) {
    const double start = measure::processor_seconds();
    const stack::Instance instance = stack::read_instance(folder);
    const stack::Machine machine(instance);
    const double read = measure::processor_seconds();
    reading.push_back(read - start);
    best = solve(machine.problem, {});
    const double solved = measure::processor_seconds();
    solving.push_back(solved - read);
    Options both;
    both.objectives = {0, 1};
    all = solve(machine.problem, both);
    front.push_back(measure::processor_seconds() - solved);
    if (run == 0) by_greed = greedy(machine);
  }
  const bool proved = best.status == Status::optimal && all.status == Status::optimal;
  fmt::print("{:<18} {:>10.5f} {:>8} {:>9.2f} {:>9.2f} {:>9.2f} {:>6} {:>7} {:>9} {:>8.2f}\n",
             name,
             best.builds.empty() ? std::nan("") : best.builds[0].resources[0],
             proved ? "proved" : "open",
             1e3 * median(reading),
             1e3 * median(solving),
             1e3 * median(front),
             all.builds.size(),
             best.nodes,
             best.evaluations,
             best.builds.empty() ? 0.0 : 100.0 * (by_greed / best.builds[0].resources[0] - 1.0));
}

}  // namespace

int main(int argc, char** argv) {
  fmt::print("{}\none thread, processor milliseconds, median of 5\n", measure::machine());
  fmt::print("{:<18} {:>10} {:>8} {:>9} {:>9} {:>9} {:>6} {:>7} {:>9} {:>8}\n",
             "instance",
             "cost",
             "",
             "read ms",
             "solve ms",
             "front ms",
             "points",
             "nodes",
             "questions",
             "greedy %");
  constexpr int runs = 5;
  for (int i = 1; i < argc; ++i) solve_instance(std::filesystem::path(argv[i]).filename().string(), argv[i], runs);
  if (argc > 1) return 0;
  const auto folder = std::filesystem::temp_directory_path() / "millwright_stack_benchmark";
  // Seeds with which sizing one axis after the other misses the optimum: there the axes have to be weighed together.
  for (const auto& [k, screws, motors, seed] :
       {std::array{2, 20, 20, 9}, {3, 100, 100, 2}, {3, 500, 200, 3}, {3, 2000, 500, 2}, {3, 10000, 2000, 3}}) {
    stack::write_instance(stack::random_instance(k, screws, motors, static_cast<std::uint64_t>(seed)), folder);
    solve_instance(fmt::format("k{} ({}, {})", k, screws, motors), folder, runs);
  }
  std::filesystem::remove_all(folder);
}
