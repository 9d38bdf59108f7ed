// SPDX-License-Identifier: Apache-2.0
//
// How the combinations of shared choices are settled: each is prepared (stage_plan.h) and looked at briefly, cheapest
// first; of those left, label by label (branch_and_bound.h) for as long as that is cheap; then stage by stage
// (stagewise_search.h) where that method applies, and what remains label by label to the end, where that takes long
// with close curves of what is to come (rest_curve.h). Two objectives go stage by stage at once, three label by label,
// with fronts of two of them before (find_sides).
//
// In the order of the calls: `start` prepares a combination; first builds are looked for (solve_looks.cpp), and limits
// may be priced (limit_prices.cpp); `settle(brief)` searches label by label with coarse curves, `settle(thorough)` with
// dominated rows left out and close curves; `settle(whole)` is `finish`: stage by stage, then label by label to the
// end.
#include "solver/solve_run.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/row_dominance.h"

namespace millwright::solver {
namespace {

/// A problem that is settled in so many nodes is not worth rest curves.
constexpr std::uint64_t easy_nodes = 200;

/// The least bound from a place on; infinity where there is nothing more.
template <class Parts>
double least(const Parts& parts, std::size_t from) {
  double bound = infinity;
  for (std::size_t i = from; i < parts.size(); ++i) bound = std::min(bound, parts[i].score[0]);
  return bound;
}

}  // namespace

void SolveRun::search() {
  std::vector<Combination> combinations;
  const bool known = control_.while_there_is_time(
      [&] { combinations = combinations_of(problem_, criteria_, control_.desk(0), *tables_); });
  if (!known) return leave_open(std::vector<double>(criteria_.size(), -infinity));
  std::vector<OpenSearch> open;
  // A single objective looks at every combination briefly first: what is found in one settles much of the others.
  for (std::size_t i = 0; i < combinations.size(); ++i) {
    const Combination& combination = combinations[i];
    if (control_.time_is_up() || beyond_scope_) {
      leave_open(combination.score);
      continue;
    }
    control_.enter(combination.score[0], std::min(least(combinations, i + 1), least(open, 0)));
    if (incumbents_.hopeless(combination.score, 0.0)) continue;
    if (auto started = start(combination)) open.push_back(std::move(*started));
  }
  std::stable_sort(open.begin(), open.end(), [](const auto& a, const auto& b) { return a.score[0] < b.score[0]; });
  look_for_first_build(open);
  look_around(open);
  for (OpenSearch& each : open) each.stagewise = nullptr;
  // What is settled soon in one combination may leave nothing to do in those that would take long. (But where variables
  // move the objective builds are looked for last, and without any the others are not settled soon.)
  constexpr std::array efforts = {Effort::brief, Effort::thorough, Effort::whole};
  const auto settle_by = [&](std::span<const Effort> in_turn) {
    go_through(open, [&](OpenSearch& each) {
      return std::ranges::any_of(in_turn, [&](Effort effort) { return settle(each, effort); });
    });
  };
  if (!limited_scores().empty()) {
    // As soon as one of them takes long.
    bool takes_long = false;
    go_through(open, [&](OpenSearch& each) {
      takes_long = takes_long || !(settle(each, Effort::brief) || settle(each, Effort::thorough));
      return !takes_long;
    });
    settle_without_price(open);
    if (!open.empty() && !control_.time_is_up()) price_limit(open);
    settle_by(std::span(efforts).last(2));
  } else if (any_covered_) {
    settle_by(efforts);
  } else {
    for (const Effort effort : efforts) go_through(open, [&](OpenSearch& each) { return settle(each, effort); });
  }
  decide_equals();
}

/// When the least of all combinations is known: in most of them there is none as good.
void SolveRun::decide_equals() {
  for (OpenSearch& each : equals_left_) {
    if (incumbents_.hopeless(each.score, 0.0)) continue;
    const bool decided = !control_.time_is_up() &&
                         StagewiseSearch(problem_, criteria_, *each.plans, incumbents_, control_).decide_equals();
    if (!decided) among_equals_ = AmongEquals::some;
  }
}

/// Takes out what is hopeless or has been settled.
void SolveRun::go_through(std::vector<OpenSearch>& open, const std::function<bool(OpenSearch&)>& settle) {
  for (std::size_t i = 0; i < open.size();) {
    double elsewhere = std::min(open_bound_, least(open, i + 1));
    for (std::size_t j = 0; j < i; ++j) elsewhere = std::min(elsewhere, open[j].score[0]);
    control_.enter(open[i].score[0], elsewhere);
    if (incumbents_.hopeless(open[i].score, 0.0) || settle(open[i]))
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
}

/// All stages together give up less than what incumbents settle (set_tolerance), or every build would be undecided.
/// (What a label stands for is bounded by the label's lower bounds, in guides of a front too, and so falls short of a
/// build known by no more than what incumbents settle, and by what labels give up: slack_of_labels.)
double SolveRun::leaf_tolerance() const {
  const auto covered = static_cast<double>(std::count(covered_stages_.begin(), covered_stages_.end(), true));
  return std::min(0.25, 0.45 / std::max(covered, 1.0)) * tolerated();
}

/// Which stages have variables that move scores.
void SolveRun::note_covered(const std::vector<StagePlan>& plans) {
  covered_stages_.resize(plans.size());
  for (std::size_t i = 0; i < plans.size(); ++i) {
    any_covered_ = any_covered_ || is_covered(plans[i]);
    covered_stages_[i] = covered_stages_[i] || is_covered(plans[i]);
  }
}

/// Empty when the combination is settled.
std::optional<SolveRun::OpenSearch> SolveRun::start(const Combination& combination) {
  const std::uint64_t before = control_.evaluations();
  OpenSearch open{std::make_unique<std::vector<StagePlan>>(), nullptr, nullptr, combination.score};
  std::vector<StagePlan>& plans = *open.plans;
  const bool prepared = control_.while_there_is_time([&] {
    plans =
        make_plans(problem_, combination.shared, criteria_, control_.desk(0), *tables_, PlannedRows::best_of_very_long);
  });
  if (!prepared) leave_open(combination.score);
  if (plans.empty()) return std::nullopt;
  open.questions = control_.evaluations() - before;
  note_covered(plans);
  beyond_scope_ = scope_ == Scope::stage_by_stage &&
                  !StagewiseSearch(problem_, criteria_, plans, incumbents_, control_).applicable();
  if (beyond_scope_) {
    leave_open(combination.score);
    return std::nullopt;
  }
  if (criteria_.objectives > 1) {
    control_.while_there_is_time([&] { leave_out_dominated_rows(plans, control_.desk(0)); });
    sharpen(plans);
    if (stage_by_stage(plans, combination.score) == Settled::yes) return std::nullopt;
    if (scope_ == Scope::stage_by_stage) {
      leave_open(combination.score);
      return std::nullopt;
    }
  }
  set_tolerance();
  open.search = label_by_label(plans);
  if (criteria_.objectives > 1) return open;
  const SearchResult result = open.search->run(std::min(control_.options().patience, easy_nodes));
  if (result.complete) return std::nullopt;
  open.score[0] = std::max(open.score[0], result.lower_bound);
  return open;
}

/// Totals of the objectives beyond which the curves of what is to come need not be known.
std::vector<double> SolveRun::what_matters() const {
  std::vector<double> most(criteria_.objectives, infinity);
  for (std::size_t k = 0; k < most.size() && criteria_.objectives < 3 && !incumbents_.builds().empty(); ++k) {
    most[k] = -infinity;
    for (const RankedBuild& build : incumbents_.builds()) most[k] = std::max(most[k], build.score[k]);
  }
  return most;
}

/// What is to come at least, by what has been handed on; the curves that there was no time for are left out.
void SolveRun::sharpen(std::vector<StagePlan>& plans, const CurveEffort& effort) {
  control_.while_there_is_time([&] { find_rest_curves(plans, what_matters(), effort, control_.desk(0)); });
}

/// Searches a single objective label by label, from where it stood, while that costs no more than `share` times what
/// preparing it did: what is not done then is better done stage by stage. True when it is settled.
bool SolveRun::settle_briefly(OpenSearch& open, std::uint64_t share, const CurveEffort& effort) {
  if (control_.time_is_up()) return false;
  sharpen(*open.plans, effort);
  if (open.search == nullptr) open.search = label_by_label(*open.plans);
  constexpr std::uint64_t nodes_at_once = 500;
  const std::uint64_t before = control_.evaluations();
  for (std::uint64_t nodes = 0; nodes < control_.options().patience; nodes += nodes_at_once) {
    const SearchResult result = open.search->run(nodes_at_once);
    if (result.complete) return true;
    open.score[0] = std::max(open.score[0], result.lower_bound);
    if (control_.time_is_up() || control_.evaluations() - before > share * open.questions) break;
  }
  open.search = nullptr;
  return false;
}

bool SolveRun::settle(OpenSearch& open, Effort effort) {
  const bool single = criteria_.objectives == 1;
  if (effort == Effort::brief)
    return single && !(open.tried && incumbents_.builds().empty()) && settle_briefly(open, 1);
  if (effort == Effort::thorough) {  // its curves serve all that follows
    if (!single) return false;
    open.search = nullptr;  // it would count regions by numbers that may no longer be theirs
    control_.while_there_is_time([&] { leave_out_dominated_rows(*open.plans, control_.desk(0)); });
    return settle_briefly(open, 1, CurveEffort::thorough());
  }
  finish(open);
  return true;
}

/// To the end, label by label: where that is not soon done, with the closest curves from then on.
SearchResult SolveRun::search_whole(OpenSearch& open) {
  const SearchResult soon = open.search->run(control_.options().patience);
  if (soon.complete || control_.time_is_up()) return soon;
  sharpen(*open.plans, CurveEffort::closest());
  return open.search->run();
}

void SolveRun::finish(OpenSearch& open) {
  if (settled_by_front_) return;
  if (criteria_.objectives == 1) {
    const Settled settled = stage_by_stage(*open.plans, open.score);
    if (settled == Settled::but_for_equals) {
      open.score[0] = std::max(open.score[0], incumbents_.best());
      return equals_left_.push_back(std::move(open));
    }
    if (settled == Settled::yes) return;
    look_for_builds(open);
    // Regions may have been left out: a search that was begun before counts them by numbers that are no longer
    // theirs.
    open.search = label_by_label(*open.plans);
  }
  set_tolerance();
  SearchResult result = search_whole(open);
  // A point that stands for designs a little better than itself may be too heavy for a later stage where they are not.
  // What stays undecided for that reason is decided with points that stand for less. (What a front that has widened
  // leaves undecided, its tolerance tells.)
  while (!result.complete && !control_.time_is_up() && !is_widened()) {
    std::optional<LeafPrecision> precision = next_precision(
        open.search->precision(), open.search->undecided_designs(), leaf_tolerance(), criteria_.objectives);
    if (!precision) break;
    slack_given_ = std::max(slack_given_, open.search->slack_given());
    open.search = nullptr;  // it may be large
    open.search = label_by_label(*open.plans, std::move(*precision));
    result = open.search->run();
  }
  slack_given_ = std::max(slack_given_, open.search->slack_given());
  if (result.complete) return;
  complete_ = false;
  open_bound_ = std::min(open_bound_, std::max(open.score[0], result.lower_bound));
  if (criteria_.objectives > 1) widen_to_settle([&] { open.search->settle_open(); });
}

void SolveRun::leave_open(std::span<const double> score) {
  complete_ = false;
  open_bound_ = std::min(open_bound_, score[0]);
  if (criteria_.objectives > 1) left_open_.emplace_back(score.begin(), score.end());
}

/// Of a single objective, where no build is known yet that keeps the limit of one more resource: the front of both, of
/// all combinations at once, finds out far sooner what is of use than a search without any build. Its first build is
/// the best, and of equals the one with the least of the resource: so that has to be the first tie. Only once: what a
/// front leaves open for one combination it would leave open for the next. And only a front that is exact, not one that
/// is covered to its tolerance.
bool SolveRun::settle_by_front() {
  const Options& asked = control_.options();
  if (front_tried_ || !asked.weights.empty() || asked.ties.empty() || control_.time_is_up()) return false;
  if (!std::isfinite(problem_.resources[asked.ties.front()].limit)) return false;
  Options options = asked;
  options.objectives.push_back(options.ties.front());
  options.ties.erase(options.ties.begin());
  options.time_limit_seconds -= control_.seconds();
  front_tried_ = true;
  const Summary front = solve_first(std::move(options), Scope::stage_by_stage);
  settled_by_front_ = front.status != Status::limit && front.front_tolerance == 0.0;
  return settled_by_front_;
}

/// One or two objectives by stagewise_search.h; `no` when that method does not apply or leaves something undecided.
SolveRun::Settled SolveRun::stage_by_stage(std::vector<StagePlan>& plans, std::span<const double> score) {
  if (criteria_.objectives > 2 || !control_.options().stagewise) return Settled::no;
  StagewiseSearch search(problem_, criteria_, plans, incumbents_, control_);
  if (!search.applicable()) return Settled::no;
  stagewise_ = true;
  const bool settled = search.run(allowances_priced_, score[0], [this] { return settle_by_front(); });
  allowances_priced_ = allowances_priced_ || search.used_prices();
  if (search.nothing_left()) return Settled::yes;
  // Where a later stage refuses the points of a cover it might not refuse what they stand for: builds may be missing.
  const bool covered = std::ranges::any_of(plans, is_covered);
  if (settled && !covered) return search.equals_left() ? Settled::but_for_equals : Settled::yes;
  if (search.undecided() && !covered && !control_.time_is_up()) return Settled::no;
  std::vector<double> left(score.begin(), score.end());
  if (criteria_.objectives == 1) left[0] = std::max(left[0], search.least_total());
  leave_open(left);
  return Settled::yes;
}

}  // namespace millwright::solver
