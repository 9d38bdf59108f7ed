// SPDX-License-Identifier: Apache-2.0
// What the tool gives way, worked by hand with <cmath> only; limits of the whole machine and enforced constraints
// against all builds.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "evaluation/exhaustive.h"
#include "evaluation/hand_worked.h"
#include "evaluation/synthesis.h"
#include "machine/belt_drive.h"
#include "machine/guide_system.h"
#include "machine/member_compliance.h"
#include "machine/screw_drive_quantities.h"
#include "machine/tool_chain.h"

namespace tool_chain_test {

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::MachineModel;
using evaluation::Synthesis;
using machine::Compliance;
using machine::ToolPlace;
using scalar::Interval;

namespace {

constexpr const char* chain = R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V", "36 V"]
{0}
[tool]
axis = "z"
force = {{ x = "80 N", y = "80 N", z = "50 N" }}
deflection = "{1}"
[[axis]]
name = "z"
direction = "vertical"
normal = "y"
stroke = "100 mm"
structure_mass = "1.5 kg"
acceleration_time = "0.2 s"
mechanism = {{ kind = "belt", idler_distance = "60 mm" }}
motor = {{ microsteps = 8, brake_torque = "2 N.m" }}
guide = {{ kinds = ["profile rail"], carriages = 4, carriage_spacing = "80 mm", rail_spacing = "60 mm", tool_at = ["-70 mm", "10 mm", "50 mm"] }}
[[axis.moves]]
distance = "80 mm"
time = "2 s"
[axis.require]
inertia_ratio = 150
[[axis]]
name = "x"
carries = ["z"]
stroke = "300 mm"
structure_mass = "2 kg"
acceleration_time = "0.2 s"
mechanism = {{ kind = "belt", idler_distance = "80 mm" }}
motor = {{ microsteps = 8 }}
guide = {{ kinds = ["profile rail"], carriages = 4, carriage_spacing = "100 mm", rail_spacing = "120 mm", tool_at = ["20 mm", "40 mm", "30 mm"] }}
[[axis.moves]]
distance = "250 mm"
time = "2 s"
[axis.require]
inertia_ratio = 150
{2}
)";

constexpr const char* bed = R"(
[[axis]]
name = "y"
stroke = "200 mm"
structure_mass = "3 kg"
acceleration_time = "0.2 s"
mechanism = { kind = "belt", idler_distance = "80 mm" }
motor = { microsteps = 8 }
guide = { kinds = ["profile rail"], carriages = 4, carriage_spacing = "150 mm", rail_spacing = "160 mm", tool_at = ["0 mm", "5 mm", "15 mm"] }
[[axis.moves]]
distance = "150 mm"
time = "1 s"
)";

machine::Problem machine_with(const std::string& more, const std::string& deflection, const std::string& axes = {}) {
  return problem_of_text(fmt::format(fmt::runtime(chain), more, deflection, axes));
}

Synthesis solved(const MachineModel& model, const std::string& objective) {
  evaluation::SearchOptions options;
  options.objectives = {objective};
  return evaluation::synthesise(model, options);
}

}  // namespace

TEST_CASE("Levers of the tool grow by half of what moves it over the carriages") {
  const machine::Problem problem = machine_with("", "0.5 mm", bed);
  // z carries the tool alone. Seen from it: 70 mm along z, 10 mm across (x), 50 mm off its guides (y).
  const ToolPlace z = machine::tool_place(problem, 0);
  CHECK(z.travel == 2);
  CHECK(z.normal == 1);
  CHECK(z.across == 0);
  CHECK(z.along_arm == Approx(0.070));
  CHECK(z.across_arm == Approx(0.010));
  CHECK(z.height_arm == Approx(0.050));
  // z moves the tool by half of 100 mm over x's carriages, upwards.
  const ToolPlace x = machine::tool_place(problem, 1);
  CHECK(x.along_arm == Approx(0.020));
  CHECK(x.across_arm == Approx(0.040));
  CHECK(x.height_arm == Approx(0.030 + 0.050));
  // Under y, which carries the work, its own travel and those of z and x move the tool.
  const ToolPlace y = machine::tool_place(problem, 2);
  CHECK(y.travel == 1);
  CHECK(y.along_arm == Approx(0.100));
  CHECK(y.across_arm == Approx(0.005 + 0.150));
  CHECK(y.height_arm == Approx(0.015 + 0.050));
}

TEST_CASE("Guides, screws and members give way as worked by hand") {
  ToolPlace place;  // along x, across y, pressing on z
  place.along_arm = 0.02;
  place.across_arm = 0.03;
  place.height_arm = 0.04;
  machine::GuideData guide_data;
  guide_data.choice.carriages = 4.0;
  guide_data.choice.carriage_spacing = 0.1;
  guide_data.choice.rail_spacing = 0.2;
  machine::GuideSystem<double> guide;
  guide.data = &guide_data;
  guide.guide.radial_stiffness = 150e6;
  const double about_y = 150e6 * 0.1 * 0.1, about_x = 150e6 * 0.2 * 0.2;
  const Compliance<double> g4 = tool_compliance(guide, place);
  CHECK(g4[0] == Approx((0.04 * 0.04 + 0.03 * 0.03) / about_y));
  CHECK(g4[1] == Approx(1.0 / 600e6 + 0.04 * 0.04 / about_x + 0.02 * 0.02 / about_y));
  CHECK(g4[2] == Approx(1.0 / 600e6 + 0.03 * 0.03 / about_x + 0.02 * 0.02 / about_y));
  place.drives = 2.0;  // two screws hold the table straight against what stands beside its middle
  place.load_share = 0.8;
  CHECK(tool_compliance(guide, place)[0] == Approx(0.04 * 0.04 / about_y));
  CHECK(machine::sharing_factor(place) == Approx(0.8 * 0.8 + 0.2 * 0.2));

  // Lead screw 5 mm, root 10 mm, 0.5 m long, E 206 GPa, G 80 GPa; bearing 40 N/um, coupling 60 N.m/rad, motor 50 teeth
  // x 1.2 N.m.
  machine::ScrewDriveData screw_data;
  screw_data.has_coupling = true;
  machine::ScrewDrive<double> screw;
  screw.data = &screw_data;
  screw.kind = machine::ScrewKind::sliding;
  screw.screw.lead = 0.005;
  screw.screw.root_diameter = 0.01;
  screw.screw.supported_length = 0.5;
  screw.screw.elastic_modulus = 206e9;
  screw.screw.shear_modulus = 80e9;
  screw.support_fixed.axial_stiffness = 40e6;
  screw.coupling.stiffness = 60.0;
  screw.motor.rotor_teeth = 50.0;
  screw.motor.static_torque = 1.2;
  const double shaft = 0.5 / (206e9 * pi / 4.0 * 1e-4), twist = 0.5 / (80e9 * pi / 32.0 * 1e-8);
  const double per_radian = 0.005 / (2.0 * pi);
  const double one = shaft + 1.0 / 40e6 + per_radian * per_radian * (twist + 1.0 / 60.0 + 1.0 / 60.0);
  place.drives = 1.0;
  place.load_share = 1.0;
  CHECK(tool_compliance(screw, place)[0] == Approx(one));
  CHECK(tool_compliance(screw, place)[1] == 0.0);
  place.drives = 2.0;
  place.load_share = 0.8;
  CHECK(tool_compliance(screw, place)[0] == Approx(0.68 * one));

  // A beam of 0.6 m along x: 4 and 2 cm^4, J 3 cm^4, E 206 GPa, G 80 GPa.
  machine::MemberData beam_data;
  beam_data.member.kind = machine::MemberKind::section_beam;
  beam_data.member.length = 0.6;
  beam_data.member.count = 2.0;
  machine::StructureMember<double> beam;
  beam.data = &beam_data;
  beam.section.elastic_modulus = 206e9;
  beam.section.shear_modulus = 80e9;
  beam.section.strong_second_moment = 4e-8;
  beam.section.weak_second_moment = 2e-8;
  beam.section.torsion_constant = 3e-8;
  const double turn = 0.5 * 0.6 / (4.0 * 80e9 * 3e-8);
  Compliance<double> b = tool_compliance(beam, place);
  CHECK(b[0] == 0.0);
  CHECK(b[1] == Approx(0.5 * 0.216 / (48.0 * 206e9 * 2e-8) + 0.04 * 0.04 * turn));
  CHECK(b[2] == Approx(0.5 * 0.216 / (48.0 * 206e9 * 4e-8) + 0.03 * 0.03 * turn));
  beam_data.member.support = machine::BeamSupport::cantilever;
  b = tool_compliance(beam, place);
  CHECK(b[2] == Approx(0.5 * 0.216 / (3.0 * 206e9 * 4e-8) + 0.03 * 0.03 * 4.0 * turn));
  beam_data.member.kind = machine::MemberKind::column;
  beam.section.area = 5e-4;
  b = tool_compliance(beam, place);
  CHECK(b[0] == 0.0);
  CHECK(b[2] == Approx(0.6 / (2.0 * 206e9 * 5e-4)));

  // A plate of 100 x 10 mm along x. The torsion constant of a rectangle ten times as wide as thick is 0.312 b t^3
  // [timoshenko_elasticity, section 109].
  machine::MemberData plate_data = beam_data;
  plate_data.member.kind = machine::MemberKind::plate;
  plate_data.member.support = machine::BeamSupport::supported;
  plate_data.member.count = 1.0;
  plate_data.member.plate_width = 0.1;
  plate_data.elastic_modulus = 206e9;
  plate_data.shear_modulus = 80e9;
  machine::StructureMember<double> plate;
  plate.data = &plate_data;
  plate.thickness = 0.01;
  plate.derive();
  const double plate_turn = 0.25 * 0.6 / (80e9 * 0.312 * 0.1 * 1e-6);
  b = tool_compliance(plate, place);
  CHECK(b[0] == 0.0);
  CHECK(b[1] == Approx(0.216 / (48.0 * 206e9 * 0.01 * 1e-3 / 12.0) + 0.04 * 0.04 * plate_turn).epsilon(2e-3));
  CHECK(b[2] == Approx(0.216 / (48.0 * 206e9 * 0.1 * 1e-6 / 12.0) + 0.03 * 0.03 * plate_turn).epsilon(2e-3));
}

TEST_CASE("A hundred steps of compliance are permitted however they are added up, the next one is not") {
  constexpr int permitted = 100;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-6.0, 3.0);
  machine::Problem problem = machine_with("", "3 mm");
  for (int sample = 0; sample < 2000; ++sample) {
    problem.tool->deflection = 1e-3 * std::pow(10.0, exponent(random));
    problem.tool->force[2] = std::pow(10.0, exponent(random));
    const double step = machine::tool_place(problem, 0).step[2];
    // Elements that take some steps each, in the order of the machine.
    double compliance = 0.0;
    Interval bounds(0.0);
    for (int left = permitted; left > 0;) {
      const int taken = std::uniform_int_distribution<int>(1, left)(random);
      left -= taken;
      const double value = (taken - 0.5) * step;
      const double counted = machine::whole_steps(value, step, scalar::dimension::none);
      CHECK(counted == Approx(taken * step).epsilon(1e-14));
      compliance += counted;
      bounds = bounds + machine::whole_steps(Interval(value), step, scalar::dimension::none);
    }
    INFO(*problem.tool->deflection << " m, " << problem.tool->force[2] << " N");
    CHECK(problem.tool->force[2] * compliance <= *problem.tool->deflection);
    CHECK((Interval(problem.tool->force[2]) * bounds).upper <= *problem.tool->deflection);
    CHECK((Interval(problem.tool->force[2]) * (bounds + Interval(step))).lower > *problem.tool->deflection);
  }
}

TEST_CASE("The search holds what the tool may give way, and limits of cost and mass, as all builds say") {
  const auto& tiny = parts();
  int refused = 0, found = 0;
  double before = 0.0;
  for (const char* deflection : {"8 mm", "4 mm", "2 mm", "1.5 mm", "1 mm", "0.7 mm", "0.5 mm", "0.02 mm"}) {
    const MachineModel model(machine_with("", deflection), tiny);
    const Exhaustive all(model);
    INFO(deflection << ": " << all.builds.size() << " builds");
    for (const char* objective : {"cost", "mass"}) {
      const Synthesis synthesis = solved(model, objective);
      if (all.builds.empty()) {
        CHECK(synthesis.status == solver::Status::infeasible);
        ++refused;
        continue;
      }
      ++found;
      REQUIRE(synthesis.designs.size() == 1);
      const bool cost = std::string(objective) == "cost";
      CHECK((cost ? synthesis.designs[0].cost : synthesis.designs[0].mass) ==
            Approx(all.least(cost ? &BuildValue::cost : &BuildValue::mass)).epsilon(1e-9));
      CHECK(synthesis.designs[0].satisfied());
    }
    if (all.builds.empty()) continue;
    // Stiffer costs no less.
    CHECK(all.least(&BuildValue::cost) >= before - 1e-9);
    before = all.least(&BuildValue::cost);
  }
  CHECK(refused >= 2);
  CHECK(found >= 6);

  // The cheapest build that may weigh no more than a middling one.
  const MachineModel free(machine_with("", "1 mm"), tiny);
  const Exhaustive all(free);
  const double lightest = all.least(&BuildValue::mass);
  const double limit = 1.2 * lightest;
  double cheapest = std::numeric_limits<double>::infinity();
  for (const BuildValue& build : all.builds)
    if (build.mass <= limit) cheapest = std::min(cheapest, build.cost);
  const MachineModel light(machine_with(fmt::format("[limits]\nmass = \"{:.12g} kg\"", limit), "1 mm"), tiny);
  const Synthesis synthesis = solved(light, "cost");
  REQUIRE(synthesis.designs.size() == 1);
  CHECK(synthesis.designs[0].cost == Approx(cheapest).epsilon(1e-9));
  CHECK(synthesis.designs[0].mass <= limit * (1.0 + 1e-12));
  expect(synthesis.designs[0], "whole", "C-SYS-MASS", synthesis.designs[0].mass, limit);
  const MachineModel cheap(
      machine_with(fmt::format("[limits]\ncost = \"{:.12g} USD\"", 0.999 * all.least(&BuildValue::cost)), "1 mm"),
      tiny);
  CHECK(solved(cheap, "cost").status == solver::Status::infeasible);
}

TEST_CASE("An enforced constraint holds, and costs no less than without") {
  const auto& tiny = parts();
  const MachineModel free(machine_with("", "3 mm"), tiny);
  const Synthesis without = solved(free, "cost");
  REQUIRE(without.designs.size() == 1);
  int violated = 0, enforced_some = 0;
  for (const evaluation::Check& check : without.designs[0].checks) {
    if (check.kind != machine::ConstraintKind::soft || check.axis == "machine") continue;
    if (check.verdict != evaluation::Verdict::violated) continue;
    ++violated;
    const MachineModel model(machine_with(fmt::format("[require]\nenforce = [\"{}\"]", check.id), "3 mm"), tiny);
    INFO(check.id);
    const Exhaustive all(model);
    const Synthesis with = solved(model, "cost");
    if (all.builds.empty()) {
      CHECK(with.status == solver::Status::infeasible);
      continue;
    }
    REQUIRE(with.designs.size() == 1);
    ++enforced_some;
    CHECK(with.designs[0].cost == Approx(all.least(&BuildValue::cost)).epsilon(1e-9));
    CHECK(with.designs[0].cost >= without.designs[0].cost - 1e-9);
    for (const evaluation::Check& held : with.designs[0].checks)
      if (held.id == check.id) {
        CHECK(held.kind == machine::ConstraintKind::hard);
        CHECK(held.verdict == evaluation::Verdict::satisfied);
      }
  }
  CHECK(violated >= 1);
}

}  // namespace tool_chain_test
