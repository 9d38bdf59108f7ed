// SPDX-License-Identifier: Apache-2.0
// The current of a motor as a choice of its own: checks worked by hand, against all builds, and on a bill of materials.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "catch.h"
#include "evaluation/design_bill.h"
#include "evaluation/exhaustive.h"
#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"
#include "machine/bill_of_materials.h"
#include "sanitized.h"

namespace current_choice_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;

namespace {

/// A slide that a lead screw pushes upwards, carried by a belt; both let currents be set.
std::string two_axes(double mass, const std::string& currents) {
  return fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V", "36 V"]
[[axis]]
name = "z"
direction = "vertical"
stroke = "200 mm"
structure_mass = "{} kg"
acceleration_time = ["0.05 s", "0.5 s"]
mechanism = {{ kind = "screw", screw = ["lead_screws"] }}
motor = {{ microsteps = 4, current = {} }}
[[axis.moves]]
distance = "100 mm"
time = "5 s"
[axis.require]
inertia_ratio = 20
[[axis]]
name = "x"
carries = ["z"]
stroke = "500 mm"
structure_mass = "1 kg"
guide_friction = 0.05
acceleration_time = ["0.05 s", "0.5 s"]
mechanism = {{ kind = "belt" }}
motor = {{ microsteps = 4, current = {} }}
[[axis.moves]]
distance = "400 mm"
time = "4 s"
[axis.require]
inertia_ratio = 60
[require]
supply_reserve = 1.5
)",
                     mass,
                     currents,
                     currents);
}

double current_of(const Design& design, const std::string& axis) {
  for (const auto& line : design.dimensions)
    if (line.axis == axis && line.name == "motor_current") {
      CHECK(line.unit == "A");
      return line.value;
    }
  return std::nan("");
}

std::string part_of(const Design& design, const std::string& axis, const std::string& slot) {
  for (const auto& part : design.parts)
    if (part.axis == axis && part.slot == slot) return part.part_number;
  return {};
}

const evaluation::Check& find(const Design& design, const std::string& axis, const std::string& id) {
  const auto found = std::find_if(
      design.checks.begin(), design.checks.end(), [&](const auto& c) { return c.axis == axis && c.id == id; });
  INFO(axis << " " << id);
  REQUIRE(found != design.checks.end());
  return *found;
}

evaluation::Synthesis solved(const MachineModel& model, const std::string& objective) {
  evaluation::SearchOptions options;
  options.objectives = {objective};
  options.threads = 1;
  return evaluation::synthesise(model, options);
}

/// The parts and, but for those left out, the settings of a design.
machine::BillOfMaterials list_of(const Design& design, const std::set<std::string>& without = {}) {
  machine::BillOfMaterials bom = evaluation::bill_of(design);
  std::erase_if(bom.lines, [&](const machine::BomLine& line) { return line.value && without.count(line.slot) > 0; });
  return bom;
}

}  // namespace

TEST_CASE("A holding torque with one phase on is sqrt(2) times less than with both") {
  // The same motor twice, its torque of 1.2 N.m with both phases stated with one: 1.2 / sqrt(2) N.m.
  const auto parts_with = [](const std::string& torque, const std::string& phases) {
    const TemporaryFolder folder;
    folder.write("steppers/motor.csv",
                 "manufacturer,part_number,frame,frame_size [mm],shaft_diameter [mm],step_angle [deg],holding_torque "
                 "[N.m],phases_on [1],detent_torque [N.m],rated_current [A],phase_resistance [ohm],phase_inductance "
                 "[mH],rotor_inertia [g.cm2],mass [kg],price,currency,price_basis,evidence,source,confidence\n"
                 "tiny,M,NEMA23,57,6.35,1.8," +
                     torque + "," + phases + ",0.04,2.8,0.9,2.5,280,0.7,16,USD,test,computed,test,high\n");
    const TinyCatalogue tiny({}, {"steppers"});
    return catalogue_of({tiny.path(), folder.path()});
  };
  const machine::Problem problem = problem_of_text(two_axes(3.0, "\"2 A\""));
  const auto cheapest = [&](const std::string& torque, const std::string& phases) {
    const catalogue::Catalogue parts = parts_with(torque, phases);
    return solved(MachineModel(problem, parts), "cost");
  };
  const evaluation::Synthesis both = cheapest("1.2", "2"), unsaid = cheapest("1.2", "");
  const evaluation::Synthesis one = cheapest("0.848528137423857", "1");
  REQUIRE(both.status == solver::Status::optimal);
  REQUIRE(one.status == solver::Status::optimal);
  REQUIRE(unsaid.status == solver::Status::optimal);
  CHECK(one.lower_bound == Approx(both.lower_bound));
  CHECK(unsaid.lower_bound == Approx(both.lower_bound));
  const auto& checks = both.designs.front().checks;
  REQUIRE(one.designs.front().checks.size() == checks.size());
  for (std::size_t i = 0; i < checks.size(); ++i) {
    INFO(checks[i].axis << " " << checks[i].id);
    CHECK(one.designs.front().checks[i].utilisation == Approx(checks[i].utilisation).margin(1e-9));
  }
  CHECK(cheapest("1.2", "1.5").status == solver::Status::infeasible);  // neither one nor two: not known
}

TEST_CASE("Machines that choose their motors' currents equal those of all builds") {
  const TinyCatalogue tiny;
  std::set<double> set;
  int machines = 0, compliant = 0, impossible = 0;
  for (const double mass : {3.0, 12.0, 60.0})
    for (const char* currents : {"[\"0.6 A\", \"1.2 A\", \"2 A\", \"2.8 A\"]",
                                 "\"2 A\"",
                                 "[\"2.8 A\", \"0.6 A\"]",
                                 "[\"1.2 A\", \"1.6 A\", \"4 A\"]"}) {
      if (sanitized && ++machines % 6 != 1) continue;
      const machine::Problem problem = problem_of_text(two_axes(mass, currents));
      const MachineModel model(problem, tiny.parts());
      const Exhaustive all(model);
      INFO(mass << " kg, " << currents << ", " << all.builds.size() << " compliant builds");
      if (all.builds.empty()) {
        ++impossible;
        CHECK(solved(model, "cost").status == solver::Status::infeasible);
        continue;
      }
      for (const bool cost : {true, false}) {
        ++compliant;
        const auto found = solved(model, cost ? "cost" : "mass");
        REQUIRE(found.designs.size() == 1);
        const Design& design = found.designs.front();
        CHECK(design.satisfied());
        CHECK((cost ? design.cost : design.mass) ==
              Approx(all.least(cost ? &BuildValue::cost : &BuildValue::mass)).epsilon(2e-6));
        for (const char* axis : {"x", "z"}) {
          set.insert(current_of(design, axis));
          CHECK(find(design, axis, "C-DR-CURRENT").value == Approx(current_of(design, axis)));
          CHECK(find(design, axis, "C-DR-CURRENT").verdict == evaluation::Verdict::satisfied);
        }
      }
    }
  CHECK(compliant >= (sanitized ? 2 : 8));
  if (sanitized) return;
  CHECK(impossible >= 1);
  CHECK(set.size() >= 3);
}

TEST_CASE("A current of the problem replaces the rated one in torque, heat and power") {
  const TinyCatalogue tiny;
  const auto of_current = [&](const char* current) {
    const machine::Problem problem = problem_of_text(two_axes(3.0, current));
    Design design = solved(MachineModel(problem, tiny.parts()), "cost").designs.front();
    machine::BillOfMaterials bom = list_of(design, {"motor_current"});
    for (machine::BomLine& line : bom.lines) {
      if (line.slot == "motor") line.part_number = "M23";
      if (line.slot == "driver") line.part_number = "D4";
    }
    const auto checked = evaluation::check(problem, tiny.parts(), bom, false, {});
    for (const auto& p : checked.problems) UNSCOPED_INFO(p.message << " / " << p.hint);
    REQUIRE(checked.problems.empty());
    return checked.design;
  };
  // M23: 1.2 N.m and 0.9 ohm at 2.8 A. One ampere gives K = 1.2/(sqrt 2 2.8) N.m of static torque, of which half may be
  // used to hold; windings heat with the square.
  for (const double ampere : {1.4, 2.0, 2.8}) {
    const Design design = of_current(fmt::format("\"{} A\"", ampere).c_str());
    INFO(ampere << " A");
    CHECK(current_of(design, "x") == ampere);
    CHECK(find(design, "z", "C-ST-HOLD").limit == Approx(0.5 * 1.2 / (std::sqrt(2.0) * 2.8) * ampere));
    CHECK(find(design, "x", "C-DR-MOTORI").value == Approx(ampere / 2.8));
    CHECK(find(design, "x", "C-DR-CURRENT").value == Approx(ampere));
    CHECK(find(design, "x", "C-DR-CURRENT").limit == Approx(4.2));
  }
}

TEST_CASE("A bill of materials says which current is set, and without it the check chooses one") {
  const TinyCatalogue tiny;
  const machine::Problem problem = problem_of_text(two_axes(12.0, "[\"1.2 A\", \"2 A\", \"2.8 A\"]"));
  const Design design = solved(MachineModel(problem, tiny.parts()), "cost").designs.front();

  const auto same = evaluation::check(problem, tiny.parts(), list_of(design), false, {});
  REQUIRE(same.problems.empty());
  CHECK_FALSE(same.completed);
  CHECK(same.design.satisfied());
  for (const char* axis : {"x", "z"}) CHECK(current_of(same.design, axis) == current_of(design, axis));

  const auto chosen = evaluation::check(problem, tiny.parts(), list_of(design, {"motor_current"}), false, {});
  REQUIRE(chosen.problems.empty());
  CHECK(chosen.design.satisfied());
  CHECK(chosen.design.cost == Approx(design.cost));

  // Not one of the problem's, and too little to hold anything: it is what the builder has.
  machine::BillOfMaterials weak = list_of(design);
  for (machine::BomLine& line : weak.lines)
    if (line.slot == "motor_current") line.value = 0.01;
  const auto judged = evaluation::check(problem, tiny.parts(), weak, false, {});
  REQUIRE(judged.problems.empty());
  CHECK(current_of(judged.design, "z") == 0.01);
  CHECK_FALSE(judged.design.satisfied());
  CHECK(find(judged.design, "z", "C-ST-TORQUE").verdict == evaluation::Verdict::violated);

  // More than the driver of the bill gives is said, and counted as what it gives.
  machine::BillOfMaterials strong = list_of(design);
  for (machine::BomLine& line : strong.lines) {
    if (line.slot == "driver" && line.axis == "z") line.part_number = "D2";
    if (line.slot == "motor_current" && line.axis == "z") line.value = 2.5;
    if (line.slot == "supply") line.part_number = "P24-350";
    if (line.slot == "supply_voltage") line.value = 24.0;
  }
  const auto over = evaluation::check(problem, tiny.parts(), strong, false, {});
  for (const auto& p : over.problems) UNSCOPED_INFO(p.message << " / " << p.hint);
  REQUIRE(over.problems.empty());
  CHECK(find(over.design, "z", "C-DR-CURRENT").value == Approx(2.5));
  CHECK(find(over.design, "z", "C-DR-CURRENT").limit == Approx(2.0));
  CHECK(find(over.design, "z", "C-DR-CURRENT").verdict == evaluation::Verdict::violated);
}

TEST_CASE("A current that no driver gives is in no build") {
  const TinyCatalogue tiny;
  const machine::Problem problem = problem_of_text(two_axes(3.0, "[\"1 A\", \"9 A\"]"));
  const auto found = solved(MachineModel(problem, tiny.parts()), "cost");
  REQUIRE(found.designs.size() == 1);
  CHECK(current_of(found.designs.front(), "z") == 1.0);
  // A driver of 2 A is not set to 2.8 A: there the larger one is taken, though the small one would do with 2 A.
  const machine::Problem large = problem_of_text(two_axes(3.0, "\"2.8 A\""));
  const auto dearer = solved(MachineModel(large, tiny.parts()), "cost");
  REQUIRE(dearer.designs.size() == 1);
  CHECK(part_of(dearer.designs.front(), "x", "driver") == "D4");
}

}  // namespace current_choice_test
