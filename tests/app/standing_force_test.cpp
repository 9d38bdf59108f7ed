// SPDX-License-Identifier: Apache-2.0
// What a measured force does that acts while the axis stands.
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "catch.h"

namespace millwright::app::standing_force_test {
namespace {

using Json = nlohmann::json;

/// A press of 2 kg with 2 N of drag: it goes 40 mm at 10 mm/s, bears `force` [N] for 5 s at this speed, and goes back.
void write_press(const Workshop& shop,
                 const std::string& mechanism,
                 const std::string& speed,
                 const std::string& force) {
  const std::string still = "," + speed + ",", held = still + force + "\n";
  shop.write("press.csv",
             "time [s],speed [mm/s],force [N]\n0,0,0\n1,10,0\n4,10,0\n5" + still + "0\n5.1" + held + "9.9" + held +
                 "10,0,0\n11,-10,0\n14,-10,0\n15,0,0\n");
  shop.write("press.toml",
             "title = \"Press\"\n[objective]\nminimise = \"cost\"\n[currency]\nUSD = 1.0\nEUR = 1.08\n"
             "[supply]\nvoltage = [\"48 V\"]\n[[axis]]\nname = \"x\"\nstroke = \"100 mm\"\n"
             "structure_mass = \"2 kg\"\nguide_drag = \"2 N\"\n"
             "motor = { from = \"steppers\", frame = [\"NEMA23\", \"NEMA34\"], microsteps = 8 }\nmechanism = " +
                 mechanism + "\n[[axis.moves]]\nname = \"press\"\nprofile = \"press.csv\"\n");
}

double value_of(const Json& result, const std::string& check) {
  for (const Json& each : result.at("checks"))
    if (each.at("id") == check) return each.at("value").get<double>();
  FAIL("no check " << check);
  return 0.0;
}

Json solved(const Workshop& shop) {
  const Outcome outcome = shop.run({"solve", "press.toml", "--json", "-", "--bom", "bom.csv", "--force"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

}  // namespace

TEST_CASE("A force that acts while a screw stands loads it like one that acts while it creeps") {
  const Workshop shop;
  const std::string screw =
      "{ kind = \"screw\", screw = [\"lead_screws\"], thread_forms = [\"trapezoidal\"], ends = \"fixed-supported\" }";
  write_press(shop, screw, "0", "900");
  const Json stands = solved(shop);
  // 900 N and 2 N of drag; while it moves 2 N and 2 kg at 0.01 m/s2.
  for (const char* check : {"C-SCR-BUCK", "F-SUPPORT-LOAD"}) CHECK(value_of(stands, check) == Approx(902.0));
  CHECK(value_of(stands, "C-ST-TORQUE") < 0.1);
  write_press(shop, screw, "0.001", "900");
  const Outcome creeping = shop.run({"check", "press.toml", "bom.csv", "--json", "-"});
  REQUIRE(creeping.exit_code <= 1);
  const Json creeps = Json::parse(creeping.out);
  for (const char* check : {"C-SCR-BUCK", "F-SUPPORT-LOAD", "C-SCR-VM", "C-SCR-PB", "C-SCR-TWIST"})
    CHECK(value_of(creeps, check) == Approx(value_of(stands, check)).epsilon(1e-6));
  CHECK(value_of(creeps, "C-ST-TORQUE") > value_of(stands, "C-ST-TORQUE"));
}

TEST_CASE("A force that acts while a belt stands pulls at it") {
  const Workshop shop;
  const std::string belt = "{ kind = \"belt\", efficiency = 0.95, idler_distance = \"60 mm\" }";
  write_press(shop, belt, "0", "60");
  const Json stands = solved(shop);
  write_press(shop, belt, "0.001", "60");
  const Outcome creeping = shop.run({"check", "press.toml", "bom.csv", "--json", "-"});
  REQUIRE(creeping.exit_code <= 1);
  const Json creeps = Json::parse(creeping.out);
  CHECK(value_of(creeps, "C-BT-TENSION") == Approx(value_of(stands, "C-BT-TENSION")).epsilon(1e-6));
  CHECK(value_of(stands, "C-BT-TENSION") > 62.0);
}

}  // namespace millwright::app::standing_force_test
