// SPDX-License-Identifier: Apache-2.0
#include "solver/least_front.h"

#include <algorithm>
#include <array>

#include "solver/archive.h"
#include "solver/best_first.h"
#include "solver/region_order.h"
#include "solver/relaxation.h"

namespace millwright::solver {

std::vector<Pair> least_front(const StagePlan& plan, std::size_t node_limit, Desk& desk) {
  struct Node {
    Region region;
    Bounds bounds;
    std::vector<double> key;
    double value = 0.0;
  };
  constexpr std::array<std::size_t, 2> first_two = {0, 1};
  const RegionOrder order(plan, std::span(first_two).first(std::min<std::size_t>(plan.criteria->size(), 2)));
  BestFirst<Node> open;
  Archive known(2);
  std::vector<Pair> found;
  SplitWorth worth(plan.region.rows.size());
  const auto offer = [&](Region region) -> std::optional<Reached> {
    Node node;
    node.region = std::move(region);
    read_bounds(plan, desk.bound(*plan.stage, plan.shared, plan.best_inherited, node.region), node.bounds);
    if (node.bounds.utilisation > 1.0) return std::nullopt;
    node.key = {node.bounds.score[0], plan.criteria->second(node.bounds.score)};
    if (known.dominates(node.key)) return std::nullopt;
    note_kept(node.bounds, node.region);
    if (!cut_variables(plan, plan.best_inherited, node.region, node.bounds, desk)) return std::nullopt;
    note_kept(node.bounds, node.region);
    node.value = order.value_of(node.key);
    const Reached reached{node.bounds.utilisation, node.value};
    open.push(reached.value, std::move(node));
    return reached;
  };
  offer(plan.region);
  for (std::size_t nodes = 0; !open.empty() && nodes < node_limit; ++nodes) {
    const Node node = open.pop();
    if (known.dominates(node.key)) continue;
    if (!node.region.one_design_per_slot()) {
      branch(plan, node.region, node.bounds.open, {node.bounds.utilisation, node.value}, worth, offer);
    } else if (!proves_infeasible(plan, plan.best_inherited, node.region, usual_proof_boxes, desk)) {
      known.add(node.key);
      found.push_back({node.key[0], node.key[1]});
    }
  }
  open.for_each([&](const Node& node) { found.push_back({node.key[0], node.key[1]}); });
  return lower_staircase(std::move(found));
}

}  // namespace millwright::solver
