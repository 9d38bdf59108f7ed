// SPDX-License-Identifier: Apache-2.0
//
// Time and electrical energy of one duty cycle of an axis, as objectives (objective.h): both move with the ramp time
// that is chosen. Written so that the ramp time occurs as seldom as can be: bounds over a range of ramps stay tight.
//
// Time. With equal ramps t_r to the speed v a distance s takes s/v + t_r, jerk-limited or not; where the time is given,
// it takes that, whatever the ramp.
//
// Energy: E = (P_Cu t + sum of W + sum of E_Fe)/eta over the moves, t the time of the whole cycle with its dwells. It
// is an estimate: iron losses and the efficiency of the driver are usual figures (motor.h).
//   P_Cu  copper loss; a stepper's driver keeps the current up at standstill too.
//   W     work at the shaft, phase by phase. Over a way s' with even force F and acceleration a it is the largest of
//           F s'/eta_f + J k^2 a s' + k T_d s'   the motor drives against F,
//           F s' eta_b + J k^2 a s' + k T_d s'   F < 0 assists, and only the share eta_b of it comes through,
//           0                                    work that comes back: a driver turns it into heat,
//         k the angle of the motor per way, J what turns, T_d the drag torque. Each of the three is q_j s' + g_j a s',
//         q_j for the steady force alone. A ramp goes over h = v t_r/2, whatever its shape (a jerk-limited one is taken
//         as even), and a s' is v^2/2 in one and -v^2/2 in the other. So, with any i of the three, over a move
//           sum of W = q_i s + (s - 2 h) M(1, 0) + M(h, v^2/2) + M(h, -v^2/2),
//           M(s', e) = max over j of (q_j - q_i) s' + (g_j - g_i) e >= 0.
//         With the i that is largest at steady speed M is 0 unless a ramp turns the sign: then no ramp time is left.
//   E_Fe  iron losses T_h (c_0 + c_1 omega) omega over the move: the mean of omega over time is theta/t; the mean of
//   its
//         square over that is omega_e = omega (1 - v t_r/s (1 - c)), c that of its ramps (ramp.h), 2/3 if they are
//         even. Then E_Fe = T_h (c_0 + c_1 omega_e) theta. In a move of given time t with y = t/(t - t_r) it is v = y
//         s/t, v t_r = s (y - 1) and, where ramps are even, omega_e = k s/t (4 - (2 - y)^2)/3.
#pragma once

#include <array>

#include "machine/geared_drive.h"
#include "machine/screw_drive.h"

namespace millwright::machine {

/// Which moves are timed: all of an axis, or those that count in the cycle of the machine (Move::counts_in_cycle).
enum class Timed { axis, machine };

/// Duration of the moves with their dwells [s].
template <class T>
T moving_time(const MotionData& motion, const T& acceleration_time, Timed timed) {
  using namespace scalar;
  double fixed = 0.0, ramps = 0.0;
  for (const Move& move : motion.moves) {
    if (timed == Timed::machine && !move.counts_in_cycle) continue;
    const double times = runs(motion, move);
    if (move.profile)
      fixed += move.profile->time + move.dwell;
    else if (move.speed)
      fixed += times * (move.distance / *move.speed + move.acceleration_time.value_or(0.0) + move.dwell);
    else
      fixed += times * (*move.time + move.dwell);
    if (move.speed && uses_chosen_ramp(move)) ramps += times;
  }
  const T constant = in_unit<T>(fixed, dimension::time);
  return ramps > 0.0 ? T(constant + ramps * acceleration_time) : constant;
}

/// A drive as its motor feels it, per way of the axis.
template <class T>
struct MotorView {
  T turning{};       ///< k, angle of the motor per way
  T mass{};          ///< kg, that travels; of a table its inertia
  T turning_mass{};  ///< J k^2, of all that turns
  T drag{};          ///< k T_d, force that the drag torque amounts to
  T loss{};          ///< 1/eta_f
  T back{};          ///< eta_b
};

template <class T>
MotorView<T> motor_view(const ScrewDrive<T>& d) {
  using namespace scalar;
  MotorView<T> view;
  const T reducer = d.reduction.efficiency_or_one();
  view.turning = d.reduction.at_motor(2.0 * pi<T>() / d.screw.lead);
  view.mass = d.moved_mass;
  view.turning_mass = d.rotating_inertia * square(view.turning);
  view.drag = d.reduction.driving(d.screw.drag_torque) * view.turning;
  view.loss = 1.0 / (d.screw.efficiency * reducer);
  // A self-locking screw has to be driven down: the reducer's losses add to that.
  view.back = where_below(
      d.screw.reverse_efficiency,
      T(0.0),
      [&](const T& locking) -> T { return locking / reducer; },
      [&](const T& yielding) -> T { return yielding * reducer; });
  return view;
}

template <class T>
MotorView<T> motor_view(const GearedDrive<T>& d) {
  using namespace scalar;
  MotorView<T> view;
  view.turning = d.reduction.at_motor(1.0 / d.radius);
  view.mass = d.travelling_mass;
  view.turning_mass = d.rotating_inertia * square(view.turning);
  view.drag = in_unit<T>(0.0, d.dimensions().force);
  view.loss = 1.0 / d.efficiency;
  view.back = d.efficiency;
  return view;
}

namespace detail {

/// A number in the middle of what a scalar stands for.
inline double representative(double x) { return x; }
inline double representative(const scalar::Interval& x) { return 0.5 * (x.lower + x.upper); }
template <class T>
double representative(const T& x) {
  return representative(x.value);
}

/// Adds up what a drive does in the moves of its axis, beside the copper loss.
template <class T, class Drive>
class WorkSum {
 public:
  explicit WorkSum(const Drive& drive)
      : d_(drive),
        view_(motor_view(drive)),
        of_(motion_dimensions(drive.data->motion.rotary)),
        sum_(si<T>(0.0, scalar::dimension::energy)) {}

  void add(const Move& move) {
    using namespace scalar;
    const T way = si<T>(move.distance, of_.distance);
    const T chosen = move.acceleration_time ? si<T>(*move.acceleration_time, dimension::time) : d_.acceleration_time;
    // Ramps that leave no cruise are refused (C-SYS-TIME); here they end where they meet.
    T speed, ramps_way, iron_speed;  // ramps_way: of both ramps
    if (move.speed) {
      speed = si<T>(*move.speed, of_.speed);
      ramps_way = speed * smaller(chosen, si<T>(move.distance / *move.speed, dimension::time));
      iron_speed = speed * (1.0 - ramps_way / (3.0 * way));
    } else {
      const T time = si<T>(*move.time, dimension::time);
      const T faster = 1.0 / (1.0 - smaller(T(chosen / time), T(0.5)));
      speed = faster * (way / time);
      ramps_way = (faster - 1.0) * way;
      iron_speed = (4.0 - square(2.0 - faster)) * (way / (3.0 * time));
    }
    if (move.jerk) {
      const T jerk = si<T>(*move.jerk, of_.acceleration / dimension::time);
      iron_speed = speed * (1.0 - ramps_way / way * (1.0 - ramp_parts(speed, chosen, &jerk).loss_share));
    }
    const T half = 0.5 * ramps_way;
    const T kinetic = 0.5 * square(speed);
    const T cruise = larger(way - ramps_way, si<T>(0.0, of_.distance));
    const int times = runs(d_.data->motion, move);
    for (int direction = 0; direction < times; ++direction) {
      const Ways ways = ways_of(steady_force(direction > 0, move.force));
      const std::size_t i = ways.usual;
      sum_ = sum_ + ways.steady[i] * way + above(ways, cruise, si<T>(0.0, of_.speed * of_.speed)) +
             above(ways, half, kinetic) + above(ways, half, T(-kinetic));
    }
    add_iron(T(times * way), iron_speed);
  }

  void add(const ProfilePhase& phase) {
    const T way = si<T>(phase.mean_speed * phase.duration, of_.distance);
    if (phase.mean_speed <= 0.0) return;
    const Ways ways = ways_of(steady_force(phase.backwards, phase.force));
    const std::size_t i = ways.usual;
    const T gain = si<T>(phase.acceleration * phase.mean_speed * phase.duration, of_.speed * of_.speed);
    sum_ = sum_ + ways.steady[i] * way + ways.gain[i] * gain + above(ways, way, gain);
    add_iron(way, si<T>(loss_share(phase) * phase.speed, of_.speed));
  }

  [[nodiscard]] const T& sum() const { return sum_; }

 private:
  [[nodiscard]] T steady_force(bool down, double process) const {
    const T weight = down ? T(-d_.cycle.gravity_force) : d_.cycle.gravity_force;
    return weight + d_.cycle.friction_force + si<T>(process, of_.force);
  }
  /// The ways to work at a steady force: q_j and g_j.
  struct Ways {
    std::array<T, 3> steady, gain;
    std::size_t usual = 0;  ///< i; right or not decides over tightness only
  };
  [[nodiscard]] Ways ways_of(const T& force) const {
    Ways ways;
    ways.steady = {T(force * view_.loss + view_.drag), T(force * view_.back + view_.drag), T(0.0 * force)};
    ways.gain = {T(view_.mass * view_.loss + view_.turning_mass),
                 T(view_.mass * view_.back + view_.turning_mass),
                 T(0.0 * view_.mass)};
    for (std::size_t j = 1; j < ways.steady.size(); ++j)
      if (representative(ways.steady[j]) > representative(ways.steady[ways.usual])) ways.usual = j;
    return ways;
  }
  /// M.
  [[nodiscard]] T above(const Ways& ways, const T& way, const T& gain) const {
    using namespace scalar;
    T most = si<T>(0.0, dimension::energy);
    for (std::size_t j = 0; j < ways.steady.size(); ++j)
      if (j != ways.usual)
        most = larger(
            most, T((ways.steady[j] - ways.steady[ways.usual]) * way + (ways.gain[j] - ways.gain[ways.usual]) * gain));
    return most;
  }
  void add_iron(const T& way, const T& speed) {
    using namespace scalar;
    const T omega = view_.turning * speed;
    sum_ = sum_ + mechanics::stepper::loss_torque(
                      d_.motor.holding_torque, omega, T(constant_loss), si<T>(speed_loss, dimension::time)) *
                      (view_.turning * way);
  }

  const Drive& d_;
  MotorView<T> view_;
  MotionDimensions of_;
  T sum_;
};

}  // namespace detail

/// Electrical energy that a drive takes for one cycle of its axis [J], an estimate: see the head of this file.
template <class Drive, class T = std::remove_cvref_t<decltype(std::declval<Drive>().input_power)>>
T cycle_energy(const Drive& drive) {
  const MotionData& motion = drive.data->motion;
  detail::WorkSum<T, Drive> work(drive);
  for (const Move& move : motion.moves) {
    if (move.profile)
      for (const ProfilePhase& phase : move.profile->phases) work.add(phase);
    else
      work.add(move);
  }
  const T copper = drive.motor.copper_loss * moving_time(motion, drive.acceleration_time, Timed::axis);
  return (copper + work.sum()) / T(driver_efficiency);
}

}  // namespace millwright::machine
