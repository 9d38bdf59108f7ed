// SPDX-License-Identifier: Apache-2.0
// The reports of a small machine made by hand.
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "report/bom_csv.h"
#include "report/design_text.h"
#include "report/json.h"
#include "report/machine_text.h"
#include "report/page_parts.h"
#include "report/quantity_text.h"
#include "scalar/unit.h"

namespace millwright::report::machine_report_test {
namespace {

using evaluation::Check;
using evaluation::Verdict;
using machine::ConstraintKind;
using Json = nlohmann::json;

constexpr double infinity = std::numeric_limits<double>::infinity();
const double undefined = std::nan("");

Check check_of(
    const char* id, double value, double limit, Verdict verdict, ConstraintKind kind = ConstraintKind::hard) {
  Check check;
  check.axis = "x";
  check.element = "drive";
  check.id = id;
  check.title = std::string("title of ") + id;
  check.kind = kind;
  check.value = value;
  check.limit = limit;
  check.unit = "MPa";
  check.utilisation = value / limit;
  check.verdict = verdict;
  check.source = "book, p. 1";
  return check;
}

MachineResult result_of_three_checks() {
  evaluation::Design design;
  design.currency = "USD";
  evaluation::PartLine screw;
  screw.axis = "x";
  screw.slot = "screw";
  screw.family = "lead_screws";
  screw.manufacturer = "Maker, \"Best\" Ltd";
  screw.part_number = "T10-2";
  screw.length = 0.384;
  screw.price = 5.0;
  screw.unit_price = 5.0;
  screw.currency = "USD";
  screw.mass = 0.2;
  screw.estimate = true;
  screw.where = "catalogues/lead_screws/generic.csv:7";
  design.parts.push_back(screw);
  design.dimensions.push_back({"x", "acceleration_time", 0.1 + 0.2, "s"});
  design.dimensions.push_back({"x", "shaft.diameter", 0.0125, "m"});
  design.checks = {check_of("C-LOW", 10.0, 100.0, Verdict::satisfied),
                   check_of("C-OPEN", undefined, 100.0, Verdict::not_evaluated, ConstraintKind::soft),
                   check_of("C-BAD", 120.0, 100.0, Verdict::violated),
                   check_of("C-SOFT", 150.0, 100.0, Verdict::violated, ConstraintKind::soft),
                   check_of("C-NEVER", 1.0, 0.0, Verdict::violated)};
  design.cost = 7.5;  // 2.5 more than the parts: a member made to measure
  design.mass = 0.5;
  MachineResult result;
  result.currency = design.currency;
  result.title = "Small";
  result.file = "small.toml";
  result.axes = {"x"};
  result.objectives = {"cost"};
  result.bom_file = "bom.csv";
  result.status = Status::optimal;
  result.lower_bound = 7.5;
  result.designs = {design};
  return result;
}

TEST_CASE("Checks are sorted by utilisation, what is not evaluated last") {
  const MachineResult result = result_of_three_checks();
  std::vector<std::string> ids;
  for (const Check* check : checks_of(result.designs.front(), "x")) ids.push_back(check->id);
  CHECK(ids == std::vector<std::string>{"C-NEVER", "C-SOFT", "C-BAD", "C-LOW", "C-OPEN"});
}

TEST_CASE("A check's report lists what fails first, and soft checks are no failures") {
  Style full;
  full.full = true;
  const std::string text = check_text(result_of_three_checks(), full);
  CHECK(text.find("It fails 2 of 5 checks.") != std::string::npos);
  const std::string summary = text.substr(0, text.find("Governing check"));
  CHECK(summary.find("C-BAD") != std::string::npos);
  CHECK(summary.find("120.0 %") != std::string::npos);
  CHECK(summary.find("C-SOFT") == std::string::npos);
  CHECK(text.find("C-SOFT*") != std::string::npos);
  CHECK(text.find("open: a figure that the check needs is not known") != std::string::npos);
  CHECK(text.find("nan") == std::string::npos);
}

TEST_CASE("A check in short tells failures, what is next to its limit, and what is only reported and over") {
  MachineResult result = result_of_three_checks();
  result.designs[0].checks.push_back(check_of("C-NEAR", 96.0, 100.0, Verdict::satisfied));
  result.designs[0].checks.push_back(check_of("C-FAR", 20.0, 100.0, Verdict::satisfied));
  const std::string text = check_text(result, {});
  const auto count = [&](const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
  };
  CHECK(text.find("It fails 2 of 7 checks.") != std::string::npos);
  CHECK(count("title of C-BAD") == 1);
  CHECK(text.find("title of C-NEAR  96.0 %") != std::string::npos);
  CHECK(count("C-FAR") == 0);
  const std::size_t over = text.find("Reported, not enforced, and over");
  REQUIRE(over != std::string::npos);
  CHECK(text.find("title of C-SOFT  150.0 %", over) != std::string::npos);
  CHECK(text.find("--full: all 7 checks") != std::string::npos);
  CHECK(text.find("Parts\n") != std::string::npos);
}

TEST_CASE("Utilisation just over the limit does not look like the limit") {
  Check check = check_of("C", 100.001, 100.0, Verdict::violated);
  CHECK(utilisation_text(check) == "> 100 %");
  check.utilisation = 1.0;
  CHECK(utilisation_text(check) == "100.0 %");
  check.utilisation = infinity;
  CHECK(utilisation_text(check) == "> 999 %");
  check.verdict = Verdict::not_evaluated;
  CHECK(utilisation_text(check) == "-");
}

TEST_CASE("Estimates are marked, members made to measure are not forgotten") {
  const MachineResult result = result_of_three_checks();
  const std::string text = parts_text(result, result.designs.front(), {});
  CHECK(text.find("~5.00") != std::string::npos);
  CHECK(text.find("~ the price, or a figure of the part that matters, is an estimate") != std::string::npos);
  CHECK(text.find("384") != std::string::npos);
  CHECK(text.find("Members made to measure, by their mass: 2.50 USD, 0.300 kg") != std::string::npos);
  CHECK(text.find("Total: 7.50 USD, 0.500 kg") != std::string::npos);
}

TEST_CASE("Of a part the estimated inputs have what is estimated of it, and not what is quoted") {
  MachineResult result = result_of_three_checks();
  evaluation::Design& design = result.designs.front();
  design.parts[0].price_estimate = true;
  design.parts[0].price_basis = "estimate 2025";
  evaluation::PartLine motor = design.parts[0];
  motor.slot = "motor";
  motor.part_number = "AM-2301";
  motor.price_estimate = false;
  motor.price_basis = "list 2026-02-01";
  motor.confidence = "high";
  design.parts.push_back(motor);
  design.checks.push_back(check_of("C-ST-TORQUE", 1.0, 2.0, Verdict::satisfied));
  design.checks.back().note = "torque at speed is an estimate";
  const std::string page = basis_sections(result, design, Texts(Language::english));
  const std::string estimates = page.substr(page.find("Estimated inputs"));
  CHECK(estimates.find("estimate 2025") != std::string::npos);
  CHECK(estimates.find("torque at speed, by the model of the winding") > estimates.find("AM-2301"));
  CHECK(estimates.find("list 2026") == std::string::npos);
  CHECK(estimates.find("high") == std::string::npos);
}

TEST_CASE("JSON has neither infinity nor NaN, and the stable names") {
  const std::string text = solve_json(result_of_three_checks());
  CHECK(text.find("Infinity") == std::string::npos);
  const Json json = Json::parse(text);
  CHECK(json.at("schema") == "millwright.result/1");
  CHECK(json.at("status") == "optimal");
  CHECK(json.at("objective") ==
        Json{{"name", "cost"}, {"value", 7.5}, {"unit", "USD"}, {"lower_bound", 7.5}, {"gap", 0.0}});
  CHECK(json.at("totals").at("mass") == Json{{"value", 0.5}, {"unit", "kg"}});
  const Json& part = json.at("build").at("parts")[0];
  for (const char* key : {"axis",
                          "slot",
                          "family",
                          "manufacturer",
                          "part_number",
                          "quantity",
                          "unit_price",
                          "currency",
                          "mass_kg",
                          "row"})
    CHECK(part.contains(key));
  const Json& worst = json.at("checks")[0];
  CHECK(worst.at("id") == "C-NEVER");
  CHECK(worst.at("utilisation").is_null());
  CHECK(worst.at("kind") == "hard");
  CHECK(json.at("checks")[4].at("verdict") == "not evaluated");
  CHECK(json.at("checks")[4].at("value").is_null());
  CHECK(Json::parse(check_json(result_of_three_checks())).at("satisfied") == false);
  CHECK(Json::parse(front_json(result_of_three_checks())).at("front").size() == 1);
}

TEST_CASE("Formulas used outside their stated range have a section of their own, and fail nothing") {
  MachineResult result = result_of_three_checks();
  Style full;
  full.full = true;
  const char* const heading = "Outside the range a formula is stated for";
  CHECK(check_text(result, full).find(heading) == std::string::npos);
  CHECK(Json::parse(check_json(result)).at("outside_validity") == Json::array());
  result.designs[0].outside_validity.push_back({.axis = "x",
                                                .element = "drive",
                                                .constraint = "C-LOW",
                                                .formula = "rack.velocity_factor",
                                                .title = "Velocity factor",
                                                .sentence = "speed = 13 m/s is above 12.5 m/s",
                                                .source = "book, p. 2",
                                                .values = {{"speed", "m/s", {13.0}}}});
  result.designs[0].formulas_watched = 7;
  for (const std::string& text : {check_text(result, full), solve_text(result, full)}) {
    const std::size_t begin = text.find(heading);
    REQUIRE(begin != std::string::npos);
    CHECK(text.find("rack.velocity_factor  speed = 13 m/s is above 12.5 m/s", begin) != std::string::npos);
    CHECK(text.find("Requirements", 0) > begin);
  }
  CHECK(check_text(result, {}).find("It fails 2 of 5 checks.") != std::string::npos);
  for (const std::string& text : {check_json(result), solve_json(result)}) {
    const Json json = Json::parse(text);
    CHECK(json.at("formulas_watched") == 7);
    REQUIRE(json.at("outside_validity").size() == 1);
    CHECK(json.at("outside_validity")[0] ==
          Json{{"axis", "x"},
               {"element", "drive"},
               {"id", "C-LOW"},
               {"formula", "rack.velocity_factor"},
               {"title", "Velocity factor"},
               {"limit", "speed = 13 m/s is above 12.5 m/s"},
               {"arguments", {{{"name", "speed"}, {"values", {13.0}}, {"unit", "m/s"}}}},
               {"source", "book, p. 2"}});
  }
}

TEST_CASE("Nothing compliant: the checks that always fail and the ways out are said, in text and JSON") {
  MachineResult result = result_of_three_checks();
  result.designs.clear();
  result.status = Status::infeasible;
  CHECK(solve_text(result, {}).find("'check' with a bill of materials") != std::string::npos);
  CHECK(Json::parse(solve_json(result)).at("unmet") == Json::array());
  result.unmet = {{"x", "drive", "C-ACC-TOTAL", "Position error budget", "position_error", "", 1.23456, "", ""},
                  {"x", "drive", "C-NEVER", "Never", "", "", 1e9, "", ""}};
  CHECK(solve_text(result, {}).find("'explain' finds by how much") != std::string::npos);
  evaluation::WayOut way;
  way.mapped = true;
  way.least = false;
  way.changes = {{"x", 10e-6, 70.5e-6, 0.7}};
  way.cost = 380.294;
  way.mass = 13.5;
  way.currency = "USD";
  result.ways_out = {way};
  const std::string text = solve_text(result, {});
  for (const char* said : {"C-ACC-TOTAL  Position error budget   123.4 %  position_error",  // never more than proved
                           "C-NEVER      Never                   no part",
                           "with lead_error = \"mapped\"",
                           "x: position_error 10 -> 70.5 um over 700 mm",
                           "time was up: less may do",
                           "cheapest build then: 380.29 USD, 13.500 kg"}) {
    INFO(said << " in\n" << text);
    CHECK(text.find(said) != std::string::npos);
  }
  for (const std::string& answer : {solve_json(result), front_json(result)}) {
    const Json json = Json::parse(answer);
    CHECK(json.at("unmet")[0] == Json{{"axis", "x"},
                                      {"element", "drive"},
                                      {"id", "C-ACC-TOTAL"},
                                      {"title", "Position error budget"},
                                      {"requirement", "position_error"},
                                      {"least_utilisation", 1.23456}});
    const Json& said = json.at("ways_out")[0];
    CHECK(said.at("lead_error") == "mapped");
    CHECK(said.at("least") == false);
    CHECK(said.at("changes")[0].at("to") == 70.5e-6);
    CHECK(said.at("cost") == Json{{"value", 380.294}, {"unit", "USD"}});
  }
  CHECK_FALSE(Json::parse(check_json(result_of_three_checks())).contains("unmet"));
}

TEST_CASE("No build: said with the reason, in text and JSON") {
  MachineResult result = result_of_three_checks();
  result.designs.clear();
  result.status = Status::infeasible;
  result.missing = {{"x", "motor", "no NEMA99"}};
  CHECK(solve_text(result, {}).find("axis x: no candidate for slot motor (no NEMA99)") != std::string::npos);
  CHECK(check_text(result, {}).find("slot motor") != std::string::npos);
  CHECK(front_text(result, {}).find("slot motor") != std::string::npos);
  const Json json = Json::parse(solve_json(result));
  CHECK(json.at("objective").at("value").is_null());
  CHECK(json.at("missing")[0].at("slot") == "motor");
}

TEST_CASE("A limit is said with the gap") {
  MachineResult result = result_of_three_checks();
  result.status = Status::limit;
  result.lower_bound = 6.0;
  result.gap = 0.2;
  const std::string text = solve_text(result, {});
  CHECK(text.find("Best build found before the search was ended: 7.50 USD") != std::string::npos);
  CHECK(text.find("not below 6.00 USD, gap 20.00 %") != std::string::npos);
  CHECK(text.find("Not proved") != std::string::npos);
}

TEST_CASE("Of a bound no more is said than was proved, of a gap no less") {
  using machine::Quantity;
  CHECK(quantity_bound_text(Quantity::cost, 6.019999, "USD") == "6.01 USD");
  CHECK(quantity_bound_text(Quantity::cost, 6.02, "USD") == "6.02 USD");
  CHECK(quantity_bound_text(Quantity::cost, 0.0, "USD") == "0.00 USD");
  CHECK(quantity_bound_text(Quantity::mass, 11.9038, "USD") == "11.903 kg");
  CHECK(quantity_bound_text(Quantity::cycle_time, 2.0009, "USD") == "2.000 s");
  CHECK(quantity_bound_text(Quantity::energy, 1907.978, "USD") == "1907.9 J");
  CHECK(quantity_bound_text(Quantity::energy, 1908.0, "USD") == "1908 J");
  CHECK(quantity_bound_text(Quantity::position_error, 207.398e-6, "USD") == "207.3 um");
  CHECK(objective_bound_text("cost + 25*mass", 123.456789, "USD") == "123.4567");
  CHECK(gap_percent(0.2) == "20.00");
  CHECK(gap_percent(1.6e-5) == "0.01");
  CHECK(gap_percent(0.12341) == "12.35");
  CHECK(gap_percent(0.0) == "0.00");
  MachineResult result = result_of_three_checks();
  result.status = Status::limit;
  result.lower_bound = 7.4999;
  result.gap = 1.4e-5;
  const std::string text = solve_text(result, {});
  CHECK(text.find("not below 7.49 USD, gap 0.01 %") != std::string::npos);
  CHECK(text.find("a build of 7.49 USD or more may still exist (gap 0.01 %)") != std::string::npos);
}

TEST_CASE("The bill of materials quotes what it must and keeps every bit that may decide a check") {
  MachineResult result = result_of_three_checks();
  const std::string dimensions = "x,shaft.diameter,,,,,12.5 mm\n";
  result.designs.front().checks.push_back(
      check_of("F-SUPPLY-VOLTAGE", 36.0, 36.0, Verdict::satisfied, ConstraintKind::fit));
  CHECK(bom_csv(result.designs.front()).ends_with("x,acceleration_time,,,,,0.3 s\n" + dimensions));
  result.designs.front().dimensions.front().value = 0.2707106781186548;
  CHECK(bom_csv(result.designs.front()).ends_with("x,acceleration_time,,,,,0.2707106781186548 s\n" + dimensions));
  result = result_of_three_checks();
  result.designs.front().checks.push_back(check_of("C-EDGE", 100.0, 100.0, Verdict::satisfied));
  CHECK(bom_csv(result.designs.front()) ==
        "axis,slot,manufacturer,part_number,quantity,length,value\n"
        "x,screw,\"Maker, \"\"Best\"\" Ltd\",T10-2,1,384 mm,\n"
        "x,acceleration_time,,,,,0.30000000000000004 s\n"
        "x,shaft.diameter,,,,,12.5 mm\n");
  CHECK(csv_cell("plain") == "plain");
  CHECK(csv_cell("# no comment") == "\"# no comment\"");
  CHECK(csv_cell("line\nbreak") == "\"line\nbreak\"");
}

// A rail of 1247.5 mm that is cut to 1247 mm is too short.
TEST_CASE("Lengths have their tenths, however long they are") {
  CHECK(millimetres_text(1.2475) == "1247.5");
  CHECK(millimetres_text(12.3456) == "12345.6");
  CHECK(millimetres_text(2.49998) == "2500");
  CHECK(millimetres_text(0.70994) == "709.9");
  CHECK(millimetres_text(0.01234) == "12.34");
  MachineResult result = result_of_three_checks();
  result.designs.front().parts.front().length = 1.2475;
  CHECK(check_text(result, {}).find("  1247.5  ") != std::string::npos);
}

TEST_CASE("A reduction is on the bill of materials by its name, and left out without one") {
  evaluation::Design design;
  evaluation::PartLine& line = design.parts.emplace_back();
  line.axis = "x";
  line.slot = "reduction";
  line.part_number = "as the problem states it";
  const std::string header = "axis,slot,manufacturer,part_number,quantity,length,value\n";
  CHECK(bom_csv(design) == header);
  line.manufacturer = "generic";
  line.part_number = "3:1 belt";
  CHECK(bom_csv(design) == header + "x,reduction,generic,3:1 belt,1,,\n");
}

TEST_CASE("A length survives the way through millimetres bit for bit") {
  std::string reason;
  for (double metres = 1e-4; metres < 3.0; metres *= 1.0173) {
    const auto back = scalar::parse_quantity(exact_quantity(metres, "mm", "m"), scalar::Unit::of("mm"), reason);
    REQUIRE(back);
    CHECK(back->si == metres);
  }
}

}  // namespace
}  // namespace millwright::report::machine_report_test
