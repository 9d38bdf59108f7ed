// SPDX-License-Identifier: Apache-2.0
//
// The inside of rest_plane.h: prices of allowances, the planes (rest_plane.cpp), staircases (rest_stairs.cpp) and
// vectors (rest_vector_sums.cpp) that follow from them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "solver/region_pool.h"
#include "solver/rest_plane.h"

namespace millwright::solver {

/// Relative: a state is the same sum in another order in the end.
inline constexpr double sum_slack = 1e-10;

/// A component of the state that arrives at a stage and matters no further.
struct Allowance {
  std::size_t component = 0;
  double limit = 0.0;                 ///< no later stage has a feasible design from more on
  std::vector<double> from = {};      ///< amounts from which on the stage's least is found, ascending; empty: one pool
  std::vector<RegionPool> pool = {};  ///< [step]

  /// The amount where a step ends.
  [[nodiscard]] double up_to(std::size_t step) const { return step + 1 < from.size() ? from[step + 1] : limit; }
};

/// One stage as the prices see it.
struct PricedStage {
  const StagePlan* plan = nullptr;
  const StateForm* form = nullptr;
  std::vector<Allowance> ends;  ///< here
  std::optional<RegionPool> pool;
};

class RestPlanes::Prices {
 public:
  Prices(const Problem& problem, std::vector<StagePlan>& plans, std::span<const StateForm> forms, Desk& desk);

  double find(const Mix& mix, double known);
  double find_from(const Mix& mix, double known, std::size_t stage, std::span<const double> state);
  bool restrict_to(const std::vector<Pair>& corners);
  void tighten_limits();
  bool find_vectors(const std::vector<Pair>& corners);
  void keep_regions();

 private:
  class Totals;
  /// A bound under way from the base to the tool: constant + weight * state.
  struct Plane {
    double constant = 0.0;
    double room = 0.0;  ///< magnitudes that were added up
    std::vector<double> weight;
  };
  /// What a stage adds at least, by what it adds to the state.
  struct Addition {
    double value = 0.0;
    double priced = 0.0;        ///< the same with what has been inherited
    double room = 0.0;          ///< magnitudes that were added up
    std::vector<double> state;  ///< of the design where the value is least
  };
  /// A plane, and the bound at the tool without what each stage adds to it.
  struct Kept {
    Mix mix;
    std::vector<double> without;              ///< [stage]
    std::vector<std::vector<double>> weight;  ///< [stage]
  };
  /// An allowance that is kept as it is while the others have prices.
  struct KeptStairs {
    Mix mix;
    double constant = 0.0;                    ///< of all stages, with the state at the tool
    double limit = 0.0;                       ///< for what the stages take of the allowance
    std::size_t end_stage = 0;                ///< where it ends
    std::vector<std::vector<double>> weight;  ///< [stage]: of what it adds to the state
    std::vector<std::vector<double>> use;     ///< [stage]: of the allowance, by the state before it
    std::vector<std::vector<Pair>> without;   ///< [stage]: what all others add at least, by what they take
  };

  /// An allowance that vectors tell of.
  struct Shared {
    const Allowance* end = nullptr;
    std::vector<std::vector<double>> use;  ///< [stage]: of it, by the state before the stage
  };

  void find_ends(std::size_t stage);
  void find_steps(std::size_t stage, Allowance& end);
  double climb(double known, const std::function<void(double bound)>& risen);
  double evaluate(std::span<const double> price, std::span<double> slope);
  bool pass(std::size_t stage, std::span<const double> price, Plane& plane);
  Addition least_addition(RegionPool& pool, const StateForm& form, std::span<const double> weight);
  [[nodiscard]] std::vector<double> after(std::size_t stage, const std::vector<double>& state) const;
  [[nodiscard]] RestPlane rest_plane(const Plane& plane) const;
  void keep(double bound);

  void find_stairs();
  void keep_stairs(KeptStairs kept, const Allowance& end);
  [[nodiscard]] std::optional<std::vector<std::vector<double>>> find_use(std::size_t end_stage,
                                                                         const Allowance& end) const;
  std::vector<Pair> points(std::size_t stage, const Allowance& end, const KeptStairs& kept);
  [[nodiscard]] double least_total(const KeptStairs& stairs, std::size_t stage, const Bounds& bounds) const;

  void find_shared();
  bool refine_vectors(std::size_t stage, Totals& totals);
  [[nodiscard]] std::vector<double> vector_of(std::size_t stage, const RegionPool& pool, const Bounds& bounds) const;
  [[nodiscard]] VectorSet vectors_of(std::size_t stage) const;
  [[nodiscard]] std::vector<double> limits() const;
  [[nodiscard]] bool vectors_reach(std::size_t stage, const Bounds& bounds, const std::vector<Pair>& corners) const;

  const Problem& problem_;
  std::vector<StagePlan>& plans_;
  std::vector<StateForm> forms_;  ///< as they were at first: what has been found since is about them
  Desk& desk_;
  std::vector<PricedStage> stages_;
  std::size_t allowances_ = 0;
  std::vector<Kept> kept_;
  std::vector<KeptStairs> kept_stairs_;
  std::vector<double> best_price_;  ///< of the last climb
  std::vector<bool> has_had_price_;
  std::vector<Shared> shared_;
  std::vector<RestVectors> without_vectors_;  ///< [stage]: of all others; `use` is what the stage itself takes
  // Of the evaluation under way:
  Mix mix_;
  std::size_t first_ = 0;
  std::vector<double> state_;                ///< before the first of these stages
  std::vector<Plane> planes_;                ///< [stage]: after it
  std::vector<double> least_;                ///< [stage]: score and priced state handed on, where least
  std::vector<double> paid_;                 ///< [stage]: for allowances that end there
  std::vector<std::vector<double>> chosen_;  ///< [stage]: what the design of the least value adds to the state
  std::vector<std::vector<double>> used_;    ///< [stage][end]
  std::vector<std::vector<double>> unit_;    ///< [stage][end]: price of a unit
  Plane before_;                             ///< the first of these stages
};

/// What a design of these bounds takes of an allowance, with what it inherits.
inline double used(const Bounds& bounds, std::span<const double> use) {
  double sum = 0.0;
  for (std::size_t c = 0; c < use.size(); ++c)
    if (use[c] > 0.0) sum += use[c] * bounds.handed_on[c].lower;
  return sum;
}

/// What a handed-on component takes over from inherited states.
Interval flow(const StateForm& form, std::size_t component, std::span<const Interval> states);

}  // namespace millwright::solver
