// SPDX-License-Identifier: Apache-2.0
// What may become of a file that is there already: results are renewed, everything else gives way only to --force, and
// what is read or stands behind a link never does.
#include <unistd.h>

#include <filesystem>

#include "app/program.h"
#include "catch.h"
#include "sanitized.h"

namespace millwright::app::output_test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const Words calc{"calc", "actuation.power", "torque=2 N.m", "angular_speed=30 rad/s"};

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The output named by `option` of a command, over what is there.
struct Case {
  Words command;
  std::string option, file;
  bool renewed;  ///< without --force
};

std::vector<Case> cases() {
  const Words solve{"solve", "m.toml", "--quiet"};
  const Words sweep{"solve", "m.toml", "--quiet", "--set", "axis.x.moves[0].time=20:21:2 s"};
  return {{solve, "--json", "r.json", true},
          {solve, "--report", "r.html", true},
          {solve, "--write-lock", "m.lock", true},
          {solve, "--bom", "b.csv", false},
          {solve, "--order", "o.csv", false},
          {solve, "--order", "o.xlsx", false},
          {sweep, "--csv", "s.csv", false},
          {sweep, "--json", "s.json", true},
          {{"solve", "m.toml", "--quiet", "--set", "axis.x.stroke=210 mm"}, "--json", "r.json", true},
          {{"explain", "m.toml"}, "--json", "e.json", true},
          {{"catalogue", "list"}, "--json", "l.json", true},
          {{"formulas"}, "--json", "f.json", true}};
}

}  // namespace

TEST_CASE("What the program made and nobody edits is made anew, all else gives way to force alone") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  std::size_t number = 0;
  for (const Case& each : cases()) {
    if (sanitized && number++ % 4 != 0) continue;
    INFO(each.command.front() << " " << each.option << " " << each.file);
    const Words words = with(each.command, {each.option, each.file});
    if (!shop.has(each.file)) CHECK(shop.run(words).exit_code == 0);
    const std::string made = shop.read(each.file);
    CHECK_FALSE(made.empty());
    const Outcome again = shop.run(words);
    CHECK(again.exit_code == (each.renewed ? 0 : 2));
    if (!each.renewed) {
      CHECK(again.says(each.file + ": there is such a file already\n"));
      CHECK(again.out.empty());
      CHECK(shop.read(each.file) == made);
    }
    shop.write(each.file, "mine");
    const Outcome foreign = shop.run(words);
    CHECK(foreign.exit_code == 2);
    CHECK(foreign.says(each.file + ": there is such a file already"));
    CHECK(foreign.says("say --force to overwrite it"));
    CHECK(foreign.out.empty());
    CHECK(shop.read(each.file) == "mine");
    CHECK(shop.run(with(words, {"--force"})).exit_code == 0);
    CHECK(shop.read(each.file).size() > 10);
    shop.write(each.file, "");  // nothing is lost
    fs::remove(shop.path("o-cutting.csv"));
    CHECK(shop.run(words).exit_code == 0);
  }
}

TEST_CASE("JSON that only looks like a result, and a page of others, are not overwritten") {
  const Workshop shop;
  for (const char* json : {"{}", "{\n  \"schema\": \"mine/1\"\n}", "{\"title\": \"millwright.result/1\"}", "PK"}) {
    shop.write("r.json", json);
    const Outcome outcome = shop.run(with(calc, {"--json", "r.json"}));
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.says("r.json: there is such a file already that is no result of millwright"));
    CHECK(shop.read("r.json") == json);
  }
  shop.write("m.toml", one_slide);
  const std::string page = "<!DOCTYPE html>\n<html><head><meta name=\"generator\" content=\"Hugo\"></head></html>\n";
  shop.write("r.html", page);
  CHECK(shop.run({"solve", "m.toml", "--report", "r.html"}).says("that is no page of millwright"));
  CHECK(shop.read("r.html") == page);
}

TEST_CASE("Links, folders and devices are never written, forced or not") {
  const Workshop shop;
  shop.write("there.json", "mine");
  shop.write("folder/file", "mine");
  REQUIRE(symlink("there.json", shop.path("link.json").c_str()) == 0);
  REQUIRE(symlink("nowhere.json", shop.path("dangling.json").c_str()) == 0);
  REQUIRE(symlink("link.json", shop.path("loop.json").c_str()) == 0);
  for (const bool force : {false, true}) {
    const auto complaint = [&](const std::string& file) {
      const Outcome outcome = shop.run(with(calc, force ? Words{"--force", "--json", file} : Words{"--json", file}));
      CHECK(outcome.exit_code == 2);
      CHECK(outcome.out.empty());
      return outcome.err;
    };
    for (const char* link : {"link.json", "dangling.json", "loop.json"})
      CHECK(complaint(link).find("is a symbolic link and is not written through") != std::string::npos);
    CHECK(complaint("folder").find("it is a folder") != std::string::npos);
    CHECK(complaint("folder/").find("cannot be written") != std::string::npos);
    CHECK(complaint("/dev/full").find("it is a device, not a file") != std::string::npos);
    CHECK(complaint("there.json/r").find("there is no folder") != std::string::npos);
    CHECK(complaint(std::string(300, 'x')).find("cannot be written: File name too long") != std::string::npos);
  }
  CHECK(shop.read("there.json") == "mine");
  CHECK(fs::is_symlink(shop.path("link.json")));
  CHECK_FALSE(shop.has("nowhere.json"));
  CHECK(shop.entries() == 5);
}

TEST_CASE("Nothing that is read is written over, forced or not, however it is spelt") {
  const Workshop shop;
  const std::string motors =
      "manufacturer,part_number,step_angle [deg],holding_torque [N.m],rated_current [A],price,currency,source,"
      "confidence\nMine,M1,1.8,1,2,10,USD,own,high\n";
  const std::string problem = one_slide_with("title =", "catalogues = [\"parts\"]\ntitle =");
  shop.write("m.toml", problem);
  shop.write("parts/steppers/mine.csv", motors);
  fs::create_hard_link(shop.path("m.toml"), shop.path("same.toml"));
  fs::create_directory_symlink("parts", shop.path("other"));
  for (const char* file :
       {"m.toml", "./m.toml", "parts/../m.toml", "same.toml", "parts/steppers/mine.csv", "other/steppers/mine.csv"})
    for (const char* option : {"--json", "--bom", "--report", "--write-lock"}) {
      if (sanitized && std::string(option) != "--json" && std::string(file) != "same.toml") continue;
      INFO(option << " " << file);
      const Outcome outcome = shop.run({"solve", "m.toml", option, file, "--force"});
      CHECK(outcome.exit_code == 2);
      CHECK(outcome.says(std::string(file) + ": cannot be written: it is read too"));
      CHECK(outcome.out.empty());
    }
  CHECK(shop.read("m.toml") == problem);
  CHECK(shop.read("parts/steppers/mine.csv") == motors);
  const std::string claims = MILLWRIGHT_SOURCE_DIR "/problems/papers/mini-mill.toml";
  fs::copy_file(claims, shop.path("claims.toml"));
  CHECK(shop.run({"audit", "claims.toml", "--json", "claims.toml", "--force"}).says("it is read too"));
  CHECK(
      shop.run({"catalogue", "lint", "parts", "--json", "parts/steppers/mine.csv", "--force"}).says("it is read too"));
}

TEST_CASE("Two outputs do not go to one file, however it is spelt") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  shop.write("folder/file", "");
  for (const char* other : {"r", "./r", "folder/../r"})
    CHECK(shop.run({"solve", "m.toml", "--json", "r", "--report", other}).says("two outputs cannot go to one file"));
  CHECK(shop.run({"solve", "m.toml", "--order", "o.csv", "--bom", "./o-cutting.csv"})
            .says("two outputs cannot go to one file"));
  CHECK(shop.entries() == 2);
}

}  // namespace millwright::app::output_test
