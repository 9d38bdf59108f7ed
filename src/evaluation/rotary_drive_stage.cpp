// SPDX-License-Identifier: Apache-2.0
#include "evaluation/rotary_drive_stage.h"

namespace millwright::evaluation {

using machine::RotaryDrive;

RotaryDriveStage::RotaryDriveStage(const machine::Axis& axis,
                                   AxisPlace place,
                                   const std::vector<double>& voltages,
                                   const catalogue::Catalogue& catalogue,
                                   const PriceBook& prices)
    : DriveStage(axis, place, prices), data_(geared_drive_data(axis)), inertia_(axis.inertia) {
  name_ = axis.name + ".drive";
  const auto [slow, fast] = constant_speed_range(axis);
  take_motors(motor_table(catalogue, axis, voltages, prices),
              axis,
              voltages.size(),
              log_spaced(0.999 * slow * reduction_.least_ratio(), 1.001 * fast * reduction_.largest_ratio()));
  reduction_.add_to(tables_);
  finish_slots();
  if (!acceleration_time_.fixed())
    variables_.push_back({"acceleration_time", acceleration_time_.lower, acceleration_time_.upper});
  machine::rotary_drive_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&&) {
    constraint_count_ += machine::is_searched(d, axis.require);
  });
}

template <class T>
RotaryDrive<T> RotaryDriveStage::design(const Selection<T>& s) const {
  RotaryDrive<T> d;
  d.data = &data_;
  const std::size_t voltage = s.shared.empty() ? 0 : s.shared.front();
  d.motor = motors_->template reading<T>(s.rows[motor_slot], voltage);
  d.available_torque = [this, rows = s.rows[motor_slot], voltage](const T& omega) {
    return motors_->template torque<T>(rows, voltage, omega);
  };
  d.reduction = reduction_.reading<T>(s.rows);
  d.table_inertia = T(inertia_);
  d.acceleration_time = variables_.empty() ? T(acceleration_time_.lower) : s.variables[0];
  d.derive();
  return d;
}

template <class T>
void RotaryDriveStage::answer(const Selection<T>& s, solver::Answer<T>& out) const {
  const RotaryDrive<T> d = design(s);
  machine::rotary_drive_constraints(UtilisationVisitor<T, RotaryDrive<T>>(d, s.kept, out.utilisation));
  out.resources[cost_resource] = total<T>(s, Total::price);
  out.resources[mass_resource] = total<T>(s, Total::mass);
  count_cycle(place_, d, 1.0, out);
  out.handed_on[power_state] = s.inherited[power_state] + d.input_power;
  hand_on_flange(d, s, out);
  out.handed_on[place_.load_state] = T(0.0);
  if (place_.parent_load_state)
    out.handed_on[*place_.parent_load_state] =
        s.inherited[*place_.parent_load_state] + s.inherited[place_.load_state] + total<T>(s, Total::burden);
}

template RotaryDrive<double> RotaryDriveStage::design(const Selection<double>&) const;

template class ElementStage<RotaryDriveStage>;

}  // namespace millwright::evaluation
