// SPDX-License-Identifier: Apache-2.0
// What is odd among rows that are odd together, in other currencies and with one phase on. Expected values by hand.
#include "catalogue/plausibility.h"

#include <fmt/format.h>

#include <cmath>

#include "catalogue/table_of.h"
#include "catch.h"

namespace plausibility_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

bool nothing(std::string_view) { return false; }

const std::string motors =
    "manufacturer,part_number,frame,frame_size [mm],body_length [mm],shaft_diameter [mm],step_angle [deg],"
    "holding_torque [N.m],detent_torque [N.m],rated_current [A],phase_resistance [ohm],phase_inductance [mH],"
    "rotor_inertia [g.cm2],mass [kg],phases_on [1],price,currency\n";

/// QSH5718-76-28-189 at some price.
std::string motor(int number,
                  const std::string& price_and_currency,
                  const std::string& torque = "1.89",
                  const std::string& phases_on = "") {
  return fmt::format("Acme,P{},NEMA23,57,76,6.35,1.8,{},0.066,2.8,1.13,3.6,480,1.0,{},{}\n",
                     number,
                     torque,
                     phases_on,
                     price_and_currency);
}

}  // namespace

TEST_CASE("figures that scatter without any law are no law, and each beyond the limits is told") {
  std::string rows =
      "manufacturer,part_number,width [mm],height [mm],slot [mm],area [mm2],second_moment_x [mm4],"
      "second_moment_y [mm4],section_modulus_x [mm3],section_modulus_y [mm3],mass_per_length [kg/m],alloy,"
      "elastic_modulus [MPa],yield_strength [MPa],price_per_length [1/m],currency\n";
  const std::vector<double> moduli{30, 40, 48, 56, 64, 69, 72, 78, 90, 105, 125, 150};  // GPa
  for (std::size_t i = 0; i < moduli.size(); ++i)
    rows += fmt::format("A,P{},20,20,6,166.7,6800,6800,680,680,0.45,6063-T5,{},160,3.5,USD\n", i, moduli[i] * 1e3);
  const Table table = table_of(Family::extrusions, rows);
  const Plausibility plausibility(table);
  for (int row = 0; row < table.rows(); ++row) {
    const double modulus = moduli[static_cast<std::size_t>(row)];
    INFO(modulus);
    const auto found = plausibility.examine(row, nothing);
    // Aluminium: 69 GPa, impossible beyond a factor of 1.3.
    const bool impossible = modulus < 69 / 1.3 || modulus > 69 * 1.3;
    REQUIRE((!impossible || found));
    CHECK((found && found->impossible) == impossible);
    if (found) CHECK(declaration(found->column).name == "elastic_modulus");
    CHECK_FALSE(plausibility.examine(row, [](std::string_view rule) { return rule == "alloy"; }));
  }
}

TEST_CASE("a price is not judged by prices in other currencies") {
  const Table rupiah = table_of(Family::steppers, motors + motor(0, "450000,IDR"));
  CHECK_FALSE(Plausibility(rupiah).examine(0, nothing));
  const Table dollars = table_of(Family::steppers, motors + motor(0, "450000,USD"));
  const auto found = Plausibility(dollars).examine(0, nothing);
  REQUIRE(found);
  CHECK(declaration(found->column).name == "price");
  CHECK(found->impossible);
  std::string mixed = motors + motor(0, "30,USD");
  for (int i = 1; i <= 12; ++i) mixed += motor(i, "450000,IDR");
  const Table both = table_of(Family::steppers, mixed);
  const Plausibility plausibility(both);
  for (int row = 0; row < both.rows(); ++row) CHECK_FALSE(plausibility.examine(row, nothing));
}

TEST_CASE("ten prices in another currency are judged by each other, nine are not") {
  const auto shop = [](int sound) {
    std::string rows = motors + motor(0, "450,IDR");
    for (int i = 1; i <= sound; ++i) rows += motor(i, fmt::format("{},IDR", 390000 + 10000 * i));
    return table_of(Family::steppers, rows);
  };
  const Table few = shop(8);
  const Plausibility of_few(few);
  for (int row = 0; row < few.rows(); ++row) CHECK_FALSE(of_few.examine(row, nothing));
  const Table many = shop(12);  // 450 and 400000 to 510000: the seventh of thirteen is 450000
  const Plausibility of_many(many);
  for (int row = 1; row < many.rows(); ++row) CHECK_FALSE(of_many.examine(row, nothing));
  const auto found = of_many.examine(0, nothing);
  REQUIRE(found);
  CHECK(declaration(found->column).name == "price");
  CHECK(found->value == Approx(450));
  CHECK(found->factor == Approx(1e-3));
  CHECK(found->expected_low < 450000);
  CHECK(found->expected_high > 450000);
}

// Without a frame size nothing else speaks of the mass: 36 kg^-0.6 times 1 kg is usual, and 5000 is 139 times that. The
// usual slips of a mass are commoner than those of a price, but motors of a tonne are not.
TEST_CASE("where only its price speaks of a mass, the price is blamed, and the mass mentioned") {
  for (const char* price : {"5000", "0.3"}) {
    std::string row = motor(1, std::string(price) + ",USD");
    row.replace(row.find(",57,"), 4, ",,");
    const Table table = table_of(Family::steppers, motors + row);
    const auto found = Plausibility(table).examine(0, nothing);
    INFO(price);
    REQUIRE(found);
    CHECK(declaration(found->column).name == "price");
    CHECK(found->value == Approx(std::stod(price)));
    CHECK(found->expected_low < 36.0);
    CHECK(found->expected_high > 36.0);
    REQUIRE(found->instead);
    CHECK(declaration(*found->instead).name == "mass");
  }
}

TEST_CASE("a torque with one phase on is judged as the root of two times it") {
  // Ten times too large, stated with both phases on and with one.
  const Table both = table_of(Family::steppers, motors + motor(0, "30,USD", "18.9"));
  const Table one = table_of(Family::steppers, motors + motor(0, "30,USD", "13.364318164425751", "1"));
  const auto of_both = Plausibility(both).examine(0, nothing), of_one = Plausibility(one).examine(0, nothing);
  REQUIRE(of_both);
  REQUIRE(of_one);
  CHECK(declaration(of_one->column).name == "holding_torque");
  CHECK(of_one->rules == of_both->rules);
  CHECK(of_one->factor == Approx(of_both->factor));
  CHECK(of_one->value == Approx(13.364318164425751));
  CHECK(of_one->expected_low == Approx(of_both->expected_low / std::sqrt(2.0)));
  CHECK(of_one->expected_high == Approx(of_both->expected_high / std::sqrt(2.0)));
}

}  // namespace plausibility_test
