// SPDX-License-Identifier: Apache-2.0
// Bills of materials: what is read, and what is said about wrong ones, at the very cell (marks « »).
#include "machine/bill_of_materials.h"

#include <filesystem>

#include "problem_text.h"

namespace bill_of_materials_test {

using namespace problem_text;
using machine::BillOfMaterials;
using text::Severity;

namespace {

const std::string members = R"([[axis.members]]
name = "rod"
kind = "shaft"
length = "500 mm"
material = "C45"
diameter = ["8 mm", "12 mm"]
[[axis.members]]
name = "bar"
kind = "bar"
length = "500 mm"
material = "C45"
width = "20 mm"
height = "20 mm"
[[axis.members]]
name = "joint"
kind = "weld"
material = "E6013"
leg = "4 mm"
joint_width = "40 mm"
joint_depth = "40 mm"
)";

/// Axis x with a screw, a guide and members, axis y with a belt.
machine::Problem problem() {
  Outcome outcome = read(replaced(sound, "[[axis.members]]\n", members + "[[axis.members]]\n"));
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.problem);
  return *outcome.problem;
}

struct BomOutcome {
  std::optional<BillOfMaterials> bom;
  text::Diagnostics diagnostics;
};

BomOutcome read_bom(const std::string& contents, const machine::Problem& of) {
  BomOutcome outcome;
  outcome.bom =
      machine::read_bill_of_materials(text::SourceText::from_string("bom.csv", contents), of, outcome.diagnostics);
  return outcome;
}

const std::string head = "axis,slot,manufacturer,part_number,quantity,length,value,origin\n";

struct BomCase {
  std::string contents;  ///< with marks
  std::string message, hint;
  Severity severity = Severity::error;
};

void check_bom(const BomCase& expected, const machine::Problem& of) {
  std::string contents = expected.contents;
  const Place place = take_marks(contents);
  const BomOutcome outcome = read_bom(contents, of);
  INFO(expected.contents << "\n" << text::format(outcome.diagnostics));
  CHECK(outcome.bom.has_value() == (expected.severity != Severity::error));
  REQUIRE(outcome.diagnostics.count() == 1);
  check_place(outcome.diagnostics.all().front(), place, {"", "", expected.message, expected.hint, expected.severity});
}

}  // namespace

TEST_CASE("A bill of materials is read into SI") {
  const BomOutcome outcome = read_bom("# as built\n" + head +
                                          "x,motor,StepperOnline,23HS22-2804S,1,,,paper\n"
                                          "x,screw,\"TBI, Taiwan\",SFU1605,1,82 cm,,ours\n"
                                          "x,guide,HIWIN,HGH15CA,4,,,\n"
                                          "\n"
                                          "x,acceleration_time,,,,,200 ms,paper\n"
                                          "x,rod.diameter,,,,,1 cm,\n"
                                          "x,joint.leg,,,,,5 mm,\n"
                                          "y,belt,generic,GT2-6,1,1.2 m,,\n"
                                          "machine,supply,Mean Well,LRS-150-24,,,,\n"
                                          "machine,supply_voltage,,,,,0.024 kV,\n",
                                      problem());
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.bom);
  const auto& lines = outcome.bom->lines;
  CHECK(outcome.bom->file == "bom.csv");
  REQUIRE(lines.size() == 9);
  CHECK(lines[0].axis == "x");
  CHECK(lines[0].slot == "motor");
  CHECK(lines[0].manufacturer == "StepperOnline");
  CHECK(lines[0].part_number == "23HS22-2804S");
  CHECK(lines[0].quantity.value() == 1.0);
  CHECK_FALSE(lines[0].length);
  CHECK_FALSE(lines[0].is_dimension());
  CHECK(lines[0].origin == "paper");
  CHECK(lines[0].where.line == 3);
  CHECK(lines[0].where.column == 23);
  CHECK(lines[1].manufacturer == "TBI, Taiwan");
  CHECK(lines[1].length.value() == Approx(0.82).epsilon(1e-12));
  CHECK(lines[2].quantity.value() == 4.0);
  CHECK(lines[3].is_dimension());
  CHECK(lines[3].value.value() == Approx(0.2).epsilon(1e-12));
  CHECK(lines[3].where.line == 7);
  CHECK(lines[3].where.column == 25);
  CHECK(lines[4].value.value() == Approx(0.01).epsilon(1e-12));
  CHECK(lines[5].value.value() == Approx(0.005).epsilon(1e-12));
  CHECK(lines[6].length.value() == Approx(1.2).epsilon(1e-12));
  CHECK_FALSE(lines[7].quantity);
  CHECK(lines[8].value.value() == Approx(24.0).epsilon(1e-12));
}

TEST_CASE("What a spreadsheet makes of a bill of materials is read alike") {
  const BomOutcome outcome = read_bom(
      "\xEF\xBB\xBF"
      "axis;slot;manufacturer;part_number;quantity;length;value\r\n"
      "x;screw;TBI;SFU1605;1;\"820,5 mm\";\r\n"
      "x;guide;HIWIN;HGH15CA;4,0;;\r\n"
      "x;acceleration_time;;;;;0,25 s\r\n"
      ";;;;;;\r\n",
      problem());
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.count() == 0);
  REQUIRE(outcome.bom);
  REQUIRE(outcome.bom->lines.size() == 3);
  CHECK(outcome.bom->lines[0].length.value() == Approx(0.8205).epsilon(1e-12));
  CHECK(outcome.bom->lines[1].quantity.value() == 4.0);
  CHECK(outcome.bom->lines[2].value.value() == Approx(0.25).epsilon(1e-12));
  // Columns in another order, and none that may be left out.
  const BomOutcome short_one = read_bom("part_number,axis,slot\nSFU1605,x,screw\n", problem());
  REQUIRE(short_one.bom);
  CHECK(short_one.bom->lines.at(0).part_number == "SFU1605");
}

TEST_CASE("What is wrong in a bill of materials is reported at its cell") {
  const machine::Problem of = problem();
  const std::vector<BomCase> cases{
      {"«»" + head, "the bill of materials is empty", "x,motor,StepperOnline"},
      {head + "x,motor,a,b,1,,,\n«q»,motor,a,b,1,,,\n", "axis: the problem has no axis 'q'", "axes: machine, x, y"},
      {head + "x,motor,a,b,1,,,\n«machin»,supply,a,b,1,,,\n", "no axis 'machin'", "did you mean 'machine'?"},
      {head + "«»,motor,a,b,1,,,\n", "axis: the cell is empty", "machine"},
      {head + "x,«moter»,a,b,1,,,\n", "slot: axis 'x' has no 'moter'", "did you mean 'motor'?"},
      {head + "x,«»,a,b,1,,,\n", "slot: the cell is empty", "slots: guide"},
      {head + "x,«belt»,a,b,1,,,\n", "slot: axis 'x' has no 'belt'", "slots: guide, beam, screw, nut"},
      {head + "x,«support_free»,a,b,1,,,\n", "slot: axis 'x' has no 'support_free'", ""},
      {head + "y,«screw»,a,b,1,,,\n", "slot: axis 'y' has no 'screw'", "slots: belt"},
      {head + "x,«rod»,a,b,1,,,\n", "slot: axis 'x' has no 'rod'", "did you mean 'rod.diameter'?"},
      {head + "machine,«motor»,a,b,1,,,\n", "slot: axis 'machine' has no 'motor'", "supply, supply_voltage"},
      {head + "x,motor,a,b,1,,,\ny,motor,a,b,1,,,\nx,«motor»,a,c,1,,,\n",
       "slot: motor of axis 'x' is given twice",
       "one line"},
      {head + "x,motor,a,«»,1,,,\n", "part_number: motor of axis 'x' names no part", "remove the line"},
      {head + "x,motor,a,b,«0»,,,\n", "quantity: must be greater than zero", "write for example 4"},
      {head + "x,motor,a,b,«-1»,,,\n", "quantity: must not be negative", "write for example 4"},
      {head + "x,motor,a,b,«1.5»,,,\n", "quantity: 1.5 pieces", "whole number"},
      {head + "x,motor,a,b,«20000»,,,\n", "quantity: 20000 pieces", "another column"},
      {head + "x,motor,a,b,«1O»,,,\n", "quantity: '1O' is not a number", "letter O where a zero was meant"},
      {head + "x,motor,a,b,«two»,,,\n", "quantity: 'two'", "write for example 4"},
      {head + "x,motor,a,b,2 «pcs»,,,\n", "quantity: unknown unit 'pcs'", ""},
      {head + "x,motor,a,b,2 «mm»,,,\n", "quantity: 'mm'", "write for example 4"},
      {head + "x,screw,a,b,1,«820»,,\n", "length: a unit is missing", "820 mm"},
      {head + "x,screw,a,b,1,820 «kg»,,\n", "length: 'kg' (kg) does not fit: 'mm'", "820 mm"},
      {head + "x,screw,a,b,1,820 «mn»,,\n", "length: unknown unit 'mn'", "did you mean"},
      {head + "x,screw,a,b,1,«-820» mm,,\n", "length: must not be negative", "820 mm"},
      {head + "x,screw,a,b,1,«0» mm,,\n", "length: must be greater than zero", "820 mm"},
      {head + "x,screw,a,b,1,«1e9» mm,,\n", "length: more than any machine has", "at most 1000 m"},
      {head + "x,screw,a,b,1,\"«820,5» mm\",,\n", "length: '820,5' has a comma", "decimal point"},
      {head + "x,acceleration_time,,,,,«0.2»,\n", "value: a unit is missing", "0.2 s"},
      {head + "x,acceleration_time,,,,,0.2 «mm»,\n", "value: 'mm' (m) does not fit: 's'", "0.2 s"},
      {head + "x,acceleration_time,,,,,«»,\n", "value: acceleration_time of axis 'x' has none", "0.2 s"},
      {head + "x,acceleration_time,,«fast»,,,,\n",
       "part_number: acceleration_time of axis 'x' is a setting",
       "column value"},
      {head + "x,motor,a,b,1,,«5 mm»,\n", "value: motor of axis 'x' is a part", "column length"},
      {head + "machine,supply_voltage,,,,,24 «A»,\n", "value: 'A'", "24 V"},
      {head + "x,bar.width,,,,,20 «s»,\n", "value: 's' (s) does not fit: 'mm'", ""},
      {head + "x,acceleration_time,,,«1»,,0.2 s,\n", "quantity: not used", "empty", Severity::warning},
      {head + "x,acceleration_time,,,,«5 mm»,0.2 s,\n", "length: not used", "empty", Severity::warning},
      {head + "x,motor,a,b,1,,,«papers»\n",
       "origin: 'papers' means nothing",
       "did you mean 'paper'?",
       Severity::warning},
      {head + "x,motor,a,b,1,,,«me»\n", "origin: 'me' means nothing", "paper, ours, or empty", Severity::warning},
      {"axis,slot,part_number,«orign»\nx,motor,b,ours\n",
       "column 'orign' is not used",
       "did you mean 'origin'?",
       Severity::warning},
      // What decides is not left out; but where it is there, another column may be called what it will.
      {"axis,slot,part_number,«Qty»\nx,motor,b,2\n", "column 'Qty' is not used", "did you mean 'quantity'?"},
      {"axis,slot,part_number,«lenght»\nx,screw,b,0.2 m\n", "column 'lenght' is not used", "did you mean 'length'?"},
      {"axis,slot,part_number,«quality»\nx,motor,b,fine\n",
       "column 'quality' is not used",
       "did you mean 'quantity'?",
       Severity::warning},
      {"axis,slot,part_number,quantity,«qty»\nx,motor,b,1,2\n",
       "column 'qty' is not used",
       "those used: axis, slot",
       Severity::warning},
  };
  for (const BomCase& one : cases) check_bom(one, of);
  check_bom({"«axis,slot,manufacturer»\nx,motor,a\n", "has no column 'part_number'", "axis,slot,manufacturer"}, of);
}

TEST_CASE("All wrong cells of a bill of materials are reported in one go") {
  const BomOutcome outcome = read_bom(head +
                                          "x,moter,a,b,1,,,\n"
                                          "x,nut,a,b,1.5,,,\n"
                                          "x,screw,a,b,0,820,,\n"
                                          "x,driver,a,b\n"
                                          "y,belt,a,,1,,5 mm,\n",
                                      problem());
  INFO(text::format(outcome.diagnostics));
  CHECK_FALSE(outcome.bom);
  CHECK(outcome.diagnostics.error_count() == 7);
}

TEST_CASE("An unknown axis is reported once, a bill for another machine in one sentence") {
  std::string lines = head + "x,motor,a,b,1,,,\n";
  for (const char* slot : {"motor", "screw", "nut", "driver"}) lines += std::string("z,") + slot + ",a,b,1,,,\n";
  const BomOutcome one = read_bom(lines, problem());
  REQUIRE(one.diagnostics.count() == 1);
  CHECK(one.diagnostics.all()[0].message == "axis: the problem has no axis 'z' (4 lines)");
  CHECK(one.diagnostics.all()[0].where.line == 3);

  std::string other = head + "machine,supply,a,b,1,,,\n";
  for (int i = 0; i < 40; ++i)
    other += (i % 2 == 0 ? "bridge" : "table") + (",motor" + std::to_string(i)) + ",a,b,1,,,\n";
  const BomOutcome outcome = read_bom(other, problem());
  INFO(text::format(outcome.diagnostics));
  CHECK_FALSE(outcome.bom);
  REQUIRE(outcome.diagnostics.count() == 1);
  const text::Diagnostic said = outcome.diagnostics.all()[0];
  CHECK(said.where.line == 3);
  CHECK(said.where.column == 1);
  CHECK(said.message == "this bill of materials is for another machine: its axes are bridge, table");
  CHECK(said.hint == "the axes of the problem are x, y");
}

TEST_CASE("Bills that are no text, or hostile") {
  const machine::Problem of = problem();
  for (const std::string& contents : {std::string(),
                                      std::string("\n\n\n"),
                                      std::string("axis,slot,part_number\nx,mo\0tor,b\n", 33),
                                      std::string("axis,slot,part_number\n\"x,motor,b\n"),
                                      std::string("axis,axis,slot\nx,x,y\n"),
                                      std::string("axis,slot,part_number\nx,mot\xFFor,b\n"),
                                      std::string(100000, ',') + "\n",
                                      head + "\x1B[31m,motor,a,b,1,,,\n"}) {
    const BomOutcome outcome = read_bom(contents, of);
    CHECK_FALSE(outcome.bom);
    CHECK(outcome.diagnostics.has_errors());
    CHECK(text::format(outcome.diagnostics).find('\x1B') == std::string::npos);
  }
}

TEST_CASE("The slots and settings of an axis") {
  using Words = std::vector<std::string>;
  const machine::Problem of = problem();
  CHECK(machine::slot_names(of.axes[0]) ==
        Words{"guide", "beam", "screw", "nut", "motor", "driver", "coupling", "support_fixed"});
  CHECK(machine::slot_names(of.axes[1]) == Words{"belt", "pulley_drive", "pulley_idle", "motor", "driver"});
  CHECK(machine::setting_names(of.axes[0]) ==
        Words{"acceleration_time", "motor_current", "rod.diameter", "bar.width", "bar.height", "joint.leg"});
  machine::Axis supported = of.axes[0];
  supported.mechanism.ends = machine::Ends::fixed_supported;
  CHECK(machine::slot_names(supported).back() == "support_free");
}

TEST_CASE("The shipped bills of materials are read without error or warning") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MILLWRIGHT_SOURCE_DIR "/problems")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with("-bom.csv")) continue;
    ++count;
    text::Diagnostics diagnostics;
    const auto of = machine::read_problem(
        entry.path().parent_path() / (name.substr(0, name.size() - 8) + ".toml"), {}, diagnostics);
    REQUIRE(of);
    const auto bom =
        machine::read_bill_of_materials(text::SourceText::load(entry.path().string(), diagnostics), *of, diagnostics);
    INFO(text::format(diagnostics));
    CHECK(diagnostics.count() == 0);
    CHECK(bom.has_value());
  }
  CHECK(count >= 4);
}

}  // namespace bill_of_materials_test
