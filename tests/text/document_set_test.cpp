// SPDX-License-Identifier: Apache-2.0
#include <random>

#include "catch.h"
#include "text/document.h"

namespace document_set_test {

using namespace millwright::text;

namespace {

constexpr const char* machine =
    "title = \"m\"\n"
    "supply = { voltage = [\"24 V\", \"36 V\"] }\n"
    "[[axis]]\nname = \"x\"\nstroke = \"700 mm\"\n"
    "[[axis.moves]]\ntime = \"36 s\"\n"
    "[[axis.moves]]\ntime = \"5 s\"\n"
    "[[axis]]\nname = \"y\"\nstroke = \"300 mm\"\n";

Document document() {
  Diagnostics diagnostics;
  return *read_toml(SourceText::from_string("m.toml", machine), diagnostics);
}

const Node& axis(const Document& d, std::size_t i) { return d.root().find("axis")->at(i); }

/// The printed complaint about an assignment that cannot be done; the document must be as before.
std::string refusal(const std::string& assignment) {
  Document d = document();
  Diagnostics diagnostics;
  CHECK_FALSE(d.set(assignment, diagnostics));
  REQUIRE(diagnostics.error_count() == 1);
  CHECK(d.root().size() == 3);
  return format(diagnostics.all()[0]);
}

}  // namespace

TEST_CASE("values are set by name, position and key") {
  Document d = document();
  Diagnostics diagnostics;
  CHECK(d.set("axis.x.moves[0].time=0.3 s", diagnostics));
  CHECK(d.set("axis[1].stroke=\"400 mm\"", diagnostics));
  CHECK(d.set("axis[x].stroke = 650 mm ", diagnostics) == false);  // blanks are not part of a path
  CHECK(diagnostics.error_count() == 1);
  CHECK(d.set("axis[x].stroke", " 650 mm ", diagnostics));
  CHECK(d.set("axis.y.require.inertia_ratio=30", diagnostics));
  CHECK(d.set("supply.voltage[1]=48 V", diagnostics));
  CHECK(d.set("title=", diagnostics));
  CHECK(d.set("\"odd key\".flag=true", diagnostics));
  CHECK(d.set("objective.minimise=[\"cost\", 'mass']", diagnostics));
  CHECK(d.set("formula=a=b", diagnostics));
  CHECK(d.set("start=2026-01-15", diagnostics));
  CHECK(diagnostics.error_count() == 1);
  CHECK(axis(d, 0).find("moves")->at(0).find("time")->as_string() == "0.3 s");
  CHECK(axis(d, 0).find("moves")->at(1).find("time")->as_string() == "5 s");
  CHECK(axis(d, 0).find("stroke")->as_string() == "650 mm");
  CHECK(axis(d, 1).find("stroke")->as_string() == "400 mm");
  CHECK(axis(d, 1).find("require")->find("inertia_ratio")->as_integer() == 30);
  CHECK(d.root().find("supply")->find("voltage")->at(1).as_string() == "48 V");
  CHECK(d.root().find("title")->as_string() == "");
  CHECK(d.root().find("odd key")->find("flag")->as_boolean() == true);
  CHECK(d.root().find("objective")->find("minimise")->at(1).as_string() == "mass");
  CHECK(d.root().find("formula")->as_string() == "a=b");
  CHECK(d.root().find("start")->as_date() == "2026-01-15");
}

TEST_CASE("what was set points at the command line") {
  Document d = document();
  Diagnostics diagnostics;
  REQUIRE(d.set("axis.x.moves[0].time=0.3 sec", diagnostics));
  const Node& time = *axis(d, 0).find("moves")->at(0).find("time");
  diagnostics.error(time.part_span(4, 3), "unknown unit 'sec'", "did you mean 's'?");
  REQUIRE(d.set("axis.x.strok=1", diagnostics));
  diagnostics.error(axis(d, 0).key_span("strok"), "unknown key");
  REQUIRE(d.set("voltage=[\"µ\", 12]", diagnostics));
  diagnostics.error(d.root().find("voltage")->at(1).span(), "no unit");
  CHECK(format(diagnostics) ==
        "command line:1:32: error: unknown unit 'sec'\n"
        "    1 | --set axis.x.moves[0].time=0.3 sec\n"
        "      |                                ^~~ hint: did you mean 's'?\n"
        "command line:1:14: error: unknown key\n"
        "    1 | --set axis.x.strok=1\n"
        "      |              ^~~~~\n"
        "command line:1:21: error: no unit\n"
        "    1 | --set voltage=[\"µ\", 12]\n"
        "      |                     ^~\n"
        "3 errors\n");
}

TEST_CASE("assignments that lead nowhere are refused at the step") {
  CHECK(refusal("axis.z.stroke=1") ==
        "command line:1:12: error: no element has the name 'z'\n"
        "    1 | --set axis.z.stroke=1\n"
        "      |            ^ hint: there is x, y\n");
  CHECK(refusal("axis[2].stroke=1").find("the list has 2 elements, counted from 0") != std::string::npos);
  CHECK(refusal("axis.x.mooves[0].time=1").find("1:14: error: there is no 'mooves'") != std::string::npos);
  CHECK(refusal("axis.x.mooves[0].time=1").find("did you mean 'moves'?") != std::string::npos);
  CHECK(refusal("title.x=1").find("this leads into text, which has no keys") != std::string::npos);
  CHECK(refusal("title[0]=1").find("has no positions") != std::string::npos);
  CHECK(refusal("supply.voltage.a.b=1").find("by their position") != std::string::npos);
  CHECK(refusal("stroke").find("'=' is missing") != std::string::npos);
  CHECK(refusal("=1").find("a key is expected") != std::string::npos);
  CHECK(refusal("a..b=1").find("1:9: error: a key is expected") != std::string::npos);
  CHECK(refusal("a[1=1").find("']' is missing") != std::string::npos);
  CHECK(refusal("a[]=1").find("a position or a name is expected") != std::string::npos);
  CHECK(refusal("\"a=1").find("the quote is never closed") != std::string::npos);
  CHECK(refusal("supply.voltage=[\"24 V\"").substr(0, 15) == "command line:1:");
  CHECK(refusal("new.table.x=nan").find("not a finite number") != std::string::npos);
  CHECK(refusal("title=\"a\"\nb=\"c\"").find("one value is expected") != std::string::npos);
  CHECK(refusal("axis[99999999999999999999999].a=1").find("no element has the name") != std::string::npos);
}

TEST_CASE("a path of thousands of parts is refused") {
  std::string path = "a";
  for (int i = 0; i < 50000; ++i) path += ".a";
  CHECK(refusal(path + "=1").find("a path of more than 8 parts") != std::string::npos);
}

TEST_CASE("random assignments never crash") {
  std::mt19937 generator(21);
  const std::vector<std::string> pieces = {"axis", "x", ".", "[",  "]", "0",    "9",    "=",    "\"", "'",    "moves",
                                           "{",    "}", " ", "\n", "µ", "\x01", "\xFF", "name", ",",  "title"};
  Document d = document();
  for (int round = 0; round < 20000; ++round) {
    std::string assignment = generator() % 2 == 0 ? "axis.x." : "";
    for (auto n = generator() % 12; n > 0; --n) assignment += pieces[generator() % pieces.size()];
    Diagnostics diagnostics;
    const bool done = d.set(assignment, diagnostics);
    REQUIRE((done || diagnostics.has_errors()));
    CHECK((diagnostics.count() == 0 || !format(diagnostics).empty()));
    if (generator() % 16 == 0) d = document();
  }
}

}  // namespace document_set_test
