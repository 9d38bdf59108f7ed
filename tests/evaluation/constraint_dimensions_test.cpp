// SPDX-License-Identifier: Apache-2.0
// Demand and capacity of every constraint are quantities of one kind, that of the unit in which they are shown: proved
// by running the declarations on numbers that know their dimension.
#include <set>

#include "catch.h"
#include "evaluation/declared_constraints.h"
#include "scalar/unit.h"

namespace constraint_dimensions_test {

using namespace millwright;
using scalar::Dimension;
using scalar::Dimensioned;
namespace dimension = scalar::dimension;
using machine::Requirement;

namespace {

Dimensioned length(double v) { return {v, dimension::length}; }
Dimensioned mass(double v) { return {v, dimension::mass}; }
Dimensioned torque(double v) { return {v, dimension::torque}; }
Dimensioned force(double v) { return {v, dimension::force}; }
Dimensioned pressure(double v) { return {v, dimension::pressure}; }
Dimensioned inertia(double v) { return {v, dimension::inertia}; }
Dimensioned speed(double v) { return {v, dimension::speed}; }
Dimensioned time(double v) { return {v, dimension::time}; }
Dimensioned rate(double v) { return {v, dimension::angular_speed}; }
Dimensioned stiffness(double v) { return {v, dimension::stiffness}; }
Dimensioned ampere(double v) { return {v, dimension::current}; }
Dimensioned volt(double v) { return {v, dimension::voltage}; }

/// Checks the dimensions and remembers what was looked at.
template <class Element>
class DimensionVisitor {
 public:
  DimensionVisitor(const Element& element, std::set<std::string>& seen) : element_(element), seen_(seen) {}
  template <class When, class Demand, class Capacity>
  void operator()(const machine::Declaration& declaration, When when, Demand demand, Capacity capacity) {
    if (when(element_) != machine::Applies::yes) return;
    INFO(declaration.id << " in " << declaration.unit);
    const Dimensioned asked = demand(element_);
    const Dimensioned given = capacity(element_);
    const Dimension shown = scalar::Unit::of(declaration.unit).dimension();
    CHECK((asked.zero_literal || asked.dimension == shown));
    CHECK((given.zero_literal || given.dimension == shown));
    CHECK_FALSE((asked.zero_literal && given.zero_literal));
    CHECK(std::isfinite(asked.value));
    CHECK(std::isfinite(given.value));
    seen_.insert(std::string(declaration.id));
  }

 private:
  const Element& element_;
  std::set<std::string>& seen_;
};

machine::MotionData motion(bool vertical) {
  machine::Move move;
  move.distance = 0.3;
  move.time = 2.0;
  move.force = 40.0;
  move.dwell = 0.5;
  move.cutting = machine::CuttingProcess{.material = {},
                                         .unit_specific_force = 700e6,
                                         .depth = 2e-3,
                                         .width = 2e-3,
                                         .feed_per_tooth = 5e-5,
                                         .diameter = 6e-3,
                                         .cutting_speed = 3.0,
                                         .spindle_power = 500.0};
  machine::MotionData data{.moves = {move}, .inclination = vertical ? std::acos(0.0) : 0.0};
  data.guide_friction = 0.05;
  data.guide_drag = 3.0;
  return data;
}

machine::Requirements with_accuracy() {
  machine::Requirements require;
  require.set(Requirement::position_error, 1e-4);
  require.set(Requirement::lost_motion, 5e-5);
  require.set(Requirement::efficiency, 0.3);
  require.set(Requirement::axial_stiffness, 2e7);
  require.set(Requirement::output_power_factor, 1.0);
  require.set(Requirement::motor_radial_load, 75.0);
  require.set(Requirement::start_rate, 100.0);
  return require;
}

machine::ScrewReading<Dimensioned> screw(machine::ScrewKind kind) {
  machine::ScrewFigures<Dimensioned> f;
  f.nominal_diameter = length(0.016);
  f.mean_diameter = length(0.014);
  f.ball_circle_diameter = length(0.0165);
  f.root_diameter = length(0.012);
  f.nut_thread_diameter = length(0.016);
  f.pitch = f.lead = length(0.004);
  f.flank_angle = Dimensioned(0.26);
  f.thread_depth = length(0.002);
  f.friction = Dimensioned(0.1);
  f.wear_rate = {1e-15, dimension::area / dimension::force};
  f.yield_strength = pressure(345e6);
  f.nut_yield_strength = pressure(150e6);
  f.mass_per_length = {1.2, dimension::mass_per_length};
  f.nut_mass = mass(0.2);
  f.nut_length = length(0.03);
  f.lead_error_300 = length(5e-5);
  f.backlash = length(2e-5);
  f.drag_torque = torque(0.02);
  f.allowable_pressure = pressure(10e6);
  f.pv_limit = {2e6, dimension::pressure * dimension::speed};
  f.sliding_speed_limit = speed(0.5);
  f.dynamic_rating = force(8000.0);
  f.static_rating = force(12000.0);
  f.nut_stiffness = stiffness(2e8);
  f.speed_value_limit = {5.2, dimension::speed};
  f.largest_length = length(1.5);
  f.elastic_modulus = pressure(206e9);
  f.shear_modulus = pressure(79e9);
  f.density = {7850.0, dimension::density};
  return machine::screw_reading(f,
                                {.kind = kind,
                                 .stroke = 0.3,
                                 .overtravel = 0.01,
                                 .end_allowance = 0.08,
                                 .preload_fraction = kind == machine::ScrewKind::ball ? 0.05 : 0.0});
}

machine::MotorReading<Dimensioned> motor() {
  machine::MotorFigures<Dimensioned> f;
  f.holding_torque = torque(1.2);
  f.detent_torque = torque(0.04);
  f.rated_current = ampere(3.0);
  f.resistance = {0.8, dimension::resistance};
  f.inductance = {2.5e-3, dimension::inductance};
  f.rotor_inertia = inertia(3e-5);
  f.rotor_teeth = Dimensioned(50.0);
  f.driver_peak_current = ampere(4.2);
  f.driver_largest_voltage = volt(50.0);
  f.driver_least_voltage = volt(18.0);
  f.voltage = volt(36.0);
  f.asked_current = ampere(3.0);
  CHECK(machine::modelled_torque(f, ampere(3.0), rate(60.0)).dimension == dimension::torque);
  return machine::motor_reading(f, Dimensioned(0.5));
}

machine::DriveReduction<Dimensioned> reduction() {
  machine::DriveReduction<Dimensioned> r;
  r.present = true;
  r.torque_is_rated = r.speed_is_rated = machine::Applies::yes;
  r.ratio = Dimensioned(4.0);
  r.efficiency = Dimensioned(0.9);
  r.inertia = inertia(2e-6);
  r.backlash = Dimensioned(2e-3);
  r.compliance = {1e-3, dimension::none / dimension::torque};
  r.rated_torque = torque(12.0);
  r.largest_speed = rate(300.0);
  r.shaft = length(0.014);
  r.mass = mass(0.5);
  return r;
}

/// What objectives count of a drive.
template <class Drive>
void check_objectives(const Drive& d) {
  CHECK(machine::cycle_energy(d).dimension == dimension::energy);
  for (const machine::Timed timed : {machine::Timed::axis, machine::Timed::machine})
    CHECK(machine::moving_time(d.data->motion, d.acceleration_time, timed).dimension == dimension::time);
}

void check_screw_drive(
    machine::ScrewKind kind, bool vertical, bool geared, bool nut_rotates, std::set<std::string>& seen) {
  const machine::ScrewDriveData data{.motion = motion(vertical),
                                     .require = with_accuracy(),
                                     .stroke = 0.3,
                                     .microsteps = vertical ? 2.0 : 16.0,
                                     .vertical = vertical,
                                     .both_ends_fixed = vertical,
                                     .preloaded = kind == machine::ScrewKind::ball,
                                     .preload_fraction = 0.05,
                                     .has_coupling = !nut_rotates,
                                     .nut_rotates = nut_rotates,
                                     .nut_inertia = 2e-5};
  machine::ScrewDrive<Dimensioned> d;
  d.data = &data;
  d.motor_mass = mass(1.2);
  if (geared) d.reduction = reduction();
  d.kind = kind;
  d.screw = screw(kind);
  d.motor = motor();
  d.coupling = {inertia(1e-6),
                torque(5.0),
                torque(60.0),
                rate(600.0),
                length(0.005),
                length(0.012),
                length(2e-4),
                Dimensioned(0.02),
                length(3e-4)};
  d.support_fixed = {length(0.008), force(1000.0), stiffness(1e8), rate(400.0), Dimensioned(0.0)};
  d.support_free = d.support_fixed;
  d.motor_shaft = length(0.008);
  d.available_torque = [](const Dimensioned& omega) {
    CHECK(omega.dimension == dimension::angular_speed);
    return torque(0.8);
  };
  d.carried_mass = mass(20.0);
  d.acceleration_time = time(0.2);
  d.derive();
  CHECK(d.input_power.dimension == dimension::power_output);
  check_objectives(d);
  CHECK(d.moved_mass.dimension == dimension::mass);
  machine::screw_drive_constraints(DimensionVisitor(d, seen));
}

void check_belt_drive(bool vertical, bool geared, std::set<std::string>& seen) {
  const machine::GearedDriveData data{
      .motion = motion(vertical), .require = with_accuracy(), .stroke = 0.3, .microsteps = 2.0, .vertical = vertical};
  machine::BeltDrive<Dimensioned> d;
  d.data = &data;
  if (geared) d.reduction = reduction();
  d.belt = {{0.02, dimension::mass_per_length},
            force(200.0),
            force(25000.0),
            Dimensioned(14.0),
            speed(20.0),
            length(0.8),
            mass(0.016),
            length(0.35),
            Dimensioned(20.0),
            length(0.0127),
            inertia(2e-6),
            inertia(2e-6),
            length(0.0127),
            length(0.005),
            length(0.009)};
  d.motor = motor();
  d.motor_shaft = length(0.005);
  d.available_torque = [](const Dimensioned&) { return torque(0.8); };
  d.carried_mass = mass(2.0);
  d.acceleration_time = time(0.1);
  d.derive();
  CHECK(d.input_power.dimension == dimension::power_output);
  check_objectives(d);
  machine::belt_drive_constraints(DimensionVisitor(d, seen));
}

void check_rack_drive(bool vertical, bool geared, bool rides, std::set<std::string>& seen) {
  machine::GearedDriveData data{.motion = motion(vertical),
                                .require = with_accuracy(),
                                .stroke = 0.3,
                                .microsteps = vertical ? 2.0 : 16.0,
                                .efficiency = 0.95,
                                .backlash = 1e-4,
                                .vertical = vertical,
                                .motor_rides = rides};
  machine::RackDrive<Dimensioned> d;
  d.data = &data;
  if (geared) d.reduction = reduction();
  d.rack = {length(0.0015), Dimensioned(0.35), length(0.015), pressure(1e8), Dimensioned(1e-4), mass(1.5)};
  d.pinion = {length(0.0015),
              Dimensioned(0.35),
              Dimensioned(20.0),
              length(0.012),
              length(0.008),
              pressure(1.2e8),
              mass(0.1),
              inertia(1e-5)};
  d.motor = motor();
  d.motor_shaft = length(0.008);
  d.motor_mass = mass(1.2);
  d.available_torque = [](const Dimensioned& omega) {
    CHECK(omega.dimension == dimension::angular_speed);
    return torque(0.8);
  };
  d.carried_mass = mass(6.0);
  d.acceleration_time = time(0.1);
  d.derive();
  CHECK(d.input_power.dimension == dimension::power_output);
  check_objectives(d);
  CHECK(d.moved_mass.dimension == dimension::mass);
  machine::rack_drive_constraints(DimensionVisitor(d, seen));
}

void check_rotary_drive(bool geared, std::set<std::string>& seen) {
  machine::GearedDriveData data{.motion = motion(false), .require = {}, .stroke = 6.0};
  data.motion.rotary = true;
  data.motion.guide_friction = 0.0;
  data.require.set(Requirement::angle_error, 1e-3);
  data.require.set(Requirement::lost_angle, 1e-3);
  data.require.set(Requirement::output_power_factor, 1.0);
  data.require.set(Requirement::start_rate, 100.0);
  data.microsteps = geared ? 2.0 : 16.0;
  // No constraint of a table without drop weight is left out but C-ST-BACK, which needs a vertical axis.
  data.vertical = geared;
  machine::RotaryDrive<Dimensioned> d;
  d.data = &data;
  if (geared) d.reduction = reduction();
  d.motor = motor();
  d.available_torque = [](const Dimensioned& omega) {
    CHECK(omega.dimension == dimension::angular_speed);
    return torque(0.8);
  };
  d.table_inertia = inertia(0.02);
  d.acceleration_time = time(0.1);
  d.derive();
  CHECK(d.input_power.dimension == dimension::power_output);
  check_objectives(d);
  CHECK(d.cycle.travelled.dimension == dimension::angular);
  machine::rotary_drive_constraints(DimensionVisitor(d, seen));
}

void check_guide(double carriages, bool vertical, std::set<std::string>& seen) {
  machine::GuideData data{.choice = {}, .motion = motion(vertical), .require = {}};
  data.choice.carriages = carriages;
  data.choice.carriage_spacing = 0.1;
  data.choice.rail_spacing = 0.2;
  data.choice.load_offset_x = 0.02;
  data.choice.load_offset_y = 0.03;
  data.choice.force_height = 0.05;
  data.choice.drive_offset = 0.04;
  machine::GuideSystem<Dimensioned> d;
  d.data = &data;
  d.guide.dynamic_rating = force(8000.0);
  d.guide.static_rating = force(12000.0);
  d.guide.rating_distance = length(5e4);
  d.guide.roll_moment_rating = d.guide.pitch_moment_rating = d.guide.yaw_moment_rating = torque(90.0);
  d.guide.carriage_mass = mass(1.0);
  d.guide.rail_mass = mass(3.0);
  d.guide.rail_length = length(0.6);
  d.guide.largest_rail_length = length(2.0);
  d.guide.shaft_diameter = length(0.016);
  d.guide.friction = Dimensioned(0.003);
  d.unsupported_shaft = d.bushings = machine::Applies::yes;
  d.carried_mass = mass(20.0);
  d.acceleration_time = time(0.1);
  d.derive();
  machine::guide_constraints(DimensionVisitor(d, seen));
}

void check_member(
    machine::MemberKind kind, machine::BeamSupport support, bool guide, bool steel, std::set<std::string>& seen) {
  machine::MemberData data;
  data.member.kind = kind;
  data.member.support = support;
  data.member.length = 0.5;
  data.member.lateral_force = 20.0;
  data.member.is_guide = guide;
  data.member.lever_arm = 0.1;
  data.member.joint_width = data.member.joint_depth = 0.04;
  data.member.torque = 5.0;
  data.member.rotating = kind == machine::MemberKind::round_shaft;
  data.member.plate_width = 0.3;
  data.member.column_height = 0.4;
  data.elastic_modulus = 206e9;
  data.yield_strength = 235e6;
  data.density = 7850.0;
  data.shear_modulus = 80e9;
  data.ultimate_strength = 360e6;
  data.endurance_limit = steel ? 0.0 : 120e6;
  data.acceleration = 2.0;
  data.require.set(Requirement::frame_twist, 0.01);
  if (steel) data.require.set(Requirement::frame_natural_frequency, 30.0);
  if (!steel) data.require.set(Requirement::ringing_amplitude, 1e-5);
  machine::StructureMember<Dimensioned> d;
  d.data = &data;
  d.section = {{1e-3, dimension::area},
               {1e-7, dimension::second_moment_of_area},
               {5e-8, dimension::second_moment_of_area},
               {4e-8, dimension::second_moment_of_area},
               {3e-6, dimension::area * dimension::length},
               {2e-6, dimension::area * dimension::length},
               length(0.06),
               length(0.03),
               {8.0, dimension::mass_per_length},
               {206e9, dimension::pressure},
               {235e6, dimension::pressure},
               length(0.02),
               {2e-8, dimension::second_moment_of_area},
               {80e9, dimension::pressure}};
  d.carried_mass = mass(20.0);
  d.diameter = length(0.02);
  d.width = length(0.02);
  d.height = length(0.03);
  d.leg = length(0.005);
  d.thickness = length(0.012);
  d.derive();
  CHECK(d.mass.dimension == dimension::mass);
  machine::member_constraints(DimensionVisitor(d, seen));
}

void check_bolts(bool fitted, bool eccentric, machine::Held holds, std::set<std::string>& seen) {
  machine::BoltedJointData data;
  data.member.bolts.holds = holds;
  data.member.kind = machine::MemberKind::bolts;
  data.member.lateral_force = 20.0;
  data.member.lever_arm = 0.1;
  data.member.bolts.row_spacing = 0.06;
  data.member.bolts.column_spacing = 0.08;
  data.member.bolts.edge_distance = 0.02;
  data.member.bolts.pull_force = 30.0;
  data.member.bolts.eccentricity = eccentric ? 0.03 : 0.0;
  data.member.bolts.fitted = fitted;
  if (eccentric) data.member.bolts.tightening_torque = 10.0;
  machine::BoltedJoint<Dimensioned> d;
  d.data = &data;
  d.bolt = {length(0.008), {36.6e-6, dimension::area}, pressure(600e6), pressure(640e6)};
  d.carried_mass = mass(20.0);
  d.held_force = {30.0, dimension::force};
  d.held_torque = {2.0, dimension::torque};
  d.derive();
  CHECK(d.preload.dimension == dimension::force);
  machine::bolted_joint_constraints(DimensionVisitor(d, seen));
}

}  // namespace

TEST_CASE("Demand and capacity of every constraint have the dimension of its unit") {
  std::vector<std::set<std::string>> seen(9);
  for (const bool vertical : {false, true}) {
    for (const bool geared : {false, true}) {
      for (const bool nut_rotates : {false, true})
        for (const auto kind : {machine::ScrewKind::sliding, machine::ScrewKind::ball})
          check_screw_drive(kind, vertical, geared, nut_rotates, seen[0]);
      check_belt_drive(vertical, geared, seen[1]);
      for (const bool rides : {false, true}) check_rack_drive(vertical, geared, rides, seen[6]);
      check_rotary_drive(geared, seen[7]);
    }
    check_guide(4.0, vertical, seen[2]);
    check_guide(1.0, vertical, seen[2]);
  }
  using machine::BeamSupport;
  using machine::MemberKind;
  for (const auto support : {BeamSupport::supported, BeamSupport::fixed, BeamSupport::cantilever})
    for (const auto kind : {MemberKind::round_shaft,
                            MemberKind::rectangular_bar,
                            MemberKind::section_beam,
                            MemberKind::column,
                            MemberKind::weld,
                            MemberKind::plate,
                            MemberKind::portal_frame})
      for (const bool steel : {true, false}) check_member(kind, support, false, steel, seen[3]);
  check_member(MemberKind::round_shaft, BeamSupport::fixed, true, true, seen[3]);
  for (const bool fitted : {false, true})
    for (const bool eccentric : {false, true})
      for (const auto holds : {machine::Held::burden, machine::Held::motor, machine::Held::carriage})
        check_bolts(fitted, eccentric, holds, seen[5]);
  evaluation::supply_constraints(DimensionVisitor(evaluation::Supply<Dimensioned>{nullptr,
                                                                                  {120.0, dimension::power_output},
                                                                                  {350.0, dimension::power_output},
                                                                                  volt(36.0),
                                                                                  volt(36.0),
                                                                                  {ampere(2.8)},
                                                                                  ampere(9.7)},
                                                  seen[4]));
  evaluation::WholeData whole;
  whole.tool.emplace();
  whole.tool->force = {200.0, 200.0, 100.0};
  whole.tool->stiffness = 4e6;
  whole.tool->deflection = 5e-5;
  whole.tool->position_error = 1e-4;
  whole.error_counts = {true, true, true};
  for (const auto& each : machine::quantities()) whole.limits[each.quantity] = 1e3;
  const Dimensioned compliance{1e-7, dimension::none / dimension::stiffness};
  const Dimensioned error{2e-5, dimension::length};
  evaluation::whole_constraints(
      DimensionVisitor(evaluation::WholeMachine<Dimensioned>{&whole,
                                                             {compliance, compliance, compliance},
                                                             {error, error, error},
                                                             {Dimensioned{300.0, dimension::none},
                                                              {7.0, dimension::mass},
                                                              {5.0, dimension::time},
                                                              {90.0, dimension::energy},
                                                              {1e-4, dimension::length}}},
                       seen[8]));
  // Nothing was left out.
  const auto elements = declaring_elements();
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const auto& declaration : elements[i].constraints) {
      INFO(elements[i].name << ", " << declaration.id);
      CHECK(seen[i].count(std::string(declaration.id)) == 1);
    }
}

}  // namespace constraint_dimensions_test
