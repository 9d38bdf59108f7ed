// SPDX-License-Identifier: Apache-2.0
// How solving grows: with the catalogues (real machines, 1, 10 and 100 times the rows), with axes in a stack (1 to 8),
// with continuous dimensions (0 to 6 an axis) and with threads (1 and 2).
// Usage: growth_benchmark [SECONDS [PROBLEM.toml...]]: time limit per solve (30, or the environment's
// MILLWRIGHT_GROWTH_SECONDS); machines (some of problems/)
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "benchmark/growing_stack.h"
#include "benchmark/measure.h"
#include "benchmark/multiplied_catalogues.h"

namespace {

using namespace millwright::solver;

struct Timing {
  std::string status = "failed";
  double read = std::nan(""), solve = std::nan("");
};

/// The program on a problem, with these catalogues.
Timing solve_machine(const std::string& problem,
                     const std::filesystem::path& catalogues,
                     double seconds,
                     const std::filesystem::path& folder) {
  const auto result = folder / "result.json";
  const std::string command =
      fmt::format("MILLWRIGHT_CATALOGUES='{}' '{}' solve '{}' --quiet --time-limit {} --json '{}' >'{}' 2>&1",
                  catalogues.string(),
                  MILLWRIGHT_PROGRAM,
                  problem,
                  seconds,
                  result.string(),
                  (folder / "said").string());
  std::filesystem::remove(result);
  Timing timing;
  // 1 is no compliant design, 3 a limit: results too.
  if (std::system(command.c_str()) < 0 || !std::filesystem::exists(result)) return timing;
  std::ifstream in(result);
  const auto json = nlohmann::json::parse(in);
  timing.status = json.at("status").get<std::string>();
  timing.read = json.at("timing_s").at("read").get<double>();
  timing.solve = json.at("timing_s").at("solve").get<double>();
  return timing;
}

void grow_catalogues(const std::vector<std::string>& problems, double seconds, const std::filesystem::path& folder) {
  const std::filesystem::path shipped = std::filesystem::path(MILLWRIGHT_SOURCE_DIR) / "catalogues";
  constexpr std::array<int, 4> times{1, 3, 10, 100};
  fmt::print(
      "\nCatalogues; a machine is left at the first size that is not settled in time.\n"
      "read: the files; solve: all the rest, with the tables of candidates made of them.\n"
      "Targets: exponent of solve time in rows <= 1.1, at 100 times the rows solve <= 2 times read\n");
  fmt::print(
      "  {:<16} {:>6} {:>9} {:>9} {:>10} {:>11}\n", "machine", "times", "rows", "read s", "solve s", "solve/read");
  std::vector<double> rows;
  for (const int many : times)
    rows.push_back(static_cast<double>(
        growth::multiply_catalogues(shipped, folder / ("catalogues" + std::to_string(many)), many)));
  for (const std::string& problem : problems) {
    const std::string name = std::filesystem::path(problem).stem().string();
    std::vector<double> known_rows, known_times;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const auto catalogues = folder / ("catalogues" + std::to_string(times[i]));
      const Timing timing = solve_machine(problem, catalogues, seconds, folder);
      const bool settled = timing.status == "optimal" || timing.status == "infeasible";
      fmt::print("  {:<16} {:>6} {:>9.0f} {:>9.3f} {:>10} {:>11.1f}  {}\n",
                 name,
                 times[i],
                 rows[i],
                 timing.read,
                 fmt::format("{}{:.3f}", settled ? "" : ">", timing.solve),
                 timing.solve / timing.read,
                 timing.status);
      std::fflush(stdout);
      if (!settled) break;
      known_rows.push_back(rows[i]);
      known_times.push_back(timing.solve);
    }
    if (known_rows.size() > 1)
      fmt::print("  {:<16} exponent {:.2f}\n", name, growth::exponent(known_rows, known_times));
  }
}

struct Solved {
  Summary best, front;
};
Solved solve_both(const Problem& problem, double seconds, unsigned threads) {
  Options options;
  options.time_limit_seconds = seconds;
  options.threads = threads;
  Solved solved;
  solved.best = solve(problem, options);
  options.objectives = {0, 1};
  solved.front = solve(problem, options);
  return solved;
}

std::string seconds_of(const Summary& summary) {
  return summary.status == Status::limit ? fmt::format(">{:.2f}", summary.seconds)
                                         : fmt::format("{:.4f}", summary.seconds);
}

void print_stack(const std::string& name, const Solved& solved) {
  const char* status[] = {"optimal", "infeasible", "limit"};
  fmt::print("  {:<24} {:>10} {:>10} {:>8} {:>9}  {}\n",
             name,
             seconds_of(solved.best),
             seconds_of(solved.front),
             solved.front.builds.size(),
             solved.best.nodes,
             status[static_cast<int>(solved.front.status)]);
  std::fflush(stdout);
}

void print_head(const std::string& title) {
  fmt::print("\n{}\n  {:<24} {:>10} {:>10} {:>8} {:>9}\n", title, "", "solve s", "front s", "points", "nodes");
}

void grow_axes(double seconds) {
  print_head("Axes in a stack, (500, 200)");
  std::vector<double> axes, times, fronts;
  for (int k = 1; k <= 8; ++k) {
    const stack::Instance instance = stack::random_instance(k, 500, 200, 3);
    const stack::Machine machine(instance);
    const Solved solved = solve_both(machine.problem, seconds, 1);
    print_stack(fmt::format("{} axes", k), solved);
    axes.push_back(k);
    times.push_back(solved.best.seconds);
    fronts.push_back(solved.front.seconds);
  }
  fmt::print("  exponent in the number of axes: solve {:.2f}, front {:.2f}\n",
             growth::exponent(axes, times),
             growth::exponent(axes, fronts));
}

void grow_dimensions(double seconds) {
  print_head("Continuous dimensions of each of 3 axes, (200, 100)");
  const stack::Instance instance = stack::random_instance(3, 200, 100, 3);
  for (std::size_t n = 0; n <= 6; ++n) {
    const growth::Machine machine(instance, n, false);
    print_stack(fmt::format("{} ramps", n), solve_both(machine.problem, seconds, 1));
  }
  for (std::size_t n = 1; n <= 6; ++n) {
    const growth::Machine machine(instance, n - 1, true);
    print_stack(fmt::format("{} ramps, a diameter", n - 1), solve_both(machine.problem, seconds, 1));
  }
}

void grow_threads(double seconds) {
  print_head("Threads, 3 axes, (2000, 500)");
  const stack::Instance instance = stack::random_instance(3, 2000, 500, 2);
  const stack::Machine machine(instance);
  for (const unsigned threads : {1U, 2U})
    print_stack(fmt::format("{} threads", threads), solve_both(machine.problem, seconds, threads));
}

}  // namespace

int main(int argc, char** argv) {
  const char* asked = std::getenv("MILLWRIGHT_GROWTH_SECONDS");
  const double seconds = argc > 1           ? std::strtod(argv[1], nullptr)
                         : asked != nullptr ? std::strtod(asked, nullptr)
                                            : 30.0;
  std::vector<std::string> problems(argv + std::min(argc, 2), argv + argc);
  const std::string shipped = std::string(MILLWRIGHT_SOURCE_DIR) + "/problems/";
  if (problems.empty())
    for (const char* name : {"sander", "mini-mill", "torch-table", "lifter"})
      problems.push_back(shipped + name + ".toml");
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("millwright_growth_{}", static_cast<long>(getpid()));
  std::filesystem::create_directories(folder);
  fmt::print("{}\ntime limit {} s for each solve, one thread\n", measure::machine(), seconds);
  grow_axes(seconds);
  grow_dimensions(seconds);
  grow_threads(seconds);
  grow_catalogues(problems, seconds, folder);
  std::filesystem::remove_all(folder);
}
