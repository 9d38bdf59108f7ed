// SPDX-License-Identifier: Apache-2.0
// pagmo's evolutionary algorithms on the physics, with a penalty for what is exceeded.
#include "benchmark/peers/peer.h"

#ifdef MILLWRIGHT_WITH_PAGMO
#include <cmath>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "benchmark/measure.h"
#include "benchmark/peers/rounded.h"

namespace stack::peers {
namespace {

struct Stacked {
  const RoundedModel* model = nullptr;

  [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    const auto answer = model->answer(x);
    constexpr double penalty = 1e4;
    return {answer.excess <= 0.0 ? answer.cost : penalty * (1.0 + std::min(answer.excess, 1e3))};
  }
  [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const std::size_t n = model == nullptr ? 1 : model->dimensions();
    return {pagmo::vector_double(n, 0.0), pagmo::vector_double(n, 1.0)};
  }
};

void evolve(const std::string& name, const Question& question, const Report& report) {
  const auto start = measure::Clock::now();
  const RoundedModel model(question.instance);
  constexpr unsigned individuals = 100, generations = 20, seed = 1;
  pagmo::algorithm algorithm =
      name == "sga" ? pagmo::algorithm(
                          pagmo::sga(generations, .90, 1., .05, 1., 2, "exponential", "polynomial", "tournament", seed))
                    : pagmo::algorithm(pagmo::de(generations, 0.8, 0.9, 2, 0.0, 0.0, seed));
  pagmo::population population(pagmo::problem(Stacked{&model}), individuals, seed);
  double best = std::numeric_limits<double>::infinity();
  while (measure::seconds_since(start) < question.seconds) {
    population = algorithm.evolve(population);
    const auto answer = model.answer(population.champion_x());
    if (answer.excess > 0.0 || !(answer.cost < best)) continue;
    best = answer.cost;
    report.found(answer.design);
  }
}

}  // namespace

Peer pagmo(const std::string& algorithm) {
  return {"pagmo " + algorithm + ", physics",
          "libpagmo-dev",
          true,
          [algorithm](const Question& question, const Report& report) { evolve(algorithm, question, report); }};
}

}  // namespace stack::peers
#else
namespace stack::peers {
Peer pagmo(const std::string& algorithm) { return {"pagmo " + algorithm + ", physics", "libpagmo-dev", false, {}}; }
}  // namespace stack::peers
#endif
