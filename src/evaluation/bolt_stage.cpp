// SPDX-License-Identifier: Apache-2.0
#include "evaluation/bolt_stage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "evaluation/figure_reader.h"
#include "evaluation/screw_drive_stage.h"
#include "machine/word_column.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;
using machine::BoltedJoint;
using scalar::Interval;

namespace {

/// A socket head cap screw with a shank of 3 d, as it is priced: head 1.5 d wide and d high (ISO 4762), steel.
double screw_mass(double diameter) {
  constexpr double pi = 3.14159265358979323846, steel = 7850.0;  // kg/m^3
  constexpr double shank = 3.0, head = 1.5 * 1.5;                // in d^3 pi/4
  return steel * 0.25 * pi * diameter * diameter * diameter * (shank + head);
}

}  // namespace

BoltStage::BoltStage(const machine::Axis& axis,
                     const machine::Member& member,
                     AxisPlace place,
                     bool is_last,
                     const catalogue::Catalogue& catalogue,
                     const PriceBook& prices)
    : data_{.member = member,
            .require = axis.require,
            .riding_mass = member.rides ? 0.0 : machine::riding_mass_allowance(axis),
            .climbing_acceleration = place.lifting_acceleration + machine::climbing_acceleration(motion_of(axis))},
      place_(place),
      is_last_(is_last) {
  name_ = axis.name + "." + member.name;
  SlotTable table(member.name, machine::bolt_reading_fields);
  const catalogue::Table& t = catalogue.table(Family::screws);
  const machine::BoltPattern& pattern = member.bolts;
  const double pieces = member.count * pattern.count();
  for (const int row : t.rows_in_order()) {
    std::vector<catalogue::Column> missing;
    const FigureReader number(t, row, missing);
    if (!machine::word_columns::screw_size.takes(pattern.sizes, t, row) ||
        !machine::word_columns::property_class.takes(pattern.property_classes, t, row))
      continue;
    const auto readings_of = [&](auto figure) {
      using T = decltype(figure("proof_strength"));
      return std::array<T, machine::bolt_reading_fields>{figure("nominal_diameter"),
                                                         figure("tensile_stress_area"),
                                                         figure("proof_strength"),
                                                         pattern.fitted ? figure("yield_strength") : T(0.0)};
    };
    const std::array<double, machine::bolt_reading_fields> readings = readings_of(number);
    CandidateDraft candidate = candidate_of({{member.name,
                                              Family::screws,
                                              row,
                                              pieces,
                                              0.0,
                                              prices.line(t, row, pieces, 0.0),
                                              pieces * screw_mass(readings[0])}},
                                            0.0);
    if (t.has_ranges())  // the size of a screw is exact, and with it its mass
      candidate.ranges =
          candidate_ranges(readings_of([&](const char* name) { return t.range(column(Family::screws, name), row); }),
                           candidate.price,
                           {},
                           candidate.mass);
    if (!table.admits(candidate, readings, missing)) continue;
    table.add(std::move(candidate), readings);
  }
  tables_.push_back(std::move(table));
  finish_slots();
  machine::bolted_joint_constraints([&](const machine::Declaration& d, auto&&, auto&&, auto&&) {
    constraint_count_ += machine::is_searched(d, axis.require);
  });
}

template <class T>
BoltedJoint<T> BoltStage::joint_of(const RowsAlive& screws) const {
  BoltedJoint<T> d;
  d.data = &data_;
  std::size_t field = 0;
  visit_bolt_reading(d.bolt, [&](T& x) {
    x = tables_[0].template read<T>(screws, field);
    ++field;
  });
  return d;
}

bool BoltStage::all_bear(double force, double torque) const {
  for (solver::Row row = 0; row < tables_[0].rows(); ++row) {
    BoltedJoint<Interval> d = joint_of<Interval>(RowsAlive(std::span(&row, 1)));
    d.held_force = Interval(force);
    d.held_torque = Interval(torque);
    d.derive();
    std::vector<Interval> used(constraint_count_);
    machine::bolted_joint_constraints(UtilisationVisitor<Interval, BoltedJoint<Interval>>(d, 0, used));
    if (!std::all_of(used.begin(), used.end(), [](const Interval& each) { return each.upper <= 1.0; })) return false;
  }
  return true;
}

double BoltStage::harmless_force(double torque) const {
  // More force and more torque only load a joint more: what bears both bears anything below.
  constexpr double least = 1.0, most = 1e6, steps = 60.0;
  if (!all_bear(least, torque)) return 0.0;
  double borne = least, refused = most;
  for (double step = 0.0; step < steps; step += 1.0) {
    const double middle = std::sqrt(borne * refused);
    (all_bear(middle, torque) ? borne : refused) = middle;
  }
  return borne;
}

template <class T>
BoltedJoint<T> BoltStage::design(const Selection<T>& s) const {
  BoltedJoint<T> d = joint_of<T>(s.rows[0]);
  d.carried_mass = s.inherited[place_.load_state];
  if (data_.member.bolts.holds == machine::Held::carriage) d.held_force = s.inherited[*place_.carriage_state];
  if (data_.member.bolts.holds == machine::Held::motor) {
    d.held_force = s.inherited[*place_.motor_force_state];
    d.held_torque = s.inherited[*place_.motor_torque_state];
  }
  d.derive();
  return d;
}

template <class T>
void BoltStage::answer(const Selection<T>& s, solver::Answer<T>& out) const {
  const BoltedJoint<T> d = design(s);
  machine::bolted_joint_constraints(UtilisationVisitor<T, BoltedJoint<T>>(d, s.kept, out.utilisation));
  const T mass = total<T>(s, Total::mass);
  out.resources[cost_resource] = total<T>(s, Total::price);
  out.resources[mass_resource] = mass;
  if (data_.member.rides)
    out.handed_on[place_.load_state] = d.carried_mass + mass;
  else if (place_.parent_load_state)
    out.handed_on[*place_.parent_load_state] = s.inherited[*place_.parent_load_state] + mass;
  if (!is_last_) return;
  // Nobody else asks: builds that differ only in that are one from here on.
  if (data_.member.bolts.holds == machine::Held::carriage) out.handed_on[*place_.carriage_state] = T(0.0);
  if (data_.member.bolts.holds == machine::Held::motor)
    out.handed_on[*place_.motor_force_state] = out.handed_on[*place_.motor_torque_state] = T(0.0);
}

template BoltedJoint<double> BoltStage::design(const Selection<double>&) const;

template class ElementStage<BoltStage>;

}  // namespace millwright::evaluation
