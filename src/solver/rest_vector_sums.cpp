// SPDX-License-Identifier: Apache-2.0
//
// The vectors of rest_vectors.h: what the regions of each stage add to two scores and take of the allowances that have
// had a price, and the sums of it over the stages. Only what may lead to a total that matters is kept, so that the sets
// stay small where little of the front is looked for.
#include <algorithm>
#include <cmath>

#include "solver/rest_prices.h"

namespace millwright::solver {
namespace {

constexpr std::size_t most_own = 200;       // vectors of a stage
constexpr std::size_t most_summed = 150;    // of many stages
constexpr std::size_t most_refined = 2000;  // regions of a stage
constexpr std::size_t most_allowances = 6;  // with more there are too many vectors that tell too little
constexpr std::size_t no_stage = static_cast<std::size_t>(-1);

}  // namespace

/// What is asked of sums of all stages, and what each stage adds at least.
class RestPlanes::Prices::Totals {
 public:
  Totals(std::vector<double> limit, const std::vector<Pair>& corners, std::size_t stages)
      : limit_(std::move(limit)), corners_(corners), least_(stages, std::vector<double>(dimensions(), 0.0)) {}

  [[nodiscard]] std::size_t dimensions() const { return 2 + limit_.size(); }
  void set_least(std::size_t stage, std::vector<double> least) { least_[stage] = std::move(least); }
  /// Of the stages from one up to another, less one of them.
  [[nodiscard]] std::vector<double> least_of(std::size_t from, std::size_t to, std::size_t without = no_stage) const {
    std::vector<double> sum(dimensions(), 0.0);
    for (std::size_t i = from; i < to; ++i)
      for (std::size_t d = 0; i != without && d < sum.size(); ++d) sum[d] += least_[i][d];
    return sum;
  }
  /// Whether a sum with what others add is within the limits and below some corner.
  [[nodiscard]] bool matters(const std::vector<double>& others, std::span<const double> sum) const {
    for (std::size_t a = 0; a < limit_.size(); ++a)
      if (others[2 + a] + sum[2 + a] > limit_[a]) return false;
    return below_staircase(corners_, others[0] + sum[0], others[1] + sum[1]);
  }
  /// What coordinates are weighed by against each other.
  [[nodiscard]] std::vector<double> weights() const {
    constexpr double little = 1e-9;
    std::vector<double> weight = least_of(0, least_.size());
    for (std::size_t d = 0; d < weight.size(); ++d)
      weight[d] = 1.0 / (std::fabs(d < 2 ? weight[d] : limit_[d - 2]) + little * (d < 2 ? 1.0 : 0.0));
    return weight;
  }

 private:
  std::vector<double> limit_;  ///< [allowance]
  const std::vector<Pair>& corners_;
  std::vector<std::vector<double>> least_;  ///< [stage]
};

/// Allowances that have had a price in some evaluation.
void RestPlanes::Prices::find_shared() {
  shared_.clear();
  std::size_t number = 0;
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    for (const Allowance& end : stages_[i].ends) {
      if (!has_had_price_[number++] || shared_.size() == most_allowances) continue;
      if (auto use = find_use(i, end)) shared_.push_back({&end, std::move(*use)});
    }
  }
}

/// What a design of these bounds adds.
std::vector<double> RestPlanes::Prices::vector_of(std::size_t stage,
                                                  const RegionPool& pool,
                                                  const Bounds& bounds) const {
  std::vector<double> vector{bounds.score[0], plans_[stage].criteria->second(bounds.score)};
  for (const Shared& shared : shared_) {
    const std::vector<double>& use = shared.use[stage + 1];
    double taken = used(bounds, use);
    for (std::size_t h = 0; h < use.size(); ++h)
      if (use[h] != 0.0) taken -= use[h] * flow(*stages_[stage].form, h, pool.inherited()).upper;
    vector.push_back(taken);
  }
  return vector;
}

/// What all regions of a stage add.
VectorSet RestPlanes::Prices::vectors_of(std::size_t stage) const {
  const PricedStage& own = stages_[stage];
  VectorSet vectors(2 + shared_.size());
  const auto add_all = [&](const RegionPool& pool, const Allowance* steps, double given) {
    pool.for_each([&](const Bounds& bounds) {
      std::vector<double> vector = vector_of(stage, pool, bounds);
      for (std::size_t a = 0; a < shared_.size(); ++a)  // what it is not enough for counts as taken
        if (shared_[a].end == steps) vector[2 + a] += steps->limit - given;
      vectors.add(vector);
    });
  };
  if (own.pool) add_all(*own.pool, nullptr, 0.0);
  for (const Allowance& end : own.ends)
    for (std::size_t k = 0; k < end.pool.size(); ++k) add_all(end.pool[k], &end, end.up_to(k));
  return vectors;
}

/// The limits of all stages together, at the tool.
std::vector<double> RestPlanes::Prices::limits() const {
  std::vector<double> limits;
  for (const Shared& shared : shared_) {
    double left = shared.end->limit * (1.0 + sum_slack);
    for (std::size_t c = 0; c < problem_.first_state.size(); ++c)
      if (shared.use[0][c] != 0.0) left -= shared.use[0][c] * problem_.first_state[c];
    limits.push_back(left);
  }
  return limits;
}

/// Refines regions where what they add may matter. False when nothing does.
bool RestPlanes::Prices::refine_vectors(std::size_t stage, Totals& totals) {
  if (!stages_[stage].pool) return true;
  RegionPool& pool = *stages_[stage].pool;
  const std::vector<double> others = totals.least_of(0, stages_.size(), stage);
  const auto matters = [&](const Bounds& bounds) { return totals.matters(others, vector_of(stage, pool, bounds)); };
  const auto key = [&](const Bounds& bounds) { return vector_of(stage, pool, bounds); };
  if (!pool.refine_front(key, totals.weights(), matters, most_refined, desk_)) return false;
  totals.set_least(stage, vectors_of(stage).least());
  return true;
}

bool RestPlanes::Prices::find_vectors(const std::vector<Pair>& corners) {
  const std::size_t stages = stages_.size();
  for (StagePlan& plan : plans_) plan.vectors = RestVectors{};
  without_vectors_.clear();
  find_shared();
  if (shared_.empty()) return true;
  Totals totals(limits(), corners, stages);
  for (std::size_t i = 0; i < stages; ++i) {
    std::vector<double> least = vectors_of(i).least();
    // Infinity: nothing is feasible, and the search will find out. Minus infinity: nothing is known.
    if (!std::all_of(least.begin(), least.end(), [](double each) { return std::isfinite(each); })) return true;
    totals.set_least(i, std::move(least));
  }
  for (std::size_t i = 0; i < stages; ++i)
    if (!refine_vectors(i, totals)) return false;

  const std::size_t n = totals.dimensions();
  std::vector<VectorSet> own, before(stages + 1, VectorSet(n)), after(stages + 1, VectorSet(n));
  before.front().add(std::vector<double>(n, 0.0));
  after.back().add(std::vector<double>(n, 0.0));
  const auto sum = [&](const VectorSet& a, const VectorSet& b, const std::vector<double>& others) {
    return sum_of_vectors(a, b, most_summed, [&](std::span<const double> s) { return totals.matters(others, s); });
  };
  for (std::size_t i = 0; i < stages; ++i) {
    const std::vector<double> others = totals.least_of(0, stages, i);
    const VectorSet all = vectors_of(i);
    VectorSet useful(n);
    for (std::size_t v = 0; v < all.size(); ++v)
      if (totals.matters(others, all[v])) useful.add(all[v]);
    own.push_back(lower_vectors(useful, most_own));
    before[i + 1] = sum(before[i], own[i], totals.least_of(i + 1, stages));
    if (before[i + 1].empty()) return false;
  }
  for (std::size_t i = stages; i-- > 0;) {
    after[i] = sum(own[i], after[i + 1], totals.least_of(0, i));
    if (after[i].empty()) return false;
  }
  for (std::size_t i = 0; i < stages; ++i) {
    RestVectors& without = without_vectors_.emplace_back();
    without.limit = limits();
    without.add = sum(before[i], after[i + 1], totals.least_of(i, i + 1));
    RestVectors& vectors = plans_[i].vectors;
    for (const Shared& shared : shared_) {
      without.use.emplace_back(shared_.size(), 0.0)[without.use.size() - 1] = 1.0;
      vectors.limit.push_back(shared.end->limit * (1.0 + sum_slack));
      vectors.use.push_back(shared.use[i + 1]);
    }
    vectors.add = std::move(after[i + 1]);
  }
  return true;
}

void RestPlanes::Prices::keep_regions() {
  for (std::size_t i = 0; i < stages_.size(); ++i)
    if (stages_[i].pool) plans_[i].open_regions = stages_[i].pool->regions();
}

/// Whether designs of the other stages go with one of these bounds.
bool RestPlanes::Prices::vectors_reach(std::size_t stage,
                                       const Bounds& bounds,
                                       const std::vector<Pair>& corners) const {
  if (without_vectors_.empty()) return true;
  const std::vector<double> own = vector_of(stage, *stages_[stage].pool, bounds);
  return without_vectors_[stage].reach(
      {own[0], own[1]}, [&](std::size_t a) { return own[2 + a]; }, corners);
}

}  // namespace millwright::solver
