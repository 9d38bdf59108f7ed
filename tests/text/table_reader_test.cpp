// SPDX-License-Identifier: Apache-2.0
#include "text/table_reader.h"

#include "catch.h"
#include "text/document.h"

namespace table_reader_test {

using namespace millwright::text;

namespace {
Document parse(const std::string& toml) {
  Diagnostics diagnostics;
  return *read_toml(SourceText::from_string("p.toml", toml), diagnostics);
}
}  // namespace

TEST_CASE("values are read by kind") {
  const Document d =
      parse("name = 'x'\ncount = 3\nratio = 2.5\nhold = true\nframe = ['a', 'b']\none = 'c'\ntable = {}\n");
  Diagnostics diagnostics;
  TableReader reader(d.root(), "axis 'x'", diagnostics);
  CHECK(reader.string("name", Presence::required) == "x");
  CHECK(reader.integer("count") == 3);
  CHECK(reader.number("ratio") == 2.5);
  CHECK(reader.number("count") == 3.0);
  CHECK(reader.boolean("hold") == true);
  CHECK(reader.strings("frame") == std::vector<std::string>{"a", "b"});
  CHECK(reader.strings("one") == std::vector<std::string>{"c"});
  CHECK(reader.list("none").empty());
  CHECK(reader.table("table") != nullptr);
  CHECK(reader.array("frame") != nullptr);
  CHECK(reader.word("one", {"b", "c"}) == "c");
  CHECK_FALSE(reader.string("missing"));
  CHECK(reader.has("name"));
  CHECK_FALSE(reader.has("other"));
  reader.finish();
  CHECK(format(diagnostics).empty());
}

TEST_CASE("an unknown key is reported with the nearest known one") {
  const Document d = parse("[axis]\nname = 'x'\n  storke = '700 mm'\nname2 = 1\ncolour = 'red'\n");
  Diagnostics diagnostics;
  TableReader reader(*d.root().find("axis"), "axis 'x'", diagnostics);
  reader.string("name");
  reader.string("stroke", Presence::required);
  reader.find("structure_mass");
  reader.finish();
  CHECK(format(diagnostics) ==
        "p.toml:1:1: error: axis 'x' needs the key 'stroke'\n"
        "    1 | [axis]\n"
        "      | ^~~~~~\n"
        "p.toml:3:3: error: unknown key 'storke' in axis 'x'\n"
        "    3 |   storke = '700 mm'\n"
        "      |   ^~~~~~ hint: did you mean 'stroke'?\n"
        "p.toml:4:1: error: unknown key 'name2' in axis 'x'\n"
        "    4 | name2 = 1\n"
        "      | ^~~~~ hint: did you mean 'name'?\n"
        "p.toml:5:1: error: unknown key 'colour' in axis 'x'\n"
        "    5 | colour = 'red'\n"
        "      | ^~~~~~ hint: known keys: name, stroke, structure_mass\n"
        "4 errors\n");
}

TEST_CASE("of very many unknown keys most are only counted") {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += "key" + std::to_string(i) + " = 1\n";
  const Document d = parse(text);
  Diagnostics diagnostics;
  TableReader(d.root(), "file", diagnostics).finish();
  CHECK(diagnostics.error_count() == 20000);
  CHECK(format(diagnostics).find("note: ... and 19950 more\n") != std::string::npos);
}

TEST_CASE("a value of another kind is reported where it stands") {
  const Document d =
      parse("a = 5\nb = '5'\nc = 2.0\nd = 'true'\ne = 'x'\nf = ['x', 3]\ng = 2026-01-15\nh = '1O'\ni = 'scerw'\n");
  Diagnostics diagnostics;
  TableReader reader(d.root(), "the file", diagnostics);
  CHECK_FALSE(reader.string("a"));
  CHECK_FALSE(reader.number("b"));
  CHECK_FALSE(reader.integer("c"));
  CHECK_FALSE(reader.boolean("d"));
  CHECK(reader.table("e") == nullptr);
  CHECK(reader.strings("f") == std::vector<std::string>{"x"});
  CHECK_FALSE(reader.string("g"));
  CHECK_FALSE(reader.number("h"));
  CHECK_FALSE(reader.word("i", {"screw", "belt"}));
  reader.finish();
  std::vector<std::string> found;
  for (const Diagnostic& x : diagnostics.all()) {
    found.push_back(std::to_string(x.where.line) + ":" + std::to_string(x.where.column) + " " + x.message + " | " +
                    x.hint);
  }
  CHECK(found ==
        std::vector<std::string>{
            "1:5 'a' must be text, but this is a whole number | put it in quotes, with its unit if it has one",
            "2:5 'b' must be a number, but this is text | write it without quotes: 5",
            "3:5 'c' must be a whole number, but this is a number | write it without a decimal point",
            "4:5 'd' must be true or false, but this is text | write it without quotes: true",
            "5:5 'e' must be a table, but this is text | a table is written as { key = value } or under a [header]",
            "6:11 'f' must be text, but this is a whole number | put it in quotes, with its unit if it has one",
            "7:5 'g' must be text, but this is a date | put it in quotes",
            "8:5 'h' must be a number, but this is text | letter O where a zero was meant: 10",
            "9:5 'i' cannot be 'scerw' | did you mean 'screw'?"});
}

TEST_CASE("a node that is no table is reported once") {
  const Document d = parse("axis = 3\n");
  Diagnostics diagnostics;
  TableReader reader(*d.root().find("axis"), "'axis'", diagnostics);
  CHECK_FALSE(reader.string("name", Presence::required));
  reader.finish();
  REQUIRE(diagnostics.count() == 1);
  CHECK(diagnostics.all()[0].message == "'axis' must be a table, but this is a whole number");
}

}  // namespace table_reader_test
