// SPDX-License-Identifier: Apache-2.0
#include "solver/neighbours.h"

#include <algorithm>

#include "solver/box.h"
#include "solver/criteria.h"

namespace millwright::solver {

namespace {

constexpr Row most_rows = 2000;  // looked at of each slot, evenly spread

}  // namespace

bool Neighbours::fits(const Build& build, std::size_t stage) const {
  const std::vector<Row>& rows = build.stages[stage].rows;
  for (std::size_t slot = 0; slot < rows.size(); ++slot)
    if (!problem_.stages[stage]->offered(build.shared, slot, rows[slot])) return false;
  for (std::size_t a = 0; a < rows.size(); ++a)
    for (std::size_t b = a + 1; b < rows.size(); ++b)
      if (!problem_.stages[stage]->fits(build.shared, a, rows[a], b, rows[b])) return false;
  return true;
}

bool Neighbours::complete(Build& build, std::size_t stage, std::vector<double> resources) const {
  Answer<double> answer;
  for (std::size_t i = stage; i < problem_.stages.size(); ++i) {
    StageChoice& choice = build.stages[i];
    if (i > stage) choice.inherited = answer.handed_on;
    problem_.stages[i]->evaluate({build.shared, choice.inherited, choice.rows, choice.variables}, answer);
    for (const double u : answer.utilisation)
      if (!(u <= 1.0)) return false;
    for (std::size_t r = 0; r < resources.size(); ++r) resources[r] += answer.resources[r];
  }
  for (std::size_t r = 0; r < resources.size(); ++r)
    if (!within_limit(resources[r], problem_.resources[r].limit)) return false;
  build.resources = std::move(resources);
  return true;
}

double Neighbours::worst_utilisation(const Build& build) const {
  double worst = 0.0;
  Answer<double> answer;
  for (std::size_t i = 0; i < problem_.stages.size(); ++i) {
    const StageChoice& choice = build.stages[i];
    problem_.stages[i]->evaluate({build.shared, choice.inherited, choice.rows, choice.variables}, answer);
    worst = std::max(worst, worst_of(answer.utilisation));
  }
  return worst;
}

void Neighbours::visit(const Build& build, std::size_t objective, const Visitor& visitor) const {
  const std::vector<double> none(problem_.resources.size(), 0.0);
  double most = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < build.shared.size(); ++i) {
    Build next = build;
    for (Row row = 0; row < problem_.shared[i].rows; ++row) {
      next.shared[i] = row;
      if (row == build.shared[i]) continue;
      bool all_fit = true;
      for (std::size_t stage = 0; stage < next.stages.size() && all_fit; ++stage) all_fit = fits(next, stage);
      if (all_fit && complete(next, 0, none)) most = visitor(next);
    }
  }
  std::vector<double> before = none;  // of the stages before the one that changes
  Answer<double> answer;
  for (std::size_t i = 0; i < build.stages.size(); ++i) {
    const StageChoice& own = build.stages[i];
    const Stage& stage = *problem_.stages[i];
    stage.evaluate({build.shared, own.inherited, own.rows, own.variables}, answer);
    const std::vector<double> own_share = answer.resources;
    for (std::size_t slot = 0; slot < own.rows.size(); ++slot) {
      const Row rows = stage.slots()[slot].rows;
      const Row step = (rows + most_rows - 1) / most_rows;
      for (Row row = 0; row < rows; row += step) {
        if (row == own.rows[slot]) continue;
        Build next = build;
        next.stages[i].rows[slot] = row;
        if (!fits(next, i)) continue;
        stage.evaluate({next.shared, own.inherited, next.stages[i].rows, own.variables}, answer);
        const bool feasible =
            std::all_of(answer.utilisation.begin(), answer.utilisation.end(), [](double u) { return u <= 1.0; });
        const double total = build.resources[objective] - own_share[objective] + answer.resources[objective];
        if (feasible && total <= most && complete(next, i, before)) most = visitor(next);
      }
    }
    for (std::size_t r = 0; r < before.size(); ++r) before[r] += own_share[r];
  }
}

bool Neighbours::improve_slot(
    Build& build, std::size_t stage, std::size_t slot, const std::vector<double>& before, const Value& value) const {
  const Row rows = problem_.stages[stage]->slots()[slot].rows;
  const Row step = (rows + most_rows - 1) / most_rows;
  double best = value(build.resources);
  bool improved = false;
  Answer<double> answer;
  Build next = build;
  for (Row row = 0; row < rows; row += step) {
    StageChoice& choice = next.stages[stage];
    choice.rows[slot] = row;
    if (!fits(next, stage)) continue;
    problem_.stages[stage]->evaluate({next.shared, choice.inherited, choice.rows, choice.variables}, answer);
    if (!std::all_of(answer.utilisation.begin(), answer.utilisation.end(), [](double u) { return u <= 1.0; })) continue;
    Build whole = next;
    if (!complete(whole, stage, before) || !(value(whole.resources) < best)) continue;
    best = value(whole.resources);
    build = std::move(whole);
    improved = true;
  }
  return improved;
}

Build Neighbours::improved(Build build, const Value& value, const std::function<bool()>& stop) const {
  for (bool again = true; again;) {
    again = false;
    std::vector<double> before(problem_.resources.size(), 0.0);
    Answer<double> answer;
    for (std::size_t i = 0; i < build.stages.size(); ++i) {
      for (std::size_t slot = 0; slot < build.stages[i].rows.size(); ++slot) {
        if (stop()) return build;
        again = improve_slot(build, i, slot, before, value) || again;
      }
      const StageChoice& own = build.stages[i];
      problem_.stages[i]->evaluate({build.shared, own.inherited, own.rows, own.variables}, answer);
      for (std::size_t r = 0; r < before.size(); ++r) before[r] += answer.resources[r];
    }
  }
  return build;
}

void Neighbours::improve_equals(const Criteria& criteria, RankedBuild& best, const std::function<bool()>& stop) const {
  std::vector<double> score(criteria.size());
  for (std::size_t tie = criteria.objectives; tie < criteria.objectives + criteria.ties; ++tie) {
    const std::vector<double> most(best.score.begin(), best.score.begin() + static_cast<std::ptrdiff_t>(tie));
    const auto value = [&](std::span<const double> resources) {
      criteria.scores<double>(resources, score);
      for (std::size_t k = 0; k < most.size(); ++k)
        if (rounded(score[k]) > rounded(most[k])) return std::numeric_limits<double>::infinity();
      return rounded(score[tie]);
    };
    best.build = improved(best.build, value, stop);
    criteria.scores<double>(best.build.resources, best.score);
  }
}

}  // namespace millwright::solver
