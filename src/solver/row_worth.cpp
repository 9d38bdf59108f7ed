// SPDX-License-Identifier: Apache-2.0
#include "solver/row_worth.h"

#include <algorithm>
#include <chrono>

#include "solver/stage_plan.h"

namespace millwright::solver {

namespace {

constexpr double most_shared_choices = 32.0;

/// What the stage of this plan adds at least with each of its rows.
std::vector<std::vector<double>> own_worths(const StagePlan& plan, Desk& desk) {
  std::vector<std::vector<double>> worths;
  const auto slots = plan.stage->slots();
  Bounds bounds;
  for (std::size_t slot = 0; slot < slots.size(); ++slot) {
    worths.emplace_back(slots[slot].rows, infinity);
    for (const Row row : *plan.region.rows[slot]) {
      Region trial = plan.region;
      trial.rows[slot] = only(*plan.stage, plan.shared, slot, row);
      if (!plan.fits.filter(trial, slot)) continue;
      read_bounds(plan, desk.bound(*plan.stage, plan.shared, plan.best_inherited, trial), bounds);
      if (bounds.utilisation <= 1.0) worths[slot][row] = std::max(bounds.score[0], plan.least[0]);
    }
  }
  return worths;
}

}  // namespace

std::vector<RowWorth> row_worths(const Problem& problem, const Options& options, std::uint64_t& evaluations) try {
  double combinations = 1.0;
  for (const Slot& slot : problem.shared) combinations *= static_cast<double>(slot.rows);
  std::vector<RowWorth> result;
  if (combinations > most_shared_choices || combinations < 1.0) return result;
  const Criteria criteria = make_criteria(problem, options);
  const auto start = std::chrono::steady_clock::now();
  Desk desk;
  desk.interrupt = [&] {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    return spent.count() > options.time_limit_seconds || (options.stop != nullptr && options.stop->load());
  };
  TableMemory tables;
  std::vector<Row> shared(problem.shared.size(), 0);
  for (bool more = true; more;) {
    const std::vector<StagePlan> plans = make_plans(problem, shared, criteria, desk, tables);
    if (!plans.empty()) {
      RowWorth worth;
      worth.shared = shared;
      for (const StagePlan& plan : plans) {
        worth.least += plan.least[0];
        worth.rows.push_back(own_worths(plan, desk));
      }
      for (std::size_t i = 0; i < plans.size(); ++i) {
        double others = 0.0;
        for (std::size_t k = 0; k < plans.size(); ++k) others += k == i ? 0.0 : plans[k].least[0];
        for (std::vector<double>& slot : worth.rows[i])
          for (double& row : slot) row += others;
      }
      result.push_back(std::move(worth));
    }
    more = false;
    for (std::size_t i = shared.size(); i-- > 0 && !more;) {
      more = ++shared[i] < problem.shared[i].rows;
      if (!more) shared[i] = 0;
    }
  }
  evaluations += desk.bounds + desk.evaluations;
  return result;
} catch (const OutOfTime&) {
  return {};
}

}  // namespace millwright::solver
