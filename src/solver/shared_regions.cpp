// SPDX-License-Identifier: Apache-2.0
#include "solver/shared_regions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "solver/rest_curve.h"
#include "solver/variable_halves.h"

namespace millwright::solver {

SharedRegions::SharedRegions(const StagePlan& plan, Desk& desk)
    : plan_(&plan), form_(find_state_form(plan, desk)), cells_(plan.inherited.size(), 1) {
  constexpr double width = 0.003;  // relative, of the states of a cell
  constexpr double most = 1000.0;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const Interval& range = plan.inherited[c];
    if ((!form_.influences[c] && !form_.moves_scores[c]) || !std::isfinite(range.upper - range.lower)) continue;
    const double relative = (range.upper - range.lower) / std::max(magnitude(range), 1e-300);
    cells_[c] = static_cast<int>(std::clamp(std::ceil(relative / width), 1.0, most));
  }
}

SharedRegions::Cell* SharedRegions::cell_of(std::span<const Interval> states) {
  std::vector<int> place;
  std::vector<Interval> range;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    Interval side = plan_->inherited[c];
    if (cells_[c] > 1) {
      const double step = (side.upper - side.lower) / cells_[c];
      for (const double end : {states[c].lower, states[c].upper})
        place.push_back(static_cast<int>(std::clamp(std::floor((end - side.lower) / step), 0.0, cells_[c] - 1.0)));
      const int first = place[place.size() - 2], last = place.back();
      side = {side.lower + first * step, side.lower + (last + 1) * step};
    }
    // What is handed on from an endless range tells nothing of that from a state in it.
    if (!std::isfinite(side.upper - side.lower)) return nullptr;
    // What is the same for all labels is so exactly.
    const double slack = side.lower < side.upper ? equal_sums * magnitude(plan_->inherited[c]) : 0.0;
    range.emplace_back(side.lower - slack, side.upper + slack);
    if (!contains(range.back(), states[c].lower) || !contains(range.back(), states[c].upper)) return nullptr;
  }
  std::unique_ptr<Cell>& cell = known_[place];
  if (cell == nullptr) {
    cell = std::make_unique<Cell>();
    cell->states = std::move(range);
    cell->parts.resize(plan_->open_regions.size());
    cell->bounded.resize(plan_->open_regions.size());
  }
  ++cell->labels;
  return cell.get();
}

std::mutex& SharedRegions::mutex_of(const void* known) {
  constexpr std::size_t size = 64;  // that two of them are apart at least
  return working_[std::hash<const void*>{}(known) / size % working_.size()];
}

SharedPart* SharedRegions::part_of(Cell& cell, std::size_t region, Desk& desk) {
  const std::lock_guard lock(mutex_of(&cell));
  if (cell.bounded[region] == 0) {
    Region own = plan_->open_regions[region].region;
    own.kept = 0;  // that was so at other states
    cell.parts[region] = bounded(cell, std::move(own), desk);
    cell.bounded[region] = 1;
  }
  return cell.parts[region].get();
}

std::unique_ptr<SharedPart> SharedRegions::bounded(const Cell& cell, Region region, Desk& desk) {
  auto part = std::make_unique<SharedPart>();
  part->region = std::move(region);
  Bounds& bounds = part->bounds;
  if (!assess(*plan_, cell.states, part->region, bounds, desk)) return nullptr;
  part->region.kept = ~bounds.telling;
  part->divisions = part->region.divisions();
  part->single_design = part->region.one_design_per_slot();
  for (std::size_t k = 0; k < bounds.score.size(); ++k)
    part->least.push_back(
        total_down(std::max(bounds.score[k], plan_->least[k]), rest_after(*plan_, k, bounds.handed_on)));
  ++parts_;
  return part;
}

bool SharedRegions::divide(const Cell& cell, SharedPart& part, const SplitWorth& worth, Desk& desk) {
  const std::lock_guard lock(mutex_of(&part));
  if (part.divided) return true;
  if (full_) return false;
  const StagePlan& plan = *plan_;
  if (const auto variable = variable_to_halve(plan, cell.states, part.region, part.bounds.score, desk)) {
    auto [lower, upper] = halved(part.region, *variable);
    part.halves = {bounded(cell, std::move(lower), desk), bounded(cell, std::move(upper), desk)};
  } else {
    const RowProfile::Split split = plan.profile.split(part.region, part.bounds.open, worth.of_slots());
    part.slot = split.slot;
    const std::array<RowSet, 2> rows{split.left, split.right};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Region half = part.region;
      half.rows[split.slot] = rows[i];
      if (plan.fits.filter(half, split.slot)) part.halves[i] = bounded(cell, std::move(half), desk);
    }
  }
  part.region = {};
  part.divided = true;
  return true;
}

/// Of a linear form the part that comes of the cell's states is taken off, and that of the label's put in its place.
void SharedRegions::hand_on(const Cell& cell,
                            std::span<const Interval> states,
                            const Bounds& bounds,
                            std::vector<Interval>& handed_on) const {
  // What is given up to rounding has to be less than what counts as equal (exact_digits), or nothing would ever be as
  // good as what is the same.
  constexpr double of_sums = 8 * std::numeric_limits<double>::epsilon();
  handed_on = bounds.handed_on;
  for (std::size_t h = 0; h < handed_on.size(); ++h) {
    double lower = 0.0, upper = 0.0, slack = of_sums * magnitude(handed_on[h]);
    for (std::size_t c = 0; c < states.size(); ++c) {
      const double slope = form_.slope[h][c];
      if (slope == 0.0) continue;
      const double from_lower = states[c].lower - cell.states[c].lower;
      const double from_upper = states[c].upper - cell.states[c].upper;
      lower += slope * (slope > 0.0 ? from_lower : from_upper);
      upper += slope * (slope > 0.0 ? from_upper : from_lower);
      slack += form_.slope_error[h][c] * std::max(std::fabs(from_lower), std::fabs(from_upper)) +
               of_sums * std::fabs(slope) * magnitude(cell.states[c]);
    }
    if (lower == 0.0 && upper == 0.0) continue;
    handed_on[h].lower += lower - slack;
    handed_on[h].upper += upper + slack;
  }
}

}  // namespace millwright::solver
