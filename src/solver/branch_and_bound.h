// SPDX-License-Identifier: Apache-2.0
//
// The search for one combination of shared choices: one best-first branch and bound through the whole chain.
//
// A node is a label (what is chosen for the stages before) and a region of the next stage; its worth is
//     scores of the label + least of the region + least of all stages after it      (lower bounds; the last one knows
//                                                                     what the region hands on: rest_curve.h).
// The node with the least first objective is taken next (of several, with a little of the others added):
//   - a label that arrives at a stage takes over the regions of the stage's relaxation one by one, cheapest first;
//   - a region with several rows in some slot is split in two, in these rows (row_profile.h) or in a variable
//     (variable_halves.h); rows without a fitting partner drop out, and each half is bounded with the label's own
//     state; if no value of the variables is left for it, it is given up before (set_proofs.h);
//   - a region with one row per slot is a design: its variables are dealt with (continuous.h), and it becomes a label
//     of the next stage, or after the last stage a build.
// A node is given up when a constraint is certainly violated in it, when the builds known settle it (incumbents.h), or
// when a label known before the next stage dominates everything in it (dominance.h; of a front to a tolerance, but for
// a part of that).
//
// Of several objectives thousands of labels may arrive at a stage, and of one that continuous variables move: those in
// alike states divide its regions together, and ask only about single designs at their own state (shared_regions.h).
//
// Nodes are taken in batches of fixed size that are worked on in parallel and merged in order, so the search, and with
// it the answer among equals, does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "solver/best_first.h"
#include "solver/continuous.h"
#include "solver/dominance.h"
#include "solver/incumbents.h"
#include "solver/leaf_precision.h"
#include "solver/search_control.h"
#include "solver/set_proofs.h"
#include "solver/shared_regions.h"
#include "solver/split_worth.h"

namespace millwright::solver {

struct SearchResult {
  bool complete = true;                                          ///< false: time limit, or something undecided
  double lower_bound = std::numeric_limits<double>::infinity();  ///< of the first objective, of what is left open
};

class BranchAndBound {
 public:
  BranchAndBound(const Problem& problem,
                 const Criteria& criteria,
                 std::vector<StagePlan>& plans,
                 Incumbents& incumbents,
                 SearchControl& control,
                 LeafPrecision precision);

  /// Goes on until the search is done, time is up, or so many nodes more have been looked at.
  SearchResult run(std::uint64_t most_nodes = std::numeric_limits<std::uint64_t>::max());
  /// For a good build, instead of `run`: a beam search. Before each stage only so many labels are followed, those that
  /// arrive first; so many nodes are looked at for the first of them, and a tenth for another.
  void look(std::size_t labels, std::uint64_t most_nodes);
  /// For a first build, instead of `run`: until one is found that is better than those known, or so many nodes have
  /// been looked at. To divide a node raises its bound by a little; what is expected of all the divisions that a node
  /// is away from a design counts in its order, so that small nodes come before large ones that are hardly better.
  void dive(std::uint64_t most_nodes);
  /// Of a front whose search has ended before it was done: widens the tolerance of the incumbents until they settle
  /// what is left.
  void settle_open();
  /// By how much of the whole labels of a front have been given up for others.
  [[nodiscard]] double slack_given() const;
  /// What a search that is done has left undecided.
  [[nodiscard]] UndecidedDesigns undecided_designs() const;
  [[nodiscard]] const LeafPrecision& precision() const { return precision_; }

 private:
  static constexpr std::size_t whole_stage = static_cast<std::size_t>(-1);
  struct Node {
    std::uint32_t label = 0;
    std::size_t next_region = whole_stage;  ///< of the stage's open regions; whole_stage: `part` or `region` is meant
    SharedPart* part = nullptr;             ///< null: `region`
    Region region;
    std::vector<double> score;    ///< totals, lower bounds
    std::vector<double> reached;  ///< the same without the stages after this one
    std::vector<Interval> handed_on;
    double utilisation = 0.0;
    std::uint64_t open = 0;
    std::uint32_t depth = 0;
    /// What has been proved of the whole holds for this part of it.
    void take_over_bounds(const Node& whole) {
      for (std::size_t k = 0; k < score.size(); ++k) score[k] = std::max(score[k], whole.score[k]);
    }
  };
  struct Key {
    double score = 0.0;  ///< order_of the node
    std::uint32_t depth = 0;
    std::uint64_t order = 0;
    /// Least score first; among equals the deepest stage, the deepest node, the older.
    static bool later(const Key& a, const Key& b) {
      if (a.score != b.score) return a.score > b.score;
      if (a.depth != b.depth) return a.depth < b.depth;
      return a.order > b.order;
    }
  };
  /// What came out of one node; merged in order.
  struct Outcome {
    std::vector<Node> nodes;
    LeafAnswer leaf;
    bool is_leaf = false;
    std::vector<OpenBox> boxes = {};             ///< in which a leaf is looked at
    std::optional<std::size_t> divided = {};     ///< the slot in which a region was divided
    std::optional<SetProofs::Asked> asked = {};  ///< about a region as a whole (refuted_by_variables)
  };

  [[nodiscard]] double slack_of_labels() const;
  void widen();
  void rate_objectives();
  [[nodiscard]] double order_of(const Node& node) const;
  [[nodiscard]] double divisions_left(const Node& node) const;
  void start();
  void work_on_batch();
  void put(Node node);
  bool push(Node node);
  /// False: one of these lower bounds of totals is infinity, so that no feasible design follows.
  [[nodiscard]] bool can_end(std::span<const double> score) const;
  [[nodiscard]] bool useless(const Node& node) const;
  [[nodiscard]] bool useless(const Label& label, std::size_t stage, const Worth& own) const;
  [[nodiscard]] std::vector<double> with_rest(std::size_t stage,
                                              std::span<const double> reached,
                                              std::span<const Interval> handed_on) const;
  void expand(const Node& node, Outcome& outcome, Desk& desk) const;
  [[nodiscard]] std::size_t first_to_follow(const Label& label, std::size_t region) const;
  void expand_stream(const Node& node, Outcome& outcome, Desk& desk) const;
  void find_region(Node& node) const;
  [[nodiscard]] bool asks_nothing(const Node& node) const;
  [[nodiscard]] bool make_part(const Node& from, SharedPart& part, Node& node) const;
  void go_down(const Node& from, SharedPart* part, double up_to, Outcome& outcome) const;
  void expand_part(const Node& node, Outcome& outcome, Desk& desk) const;
  bool refuted_by_variables(const Node& node, Outcome& outcome, Desk& desk) const;
  void branch(const Node& node, Outcome& outcome, Desk& desk) const;
  bool bound_node(Node& node, Desk& desk) const;
  void offer(const Node& from, Region part, Outcome& outcome, Desk& desk) const;
  void merge(Node& node, Outcome& outcome);
  void arrive(const Node& node, const StagePoint& point, std::vector<OpenBox::Origin> origins);
  void finish(Label label);
  /// Designs of which these are lower bounds, unless the incumbents settle them.
  struct Undecided {
    std::vector<double> score;
    double utilisation = 0.0;
    std::uint32_t label = 0;
    std::vector<Row> rows = {};       ///< chosen for the label's next stage
    std::vector<OpenBox> boxes = {};  ///< of its variables; none: all
  };
  void leave_undecided(Undecided undecided);
  void keep_boxes(std::vector<OpenBox>& boxes);
  void forget_settled();
  bool make_stream(std::uint32_t label, std::size_t region, Node& node) const;
  [[nodiscard]] bool shares_regions(std::uint32_t label) const;
  void note_scores(const Bounds& bounds, Node& node) const;
  void follow(std::uint32_t label);
  [[nodiscard]] Build build_of(const Label& last) const;
  [[nodiscard]] double open_bound() const;

  const Problem& problem_;
  const Criteria& criteria_;
  std::vector<StagePlan>& plans_;
  Incumbents& incumbents_;
  SearchControl& control_;
  LeafPrecision precision_;
  std::deque<Label> labels_;
  std::vector<LabelSet> label_sets_;  ///< [stage]: labels before it
  double slack_ = 0.0;                ///< in them
  /// [stage][region][score]: least of the regions from this one on, with all stages after.
  std::vector<std::vector<std::vector<double>>> tail_;
  std::vector<SplitWorth> worth_;                       ///< [stage]
  std::vector<SetProofs> set_proofs_;                   ///< [stage]
  std::vector<std::unique_ptr<SharedRegions>> shared_;  ///< [stage]; null: each label divides regions by itself
  std::vector<SharedRegions::Cell*> cells_;             ///< [label]; null: it does
  std::vector<double> rates_;                           ///< [further objective]: worth in the first, in order_of
  BestFirst<Node, Key> open_;
  std::uint64_t order_ = 0, nodes_ = 0;
  std::vector<Outcome> outcomes_;                                     ///< of the batch at work
  std::size_t last_stage_ = std::numeric_limits<std::size_t>::max();  ///< in `look`: labels of later ones wait
  std::vector<Node> waiting_;
  double later_for_divisions_ = 0.0;     ///< in `dive`: added to the order of a node for each that is left
  std::vector<double> divisions_after_;  ///< in `dive`, [stage]: those of all stages after it
  std::vector<Undecided> undecided_;
  bool many_undecided_ = false;          ///< more than are kept
  std::vector<double> least_undecided_;  ///< scores of those that are not kept
  double widening_ = 1.0;                ///< what has been made of the tolerances (SearchControl::tolerance_of_front)
  std::size_t boxes_kept_ = 0;
  double undecided_bound_ = std::numeric_limits<double>::infinity();
};

}  // namespace millwright::solver
