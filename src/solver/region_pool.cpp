// SPDX-License-Identifier: Apache-2.0
#include "solver/region_pool.h"

#include <algorithm>

#include "solver/archive.h"
#include "solver/relaxation.h"

namespace millwright::solver {
namespace {

constexpr std::size_t nodes_a_weighing = 200;  // refined for one weighing
// Before what is left is told: the search does the rest with all it knows.
constexpr std::size_t most_refined_at_once = 100;

Reached reached(const OpenRegion& part) { return {part.bounds.utilisation, part.bounds.score[0]}; }

}  // namespace

RegionPool::RegionPool(const StagePlan& plan, std::vector<Interval> inherited)
    : plan_(&plan), inherited_(std::move(inherited)), worth_(plan.region.rows.size()) {
  const auto same = [](const Interval& a, const Interval& b) { return a.lower == b.lower && a.upper == b.upper; };
  const bool at_best = std::equal(inherited_.begin(), inherited_.end(), plan.best_inherited.begin(), same);
  for (const OpenRegion& open : plan.open_regions) parts_.push_back({open, at_best});
}

bool RegionPool::bound(Part& part, const Useful& useful, Desk& desk) const {
  part.bounded = true;
  Region& region = part.open.region;
  Bounds& bounds = part.open.bounds;
  read_bounds(*plan_, desk.bound(*plan_->stage, plan_->shared, inherited_, region), bounds);
  // Cutting variables takes far longer than this, so it comes last.
  part.alive = bounds.utilisation <= 1.0 && (!useful || useful(bounds));
  if (!part.alive) return false;
  note_kept(bounds, region);
  part.alive = cut_variables(*plan_, inherited_, region, bounds, desk);
  note_kept(bounds, region);
  return part.alive;
}

template <class Offer>
void RegionPool::refine(std::size_t index, const Useful& useful, Desk& desk, Offer&& offer) {
  if (!parts_[index].bounded) {
    if (bound(parts_[index], useful, desk)) offer(index);
    return;
  }
  if (parts_[index].open.region.one_design_per_slot()) {
    parts_[index].alive = !proves_infeasible(*plan_, inherited_, parts_[index].open.region, usual_proof_boxes, desk);
    parts_[index].undecided = true;
    if (parts_[index].alive) offer(index);
    return;
  }
  const OpenRegion whole = std::move(parts_[index].open);
  const RowProfile::Split split = plan_->profile.split(whole.region, whole.bounds.open, worth_.of_slots());
  parts_[index].alive = false;
  std::size_t place = index;
  for (const RowSet& half : {split.left, split.right}) {
    Part part;
    part.open.region = whole.region;
    part.open.region.rows[split.slot] = half;
    const bool left = plan_->fits.filter(part.open.region, split.slot) && bound(part, useful, desk);
    worth_.count(split.slot, reached(whole), left ? std::optional(reached(part.open)) : std::nullopt);
    if (!left) continue;
    if (place == parts_.size()) parts_.emplace_back();
    parts_[place] = std::move(part);
    offer(place);
    place = parts_.size();
  }
}

RegionPool::Least RegionPool::least(const Mix& mix, std::span<const double> weight, Desk& desk) {
  std::erase_if(parts_, [](const Part& part) { return !part.alive; });
  const auto value_of = [&](std::size_t index) { return priced(parts_[index].open.bounds, mix, weight); };
  std::vector<Entry> heap;
  for (std::size_t i = 0; i < parts_.size(); ++i) heap.push_back({value_of(i), i});
  std::make_heap(heap.begin(), heap.end());
  for (std::size_t nodes = 0; !heap.empty(); ++nodes) {
    const Entry first = heap.front();
    if (nodes >= nodes_a_weighing || parts_[first.index].undecided) break;
    std::pop_heap(heap.begin(), heap.end());
    heap.pop_back();
    refine(first.index, {}, desk, [&](std::size_t index) {
      heap.push_back({value_of(index), index});
      std::push_heap(heap.begin(), heap.end());
    });
  }
  if (heap.empty()) return {infinity, {}};
  Least found{heap.front().value, {}};
  for (const Interval& handed_on : parts_[heap.front().index].open.bounds.handed_on)
    found.handed_on.push_back(handed_on.lower);
  return found;
}

bool RegionPool::refine_front(
    const Key& key, std::span<const double> weights, const Useful& useful, std::size_t most_nodes, Desk& desk) {
  Archive known(weights.size());  // of single designs
  std::vector<Entry> heap;
  const auto push = [&](std::size_t index) {
    Part& part = parts_[index];
    part.alive = part.alive && useful(part.open.bounds);
    if (!part.alive) return;
    double value = 0.0;
    const std::vector<double> at = key(part.open.bounds);
    for (std::size_t d = 0; d < at.size(); ++d) value += weights[d] * at[d];
    heap.push_back({value, index});
    std::push_heap(heap.begin(), heap.end());
  };
  for (std::size_t i = 0; i < parts_.size(); ++i) push(i);
  for (std::size_t nodes = 0; !heap.empty() && nodes < most_nodes;) {
    const std::size_t index = heap.front().index;
    std::pop_heap(heap.begin(), heap.end());
    heap.pop_back();
    const std::vector<double> at = key(parts_[index].open.bounds);
    if (known.dominates(at)) continue;
    if (parts_[index].undecided) {
      known.add(at);
      continue;
    }
    refine(index, useful, desk, push);
    ++nodes;
  }
  std::erase_if(parts_, [](const Part& part) { return !part.alive; });
  return !parts_.empty();
}

std::vector<OpenRegion> RegionPool::regions() const {
  std::vector<OpenRegion> regions;
  for (const Part& part : parts_)
    if (part.alive) {
      regions.push_back(part.open);
      regions.back().region.kept = 0;
    }
  std::stable_sort(regions.begin(), regions.end(), [](const OpenRegion& a, const OpenRegion& b) {
    return a.bounds.score[0] < b.bounds.score[0];
  });
  return regions;
}

bool RegionPool::keep_only(const Useful& useful, Desk& desk) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < parts_.size(); ++i) open.push_back(i);
  std::size_t refined_now = 0;
  while (!open.empty()) {
    std::vector<std::size_t> next;
    for (const std::size_t index : open) {
      Part& part = parts_[index];
      part.alive = part.alive && (!part.bounded || useful(part.open.bounds));
      if (!part.alive || part.undecided || refined_now >= most_refined_at_once) continue;
      ++refined_now;
      refine(index, useful, desk, [&](std::size_t refined) { next.push_back(refined); });
    }
    if (refined_now >= most_refined_at_once) break;
    open = std::move(next);
  }
  std::erase_if(parts_, [&](const Part& part) { return !part.alive || (part.bounded && !useful(part.open.bounds)); });
  return !parts_.empty();
}

std::vector<double> RegionPool::least_handed_on() const {
  std::vector<double> least(inherited_.size(), infinity);
  for (const Part& part : parts_)
    for (std::size_t c = 0; part.alive && c < least.size(); ++c)
      least[c] = std::min(least[c], part.open.bounds.handed_on[c].lower);
  return least;
}

void RegionPool::narrow(Region& region) const {
  for (std::size_t slot = 0; slot < region.rows.size(); ++slot) {
    std::vector<bool> left(plan_->stage->slots()[slot].rows, false);
    for (const Part& part : parts_) {
      for (const Row row : *part.open.region.rows[slot]) left[row] = true;
    }
    std::vector<Row> rows;
    for (const Row row : *region.rows[slot]) {
      if (left[row]) rows.push_back(row);
    }
    if (rows.size() < region.rows[slot]->size())
      region.rows[slot] = make_rows(*plan_->stage, plan_->shared, slot, std::move(rows));
  }
}

}  // namespace millwright::solver
