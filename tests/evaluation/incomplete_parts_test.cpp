// SPDX-License-Identifier: Apache-2.0
// Parts that cannot be chosen because they lack a figure or a price: every figure of every part is taken away, one at a
// time, and what is told must be what then is in no candidate.
#include "evaluation/incomplete_parts.h"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <set>

#include "catch.h"
#include "evaluation/machines.h"
#include "evaluation/tiny_catalogue.h"

namespace incomplete_parts_test {

using namespace millwright;
using catalogue::Family;
using evaluation::IncompleteParts;
using evaluation::MachineModel;

namespace {

const char* const head = "[currency]\nUSD = 1.0\n[supply]\nvoltage = [\"24 V\", \"36 V\"]\n";
const char* const screw_drive = R"(kind = "screw", screw = ["ball_screws", "lead_screws"], ends = "fixed-supported")";

/// `parts`: what stands in the axis's own table or opens tables of its members; `more`: tables behind its moves.
std::string axis_of(const char* name,
                    const std::string& mechanism,
                    const std::string& parts = {},
                    const std::string& more = {}) {
  return fmt::format(R"(
[[axis]]
name = "{}"
stroke = "300 mm"
structure_mass = "3 kg"
acceleration_time = "0.2 s"
mechanism = {{ {} }}
motor = {{ microsteps = 8 }}
{}
[[axis.moves]]
distance = "200 mm"
time = "4 s"
force = "20 N"
{})",
                     name,
                     mechanism,
                     parts,
                     more);
}

/// Takes parts of every family that is bought: a screw on x, a belt on y, racks on z.
std::string machine_of_everything() {
  return head +
         axis_of("x",
                 screw_drive,
                 R"(guide = { rails = 2, carriages = 4, carriage_spacing = "100 mm", rail_spacing = "100 mm" }
[[axis.members]]
name = "beam"
kind = "beam"
support = "supported"
length = "400 mm"
material = "steel"
sections = ["steel_sections", "extrusions"]
[[axis.members]]
name = "joint"
kind = "bolts"
rows = 2
columns = 2
row_spacing = "60 mm"
column_spacing = "60 mm"
edge_distance = "15 mm"
lever_arm = "60 mm")") +
         axis_of("y", "kind = \"belt\", idler_distance = \"100 mm\"") + axis_of("z", "kind = \"rack\"");
}

using Part = std::pair<std::string, std::string>;  // family, part number

/// All parts that stand in some candidate.
std::set<Part> usable_parts(const MachineModel& model) {
  std::set<Part> parts;
  for (const auto& entry : model.entries())
    for (const auto& table : entry.tables())
      for (solver::Row row = 0; row < table.rows(); ++row)
        for (const auto& use : table.candidate(row).parts)
          if (use.stated.empty())
            parts.insert({std::string(catalogue::declaration(use.family).name),
                          std::string(model.catalogue().table(use.family).part_number(use.row))});
  return parts;
}

/// What is said to be missing of a part; nothing if it is not told.
std::optional<std::vector<std::string>> told(const MachineModel& model, Family family, const std::string& part_number) {
  for (const IncompleteParts& each : evaluation::incomplete_parts(model))
    for (const std::string& part : each.parts)
      if (each.family == catalogue::declaration(family).name && part == "tiny " + part_number) return each.missing;
  return std::nullopt;
}

void without_figure(catalogue::Catalogue& parts, Family family, int row, const char* name) {
  parts.changeable_table(family).set_number(
      row, catalogue::column(family, name), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

TEST_CASE("Nothing is said of parts that can all be chosen") {
  const TinyCatalogue tiny;
  const machine::Problem problem = problem_of_text(machine_of_everything());
  const MachineModel model(problem, tiny.parts());
  CHECK(model.empty_slots().empty());
  CHECK(evaluation::incomplete_parts(model).empty());
}

TEST_CASE("A part is told as incomplete just when the figure that is taken away takes it out of all candidates") {
  const TinyCatalogue tiny;
  const machine::Problem problem = problem_of_text(machine_of_everything());
  const std::set<Part> before = usable_parts(MachineModel(problem, tiny.parts()));
  std::set<std::string> families_told;
  std::size_t harmless = 0;
  for (const catalogue::FamilyDeclaration& family : catalogue::families) {
    if (family.family == Family::materials || family.family == Family::stepper_curves) continue;
    for (std::size_t index = 0; index < catalogue::column_count(family.family); ++index) {
      const catalogue::Column column{family.family, static_cast<std::uint8_t>(index)};
      const catalogue::ColumnDeclaration& declared = catalogue::declaration(column);
      if (declared.kind != catalogue::Kind::number && declared.kind != catalogue::Kind::money) continue;
      for (int row = 0; row < tiny.parts().table(family.family).rows(); ++row) {
        const std::string number(tiny.parts().table(family.family).part_number(row));
        const Part part{std::string(family.name), number};
        if (!before.contains(part) || std::isnan(tiny.parts().table(family.family).number(column, row))) continue;
        catalogue::Catalogue parts = tiny.parts();
        parts.changeable_table(family.family).set_number(row, column, std::numeric_limits<double>::quiet_NaN());
        const MachineModel model(problem, parts);
        const std::set<Part> usable = usable_parts(model);
        INFO(family.name << ' ' << number << ' ' << declared.name);
        const auto found = told(model, family.family, number);
        // Without its width a belt or pulley has no partners; no catalogue may leave it out.
        const bool is_partner = !usable.contains(part) && !found;
        if (is_partner) {
          CHECK(std::set<std::string>{"width", "belt_width"}.contains(std::string(declared.name)));
          continue;
        }
        CHECK(found.has_value() == !usable.contains(part));
        harmless += found ? 0 : 1;
        if (!found) continue;
        families_told.insert(part.first);
        CHECK(std::find(found->begin(), found->end(), declared.name) != found->end());
      }
    }
  }
  CHECK(families_told == std::set<std::string>{"ball_screws",
                                               "belts",
                                               "couplings",
                                               "drivers",
                                               "extrusions",
                                               "lead_nuts",
                                               "lead_screws",
                                               "linear_guides",
                                               "pinions",
                                               "power_supplies",
                                               "pulleys",
                                               "racks",
                                               "screws",
                                               "steel_sections",
                                               "steppers",
                                               "support_bearings"});
  CHECK(harmless > 30);
}

TEST_CASE("What a part lacks is named, but not what other parts do without") {
  const TinyCatalogue tiny;
  catalogue::Catalogue parts = tiny.parts();
  // K12 states no misalignments, which soft checks read: they are not why K8 cannot be chosen.
  without_figure(parts, Family::couplings, 0, "inertia");
  without_figure(parts, Family::couplings, 0, "parallel_misalignment");
  const machine::Problem problem = problem_of_text(machine_of_everything());
  const MachineModel model(problem, parts);
  const std::vector<IncompleteParts> all = evaluation::incomplete_parts(model);
  REQUIRE(all.size() == 1);
  CHECK(all[0].family == "couplings");
  CHECK(all[0].known == 2);
  CHECK(all[0].parts == std::vector<std::string>{"tiny K8"});
  CHECK(all[0].missing == std::vector<std::string>{"inertia"});
}

TEST_CASE("What no hard check reads is not said to be missing, though every other part has it") {
  const TinyCatalogue tiny;
  catalogue::Catalogue parts = tiny.parts();
  without_figure(parts, Family::steppers, 0, "rotor_inertia");
  without_figure(parts, Family::steppers, 0, "frame_size");
  without_figure(parts, Family::power_supplies, 0, "power");
  without_figure(parts, Family::power_supplies, 0, "output_current");
  without_figure(parts, Family::support_bearings, 2, "maximum_speed");  // S6, which states no thrust
  const machine::Problem problem = problem_of_text(machine_of_everything());
  const MachineModel model(problem, parts);
  CHECK(told(model, Family::steppers, "M17") == std::vector<std::string>{"rotor_inertia"});
  CHECK(told(model, Family::power_supplies, "P24-100") == std::vector<std::string>{"power"});
  CHECK(told(model, Family::support_bearings, "S6") == std::vector<std::string>{"maximum_speed"});
}

TEST_CASE("A part is told that one axis could take and another could not, but not for a slot that is fixed") {
  const TinyCatalogue tiny;
  catalogue::Catalogue parts = tiny.parts();
  without_figure(parts, Family::support_bearings, 0, "axial_stiffness");  // F6
  const auto two_axes = [](const std::string& asked_of_x) {
    return problem_of_text(head + axis_of("x", screw_drive, {}, asked_of_x) + axis_of("y", screw_drive));
  };
  const machine::Problem loose = two_axes({});
  const machine::Problem exact = two_axes("[axis.require]\nposition_error = \"200 um\"");
  CHECK(evaluation::incomplete_parts(MachineModel(loose, parts)).empty());
  const MachineModel model(exact, parts);
  CHECK(usable_parts(model).contains({"support_bearings", "F6"}));  // on y
  CHECK(told(model, Family::support_bearings, "F6") == std::vector<std::string>{"axial_stiffness"});

  evaluation::ModelOptions options;
  machine::BomLine line;
  line.axis = "x";
  line.slot = "support_fixed";
  line.manufacturer = "tiny";
  line.part_number = "F10";
  options.fixed.lines.push_back(line);
  CHECK(evaluation::incomplete_parts(MachineModel(exact, parts, {}, options)).empty());

  // Where nothing is left it is the reason.
  without_figure(parts, Family::support_bearings, 1, "axial_stiffness");
  const MachineModel none(exact, parts);
  REQUIRE(none.empty_slots().size() == 1);
  CHECK(none.empty_slots()[0].axis == "x");
  CHECK(none.empty_slots()[0].reason ==
        "no catalogue row fits what axis 'x' asks of its support_fixed; 2 support_bearings lack axial_stiffness");
}

TEST_CASE("Of a screw and a nut that one is told which lacks something") {
  const TinyCatalogue tiny;
  catalogue::Catalogue parts = tiny.parts();
  without_figure(parts, Family::lead_nuts, 0, "friction_greased");
  without_figure(parts, Family::lead_screws, 1, "lead_error_per_300mm");
  const machine::Problem problem = problem_of_text(machine_of_everything());
  const MachineModel model(problem, parts);
  const auto nut = told(model, Family::lead_nuts, "Tr10x2 nut");
  const auto screw = told(model, Family::lead_screws, "Tr16x4");
  REQUIRE(nut.has_value());
  REQUIRE(screw.has_value());
  CHECK(*nut == std::vector<std::string>{"friction_greased"});
  CHECK(*screw == std::vector<std::string>{"lead_error_per_300mm"});
  // Their partners lack nothing of their own, but cannot be chosen either.
  CHECK(told(model, Family::lead_nuts, "Tr16x4 nut").has_value());
  CHECK(told(model, Family::lead_screws, "Tr10x2").has_value());

  catalogue::Catalogue of_unknown_bronze = tiny.parts();
  without_figure(of_unknown_bronze, Family::materials, 1, "yield_strength");
  const MachineModel other(problem, of_unknown_bronze);
  const auto bronze = told(other, Family::lead_nuts, "Tr10x2 nut");
  REQUIRE(bronze.has_value());
  CHECK(*bronze == std::vector<std::string>{"materials.yield_strength"});
}

TEST_CASE("What the problem does not ask for is not incomplete, and neither is what is too short") {
  const TinyCatalogue tiny;
  catalogue::Catalogue parts = tiny.parts();
  without_figure(parts, Family::steppers, 3, "rotor_inertia");  // M34
  std::string text = machine_of_everything();
  const MachineModel any(problem_of_text(text), parts);
  CHECK(told(any, Family::steppers, "M34").has_value());
  const std::string frames = "frame = [\"NEMA17\", \"NEMA23\"], ";
  for (std::size_t at = 0; (at = text.find("microsteps = 8", at)) != std::string::npos; at += frames.size() + 1)
    text.insert(at, frames);
  const MachineModel small(problem_of_text(text), parts);
  CHECK(evaluation::incomplete_parts(small).empty());

  // Bars of 300 mm, of which a beam of 400 mm cannot be cut.
  catalogue::Catalogue bars = tiny.parts();
  bars.changeable_table(Family::steel_sections)
      .set_number(0, catalogue::column(Family::steel_sections, "stock_length"), 0.3);
  const MachineModel short_bars(problem_of_text(machine_of_everything()), bars);
  CHECK(!usable_parts(short_bars).contains({"steel_sections", "box20"}));
  CHECK(evaluation::incomplete_parts(short_bars).empty());

  // Of a rail of unknown length nobody can say that it is too long.
  without_figure(bars, Family::linear_guides, 0, "block_length");
  bars.changeable_table(Family::linear_guides)
      .set_number(0, catalogue::column(Family::linear_guides, "stock_length"), 2.0);
  const MachineModel unknown(problem_of_text(machine_of_everything()), bars);
  CHECK(told(unknown, Family::linear_guides, "R12") == std::vector<std::string>{"block_length"});
}

TEST_CASE("What several ranges of parts say together names each part once") {
  const std::vector<IncompleteParts> several{{"couplings", {"price"}, {"A 1", "B 2"}, 9},
                                             {"linear_guides", {"mass"}, {"C 3"}, 7},
                                             {"couplings", {"inertia"}, {"A 1", "B 1"}, 9},
                                             {"couplings", {"price"}, {"B 2", "B 3"}, 9}};
  const std::vector<IncompleteParts> all = evaluation::united(several);
  REQUIRE(all.size() == 4);
  CHECK(all[0].family == "couplings");
  CHECK(all[0].missing == std::vector<std::string>{"price"});
  CHECK(all[0].parts == std::vector<std::string>{"B 2", "B 3"});
  CHECK(all[3].family == "linear_guides");
  CHECK(all[3].parts == std::vector<std::string>{"C 3"});
  CHECK(all[3].known == 7);
  std::size_t both = 0;
  for (const IncompleteParts& each : all)
    if (each.missing == std::vector<std::string>{"price", "inertia"}) {
      ++both;
      CHECK(each.parts == std::vector<std::string>{"A 1"});
    }
  CHECK(both == 1);
  CHECK(evaluation::united({}).empty());
}

}  // namespace incomplete_parts_test
