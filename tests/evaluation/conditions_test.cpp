// SPDX-License-Identifier: Apache-2.0
// What of a machine with two axes can be eased, and by how much, where one value counts for both.
#include <algorithm>

#include "catch.h"
#include "evaluation/tiny_catalogue.h"
#include "machine/condition.h"
#include "machine/problem_file.h"

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

struct Stated {
  explicit Stated(const std::string& toml) {
    text::Diagnostics diagnostics;
    const auto document = text::read_toml(text::SourceText::from_string("m.toml", toml), diagnostics);
    REQUIRE(document.has_value());
    const auto problem = machine::problem_of(*document, diagnostics);
    INFO(text::format(diagnostics));
    REQUIRE(problem.has_value());
    asked.problem = *problem;
    conditions = machine::conditions_of(asked, *document, tiny.parts());
  }
  [[nodiscard]] std::vector<Condition> named(const std::string& name) const {
    std::vector<Condition> found;
    for (const Condition& condition : conditions)
      if (condition.name == name) found.push_back(condition);
    return found;
  }

  TinyCatalogue tiny;
  Asked asked;
  std::vector<Condition> conditions;
};

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

// 20 kg that 200 N nearly hold up are lighter than nothing once they are lifted off.
TEST_CASE("What a counterbalance holds up is no condition: less of it is not easier") {
  const std::string lift = R"([currency]
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
)";
  const std::string moves = "[[axis.moves]]\ndistance = \"200 mm\"\ntime = \"2 s\"\n";
  CHECK(Stated(lift + moves).named("structure_mass").size() == 1);
  CHECK(Stated(lift + "counterbalance_force = \"200 N\"\n" + moves).named("structure_mass").empty());
}

TEST_CASE("Nor is what an axis weighs that a counterbalanced one carries") {
  const std::string both = R"([currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "z"
stroke = "300 mm"
direction = "vertical"
carries = ["a"]
structure_mass = "20 kg"
guide_friction = 0.05
counterbalance_force = "200 N"
mechanism = { kind = "screw", screw = ["ball_screws"] }
[[axis.moves]]
distance = "200 mm"
time = "2 s"
[[axis]]
name = "a"
stroke = "360 deg"
structure_inertia = "5e-05 kg.m2"
structure_mass = "1 kg"
mechanism = { kind = "rotary" }
[[axis.moves]]
distance = "180 deg"
time = "1 s"
)";
  const Stated stated(both);
  CHECK(stated.named("structure_mass").empty());
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
