// SPDX-License-Identifier: Apache-2.0
//
// The labels before a stage in chunks of alike states, each with the question what designs can matter to it.
#include <algorithm>
#include <cmath>

#include "solver/candidate_groups.h"
#include "solver/stagewise_search.h"

namespace millwright::solver {
namespace {

constexpr std::size_t most_chunks = 8;  // of the labels before one stage
static_assert(most_chunks + 1 < most_groups, "rounding may make one more");
constexpr double chunk_width = 0.02;  // relative, of its states

}  // namespace

/// Labels with alike states together, by the component that differs most among those that decide about feasibility or
/// move scores.
std::vector<StagewiseSearch::Chunk> StagewiseSearch::make_chunks(std::size_t stage,
                                                                 const Comparison& comparison) const {
  const std::vector<Label>& labels = labels_[stage];
  const StateForm& form = forms_[stage];
  std::vector<Chunk> chunks;
  if (labels.empty()) return chunks;
  double widest = 0.0;
  std::size_t component = 0;
  for (std::size_t c = 0; c < form.influences.size(); ++c) {
    if (!form.influences[c] && !form.moves_scores[c]) continue;
    const auto [low, high] = std::minmax_element(
        labels.begin(), labels.end(), [c](const Label& a, const Label& b) { return a.state[c] < b.state[c]; });
    const double width = (high->state[c] - low->state[c]) / std::max(std::fabs(high->state[c]), 1e-9);
    if (width > widest) {
      widest = width;
      component = c;
    }
  }
  const auto state_of = [&](std::uint32_t label) {  // a problem may have none
    return component < labels[label].state.size() ? labels[label].state[component] : 0.0;
  };
  std::vector<std::uint32_t> order(labels.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(
      order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return state_of(a) < state_of(b); });
  const double low = state_of(order.front());
  const double high = state_of(order.back());
  const double parts = std::clamp(std::ceil(widest / chunk_width), 1.0, static_cast<double>(most_chunks));
  const double step = (high - low) / parts;
  double end = -infinity;
  for (const std::uint32_t index : order) {
    const double value = state_of(index);
    if (chunks.empty() || value > end) {
      chunks.emplace_back();
      end = value + step;
    }
    chunks.back().labels.push_back(index);
  }
  for (Chunk& chunk : chunks) ask(stage, comparison, chunk);
  return chunks;
}

/// What designs of the stage can matter to the labels of a chunk; and which of these are alike in what decides.
void StagewiseSearch::ask(std::size_t stage, const Comparison& comparison, Chunk& chunk) const {
  const std::vector<Label>& labels = labels_[stage];
  const StateForm& form = forms_[stage];
  std::vector<Pair> scores;
  std::map<std::vector<double>, std::uint32_t> groups;
  for (const std::uint32_t index : chunk.labels) {
    const Label& label = labels[index];
    scores.push_back({label.score[0], criteria_.second(label.score)});
    std::vector<double> deciding;
    for (std::size_t c = 0; c < label.state.size(); ++c) {
      if (form.influences[c]) deciding.push_back(label.state[c]);
      if (scores.size() == 1)
        chunk.question.states.emplace_back(label.state[c]);
      else
        chunk.question.states[c] = hull(chunk.question.states[c], label.state[c]);
    }
    chunk.group.push_back(groups.emplace(deciding, static_cast<std::uint32_t>(groups.size())).first->second);
  }
  chunk.question.plan = &plans_[stage];
  chunk.question.form = &form;
  chunk.question.comparison = &comparison;
  chunk.question.least = {infinity, infinity};
  for (const Pair& score : scores) {
    chunk.question.least.first = std::min(chunk.question.least.first, score.first);
    chunk.question.least.second = std::min(chunk.question.least.second, score.second);
  }
  chunk.question.corners = useful_.back();
  chunk.question.useful =
      difference_of_staircases(useful_[stage + 1], lower_staircase(std::move(scores)), staircase_points);
  ask_totals(stage, chunk);
  if (haste_) {
    chunk.question.node_limit = haste_->nodes;
    chunk.question.state_weight = state_weights(stage, haste_->mix.of(plans_[stage].least));
    if (criteria_.objectives > 1) chunk.question.mix = haste_->mix;
  }
  chunk.question.patience = patience_;
  chunk.question.stop = [this] { return control_.time_is_up(); };
}

/// What labels of the chunk and all stages after this one come to, as vectors. `priced(weight, label)`: of the state
/// that a label hands through.
template <class Priced>
void StagewiseSearch::ask_vectors(std::size_t stage, Chunk& chunk, Priced&& priced) const {
  constexpr std::size_t most_labels = 200;
  constexpr std::size_t most = 300;
  const RestVectors& rest = plans_[stage].vectors;
  if (rest.add.empty()) return;
  VectorSet labels(rest.add.dimensions());
  for (const std::uint32_t index : chunk.labels) {
    const Label& label = labels_[stage][index];
    std::vector<double> vector{label.score[0], criteria_.second(label.score)};
    for (const std::vector<double>& use : rest.use) vector.push_back(priced(use, label));
    labels.add(vector);
  }
  const std::vector<double>& own = plans_[stage].least;
  const auto matters = [&](std::span<const double> sum) {
    return below_staircase(useful_.back(), sum[0] + own[0], sum[1] + criteria_.second(own));
  };
  RestVectors& total = chunk.question.total_vectors;
  total.limit = rest.limit;
  total.use = rest.use;
  total.add = sum_of_vectors(lower_vectors(labels, most_labels), rest.add, most, matters);
  const std::vector<double> nothing(labels.dimensions(), infinity);
  if (total.add.empty()) total.add.add(nothing);
}

/// Planes and staircases over what a stage adds to a label of the chunk, at the label where each is least.
void StagewiseSearch::ask_totals(std::size_t stage, Chunk& chunk) const {
  const auto priced = [&](const std::vector<double>& weight, const Label& label) {
    const std::vector<double> nothing(label.state.size(), 0.0);
    double sum = 0.0;
    for (std::size_t h = 0; h < weight.size(); ++h)
      if (weight[h] != 0.0) sum += weight[h] * forms_[stage].change(h, nothing, label.state);
    return sum;
  };
  const auto least = [&](auto&& value_of) {
    double value = infinity;
    for (const std::uint32_t index : chunk.labels) value = std::min(value, value_of(labels_[stage][index]));
    return value - bound_slack * std::fabs(value);
  };
  const auto add_all = [&](const auto& from, auto& to) {
    for (const auto& each : from) {
      to.push_back(each);
      to.back().constant +=
          least([&](const Label& label) { return each.mix.of(label.score) + priced(each.weight, label); });
    }
  };
  ask_vectors(stage, chunk, priced);
  add_all(plans_[stage].planes, chunk.question.totals);
  add_all(plans_[stage].stairs, chunk.question.total_stairs);
  for (RestStairs& stairs : chunk.question.total_stairs) {
    stairs.limit =
        stairs.limit * (1.0 + bound_slack) - least([&](const Label& label) { return priced(stairs.use, label); });
  }
}

}  // namespace millwright::solver
