// SPDX-License-Identifier: Apache-2.0
//
// What is done before a long pass: prices for the allowances that stages share, good builds by them, and less to choose
// from.
#include <algorithm>
#include <array>
#include <cmath>

#include "solver/neighbours.h"
#include "solver/rest_curve.h"
#include "solver/stagewise_search.h"
#include "solver/stagewise_sums.h"

namespace millwright::solver {
StagewiseSearch::Difficulty StagewiseSearch::find_difficulty() {
  if (control_.time_is_up()) return Difficulty::out_of_time;
  find_rest();
  if (pass({.compared = Compared::objectives, .patience = quick_patience()})) return Difficulty::easy;
  return control_.time_is_up() ? Difficulty::out_of_time : Difficulty::hard;
}

/// While there is no build: passes that save more and more for later stages. False when time is up.
bool StagewiseSearch::look_for_any() {
  for (const double share : {0.03, 0.1, 0.3, 1.0}) {
    if (!incumbents_.builds().empty() || !control_.options().look_first) return true;
    for (const std::size_t nodes : {few_nodes, many_nodes})
      if (!look(share, nodes)) return false;
  }
  return true;
}

/// Whether there is a best build to be changed, of these shared choices.
bool StagewiseSearch::has_own_best() const {
  if (criteria_.objectives > 1 || incumbents_.builds().empty() || !control_.options().look_first) return false;
  const std::vector<Row>& shared = incumbents_.builds().front().build.shared;
  return std::equal(shared.begin(), shared.end(), plans_.front().shared.begin());
}

/// Changes single parts of the best build for better ones, if it has not been changed yet.
void StagewiseSearch::improve() {
  if (!has_own_best() || !(incumbents_.builds().front().score[0] < improved_)) return;
  RankedBuild ranked = incumbents_.builds().front();
  const auto value = [&](std::span<const double> resources) {
    criteria_.scores<double>(resources, ranked.score);
    return ranked.score[0];
  };
  ranked.build = Neighbours(problem_).improved(ranked.build, value, [this] { return control_.time_is_up(); });
  improved_ = value(ranked.build.resources);
  offer_relieved(std::move(ranked));
}

/// The same for what decides between equals.
void StagewiseSearch::improve_equals() {
  if (!has_own_best()) return;
  RankedBuild ranked = incumbents_.builds().front();
  Neighbours(problem_).improve_equals(criteria_, ranked, [this] { return control_.time_is_up(); });
  offer_relieved(std::move(ranked));
}

void StagewiseSearch::offer_relieved(RankedBuild ranked) {
  ranked.build.worst_utilisation = 0.0;
  for (std::size_t stage = 0; stage < plans_.size(); ++stage) {
    StageChoice& choice = ranked.build.stages[stage];
    Label before = first_label(problem_, criteria_);
    before.state = choice.inherited;
    before.enclosure.assign(before.state.begin(), before.state.end());
    relieve(stage, before, choice, ranked.build.worst_utilisation);
  }
  take_stock(ranked.build);
  incumbents_.offer(std::move(ranked));
}

/// Before a long pass: prices for shared allowances, good builds by them, and less to choose from. False: time is up.
/// `shared_allowances`: prices have been of use with other shared choices.
bool StagewiseSearch::find_better_first(bool shared_allowances) {
  improve();
  for (std::size_t score = 0; score < criteria_.objectives; ++score) mixes_.push_back(Mix::only(score));
  bool priced = false;
  const bool prepared = control_.while_there_is_time([&] {
    planes_ = std::make_unique<RestPlanes>(problem_, plans_, forms_, control_.desk(0));
    priced = find_planes();
  });
  if (!prepared || !priced) return prepared;
  used_prices_ = true;
  // What has been found with other shared choices says enough here.
  const bool look = incumbents_.builds().empty() || !shared_allowances;
  const bool front = criteria_.objectives > 1;
  for (const Haste& haste : {Haste{.nodes = 100}, {.nodes = 1000}, {.nodes = 2000, .labels = 100, .digits = 14}}) {
    if (front && haste.nodes > 1000) break;  // sections look on
    if (front && !control_.while_there_is_time([&] { settled_ = !find_vectors(); })) return false;
    if (settled_) return true;
    if (front) planes_->keep_regions();
    if (look && !look_for_builds(haste)) return false;
    improve();
    const auto restrict_again = [&] {
      settled_ = find_planes() && !incumbents_.builds().empty() && !restrict_stages();
    };
    if (!control_.while_there_is_time(restrict_again)) return false;
    if (settled_) return true;
  }
  return true;
}

/// A pass for each mix of the objectives; between the builds that are found there are further mixes. False: time is up.
bool StagewiseSearch::look_for_builds(const Haste& haste) {
  constexpr std::size_t most_mixes = 7;
  if (!control_.options().look_first) return true;
  Haste here = haste;
  for (std::size_t i = 0; i < mixes_.size(); ++i) {
    here.mix = mixes_[i];
    if (!pass({.haste = here})) return false;
    if (i + 1 < mixes_.size() || mixes_.size() >= most_mixes || criteria_.objectives < 2) continue;
    const std::optional<Mix> next = next_mix();
    if (!next) break;
    mixes_.push_back(*next);
    if (!control_.while_there_is_time([&] { find_plane(*next); })) return false;
  }
  return true;
}

/// Across the longest edge of the convex hull of the known front, if no mix is like it.
std::optional<Mix> StagewiseSearch::next_mix() const {
  std::vector<Pair> hull;
  for (const RankedBuild& build : incumbents_.builds()) {
    const Pair point{build.score[0], build.score[1]};
    const auto lies_above = [&] {
      const Pair& a = hull[hull.size() - 2];
      const Pair& b = hull.back();
      return (b.first - a.first) * (point.second - a.second) <= (b.second - a.second) * (point.first - a.first);
    };
    while (hull.size() > 1 && lies_above()) hull.pop_back();
    hull.push_back(point);
  }
  std::optional<Mix> best;
  if (hull.size() < 2) return best;
  const double width = hull.back().first - hull.front().first;
  const double height = hull.front().second - hull.back().second;
  double longest = 0.0;
  for (std::size_t i = 0; i + 1 < hull.size(); ++i) {
    const double right = (hull[i + 1].first - hull[i].first) / width;
    const double down = (hull[i].second - hull[i + 1].second) / height;
    const auto alike = [&](const Mix& mix) {
      constexpr double little = 0.15;  // radians
      const double angle = std::atan2(mix.second * height, mix.first * width);
      return std::fabs(angle - std::atan2(right, down)) < little;
    };
    if (right + down <= longest || std::any_of(mixes_.begin(), mixes_.end(), alike)) continue;
    longest = right + down;
    best = Mix{down / width, right / height};
  }
  return best;
}

/// Of the builds known, or infinity.
std::vector<double> StagewiseSearch::highest_scores() const {
  std::vector<double> most(criteria_.objectives, incumbents_.builds().empty() ? infinity : -infinity);
  for (const RankedBuild& build : incumbents_.builds())
    for (std::size_t k = 0; k < most.size(); ++k) most[k] = std::max(most[k], build.score[k]);
  return most;
}

/// Planes over the states. False where nothing has a price.
bool StagewiseSearch::find_planes() {
  for (const Mix& mix : mixes_) find_plane(mix);
  return std::any_of(plans_.begin(), plans_.end(), [](const StagePlan& plan) { return !plan.planes.empty(); });
}

void StagewiseSearch::find_plane(const Mix& mix) {
  double known = infinity;
  for (const RankedBuild& build : incumbents_.builds()) known = std::min(known, mix.of(build.score));
  const double least = planes_->find(mix, known);
  if (mix == Mix::only(0)) least_total_ = std::max(least_total_, least);
}

/// Leaves out what cannot reach the known front. False: nothing that is left can.
bool StagewiseSearch::restrict_stages() {
  update_useful();
  if (!planes_->restrict_to(useful_.back())) return false;
  Desk& desk = control_.desk(0);
  look_again(problem_, plans_, desk);
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    // A slope without bound may be bounded now, and yet no constant: what was said of more designs is true of fewer.
    StateForm form = find_state_form(plans_[i], desk);
    if (form.additive || !forms_[i].additive) forms_[i] = std::move(form);
  }
  planes_->tighten_limits();
  return true;
}

/// What a component handed on weighs against a mix of scores of `unit`: by its price, or where there is none such that
/// using up all that later stages can bear counts like a share of the score.
std::vector<double> StagewiseSearch::state_weights(std::size_t stage, double unit) const {
  const StagePlan& plan = plans_[stage];
  std::vector<double> weights(plan.most_after.size(), 0.0);
  const auto priced = std::find_if(
      plan.planes.rbegin(), plan.planes.rend(), [this](const RestPlane& plane) { return plane.mix == haste_->mix; });
  for (std::size_t c = 0; c < weights.size(); ++c) {
    const bool smaller = plan.after[c] == Direction::smaller_is_better;
    if (haste_->share == 0.0 && priced != plan.planes.rend())
      weights[c] = priced->weight[c] / (std::fabs(unit) + 1e-6);
    else if (smaller && std::isfinite(plan.most_after[c]) && plan.most_after[c] > 0.0)
      weights[c] = haste_->share / plan.most_after[c];
  }
  return weights;
}

/// Keeps the best of many labels: by what they lead to at least, or by their scores and weighed states.
void StagewiseSearch::keep_best(std::size_t stage) {
  std::vector<Label>& labels = labels_[stage + 1];
  if (labels.size() <= haste_->labels) return;
  const RestVectors& rest = plans_[stage].vectors;
  double least = infinity;
  for (const Label& label : labels) least = std::min(least, haste_->mix.of(label.score));
  const std::vector<double> weights = state_weights(stage, least);
  const auto weighed = [&](const Label& label) {
    double sum = haste_->mix.of(label.score) / (std::fabs(least) + 1e-6);
    for (std::size_t c = 0; c < weights.size(); ++c) sum += weights[c] * label.state[c];
    return sum;
  };
  const auto least_total = [&](const Label& label) {
    const auto lower = [&](std::size_t c) { return label.state[c]; };
    return rest.least(haste_->mix, {label.score[0], criteria_.second(label.score)}, lower, useful_.back());
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < labels.size(); ++i)
    order.emplace_back(rest.add.empty() ? weighed(labels[i]) : least_total(labels[i]), i);
  std::sort(order.begin(), order.end());
  std::vector<Label> best;
  for (std::size_t i = 0; i < haste_->labels; ++i) best.push_back(std::move(labels[order[i].second]));
  labels = std::move(best);
}

/// Planes for those of many extensions that have the least bounds.
void StagewiseSearch::sharpen_planes(std::size_t stage, const std::vector<Chunk>& chunks) {
  constexpr std::size_t many = 5000, samples = 1000, rounds = 8;
  constexpr double worthwhile = 1e-3;
  std::size_t number = 0;
  for (const Chunk& chunk : chunks) number += chunk.labels.size() * chunk.set.candidates.size();
  if (number < many || haste_ || patience_ < endless || stage + 2 >= plans_.size() || plans_[stage].planes.empty())
    return;
  struct Sample {
    std::vector<double> score, state;
  };
  std::vector<Sample> sampled;
  const auto take = [&](auto, const auto& score, const auto& state, const auto&) { sampled.push_back({score, state}); };
  for (const Chunk& chunk : chunks)
    for (std::uint32_t label = 0; label < chunk.labels.size(); ++label)
      sums(stage, chunk, label, number / samples, take);
  const std::vector<double> most = highest_scores();
  for (std::size_t round = 0; round < rounds * criteria_.objectives && !sampled.empty(); ++round) {
    const std::size_t k = round % criteria_.objectives;
    const auto bound = [&](const Sample& sample) {
      return sample.score[k] + rest_after(plans_[stage], k, std::span<const double>(sample.state));
    };
    const auto worst = std::min_element(
        sampled.begin(), sampled.end(), [&](const Sample& a, const Sample& b) { return bound(a) < bound(b); });
    const double before = bound(*worst);
    const double rest = planes_->find_from(Mix::only(k), most[k] - worst->score[k], stage + 1, worst->state);
    if (!(worst->score[k] + rest > before + worthwhile * std::fabs(before)) && criteria_.objectives == 1) break;
    sampled.erase(worst);
    std::erase_if(sampled, [&](const Sample& sample) { return !may_matter(stage, sample.score, sample.state); });
  }
}

}  // namespace millwright::solver
