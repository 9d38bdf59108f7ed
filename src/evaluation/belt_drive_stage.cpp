// SPDX-License-Identifier: Apache-2.0
#include "evaluation/belt_drive_stage.h"

#include <cmath>
#include <map>

namespace millwright::evaluation {

using machine::BeltDrive;

namespace {

std::vector<double> belt_speed_edges(const machine::Axis& axis,
                                     const SlotTable& belts,
                                     const ReductionSlot& reduction) {
  double smallest = scalar::rounding::infinity, largest = 0.0;
  for (std::size_t row = 0; row < belts.rows(); ++row) {
    const double radius = 0.5 * belts.reading(row, BeltTables::pitch_diameter);
    smallest = std::min(smallest, radius);
    largest = std::max(largest, radius);
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
  belts_ = belt_tables(catalogue, axis, prices);
  tables_.push_back(std::move(belts_.belts));
  tables_.push_back(std::move(belts_.pulleys));
  tables_.push_back(std::move(belts_.idlers));
  take_motors(motor_table(catalogue, axis, voltages, prices),
              axis,
              voltages.size(),
              belt_speed_edges(axis, tables_.front(), reduction_));
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
  const auto read = [&](std::size_t slot, std::size_t field) {
    return tables_[slot].template read<T>(s.rows[slot], field);
  };
  using B = BeltTables;
  d.belt.mass_per_length = read(belt_slot, B::mass_per_length);
  d.belt.allowable_tension = read(belt_slot, B::allowable_tension);
  d.belt.specific_stiffness = read(belt_slot, B::specific_stiffness);
  d.belt.least_teeth = read(belt_slot, B::least_teeth);
  d.belt.largest_speed = read(belt_slot, B::largest_speed);
  d.belt.belt_length = read(belt_slot, B::belt_length);
  d.belt.belt_mass = read(belt_slot, B::belt_mass);
  d.belt.span = read(belt_slot, B::span);
  d.belt.teeth = read(belt_slot, B::teeth);
  d.belt.pitch_diameter = read(belt_slot, B::pitch_diameter);
  d.belt.idler_diameter = read(belt_slot, B::idler_diameter);
  d.belt.width = read(belt_slot, B::width);
  d.belt.pulley_inertia = read(pulley_slot, B::pulley_inertia);
  d.belt.bore = read(pulley_slot, B::bore);
  // One of the two is nothing.
  d.belt.idler_inertia = read(pulley_slot, B::second_inertia) + read(idler_slot, B::idler_inertia);
  const scalar::Interval kinds = belts_.kinds(s.rows[belt_slot], s.rows[pulley_slot], s.rows[idler_slot]);
  if constexpr (std::is_constructible_v<T, scalar::Interval>)
    d.belt.kinds = T(kinds);
  else
    d.belt.kinds = T(kinds.upper);
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
  if (slot_a == belt_slot && slot_b == pulley_slot) return belts_.runs(row_a, row_b);
  if (slot_a == belt_slot && slot_b == idler_slot) return belts_.turns(row_a, row_b);
  if (slot_a != pulley_slot) return true;
  if (slot_b == idler_slot) return belts_.goes_with(row_a, row_b);
  const auto bore_is = [&](double shaft) {
    return std::abs(tables_[pulley_slot].reading(row_a, BeltTables::bore) - shaft) < 1e-6;
  };
  if (reduction_.is(slot_b)) return bore_is(reduction_.shaft(row_b));
  return reduction_.slot().has_value() || bore_is(motors_->pairs()[row_b].shaft);
}

solver::FitKey BeltDriveStage::fit_key(std::span<const solver::Row>,
                                       std::size_t slot,
                                       solver::Row row,
                                       std::size_t other) const {
  // No number below nothing: those stand for versions that differ (scenario_problem.cpp).
  const auto key = [](std::int32_t first, std::int32_t second) {
    return solver::FitKey{static_cast<double>(first - BeltFit::same), static_cast<double>(second - BeltFit::same)};
  };
  if (slot == belt_slot) return key(belts_.belt_fits[row].drive, belts_.belt_fits[row].idler);
  if (slot == idler_slot) return key(belts_.idlers_fit[row], 0);
  if (slot == pulley_slot) {
    const BeltFit& fit = belts_.pulley_fits[row];
    if (other == belt_slot) return key(fit.drive, fit.idler);
    if (other == idler_slot) return key(fit.idler, 0);
    return {tables_[pulley_slot].reading(row, BeltTables::bore), 0.0};
  }
  return {reduction_.is(slot) ? reduction_.shaft(row) : motors_->pairs()[row].shaft, 0.0};
}

std::optional<std::size_t> BeltDriveStage::own_row_kind(std::size_t slot, solver::Row row) const {
  const BeltFit fit = slot == belt_slot     ? belts_.belt_fits[row]
                      : slot == pulley_slot ? belts_.pulley_fits[row]
                                            : BeltFit{BeltFit::none, belts_.idlers_fit[row]};
  const auto number = [](std::int32_t size) { return static_cast<std::size_t>(size - BeltFit::same); };
  return (number(fit.drive) << 32U) + number(fit.idler);
}

bool BeltDriveStage::may_misfit(std::size_t slot_a, std::size_t slot_b) const {
  return std::min(slot_a, slot_b) <= pulley_slot &&
         (std::max(slot_a, slot_b) <= idler_slot || std::min(slot_a, slot_b) == pulley_slot);
}

double BeltDriveStage::combinations(std::span<const std::vector<solver::Row>> rows) const {
  std::map<std::pair<std::int32_t, bool>, double> pulleys;
  std::map<std::int32_t, double> idlers;
  for (const solver::Row row : rows[pulley_slot])
    pulleys[{belts_.pulley_fits[row].drive, belts_.brings_idler(row)}] += 1.0;
  for (const solver::Row row : rows[idler_slot]) idlers[belts_.idlers_fit[row]] += 1.0;
  double count = 0.0;
  for (const solver::Row row : rows[belt_slot]) {
    const BeltFit& fit = belts_.belt_fits[row];
    count += pulleys[{fit.drive, belts_.has_same(row)}] * idlers[fit.idler];
  }
  for (std::size_t slot = motor_slot; slot < rows.size(); ++slot) count *= static_cast<double>(rows[slot].size());
  return count;
}

template BeltDrive<double> BeltDriveStage::design(const Selection<double>&) const;

template class ElementStage<BeltDriveStage>;

}  // namespace millwright::evaluation
