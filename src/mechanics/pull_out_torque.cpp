// SPDX-License-Identifier: Apache-2.0
#include "mechanics/pull_out_torque.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace millwright::mechanics::stepper {

namespace {

Interval from_zero(const Interval& x) { return {larger(x.lower, 0.0), larger(x.upper, 0.0)}; }

/// A square that is neither near to the smallest nor to the largest number.
bool is_ordinary(double square) { return square > 1e-250 && square < 1e250; }

/// Bounds of the largest torque current at one point, a part in 1e9 around the plain number, each proved by one
/// comparison; nothing where rounding leaves it open. Voltage, resistance and current may be wrong by two parts in
/// 1e15, the others by five: then no term below is wrong by more than four parts in 1e14, and sums are compared with a
/// margin of a part in 1e13 of their terms. (All that while no square runs out of the numbers that there are.)
std::optional<Interval> proved_current(
    double voltage, double resistance, double reactance, double emf, double current) {
  constexpr double step = 1e-9, error = 1e-13;
  const double found = largest_torque_current(voltage, resistance, reactance, emf, current);
  if (!(found > 1e-4 * current)) return std::nullopt;
  const double impedance_squared = resistance * resistance + reactance * reactance;
  if (!is_ordinary(impedance_squared) || !is_ordinary(voltage * voltage) || !is_ordinary(current * current))
    return std::nullopt;
  const double centre_d = -reactance * emf / impedance_squared;
  const double centre_q = -resistance * emf / impedance_squared;
  const double radius = voltage / std::sqrt(impedance_squared);
  const double room = error * current * current;

  // Below: a current vector that both limits allow, with i_d as near to the middle of the voltage disc as it may be.
  const double lower = found * (1.0 - step);
  const double i_d = larger(centre_d, -std::sqrt(larger(current * current - lower * lower - room, 0.0)));
  if (!(i_d * i_d + lower * lower <= current * current - 0.5 * room)) return std::nullopt;
  const double margin = error * ((resistance + reactance) * (lower - i_d) + emf);
  const double v_d = std::fabs(resistance * i_d - reactance * lower) + margin;
  const double v_q = std::fabs(resistance * lower + reactance * i_d + emf) + margin;
  if (!(v_d * v_d + v_q * v_q <= voltage * voltage * (1.0 - error))) return std::nullopt;

  // Above: at this i_q the two discs have no i_d in common; as they are convex and have the point below, none higher.
  const double upper = found * (1.0 + step);
  if (upper >= current) return Interval(lower, current);
  const double height = upper - centre_q;
  const double half_width = radius * radius - height * height + error * (radius * radius + height * height);
  if (!(half_width < 0.0)) {
    const double reach = std::sqrt(current * current - upper * upper + room) + std::sqrt(half_width);
    if (!(reach * (1.0 + error) < -centre_d * (1.0 - error))) return std::nullopt;
  }
  return Interval(lower, upper);
}

/// Largest torque current at one point; every argument is a number.
Interval current_at(double voltage, double resistance, double linkage, double constant, double current, double speed) {
  if (const auto proved = proved_current(voltage, resistance, linkage * speed, constant * speed, current))
    return *proved;
  const Interval omega(speed);
  const Interval found = largest_torque_current(Interval(voltage),
                                                Interval(resistance),
                                                Interval(linkage) * omega,
                                                Interval(constant) * omega,
                                                Interval(current));
  return {larger(found.lower, 0.0), smaller(found.upper, current)};
}

/// Largest torque current with i_d = 0 at one point: a lower bound that falls with R, λ, K and ω, because |v|² then is
/// R² i² + 2 K ω R i + ω² (K² + λ² i²).
double unweakened_current_at_least(
    double voltage, double resistance, double linkage, double constant, double current, double speed) {
  const Interval emf = Interval(constant) * speed;
  const Interval reactance = Interval(linkage) * speed;
  const Interval impedance_squared = square(Interval(resistance)) + square(reactance);
  const Interval radicand = square(Interval(voltage)) * impedance_squared - square(reactance * emf);
  if (!(radicand.lower > 0.0)) return 0.0;
  const Interval reached = (sqrt(radicand) - resistance * emf) / impedance_squared;
  return larger(smaller(reached.lower, current), 0.0);
}

/// The driver can hold the full current square to the flux everywhere in the box. (No plain number here is wrong by
/// more than a part in 1e14, but for squares too small to matter beside what is allowed.)
bool certainly_current_limited(const WindingBox& box) {
  const double active = box.resistance.upper * box.current.upper + box.constant.upper * box.speed.upper;
  const double reactive = box.linkage.upper * box.speed.upper * box.current.upper;
  const double allowed = box.voltage.lower * box.voltage.lower;
  return is_ordinary(allowed) && active * active + reactive * reactive <= allowed * (1.0 - 1e-13);
}

/// A number but for the rounding of a few operations.
bool is_rounded_number(const Interval& x) { return x.upper - x.lower <= 2e-15 * x.upper; }

/// Range of the torque current over a box narrow in constant and linkage.
Interval current_over(const WindingBox& box) {
  const auto& [voltage, resistance, linkage, constant, current, speed] = box;
  if (is_rounded_number(voltage) && is_rounded_number(resistance) && is_rounded_number(linkage) &&
      is_rounded_number(constant) && is_rounded_number(current) && is_rounded_number(speed)) {
    if (const auto proved = proved_current(
            voltage.upper, resistance.upper, linkage.upper * speed.upper, constant.upper * speed.upper, current.upper))
      return *proved;
  }
  const Interval most =
      current_at(voltage.upper, resistance.lower, linkage.upper, constant.lower, current.upper, speed.lower);
  const Interval least =
      current_at(voltage.lower, resistance.upper, linkage.lower, constant.upper, current.lower, speed.upper);
  const double wider = rounding::quotient_up(linkage.upper, linkage.lower);
  const double narrower = larger(rounding::quotient_down(linkage.lower, linkage.upper), 0.0);
  if (narrower > 0.999999)
    return {rounding::product_down(least.lower, narrower),
            smaller(rounding::product_up(most.upper, wider), current.upper)};
  const double unweakened = unweakened_current_at_least(
      voltage.lower, resistance.upper, linkage.upper, constant.upper, current.lower, speed.upper);
  return {larger(rounding::product_down(least.lower, narrower), unweakened),
          smaller(rounding::product_up(most.upper, wider), current.upper)};
}

/// Number of pieces that keeps the ratio of the ends of each near 1, few enough to stay fast.
int pieces(const Interval& x) {
  const double ratio = x.lower > 0.0 ? x.upper / x.lower : rounding::infinity;
  return ratio < 1.02 ? 1 : ratio < 1.1 ? 2 : ratio < 1.3 ? 4 : 6;
}

/// Piece number n of `count`, the ends in geometric steps; neighbouring pieces share their ends.
Interval piece(const Interval& x, int n, int count) {
  const auto end = [&](int k) {
    if (k == 0) return x.lower;
    if (k == count) return x.upper;
    const double share = static_cast<double>(k) / count;
    const double inside = x.lower > 0.0 ? x.lower * std::pow(x.upper / x.lower, share) : x.upper * share * share;
    return std::clamp(inside, x.lower, x.upper);
  };
  return {end(n), end(n + 1)};
}

Interval torque_over(const WindingBox& box) {
  if (certainly_current_limited(box)) return box.constant * box.current;
  const int constants = pieces(box.constant);
  const int linkages = pieces(box.linkage);
  Interval torque;
  for (int i = 0; i < constants; ++i) {
    for (int k = 0; k < linkages; ++k) {
      WindingBox part = box;
      part.constant = piece(box.constant, i, constants);
      part.linkage = piece(box.linkage, k, linkages);
      const Interval here = part.constant * current_over(part);
      torque = i == 0 && k == 0 ? here : hull(torque, here);
    }
  }
  return from_zero(torque);
}

/// Derivatives of the torque current, by V, R, λ, K, I_p, ω.
using CurrentSlopes = std::array<Interval, 6>;

/// Where the voltage limits, with the current (i_d, i_q) and the multiplier m of the voltage limit: a change of |v|² by
/// 2 dw changes the largest i_q by -m dw (m = 1/(Z² i_q + E R), and |i_d| / (E (R |i_d| + X i_q)) where both limit).
CurrentSlopes voltage_limited_slopes(
    const WindingBox& box, const Interval& m, const Interval& i_d, const Interval& i_q, const Interval& by_current) {
  const Interval emf = box.constant * box.speed;
  const Interval size_squared = square(i_d) + square(i_q);
  const Interval voltage_q =
      from_zero(box.resistance * i_q + box.linkage * box.speed * i_d + emf);  // never negative at the best current
  const Interval by_speed = box.constant * box.resistance * i_q +
                            box.speed * (square(box.linkage * i_d + box.constant) + square(box.linkage * i_q));
  return {box.voltage * m,
          -(m * (box.resistance * size_squared + emf * i_q)),
          -(m * square(box.speed) * (box.linkage * size_squared + box.constant * i_d)),
          -(m * box.speed * voltage_q),
          by_current,
          -(m * by_speed)};
}

void widen(std::optional<CurrentSlopes>& all, const CurrentSlopes& one) {
  if (!all) {
    all = one;
    return;
  }
  for (std::size_t k = 0; k < one.size(); ++k) (*all)[k] = hull((*all)[k], one[k]);
}

CurrentSlopes current_slopes(const WindingBox& box, const Interval& i_q) {
  std::optional<CurrentSlopes> all;
  const CurrentSlopes constant_current{0.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  if (certainly_current_limited(box)) return constant_current;
  const Interval emf = box.constant * box.speed;
  const Interval reactance = box.linkage * box.speed;
  const Interval impedance_squared = square(box.resistance) + square(reactance);
  const Interval needed = square(box.resistance * box.current + emf) + square(reactance * box.current);
  if (!certainly_below(square(box.voltage), needed)) widen(all, constant_current);
  if (!(i_q.lower > 0.0)) widen(all, CurrentSlopes{});
  // The voltage alone limits: the top of its disc is reached.
  const Interval centre_d = from_zero(reactance * emf / impedance_squared);
  const Interval top = box.voltage / sqrt(impedance_squared) - box.resistance * emf / impedance_squared;
  if (!certainly_below(square(box.current), square(centre_d) + square(top))) {
    const Interval i_d(-smaller(centre_d.upper, box.current.upper), -smaller(centre_d.lower, box.current.upper));
    const Interval m = 1.0 / (impedance_squared * i_q + emf * box.resistance);
    widen(all, voltage_limited_slopes(box, m, i_d, i_q, 0.0));
  }
  if (all && certainly_below(square(centre_d) + square(top), square(box.current))) return *all;
  // Both limit: the crossing of the two circles.
  const Interval i_d = -sqrt(from_zero(square(box.current) - square(i_q)));
  const Interval tilt = box.resistance * -i_d + reactance * i_q;
  const Interval m = from_zero(-i_d / (emf * tilt));
  const Interval by_current = from_zero(box.current * (reactance * emf + impedance_squared * i_d) / (emf * tilt));
  widen(all, voltage_limited_slopes(box, m, i_d, i_q, by_current));
  return *all;
}

}  // namespace

PullOutTorques::PullOutTorques(const Interval& voltage,
                               const Interval& resistance,
                               const Interval& inductance,
                               const Interval& rotor_teeth,
                               const Interval& torque_constant,
                               const Interval& current_amplitude)
    : at_rest_{from_zero(voltage),
               from_zero(resistance),
               from_zero(rotor_teeth) * from_zero(inductance),
               from_zero(torque_constant),
               from_zero(current_amplitude),
               Interval(0.0)} {}

WindingBox PullOutTorques::box_at(const Interval& angular_speed) const {
  WindingBox box = at_rest_;
  box.speed = from_zero(angular_speed);
  return box;
}

Interval PullOutTorques::at(const Interval& angular_speed) const { return torque_over(box_at(angular_speed)); }

Interval pull_out_torque(const Interval& voltage,
                         const Interval& resistance,
                         const Interval& inductance,
                         const Interval& rotor_teeth,
                         const Interval& torque_constant,
                         const Interval& current_amplitude,
                         const Interval& angular_speed) {
  return PullOutTorques(voltage, resistance, inductance, rotor_teeth, torque_constant, current_amplitude)
      .at(angular_speed);
}

PullOutRange pull_out_torque_and_slopes(const Interval& voltage,
                                        const Interval& resistance,
                                        const Interval& inductance,
                                        const Interval& rotor_teeth,
                                        const Interval& torque_constant,
                                        const Interval& current_amplitude,
                                        const Interval& angular_speed) {
  const WindingBox box =
      PullOutTorques(voltage, resistance, inductance, rotor_teeth, torque_constant, current_amplitude)
          .box_at(angular_speed);
  const Interval torque = torque_over(box);
  const Interval quotient = torque / box.constant;
  const Interval i_q(larger(quotient.lower, 0.0), smaller(quotient.upper, box.current.upper));
  const auto [by_voltage, by_resistance, by_linkage, by_constant, by_current, by_speed] = current_slopes(box, i_q);
  const Interval& k = box.constant;
  return {torque,
          {k * by_voltage,
           k * by_resistance,
           k * by_linkage * rotor_teeth,
           k * by_linkage * inductance,
           i_q + k * by_constant,
           k * by_current,
           k * by_speed}};
}

}  // namespace millwright::mechanics::stepper
