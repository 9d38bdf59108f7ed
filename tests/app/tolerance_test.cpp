// SPDX-License-Identifier: Apache-2.0
// --robust on the command line: exit codes, and a build that solve found and check takes.
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "catch.h"
#include "sanitized.h"

namespace tolerance_test {

using namespace millwright::app;

namespace {
const std::string feeder = MILLWRIGHT_SOURCE_DIR "/problems/bar-feeder.toml";
}

TEST_CASE("what solve --robust finds passes check --robust, the build without it does not") {
  const Workshop shop;
  // This motor's inertia and mass are estimates of +-25 % and +-15 %, and torque is what limits the ramp (where the
  // screw may be a little softer).
  const std::string softer = "axis.x.require.axial_stiffness=38 N/um", slower = "axis.x.moves[1].speed=400 mm/s";
  REQUIRE(shop.run({"solve",
                    feeder,
                    "--set",
                    softer,
                    "--set",
                    slower,
                    "--fix",
                    "x.motor=23HS32-4004S",
                    "--bom",
                    "plain.csv"})
              .exit_code == 0);
  CHECK(shop.run({"check", feeder, "plain.csv", "--set", softer, "--set", slower}).exit_code == 0);
  const Outcome refused =
      shop.run({"check", feeder, "plain.csv", "--set", softer, "--set", slower, "--robust", "--json", "-"});
  CHECK(refused.exit_code == 1);
  const auto tolerances = nlohmann::json::parse(refused.out).at("tolerances");
  CHECK(tolerances.at("verdict") == "broken");
  CHECK(!tolerances.at("breaks").empty());
  REQUIRE(shop.run({"solve", feeder, "--robust", "--bom", "robust.csv"}).exit_code == 0);
  CHECK(shop.run({"check", feeder, "robust.csv", "--robust"}).exit_code == 0);
}

TEST_CASE("where nothing states a tolerance, --robust claims no more than without it") {
  const Workshop shop;
  // The parts of a slower lifter state none; what is printed of it is the build and proof of solve without --robust.
  const std::string lifter = MILLWRIGHT_SOURCE_DIR "/problems/lifter.toml";
  const Outcome robust = shop.run(
      {"solve", lifter, "--set", "axis.z.moves[0].time='2 s'", "--robust", "--report", "r.html", "--json", "r.json"});
  REQUIRE(robust.exit_code == 0);
  CHECK(nlohmann::json::parse(shop.read("r.json")).at("tolerances").at("verdict") == "none_stated");
  CHECK(robust.prints("with --robust this is no\n  stronger than without"));
  CHECK(robust.prints("Cheapest compliant build: "));
  CHECK_FALSE(robust.prints("over all tolerances"));
  CHECK(shop.read("r.html").find("with --robust this is no\n  stronger than without") != std::string::npos);
}

TEST_CASE("a robust build has no next best") {
  const Workshop shop;
  const Outcome outcome = shop.run({"solve", feeder, "--robust", "--alternatives", "2"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.says("--robust"));
}

TEST_CASE("every build of pareto --robust is compliant for every value, and the front says so") {
  const Workshop shop;
  // Sanitised, only its cheapest builds.
  const std::string limit = millwright::sanitized ? "cost=418" : "cost=10000";
  const std::string slower = "axis.x.moves[1].speed=400 mm/s";
  const Outcome front = shop.run({"pareto",
                                  feeder,
                                  "--set",
                                  slower,
                                  "--robust",
                                  "--limit",
                                  limit,
                                  "--json",
                                  "front.json",
                                  "--report",
                                  "front.html"});
  REQUIRE(front.exit_code == 0);
  CHECK(front.prints("Every build of it is compliant for every value within the stated"));
  const auto json = nlohmann::json::parse(shop.read("front.json"));
  REQUIRE(!json.at("front").empty());
  std::size_t proved = 0;
  for (const auto& build : json.at("front")) {
    // Some are of parts that state no tolerance.
    const std::string verdict = build.at("tolerances").at("verdict");
    CHECK((verdict == "compliant" || verdict == "none_stated"));
    proved += verdict == "compliant";
  }
  CHECK(proved > 0);
  CHECK(shop.read("front.html").find("Every build of it is compliant") != std::string::npos);
  // Its cheapest build is the one of solve --robust.
  const Outcome best = shop.run({"solve", feeder, "--set", slower, "--robust", "--json", "-"});
  REQUIRE(best.exit_code == 0);
  CHECK(json.at("front").at(0).at("totals").at("cost").at("value").get<double>() ==
        Approx(nlohmann::json::parse(best.out).at("totals").at("cost").at("value").get<double>()).epsilon(1e-3));
}

TEST_CASE("what robustness costs is said in real prices where parts are preferred") {
  const Workshop shop;
  const auto json_of = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"solve", feeder, "--json", "-"});
    const Outcome outcome = shop.run(words);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return nlohmann::json::parse(outcome.out);
  };
  std::string stock = "manufacturer,part_number,available\n";
  const auto usual = json_of({});
  for (const auto& part : usual.at("build").at("parts"))
    if (part.at("slot") == "motor" || part.at("slot") == "driver")
      stock +=
          part.at("manufacturer").get<std::string>() + "," + part.at("part_number").get<std::string>() + ",preferred\n";
  shop.write("mine/stock.csv", stock);
  const std::vector<std::string> preferring{
      "--catalogue", "mine", "--set", "objective.minimise=cost", "--set", "objective.preference=0.3"};
  const auto plain = json_of(preferring);
  const double without = plain.at("totals").at("cost").at("value");
  REQUIRE(plain.at("objective").at("compared_value").get<double>() < 0.99 * without);
  std::vector<std::string> words = preferring;
  words.emplace_back("--robust");
  const auto robust = json_of(words);
  CHECK(robust.at("tolerances").at("robust").at("objective_without").get<double>() == Approx(without).epsilon(1e-9));
}

TEST_CASE("a robust front that time was up for says which builds were not settled") {
  const Workshop shop;
  const Outcome front = shop.run({"pareto", feeder, "--robust", "--time-limit", "1e-9", "--json", "-"});
  CHECK(front.exit_code == 3);
  const auto json = nlohmann::json::parse(front.out);
  CHECK(json.at("complete") == false);
  for (const auto& build : json.at("front")) {
    CHECK(build.at("tolerances").at("verdict") == "unsettled");
    CHECK(build.at("tolerances").at("stopped") == true);
  }
}

}  // namespace tolerance_test
