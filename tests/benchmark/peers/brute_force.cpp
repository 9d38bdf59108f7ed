// SPDX-License-Identifier: Apache-2.0
// Every pair of every axis, depth first, the cheapest first: a branch ends where it costs more than the best design.
#include <algorithm>
#include <numeric>

#include "benchmark/peers/peer.h"

namespace stack::peers {
namespace {

class Search {
 public:
  Search(const Instance& instance, const Report& report) : instance_(instance), report_(report) {
    for (const Axis& axis : instance.axes) {
      std::vector<Pair> pairs;
      for (std::uint32_t i = 0; i < instance.screws.rows(); ++i)
        for (std::uint32_t j = 0; j < instance.motors.rows(); ++j) {
          const double* s = instance.screws.row(i);
          const double* q = instance.motors.row(j);
          pairs.push_back({i,
                           j,
                           s[price] + s[price_per_length] * axis.length + q[motor_price],
                           s[mass_per_length] * axis.length + q[motor_mass],
                           0.0});
        }
      std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.cost < b.cost; });
      pairs_.push_back(std::move(pairs));
    }
    rest_.assign(pairs_.size() + 1, 0.0);
    for (std::size_t i = pairs_.size(); i-- > 0;) rest_[i] = rest_[i + 1] + pairs_[i].front().cost;
    design_.resize(pairs_.size());
  }

  void descend(std::size_t i, double above, double cost) {
    if (i == pairs_.size()) {
      best_ = cost;
      report_.found(design_);
      return;
    }
    const Axis& axis = instance_.axes[i];
    const double moved = above + axis.carriage;
    for (const Pair& pair : pairs_[i]) {
      if (cost + pair.cost + rest_[i + 1] >= best_) return;
      const auto [ramp, capacity] = best_ramp(axis, instance_.screws.row(pair.screw), instance_.motors.row(pair.motor));
      if (capacity < moved) continue;
      design_[i] = {pair.screw, pair.motor, ramp};
      descend(i + 1, moved + pair.mass, cost + pair.cost);
    }
  }

 private:
  const Instance& instance_;
  const Report& report_;
  std::vector<std::vector<Pair>> pairs_;
  std::vector<double> rest_;
  Design design_;
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Peer brute_force() {
  return {"brute force", "", true, [](const Question& question, const Report& report) {
            Search(question.instance, report).descend(0, 0.0, 0.0);
            report.claim();
          }};
}

}  // namespace stack::peers
