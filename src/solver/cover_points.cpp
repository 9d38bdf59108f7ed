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

std::size_t CoverPoints::within(std::span<const double> limits) const {
  std::size_t place = 0;
  const bool found = by_key_.any_at_most(limits, [&](Archive::Name name) {
    place = name;
    return true;
  });
  return found ? place : known_.size();
}

void CoverPoints::add(StagePoint point) {
  thread_local std::vector<double> limits;
  if (keys_.limits_of(point.score_lower, point.enclosure, {0.0, {}, {}}, limits) && within(limits) < known_.size())
    return;
  Known next{std::move(point), {}};
  keys_.key_of(next.point.score_lower, next.point.state, next.key);
  replace_dominated(next);
  const auto name = static_cast<Archive::Name>(known_.size());
  by_key_.add(next.key, name);
  known_.push_back(std::move(next));
}

/// Removes the points that a new one is as good as. It covers what they covered, so it takes over what they stand for;
/// without this the list would grow with every step of the descent and each box would be compared with all of it.
void CoverPoints::replace_dominated(Known& known) {
  thread_local std::vector<double> turned;
  turned.clear();
  for (const double coordinate : known.key) turned.push_back(-coordinate);
  turned_round_.remove_at_most(turned, [&](Archive::Name name) {
    Known& old = known_[name];
    by_key_.remove(old.key, name);
    if (old.needed) take_over(old.point, known.point);
    known.needed = known.needed || old.needed;
    old = {.point = {}, .key = {}, .replaced = true};
    ++replaced_;
    return true;
  });
  turned_round_.add(turned, static_cast<Archive::Name>(known_.size()));
}

void CoverPoints::take_over(const StagePoint& old, StagePoint& point) const {
  point.boxes.insert(point.boxes.end(), old.boxes.begin(), old.boxes.end());
  point.exact = point.exact && old.exact;
  for (std::size_t k = 0; k < point.score_lower.size(); ++k)
    point.score_lower[k] = std::min(point.score_lower[k], old.score_lower[k]);
  for (std::size_t c = 0; c < point.enclosure.size(); ++c)
    stand_for(*question_.plan, point.enclosure[c], old.enclosure[c], c);
}

StagePoint* CoverPoints::cover(const Bounds& bounds, const Slack& slack) {
  thread_local std::vector<double> limits;
  if (!keys_.limits_of(bounds.score, bounds.handed_on, slack, limits)) return nullptr;
  const std::size_t place = within(limits);
  if (place == known_.size()) return nullptr;
  known_[place].needed = true;
  return &known_[place].point;
}

bool CoverPoints::has_as_good(const Bounds& bounds, const Slack& slack) const {
  thread_local std::vector<double> limits;
  return keys_.limits_of(bounds.score, bounds.handed_on, slack, limits) && within(limits) < known_.size();
}

std::vector<StagePoint> CoverPoints::take(bool all) && {
  std::vector<StagePoint> points;
  for (Known& known : known_) {
    if (known.replaced || (!known.needed && !all)) continue;
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
