// SPDX-License-Identifier: Apache-2.0
#include "evaluation/best_front.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "evaluation/allowed_time.h"
#include "evaluation/best_build.h"
#include "solver/front_spread.h"

namespace millwright::evaluation {

namespace {

/// A front that is ended by its time limit would show what was met on the way only, from one end of it or nothing at
/// all, and prove nothing: the last two fifths of the time, two seconds at least if that is no more than half of it,
/// are for the best builds by each objective and builds from all over the front, and then for proving from these what
/// can be proved in so much time.
double time_to_cover(double limit) { return std::max(0.4 * limit, std::min(2.0, 0.5 * limit)); }

/// A front that has used up the memory goes on for so much of the time that it took: what it asks for then is a part of
/// what it had.
constexpr double part_after_memory = 0.4;

/// The objectives by which a build is best at an end of the front. Where none is known, by cost before all: that way
/// one is found soonest.
std::vector<std::string> ends_of(const MachineModel& model, const SearchOptions& options, bool none_known) {
  std::vector<std::string> ends;
  for (const std::string& objective : options.objectives)
    if (!is_left_out(model, options, objective)) ends.push_back(objective);
  if (none_known) {
    std::erase(ends, "cost");
    ends.insert(ends.begin(), "cost");
  }
  return ends;
}

}  // namespace

solver::Summary best_front(const MachineModel& model, const SearchOptions& options) {
  const AllowedTime time(options.time_limit_seconds);
  solver::Options front = solver_options(model, options);
  if (std::isfinite(options.time_limit_seconds))
    front.time_limit_seconds = options.time_limit_seconds - time_to_cover(options.time_limit_seconds);
  solver::Summary summary = solver::solve(model.problem(), front);
  const auto is_stopped = [&] { return options.stop != nullptr && options.stop->load(); };
  double left = time.left();
  const bool resumed = summary.status == solver::Status::limit && is_stopped() && options.resume && options.resume();
  if (resumed) left = std::min(left, part_after_memory * time.used());
  if (summary.status != solver::Status::limit || is_stopped() || !(left > 0.0)) return summary;
  const AllowedTime rest(left);
  const double to_cover = std::isfinite(left) ? 0.5 * left : 0.0;
  const auto time_left = [&] { return std::max(0.0, rest.left() - to_cover); };
  const auto stop = [&] { return time_left() == 0.0 || is_stopped(); };
  const std::vector<std::string> ends = ends_of(model, options, summary.builds.empty());
  for (std::size_t k = 0; k < ends.size() && !stop(); ++k) {
    SearchOptions single = options;
    single.objectives = {ends[k]};
    // As much is left for the spreading as each of them gets, or a little if there is no build yet to go on from.
    const double share = summary.builds.empty() ? 0.8 : 1.0 / static_cast<double>(ends.size() - k + 1);
    single.time_limit_seconds = share * time_left();
    single.progress = nullptr;  // it would tell of another objective
    single.confirm = false;
    solver::Summary found = best_build(model, single);
    summary.nodes += found.nodes;
    summary.evaluations += found.evaluations;
    std::move(found.builds.begin(), found.builds.end(), std::back_inserter(summary.builds));
    if (found.status == solver::Status::infeasible && summary.builds.empty()) {  // of any front, then
      summary.status = found.status;
      summary.front_tolerance = 0.0;
      summary.seconds = time.used();
      return summary;
    }
  }
  summary.builds = solver::spread_front(model.problem(), front, std::move(summary.builds), stop);
  summary.method += resumed ? "; when memory was used up" : "; when time was nearly up";
  summary.method += ", the best by each objective, and from those builds all over the front";
  summary.front_tolerance += options.gap;  // builds as good but for the gap are left out of it
  front.time_limit_seconds = rest.left();
  if (!is_stopped() && to_cover > 0.0 && front.time_limit_seconds > 0.0) {
    solver::Summary covered = solver::cover_front(model.problem(), front, summary.builds);
    summary.nodes += covered.nodes;
    summary.evaluations += covered.evaluations;
    summary.builds = std::move(covered.builds);
    summary.front_tolerance = std::min(summary.front_tolerance + options.gap, covered.front_tolerance);
    summary.status = covered.status;
    summary.method += "; then label by label, to a tolerance that rose with the time";
    if (covered.status == solver::Status::optimal && covered.front_tolerance > 0.0)
      summary.method += "; where continuous variables move the objectives the front is covered to its tolerance";
  }
  summary.seconds = time.used();
  return summary;
}

}  // namespace millwright::evaluation
