// SPDX-License-Identifier: Apache-2.0
// Files that were damaged at random: never a crash, and always either something that was read or a reason why not.
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include "machine/bill_of_materials.h"
#include "problem_text.h"

namespace problem_mutation_test {

using namespace problem_text;

namespace {

std::string contents_of(const std::string& name) {
  std::ifstream file(std::string(MILLWRIGHT_SOURCE_DIR "/problems/") + name, std::ios::binary);
  std::ostringstream all;
  all << file.rdbuf();
  REQUIRE_FALSE(all.str().empty());
  return all.str();
}

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  /// One to four small accidents.
  std::string of(std::string text) {
    for (std::size_t i = 1 + below(4); i > 0 && !text.empty(); --i) accident(text);
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_() % limit); }

  void accident(std::string& text) {
    const std::size_t at = below(text.size());
    const std::size_t line = text.rfind('\n', at) == std::string::npos ? 0 : text.rfind('\n', at) + 1;
    const std::size_t next = std::min(text.find('\n', at), text.size() - 1) + 1;
    static const std::vector<std::string> words{"\"",
                                                "[",
                                                "]",
                                                "{",
                                                "}",
                                                "=",
                                                ",",
                                                ".",
                                                "-",
                                                "0",
                                                "9e99",
                                                " kg",
                                                "nan",
                                                "\xC3",
                                                "\xEF\xBB\xBF",
                                                std::string(1, '\0'),
                                                "\r",
                                                "[[axis]]\n",
                                                "name = \"x\"\n",
                                                "carries = [\"x\"]\n",
                                                "\"\"",
                                                "1e-320",
                                                "true",
                                                "ä"};
    switch (below(6)) {
      case 0:
        text.erase(at, 1 + below(3));
        break;
      case 1:
        text[at] = static_cast<char>(below(256));
        break;
      case 2:
        text.insert(at, words[below(words.size())]);
        break;
      case 3:
        text.erase(line, next - line);
        break;
      case 4:
        text.insert(line, text.substr(line, next - line));
        break;
      default:
        std::swap(text[at], text[below(text.size())]);
        break;
    }
  }

  std::mt19937 random_;
};

/// What was read can be reckoned with.
void check_sound(const machine::Problem& problem) {
  CHECK_FALSE(problem.axes.empty());
  CHECK(problem.order.size() == problem.axes.size());
  CHECK_FALSE(problem.supply_voltages.empty());
  for (const machine::Axis& axis : problem.axes) {
    CHECK_FALSE(axis.name.empty());
    CHECK(std::isfinite(axis.stroke));
    CHECK(axis.stroke > 0.0);
    CHECK(axis.structure_mass >= 0.0);
    CHECK(axis.acceleration_time.lower > 0.0);
    CHECK(axis.acceleration_time.upper >= axis.acceleration_time.lower);
    CHECK_FALSE(axis.moves.empty());
    for (const machine::Move& move : axis.moves) {
      CHECK((move.time || move.speed || move.profile));
      CHECK(move.distance <= axis.stroke * 1.000001);
    }
  }
}

}  // namespace

TEST_CASE("A damaged problem file is read or refused with a reason") {
  for (const char* name : {"sander.toml", "gantry.toml", "rotary-table.toml"}) {
    const std::string original = contents_of(name);
    int survivors = 0;
    for (unsigned seed = 0; seed < 500; ++seed) {
      const std::string damaged = Damage(seed).of(original);
      INFO(name << ", seed " << seed);
      const Outcome outcome = read(damaged);
      CHECK(outcome.problem.has_value() == !outcome.diagnostics.has_errors());
      for (const text::Diagnostic& said : outcome.diagnostics.all()) {
        CHECK_FALSE(said.message.empty());
        CHECK(said.where.text != nullptr);
      }
      CHECK((text::format(outcome.diagnostics).empty() == (outcome.diagnostics.count() == 0)));
      if (outcome.problem) check_sound(*outcome.problem);
      survivors += outcome.problem ? 1 : 0;
    }
    // Much of the file is comments, so that a good part must survive, but not most of it.
    INFO(name);
    CHECK(survivors > 25);
    CHECK(survivors < 475);
  }
}

TEST_CASE("A damaged bill of materials is read or refused with a reason") {
  const Outcome sander = read(contents_of("sander.toml"));
  REQUIRE(sander.problem);
  const std::string original = contents_of("sander-bom.csv");
  for (unsigned seed = 0; seed < 500; ++seed) {
    INFO("seed " << seed);
    text::Diagnostics diagnostics;
    const auto bom = machine::read_bill_of_materials(
        text::SourceText::from_string("bom.csv", Damage(seed).of(original)), *sander.problem, diagnostics);
    CHECK(bom.has_value() == !diagnostics.has_errors());
    (void)text::format(diagnostics);
    if (!bom) continue;
    for (const machine::BomLine& line : bom->lines) CHECK(line.is_dimension() == line.part_number.empty());
  }
}

TEST_CASE("A problem cut off anywhere is read or refused with a reason") {
  for (std::size_t length = 0; length < sound.size(); length += 3) {
    const Outcome outcome = read(sound.substr(0, length));
    CHECK(outcome.problem.has_value() == !outcome.diagnostics.has_errors());
  }
}

}  // namespace problem_mutation_test
