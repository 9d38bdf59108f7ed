// SPDX-License-Identifier: Apache-2.0
#include "solver/candidates.h"

#include <algorithm>
#include <cmath>

#include "solver/archive.h"
#include "solver/best_first.h"
#include "solver/relaxation.h"
#include "solver/rest_curve.h"

namespace millwright::solver {
namespace {

constexpr std::size_t proof_boxes = 60;

struct Node {
  Region region;
  Bounds bounds;
  std::vector<double> key;
  double value = 0.0;
};

/// A positive sum of a region's coordinates, in the ascending order of which regions are taken.
class Order {
 public:
  explicit Order(const StagePlan& plan) {
    for (std::size_t k = 0; k < plan.criteria->size(); ++k) weight_.push_back(1.0 / (std::fabs(plan.least[k]) + 1e-6));
  }
  /// Of a mix of scores.
  Order(const StagePlan& plan, const Mix& mix) : Order(plan) {
    const double unit = std::fabs(mix.of(plan.least)) + 1e-6;
    weight_[0] = mix.first / unit;
    weight_[1] = mix.second / unit;
  }
  [[nodiscard]] double value_of(std::span<const double> key, double weighed_state = 0.0) const {
    constexpr double state_weight = 1e-4;  // decides between equal scores
    double value = weighed_state;
    for (std::size_t i = 0; i < key.size(); ++i) value += key[i] * (i < weight_.size() ? weight_[i] : state_weight);
    return value;
  }

 private:
  std::vector<double> weight_;
};

/// The two halves of a region, less rows without a partner.
template <class Offer>
void branch(const StagePlan& plan, const Node& node, Offer&& offer) {
  const RowProfile::Split split = plan.profile.split(node.region, node.bounds.open);
  for (const RowSet& half : {split.left, split.right}) {
    Region region = node.region;
    region.rows[split.slot] = half;
    if (plan.fits.filter(region, split.slot)) offer(std::move(region));
  }
}

class Search {
 public:
  Search(const CandidateQuestion& question, Desk& desk)
      : question_(question),
        plan_(*question.plan),
        comparison_(*question.comparison),
        desk_(desk),
        order_(question.mix ? Order(plan_, *question.mix) : Order(plan_)),
        totals_(question.totals),
        total_stairs_(question.total_stairs),
        total_vectors_(question.total_vectors),
        known_(comparison_.dimensions()) {
    for (const Interval& side : question.states) set_.reference.push_back(middle(side));
    // From a lower bound over H to one at the reference state: the linear part is taken to the worst corner and back.
    for (std::size_t h = 0; h < question.states.size(); ++h) {
      double low = 0.0;
      double high = 0.0;
      for (std::size_t c = 0; c < question.states.size(); ++c) {
        const double slope = question.form->slope[h][c];
        const double at_lower = slope * (set_.reference[c] - question.states[c].lower);
        const double at_upper = slope * (set_.reference[c] - question.states[c].upper);
        low += std::max(at_lower, at_upper);
        high += std::min(at_lower, at_upper);
      }
      to_reference_.emplace_back(low, high);
    }
    // What is handed on over H, as if nothing had been inherited.
    std::vector<double> own(set_.reference.size());
    const std::vector<double> nothing(set_.reference.size(), 0.0);
    for (std::size_t h = 0; h < own.size(); ++h)
      own[h] = to_reference_[h].first - question.form->change(h, nothing, set_.reference);
    const auto priced = [&](const std::vector<double>& weight) {
      double sum = 0.0;
      for (std::size_t h = 0; h < own.size(); ++h)
        if (weight[h] != 0.0) sum += weight[h] * own[h];
      return sum;
    };
    for (RestPlane& plane : totals_) plane.constant += priced(plane.weight);
    for (RestStairs& stairs : total_stairs_) {
      stairs.constant += priced(stairs.weight);
      stairs.limit -= priced(stairs.use);
    }
    for (std::size_t a = 0; a < total_vectors_.limit.size(); ++a)
      total_vectors_.limit[a] -= priced(total_vectors_.use[a]);
  }

  CandidateSet run() {
    offer(plan_.region);
    while (!open_.empty() && set_.nodes < question_.node_limit) {
      const Node node = open_.pop();
      if (!count()) break;
      look_at(node);
    }
    if (set_.complete && !question_.mix && set_.candidates.empty() && set_.nodes >= question_.node_limit)
      look_for_feasible();
    drop_dominated();
    return std::move(set_);
  }

 private:
  /// False: stopped, or it takes too long.
  bool count() {
    const bool stopped = ++set_.nodes % 64 == 0 && question_.stop && question_.stop();
    set_.complete = set_.complete && !stopped && set_.nodes <= question_.patience;
    return set_.complete;
  }

  void look_at(const Node& node) {
    if (known_.dominates(node.key)) return;
    if (node.region.one_design_per_slot())
      settle(node);
    else
      branch(plan_, node, [&](Region region) { offer(std::move(region)); });
  }

  /// Where there are many nearly equal rows the cheapest regions are all infeasible or still large when the limit is
  /// reached. So they are taken in the order of value and strain together; the more strain weighs, the surer and the
  /// dearer is what is found.
  void look_for_feasible() {
    for (const double weight : {0.5, 2.0, 8.0, 32.0}) {
      if (!set_.complete || !set_.candidates.empty()) return;
      look_with(weight);
    }
  }
  void look_with(double strain_weight) {
    constexpr std::size_t enough = 4, fewest_nodes = 400;
    BestFirst<Node> open;
    const auto offer_here = [&](Region region) {
      std::optional<Node> node = assess_region(std::move(region));
      if (!node) return;
      const double value = node->value + strain_weight * strain(node->region);
      open.push(value, std::move(*node));
    };
    offer_here(plan_.region);
    for (std::size_t nodes = 0; nodes < std::max(question_.node_limit, fewest_nodes) && !open.empty() && count();
         ++nodes) {
      const Node node = open.pop();
      if (!node.region.one_design_per_slot())
        branch(plan_, node, offer_here);
      else
        settle(node);
      if (set_.candidates.size() >= enough) return;
    }
  }

  /// How far a typical design of a region is from keeping its constraints: what their utilisations, as logarithms, are
  /// above 1 in sum.
  double strain(const Region& region) {
    std::vector<Interval> variables;
    for (const Interval& side : region.variables) variables.emplace_back(middle(side));
    const auto& answer = desk_.bound(*plan_.stage, plan_.shared, question_.states, region, variables);
    double sum = 0.0;
    for (const Interval& u : answer.utilisation) {
      const double square = std::max(u.lower, 1e-3) * std::min(u.upper, 1e3);
      if (square > 1.0) sum += 0.5 * std::log(square);
    }
    return sum;
  }

  void offer(Region region) {
    std::optional<Node> node = assess_region(std::move(region));
    if (!node) return;
    const double value = node->value;
    open_.push(value, std::move(*node));
  }

  /// The region with its bounds and its value; nothing when it can be left out.
  std::optional<Node> assess_region(Region region) {
    Node node;
    node.region = std::move(region);
    read_bounds(plan_, desk_.bound(*plan_.stage, plan_.shared, question_.states, node.region), node.bounds);
    if (node.bounds.utilisation > 1.0) return std::nullopt;
    if (!below_staircase(question_.useful, node.bounds.score[0], plan_.criteria->second(node.bounds.score)))
      return std::nullopt;
    if (!may_lead_on(node.bounds)) return std::nullopt;
    const bool guided = question_.mix && !total_vectors_.add.empty();
    if (guided) node.value = least_total(node.bounds);
    for (std::size_t h = 0; h < to_reference_.size(); ++h) {
      node.bounds.handed_on[h].lower += to_reference_[h].first;
      node.bounds.handed_on[h].upper += to_reference_[h].second;
    }
    node.key.resize(comparison_.dimensions());
    comparison_.best_key(node.bounds.score, node.bounds.handed_on, node.key.data());
    if (known_.dominates(node.key)) return std::nullopt;
    note_kept(node.bounds, node.region);
    if (!cut_variables(plan_, question_.states, node.region, node.bounds, desk_)) return std::nullopt;
    note_kept(node.bounds, node.region);
    if (guided) return node;
    double weighed_state = 0.0;
    for (std::size_t h = 0; h < question_.state_weight.size(); ++h)
      weighed_state += question_.state_weight[h] * node.bounds.handed_on[h].lower;
    node.value = order_.value_of(node.key, weighed_state);
    return node;
  }

  /// Of the mix, with some label and what must follow.
  [[nodiscard]] double least_total(const Bounds& bounds) const {
    return total_vectors_.least(
        *question_.mix,
        {bounds.score[0], plan_.criteria->second(bounds.score)},
        [&](std::size_t h) { return bounds.handed_on[h].lower; },
        question_.corners);
  }
  /// Whether the cheapest label with a design of these bounds, and what must follow then, is below some corner.
  [[nodiscard]] bool may_lead_on(const Bounds& bounds) const {
    if ((plan_.curves.empty() && plan_.planes.empty()) || question_.corners.empty()) return true;
    double second = question_.least.second + plan_.criteria->second(bounds.score);
    if (plan_.criteria->objectives > 1) second += rest_after(plan_, 1, bounds.handed_on);
    LeastTotals totals(question_.least.first + bounds.score[0] + rest_after(plan_, 0, bounds.handed_on), second);
    const auto lower = [&](std::size_t h) { return bounds.handed_on[h].lower; };
    const auto add_all = [&](const auto& all) {
      for (const auto& each : all) totals.add(each.mix, each.mix.of(bounds.score) + rest_by(each, lower));
    };
    add_all(totals_);
    add_all(total_stairs_);
    return totals.below(question_.corners) &&
           (total_vectors_.add.empty() ||
            total_vectors_.reach({bounds.score[0], plan_.criteria->second(bounds.score)}, lower, question_.corners));
  }

  /// Values of the variables at which every utilisation is <= 1 over all of H, if some are found.
  bool find_universal(const Node& node, std::vector<double>& variables) {
    const std::vector<Interval>& box = node.region.variables;
    std::vector<Interval> point(box.size());
    for (const double part : {0.5, 1.0, 0.0, 0.75, 0.25}) {
      for (std::size_t v = 0; v < box.size(); ++v) {
        variables[v] = std::clamp(box[v].lower + part * (box[v].upper - box[v].lower), box[v].lower, box[v].upper);
        point[v] = variables[v];
      }
      const auto& answer = desk_.bound(*plan_.stage, plan_.shared, question_.states, node.region, point);
      if (std::all_of(
              answer.utilisation.begin(), answer.utilisation.end(), [](const Interval& u) { return u.upper <= 1.0; })) {
        return true;
      }
      if (box.empty()) return false;
    }
    return false;
  }

  void settle(const Node& node) {
    Candidate candidate;
    candidate.variables.resize(node.region.variables.size());
    candidate.universal = find_universal(node, candidate.variables);
    if (!candidate.universal && proves_infeasible(plan_, question_.states, node.region, proof_boxes, desk_)) return;
    for (const RowSet& set : node.region.rows) candidate.rows.push_back(set->front());
    const auto& answer =
        desk_.evaluate(*plan_.stage, Point{plan_.shared, set_.reference, candidate.rows, candidate.variables});
    candidate.score.resize(plan_.criteria->size());
    plan_.criteria->scores<double>(answer.resources, candidate.score);
    candidate.least = answer.handed_on;
    candidate.most = answer.handed_on;
    take_range(node, candidate);
    candidate.key.resize(comparison_.dimensions());
    comparison_.best_key(candidate.score, candidate.least, candidate.most, candidate.key.data());
    if (known_.dominates(candidate.key)) return;
    if (candidate.universal) known_.add(worst_key(candidate));
    set_.candidates.push_back(std::move(candidate));
  }

  /// What the form does not tell exactly, over all of H.
  void take_range(const Node& node, Candidate& candidate) {
    const std::vector<bool>& exact = question_.form->exact;
    if (question_.form->all_exact()) return;
    std::vector<Interval> variables = node.region.variables;
    if (candidate.universal) variables.assign(candidate.variables.begin(), candidate.variables.end());
    const auto& answer = desk_.bound(*plan_.stage, plan_.shared, question_.states, node.region, variables);
    for (std::size_t h = 0; h < exact.size(); ++h) {
      if (exact[h]) continue;
      candidate.least[h] = answer.handed_on[h].lower + to_reference_[h].first;
      candidate.most[h] = answer.handed_on[h].upper + to_reference_[h].second;
    }
  }
  [[nodiscard]] std::vector<double> worst_key(const Candidate& candidate) const {
    std::vector<double> key(comparison_.dimensions());
    comparison_.best_key(candidate.score, candidate.most, candidate.least, key.data());
    return key;
  }

  /// A universal design found late may dominate one found early when both have the same sum.
  void drop_dominated() {
    std::vector<Candidate>& all = set_.candidates;
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
      return a.key != b.key ? a.key < b.key : a.universal > b.universal;
    });
    Archive known(comparison_.dimensions());
    std::erase_if(all, [&](const Candidate& candidate) {
      if (known.dominates(candidate.key)) return true;
      if (candidate.universal) known.add(worst_key(candidate));
      return false;
    });
  }

  const CandidateQuestion& question_;
  const StagePlan& plan_;
  const Comparison& comparison_;
  Desk& desk_;
  Order order_;
  BestFirst<Node> open_;
  std::vector<RestPlane> totals_;  ///< of handed-on states as they are bounded over H
  std::vector<RestStairs> total_stairs_;
  RestVectors total_vectors_;
  Archive known_;
  std::vector<std::pair<double, double>> to_reference_;  ///< [handed-on component]: for lower and upper bounds
  CandidateSet set_;
};

}  // namespace

CandidateSet find_candidates(const CandidateQuestion& question, Desk& desk) { return Search(question, desk).run(); }

std::vector<Pair> least_front(const StagePlan& plan, std::size_t node_limit, Desk& desk) {
  const Order order(plan);
  BestFirst<Node> open;
  Archive known(2);
  std::vector<Pair> found;
  const auto offer = [&](Region region) {
    Node node;
    node.region = std::move(region);
    read_bounds(plan, desk.bound(*plan.stage, plan.shared, plan.best_inherited, node.region), node.bounds);
    if (node.bounds.utilisation > 1.0) return;
    node.key = {node.bounds.score[0], plan.criteria->second(node.bounds.score)};
    if (known.dominates(node.key)) return;
    note_kept(node.bounds, node.region);
    if (cut_variables(plan, plan.best_inherited, node.region, node.bounds, desk)) {
      note_kept(node.bounds, node.region);
      const double value = order.value_of(node.key);
      open.push(value, std::move(node));
    }
  };
  offer(plan.region);
  for (std::size_t nodes = 0; !open.empty() && nodes < node_limit; ++nodes) {
    const Node node = open.pop();
    if (known.dominates(node.key)) continue;
    if (!node.region.one_design_per_slot()) {
      branch(plan, node, offer);
    } else if (!proves_infeasible(plan, plan.best_inherited, node.region, proof_boxes, desk)) {
      known.add(node.key);
      found.push_back({node.key[0], node.key[1]});
    }
  }
  open.for_each([&](const Node& node) { found.push_back({node.key[0], node.key[1]}); });
  return lower_staircase(std::move(found));
}

}  // namespace millwright::solver
