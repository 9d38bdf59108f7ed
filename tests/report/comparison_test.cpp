// SPDX-License-Identifier: Apache-2.0
// Two builds made by hand, so that what differs is known.
#include "report/comparison.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.h"

namespace millwright::report::comparison_test {
namespace {

using evaluation::Check;
using evaluation::PartLine;
using evaluation::Verdict;

PartLine part(const char* slot, const char* number, double price, double mass) {
  PartLine line;
  line.axis = "x";
  line.slot = slot;
  line.manufacturer = "Maker";
  line.part_number = number;
  line.price = line.unit_price = price;
  line.mass = mass;
  line.currency = "USD";
  return line;
}

Check check(const char* id, double utilisation, machine::ConstraintKind kind = machine::ConstraintKind::hard) {
  Check result;
  result.axis = "x";
  result.element = "drive";
  result.id = id;
  result.title = std::string("title of ") + id;
  result.kind = kind;
  result.value = utilisation;
  result.limit = 1.0;
  result.unit = "N";
  result.utilisation = utilisation;
  result.verdict = utilisation > 1.0 ? Verdict::violated : Verdict::satisfied;
  return result;
}

ComparedBuild build_a() {
  ComparedBuild a{"a.json", "as recorded", "Machine", {"x"}, {}};
  a.design.currency = "USD";
  a.design.cost = 40.0;
  a.design.mass = 2.0;
  a.design.parts = {part("motor", "M1", 10.0, 0.5),
                    part("driver", "D1", 5.0, 0.1),
                    part("nut", "N1", 2.0, 0.2),
                    part("screw", "S1", 23.0, 1.2)};
  a.design.checks = {check("C-ONE", 0.5),
                     check("C-TWO", 0.9),
                     check("C-THREE", 0.2),
                     check("C-FOUR", 0.7),
                     check("C-SOFT", 0.4, machine::ConstraintKind::soft)};
  a.design.dimensions = {{"x", "acceleration_time", 0.2, "s"}, {"machine", "supply_voltage", 24.0, "V"}};
  return a;
}

ComparedBuild build_b() {
  ComparedBuild b = build_a();
  b.file = "b.csv";
  b.design.cost = 43.5;
  b.design.mass = 1.9;
  // The driver for half a unit more, the motor for two less and lighter, the screw cut longer for five; no nut, a belt.
  b.design.parts = {part("motor", "M2", 8.0, 0.3),
                    part("driver", "D2", 5.5, 0.1),
                    part("screw", "S1", 28.0, 1.3),
                    part("belt", "B1", 2.0, 0.2)};
  b.design.parts[2].length = 0.6;
  b.design.checks = {check("C-ONE", 0.55),
                     check("C-TWO", 1.1),
                     check("C-THREE", 0.8),
                     check("C-FOUR", 0.70001),
                     check("C-SOFT", 1.4, machine::ConstraintKind::soft),
                     check("C-NEW", 0.1)};
  b.design.dimensions[0].value = 0.1;
  return b;
}

TEST_CASE("What matters comes first: prices by their difference, then checks that fail in one build only") {
  const ComparedBuild a = build_a(), b = build_b();
  const Comparison found = compare(a, b);
  std::vector<std::string> slots;
  std::vector<double> prices;
  for (const PartChange& change : found.parts) {
    slots.push_back(change.slot);
    prices.push_back(change.price());
  }
  // Of equal differences in price that in mass decides: motor -2.00 and -0.2 kg, then belt +2.00 and nut -2.00 by 0.2.
  CHECK(slots == std::vector<std::string>{"screw", "motor", "belt", "nut", "driver"});
  CHECK(prices == std::vector<double>{5.0, -2.0, 2.0, -2.0, 0.5});
  CHECK(found.parts[1].mass() == Approx(-0.2));
  CHECK(found.parts[2].a == nullptr);
  CHECK(found.parts[3].b == nullptr);
  CHECK(found.same_parts == 0);

  std::vector<std::string> ids;
  for (const CheckChange& change : found.checks) ids.push_back(change.either().id);
  // C-TWO turns, the soft one too; then the new one, of which nothing is known before, 0.6, 0.05.
  CHECK(ids == std::vector<std::string>{"C-TWO", "C-SOFT", "C-NEW", "C-THREE", "C-ONE"});
  CHECK(found.checks[0].turns());
  CHECK(found.checks[1].turns());
  CHECK_FALSE(found.checks[3].turns());
  CHECK(found.checks[3].change() == Approx(0.6));
  CHECK(found.same_checks == 1);  // C-FOUR, by a thousandth of a percent
  REQUIRE(found.dimensions.size() == 1);
  CHECK(found.dimensions[0].name == "acceleration_time");
  CHECK(failed_checks(a.design) == 0);
  CHECK(failed_checks(b.design) == 1);
}

TEST_CASE("A build compared with itself differs in nothing") {
  const ComparedBuild a = build_a();
  const Comparison found = compare(a, a);
  CHECK(found.parts.empty());
  CHECK(found.checks.empty());
  CHECK(found.dimensions.empty());
  CHECK(found.same_parts == 4);
  CHECK(found.same_checks == 5);
}

TEST_CASE("The comparison fits 80 columns and says which build fails") {
  ComparedBuild a = build_a(), b = build_b();
  a.design.parts[0].part_number = "a motor with a name that is much longer than a column is wide";
  b.design.checks[1].title = "a title that takes more room than there is beside all the numbers of the line";
  const std::string text = comparison_text(a, b, Style{});
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    CHECK(display_width(line) <= 80);
  }
  CHECK(text.find("+3.50 USD") != std::string::npos);
  CHECK(text.find("-0.100 kg") != std::string::npos);
  CHECK(text.find("B FAILS") != std::string::npos);
  CHECK(text.find("S1, 600 mm") != std::string::npos);
  const std::string json = comparison_json(a, b);
  const nlohmann::json read = nlohmann::json::parse(json);
  CHECK(read.at("command") == "compare");
  CHECK(read.at("b").at("failed") == 1);
  CHECK(read.at("parts").size() == 5);
  CHECK(read.at("parts")[2].at("a").is_null());
  CHECK(read.at("checks")[0].at("turns") == true);
}

}  // namespace
}  // namespace millwright::report::comparison_test
