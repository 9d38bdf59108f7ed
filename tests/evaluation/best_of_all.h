// SPDX-License-Identifier: Apache-2.0
//
// What the search found, against all builds: the cheapest (lightest) one, and every point of the front of cost and
// mass, and the next best ones. `sound` is called with each design and checks it by itself: that its lines add up, for
// example.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "catch.h"
#include "evaluation/exhaustive.h"
#include "evaluation/synthesis.h"

namespace millwright {

/// The one design found is the cheapest of all builds, to the stated tolerance and proved.
template <class Sound>
void require_cheapest_of(const Exhaustive& all, const evaluation::Synthesis& cost, const Sound& sound) {
  REQUIRE(cost.designs.size() == 1);
  CHECK(cost.status == solver::Status::optimal);
  CHECK(cost.designs[0].cost == Approx(all.least(&BuildValue::cost)).epsilon(2e-6));
  CHECK(cost.lower_bound <= cost.designs[0].cost * (1.0 + 1e-9));
  sound(cost.designs[0]);
}

/// The one design found is the lightest of all builds.
template <class Sound>
void require_lightest_of(const Exhaustive& all, const evaluation::Synthesis& mass, const Sound& sound) {
  REQUIRE(mass.designs.size() == 1);
  CHECK(mass.status == solver::Status::optimal);
  CHECK(mass.designs[0].mass == Approx(all.least(&BuildValue::mass)).epsilon(2e-6));
  CHECK(mass.lower_bound <= mass.designs[0].mass * (1.0 + 1e-9));
  sound(mass.designs[0]);
}

/// The designs found are the front of all builds, point by point.
template <class Sound>
void require_front_of(const Exhaustive& all, const evaluation::Synthesis& front, const Sound& sound) {
  const std::vector<BuildValue> expected = all.front();
  REQUIRE(front.designs.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(front.designs[i].cost == Approx(expected[i].cost).epsilon(1e-9));
    CHECK(front.designs[i].mass == Approx(expected[i].mass).epsilon(1e-9));
    sound(front.designs[i]);
  }
}

/// Both of them.
template <class Sound>
void require_best_of(const Exhaustive& all,
                     const evaluation::Synthesis& cost,
                     const evaluation::Synthesis& front,
                     const Sound& sound) {
  require_cheapest_of(all, cost, sound);
  require_front_of(all, front, sound);
}

/// The so many cheapest builds of a problem are the first of all builds; of equal cost the lighter one comes first.
template <class Sound>
void require_next_best_of(const Exhaustive& all,
                          const machine::Problem& problem,
                          const catalogue::Catalogue& offered,
                          std::size_t builds,
                          const Sound& sound) {
  evaluation::ModelOptions every;
  every.every_candidate = true;
  every.builds = builds;
  evaluation::SearchOptions options;
  options.builds = builds;
  const evaluation::Synthesis found =
      evaluation::synthesise(evaluation::MachineModel(problem, offered, {}, every), options);
  std::vector<BuildValue> expected = all.builds;
  std::sort(expected.begin(), expected.end(), [](const BuildValue& a, const BuildValue& b) {
    const double cost_a = std::round(1e8 * a.cost), cost_b = std::round(1e8 * b.cost);
    return cost_a != cost_b ? cost_a < cost_b : a.mass < b.mass;
  });
  REQUIRE(found.designs.size() == std::min(builds, expected.size()));
  CHECK(found.proved == found.designs.size());
  for (std::size_t i = 0; i < found.designs.size(); ++i) {
    CAPTURE(i);
    CHECK(found.designs[i].cost == Approx(expected[i].cost).epsilon(1e-9));
    CHECK(found.designs[i].mass == Approx(expected[i].mass).epsilon(1e-9));
    sound(found.designs[i]);
  }
}

/// Found once more (by more threads, for example), design by design at the same cost to the last digit.
inline void require_same_costs(const evaluation::Synthesis& found, const evaluation::Synthesis& again) {
  REQUIRE(again.designs.size() == found.designs.size());
  for (std::size_t i = 0; i < again.designs.size(); ++i) CHECK(again.designs[i].cost == found.designs[i].cost);
}

}  // namespace millwright
