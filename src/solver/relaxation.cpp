// SPDX-License-Identifier: Apache-2.0
#include "solver/relaxation.h"

#include "solver/best_first.h"
#include "solver/region_order.h"
#include "solver/variable_box.h"

namespace millwright::solver {
namespace {

struct Node {
  OpenRegion part;
  bool undecided = false;  ///< a single design that could not be proved infeasible
};

double value_of(const StagePlan& plan, RelaxedTarget target, const Bounds& bounds) {
  if (target.kind == RelaxedTarget::Kind::score) return bounds.score[target.index];
  const Interval& state = bounds.handed_on[target.index];
  return plan.after[target.index] == Direction::larger_is_better ? -state.upper : state.lower;
}

class RelaxationSearch {
 public:
  RelaxationSearch(const StagePlan& plan, RelaxedTarget target, Desk& desk)
      : plan_(plan), target_(target), desk_(desk), worth_(plan.region.rows.size()) {}

  Relaxation run(std::size_t node_limit) {
    Region root = plan_.region;
    offer(std::move(root));
    for (std::size_t nodes = 0; !open_.empty() && nodes < node_limit; ++nodes) {
      if (open_.first().undecided) break;
      const double value = open_.first_key().value;
      Node node = open_.pop();
      if (!node.part.region.one_design_per_slot() || wide_variable(plan_, node.part.region)) {
        divide(node.part, value);
      } else if (!proves_infeasible(plan_, plan_.best_inherited, node.part.region, usual_proof_boxes, desk_)) {
        node.undecided = true;
        open_.push(value, std::move(node));
      }
    }
    return result();
  }

 private:
  std::optional<Reached> offer(Region region) {
    Node node;
    node.part.region = std::move(region);
    if (!assess(plan_, plan_.best_inherited, node.part.region, node.part.bounds, desk_)) return std::nullopt;
    note_kept(node.part.bounds, node.part.region);
    const Reached reached{node.part.bounds.utilisation, value_of(plan_, target_, node.part.bounds)};
    open_.push(reached.value, std::move(node));
    return reached;
  }
  void divide(const OpenRegion& part, double value) {
    branch(plan_, part.region, part.bounds.open, {part.bounds.utilisation, value}, worth_, [&](Region half) {
      return offer(std::move(half));
    });
  }
  Relaxation result() {
    Relaxation relaxation;
    relaxation.least = open_.empty() ? std::numeric_limits<double>::infinity() : open_.first_key().value;
    relaxation.open.reserve(open_.size());
    open_.for_each([&](Node& node) {
      node.part.region.kept = 0;
      relaxation.open.push_back(std::move(node.part));
    });
    return relaxation;
  }

  const StagePlan& plan_;
  RelaxedTarget target_;
  Desk& desk_;
  SplitWorth worth_;
  BestFirst<Node> open_;
};

}  // namespace

Relaxation relax(const StagePlan& plan, RelaxedTarget target, std::size_t node_limit, Desk& desk) {
  return RelaxationSearch(plan, target, desk).run(node_limit);
}

bool narrow_one_by_one(const StagePlan& plan,
                       std::span<const Interval> inherited,
                       const Region& region,
                       std::vector<Interval>& sides,
                       std::size_t most_pieces,
                       Desk& desk) {
  for (std::size_t v = 0; v < sides.size(); ++v) {
    const Variable& variable = plan.stage->variables()[v];
    const double narrow = 1e-9 * (variable.upper - variable.lower);
    std::vector<Interval> trial = sides;
    std::vector<Interval> open{sides[v]};
    while (!open.empty() && open.size() <= most_pieces && open.front().upper - open.front().lower > narrow) {
      std::vector<Interval> halves;
      for (const Interval& piece : open) {
        const double cut = middle(piece);
        for (const Interval& half : {Interval(piece.lower, cut), Interval(cut, piece.upper)}) {
          trial[v] = half;
          const auto& answer = desk.bound(*plan.stage, plan.shared, inherited, region, trial);
          if (worst_lower(answer.utilisation) <= 1.0) halves.push_back(half);
        }
      }
      open = std::move(halves);
    }
    if (open.empty()) return false;
    sides[v] = {open.front().lower, open.back().upper};
  }
  return true;
}

namespace {

/// Whether the middle of a box of variables is feasible and of use at the middle of the states: then no proof will
/// succeed.
bool middle_is_feasible(const StagePlan& plan,
                        std::span<const Interval> inherited,
                        const Region& region,
                        std::span<const Interval> box,
                        Desk& desk,
                        const OfNoUse& of_no_use) {
  std::vector<double> state, variables;
  std::vector<Row> rows;
  for (const Interval& side : inherited) state.push_back(middle(side));
  for (const RowSet& set : region.rows) rows.push_back(set->front());
  for (const Interval& side : box) variables.push_back(middle(side));
  const Answer<double>& answer = desk.evaluate(*plan.stage, {plan.shared, state, rows, variables});
  if (!(worst_of(answer.utilisation) <= 1.0)) return false;
  const auto intervals = [](const std::vector<double>& numbers) {
    return std::vector<Interval>(numbers.begin(), numbers.end());
  };
  return !of_no_use ||
         !of_no_use({intervals(answer.utilisation), intervals(answer.resources), intervals(answer.handed_on)});
}

}  // namespace

bool proves_infeasible(const StagePlan& plan,
                       std::span<const Interval> inherited,
                       const Region& region,
                       std::size_t limit,
                       Desk& desk,
                       const OfNoUse& of_no_use) {
  constexpr std::size_t one_by_one_after = 24;  // boxes
  constexpr std::size_t pieces = 16;
  constexpr double narrow = 1e-9;
  std::vector<std::vector<Interval>> open{region.variables};
  for (std::size_t boxes = 0; !open.empty(); ++boxes) {
    if (boxes >= limit) return false;
    if (boxes == one_by_one_after && region.variables.size() > 1) {
      open.assign(1, region.variables);
      if (!narrow_one_by_one(plan, inherited, region, open.front(), pieces, desk)) return true;
    }
    const std::vector<Interval> box = std::move(open.back());
    open.pop_back();
    const auto& answer = desk.bound(*plan.stage, plan.shared, inherited, region, box);
    if (worst_lower(answer.utilisation) > 1.0 || (of_no_use && of_no_use(answer))) continue;
    if (middle_is_feasible(plan, inherited, region, box, desk, of_no_use)) return false;
    const std::size_t widest = widest_side(*plan.stage, box, narrow);
    if (widest == box.size()) return false;
    const double cut = middle(box[widest]);
    open.push_back(box);
    open.back()[widest].lower = cut;
    open.push_back(box);
    open.back()[widest].upper = cut;
  }
  return true;
}

}  // namespace millwright::solver
