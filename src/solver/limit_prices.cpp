// SPDX-License-Identifier: Apache-2.0
//
// What a limit is worth. Of a single objective with a limit on another total (the least energy for 600 USD) a search
// label by label sees little for long: what is best in the objective exceeds the limit, what is cheap is bad, and the
// least of each by itself says nothing of both. With a price on the other total it does: the least of
//     objective + price * other
// less what the limit comes to at that price is a lower bound of the objective of all that keeps the limit (Lagrange's
// relaxation; Everett, Operations Research 11, 1963), and at the right price falls short of the best only by the steps
// that catalogues have and by what bounds lack anyway.
//
// The right price is the slope of the lower hull of what can be reached, between a build that keeps the limit and one
// that does not: both are moved towards the limit by searches without it. The one that keeps it is where the search
// starts from, with single parts changed for what is left of the limit. All that takes many searches: where little is
// left to prove, that is tried without a price first (settle_without_price).
#include <algorithm>
#include <array>
#include <cmath>

#include "solver/nearby.h"
#include "solver/solve_run.h"

namespace millwright::solver {
namespace {

constexpr double only_other = infinity;  // a price
/// Of the searches at the two ends, half of what is left to prove: else a build known already would do for an end.
constexpr double least_gap_at_end = 5e-3, most_gap_at_end = 2e-2;

/// The resource that a score is, where it is a single one.
std::optional<std::size_t> resource_of(const std::vector<double>& weight) {
  const auto used = [](double each) { return each != 0.0; };
  if (std::ranges::count_if(weight, used) != 1) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::find_if(weight, used) - weight.begin());
}

}  // namespace

/// Scores with a limit that can be given a price, in a search that would make use of it.
std::vector<std::size_t> SolveRun::limited_scores() const {
  std::vector<std::size_t> limited;
  if (scope_ != Scope::all || !control_.options().price_limits || criteria_.objectives != 1 || !any_covered_)
    return limited;
  for (std::size_t k = 1; k < criteria_.size(); ++k)
    if (std::isfinite(criteria_.limit[k]) && criteria_.limit[k] > 0.0 && resource_of(criteria_.weight[k]) &&
        !criteria_.is_floor(k))
      limited.push_back(k);
  return limited;
}

/// A good build of the sum at this price where nothing is limited: (limited score, objective).
std::optional<Pair> SolveRun::best_at_price(const Problem& unlimited,
                                            std::size_t limited,
                                            double price,
                                            const PriceEffort& effort) {
  constexpr double gap_between = 5e-3;
  constexpr double share = 0.3;  // of the time there is for all prices
  const Options& asked = control_.options();
  const double seconds = std::min(share * effort.seconds, effort.until - control_.seconds());
  if (control_.time_is_up() || !(seconds > 0.0)) return std::nullopt;
  Options options = asked;
  options.weights = criteria_.weight[0];
  double& weight = options.weights[*resource_of(criteria_.weight[limited])];
  if (price == only_other) {
    std::ranges::fill(options.weights, 0.0);
    weight = 1.0;
  } else {
    weight += price;
  }
  const bool at_end = price == 0.0 || price == only_other;
  options.gap = std::max(options.gap, at_end ? effort.gap_at_end : gap_between);
  options.time_limit_seconds = seconds;
  options.most_nodes = std::min(asked.most_nodes - std::min(asked.most_nodes, control_.nodes), effort.nodes);
  options.confirm = options.settle_ties = false;
  // Its bound and its builds are of other objectives; that the time goes on may be told.
  if (asked.progress) options.progress = [this](const Progress&) { control_.report(incumbents_.best()); };
  // (What is known of the tables may hold within the limits only.)
  std::vector<Build> known;
  for (const RankedBuild& ranked : incumbents_.builds()) known.push_back(ranked.build);
  const Summary found = SolveRun(unlimited, options, Scope::unpriced, nullptr, known).run();
  control_.nodes += found.nodes;
  earlier_evaluations_ += found.evaluations;
  if (found.builds.empty()) return std::nullopt;
  std::vector<double> score = scores_of(found.builds[0]);
  const Pair point{score[limited], score[0]};
  incumbents_.offer({std::move(score), found.builds[0]});
  return point;
}

/// The slope of the hull at the limit; 0 where the limit is in nobody's way, or no slope is found.
double SolveRun::price_at_limit(std::size_t limited, const PriceEffort& effort) {
  constexpr std::size_t most_steps = 8;
  constexpr double little = 1e-3;  // that a step has to better the sum by
  const double limit = criteria_.limit[limited];
  Problem unlimited = problem_;
  unlimited.resources[*resource_of(criteria_.weight[limited])].limit = infinity;
  std::optional<Pair> above = best_at_price(unlimited, limited, 0.0, effort);
  if (!above || within_limit(above->first, limit)) return 0.0;
  std::optional<Pair> below = best_at_price(unlimited, limited, only_other, effort);
  if (!below || !within_limit(below->first, limit)) return 0.0;
  double price = 0.0;
  for (std::size_t step = 0; step < most_steps && below->second > above->second; ++step) {
    price = (below->second - above->second) / (above->first - below->first);
    const std::optional<Pair> between = best_at_price(unlimited, limited, price, effort);
    if (!between) break;
    const double known = below->second + price * below->first;
    if (!(between->second + price * between->first < known - little * std::fabs(known))) break;
    (within_limit(between->first, limit) ? below : above) = between;
  }
  return std::isfinite(price) ? price : 0.0;
}

/// What is open may be better than the best build by this part of it; infinity where none is known.
double SolveRun::gap_left(const std::vector<OpenSearch>& open) const {
  if (incumbents_.builds().empty()) return infinity;
  double bound = incumbents_.best();
  for (const OpenSearch& each : open) bound = std::min(bound, each.score[0]);
  return (incumbents_.best() - bound) / std::fabs(incumbents_.best());
}

/// Where little is left to prove: for about as many nodes as finding prices would take, which may then not be needed.
/// By turns, since what is best may be in the combination that seems to be worse.
void SolveRun::settle_without_price(std::vector<OpenSearch>& open) {
  constexpr double little = 0.05;
  constexpr std::uint64_t times = 2;
  constexpr int turns = 4;
  if (!(gap_left(open) < little)) return;
  for (int turn = 0; turn < turns; ++turn) {
    go_through(open, [&](OpenSearch& each) {
      if (control_.time_is_up()) return false;
      if (each.search == nullptr) each.search = label_by_label(*each.plans);
      if (turn == 1) sharpen(*each.plans, CurveEffort::closest());
      const SearchResult result = each.search->run(times * control_.options().patience);
      if (!result.complete) each.score[0] = std::max(each.score[0], result.lower_bound);
      return result.complete;
    });
  }
  for (OpenSearch& each : open) each.search = nullptr;
}

/// Adds prices of a limit that is in the way, for what is searched from then on.
void SolveRun::price_limit(std::vector<OpenSearch>& open) {
  // What is left to choose may be worth more or less than the whole.
  constexpr std::array parts = {0.25, 0.5, 1.0, 2.0, 4.0};
  constexpr double share = 0.65;  // of the time left
  constexpr std::uint64_t nodes = 60000;
  const double now = control_.seconds();
  const double seconds = share * (control_.options().time_limit_seconds - now);
  const double gap_at_end = std::clamp(0.5 * gap_left(open), least_gap_at_end, most_gap_at_end);
  const PriceEffort effort{seconds, now + seconds, gap_at_end, nodes + 4 * control_.nodes};
  double price = 0.0;
  std::size_t limited = 0;
  for (const std::size_t each : limited_scores()) {
    if (price > 0.0) break;
    limited = each;
    price = price_at_limit(each, effort);
  }
  if (!incumbents_.builds().empty()) {
    const auto stop = [this] { return control_.time_is_up(); };
    Build better = best_nearby(problem_, control_.options(), incumbents_.builds().front().build, stop);
    std::vector<double> score = scores_of(better);
    incumbents_.offer({std::move(score), std::move(better)});
  }
  if (!(price > 0.0)) return;
  std::vector<double> prices;
  for (const double part : parts) prices.push_back(part * price);
  add_limit_prices(criteria_, limited, prices);
  for (RankedBuild& ranked : incumbents_.builds()) ranked.score = scores_of(ranked.build);
  go_through(open, [this](OpenSearch& each) { return !begin_again(each); });
  std::ranges::stable_sort(open, {}, [](const OpenSearch& each) { return each.score[0]; });
  limit_priced_ = !open.empty();
}

/// A combination anew, with the scores that there are now. False: there was no time, or nothing in it is feasible.
bool SolveRun::begin_again(OpenSearch& open) {
  const std::span<const Row> shared = open.plans->front().shared;
  open.search = nullptr;
  std::vector<StagePlan> plans;
  const bool prepared = control_.while_there_is_time([&] {
    plans = make_plans(problem_, shared, criteria_, control_.desk(0), *tables_, PlannedRows::best_of_very_long);
  });
  if (!prepared) leave_open(open.score);
  if (!prepared || plans.empty()) return false;
  note_covered(plans);
  *open.plans = std::move(plans);
  set_tolerance();
  open.score[0] = std::max(open.score[0], label_by_label(*open.plans)->run(0).lower_bound);
  return true;
}

}  // namespace millwright::solver
