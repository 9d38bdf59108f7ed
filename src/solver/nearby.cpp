// SPDX-License-Identifier: Apache-2.0
#include "solver/nearby.h"

#include <algorithm>
#include <cmath>

#include "solver/criteria.h"
#include "solver/multipliers.h"
#include "solver/neighbours.h"

namespace millwright::solver {
namespace {

class Nearby {
 public:
  Nearby(const Problem& problem, const Options& options, const std::function<bool()>& stop)
      : problem_(problem),
        options_(options),
        stop_(stop),
        criteria_(make_criteria(problem, options)),
        neighbours_(problem),
        score_(criteria_.size()) {}

  Build run(Build build) {
    constexpr double little = 1e-9;
    for (double before = value(build.resources); !stop_();) {
      build = neighbours_.improved(
          std::move(build), [this](std::span<const double> resources) { return value(resources); }, stop_);
      if (!stop_()) move_variables(build);
      const double now = value(build.resources);
      if (!(now < before - little * std::fabs(before))) break;
      before = now;
    }
    build.worst_utilisation = neighbours_.worst_utilisation(build);
    return build;
  }

 private:
  double value(std::span<const double> resources) {
    criteria_.scores<double>(resources, score_);
    return score_[0];
  }

  /// Local solvers end on constraints or a little beyond: where all variables together do not go all the way or a part
  /// of it, each goes by itself.
  void move_variables(Build& build) {
    const Build moved = settled(problem_, options_, build, stop_);
    if (move(build, [&](std::size_t i, std::size_t v) { return moved.stages[i].variables[v]; })) return;
    for (std::size_t stage = 0; stage < build.stages.size(); ++stage)
      for (std::size_t variable = 0; variable < build.stages[stage].variables.size(); ++variable)
        if (!stop_())
          move(build, [&, from = build](std::size_t i, std::size_t v) {
            return (i == stage && v == variable ? moved : from).stages[i].variables[v];
          });
  }

  static void go(double& from, double to, double part) {
    from = std::clamp(from + part * (to - from), std::min(from, to), std::max(from, to));
  }
  /// Towards these values, as far as that is feasible and better.
  template <class Values>
  bool move(Build& build, Values&& values) {
    for (const double part : {1.0, 1.0 - 1e-6, 0.99, 0.5}) {
      Build trial = build;
      for (std::size_t i = 0; i < trial.stages.size(); ++i)
        for (std::size_t v = 0; v < trial.stages[i].variables.size(); ++v)
          go(trial.stages[i].variables[v], values(i, v), part);
      if (!neighbours_.evaluate(trial) || !(value(trial.resources) < value(build.resources))) continue;
      build = std::move(trial);
      return true;
    }
    return false;
  }

  const Problem& problem_;
  const Options& options_;
  const std::function<bool()>& stop_;
  Criteria criteria_;
  Neighbours neighbours_;
  std::vector<double> score_;
};

}  // namespace

Build best_nearby(const Problem& problem, const Options& options, Build build, const std::function<bool()>& stop) {
  return Nearby(problem, options, stop).run(std::move(build));
}

}  // namespace millwright::solver
