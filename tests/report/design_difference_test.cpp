// SPDX-License-Identifier: Apache-2.0
#include "report/design_difference.h"

#include "catch.h"

namespace millwright::report::design_difference_test {
namespace {

evaluation::PartLine part(const char* axis, const char* slot, const char* maker, const char* number) {
  evaluation::PartLine line;
  line.axis = axis;
  line.slot = slot;
  line.manufacturer = maker;
  line.part_number = number;
  return line;
}

std::string sentence(const DesignDifference& d) { return d.axis + "." + d.slot + ": " + d.before + " -> " + d.now; }

TEST_CASE("Builds differ in parts and settings, and what one of them has not is shown as a dash") {
  evaluation::Design before;
  before.parts = {part("x", "motor", "Maker", "A1"),
                  part("x", "driver", "Other", "D1"),
                  part("x", "nut", "", "N1"),
                  part("y", "motor", "Maker", "A1")};
  before.dimensions = {
      {"x", "motor_current", 1.2, "A"}, {"x", "acceleration_time", 0.1, "s"}, {"machine", "supply_voltage", 24.0, "V"}};
  CHECK(differences(before, before).empty());

  evaluation::Design now;
  now.parts = {part("x", "motor", "Maker", "A2"),
               part("x", "driver", "Clone", "D1"),
               part("x", "coupling", "", "K1"),
               part("y", "motor", "Maker", "A1")};
  now.dimensions = {{"x", "acceleration_time", 0.3, "s"}, {"machine", "supply_voltage", 36.0, "V"}};
  const std::vector<DesignDifference> found = differences(before, now);
  std::vector<std::string> sentences;
  for (const DesignDifference& each : found) sentences.push_back(sentence(each));
  CHECK(sentences == std::vector<std::string>{"x.motor: Maker A1 -> Maker A2",
                                              "x.driver: Other D1 -> Clone D1",
                                              "x.coupling: – -> K1",
                                              "x.nut: N1 -> –",
                                              "machine.supply_voltage: 24 V -> 36 V",
                                              "x.motor_current: 1.2 A -> –"});
  // Makers are named where the number does not tell.
  REQUIRE(found.size() == 6);
  CHECK(found[0].short_now == "A2");
  CHECK(found[1].short_before == "Other D1");
  CHECK(found[1].short_now == "Clone D1");
}

TEST_CASE("The same parts differ where they are bought elsewhere, or one of them is in stock") {
  evaluation::Design before;
  before.parts = {part("x", "motor", "Maker", "A1"),
                  part("x", "driver", "Other", "D1"),
                  part("x", "coupling", "", "K1"),
                  part("y", "motor", "Maker", "A1")};
  for (evaluation::PartLine& line : before.parts) line.quantity = 1.0;
  evaluation::Design now = before;
  CHECK(purchase_differences(before, now).empty());
  now.parts[0].supplier = "Shop A";
  now.parts[1].part_number = "D2";  // another part: not said here
  now.parts[1].supplier = "Shop A";
  now.parts[2].owned = 1.0;
  now.parts[3].owned = 1.0;
  now.parts[3].spares = 1.0;  // one is bought
  CHECK(differences(before, now).size() == 1);
  const std::vector<DesignDifference> found = purchase_differences(before, now);
  REQUIRE(found.size() == 2);
  CHECK(sentence(found[0]) == "x.motor: Maker A1 as the catalogue offers it -> Maker A1 from Shop A");
  CHECK(found[0].short_now == "A1 from Shop A");
  CHECK(sentence(found[1]) == "x.coupling: K1 as the catalogue offers it -> K1 in stock");
}

}  // namespace
}  // namespace millwright::report::design_difference_test
