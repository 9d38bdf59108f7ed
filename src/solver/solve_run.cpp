// SPDX-License-Identifier: Apache-2.0
#include "solver/solve_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "solver/confirmation.h"
#include "solver/method_sentence.h"
#include "solver/neighbours.h"

namespace millwright::solver {

Summary SolveRun::run() {
  if (problem_.stages.empty()) throw std::invalid_argument("Problem::stages is empty");
  if (!has_empty_slot(problem_) && find_some_first()) search();
  better_among_equals();
  leave_out_noise();
  return summary();
}

/// What is known already; of several objectives what is better known before the search. False: there is no build at
/// all.
bool SolveRun::find_some_first() {
  constexpr double small = 1e3;  // combinations below which none of it is worth its while
  const Options& options = control_.options();
  if (!known_.empty()) {
    take_known();
    return true;
  }
  const bool ends = criteria_.objectives == 2 && !options.stagewise;
  const bool sides = criteria_.objectives == 3 && options.stagewise && options.look_first;
  if ((!ends && !sides) || !(search_space(problem_) > small)) return true;
  if (sides) return find_sides();
  find_ends();
  return true;
}

/// Solves for other objectives first: what is found counts here too.
Summary SolveRun::solve_first(Options options, Scope scope) {
  options.confirm = false;
  options.settle_ties = false;
  options.progress = nullptr;  // it would tell of other objectives
  Summary found = SolveRun(problem_, options, scope, tables_).run();
  control_.earlier_nodes += found.nodes;
  earlier_evaluations_ += found.evaluations;
  for (const Build& build : found.builds) incumbents_.offer({scores_of(build), build});
  return found;
}

std::vector<double> SolveRun::scores_of(const Build& build) const {
  std::vector<double> score(criteria_.size());
  criteria_.scores<double>(build.resources, score);
  return score;
}

/// The two ends of a front by themselves: they bound it, and their distance says what rate between the objectives is
/// worth a guide.
void SolveRun::find_ends() {
  std::vector<std::vector<double>> ends;
  for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
    Options options = control_.options();
    options.ties.insert(options.ties.begin(), options.objectives[1 - first]);
    options.objectives = {options.objectives[first]};
    options.time_limit_seconds -= control_.seconds();
    const Summary end = solve_first(std::move(options), Scope::all);
    if (end.builds.empty()) return;
    ends.push_back(scores_of(end.builds[0]));
  }
  add_guides_between(ends[0], ends[1]);
}

/// Builds that another run has found, and guides by how far they lie apart.
void SolveRun::take_known() {
  for (const Build& build : known_) incumbents_.offer({scores_of(build), build});
  if (incumbents_.builds().empty() || criteria_.objectives == 1) return;
  if (criteria_.objectives == 3) return add_guides_between_sides();
  const std::vector<double> first = incumbents_.builds().front().score;
  const std::vector<double> last = incumbents_.builds().back().score;
  add_guides_between(first, last);
}

void SolveRun::add_guides_between(std::span<const double> first_end, std::span<const double> second_end) {
  const double rise = second_end[0] - first_end[0];
  const double fall = first_end[1] - second_end[1];
  if (rise > 0.0 && fall > 0.0) add_guides(criteria_, std::array{rise, fall});
  for (RankedBuild& ranked : incumbents_.builds()) ranked.score = scores_of(ranked.build);
}

/// Of three objectives, by how far the builds known lie apart in each.
void SolveRun::add_guides_between_sides() {
  std::vector<double> apart;
  for (std::size_t k = 0; k < criteria_.objectives; ++k) {
    double least = infinity, most = -infinity;
    for (const RankedBuild& ranked : incumbents_.builds()) {
      least = std::min(least, ranked.score[k]);
      most = std::max(most, ranked.score[k]);
    }
    apart.push_back(most - least);
  }
  add_guides(criteria_, apart);
  for (RankedBuild& ranked : incumbents_.builds()) ranked.score = scores_of(ranked.build);
}

/// For what is best in two of three objectives there is a build on the front that is as good in these two. Stage by
/// stage (stagewise_search.h) such are found soon, where that method applies, while a search in all three that ends at
/// the limit may have come upon a few builds only. Nothing is proved by it but that there may be no build at all: then
/// false.
bool SolveRun::find_sides() {
  constexpr double share = 0.1;  // of the time left, for each
  for (std::size_t other = 0; other < 3 && !control_.time_is_up(); ++other) {
    Options options = control_.options();
    options.objectives.erase(options.objectives.begin() + static_cast<std::ptrdiff_t>(other));
    options.time_limit_seconds = share * (options.time_limit_seconds - control_.seconds());
    if (solve_first(std::move(options), Scope::stage_by_stage).status == Status::infeasible) return false;
  }
  add_guides_between_sides();
  return true;
}

/// Within the tolerance of continuous variables a search does not ask what decides between equals. So parts of the
/// best build are changed one by one for such as are better in that and no worse in the objective. (Incumbents would
/// not take such a build: within the tolerance the one known is as good.)
void SolveRun::better_among_equals() {
  if (criteria_.objectives != 1 || criteria_.ties == 0 || incumbents_.builds().empty()) return;
  if (!complete_) among_equals_ = AmongEquals::some;
  if (!any_covered_) return;
  RankedBuild& best = incumbents_.builds().front();
  searched_best_ = best.score[0];
  const Neighbours neighbours(problem_);
  neighbours.improve_equals(criteria_, best, [this] { return control_.time_is_up(); });
  best.build.worst_utilisation = neighbours.worst_utilisation(best.build);
  if (auto other = best_among_equals()) best = std::move(*other);
}

/// Parts that only together are better: the least in the first tie of all builds that are no worse in the objective, if
/// that is found soon, and is better by more than searches leave open.
std::optional<RankedBuild> SolveRun::best_among_equals() {
  const Options& asked = control_.options();
  if (!asked.settle_ties || !asked.weights.empty() || asked.ties.empty()) return std::nullopt;
  among_equals_ = AmongEquals::some;
  if (!complete_) return std::nullopt;
  const RankedBuild& best = incumbents_.builds().front();
  const std::size_t objective = asked.objectives.front(), tie = asked.ties.front();
  Problem within = problem_;
  double& limit = within.resources[objective].limit;
  limit = std::min(limit, best.build.resources[objective]);
  Options options = asked;
  options.objectives = {tie};
  options.ties.erase(options.ties.begin());
  options.confirm = false;
  options.progress = nullptr;  // it would tell of another objective
  options.time_limit_seconds -= control_.seconds();
  const std::uint64_t nodes = control_.nodes + control_.earlier_nodes;
  options.most_nodes = std::min(4 * nodes + 500, nodes / 2 + 6000);
  const Summary found = SolveRun(within, options, Scope::unpriced, tables_).run();
  control_.earlier_nodes += found.nodes;
  earlier_evaluations_ += found.evaluations;
  if (found.status != Status::optimal) return std::nullopt;
  among_equals_ = AmongEquals::all;
  const Build& build = found.builds.front();
  for (const std::size_t each : asked.ties) {
    const double known = best.build.resources[each], other = build.resources[each];
    const double room = asked.gap * std::fabs(known);
    if (other < known - room) return RankedBuild{scores_of(build), build};
    if (other > known + room) break;
  }
  return std::nullopt;
}

/// Continuous variables are found within the gap only, so that of two builds the one may be lighter by that noise, for
/// money. Of a front those are left out that another one, which stays, beats by more than the gap, and does not fall
/// short of by more. (No more than a little of the tolerance, whatever the gap: what builds settle and labels give up
/// leaves 5 %.)
void SolveRun::leave_out_noise() {
  constexpr double little = 0.02;
  if (!any_covered_ || criteria_.objectives < 2) return;
  const double gap = std::min(control_.options().gap, little * tolerated());
  std::vector<RankedBuild>& builds = incumbents_.builds();
  std::vector<bool> left_out(builds.size(), false);
  const auto stands_in_for = [&](const RankedBuild& a, const RankedBuild& b) {
    bool beats = false;
    for (std::size_t k = 0; k < criteria_.objectives; ++k)
      beats = beats || a.score[k] < b.score[k] - gap * std::fabs(b.score[k]);
    return beats && criteria_.is_as_good(a.score, b.score, gap);
  };
  // Whoever stands in for a build must stay itself: of a chain each would fall short of the next by the gap.
  std::vector<bool> stands_in(builds.size(), false);
  for (std::size_t i = 0; i < builds.size(); ++i) {
    for (std::size_t j = 0; j < builds.size() && !stands_in[i] && !left_out[i]; ++j) {
      if (left_out[j] || !stands_in_for(builds[j], builds[i])) continue;
      left_out[i] = stands_in[j] = true;
    }
  }
  std::vector<RankedBuild> left;
  for (std::size_t i = 0; i < builds.size(); ++i)
    if (!left_out[i]) left.push_back(std::move(builds[i]));
  builds = std::move(left);
}

/// To what tolerance the builds known settle what is left open; what is not, is searched on with the one it had.
void SolveRun::widen_to_settle(const std::function<void()>& settle) {
  const double tolerance = incumbents_.tolerance();
  if (left_tolerance_ > tolerance) incumbents_.set_tolerance(left_tolerance_);
  settle();
  left_tolerance_ = incumbents_.tolerance();
  incumbents_.set_tolerance(tolerance);
}

/// What the builds of a front settle, and what its labels have given up; beyond that `leave_out_noise`, and whoever
/// adds builds later, may leave out one for another that falls short of it by the gap.
double SolveRun::proved_tolerance() {
  if (complete_ && (incumbents_.builds().empty() || !is_widened())) return asked_tolerance();
  const auto says_nothing = [&](const std::vector<double>& score) {
    return std::any_of(score.begin(), score.begin() + static_cast<std::ptrdiff_t>(criteria_.objectives), [](double x) {
      return x == -infinity;
    });
  };
  if (std::ranges::any_of(left_open_, says_nothing)) return infinity;
  widen_to_settle([&] {
    for (const std::vector<double>& score : left_open_) incumbents_.widen_to_settle(score, 0.0);
  });
  const double proved = left_tolerance_ + slack_given_ + control_.options().gap;
  return incumbents_.builds().empty() || !(proved < 1.0) ? infinity : std::max(asked_tolerance(), proved);
}

Summary SolveRun::summary() {
  Summary out;
  out.combinations = search_space(problem_);
  out.nodes = control_.nodes + control_.earlier_nodes;
  out.evaluations = control_.evaluations() + earlier_evaluations_;
  const double best = incumbents_.best();
  // What the tolerance gave up may be better by so much.
  const double searched = std::min(best, searched_best_);
  const double settled = std::isfinite(best) ? searched - incumbents_.tolerance() * std::fabs(searched) : infinity;
  out.lower_bound = std::min(settled, open_bound_);
  for (const RankedBuild& ranked : incumbents_.builds()) out.builds.push_back(ranked.build);
  if (criteria_.objectives == 1 && out.builds.size() > 1) out.builds.resize(1);
  out.gap = std::isfinite(best) ? (best - out.lower_bound) / std::max(std::fabs(best), 1e-300) : infinity;
  if (criteria_.objectives > 1) out.front_tolerance = proved_tolerance();
  const bool closed = criteria_.objectives > 1 ? out.front_tolerance <= asked_tolerance()
                                               : complete_ || out.gap <= control_.options().gap;
  out.status = !closed ? Status::limit : out.builds.empty() ? Status::infeasible : Status::optimal;
  out.seconds = control_.seconds();
  out.method = sentence_of({any_covered_,
                            criteria_.objectives > 1 && closed,
                            stagewise_,
                            !known_.empty(),
                            allowances_priced_,
                            settled_by_front_,
                            among_equals_,
                            limit_priced_});
  // (Of many axes at once it takes long; after the time is up nobody waits for it.)
  const auto stop = [this] { return control_.time_is_up(); };
  const bool asked = control_.options().confirm && !stop();
  if (any_covered_ && asked && criteria_.objectives == 1 && !out.builds.empty()) {
    out.confirmations = confirm(problem_, criteria_, out.builds.front(), covered_stages_, stop);
    out.method += confirmation_sentence(out.confirmations);
  }
  return out;
}

}  // namespace millwright::solver
