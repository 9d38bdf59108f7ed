// SPDX-License-Identifier: Apache-2.0
// `catalogue import` as a user meets it: what is written, and what never is.
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "app/program.h"
#include "catch.h"

namespace millwright::app::import_test {
namespace {

constexpr const char* table =
    "Brand,Part No,Step angle (deg),Torque (N.cm),Current,Weight (kg),Price (EUR),Stock\n"
    "ACME,007,1.8,126,2.8 A,1.0,24.33,12\n"
    "ACME,008,1.8,44,1.7 A,0.28,12.50,3\n";
constexpr const char* without_unit =
    "Brand,Part No,Step angle (deg),Torque,Current (A),Price (EUR)\nACME,007,1.8,1.26,2.8,24.33\n";

std::vector<std::string> import(const std::vector<std::string>& more) {
  std::vector<std::string> words{"catalogue", "import", "prices.csv"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_CASE("An import shows what it would do, and writes when it is told to") {
  const Workshop shop;
  shop.write("prices.csv", table);
  const Outcome shown = shop.run(import({"--family", "steppers", "--output", "steppers.csv"}));
  CHECK(shown.exit_code == 1);  // nobody confirmed
  CHECK(shown.prints("holding_torque"));
  CHECK(shown.prints("Stock: kept as x_stock"));
  CHECK(shown.says("Nothing was written"));
  CHECK_FALSE(shop.has("steppers.csv"));
  const Outcome written = shop.run(import({"--family", "steppers", "--output", "steppers.csv", "--yes"}));
  CHECK(written.exit_code == 0);
  CHECK(written.prints("steppers.csv: 2 rows written."));
  CHECK(shop.entries() == 2);
  const std::string text = shop.read("steppers.csv");
  CHECK(text.find("ACME,007,24.33,EUR,") != std::string::npos);
  CHECK(shop.run({"catalogue", "lint", "steppers.csv"}).exit_code == 0);
  CHECK(shop.run({"catalogue", "show", "007", "--catalogue", "steppers.csv"}).prints("1.26"));
}

TEST_CASE("A mapping is saved, edited and replayed for the next price list") {
  const Workshop shop;
  shop.write("prices.csv", without_unit);
  const Outcome assumed =
      shop.run(import({"--family", "steppers", "--output", "steppers.csv", "--yes", "--save-mapping", "m.toml"}));
  CHECK(assumed.exit_code == 2);
  CHECK(assumed.says("prices.csv:1:32: error: nothing says the unit of holding_torque"));
  CHECK(assumed.says("say --unit holding_torque=N.m, if that is its unit"));
  CHECK_FALSE(shop.has("steppers.csv"));
  CHECK_FALSE(shop.has("m.toml"));  // the import failed as a whole
  CHECK(assumed.says("m.toml was not written either; without --output it is, to be edited"));
  CHECK(shop.run(import({"--family", "steppers", "--save-mapping", "m.toml"})).exit_code == 1);
  CHECK(shop.read("m.toml").find("# unit = \"N.m\"? nothing says it") != std::string::npos);
  const Outcome open = shop.run(import({"--mapping", "m.toml", "--output", "steppers.csv"}));
  CHECK(open.exit_code == 2);
  CHECK(open.says("m.toml:"));
  CHECK(
      shop.run(import({"--mapping", "m.toml", "--unit", "holding_torque=N.m", "--output", "steppers.csv"})).exit_code ==
      0);
  CHECK(shop.run(import({"--family",
                         "steppers",
                         "--unit",
                         "holding_torque=N.m",
                         "--save-mapping",
                         "m.toml",
                         "--force",
                         "--yes",
                         "--output",
                         "steppers.csv"}))
            .exit_code == 0);
  shop.write("prices.csv", "Price (EUR),Brand,Part No,Step angle (deg),Torque,Current (A)\n26,ACME,007,1.8,1.26,2.8\n");
  CHECK(shop.run(import({"--mapping", "m.toml", "--output", "steppers.csv", "--force"})).exit_code == 0);
  CHECK(shop.read("steppers.csv").find("ACME,007,26,EUR") != std::string::npos);
}

TEST_CASE("Nothing is overwritten without force, and nothing is written through a link") {
  const Workshop shop;
  shop.write("prices.csv", table);
  shop.write("mine.csv", "mine");
  const std::vector<std::string> words{"--family", "steppers", "--yes", "--output"};
  const auto to = [&](const std::string& file, bool force) {
    std::vector<std::string> all = words;
    all.push_back(file);
    if (force) all.emplace_back("--force");
    return shop.run(import(all));
  };
  const Outcome there = to("mine.csv", false);
  CHECK(there.exit_code == 2);
  CHECK(there.says("mine.csv: there is such a file already"));
  REQUIRE(symlink("mine.csv", shop.path("link.csv").c_str()) == 0);
  for (const bool force : {false, true}) {
    const Outcome link = to("link.csv", force);
    CHECK(link.exit_code == 2);
    CHECK(link.says("link.csv: is a symbolic link and is not written through"));
  }
  CHECK(to("prices.csv", true).says("prices.csv: cannot be written: it is read too"));
  CHECK(to("nowhere/a.csv", false).says("there is no folder 'nowhere'"));
  CHECK(shop.read("mine.csv") == "mine");
  CHECK(shop.read("prices.csv") == table);
  CHECK(shop.entries() == 3);
  CHECK(to("mine.csv", true).exit_code == 0);
  CHECK(shop.read("mine.csv").rfind("# Imported from prices.csv.", 0) == 0);
}

TEST_CASE("A failed import leaves no file behind") {
  const Workshop shop;
  shop.write("prices.csv", std::string(table) + "ACME,009,1.8,126000,2.8 A,1,20,1\n");
  const Outcome wrong =
      shop.run(import({"--family", "steppers", "--yes", "--output", "steppers.csv", "--save-mapping", "m.toml"}));
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.says("m.toml was not written either"));
  CHECK(shop.entries() == 1);
}

TEST_CASE("An error of lint leaves the file as it was") {
  const Workshop shop;
  shop.write("prices.csv", std::string(table) + "ACME,009,1.8,126000,2.8 A,1,20,1\n");
  shop.write("mine.csv", "mine");
  const Outcome wrong = shop.run(import({"--family", "steppers", "--yes", "--force", "--output", "mine.csv"}));
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.says("prices.csv:4:14: error: 009: holding_torque 1260 N.m"));
  CHECK(shop.read("mine.csv") == "mine");
  CHECK(shop.entries() == 2);
}

TEST_CASE("Output and mapping are not one file, however it is spelt") {
  const Workshop shop;
  shop.write("prices.csv", table);
  for (const char* other : {"same.csv", "./same.csv", "../same.csv"}) {
    INFO(other);
    const Outcome outcome =
        shop.run(import({"--family", "steppers", "--yes", "--output", "same.csv", "--save-mapping", other}));
    CHECK(outcome.says("--output and --save-mapping cannot be one file") == (std::string(other) != "../same.csv"));
    if (std::string(other) != "../same.csv") CHECK_FALSE(shop.has("same.csv"));
  }
}

TEST_CASE("Options of an import that make no sense are pointed at") {
  const Workshop shop;
  shop.write("prices.csv", table);
  CHECK(shop.run(import({})).says("which parts are these?"));
  CHECK(shop.run(import({"--family", "steper"})).says("command line:1:10: error: there is no part family 'steper'"));
  CHECK(shop.run(import({"--family", "steppers", "--unit", "mass=mm"})).says("command line:1:8: error: mass: 'mm'"));
  CHECK(shop.run(import({"--family", "steppers", "--constant", "masse=1 kg"})).says("did you mean 'mass'?"));
  CHECK(shop.run(import({"--family", "steppers", "--constant", "mass"})).says("a column, '=' and a value are wanted"));
  CHECK(shop.run(import({"--family", "steppers", "--constant", "mass=1 kg", "--constant", "mass=2 kg"}))
            .says("command line:1:12: error: mass is named twice"));
  CHECK(shop.run({"catalogue", "import", "nothing.csv", "--family", "steppers"}).says("cannot be opened"));
  CHECK(shop.run({"catalogue", "import", ".", "--family", "steppers"}).exit_code == 2);
}

TEST_CASE("An import tells programs what it found and wrote") {
  const Workshop shop;
  shop.write("prices.csv", table);
  const Outcome shown = shop.run(import({"--family", "steppers", "--json", "-"}));
  CHECK(shown.exit_code == 1);
  const auto proposed = nlohmann::json::parse(shown.out);
  CHECK(proposed.at("command") == "catalogue import");
  CHECK(proposed.at("family") == "steppers");
  CHECK(proposed.at("rows") == 2);
  CHECK(proposed.at("written").is_null());
  const auto& torque = proposed.at("columns").at(3);
  CHECK(torque.at("header") == "Torque (N.cm)");
  CHECK(torque.at("column") == "holding_torque");
  CHECK(torque.at("unit") == "N.cm");
  CHECK(torque.at("unit_origin") == "header");
  CHECK(torque.at("decimal") == "point");
  CHECK(torque.at("confidence").get<double>() > 0.5);
  const auto& kept = proposed.at("columns").at(7);
  CHECK(kept.at("column").is_null());
  CHECK(kept.at("kept_as") == "x_stock");
  const Outcome written =
      shop.run(import({"--family", "steppers", "--output", "steppers.csv", "--yes", "--json", "result.json"}));
  CHECK(written.exit_code == 0);
  CHECK(written.prints("2 rows written"));
  const auto json = nlohmann::json::parse(shop.read("result.json"));
  CHECK(json.at("written") == "steppers.csv");
  CHECK(json.at("rows_written") == 2);
  CHECK(json.at("errors") == 0);
  shop.write("prices.csv", std::string(table) + "ACME,009,1.8,126000,2.8 A,1,20,1\n");
  const Outcome wrong = shop.run(
      import({"--family", "steppers", "--output", "steppers.csv", "--yes", "--force", "--json", "result.json"}));
  CHECK(wrong.exit_code == 2);
  const auto failed = nlohmann::json::parse(shop.read("result.json"));
  CHECK(failed.at("written").is_null());
  CHECK(failed.at("errors").get<int>() > 0);
  CHECK(failed.at("findings").at(0).at("file") == "prices.csv");
  // What is read is never written over, and no two outputs are one file.
  const std::string before = shop.read("prices.csv");
  CHECK(shop.run(import({"--family", "steppers", "--json", "prices.csv", "--force"})).exit_code == 2);
  CHECK(shop.read("prices.csv") == before);
  CHECK(shop.run(import({"--family", "steppers", "--output", "a.csv", "--yes", "--json", "a.csv"}))
            .says("--json cannot be one file with --output or --save-mapping"));
  CHECK_FALSE(shop.has("a.csv"));
}

}  // namespace

TEST_CASE("An import says which units change nothing, and writes nothing that no catalogue would be read from") {
  const Workshop shop;
  shop.write("list.csv",
             "Part number;Holding torque (Ncm);Rated current (A);Step angle (deg);Price (EUR)\nA1;44;1.7;1.8;12.5\n");
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{
        "catalogue", "import", "list.csv", "--family", "steppers", "--constant", "manufacturer=X", "--yes"};
    words.insert(words.end(), more.begin(), more.end());
    return shop.run(words);
  };
  const Outcome idle = with({"--output", "a.csv", "--unit", "mass=kg"});
  CHECK(idle.exit_code == 0);
  CHECK(idle.says("command line:1:8: warning: no column of the table is read as mass"));
  CHECK(idle.prints("1 row of stepper motors"));
  CHECK(idle.prints("a.csv: 1 row written."));
  CHECK(with({"--output", "b.csv", "--unit", "holding_torque=N.cm"}).err.empty());
  for (const char* name : {"-", "a.txt", "motors"}) {
    const Outcome refused = with({"--output", name});
    CHECK(refused.exit_code == 2);
    CHECK(refused.says("a catalogue file ends in .csv"));
    CHECK_FALSE(std::filesystem::exists(shop.path(name)));
  }
}

TEST_CASE("A catalogue that holds nothing, or has no name, is told of by lint too") {
  const Workshop shop;
  std::filesystem::create_directories(shop.path("empty/steppers"));
  const Outcome lint = shop.run({"catalogue", "lint", "empty"});
  CHECK(lint.exit_code == 2);
  CHECK(lint.prints("error: the catalogue 'empty' is empty: it holds no CSV file"));
  shop.write("mine/stock.csv", "part_number,owned\n17HS4401S,2\n");
  CHECK(shop.run({"catalogue", "lint", "mine"}).exit_code == 0);
  const Outcome nameless = shop.run({"catalogue", "list", "--catalogue", ""});
  CHECK(nameless.exit_code == 2);
  CHECK(nameless.says("--catalogue: the name is empty"));
}

TEST_CASE("A part is shown by the name that lists and differences give it") {
  const Workshop shop;
  const std::string head =
      "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency\n";
  shop.write("mine/steppers/m.csv", head + "Acme & Sons,M 1,1.8,1.26,2,10,USD\nOther,M 1,1.8,1.26,2,11,USD\n");
  const Outcome shown = shop.run({"catalogue", "show", "Acme & Sons M 1", "--catalogue", "mine"});
  CHECK(shown.exit_code == 0);
  CHECK(shown.prints("mine/steppers/m.csv:2"));
  CHECK_FALSE(shown.prints("m.csv:3"));
  CHECK(shop.run({"catalogue", "show", "M 1", "--manufacturer", "Other", "--catalogue", "mine"}).exit_code == 0);
  CHECK(shop.run({"catalogue", "show", "Acme & Sons M 2", "--catalogue", "mine"})
            .says("did you mean 'Acme & Sons M 1'?"));
}

TEST_CASE("A catalogue file may end in capitals") {
  const Workshop shop;
  const std::string parts =
      "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency\n"
      "Acme,M1,1.8,1.26,2,10,USD\n";
  shop.write("mine/steppers/OLD.CSV", parts);
  const Outcome list = shop.run({"catalogue", "show", "M1", "--catalogue", "mine"});
  CHECK(list.exit_code == 0);
  CHECK(list.prints("OLD.CSV"));
}

}  // namespace millwright::app::import_test
