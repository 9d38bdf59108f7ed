// SPDX-License-Identifier: Apache-2.0
//
// The reduction by gear or belt between a motor and the shaft that it turns, on any scalar: what every kind of drive
// asks of it. A drive without one goes through the same functions, which then change nothing.
//
// Power flows both ways. While the motor drives, a torque T at the output takes T/(i η) of it; while the load drives,
// only T η/i comes back. Inertia at the output counts by 1/i² at the motor; what its acceleration costs in the mesh is
// neglected, as it is in actuation::screw_motor_torque and belt_motor_torque.
#pragma once

#include "machine/constraint.h"
#include "mechanics/transmission.h"
#include "scalar/scalars.h"

namespace millwright::machine {

/// `with()` where the property holds, `without` where it does not; for a set of designs of which some have it, both.
template <class T, class With>
T where_applies(Applies applies, const T& without, With&& with) {
  if (applies == Applies::no) return without;
  const T result = with();
  if constexpr (requires { hull(without, result); }) {
    if (applies == Applies::some) return hull(without, result);
  }
  return result;
}

template <class T>
struct ReductionReading {
  T ratio{}, efficiency{};
  T inertia{};        ///< at the input
  T backlash{};       ///< at the output, as the next
  T compliance{};     ///< rad/(N.m), 0 where no stiffness is stated
  T rated_torque{};   ///< 0 where none is stated
  T largest_speed{};  ///< of the input, 0 where none is stated
  T shaft{};          ///< 0 where it has none
  T mass{};
};

template <class Reading, class Visit>
void visit_reduction_reading(Reading& r, Visit&& visit) {
  for (auto* field : {&r.ratio,
                      &r.efficiency,
                      &r.inertia,
                      &r.backlash,
                      &r.compliance,
                      &r.rated_torque,
                      &r.largest_speed,
                      &r.shaft,
                      &r.mass})
    visit(*field);
}
inline constexpr std::size_t reduction_reading_fields = 9;

template <class T>
struct DriveReduction : ReductionReading<T> {
  bool present = false;
  Applies torque_is_rated = Applies::no, speed_is_rated = Applies::no;

  /// Speed, angle or acceleration of the motor for one of the output.
  [[nodiscard]] T at_motor(const T& at_output) const { return present ? T(at_output * this->ratio) : at_output; }
  /// Speed, angle or travel of the output for one of the motor.
  [[nodiscard]] T at_output(const T& at_motor) const { return present ? T(at_motor / this->ratio) : at_motor; }
  /// Motor torque for a torque that the output gives.
  [[nodiscard]] T driving(const T& torque) const {
    return present ? T(mechanics::transmission::motor_torque(torque, this->ratio, this->efficiency)) : torque;
  }
  /// Torque at the motor of one that drives the output.
  [[nodiscard]] T driven(const T& torque) const {
    return present ? T(torque * this->efficiency / this->ratio) : torque;
  }
  /// Inertia at the motor of one at the output, without its own.
  [[nodiscard]] T reflected(const T& behind) const {
    return present ? T(mechanics::transmission::reflected_inertia(behind, this->ratio)) : behind;
  }
  /// What it adds to that which the motor speeds up: the torque for it passes the reduction, of which only its
  /// efficiency comes through. While the load brakes it is less: taken so it is on the safe side.
  [[nodiscard]] T sped_up(const T& behind) const {
    return present ? T(this->reflected(behind) / this->efficiency) : behind;
  }
  /// With its own, as it hangs on the rotor.
  [[nodiscard]] T with_own(const T& others) const { return present ? T(this->inertia + others) : others; }
  /// The smaller of a speed of the motor and that for which the reduction is made.
  [[nodiscard]] T limited(const T& motor_speed) const {
    return where_applies(speed_is_rated, motor_speed, [&] {
      using scalar::smaller;
      return T(smaller(motor_speed, this->largest_speed));
    });
  }
  /// Ratio and efficiency for formulas that take them.
  [[nodiscard]] T ratio_or_one() const { return present ? this->ratio : T(1.0); }
  [[nodiscard]] T efficiency_or_one() const { return present ? this->efficiency : T(1.0); }
};

}  // namespace millwright::machine
