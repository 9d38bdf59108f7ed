// SPDX-License-Identifier: Apache-2.0
#include "machine/objective.h"

#include <random>

#include "catch.h"
#include "problem_text.h"

namespace objective_test {

using namespace millwright;
using machine::Quantity;

namespace {

std::string name_of(const std::string& text) {
  machine::ObjectiveFault fault;
  const auto objective = machine::parse_objective(text, fault);
  return objective ? objective->name() : "fault: " + fault.message;
}

}  // namespace

TEST_CASE("Objectives are quantities and weighted sums, however they are spaced") {
  CHECK(name_of("cost") == "cost");
  CHECK(name_of("  cycle_time\t") == "cycle_time");
  CHECK(name_of("cost+25*mass") == "cost + 25*mass");
  CHECK(name_of(" 1e-3 * energy + 1*cost +.5*mass") == "0.001*energy + cost + 0.5*mass");
  CHECK(name_of("2*cost") == "2*cost");
  CHECK(name_of("1e3*cost") == "1000*cost");
  CHECK(machine::objective_named("mass").single() == Quantity::mass);
  CHECK(machine::objective_named("1*mass").single() == Quantity::mass);
  CHECK_FALSE(machine::objective_named("2*mass").single());
  CHECK_FALSE(machine::objective_named("cost + mass").single());
  CHECK_THROWS_AS(machine::objective_named("price"), std::invalid_argument);
  const auto terms = machine::objective_named("cost + 0.1*position_error").terms;
  REQUIRE(terms.size() == 2);
  CHECK(terms[1].weight == 0.1);
  CHECK(terms[1].quantity == Quantity::position_error);
}

TEST_CASE("Only what objectives ask for beside cost and mass is counted, once") {
  CHECK(machine::counted_quantities({"cost", "mass"}).empty());
  CHECK(machine::counted_quantities({"energy", "cost + 2*energy + cycle_time"}) ==
        std::vector<Quantity>{Quantity::cycle_time, Quantity::energy});
}

TEST_CASE("A weighted objective in a problem file is known by its name and counts its quantities") {
  const auto outcome =
      problem_text::read(problem_text::replaced(problem_text::sound, "\"cost\"", "\"cost+ 2.50*cycle_time\""));
  REQUIRE(outcome.problem);
  CHECK(outcome.problem->objective == "cost + 2.5*cycle_time");
  CHECK(outcome.problem->counted == std::vector<Quantity>{Quantity::cycle_time});
}

// Whatever is typed is understood, and then its name is understood as the same, or has a fault inside the text.
TEST_CASE("Random objectives are understood or have a place where they are wrong") {
  std::mt19937 random(3);
  const std::vector<std::string> pieces{
      "cost", "mass", "energy", "+", "*", " ", "25", "1e", "-3", ".", "x", "\xC3\xA4", "0"};
  int good = 0;
  for (int n = 0; n < 20000; ++n) {
    std::string text;
    const auto length = random() % 6;
    for (unsigned i = 0; i < length; ++i) text += pieces[random() % pieces.size()];
    machine::ObjectiveFault fault;
    const auto objective = machine::parse_objective(text, fault);
    INFO(text);
    if (objective) {
      ++good;
      REQUIRE(name_of(objective->name()) == objective->name());
    } else {
      REQUIRE(fault.offset + fault.length <= text.size());
      REQUIRE_FALSE(fault.message.empty());
      REQUIRE_FALSE(fault.hint.empty());
    }
  }
  CHECK(good > 300);
}

}  // namespace objective_test
