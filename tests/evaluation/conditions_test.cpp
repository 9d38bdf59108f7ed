// SPDX-License-Identifier: Apache-2.0
// What of a machine with two axes can be eased, and by how much, where one value counts for both.
#include <algorithm>

#include "catch.h"
#include "evaluation/stated_conditions.h"
#include "evaluation/tiny_catalogue.h"

namespace conditions_test {

using namespace millwright;
using machine::Asked;
using machine::Condition;

namespace {

/// Two turntables; `first` and `second` stand in their tables, `more` before them.
std::string turntables(const std::string& more, const std::string& first, const std::string& second) {
  const auto axis = [](const std::string& name, const std::string& own) {
    return "[[axis]]\nname = \"" + name + "\"\n" + R"(stroke = "360 deg"
structure_inertia = "5e-05 kg.m2"
structure_mass = "1 kg"
acceleration_time = "0.2 s"
mechanism = { kind = "rotary" }
motor = { microsteps = 8 }
)" + own + "\n[[axis.moves]]\ndistance = \"180 deg\"\ntime = \"1 s\"\n";
  };
  return "[currency]\nUSD = 1.0\n[supply]\nvoltage = [\"24 V\"]\n" + more + "\n" + axis("a", first) + axis("b", second);
}

const catalogue::Catalogue& parts() {
  static const TinyCatalogue tiny;
  return tiny.parts();
}

struct Stated : StatedConditions {
  explicit Stated(const std::string& toml) : StatedConditions("m.toml", toml, parts()) {}
  [[nodiscard]] std::vector<Condition> named(const std::string& name) const {
    std::vector<Condition> found;
    for (const Condition& condition : conditions)
      if (condition.name == name) found.push_back(condition);
    return found;
  }
};

/// 20 kg upright; `own` stands in its table, `more` behind it.
std::string lifter(const std::string& own, const std::string& more = {}) {
  return R"([currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "z"
stroke = "300 mm"
direction = "vertical"
structure_mass = "20 kg"
guide_friction = 0.05
mechanism = { kind = "screw", screw = ["ball_screws"] }
)" + own +
         "\n[[axis.moves]]\ndistance = \"200 mm\"\ntime = \"2 s\"\n" + more;
}

constexpr double gravity = 9.80665;

double reserve(const Asked& asked, std::size_t axis) {
  return asked.problem.axes[axis].require(machine::Requirement::supply_reserve);
}

}  // namespace

TEST_CASE("The reserve of the supply is that of the axis that asks for most, and is eased there to none") {
  const Stated stated(turntables("[require]\nsupply_reserve = 1.3", "", "require = { supply_reserve = 12 }"));
  const std::vector<Condition> found = stated.named("supply_reserve");
  REQUIRE(found.size() == 1);
  CHECK(found[0].value == 12.0);
  CHECK(found[0].setting == "axis.b.require.supply_reserve");
  CHECK(found[0].where.line == 27);
  Asked eased = stated.asked;
  found[0].set(eased, 5.0);
  CHECK(reserve(eased, 0) == 1.3);  // as it was: less than that already
  CHECK(reserve(eased, 1) == 5.0);
  found[0].lift(eased);
  CHECK(reserve(eased, 0) == Approx(1.0));
  CHECK(reserve(eased, 1) == Approx(1.0));
}

TEST_CASE("A reserve that is stated for all axes is set for all") {
  const Stated stated(turntables("[require]\nsupply_reserve = 1.5", "", ""));
  const std::vector<Condition> found = stated.named("supply_reserve");
  REQUIRE(found.size() == 1);
  CHECK(found[0].value == 1.5);
  CHECK(found[0].setting == "require.supply_reserve");
}

// A torque_margin that stands alone holds for torques that are only a model, too.
TEST_CASE("A torque margin that nobody stated is eased beside that of modelled torques, which stays as it is") {
  const auto beside = [](const std::string& require) {
    const Stated stated(turntables("", "", require));
    std::vector<std::string> said;
    for (const Condition& condition : stated.named("torque_margin")) said.push_back(condition.beside);
    for (const Condition& condition : stated.named("torque_margin_estimate")) CHECK(condition.beside.empty());
    return said;
  };
  using Said = std::vector<std::string>;
  const std::string a = "axis.a.require.torque_margin_estimate=0.5", b = "axis.b.require.torque_margin_estimate=0.5";
  CHECK(beside("") == Said{a, b});
  CHECK(beside("require = { torque_margin = 0.6 }") == Said{"", a});
  CHECK(beside("require = { torque_margin_estimate = 0.6 }") == Said{a, ""});
}

TEST_CASE("Where less softens a nut that must be stiff, neither forces nor loads are eased") {
  const auto forces_and_loads = [](const std::string& mechanism, const std::string& require) {
    std::string toml = lifter("", "force = \"50 N\"\n" + require);
    const std::string own = "screw = [\"ball_screws\"]";
    toml.replace(toml.find(own), own.size(), mechanism);
    const Stated stated(toml);
    return std::pair(stated.named("force of move 1").size(), stated.named("structure_mass").size());
  };
  const std::string stiff = "[axis.require]\naxial_stiffness = \"30 N/um\"\n";
  const std::pair<std::size_t, std::size_t> both{1, 1}, none{0, 0};
  CHECK(forces_and_loads("screw = [\"ball_screws\"]", "") == both);
  CHECK(forces_and_loads("screw = [\"ball_screws\"]", stiff) == none);
  CHECK(forces_and_loads("screw = [\"ball_screws\"], preload = 0.05", stiff) == both);
  // Ball screws may come in where the kind of screw is eased as well.
  CHECK(forces_and_loads("screw = [\"lead_screws\"]", "") == both);
  CHECK(forces_and_loads("screw = [\"lead_screws\"]", stiff) == none);
  // Nor what rides on it, but its forces.
  const Stated riding(lifter("carries = [\"a\"]", stiff + R"([[axis]]
name = "a"
stroke = "100 mm"
structure_mass = "3 kg"
mechanism = { kind = "screw", screw = ["lead_screws"] }
[[axis.moves]]
distance = "50 mm"
time = "1 s"
force = "10 N"
)"));
  CHECK(riding.named("structure_mass").empty());
  CHECK(riding.named("force of move 1").size() == 1);
}

// Rests take their share of an RMS torque; frequencies have to lie apart, whichever is the higher one.
TEST_CASE("What may fail an enforced check when it is slower or lighter is not eased") {
  using Counts = std::vector<std::size_t>;
  const auto times_forces_masses = [](const std::string& motor, const std::string& enforced) {
    const Stated stated(lifter(motor, "force = \"50 N\"\n" + enforced));
    return Counts{stated.named("time of move 1").size(),
                  stated.named("force of move 1").size(),
                  stated.named("structure_mass").size()};
  };
  const std::string half_steps = "motor = { microsteps = 2 }";
  CHECK(times_forces_masses("", "") == Counts{1, 1, 1});
  CHECK(times_forces_masses("", "[axis.require]\nenforce = [\"C-ST-RMS\"]\n") == Counts{0, 1, 1});
  CHECK(times_forces_masses("", "[axis.require]\nenforce = [\"C-CP-RES\"]\n") == Counts{1, 1, 0});
  CHECK(times_forces_masses("", "[axis.require]\nenforce = [\"C-ST-RES\"]\n") == Counts{1, 1, 1});
  CHECK(times_forces_masses(half_steps, "[axis.require]\nenforce = [\"C-ST-RES\"]\n") == Counts{0, 1, 0});
  CHECK(times_forces_masses(half_steps, "[axis.require]\nenforce = [\"C-ST-TEMP\"]\n") == Counts{1, 1, 1});
}

TEST_CASE("A brake that is stated far too small is eased as far as one that is missing") {
  const auto eased = [](const std::string& brake) {
    const Stated stated(lifter(brake));
    const std::vector<Condition> found = stated.named("brake_torque");
    REQUIRE(found.size() == 1);
    return std::pair(found[0].eased(1.0), found[0].eased(found[0].furthest));
  };
  CHECK(eased("").first == 0.0);
  CHECK(eased("motor = { brake_torque = \"1e-9 N.m\" }").first == Approx(1e-9));
  CHECK(eased("motor = { brake_torque = \"0.9 mN.m\" }").first == Approx(0.9e-3));
  // More than what lifts a tonne by a screw of 100 mm lead: 9806.65 N * 0.1 m / (2 pi).
  for (const char* brake : {"", "motor = { brake_torque = \"1e-9 N.m\" }", "motor = { brake_torque = \"1 mN.m\" }"})
    CHECK(eased(brake).second > 156.0);
}

TEST_CASE("What a counterbalance holds up is lighter until it is held up, and no further") {
  const auto lifted_mass = [](const Stated& stated) {
    const std::vector<Condition> found = stated.named("structure_mass");
    REQUIRE(found.size() == 1);
    Asked lifted = stated.asked;
    found[0].lift(lifted);
    return lifted.problem.axes[0].structure_mass;
  };
  CHECK(lifted_mass(Stated(lifter(""))) < 0.001);
  CHECK(lifted_mass(Stated(lifter("counterbalance_force = \"100 N\""))) == Approx(100.0 / gravity));
  // More than its weight pushes it up as it is.
  CHECK(Stated(lifter("counterbalance_force = \"200 N\"")).named("structure_mass").empty());
}

TEST_CASE("So is what an axis weighs that a counterbalanced one carries, all of it together") {
  const Stated stated(lifter("carries = [\"a\"]\ncounterbalance_force = \"100 N\"", R"([[axis]]
name = "a"
stroke = "360 deg"
structure_inertia = "5e-05 kg.m2"
structure_mass = "1 kg"
mechanism = { kind = "rotary" }
[[axis.moves]]
distance = "180 deg"
time = "1 s"
)"));
  Asked lifted = stated.asked;
  const std::vector<Condition> masses = stated.named("structure_mass");
  REQUIRE(masses.size() == 2);
  for (const Condition& mass : masses) mass.lift(lifted);
  CHECK((lifted.problem.axes[0].structure_mass + lifted.problem.axes[1].structure_mass) * gravity == Approx(100.0));
  CHECK(stated.named("structure_inertia").size() == 1);
}

TEST_CASE("The speed of a move that has a time, too, is no condition: slower it may be late") {
  const auto speeds = [](const std::string& time) {
    std::string text = turntables("", "", "");
    const std::size_t at = text.rfind("time = ");
    return Stated(text.substr(0, at) + "speed = \"600 deg/s\"\n" + time).named("speed of move 1").size();
  };
  CHECK(speeds("") == 1);
  CHECK(speeds("time = \"1 s\"\n") == 0);
}

TEST_CASE("A list of motor currents is lifted to one that has its own as well") {
  std::string text = turntables("", "", "");
  text.replace(text.find("microsteps = 8"), 14, "microsteps = 8, current = [\"0.55 A\", \"1.1 A\"]");
  const Stated stated(text);
  const std::vector<Condition> found = stated.named("motor current");
  REQUIRE(found.size() == 1);
  Asked lifted = stated.asked;
  found[0].lift(lifted);
  const std::vector<double>& currents = lifted.problem.axes[0].motor.currents;
  CHECK(std::is_sorted(currents.begin(), currents.end()));
  CHECK(std::count(currents.begin(), currents.end(), 0.55) == 1);
  CHECK(std::count(currents.begin(), currents.end(), 1.1) == 1);
  CHECK(currents.size() > 2);
  CHECK(lifted.problem.axes[1].motor.currents.empty());
}

}  // namespace conditions_test
