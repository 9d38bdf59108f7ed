// SPDX-License-Identifier: Apache-2.0
#include "solver/candidates.h"

#include <algorithm>
#include <cmath>

#include "solver/best_first.h"
#include "solver/candidate_groups.h"
#include "solver/least_state.h"
#include "solver/region_order.h"
#include "solver/relaxation.h"
#include "solver/set_proofs.h"

namespace millwright::solver {
namespace {

constexpr std::size_t endless = std::numeric_limits<std::size_t>::max();

class CandidateSearch {
 public:
  CandidateSearch(std::span<const CandidateQuestion* const> questions, Desk& desk)
      : question_(*questions.front()),
        plan_(*question_.plan),
        comparison_(*question_.comparison),
        desk_(desk),
        worth_(plan_.region.rows.size()),
        order_(question_.mix ? RegionOrder(plan_, comparison_.scores(), *question_.mix)
                             : RegionOrder(plan_, comparison_.scores())),
        groups_(questions),
        known_(questions.size(), KnownKeys(comparison_)),
        sets_(questions.size()),
        node_limit_(question_.node_limit) {
    if (node_limit_ < endless && questions.size() > 1) node_limit_ *= 2;  // several share what they look at
    for (std::size_t group = 0; group < sets_.size(); ++group) sets_[group].reference = groups_.reference(group);
  }

  std::vector<CandidateSet> run() {
    offer(plan_.region, groups_.all());
    while (!open_.empty() && nodes_ < node_limit_) {
      Node node = open_.pop();
      if (!count()) break;
      look_at(node);
    }
    if (complete_ && !question_.mix && nodes_ >= node_limit_ && nothing_found()) look_for_feasible();
    for (std::size_t group = 0; group < sets_.size(); ++group) {
      drop_dominated(sets_[group].candidates);
      sets_[group].complete = complete_;
    }
    sets_.front().nodes = nodes_;
    return std::move(sets_);
  }

 private:
  using View = CandidateGroups::View;
  struct Node {
    Region region;
    Bounds bounds;
    GroupSet groups = 0;         ///< to which it may matter
    const View* view = nullptr;  ///< over whose states the bounds are
    double value = 0.0;
  };

  /// False: stopped, or it takes too long.
  bool count() {
    const bool stopped = ++nodes_ % 64 == 0 && question_.stop && question_.stop();
    complete_ = complete_ && !stopped && nodes_ <= question_.patience;
    return complete_;
  }
  [[nodiscard]] bool nothing_found() const {
    return std::all_of(sets_.begin(), sets_.end(), [](const CandidateSet& set) { return set.candidates.empty(); });
  }

  void look_at(Node& node) {
    if (!leave_out_dominated(node)) return;
    if (refuted_by_variables(node)) return;
    if (node.region.one_design_per_slot())
      settle(node);
    else if (nodes_ > nodes_together && !std::has_single_bit(node.groups))
      divide_groups(node);
    else
      divide(node, [&](Region part) { return offer(std::move(part), node.groups); });
  }

  /// Whether dividing the variables proves that no design of a node's region is feasible, or, where they move what is
  /// handed on, that none is both feasible and of use. False: not proved, or not worth the questions (set_proofs.h).
  bool refuted_by_variables(const Node& node) {
    const bool moves = plan_.moved_state.has_value();
    const bool single = node.region.one_design_per_slot();  // `settle` asks whether that is feasible
    if (node.region.variables.empty() || (single && !moves) || !set_proofs_.worth_asking(nodes_)) return false;
    OfNoUse of_no_use;
    if (moves) of_no_use = [&](const Answer<Interval>& answer) { return matters_to_no_group(node, answer); };
    const std::uint64_t before = desk_.evaluations;
    const bool refuted =
        proves_infeasible(plan_, node.view->states, node.region, SetProofs::boxes_for(node.region), desk_, of_no_use);
    set_proofs_.count({desk_.evaluations - before, refuted});
    return refuted;
  }

  /// What bounds say of a part of a node's region: infeasible, or for every group too dear or dominated.
  bool matters_to_no_group(const Node& node, const Answer<Interval>& answer) {
    read_bounds(plan_, answer, part_);
    if (part_.utilisation > 1.0) return true;
    bool matters = false;
    for_each_group(node.groups, [&](std::size_t group) {
      if (matters || !groups_.may_matter(group, *node.view, part_)) return;
      groups_.best_key(group, *node.view, part_, key_);
      matters = !known_[group].dominates(key_);
    });
    return !matters;
  }

  template <class Offer>
  void divide(const Node& node, Offer&& offer) {
    branch(plan_, node.region, node.bounds.open, {node.bounds.utilisation, node.value}, worth_, offer);
  }
  /// Regions that are feasible for no group, each for its own reason, may be many: then groups are asked about apart.
  static constexpr std::uint64_t nodes_together = 20000;

  /// The same region for either half of the groups.
  void divide_groups(const Node& node) {
    GroupSet first = node.groups;
    for (int left = (std::popcount(node.groups) + 1) / 2; left > 0; --left) first &= first - 1;
    offer(node.region, first);
    offer(node.region, node.groups & ~first);
  }

  /// Where there are many nearly equal rows the cheapest regions are all infeasible or still large when the limit is
  /// reached. So they are taken in the order of value and strain together; the more strain weighs, the surer and the
  /// dearer is what is found.
  void look_for_feasible() {
    for (const double weight : {0.5, 2.0, 8.0, 32.0}) {
      if (!complete_ || !nothing_found()) return;
      look_with(weight);
    }
  }
  void look_with(double strain_weight) {
    constexpr std::size_t enough = 4, fewest_nodes = 400;
    BestFirst<Node> open;
    const auto offer_here = [&](Region region) -> std::optional<Reached> {
      std::optional<Node> node = assess_region(std::move(region), groups_.all());
      if (!node) return std::nullopt;
      const Reached reached{node->bounds.utilisation, node->value};
      const double value = node->value + strain_weight * strain(*node);
      open.push(value, std::move(*node));
      return reached;
    };
    offer_here(plan_.region);
    for (std::size_t nodes = 0; nodes < std::max(node_limit_, fewest_nodes) && !open.empty() && count(); ++nodes) {
      const Node node = open.pop();
      if (!node.region.one_design_per_slot())
        divide(node, offer_here);
      else
        for_each_group(node.groups, [&](std::size_t group) { settle_alone(node, group); });
      const auto has_enough = [](const CandidateSet& set) { return set.candidates.size() >= enough; };
      if (std::any_of(sets_.begin(), sets_.end(), has_enough)) return;
    }
  }

  /// How far a typical design of a region is from keeping its constraints: what their utilisations, as logarithms, are
  /// above 1 in sum.
  double strain(const Node& node) {
    std::vector<Interval> variables;
    for (const Interval& side : node.region.variables) variables.emplace_back(middle(side));
    const auto& answer = desk_.bound(*plan_.stage, plan_.shared, node.view->states, node.region, variables);
    double sum = 0.0;
    for (const Interval& u : answer.utilisation) {
      const double square = std::max(u.lower, 1e-3) * std::min(u.upper, 1e3);
      if (square > 1.0) sum += 0.5 * std::log(square);
    }
    return sum;
  }

  /// Nothing when it can be left out.
  std::optional<Reached> offer(Region region, GroupSet groups) {
    std::optional<Node> node = assess_region(std::move(region), groups);
    if (!node) return std::nullopt;
    const Reached reached{node->bounds.utilisation, node->value};
    open_.push(reached.value, std::move(*node));
    return reached;
  }

  /// The region with its bounds and its value; nothing when it can be left out for all of these groups.
  std::optional<Node> assess_region(Region region, GroupSet groups) {
    Node node;
    node.region = std::move(region);
    node.view = &groups_.view(groups);
    const std::vector<Interval>& states = node.view->states;
    read_bounds(plan_, desk_.bound(*plan_.stage, plan_.shared, states, node.region), node.bounds);
    if (node.bounds.utilisation > 1.0) return std::nullopt;
    for_each_group(groups, [&](std::size_t group) {
      if (groups_.may_matter(group, *node.view, node.bounds)) node.groups |= GroupSet{1} << group;
    });
    if (!leave_out_dominated(node)) return std::nullopt;
    node.value = value_of(node);
    note_kept(node.bounds, node.region);
    if (!cut_variables(plan_, states, node.region, node.bounds, desk_)) return std::nullopt;
    note_kept(node.bounds, node.region);
    return node;
  }

  double value_of(const Node& node) {
    if (question_.mix && !question_.total_vectors.add.empty()) {
      double least = std::numeric_limits<double>::infinity();
      for_each_group(node.groups, [&](std::size_t group) {
        least = std::min(least, groups_.least_total(group, *node.view, node.bounds));
      });
      return least;
    }
    groups_.best_own_key(*node.view, node.bounds, key_);
    double weighed_state = 0.0;
    for (std::size_t h = 0; h < question_.state_weight.size(); ++h)
      weighed_state += question_.state_weight[h] * (node.bounds.handed_on[h].lower + node.view->to_own_share[h].first);
    return order_.value_of(key_, weighed_state);
  }

  /// False: a universal design is at least as good for every group.
  bool leave_out_dominated(Node& node) {
    GroupSet left = 0;
    for_each_group(node.groups, [&](std::size_t group) {
      groups_.best_key(group, *node.view, node.bounds, key_);
      if (!known_[group].dominates(key_)) left |= GroupSet{1} << group;
    });
    node.groups = left;
    return left != 0;
  }

  /// Values of the variables at which every utilisation is <= 1 at all these states, if some are found.
  bool find_universal(const Region& region, std::span<const Interval> states, std::vector<double>& variables) {
    const std::vector<Interval>& box = region.variables;
    std::vector<Interval> point(box.size());
    for (const double part : {0.5, 1.0, 0.0, 0.75, 0.25}) {
      for (std::size_t v = 0; v < box.size(); ++v) {
        variables[v] = std::clamp(box[v].lower + part * (box[v].upper - box[v].lower), box[v].lower, box[v].upper);
        point[v] = variables[v];
      }
      const auto& answer = desk_.bound(*plan_.stage, plan_.shared, states, region, point);
      if (std::all_of(
              answer.utilisation.begin(), answer.utilisation.end(), [](const Interval& u) { return u.upper <= 1.0; })) {
        return true;
      }
      if (box.empty()) return false;
    }
    return false;
  }

  /// A single design. What is not proved for all groups at once is asked for fewer of them.
  void settle(const Node& node) {
    if (plan_.moved_state) return for_each_group(node.groups, [&](std::size_t group) { settle_least(node, group); });
    std::vector<double> variables(node.region.variables.size());
    if (std::has_single_bit(node.groups))
      settle_alone(node, static_cast<std::size_t>(std::countr_zero(node.groups)));
    else if (find_universal(node.region, node.view->states, variables))
      for_each_group(node.groups, [&](std::size_t group) { take(node, group, variables, true); });
    else
      divide_groups(node);
  }
  void settle_alone(const Node& node, std::size_t group) {
    std::vector<double> variables(node.region.variables.size());
    const std::vector<Interval>& states = groups_.question(group).states;
    const bool universal = find_universal(node.region, states, variables);
    if (universal || !proves_infeasible(plan_, states, node.region, usual_proof_boxes, desk_))
      take(node, group, variables, universal);
  }

  /// A single design of which one best point counts (least_state.h).
  void settle_least(const Node& node, std::size_t group) {
    constexpr std::size_t most_boxes = 60;
    const std::vector<Interval>& states = groups_.question(group).states;
    LeastState found = find_least_state(plan_, states, node.region, {}, most_boxes, desk_);
    if (found.infeasible()) return;
    const bool universal = found.universal();
    if (!universal)
      for (const Interval& side : node.region.variables) found.variables.push_back(middle(side));
    take(node, group, found.variables, universal, &found);
  }

  /// `least`: where one best point counts.
  void take(const Node& node,
            std::size_t group,
            const std::vector<double>& variables,
            bool universal,
            const LeastState* least = nullptr) {
    CandidateSet& set = sets_[group];
    Candidate candidate;
    candidate.variables = variables;
    candidate.universal = universal;
    for (const RowSet& rows : node.region.rows) candidate.rows.push_back(rows->front());
    const auto& answer =
        desk_.evaluate(*plan_.stage, Point{plan_.shared, set.reference, candidate.rows, candidate.variables});
    candidate.score.resize(plan_.criteria->size());
    plan_.criteria->scores<double>(answer.resources, candidate.score);
    candidate.most_score = candidate.score;
    candidate.least = answer.handed_on;
    candidate.most = answer.handed_on;
    take_range(node.region, group, candidate);
    if (least != nullptr) take_least(*least, group, candidate);
    candidate.key.resize(comparison_.dimensions());
    comparison_.best_key(candidate.score, candidate.least, candidate.most, candidate.key.data());
    if (known_[group].dominates(candidate.key)) return;
    if (candidate.universal) known_[group].add(worst_key(candidate));
    set.candidates.push_back(std::move(candidate));
  }

  /// What the form does not tell exactly, over all states of the group.
  void take_range(const Region& region, std::size_t group, Candidate& candidate) {
    const std::vector<bool>& exact = question_.form->exact;
    if (question_.form->all_exact()) return;
    const View& view = groups_.view(GroupSet{1} << group);
    std::vector<Interval> variables = region.variables;
    if (candidate.universal) variables.assign(candidate.variables.begin(), candidate.variables.end());
    const auto& answer = desk_.bound(*plan_.stage, plan_.shared, view.states, region, variables);
    for (std::size_t h = 0; h < exact.size(); ++h) {
      if (exact[h]) continue;
      candidate.least[h] = answer.handed_on[h].lower + view.of(group).to_reference[h].first;
      candidate.most[h] = answer.handed_on[h].upper + view.of(group).to_reference[h].second;
    }
    if (!question_.form->scores_vary()) return;
    std::vector<Interval> score(candidate.score.size());
    plan_.criteria->scores<Interval>(answer.resources, score);
    for (std::size_t k = 0; k < score.size(); ++k) {
      candidate.score[k] = score[k].lower;
      candidate.most_score[k] = score[k].upper;
    }
  }
  /// Of the component that variables move.
  void take_least(const LeastState& found, std::size_t group, Candidate& candidate) {
    const std::size_t h = *plan_.moved_state;
    const auto& to_reference = groups_.view(GroupSet{1} << group).of(group).to_reference[h];
    if (plan_.after[h] == Direction::larger_is_better)
      candidate.most[h] = -found.least + to_reference.second;
    else
      candidate.least[h] = found.least + to_reference.first;
    const double slack = equal_sums * std::fabs(candidate.most[h]);
    candidate.is_least = candidate.universal && candidate.least[h] >= candidate.most[h] - slack;
  }
  [[nodiscard]] std::vector<double> worst_key(const Candidate& candidate) const {
    std::vector<double> key(comparison_.dimensions());
    comparison_.best_key(candidate.most_score, candidate.most, candidate.least, key.data());
    return key;
  }

  /// A universal design found late may dominate one found early when both have the same sum.
  void drop_dominated(std::vector<Candidate>& all) const {
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
      return a.key != b.key ? a.key < b.key : a.universal > b.universal;
    });
    KnownKeys known(comparison_);
    std::erase_if(all, [&](const Candidate& candidate) {
      if (known.dominates(candidate.key)) return true;
      if (candidate.universal) known.add(worst_key(candidate));
      return false;
    });
  }

  const CandidateQuestion& question_;  ///< of the first group: what all have in common
  const StagePlan& plan_;
  const Comparison& comparison_;
  Desk& desk_;
  SplitWorth worth_;
  SetProofs set_proofs_;
  RegionOrder order_;
  BestFirst<Node> open_;
  CandidateGroups groups_;
  std::vector<KnownKeys> known_;    ///< [group]: universal designs
  std::vector<CandidateSet> sets_;  ///< [group]
  std::vector<double> key_;
  Bounds part_;  ///< of a node's region
  std::size_t node_limit_;
  std::uint64_t nodes_ = 0;
  bool complete_ = true;
};

}  // namespace

std::vector<CandidateSet> find_candidates(std::span<const CandidateQuestion* const> questions, Desk& desk) {
  return CandidateSearch(questions, desk).run();
}

}  // namespace millwright::solver
