// SPDX-License-Identifier: Apache-2.0
// `millwright new`. That every optional line of a template can be used: machine/template_test.cpp.
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "catch.h"
#include "sanitized.h"

namespace millwright::app::new_test {
namespace {

const std::vector<std::string> names = {"mill", "printer", "router", "sander", "torch"};

TEST_CASE("Each template solves as it is") {
  std::size_t number = 0;
  for (const std::string& name : names) {
    if (millwright::sanitized && number++ % 2 > 0) continue;
    const Workshop shop;
    const Outcome written = shop.run({"new", "--template", name, "m.toml"});
    CAPTURE(name, written.err);
    CHECK(written.exit_code == 0);
    CHECK(written.prints("'millwright solve m.toml'"));
    CHECK(shop.entries() == 1);
    std::ifstream source(MILLWRIGHT_SOURCE_DIR "/src/app/templates/" + name + ".toml", std::ios::binary);
    CHECK(shop.read("m.toml") == std::string(std::istreambuf_iterator<char>(source), {}));
    const Outcome printed = shop.run({"new", "--template", name, "-"});
    CHECK(printed.exit_code == 0);
    CHECK(printed.out == shop.read("m.toml"));
    CHECK(shop.entries() == 1);
    const Outcome solved = shop.run({"solve", "m.toml", "--json", "-"});
    CAPTURE(solved.err);
    CHECK(solved.exit_code == 0);
    CHECK(solved.err.empty());
    CHECK(nlohmann::json::parse(solved.out)["status"] == "optimal");
  }
}

TEST_CASE("A file that is there is only overwritten by force") {
  const Workshop shop;
  shop.write("m.toml", "mine");
  const Outcome refused = shop.run({"new", "--template", "mill", "m.toml"});
  CHECK(refused.exit_code == 2);
  CHECK(refused.says("m.toml: there is such a file already\n      hint: name another one, or say --force"));
  CHECK(refused.out.empty());
  CHECK(shop.read("m.toml") == "mine");
  CHECK(shop.run({"new", "--template", "mill", "m.toml", "--force"}).exit_code == 0);
  CHECK(shop.read("m.toml").rfind("# A bench-top mill", 0) == 0);
  CHECK(shop.entries() == 1);
}

TEST_CASE("A template or file that cannot be: exit code 2, a hint, and nothing is written") {
  const Workshop shop;
  const std::vector<std::pair<std::vector<std::string>, const char*>> cases = {
      {{"new", "m.toml"}, "hint: say --template mill; templates: mill, printer, router, sander, torch"},
      {{"new", "--template", "mil", "m.toml"}, "there is no template 'mil'\n      hint: did you mean 'mill'?"},
      {{"new", "--template", "lathe", "m.toml"}, "hint: templates: mill, printer, router, sander, torch"},
      {{"new", "--template", "mill"}, "FILE is required"},
      {{"new", "--template", "mill", "m.json"}, "read as JSON"},
      {{"new", "--template", "mill", "no/m.toml"}, "no/m.toml"},
      {{"new", "--template", "mill", "."}, "it is a folder"},
      {{"new", "--template", "mill", ""}, "no name of a file"},
  };
  for (const auto& [words, complaint] : cases) {
    const Outcome outcome = shop.run(words);
    CAPTURE(complaint, outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.says(complaint));
    CHECK(outcome.out.empty());
    CHECK(shop.entries() == 0);
  }
}

}  // namespace
}  // namespace millwright::app::new_test
