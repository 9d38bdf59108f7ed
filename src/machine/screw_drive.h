// SPDX-License-Identifier: Apache-2.0
//
// Screw axis drive: screw and nut, motor and driver, coupling, support bearings; what it must move and how. `derive`
// computes what several constraints share, on any scalar; the constraints themselves are declared in
// screw_drive_constraints.h.
//
// A reduction sits between motor and screw. With an output shaft of its own (a gearbox) the coupling joins that shaft
// to the screw; without one (a belt or gear pair, its last wheel on the screw) there is no coupling. "Output" means
// behind the reduction: there coupling and screw turn.
//
// The nut may turn instead of the screw: then motor and reduction ride with it, no coupling can be on the line that the
// screw runs through, and the screw stands, clamped in its supports. What thread and balls see is the speed of the nut
// against the screw, which is the same; a screw that does not turn has no critical speed and its supports no speed.
// The torque of the nut is held by the clamped end: the screw between it and the nut twists as one that turns, and the
// nut is back by that angle.
#pragma once

#include <functional>
#include <vector>

#include "machine/axis_motion.h"
#include "machine/motor.h"
#include "machine/reduction.h"
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
  bool has_coupling = true;       ///< on the motor's shaft, or the output shaft of a reduction
  bool nut_rotates = false;
  double nut_inertia = 0.0;  ///< kg.m2, of a nut that turns, with the wheel on it
  double moved_share = 1.0;  ///< of what rides with a nut that turns, that this drive moves
};

template <class T>
struct ScrewDrive {
  const ScrewDriveData* data = nullptr;
  ScrewKind kind = ScrewKind::sliding;
  ScrewReading<T> screw;
  MotorReading<T> motor;
  CouplingReading<T> coupling;
  SupportReading<T> support_fixed, support_free;
  DriveReduction<T> reduction;
  T motor_shaft{};                              ///< m
  T motor_mass{};                               ///< kg, read only where it rides
  std::function<T(const T&)> available_torque;  ///< N.m at an angular speed

  T carried_mass{};       ///< kg, what the axis moves without its nut
  T acceleration_time{};  ///< s

  // derived
  T moved_mass{};
  Cycle<T> cycle;
  T riding_mass{};                ///< kg, of this drive: what of it moves with the axis
  T load_inertia{};               ///< without the rotor, with the moved mass, at the motor
  T output_inertia{};             ///< the same without the reduction's own
  std::vector<T> axial_forces;    ///< |F|, per phase
  std::vector<T> motor_torques;   ///< signed, per phase
  std::vector<T> angular_speeds;  ///< per phase, the largest
  std::vector<T> torque_ratios;   ///< |T| / available torque at that speed, per phase that may govern, else 0
  T input_power{};                ///< W, drive input that the supply must be ready for
  T largest_force{}, largest_torque{}, screw_torque{}, peak_speed{}, load_torque{};
  T driven_force{};       ///< the largest while it moves; largest_force is that of standing, too
  T standing_torque{};    ///< at the screw, under the force of standing; only where there is one
  T screw_speed{};        ///< of screw and nut against each other, the largest
  T steady_torque{};      ///< at the screw, without acceleration
  T output_torque{};      ///< the largest that turns the screw; only behind a reduction or a coupling
  T peak_acceleration{};  ///< of the motor, rad/s^2
  T holding_force{};      ///< static, along the travel
  T rotating_inertia{};   ///< of all that turns, at the motor

  [[nodiscard]] T require(Requirement requirement, const scalar::Dimension& dimension = scalar::dimension::none) const {
    return scalar::in_unit<T>(data->require(requirement), dimension);
  }
  [[nodiscard]] Applies sliding() const {
    return kind == ScrewKind::mixed ? Applies::some : kind == ScrewKind::sliding ? Applies::yes : Applies::no;
  }
  [[nodiscard]] Applies ball() const {
    return kind == ScrewKind::mixed ? Applies::some : kind == ScrewKind::ball ? Applies::yes : Applies::no;
  }

  /// Shaft that the coupling clamps on the side of the motor [m].
  [[nodiscard]] const T& output_shaft() const { return reduction.present ? reduction.shaft : motor_shaft; }
  /// Whether something between motor and screw bears what turns the screw.
  [[nodiscard]] bool is_driven_through() const { return reduction.present || data->has_coupling; }
  /// Inertia on the side of the motor before the elastic parts: its rotor and the reduction's [kg.m2].
  [[nodiscard]] T motor_side_inertia() const { return reduction.with_own(motor.rotor_inertia); }
  /// Travel of a turn of the motor [m].
  [[nodiscard]] T lead_of_motor() const { return reduction.at_output(screw.lead); }

  void derive();

 private:
  void derive_phases(const T& turning);
  void derive_power();
};

template <class T>
void ScrewDrive<T>::derive_power() {
  using namespace scalar;
  namespace st = mechanics::stepper;
  Largest<T> power;
  const T& weight = cycle.weight;
  for (const PowerDemand<T>& demand : cycle.demands) {
    const T& acceleration = demand.acceleration;
    const T force = moved_mass * acceleration + weight + cycle.friction_force + demand.force;
    const T omega = reduction.at_motor(mechanics::power_screw::angular_speed(demand.speed, screw.lead));
    const T torque = reduction.driving(mechanics::ball_screw::drive_torque(force, screw.lead, screw.efficiency) +
                                       screw.drag_torque) +
                     rotating_inertia * reduction.at_motor(acceleration * 2.0 * pi<T>() / screw.lead);
    if constexpr (std::is_same_v<T, Interval>) {
      // The torque is linear in the acceleration, and acceleration times speed is known better than both apart.
      const auto driving = [&](const T& axial) {
        return mechanics::ball_screw::drive_torque(axial, screw.lead, screw.efficiency);
      };
      const T together =
          reduction.at_motor(mechanics::power_screw::angular_speed(demand.acceleration_times_speed, screw.lead));
      const T steady =
          reduction.driving(driving(weight + cycle.friction_force + demand.force) + screw.drag_torque) * omega;
      const T accelerating = reduction.driving(driving(moved_mass * together)) +
                             rotating_inertia * reduction.at_motor(together * 2.0 * pi<T>() / screw.lead);
      power.take(drive_power(motor, torque, omega, T(steady + accelerating)));
    } else {
      power.take(drive_power(motor, torque, omega));
    }
  }
  input_power = named("P_in", whole_watts(power.value()));
}

template <class T>
void ScrewDrive<T>::derive_phases(const T& turning) {
  using namespace scalar;
  namespace act = mechanics::actuation;
  const T one = T(1.0);
  const T nothing = in_unit<T>(0.0, dimension::torque);
  const T drag = reduction.driving(screw.drag_torque);
  axial_forces.clear();
  motor_torques.clear();
  angular_speeds.clear();
  torque_ratios.clear();
  Largest<T> most_force, most_torque, most_acceleration, most_output_torque;
  make_room(cycle.phases.size(), axial_forces, motor_torques, angular_speeds, torque_ratios);
  const auto torque =
      [&](const T& force, const T& inertia, const T& alpha, const T& dragging, const T& i, const T& eta) {
        return act::screw_motor_torque(
            force, screw.lead, screw.efficiency, screw.reverse_efficiency, inertia, alpha, dragging, i, eta);
      };
  for (const Phase<T>& phase : cycle.phases) {
    axial_forces.push_back(absolute(phase.force));
    angular_speeds.push_back(reduction.at_motor(mechanics::power_screw::angular_speed(phase.speed, screw.lead)));
    motor_torques.push_back(nothing);
    torque_ratios.push_back(T(0.0));
    if (!phase.may_govern && !wants_everything<T>(data->require)) continue;
    const T& omega = angular_speeds.back();
    const T output_alpha = phase.acceleration * (2.0 * pi<T>()) / screw.lead;
    const T alpha = reduction.at_motor(output_alpha);
    motor_torques.back() = named(
        "T_m",
        torque(phase.force, rotating_inertia, alpha, drag, reduction.ratio_or_one(), reduction.efficiency_or_one()));
    if (!phase.may_govern) continue;
    const T needed = absolute(motor_torques.back());
    most_acceleration.take(alpha);
    most_force.take(axial_forces.back());
    most_torque.take(needed);
    torque_ratios.back() = needed / larger(available_torque(omega), in_unit<T>(1e-9, dimension::torque));
    // The same balance behind reduction and coupling: without the rotor.
    if (is_driven_through())
      most_output_torque.take(absolute(torque(phase.force, turning, output_alpha, screw.drag_torque, one, one)));
  }
  peak_acceleration = named("α", most_acceleration.value());
  driven_force = named("F", most_force.value());
  if (cycle.standing_force > 0.0) {
    const T load = standing_load(cycle, dimension::force);
    const T still = in_unit<T>(0.0, dimension::angular_acceleration);
    most_force.take(load);
    standing_torque = named("T_st", torque(load, turning, still, screw.drag_torque, one, one));
    if (is_driven_through()) most_output_torque.take(standing_torque);
  }
  largest_force = named("F", most_force.value());
  largest_torque = named("T", most_torque.value());
  if (is_driven_through()) output_torque = named("T_2", most_output_torque.value());
}

template <class T>
void ScrewDrive<T>::derive() {
  using namespace scalar;
  riding_mass = screw.nut_mass;
  moved_mass = carried_mass + screw.nut_mass;
  if (data->nut_rotates) {
    const T riding = reduction.present ? T(motor_mass + reduction.mass) : motor_mass;
    riding_mass = named("m_r", screw.nut_mass + riding);
    moved_mass = moved_mass + data->moved_share * riding;
  }
  moved_mass = named("m", moved_mass);
  cycle = duty_cycle(data->motion, moved_mass, acceleration_time);
  const T turning = named("J_o",
                          data->nut_rotates    ? in_unit<T>(data->nut_inertia, dimension::inertia)
                          : data->has_coupling ? T(coupling.inertia + screw.inertia)
                                               : screw.inertia);
  rotating_inertia = named("J_rot", motor.rotor_inertia + reduction.with_own(reduction.sped_up(turning)));
  output_inertia = reduction.reflected(turning + mechanics::transmission::screw_load_inertia(moved_mass, screw.lead));
  load_inertia = named("J_L", reduction.with_own(output_inertia));
  derive_phases(turning);
  screw_speed = named("ω_s", mechanics::power_screw::angular_speed(cycle.peak_speed, screw.lead));
  peak_speed = named("ω", reduction.at_motor(screw_speed));
  screw_torque = named("T_R", mechanics::ball_screw::drive_torque(largest_force, screw.lead, screw.efficiency));
  // Without acceleration: against gravity, friction and the process.
  const T& weight = cycle.weight;
  const T steady = weight + cycle.friction_force + cycle.process_force;
  steady_torque = mechanics::ball_screw::drive_torque(steady, screw.lead, screw.efficiency) + screw.drag_torque;
  load_torque = named("T_L", reduction.driving(steady_torque));
  derive_power();
  holding_force = named("F_h", weight + cycle.process_force);
}

}  // namespace millwright::machine
