// SPDX-License-Identifier: Apache-2.0
//
// Of the ramps with which one design complies the one that takes least power, tried one by one: on a grid, then between
// the neighbours of its best point, and, where compliance ends between two points, up to there. For enumerations: it
// may miss a narrow window and the last watt, but what it finds complies and takes that power.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

namespace millwright {

/// Thrown when a ramp changes more of a state than the power (the loads of bolts that hold a motor).
struct MovesMore : std::logic_error {
  MovesMore() : std::logic_error("the ramp changes more than the power") {}
};

/// Where two states differ, if they do.
inline std::optional<std::size_t> changed_component(const std::vector<double>& a, const std::vector<double>& b) {
  std::optional<std::size_t> changed;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (changed) throw MovesMore();
    changed = i;
  }
  return changed;
}

struct RampTried {
  double worst = 0.0;  ///< utilisation
  double power = 0.0;
};

/// `ask(time)` tries a ramp. Nothing if none complies.
template <class Ask>
std::optional<double> least_power_ramp(double lower, double upper, Ask&& ask) {
  constexpr int grid = 12, bisections = 24, sections = 40;
  const double infinity = std::numeric_limits<double>::infinity();
  double best_time = lower, best_power = infinity;
  const auto tried = [&](double time) {
    const RampTried found = ask(std::clamp(time, lower, upper));
    if (found.worst <= 1.0 && found.power < best_power) {
      best_power = found.power;
      best_time = std::clamp(time, lower, upper);
    }
    return found.worst;
  };
  std::vector<double> times, worst;
  for (int i = 0; i <= grid; ++i) {
    times.push_back(lower * std::pow(upper / lower, i / double(grid)));
    worst.push_back(tried(times.back()));
  }
  if (best_power == infinity) {
    // About the point that is nearest to compliance by golden sections, if that could decide.
    const auto nearest = static_cast<std::size_t>(std::min_element(worst.begin(), worst.end()) - worst.begin());
    double a = times[nearest == 0 ? 0 : nearest - 1], b = times[std::min<std::size_t>(nearest + 1, grid)];
    double found = infinity;
    for (int i = 0; i < sections && worst[nearest] < 1.4 && found > 1.0; ++i) {
      const double c = b - 0.618 * (b - a), d = a + 0.618 * (b - a);
      const double uc = tried(c), ud = tried(d);
      found = std::min(uc, ud);
      (uc < ud ? b : a) = uc < ud ? d : c;
    }
    if (best_power == infinity) return std::nullopt;
    times.push_back(best_time);
    worst.push_back(found);
    std::sort(times.begin(), times.end());
    worst.clear();
    for (const double time : times) worst.push_back(tried(time));
  }
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if ((worst[i] <= 1.0) == (worst[i + 1] <= 1.0)) continue;
    double inside = worst[i] <= 1.0 ? times[i] : times[i + 1], outside = worst[i] <= 1.0 ? times[i + 1] : times[i];
    for (int k = 0; k < bisections; ++k) {
      const double middle = 0.5 * (inside + outside);
      (tried(middle) <= 1.0 ? inside : outside) = middle;
    }
  }
  const double step = std::pow(upper / lower, 1.0 / grid);
  const double a = best_time / step, b = best_time * step;
  for (int i = 1; i < grid; ++i) tried(a + (b - a) * i / grid);
  return best_time;
}

}  // namespace millwright
