// SPDX-License-Identifier: Apache-2.0
//
// The available torque of a motor with its driver at one supply voltage, on any scalar.
#pragma once

#include <algorithm>
#include <optional>

#include "evaluation/drive_tables.h"
#include "machine/motor.h"
#include "scalar/scalars.h"

namespace millwright::evaluation {

/// Peak amplitude of the current that a motor gets [A]: what is set, or what a weak driver gives.
inline double driver_current(const MotorPair& pair) {
  return std::min(pair.figures.driver_peak_current, pair.figures.asked_current);
}

/// What the winding model reads of a motor.
template <class T>
machine::MotorFigures<T> model_figures(const MotorPair& pair, std::size_t voltage) {
  using namespace scalar;
  const machine::MotorFigures<double> figures = pair.figures_at(voltage);
  machine::MotorFigures<T> f;
  f.holding_torque = in_unit<T>(figures.holding_torque, dimension::torque);
  f.rated_current = in_unit<T>(figures.rated_current, dimension::current);
  f.resistance = in_unit<T>(figures.resistance, dimension::resistance);
  f.inductance = in_unit<T>(figures.inductance, dimension::inductance);
  f.rotor_teeth = T(figures.rotor_teeth);
  f.voltage = in_unit<T>(figures.voltage, dimension::voltage);
  return f;
}

/// Available torque of one motor: its published curve where that governs, else the winding model; beyond the curve the
/// share of the model that counts there (AtVoltages), no more than the curve's last torque.
template <class T>
T available_torque(const MotorPair& pair, std::size_t voltage, const T& angular_speed) {
  using namespace scalar;
  const auto model = [&] {
    return machine::modelled_torque(
        model_figures<T>(pair, voltage), in_unit<T>(driver_current(pair), dimension::current), angular_speed);
  };
  const mechanics::PullOutCurve* curve = pair.curve_at(voltage);
  if (curve == nullptr) return model();
  const T last = in_unit<T>(curve->points().back().torque, dimension::torque);
  // The curve may end above the model: there the torque jumps down.
  return step_below(
      angular_speed,
      in_unit<T>(curve->end(), dimension::angular_speed),
      [&] { return (*curve)(angular_speed); },
      [&] { return smaller(T(pair.at->model_share * model()), last); });
}

/// The same over the figures of one motor that are intervals.
template <class T>
T available_torque(const MotorRanges& ranges, const T& angular_speed) {
  using namespace scalar;
  const machine::MotorFigures<Interval>& figures = ranges.figures;
  machine::MotorFigures<T> f;
  f.holding_torque = T(figures.holding_torque);
  f.rated_current = T(figures.rated_current);
  f.resistance = T(figures.resistance);
  f.inductance = T(figures.inductance);
  f.rotor_teeth = T(figures.rotor_teeth);
  f.voltage = T(figures.voltage);
  const T current = T(smaller(figures.driver_peak_current, figures.asked_current));
  const auto model = [&] { return machine::modelled_torque(f, current, angular_speed); };
  std::optional<T> result;
  const auto take = [&](const T& torque) { result = result ? hull(*result, torque) : torque; };
  if (ranges.model_may_govern) take(model());
  for (const MotorRanges::Curve& curve : ranges.curves)
    for (const mechanics::PullOutCurve* bound : {&curve.lowest, &curve.highest})
      take(step_below(
          angular_speed,
          T(bound->end()),
          [&] { return (*bound)(angular_speed); },
          [&] { return smaller(T(ranges.model_share * model()), T(bound->points().back().torque)); }));
  return result.value();
}

}  // namespace millwright::evaluation
