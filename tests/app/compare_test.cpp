// SPDX-License-Identifier: Apache-2.0
// millwright compare: results and bills of materials in every pairing, and what is said of bad ones.
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "catch.h"

namespace millwright::app::compare_test {
namespace {

using Json = nlohmann::json;

/// The folder of a user who solved the slide, once as it is and once without the best motor.
void solve_twice(const Workshop& shop) {
  shop.write("m.toml", one_slide);
  REQUIRE(shop.run({"solve", "m.toml", "--json", "a.json", "--bom", "a.csv"}).exit_code == 0);
  const Json a = Json::parse(shop.read("a.json"));
  std::string motor;
  for (const Json& each : a.at("build").at("parts"))
    if (each.at("slot") == "motor") motor = each.at("part_number").get<std::string>();
  REQUIRE(shop.run({"solve", "m.toml", "--without", motor, "--json", "b.json", "--bom", "b.csv"}).exit_code == 0);
}

double cost(const Json& json) { return json.at("totals").at("cost").at("value").get<double>(); }

TEST_CASE("Results and bills of materials of the same builds compare alike") {
  const Workshop shop;
  solve_twice(shop);
  const Json a = Json::parse(shop.read("a.json")), b = Json::parse(shop.read("b.json"));
  const Outcome recorded = shop.run({"compare", "a.json", "b.json", "--json", "-"});
  CAPTURE(recorded.err);
  REQUIRE(recorded.exit_code == 0);
  const Json both = Json::parse(recorded.out);
  CHECK(cost(both.at("a")) == cost(a));
  CHECK(cost(both.at("b")) == cost(b));
  REQUIRE_FALSE(both.at("parts").empty());
  // What is said of each slot is what the results say; slots that are not listed are equal.
  double difference = 0.0;
  for (const Json& change : both.at("parts")) {
    difference += change.at("price_difference").get<double>();
    CHECK(change.at("a") != change.at("b"));
  }
  CHECK(difference == Approx(cost(b) - cost(a)).margin(1e-9));
  CHECK(both.at("parts").size() + both.at("parts_alike").get<std::size_t>() == a.at("build").at("parts").size());
  CHECK(both.at("checks").size() + both.at("checks_alike").get<std::size_t>() == a.at("checks").size());

  // The problem is the one that the result names, or as said.
  for (const std::vector<std::string>& words : {std::vector<std::string>{"compare", "a.json", "b.csv", "--json", "-"},
                                                {"compare", "a.csv", "b.json", "--json", "-"},
                                                {"compare", "a.csv", "b.csv", "--problem", "m.toml", "--json", "-"}}) {
    const Outcome outcome = shop.run(words);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const Json json = Json::parse(outcome.out);
    CHECK(json.at("parts") == both.at("parts"));
  }
  const Outcome text = shop.run({"compare", "a.json", "b.csv"});
  CHECK(text.prints("a.json: as recorded by solve of m.toml"));
  CHECK(text.prints("b.csv: a bill of materials, evaluated now with m.toml"));
  // The result did not count the cycle time, so that there is nothing to compare; of two bills there is.
  CHECK_FALSE(text.prints("cycle_time"));
  CHECK(shop.run({"compare", "a.csv", "b.csv", "--problem", "m.toml"}).prints("cycle_time"));
  CHECK(shop.run({"compare", "a.json", "a.json"}).prints("none"));
}

TEST_CASE("What a result was asked beside its problem is said where it is compared") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  REQUIRE(shop.run({"solve", "m.toml", "--json", "a.json"}).exit_code == 0);
  REQUIRE(shop.run({"solve",
                    "m.toml",
                    "--set",
                    "axis.x.stroke=0.31 m",
                    "--limit",
                    "mass=50 kg",
                    "--without",
                    "A4988",
                    "--json",
                    "b.json"})
              .exit_code == 0);
  const std::string text = shop.run({"compare", "a.json", "b.json"}).out;
  CAPTURE(text);
  CHECK(text.find("axis.x.stroke=0.31") != std::string::npos);
  CHECK(text.find("A4988") != std::string::npos);
  CHECK(text.find("mass=50 kg") != std::string::npos);
  // Nothing of the kind is said of the first.
  CHECK(text.find("A  a.json: as recorded by solve of m.toml\n") != std::string::npos);
}

TEST_CASE("A comparison with a build that fails a check says so in its exit code") {
  const Workshop shop;
  solve_twice(shop);
  // A what-if that no build keeps, evaluated on the bill of materials.
  const Outcome outcome = shop.run({"compare", "a.json", "a.csv", "--set", "axis.x.require.inertia_ratio=0.001"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.prints("B FAILS"));
  CHECK(outcome.prints("C-ST-INERTIA"));
  CHECK(shop.run({"compare", "a.csv", "a.json", "--set", "axis.x.require.inertia_ratio=0.001"}).prints("A FAILS"));
}

TEST_CASE("What cannot be compared is said at once, with a hint") {
  const Workshop shop;
  solve_twice(shop);
  const auto refuses = [&](const std::vector<std::string>& words, const std::vector<std::string>& said) {
    const Outcome outcome = shop.run(words);
    CAPTURE(words, outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    for (const std::string& each : said) CHECK(outcome.says(each));
  };
  refuses({"compare", "a.json"}, {"B is required"});
  refuses({"compare", "gone.json", "lost.csv"}, {"gone.json: error: cannot be opened", "lost.csv: error: cannot be"});
  refuses({"compare", "a.csv", "b.csv"}, {"which problem this bill of materials is for", "--problem FILE.toml"});
  refuses({"compare", "a.json", "b.json", "--set", "axis.x.stroke=1 m", "--complete"},
          {"--set: both", "--complete: both"});
  shop.write("cut.json", shop.read("a.json").substr(0, 300));
  shop.write("other.json", "{\"schema\": \"somebody else's\"}");
  refuses({"compare", "cut.json", "other.json"}, {"this is no JSON", "this is no result of millwright"});
  shop.write("list.json", "[1, 2]");
  refuses({"compare", "list.json", "a.json"}, {"list.json"});
  Json wrong = Json::parse(shop.read("a.json"));
  wrong["totals"]["cost"]["value"] = "much";
  wrong["checks"][0]["verdict"] = "maybe";
  wrong["build"]["parts"][0].erase("slot");
  shop.write("wrong.json", wrong.dump());
  refuses({"compare", "wrong.json", "a.json"},
          {"totals.cost.value is not a number", "checks[0].verdict is 'maybe'", "build.parts[0].slot is missing"});

  REQUIRE(shop.run({"pareto", "m.toml", "--json", "front.json"}).exit_code == 0);
  REQUIRE(shop.run({"solve", "m.toml", "--limit", "cost=1", "--json", "none.json"}).exit_code == 1);
  refuses({"compare", "front.json", "none.json"}, {"a front holds several builds", "no build is compliant"});

  std::string renamed = one_slide;
  renamed.replace(renamed.find("name = \"x\""), 10, "name = \"u\"");
  shop.write("u.toml", renamed);
  REQUIRE(shop.run({"solve", "u.toml", "--json", "u.json"}).exit_code == 0);
  refuses({"compare", "a.json", "u.json"}, {"of different machines: axes x against u"});

  std::filesystem::remove(shop.path("m.toml"));
  refuses({"compare", "a.json", "b.csv"}, {"the problem that this result names is not there: 'm.toml'"});
}

}  // namespace
}  // namespace millwright::app::compare_test
