// SPDX-License-Identifier: Apache-2.0
#include "solver/branch_and_bound.h"

#include <algorithm>
#include <array>
#include <utility>

#include "solver/easing.h"
#include "solver/relaxation.h"
#include "solver/rest_curve.h"
#include "solver/variable_halves.h"

namespace millwright::solver {
namespace {

constexpr std::size_t batch_size = 8;

std::vector<OpenBox::Origin> origins_of(const std::vector<OpenBox>& boxes) {
  std::vector<OpenBox::Origin> origins;
  for (const OpenBox& box : boxes) origins.push_back(box.origin);
  std::sort(origins.begin(), origins.end());
  origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
  if (origins.front() == UndecidedDesigns::everything) origins.clear();
  return origins;
}

std::vector<Row> rows_of(const Region& design) {
  std::vector<Row> rows;
  for (const RowSet& set : design.rows) rows.push_back(set->front());
  return rows;
}

}  // namespace

BranchAndBound::BranchAndBound(const Problem& problem,
                               const Criteria& criteria,
                               std::vector<StagePlan>& plans,
                               Incumbents& incumbents,
                               SearchControl& control,
                               LeafPrecision precision)
    : problem_(problem),
      criteria_(criteria),
      plans_(plans),
      incumbents_(incumbents),
      control_(control),
      precision_(std::move(precision)) {
  const bool by_point = precision_.refined_later || precision_.refinements > 0;
  slack_ = slack_of_labels();
  const Dominating by = by_point ? Dominating::point : Dominating::lower_bound;
  // What is exact in a single objective has few labels at a time.
  const bool many_labels = criteria_.objectives > 1 || std::ranges::any_of(plans_, is_covered);
  for (const StagePlan& plan : plans_) {
    label_sets_.emplace_back(criteria_, plan.before, labels_, by, slack_);
    worth_.emplace_back(plan.region.rows.size());
    set_proofs_.emplace_back();
    const bool shares = many_labels && !shared_.empty() && !plan.region.rows.empty();
    shared_.push_back(shares ? std::make_unique<SharedRegions>(plan, control_.desk(0)) : nullptr);
    auto& tail = tail_.emplace_back();
    for (const OpenRegion& part : plan.open_regions) {
      auto& least = tail.emplace_back(criteria_.size());
      for (std::size_t k = 0; k < least.size(); ++k) {
        least[k] =
            total_down(std::max(part.bounds.score[k], plan.least[k]), rest_after(plan, k, part.bounds.handed_on));
      }
    }
    for (std::size_t i = tail.size(); i-- > 1;) {
      for (std::size_t k = 0; k < criteria_.size(); ++k) tail[i - 1][k] = std::min(tail[i - 1][k], tail[i][k]);
    }
  }
  rate_objectives();
}

void BranchAndBound::put(Node node) {
  const double later = later_for_divisions_ > 0.0 ? later_for_divisions_ * divisions_left(node) : 0.0;
  const Key key{rounded(order_of(node) + later), node.depth, ++order_};
  open_.push(key, std::move(node));
}

/// False: it is useless.
bool BranchAndBound::push(Node node) {
  if (useless(node)) return false;
  if (labels_[node.label].stage > last_stage_) {
    waiting_.push_back(std::move(node));
    return true;
  }
  put(std::move(node));
  return true;
}

/// The node that stands for all open regions of the plan from `region` on.
bool BranchAndBound::make_stream(std::uint32_t index, std::size_t region, Node& node) const {
  const Label& label = labels_[index];
  const StagePlan& plan = plans_[label.stage];
  if (region >= plan.open_regions.size()) return false;
  node.label = index;
  node.next_region = region;
  node.utilisation = label.utilisation;
  node.depth = static_cast<std::uint32_t>(label.stage * 1000);
  node.score.resize(criteria_.size());
  for (std::size_t k = 0; k < node.score.size(); ++k) {
    double least = tail_[label.stage][region][k];
    if (label.stage > 0) least = std::max(least, rest_after(plans_[label.stage - 1], k, label.enclosure));
    node.score[k] = total_down(label.score_lower[k], least);
  }
  criteria_.raise(node.score);
  return true;
}

/// Bounds a region with the label's own state. False: nothing feasible in it.
bool BranchAndBound::bound_node(Node& node, Desk& desk) const {
  const Label& label = labels_[node.label];
  const StagePlan& plan = plans_[label.stage];
  thread_local Bounds bounds;
  if (!assess(plan, label.enclosure, node.region, bounds, desk)) return false;
  node.region.kept = ~bounds.telling;  // equals are decided by the worst utilisation
  node.handed_on = bounds.handed_on;
  note_scores(bounds, node);
  return true;
}

/// What bounds say of a node's label with what it hands on.
void BranchAndBound::note_scores(const Bounds& bounds, Node& node) const {
  const Label& label = labels_[node.label];
  const StagePlan& plan = plans_[label.stage];
  node.score.resize(criteria_.size());
  node.reached.resize(criteria_.size());
  for (std::size_t k = 0; k < node.score.size(); ++k) {
    node.reached[k] = total_down(label.score_lower[k], std::max(bounds.score[k], plan.least[k]));
    node.score[k] = total_down(node.reached[k], rest_after(plan, k, node.handed_on));
  }
  criteria_.raise(node.score);
  node.utilisation = std::max({node.utilisation, label.utilisation, bounds.utilisation});
  node.open = bounds.open;
}

/// A part of a node's region, bounded with its label's own state.
void BranchAndBound::offer(const Node& from, Region part, Outcome& outcome, Desk& desk) const {
  Node child;
  child.label = from.label;
  child.region = std::move(part);
  child.utilisation = from.utilisation;  // constraints that are kept are not looked at any more
  child.depth = from.depth + 1;
  if (!bound_node(child, desk)) return;
  child.take_over_bounds(from);
  outcome.nodes.push_back(std::move(child));
}

/// From one on, the first open region of the plan that may matter to a label. Those that are hopeless even at the best
/// state need not be bounded with its own.
std::size_t BranchAndBound::first_to_follow(const Label& label, std::size_t region) const {
  const StagePlan& plan = plans_[label.stage];
  std::vector<double> score(criteria_.size());
  for (; region < plan.open_regions.size(); ++region) {
    const Bounds& best = plan.open_regions[region].bounds;
    for (std::size_t k = 0; k < score.size(); ++k) {
      const double own = std::max(best.score[k], plan.least[k]);
      score[k] = total_down(total_down(label.score_lower[k], own), rest_after(plan, k, best.handed_on));
    }
    criteria_.raise(score);
    if (can_end(score) && !incumbents_.hopeless(score, std::max(label.utilisation, best.utilisation))) break;
  }
  return region;
}

void BranchAndBound::expand_stream(const Node& node, Outcome& outcome, Desk& desk) const {
  const Label& label = labels_[node.label];
  const StagePlan& plan = plans_[label.stage];
  const std::size_t region = first_to_follow(label, node.next_region);
  if (region == plan.open_regions.size()) return;
  if (shares_regions(node.label))
    go_down(node, shared_[label.stage]->part_of(*cells_[node.label], region, desk), node.score[0], outcome);
  else
    offer(node, plan.open_regions[region].region, outcome, desk);
  Node others;
  if (make_stream(node.label, region + 1, others)) outcome.nodes.push_back(std::move(others));
}

/// Of variables that decide feasibility only (or move the least handed on, least_state.h): others are divided anyway.
bool BranchAndBound::refuted_by_variables(const Node& node, Outcome& outcome, Desk& desk) const {
  const Label& label = labels_[node.label];
  const StagePlan& plan = plans_[label.stage];
  if (node.region.variables.empty() || is_covered(plan) || !set_proofs_[label.stage].worth_asking(nodes_)) return false;
  const std::uint64_t before = desk.evaluations;
  const bool refuted = proves_infeasible(plan, label.enclosure, node.region, SetProofs::boxes_for(node.region), desk);
  outcome.asked = SetProofs::Asked{desk.evaluations - before, refuted};
  return refuted;
}

void BranchAndBound::branch(const Node& node, Outcome& outcome, Desk& desk) const {
  const Label& label = labels_[node.label];
  const StagePlan& plan = plans_[label.stage];
  std::vector<double> least = node.reached;
  for (std::size_t k = 0; k < least.size(); ++k) least[k] -= label.score_lower[k];
  if (const auto variable = variable_to_halve(plan, label.enclosure, node.region, least, desk)) {
    auto [lower, upper] = halved(node.region, *variable);
    offer(node, std::move(lower), outcome, desk);
    offer(node, std::move(upper), outcome, desk);
    return;
  }
  const RowProfile::Split split = plan.profile.split(node.region, node.open, worth_[label.stage].of_slots());
  outcome.divided = split.slot;
  for (const RowSet& half : {split.left, split.right}) {
    Region part = node.region;
    part.rows[split.slot] = half;
    if (plan.fits.filter(part, split.slot)) offer(node, std::move(part), outcome, desk);
  }
}

void BranchAndBound::expand(const Node& node, Outcome& outcome, Desk& desk) const {
  if (node.next_region != whole_stage) {
    expand_stream(node, outcome, desk);
  } else if (node.part != nullptr) {
    expand_part(node, outcome, desk);
  } else if (!node.region.one_design_per_slot()) {
    if (!refuted_by_variables(node, outcome, desk)) branch(node, outcome, desk);
  } else {
    const Label& label = labels_[node.label];
    const std::size_t stage = label.stage;
    outcome.boxes = precision_.among.boxes(label.origins, rows_of(node.region));
    if (outcome.boxes.empty()) return;
    outcome.is_leaf = true;
    const LeafQuestion question{
        &plans_[stage],
        &label,
        &node.region,
        precision_.tolerance,
        true,
        [&](const Worth& own) {
          return useless(label, stage, {own.score, own.state, std::max(own.utilisation, node.utilisation)});
        },
        [&] { return control_.time_is_up(); },
        outcome.boxes,
        precision_.refined_later};
    outcome.leaf = solve_leaf(question, desk);
  }
}

void BranchAndBound::merge(Node& node, Outcome& outcome) {
  if (outcome.asked) set_proofs_[labels_[node.label].stage].count(*outcome.asked);
  std::array<std::optional<Reached>, 2> parts;  // that a region was divided into
  for (std::size_t i = 0; i < outcome.nodes.size(); ++i) {
    const Reached reached{outcome.nodes[i].utilisation, outcome.nodes[i].score[0]};
    if (push(std::move(outcome.nodes[i])) && i < parts.size()) parts[i] = reached;
  }
  if (outcome.divided)
    for (const std::optional<Reached>& part : parts)
      worth_[labels_[node.label].stage].count(*outcome.divided, {node.utilisation, node.score[0]}, part);
  if (!outcome.is_leaf) return;
  for (const StagePoint& point : outcome.leaf.points)
    arrive(node, point, origins_of(point.boxes.empty() ? outcome.boxes : point.boxes));
  if (!outcome.leaf.undecided) return;
  const Label& label = labels_[node.label];
  std::vector<double> score = outcome.leaf.undecided_score;
  for (std::size_t k = 0; k < score.size(); ++k) {
    score[k] = total_down(total_down(label.score_lower[k], score[k]), plans_[label.stage].rest[k]);
  }
  leave_undecided(
      {std::move(score), node.utilisation, node.label, rows_of(node.region), std::move(outcome.leaf.undecided_boxes)});
}

/// A design of a stage becomes a label of the next, or a build.
void BranchAndBound::arrive(const Node& node, const StagePoint& point, std::vector<OpenBox::Origin> origins) {
  const Label& from = labels_[node.label];
  Label label;
  label.parent = node.label;
  label.stage = from.stage + 1;
  label.rows = rows_of(node.region);
  label.variables = point.variables;
  label.boxes = point.boxes;
  label.origins = std::move(origins);
  label.resources = from.resources;
  for (std::size_t r = 0; r < label.resources.size(); ++r) label.resources[r] += point.resources[r];
  label.score.resize(criteria_.size());
  criteria_.scores<double>(label.resources, label.score);
  label.exact = from.exact && point.exact;
  label.feasible = from.feasible && point.feasible;
  label.score_lower = label.score;
  if (!label.exact) {
    for (std::size_t k = 0; k < label.score.size(); ++k) {
      label.score_lower[k] = std::min(label.score[k], total_down(from.score_lower[k], point.score_lower[k]));
    }
    // What is no better in the objectives is dominated by this label. It must be no better in their sums, too, or both
    // could be given up: this one by a guide, with its point, where that is not feasible in the end.
    criteria_.lower_guides(label.score_lower);
  }
  label.state = point.state;
  label.enclosure = point.enclosure;
  label.utilisation = std::max(from.utilisation, point.utilisation);
  if (label.stage == plans_.size()) {
    finish(std::move(label));
    return;
  }
  const Worth worth{label.score_lower, label.enclosure, label.utilisation};
  const std::vector<double> total = with_rest(from.stage, label.score_lower, label.enclosure);
  if (!can_end(total) || label_sets_[label.stage].dominates(worth, total)) return;
  keep_boxes(label.boxes);
  labels_.push_back(std::move(label));
  const auto index = static_cast<std::uint32_t>(labels_.size() - 1);
  if (labels_.back().feasible) label_sets_[labels_.back().stage].add(index);
  follow(index);
}

void BranchAndBound::finish(Label label) {
  RankedBuild ranked;
  ranked.score = label.score;
  ranked.build = build_of(label);
  if (label.feasible) {
    ease(problem_, criteria_, plans_, ranked.build, control_.desk(0));
    incumbents_.offer(std::move(ranked));
  }
  // What the points stand for may be better than they are: it may keep a limit that they do not, or be more than the
  // tolerance better where several stages gave up a part of it.
  if (label.exact) return;
  leave_undecided({std::move(label.score_lower), 0.0, label.parent, std::move(label.rows), std::move(label.boxes)});
}

Build BranchAndBound::build_of(const Label& last) const {
  Build build;
  build.shared.assign(plans_.front().shared.begin(), plans_.front().shared.end());
  build.stages.resize(plans_.size());
  build.resources = last.resources;
  build.worst_utilisation = last.utilisation;
  const Label* label = &last;
  for (std::size_t stage = plans_.size(); stage-- > 0;) {
    const Label& before = labels_[label->parent];
    build.stages[stage] = StageChoice{label->rows, label->variables, before.state};
    label = &before;
  }
  return build;
}

double BranchAndBound::open_bound() const {
  double bound = undecided_bound_;
  open_.for_each([&](const Node& node) { bound = std::min(bound, node.score[0]); });
  return bound;
}

void BranchAndBound::start() {
  labels_.push_back(first_label(problem_, criteria_));
  const OpenBox::Origin root = precision_.among.root();
  if (root != UndecidedDesigns::everything) labels_.back().origins = {root};
  follow(0);
}

void BranchAndBound::work_on_batch() {
  std::vector<Node> batch;
  while (!open_.empty() && batch.size() < batch_size) {
    Node node = open_.pop();
    if (!useless(node)) batch.push_back(std::move(node));
  }
  outcomes_.assign(batch.size(), {});
  // To wake the crew takes longer than to follow what is known.
  std::vector<std::size_t> long_ones;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    find_region(batch[i]);
    if (asks_nothing(batch[i])) {
      expand(batch[i], outcomes_[i], control_.desk(0));
      outcomes_[i].divided.reset();  // by another one
    } else {
      long_ones.push_back(i);
    }
  }
  control_.crew().run(long_ones.size(), [&](std::size_t i, unsigned thread) {
    expand(batch[long_ones[i]], outcomes_[long_ones[i]], control_.desk(thread));
  });
  control_.nodes += batch.size();
  nodes_ += batch.size();
  for (std::size_t i = 0; i < batch.size(); ++i) merge(batch[i], outcomes_[i]);
  for (const auto& shared : shared_)
    if (shared != nullptr) shared->count();
}

SearchResult BranchAndBound::run(std::uint64_t most_nodes) {
  if (labels_.empty()) start();
  const std::uint64_t before = nodes_;
  while (!open_.empty()) {
    if (control_.time_is_up() || nodes_ - before >= most_nodes) return {false, open_bound()};
    widen();
    work_on_batch();
    if (open_.empty()) break;
    const auto bound = [&] {
      return rates_.empty() ? std::min(open_.first().score[0], undecided_bound_) : open_bound();
    };
    control_.report(bound, incumbents_.best());
  }
  forget_settled();
  return {undecided_.empty(), undecided_bound_};
}

}  // namespace millwright::solver
