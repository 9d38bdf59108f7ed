// SPDX-License-Identifier: Apache-2.0
//
// Factors are from the SI brochure (9th ed.) and NIST SP 811 appendix B; every trap known of UDUNITS-2 is a test.
#include "scalar/unit.h"

#include <numbers>
#include <thread>
#include <vector>

#include "catch.h"

namespace unit_test {

namespace {

using namespace millwright::scalar;

constexpr double pi_value = std::numbers::pi;

std::string refusal(std::string_view text) {
  std::string reason;
  return Unit::parse(text, reason) ? "" : reason;
}
std::string quantity_refusal(std::string_view text, std::string_view expected) {
  std::string reason;
  return parse_quantity(text, Unit::of(expected), reason) ? "" : reason;
}
double si(std::string_view text, std::string_view expected) {
  std::string reason;
  const auto quantity = parse_quantity(text, Unit::of(expected), reason);
  INFO(text << ": " << reason);
  REQUIRE(quantity.has_value());
  return quantity->si;
}
bool mentions(const std::string& text, std::string_view word) { return text.find(word) != std::string::npos; }

struct Factor {
  const char* unit;
  double si;
  Dimension dimension;
};

}  // namespace

TEST_CASE("factors of units") {
  const Factor factors[] = {
      {"m", 1, dimension::length},
      {"mm", 1e-3, dimension::length},
      {"um", 1e-6, dimension::length},
      {"\u00b5m", 1e-6, dimension::length},
      {"\u03bcm", 1e-6, dimension::length},
      {"in", 0.0254, dimension::length},
      {"ft", 0.3048, dimension::length},
      {"mm2", 1e-6, dimension::area},
      {"mm^2", 1e-6, dimension::area},
      {"mm²", 1e-6, dimension::area},
      {"mm3", 1e-9, dimension::volume},
      {"mm⁴", 1e-12, dimension::second_moment_of_area},
      {"cm^4", 1e-8, dimension::second_moment_of_area},
      {"L/min", 1e-3 / 60, dimension::volume / dimension::time},
      {"kg", 1, dimension::mass},
      {"g", 1e-3, dimension::mass},
      {"t", 1000, dimension::mass},
      {"lb", 0.45359237, dimension::mass},
      {"oz", 0.028349523125, dimension::mass},
      {"h", 3600, dimension::time},
      {"min", 60, dimension::time},
      {"N", 1, dimension::force},
      {"kgf", 9.80665, dimension::force},
      {"lbf", 4.4482216152605, dimension::force},
      {"ozf", 0.27801385095378125, dimension::force},
      {"kgf/mm2", 9.80665e6, dimension::pressure},
      {"kgf/mm^2", 9.80665e6, dimension::pressure},
      {"N/mm^2", 1e6, dimension::pressure},
      {"MPa", 1e6, dimension::pressure},
      {"bar", 1e5, dimension::pressure},
      {"psi", 6894.757293168361, dimension::pressure},
      {"N.cm", 1e-2, dimension::torque},
      {"Ncm", 1e-2, dimension::torque},
      {"mNm", 1e-3, dimension::torque},
      {"oz.in", 0.00706155181422604, dimension::torque},  // NIST SP 811: 7.061 552 E-03
      {"oz-in", 0.00706155181422604, dimension::torque},
      {"ozf.in", 0.00706155181422604, dimension::torque},
      {"in.oz", 0.00706155181422604, dimension::torque},
      {"lbf.in", 0.1129848290276167, dimension::torque},
      {"g.cm2", 1e-7, dimension::inertia},
      {"oz.in^2", 0.028349523125 * 0.0254 * 0.0254, dimension::inertia},
      {"oz.in.s^2", 0.00706155181422604, dimension::inertia},
      {"W", 1, dimension::power_output},
      {"hp", 745.69987158227022, dimension::power_output},
      {"Wh", 3600, dimension::power_output * dimension::time},  // NIST SP 811: 3.6 E+03
      {"kWh", 3.6e6, dimension::power_output * dimension::time},
      {"Ws", 1, dimension::power_output * dimension::time},
      {"PS", 735.49875, dimension::power_output},
      {"V", 1, dimension::voltage},
      {"mH", 1e-3, dimension::inductance},
      {"ohm", 1, dimension::resistance},
      {"\u03a9", 1, dimension::resistance},
      {"\u2126", 1, dimension::resistance},
      {"V/krpm", 60 / (2000 * pi_value), dimension::voltage * dimension::time},
      {"N/um", 1e6, dimension::stiffness},
      {"1/K", 1, dimension::none / dimension::temperature},
      {"W/(m.K)", 1, dimension::power_output / dimension::length / dimension::temperature},
      {"µm/(m·°C)", 1e-6, dimension::none / dimension::temperature},
      {"kg·m²/s³", 1, dimension::power_output},
      {"MPa·m^0.5", 1e6, dimension::pressure * power(dimension::length, 0.5)},
      {"rad/s²", 1, dimension::angular_acceleration},
      {"km/h", 1 / 3.6, dimension::speed},
      {"rad", 1, dimension::none},
      {"rev", 2 * pi_value, dimension::none},
      {"deg", pi_value / 180, dimension::none},
      {"°", pi_value / 180, dimension::none},
      {"arcmin", pi_value / 10800, dimension::none},
      {"arcsec", pi_value / 648000, dimension::none},
      {"rpm", pi_value / 30, dimension::angular_speed},
      {"r/min", pi_value / 30, dimension::angular_speed},
      {"rev/min", pi_value / 30, dimension::angular_speed},
      {"krpm", 1000 * pi_value / 30, dimension::angular_speed},
      {"pps", 1, dimension::frequency},
      {"kpps", 1000, dimension::frequency},
      {"Hz", 1, dimension::frequency},
      {"kHz", 1000, dimension::frequency},
      {"1/min", 1.0 / 60, dimension::frequency},
      {"min-1", 1.0 / 60, dimension::frequency},
      {"s⁻¹", 1, dimension::frequency},
      {"%", 0.01, dimension::none},
      {"", 1, dimension::none},
      {"1", 1, dimension::none},
  };
  for (const Factor& factor : factors) {
    const Unit unit = Unit::of(factor.unit);
    CAPTURE(factor.unit);
    CHECK(unit.to_si(1.0) == Approx(factor.si).epsilon(1e-12));
    CHECK(unit.to_si(0.0) == 0.0);
    CHECK(unit.dimension() == factor.dimension);
    CHECK(unit.name() == factor.unit);
    for (const double x : {1.0, -3.7, 1e-9, 12345.678}) CHECK(unit.from_si(unit.to_si(x)) == Approx(x).epsilon(1e-14));
  }
}

TEST_CASE("a newton metre in every spelling") {
  for (const char* text : {"N·m", "N*m", "N.m", "N m", "Nm", "N-m", "N⋅m", "N×m", "N · m", " N.m ", "J", "m.N"}) {
    CAPTURE(text);
    std::string reason;
    const auto unit = Unit::parse(text, reason);
    REQUIRE(unit.has_value());
    CHECK(unit->to_si(1.0) == 1.0);
    CHECK(unit->dimension() == dimension::torque);
  }
}

TEST_CASE("decimal units round once") {
  for (int i = 1; i < 2000; ++i) {
    const double whole = i;
    if (Unit::of("mm").to_si(whole) != whole / 1000.0) FAIL(i);
    if (Unit::of("N.cm").to_si(whole) != whole / 100.0) FAIL(i);
    if (Unit::of("MPa").to_si(whole) != whole * 1e6) FAIL(i);
    if (Unit::of("g.cm2").to_si(whole) != whole / 1e7) FAIL(i);
  }
  CHECK(Unit::of("in").to_si(1.0) == 0.0254);
  CHECK(Unit::of("kgf/mm2").to_si(1.0) == 9806650.0);
}

TEST_CASE("what UDUNITS-2 reads without an error and we refuse") {
  for (const char* text : {"20 mm",
                           "-5",
                           "1e3",
                           "5",
                           "0.001 m",
                           "m0.5",
                           "X since 2000-01-01",
                           "days since 1970",
                           "m @ 3",
                           "lg(re mW)",
                           "lg(re 1 mW)",
                           "ton",
                           "cps",
                           "cycles",
                           "cycle",
                           "pi",
                           "m^",
                           "m^-",
                           "m**2",
                           "m//s",
                           "(m",
                           "m)",
                           "()",
                           "/s",
                           ".m",
                           "m.",
                           "m/",
                           "*",
                           "m^0",
                           "m^99",
                           "m^1e3",
                           "W/m.K",
                           "W/m K",
                           "degC degC @ 2",
                           "m;s",
                           "m,s",
                           "m\ns",
                           "N m (",
                           "^2",
                           "²",
                           "10^3 m",
                           "m+s",
                           "mol",
                           "cd",
                           "dB",
                           "dBm",
                           "BV",
                           "\xff\xfe",
                           "m\xc2",
                           "2",
                           "m 2",
                           "mm/s 2",
                           "100%",
                           "EUR.USD",
                           "EUR/USD",
                           "EUR^2",
                           "1/EUR",
                           "$"}) {
    CAPTURE(text);
    CHECK_FALSE(refusal(text).empty());
  }
  CHECK_FALSE(refusal(std::string_view("m\0s", 3)).empty());
  CHECK_FALSE(refusal(std::string(2000, '(')).empty());
  CHECK_FALSE(refusal(std::string(100000, 'm')).empty());
  CHECK(mentions(refusal("W/m.K"), "parenthes"));
  CHECK(mentions(refusal("ton"), "short_ton"));
}

TEST_CASE("the nearest known unit is named") {
  CHECK(mentions(refusal("Mpa"), "'MPa'"));
  CHECK(mentions(refusal("mmm"), "'mm'"));
  CHECK(mentions(refusal("KW"), "'kW'"));
  CHECK(mentions(refusal("rpn"), "'rpm'"));
  CHECK(mentions(refusal("Kg"), "'kg'"));
  CHECK(mentions(refusal("usd"), "'USD'"));
  CHECK_FALSE(mentions(refusal("blorgh"), "did you mean"));
}

TEST_CASE("kinds") {
  const std::pair<const char*, UnitKind> kinds[] = {{"mm", UnitKind::plain},
                                                    {"", UnitKind::plain},
                                                    {"%", UnitKind::plain},
                                                    {"K", UnitKind::plain},
                                                    {"rad", UnitKind::angle},
                                                    {"deg", UnitKind::angle},
                                                    {"rev", UnitKind::angle},
                                                    {"rpm", UnitKind::angular_speed},
                                                    {"rad/s", UnitKind::angular_speed},
                                                    {"deg/s", UnitKind::angular_speed},
                                                    {"Hz", UnitKind::frequency},
                                                    {"1/s", UnitKind::frequency},
                                                    {"min-1", UnitKind::frequency},
                                                    {"pps", UnitKind::step_rate},
                                                    {"step/s", UnitKind::step_rate},
                                                    {"degC", UnitKind::temperature},
                                                    {"°C", UnitKind::temperature},
                                                    {"EUR", UnitKind::currency},
                                                    {"EUR/m", UnitKind::currency},
                                                    {"W/degC", UnitKind::plain},
                                                    {"N.m/rad", UnitKind::plain}};
  for (const auto& [text, kind] : kinds) {
    CAPTURE(text);
    CHECK(Unit::of(text).kind() == kind);
  }
  CHECK(Unit::of("EUR/m").currency() == "EUR");
  CHECK(Unit::of("€").currency() == "EUR");
}

TEST_CASE("what fits where") {
  CHECK(si("1500 rpm", "rad/s") == Approx(1500 * pi_value / 30));
  CHECK(si("90 deg", "rad") == Approx(pi_value / 2));
  CHECK(si("400 pps", "step/s") == 400.0);
  CHECK(si("5 %", "1") == 0.05);
  CHECK(si("5%", "1") == 0.05);
  CHECK(si("90°", "rad") == Approx(pi_value / 2));
  CHECK(si("0.25", "") == 0.25);
  CHECK(si("4.5 EUR/m", "EUR/mm") == 4.5);
  // 50 Hz is not 50 rad/s: the hint says what the difference is.
  CHECK(mentions(quantity_refusal("50 Hz", "rpm"), "60 rpm"));
  CHECK(mentions(quantity_refusal("3000 min-1", "rpm"), "rpm"));
  CHECK_FALSE(quantity_refusal("3000 rpm", "Hz").empty());
  CHECK_FALSE(quantity_refusal("3000 pps", "Hz").empty());
  CHECK(mentions(quantity_refusal("3000 Hz", "pps"), "pps"));
  CHECK_FALSE(quantity_refusal("3000 rpm", "pps").empty());
  CHECK_FALSE(quantity_refusal("1 rad", "1").empty());
  CHECK(mentions(quantity_refusal("1", "rad"), "unit is missing"));
  CHECK_FALSE(quantity_refusal("5 mm/rev", "mm").empty());
  CHECK_FALSE(quantity_refusal("5 N.m", "N.m/rad").empty());
  // UDUNITS-2 converts reciprocals: 4 s would become 0.25 Hz.
  CHECK_FALSE(quantity_refusal("4 s", "Hz").empty());
  CHECK_FALSE(quantity_refusal("2 kg/m", "m/kg").empty());
  CHECK_FALSE(quantity_refusal("4 EUR", "USD").empty());
  CHECK_FALSE(quantity_refusal("4 EUR", "").empty());
  CHECK_FALSE(quantity_refusal("4", "EUR").empty());
  CHECK(mentions(quantity_refusal("12 kg.cm", "N.m"), "kgf"));
  CHECK(mentions(quantity_refusal("12 kg", "N"), "kgf"));
}

TEST_CASE("temperatures and their differences") {
  CHECK(si("20 degC", "degC") == Approx(293.15));
  CHECK(si("20 °C", "degC") == Approx(293.15));
  CHECK(si("-40 degF", "degC") == Approx(233.15));
  CHECK(si("293.15 K", "degC") == Approx(293.15));
  CHECK(si("20 K", "K") == 20.0);
  CHECK(Unit::of("degC").from_si(373.15) == Approx(100.0));
  CHECK(mentions(quantity_refusal("20 degC", "K"), "difference"));
  CHECK(mentions(quantity_refusal("20 C", "degC"), "degC"));
  CHECK(si("2 W/degC", "W/K") == 2.0);
}

TEST_CASE("numbers") {
  std::string reason;
  for (const char* text :
       {"",         " ",    "-",     "+",  ".",   "abc",   "1,5", "1.000,5", "1,000", "inf", "-inf", "nan",
        "infinity", "0x10", "1e999", "1e", "1 2", "1_000", "--1", "+-1",     "1.2.3", "O.5", "1O"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_number(text, reason).has_value());
  }
  CHECK(parse_number("+1.5e-3", reason) == 1.5e-3);
  CHECK(parse_number("-.5", reason) == -0.5);
  CHECK(parse_number("5.", reason) == 5.0);
}

TEST_CASE("quantities are a number, a blank and a unit") {
  CHECK(si("20 mm/s", "m/s") == 0.02);
  CHECK(si("  62.7   N/mm^2 ", "MPa") == 62.7e6);
  CHECK(si("-1e3 N", "kN") == -1000.0);
  CHECK(si("1E3 N", "kN") == 1000.0);
  CHECK(mentions(quantity_refusal("20mm", "mm"), "'20 mm'"));
  CHECK(mentions(quantity_refusal("2e", "mm"), "not a number"));
  CHECK(mentions(quantity_refusal("1,5 mm", "mm"), "comma"));
  CHECK(mentions(quantity_refusal("20", "mm"), "'20 mm'"));
  CHECK(mentions(quantity_refusal("mm", "mm"), "number"));
  CHECK(mentions(quantity_refusal("10 m from 3", "mm"), "from"));
  CHECK(mentions(quantity_refusal("20 N", "mm"), "'mm' (m)"));
  for (const char* text : {"",
                           " ",
                           "20 20 mm",
                           "1/2 mm",
                           "2 * 3 mm",
                           "1e3",
                           "mm 20",
                           "inf mm",
                           "nan mm",
                           "1 - 2 mm",
                           "(1) mm",
                           "2 mm mm",
                           "1;2 mm",
                           "20 m/",
                           "20\tmm\t\x01"}) {
    CAPTURE(text);
    CHECK_FALSE(quantity_refusal(text, "mm").empty());
  }
  std::string reason;
  CHECK(parse_quantity("3 in", Unit::of("mm"), reason)->unit.name() == "in");
}

TEST_CASE("numbers and quantities as printed") {
  CHECK(format_number(0.0) == "0");
  CHECK(format_number(-0.0) == "0");
  CHECK(format_number(8.0) == "8");
  CHECK(format_number(2.50) == "2.5");
  CHECK(format_number(1.184018) == "1.184");
  CHECK(format_number(308.71, 3) == "309");
  CHECK(format_number(123456.7, 4) == "123457");
  CHECK(format_number(0.00012345, 3) == "0.000123");
  CHECK(format_number(1.2e-7) == "1.2e-07");
  CHECK(format_number(6.02e23, 3) == "6.02e+23");
  CHECK(format_number(99.996, 4) == "100");
  CHECK(format_number(9999.96, 5) == "10000");
  CHECK(format_number(-1234.5, 5) == "-1234.5");
  CHECK(format_number(100.0, 1) == "100");
  CHECK(format_number(std::numeric_limits<double>::infinity()) == "∞");
  CHECK(format(0.02, Unit::of("mm")) == "20 mm");
  CHECK(format(308.7e6, Unit::of("MPa")) == "308.7 MPa");
  CHECK(format(0.5, Unit()) == "0.5");
  CHECK(format(0.5, Unit::of("1")) == "0.5");
  CHECK(format(0.05, Unit::of("%")) == "5%");
  CHECK(format(293.15, Unit::of("degC")) == "20 degC");
  CHECK(format(1000 * pi_value / 30, Unit::of("rpm")) == "1000 rpm");
}

TEST_CASE("readable units have the dimension asked for and parse again") {
  CHECK(readable_unit(dimension::length, 0.02).name() == "mm");
  CHECK(readable_unit(dimension::length, 20).name() == "m");
  CHECK(readable_unit(dimension::length, 2e-6).name() == "µm");
  CHECK(readable_unit(dimension::pressure, -3e8).name() == "MPa");
  CHECK(readable_unit(dimension::torque, 2).name() == "N·m");
  CHECK(readable_unit(dimension::frequency, 2).name() == "rad/s");
  const Dimension square_of_torque = dimension::torque * dimension::torque;
  const Dimension cube_of_force = dimension::force * dimension::force * dimension::force;
  CHECK(readable_unit(cube_of_force * dimension::length, 2).name() == "N³·m");
  CHECK(readable_unit(square_of_torque * dimension::time, 2).name() == "N²·m²·s");
  for (const Dimension& d : {dimension::none,
                             dimension::length,
                             dimension::area,
                             dimension::volume,
                             dimension::mass,
                             dimension::time,
                             dimension::force,
                             dimension::torque,
                             dimension::power_output,
                             dimension::inertia,
                             dimension::voltage,
                             dimension::resistance,
                             dimension::inductance,
                             dimension::stiffness,
                             dimension::jerk,
                             dimension::current,
                             power(dimension::length, 0.5),
                             dimension::none / dimension::force,
                             dimension::temperature / dimension::power_output,
                             cube_of_force,
                             cube_of_force * dimension::length,
                             cube_of_force * dimension::speed,
                             square_of_torque,
                             square_of_torque * dimension::torque,
                             square_of_torque * dimension::time,
                             dimension::none / (dimension::mass * dimension::time)}) {
    for (const double value : {0.0, 1e-9, 1e-3, 1.0, -1e3, 1e12}) {
      CAPTURE(to_string(d), value);
      CHECK(readable_unit(d, value).dimension() == d);
      CHECK(readable_unit(d, value).to_si(0.0) == 0.0);
    }
  }
}

TEST_CASE("units from several threads") {
  const char* const texts[] = {
      "mm", "N.cm", "oz.in", "kgf/mm2", "furlong", "blorgh", "W/(m.K)", "EUR/m", "mil", "20 mm"};
  std::vector<std::jthread> threads;
  std::vector<int> parsed(4, 0);
  for (std::size_t t = 0; t < parsed.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 2000; ++i) {
        std::string reason;
        // New spellings too, so that not everything comes from the cache.
        const std::string fresh = "m" + std::to_string(i % 12 + 1) + ".s" + std::to_string(i % 7 + 1);
        parsed[t] += Unit::parse(texts[static_cast<std::size_t>(i) % std::size(texts)], reason).has_value() ? 1 : 0;
        parsed[t] += Unit::parse(fresh, reason).has_value() ? 1 : 0;
      }
    });
  }
  threads.clear();
  for (const int count : parsed) CHECK(count == 2000 * 8 / 10 + 2000);
}

TEST_CASE("a unit written in the program that does not exist is our own error") {
  CHECK_THROWS_AS(Unit::of("blorgh"), std::logic_error);
}

TEST_CASE("What leaves the range of numbers in its unit is refused") {
  CHECK(quantity_refusal("9e307 km", "mm").find("is too large") != std::string::npos);
  CHECK(quantity_refusal("9e307 m", "mm").empty());
}

}  // namespace unit_test
