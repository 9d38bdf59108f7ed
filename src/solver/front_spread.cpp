// SPDX-License-Identifier: Apache-2.0
#include "solver/front_spread.h"

#include <algorithm>
#include <cmath>

#include "solver/incumbents.h"
#include "solver/nearby.h"

namespace millwright::solver {
namespace {

class FrontSpread {
 public:
  FrontSpread(const Problem& problem, const Options& options, const std::function<bool()>& stop)
      : problem_(problem),
        options_(options),
        stop_(stop),
        criteria_(make_criteria(problem, options)),
        front_(criteria_) {}

  std::vector<Build> run(std::vector<Build> known) {
    for (Build& build : known) offer(std::move(build));
    std::vector<Build> starts;
    for (std::size_t k = 0; k < criteria_.objectives && !front_.builds().empty(); ++k)
      starts.push_back(
          std::ranges::min_element(front_.builds(), {}, [&](const RankedBuild& each) { return each.score[k]; })->build);
    for (const Build& start : starts)
      for (std::size_t k = 0; k < criteria_.objectives; ++k) go_towards(k, start);
    std::vector<RankedBuild> kept;
    for (RankedBuild& each : front_.builds())
      if (std::ranges::none_of(kept, [&](const RankedBuild& other) {
            return criteria_.is_as_good(other.score, each.score, options_.gap);
          }))
        kept.push_back(std::move(each));
    std::vector<Build> result;
    for (RankedBuild& each : kept) result.push_back(std::move(each.build));
    return result;
  }

 private:
  void offer(Build build) {
    std::vector<double> score(criteria_.size());
    criteria_.scores<double>(build.resources, score);
    front_.offer({std::move(score), std::move(build)});
  }

  /// Each step begins where the one before ended, the first as good in all else: the best in one objective alone may
  /// be needlessly bad in this one.
  void go_towards(std::size_t objective, Build at) {
    for (const double share : {0.001, 0.25, 0.5, 0.75, 0.9, 1.0}) {
      if (stop_()) return;
      const Options options = weighted(objective, share, at);
      at = best_nearby(problem_, options, std::move(at), stop_);
      offer(at);
    }
  }

  /// One objective counts by this share and the others by the rest, relative to what they are.
  [[nodiscard]] Options weighted(std::size_t objective, double share, const Build& at) const {
    Options result = options_;
    result.objectives = {options_.objectives[objective]};
    result.ties.clear();
    result.weights.assign(problem_.resources.size(), 0.0);
    const double others = (1.0 - share) / static_cast<double>(criteria_.objectives - 1);
    for (std::size_t k = 0; k < options_.objectives.size(); ++k) {
      const std::size_t resource = options_.objectives[k];
      const double size = std::fabs(at.resources[resource]);
      result.weights[resource] = (k == objective ? share : others) / (size > 0.0 ? size : 1.0);
    }
    return result;
  }

  const Problem& problem_;
  const Options& options_;
  const std::function<bool()>& stop_;
  Criteria criteria_;
  Incumbents front_;
};

}  // namespace

std::vector<Build> spread_front(const Problem& problem,
                                const Options& options,
                                std::vector<Build> known,
                                const std::function<bool()>& stop) {
  return FrontSpread(problem, options, stop).run(std::move(known));
}

}  // namespace millwright::solver
