// SPDX-License-Identifier: Apache-2.0
#include "solver/easing.h"

#include "solver/leaf_point.h"
#include "solver/neighbours.h"

namespace millwright::solver {
namespace {

class Easing {
 public:
  Easing(const Problem& problem, const Criteria& criteria, Build& build)
      : neighbours_(problem), criteria_(criteria), build_(build) {
    score_.resize(criteria.size());
    criteria.scores<double>(build.resources, score_);
  }

  /// False: the build would not be as good, and stays as it is.
  bool take(Build changed) {
    if (!neighbours_.evaluate(changed)) return false;
    std::vector<double> score(criteria_.size());
    criteria_.scores<double>(changed.resources, score);
    for (std::size_t k = 0; k < score.size(); ++k)
      if (rounded(score[k]) > rounded(score_[k])) return false;
    build_ = std::move(changed);
    return true;
  }

  /// As far as that can be.
  void move(std::size_t stage, const std::vector<double>& to) {
    constexpr int halvings = 12;
    const std::vector<double> from = build_.stages[stage].variables;
    double near = 0.0, far = 1.0;
    for (int i = 0; i <= halvings; ++i) {
      const double part = i == 0 ? 1.0 : 0.5 * (near + far);
      Build changed = build_;
      for (std::size_t v = 0; v < to.size(); ++v)
        changed.stages[stage].variables[v] = part == 1.0 ? to[v] : from[v] + part * (to[v] - from[v]);
      const bool taken = take(std::move(changed));
      if (part == 1.0 && taken) return;
      (taken ? near : far) = part;
    }
  }

  [[nodiscard]] double worst() const { return neighbours_.worst_utilisation(build_); }

 private:
  Neighbours neighbours_;
  const Criteria& criteria_;
  Build& build_;
  std::vector<double> score_;
};

}  // namespace

void ease(
    const Problem& problem, const Criteria& criteria, const std::vector<StagePlan>& plans, Build& build, Desk& desk) {
  Build eased = build;
  std::vector<std::size_t> stages;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const StagePlan& plan = plans[i];
    if (!plan.moved_state) continue;
    const Region region = region_of(*plan.stage, plan.shared, build.stages[i].rows, plan.region.variables);
    Label before;
    before.state = build.stages[i].inherited;
    const LeafQuestion question{.plan = &plan, .label = &before, .region = &region};
    LeafDesign(question, desk).relieve(eased.stages[i].variables, region.variables);
    if (eased.stages[i].variables != build.stages[i].variables) stages.push_back(i);
  }
  if (stages.empty()) return;
  Easing easing(problem, criteria, build);
  if (!easing.take(eased))
    for (const std::size_t i : stages) easing.move(i, eased.stages[i].variables);
  build.worst_utilisation = easing.worst();
}

}  // namespace millwright::solver
