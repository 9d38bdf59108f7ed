// SPDX-License-Identifier: Apache-2.0
#include "solver/cover.h"

#include <algorithm>
#include <cmath>

#include "solver/box_slopes.h"
#include "solver/leaf_point.h"
#include "solver/relaxation.h"
#include "solver/variable_box.h"

namespace millwright::solver {
namespace {

constexpr std::size_t cover_boxes = 20000;
constexpr std::size_t proof_boxes = 30;
constexpr std::size_t ipopt_after = 401;  // boxes after which Ipopt is asked if no feasible point is known

/// Covers the useful designs of a box of priced variables by feasible points.
class Cover {
 public:
  Cover(const LeafQuestion& question, Desk& desk) : question_(question), desk_(desk), design_(question, desk) {}

  LeafAnswer run() {
    const auto& variables = question_.region->variables;
    if (!start_points(variables)) return std::move(answer_);
    push(variables, nullptr);
    std::size_t boxes = 0;
    for (; !heap_.empty() && boxes < cover_boxes && !stopped(boxes); ++boxes) {
      VariableBox box = heap_.pop();
      if (covered(box.bounds)) continue;
      look_inside(box, boxes);
      if (!covered(box.bounds)) divide(box);
    }
    for (const VariableBox& box : heap_.all()) answer_.leave_undecided(box.bounds.score);
    drop_unused();
    return std::move(answer_);
  }

 private:
  [[nodiscard]] bool stopped(std::size_t boxes) const {
    constexpr std::size_t asked_every = 16;
    return boxes % asked_every == 0 && question_.stop && question_.stop();
  }

  /// False: nothing is feasible. Where nothing that is tried is, a few boxes often prove so, at a small part of what it
  /// takes to look for a feasible point.
  bool start_points(std::span<const Interval> variables) {
    std::vector<double> start = middle_of(variables);
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
    const BoxSlopes slopes(question_, box, desk_);
    std::vector<Interval> side = box.side;
    if (!slopes.narrow(side)) return;
    slopes.raise(side, box.bounds);
    if (useless(box.bounds)) return;
    for (std::size_t v = 0; v < side.size(); ++v) {
      const double before = box.side[v].upper - box.side[v].lower;
      if (side[v].upper - side[v].lower < much * before) return push(side, &box.bounds);
    }
    box.side = std::move(side);
    const std::size_t deciding = deciding_side(box, slopes);
    if (deciding == box.side.size()) return answer_.leave_undecided(box.bounds.score);
    const auto [left, right] = halves(box.side, deciding);
    push(left, &box.bounds);
    push(right, &box.bounds);
  }

  /// The side over which scores, states or undecided utilisations change most, by slope times width: halving a
  /// diameter that moves the cost decides more than halving an acceleration time that moves nothing undecided. While no
  /// point is feasible nothing can be covered: only the proof that there is none can close boxes.
  std::size_t deciding_side(const VariableBox& box, const BoxSlopes& slopes) {
    const Stage& stage = *question_.plan->stage;
    std::size_t best = widest_side(stage, box.side);
    double most = 0.0;
    for (std::size_t v = 0; v < box.side.size(); ++v) {
      const Variable& variable = stage.variables()[v];
      const double width = box.side[v].upper - box.side[v].lower;
      if (!(width > narrowest * (variable.upper - variable.lower))) continue;
      const double change = slopes.change_over(v, box.bounds, !answer_.points.empty());
      if (change > most) {
        most = change;
        best = v;
      }
    }
    return best;
  }

  void look_inside(const VariableBox& box, std::size_t boxes) {
    constexpr std::size_t local_every = 16;
    const std::vector<double> center = middle_of(box.side);
    add(center);
    std::vector<double> low;
    for (const Interval& side : box.side) low.push_back(side.lower);
    add(low);
    const bool with_ipopt = boxes == ipopt_after && answer_.points.empty();
    if (boxes % local_every == 0 || with_ipopt) {
      if (const auto found = design_.small_worth(box.side, center, with_ipopt)) add(*found);
    }
  }

  /// Keeps a feasible point unless a known one is as good.
  void add(std::span<const double> variables) {
    StagePoint point;
    if (!design_.take(variables, point)) return;
    for (const StagePoint& known : answer_.points) {
      if (as_good(known, point.score_lower, point.enclosure, 0.0)) return;
    }
    std::vector<double> score = point.score_lower;
    const bool used = replace_dominated(point);
    points_score_.push_back(std::move(score));
    answer_.points.push_back(std::move(point));
    used_.push_back(used);
  }

  /// Removes the points that a new one is as good as. It covers what they covered, so it takes over what they stand
  /// for; without this the list would grow with every step of the descent and each box would be compared with all of
  /// it.
  bool replace_dominated(StagePoint& point) {
    const std::vector<double> own_score = point.score_lower;
    bool used = false;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < answer_.points.size(); ++i) {
      if (dominated_by(points_score_[i], answer_.points[i].state, own_score, point.state)) {
        if (!used_[i]) continue;
        used = true;
        point.exact = point.exact && answer_.points[i].exact;
        for (std::size_t k = 0; k < point.score_lower.size(); ++k)
          point.score_lower[k] = std::min(point.score_lower[k], answer_.points[i].score_lower[k]);
        for (std::size_t c = 0; c < point.enclosure.size(); ++c)
          stand_for(point.enclosure[c], answer_.points[i].enclosure[c], c);
        continue;
      }
      if (kept != i) {
        answer_.points[kept] = std::move(answer_.points[i]);
        points_score_[kept] = std::move(points_score_[i]);
        used_[kept] = used_[i];
      }
      ++kept;
    }
    answer_.points.resize(kept);
    points_score_.resize(kept);
    used_.resize(kept);
    return used;
  }

  /// Whether a point is no better than another in any score and in any component of the state, in its proved direction.
  [[nodiscard]] bool dominated_by(std::span<const double> old_score,
                                  std::span<const double> old_state,
                                  std::span<const double> score,
                                  std::span<const double> state) const {
    for (std::size_t k = 0; k < score.size(); ++k)
      if (score[k] > old_score[k]) return false;
    for (std::size_t c = 0; c < state.size(); ++c) {
      switch (question_.plan->after[c]) {
        case Direction::irrelevant:
          break;
        case Direction::smaller_is_better:
          if (state[c] > old_state[c]) return false;
          break;
        case Direction::larger_is_better:
          if (state[c] < old_state[c]) return false;
          break;
        case Direction::equal_only:
          if (state[c] != old_state[c]) return false;
          break;
      }
    }
    return true;
  }

  [[nodiscard]] bool as_good(const StagePoint& known,
                             std::span<const double> score,
                             std::span<const Interval> state,
                             double tolerance) const {
    const StagePlan& plan = *question_.plan;
    const std::size_t index = static_cast<std::size_t>(&known - answer_.points.data());
    for (std::size_t k = 0; k < score.size(); ++k) {
      const double total = question_.label->score_lower[k] + score[k] + plan.rest[k];
      if (points_score_[index][k] > score[k] + tolerance * std::fabs(total)) return false;
    }
    for (std::size_t c = 0; c < state.size(); ++c) {
      const double slack = tolerance * magnitude(state[c]);
      switch (plan.after[c]) {
        case Direction::irrelevant:
          break;
        case Direction::smaller_is_better:
          if (known.state[c] > state[c].lower + slack) return false;
          break;
        case Direction::larger_is_better:
          if (known.state[c] < state[c].upper - slack) return false;
          break;
        case Direction::equal_only:
          if (state[c].upper - state[c].lower > slack) return false;
          if (!(std::fabs(known.state[c] - middle(state[c])) <= slack)) return false;
          break;
      }
    }
    return true;
  }

  bool covered(const Bounds& bounds) {
    for (std::size_t i = 0; i < answer_.points.size(); ++i) {
      StagePoint& point = answer_.points[i];
      if (!as_good(point, bounds.score, bounds.handed_on, question_.tolerance)) continue;
      used_[i] = true;
      point.exact = false;
      for (std::size_t k = 0; k < bounds.score.size(); ++k) {
        point.score_lower[k] = std::min(point.score_lower[k], bounds.score[k]);
      }
      for (std::size_t c = 0; c < point.enclosure.size(); ++c) stand_for(point.enclosure[c], bounds.handed_on[c], c);
      return true;
    }
    return false;
  }

  /// In a good direction only the better side needs to be enclosed: the worse is no better than the point.
  void stand_for(Interval& enclosure, const Interval& state, std::size_t component) const {
    switch (question_.plan->after[component]) {
      case Direction::irrelevant:
        break;
      case Direction::smaller_is_better:
        enclosure.lower = std::min(enclosure.lower, state.lower);
        break;
      case Direction::larger_is_better:
        enclosure.upper = std::max(enclosure.upper, state.upper);
        break;
      case Direction::equal_only:
        enclosure = hull(enclosure, state);
        break;
    }
  }

  bool useless(const Bounds& bounds) {
    return (question_.hopeless && question_.hopeless({bounds.score, bounds.handed_on, bounds.utilisation})) ||
           covered(bounds);
  }

  /// `around`: bounds that hold in a larger box.
  void push(std::span<const Interval> side, const Bounds* around) {
    Region region = *question_.region;
    region.variables.assign(side.begin(), side.end());
    VariableBox box;
    if (!assess(*question_.plan, question_.label->enclosure, region, box.bounds, desk_)) return;
    if (around != nullptr) {
      for (std::size_t k = 0; k < box.bounds.score.size(); ++k)
        box.bounds.score[k] = std::max(box.bounds.score[k], around->score[k]);
      for (std::size_t s = 0; s < box.bounds.handed_on.size(); ++s)
        box.bounds.handed_on[s] =
            intersect(box.bounds.handed_on[s], around->handed_on[s]).value_or(box.bounds.handed_on[s]);
    }
    if (useless(box.bounds)) return;
    box.side = std::move(region.variables);
    box.value = box.bounds.score[0];
    heap_.push(std::move(box));
  }

  /// Points that cover nothing are not needed.
  void drop_unused() {
    std::vector<StagePoint> kept;
    for (std::size_t i = 0; i < answer_.points.size(); ++i) {
      StagePoint& point = answer_.points[i];
      if (!used_[i] && !answer_.undecided) continue;
      kept.push_back(std::move(point));
    }
    answer_.points = std::move(kept);
  }

  const LeafQuestion& question_;
  Desk& desk_;
  LeafDesign design_;
  BoxHeap heap_;
  LeafAnswer answer_;
  std::vector<std::vector<double>> points_score_;  ///< own share of each point itself
  std::vector<bool> used_;
};

}  // namespace

LeafAnswer cover(const LeafQuestion& question, Desk& desk) { return Cover(question, desk).run(); }

}  // namespace millwright::solver
