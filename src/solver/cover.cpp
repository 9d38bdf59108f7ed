// SPDX-License-Identifier: Apache-2.0
#include "solver/cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "solver/box_slopes.h"
#include "solver/cover_points.h"
#include "solver/leaf_point.h"
#include "solver/leaf_precision.h"
#include "solver/point_comparison.h"
#include "solver/relaxation.h"
#include "solver/relief.h"
#include "solver/variable_box.h"

namespace millwright::solver {
namespace {

constexpr std::size_t cover_boxes = 20000;
constexpr std::size_t proof_boxes = 30;
constexpr std::size_t label_asked_after = 64;  // boxes after which it is asked whether the label leaves them undecided
constexpr std::size_t ipopt_after = 401;       // boxes after which Ipopt is asked if no feasible point is known
constexpr std::size_t around_every = 64;       // boxes after which points beside one are looked for
constexpr double undecided_reach = 1.0 / refined_part;  // of the tolerance, where an inexact label leaves open

/// Covers the useful designs of a box of variables that move the outcome by feasible points.
class Cover {
 public:
  Cover(const LeafQuestion& question, Desk& desk)
      : question_(question),
        desk_(desk),
        design_(question, desk),
        relief_(design_),
        keys_(question),
        points_(question) {}

  LeafAnswer run() {
    const auto& variables = question_.region->variables;
    push_boxes();
    if (!leaves_to_later() && !may_be_of_use()) return std::move(answer_);
    if (!start_points(variables)) return std::move(answer_);
    if (leaves_to_later()) measure_label(variables);
    std::size_t boxes = 0;
    for (; !heap_.empty() && boxes < cover_boxes && !stopped(boxes); ++boxes) {
      VariableBox box = heap_.pop();
      if (covered(box.side, box.origin, box.bounds)) continue;
      const bool smaller = look_inside(box, boxes);
      if (covered(box.side, box.origin, box.bounds) || has_stand_in(box)) continue;
      if (boxes >= label_asked_after && only_label_decides(box))
        leave_undecided(box);
      else if (smaller)
        push_part(box, box.side);
      else
        divide(box);
    }
    for (const VariableBox& box : heap_.all()) leave_undecided(box);
    answer_.points = std::move(points_).take(answer_.undecided || !stand_ins_.empty());
    std::move(stand_ins_.begin(), stand_ins_.end(), std::back_inserter(answer_.points));
    return std::move(answer_);
  }

 private:
  /// How far what the label stands for is from itself.
  struct LabelSlack {
    std::vector<double> score, state;
  };

  [[nodiscard]] bool stopped(std::size_t boxes) const {
    constexpr std::size_t asked_every = 16;
    return boxes % asked_every == 0 && question_.stop && question_.stop();
  }

  void push_boxes() {
    const auto& variables = question_.region->variables;
    if (question_.among.empty()) push({.side = variables}, nullptr);
    for (const OpenBox& box : question_.among)
      if (auto sides = common_part(box.sides.empty() ? variables : box.sides, variables))
        push({.side = std::move(*sides), .origin = box.origin}, nullptr);
  }

  /// False: a few boxes show that nothing is. To look for points takes longer, and of most designs none is of use.
  bool may_be_of_use() {
    constexpr std::size_t few = 8;
    has_looked_ = false;
    for (std::size_t boxes = 0; boxes < few && !heap_.empty(); ++boxes) {
      VariableBox box = heap_.pop();
      divide(box);
    }
    has_looked_ = true;
    for (VariableBox& box : std::exchange(set_aside_, {})) heap_.push(std::move(box));
    return !heap_.empty();
  }

  /// False: nothing is feasible. Where nothing that is tried is, a few boxes often prove so, at a small part of what it
  /// takes to look for a feasible point.
  bool start_points(std::span<const Interval> variables) {
    std::vector<double> start = middle_of(variables);
    relief_.relieve(start, variables, true);
    if (const auto feasible = design_.try_points(variables))
      start = *feasible;
    else if (proves_infeasible(*question_.plan, question_.label->enclosure, *question_.region, proof_boxes, desk_))
      return false;
    else if (const auto found = design_.least_violation(variables, start))
      start = *found;
    add(start);
    if (const auto best = design_.small_worth(variables, start, false)) add(*best);
    return true;
  }

  /// Narrows the box and raises its bounds by first-order enclosures; if that helps little it is halved as well.
  void divide(VariableBox& box) {
    constexpr double much = 0.7;
    if (!relief_.sieve(box)) return;
    const BoxSlopes slopes(question_, box, desk_);
    std::vector<Interval> side = box.side;
    if (!slopes.narrow(side)) return;
    slopes.raise(side, box.bounds);
    if (useless(side, box.origin, box.bounds)) return;
    for (std::size_t v = 0; v < side.size(); ++v) {
      const double before = box.side[v].upper - box.side[v].lower;
      if (side[v].upper - side[v].lower < much * before) return push_part(box, std::move(side));
    }
    box.side = std::move(side);
    if (!relief_.clip(box)) return;
    const std::size_t deciding = deciding_side(box, slopes);
    if (deciding == box.side.size()) {
      if (has_looked_) return leave_undecided(box);
      return set_aside_.push_back(std::move(box));
    }
    if (relief_.divides(deciding)) {
      if (relief_.refine(box, deciding)) push_part(box, box.side);
      return;
    }
    auto [left, right] = halves(box.side, deciding);
    push_part(box, std::move(left));
    push_part(box, std::move(right));
  }

  /// The side over which scores, states or undecided utilisations change most, by slope times width: halving a
  /// diameter that moves the cost decides more than halving an acceleration time that moves nothing undecided. While no
  /// point that has been looked for is feasible and none stands in nothing can be covered: only the proof that there is
  /// none can close boxes.
  std::size_t deciding_side(const VariableBox& box, const BoxSlopes& slopes) const {
    constexpr double few_parts = 32.0;
    std::size_t best = box.side.size();
    double most = -1.0;
    for (std::size_t v = 0; v < box.side.size(); ++v) {
      const Variable& variable = question_.plan->stage->variables()[v];
      const double range = variable.upper - variable.lower, width = Relief::widest_part(box, v);
      const std::size_t parts = Relief::parts(box, v);
      if (!(width > narrowest * range) || parts >= Relief::most_parts) continue;
      const double share = width / (box.side[v].upper - box.side[v].lower);
      const double change =
          share * slopes.change_over(v, box.bounds, !has_looked_ || !points_.empty() || leaves_to_later());
      // The more parts there are, the more it costs; the widest, where nothing changes.
      const double worth =
          change > 0.0 ? change / (1.0 + static_cast<double>(parts) / few_parts) : -1.0 + 1e-3 * width / range;
      if (worth > most) {
        most = worth;
        best = v;
      }
    }
    return best;
  }

  /// Tries points of the box. True: the box has become smaller by what they say.
  bool look_inside(VariableBox& box, std::size_t boxes) {
    constexpr std::size_t local_every = 16;
    std::vector<double> center = middle_of(box.side);
    const bool thoroughly = boxes % local_every == 0;
    relief_.relieve(center, box.side, thoroughly);
    add(center);
    std::vector<double> low;
    for (std::size_t v = 0; v < center.size(); ++v) low.push_back(relief_.has(v) ? center[v] : box.side[v].lower);
    add(low);
    const bool with_ipopt = boxes == ipopt_after && points_.empty();
    if (thoroughly || with_ipopt) {
      if (const auto found = design_.small_worth(box.side, center, with_ipopt)) add(*found);
    }
    if (boxes % around_every == around_every - 1 && !question_.refined_later) look_around(center);
    return relief_.settle(box, center);
  }

  /// Where designs are feasible only just, nothing in the boxes that come up is, however small they are: beside them,
  /// ever nearer and farther.
  void look_around(std::span<const double> center) {
    constexpr std::array reach = {1e-3, 1e-5, 1e-2, 1e-4, 1e-6};  // of the ranges
    const double share = reach[looked_around_++ % reach.size()];
    const std::vector<Interval>& whole = question_.region->variables;
    std::vector<Interval> around;
    for (std::size_t v = 0; v < whole.size(); ++v) {
      const double by = share * (whole[v].upper - whole[v].lower);
      around.emplace_back(std::max(whole[v].lower, center[v] - by), std::min(whole[v].upper, center[v] + by));
    }
    std::vector<double> start(center.begin(), center.end());
    if (const auto inside = design_.least_violation(around, start)) start = *inside;
    add(start);
    if (const auto best = design_.small_worth(around, start, false)) add(*best);
  }

  /// Keeps a feasible point unless a known one is as good.
  void add(std::span<const double> variables) {
    StagePoint point;
    // Where more is better what is more than later stages can bear must not stand for less.
    if (design_.take(variables, point) && bearable(*question_.plan, point.state)) points_.add(std::move(point));
  }

  [[nodiscard]] Slack slack() const { return {question_.tolerance, label_slack_.score, label_slack_.state}; }

  bool covered(std::span<const Interval> side, OpenBox::Origin origin, const Bounds& bounds) {
    return covered(side, origin, bounds, slack());
  }
  bool covered(std::span<const Interval> side, OpenBox::Origin origin, const Bounds& bounds, const Slack& within) {
    StagePoint* const point = points_.cover(bounds, within);
    if (point != nullptr) take_over(side, origin, bounds, *point);
    return point != nullptr;
  }

  void take_over(std::span<const Interval> side,
                 OpenBox::Origin origin,
                 const Bounds& bounds,
                 StagePoint& point) const {
    point.exact = false;
    if (question_.refined_later) point.boxes.push_back({relief_.as_given(side), origin});
    for (std::size_t k = 0; k < bounds.score.size(); ++k)
      point.score_lower[k] = std::min(point.score_lower[k], bounds.score[k]);
    for (std::size_t c = 0; c < point.enclosure.size(); ++c)
      stand_for(*question_.plan, point.enclosure[c], bounds.handed_on[c], c);
  }

  [[nodiscard]] bool leaves_to_later() const { return question_.refined_later && !question_.label->exact; }

  /// What a label stands for may be feasible where it is not itself: to divide such boxes further than the tolerance
  /// decides nothing, and what comes later may.
  bool has_stand_in(const VariableBox& box) {
    if (!leaves_to_later()) return false;
    const auto stands_for_it = [&](std::span<const double> score, std::span<const double> state, const Slack& within) {
      return as_good(keys_, score, state, box.bounds.score, box.bounds.handed_on, within);
    };
    for (std::size_t i = 0; i < stand_ins_.size(); ++i) {
      StagePoint& known = stand_ins_[i];
      if (!stands_for_it(stand_ins_score_[i], known.state, slack())) continue;
      known.utilisation = std::min(known.utilisation, box.bounds.utilisation);
      take_over(box.side, box.origin, box.bounds, known);
      return true;
    }
    StagePoint point;
    const std::vector<double> middle = middle_of(box.side);
    if (!design_.take_infeasible(middle, point)) return false;
    std::vector<double> score = point.score_lower;
    if (!stands_for_it(score, point.state, slack())) {
      // What is in whole steps (a power) may be one or the next just here.
      const LabelSlack here = label_slack(middle, point);
      if (!stands_for_it(score, point.state, {question_.tolerance, here.score, here.state})) return false;
    }
    point.utilisation = box.bounds.utilisation;
    take_over(box.side, box.origin, box.bounds, point);
    stand_ins_score_.push_back(std::move(score));
    stand_ins_.push_back(std::move(point));
    return true;
  }

  /// Whether dividing a box decides nothing any more: its middle is feasible, and nothing known can stand for all that
  /// the middle alone may be for what the label stands for, which is as much as the box may be. (A power in whole watts
  /// is one or the next by a load that is known within bounds.) No feasible point can cover such a box, however small
  /// it is.
  bool only_label_decides(const VariableBox& box) {
    if (question_.label->exact || leaves_to_later()) return false;
    std::vector<double> center = middle_of(box.side);
    relief_.relieve(center, box.side, true);
    if (!(design_.worst_at(center) <= 1.0)) return false;
    const StagePlan& plan = *question_.plan;
    const std::vector<Interval> there(center.begin(), center.end());
    Bounds bounds;
    read_bounds(
        plan, desk_.bound(*plan.stage, plan.shared, question_.label->enclosure, *question_.region, there), bounds);
    if (bounds.utilisation > 1.0) return false;
    if (points_.has_as_good(bounds, slack())) return false;
    std::vector<double> best;
    for (std::size_t c = 0; c < bounds.handed_on.size(); ++c)
      best.push_back(plan.after[c] == Direction::larger_is_better ? bounds.handed_on[c].upper
                                                                  : bounds.handed_on[c].lower);
    return as_good(keys_, bounds.score, best, box.bounds.score, box.bounds.handed_on, slack());
  }

  /// How far scores and states of what the label stands for are from those of its point, in the middle of its
  /// variables.
  void measure_label(std::span<const Interval> variables) {
    StagePoint point;
    const std::vector<double> middle = middle_of(variables);
    if (design_.take_infeasible(middle, point)) label_slack_ = label_slack(middle, point);
  }
  /// `point`: of the label itself, with these variables.
  LabelSlack label_slack(std::span<const double> variables, const StagePoint& point) {
    LabelSlack found;
    const StagePlan& plan = *question_.plan;
    const std::vector<Interval> there(variables.begin(), variables.end());
    Bounds bounds;
    read_bounds(
        plan, desk_.bound(*plan.stage, plan.shared, question_.label->enclosure, *question_.region, there), bounds);
    for (std::size_t k = 0; k < bounds.score.size(); ++k) {
      const double below = point.score_lower[k] - bounds.score[k];
      found.score.push_back(std::isfinite(below) ? std::max(below, 0.0) : 0.0);
    }
    for (const Interval& state : bounds.handed_on)
      found.state.push_back(state.is_bounded() ? state.upper - state.lower : 0.0);
    return found;
  }

  bool useless(std::span<const Interval> side, OpenBox::Origin origin, const Bounds& bounds) {
    return (question_.hopeless && question_.hopeless({bounds.score, bounds.handed_on, bounds.utilisation})) ||
           covered(side, origin, bounds);
  }

  /// Part of a box, whose bounds hold there, too.
  void push_part(const VariableBox& box, std::vector<Interval> side) {
    push({.side = std::move(side), .origin = box.origin, .parts = box.parts}, &box.bounds);
  }
  void push(VariableBox box, const Bounds* around) {
    Region region = *question_.region;
    region.variables = std::move(box.side);
    if (!assess(*question_.plan, question_.label->enclosure, region, box.bounds, desk_)) return;
    box.side = std::move(region.variables);
    if (!relief_.clip(box)) return;
    if (around != nullptr) {
      for (std::size_t k = 0; k < box.bounds.score.size(); ++k)
        box.bounds.score[k] = std::max(box.bounds.score[k], around->score[k]);
      for (std::size_t s = 0; s < box.bounds.handed_on.size(); ++s)
        box.bounds.handed_on[s] =
            intersect(box.bounds.handed_on[s], around->handed_on[s]).value_or(box.bounds.handed_on[s]);
    }
    if (useless(box.side, box.origin, box.bounds)) return;
    box.value = box.bounds.score[0];
    heap_.push(std::move(box));
  }

  /// What an inexact label stands for moves what its designs must be, and that may move what they cost by more than the
  /// tolerance: then no division decides which of them are feasible, with whatever tolerance. A point may stand for
  /// them even so, a good deal worse: a label that is open in the end is counted by its bounds, and a finer search with
  /// this reach stays within the tolerance of the first one.
  void leave_undecided(const VariableBox& box) {
    if (is_beyond_bearing(*question_.plan, box.bounds.handed_on)) return;
    const bool by_label = !question_.label->exact && !question_.refined_later;
    if (by_label && covered(box.side, box.origin, box.bounds, {undecided_reach * question_.tolerance, {}, {}})) return;
    answer_.leave_undecided(box.bounds.score);
    if (question_.refined_later) answer_.undecided_boxes.push_back({relief_.as_given(box.side), box.origin});
  }

  const LeafQuestion& question_;
  Desk& desk_;
  LeafDesign design_;
  Relief relief_;
  BoxHeap heap_;
  LeafAnswer answer_;
  PointKeys keys_;
  CoverPoints points_;
  bool has_looked_ = true;              ///< for points; false: not yet
  std::size_t looked_around_ = 0;       ///< so often
  std::vector<VariableBox> set_aside_;  ///< that cannot be divided, and in which points have not been looked for
  std::vector<StagePoint> stand_ins_;   ///< points that break a constraint, for what an inexact label stands for
  std::vector<std::vector<double>> stand_ins_score_;
  LabelSlack label_slack_;
};

}  // namespace

LeafAnswer cover(const LeafQuestion& question, Desk& desk) { return Cover(question, desk).run(); }

}  // namespace millwright::solver
