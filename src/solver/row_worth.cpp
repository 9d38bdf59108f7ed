// SPDX-License-Identifier: Apache-2.0
#include "solver/row_worth.h"

#include <algorithm>
#include <chrono>

#include "solver/shared_choices.h"
#include "solver/stage_plan.h"

namespace millwright::solver {

namespace {

constexpr double most_shared_choices = 32.0;

/// What the stage of a plan adds at least with each row of a slot. What is above `most` may be more.
class OwnWorths {
 public:
  OwnWorths(const StagePlan& plan, std::size_t slot, double most, Desk& desk)
      : plan_(plan), slot_(slot), most_(most), desk_(desk), worths_(plan.stage->slots()[slot].rows, infinity) {
    std::vector<std::vector<Row>> kinds;
    for (const Row row : *plan.region.rows[slot]) {
      const std::size_t kind = plan.fits.kinds(slot)[row];
      if (kinds.size() <= kind) kinds.resize(kind + 1);
      kinds[kind].push_back(row);
    }
    for (std::vector<Row>& rows : kinds)
      if (!rows.empty()) ask_of_kind(std::move(rows));
  }

  std::vector<double> take() && { return std::move(worths_); }

 private:
  /// Rows that have the same partners: what does not fit one of them fits none.
  void ask_of_kind(std::vector<Row> rows) {
    Region region = plan_.region;
    region.rows[slot_] = make_rows(*plan_.stage, plan_.shared, slot_, std::move(rows));
    if (!plan_.fits.filter(region, slot_)) return;
    std::vector<RowSet> open{region.rows[slot_]};
    while (!open.empty()) {
      const RowSet set = std::move(open.back());
      open.pop_back();
      const double least = worth_of(region, *set);
      if (set->size() > 1 && least <= most_) {
        RowProfile::Split halves = plan_.profile.split_slot(*set, slot_);
        open.push_back(std::move(halves.left));
        open.push_back(std::move(halves.right));
        continue;
      }
      for (const Row row : *set) worths_[row] = least;
    }
  }

  /// Of all designs of the region with these rows.
  double worth_of(const Region& region, const Rows& rows) {
    read_bounds(plan_,
                desk_.bound_with(*plan_.stage, plan_.shared, plan_.best_inherited, region, slot_, rows.alive()),
                bounds_);
    return bounds_.utilisation > 1.0 ? infinity : std::max(bounds_.score[0], plan_.least[0]);
  }

  const StagePlan& plan_;
  std::size_t slot_;
  double most_;
  Desk& desk_;
  std::vector<double> worths_;  ///< [row]
  Bounds bounds_;
};

}  // namespace

std::vector<RowWorth> row_worths(const Problem& problem,
                                 const Options& options,
                                 double most,
                                 std::uint64_t& evaluations,
                                 const DirectionsOf& known) try {
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
  tables.known_directions = known;
  std::vector<Row> shared(problem.shared.size(), 0);
  do {
    const std::vector<StagePlan> plans = make_plans(problem, shared, criteria, desk, tables);
    if (!plans.empty()) {
      RowWorth worth;
      worth.shared = shared;
      for (const StagePlan& plan : plans) worth.least += plan.least[0];
      for (std::size_t i = 0; i < plans.size(); ++i) {
        double others = 0.0;
        for (std::size_t k = 0; k < plans.size(); ++k) others += k == i ? 0.0 : plans[k].least[0];
        std::vector<std::vector<double>>& slots = worth.rows.emplace_back();
        for (std::size_t slot = 0; slot < plans[i].stage->slots().size(); ++slot) {
          slots.push_back(OwnWorths(plans[i], slot, most - others, desk).take());
          for (double& row : slots.back()) row += others;
        }
      }
      result.push_back(std::move(worth));
    }
  } while (next_combination(problem, shared));
  evaluations += desk.bounds + desk.evaluations;
  return result;
} catch (const OutOfTime&) {
  return {};
}

}  // namespace millwright::solver
