// SPDX-License-Identifier: Apache-2.0
// Bills of materials against a machine: held, completed, refused.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "evaluation/design_bill.h"
#include "evaluation/synthesis.h"
#include "evaluation/tiny_catalogue.h"

namespace bom_check_test {

using namespace millwright;
using evaluation::BomCheck;
using evaluation::Design;
using machine::BillOfMaterials;
using machine::BomLine;

namespace {

const catalogue::Catalogue& parts() {
  static const TinyCatalogue tiny;
  return tiny.parts();
}

const char* const one_axis = R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V", "36 V"]
[[axis]]
name = "x"
stroke = "300 mm"
structure_mass = "10 kg"
guide_friction = 0.05
acceleration_time = ["0.1 s", "0.5 s"]
mechanism = { kind = "screw", screw = ["ball_screws", "lead_screws"], ends = "fixed-supported" }
motor = { microsteps = 8 }
guide = { carriages = 4, carriage_spacing = "100 mm", rail_spacing = "200 mm" }
[[axis.moves]]
distance = "200 mm"
time = "8 s"
force = "60 N"
)";

BomLine part(const std::string& axis, const std::string& slot, const std::string& number) {
  BomLine line;
  line.axis = axis;
  line.slot = slot;
  line.part_number = number;
  return line;
}
BomLine setting(const std::string& axis, const std::string& slot, double value) {
  BomLine line;
  line.axis = axis;
  line.slot = slot;
  line.value = value;
  return line;
}

BomCheck checked(const std::vector<BomLine>& lines, bool complete, const char* problem = one_axis) {
  BillOfMaterials bom;
  bom.lines = lines;
  return evaluation::check(problem_of_text(problem), parts(), bom, complete, {});
}

const Design& cheapest() {
  static const Design design = [] {
    const evaluation::MachineModel model(problem_of_text(one_axis), parts());
    const auto solved = evaluation::synthesise(model, {});
    REQUIRE(solved.designs.size() == 1);
    return solved.designs.front();
  }();
  return design;
}

bool says(const BomCheck& result, const std::string& word) {
  return std::any_of(result.problems.begin(), result.problems.end(), [&](const auto& p) {
    return p.message.find(word) != std::string::npos;
  });
}

}  // namespace

TEST_CASE("The bill of a solved design is found compliant, at the same cost and mass") {
  const BomCheck again =
      evaluation::check(problem_of_text(one_axis), parts(), evaluation::bill_of(cheapest()), false, {});
  for (const auto& p : again.problems) UNSCOPED_INFO(p.message);
  REQUIRE(again.problems.empty());
  CHECK(again.design.satisfied());
  CHECK_FALSE(again.completed);
  CHECK(again.design.cost == Approx(cheapest().cost).epsilon(1e-12));
  CHECK(again.design.mass == Approx(cheapest().mass).epsilon(1e-12));
  REQUIRE(again.design.checks.size() == cheapest().checks.size());
  for (std::size_t i = 0; i < again.design.checks.size(); ++i)
    CHECK(again.design.checks[i].utilisation == Approx(cheapest().checks[i].utilisation).epsilon(1e-9));
}

// D2 bears 30 V, of which 90 % may be used: 27 V. The supply of the bill gives 36 V.
TEST_CASE("A driver that does not bear the voltage of the bill fails its check, and nothing else happens") {
  BillOfMaterials bom;
  for (const auto& line : evaluation::bill_of(cheapest()).lines)
    if (!line.is_dimension() && line.slot != "supply" && line.slot != "driver") bom.lines.push_back(line);
  bom.lines.push_back(part("x", "driver", "D2"));
  bom.lines.push_back(setting("machine", "supply_voltage", 36.0));
  const BomCheck result = evaluation::check(problem_of_text(one_axis), parts(), bom, true, {});
  for (const auto& p : result.problems) UNSCOPED_INFO(p.message);
  REQUIRE(result.problems.empty());
  CHECK_FALSE(result.design.satisfied());
  // The one supply of 36 V is chosen, though those of 24 V are cheaper.
  for (const auto& line : result.design.parts)
    if (line.slot == "supply") CHECK(line.part_number == "P36-350");
  for (const auto& check : result.design.checks)
    if (check.id == "C-DR-VOLT") {
      CHECK(check.value == Approx(36.0));
      CHECK(check.limit == Approx(27.0));
    }
}

TEST_CASE("An empty bill is completed to the cheapest build") {
  const BomCheck result = checked({}, true);
  REQUIRE(result.problems.empty());
  CHECK(result.completed);
  CHECK(result.completion == evaluation::Completion::best);
  CHECK(result.design.satisfied());
  CHECK(result.design.cost == Approx(cheapest().cost));
}

TEST_CASE("A dear part that is held stays, and the rest is the cheapest around it") {
  const BomCheck result = checked({part("x", "motor", "M34")}, true);
  REQUIRE(result.problems.empty());
  CHECK(result.completion == evaluation::Completion::best);
  CHECK(result.design.cost > cheapest().cost);
  bool held = false;
  for (const auto& line : result.design.parts) {
    held = held || (line.slot == "motor" && line.part_number == "M34");
    CHECK(line.origin == (line.slot == "motor" ? "given" : ""));
  }
  CHECK(held);
  // No cheaper completion: every other choice of one part, the rest completed again, costs as much or more.
  for (const char* coupling : {"K8", "K12"})
    for (const char* screw : {"Tr10x2", "Tr16x4", "B16x5"}) {
      const BomCheck other =
          checked({part("x", "motor", "M34"), part("x", "coupling", coupling), part("x", "screw", screw)}, true);
      if (other.problems.empty() && other.design.satisfied())
        CHECK(other.design.cost >= result.design.cost * (1.0 - 1e-9));
    }
}

TEST_CASE("A bill that cannot comply is evaluated all the same, and says by how much it fails") {
  std::string heavy = one_axis;
  heavy.replace(heavy.find("60 N"), 4, "2500 N");
  BillOfMaterials bom = evaluation::bill_of(cheapest());
  const BomCheck result = evaluation::check(problem_of_text(heavy), parts(), bom, false, {});
  REQUIRE(result.problems.empty());
  CHECK_FALSE(result.design.satisfied());
  CHECK(result.completion == evaluation::Completion::refuted);
  bool fails = false;
  for (const auto& c : result.design.checks) fails = fails || (c.utilisation > 1.0 && std::isfinite(c.utilisation));
  CHECK(fails);
  REQUIRE(result.design.governing("x") != nullptr);
  CHECK(result.design.governing("x")->utilisation > 1.0);
}

TEST_CASE("Around a bill that fails, the supply is the cheapest that gives voltage and power") {
  // Two checks of a supply, so it is one by one: 24 V and the power the drives take.
  for (const double volts : {24.0, 36.0}) {
    BillOfMaterials bom;
    for (const auto& line : evaluation::bill_of(cheapest()).lines)
      if (!line.is_dimension() && line.slot != "supply" && line.slot != "motor" && line.slot != "driver")
        bom.lines.push_back(line);
    bom.lines.push_back(part("x", "motor", "M34"));
    bom.lines.push_back(part("x", "driver", "D2"));
    bom.lines.push_back(setting("machine", "supply_voltage", volts));
    std::string heavy = one_axis;
    heavy.replace(heavy.find("60 N"), 4, "2500 N");
    const BomCheck result = evaluation::check(problem_of_text(heavy), parts(), bom, true, {});
    REQUIRE(result.problems.empty());
    CHECK_FALSE(result.design.satisfied());
    double taken = 0.0;
    for (const auto& check : result.design.checks)
      if (check.id == "C-PSU-POWER") taken = check.value;
    const char* expected = volts > 30.0 ? "P36-350" : taken <= 100.0 ? "P24-100" : "P24-350";
    CAPTURE(volts, taken);
    for (const auto& line : result.design.parts)
      if (line.slot == "supply") CHECK(line.part_number == expected);
  }
}

TEST_CASE("Where a held part fails whatever the ramp, the ramp still keeps the rest from failing") {
  const auto failures = [](const BomCheck& result) {
    REQUIRE(result.problems.empty());
    int count = 0;
    for (const auto& c : result.design.checks)
      count += c.kind != machine::ConstraintKind::soft && c.verdict == evaluation::Verdict::violated;
    return count;
  };
  int middle_was_worse = 0;
  for (const double seconds : {0.8, 1.0, 1.2, 1.5, 2.0}) {
    // No screw of the tiny catalogue is off by less than 50 um.
    std::string text = one_axis;
    text.replace(text.find("time = \"8 s\""), 12, fmt::format("time = \"{} s\"", seconds));
    text.replace(text.find("[\"0.1 s\", \"0.5 s\"]"), 18, "[\"0.01 s\", \"0.39 s\"]");
    text += "[axis.require]\nposition_error = \"10 um\"\n";
    text.replace(text.find("structure_mass = \"10 kg\""), 24, "structure_mass = \"60 kg\"");
    BillOfMaterials bom = evaluation::bill_of(cheapest());
    const auto is_ramp = [](const BomLine& line) { return line.slot == "acceleration_time"; };
    bom.lines.erase(std::remove_if(bom.lines.begin(), bom.lines.end(), is_ramp), bom.lines.end());
    int fewest = 1000, in_the_middle = 0;
    for (int k = 0; k <= 38; ++k) {
      BillOfMaterials held = bom;
      held.lines.push_back(setting("x", "acceleration_time", 0.01 * (k + 1)));
      const int count = failures(evaluation::check(problem_of_text(text), parts(), held, false, {}));
      fewest = std::min(fewest, count);
      if (k == 19) in_the_middle = count;
    }
    INFO(seconds << " s: at least " << fewest << " fail, in the middle " << in_the_middle);
    CHECK(fewest >= 1);
    CHECK(failures(evaluation::check(problem_of_text(text), parts(), bom, false, {})) <= fewest);
    middle_was_worse += in_the_middle > fewest;
  }
  CHECK(middle_was_worse >= 1);
}

TEST_CASE("A held setting is kept, also where the problem fixes it") {
  for (const bool fixed : {false, true}) {
    std::string text = one_axis;
    if (fixed) text.replace(text.find("[\"0.1 s\", \"0.5 s\"]"), 18, "\"0.3 s\"");
    const BomCheck result = checked({setting("x", "acceleration_time", 0.2)}, true, text.c_str());
    REQUIRE(result.problems.empty());
    // Two ramps of 0.2 s in a move of 8 s.
    for (const auto& c : result.design.checks)
      if (c.id == "C-SYS-TIME") CHECK(c.value == Approx(0.05));
  }
}

TEST_CASE("What a bill of materials cannot mean is said") {
  SECTION("a part that no catalogue has") {
    const BomCheck r = checked({part("x", "motor", "M24")}, true);
    CHECK(says(r, "M24"));
    CHECK(r.design.parts.empty());
  }
  SECTION("a part of another family") {
    const BomCheck r = checked({part("x", "motor", "K12")}, true);
    CHECK(says(r, "'K12' cannot be the motor of axis 'x'"));
  }
  SECTION("a nut that does not run on the screw") {
    const BomCheck r = checked({part("x", "screw", "Tr10x2"), part("x", "nut", "Tr16x4 nut")}, true);
    CHECK(says(r, "'Tr10x2' as screw, 'Tr16x4 nut' as nut of axis 'x': they do not run together"));
  }
  SECTION("a supply of another voltage") {
    std::string text = one_axis;
    text.replace(text.find("[\"24 V\", \"36 V\"]"), 16, "[\"24 V\"]");
    const BomCheck r = checked({part("machine", "supply", "P36-350")}, true, text.c_str());
    CHECK(says(r, "36 V"));
  }
  SECTION("a supply voltage that the problem does not have") {
    CHECK(says(checked({setting("machine", "supply_voltage", 48.0)}, true), "48 V"));
  }
  SECTION("missing slots, all of them, unless they may be completed") {
    const BomCheck r = checked({part("x", "motor", "M23"), part("x", "screw", "Tr16x4")}, false);
    for (const char* slot : {"nut", "driver", "coupling", "support_fixed", "support_free", "guide", "supply"}) {
      INFO(slot);
      CHECK(says(r, std::string("has no ") + slot));
    }
    CHECK_FALSE(says(r, "has no motor"));
    CHECK_FALSE(says(r, "has no screw"));
    CHECK(r.problems.size() == 7);
  }
}

// A shipped catalogue has some thousand pairs of motor and driver, and a bill takes one of them on an axis.
TEST_CASE("Of motors and drivers that are given no others are looked at, unless they cannot be chosen") {
  const machine::Problem problem = problem_of_text(one_axis);
  const auto pairs = [&](const std::vector<BomLine>& lines) {
    BillOfMaterials bom;
    bom.lines = lines;
    const evaluation::MachineModel model(problem, parts(), evaluation::given_slots(bom));
    std::vector<std::string> names;
    for (const evaluation::StageEntry& entry : model.entries())
      for (const evaluation::SlotTable& table : entry.tables())
        for (std::size_t row = 0; row < table.rows() && table.name() == "motor"; ++row) {
          const auto use = table.candidate(row).parts;
          REQUIRE(use.size() == 2);
          names.push_back(fmt::format("{} {}",
                                      parts().table(catalogue::Family::steppers).part_number(use[0].row),
                                      parts().table(catalogue::Family::drivers).part_number(use[1].row)));
        }
    std::sort(names.begin(), names.end());
    return names;
  };
  using Names = std::vector<std::string>;
  const Names all = pairs({part("x", "driver", "no such driver")});
  REQUIRE(all.size() == 8);  // four motors with two drivers
  CHECK(pairs({part("x", "motor", "M23"), part("x", "driver", "D2")}) == Names{"M23 D2"});
  CHECK(pairs({part("x", "driver", "D2")}) == Names{"M17 D2", "M23 D2", "M23L D2", "M34 D2"});
  const Names of_one_motor = pairs({part("x", "motor", "M23L")});
  REQUIRE_FALSE(of_one_motor.empty());
  for (const std::string& pair : of_one_motor) CHECK(pair.starts_with("M23L "));
  CHECK(pairs({part("x", "motor", "M23"), part("x", "driver", "M23")}) == all);
  CHECK(pairs({part("x", "motor", "M24"), part("x", "driver", "D2")}) == all);
  BomLine of_another_maker = part("x", "motor", "M23");
  of_another_maker.manufacturer = "somebody else";
  CHECK(pairs({of_another_maker, part("x", "driver", "D2")}) == all);
}

TEST_CASE("A family without rows is said, with and without a bill for it") {
  const TinyCatalogue without_couplings({}, {"couplings"});
  const auto problem = problem_of_text(one_axis);
  BillOfMaterials bom;
  for (const bool given : {false, true}) {
    if (given) bom.lines = {part("x", "coupling", "K8"), part("x", "motor", "M23")};
    const BomCheck r = evaluation::check(problem, without_couplings.parts(), bom, true, {});
    REQUIRE(r.problems.size() == 1);
    CHECK(says(r, given ? "K8" : "coupling of axis 'x'"));
  }
  const evaluation::MachineModel model(problem, without_couplings.parts());
  const auto solved = evaluation::synthesise(model, {});
  CHECK(solved.designs.empty());
  REQUIRE(solved.empty_slots.size() == 1);
  CHECK(solved.empty_slots[0].slot == "coupling");
}

}  // namespace bom_check_test
