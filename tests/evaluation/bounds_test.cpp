// SPDX-License-Identifier: Apache-2.0
// What the search trusts: bounds contain every member of a set, slopes every secant, gradients are the derivatives, and
// what does not fit is not compliant. Tried on random sets of designs of real and written machines.
#include <fmt/format.h>

#include <map>
#include <optional>

#include "catalogue/column_unit.h"
#include "catalogue/header.h"
#include "catalogue/temporary_folder.h"
#include "catch.h"
#include "evaluation/machine_stages.h"
#include "evaluation/machines.h"
#include "evaluation/random_boxes.h"
#include "sanitized.h"

namespace bounds_test {

using namespace millwright;
using evaluation::MachineModel;
using evaluation::StageEntry;
using solver::Answer;
using solver::Input;

namespace {

/// One axis of each kind that the sander does not have.
const char* const belt_machine = R"(
title = "belt gantry"
[currency]
USD = 1.0
EUR = 1.08
[supply]
voltage = ["24 V", "48 V"]
[[axis]]
name = "tool"
direction = "inclined"
inclination = "30 deg"
stroke = "200 mm"
structure_mass = "1 kg"
guide_friction = 0.1
guide_drag = "2 N"
acceleration_time = ["0.02 s", "0.4 s"]
mechanism = { kind = "screw", screw = ["ball_screws", "lead_screws"], ends = "fixed-fixed", preload = 0.05 }
motor = { microsteps = 8, brake_torque = "0.1 N.m" }
guide = { rails = 1, carriages = 1, load_offset_y = "30 mm", load_offset_x = "20 mm", force_height = "50 mm" }
[[axis.moves]]
distance = "150 mm"
speed = "60 mm/s"
time = "4 s"
force = "25 N"
dwell = "1 s"
[axis.require]
position_error = { limit = "0.1 mm", over = "300 mm" }
lost_motion = "0.05 mm"
axial_stiffness = "15 N/um"
start_rate = "200 Hz"
[[axis]]
name = "gantry"
carries = ["tool"]
stroke = "600 mm"
structure_mass = "2 kg"
guide_friction = 0.02
acceleration_time = ["0.05 s", "0.6 s"]
mechanism = { kind = "belt", idler_distance = "100 mm" }
motor = { microsteps = 16 }
guide = { rails = 2, carriages = 4, carriage_spacing = "120 mm", rail_spacing = "300 mm", load_offset_y = "40 mm" }
[[axis.moves]]
distance = "500 mm"
time = "1.5 s"
force = "10 N"
[axis.require]
position_error = "0.3 mm"
lost_motion = "0.2 mm"
motor_radial_load = "100 N"
[[axis.members]]
name = "bar"
kind = "bar"
support = "fixed"
length = "700 mm"
material = "Al 6061-T6"
lateral_force = "30 N"
width = ["8 mm", "60 mm"]
height = ["8 mm", "60 mm"]
rides = true
[[axis.members]]
name = "rod"
kind = "shaft"
length = "700 mm"
count = 2
material = "S45C normalised"
lateral_force = "30 N"
guide = true
diameter = ["8 mm", "40 mm"]
[[axis.members]]
name = "arm"
kind = "shaft"
support = "cantilever"
length = "300 mm"
material = "S45C normalised"
diameter = ["8 mm", "40 mm"]
[[axis.members]]
name = "legs"
kind = "column"
length = "800 mm"
count = 4
material = "S235JR"
sections = ["steel_sections", "extrusions"]
extra_force = "100 N"
[[axis.members]]
name = "joint"
kind = "weld"
material = "S235JR"
lever_arm = "200 mm"
joint_width = "30 mm"
joint_depth = "20 mm"
leg = ["2 mm", "10 mm"]
[[axis.members]]
name = "table"
kind = "plate"
material = "Al 6061-T6"
length = "300 mm"
width = "400 mm"
thickness = ["3 mm", "30 mm"]
lateral_force = "20 N"
rides = true
[[axis.members]]
name = "portal"
kind = "portal_frame"
material = "Al 6063-T5"
sections = ["extrusions", "steel_sections"]
length = "700 mm"
height = "350 mm"
lateral_force = "60 N"
[[axis.members]]
name = "spindle"
kind = "shaft"
rotating = true
length = "400 mm"
material = "S45C normalised"
torque = "3 N.m"
lateral_force = "20 N"
diameter = ["8 mm", "40 mm"]
[[axis.members]]
name = "flange"
kind = "bolts"
rows = 3
columns = 2
row_spacing = "40 mm"
column_spacing = "60 mm"
edge_distance = "15 mm"
lever_arm = "120 mm"
eccentricity = "30 mm"
lateral_force = "40 N"
pull_force = "10 N"
[[axis.members]]
name = "dowels"
kind = "bolts"
fitted = true
row_spacing = "40 mm"
column_spacing = "60 mm"
extra_force = "200 N"
tightening_torque = "5 N.m"
rides = true
[[axis.members]]
name = "motor_flange"
kind = "bolts"
holds = "motor"
row_spacing = "31 mm"
column_spacing = "31 mm"
edge_distance = "6 mm"
lever_arm = "30 mm"
lateral_force = "5 N"
[[axis.members]]
name = "carriages"
kind = "bolts"
holds = "guide"
fitted = true
row_spacing = "20 mm"
column_spacing = "15 mm"
)";

/// A rack that lifts, one that stands while its motor rides, a table, screws and a belt on it: with reductions to
/// choose from, some of which state what others do not.
const char* const rack_machine = R"(
title = "rack gantry with a table"
[currency]
USD = 1.0
EUR = 1.08
[supply]
voltage = ["24 V", "48 V"]
[[axis]]
name = "table"
stroke = "360 deg"
structure_mass = "2 kg"
structure_inertia = "0.004 kg.m2"
payload_inertia = "0.001 kg.m2"
friction_torque = "0.02 N.m"
acceleration_time = ["0.05 s", "0.3 s"]
mechanism = { kind = "rotary", reduction = [
  { name = "3:1", ratio = 3, efficiency = 0.9, backlash = "5 arcmin", mass = "0.3 kg" },
  { name = "5:1", ratio = 5, efficiency = 0.95, inertia = "1e-6 kg.m2", torque = "2 N.m", stiffness = "50 N.m/rad" } ] }
motor = { microsteps = 16 }
[[axis.moves]]
distance = "90 deg"
time = "0.8 s"
torque = "0.05 N.m"
[axis.require]
angle_error = "0.2 deg"
lost_angle = "0.15 deg"
[[axis]]
name = "lift"
direction = "vertical"
stroke = "150 mm"
structure_mass = "1 kg"
guide_drag = "2 N"
acceleration_time = ["0.05 s", "0.3 s"]
mechanism = { kind = "rack", motor_rides = false, backlash = "0.05 mm" }
motor = { microsteps = 16, brake_torque = "0.3 N.m" }
[[axis.moves]]
distance = "120 mm"
speed = "100 mm/s"
force = "10 N"
[[axis]]
name = "quill"
direction = "inclined"
inclination = "20 deg"
stroke = "150 mm"
structure_mass = "3 kg"
guide_friction = 0.05
acceleration_time = ["0.05 s", "0.3 s"]
mechanism = { kind = "screw", screw = ["ball_screws", "lead_screws"], rotating = "nut", nut_inertia = "3 kg.cm2", reduction = [
  { name = "1:1 belt", ratio = 1, efficiency = 0.95, mass = "0.2 kg", torque = "2 N.m", price = "20 USD" },
  { name = "2:1 belt", ratio = 2, speed = "2000 rpm", stiffness = "80 N.m/rad", mass = "0.5 kg", backlash = "0.1 deg" } ] }
motor = { microsteps = 8, brake_torque = "0.2 N.m" }
[[axis.moves]]
distance = "120 mm"
time = "4 s"
force = "30 N"
[axis.require]
position_error = { limit = "0.1 mm", over = "150 mm" }
lost_motion = "0.1 mm"
[[axis]]
name = "slide"
stroke = "200 mm"
structure_mass = "4 kg"
guide_friction = 0.05
acceleration_time = ["0.05 s", "0.3 s"]
mechanism = { kind = "screw", screw = ["ball_screws", "lead_screws"], preload = 0.03, reduction = [
  { name = "P3", ratio = 3, shaft = "8 mm", inertia = "2e-6 kg.m2", torque = "5 N.m", speed = "3000 rpm", mass = "0.5 kg" },
  { name = "P5", ratio = 5, shaft = "10 mm", stiffness = "300 N.m/rad", backlash = "8 arcmin", price = "90 EUR" } ] }
[[axis.moves]]
distance = "150 mm"
time = "5 s"
force = "40 N"
[axis.require]
position_error = "0.1 mm"
lost_motion = "0.1 mm"
[[axis]]
name = "shuttle"
stroke = "300 mm"
structure_mass = "2 kg"
guide_friction = 0.05
acceleration_time = ["0.05 s", "0.3 s"]
mechanism = { kind = "belt", reduction = [
  { name = "P3", ratio = 3, shaft = "8 mm", inertia = "2e-6 kg.m2", torque = "5 N.m", mass = "0.5 kg" },
  { name = "P2", ratio = 2, shaft = "5 mm", stiffness = "100 N.m/rad", speed = "1500 rpm", backlash = "8 arcmin" } ] }
[[axis.moves]]
distance = "250 mm"
time = "2 s"
force = "5 N"
[axis.require]
position_error = "0.2 mm"
lost_motion = "0.1 mm"
[[axis]]
name = "x"
carries = ["table", "lift", "quill", "slide", "shuttle"]
stroke = "900 mm"
structure_mass = "3 kg"
guide_friction = 0.02
acceleration_time = ["0.05 s", "0.6 s"]
mechanism = { kind = "rack", efficiency = 0.9, reduction = [
  { name = "planet", ratio = 4, shaft = "14 mm", efficiency = 0.9, mass = "0.5 kg", price = "40 USD", torque = "12 N.m" },
  { name = "belt", ratio = 3, shaft = "10 mm", efficiency = 0.95, mass = "0.8 kg", speed = "2500 rpm", stiffness = "200 N.m/rad" } ] }
motor = { microsteps = 8 }
guide = { rails = 2, carriages = 4, carriage_spacing = "120 mm", rail_spacing = "300 mm" }
[[axis.moves]]
distance = "800 mm"
time = "2 s"
force = "20 N"
[axis.require]
position_error = { limit = "0.4 mm", over = "900 mm" }
lost_motion = "0.3 mm"
)";

/// Jerk-limited, coordinated and measured moves: a screw up a slope, a belt with a counterweight, a rack that lifts.
/// The ramps run from too short for their jerk to long ones.
const char* const moved_machine = R"(
title = "moved in every way"
[currency]
USD = 1.0
EUR = 1.08
[supply]
voltage = ["24 V", "48 V"]
[[moves]]
name = "diagonal"
axes = {{ tool = "120 mm", gantry = "350 mm" }}
speed = "120 mm/s"
acceleration_time = "0.3 s"
forces = {{ tool = "15 N" }}
[[axis]]
name = "tool"
direction = "inclined"
inclination = "30 deg"
stroke = "200 mm"
structure_mass = "1 kg"
guide_friction = 0.1
jerk = "20 m/s^3"
acceleration_time = ["0.02 s", "0.4 s"]
mechanism = {{ kind = "screw", screw = ["ball_screws", "lead_screws"], preload = 0.05 }}
motor = {{ microsteps = 8, brake_torque = "0.1 N.m" }}
[[axis.moves]]
distance = "150 mm"
speed = "60 mm/s"
force = "25 N"
[[axis.moves]]
distance = "100 mm"
time = "2 s"
jerk = "5 m/s^3"
[[axis.moves]]
profile = "{0}/tool.csv"
dwell = "1 s"
[[axis]]
name = "gantry"
carries = ["tool"]
direction = "vertical"
counterbalance_force = "20 N"
stroke = "600 mm"
structure_mass = "2 kg"
acceleration_time = ["0.05 s", "0.6 s"]
mechanism = {{ kind = "belt", idler_distance = "100 mm" }}
[[axis.moves]]
distance = "500 mm"
time = "1.5 s"
jerk = "15 m/s^3"
[[axis]]
name = "lift"
direction = "vertical"
stroke = "450 mm"
structure_mass = "1 kg"
guide_drag = "2 N"
mechanism = {{ kind = "rack", motor_rides = false }}
motor = {{ microsteps = 16, brake_torque = "0.3 N.m" }}
[[axis.moves]]
profile = "{0}/lift.csv"
)";

machine::Problem moved_problem() {
  const TemporaryFolder folder;
  folder.write("tool.csv",
               "time [s],position [mm],force [N]\n0,0,0\n0.1,2,0\n0.3,12,30\n0.5,25,-40\n0.7,35,0\n0.9,36,0\n1.2,20,5\n"
               "1.5,0,5\n1.6,0,0\n1.7,0,0\n");
  std::string lift = "time [s],speed [mm/s],force [N]\n";
  for (int i = 0; i <= 200; ++i)
    lift += fmt::format("{},{},{}\n", 0.02 * i, 300.0 * std::sin(0.01 * 3.14159 * i), 5.0 * std::cos(0.3 * i));
  folder.write("lift.csv", lift);
  return problem_of_text(fmt::format(fmt::runtime(moved_machine), folder.path().string()));
}

/// With everything that an objective can ask for.
machine::Problem counting(machine::Problem problem) {
  using machine::Quantity;
  problem.counted = {Quantity::cycle_time, Quantity::energy, Quantity::position_error};
  return problem;
}

const MachineModel& sander() {
  static const MachineModel model(counting(shipped_problem("sander")), shipped_catalogue());
  return model;
}
/// Belts and pulleys of two other makers, in the same sizes with other figures, and idlers in all of them: what runs on
/// the same can be compared.
const catalogue::Catalogue& with_other_makers() {
  static const catalogue::Catalogue parts = [] {
    const TemporaryFolder folder;
    using Figures = std::vector<std::pair<const char*, double>>;
    const auto write =
        [&](catalogue::Family family, const std::string& maker, const char* type, const Figures& figures) {
          const catalogue::Table& table = shipped_catalogue().table(family);
          std::string csv = "manufacturer,part_number,currency,price_basis,evidence,source,confidence,profile";
          if (type != nullptr) csv += ",type";
          for (const auto& [name, factor] : figures)
            csv += "," + catalogue::header_cell(catalogue::column(family, name));
          for (int row = 0; row < table.rows(); ++row) {
            csv += fmt::format("\n{},{} {},USD,test,computed,test,high,{}",
                               maker,
                               table.part_number(row),
                               type == nullptr ? "" : type,
                               table.text("profile", row));
            if (type != nullptr) csv += fmt::format(",{}", type);
            for (const auto& [name, factor] : figures) {
              const double value = table.number(name, row);
              const scalar::Unit unit = catalogue::display_unit(catalogue::column(family, name));
              csv += std::isnan(value) ? "," : fmt::format(",{:.12g}", factor * unit.from_si(value));
            }
          }
          folder.write(
              fmt::format("{}/{}{}.csv", catalogue::declaration(family).name, maker, type == nullptr ? "" : type),
              csv + "\n");
        };
    for (const auto& [maker, more] : {std::pair("others", 1.2), std::pair("thirds", 0.9)}) {
      write(catalogue::Family::belts,
            maker,
            nullptr,
            {{"pitch", 1.0},
             {"width", 1.0},
             {"allowable_tension", more},
             {"mass_per_length", 1.1 * more},
             {"tensile_stiffness", 0.9 * more},
             {"minimum_pulley_teeth", 1.0},
             {"maximum_speed", more},
             {"price_per_length", 1.0 / more}});
      for (const char* const type : {"pulley", "idler"})
        write(catalogue::Family::pulleys,
              maker,
              type,
              {{"pitch", 1.0},
               {"teeth", 1.0},
               {"belt_width", 1.0},
               {"bore", 1.0},
               {"pitch_diameter", 1.0},
               {"inertia", more},
               {"mass", 0.8 * more},
               {"price", 1.1 / more}});
    }
    return catalogue_of({std::string(MILLWRIGHT_SOURCE_DIR) + "/catalogues",
                         std::string(MILLWRIGHT_SOURCE_DIR) + "/problems/sander-parts",
                         folder.path()});
  }();
  return parts;
}

const MachineModel& gantry() {
  static const MachineModel model(counting(problem_of_text(belt_machine)), with_other_makers());
  return model;
}

const MachineModel& racks() {
  static const MachineModel model(counting(problem_of_text(rack_machine)), with_other_makers());
  return model;
}

const MachineModel& moved() {
  static const MachineModel model(counting(moved_problem()), with_other_makers());
  return model;
}

std::vector<const StageEntry*> all_stages() {
  std::vector<const StageEntry*> all;
  for (const MachineModel* model : {&sander(), &gantry(), &racks(), &moved()})
    for (const StageEntry& entry : model->entries()) all.push_back(&entry);
  return all;
}

BoxSampler sampler_of(const StageEntry& entry, unsigned seed) {
  const auto has_it = [&](const MachineModel& model) {
    return std::any_of(
        model.entries().begin(), model.entries().end(), [&](const StageEntry& e) { return &e == &entry; });
  };
  const MachineModel& model = has_it(sander())   ? sander()
                              : has_it(gantry()) ? gantry()
                              : has_it(racks())  ? racks()
                                                 : moved();
  return {entry.as_stage(), model.machine().supply_voltages.size(), model.problem().first_state.size(), seed};
}

/// Names of the entries of an answer, for messages.
template <class T>
std::vector<std::pair<std::string, T>> flat(const Answer<T>& a) {
  std::vector<std::pair<std::string, T>> all;
  for (std::size_t i = 0; i < a.utilisation.size(); ++i)
    all.emplace_back("utilisation " + std::to_string(i), a.utilisation[i]);
  for (std::size_t i = 0; i < a.resources.size(); ++i)
    all.emplace_back("resource " + std::to_string(i), a.resources[i]);
  for (std::size_t i = 0; i < a.handed_on.size(); ++i) all.emplace_back("state " + std::to_string(i), a.handed_on[i]);
  return all;
}

class Findings {
 public:
  void add(const std::string& what) {
    if (++count_ <= 8) text_ += what + "\n";
  }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

std::string shown(const std::string& name, double x, const Interval& range) {
  return fmt::format("{} = {:.17g} outside [{:.17g}, {:.17g}]", name, x, range.lower, range.upper);
}

}  // namespace

TEST_CASE("The written machines and the sander have every kind of stage") {
  CHECK(sander().empty_slots().empty());
  CHECK(gantry().empty_slots().empty());
  CHECK(racks().empty_slots().empty());
  CHECK(moved().empty_slots().empty());
  std::map<std::size_t, int> kinds;
  for (const StageEntry* entry : all_stages()) ++kinds[entry->stage.index()];
  CHECK(kinds.size() == 8);
}

TEST_CASE("Bounds of random sets contain their members") {
  const std::size_t sets = sanitized ? 250 : 2000;
  for (const StageEntry* entry : all_stages()) {
    const solver::Stage& stage = entry->as_stage();
    BoxSampler sampler = sampler_of(*entry, 11);
    Findings findings;
    std::size_t proved = 0;
    for (std::size_t n = 0; n < sets; ++n) {
      SampledBox box = sampler.box();
      Answer<Interval> bounds;
      stage.bound(box.box(), bounds);
      Answer<Interval> unread;
      stage.bound(box.box(false), unread);
      const auto same = [](const auto& x, const auto& y) {
        return x.second.lower == y.second.lower && x.second.upper == y.second.upper;
      };
      const auto ranges = flat(bounds), without = flat(unread);
      if (!std::equal(ranges.begin(), ranges.end(), without.begin(), without.end(), same))
        findings.add("what is read beforehand makes a difference");
      REQUIRE(bounds.utilisation.size() == stage.constraints());
      for (const Interval& u : bounds.utilisation) proved += u.upper <= 1.0 || u.lower > 1.0;
      for (int k = 0; k < 3; ++k) {
        const SampledPoint member = sampler.point(box);
        Answer<double> answer;
        stage.evaluate(member.point(), answer);
        const auto values = flat(answer);
        REQUIRE(values.size() == ranges.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
          const double x = values[i].second;
          if (!(ranges[i].second.lower <= x && x <= ranges[i].second.upper))
            findings.add(shown(values[i].first, x, ranges[i].second));
        }
      }
    }
    INFO(entry->axis << "." << entry->element << ": " << findings.count() << " outside\n" << findings.text());
    CHECK(findings.count() == 0);
    CHECK(proved > sets);  // the bounds say something
  }
}

namespace {

/// Some of a set: half of the rows of each slot, and part of each interval.
SampledBox part_of(const SampledBox& whole, BoxSampler& sampler) {
  SampledBox part = whole;
  for (std::vector<Row>& rows : part.rows) rows.resize((rows.size() + 1) / 2);
  for (auto* sides : {&part.inherited, &part.variables})
    for (Interval& side : *sides) side = Interval::between(sampler.within(side), sampler.within(side));
  return part;
}

/// The constraints (modulo 64) that all members of a set keep.
std::uint64_t kept_in(const Answer<Interval>& bounds) {
  std::uint64_t kept = ~std::uint64_t{0};
  for (std::size_t c = 0; c < bounds.utilisation.size(); ++c)
    if (!(bounds.utilisation[c].upper <= 1.0)) kept &= ~(std::uint64_t{1} << (c % 64));
  return kept;
}

}  // namespace

// The search does not ask again about constraints that a set has been proved to keep.
TEST_CASE("A constraint that a set keeps is kept by its parts, and leaving it out changes nothing else") {
  const std::size_t sets = sanitized ? 150 : 1000;
  for (const StageEntry* entry : all_stages()) {
    const solver::Stage& stage = entry->as_stage();
    BoxSampler sampler = sampler_of(*entry, 14);
    Findings findings;
    std::size_t left_out = 0;
    for (std::size_t n = 0; n < sets; ++n) {
      SampledBox whole = sampler.box();
      SampledBox part = part_of(whole, sampler);
      Answer<Interval> bounds, all, some;
      stage.bound(whole.box(), bounds);
      const std::uint64_t kept = kept_in(bounds);
      solver::Box box = part.box();
      stage.bound(box, all);
      box.kept = kept;
      stage.bound(box, some);
      const auto expected = flat(all), found = flat(some);
      REQUIRE(expected.size() == found.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const Interval& x = found[i].second;
        const bool is_kept = i < all.utilisation.size() && ((kept >> (i % 64)) & 1U) != 0;
        if (is_kept && !(expected[i].second.upper <= 1.0)) findings.add(found[i].first + " is not kept by a part");
        if (is_kept && x.lower == 0.0 && x.upper == 0.0) {
          left_out += expected[i].second.upper > 0.0;
        } else if (x.lower != expected[i].second.lower || x.upper != expected[i].second.upper) {
          findings.add(found[i].first + " is another one");
        }
      }
    }
    INFO(entry->axis << "." << entry->element << ": " << findings.count() << "\n" << findings.text());
    CHECK(findings.count() == 0);
    CHECK((stage.constraints() < 3 || 2 * left_out > sets));
  }
}

TEST_CASE("The answer for one design is never NaN") {
  for (const StageEntry* entry : all_stages()) {
    BoxSampler sampler = sampler_of(*entry, 12);
    bool sound = true;
    for (int n = 0; n < 500; ++n) {
      const SampledBox box = sampler.box();
      const SampledPoint member = sampler.point(box);
      Answer<double> answer;
      entry->as_stage().evaluate(member.point(), answer);
      for (const auto& [name, x] : flat(answer)) sound = sound && std::isfinite(x);
      for (const double u : answer.utilisation) sound = sound && u >= 0.0 && u <= machine::useless_utilisation;
    }
    INFO(entry->axis << "." << entry->element);
    CHECK(sound);
  }
}

namespace {

std::vector<Input> inputs_of(const solver::Stage& stage, std::size_t states) {
  std::vector<Input> inputs;
  for (std::size_t i = 0; i < stage.variables().size(); ++i) inputs.push_back({Input::Kind::variable, i});
  for (std::size_t i = 0; i < states; ++i) inputs.push_back({Input::Kind::inherited, i});
  return inputs;
}
double& value_of(SampledPoint& p, Input input) {
  return input.kind == Input::Kind::variable ? p.variables[input.index] : p.inherited[input.index];
}
double at_rest(const SampledPoint& p, Input input) {
  return input.kind == Input::Kind::variable ? p.variables[input.index] : p.inherited[input.index];
}
const Interval& range_of(const SampledBox& b, Input input) {
  return input.kind == Input::Kind::variable ? b.variables[input.index] : b.inherited[input.index];
}

}  // namespace

// By the mean value theorem a secant between two members is a value of the slope between them, kinks and steps
// included: nothing has to be left out but rounding.
TEST_CASE("Slopes of random sets contain the secants between their members") {
  const std::size_t sets = sanitized ? 350 : 2000;
  for (const StageEntry* entry : all_stages()) {
    const solver::Stage& stage = entry->as_stage();
    BoxSampler sampler = sampler_of(*entry, 13);
    Findings findings;
    std::size_t looked = 0;
    for (std::size_t n = 0; n < sets; ++n) {
      SampledBox box = sampler.box();
      const auto inputs = inputs_of(stage, box.inherited.size());
      const Input input = inputs[sampler.below(inputs.size())];
      const Interval range = range_of(box, input);
      if (range.upper - range.lower < 1e-6 * range.upper) continue;
      Answer<Interval> slopes;
      stage.slopes(box.box(), input, slopes);
      const auto bounds = flat(slopes);
      SampledPoint a = sampler.point(box);
      SampledPoint b = a;
      value_of(b, input) = sampler.within(range);
      const double step = value_of(b, input) - value_of(a, input);
      if (std::abs(step) < 1e-7 * range.upper) continue;
      Answer<double> at_a, at_b;
      stage.evaluate(a.point(), at_a);
      stage.evaluate(b.point(), at_b);
      const auto va = flat(at_a), vb = flat(at_b);
      for (std::size_t i = 0; i < va.size(); ++i) {
        const double x = va[i].second, y = vb[i].second;
        // Where a utilisation is cut off at 1e9 it has no slope of its own.
        if (std::max(x, y) >= machine::useless_utilisation) continue;
        const double noise = 1e-13 * (std::abs(x) + std::abs(y)) / std::abs(step) + 1e-300;
        const double secant = (y - x) / step;
        ++looked;
        if (!(bounds[i].second.lower - noise <= secant && secant <= bounds[i].second.upper + noise))
          findings.add(shown(va[i].first, secant, bounds[i].second));
      }
    }
    INFO(entry->axis << "." << entry->element << ": " << findings.count() << " outside\n" << findings.text());
    CHECK(findings.count() == 0);
    CHECK(2 * looked > sets);
  }
}

namespace {

/// Two rows of a slot that may be compared with each other: of one kind, and equal in what is no quantity.
std::optional<std::pair<Row, Row>> comparable_rows(const solver::Stage& stage,
                                                   const SampledBox& box,
                                                   std::size_t slot,
                                                   BoxSampler& sampler) {
  const auto any = [&] { return static_cast<Row>(sampler.below(stage.slots()[slot].rows)); };
  const auto not_graded = [&](Row row) {
    std::vector<Interval> readings;
    stage.read(box.shared, slot, std::span(&row, 1), readings);
    std::vector<double> numbers;
    for (std::size_t r = stage.graded_readings(slot); r < readings.size(); ++r)
      numbers.insert(numbers.end(), {readings[r].lower, readings[r].upper});
    return numbers;
  };
  const Row a = any();
  std::vector<Row> others;
  for (Row b = 0; b < stage.slots()[slot].rows; ++b)
    if (a != b && stage.row_kind(slot, a) == stage.row_kind(slot, b) && not_graded(a) == not_graded(b))
      others.push_back(b);
  if (others.empty()) return std::nullopt;
  return std::pair(a, others[sampler.below(others.size())]);
}

}  // namespace

// Rows are compared by what is read of them: were anything else of a row used, or a reading without its slope, then
// what two rows differ by would not be the sum of what their readings do.
TEST_CASE("What two rows of a kind differ by lies within the slopes in their readings") {
  std::map<std::size_t, std::size_t> graded_slots;  // [kind of stage]
  const std::size_t pairs = sanitized ? 15 : 200;
  for (const StageEntry* entry : all_stages()) {
    const solver::Stage& stage = entry->as_stage();
    BoxSampler sampler = sampler_of(*entry, 16);
    for (std::size_t slot = 0; slot < stage.slots().size(); ++slot) {
      const std::size_t graded = stage.graded_readings(slot);
      if (graded == 0) continue;
      ++graded_slots[entry->stage.index()];
      Findings findings;
      std::size_t differ = 0;
      for (std::size_t n = 0; n < pairs; ++n) {
        SampledPoint p = sampler.point(sampler.box());
        SampledBox box;
        box.stage = &stage;
        box.shared = p.shared;
        for (const Row row : p.rows) box.rows.push_back({row});
        for (const double x : p.inherited) box.inherited.emplace_back(x);
        for (const double x : p.variables) box.variables.emplace_back(x);
        const auto rows = comparable_rows(stage, box, slot, sampler);
        if (!rows) continue;
        const auto [a, b] = *rows;
        box.rows[slot] = {std::min(a, b), std::max(a, b)};
        std::vector<Interval> of_a, of_b;
        stage.read(p.shared, slot, std::span(&a, 1), of_a);
        stage.read(p.shared, slot, std::span(&b, 1), of_b);
        const auto at = [&](Row row) {
          p.rows[slot] = row;
          Answer<double> answer;
          stage.evaluate(p.point(), answer);
          return flat(answer);
        };
        const auto at_a = at(a), at_b = at(b);
        std::vector<Interval> change(at_a.size(), Interval(0.0));
        for (std::size_t r = 0; r < graded; ++r) {
          if (of_a[r].lower != of_a[r].upper) findings.add("one row is read as a range");
          if (of_a[r].lower == of_b[r].lower) continue;
          Answer<Interval> slopes;
          stage.slopes(box.box(), {Input::Kind::reading, r, slot}, slopes);
          const auto by = flat(slopes);
          for (std::size_t i = 0; i < change.size(); ++i) change[i] = change[i] + by[i].second * (of_b[r] - of_a[r]);
        }
        for (std::size_t i = 0; i < change.size(); ++i) {
          const double x = at_a[i].second, y = at_b[i].second;
          if (std::max(x, y) >= machine::useless_utilisation) continue;
          differ += x != y && std::isfinite(change[i].lower) && std::isfinite(change[i].upper);
          const double noise = 1e-12 * (std::abs(x) + std::abs(y)) + 1e-300;
          if (!(change[i].lower - noise <= y - x && y - x <= change[i].upper + noise))
            findings.add(shown(at_a[i].first, y - x, change[i]));
        }
      }
      INFO(entry->axis << "." << entry->element << " " << stage.slots()[slot].name << ": " << findings.count()
                       << " outside, " << differ << " differ\n"
                       << findings.text());
      CHECK(findings.count() == 0);
      CHECK(2 * differ > pairs);
    }
  }
  CHECK(graded_slots.size() == 3);  // screw, belt and rack drives
}

TEST_CASE("Gradients are the derivatives") {
  for (const StageEntry* entry : all_stages()) {
    const solver::Stage& stage = entry->as_stage();
    BoxSampler sampler = sampler_of(*entry, 14);
    Findings findings;
    std::size_t looked = 0;
    for (int n = 0; n < (sanitized ? 50 : 300); ++n) {
      const SampledPoint p = sampler.point(sampler.box());
      for (const Input input : inputs_of(stage, p.inherited.size())) {
        Answer<double> gradient, at;
        stage.gradient(p.point(), input, gradient);
        stage.evaluate(p.point(), at);
        const auto slopes = flat(gradient);
        const auto values = flat(at);
        const auto side = [&](double relative) {
          SampledPoint q = p;
          value_of(q, input) *= 1.0 + relative;
          const double step = value_of(q, input) - at_rest(p, input);
          Answer<double> answer;
          stage.evaluate(q.point(), answer);
          auto moved = flat(answer);
          for (std::size_t i = 0; i < moved.size(); ++i) moved[i].second = (moved[i].second - values[i].second) / step;
          return moved;
        };
        const auto right = side(1e-6), left = side(-1e-6), further = side(-4e-6);
        for (std::size_t i = 0; i < values.size(); ++i) {
          const double reach = 1e-6 * at_rest(p, input);
          const double noise = 4e-15 * std::abs(values[i].second) / reach;
          const double scale = std::abs(right[i].second) + std::abs(left[i].second) + 1e4 * noise + 1e-18;
          // A kink or a step within reach shows in one-sided differences that do not agree.
          if (std::abs(right[i].second - left[i].second) > 1e-4 * scale ||
              std::abs(further[i].second - left[i].second) > 1e-4 * scale)
            continue;
          ++looked;
          const double central = 0.5 * (right[i].second + left[i].second);
          if (!(std::abs(slopes[i].second - central) <= 2e-4 * scale))
            findings.add(
                fmt::format("{}: gradient {:.10g}, differences {:.10g}", values[i].first, slopes[i].second, central));
        }
      }
    }
    INFO(entry->axis << "." << entry->element << ": " << findings.count() << " wrong\n" << findings.text());
    CHECK(findings.count() == 0);
    CHECK(looked > (sanitized ? 150 : 1000));
  }
}

namespace {

/// Whether all constraints on how the parts of a drive go together hold.
bool parts_go_together(const StageEntry& entry, const SampledPoint& p) {
  std::vector<solver::RowsAlive> rows;
  for (const Row& row : p.rows) rows.emplace_back(std::span(&row, 1));
  const evaluation::Selection<double> selection{
      .shared = p.shared, .rows = rows, .inherited = p.inherited, .variables = p.variables};
  bool good = true;
  const auto look = [&](const auto& element) {
    return [&](const machine::Declaration& declaration, auto when, auto demand, auto capacity) {
      if (declaration.kind != machine::ConstraintKind::fit || when(element) != machine::Applies::yes) return;
      good = good && demand(element) <= capacity(element) * (1.0 + 1e-12);
    };
  };
  if (const auto* screw = std::get_if<std::unique_ptr<evaluation::ScrewDriveStage>>(&entry.stage)) {
    const auto design = (*screw)->design<double>(selection);
    machine::screw_fit_constraints(look(design));
  }
  if (const auto* belt = std::get_if<std::unique_ptr<evaluation::BeltDriveStage>>(&entry.stage)) {
    const auto design = (*belt)->design<double>(selection);
    machine::belt_constraints(look(design));
  }
  if (const auto* rack = std::get_if<std::unique_ptr<evaluation::RackDriveStage>>(&entry.stage)) {
    const auto design = (*rack)->design<double>(selection);
    machine::rack_fit_constraints(look(design));
  }
  return good;
}

}  // namespace

// `fits` may only rule out what the fit constraints, which judge in the end, rule out too.
TEST_CASE("Parts that go together are never said not to fit") {
  for (const StageEntry* entry : all_stages()) {
    const solver::Stage& stage = entry->as_stage();
    if (stage.slots().size() < 2) continue;
    BoxSampler sampler = sampler_of(*entry, 15);
    Findings findings;
    std::size_t unfit = 0, together = 0;
    for (int n = 0; n < 10000; ++n) {
      SampledPoint p = sampler.point(sampler.box());
      // Few of all belts run on few of all pulleys: half of the points are drawn until their parts are said to fit.
      const auto fits_before = [&](std::size_t slot) {
        for (std::size_t other = 0; other < slot; ++other)
          if (!stage.fits(p.shared, other, p.rows[other], slot, p.rows[slot])) return false;
        return true;
      };
      if (n % 2 == 0)
        for (std::size_t slot = 0; slot < p.rows.size(); ++slot)
          for (int tries = 0; tries < 100 && !fits_before(slot); ++tries)
            p.rows[slot] = static_cast<Row>(sampler.below(stage.slots()[slot].rows));
      bool fits = true;
      for (std::size_t a = 0; a < p.rows.size(); ++a)
        for (std::size_t b = a + 1; b < p.rows.size(); ++b) {
          const bool ab = stage.fits(p.shared, a, p.rows[a], b, p.rows[b]);
          if (ab != stage.fits(p.shared, b, p.rows[b], a, p.rows[a])) findings.add("fits depends on the order");
          fits = fits && ab;
        }
      const bool good = parts_go_together(*entry, p);
      together += good;
      unfit += !fits;
      if (good && !fits) findings.add("said not to fit, but every fit constraint holds");
    }
    INFO(entry->axis << "." << entry->element << "\n" << findings.text());
    CHECK(findings.count() == 0);
    // Any reduction of a table goes with any motor.
    if (entry->axis == "table")
      CHECK(unfit == 0);
    else
      CHECK(unfit > 100);
    CHECK(together > 5);
  }
}

}  // namespace bounds_test
