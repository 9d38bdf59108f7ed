// SPDX-License-Identifier: Apache-2.0
#include "solver/rest_curve.h"

#include <algorithm>
#include <cmath>

#include "solver/best_first.h"
#include "solver/region_order.h"
#include "solver/relaxation.h"

namespace millwright::solver {
namespace {

constexpr double halvings = 10.0;       // of the range of states, down to the first step
constexpr double worth_keeping = 1e-6;  // relative rise of a curve below which it says nothing

/// R_i(s) for one stage, component and score, for rising s. What is infeasible or dear at one s is so at the next, so
/// the search goes on from where it stood: regions are bounded again only when they come up.
class LeastFrom {
 public:
  LeastFrom(
      const StagePlan& plan, std::size_t score, std::size_t component, double most, std::size_t node_limit, Desk& desk)
      : plan_(plan),
        score_(score),
        component_(component),
        most_(most),
        node_limit_(node_limit),
        desk_(desk),
        inherited_(plan.best_inherited),
        worth_(plan.region.rows.size()) {
    for (const OpenRegion& region : plan_.open_regions) {
      Node node;
      node.known = &region;
      open_.push(value_of(region.bounds), std::move(node));
    }
  }

  double at(double state) {
    inherited_[component_] = state;
    ++step_;
    while (!open_.empty() && nodes_ < node_limit_) {
      if (open_.first().undecided && open_.first().step == step_) break;
      const double value = open_.first_key().value;
      if (value > most_) break;
      ++nodes_;
      look_at(open_.pop(), value);
    }
    return open_.empty() ? infinity : open_.first_key().value;
  }

 private:
  struct Node {
    const OpenRegion* known = nullptr;  ///< of the plan, not yet bounded
    OpenRegion part;
    std::size_t step = 0;    ///< at which it was bounded
    bool undecided = false;  ///< a single design that could not be proved infeasible
  };

  [[nodiscard]] double value_of(const Bounds& bounds) const {
    return total_down(bounds.score[score_], rest_after(plan_, score_, bounds.handed_on));
  }
  std::optional<Reached> offer(Region region, double at_least) {
    Node node;
    node.part.region = std::move(region);
    if (!assess(plan_, inherited_, node.part.region, node.part.bounds, desk_)) return std::nullopt;
    note_kept(node.part.bounds, node.part.region);
    node.step = step_;
    const Reached reached{node.part.bounds.utilisation, std::max(at_least, value_of(node.part.bounds))};
    if (!(reached.value < infinity)) return std::nullopt;
    open_.push(reached.value, std::move(node));
    return reached;
  }
  void look_at(Node node, double value) {
    if (node.known != nullptr) {
      offer(node.known->region, value);
    } else if (node.step != step_) {
      node.part.region.kept = 0;
      offer(std::move(node.part.region), value);
    } else if (!node.part.region.one_design_per_slot() || wide_variable(plan_, node.part.region)) {
      const Bounds& bounds = node.part.bounds;
      branch(plan_, node.part.region, bounds.open, {bounds.utilisation, value}, worth_, [&](Region part) {
        return offer(std::move(part), value);
      });
    } else if (!proves_infeasible(plan_, inherited_, node.part.region, usual_proof_boxes, desk_)) {
      node.undecided = true;
      open_.push(value, std::move(node));
    }
  }

  const StagePlan& plan_;
  std::size_t score_, component_;
  double most_;
  std::size_t node_limit_;
  Desk& desk_;
  std::vector<Interval> inherited_;
  SplitWorth worth_;
  BestFirst<Node> open_;
  std::size_t step_ = 0, nodes_ = 0;
};

/// The curve before a stage of few designs, nearly exactly: between two states where it differs it is asked half way.
class FineCurve {
 public:
  FineCurve(const StagePlan& plan, double most, double upper, RestCurve coarse, const CurveEffort& effort, Desk& desk)
      : plan_(plan), most_(most), upper_(upper), coarse_(std::move(coarse)), effort_(effort), desk_(desk) {}

  RestCurve run() {
    curve_ = {coarse_.score, coarse_.component, {coarse_.from.front()}, {coarse_.least.front()}};
    for (std::size_t i = 0; i + 1 < coarse_.from.size(); ++i)
      between(coarse_.from[i], coarse_.least[i], coarse_.from[i + 1], coarse_.least[i + 1]);
    keep(coarse_.from.back(), coarse_.least.back());
    if (upper_ > coarse_.from.back()) {
      const double at_end = std::max(at(upper_), coarse_.least.back());
      between(coarse_.from.back(), coarse_.least.back(), upper_, at_end);
      keep(upper_, at_end);
    }
    return std::move(curve_);
  }

 private:
  double at(double state) {
    ++asked_;
    return LeastFrom(plan_, coarse_.score, coarse_.component, most_, effort_.nodes, desk_).at(state);
  }
  void keep(double from, double least) {
    const double known = curve_.least.back();
    if (!(least > known + worth_keeping * std::fabs(known))) return;
    curve_.from.push_back(from);
    curve_.least.push_back(least);
  }
  void between(double low, double least, double high, double least_there) {
    constexpr double narrow = 1e-3, little = 1e-3;
    constexpr std::size_t most_asked = 100;
    keep(low, least);
    if (!(least_there > least * (1.0 + little)) || !(high - low > narrow * upper_) || asked_ >= most_asked) return;
    const double middle = 0.5 * (low + high);
    const double here = std::clamp(at(middle), least, least_there);
    between(low, least, middle, here);
    between(middle, here, high, least_there);
  }

  const StagePlan& plan_;
  double most_, upper_;
  RestCurve coarse_, curve_;
  const CurveEffort& effort_;
  Desk& desk_;
  std::size_t asked_ = 0;
};

/// The curve before a stage, up to `most`; empty where the component tells nothing.
RestCurve curve_before(const StagePlan& plan,
                       std::size_t score,
                       std::size_t component,
                       double rest,
                       double most,
                       const CurveEffort& effort,
                       Desk& desk) {
  RestCurve curve{score, component, {}, {}};
  const Interval& whole = plan.inherited[component];
  const double best = plan.best_inherited[component].lower;
  if (!(whole.upper > best) || !std::isfinite(whole.upper)) return curve;
  LeastFrom least(plan, score, component, most, effort.nodes, desk);
  double known = rest;
  const auto steps = static_cast<double>(effort.steps);
  for (std::size_t i = 0; i < effort.steps && known < infinity && known <= most; ++i) {
    const double share = i == 0 ? 0.0 : std::exp2(halvings * (static_cast<double>(i) - steps) / steps);
    const double state = best + share * (whole.upper - best);
    const double from_here = least.at(state);
    if (!(from_here > known + worth_keeping * std::fabs(known))) continue;
    known = from_here;
    curve.from.push_back(state);
    curve.least.push_back(known);
  }
  if (curve.from.empty() || !has_few_designs(plan)) return curve;
  return FineCurve(plan, most, whole.upper, std::move(curve), effort, desk).run();
}

}  // namespace

void find_rest_curves(std::vector<StagePlan>& plans,
                      std::span<const double> most,
                      const CurveEffort& effort,
                      Desk& desk) {
  if (plans.empty()) return;
  const Criteria& criteria = *plans.front().criteria;
  // What may be left for a stage and all after it: the stages before it take their least at least.
  std::vector<std::vector<double>> left(plans.size());
  for (std::size_t i = 0; i < plans.size(); ++i) {
    for (std::size_t score = 0; score < criteria.objectives; ++score) {
      constexpr double slack = 1e-9;
      left[i].push_back(i == 0 ? most[score] + slack * std::fabs(most[score])
                               : left[i - 1][score] - plans[i - 1].least[score]);
    }
  }
  for (std::size_t i = plans.size(); i-- > 1;) {
    const StagePlan& plan = plans[i];
    StagePlan& before = plans[i - 1];
    before.curves.clear();
    for (std::size_t score = 0; score < criteria.objectives; ++score) {
      const double rest = total_down(plan.least[score], plan.rest[score]);
      before.rest[score] = std::max(before.rest[score], rest);
      for (std::size_t component = 0; component < plan.before.size(); ++component) {
        if (plan.before[component] != Direction::smaller_is_better) continue;
        RestCurve curve = curve_before(plan, score, component, before.rest[score], left[i][score], effort, desk);
        if (!curve.from.empty()) before.curves.push_back(std::move(curve));
      }
    }
  }
}

}  // namespace millwright::solver
