// SPDX-License-Identifier: Apache-2.0
//
// The search stage by stage, for one combination of shared choices: the exact front in two objectives, or the best in
// one. All labels go through a stage at once. (branch_and_bound.h walks one label at a time, which suits a single
// objective as long as few labels are opened. A front opens thousands, and they would all walk through the same
// regions.)
//
//   labels before a stage (scores so far, state)
//     -> sorted by the state component that decides most about feasibility, and cut into chunks of alike states
//     -> for each chunk the designs of the stage that can matter to any of its labels (candidates.h), found together
//     -> labels x candidates, as sums; what cannot reach the known front any more is dropped (staircase.h)
//     -> in ascending order of all coordinates: dropped if a kept one is at least as good in every coordinate, else
//        its feasibility is decided at the label's own state, and it is evaluated exactly: a label before the next
//        stage
//
// A quick first pass compares scores only, and so finds good builds but proves nothing; the second compares everything
// that matters and is exact: in the end the builds known are the front.
//
// A stage without slots whose variables move scores or states (a shaft of free diameter) is asked label by label: its
// designs are covered to Options::front_tolerance by real ones (continuous.h), and those become the labels. So with
// such stages every design is matched within the tolerance by a build of the front or by one that a later stage refuses
// for being heavier by no more than the tolerance; without them the front is exact. What is lost that way is found by
// branch_and_bound.h, from the builds of this front (solver.cpp).
//
// A stage whose variables move one component handed on and nothing else (a ramp that decides how many watts a drive
// takes) is done like one whose variables decide feasibility only: a design hands on the least that some feasible
// variables allow (least_state.h), known within bounds over a chunk and found exactly at a label's own state.
//
// Of a single objective the least comes first, without comparing what decides between equals; builds as good as the
// best are looked at when the least of all combinations of shared choices is known (decide_equals).
//
// Where a score depends on the state (a position error on the carried mass) it is known within bounds over a chunk. A
// stage that chooses nothing (what is owned of a part and what is to be bought) is asked label by label then.
//
// Where stages share allowances that bind, prices for those and for mixes of the two objectives come first
// (rest_plane.h), and what is too much at once is done in sections of the front (stagewise_sections.cpp).
//
// What it cannot do is left to branch_and_bound.h: other variables that move scores or states together with slots,
// states that do not simply add up (state_form.h), designs whose feasibility stays undecided.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "solver/candidates.h"
#include "solver/continuous.h"
#include "solver/incumbents.h"
#include "solver/rest_curve.h"
#include "solver/rest_plane.h"
#include "solver/search_control.h"

namespace millwright::solver {

class StagewiseSearch {
 public:
  StagewiseSearch(const Problem& problem,
                  const Criteria& criteria,
                  std::vector<StagePlan>& plans,
                  Incumbents& incumbents,
                  SearchControl& control);

  /// Whether the method can do this problem at all.
  [[nodiscard]] bool applicable() const { return applicable_; }
  /// True when the incumbents are the front, but for builds that are equal in a single objective and may win the tie
  /// (`equals_left`). False: time limit, or something undecided (then `undecided()`).
  /// `shared_allowances`: prices for them have been of use elsewhere in the problem. `least_total`: of the first score,
  /// as far as it is known. `otherwise`: asked before what takes long with a single objective, if no build is known
  /// yet; true: the incumbents are now the answer, or there is none.
  bool run(bool shared_allowances, double least_total, const std::function<bool()>& otherwise);
  /// Whether `decide_equals` has something to do.
  [[nodiscard]] bool equals_left() const { return least_known_; }
  /// Of builds that are equal in the objective the best, after a `run` on these plans that left equals; better in the
  /// objective there is none. False: not all of them were compared, for want of time or since something is undecided.
  bool decide_equals();
  enum class Difficulty { out_of_time, easy, hard };
  /// Whether to prove things takes so long that it is worth looking for any build first (else it is easy: `run` does
  /// it). To be called before `look`.
  Difficulty find_difficulty();
  /// For any build, by a beam search: using up all that later stages can bear counts as `share` of the least first
  /// score, and so many nodes are looked at for the designs of a chunk. False when time is up.
  bool look(double share, std::size_t nodes) { return pass({.haste = Haste{.share = share, .nodes = nodes}}); }
  [[nodiscard]] bool undecided() const { return undecided_; }
  /// Whether it was found at once that some stage has no design that is feasible and may matter.
  [[nodiscard]] bool nothing_left() const { return nothing_left_; }
  /// What a single objective comes to at least, as far as `run` has proved it: less than that or the best build nothing
  /// does.
  [[nodiscard]] double least_total() const { return least_total_ - bound_slack * std::fabs(least_total_); }
  /// Whether shared allowances were given prices (rest_plane.h).
  [[nodiscard]] bool used_prices() const { return used_prices_; }

  static constexpr std::size_t few_nodes = 100, many_nodes = 1000;  ///< for `look`

 private:
  static constexpr std::size_t staircase_points = 600;
  static constexpr std::size_t endless = std::numeric_limits<std::size_t>::max();
  /// A beam search for a first answer.
  struct Haste {
    double share = 0.0;       ///< using up all that later stages can bear counts as so much of the least first score
    std::size_t nodes = 100;  ///< looked at for the designs of a chunk
    std::size_t labels = 30;  ///< kept before each stage
    int digits = 6;           ///< binary, of what is compared
    Mix mix = {};             ///< of the objectives, that is to be small
  };
  struct Pass {
    Compared compared = Compared::everything;
    std::optional<Haste> haste = std::nullopt;
    std::size_t patience = endless;  ///< nodes or extensions at a stage from which on it is given up
  };
  std::vector<double> state_weights(std::size_t stage, double unit) const;
  bool look_for_builds(const Haste& haste);
  bool look_for_any();
  void improve();
  void improve_equals();
  bool has_own_best() const;
  void offer_relieved(RankedBuild ranked);
  /// For the first pass. Long where there are many nearly equal parts; then others that are quicker must find
  /// something.
  [[nodiscard]] std::size_t quick_patience() const {
    return criteria_.objectives > 1 ? control_.options().stage_patience : control_.options().stage_patience / 6;
  }
  std::optional<Mix> next_mix() const;
  void keep_best(std::size_t stage);
  /// A part of the front: first scores above `from` and up to `to`.
  struct Section {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    unsigned given_up = 0;  ///< sections around it that have been
  };
  struct Chunk {
    std::vector<std::uint32_t> labels;
    CandidateQuestion question;
    CandidateSet set;
    std::vector<std::uint32_t> group;                      ///< [label]: labels with equal influencing states
    std::unordered_map<std::uint64_t, LeafAnswer> leaves;  ///< [group, candidate]
  };
  /// A label with a candidate; its key is in keys_.
  struct Extension {
    std::uint32_t chunk = 0, label = 0, candidate = 0;
    std::size_t key = 0;
  };

  bool pass(const Pass& pass);
  bool by_sections();
  bool find_least();
  bool aim();
  bool settle(const Section& section, const std::vector<StagePlan>& plans, const std::vector<StateForm>& forms);
  std::vector<double> known_inside(const Section& section) const;
  std::size_t section_patience(unsigned given_up) const;
  double middle_of(const Section& section) const;
  double known_range() const;
  double central(double score, const Section& section) const;
  bool is_wide(const Section& section) const;
  bool is_narrow(const Section& section) const;
  std::vector<Pair> corners(bool equals = true) const;
  bool advance(std::size_t stage, const Comparison& comparison);
  bool find_candidates_of(std::vector<Chunk>& chunks);
  bool advance_covered(std::size_t stage, const Comparison& comparison);
  bool advance_each(std::size_t stage, const Comparison& comparison);
  void find_rest();
  std::vector<double> highest_scores() const;
  bool find_planes();
  bool find_vectors();
  void find_plane(const Mix& mix);
  bool find_better_first(bool shared_allowances);
  bool restrict_stages();
  void sharpen_planes(std::size_t stage, const std::vector<Chunk>& chunks);
  template <class Found>
  void sums(std::size_t stage, const Chunk& chunk, std::uint32_t label, std::size_t stride, Found&& found) const;
  void update_useful(bool equals = true);
  std::vector<Chunk> make_chunks(std::size_t stage, const Comparison& comparison) const;
  void ask(std::size_t stage, const Comparison& comparison, Chunk& chunk) const;
  void ask_totals(std::size_t stage, Chunk& chunk) const;
  template <class Priced>
  void ask_vectors(std::size_t stage, Chunk& chunk, Priced&& priced) const;
  [[nodiscard]] bool may_matter(std::size_t stage, std::span<const double> score, std::span<const double> state) const;
  bool extend(std::size_t stage, std::uint32_t index, const std::vector<Chunk>& chunks, const Comparison& comparison);
  void sort_extensions(const Comparison& comparison);
  void compact(std::size_t stage, const std::vector<Chunk>& chunks, const Comparison& comparison);
  void worst_key(std::size_t stage,
                 const Chunk& chunk,
                 const Extension& extension,
                 const Comparison& comparison,
                 double* out) const;
  bool arrive(std::size_t stage, Chunk& chunk, const Extension& extension);
  bool evaluate(std::size_t stage,
                std::uint32_t parent,
                const std::vector<Row>& rows,
                std::vector<double> variables,
                Label& label);
  void keep_undominated(std::vector<Label> labels, std::size_t stage, const Comparison& comparison);
  const LeafAnswer& leaf(std::size_t stage, Chunk& chunk, const Extension& extension);
  void finish(const Label& label);
  Build build_of(const Label& last);
  void take_stock(Build& build) const;
  void relieve(std::size_t stage, const Label& before, StageChoice& choice, double& utilisation);

  const Problem& problem_;
  const Criteria& criteria_;
  std::vector<StagePlan>& plans_;
  Incumbents& incumbents_;
  SearchControl& control_;
  std::vector<StateForm> forms_;
  std::unique_ptr<RestPlanes> planes_;
  std::vector<Mix> mixes_;                  ///< of the objectives that have planes
  double least_total_ = 0.0;                ///< of the first score
  double floor_total_ = -infinity;          ///< of the first score, by its floors
  std::vector<std::vector<Pair>> rest_;     ///< [stage]: least added by this and all later stages
  std::vector<std::vector<Pair>> useful_;   ///< [stage]: what a label before it must be below
  std::vector<std::vector<Label>> labels_;  ///< [stage]
  std::vector<Extension> extensions_;
  std::vector<double> keys_;
  double leaf_tolerance_ = 0.0;  ///< of one stage that is covered
  bool applicable_ = true;
  bool undecided_ = false;
  bool nothing_left_ = false;
  bool used_prices_ = false;
  double improved_ = std::numeric_limits<double>::infinity();  ///< the best first score that `improve` has led to
  std::optional<Haste> haste_;                                 ///< of the pass under way
  std::size_t patience_ = endless;                             ///< of the pass under way
  Section section_;                                            ///< of the front that is looked for
  bool settled_ = false;                                       ///< nothing is left that could change the known front
  bool least_known_ = false;  ///< nothing has a smaller first score than the best build, of these shared choices
};

}  // namespace millwright::solver
