// SPDX-License-Identifier: Apache-2.0
#include "solver/continuous.h"

#include <algorithm>
#include <cmath>

#include "solver/cover.h"
#include "solver/leaf_point.h"
#include "solver/least_state.h"
#include "solver/relaxation.h"
#include "solver/variable_box.h"

namespace millwright::solver {
namespace {

constexpr std::size_t feasibility_boxes = 4000;
constexpr std::size_t inexact_boxes = 200;  // what these leave open a finer tolerance decides
constexpr std::size_t local_after = 24;     // boxes after which a local solver is asked
constexpr std::size_t thorough_after = 400;

enum class Verdict { feasible, infeasible, undecided };

/// Looks for a feasible point of one design, or proves that there is none.
class FeasibilitySearch {
 public:
  FeasibilitySearch(const LeafQuestion& question, Desk& desk)
      : question_(question),
        desk_(desk),
        design_(question, desk),
        state_(question.label->state.begin(), question.label->state.end()) {}

  Verdict run(std::vector<double>& found) {
    const auto& variables = question_.region->variables;
    if (accept(design_.try_points(variables), found)) return Verdict::feasible;
    push(variables);
    for (std::size_t boxes = 0; !heap_.empty(); ++boxes) {
      if (boxes >= feasibility_boxes) return Verdict::undecided;
      if (variables.size() > 1 && (boxes == local_after || boxes == thorough_after)) {
        std::vector<Interval> sides = variables;
        heap_ = {};
        if (narrow_one_by_one(*question_.plan, state_, *question_.region, sides, 2 * boxes, desk_)) push(sides);
        if (heap_.empty()) return Verdict::infeasible;
      }
      const VariableBox box = heap_.pop();
      if (boxes == local_after && accept(design_.least_violation(variables, middle_of(box.side)), found)) {
        return Verdict::feasible;
      }
      const std::size_t side = widest_side(*question_.plan->stage, box.side);
      if (side == box.side.size()) continue;
      const auto [left, right] = halves(box.side, side);
      for (const auto& half : {left, right}) {
        found = middle_of(half);
        if (design_.worst_at(found) <= 1.0) return Verdict::feasible;
        push(half);
      }
    }
    return Verdict::infeasible;
  }

 private:
  static bool accept(std::optional<std::vector<double>> x, std::vector<double>& found) {
    if (x) found = std::move(*x);
    return x.has_value();
  }
  void push(std::span<const Interval> side) {
    const auto& answer = desk_.bound(*question_.plan->stage, question_.plan->shared, state_, *question_.region, side);
    const double worst = worst_lower(answer.utilisation);
    if (worst <= 1.0) heap_.push({{side.begin(), side.end()}, worst, {}});
  }

  const LeafQuestion& question_;
  Desk& desk_;
  LeafDesign design_;
  std::vector<Interval> state_;
  BoxHeap heap_;
};

void widen_to(const Bounds& bounds, StagePoint& point) {
  for (std::size_t k = 0; k < point.score_lower.size(); ++k)
    point.score_lower[k] = std::min(point.score_lower[k], bounds.score[k]);
  for (std::size_t c = 0; c < point.state.size(); ++c) point.enclosure[c] = hull(point.state[c], bounds.handed_on[c]);
  point.exact = false;
}

/// Fills in what a point of an inexact label stands for.
void widen_to_enclosure(const LeafQuestion& question, Desk& desk, StagePoint& point) {
  if (question.label->exact) return;
  Bounds bounds;
  Region region = *question.region;
  if (assess(*question.plan, question.label->enclosure, region, bounds, desk)) widen_to(bounds, point);
}

/// All that a label stands for; an exact one need not have its enclosure written out.
std::vector<Interval> states_of(const Label& label) {
  return label.exact ? std::vector<Interval>(label.state.begin(), label.state.end()) : label.enclosure;
}

LeafAnswer solve_feasibility(const LeafQuestion& question, Desk& desk) {
  LeafAnswer answer;
  LeafDesign design(question, desk);
  std::vector<double> variables;
  const Verdict verdict = FeasibilitySearch(question, desk).run(variables);
  StagePoint point;
  const auto point_is_bearable = [&] { return question.label->exact || bearable(*question.plan, point.state); };
  if (verdict == Verdict::feasible && design.take(variables, point) && point_is_bearable()) {
    if (question.relieve) {
      design.relieve(variables, question.region->variables);
      design.take(variables, point);
    }
    widen_to_enclosure(question, desk, point);
    answer.points.push_back(std::move(point));
    return answer;
  }
  // Infeasible for the point of the label; what else the label stands for may still be feasible.
  if (verdict == Verdict::infeasible && question.label->exact) return answer;
  Bounds bounds;
  Region region = *question.region;
  const std::vector<Interval> enclosure = states_of(*question.label);
  // As above: that later stages cannot bear what this label hands on is no answer for all that share it.
  const bool possible = assess(*question.plan, enclosure, region, bounds, desk);
  if (!possible && (!question.label->exact || bearable(*question.plan, bounds.handed_on))) return answer;
  const bool hand_on = question.refined_later && !question.label->exact;
  const std::size_t proof_boxes = hand_on ? inexact_boxes : feasibility_boxes;
  if (proves_infeasible(*question.plan, enclosure, region, proof_boxes, desk)) return answer;
  if (!hand_on || !design.take_infeasible(middle_of(region.variables), point)) {
    answer.leave_undecided(bounds.score);
    return answer;
  }
  point.utilisation = bounds.utilisation;
  widen_to(bounds, point);
  answer.points.push_back(std::move(point));
  return answer;
}

/// The same of an inexact label, where one point is as good for all that the label stands for as the best of each.
std::optional<LeafAnswer> solve_least_of_enclosure(const LeafQuestion& question, Desk& desk) {
  constexpr std::size_t most_boxes = 100;
  const StagePlan& plan = *question.plan;
  LeastState found =
      find_least_state(plan, question.label->enclosure, *question.region, question.start, most_boxes, desk);
  LeafAnswer answer;
  if (found.infeasible()) return answer;
  if (!found.universal() || found.most - found.least > question.tolerance * std::fabs(found.most)) return std::nullopt;
  StagePoint point;
  Bounds bounds;
  Region region = *question.region;
  if (!assess(plan, question.label->enclosure, region, bounds, desk)) return answer;
  if (!LeafDesign(question, desk).take(found.variables, point) || !bearable(plan, point.state)) return std::nullopt;
  Interval& moved = bounds.handed_on[*plan.moved_state];
  const bool falling = plan.after[*plan.moved_state] == Direction::larger_is_better;
  moved = falling ? Interval{-found.most, -found.least} : Interval{found.least, found.most};
  widen_to(bounds, point);
  answer.points.push_back(std::move(point));
  return answer;
}

/// Of an exact label the one best point, where one counts; nothing where it does not or is not found.
std::optional<LeafAnswer> solve_least(const LeafQuestion& question, Desk& desk) {
  const auto is_whole = [](const OpenBox& box) { return box.sides.empty(); };
  const bool anywhere = question.among.empty() || std::ranges::any_of(question.among, is_whole);
  if (!question.plan->moved_state || !anywhere) return std::nullopt;
  if (!question.label->exact) return solve_least_of_enclosure(question, desk);
  LeafAnswer answer;
  std::vector<double> variables;
  const LeastPoint found =
      find_least_point(*question.plan, question.label->state, *question.region, question.start, variables, desk);
  if (found == LeastPoint::infeasible) return answer;
  StagePoint point;
  if (found == LeastPoint::found && LeafDesign(question, desk).take(variables, point)) {
    // Whether later stages can bear it hangs on what does not influence this one, and that differs between labels that
    // share the answer.
    answer.points.push_back(std::move(point));
    return answer;
  }
  if (question.tolerance > 0.0) return std::nullopt;
  // Nothing could cover it.
  Bounds bounds;
  Region region = *question.region;
  const bool possible = assess(*question.plan, states_of(*question.label), region, bounds, desk);
  if (possible || !bearable(*question.plan, bounds.handed_on)) answer.leave_undecided(bounds.score);
  return answer;
}

}  // namespace

void LeafAnswer::leave_undecided(std::span<const double> score) {
  if (!undecided) undecided_score.assign(score.begin(), score.end());
  undecided = true;
  for (std::size_t k = 0; k < score.size(); ++k) undecided_score[k] = std::min(undecided_score[k], score[k]);
}

LeafAnswer solve_leaf(const LeafQuestion& question, Desk& desk) {
  if (!question.plan->any_moves_outcome) return solve_feasibility(question, desk);
  if (std::optional<LeafAnswer> one = solve_least(question, desk)) return std::move(*one);
  return cover(question, desk);
}

}  // namespace millwright::solver
