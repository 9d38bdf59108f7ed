// SPDX-License-Identifier: Apache-2.0
// Folders on top of folders, and parts found in the result.
#include <cmath>

#include "catalogue/catalogue.h"
#include "catalogue/files.h"
#include "catch.h"
#include "temporary_folder.h"

namespace overlay_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

const std::string motors =
    "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency\n";
const std::string curves =
    "manufacturer,part_number,drive_voltage [V],phase_current [A],driver,speed [rpm],torque [N.m]\n";
const std::string belts =
    "manufacturer,part_number,profile,pitch [mm],width [mm],allowable_tension [N],price_per_length [1/m],currency\n";

double torque_of(const Catalogue& catalogue, const std::string& part, const std::string& maker) {
  const Table& table = catalogue.table(Family::steppers);
  const Found found = table.find(part, maker);
  REQUIRE(found.rows.size() == 1);
  return table.number("holding_torque", found.rows.front());
}

}  // namespace

TEST_CASE("an overlay replaces by manufacturer and part number and adds the rest") {
  const TemporaryFolder shipped, first, second;
  shipped.write("steppers/a.csv", motors + "Acme,M1,1.8,1,2,10,USD\nAcme,M2,1.8,2,2,20,USD\n");
  shipped.write("steppers/b.csv", motors + "Best,M1,1.8,3,2,30,USD\n");
  shipped.write("belts/x.csv", belts + "generic,B1,GT2,2,6,30,1.5,USD\n");
  first.write("steppers/mine.csv", motors + "Acme,M1,1.8,1.5,2,0,USD\nMine,M9,0.9,9,2,90,EUR\n");
  second.write("steppers/yours.csv", motors + "Acme,M1,1.8,1.7,2,1,USD\n");
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({shipped.path(), first.path(), second.path()}, diagnostics);
  INFO(text::format(diagnostics));
  REQUIRE(diagnostics.count() == 0);
  const Table& table = catalogue.table(Family::steppers);
  CHECK(table.rows() == 4);
  CHECK(catalogue.table(Family::belts).rows() == 1);
  CHECK(torque_of(catalogue, "M1", "Acme") == 1.7);
  CHECK(torque_of(catalogue, "M1", "Best") == 3.0);
  CHECK(torque_of(catalogue, "M2", "Acme") == 2.0);
  CHECK(table.layer(table.find("M1", "Acme").rows.front()) == 2);
  CHECK(table.layer(table.find("M1", "Best").rows.front()) == 0);
  CHECK(table.layer(table.find("M9").rows.front()) == 1);
  CHECK(table.price(table.find("M9").rows.front()).currency == "EUR");
  CHECK(table.where(table.find("M1", "Acme").rows.front()).text->path() ==
        (second.path() / "steppers/yours.csv").string());
  CHECK(catalogue.layers().size() == 3);
}

TEST_CASE("an overlay's torque curve replaces the whole curve and leaves others") {
  const TemporaryFolder shipped, overlay;
  shipped.write("stepper_curves/a.csv",
                curves + "A,M,24,2,d,60,1\nA,M,24,2,d,120,0.9\nA,M,24,2,d,240,0.5\nA,M,48,2,d,60,1.1\n");
  overlay.write("stepper_curves/b.csv", curves + "A,M,24,2,d,90,0.8\nA,M,24,2,d,180,0.7\n");
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({shipped.path(), overlay.path()}, diagnostics);
  REQUIRE(diagnostics.count() == 0);
  const Table& table = catalogue.table(Family::stepper_curves);
  const Found found = table.find("M", "A");
  REQUIRE(found.rows.size() == 3);
  CHECK(table.number("drive_voltage", found.rows[0]) == 48.0);
  CHECK(table.number("torque", found.rows[1]) == 0.8);
  CHECK(table.number("torque", found.rows[2]) == 0.7);
}

TEST_CASE("the same part twice within a folder is an error, also in two files") {
  const TemporaryFolder folder;
  folder.write("steppers/a.csv", motors + "Acme,M1,1.8,1,2,10,USD\n");
  folder.write("steppers/b.csv", motors + "Acme,M0,1.8,1,2,10,USD\nAcme,M1,1.8,1,2,10,USD\n");
  text::Diagnostics diagnostics;
  CHECK(Catalogue::load({folder.path()}, diagnostics).table(Family::steppers).rows() == 2);
  REQUIRE(diagnostics.error_count() == 1);
  const text::Diagnostic duplicate = diagnostics.all().front();
  CHECK(duplicate.where.text->path() == (folder.path() / "steppers/b.csv").string());
  CHECK(duplicate.where.line == 3);
  REQUIRE(duplicate.related);
  CHECK(duplicate.related->text->path() == (folder.path() / "steppers/a.csv").string());
}

TEST_CASE("a family folder, a file named as its family and a file told by its header are understood") {
  const TemporaryFolder folder;
  folder.write("steppers/a.csv", motors + "Acme,M1,1.8,1,2,10,USD\n");
  folder.write("belts.csv", belts + "generic,B1,GT2,2,6,30,1.5,USD\n");
  folder.write("my-motors.csv", motors + "Acme,M2,1.8,1,2,10,USD\n");
  folder.write("README.md", "not a catalogue");
  text::Diagnostics diagnostics;
  CHECK(Catalogue::load({folder.path()}, diagnostics).rows() == 3);
  CHECK(Catalogue::load({folder.path() / "steppers"}, diagnostics).table(Family::steppers).rows() == 1);
  CHECK(Catalogue::load({folder.path() / "steppers" / "a.csv"}, diagnostics).table(Family::steppers).rows() == 1);
  CHECK(Catalogue::load({folder.path() / "my-motors.csv"}, diagnostics).table(Family::steppers).rows() == 1);
  CHECK(diagnostics.count() == 0);
}

TEST_CASE("a misspelt family folder is pointed out") {
  const TemporaryFolder folder;
  folder.write("stepper/a.csv", motors + "Acme,M1,1.8,1,2,10,USD\n");
  folder.write("belts/a.csv", belts + "generic,B1,GT2,2,6,30,1.5,USD\n");
  text::Diagnostics diagnostics;
  CHECK(Catalogue::load({folder.path()}, diagnostics).rows() == 1);
  REQUIRE(diagnostics.warning_count() == 1);
  CHECK(diagnostics.all().front().hint.find("steppers") != std::string::npos);
}

TEST_CASE("no folder, an empty folder and a file of no family are errors") {
  const TemporaryFolder folder;
  text::Diagnostics not_there, nothing_in_it, no_family, not_found;
  CHECK(Catalogue::load({folder.path() / "nowhere"}, not_there).rows() == 0);
  CHECK(not_there.error_count() == 1);
  CHECK(Catalogue::load({folder.path()}, nothing_in_it).rows() == 0);
  CHECK(nothing_in_it.error_count() == 1);
  const auto file = folder.write("things.csv", "colour,taste\nred,sweet\n");
  CHECK(Catalogue::load({file}, no_family).rows() == 0);
  CHECK(no_family.error_count() == 1);
  CHECK(Catalogue::load({std::filesystem::path()}, not_found).rows() == 0);
  CHECK(not_found.error_count() == 1);
}

TEST_CASE("a part is found by its number, and a wrong one is explained") {
  const TemporaryFolder folder;
  folder.write("steppers/a.csv",
               motors + "Acme,M1,1.8,1,2,10,USD\nBest,M1,1.8,3,2,30,USD\nBest,23HS22-2804S,1.8,3,2,30,USD\n");
  folder.write("materials/a.csv",
               "manufacturer,part_number,aliases,elastic_modulus [GPa],density [kg/m3],yield_strength "
               "[MPa],price_per_mass [1/kg],currency\n"
               "generic,S235JR,ST37;1.0038,206,7850,235,1.1,USD\ngeneric,S45C N,C45;S45C,206,7850,305,1.2,USD\n"
               "generic,S45C QT,S45C,206,7850,490,1.4,USD\n");
  text::Diagnostics diagnostics;
  const Catalogue catalogue = Catalogue::load({folder.path()}, diagnostics);
  REQUIRE(diagnostics.count() == 0);
  const Table& table = catalogue.table(Family::steppers);
  CHECK(table.find("23HS22-2804S").rows.size() == 1);
  CHECK(table.find("M1", "Best").rows.size() == 1);
  const Found ambiguous = table.find("M1");
  CHECK_FALSE(ambiguous);
  CHECK(ambiguous.hint.find("Acme and Best") != std::string::npos);
  const Found other_maker = table.find("23HS22-2804S", "Acme");
  CHECK(other_maker.problem == Found::Problem::other_maker);
  CHECK(other_maker.hint.find("Best") != std::string::npos);
  const Found typo = table.find("23HS22-2840S");
  CHECK(typo.problem == Found::Problem::unknown);
  CHECK(typo.hint.find("23HS22-2804S") != std::string::npos);
  const Table& materials = catalogue.table(Family::materials);
  REQUIRE(materials.find("ST37").rows.size() == 1);
  CHECK(materials.part_number(materials.find("ST37").rows.front()) == "S235JR");
  CHECK(materials.find("C45"));
  CHECK(materials.find("S45C").problem == Found::Problem::ambiguous);
  CHECK(catalogue.find("1.0038").parts.size() == 1);
  CHECK(catalogue.find("M1").parts.empty());
  CHECK(catalogue.find("M1").hint.find("Acme") != std::string::npos);
  CHECK(catalogue.find("S235JS").hint.find("S235JR") != std::string::npos);
}

TEST_CASE("the shipped catalogues are found beside an installed program and above one in a build folder") {
  const TemporaryFolder folder;
  folder.write("prefix/share/millwright/catalogues/steppers/a.csv", "x");
  CHECK(shipped_catalogues(folder.path() / "prefix/bin/millwright") ==
        folder.path() / "prefix/share/millwright/catalogues");
  const TemporaryFolder tree;
  tree.write("catalogues/steppers/a.csv", "x");
  const auto found = shipped_catalogues(tree.path() / "build/release/src/millwright");
  CHECK(std::filesystem::exists(found / "steppers"));
}

TEST_CASE("files of a family are put together whichever is the longer one and whatever columns they have") {
  const std::string more =
      "manufacturer,part_number,step_angle [deg],holding_torque [N.m],mass [kg],rated_current "
      "[A],price,currency,note\n";
  for (const int first : {1, 3, 400}) {
    for (const int second : {1, 5, 900}) {
      const TemporaryFolder folder;
      std::string a = motors, b = more;
      for (int i = 0; i < first; ++i) a += "Acme,A" + std::to_string(i) + ",1.8,1.5,2,10,USD\n";
      for (int i = 0; i < second; ++i) b += "Acme,B" + std::to_string(i) + ",1.8,2.5,0.5,2,20,USD,\"a \"\"b\"\"\"\n";
      folder.write("steppers/a.csv", a);
      folder.write("steppers/b.csv", b);
      folder.write("steppers/c.csv", motors + "Acme,C,1.8,3.5,2,30,USD\n");
      text::Diagnostics diagnostics;
      const Catalogue catalogue = Catalogue::load({folder.path()}, diagnostics);
      INFO(text::format(diagnostics));
      REQUIRE(diagnostics.count() == 0);
      const Table& table = catalogue.table(Family::steppers);
      REQUIRE(table.rows() == first + second + 1);
      CHECK(torque_of(catalogue, "A0", "Acme") == 1.5);
      CHECK(torque_of(catalogue, "C", "Acme") == 3.5);
      const int last = table.find("B" + std::to_string(second - 1), "Acme").rows.front();
      CHECK(table.number("mass", last) == 0.5);
      CHECK(table.text("note", last) == "a \"b\"");
      CHECK(table.price(last).piece == 20.0);
      CHECK(std::isnan(table.number("mass", 0)));
      CHECK(table.text("note", 0).empty());
      CHECK(std::isnan(table.price(0).length));
      CHECK(table.where(last).line == second + 1);
    }
  }
}

}  // namespace overlay_test
