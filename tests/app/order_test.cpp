// SPDX-License-Identifier: Apache-2.0
// --order of the program.
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/program.h"
#include "catch.h"
#include "sanitized.h"
#include "shipped_machines.h"

namespace millwright::app::order_test {
namespace {

using Json = nlohmann::json;

/// Cells of the lines of a CSV file; commas in quotes do not separate.
std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) cells.emplace_back();
      if (c != '"' && (c != ',' || quoted)) cells.back() += c;
    }
    rows.push_back(cells);
  }
  return rows;
}

const std::string problems = MILLWRIGHT_SOURCE_DIR "/problems/";

TEST_CASE("The lines of an order add up to the cost of the build, of every shipped machine") {
  std::size_t number = 0;
  for (const char* name : millwright::shipped_machines) {
    if (millwright::sanitized && number++ % 3 > 0) continue;
    const Workshop shop;
    const Outcome outcome =
        shop.run({"check", problems + name + ".toml", problems + name + "-bom.csv", "--json", "-", "--order", "o.csv"});
    REQUIRE(outcome.exit_code <= 1);
    const Json json = Json::parse(outcome.out);
    const double cost = json["totals"]["cost"]["value"];
    const auto rows = rows_of(shop.read("o.csv"));
    double sum = 0.0;
    INFO(name);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      REQUIRE(rows[i].size() == rows[0].size());
      if (rows[i][0].empty()) continue;
      CHECK(std::stod(rows[i][1]) * std::stod(rows[i][7]) == Approx(std::stod(rows[i][11])).epsilon(1e-6));
      sum += std::stod(rows[i][11]);
    }
    CHECK(sum == Approx(cost).epsilon(1e-12).margin(1e-7));
    CHECK(std::stod(rows.back()[11]) == Approx(cost).epsilon(1e-12).margin(1e-8));
  }
}

TEST_CASE("An order of the sander's bill of materials: by hand from bill and catalogues") {
  const Workshop shop;
  REQUIRE(shop.run({"check", problems + "sander.toml", problems + "sander-bom.csv", "--order", "o.csv"}).exit_code ==
          1);
  const auto find = [](const std::vector<std::vector<std::string>>& rows, std::size_t column, const std::string& text) {
    std::vector<std::vector<std::string>> found;
    for (const auto& row : rows)
      if (row[column] == text) found.push_back(row);
    return found;
  };
  const auto rows = rows_of(shop.read("o.csv"));
  // Shafts of stroke + 2 x 10 mm + nut 85 mm + ends 80 mm = 885 mm and 435 mm, at 58 USD/m; both nuts at 29 USD.
  const auto screws = find(rows, 5, "25x10 (paper)");
  REQUIRE(screws.size() == 2);
  CHECK(screws[0][3] == "ball screw nut");
  for (const auto& screw : screws) CHECK(screw[13] == "known only from a paper");
  CHECK(std::stod(screws[0][11]) == Approx(58.0));
  CHECK(screws[1][2] == "m");
  CHECK(std::stod(screws[1][1]) == Approx(1.32));
  CHECK(std::stod(screws[1][11]) == Approx(76.56));
  // Three drivers at 9 USD, one an axis.
  CHECK(find(rows, 3, "stepper driver").front()[1] == "3");
  CHECK(find(rows, 3, "stepper driver").front()[12] == "x.driver, y.driver, z.driver");
  CHECK(find(rows, 3, "stepper driver").front()[13].empty());
  const auto cuts = rows_of(shop.read("o-cutting.csv"));
  const auto shafts = find(cuts, 2, "25x10 (paper)");
  REQUIRE(shafts.size() == 3);
  CHECK(shafts[0][7] == "885");
  CHECK(shafts[1][7] == "435");
  CHECK(shafts[2][8] == "1320");
}

TEST_CASE("A portal is cut into its beam and two columns") {
  const Workshop shop;
  (void)shop.run({"check", problems + "gantry.toml", problems + "gantry-bom.csv", "--order", "o.csv"});
  std::vector<std::string> lengths;
  for (const auto& row : rows_of(shop.read("o-cutting.csv")))
    if (row[4] == "portal") lengths.push_back(row[6] + " x " + row[7]);
  // problems/gantry.toml: length 1600 mm, height 350 mm
  CHECK(lengths == std::vector<std::string>{"1 x 1600", "2 x 350"});
}

TEST_CASE("solve writes an order as workbook, and none of a build that does not exist") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  CHECK(shop.run({"solve", "m.toml", "--order", "o.xlsx", "--bom", "b.csv"}).exit_code == 0);
  CHECK(shop.read("o.xlsx").rfind("PK", 0) == 0);
  CHECK(shop.entries() == 3);
  CHECK(shop.run({"check", "m.toml", "b.csv", "--order", "O.XLSX"}).exit_code == 0);
  CHECK(shop.read("O.XLSX").rfind("PK", 0) == 0);
  shop.write("heavy.toml", one_slide_with("time = \"20 s\"", "time = \"0.7 s\""));
  CHECK(shop.run({"solve", "heavy.toml", "--order", "h.xlsx"}).exit_code == 1);
  CHECK_FALSE(shop.has("h.xlsx"));
}

TEST_CASE("Option --order takes files it can write, of kinds it knows, and spares what is read") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  shop.write("b-cutting.csv/file", "");
  const Outcome kind = shop.run({"solve", "m.toml", "--order", "o.ods"});
  CHECK(kind.exit_code == 2);
  CHECK(kind.says("--order: o.ods is neither a .csv nor an .xlsx file"));
  CHECK(shop.run({"solve", "m.toml", "--order", "none/o.xlsx"}).says("there is no folder 'none'"));
  CHECK(shop.run({"solve", "m.toml", "--order", "b.csv"}).says("b-cutting.csv: cannot be written: it is a folder"));
  CHECK(shop.run({"solve", "m.toml", "--order", "c.csv", "--bom", "c.csv"}).says("two outputs cannot go to one file"));
  const Outcome over = shop.run({"solve", "m.toml", "--bom", "m.toml"});
  CHECK(over.exit_code == 2);
  CHECK(over.says("m.toml: cannot be written: it is read too"));
  CHECK(shop.read("m.toml") == one_slide);
}

}  // namespace
}  // namespace millwright::app::order_test
