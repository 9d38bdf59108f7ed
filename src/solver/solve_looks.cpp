// SPDX-License-Identifier: Apache-2.0
//
// Builds that are looked for before anything is proved: with a good one known, most of what is open is hopeless.
#include <algorithm>
#include <cmath>

#include "solver/solve_run.h"

namespace millwright::solver {
namespace {

/// What a state that uses up all that later stages can bear costs in these looks (StagewiseSearch::look).
constexpr double little_share = 0.03, much_share = 0.3;

}  // namespace

/// For what is as good as a build need be to be looked for.
std::unique_ptr<BranchAndBound> SolveRun::coarsely_label_by_label(std::vector<StagePlan>& plans) {
  constexpr double coarse = 1e-4;
  LeafPrecision precision = precision_for(plans);
  precision.tolerance = std::max(precision.tolerance, coarse);
  return label_by_label(plans, std::move(precision));
}

/// Where continuous variables move the objective: a search of the least bounds first comes upon a build when nearly all
/// that seems better has been refuted, which in long catalogues is most of the work.
void SolveRun::look_for_first_build(std::vector<OpenSearch>& open) {
  constexpr std::uint64_t nodes = 3000;
  if (criteria_.objectives > 1 || !any_covered_ || !control_.options().look_first) return;
  for (OpenSearch& each : open) {
    if (!incumbents_.builds().empty() || control_.time_is_up()) return;
    coarsely_label_by_label(*each.plans)->dive(nodes);
  }
}

/// For any build, in each combination: to prove that there is none in the first may take far longer than to find one
/// in the second, and with one it is easier. Then the combination in which the best build is comes first.
void SolveRun::look_around(std::vector<OpenSearch>& open) {
  if (criteria_.objectives > 1 || open.size() < 2 || !incumbents_.builds().empty()) return;
  if (!control_.options().stagewise || !control_.options().look_first) return;
  if (!look_briefly(open)) return;
  settle_more(open);
  for (const double share : {little_share, much_share})
    for (OpenSearch& each : open)
      if (each.stagewise != nullptr && incumbents_.builds().empty() &&
          !each.stagewise->look(share, StagewiseSearch::many_nodes))
        return;
  if (incumbents_.builds().empty()) return;
  const std::vector<Row>& shared = incumbents_.builds().front().build.shared;
  std::stable_partition(open.begin(), open.end(), [&](const OpenSearch& each) {
    const auto of_search = each.plans->front().shared;
    return std::equal(shared.begin(), shared.end(), of_search.begin(), of_search.end());
  });
}

/// False: there is no time, or the first combination is easy.
bool SolveRun::look_briefly(std::vector<OpenSearch>& open) {
  for (OpenSearch& each : open) {
    if (!incumbents_.builds().empty()) break;
    each.search = nullptr;  // what it knows of the regions may no longer be so
    each.stagewise = std::make_unique<StagewiseSearch>(problem_, criteria_, *each.plans, incumbents_, control_);
    if (!each.stagewise->applicable()) return false;
    const StagewiseSearch::Difficulty difficulty = each.stagewise->find_difficulty();
    if (difficulty == StagewiseSearch::Difficulty::out_of_time) return false;
    if (difficulty == StagewiseSearch::Difficulty::easy) {
      if (&each == &open.front()) return false;
      each.stagewise = nullptr;
    } else if (!each.stagewise->look(little_share, StagewiseSearch::few_nodes)) {
      return false;
    }
  }
  return true;
}

/// Where there is no build yet a longer search label by label is worth its while: all that comes then takes longer.
void SolveRun::settle_more(std::vector<OpenSearch>& open) {
  constexpr std::uint64_t share = 2;
  go_through(open, [&](OpenSearch& each) {
    if (!incumbents_.builds().empty()) return false;
    each.tried = each.stagewise != nullptr;
    return each.tried && settle_briefly(each, share);
  });
}

/// The best build is known only when all that might be better has been looked at, which may take longer than there is
/// time: a good one first.
void SolveRun::look_for_builds(const OpenSearch& open) {
  constexpr double good = 0.01;
  constexpr std::size_t labels = 30, nodes = 30000;
  const bool wanted = control_.options().look_first && std::ranges::any_of(*open.plans, is_covered);
  if (!wanted || incumbents_.best() <= open.score[0] + good * std::fabs(open.score[0])) return;
  coarsely_label_by_label(*open.plans)->look(labels, nodes);
}

}  // namespace millwright::solver
