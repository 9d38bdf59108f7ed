// SPDX-License-Identifier: Apache-2.0
// How fast variants of the family that break its structure (broken_models.h) are solved: the proven optimum by cost and
// the whole (cost, mass) front, on one thread. Usage: broken_structure_benchmark [SCREWS MOTORS [RUNS [SECONDS]]]
#include <fmt/format.h>

#include <cstdlib>

#include "benchmark/broken_stack.h"
#include "benchmark/measure.h"

namespace {

using namespace millwright::solver;
using namespace stack::broken;

constexpr double target_solve = 0.5, target_front = 2.0;  // [s]
constexpr int belt_rows = 60;

struct Times {
  Summary best, front;
  double solving = 0.0, covering = 0.0;
};

Times measure_variant(const Problem& problem, int runs, double limit) {
  std::vector<double> solving, covering;
  Times times;
  Options options;
  options.time_limit_seconds = limit;
  for (int run = 0; run < runs; ++run) {
    options.objectives = {0};
    const double start = measure::processor_seconds();
    times.best = solve(problem, options);
    const double between = measure::processor_seconds();
    solving.push_back(between - start);
    options.objectives = {0, 1};
    times.front = solve(problem, options);
    covering.push_back(measure::processor_seconds() - between);
    if (times.front.status == Status::limit) break;  // once is enough
  }
  times.solving = measure::median(solving);
  times.covering = measure::median(covering);
  return times;
}

std::string judged(const Summary& summary, double seconds, double target) {
  const std::string said = summary.status == Status::optimal      ? seconds <= target ? "" : " over"
                           : summary.status == Status::infeasible ? " none"
                                                                  : fmt::format(" open {:.1g} %", 100.0 * summary.gap);
  return fmt::format("{:.3f}{}", seconds, said);
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, double standard) { return argc > i ? std::strtod(argv[i], nullptr) : standard; };
  const int screws = static_cast<int>(argument(1, 2000)), motors = static_cast<int>(argument(2, 500));
  const int runs = static_cast<int>(argument(3, 3));
  const double limit = argument(4, 60.0);
  fmt::print("{}\n", measure::machine());
  fmt::print(
      "k3 ({}, {}), one thread, processor seconds, median of {}; targets: solve {} s, front {} s; plain: cost without "
      "the variant\n",
      screws,
      motors,
      runs,
      target_solve,
      target_front);
  fmt::print("{:<30} {:>9} {:>9} {:>14} {:>14} {:>6} {:>8} {:>9}\n",
             "variant",
             "plain",
             "cost",
             "solve s",
             "front s",
             "points",
             "nodes",
             "questions");
  constexpr std::uint64_t seed = 2;
  const stack::Instance instance = stack::random_instance(3, screws, motors, seed);
  const stack::Columns belts = random_belts(belt_rows, seed);
  const stack::Machine plain(instance);
  const Summary unbroken = solve(plain.problem, {});
  const auto cost = [](const Summary& summary) {
    return summary.builds.empty() ? std::nan("") : summary.builds[0].resources[0];
  };
  for (const auto& [variant, name] : variants) {
    const Stack stack(instance, variant, belts, surroundings(instance, variant, belts, 0.85));
    const Times times = measure_variant(stack.problem, runs, limit);
    fmt::print("{:<30} {:>9.3f} {:>9.3f} {:>14} {:>14} {:>6} {:>8} {:>9}\n",
               name,
               cost(unbroken),
               cost(times.best),
               judged(times.best, times.solving, target_solve),
               judged(times.front, times.covering, target_front),
               times.front.builds.size(),
               times.best.nodes,
               times.best.evaluations);
    std::fflush(stdout);
  }
}
