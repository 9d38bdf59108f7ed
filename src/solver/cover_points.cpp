// SPDX-License-Identifier: Apache-2.0
#include "solver/cover_points.h"

#include <algorithm>
#include <utility>

namespace millwright::solver {
namespace {

bool lies_in(const std::vector<Interval>& sides, const StagePoint& point) {
  return std::equal(sides.begin(), sides.end(), point.variables.begin(), [](const Interval& side, double value) {
    return side.lower <= value && value <= side.upper;
  });
}

}  // namespace

void CoverPoints::add(StagePoint point) {
  const auto is_known = [&](const Known& known) {
    return as_good(question_, known.score, known.point.state, point.score_lower, point.enclosure, {0.0, {}, {}});
  };
  if (std::any_of(known_.begin(), known_.end(), is_known)) return;
  std::vector<double> score = point.score_lower;
  Known next{std::move(point), std::move(score)};
  replace_dominated(next);
  known_.push_back(std::move(next));
}

/// Removes the points that a new one is as good as. It covers what they covered, so it takes over what they stand for;
/// without this the list would grow with every step of the descent and each box would be compared with all of it.
void CoverPoints::replace_dominated(Known& known) {
  const StagePlan& plan = *question_.plan;
  StagePoint& point = known.point;
  std::erase_if(known_, [&](const Known& old) {
    if (!dominated_by(plan, old.score, old.point.state, known.score, point.state)) return false;
    if (!old.needed) return true;
    known.needed = true;
    point.boxes.insert(point.boxes.end(), old.point.boxes.begin(), old.point.boxes.end());
    point.exact = point.exact && old.point.exact;
    for (std::size_t k = 0; k < point.score_lower.size(); ++k)
      point.score_lower[k] = std::min(point.score_lower[k], old.point.score_lower[k]);
    for (std::size_t c = 0; c < point.enclosure.size(); ++c)
      stand_for(plan, point.enclosure[c], old.point.enclosure[c], c);
    return true;
  });
}

StagePoint* CoverPoints::cover(const Bounds& bounds, const Slack& slack) {
  const auto known =
      std::find_if(known_.begin(), known_.end(), [&](const Known& each) { return is_as_good(each, bounds, slack); });
  if (known == known_.end()) return nullptr;
  known->needed = true;
  return &known->point;
}

bool CoverPoints::has_as_good(const Bounds& bounds, const Slack& slack) const {
  return std::any_of(known_.begin(), known_.end(), [&](const Known& each) { return is_as_good(each, bounds, slack); });
}

std::vector<StagePoint> CoverPoints::take(bool all) && {
  std::vector<StagePoint> points;
  for (Known& known : known_) {
    if (!known.needed && !all) continue;
    if (question_.refined_later) add_to_boxes(known.point);
    points.push_back(std::move(known.point));
  }
  return points;
}

/// A point may lie in boxes that another one stands for; where it lies in none it has been settled before.
void CoverPoints::add_to_boxes(StagePoint& point) const {
  const auto holds_it = [&](const OpenBox& box) { return lies_in(box.sides, point); };
  if (std::any_of(point.boxes.begin(), point.boxes.end(), holds_it)) return;
  const std::vector<Interval> itself(point.variables.begin(), point.variables.end());
  for (const OpenBox& box : question_.among)
    if (lies_in(box.sides, point)) point.boxes.push_back({itself, box.origin});
}

}  // namespace millwright::solver
