// SPDX-License-Identifier: Apache-2.0
#include "solver/least_utilisations.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "solver/row_profile.h"

namespace millwright::solver {
namespace {

/// What is not a number proves nothing.
double known(double lower) { return std::isnan(lower) ? 0.0 : lower; }

/// The least bound of each constraint among the rows of one slot, found best set first. The sets that one constraint
/// has had cut serve the others.
class LeastOfSlot {
 public:
  LeastOfSlot(const Stage& stage,
              std::span<const Row> shared,
              std::span<const Interval> inherited,
              const Region& whole,
              std::size_t slot,
              Desk& desk)
      : stage_(stage), shared_(shared), inherited_(inherited), whole_(whole), slot_(slot), desk_(desk) {
    best_.assign(stage.constraints(), {infinity, slot, 0});
    constexpr std::size_t sample = 64;
    const std::vector<Row>& rows = whole.rows[slot]->all();
    const std::size_t tried = std::min(sample, rows.size());
    for (std::size_t i = 0; i < tried; ++i) try_row(rows[i * rows.size() / tried]);
    if (tried < rows.size()) add(whole.rows[slot]);
  }

  /// The least, if it is above `enough`; otherwise anything that is not.
  LeastUtilisation least(std::size_t constraint, double enough) {
    if (sets_.empty()) return best_[constraint];
    const auto later = [&](std::size_t a, std::size_t b) {
      const double of_a = sets_[a].lower[constraint], of_b = sets_[b].lower[constraint];
      return of_a != of_b ? of_a > of_b : sets_[a].rows->front() > sets_[b].rows->front();
    };
    std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(later)> open(later);
    open.push(0);
    while (!open.empty() && best_[constraint].value > enough) {
      const std::size_t next = open.top();
      open.pop();
      const double lower = sets_[next].lower[constraint];
      if (lower > best_[constraint].value) break;
      if (lower == best_[constraint].value && sets_[next].rows->front() >= best_[constraint].row) continue;
      look_into(next, constraint);
      if (sets_[next].left == 0) continue;
      open.push(sets_[next].left);
      open.push(sets_[next].right);
    }
    return best_[constraint];
  }

 private:
  struct Set {
    RowSet rows;
    std::vector<double> lower = {};   ///< of each constraint
    bool is_tried = false;            ///< row by row
    std::size_t left = 0, right = 0;  ///< what it was cut into; 0: it was not
  };

  void add(RowSet rows) {
    Set set{.rows = std::move(rows)};
    for (const Interval& u :
         desk_.bound_with(stage_, shared_, inherited_, whole_, slot_, set.rows->alive()).utilisation)
      set.lower.push_back(known(u.lower));
    sets_.push_back(std::move(set));
  }

  void try_row(const Row& row) {
    const std::span<const Row> alone(&row, 1);
    stage_.read(shared_, slot_, alone, readings_);
    const auto& answer = desk_.bound_with(stage_, shared_, inherited_, whole_, slot_, {alone, readings_});
    for (std::size_t c = 0; c < best_.size(); ++c) {
      const double u = known(answer.utilisation[c].lower);
      if (u < best_[c].value || (u == best_[c].value && row < best_[c].row)) best_[c] = {u, slot_, row};
    }
  }

  /// Cuts a set for the sake of a constraint, or tries all rows of a small one.
  void look_into(std::size_t index, std::size_t constraint) {
    constexpr std::size_t few = 16;
    if (sets_[index].is_tried || sets_[index].left != 0) return;
    const RowSet rows = sets_[index].rows;
    if (rows->size() <= few) {
      for (const Row& row : *rows) try_row(row);
      sets_[index].is_tried = true;
      return;
    }
    RowProfile::Split halves = profile().split_slot(*rows, slot_, std::uint64_t{1} << (constraint % 64));
    sets_[index].left = sets_.size();
    sets_[index].right = sets_.size() + 1;
    add(std::move(halves.left));
    add(std::move(halves.right));
  }

  const RowProfile& profile() {
    if (!profile_) {
      profile_.emplace(stage_, shared_);
      profile_->find(whole_, slot_, {}, [&](const RowsAlive& rows, std::span<double>) -> const Answer<Interval>& {
        return desk_.bound_with(stage_, shared_, inherited_, whole_, slot_, rows);
      });
    }
    return *profile_;
  }

  const Stage& stage_;
  std::span<const Row> shared_;
  std::span<const Interval> inherited_;
  const Region& whole_;
  std::size_t slot_;
  Desk& desk_;
  std::vector<LeastUtilisation> best_;  ///< of each constraint, among the rows tried so far
  std::vector<Set> sets_;               ///< the first is the whole table
  std::optional<RowProfile> profile_;   ///< once a set has to be cut
  std::vector<Interval> readings_;
};

}  // namespace

std::vector<LeastUtilisation> least_utilisations(const Stage& stage,
                                                 std::span<const Row> shared,
                                                 std::span<const Interval> inherited,
                                                 const Region& whole,
                                                 const std::vector<bool>& asked,
                                                 Desk& desk) {
  std::vector<LeastUtilisation> result;
  for (const Interval& u : desk.bound(stage, shared, inherited, whole).utilisation)
    result.push_back({known(u.lower), std::nullopt, 0});
  for (std::size_t slot = 0; slot < whole.rows.size(); ++slot) {
    LeastOfSlot of_slot(stage, shared, inherited, whole, slot, desk);
    for (std::size_t c = 0; c < result.size(); ++c) {
      if (!asked[c]) continue;
      const LeastUtilisation least = of_slot.least(c, std::max(1.0, result[c].value));
      if (least.value > std::max(1.0, result[c].value)) result[c] = least;
    }
  }
  return result;
}

}  // namespace millwright::solver
