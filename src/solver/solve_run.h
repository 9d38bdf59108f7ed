// SPDX-License-Identifier: Apache-2.0
//
// One solve: every combination of shared choices, the cheapest begun first, with common incumbents. What comes before
// the search (ends and sides of a front) and after it (the choice among equals, the summary) is in solve_run.cpp, the
// search of the combinations in solve_search.cpp.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/branch_and_bound.h"
#include "solver/criteria.h"
#include "solver/incumbents.h"
#include "solver/method_sentence.h"
#include "solver/rest_curve.h"
#include "solver/search_control.h"
#include "solver/shared_choices.h"
#include "solver/stage_plan.h"
#include "solver/stagewise_search.h"

namespace millwright::solver {

class SolveRun {
 public:
  /// `stage_by_stage`: only what stagewise_search.h does, the rest is left open. `unpriced`: all, but limits get no
  /// prices (limit_prices.cpp).
  enum class Scope { all, unpriced, stage_by_stage };
  /// `tables`: what another run has found out about the same problem; null: nothing yet. `known`: feasible
  /// builds to start from.
  SolveRun(const Problem& problem,
           const Options& options,
           Scope scope = Scope::all,
           std::shared_ptr<TableMemory> tables = nullptr,
           std::span<const Build> known = {})
      : problem_(problem),
        criteria_(make_criteria(problem, options)),
        control_(options),
        incumbents_(criteria_),
        scope_(scope),
        known_(known),
        tables_(tables != nullptr ? std::move(tables) : std::make_shared<TableMemory>()) {}

  Summary run();

 private:
  /// A combination that has been begun; `search` points into `plans`.
  struct OpenSearch {
    std::unique_ptr<std::vector<StagePlan>> plans;
    std::unique_ptr<BranchAndBound> search;
    std::unique_ptr<StagewiseSearch> stagewise = nullptr;  ///< by which any build is looked for
    std::vector<double> score = {};                        ///< lower bounds
    std::uint64_t questions = 0;                           ///< asked to prepare it
    bool tried = false;                                    ///< in vain, to be settled without knowing any build
  };
  enum class Effort { brief, thorough, whole };

  bool find_some_first();
  void find_ends();
  void take_known();
  void add_guides_between(std::span<const double> first_end, std::span<const double> second_end);
  bool find_sides();
  void add_guides_between_sides();
  Summary solve_first(Options options, Scope scope);
  [[nodiscard]] std::vector<double> scores_of(const Build& build) const;
  void better_among_equals();
  [[nodiscard]] std::optional<RankedBuild> best_among_equals();
  void leave_out_noise();
  Summary summary();

  void search();
  std::optional<OpenSearch> start(const Combination& combination);
  void look_for_first_build(std::vector<OpenSearch>& open);
  void look_around(std::vector<OpenSearch>& open);
  bool look_briefly(std::vector<OpenSearch>& open);
  void settle_more(std::vector<OpenSearch>& open);
  void go_through(std::vector<OpenSearch>& open, const std::function<bool(OpenSearch&)>& settle);
  bool settle(OpenSearch& open, Effort effort);
  bool settle_briefly(OpenSearch& open, std::uint64_t share, const CurveEffort& effort = {});
  enum class Settled { no, but_for_equals, yes };
  Settled stage_by_stage(std::vector<StagePlan>& plans, std::span<const double> score);
  void decide_equals();
  /// What finding prices may take: time in all and when that ends, and nodes of each search.
  struct PriceEffort {
    double seconds = 0.0, until = 0.0, gap_at_end = 0.0;
    std::uint64_t nodes = 0;
  };
  [[nodiscard]] std::vector<std::size_t> limited_scores() const;
  std::optional<Pair> best_at_price(const Problem& unlimited,
                                    std::size_t limited,
                                    double price,
                                    const PriceEffort& effort);
  double price_at_limit(std::size_t limited, const PriceEffort& effort);
  [[nodiscard]] double gap_left(const std::vector<OpenSearch>& open) const;
  void settle_without_price(std::vector<OpenSearch>& open);
  void price_limit(std::vector<OpenSearch>& open);
  void note_covered(const std::vector<StagePlan>& plans);
  bool begin_again(OpenSearch& open);
  bool settle_by_front();
  void look_for_builds(const OpenSearch& open);
  SearchResult search_whole(OpenSearch& open);
  void finish(OpenSearch& open);
  [[nodiscard]] std::vector<double> what_matters() const;
  void sharpen(std::vector<StagePlan>& plans, const CurveEffort& effort = {});
  [[nodiscard]] double leaf_tolerance() const;
  [[nodiscard]] LeafPrecision precision_for(const std::vector<StagePlan>& plans) const {
    const bool left_open = criteria_.objectives == 2 && !control_.options().stagewise && !control_.options().widens;
    return first_precision(plans, leaf_tolerance(), criteria_.objectives, left_open);
  }
  std::unique_ptr<BranchAndBound> label_by_label(std::vector<StagePlan>& plans) {
    return label_by_label(plans, precision_for(plans));
  }
  std::unique_ptr<BranchAndBound> label_by_label(std::vector<StagePlan>& plans, LeafPrecision precision) {
    return std::make_unique<BranchAndBound>(problem_, criteria_, plans, incumbents_, control_, std::move(precision));
  }
  std::unique_ptr<BranchAndBound> coarsely_label_by_label(std::vector<StagePlan>& plans);
  /// That nothing is known of designs but these lower bounds of their scores.
  void leave_open(std::span<const double> score);
  [[nodiscard]] double asked_tolerance() const { return any_covered_ ? tolerated() : 0.0; }
  [[nodiscard]] double settled_tolerance() const { return 0.5 * asked_tolerance(); }
  /// Never lower than before.
  void set_tolerance() { incumbents_.set_tolerance(std::max(incumbents_.tolerance(), settled_tolerance())); }
  /// What an answer with covered stages may fall short of the best.
  [[nodiscard]] double tolerated() const {
    return criteria_.objectives > 1 ? control_.options().tolerance_of_front() : control_.options().gap;
  }
  /// Whether a front was searched more coarsely, for want of time.
  [[nodiscard]] bool is_widened() const { return incumbents_.tolerance() > settled_tolerance(); }
  void widen_to_settle(const std::function<void()>& settle);
  double proved_tolerance();

  const Problem& problem_;
  Criteria criteria_;
  SearchControl control_;
  Incumbents incumbents_;
  Scope scope_;
  std::span<const Build> known_;
  std::shared_ptr<TableMemory> tables_;
  std::uint64_t earlier_evaluations_ = 0;       ///< of other runs that this one began
  std::vector<std::vector<double>> left_open_;  ///< lower bounds of scores of what nothing else is known of
  double left_tolerance_ = 0.0;                 ///< at which the builds of a front settle what is left open
  double slack_given_ = 0.0;                    ///< by labels of a front, of the whole
  bool complete_ = true;
  bool beyond_scope_ = false;
  bool any_covered_ = false;
  bool stagewise_ = false;          ///< stagewise_search.h was used
  bool allowances_priced_ = false;  ///< by it
  bool front_tried_ = false;        ///< by settle_by_front
  bool settled_by_front_ = false;   ///< every combination
  bool limit_priced_ = false;       ///< by price_limit
  AmongEquals among_equals_ = AmongEquals::not_looked_for;
  std::vector<bool> covered_stages_;
  std::vector<OpenSearch> equals_left_;  ///< nothing is better, but something as good may win the tie
  double open_bound_ = infinity;
  double searched_best_ = infinity;  ///< of the builds that the search has found
};

}  // namespace millwright::solver
