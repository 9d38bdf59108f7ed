// SPDX-License-Identifier: Apache-2.0
//
// Screw axis drive: screw and nut, motor and driver, coupling, support bearings; what it must move and how. `derive`
// computes what several constraints share, on any scalar; the constraints themselves are declared in
// screw_drive_constraints.h.
#pragma once

#include <functional>
#include <vector>

#include "machine/axis_motion.h"
#include "machine/motor.h"
#include "machine/screw.h"
#include "mechanics/accuracy.h"
#include "mechanics/actuation.h"
#include "mechanics/coupling.h"
#include "mechanics/stepper.h"
#include "mechanics/transmission.h"

namespace millwright::machine {

template <class T>
struct CouplingReading {
  T inertia{}, rated_torque{}, stiffness{}, largest_speed{}, least_bore{}, largest_bore{};
  /// Permissible misalignments, m, rad and m; only soft checks read them, and the search does not fill them in.
  T parallel_misalignment{}, angular_misalignment{}, axial_misalignment{};
};

template <class T>
struct SupportReading {
  T bore{}, permissible_axial_load{}, axial_stiffness{}, largest_speed{};
  T clamps{};  ///< 1 when the unit clamps the plain screw (pillow blocks), 0 when a journal is turned
};

/// The plain numbers of a screw axis that no choice changes.
struct ScrewDriveData {
  MotionData motion;
  Requirements require;
  double stroke = 0.0;
  double microsteps = 16.0;
  double brake_torque = 0.0;
  bool vertical = false;          ///< gravity acts along the travel
  bool free_end = false;          ///< the far end of the screw has no support
  bool both_ends_fixed = false;   ///< the far support takes thrust too
  bool preloaded = false;         ///< ball nuts run with the preload of the problem file
  double preload_fraction = 0.0;  ///< of the dynamic load rating
};

template <class T>
struct ScrewDrive {
  const ScrewDriveData* data = nullptr;
  ScrewKind kind = ScrewKind::sliding;
  ScrewReading<T> screw;
  MotorReading<T> motor;
  CouplingReading<T> coupling;
  SupportReading<T> support_fixed, support_free;
  T motor_shaft{};                              ///< m
  std::function<T(const T&)> available_torque;  ///< N.m at an angular speed

  T carried_mass{};       ///< kg, what the axis moves without its nut
  T acceleration_time{};  ///< s

  // derived
  T moved_mass{};
  Cycle<T> cycle;
  T load_inertia{};               ///< without the rotor, with the moved mass
  std::vector<T> axial_forces;    ///< |F|, per phase
  std::vector<T> motor_torques;   ///< signed, per phase
  std::vector<T> angular_speeds;  ///< per phase, the largest
  std::vector<T> torque_ratios;   ///< |T| / available torque at that speed, per phase that may govern, else 0
  T input_power{};                ///< W, drive input that the supply must be ready for
  T largest_force{}, largest_torque{}, screw_torque{}, peak_speed{}, load_torque{}, rms_torque{};
  T peak_acceleration{};  ///< of the motor, rad/s^2
  T holding_force{};      ///< static, along the travel

  [[nodiscard]] T require(Requirement requirement, const scalar::Dimension& dimension = scalar::dimension::none) const {
    return scalar::in_unit<T>(data->require(requirement), dimension);
  }
  [[nodiscard]] Applies sliding() const {
    return kind == ScrewKind::mixed ? Applies::some : kind == ScrewKind::sliding ? Applies::yes : Applies::no;
  }
  [[nodiscard]] Applies ball() const {
    return kind == ScrewKind::mixed ? Applies::some : kind == ScrewKind::ball ? Applies::yes : Applies::no;
  }

  void derive();

 private:
  void derive_power(const T& rotating_inertia);
};

template <class T>
void ScrewDrive<T>::derive_power(const T& rotating_inertia) {
  using namespace scalar;
  namespace st = mechanics::stepper;
  std::vector<T> powers;
  for (const SupplyDemand& demand : supply_demands(data->motion)) {
    const T acceleration = in_unit<T>(demand.acceleration, dimension::acceleration);
    const T weight = larger(cycle.gravity_force, in_unit<T>(0.0, dimension::force));
    const T force =
        moved_mass * acceleration + weight + cycle.friction_force + in_unit<T>(demand.force, dimension::force);
    const T omega = mechanics::power_screw::angular_speed(in_unit<T>(demand.speed, dimension::speed), screw.lead);
    const T torque = mechanics::ball_screw::drive_torque(force, screw.lead, screw.efficiency) +
                     rotating_inertia * acceleration * 2.0 * pi<T>() / screw.lead + screw.drag_torque;
    powers.push_back(drive_power(motor, torque, omega));
  }
  input_power = named("P_in", whole_watts(largest(powers)));
}

template <class T>
void ScrewDrive<T>::derive() {
  using namespace scalar;
  namespace act = mechanics::actuation;
  namespace st = mechanics::stepper;
  const T one = T(1.0);
  moved_mass = named("m", carried_mass + screw.nut_mass);
  cycle = duty_cycle(data->motion, moved_mass, acceleration_time);
  const T rotating = named("J_rot", motor.rotor_inertia + coupling.inertia + screw.inertia);
  load_inertia = named(
      "J_L", coupling.inertia + screw.inertia + mechanics::transmission::screw_load_inertia(moved_mass, screw.lead));
  const T turn = 2.0 * pi<T>();
  const T nothing = in_unit<T>(0.0, dimension::torque);
  axial_forces.clear();
  motor_torques.clear();
  angular_speeds.clear();
  torque_ratios.clear();
  std::vector<T> governing_forces, governing_torques, governing_accelerations;
  for (const Phase<T>& phase : cycle.phases) {
    axial_forces.push_back(absolute(phase.force));
    angular_speeds.push_back(mechanics::power_screw::angular_speed(phase.speed, screw.lead));
    motor_torques.push_back(nothing);
    torque_ratios.push_back(T(0.0));
    if (!phase.may_govern && !wants_everything<T>(data->require)) continue;
    const T& omega = angular_speeds.back();
    const T alpha = phase.acceleration * turn / screw.lead;
    motor_torques.back() = act::screw_motor_torque(phase.force,
                                                   screw.lead,
                                                   screw.efficiency,
                                                   screw.reverse_efficiency,
                                                   rotating,
                                                   alpha,
                                                   screw.drag_torque,
                                                   one,
                                                   one);
    if (!phase.may_govern) continue;
    governing_accelerations.push_back(alpha);
    governing_forces.push_back(axial_forces.back());
    governing_torques.push_back(absolute(motor_torques.back()));
    torque_ratios.back() =
        governing_torques.back() / larger(available_torque(omega), in_unit<T>(1e-9, dimension::torque));
  }
  peak_speed = named("ω", mechanics::power_screw::angular_speed(cycle.peak_speed, screw.lead));
  peak_acceleration = named("α", largest(governing_accelerations));
  largest_force = named("F", largest(governing_forces));
  largest_torque = named("T", largest(governing_torques));
  screw_torque = named("T_R", mechanics::ball_screw::drive_torque(largest_force, screw.lead, screw.efficiency));
  // Without acceleration: against gravity, friction and the process.
  const T steady =
      larger(cycle.gravity_force, in_unit<T>(0.0, dimension::force)) + cycle.friction_force + cycle.process_force;
  load_torque =
      named("T_L", mechanics::ball_screw::drive_torque(steady, screw.lead, screw.efficiency) + screw.drag_torque);
  T sum = in_unit<T>(0.0, dimension::torque * dimension::torque * dimension::time);
  for (std::size_t i = 0; i < motor_torques.size(); ++i)
    sum = sum + square(motor_torques[i]) * cycle.phases[i].duration;
  rms_torque = named("T_rms", sqrt(sum / cycle.total_time));
  derive_power(rotating);
  holding_force = named("F_h", larger(cycle.gravity_force, in_unit<T>(0.0, dimension::force)) + cycle.process_force);
}

}  // namespace millwright::machine
