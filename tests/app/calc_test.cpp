// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "catch.h"

namespace millwright::app::calc_test {
namespace {

using Json = nlohmann::json;

Json json_of(const std::vector<std::string>& words) {
  const Workshop shop;
  std::vector<std::string> all = words;
  all.insert(all.end(), {"--json", "-"});
  const Outcome outcome = shop.run(all);
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  return Json::parse(outcome.out);
}

// Handbook, SCREW-TORQUE-RAISE: 1500 N, 14 mm, 4 mm, 0.155 give 2.619353588 N m.
const std::vector<std::string> raising = {
    "calc", "power_screw.raising_torque", "force=1500 N", "mean_diameter=14 mm", "lead=4 mm", "friction=0.155"};

TEST_CASE("The handbook's raising torque, with its derivation") {
  const Json json = json_of(raising);
  CHECK(json.at("schema") == "millwright.result/1");
  CHECK(json.at("formula") == "power_screw.raising_torque");
  CHECK(json.at("value_si").get<double>() == Approx(2.619353588).epsilon(1e-9));
  CHECK(json.at("unit_si") == "N.m");
  REQUIRE(json.at("inputs").size() == 4);
  CHECK(json.at("inputs")[1].at("name") == "mean_diameter");
  CHECK(json.at("inputs")[1].at("value").get<double>() == Approx(0.014));
  CHECK(json.at("inputs")[1].at("unit") == "m");
  REQUIRE(json.at("derivation").size() >= 2);
  CHECK(json.at("derivation").back().at("value").get<double>() == Approx(2.619353588).epsilon(1e-9));
  CHECK(json.at("warnings").empty());

  const Workshop shop;
  const Outcome text = shop.run(raising);
  CHECK(text.exit_code == 0);
  CHECK(text.prints("T_R = 2.619353588 N.m"));
  CHECK(text.prints("1500 N · 14 mm / 2"));
  CHECK(text.prints("source: khurmi_gupta2005"));
}

TEST_CASE("Handbook ids, other units and a unit for the result") {
  const Json json = json_of({"calc",
                             "SCREW-TORQUE-RAISE",
                             "friction=0.155",
                             "lead=0.4 cm",
                             "mean_diameter=0.014 m",
                             "force=1.5 kN",
                             "--unit",
                             "N.cm"});
  CHECK(json.at("value").get<double>() == Approx(261.9353588).epsilon(1e-9));
  CHECK(json.at("unit") == "N.cm");
  CHECK(json.at("value_si").get<double>() == Approx(2.619353588).epsilon(1e-9));
}

void refuses(const std::vector<std::string>& arguments, const std::vector<std::string>& complaints) {
  const Workshop shop;
  std::vector<std::string> words = {"calc"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const Outcome outcome = shop.run(words);
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  for (const std::string& complaint : complaints) {
    CAPTURE(complaint);
    CHECK(outcome.says(complaint));
  }
}

TEST_CASE("Everything wrong with the arguments is said at once") {
  refuses({"power_screw.raising_torque", "force=1500", "lead=4 kg", "frictoin=0.1"},
          {"command line:1:7: error: force: ",
           "a unit is missing",
           "command line:1:6: error: lead: ",
           "power_screw.raising_torque has no argument 'frictoin'",
           "hint: did you mean 'friction'?",
           "error: mean_diameter is missing: mean diameter [m]",
           "hint: e.g. mean_diameter='1 m'",
           "error: friction is missing: "});
  refuses({"power_screw.raising_torque", "force=1 N", "force=2 N"}, {"force is given twice"});
  refuses({"power_screw.raising_torque", "1500"}, {"'1500' is no argument: expected name=value"});
  refuses({"power_screw.raising_torque", "force="}, {"force: a value is missing"});
  refuses({"power_screw.raising_torque", "force=1,5 N"}, {"force: "});
}

TEST_CASE("A formula that is not there, and a result unit that does not fit") {
  refuses({"raising_torque"},
          {"there is no formula 'raising_torque'", "hint: did you mean 'power_screw.raising_torque'?"});
  refuses({"power_screw.raising_torqe"}, {"hint: did you mean 'power_screw.raising_torque'?"});
  refuses(
      {"power_screw.raising_torque", "force=1 N", "mean_diameter=1 mm", "lead=1 mm", "friction=0.1", "--unit", "kN"},
      {"--unit: ", "hint: the result is in N.m"});
}

TEST_CASE("Every choice of a formula can be chosen, with dashes or underscores") {
  const Workshop shop;
  const Json all = Json::parse(shop.run({"formulas", "--json", "-"}).out).at("formulas");
  std::size_t tried = 0;
  for (const Json& formula : all)
    for (const Json& argument : formula.at("arguments")) {
      if (!argument.contains("choices")) continue;
      for (const std::string choice : argument.at("choices")) {
        for (const char dash : {'-', '_'}) {
          std::string word = choice;
          for (char& letter : word)
            if (letter == '-' || letter == '_') letter = dash;
          const Outcome outcome =
              shop.run({"calc", formula.at("name"), argument.at("name").get<std::string>() + "=" + word});
          CAPTURE(formula.at("name").get<std::string>(), word);
          CHECK_FALSE(outcome.says("is no choice"));
          ++tried;
        }
      }
    }
  CHECK(tried > 10);
  // A beam fixed at both ends, F L/8 under a load in the middle (Roark); on two supports F L/4.
  const auto moment = [](const std::string& load_case) {
    return json_of({"calc", "beam.largest_moment", "load_case=" + load_case, "load=100 N", "length=1 m"})
        .at("value_si")
        .get<double>();
  };
  CHECK(moment("fixed-point") == Approx(12.5));
  CHECK(moment("supported_point") == Approx(25.0));
}

TEST_CASE("Of what may have any unit the result is read as what is given: revolutions are no cycles") {
  const std::vector<std::string> twice{"calc", "arithmetic.multiple", "value=1000 rpm", "factor=2", "--unit"};
  const auto in = [&](const std::string& unit) {
    std::vector<std::string> words = twice;
    words.push_back(unit);
    return words;
  };
  CHECK(json_of(in("rad/s")).at("value").get<double>() == Approx(209.4395102));
  CHECK(json_of(in("rpm")).at("value").get<double>() == Approx(2000.0));
  refuses({"arithmetic.multiple", "value=1000 rpm", "factor=2", "--unit", "Hz"}, {"--unit: "});
  const Json difference = json_of({"calc", "arithmetic.difference", "minuend=20 degC", "subtrahend=5 degC"});
  CHECK(difference.at("value").get<double>() == Approx(15.0));
  CHECK(difference.at("unit") == "K");
  const Json winding = json_of({"calc",
                                "stepper.winding_temperature",
                                "ambient_temperature=20 degC",
                                "power_loss=10 W",
                                "thermal_resistance=3 K/W"});
  CHECK(winding.at("value_si").get<double>() == Approx(323.15));
  CHECK(winding.at("unit_si") == "K");
  CHECK(winding.at("inputs")[0].at("unit") == "K");
}

TEST_CASE("Lists and names as arguments") {
  const Workshop shop;
  const Json all = Json::parse(shop.run({"formulas", "--json", "-"}).out).at("formulas");
  bool seen_list = false;
  bool seen_choice = false;
  for (const Json& formula : all) {
    if (formula.at("arguments").empty()) continue;
    const Json& first = formula.at("arguments")[0];
    if (formula.at("arguments").size() == 1 && first.contains("list") && first.at("unit") == "any" && !seen_list) {
      seen_list = true;
      const Json json = json_of({"calc", formula.at("name"), first.at("name").get<std::string>() + "=3 mm,5 mm"});
      CHECK(json.at("inputs")[0].at("value").size() == 2);
      CHECK(json.at("inputs")[0].at("value")[1].get<double>() == Approx(0.005));
    }
    for (const Json& argument : formula.at("arguments")) {
      if (!argument.contains("choices") || seen_choice) continue;
      seen_choice = true;
      refuses({formula.at("name"), argument.at("name").get<std::string>() + "=nonsense_word"},
              {"'nonsense_word' is no choice", argument.at("choices")[0]});
    }
  }
  CHECK(seen_list);
  CHECK(seen_choice);
  // Hand calculation: 3 mm + 5 mm; the unit that was used is the unit of the answer.
  const Json sum = json_of({"calc", "arithmetic.sum", "values=3 mm,5 mm"});
  CHECK(sum.at("value").get<double>() == Approx(8.0));
  CHECK(sum.at("unit") == "mm");
  refuses({"arithmetic.sum", "values=3 mm,5 kg"}, {"command line:1:13: error: values: "});
  refuses({"arithmetic.sum", "values=3 mm,,5 mm"}, {"values: a value is missing"});
}

TEST_CASE("Outside the stated validity there is a warning, outside the formula's domain no answer") {
  const Workshop shop;
  std::vector<std::string> asked{
      "calc", "power_screw.raising_torque", "force=-1500 N", "mean_diameter=14 mm", "lead=4 mm", "friction=0.155"};
  const Outcome negative = shop.run(asked);
  CHECK(negative.exit_code == 0);
  CHECK(negative.prints("outside the stated validity: force = -1500 N is below 0 N"));
  // In degrees as they were asked for, not in kelvins.
  const Outcome hot =
      shop.run({"calc", "stepper.hot_resistance", "resistance_at_20_celsius=1 ohm", "winding_temperature=400 degC"});
  CHECK(hot.prints("outside the stated validity: winding_temperature = 400 degC is above 200"));
  CHECK(negative.err.empty());
  asked.push_back("--quiet");
  const Outcome quiet = shop.run(asked);
  CHECK(quiet.exit_code == 0);
  CHECK(quiet.says("warning: power_screw.raising_torque: force = -1500 N is below 0 N"));
}

TEST_CASE("A count that is not a whole number is warned of, in text and JSON") {
  const Workshop shop;
  const auto lead = [](const char* starts) {
    return std::vector<std::string>{"calc", "power_screw.lead", "pitch=4 mm", starts};
  };
  const Outcome text = shop.run(lead("starts=2.5"));
  CHECK(text.exit_code == 0);
  CHECK(text.prints("outside the stated validity: starts = 2.5 is not a whole number"));
  CHECK(json_of(lead("starts=2.5")).at("warnings") == Json{"starts = 2.5 is not a whole number"});
  CHECK(json_of(lead("starts=2")).at("warnings").empty());
}

TEST_CASE("A relation between arguments that does not hold is warned of, in text and JSON") {
  const Workshop shop;
  // tan λ = 31.4 / (π · 10): 45 degrees.
  const std::vector<std::string> steep{
      "calc", "power_screw.raising_torque", "force=100 N", "mean_diameter=10 mm", "lead=31.4 mm", "friction=0.1"};
  const Outcome text = shop.run(steep);
  CHECK(text.exit_code == 0);
  CHECK(text.prints("outside the stated validity: it does not hold that lead angle < 40 degrees"));
  CHECK(json_of(steep).at("warnings") == Json{"it does not hold that lead angle < 40 degrees"});
  // A square bar of 10 mm, 1 m long: slenderness 346, where Johnson's parabola ends at 129.
  const auto column = [](const char* length) {
    return std::vector<std::string>{"calc",
                                    "column.johnson_load",
                                    "end_fixity=1",
                                    "elastic_modulus=210 GPa",
                                    "yield_strength=250 MPa",
                                    "area=100 mm^2",
                                    "second_moment_of_area=833 mm^4",
                                    length};
  };
  CHECK(json_of(column("length=1 m")).at("warnings").size() == 1);
  CHECK(json_of(column("length=100 mm")).at("warnings").empty());
}

TEST_CASE("A result that is too large for a number is warned of") {
  const Workshop shop;
  const std::vector<std::string> huge{
      "calc", "power_screw.raising_torque", "force=1e300 N", "mean_diameter=1e300 mm", "lead=8 mm", "friction=0.08"};
  CHECK(shop.run(huge).prints("infinite, or too large for a number"));
  const Json json = json_of(huge);
  CHECK(json.at("value").is_null());
  CHECK(json.at("warnings").back() == "the result is infinite, or too large for a number");
}

TEST_CASE("Formulas are found by words, and told with all that calc needs") {
  const Workshop shop;
  const Outcome text = shop.run({"formulas", "critical speed"});
  CHECK(text.exit_code == 0);
  CHECK(text.prints("SCREW-CRITICAL-SPEED"));
  CHECK(text.prints("eigenvalue"));
  CHECK(text.prints("source: "));
  CHECK_FALSE(text.prints("power_screw.raising_torque"));
  const Json json = Json::parse(shop.run({"formulas", "raising_torque", "--json", "-"}).out);
  bool found = false;
  for (const Json& formula : json.at("formulas")) {
    if (formula.at("name") != "power_screw.raising_torque") continue;
    found = true;
    CHECK(formula.at("handbook_id") == "SCREW-TORQUE-RAISE");
    CHECK(formula.at("unit") == "N.m");
    REQUIRE(formula.at("arguments").size() == 4);
    CHECK(formula.at("arguments")[0] ==
          Json{{"name", "force"}, {"symbol", "W"}, {"unit", "N"}, {"meaning", "axial load opposing the motion"}});
  }
  CHECK(found);
}

}  // namespace
}  // namespace millwright::app::calc_test
