// SPDX-License-Identifier: Apache-2.0
#include "report/text_table.h"

#include "catch.h"

namespace millwright::report {
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
}  // namespace millwright::report
