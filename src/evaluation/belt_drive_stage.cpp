// SPDX-License-Identifier: Apache-2.0
#include "evaluation/belt_drive_stage.h"

#include <cmath>

namespace millwright::evaluation {

using machine::BeltDrive;

namespace {
constexpr std::size_t pitch_diameter_field = 9;
constexpr std::size_t bore_field = 13;

std::vector<double> belt_speed_edges(const machine::Axis& axis,
                                     const SlotTable& belts,
                                     const ReductionSlot& reduction) {
  double smallest = scalar::rounding::infinity, largest = 0.0;
  for (std::size_t row = 0; row < belts.rows(); ++row) {
    smallest = std::min(smallest, 0.5 * belts.reading(row, pitch_diameter_field));
    largest = std::max(largest, 0.5 * belts.reading(row, pitch_diameter_field));
  }
  if (belts.rows() == 0) return {0.0, 1.0};
  const auto [slow, fast] = constant_speed_range(axis);
  return log_spaced(0.999 * slow / largest * reduction.least_ratio(),
                    1.001 * fast / smallest * reduction.largest_ratio());
}
}  // namespace

BeltDriveStage::BeltDriveStage(const machine::Axis& axis,
                               AxisPlace place,
                               const std::vector<double>& voltages,
                               const catalogue::Catalogue& catalogue,
                               const PriceBook& prices)
    : DriveStage(axis, place, prices), data_(geared_drive_data(axis)) {
  name_ = axis.name + ".drive";
  tables_.push_back(belt_table(catalogue, axis, prices));
  motors_ = std::make_unique<MotorSet>(motor_table(catalogue, axis, voltages, prices),
                                       axis.require,
                                       voltages.size(),
                                       belt_speed_edges(axis, tables_.front(), reduction_));
  tables_.push_back(motors_->motors().table);
  reduction_.add_to(tables_);
  for (SlotTable& table : tables_) table.multiply(drives_);
  finish_slots();
  if (!acceleration_time_.fixed())
    variables_.push_back({"acceleration_time", acceleration_time_.lower, acceleration_time_.upper});
  machine::belt_drive_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&&) {
    constraint_count_ += machine::is_searched(d, axis.require);
  });
}

template <class T>
BeltDrive<T> BeltDriveStage::design(const Selection<T>& s) const {
  BeltDrive<T> d;
  d.data = &data_;
  std::size_t field = 0;
  visit_belt_reading(d.belt, [&](T& x) {
    x = tables_[belt_slot].template read<T>(s.rows[belt_slot], field);
    ++field;
  });
  const std::size_t voltage = s.shared.empty() ? 0 : s.shared.front();
  d.motor = motors_->template reading<T>(s.rows[motor_slot], voltage);
  d.motor_shaft = motors_->template shaft<T>(s.rows[motor_slot]);
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
void BeltDriveStage::answer(const Selection<T>& s, solver::Answer<T>& out) const {
  const BeltDrive<T> d = design(s);
  machine::belt_drive_constraints(UtilisationVisitor<T, BeltDrive<T>>(d, s.kept, out.utilisation));
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

bool BeltDriveStage::fits(
    std::span<const solver::Row>, std::size_t slot_a, solver::Row row_a, std::size_t slot_b, solver::Row row_b) const {
  if (slot_a > slot_b) return fits({}, slot_b, row_b, slot_a, row_a);
  const auto bore_is = [&](double shaft) {
    return std::abs(tables_[belt_slot].reading(row_a, bore_field) - shaft) < 1e-6;
  };
  if (slot_a != belt_slot) return true;
  if (reduction_.is(slot_b)) return bore_is(reduction_.shaft(row_b));
  return reduction_.slot().has_value() || bore_is(motors_->motors().pairs[row_b].shaft);
}

solver::FitKey BeltDriveStage::fit_key(std::span<const solver::Row>,
                                       std::size_t slot,
                                       solver::Row row,
                                       std::size_t) const {
  if (slot == belt_slot) return {tables_[belt_slot].reading(row, bore_field), 0.0};
  return {reduction_.is(slot) ? reduction_.shaft(row) : motors_->motors().pairs[row].shaft, 0.0};
}

template BeltDrive<double> BeltDriveStage::design(const Selection<double>&) const;

template class ElementStage<BeltDriveStage>;

}  // namespace millwright::evaluation
