// SPDX-License-Identifier: Apache-2.0
#include "report/text_table.h"

#include "catch.h"

namespace millwright::report::text_table_test {
namespace {

TEST_CASE("Columns are as wide as needed, by what is seen and not by bytes") {
  TextTable table({{"name"}, {"value", Align::right}});
  table.add({"σ_v", "1.5"});
  table.add({"torque", "12"});
  CHECK(table.str(2) ==
        "  name    value\n"
        "  σ_v       1.5\n"
        "  torque     12\n");
}

TEST_CASE("Empty columns are left out, rows may be short, lines have no blanks at the end") {
  TextTable table({{"a"}, {"unused"}, {"b"}});
  table.add({"1"});
  table.add({"2", "", "x"});
  CHECK(table.str(0) == "a  b\n1\n2  x\n");
  CHECK(TextTable({{"a"}}).str().empty());
  TextTable titled({{"a"}, {"changes against the line above"}});
  titled.add({"1"});
  CHECK(titled.str(0) == "a\n1\n");
}

TEST_CASE("Long cells go on below, words are not broken") {
  TextTable table({{"", Align::left, 9}, {""}});
  table.add({"one two three incomprehensible", "end"});
  CHECK(table.str(0) ==
        "one two           end\n"
        "three\n"
        "incomprehensible\n");
  CHECK(wrapped("aa bb cc", 5, 2) == "aa bb\n  cc");
}

TEST_CASE("A table that is too wide gives way where it hurts least") {
  // The text gets 30 - 9 - 10 - 2 * 2 = 7 columns, and two words of them use 5.
  TextTable table({{"name"}, {"text"}, {"value", Align::right}});
  table.add({"C-ST-RMS1", "aa bb cc dd ee ff gg hh", "12.5 N/mm2"});
  CHECK(table.str(0, Style{.width = 30}) ==
        "name       text        value\n"
        "C-ST-RMS1  aa bb  12.5 N/mm2\n"
        "           cc dd\n"
        "           ee ff\n"
        "           gg hh\n");
  // Names next, after their marks; then numbers leave their units.
  TextTable names({{""}, {"", Align::right}});
  names.add({"peripheral_speed_numerator", "78500 mm/min"});
  CHECK(names.str(0, Style{.width = 26}) ==
        "peripheral_  78500 mm/min\n"
        "speed_\n"
        "numerator\n");
  CHECK(names.str(0, Style{.width = 22}) ==
        "peripheral_   78500\n"
        "speed_       mm/min\n"
        "numerator\n");
}

TEST_CASE("A column that must stay whole does, and the others give way") {
  TextTable table({{"", Align::left, 0, true}, {""}});
  table.add({"one two three", "four five six"});
  CHECK(table.str(0, Style{.width = 20}) == "one two three  four\n               five\n               six\n");
}

TEST_CASE("Line ends in a cell begin lines in it, which may hang") {
  TextTable table({{"", Align::left, 0, false, 2}, {"", Align::right}});
  table.add({"C-ACC Position error\n(at rest)", "1"});
  CHECK(table.str(0) == "C-ACC Position error  1\n  (at rest)\n");
  CHECK(table.str(0, Style{.width = 17}) == "C-ACC Position  1\n  error\n  (at rest)\n");
}

TEST_CASE("Equations go on below their first equals sign") {
  CHECK(equation("T = a + b = 12 N", 2, 18) == "  T = a + b = 12 N\n");
  CHECK(equation("T = a + b = 12 N", 2, 17) == "  T = a + b\n    = 12 N\n");
  CHECK(equation("σ = a = b = c", 0, 5) == "σ = a\n  = b\n  = c\n");
  CHECK(equation("incomprehensible", 1, 5) == " incomprehensible\n");
}

TEST_CASE("Lines that are too long are broken between words, and go on indented") {
  CHECK(fitted("  one two three\nfour\n\n", 11) == "  one two\n    three\nfour\n\n");
  CHECK(fitted("incomprehensible", 5) == "incomprehensible");
  CHECK(fitted("", 5).empty());
}

TEST_CASE("Colour takes no width, and none is written where none is wanted") {
  const Style colour{.colour = true};
  CHECK(display_width(colour.bad("FAIL")) == 4);
  CHECK(Style{}.bad("FAIL") == "FAIL");
  CHECK(display_width("x̄ = µ·m²") == 8);
  TextTable table({{""}, {""}});
  table.add({colour.good("ok"), "1"});
  table.add({"FAIL", "2"});
  CHECK(table.str(0) == colour.good("ok") + "    1\nFAIL  2\n");
}

}  // namespace
}  // namespace millwright::report::text_table_test
