// SPDX-License-Identifier: Apache-2.0
#include "report/lock.h"

#include "catch.h"

namespace lock_test {

using namespace millwright;
using namespace millwright::report;

namespace {

Lock example() {
  Lock lock;
  lock.version = "1.2.3";
  lock.question = {"solve", {"axis.x.stroke='800 mm'", "a=\"b\\c\""}, {"cost=4 USD"}, {}, {"x.motor=M1"}, {"cost"}};
  lock.cost = "360.11 USD";
  lock.mass = "11.5 kg";
  lock.inputs = {{"problem", "m.toml", std::string(64, 'a')}, {"profile", "p.csv", std::string(64, 'b')}};
  lock.places = {"catalogues", "my \"parts\"\n\x7F"};
  lock.files = {{0, "steppers", "steppers/m.csv", 12, std::string(64, 'c')},
                {1, "belts", "b.csv", 1, std::string(64, 'd')}};
  lock.parts = {{"steppers",
                 "Acme",
                 "M1",
                 "Acme M1",
                 {"x.motor", "y.motor"},
                 "catalogues/steppers/m.csv",
                 {{"price", "9.62 USD"}, {"torque at 60 rpm", "1.2 N.m"}}}};
  return lock;
}

std::optional<Lock> read(const std::string& text, text::Diagnostics& diagnostics) {
  return read_lock(text::SourceText::from_string("a.lock", text), diagnostics);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("a lock is read back as it was written") {
  const Lock lock = example();
  text::Diagnostics diagnostics;
  const auto back = read(lock_toml(lock), diagnostics);
  INFO(text::format(diagnostics));
  REQUIRE(back);
  CHECK(diagnostics.count() == 0);
  CHECK(back->version == "1.2.3");
  CHECK(back->question.command == "solve");
  CHECK(back->question.settings == lock.question.settings);
  CHECK(back->question.limits == lock.question.limits);
  CHECK(back->question.without.empty());
  CHECK(back->question.fixed == lock.question.fixed);
  CHECK(back->question.objectives == lock.question.objectives);
  CHECK(back->cost == "360.11 USD");
  CHECK(back->mass == "11.5 kg");
  REQUIRE(back->inputs.size() == 2);
  CHECK(back->inputs[1].kind == "profile");
  CHECK(back->inputs[1].sha256 == std::string(64, 'b'));
  CHECK(back->places == lock.places);
  REQUIRE(back->files.size() == 2);
  CHECK(back->files[0].rows == 12);
  CHECK(back->files[1].layer == 1);
  CHECK(back->files[1].name == "b.csv");
  REQUIRE(back->parts.size() == 1);
  CHECK(back->parts[0].slots == lock.parts[0].slots);
  CHECK(back->parts[0].title == "Acme M1");
  REQUIRE(back->parts[0].figures.size() == 2);
  CHECK(back->parts[0].figures[1].name == "torque at 60 rpm");
  CHECK(back->parts[0].figures[1].value == "1.2 N.m");
  CHECK(back->parts[0].figures[0].where.line > 1);
}

TEST_CASE("a lock survives other line ends, but no other change") {
  const std::string text = lock_toml(example());
  text::Diagnostics diagnostics;
  std::string windows;
  for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(read(windows, diagnostics));
  CHECK(diagnostics.count() == 0);
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"9.62 USD", "9.52 USD"}, {"cccc", "cdcc"}, {"rows = 12", "rows = 13"}, {"1.2.3", "1.2.4"}}) {
    text::Diagnostics tampered;
    CHECK_FALSE(read(replaced(text, from, to), tampered));
    CHECK(tampered.error_count() == 1);
    CHECK(text::format(tampered).find("a.lock:4:8: error: this lock was changed after it was written") !=
          std::string::npos);
  }
}

TEST_CASE("everything that is wrong with a lock is told at its place, in one go") {
  std::string text = lock_toml(example());
  text = replaced(text, "sha256 = \"" + std::string(64, 'a'), "sha256 = \"" + std::string(63, 'a'));
  text = replaced(text, "kind = \"profile\"", "kind = \"motion\"");
  text = replaced(text, "layer = 1", "layer = 2");
  text = replaced(text, "rows = 12", "rows = -12");
  text = replaced(text, "family = \"steppers\"\n", "family = \"stepers\"\nfigure = 3\n");
  text = replaced(text, "\"9.62 USD\"", "9.62");
  text::Diagnostics diagnostics;
  CHECK_FALSE(read(text, diagnostics));
  const std::string told = text::format(diagnostics);
  INFO(told);
  CHECK(diagnostics.error_count() == 7);
  for (const char* what : {"sha256: not 64 hexadecimal digits",
                           "motion",
                           "layer: 2 of 2 places",
                           "rows: -12",
                           "stepers",
                           "figure",
                           "price"})
    CHECK(told.find(what) != std::string::npos);
  CHECK(told.find("seal") == std::string::npos);
}

TEST_CASE("what is no lock is refused") {
  for (const char* text : {"", "lock = 2\n", "lock = \"1\"\n", "title = 3\n", "not toml", "lock = 1\n[catalogues]\n"}) {
    text::Diagnostics diagnostics;
    CHECK_FALSE(read(text, diagnostics));
    CHECK(diagnostics.error_count() > 0);
  }
  text::Diagnostics diagnostics;
  CHECK_FALSE(read("lock = 2\n", diagnostics));
  CHECK(text::format(diagnostics).find("locks of format 2 are not known") != std::string::npos);
}

}  // namespace lock_test
