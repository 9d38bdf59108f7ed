// SPDX-License-Identifier: Apache-2.0
#include "solver/shared_choices.h"

#include <algorithm>
#include <numeric>

namespace millwright::solver {
namespace {

/// Sum of the stages' least scores with nothing chosen; empty when some stage is certainly infeasible.
std::vector<double> quick_bound(
    const Problem& problem, const Criteria& criteria, std::span<const Row> shared, Desk& desk, TableMemory& tables) {
  if (!all_offered(problem, shared)) return {};
  std::vector<Interval> state(problem.first_state.begin(), problem.first_state.end());
  std::vector<double> total(criteria.size(), 0.0);
  std::vector<double> score(criteria.size());
  for (const Stage* stage : problem.stages) {
    const auto& answer = desk.bound(*stage, shared, state, tables.whole_region(*stage, shared));
    if (worst_lower(answer.utilisation) > 1.0) return {};
    criteria.least_scores(answer.resources, score);
    for (std::size_t k = 0; k < total.size(); ++k) total[k] = total_down(total[k], score[k]);
    state = answer.handed_on;
  }
  criteria.raise(total);
  return total;
}

}  // namespace

bool next_combination(const Problem& problem, std::vector<Row>& shared) {
  for (std::size_t i = shared.size(); i-- > 0;) {
    if (++shared[i] < problem.shared[i].rows) return true;
    shared[i] = 0;
  }
  return false;
}

std::vector<Combination> combinations_of(const Problem& problem,
                                         const Criteria& criteria,
                                         Desk& desk,
                                         TableMemory& tables) {
  std::vector<Combination> all;
  for (const Slot& slot : problem.shared) {
    if (slot.rows == 0) return all;
  }
  std::vector<Row> shared(problem.shared.size(), 0);
  do {
    std::vector<double> score = quick_bound(problem, criteria, shared, desk, tables);
    if (!score.empty()) all.push_back({shared, std::move(score)});
  } while (next_combination(problem, shared));
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.score[0] < b.score[0]; });
  return all;
}

double search_space(const Problem& problem) {
  double product = 1.0;
  for (const Slot& slot : problem.shared) product *= static_cast<double>(slot.rows);
  for (const Stage* stage : problem.stages) {
    std::vector<std::vector<Row>> rows;
    for (const Slot& slot : stage->slots()) {
      rows.emplace_back(slot.rows);
      std::iota(rows.back().begin(), rows.back().end(), Row{0});
    }
    product *= stage->combinations(rows);
  }
  return product;
}

bool has_empty_slot(const Problem& problem) {
  const auto empty = [](const Slot& slot) { return slot.rows == 0; };
  return std::any_of(problem.shared.begin(), problem.shared.end(), empty) ||
         std::any_of(problem.stages.begin(), problem.stages.end(), [&](const Stage* stage) {
           return std::any_of(stage->slots().begin(), stage->slots().end(), empty);
         });
}

}  // namespace millwright::solver
