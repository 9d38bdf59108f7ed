// SPDX-License-Identifier: Apache-2.0
#include "evaluation/rack_drive_stage.h"

#include <cmath>

namespace millwright::evaluation {

using machine::RackDrive;

namespace {

constexpr std::size_t rack_module = 0, rack_angle = 1;
constexpr std::size_t pinion_module = 0, pinion_angle = 1, pinion_teeth = 2, pinion_bore = 4;

/// Edges of the ranges of the torque table, from the slowest move on the largest pinion to the fastest on the smallest.
std::vector<double> rack_speed_edges(const machine::Axis& axis,
                                     const SlotTable& pinions,
                                     const ReductionSlot& reduction) {
  double smallest = scalar::rounding::infinity, largest = 0.0;
  for (std::size_t row = 0; row < pinions.rows(); ++row) {
    const double radius = 0.5 * pinions.reading(row, pinion_module) * pinions.reading(row, pinion_teeth);
    smallest = std::min(smallest, radius);
    largest = std::max(largest, radius);
  }
  if (pinions.rows() == 0) return {0.0, 1.0};
  const auto [slow, fast] = constant_speed_range(axis);
  return log_spaced(0.999 * slow * reduction.least_ratio() / largest,
                    1.001 * fast * reduction.largest_ratio() / smallest);
}

bool same(double a, double b) { return std::abs(a - b) < 1e-9; }

}  // namespace

RackDriveStage::RackDriveStage(const machine::Axis& axis,
                               AxisPlace place,
                               const std::vector<double>& voltages,
                               const catalogue::Catalogue& catalogue,
                               const PriceBook& prices)
    : DriveStage(axis, place, prices), data_(geared_drive_data(axis)) {
  name_ = axis.name + ".drive";
  tables_.push_back(rack_table(catalogue, axis, prices));
  tables_.push_back(pinion_table(catalogue, prices));
  take_motors(motor_table(catalogue, axis, voltages, prices),
              axis,
              voltages.size(),
              rack_speed_edges(axis, tables_[pinion_slot], reduction_));
  reduction_.add_to(tables_);
  for (SlotTable& table : tables_) table.multiply(drives_);
  finish_slots();
  if (!acceleration_time_.fixed())
    variables_.push_back({"acceleration_time", acceleration_time_.lower, acceleration_time_.upper});
  machine::rack_drive_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&&) {
    constraint_count_ += machine::is_searched(d, axis.require);
  });
}

template <class T>
RackDrive<T> RackDriveStage::design(const Selection<T>& s) const {
  RackDrive<T> d;
  d.data = &data_;
  const auto read = [&](std::size_t slot, std::size_t field) {
    return tables_[slot].template read<T>(s.rows[slot], field);
  };
  std::size_t field = 0;
  visit_rack_reading(d.rack, [&](T& x) { x = read(rack_slot, field++); });
  field = 0;
  visit_pinion_reading(d.pinion, [&](T& x) { x = read(pinion_slot, field++); });
  const std::size_t voltage = s.shared.empty() ? 0 : s.shared.front();
  d.motor = motors_->template reading<T>(s.rows[motor_slot], voltage);
  d.motor_shaft = motors_->template shaft<T>(s.rows[motor_slot]);
  d.motor_mass = motors_->template mass<T>(s.rows[motor_slot]);
  d.reduction = reduction_.reading<T>(s.rows);
  d.available_torque = [this, rows = s.rows[motor_slot], voltage](const T& omega) {
    return motors_->template torque<T>(rows, voltage, omega);
  };
  d.carried_mass = s.inherited[place_.load_state];
  if (load_share_ != 1.0) d.carried_mass = load_share_ * d.carried_mass;
  d.acceleration_time = variables_.empty() ? T(acceleration_time_.lower) : s.variables[0];
  d.derive();
  return d;
}

template <class T>
void RackDriveStage::answer(const Selection<T>& s, solver::Answer<T>& out) const {
  const RackDrive<T> d = design(s);
  machine::rack_drive_constraints(UtilisationVisitor<T, RackDrive<T>>(d, s.kept, out.utilisation));
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

bool RackDriveStage::fits(
    std::span<const solver::Row>, std::size_t slot_a, solver::Row row_a, std::size_t slot_b, solver::Row row_b) const {
  if (slot_a > slot_b) return fits({}, slot_b, row_b, slot_a, row_a);
  const SlotTable& pinions = tables_[pinion_slot];
  if (slot_a == rack_slot && slot_b == pinion_slot)
    return same(tables_[rack_slot].reading(row_a, rack_module), pinions.reading(row_b, pinion_module)) &&
           same(tables_[rack_slot].reading(row_a, rack_angle), pinions.reading(row_b, pinion_angle));
  if (slot_a == pinion_slot && reduction_.is(slot_b))
    return same(pinions.reading(row_a, pinion_bore), reduction_.shaft(row_b));
  if (slot_a == pinion_slot && slot_b == motor_slot && !reduction_.slot())
    return same(pinions.reading(row_a, pinion_bore), motors_->pairs()[row_b].shaft);
  return true;
}

solver::FitKey RackDriveStage::fit_key(std::span<const solver::Row>,
                                       std::size_t slot,
                                       solver::Row row,
                                       std::size_t other) const {
  const SlotTable& table = tables_[slot];
  if (slot == rack_slot) return {table.reading(row, rack_module), table.reading(row, rack_angle)};
  if (slot == pinion_slot && other == rack_slot)
    return {table.reading(row, pinion_module), table.reading(row, pinion_angle)};
  if (slot == pinion_slot) return {table.reading(row, pinion_bore), 0.0};
  return {reduction_.is(slot) ? reduction_.shaft(row) : motors_->pairs()[row].shaft, 0.0};
}

template RackDrive<double> RackDriveStage::design(const Selection<double>&) const;

template class ElementStage<RackDriveStage>;

}  // namespace millwright::evaluation
