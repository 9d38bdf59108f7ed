// SPDX-License-Identifier: Apache-2.0
// Position errors: of a ball screw without preload worked by hand, mapped by the controller, and added up at the tool.
// The right-hand sides use <cmath> and nothing of the project.
#include <cmath>
#include <map>

#include "evaluation/exhaustive.h"
#include "evaluation/hand_worked.h"
#include "evaluation/synthesis.h"
#include "evaluation/ways_out.h"

namespace error_budget_test {

using namespace millwright;
using namespace millwright::hand_worked;
using evaluation::Check;
using evaluation::Design;
using evaluation::MachineModel;

namespace {

std::string ball_screw_axis(const std::string& position_error, const std::string& force, const std::string& more = {}) {
  return fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
stroke = "400 mm"
structure_mass = "20 kg"
guide_friction = 0.05
guide_drag = "4 N"
acceleration_time = "0.2 s"
mechanism = {{ kind = "screw", screw = ["ball_screws"], ends = "fixed-supported" }}
motor = {{ microsteps = 8 }}
[[axis.moves]]
distance = "300 mm"
time = "10.2 s"
force = "{}"
[axis.require]
position_error = {{ {} }}
{}
)",
                     force,
                     position_error,
                     more);
}

Design design_with(const std::string& text) {
  const MachineModel model(problem_of_text(text), parts());
  return design_of(model, {{"x", "drive", {{"B16x5"}, {"M23", "D4"}, {"K8"}, {"F6"}, {"S6"}}, {}}});
}

/// Contributions to the budget [um], by name.
std::map<std::string, double> budget(const Design& design) {
  std::map<std::string, double> result;
  for (const Check& check : design.checks)
    if (check.id == "C-ACC-TOTAL")
      for (const auto& part : check.contributions) result[part.what] = part.value;
  return result;
}

const Check& total(const Design& design) {
  for (const Check& check : design.checks)
    if (check.id == "C-ACC-TOTAL") return check;
  FAIL("no budget");
  return design.checks.front();
}

double sum(const std::map<std::string, double>& parts_of) {
  double systematic = 0.0;
  for (const auto& [what, value] : parts_of)
    if (what != "step" && what != "resolution") systematic += value;
  return systematic + std::hypot(parts_of.at("step"), parts_of.at("resolution"));
}

}  // namespace

TEST_CASE("The errors of a ball screw without preload, worked by hand") {
  const Design d = design_with(ball_screw_axis("limit = \"0.3 mm\", over = \"600 mm\"", "50 N"));
  const auto errors = budget(d);
  CHECK(errors.at("lead") == Approx(2.0 * 50.0));                  // 50 um in 300 mm
  CHECK(errors.at("thermal growth") == Approx(12.0 * 0.6 * 5.0));  // 12 um/(m K), 5 K
  // Shaft and bearing in a row, and the nut, which is softer under a small load: 200 N/um at 30 % of 8000 N, 0.8 for
  // its body, growing with the cube root of the load.
  const double supported = 0.4 + 0.02 + 0.04, shaft = 206e9 * pi / 4.0 * 0.013 * 0.013 / supported;
  const auto give = [&](double force) {
    return 1e6 * force * (1.0 / shaft + 1.0 / 40e6 + 1.0 / (0.8 * 200e6 * std::cbrt(force / 2400.0)));
  };
  const double friction = 4.0 + 0.05 * 20.25 * g;
  CHECK(errors.at("reversal") == Approx(50.0 + 2.0 * give(friction)));  // play of a nut without preload: 0.05 mm
  CHECK(errors.at("under force") == Approx(give(50.0)));
  CHECK(errors.at("step") == Approx(0.05 * 25.0));  // of 5 mm in 200 steps
  CHECK(errors.at("resolution") == Approx(0.5 * 25.0 / 8.0));
  CHECK(total(d).value == Approx(sum(errors)));
  CHECK(total(d).limit == Approx(300.0));
  CHECK(total(d).position == "nut farthest from the fixed bearing");
  // Without a process force nothing is deflected by one.
  CHECK(budget(design_with(ball_screw_axis("limit = \"0.3 mm\", over = \"600 mm\"", "0 N"))).count("under force") == 0);
}

TEST_CASE("What the controller maps counts with what is left in 300 mm, whatever the travel") {
  for (const char* over : {"100 mm", "600 mm"}) {
    const std::string limit = fmt::format("limit = \"0.3 mm\", over = \"{}\"", over);
    const auto made = budget(design_with(ball_screw_axis(limit + ", lead_error = \"as made\"", "50 N")));
    auto mapped = budget(design_with(ball_screw_axis(limit + ", lead_error = \"mapped\"", "50 N")));
    auto known =
        budget(design_with(ball_screw_axis(limit + ", lead_error = \"mapped\"", "50 N", "mapped_lead_error = 0.3")));
    CHECK(made.at("lead") == Approx(std::string(over) == "100 mm" ? 50.0 : 100.0));
    CHECK(mapped.at("lead") == Approx(25.0));
    CHECK(known.at("lead") == Approx(15.0));
    mapped["lead"] = known["lead"] = made.at("lead");  // and nothing else changes
    CHECK(mapped == made);
    CHECK(known == made);
  }
}

TEST_CASE("A map leaves no more of a pitch error than there was") {
  std::string text =
      axis_text("horizontal",
                "",
                "[axis.require]\nposition_error = { limit = \"1 mm\", over = \"50 mm\", lead_error = \"mapped\" }");
  // A belt is off by 0.2 mm in a metre: 10 um in 50 mm, and half of that in 300 mm would be 30 um.
  CHECK(budget(design_of(MachineModel(problem_of_text(text), parts()), {})).at("pitch") == Approx(10.0));
  text.replace(text.find("50 mm\", lead"), 5, "900 mm");
  CHECK(budget(design_of(MachineModel(problem_of_text(text), parts()), {})).at("pitch") == Approx(30.0));
  // What the machine says is taken back for an axis.
  const std::string made = ball_screw_axis("limit = \"0.3 mm\", over = \"600 mm\", lead_error = \"as made\"", "50 N");
  CHECK(budget(design_with("[require]\nmapped_lead_error = 0.5\n" + made)).at("lead") == Approx(100.0));
  CHECK_THROWS(design_with(ball_screw_axis("limit = \"0.3 mm\"", "50 N", "mapped_lead_error = 1.5")));
}

TEST_CASE("The position error at the tool: what the axes are wrong by, and what gives way") {
  const auto machine = [](const std::string& error) {
    return problem_of_text(ball_screw_axis("limit = \"0.3 mm\", over = \"300 mm\"",
                                           "50 N",
                                           fmt::format("[tool]\naxis = \"x\"\nforce = {{ x = \"80 N\" }}\n"
                                                       "deflection = \"1 mm\"\n{}",
                                                       error)));
  };
  const MachineModel model(machine("position_error = \"0.25 mm\""), parts());
  const Design d = design_of(model, {{"x", "drive", {{"B16x5"}, {"M23", "D4"}, {"K8"}, {"F6"}, {"S6"}}, {}}});
  auto errors = budget(d);
  errors.erase("under force");  // the tool's own force takes its place
  double deflection = 0.0, at_tool = 0.0;
  for (const Check& check : d.checks) {
    if (check.id == "C-TOOL-DEFL-X") deflection = check.value;
    if (check.id == "C-TOOL-ERROR-X") {
      at_tool = check.value;
      CHECK(check.limit == Approx(250.0));
    }
    CHECK(check.id != "C-TOOL-ERROR-Y");  // nothing travels there
  }
  CHECK(deflection > 0.0);
  // Rounded up to whole hundredths of what is permitted.
  CHECK(at_tool == Approx(deflection + 2.5 * std::ceil(sum(errors) / 2.5)));
  CHECK(at_tool >= deflection + sum(errors));

  // The search holds it as all builds say.
  int refused = 0, found = 0;
  for (const char* limit : {"300 um", "150 um", "120 um", "110 um", "105 um", "100 um", "60 um"}) {
    const MachineModel limited(machine(fmt::format("position_error = \"{}\"", limit)), parts());
    const Exhaustive all(limited);
    INFO(limit << ": " << all.builds.size() << " builds");
    const auto synthesis = evaluation::synthesise(limited, {});
    if (all.builds.empty()) {
      CHECK(synthesis.status == solver::Status::infeasible);
      ++refused;
      continue;
    }
    ++found;
    REQUIRE(synthesis.designs.size() == 1);
    CHECK(synthesis.designs[0].cost == Approx(all.least(&BuildValue::cost)).epsilon(1e-9));
    CHECK(synthesis.designs[0].satisfied());
  }
  CHECK(refused >= 1);
  CHECK(found >= 2);
}

TEST_CASE("Checks said to fail whatever is chosen do so in every build, and the way out is the least") {
  const auto machine = [](double limit, const char* lead) {
    return problem_of_text(ball_screw_axis(
        fmt::format("limit = \"{:.12g} um\", over = \"600 mm\", lead_error = \"{}\"", limit, lead), "50 N"));
  };
  const MachineModel strict(machine(20.0, "as made"), parts());
  CHECK(Exhaustive(strict).builds.empty());
  const auto unmet = evaluation::unmet_checks(strict);
  REQUIRE(unmet.size() == 2);
  for (const auto& check : unmet) {
    CHECK(check.axis == "x");
    CHECK((check.id == "C-ACC-TOTAL" || check.id == "C-BS-LEAD"));
    // Of the only ball screw, 50 um in 300 mm; the budget has its thermal growth and play at least beside it.
    if (check.id == "C-BS-LEAD") CHECK(check.least_utilisation == Approx(100.0 / 20.0));
    if (check.id == "C-ACC-TOTAL") CHECK(check.least_utilisation >= (100.0 + 36.0) / 20.0);
  }
  const auto ways = evaluation::ways_out(strict, unmet, {});
  REQUIRE(ways.size() == 2);
  for (const auto& way : ways) {
    REQUIRE(way.changes.size() == 1);
    CHECK(way.changes[0].from == Approx(20e-6));
    CHECK(way.changes[0].over == Approx(0.6));
    const char* lead = way.mapped ? "mapped" : "as made";
    const MachineModel enough(machine(1e6 * way.changes[0].to, lead), parts());
    CHECK(Exhaustive(enough).least(&BuildValue::cost) == Approx(way.cost).epsilon(1e-9));
    const MachineModel less(machine(1e6 * way.changes[0].to / 1.011, lead), parts());
    CHECK(Exhaustive(less).builds.empty());
  }
  CHECK(ways[1].changes[0].to < ways[0].changes[0].to);
  CHECK(ways[0].least);
  // The cheapest way out is asked for whatever the machine was to be best by.
  const MachineModel lightest(machine(20.0, "as made"), parts(), {}, {.objectives = {"mass"}});
  const auto same_ways = evaluation::ways_out(lightest, unmet, {});
  REQUIRE(same_ways.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) CHECK(same_ways[i].cost == ways[i].cost);
  // Where all is mapped already there is one way, and without time there is none.
  const MachineModel mapped(machine(20.0, "mapped"), parts());
  const auto one_way = evaluation::ways_out(mapped, evaluation::unmet_checks(mapped), {});
  REQUIRE(one_way.size() == 1);
  CHECK(one_way[0].mapped);
  CHECK(one_way[0].changes[0].to == Approx(ways[1].changes[0].to).epsilon(0.01));
  evaluation::SearchOptions hurried;
  hurried.time_limit_seconds = 0.0;
  CHECK(evaluation::ways_out(strict, unmet, hurried).empty());
  // Where something is compliant no check can fail always.
  CHECK(evaluation::unmet_checks(MachineModel(machine(300.0, "as made"), parts())).empty());
}

}  // namespace error_budget_test
