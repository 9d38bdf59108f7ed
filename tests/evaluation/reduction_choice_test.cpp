// SPDX-License-Identifier: Apache-2.0
// A reduction that the search chooses from those that the problem states: against all builds, and on a bill of
// materials.
#include <fmt/format.h>

#include <set>

#include "catch.h"
#include "evaluation/exhaustive.h"
#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"
#include "machine/bill_of_materials.h"
#include "sanitized.h"

namespace reduction_choice_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;

namespace {

/// A nut that turns on x, carried by the rack or belt of y; both choose their reduction.
std::string two_axes(double force, const std::string& below) {
  return fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V", "36 V"]
[[axis]]
name = "x"
stroke = "300 mm"
structure_mass = "6 kg"
guide_friction = 0.05
acceleration_time = ["0.02 s", "0.5 s"]
mechanism = {{ kind = "screw", screw = ["ball_screws", "lead_screws"], rotating = "nut", nut_inertia = "1 kg.cm2", reduction = [
  {{ name = "1:1 belt", ratio = 1, efficiency = 0.95, mass = "0.2 kg", price = "15 USD" }},
  {{ name = "3:1 belt", ratio = 3, efficiency = 0.92, inertia = "2e-6 kg.m2", torque = "4 N.m", mass = "0.5 kg", price = "22 USD" }} ] }}
motor = {{ microsteps = 4 }}
[[axis.moves]]
distance = "200 mm"
time = "6 s"
force = "{} N"
[axis.require]
inertia_ratio = 20
[[axis]]
name = "y"
carries = ["x"]
stroke = "500 mm"
structure_mass = "3 kg"
acceleration_time = ["0.05 s", "0.5 s"]
{}
[[axis.moves]]
distance = "400 mm"
time = "4 s"
force = "15 N"
[axis.require]
inertia_ratio = 25
)",
                     force,
                     below);
}

const char* const belt = R"(mechanism = { kind = "belt", reduction = [
  { name = "geared 4", ratio = 4, shaft = "6.35 mm", efficiency = 0.9, speed = "2000 rpm", mass = "0.6 kg", price = "60 USD" },
  { name = "geared 2", ratio = 2, shaft = "5 mm", mass = "0.4 kg", price = "35 USD" } ] })";
const char* const rack = R"(mechanism = { kind = "rack", reduction = [
  { name = "geared 5", ratio = 5, shaft = "8 mm", efficiency = 0.9, torque = "6 N.m", mass = "0.9 kg", price = "70 USD" },
  { name = "light 3", ratio = 3, shaft = "5 mm", mass = "0.3 kg", price = "80 USD" } ] })";

Design solved(const MachineModel& model, const std::string& objective) {
  evaluation::SearchOptions options;
  options.objectives = {objective};
  options.threads = 1;
  const auto found = evaluation::synthesise(model, options);
  REQUIRE(found.designs.size() == 1);
  return found.designs.front();
}

std::string reduction_of(const Design& design, const std::string& axis) {
  for (const auto& part : design.parts)
    if (part.axis == axis && part.slot == "reduction") return part.part_number;
  return {};
}

/// What a design is made of, as a bill of materials, with another reduction for x if one is named.
evaluation::BomCheck checked(const machine::Problem& problem,
                             const catalogue::Catalogue& parts,
                             const Design& design,
                             const std::string& reduction) {
  machine::BillOfMaterials bom;
  for (const auto& part : design.parts) {
    machine::BomLine& line = bom.lines.emplace_back();
    line.axis = part.axis;
    line.slot = part.slot;
    line.manufacturer = part.manufacturer;
    line.part_number =
        part.axis == "x" && part.slot == "reduction" && !reduction.empty() ? reduction : part.part_number;
  }
  return evaluation::check(problem, parts, bom, false, {});
}

}  // namespace

TEST_CASE("Cheapest and lightest machines that choose a reduction equal those of all builds") {
  // A heavy large motor, that rides, and light small ones.
  const TinyCatalogue tiny([](const std::string& part, PriceAndMass usual) {
    return part == "M23L" ? PriceAndMass{usual.price, 2.5} : part == "B16x5" ? PriceAndMass{55.0, usual.mass} : usual;
  });
  std::set<std::string> chosen;
  int compliant = 0, impossible = 0;
  for (const double force : {40.0, 300.0, 6000.0})
    for (const char* below : {belt, rack}) {
      if (sanitized && (force < 300.0) != (below == belt)) continue;
      const machine::Problem problem = problem_of_text(two_axes(force, below));
      machine::Problem everything = problem;
      for (machine::Axis& axis : everything.axes) axis.keep_every_candidate = true;
      const MachineModel model(problem, tiny.parts());
      const MachineModel whole(everything, tiny.parts());
      const Exhaustive all(whole);
      INFO(force << " N, " << all.builds.size() << " compliant builds");
      if (all.builds.empty()) {
        ++impossible;
        evaluation::SearchOptions options;
        options.objectives = {"cost"};
        CHECK(evaluation::synthesise(model, options).status == solver::Status::infeasible);
        continue;
      }
      for (const bool cost : {true, false}) {
        ++compliant;
        if (sanitized && cost != (force < 300.0)) continue;
        const Design design = solved(model, cost ? "cost" : "mass");
        CHECK(design.satisfied());
        CHECK((cost ? design.cost : design.mass) ==
              Approx(all.least(cost ? &BuildValue::cost : &BuildValue::mass)).epsilon(2e-6));
        chosen.insert("x " + reduction_of(design, "x"));
        chosen.insert("y " + reduction_of(design, "y"));
      }
    }
  CHECK(compliant >= (sanitized ? 2 : 4));
  if (sanitized) return;
  CHECK(impossible >= 1);
  for (const std::string& each : chosen) UNSCOPED_INFO(each);
  CHECK(chosen.size() >= 4);  // not always the same one
}

TEST_CASE("A chosen reduction is on the bill of materials, which holds it") {
  const TinyCatalogue tiny;
  const machine::Problem problem = problem_of_text(two_axes(40.0, belt));
  const Design design = solved(MachineModel(problem, tiny.parts()), "cost");
  const std::string name = reduction_of(design, "x");
  REQUIRE((name == "1:1 belt" || name == "3:1 belt"));
  for (const auto& part : design.parts)
    if (part.slot == "reduction") CHECK(part.manufacturer == "generic");
  using Slots = std::vector<std::string>;
  CHECK(machine::slot_names(problem.axes[0]) ==
        Slots{"screw", "nut", "motor", "driver", "support_fixed", "support_free", "reduction"});
  CHECK(machine::slot_names(problem.axes[1]) ==
        Slots{"belt", "pulley_drive", "pulley_idle", "motor", "driver", "reduction"});

  const auto same = checked(problem, tiny.parts(), design, "");
  REQUIRE(same.problems.empty());
  CHECK(reduction_of(same.design, "x") == name);
  CHECK(same.design.cost == Approx(design.cost));
  const std::string other = name == "1:1 belt" ? "3:1 belt" : "1:1 belt";
  const auto swapped = checked(problem, tiny.parts(), design, other);
  REQUIRE(swapped.problems.empty());
  CHECK(reduction_of(swapped.design, "x") == other);
  CHECK(swapped.design.cost == Approx(design.cost + (other == "3:1 belt" ? 7.0 : -7.0)));
  const auto unknown = checked(problem, tiny.parts(), design, "3:1 bell");
  REQUIRE(unknown.problems.size() == 1);
  CHECK(unknown.problems[0].message == "axis 'x' states no reduction '3:1 bell'");
  CHECK(unknown.problems[0].hint.find("3:1 belt") != std::string::npos);
}

TEST_CASE("A bill of materials without the reduction is not complete, but the only one stated needs no line") {
  const TinyCatalogue tiny;
  const auto problems = [&](const std::string& text) {
    const machine::Problem problem = problem_of_text(text);
    Design design = solved(MachineModel(problem, tiny.parts()), "cost");
    std::erase_if(design.parts, [](const auto& part) { return part.slot == "reduction"; });
    return checked(problem, tiny.parts(), design, "").problems;
  };
  const auto missing = problems(two_axes(40.0, belt));
  REQUIRE(missing.size() == 2);
  CHECK(missing[0].message == "axis 'x' has no reduction");
  std::string single = two_axes(40.0, belt);
  const std::size_t from = single.find("[\n  { name");
  single.replace(from, single.find("] }", from) + 1 - from, "{ ratio = 1, efficiency = 0.95 }");
  const auto of_y = problems(single);
  REQUIRE(of_y.size() == 1);
  CHECK(of_y[0].message == "axis 'y' has no reduction");
}

}  // namespace reduction_choice_test
