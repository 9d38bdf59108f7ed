// SPDX-License-Identifier: Apache-2.0
#include "solver/least_state.h"

#include <algorithm>
#include <cmath>

#include "solver/variable_box.h"

namespace millwright::solver {
namespace {

class LeastStateSearch {
 public:
  LeastStateSearch(const StagePlan& plan, std::span<const Interval> states, const Region& region, Desk& desk)
      : plan_(plan),
        states_(states),
        region_(region),
        desk_(desk),
        component_(*plan.moved_state),
        falling_(plan.after[component_] == Direction::larger_is_better) {
    one_state_ = std::all_of(states.begin(), states.end(), [](const Interval& s) { return s.lower == s.upper; });
    for (const Interval& state : states) state_.push_back(middle(state));
    for (const RowSet& rows : region.rows) rows_.push_back(rows->front());
  }

  LeastState run(std::span<const double> first, std::size_t most_boxes) {
    const std::vector<Interval>& whole = region_.variables;
    push(whole);
    if (heap_.empty()) return std::move(found_);
    whole_ = desk_.interval.utilisation;
    value_before_ = heap_.all().front().value;
    if (!first.empty()) try_point({first.begin(), first.end()});
    for (const double part : {0.5, 1.0, 0.0}) try_point(part_of(heap_.all().front().side, part));
    for (std::size_t boxes = 0; !heap_.empty(); ++boxes) {
      const VariableBox box = heap_.pop();
      if (reaches_no_less(box.value) || boxes >= most_boxes || has_stalled(boxes, box.value)) {
        found_.least = std::min(found_.least, box.value);
        break;
      }
      const std::size_t side = widest_side(*plan_.stage, box.side);
      if (side == box.side.size()) {
        // Too narrow to be divided: at one state it is left out like any such set (continuous.h).
        if (!one_state_) found_.least = std::min(found_.least, box.value);
        continue;
      }
      const auto [left, right] = halves(box.side, side);
      for (const auto& half : {left, right}) {
        push(half);
        if (pushed_) try_point(middle_of(half));
      }
    }
    if (found_.universal()) found_.least = std::min(found_.least, least_of_point_);
    return std::move(found_);
  }

 private:
  [[nodiscard]] Interval moved(const Interval& value) const { return falling_ ? -value : value; }
  /// Room for the rounding of what is equal (criteria.h).
  [[nodiscard]] bool reaches_no_less(double value) const {
    return found_.universal() && value >= least_of_point_ - equal_sums * std::fabs(least_of_point_);
  }

  void push(const std::vector<Interval>& sides) {
    pushed_ = false;
    Region part = region_;
    part.variables = sides;
    const auto& answer = desk_.bound(*plan_.stage, plan_.shared, states_, part);
    if (worst_lower(answer.utilisation) > 1.0) {
      ++refuted_;
      return;
    }
    const double value = moved(answer.handed_on[component_]).lower;
    pushed_ = true;
    heap_.push({.side = sides, .value = value});
  }

  static std::vector<double> part_of(std::span<const Interval> sides, double part) {
    std::vector<double> point;
    for (const Interval& side : sides)
      point.push_back(std::clamp(side.lower + part * (side.upper - side.lower), side.lower, side.upper));
    return point;
  }

  void try_point(std::vector<double> point) {
    Interval value;
    if (one_state_) {
      const auto& answer = desk_.evaluate(*plan_.stage, Point{plan_.shared, state_, rows_, point});
      if (!(worst_of(answer.utilisation) <= 1.0)) return;
      value = moved(Interval(answer.handed_on[component_]));
    } else {
      std::vector<Interval> sides(point.begin(), point.end());
      const auto& answer = desk_.bound(*plan_.stage, plan_.shared, states_, region_, sides);
      if (!std::ranges::all_of(answer.utilisation, [](const Interval& u) { return u.upper <= 1.0; })) {
        variables_decide_ = variables_decide_ && !is_undecided_by_state(answer.utilisation);
        return look_at_middle_state(point);
      }
      value = moved(answer.handed_on[component_]);
    }
    if (!(value.upper < found_.most)) return;
    found_.most = value.upper;
    found_.variables = std::move(point);
    least_of_point_ = value.lower;
  }

  /// Where that is feasible no proof of the opposite will succeed, and what is handed on depends on the state.
  void look_at_middle_state(std::span<const double> point) {
    if (feasible_at_middle_) return;
    const auto& answer = desk_.evaluate(*plan_.stage, Point{plan_.shared, state_, rows_, point});
    feasible_at_middle_ = worst_of(answer.utilisation) <= 1.0;
  }
  /// Whether a constraint is kept at some states and not at others, at a point as in the whole box.
  [[nodiscard]] bool is_undecided_by_state(std::span<const Interval> utilisation) const {
    constexpr double nearly = 0.99;
    for (std::size_t c = 0; c < utilisation.size(); ++c) {
      const Interval& u = utilisation[c];
      if (u.lower <= 1.0 && u.upper > 1.0 && u.upper - u.lower >= nearly * (whole_[c].upper - whole_[c].lower))
        return true;
    }
    return false;
  }
  /// Over a range of states some constraint may stay undecided whatever the variables are.
  bool has_stalled(std::size_t boxes, double value) {
    constexpr std::size_t asked_every = 8;
    if (!variables_decide_) return true;
    if (one_state_ || boxes == 0 || boxes % asked_every != 0) return false;
    if (feasible_at_middle_ || found_.universal()) return true;
    const bool got_on = refuted_ > refuted_before_ || value > value_before_;
    refuted_before_ = refuted_;
    value_before_ = value;
    return !got_on;
  }

  const StagePlan& plan_;
  std::span<const Interval> states_;
  const Region& region_;
  Desk& desk_;
  std::size_t component_;
  bool falling_;
  bool one_state_ = false;
  std::vector<double> state_;  ///< in the middle
  std::vector<Row> rows_;
  BoxHeap heap_;
  LeastState found_;
  double least_of_point_ = std::numeric_limits<double>::infinity();  ///< over all states
  bool pushed_ = false;
  std::size_t refuted_ = 0, refuted_before_ = 0;  ///< boxes in which nothing is feasible
  double value_before_ = -std::numeric_limits<double>::infinity();
  std::vector<Interval> whole_;      ///< utilisations over the whole box
  bool variables_decide_ = true;     ///< false: some constraint hangs on the state alone
  bool feasible_at_middle_ = false;  ///< some point, at the middle of the states
};

}  // namespace

LeastState find_least_state(const StagePlan& plan,
                            std::span<const Interval> states,
                            const Region& region,
                            std::span<const double> first,
                            std::size_t most_boxes,
                            Desk& desk) {
  return LeastStateSearch(plan, states, region, desk).run(first, most_boxes);
}

LeastPoint find_least_point(const StagePlan& plan,
                            std::span<const double> state,
                            const Region& region,
                            std::span<const double> first,
                            std::vector<double>& variables,
                            Desk& desk) {
  constexpr std::size_t most_boxes = 1000;
  const std::vector<Interval> states(state.begin(), state.end());
  LeastState found = find_least_state(plan, states, region, first, most_boxes, desk);
  if (found.infeasible()) return LeastPoint::infeasible;
  if (!found.universal() || found.least < found.most - equal_sums * std::fabs(found.most)) return LeastPoint::undecided;
  variables = std::move(found.variables);
  return LeastPoint::found;
}

}  // namespace millwright::solver
