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

/// Torque beside published curves: `curve` where that governs, else the winding model. Beyond the curve, and where
/// there is only a `ceiling`, published at more voltage and current, the share of the model that counts there
/// (AtVoltages), no more than the curve's last torque and the ceiling. One of the two may be null.
template <class T, class Model>
T torque_beside(const mechanics::PullOutCurve* curve,
                const mechanics::PullOutCurve* ceiling,
                double model_share,
                const Model& model,
                const T& angular_speed) {
  using namespace scalar;
  const auto estimate = [&]() -> T {
    const T share = model_share * model();
    return ceiling == nullptr ? share : T(smaller(share, (*ceiling)(angular_speed)));
  };
  if (curve == nullptr) return estimate();
  const T last = in_unit<T>(curve->points().back().torque, dimension::torque);
  // The curve may end above the model: there the torque jumps down.
  return step_below(
      angular_speed,
      in_unit<T>(curve->end(), dimension::angular_speed),
      [&] { return (*curve)(angular_speed); },
      [&] { return T(smaller(estimate(), last)); });
}

/// Available torque of one motor.
template <class T>
T available_torque(const MotorPair& pair, std::size_t voltage, const T& angular_speed) {
  using namespace scalar;
  const auto model = [&] {
    return machine::modelled_torque(
        model_figures<T>(pair, voltage), in_unit<T>(driver_current(pair), dimension::current), angular_speed);
  };
  if (pair.is_modelled(voltage)) return model();
  return torque_beside<T>(pair.curve_at(voltage), pair.ceiling_at(voltage), pair.at->model_share, model, angular_speed);
}

/// Where an available torque comes from.
enum class TorqueOrigin {
  published,  ///< a curve says it
  modelled,   ///< the winding model alone
  shared,     ///< the share of the model that counts beside curves
  beyond,     ///< the same beyond the end of a curve
  bounded     ///< a curve published at more voltage and current, below the model
};

/// That of `torque` [N.m], which is available at this speed [rad/s].
inline TorqueOrigin torque_origin(const MotorPair& pair, std::size_t voltage, double angular_speed, double torque) {
  const mechanics::PullOutCurve *curve = pair.curve_at(voltage), *ceiling = pair.ceiling_at(voltage);
  if (curve != nullptr && (angular_speed < curve->end() || torque >= curve->points().back().torque))
    return TorqueOrigin::published;
  if (ceiling != nullptr && torque >= (*ceiling)(angular_speed)) return TorqueOrigin::bounded;
  if (curve != nullptr) return TorqueOrigin::beyond;
  return ceiling != nullptr ? TorqueOrigin::shared : TorqueOrigin::modelled;
}

/// What is said of a torque that no curve says.
constexpr const char* note_of(TorqueOrigin origin) {
  switch (origin) {
    case TorqueOrigin::beyond:
      return "beyond the end of the published curve torque is an estimate from the winding: the share of one counts";
    case TorqueOrigin::bounded:
      return "a curve published at as much voltage and current or more bounds the torque";
    case TorqueOrigin::shared:
      return "no published curve at this voltage and current: the share of an estimate from the winding counts";
    default:
      return "torque at speed is an estimate from the winding: no published curve at this voltage and current";
  }
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
  const auto place = [](const std::optional<mechanics::PullOutCurve>& of) { return of ? &*of : nullptr; };
  for (const MotorRanges::Published& each : ranges.published)
    take(torque_beside<T>(place(each.curve), place(each.ceiling), ranges.model_share, model, angular_speed));
  return result.value();
}

}  // namespace millwright::evaluation
