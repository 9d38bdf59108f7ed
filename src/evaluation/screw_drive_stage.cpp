// SPDX-License-Identifier: Apache-2.0
#include "evaluation/screw_drive_stage.h"

#include <cmath>

namespace millwright::evaluation {

using machine::ScrewDrive;
using machine::ScrewKind;

machine::MotionData motion_of(const machine::Axis& axis) {
  return {axis.moves,
          axis.inclination,
          axis.guide_friction,
          machine::is_rotary(axis) ? axis.friction_torque : axis.guide_drag,
          axis.counterbalance_force,
          axis.acceleration_time,
          machine::is_rotary(axis)};
}

machine::MotionData drive_motion_of(const machine::Axis& axis) {
  machine::MotionData motion = motion_of(axis);
  const double share = axis.mechanism.load_share;
  for (machine::Move& move : motion.moves) {
    move.force *= share;
    if (move.profile) move.profile->scale_forces(share);
  }
  motion.guide_drag *= share;
  motion.counterbalance_force *= share;
  return motion;
}

machine::GearedDriveData geared_drive_data(const machine::Axis& axis) {
  const machine::Mechanism& mechanism = axis.mechanism;
  const bool rack = mechanism.kind == machine::MechanismKind::rack;
  const bool belt = mechanism.kind == machine::MechanismKind::belt;
  return {.motion = drive_motion_of(axis),
          .require = axis.require,
          .stroke = axis.stroke,
          .microsteps = axis.motor.microsteps,
          .brake_torque = axis.motor.brake_torque,
          .efficiency = rack   ? mechanism.rack_efficiency
                        : belt ? mechanism.belt_efficiency
                               : 1.0,
          .backlash = rack ? mechanism.backlash : 0.0,
          .vertical = gravity_acts(axis),
          .motor_rides = rack && mechanism.motor_rides,
          .moved_share = mechanism.load_share * mechanism.drives};
}

bool gravity_acts(const machine::Axis& axis) { return std::sin(axis.inclination) > 1e-9; }

std::pair<double, double> constant_speed_range(const machine::Axis& axis) {
  double slow = scalar::rounding::infinity, fast = 0.0;
  for (const machine::Move& move : axis.moves) {
    if (move.profile) {
      // What is slower than that is one range of the torque table.
      slow = std::min(slow, 0.02 * move.profile->peak_speed);
      fast = std::max(fast, move.profile->peak_speed);
      continue;
    }
    const auto speed = [&](double ramp) {
      return move.speed ? *move.speed : move.distance / std::max(*move.time - ramp, 1e-3 * *move.time);
    };
    slow = std::min(slow, speed(move.acceleration_time.value_or(axis.acceleration_time.lower)));
    fast = std::max(fast, speed(move.acceleration_time.value_or(axis.acceleration_time.upper)));
  }
  return {slow, fast};
}

std::vector<double> log_spaced(double from, double to) {
  constexpr int ranges = 24;
  std::vector<double> edges;
  for (int i = 0; i <= ranges; ++i) edges.push_back(from * std::pow(to / from, i / static_cast<double>(ranges)));
  return edges;
}

namespace {

/// Edges of the ranges of the torque table, from the slowest move on the longest lead to the fastest on the shortest.
std::vector<double> screw_speed_edges(const machine::Axis& axis,
                                      const ScrewTable& screws,
                                      const ReductionSlot& reduction) {
  double longest = 0.0, shortest = scalar::rounding::infinity;
  for (const auto& f : screws.shafts) {
    longest = std::max(longest, f.lead);
    shortest = std::min(shortest, f.lead);
  }
  if (screws.pairs.empty()) return {0.0, 1.0};
  const auto [slow, fast] = constant_speed_range(axis);
  constexpr double turn = 2.0 * 3.14159265358979323846;
  return log_spaced(0.999 * slow * turn / longest * reduction.least_ratio(),
                    1.001 * fast * turn / shortest * reduction.largest_ratio());
}

}  // namespace

ScrewDriveStage::ScrewDriveStage(const machine::Axis& axis,
                                 AxisPlace place,
                                 const std::vector<double>& voltages,
                                 const catalogue::Catalogue& catalogue,
                                 const PriceBook& prices)
    : DriveStage(axis, place, prices),
      data_{.motion = drive_motion_of(axis),
            .require = axis.require,
            .stroke = axis.stroke,
            .microsteps = axis.motor.microsteps,
            .brake_torque = axis.motor.brake_torque,
            .vertical = gravity_acts(axis),
            .free_end = axis.mechanism.ends == machine::Ends::fixed_free,
            .both_ends_fixed = axis.mechanism.ends == machine::Ends::fixed_fixed,
            .preloaded = axis.mechanism.preload_fraction > 0.0,
            .preload_fraction = axis.mechanism.preload_fraction,
            .has_coupling = machine::has_coupling(axis.mechanism),
            .nut_rotates = axis.mechanism.nut_rotates,
            .nut_inertia = axis.mechanism.nut_inertia,
            .moved_share = axis.mechanism.load_share * axis.mechanism.drives},
      screws_(screw_table(catalogue, axis, prices)) {
  name_ = axis.name + ".drive";
  const bool stiffness = stiffness_matters(axis);
  tables_.push_back(std::move(screws_.table));
  take_motors(motor_table(catalogue, axis, voltages, prices),
              axis,
              voltages.size(),
              screw_speed_edges(axis, screws_, reduction_));
  const auto add = [&](SlotTable table) {
    tables_.push_back(std::move(table));
    return tables_.size() - 1;
  };
  if (data_.has_coupling) coupling_slot_ = add(coupling_table(catalogue, prices));
  const bool thrust = axis.mechanism.ends != machine::Ends::supported_supported;
  fixed_slot_ = add(support_table(catalogue, prices, "support_fixed", thrust, stiffness));
  if (!data_.free_end)
    free_slot_ = add(support_table(catalogue, prices, "support_free", data_.both_ends_fixed, stiffness));
  reduction_.add_to(tables_);
  for (SlotTable& table : tables_) table.multiply(drives_);
  finish_slots();
  if (!acceleration_time_.fixed())
    variables_.push_back({"acceleration_time", acceleration_time_.lower, acceleration_time_.upper});
  machine::screw_drive_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&&) {
    constraint_count_ += machine::is_searched(d, axis.require);
  });
}

/// The kind of all these screws, if they are of one kind.
ScrewKind ScrewDriveStage::kind_of(const RowsAlive& screws) const {
  const std::size_t reading = tables_[screw_slot].width();
  const scalar::Interval kinds = reading < screws.readings.size() ? screws.readings[reading] : kinds_of(screws);
  return kinds.lower == kinds.upper ? screws_.kinds[screws.front()] : ScrewKind::mixed;
}

template <class T>
ScrewDrive<T> ScrewDriveStage::design(const Selection<T>& s) const {
  ScrewDrive<T> d;
  d.data = &data_;
  d.kind = kind_of(s.rows[screw_slot]);
  const auto read = [&](std::size_t slot, std::size_t field) {
    return tables_[slot].template read<T>(s.rows[slot], field);
  };
  std::size_t field = 0;
  visit_screw_reading(d.screw, [&](T& x) { x = read(screw_slot, field++); });
  if (machine::wants_everything<T>(data_.require))
    visit_shown_screw_reading(d.screw, [&](T& x) { x = read(screw_slot, field++); });
  const std::size_t voltage = s.shared.empty() ? 0 : s.shared.front();
  d.motor = motors_->template reading<T>(s.rows[motor_slot], voltage);
  d.motor_shaft = motors_->template shaft<T>(s.rows[motor_slot]);
  d.available_torque = [this, rows = s.rows[motor_slot], voltage](const T& omega) {
    return motors_->template torque<T>(rows, voltage, omega);
  };
  d.motor_mass = motors_->template mass<T>(s.rows[motor_slot]);
  d.reduction = reduction_.reading<T>(s.rows);
  if (coupling_slot_) {
    const auto coupling = [&](std::size_t figure) { return read(*coupling_slot_, figure); };
    d.coupling = {coupling(0), coupling(1), coupling(2), coupling(3), coupling(4), coupling(5), T{}, T{}, T{}};
    if (machine::wants_everything<T>(data_.require)) {
      d.coupling.parallel_misalignment = coupling(6);
      d.coupling.angular_misalignment = coupling(7);
      d.coupling.axial_misalignment = coupling(8);
    }
  }
  const auto support = [&](std::size_t slot) {
    return machine::SupportReading<T>{read(slot, 0), read(slot, 1), read(slot, 2), read(slot, 3), read(slot, 4)};
  };
  d.support_fixed = support(fixed_slot_);
  d.support_free = free_slot_
                       ? support(*free_slot_)
                       : machine::SupportReading<T>{T(0.0), T(0.0), T(0.0), d.support_fixed.largest_speed, T(0.0)};
  d.carried_mass = s.inherited[place_.load_state];
  if (load_share_ != 1.0) d.carried_mass = load_share_ * d.carried_mass;
  d.acceleration_time = variables_.empty() ? T(acceleration_time_.lower) : s.variables[0];
  d.derive();
  return d;
}

template <class T>
void ScrewDriveStage::answer(const Selection<T>& s, solver::Answer<T>& out) const {
  const ScrewDrive<T> d = design(s);
  machine::screw_drive_constraints(UtilisationVisitor<T, ScrewDrive<T>>(d, s.kept, out.utilisation));
  out.resources[cost_resource] = total<T>(s, Total::price);
  out.resources[mass_resource] = total<T>(s, Total::mass);
  count_cycle(place_, d, drives_, out);
  add_to_tool(place_, d, out);
  out.handed_on[power_state] = s.inherited[power_state] + (drives_ == 1.0 ? d.input_power : drives_ * d.input_power);
  hand_on_flange(d, s, out);
  out.handed_on[place_.load_state] = T(0.0);
  if (place_.parent_load_state)
    out.handed_on[*place_.parent_load_state] =
        s.inherited[*place_.parent_load_state] + s.inherited[place_.load_state] + total<T>(s, Total::burden);
}

namespace {
constexpr double margin = 1.0 + 1e-12;  // the constraint itself decides on the last bit
}

bool ScrewDriveStage::coupling_fits(double shaft, solver::Row coupling) const {
  const SlotTable& couplings = tables_[*coupling_slot_];
  return shaft <= couplings.reading(coupling, 5) * margin && couplings.reading(coupling, 4) <= shaft * margin;
}

bool ScrewDriveStage::free_support_fits(solver::Row screw, solver::Row support) const {
  const machine::ScrewFigures<double>& figures = screws_.shaft(screw);
  const double bore = tables_[*free_slot_].reading(support, 0);
  const bool clamps = tables_[*free_slot_].reading(support, 4) > 0.0 && bore / figures.nominal_diameter <= margin &&
                      figures.nominal_diameter / bore <= margin;
  return clamps || bore <= figures.root_diameter * margin;
}

bool ScrewDriveStage::fits(
    std::span<const solver::Row>, std::size_t slot_a, solver::Row row_a, std::size_t slot_b, solver::Row row_b) const {
  if (slot_a > slot_b) return fits({}, slot_b, row_b, slot_a, row_a);
  if (slot_a == screw_slot && slot_b == fixed_slot_)
    return tables_[fixed_slot_].reading(row_b, 0) <= screws_.shaft(row_a).root_diameter * margin;
  if (slot_a == screw_slot && slot_b == free_slot_) return free_support_fits(row_a, row_b);
  if (slot_a == motor_slot && slot_b == coupling_slot_ && !reduction_.slot())
    return coupling_fits(motors_->pairs()[row_a].shaft, row_b);
  if (slot_a == coupling_slot_ && slot_b == fixed_slot_)
    return tables_[*coupling_slot_].reading(row_a, 4) <= tables_[fixed_slot_].reading(row_b, 0) * margin;
  if (slot_a == coupling_slot_ && reduction_.is(slot_b)) return coupling_fits(reduction_.shaft(row_b), row_a);
  return true;
}

solver::FitKey ScrewDriveStage::fit_key(std::span<const solver::Row>,
                                        std::size_t slot,
                                        solver::Row row,
                                        std::size_t other) const {
  if (slot == screw_slot) {
    const machine::ScrewFigures<double>& figures = screws_.shaft(row);
    if (other == fixed_slot_) return {figures.root_diameter, 0.0};
    if (other == free_slot_) return {figures.nominal_diameter, figures.root_diameter};
  }
  if (slot == fixed_slot_ && (other == screw_slot || other == coupling_slot_))
    return {tables_[slot].reading(row, 0), 0.0};
  if (slot == free_slot_ && other == screw_slot) return {tables_[slot].reading(row, 0), tables_[slot].reading(row, 4)};
  if (slot == coupling_slot_) return {tables_[slot].reading(row, 4), tables_[slot].reading(row, 5)};
  if (slot == motor_slot && other == coupling_slot_) return {motors_->pairs()[row].shaft, 0.0};
  if (reduction_.is(slot) && other == coupling_slot_) return {reduction_.shaft(row), 0.0};
  return {};
}

template ScrewDrive<double> ScrewDriveStage::design(const Selection<double>&) const;

template class ElementStage<ScrewDriveStage>;

}  // namespace millwright::evaluation
