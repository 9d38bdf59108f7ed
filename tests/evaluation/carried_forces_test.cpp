// SPDX-License-Identifier: Apache-2.0
// What the guides of an axis bear of the process forces of the axes above it.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "evaluation/hand_worked.h"
#include "machine/carried_forces.h"

namespace carried_forces_test {

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::Check;
using evaluation::Design;
using evaluation::MachineModel;
using machine::CarriedForces;

namespace {

std::string axis(const char* name, const std::string& more, const char* force) {
  return fmt::format(
      "[[axis]]\nname = \"{}\"\nstroke = \"100 mm\"\nstructure_mass = \"2 kg\"\nacceleration_time = \"0.1 s\"\n"
      "mechanism = {{ kind = \"belt\", idler_distance = \"80 mm\" }}\n{}\n"
      "[[axis.moves]]\ndistance = \"50 mm\"\ntime = \"1 s\"\nforce = \"{}\"\n",
      name,
      more,
      force);
}

const std::string head = "[currency]\nUSD = 1.0\n[supply]\nvoltage = [\"24 V\"]\n";

/// x carries y, which carries z; z drills with 80 N, y mills with 60 N, x with 50 N. `of_x` are more keys of x.
std::string portal_mill(const std::string& of_x, const std::string& of_y = "", const char* drilling = "80 N") {
  return head + axis("z", "direction = \"vertical\"", drilling) + axis("y", "carries = [\"z\"]\n" + of_y, "60 N") +
         axis("x", "carries = [\"y\"]\n" + of_x, "50 N");
}

const std::string guide =
    "guide = { rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = \"200 mm\", "
    "load_offset_x = \"20 mm\", load_offset_y = \"30 mm\", force_height = \"40 mm\" }";

CarriedForces forces_on(const std::string& text, std::size_t axis) {
  return machine::carried_forces(problem_of_text(text), axis);
}

}  // namespace

TEST_CASE("Forces of carried axes press on guides, or draw across them, by their direction") {
  const CarriedForces lying = forces_on(portal_mill(guide), 2);
  CHECK(lying.pressing == Approx(80.0));
  CHECK(lying.sideways == Approx(60.0));
  CHECK(lying.along_arm == Approx(0.02));
  CHECK(lying.across_arm == Approx(0.03));
  CHECK(lying.height_arm == Approx(0.04));
  CHECK(lying.own_across_arm == Approx(0.03));
  CHECK(lying.own_height_arm == Approx(0.04));
  // Where it is said where the tool stands the axis's own force acts there.
  std::string at_tool = guide;
  at_tool.insert(at_tool.size() - 2, ", tool_at = [\"10 mm\", \"-300 mm\", \"70 mm\"]");
  const CarriedForces aside = forces_on(portal_mill(at_tool), 2);
  CHECK(aside.own_across_arm == Approx(0.3));
  CHECK(aside.own_height_arm == Approx(0.07));
  CHECK(aside.across_arm == Approx(0.03));
  // Its own force is the drive's, and what it is carried by is below it.
  const CarriedForces of_y = forces_on(portal_mill("", guide), 1);
  CHECK(of_y.pressing == Approx(80.0));
  CHECK(of_y.sideways == 0.0);
  // On a face the drill draws across the rails, and the cut along y presses.
  const CarriedForces on_face = forces_on(portal_mill(guide + "\nnormal = \"y\""), 2);
  CHECK(on_face.pressing == Approx(60.0));
  CHECK(on_face.sideways == Approx(80.0));
  // Of several moves the largest, of a recording its largest either way.
  machine::Problem problem = problem_of_text(portal_mill(guide));
  problem.axes[0].moves.push_back(problem.axes[0].moves[0]);
  problem.axes[0].moves[1].force = -90.0;
  CHECK(machine::carried_forces(problem, 2).pressing == Approx(90.0));
  problem.axes[1].moves[0].profile = machine::measured_profile(
      std::vector{0.0, 1.0, 2.0}, std::vector{0.0, 0.1, 0.0}, std::vector{-75.0, -75.0, -75.0});
  CHECK(machine::carried_forces(problem, 2).sideways == Approx(75.0));
}

TEST_CASE("A table's own torque is no force on the guides below it") {
  std::string text = portal_mill(guide);
  text +=
      "[[axis]]\nname = \"b\"\nstroke = \"100 mm\"\nstructure_mass = \"2 kg\"\nacceleration_time = \"0.1 s\"\n"
      "carries = [\"a\"]\nmechanism = { kind = \"belt\", idler_distance = \"80 mm\" }\n" +
      guide +
      "\n[[axis.moves]]\ndistance = \"50 mm\"\ntime = \"1 s\"\n"
      "[[axis]]\nname = \"a\"\nstroke = \"90 deg\"\nstructure_inertia = \"1e-3 kg.m2\"\nstructure_mass = \"1 "
      "kg\"\nacceleration_time = \"0.1 s\"\nmechanism = { kind = \"rotary\" }\n"
      "[[axis.moves]]\ndistance = \"90 deg\"\ntime = \"1 s\"\ntorque = \"2 N.m\"\n";
  const CarriedForces forces = forces_on(text, 3);
  CHECK(forces.pressing == 0.0);
  CHECK(forces.sideways == 0.0);
}

TEST_CASE("Guides below a drill are loaded by it, worked by hand") {
  const auto loaded = [&](const std::string& of_guide, const char* drilling) {
    const MachineModel model(problem_of_text(portal_mill(of_guide, "", drilling)), parts());
    const Design d = design_of(model, {{"x", "guide", {{"R12"}}, {}}});
    const auto found = std::find_if(d.checks.begin(), d.checks.end(), [](const Check& check) {
      return check.axis == "x" && check.id == "C-GD-STATIC";
    });
    REQUIRE(found != d.checks.end());
    return found->value / 2.0;  // static safety 2
  };
  // Each of four carriages a quarter; tilting by 20 mm over 100 mm, rolling by 30 mm over 200 mm.
  const double share = 0.25 + 0.02 / 0.2 + 0.03 / 0.4;
  CHECK(loaded(guide, "80 N") - loaded(guide, "0 N") == Approx(80.0 * share).epsilon(1e-9));
  // On a face the drill draws across: rolling by 40 mm over 200 mm, yawing by 20 mm over 100 mm.
  const std::string face = guide + "\nnormal = \"y\"";
  const double across = 0.25 + 0.04 / 0.4 + 0.02 / 0.2;
  CHECK(loaded(face, "80 N") - loaded(face, "0 N") == Approx(80.0 * across).epsilon(1e-9));
  // Where the problem says where the tool stands, its levers count: 50 mm along, 60 mm across and half of y's stroke.
  const std::string at = guide.substr(0, guide.size() - 1) + ", tool_at = [\"50 mm\", \"60 mm\", \"70 mm\"] }";
  const machine::Problem without = problem_of_text(portal_mill(at));
  CHECK(machine::carried_forces(without, 2).along_arm == Approx(0.02));  // no tool that stands there
  machine::Problem with = without;
  with.tool.emplace();
  with.tool->axis = 0;
  const CarriedForces forces = machine::carried_forces(with, 2);
  CHECK(forces.along_arm == Approx(0.05));
  CHECK(forces.across_arm == Approx(0.06 + 0.05));
  CHECK(forces.height_arm == Approx(0.07 + 0.05));
}

// 50 mm in 1 s with ramps of 0.1 s: 0.0556 m/s, 0.556 m/s2 upwards while it goes up or stops on its way down.
TEST_CASE("On the guides of an axis that another lifts it weighs more while that one speeds up") {
  const auto load = [](const std::string& direction) {
    const std::string lifted =
        "guide = { rails = 2, carriages = 4, carriage_spacing = \"100 mm\", rail_spacing = "
        "\"200 mm\" }";
    const MachineModel model(problem_of_text(head + axis("x", lifted, "0 N") +
                                             axis("z", "direction = \"" + direction + "\"\ncarries = [\"x\"]", "0 N")),
                             parts());
    const Design d = design_of(model, {{"x", "guide", {{"R12"}}, {}}});
    for (const Check& check : d.checks)
      if (check.axis == "x" && check.id == "C-GD-STATIC") return check.value;
    return 0.0;
  };
  CHECK(load("vertical") / load("horizontal") == Approx((g + 0.05 / 0.9 / 0.1) / g).epsilon(1e-9));
}

}  // namespace carried_forces_test
