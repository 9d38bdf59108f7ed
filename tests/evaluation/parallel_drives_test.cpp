// SPDX-License-Identifier: Apache-2.0
// Several equal drives on one axis: each is a single drive with its share of mass and forces; parts, price, mass and
// power count as often as there are drives.
#include <fmt/format.h>

#include <functional>

#include "catch.h"
#include "evaluation/design_bill.h"
#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"

namespace parallel_drives_test {

using namespace millwright;
using evaluation::BomCheck;
using evaluation::Design;

namespace {

const catalogue::Catalogue& parts() {
  static const TinyCatalogue tiny;
  return tiny.parts();
}

/// One axis without guide, so that the load on the drives is what is written here.
std::string axis_with(const std::string& mechanism, double mass, double force) {
  return fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
stroke = "300 mm"
structure_mass = "{} kg"
guide_friction = 0.05
acceleration_time = "0.2 s"
mechanism = {{ {} }}
motor = {{ microsteps = 8 }}
[[axis.moves]]
distance = "200 mm"
time = "8 s"
force = "{} N"
[axis.require]
inertia_ratio = 300
)",
                     mass,
                     mechanism,
                     force);
}

const char* const screw = R"(kind = "screw", screw = ["ball_screws", "lead_screws"])";
const char* const belt = R"(kind = "belt")";

Design cheapest(const std::string& problem) {
  const evaluation::MachineModel model(problem_of_text(problem), parts());
  const auto solved = evaluation::synthesise(model, {});
  REQUIRE(solved.designs.size() == 1);
  return solved.designs.front();
}

/// The bill of one machine on another; pieces as the other machine takes them.
Design on(const std::string& problem, machine::BillOfMaterials bom) {
  for (auto& line : bom.lines) line.quantity.reset();
  const BomCheck result = evaluation::check(problem_of_text(problem), parts(), bom, false, {});
  for (const auto& p : result.problems) UNSCOPED_INFO(p.message);
  REQUIRE(result.problems.empty());
  return result.design;
}

double mass_of_axis(const Design& design) {
  double sum = 0.0;
  for (const auto& part : design.parts)
    if (part.axis == "x") sum += part.mass;
  return sum;
}

}  // namespace

TEST_CASE("Each of several drives is a single drive with its share of the load") {
  for (const char* mechanism : {screw, belt}) {
    for (const auto& [count, share] : {std::pair{2, 0.5}, {3, 1.0 / 3.0}, {2, 0.75}}) {
      CAPTURE(mechanism, count, share);
      const double load = mechanism == screw ? 12.0 : 2.0, force = mechanism == screw ? 60.0 : 6.0;
      const std::string several =
          axis_with(fmt::format("{}, drives = {}, load_share = {:.17g}", mechanism, count, share), load, force);
      const std::string one = axis_with(mechanism, load * share, force * share);
      const Design a = cheapest(several);
      const Design b = on(one, evaluation::bill_of(a));
      REQUIRE(a.checks.size() == b.checks.size());
      std::size_t compared = 0;
      for (std::size_t i = 0; i < a.checks.size(); ++i) {
        if (a.checks[i].axis != "x") continue;
        INFO(a.checks[i].id);
        CHECK(a.checks[i].utilisation == Approx(b.checks[i].utilisation).epsilon(1e-9).margin(1e-12));
        ++compared;
      }
      CHECK(compared > 10);
      CHECK(mass_of_axis(a) == Approx(count * mass_of_axis(b)).epsilon(1e-12));
    }
  }
}

TEST_CASE("Several drives draw as much more power from the supply") {
  const std::string two = axis_with(fmt::format("{}, drives = 2", screw), 12.0, 60.0);
  const Design a = cheapest(two);
  const Design b = on(axis_with(screw, 6.0, 30.0), evaluation::bill_of(a));
  const auto value_of = [](const Design& design, std::string_view id) {
    for (const auto& check : design.checks)
      if (check.id == id) return check.value;
    throw std::runtime_error("no supply check");
  };
  for (const char* id : {"C-PSU-POWER", "C-PSU-CURRENT"})
    CHECK(value_of(a, id) == Approx(2.0 * value_of(b, id)).epsilon(1e-12));
}

TEST_CASE("A bill with fewer or shorter pieces than the axis takes is refused") {
  const std::string two = axis_with(fmt::format("{}, drives = 2", screw), 12.0, 60.0);
  const auto problems_with = [&](const std::function<void(machine::BomLine&)>& change) {
    machine::BillOfMaterials bom = evaluation::bill_of(cheapest(two));
    for (auto& line : bom.lines) change(line);
    std::string said;
    for (const auto& p : evaluation::check(problem_of_text(two), parts(), bom, false, {}).problems)
      said += p.message + "\n";
    return said;
  };
  CHECK(problems_with([](machine::BomLine&) {}).empty());
  CHECK(problems_with([](machine::BomLine& line) {
          if (line.slot == "motor") line.quantity = 3.0;  // a spare
        }).empty());
  CHECK(problems_with([](machine::BomLine& line) {
          if (line.slot == "motor") line.quantity = 1.0;
        }).find("the motor of axis 'x' takes 2") != std::string::npos);
  CHECK(problems_with([](machine::BomLine& line) {
          if (line.slot == "screw") line.length = 0.3;
        }).find("is cut to 300 mm") != std::string::npos);
}

TEST_CASE("A bill with more or longer pieces than the axis takes is told that they are not priced") {
  const std::string two = axis_with(fmt::format("{}, drives = 2", screw), 12.0, 60.0);
  const machine::BillOfMaterials whole = evaluation::bill_of(cheapest(two));
  const auto remarks_with = [&](const std::function<void(machine::BomLine&)>& change) {
    machine::BillOfMaterials bom = whole;
    for (auto& line : bom.lines) change(line);
    const auto outcome = evaluation::check(problem_of_text(two), parts(), bom, false, {});
    CHECK(outcome.problems.empty());
    CHECK(outcome.design.cost == Approx(cheapest(two).cost));
    std::vector<std::string> said;
    for (const auto& remark : outcome.remarks) said.push_back(remark.message);
    return said;
  };
  CHECK(remarks_with([](machine::BomLine&) {}).empty());
  const auto motors = remarks_with([](machine::BomLine& line) {
    if (line.slot == "motor") line.quantity = 3.0;
  });
  REQUIRE(motors.size() == 1);
  CHECK(motors.front().starts_with("3 of '"));
  CHECK(motors.front().ends_with("and the motor of axis 'x' takes 2: no more is priced and weighed"));
  const auto screws = remarks_with([](machine::BomLine& line) {
    if (line.slot == "screw") line.length = 5.0;
  });
  REQUIRE(screws.size() == 1);
  CHECK(screws.front().find("is cut to 5000 mm, and the screw of axis 'x' takes ") != std::string::npos);
}

TEST_CASE("A share below an equal one is refused, with the least that makes sense") {
  try {
    (void)problem_of_text(axis_with(fmt::format("{}, drives = 2, load_share = 0.4", screw), 1.0, 1.0));
    FAIL("accepted");
  } catch (const std::runtime_error& error) {
    CHECK(std::string(error.what()).find("at least 1/2 = 0.5") != std::string::npos);
  }
}

}  // namespace parallel_drives_test
