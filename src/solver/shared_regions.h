// SPDX-License-Identifier: Apache-2.0
//
// The regions of one stage, divided and bounded once for all labels that arrive in alike states.
//
// Thousands of labels may arrive at a stage of a front, and each would walk through the same regions and ask about them
// at states that hardly differ. So the range of states is cut into narrow cells. In each the regions make trees: a part
// is bounded over all states of the cell, and divided when the first label asks for its halves. That holds for every
// label of the cell; its own scores are added, and what is handed on as a fixed linear form of the state (state_form.h)
// is taken at the label's own. So a label goes down what others have divided in one step, only where it may matter.
// About a single design, and about whatever is left when the trees are large, it has to ask by itself.
//
// Parts are divided by several threads at once. What they become does not depend on which thread comes first, nor do
// the counts of what is known, which change between batches only (`count`, `cell_of`).
#pragma once

#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "solver/split_worth.h"
#include "solver/state_form.h"

namespace millwright::solver {

struct SharedPart {
  Region region;              ///< until it is divided
  Bounds bounds;              ///< over all states of the cell
  std::vector<double> least;  ///< [score]: of it with all stages after
  double divisions = 0.0;     ///< Region::divisions, also when it has been divided
  bool single_design = false;
  bool divided = false;
  std::array<std::unique_ptr<SharedPart>, 2> halves;  ///< null: no design in it is feasible in the cell
  std::optional<std::size_t> slot;                    ///< in which it was divided; none: in a variable
};

class SharedRegions {
 public:
  struct Cell {
    std::vector<Interval> states;
    std::size_t labels = 0;                          ///< that have come to be in it
    std::vector<std::unique_ptr<SharedPart>> parts;  ///< [open region of the plan]; null: nothing is feasible
    std::vector<char> bounded;                       ///< [region]: whether that is known
  };

  SharedRegions(const StagePlan& plan, Desk& desk);

  /// The cell in which all these states are, for one label more; it stays where it is. Null where there is none: they
  /// are outside of what can arrive, or that has no end. Not to be called while parts are asked for.
  Cell* cell_of(std::span<const Interval> states);
  /// Takes note of how many parts there are. Not to be called while parts are asked for.
  void count() { full_ = parts_ >= most_parts; }

  /// An open region of the plan; null: no design in it is feasible in the cell.
  SharedPart* part_of(Cell& cell, std::size_t region, Desk& desk);
  /// Divides a part that is not a single design, if nobody has, by what it has been worth to divide slots. False: there
  /// are too many parts already.
  bool divide(const Cell& cell, SharedPart& part, const SplitWorth& worth, Desk& desk);
  /// What designs of a part hand on from these states of the cell.
  void hand_on(const Cell& cell,
               std::span<const Interval> states,
               const Bounds& bounds,
               std::vector<Interval>& handed_on) const;

 private:
  static constexpr std::size_t most_parts = 200000;

  [[nodiscard]] std::unique_ptr<SharedPart> bounded(const Cell& cell, Region region, Desk& desk);
  [[nodiscard]] std::mutex& mutex_of(const void* known);

  const StagePlan* plan_;
  StateForm form_;
  std::vector<int> cells_;  ///< [inherited component]: into how many its range is cut
  std::map<std::vector<int>, std::unique_ptr<Cell>> known_;
  std::atomic<std::size_t> parts_ = 0;
  bool full_ = false;
  std::array<std::mutex, 16> working_;
};

}  // namespace millwright::solver
