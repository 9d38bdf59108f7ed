// SPDX-License-Identifier: Apache-2.0
#include "solver/stagewise_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/leaf_point.h"
#include "solver/least_front.h"
#include "solver/rest_curve.h"
#include "solver/stagewise_sums.h"

namespace millwright::solver {
namespace {

constexpr std::size_t front_nodes = 3000;                      // spent on the least front of one stage
constexpr std::size_t most_extensions = std::size_t{1} << 22;  // kept at a time
constexpr double rounding_of_sums = 1e-13;                     // less than makes two totals differ

/// Room for the rounding of sums, so that bounds stay bounds.
double with_slack(double bound) { return std::isfinite(bound) ? bound + bound_slack * std::fabs(bound) : bound; }

/// Whether each label has one design there, or a cover of its own.
bool is_alone(const StagePlan& plan) {
  return plan.stage->slots().empty() && (is_covered(plan) || plan.stage->variables().empty());
}

/// The largest value that does not count as equal.
double less_than(double score) { return std::isfinite(score) ? score - equal_sums * std::fabs(score) : score; }

}  // namespace

StagewiseSearch::StagewiseSearch(const Problem& problem,
                                 const Criteria& criteria,
                                 std::vector<StagePlan>& plans,
                                 Incumbents& incumbents,
                                 SearchControl& control)
    : problem_(problem), criteria_(criteria), plans_(plans), incumbents_(incumbents), control_(control) {
  std::size_t covered = 0;
  for (const StagePlan& plan : plans_) {
    if (is_covered(plan) && criteria_.objectives == 1) applicable_ = false;  // its covers are coarser than a gap
    forms_.push_back(find_state_form(plan, control_.desk(0)));
    applicable_ = applicable_ && (is_alone(plan) || (forms_.back().additive && !is_covered(plan)));
    covered += is_covered(plan) ? 1 : 0;
  }
  // The stages' shares add up; a little is left for rounding.
  const double tolerance = control_.options().tolerance_of_front();
  leaf_tolerance_ = 0.9 * tolerance / static_cast<double>(std::max<std::size_t>(covered, 1));
}

bool StagewiseSearch::run(bool shared_allowances, double least_total, const std::function<bool()>& otherwise) {
  least_total_ = least_total;
  find_rest();
  if (nothing_left_ = rest_.front().empty(); nothing_left_) return true;
  if (!pass({.compared = Compared::objectives, .patience = quick_patience()}) && control_.time_is_up()) return false;
  // Where what is cheap first leaves too little of a shared allowance to what comes later, nothing is found that way.
  const bool nothing_yet = criteria_.objectives == 1 && incumbents_.builds().empty();
  if ((shared_allowances || nothing_yet) && !find_better_first(shared_allowances)) return false;
  if (!look_for_any()) return false;
  if (!used_prices_) {
    undecided_ = false;  // what a quick pass left undecided the whole one decides again
    if (pass({.patience = control_.options().stage_patience})) return !undecided_;
    if (control_.time_is_up() || !find_better_first(false)) return false;
  }
  undecided_ = false;
  if (settled_) return true;
  if (criteria_.objectives > 1 && used_prices_) return by_sections();
  if (used_prices_) {
    if (!control_.while_there_is_time([&] { settled_ = !find_vectors(); })) return false;
    if (settled_) return true;
  }
  if (criteria_.objectives > 1) return pass({}) && !undecided_;
  return (incumbents_.builds().empty() && otherwise()) || find_least();
}

/// What all stages from each one on add at least.
void StagewiseSearch::find_rest() {
  const std::size_t stages = plans_.size();
  std::vector<std::vector<Pair>> own(stages);
  control_.crew().run(stages, [&](std::size_t i, unsigned thread) {
    own[i] = least_front(plans_[i], front_nodes, control_.desk(thread));
  });
  rest_.assign(stages + 1, {Pair{}});
  for (std::size_t i = stages; i-- > 0;) rest_[i] = sum_of_staircases(own[i], rest_[i + 1], staircase_points);
  floor_total_ = -infinity;
  for (const Floor& floor : criteria_.floors) {
    double least = floor.resource == 0 ? 0.0 : -infinity;
    for (const StagePlan& plan : plans_) least = scalar::rounding::sum_down(least, plan.least[floor.bound]);
    floor_total_ = std::max(floor_total_, least);
  }
  least_total_ = std::max(least_total_, floor_total_);
}

/// A total matters only below a corner between two neighbours of the known front. `equals`: they may win a tie.
std::vector<Pair> StagewiseSearch::corners(bool equals) const {
  const std::vector<RankedBuild>& builds = incumbents_.builds();
  std::vector<Pair> corners;
  if (criteria_.objectives == 1 && !builds.empty()) {
    // Something cheaper, or something as cheap that may win the tie.
    if (!least_known_) corners.push_back({less_than(builds[0].score[0]), infinity});
    if (equals) corners.push_back({with_slack(builds[0].score[0]), with_slack(criteria_.second(builds[0].score))});
  } else {
    double second = infinity;
    for (const RankedBuild& build : builds) {
      corners.push_back({less_than(build.score[0]), less_than(second)});
      corners.push_back({with_slack(build.score[0]), with_slack(build.score[1])});
      second = build.score[1];
    }
    corners.push_back({infinity, less_than(second)});
  }
  std::erase_if(corners, [&](const Pair& corner) {
    return corner.first < section_.from || corner.first < floor_total_ - rounding_of_sums * std::fabs(floor_total_);
  });
  // And nothing matters beyond the limits.
  for (Pair& corner : corners) {
    corner.first = std::min({corner.first, with_slack(criteria_.limit[0]), with_slack(section_.to)});
    if (criteria_.size() > 1) corner.second = std::min(corner.second, with_slack(criteria_.limit[1]));
  }
  return criteria_.objectives > 1 ? upper_staircase(std::move(corners)) : corners;
}

void StagewiseSearch::update_useful(bool equals) {
  const std::vector<Pair> corners = this->corners(equals);
  useful_.clear();
  for (const auto& rest : rest_) useful_.push_back(difference_of_staircases(corners, rest, staircase_points));
}

bool StagewiseSearch::pass(const Pass& pass) {
  haste_ = pass.haste;
  patience_ = pass.patience;
  update_useful(pass.compared != Compared::without_ties);
  labels_.assign(plans_.size() + 1, {});
  labels_[0].push_back(first_label(problem_, criteria_));
  for (std::size_t stage = 0; stage < plans_.size(); ++stage) {
    const int digits = haste_ ? haste_->digits : exact_digits;
    const Comparison comparison(criteria_, plans_[stage].after, pass.compared, digits);
    const bool label_by_label = is_alone(plans_[stage]) && (forms_[stage].scores_vary() || !forms_[stage].additive);
    const bool advanced = is_covered(plans_[stage]) ? advance_covered(stage, comparison)
                          : label_by_label          ? advance_each(stage, comparison)
                                                    : advance(stage, comparison);
    if (!advanced) return false;
    if (haste_) keep_best(stage);
  }
  for (const Label& label : labels_.back()) finish(label);
  return true;
}

/// False: it was given up.
bool StagewiseSearch::find_candidates_of(std::vector<Chunk>& chunks) {
  if (chunks.empty()) return true;
  std::vector<const CandidateQuestion*> questions;
  for (const Chunk& chunk : chunks) questions.push_back(&chunk.question);
  std::vector<CandidateSet> sets = find_candidates(questions, control_.desk(0));
  for (std::size_t i = 0; i < chunks.size(); ++i) chunks[i].set = std::move(sets[i]);
  return chunks.front().set.complete;
}

/// All labels before one stage to those before the next; false when time is up.
bool StagewiseSearch::advance(std::size_t stage, const Comparison& comparison) {
  std::vector<Chunk> chunks = make_chunks(stage, comparison);
  if (!find_candidates_of(chunks)) return false;
  extensions_.clear();
  keys_.clear();
  if (!control_.while_there_is_time([&] { sharpen_planes(stage, chunks); })) return false;
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    control_.nodes += chunks[i].set.nodes;
    if (!extend(stage, static_cast<std::uint32_t>(i), chunks, comparison)) return false;
  }
  sort_extensions(comparison);
  KnownKeys known(comparison);
  const bool exact = forms_[stage].all_exact();
  std::vector<double> own_key(comparison.dimensions());  // of the label, not of what it was bounded by
  for (std::size_t i = 0; i < extensions_.size(); ++i) {
    if (i % 1024 == 0 && control_.time_is_up()) return false;
    const Extension& extension = extensions_[i];
    const std::span<const double> key(keys_.data() + extension.key, comparison.dimensions());
    if (known.dominates(key)) continue;
    if (!arrive(stage, chunks[extension.chunk], extension)) continue;
    if (!exact) comparison.key(labels_[stage + 1].back().score, labels_[stage + 1].back().state, own_key.data());
    known.add(exact ? key : std::span<const double>(own_key));
  }
  control_.report(incumbents_.best());
  return true;
}

/// Whether what the stages after this one must add to these scores, given what is handed to them, leaves a total that
/// is below some corner of the known front.
bool StagewiseSearch::may_matter(std::size_t stage,
                                 std::span<const double> score,
                                 std::span<const double> state) const {
  const StagePlan& plan = plans_[stage];
  if (!bearable(plan, state)) return false;
  if (plan.curves.empty() && plan.planes.empty() && criteria_.floors.empty()) return true;
  const auto total = [&](std::size_t k) { return score[k] + rest_after(plan, k, state); };
  std::array<double, 2> least{total(0), criteria_.size() > 1 ? total(1) : 0.0};
  for (const Floor& floor : criteria_.floors)
    if (floor.resource < least.size()) least[floor.resource] = std::max(least[floor.resource], total(floor.bound));
  LeastTotals totals(least[0], least[1]);
  if (criteria_.objectives > 1) totals.add_mixed(plan, score, [&](std::size_t c) { return state[c]; });
  return totals.below(useful_.back()) &&
         (plan.vectors.add.empty() ||
          plan.vectors.reach(
              {score[0], criteria_.second(score)}, [&](std::size_t c) { return state[c]; }, useful_.back()));
}

/// Adds the extensions of one chunk. False: there are too many, or time is up.
bool StagewiseSearch::extend(std::size_t stage,
                             std::uint32_t index,
                             const std::vector<Chunk>& chunks,
                             const Comparison& comparison) {
  const Chunk& chunk = chunks[index];
  std::uint32_t label = 0;
  const auto keep = [&](std::uint32_t candidate, const auto& score, const auto&... states) {
    extensions_.push_back({index, label, candidate, keys_.size()});
    keys_.resize(keys_.size() + comparison.dimensions());
    comparison.best_key(score, states..., keys_.data() + extensions_.back().key);
  };
  std::size_t most = std::max(most_extensions, 2 * extensions_.size());
  for (; label < chunk.labels.size(); ++label) {
    sums(stage, chunk, label, 1, keep);
    if (extensions_.size() > patience_ || control_.time_is_up()) return false;
    if (extensions_.size() <= most) continue;
    compact(stage, chunks, comparison);
    most = std::max(most_extensions, 2 * extensions_.size());
  }
  return true;
}

/// Ascending in the first coordinate, among equals in the second, ...: nothing is dominated by what comes after it.
void StagewiseSearch::sort_extensions(const Comparison& comparison) {
  const std::size_t n = comparison.dimensions();
  std::sort(extensions_.begin(), extensions_.end(), [&](const Extension& a, const Extension& b) {
    const double* left = keys_.data() + a.key;
    const double* right = keys_.data() + b.key;
    for (std::size_t d = 0; d < n; ++d) {
      if (left[d] != right[d]) return left[d] < right[d];
    }
    return a.key < b.key;
  });
}

/// The key of an extension where what it hands on is at its worst.
void StagewiseSearch::worst_key(std::size_t stage,
                                const Chunk& chunk,
                                const Extension& extension,
                                const Comparison& comparison,
                                double* out) const {
  const Label& label = labels_[stage][chunk.labels[extension.label]];
  const Candidate& candidate = chunk.set.candidates[extension.candidate];
  std::vector<double> score = label.score;
  for (std::size_t k = 0; k < score.size(); ++k) score[k] += candidate.most_score[k];
  std::vector<double> least = candidate.least;
  std::vector<double> most = candidate.most;
  for (std::size_t c = 0; c < least.size(); ++c) {
    const double change = forms_[stage].change(c, chunk.set.reference, label.state);
    least[c] += change;
    most[c] += change;
  }
  comparison.best_key(score, most, least, out);
}

/// Drops what feasible extensions dominate, so that memory stays bounded.
void StagewiseSearch::compact(std::size_t stage, const std::vector<Chunk>& chunks, const Comparison& comparison) {
  sort_extensions(comparison);
  const std::size_t n = comparison.dimensions();
  KnownKeys known(comparison);
  const bool exact = forms_[stage].all_exact();
  std::vector<double> worst(n);
  std::size_t looked_at = 0;
  bool hurry = false;
  std::erase_if(extensions_, [&](const Extension& extension) {
    hurry = hurry || (++looked_at % 1024 == 0 && control_.time_is_up());
    if (hurry) return true;  // the pass is given up anyway
    const std::span<const double> key(keys_.data() + extension.key, n);
    if (known.dominates(key)) return true;
    if (chunks[extension.chunk].set.candidates[extension.candidate].universal) {
      if (!exact) worst_key(stage, chunks[extension.chunk], extension, comparison, worst.data());
      known.add(exact ? key : std::span<const double>(worst));
    }
    return false;
  });
  std::vector<double> keys;
  keys.reserve(extensions_.size() * n);
  for (Extension& extension : extensions_) {
    const auto from = keys_.begin() + static_cast<std::ptrdiff_t>(extension.key);
    extension.key = keys.size();
    keys.insert(keys.end(), from, from + static_cast<std::ptrdiff_t>(n));
  }
  keys_ = std::move(keys);
}

/// Decides the feasibility of a design that is not feasible for all of its chunk's labels, once for equal states.
const LeafAnswer& StagewiseSearch::leaf(std::size_t stage, Chunk& chunk, const Extension& extension) {
  const std::uint64_t name = (std::uint64_t{chunk.group[extension.label]} << 32U) | extension.candidate;
  const auto [place, first] = chunk.leaves.try_emplace(name);
  if (!first) return place->second;
  const StagePlan& plan = plans_[stage];
  const Region region =
      region_of(*plan.stage, plan.shared, chunk.set.candidates[extension.candidate].rows, plan.region.variables);
  const Label& label = labels_[stage][chunk.labels[extension.label]];
  place->second = solve_leaf({.plan = &plan,
                              .label = &label,
                              .region = &region,
                              .tolerance = 0.0,
                              .relieve = false,
                              .start = chunk.set.candidates[extension.candidate].variables},
                             control_.desk(0));
  undecided_ = undecided_ || place->second.undecided;
  return place->second;
}

/// Takes an extension over if it is feasible.
bool StagewiseSearch::arrive(std::size_t stage, Chunk& chunk, const Extension& extension) {
  const Candidate& candidate = chunk.set.candidates[extension.candidate];
  std::vector<double> variables = candidate.variables;
  if (!candidate.universal || !candidate.is_least) {
    const LeafAnswer& answer = leaf(stage, chunk, extension);
    if (answer.points.empty()) return false;
    variables = answer.points.front().variables;
  }
  Label label;
  if (!evaluate(stage, chunk.labels[extension.label], candidate.rows, std::move(variables), label)) return false;
  if (!bearable(plans_[stage], label.state)) return false;
  labels_[stage + 1].push_back(std::move(label));
  return true;
}

/// Evaluates a design that was proved feasible; false when it breaks a limit of the problem.
bool StagewiseSearch::evaluate(std::size_t stage,
                               std::uint32_t parent,
                               const std::vector<Row>& rows,
                               std::vector<double> variables,
                               Label& label) {
  const Label& from = labels_[stage][parent];
  const auto& answer =
      control_.desk(0).evaluate(*plans_[stage].stage, Point{plans_[stage].shared, from.state, rows, variables});
  const double worst = worst_of(answer.utilisation);
  if (!(worst <= 1.0)) {  // only rounding can contradict
    undecided_ = true;
    return false;
  }
  label.parent = parent;
  label.stage = stage + 1;
  label.resources = from.resources;
  for (std::size_t r = 0; r < label.resources.size(); ++r) label.resources[r] += answer.resources[r];
  label.score.resize(criteria_.size());
  criteria_.scores<double>(label.resources, label.score);
  label.state = answer.handed_on;
  label.utilisation = std::max(from.utilisation, worst);
  std::vector<double> total = label.score;
  for (std::size_t k = 0; k < total.size(); ++k)
    total[k] += rest_after(plans_[stage], k, std::span<const double>(label.state));
  const bool can_end = std::ranges::count(total, infinity) == 0;  // else no design of later stages is feasible
  if (!can_end || !incumbents_.within_limits(total)) return false;
  label.rows = rows;
  label.variables = std::move(variables);
  return true;
}

}  // namespace millwright::solver
