// SPDX-License-Identifier: Apache-2.0
// NLopt's ISRES (an evolution strategy with constraints) on the physics: rows are real numbers, rounded, in tables
// sorted by price.
#include <algorithm>
#include <cmath>
#include <nlopt.hpp>
#include <numeric>

#include "benchmark/measure.h"
#include "benchmark/peers/peer.h"
#include "benchmark/peers/rounded.h"

namespace stack::peers {
namespace {

struct Asked {
  const RoundedModel* model;
  const Report* report;
  double best;
};

double cost(unsigned n, const double* x, double*, void* data) {
  auto& asked = *static_cast<Asked*>(data);
  const auto answer = asked.model->answer(std::span(x, n));
  if (answer.excess <= 0.0 && answer.cost < asked.best) {
    asked.best = answer.cost;
    asked.report->found(answer.design);
  }
  return answer.cost;
}

double excess(unsigned n, const double* x, double*, void* data) {
  return static_cast<Asked*>(data)->model->answer(std::span(x, n)).excess;
}

}  // namespace

Peer isres() {
  return {"NLopt ISRES, physics", "", true, [](const Question& question, const Report& report) {
            const RoundedModel model(question.instance);
            Asked asked{&model, &report, std::numeric_limits<double>::infinity()};
            const auto n = static_cast<unsigned>(model.dimensions());
            nlopt::opt optimiser(nlopt::GN_ISRES, n);
            optimiser.set_lower_bounds(0.0);
            optimiser.set_upper_bounds(1.0);
            optimiser.set_min_objective(cost, &asked);
            optimiser.add_inequality_constraint(excess, &asked, 0.0);
            optimiser.set_maxtime(question.seconds);
            std::vector<double> x(n, 0.5);
            double least = 0.0;
            optimiser.optimize(x, least);
          }};
}

}  // namespace stack::peers
