// SPDX-License-Identifier: Apache-2.0
// The stack family solved by other solvers (peers/), from the same data in the same run: gap to the proven optimum,
// whether optimality was claimed, and time as a multiple of Millwright's. Every answer is judged by the exact model.
// Usage: peers_benchmark [SECONDS [K SCREWS MOTORS SEED]...]: time limit per peer and instance (5, or the environment's
// MILLWRIGHT_PEER_SECONDS), instances.
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "benchmark/measure.h"
#include "benchmark/peers/peer.h"
#include "benchmark/stack_instance.h"

namespace {

using namespace stack::peers;

using Size = std::array<int, 4>;  // axes, screws, motors, seed

std::vector<Peer> all_peers() {
  return {brute_force(),
          cbc(false),
          cbc(true),
          minizinc_table(false),
          minizinc_table(true),
          minizinc_physics(),
          bonmin("B-BB"),
          bonmin("B-OA"),
          bonmin("B-Hyb"),
          pagmo("sga"),
          pagmo("de"),
          isres()};
}

/// A claim is false when the design is none or a cheaper one exists.
std::string judgement(const Outcome& outcome, const Worth& worth, double optimum) {
  constexpr double tolerance = 1e-5;  // of peers that count in ten-thousandths
  if (!outcome.design) return outcome.crashed ? "crashed" : outcome.stopped ? "stopped, nothing" : "nothing";
  const bool design = worth.excess <= 1e-6;
  const bool best = worth.cost <= optimum * (1.0 + tolerance);
  if (!design) return outcome.claimed ? "FALSE CLAIM: no design" : "no design";
  if (outcome.claimed) return best ? "claimed" : "FALSE CLAIM: not the optimum";
  return outcome.crashed ? "crashed" : "no proof";
}

void compare(const Size& size, double seconds, const std::filesystem::path& folder) {
  const auto [k, screws, motors, seed] = size;
  const stack::Instance instance = stack::random_instance(k, screws, motors, static_cast<std::uint64_t>(seed));
  const stack::Machine machine(instance);
  std::vector<double> solving;
  millwright::solver::Summary best;
  for (int run = 0; run < 5; ++run) {
    best = millwright::solver::solve(machine.problem, {});
    solving.push_back(best.seconds);
  }
  const double own = measure::median(solving);
  const double optimum = best.builds.empty() ? std::nan("") : best.builds[0].resources[0];
  const auto start = measure::Clock::now();
  const Table table = make_table(instance);
  fmt::print("\nk{} ({}, {}), seed {}: optimum {:.5f}, {} by Millwright in {:.5f} s (median of 5)\n",
             k,
             screws,
             motors,
             seed,
             optimum,
             best.status == millwright::solver::Status::optimal ? "proved" : "NOT PROVED",
             own);
  std::size_t all = 0, useful = 0;
  for (const auto& pairs : table.all) all += pairs.size();
  for (const auto& pairs : table.useful) useful += pairs.size();
  fmt::print("table of {} pairs, {} of them useful, prepared in {:.3f} s (not counted below)\n",
             all,
             useful,
             measure::seconds_since(start));
  fmt::print("  {:<28} {:>9} {:>9} {:>9} {:>10}  {}\n", "", "gap %", "seconds", "found at", "ratio", "");
  for (const Peer& peer : all_peers()) {
    if (!peer.available) {
      fmt::print("  {:<28} skipped: needs the package {}\n", peer.name, peer.package);
      continue;
    }
    Outcome outcome = run_isolated(peer, {instance, table, seconds, folder});
    std::vector<double> times{outcome.seconds};
    while (times.size() < 3 && times[0] < 1.0)
      times.push_back(run_isolated(peer, {instance, table, seconds, folder}).seconds);
    outcome.seconds = measure::median(times);
    const Worth worth = outcome.design ? worth_of(instance, *outcome.design) : Worth{};
    fmt::print("  {:<28} {:>9} {:>9.3f} {:>9} {:>10.1f}  {}\n",
               peer.name,
               outcome.design ? fmt::format("{:.2f}", 100.0 * (worth.cost / optimum - 1.0)) : "-",
               outcome.seconds,
               outcome.design ? fmt::format("{:.3f}", outcome.found_seconds) : "-",
               outcome.seconds / own,
               judgement(outcome, worth, optimum));
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const char* asked = std::getenv("MILLWRIGHT_PEER_SECONDS");
  const double seconds = argc > 1           ? std::strtod(argv[1], nullptr)
                         : asked != nullptr ? std::strtod(asked, nullptr)
                                            : 5.0;
  std::vector<Size> sizes;
  for (int i = 2; i + 3 < argc; i += 4)
    sizes.push_back({std::atoi(argv[i]), std::atoi(argv[i + 1]), std::atoi(argv[i + 2]), std::atoi(argv[i + 3])});
  // Seeds with which sizing one axis after the other misses the optimum.
  if (sizes.empty()) sizes = {{2, 20, 20, 9}, {3, 100, 100, 2}, {3, 500, 200, 3}};
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("millwright_peers_{}", static_cast<long>(getpid()));
  std::filesystem::create_directories(folder);
  fmt::print(
      "{}\ntime limit {} s for each peer and instance; seconds: as a process, with its model's file, median of 3 below "
      "1 s; ratio to "
      "Millwright's solve\n",
      measure::machine(),
      seconds);
  for (const Size& size : sizes) compare(size, seconds, folder);
  std::filesystem::remove_all(folder);
}
