// SPDX-License-Identifier: Apache-2.0
//
// The answer to a variant of the stack family (benchmark/broken_models.h) by trying everything: the model once more in
// plain numbers, written from the description and not from the lambdas.
//
// Every left side is convex in the ramp's time on its own (sums and products of falling or rising log-convex
// functions), so the least worst utilisation over an interval of ramps is found by a ternary search; a resonance band
// splits the ramps into two such intervals. Designs nearer than 1e-9 to an edge of feasibility are counted in `margin`.
// A free diameter is the least that serves (cost and mass rise with it, and mass helps nowhere), by bisection at each
// of many ramps: real designs, so the search must do at least as well, and what it returns is checked by itself.
#pragma once

#include <optional>

#include "benchmark/broken_stack.h"

namespace stack::broken {

struct Total {
  double cost = 0.0, mass = 0.0, budget = 0.0;
};

/// One axis with its parts, in plain numbers.
struct Parts {
  double lead = 0.0, root = 0.0, efficiency = 0.0, screw_mass = 0.0, screw_inertia = 0.0;
  double holding = 0.0, corner = 0.0, rotor = 0.0;
  double ratio = 1.0, belt_inertia = 0.0, belt_torque = 1e9, belt_share = 1.0;
};

/// The worst utilisation at a ramp of `t`, moving `m`, without what does not depend on the ramp's side of a band.
inline double worst_at(const Axis& a, const Parts& p, double m, double t, double least_ratio) {
  const double pi = 3.14159265358979323846;
  const double v = a.stroke / (a.move_time - t), acceleration = v / t;
  const double force = a.force + m * 9.81 * (a.friction + a.gravity);
  const double screw_speed = v * 2.0 * pi / p.lead, screw_acceleration = acceleration * 2.0 * pi / p.lead;
  const double load = p.screw_inertia + m * std::pow(p.lead / (2.0 * pi), 2);
  const double torque = force * p.lead / (2.0 * pi * p.efficiency) + load * screw_acceleration;
  const double at_motor = torque / p.ratio / p.belt_share + (p.rotor + p.belt_inertia) * screw_acceleration * p.ratio;
  const double at_corner = p.ratio * screw_speed / p.corner;
  const double seen = load / (p.ratio * p.ratio) + p.belt_inertia;
  const double second_moment = pi * std::pow(p.root, 4) / 64.0;
  const double critical = 3.927 * 3.927 / (2.0 * pi * a.length * a.length) *
                          std::sqrt(206e9 * second_moment / (7850.0 * pi * p.root * p.root / 4.0));
  return std::max({at_motor * (1.0 + at_corner * at_corner) / (0.7 * p.holding),
                   seen / p.rotor / 10.0,
                   v / p.lead / (0.8 * critical),
                   (force + m * acceleration) / (0.5 * 2.0 * pi * pi * 206e9 * second_moment / (a.length * a.length)),
                   torque * a.length / (79e9 * 2.0 * second_moment) / a.largest_twist,
                   16.0 * torque / (pi * std::pow(p.root, 3)) / a.largest_shear,
                   torque / p.belt_torque,
                   least_ratio * p.rotor / seen});
}

class Enumeration {
 public:
  Enumeration(const Instance& instance, Variant variant, const Columns& belts, const Surroundings& given)
      : instance_(instance), variant_(variant), belts_(belts), given_(given), stack_(instance, variant, belts, given) {}

  std::vector<Total> designs;
  double margin = 1.0;  ///< how near any design came to an edge of feasibility

  void run() {
    const std::size_t choices = variant_ == Variant::shared_supply ? voltages.size()
                                : variant_ == Variant::same_motor  ? 1U + instance_.motors.rows()
                                                                   : 1U;
    for (shared_ = 0; shared_ < choices; ++shared_) descend(0, 0.0, {});
  }

  /// What a build is worth by this reckoning; nothing if it breaks something.
  std::optional<Total> judge(const millwright::solver::Build& build) {
    Total total;
    double above = 0.0;
    shared_ = build.shared.empty() ? 0 : build.shared[0];
    for (std::size_t i = 0; i < instance_.axes.size(); ++i) {
      const auto& choice = build.stages[i];
      const std::uint32_t belt = choice.rows.size() > 2 ? choice.rows[2] : 0;
      const double diameter = variant_ == Variant::free_diameter ? choice.variables[1] : 0.0;
      const Option option = option_of(i, choice.rows[0], choice.rows[1], belt, diameter);
      const double m = above + instance_.axes[i].carriage;
      for (std::size_t load = 0; load < loads(); ++load) {
        const double t = choice.variables[load];
        const Axis axis = axis_of(i, load);
        const double moved = m + payload(load);
        if (t < axis.shortest_ramp() || t > axis.longest_ramp()) return std::nullopt;
        if (worst_at(axis, option.parts, moved, t, least_ratio()) > 1.0 + 1e-9) return std::nullopt;
        if (variant_ == Variant::resonance) {
          const auto [low, high] = band(i, moved);
          const double turning = axis.stroke / (axis.move_time - t) / option.parts.lead;
          if (turning > low * (1.0 + 1e-9) && turning < high * (1.0 - 1e-9)) return std::nullopt;
        }
      }
      add(i, option, m, total);
      above = m + option.mass;
    }
    if (total.budget > given_.budget * (1.0 + 1e-9)) return std::nullopt;
    return total;
  }

 private:
  struct Option {
    Parts parts;
    double cost = 0.0, mass = 0.0, power = 0.0, lead_error = 0.0;
  };

  [[nodiscard]] std::size_t loads() const { return variant_ == Variant::several_loads ? load_cases.size() : 1; }
  [[nodiscard]] double payload(std::size_t load) const {
    return variant_ == Variant::several_loads ? load_cases[load].payload : 0.0;
  }
  [[nodiscard]] Axis axis_of(std::size_t i, std::size_t load) const {
    Axis axis = instance_.axes[i];
    if (variant_ != Variant::several_loads) return axis;
    axis.move_time *= load_cases[load].time;
    axis.force *= load_cases[load].force;
    return axis;
  }
  [[nodiscard]] double least_ratio() const { return variant_ == Variant::least_inertia ? least_inertia_ratio : 0.0; }

  /// Turns per second between which the screw of axis i must not stay.
  [[nodiscard]] std::pair<double, double> band(std::size_t i, double m) const {
    const double frequency = std::sqrt(given_.feet[i] / m) / (2.0 * 3.14159265358979323846);
    return {frequency / resonance_band, frequency * resonance_band};
  }

  [[nodiscard]] Option option_of(
      std::size_t i, std::uint32_t screw, std::uint32_t motor, std::uint32_t belt, double diameter_of_screw) const {
    const double* s = instance_.screws.row(screw);
    const bool all_same = variant_ == Variant::same_motor && shared_ > 0;
    const double* q = instance_.motors.row(all_same ? static_cast<std::uint32_t>(shared_ - 1) : motor);
    const double length = instance_.axes[i].length;
    Option option;
    Parts& p = option.parts;
    double width = s[0], core = s[2];
    p.screw_mass = s[4] * length;
    option.cost = s[5] + s[6] * length;
    if (variant_ == Variant::free_diameter) {
      const double scale = diameter_of_screw / s[0];
      width = s[0] * scale;
      core = s[2] * scale;
      p.screw_mass *= scale * scale;
      option.cost = s[5] + s[6] * length * scale * scale;  // by weight
    }
    p.lead = s[1];
    p.root = core;
    p.efficiency = s[3];
    p.screw_inertia = p.screw_mass * std::pow((width + core) / 4.0, 2) / 2.0;
    p.holding = q[0];
    p.corner = q[1];
    p.rotor = q[2];
    option.mass = p.screw_mass + q[3];
    if (variant_ == Variant::error_budget) {
      option.cost = stack_.screws(i).row(screw)[cut_price];
      option.lead_error = stack_.screws(i).row(screw)[cut_error];
    }
    option.cost += all_same ? 0.8 * q[4] : q[4];
    if (variant_ == Variant::shared_supply) {
      p.corner *= voltages[shared_].factor;
      option.power = 0.3 * q[0] * q[1] * voltages[shared_].factor;
      if (i == 0) option.cost += voltages[shared_].price;
    }
    if (variant_ == Variant::belt) {
      const double* b = belts_.row(belt);
      p.ratio = b[0];
      p.belt_inertia = b[1];
      p.belt_torque = b[2];
      p.belt_share = 0.96;
      option.mass += b[3];
      option.cost += b[4];
    }
    return option;
  }

  void add(std::size_t i, const Option& option, double m, Total& total) const {
    total.cost += option.cost;
    total.mass += option.mass;
    if (variant_ == Variant::shared_supply) total.budget += option.power;
    if (variant_ != Variant::error_budget) return;
    const double pi = 3.14159265358979323846;
    const Axis& a = instance_.axes[i];
    const Parts& p = option.parts;
    const double force = a.force + m * 9.81 * (a.friction + a.gravity);
    const double torque = force * p.lead / (2.0 * pi * p.efficiency);
    const double wound = torque * a.length / (79e9 * pi * std::pow(p.root, 4) / 32.0);
    total.budget +=
        option.lead_error + force * a.length / (206e9 * pi / 4.0 * p.root * p.root) + wound * p.lead / (2.0 * pi);
  }

  void note(double utilisation) { margin = std::min(margin, std::fabs(utilisation - 1.0)); }

  /// Least worst utilisation over ramps from low to high.
  double least_worst(const Axis& axis, const Parts& parts, double m, double low, double high) {
    const auto worst = [&](double t) { return worst_at(axis, parts, m, t, least_ratio()); };
    double least = std::min(worst(low), worst(high));
    for (int n = 0; n < 90 && least > 1.0 - 1e-6; ++n) {
      const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
      const double at_a = worst(a), at_b = worst(b);
      least = std::min({least, at_a, at_b});
      (at_a < at_b ? high : low) = at_a < at_b ? b : a;
    }
    note(least);
    return least;
  }

  bool feasible(std::size_t i, const Parts& parts, double m) {
    for (std::size_t load = 0; load < loads(); ++load) {
      const Axis axis = axis_of(i, load);
      const double moved = m + payload(load);
      const double low = axis.shortest_ramp(), high = axis.longest_ramp();
      if (variant_ != Variant::resonance) {
        if (least_worst(axis, parts, moved, low, high) > 1.0) return false;
        continue;
      }
      // The longer the ramp, the faster between: up to `slow` below the band, from `fast` on above it.
      const auto [least, most] = band(i, moved);
      const double slow = axis.move_time - axis.stroke / (least * parts.lead);
      const double fast = axis.move_time - axis.stroke / (most * parts.lead);
      margin = std::min({margin, std::fabs(slow - low), std::fabs(fast - high)});
      const bool below = slow >= low && least_worst(axis, parts, moved, low, std::min(slow, high)) <= 1.0;
      const bool above = fast <= high && least_worst(axis, parts, moved, std::max(fast, low), high) <= 1.0;
      if (!below && !above) return false;
    }
    return true;
  }

  /// The least diameter that serves at some of many ramps.
  std::optional<double> least_diameter_of(std::size_t i, std::uint32_t screw, std::uint32_t motor, double m) {
    const Axis& axis = instance_.axes[i];
    std::optional<double> least;
    constexpr int ramps = 400;
    for (int n = 0; n <= ramps; ++n) {
      const double share = static_cast<double>(n) / ramps;
      const double t = axis.shortest_ramp() + (axis.longest_ramp() - axis.shortest_ramp()) * share * share;
      const auto worst_of_screw = [&](double d) {
        Parts parts = option_of(i, screw, motor, 0, d).parts;
        parts.holding = 1e9;  // the motor never fails, but for what a thicker screw helps
        parts.rotor = 1.0;
        return worst_at(axis, parts, m, t, 0.0);
      };
      double low = least_diameter, high = least ? *least : largest_diameter;
      if (worst_of_screw(high) > 1.0) continue;
      if (worst_of_screw(low) <= 1.0) high = low;
      for (int step = 0; step < 50 && high > low; ++step) {
        const double middle = 0.5 * (low + high);
        (worst_of_screw(middle) <= 1.0 ? high : low) = middle;
      }
      if (worst_at(axis, option_of(i, screw, motor, 0, high).parts, m, t, 0.0) <= 1.0) least = high;
    }
    return least;
  }

  void descend(std::size_t i, double above, const Total& so_far) {
    if (i == instance_.axes.size()) {
      if (std::isfinite(given_.budget)) note(so_far.budget / given_.budget);
      if (so_far.budget <= given_.budget) designs.push_back(so_far);
      return;
    }
    const double m = above + instance_.axes[i].carriage;
    const std::uint32_t motors = variant_ == Variant::same_motor && shared_ > 0 ? 1 : instance_.motors.rows();
    const std::uint32_t belts = variant_ == Variant::belt ? belts_.rows() : 1;
    for (std::uint32_t screw = 0; screw < instance_.screws.rows(); ++screw)
      for (std::uint32_t motor = 0; motor < motors; ++motor)
        for (std::uint32_t belt = 0; belt < belts; ++belt) {
          double wide = 0.0;
          if (variant_ == Variant::free_diameter) {
            const auto found = least_diameter_of(i, screw, motor, m);
            if (!found) continue;
            wide = *found;
          }
          const Option option = option_of(i, screw, motor, belt, wide);
          if (variant_ != Variant::free_diameter && !feasible(i, option.parts, m)) continue;
          Total total = so_far;
          add(i, option, m, total);
          descend(i + 1, m + option.mass, total);
        }
  }

  const Instance& instance_;
  Variant variant_;
  const Columns& belts_;
  Surroundings given_;
  Stack stack_;
  std::size_t shared_ = 0;
};

}  // namespace stack::broken
