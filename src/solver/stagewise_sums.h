// SPDX-License-Identifier: Apache-2.0
//
// Labels before a stage with the designs that can matter to them, as sums; for the parts of stagewise_search.h.
#pragma once

#include "solver/stagewise_search.h"

namespace millwright::solver {

/// A label of a chunk with every candidate, as sums of scores and of the least and the most that is handed on; told of
/// those that may matter. One in `stride` of all extensions of the chunk, counted label by label.
template <class Found>
void StagewiseSearch::sums(
    std::size_t stage, const Chunk& chunk, std::uint32_t i, std::size_t stride, Found&& found) const {
  const std::vector<Pair>& useful = useful_[stage + 1];
  const StateForm& form = forms_[stage];
  const std::size_t candidates = chunk.set.candidates.size();
  const Label& label = labels_[stage][chunk.labels[i]];
  std::vector<double> change(label.state.size());
  for (std::size_t c = 0; c < change.size(); ++c) change[c] = form.change(c, chunk.set.reference, label.state);
  std::vector<double> score(criteria_.size());
  std::vector<double> least(label.state.size());
  std::vector<double> most(form.all_exact() ? 0 : label.state.size());
  for (std::size_t j = (stride - i * candidates % stride) % stride; j < candidates; j += stride) {
    const Candidate& candidate = chunk.set.candidates[j];
    for (std::size_t k = 0; k < score.size(); ++k) score[k] = label.score[k] + candidate.score[k];
    if (!below_staircase(useful, score[0], criteria_.second(score))) continue;
    for (std::size_t c = 0; c < least.size(); ++c) least[c] = candidate.least[c] + change[c];
    if (!may_matter(stage, score, least)) continue;
    for (std::size_t c = 0; c < most.size(); ++c) most[c] = candidate.most[c] + change[c];
    found(static_cast<std::uint32_t>(j), score, least, most.empty() ? least : most);
  }
}

}  // namespace millwright::solver
