// SPDX-License-Identifier: Apache-2.0
// The next best builds of small machines, and builds with parts fixed or left out, against all of their builds.
#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <set>

#include "catch.h"
#include "evaluation/exhaustive.h"
#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"
#include "sanitized.h"

namespace alternatives_test {

using namespace millwright;
using evaluation::Design;
using evaluation::MachineModel;
using evaluation::ModelOptions;
using evaluation::SearchOptions;
using evaluation::Synthesis;

namespace {

/// A slide that a screw drives, of which little is asked, so that many builds comply.
machine::Problem slide(double load, const std::string& motor = "{ microsteps = 8 }") {
  return problem_of_text(fmt::format(R"(
[supply]
voltage = ["24 V", "36 V"]
[[axis]]
name = "x"
stroke = "200 mm"
structure_mass = "{} kg"
guide_friction = 0.1
acceleration_time = ["0.05 s", "0.3 s"]
mechanism = {{ kind = "screw", screw = ["ball_screws", "lead_screws"], ends = "fixed-supported" }}
motor = {}
[[axis.moves]]
distance = "150 mm"
time = "6 s"
force = "40 N"
[axis.require]
inertia_ratio = 20
)",
                                     load,
                                     motor));
}

/// The same prices in every catalogue of this seed, but for one part.
Vary prices(unsigned seed, const std::string& dear = {}) {
  return [seed, dear](const std::string& part, PriceAndMass usual) {
    std::seed_seq seeds(part.begin(), part.end());
    std::vector<unsigned> word(1);
    seeds.generate(word.begin(), word.end());
    std::mt19937 random(word[0] ^ (seed * 2654435761U));
    const auto factor = [&](double most) {
      return std::pow(most, 2.0 * static_cast<double>(random() >> 8U) / 16777216.0 - 1.0);
    };
    const double price = usual.price * factor(3.0);
    return PriceAndMass{dear == part ? 1e6 : price, usual.mass * factor(3.0)};
  };
}

machine::BomLine part_line(const char* slot, const std::string& part_number) {
  machine::BomLine line;
  line.axis = "x";
  line.slot = slot;
  line.manufacturer = "tiny";
  line.part_number = part_number;
  return line;
}

machine::BomLine value_line(const char* axis, const char* slot, double value) {
  machine::BomLine line;
  line.axis = axis;
  line.slot = slot;
  line.value = value;
  return line;
}

Synthesis best(const MachineModel& model, std::size_t builds, const std::string& objective = "cost") {
  SearchOptions options;
  options.objectives = {objective};
  options.builds = builds;
  return evaluation::synthesise(model, options);
}

std::string part_of(const Design& design, const std::string& slot) {
  for (const auto& part : design.parts)
    if (part.slot == slot) return part.part_number;
  return {};
}

/// Voltage and parts.
std::string parts_of(const Design& design) {
  std::string all = fmt::format("{}", design.supply_voltage);
  for (const auto& part : design.parts) all += "," + part.axis + part.slot + part.part_number;
  return all;
}

/// What makes a build another one.
std::string identity(const Design& design) {
  std::string all = parts_of(design);
  for (const auto& line : design.dimensions)
    if (line.name == "motor_current") all += fmt::format(",{}", line.value);
  return all;
}

/// Decides between builds of equal cost and mass.
double worst_utilisation(const Design& design) {
  double worst = 0.0;
  for (const auto& check : design.checks)
    if (check.kind == machine::ConstraintKind::hard) worst = std::max(worst, check.utilisation);
  return worst;
}

/// How many rows others cover.
std::size_t covered_rows(const MachineModel& model) {
  std::size_t rows = 0;
  for (std::size_t stage = 0; stage < model.problem().stages.size(); ++stage) {
    const auto slots = model.problem().stages[stage]->slots();
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
      for (solver::Row row = 0; row < slots[slot].rows; ++row)
        rows += model.covering_rows(stage, slot, row).empty() ? 0 : 1;
  }
  return rows;
}

TEST_CASE("The cheapest and the lightest builds of small machines are the first of all their builds") {
  unsigned covered = 0;
  std::size_t covered_by_any = 0, covered_by_asked = 0;
  for (unsigned seed = 1; seed <= (sanitized ? 3U : 8U); ++seed) {
    const TinyCatalogue tiny(prices(seed));
    const bool currents = seed % 3 == 0;
    machine::Problem problem =
        slide(3.0 + seed, currents ? "{ microsteps = 8, current = [\"1.5 A\", \"2 A\"] }" : "{ microsteps = 8 }");
    // The small driver does not run at 36 V: only without that it covers the large one.
    if (seed % 2 == 0) problem.supply_voltages = {24.0};
    const MachineModel model(problem, tiny.parts(), {}, ModelOptions{.fixed = {}, .every_candidate = true});
    const MachineModel usual(problem, tiny.parts());
    Exhaustive all(model);
    CAPTURE(seed, all.builds.size());
    const std::size_t count = 5 + 2 * seed;
    REQUIRE(all.builds.size() > count);
    for (const std::string objective : {"cost", "mass"}) {
      const auto what = objective == "cost" ? &BuildValue::cost : &BuildValue::mass;
      const auto other = objective == "cost" ? &BuildValue::mass : &BuildValue::cost;
      const auto value = objective == "cost" ? &Design::cost : &Design::mass;
      const auto other_value = objective == "cost" ? &Design::mass : &Design::cost;
      std::sort(all.builds.begin(), all.builds.end(), [&](const BuildValue& a, const BuildValue& b) {
        return std::abs(a.*what - b.*what) > 1e-9 ? a.*what < b.*what : a.*other < b.*other;
      });
      const Synthesis found = best(model, count, objective);
      REQUIRE(found.status == solver::Status::optimal);
      REQUIRE(found.designs.size() == count);
      REQUIRE(found.proved == count);
      // Left out even so: what as many cover as builds are asked for.
      for (const std::size_t few : {std::size_t{2}, std::size_t{3}, count}) {
        for (const std::vector<std::string>& asked : {std::vector<std::string>{}, {objective}}) {
          const MachineModel some(
              problem,
              tiny.parts(),
              {},
              ModelOptions{.fixed = {}, .every_candidate = true, .builds = few, .objectives = asked});
          const Synthesis first = best(some, few, objective);
          REQUIRE(first.designs.size() == few);
          for (std::size_t i = 0; i < few; ++i) {
            CHECK(first.designs[i].*value == Approx(all.builds[i].*what).epsilon(1e-9));
            CHECK(first.designs[i].*other_value == Approx(all.builds[i].*other).epsilon(1e-9));
          }
          (asked.empty() ? covered_by_any : covered_by_asked) += covered_rows(some);
        }
      }
      std::set<std::string> distinct;
      for (std::size_t i = 0; i < count; ++i) {
        const Design& design = found.designs[i];
        CHECK(design.satisfied());
        CHECK(design.cost == Approx(all.builds[i].cost).epsilon(1e-9));
        CHECK(design.mass == Approx(all.builds[i].mass).epsilon(1e-9));
        CHECK(distinct.insert(identity(design)).second);
      }
      // The best one is the answer of a search that leaves covered candidates out. Which of two currents is named that
      // leave it as strained as it is nothing says.
      const Design answer = best(usual, 1, objective).designs.front();
      CHECK(parts_of(found.designs.front()) == parts_of(answer));
      CHECK(worst_utilisation(found.designs.front()) == Approx(worst_utilisation(answer)).epsilon(1e-12));
    }
    const auto candidates = [](const MachineModel& of) {
      std::size_t rows = 0;
      for (const auto& entry : of.entries())
        for (const auto& table : entry.tables()) rows += table.name() == "motor" ? table.rows() : 0;
      return rows;
    };
    covered += candidates(model) > candidates(usual) ? 1 : 0;
  }
  CHECK(covered > (sanitized ? 0U : 1U));  // there was something that is left out otherwise
  CHECK(covered_by_asked >= covered_by_any + (sanitized ? 0U : 1U));
}

TEST_CASE("When there are fewer builds than asked for, all of them are found") {
  const TinyCatalogue tiny(prices(5));
  // Only the largest motor moves this.
  machine::Problem problem = slide(60.0);
  problem.supply_voltages = {24.0};
  problem.axes[0].mechanism.lead_screws = false;
  const MachineModel model(problem, tiny.parts(), {}, ModelOptions{.fixed = {}, .every_candidate = true});
  const Exhaustive all(model);
  REQUIRE(all.builds.size() > 1);
  REQUIRE(all.builds.size() < 100);
  const Synthesis found = best(model, 100);
  CHECK(found.status == solver::Status::optimal);
  CHECK(found.designs.size() == all.builds.size());
}

TEST_CASE("A part that is left out might as well cost a fortune, one that is fixed leaves the others out") {
  const machine::Problem problem = slide(6.0);
  const std::vector<std::string> motors{"M17", "M23", "M23L", "M34"};
  for (unsigned seed = 1; seed <= (sanitized ? 2U : 6U); ++seed) {
    const TinyCatalogue tiny(prices(seed));
    double least = 1e9;
    for (const std::string& motor : motors) {
      ModelOptions fixed;
      fixed.fixed.lines.push_back(part_line("motor", motor));
      const MachineModel model(problem, tiny.parts(), {}, fixed);
      REQUIRE(model.problems().empty());
      const Synthesis found = best(model, 1);
      if (found.designs.empty()) continue;
      CHECK(part_of(found.designs.front(), "motor") == motor);
      least = std::min(least, found.designs.front().cost);
    }
    const Exhaustive all{MachineModel(problem, tiny.parts())};
    CAPTURE(seed);
    CHECK(least == Approx(all.least(&BuildValue::cost)).epsilon(1e-9));

    // D4 is dearer and heavier than D2 mostly; without D2 it has to come back.
    for (const char* part : {"D2", "D4", "M17", "F6", "Tr10x2", "P24-100"}) {
      catalogue::Catalogue without = tiny.parts();
      without.drop(without.find_named(std::string("tiny ") + part).parts);
      CHECK(without.find(part).parts.empty());
      const Synthesis found = best(MachineModel(problem, without), 1);
      const TinyCatalogue fortune(prices(seed, part));
      const double cost = Exhaustive{MachineModel(problem, fortune.parts())}.least(&BuildValue::cost);
      CAPTURE(part);
      REQUIRE(found.designs.empty() == (cost > 1e5));
      if (!found.designs.empty()) CHECK(found.designs.front().cost == Approx(cost).epsilon(1e-9));
    }
  }
}

TEST_CASE("Fixed drivers, settings and voltages hold, and alternatives with them too") {
  const TinyCatalogue tiny(prices(2));
  const machine::Problem problem = slide(6.0);
  ModelOptions options;
  options.every_candidate = true;
  options.fixed.lines.push_back(part_line("driver", "D4"));
  options.fixed.lines.push_back(value_line("x", "acceleration_time", 0.125));
  options.fixed.lines.push_back(value_line("machine", "supply_voltage", 36.0));
  const MachineModel model(problem, tiny.parts(), {}, options);
  REQUIRE(model.problems().empty());
  const Synthesis found = best(model, 6);
  REQUIRE(found.designs.size() == 6);
  // Among all builds with every candidate, those at 36 V; D2 does not run there.
  machine::Problem at = problem;
  at.supply_voltages = {36.0};
  at.axes[0].acceleration_time = {0.125, 0.125};
  Exhaustive all{MachineModel(at, tiny.parts(), {}, ModelOptions{.fixed = {}, .every_candidate = true})};
  std::sort(
      all.builds.begin(), all.builds.end(), [](const BuildValue& a, const BuildValue& b) { return a.cost < b.cost; });
  for (std::size_t i = 0; i < found.designs.size(); ++i) {
    const Design& design = found.designs[i];
    CHECK(design.cost == Approx(all.builds[i].cost).epsilon(1e-9));
    CHECK(part_of(design, "driver") == "D4");
    CHECK(design.supply_voltage == 36.0);
    for (const auto& line : design.dimensions)
      if (line.name == "acceleration_time") CHECK(line.value == 0.125);
  }
}

TEST_CASE("What the problem does not permit cannot be fixed") {
  const TinyCatalogue tiny;
  const auto complaint = [&](machine::BomLine line) {
    ModelOptions options;
    options.fixed.lines.push_back(std::move(line));
    const MachineModel model(slide(6.0, "{ microsteps = 8, frame = [\"NEMA17\"], current = [\"1 A\", \"2 A\"] }"),
                             tiny.parts(),
                             {},
                             options);
    return model.problems().empty() ? std::string() : model.problems().front().message;
  };
  CHECK(complaint(part_line("motor", "M17")).empty());
  CHECK(complaint(part_line("motor", "M23")) == "'M23' cannot be the motor of axis 'x'");
  CHECK(complaint(part_line("motor", "D2")) == "'D2' cannot be the motor of axis 'x'");
  CHECK(complaint(value_line("x", "motor_current", 2.0)).empty());
  CHECK(complaint(value_line("x", "motor_current", 1.5)) == "motor_current 1.5 A is not among those of the problem");
  CHECK(complaint(value_line("x", "acceleration_time", 0.3)).empty());
  CHECK(complaint(value_line("x", "acceleration_time", 0.4)) ==
        "x.acceleration_time: 0.4 s is not within the problem's range");
  CHECK(complaint(value_line("machine", "supply_voltage", 24.0)).empty());
  CHECK(complaint(value_line("machine", "supply_voltage", 12.0)) ==
        "supply voltage 12 V is not among those of the problem");
}

}  // namespace

}  // namespace alternatives_test
