// SPDX-License-Identifier: Apache-2.0
#include "solver/solver.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "solver/branch_and_bound.h"
#include "solver/confirmation.h"
#include "solver/criteria.h"
#include "solver/frontier.h"
#include "solver/incumbents.h"
#include "solver/method_sentence.h"
#include "solver/neighbours.h"
#include "solver/rest_curve.h"
#include "solver/row_dominance.h"
#include "solver/search_control.h"
#include "solver/shared_choices.h"
#include "solver/stage_plan.h"

namespace millwright::solver {
namespace {

/// One solve: every combination of shared choices, cheapest first, with common incumbents.
class Solve {
 public:
  Solve(const Problem& problem, const Options& options)
      : problem_(problem), criteria_(make_criteria(problem, options)), control_(options), incumbents_(criteria_) {}

  Summary run() {
    if (problem_.stages.empty()) throw std::invalid_argument("Problem::stages is empty");
    constexpr double small = 1e3;  // combinations below which the ends and the guides are not worth their while
    if (criteria_.objectives == 2 && !control_.options().stagewise && !has_empty_slot(problem_) &&
        search_space(problem_) > small) {
      find_ends();
    }
    if (!has_empty_slot(problem_)) search();
    better_among_equals();
    return summary();
  }

 private:
  /// The two ends of a front by themselves: they bound it, and their distance says what rate between the objectives is
  /// worth a guide.
  void find_ends() {
    std::vector<std::vector<double>> ends;
    for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
      Options options = control_.options();
      options.ties.insert(options.ties.begin(), options.objectives[1 - first]);
      options.objectives = {options.objectives[first]};
      options.confirm = false;
      options.time_limit_seconds -= control_.seconds();
      const Summary end = Solve(problem_, options).run();
      control_.nodes += end.nodes;
      earlier_evaluations_ += end.evaluations;
      if (end.builds.empty()) return;
      std::vector<double> score(criteria_.size());
      criteria_.scores<double>(end.builds[0].resources, score);
      ends.push_back(score);
      incumbents_.offer({std::move(score), end.builds[0]});
    }
    const double rise = ends[1][0] - ends[0][0];
    const double fall = ends[0][1] - ends[1][1];
    if (rise > 0.0 && fall > 0.0) add_guides(criteria_, rise / fall);
    for (RankedBuild& ranked : incumbents_.builds()) {
      ranked.score.resize(criteria_.size());
      criteria_.scores<double>(ranked.build.resources, ranked.score);
    }
  }

  void search() {
    std::vector<Combination> combinations = combinations_of(problem_, criteria_, control_.desk(0));
    std::vector<OpenSearch> open;
    // A single objective looks at every combination briefly first, and goes on with the most promising one: what is
    // found in one settles much of the others.
    for (std::size_t i = 0; i < combinations.size(); ++i) {
      const Combination& combination = combinations[i];
      control_.enter(combination.score[0], std::min(least(combinations, i + 1), least(open, 0)));
      if (control_.time_is_up()) {
        leave_open(combination.score[0]);
        break;
      }
      if (incumbents_.hopeless(combination.score, 0.0)) continue;
      if (auto started = start(combination)) open.push_back(std::move(*started));
    }
    std::stable_sort(open.begin(), open.end(), [](const auto& a, const auto& b) { return a.score[0] < b.score[0]; });
    look_around(open);
    for (OpenSearch& each : open) each.frontier = nullptr;
    for (std::size_t i = 0; i < open.size(); ++i) {
      control_.enter(open[i].score[0], std::min(least(open, i + 1), open_bound_));
      if (!incumbents_.hopeless(open[i].score, 0.0)) finish(open[i]);
    }
  }

  /// The least bound from a place on; infinity where there is nothing more.
  template <class Parts>
  static double least(const Parts& parts, std::size_t from) {
    double bound = infinity;
    for (std::size_t i = from; i < parts.size(); ++i) bound = std::min(bound, parts[i].score[0]);
    return bound;
  }

  /// A combination that has been begun; `search` points into `plans`.
  struct OpenSearch {
    std::unique_ptr<std::vector<StagePlan>> plans;
    std::unique_ptr<BranchAndBound> search;
    std::unique_ptr<Frontier> frontier = nullptr;  ///< by which any build is looked for
    std::vector<double> score = {};                ///< lower bounds
    std::uint64_t questions = 0;                   ///< asked to prepare it
    bool tried = false;                            ///< in vain, to be settled without knowing any build
  };

  /// For any build, in each combination: to prove that there is none in the first may take far longer than to find one
  /// in the second, and with one it is easier. Then the combination in which the best build is comes first.
  void look_around(std::vector<OpenSearch>& open) {
    if (criteria_.objectives > 1 || open.size() < 2 || !incumbents_.builds().empty()) return;
    if (!control_.options().stagewise || !control_.options().look_first) return;
    if (!look_briefly(open)) return;
    settle_more(open);
    for (const double share : {little_share, much_share})
      for (OpenSearch& each : open)
        if (each.frontier != nullptr && incumbents_.builds().empty() &&
            !each.frontier->look(share, Frontier::many_nodes))
          return;
    if (incumbents_.builds().empty()) return;
    const std::vector<Row>& shared = incumbents_.builds().front().build.shared;
    std::stable_partition(open.begin(), open.end(), [&](const OpenSearch& each) {
      const auto of_search = each.plans->front().shared;
      return std::equal(shared.begin(), shared.end(), of_search.begin(), of_search.end());
    });
  }
  /// What a state that uses up all that later stages can bear costs in these looks (Frontier::look).
  static constexpr double little_share = 0.03, much_share = 0.3;

  /// False: there is no time, or the first combination is easy.
  bool look_briefly(std::vector<OpenSearch>& open) {
    for (OpenSearch& each : open) {
      if (!incumbents_.builds().empty()) break;
      each.frontier = std::make_unique<Frontier>(problem_, criteria_, *each.plans, incumbents_, control_);
      if (!each.frontier->applicable()) return false;
      const Frontier::Difficulty difficulty = each.frontier->find_difficulty();
      if (difficulty == Frontier::Difficulty::out_of_time) return false;
      if (difficulty == Frontier::Difficulty::easy) {
        if (&each == &open.front()) return false;
        each.frontier = nullptr;
      } else if (!each.frontier->look(little_share, Frontier::few_nodes)) {
        return false;
      }
    }
    return true;
  }
  /// Where there is no build yet a longer search label by label is worth its while: all that comes then takes longer.
  void settle_more(std::vector<OpenSearch>& open) {
    constexpr std::uint64_t share = 2;
    for (std::size_t i = 0; i < open.size() && incumbents_.builds().empty();) {
      double elsewhere = std::min(open_bound_, least(open, i + 1));
      for (std::size_t j = 0; j < i; ++j) elsewhere = std::min(elsewhere, open[j].score[0]);
      control_.enter(open[i].score[0], elsewhere);
      const bool hard = open[i].frontier != nullptr;
      if (hard && (incumbents_.hopeless(open[i].score, 0.0) || settle_briefly(open[i], share))) {
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      open[i].tried = hard;
      ++i;
    }
  }

  /// A point that stands for designs a little better than itself may be too heavy for a later stage where they are not.
  /// What stays undecided for that reason is decided with points that stand for less.
  /// All stages together give up less than what incumbents settle (set_tolerance), or every build would be undecided;
  /// and what a label stands for may be given up by a guide of a front with the label, which costs no more than that.
  [[nodiscard]] double leaf_tolerance() const {
    const auto priced = static_cast<double>(std::count(priced_stages_.begin(), priced_stages_.end(), true));
    return std::min(0.25, 0.45 / std::max(priced, 1.0)) * tolerated();
  }
  [[nodiscard]] LeafPrecision precision_for(const std::vector<StagePlan>& plans) const {
    return first_precision(plans, leaf_tolerance(), criteria_.objectives);
  }
  std::unique_ptr<BranchAndBound> label_by_label(std::vector<StagePlan>& plans) {
    return label_by_label(plans, precision_for(plans));
  }
  std::unique_ptr<BranchAndBound> label_by_label(std::vector<StagePlan>& plans, LeafPrecision precision) {
    return std::make_unique<BranchAndBound>(problem_, criteria_, plans, incumbents_, control_, std::move(precision));
  }

  /// A problem that is settled in so many nodes is not worth rest curves.
  static constexpr std::uint64_t easy_nodes = 200;

  /// Empty when the combination is settled.
  std::optional<OpenSearch> start(const Combination& combination) {
    const std::uint64_t before = control_.evaluations();
    OpenSearch open{std::make_unique<std::vector<StagePlan>>(), nullptr, nullptr, combination.score};
    std::vector<StagePlan>& plans = *open.plans;
    const bool prepared = control_.while_there_is_time(
        [&] { plans = make_plans(problem_, combination.shared, criteria_, control_.desk(0)); });
    if (!prepared) leave_open(combination.score[0]);
    if (plans.empty()) return std::nullopt;
    open.questions = control_.evaluations() - before;
    priced_stages_.resize(plans.size());
    for (std::size_t i = 0; i < plans.size(); ++i) {
      priced_ = priced_ || plans[i].any_priced;
      priced_stages_[i] = priced_stages_[i] || plans[i].any_priced;
    }
    if (criteria_.objectives > 1) {
      control_.while_there_is_time([&] { leave_out_dominated_rows(plans, control_.desk(0)); });
      sharpen(plans);
      if (stage_by_stage(plans, combination.score[0])) return std::nullopt;
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
  [[nodiscard]] std::vector<double> what_matters() const {
    std::vector<double> most(criteria_.objectives, infinity);
    for (std::size_t k = 0; k < most.size() && criteria_.objectives < 3 && !incumbents_.builds().empty(); ++k) {
      most[k] = -infinity;
      for (const RankedBuild& build : incumbents_.builds()) most[k] = std::max(most[k], build.score[k]);
    }
    return most;
  }

  /// What is to come at least, by what has been handed on; the curves that there was no time for are left out.
  void sharpen(std::vector<StagePlan>& plans, const CurveEffort& effort = {}) {
    control_.while_there_is_time([&] { find_rest_curves(plans, what_matters(), effort, control_.desk(0)); });
  }

  /// Searches a single objective label by label while that costs no more than `share` times what preparing it did: what
  /// is not done then is better done stage by stage. True when it is settled.
  bool settle_briefly(OpenSearch& open, std::uint64_t share, const CurveEffort& effort = {}) {
    if (control_.time_is_up()) return false;
    sharpen(*open.plans, effort);
    open.search = label_by_label(*open.plans);
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

  /// The best build is known only when all that might be better has been looked at, which may take longer than there is
  /// time: a good one first.
  void look_for_builds(const OpenSearch& open) {
    constexpr double good = 0.01, coarse = 1e-4;
    constexpr std::size_t labels = 30, nodes = 30000;
    const bool wanted = control_.options().look_first && std::ranges::any_of(*open.plans, &StagePlan::any_priced);
    if (!wanted || incumbents_.best() <= open.score[0] + good * std::fabs(open.score[0])) return;
    LeafPrecision precision = precision_for(*open.plans);
    precision.tolerance = std::max(precision.tolerance, coarse);
    label_by_label(*open.plans, std::move(precision))->look(labels, nodes);
  }

  void finish(OpenSearch& open) {
    if (criteria_.objectives == 1) {
      const bool again = open.tried && incumbents_.builds().empty();
      if (!again && settle_briefly(open, 1)) return;
      control_.while_there_is_time([&] { leave_out_dominated_rows(*open.plans, control_.desk(0)); });
      if (settle_briefly(open, 1, CurveEffort::thorough())) return;  // its curves serve all that follows
      if (stage_by_stage(*open.plans, open.score[0])) return;
      look_for_builds(open);
      // Regions may have been left out: a search that was begun before counts them by numbers that are no longer
      // theirs.
      open.search = label_by_label(*open.plans);
    }
    set_tolerance();
    SearchResult result = open.search->run();
    while (!result.complete && !control_.time_is_up() && may_be_finer(open.search->precision(), leaf_tolerance())) {
      LeafPrecision precision = finer(open.search->precision(), open.search->undecided_designs());
      open.search = nullptr;  // it may be large
      open.search = label_by_label(*open.plans, std::move(precision));
      result = open.search->run();
    }
    if (!result.complete) leave_open(std::max(open.score[0], result.lower_bound));
  }

  /// Within the tolerance of continuous variables a search does not ask what decides between equals. So parts of the
  /// best build are changed one by one for such as are better in that and no worse in the objective. (Incumbents would
  /// not take such a build: within the tolerance the one known is as good.)
  void better_among_equals() {
    if (!priced_ || criteria_.objectives != 1 || criteria_.ties == 0 || incumbents_.builds().empty()) return;
    RankedBuild& best = incumbents_.builds().front();
    searched_best_ = best.score[0];
    std::vector<double> score(criteria_.size());
    const Neighbours neighbours(problem_);
    for (std::size_t tie = 1; tie <= criteria_.ties; ++tie) {
      const std::vector<double> most(best.score.begin(), best.score.begin() + static_cast<std::ptrdiff_t>(tie));
      const auto value = [&](std::span<const double> resources) {
        criteria_.scores<double>(resources, score);
        for (std::size_t k = 0; k < most.size(); ++k)
          if (rounded(score[k]) > rounded(most[k])) return infinity;
        return rounded(score[tie]);
      };
      best.build = neighbours.improved(best.build, value, [this] { return control_.time_is_up(); });
      criteria_.scores<double>(best.build.resources, best.score);
    }
    best.build.worst_utilisation = neighbours.worst_utilisation(best.build);
  }

  void set_tolerance() { incumbents_.tolerance = priced_ ? 0.5 * tolerated() : 0.0; }

  /// One or two objectives by frontier.h; false when that method does not apply or leaves something undecided.
  bool stage_by_stage(std::vector<StagePlan>& plans, double lower_bound) {
    if (criteria_.objectives > 2 || !control_.options().stagewise) return false;
    Frontier frontier(problem_, criteria_, plans, incumbents_, control_);
    if (!frontier.applicable()) return false;
    stagewise_ = true;
    const bool settled = frontier.run(allowances_priced_, lower_bound);
    allowances_priced_ = allowances_priced_ || frontier.used_prices();
    if (settled) return true;
    if (frontier.undecided() && !control_.time_is_up()) return false;
    leave_open(lower_bound);
    return true;
  }

  /// What an answer with priced variables may fall short of the best.
  [[nodiscard]] double tolerated() const {
    return criteria_.objectives > 1 ? front_tolerance() : control_.options().gap;
  }
  [[nodiscard]] double front_tolerance() const {
    return std::max(control_.options().front_tolerance, control_.options().gap);
  }

  void leave_open(double lower_bound) {
    complete_ = false;
    open_bound_ = std::min(open_bound_, lower_bound);
  }

  Summary summary() {
    Summary out;
    out.combinations = search_space(problem_);
    out.nodes = control_.nodes;
    out.evaluations = control_.evaluations() + earlier_evaluations_;
    const double best = incumbents_.best();
    // What the tolerance gave up may be better by so much.
    const double searched = std::min(best, searched_best_);
    const double settled = std::isfinite(best) ? searched - incumbents_.tolerance * std::fabs(searched) : infinity;
    out.lower_bound = std::min(settled, open_bound_);
    for (const RankedBuild& ranked : incumbents_.builds()) out.builds.push_back(ranked.build);
    if (criteria_.objectives == 1 && out.builds.size() > 1) out.builds.resize(1);
    out.gap = std::isfinite(best) ? (best - out.lower_bound) / std::max(std::fabs(best), 1e-300) : infinity;
    const bool closed = complete_ || (criteria_.objectives == 1 && out.gap <= control_.options().gap);
    out.status = !closed ? Status::limit : out.builds.empty() ? Status::infeasible : Status::optimal;
    out.seconds = control_.seconds();
    if (priced_ && criteria_.objectives > 1) out.front_tolerance = front_tolerance();
    out.method = sentence_of({priced_, criteria_.objectives > 1, stagewise_, allowances_priced_});
    if (priced_ && control_.options().confirm && criteria_.objectives == 1 && !out.builds.empty()) {
      out.confirmations = confirm(problem_, criteria_, out.builds.front(), priced_stages_);
      out.method += confirmation_sentence(out.confirmations);
    }
    return out;
  }

  const Problem& problem_;
  Criteria criteria_;
  SearchControl control_;
  Incumbents incumbents_;
  std::uint64_t earlier_evaluations_ = 0;
  bool complete_ = true;
  bool priced_ = false;
  bool stagewise_ = false;          ///< frontier.h was used
  bool allowances_priced_ = false;  ///< by it
  std::vector<bool> priced_stages_;
  double open_bound_ = infinity;
  double searched_best_ = infinity;  ///< of the builds that the search has found
};

}  // namespace

Summary solve(const Problem& problem, const Options& options) {
  Summary summary = Solve(problem, options).run();
  const bool time_is_up =
      summary.seconds >= options.time_limit_seconds || (options.stop != nullptr && options.stop->load());
  if (summary.status != Status::limit || time_is_up || !options.stagewise || options.objectives.size() != 2)
    return summary;
  // What is undecided stage by stage (a point that stands for slightly better ones is refused later on) the other
  // method may settle: it knows the ends of the front first.
  Options other = options;
  other.stagewise = false;
  other.time_limit_seconds -= summary.seconds;
  Summary settled = Solve(problem, other).run();
  settled.nodes += summary.nodes;
  settled.evaluations += summary.evaluations;
  settled.seconds += summary.seconds;
  return settled.status == Status::optimal ? settled : summary;
}

}  // namespace millwright::solver
