// SPDX-License-Identifier: Apache-2.0
// The constraints as a whole: which there are, and that each is said completely.
#include <algorithm>
#include <map>
#include <set>

#include "catch.h"
#include "evaluation/declared_constraints.h"
#include "scalar/unit.h"

namespace constraint_declarations_test {

using namespace millwright;
using machine::ConstraintKind;
using machine::Declaration;

namespace {

std::set<std::string> ids_of(const DeclaringElement& element) {
  std::set<std::string> ids;
  for (const Declaration& d : element.constraints) ids.insert(std::string(d.id));
  return ids;
}

void require_ids(const DeclaringElement& element, const std::vector<std::string>& wanted) {
  const auto ids = ids_of(element);
  for (const std::string& id : wanted) {
    INFO(element.name << " has no " << id);
    CHECK(ids.count(id) == 1);
  }
}

const std::vector<std::string> of_every_drive{
    "C-SYS-TIME",    "C-SYS-SPEED", "C-ST-TORQUE", "C-ST-80",      "C-ST-INERTIA", "C-ST-RMS",
    "C-ST-STEPRATE", "C-ST-HOLD",   "C-ST-BACK",   "C-DR-CURRENT", "C-DR-VOLT",    "C-DR-MOTORI",
    "C-ST-START",    "C-ST-TEMP",   "C-RD-TORQUE", "C-RD-SPEED",   "C-ST-RES",     "C-ST-POWER",
    "C-ACC-MICRO",   "C-ACC-RES",   "C-ACC-TOTAL", "C-ACC-LOST",   "C-TOOL-POWER"};

}  // namespace

TEST_CASE("Every element declares the constraints that the design rules ask of it") {
  const auto elements = declaring_elements();
  REQUIRE(elements.size() == 9);
  require_ids(elements[0], of_every_drive);
  require_ids(elements[0],
              {"C-SYS-TRAVEL",   "C-SCR-VM",         "C-SCR-TMAX",       "C-SCR-SIGMA",      "C-SCR-PB",
               "C-SCR-SHS",      "C-SCR-SHN",        "C-SCR-BEND",       "C-SCR-BUCK",       "C-SCR-NCRIT",
               "C-SCR-TWIST",    "C-SCR-LOCK",       "C-SCR-PV",         "C-SCR-VS",         "C-BS-LIFE",
               "C-BS-STATIC",    "C-BS-AXIAL",       "C-BS-BUCK",        "C-BS-NCRIT",       "C-BS-DN",
               "C-CP-TORQUE",    "F-COUPLING-MOTOR", "F-COUPLING-SCREW", "F-SUPPORT-FIXED",  "F-SUPPORT-FREE",
               "F-SUPPORT-LOAD", "C-SCR-DC",         "C-SCR-EFF",        "C-SCR-NTURNS",     "C-SCR-WEAR",
               "C-BS-PREMIN",    "C-BS-PREMAX",      "C-BS-LEAD",        "C-BS-STIFF",       "C-CP-MISAL",
               "C-CP-RES",       "C-CP-WINDUP",      "C-ACC-THERM",      "F-NUT-RIDING-MASS"});
  require_ids(elements[1], of_every_drive);
  require_ids(elements[1],
              {"C-BT-TENSION",
               "C-BT-POWER",
               "C-BT-TEETH",
               "C-BT-PRET",
               "C-BT-MINZ",
               "F-PULLEY-BORE",
               "F-BELT-PULLEYS",
               "C-BT-WIDTH",
               "C-BT-STIFF",
               "C-BT-FREQ",
               "C-ST-RADIAL"});
  require_ids(elements[2], {"C-GD-LIFE", "C-GD-STATIC", "C-GD-DEFL", "C-GD-STRESS", "C-GD-SLOPE", "C-GD-BIND"});
  require_ids(elements[3],
              {"C-FR-STRESS",
               "C-FR-DEFL",
               "C-FR-BUCK",
               "C-FR-SWAY",
               "C-FR-COLUMN",
               "C-FR-TWIST",
               "C-FR-FREQ",
               "C-WELD",
               "C-SH-DIAM",
               "C-SH-FAT",
               "C-GD-STRESS",
               "C-GD-DEFL"});
  require_ids(elements[4], {"C-PSU-POWER", "C-PSU-CURRENT", "F-SUPPLY-VOLTAGE"});
  require_ids(elements[5], {"C-BOLT-PROOF", "C-BOLT-SEP", "C-BOLT-SLIP", "C-BOLT-SHEAR"});
  require_ids(elements[6], of_every_drive);
  require_ids(elements[6],
              {"C-RK-BEND", "C-RK-RACK", "C-ST-RADIAL", "F-RACK-MODULE", "F-PINION-BORE", "F-RACK-RIDING-MASS"});
  // The travel of a table is an angle: speed and accuracy are constraints of their own, and nothing is cut along it.
  for (const std::string& id : of_every_drive)
    if (id != "C-SYS-SPEED" && id != "C-TOOL-POWER" && id.substr(0, 6) != "C-ACC-") require_ids(elements[7], {id});
  require_ids(elements[7], {"C-ROT-SPEED", "C-ROT-RES", "C-ROT-TOTAL", "C-ROT-LOST"});
}

TEST_CASE("No element declares a constraint twice") {
  for (const DeclaringElement& element : declaring_elements()) {
    INFO(element.name);
    CHECK(ids_of(element).size() == element.constraints.size());
  }
}

TEST_CASE("A constraint is said completely") {
  for (const DeclaringElement& element : declaring_elements())
    for (const Declaration& d : element.constraints) {
      INFO(element.name << ", " << d.id);
      CHECK_FALSE(d.title.empty());
      CHECK_FALSE(d.symbol.empty());
      CHECK_FALSE(d.source.empty());
      std::string reason;
      CHECK(scalar::Unit::parse(d.unit, reason).has_value());
      CHECK((d.requirement.empty() || machine::find_requirement(d.requirement) != nullptr));
      CHECK(d.id.substr(0, 2) == (d.kind == ConstraintKind::fit ? "F-" : "C-"));
      CHECK(std::string(d.file).find(".h") != std::string::npos);
      CHECK(d.line > 1);
    }
}

TEST_CASE("What implies a constraint is a hard one of the same element that the search holds") {
  for (const DeclaringElement& element : declaring_elements())
    for (const Declaration& d : element.constraints) {
      if (d.implied_by.empty()) continue;
      INFO(element.name << ", " << d.id << " by " << d.implied_by);
      CHECK(d.kind == ConstraintKind::hard);
      CHECK(std::count_if(element.constraints.begin(), element.constraints.end(), [&](const Declaration& other) {
              return other.id == d.implied_by && machine::is_searched(other);
            }) == 1);
    }
}

TEST_CASE("A constraint that two elements share means the same in both") {
  std::map<std::string_view, Declaration> first;
  for (const DeclaringElement& element : declaring_elements())
    for (const Declaration& d : element.constraints) {
      const auto [known, added] = first.try_emplace(d.id, d);
      if (added) continue;
      INFO(d.id);
      CHECK(known->second.title == d.title);
      CHECK(known->second.unit == d.unit);
      CHECK(known->second.requirement == d.requirement);
      CHECK(known->second.kind == d.kind);
    }
}

TEST_CASE("Requirements are unique, and their units parse") {
  std::set<std::string_view> keys;
  for (const machine::RequirementDeclaration& r : machine::requirements()) {
    INFO(r.key);
    CHECK(keys.insert(r.key).second);
    std::string reason;
    CHECK(scalar::Unit::parse(r.unit, reason).has_value());
    CHECK_FALSE(r.meaning.empty());
    CHECK(machine::find_requirement(r.key) == &r);
  }
  CHECK(machine::find_requirement("no_such_requirement") == nullptr);
}

// Defaults that the design documents state.
TEST_CASE("Requirements have the documented defaults") {
  const machine::Requirements r;
  using enum machine::Requirement;
  CHECK(r(torque_margin) == 0.7);
  CHECK(r(torque_margin_estimate) == 0.5);
  CHECK(r(load_torque_factor) == 0.8);
  CHECK(r(inertia_ratio) == 10.0);
  CHECK(r(screw_safety_factor) == 3.0);
  CHECK(r(screw_shear_safety_factor) == 4.0);
  CHECK(r(buckling_factor) == 0.5);
  CHECK(r(critical_speed_factor) == 0.8);
  CHECK(r(twist_per_length) == Approx(0.3 * 3.14159265358979 / 180.0));
  CHECK(r(life) == 3.6e7);
  CHECK(r(static_safety) == 2.0);
  CHECK(r(permissible_axial_stress) == 147e6);
  CHECK(r(supply_reserve) == 1.25);
  CHECK(r(driver_voltage_factor) == 0.9);
  CHECK(r(weld_stress) == 80e6);
  CHECK(r(column_factor) == Approx(1.0 / 3.0));
  CHECK(r(frame_deflection_ratio) == Approx(1e-3));
  CHECK(r(guide_shaft_deflection_ratio) == Approx(1.0 / 3000.0));
  CHECK(r(start_rate_factor) == 0.5);
  CHECK(r(winding_temperature_rise) == 60.0);
  CHECK(r(rated_temperature_rise) == 80.0);
  CHECK(r(resonance_distance) == 1.3);
  CHECK(r(load_sharing_turns) == 10.0);
  CHECK(r(nut_wear_fraction) == 0.25);
  CHECK(r(largest_preload_fraction) == 0.1);
  CHECK(r(coupling_parallel_misalignment) == 1e-4);
  CHECK(r(coupling_angular_misalignment) == Approx(0.5 * 3.14159265358979 / 180.0));
  CHECK(r(belt_frequency) == 20.0);
  CHECK_FALSE(r.known(start_rate));
  CHECK_FALSE(r.known(efficiency));
  CHECK_FALSE(r.known(axial_stiffness));
  CHECK_FALSE(r.known(motor_radial_load));
  CHECK_FALSE(r.known(output_power_factor));
  constexpr double degree = 3.14159265358979 / 180.0;
  CHECK(r(bushing_slope) == Approx(0.1 * degree));
  CHECK(r(bushing_slope_self_aligning) == Approx(0.5 * degree));
  CHECK(r(bushing_binding_factor) == 1.0);
  CHECK(r(fatigue_safety_factor) == 1.5);
  CHECK(r(fatigue_reliability_factor) == 0.814);
  CHECK(r(bolt_preload_fraction) == 0.75);
  CHECK(r(bolt_proof_safety) == 1.15);
  CHECK(r(bolt_separation_safety) == 1.5);
  CHECK(r(bolt_slip_safety) == 1.5);
  CHECK(r(bolt_shear_safety_factor) == 2.0);
  CHECK(r(spindle_power_factor) == 0.8);
  CHECK_FALSE(r.known(frame_twist));
  CHECK_FALSE(r.known(frame_natural_frequency));
  CHECK_FALSE(r.known(ringing_amplitude));
  CHECK_FALSE(r.known(position_error));
  CHECK_FALSE(r.known(lost_motion));
}

}  // namespace constraint_declarations_test
