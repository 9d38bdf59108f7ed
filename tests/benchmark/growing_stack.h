// SPDX-License-Identifier: Apache-2.0
//
// Stacks whose axes have as many continuous dimensions as one likes: a ramp for each of several moves, which only
// decide whether a design is one, and maybe a screw of free diameter, which costs and weighs.
#pragma once

#include "benchmark/broken_models.h"

namespace growth {

using stack::Columns;

struct Model {
  stack::Axis axis;
  std::size_t ramps = 1;  ///< 0: one move, its ramp fixed half way
  bool free_diameter = false;

  /// Later moves carry more and have more time.
  [[nodiscard]] static stack::broken::LoadCase load(std::size_t move) {
    const auto n = static_cast<double>(move);
    return {0.25 * n, 1.0 + 0.25 * n, 1.0 + 0.1 * n};
  }
  [[nodiscard]] std::size_t moves() const { return std::max<std::size_t>(ramps, 1); }
  [[nodiscard]] std::vector<millwright::solver::Variable> variables() const {
    std::vector<millwright::solver::Variable> all;
    for (std::size_t i = 0; i < ramps; ++i) {
      const stack::Axis loaded = stack::broken::under(load(i), axis);
      all.push_back({"acceleration_time", loaded.shortest_ramp(), loaded.longest_ramp()});
    }
    if (free_diameter) all.push_back({"diameter", stack::broken::least_diameter, stack::broken::largest_diameter});
    return all;
  }

  template <class Input, class Answer>
  void operator()(const Input& in, Answer& out) const {
    using T = std::decay_t<decltype(in.state(0))>;
    using millwright::scalar::square;
    using namespace stack;
    const broken::Motor<T> motor = broken::motor_of<T>(in);
    const T mass = in.state(0) + axis.carriage;
    const T step = in.row(screw_slot, broken::blank_lead), core = in.row(screw_slot, broken::blank_core);
    const T per_square = in.row(screw_slot, broken::blank_mass);
    // The catalogue's own diameter is that of its mass per length.
    const T wide = free_diameter ? in.variable(ramps) : in.row(screw_slot, broken::blank_width);
    const T screw = per_square * square(wide) * axis.length;
    for (std::size_t i = 0; i < moves(); ++i) {
      const Axis loaded = broken::under(load(i), axis);
      const T ramp = ramps == 0 ? T(0.5 * (axis.shortest_ramp() + axis.longest_ramp())) : in.variable(i);
      const Motion<T> motion = motion_of<T>(loaded,
                                            step,
                                            in.row(screw_slot, broken::blank_efficiency),
                                            screw * square(wide * (1.0 + core)) / 32.0,
                                            mass + load(i).payload,
                                            ramp);
      broken::hold_drive<T>(loaded, step, wide * core, motor, motion, out.utilisation);
    }
    broken::add_up<T>(screw, broken::price_of_blank<T>(in, screw), motor, mass, out);
  }
};

/// Stages of such axes over an instance, which must outlive them.
struct Machine {
  Machine(const stack::Instance& instance, std::size_t ramps, bool free_diameter)
      : screws(stack::broken::blanks(instance.screws)) {
    // One column more: the diameter as it is.
    Columns wider{"screw", screws.width + 1, {}};
    for (std::uint32_t i = 0; i < screws.rows(); ++i) {
      wider.numbers.insert(wider.numbers.end(), screws.row(i), screws.row(i) + screws.width);
      wider.numbers.push_back(instance.screws.row(i)[stack::diameter]);
    }
    screws = std::move(wider);
    for (const stack::Axis& axis : instance.axes) {
      const Model model{axis, ramps, free_diameter};
      stages.push_back(std::make_unique<millwright::solver::ModelStage<Model>>(
          "axis " + std::to_string(stages.size() + 1),
          std::vector<const Columns*>{&screws, &instance.motors},
          model.variables(),
          stack::constraints * model.moves(),
          model));
      problem.stages.push_back(stages.back().get());
    }
    problem.first_state = {0.0};
    problem.resources = {{"cost"}, {"mass"}};
  }
  Columns screws;
  std::vector<std::unique_ptr<stack::Stage>> stages;
  millwright::solver::Problem problem;
};

/// The slope of y over x on logarithmic scales, by least squares: the exponent with which y grows.
inline double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = std::log(x[i]), v = std::log(y[i]);
    sx += u;
    sy += v;
    sxx += u * u;
    sxy += u * v;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace growth
