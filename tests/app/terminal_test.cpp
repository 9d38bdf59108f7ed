// SPDX-License-Identifier: Apache-2.0
// What the program writes fits the terminal: 80 columns where nothing says that there are more.
#include <fcntl.h>
#include <pty.h>
#include <sys/ioctl.h>

#include <array>
#include <set>
#include <sstream>

#include "app/program.h"
#include "catch.h"
#include "sanitized.h"
#include "shipped_machines.h"

namespace millwright::app::terminal_test {
namespace {

const std::string problems = MILLWRIGHT_SOURCE_DIR "/problems/";

/// Characters of a line, which is UTF-8, less escape sequences and marks that take no room.
std::size_t columns_of(const std::string& line) {
  std::size_t columns = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto byte = static_cast<unsigned char>(line[i]);
    if (byte == 0x1B)
      i = std::min(line.find('m', i), line.size());
    else if (byte == 0xCC)
      ++i;
    else if ((byte & 0xC0U) != 0x80)
      ++columns;
  }
  return columns;
}

/// The first line that is longer; empty if there is none.
std::string longer_than(std::size_t width, const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (columns_of(line) > width) return line;
  return {};
}

void fits(const std::vector<std::string>& arguments) {
  const Workshop shop;
  const Outcome outcome = shop.run(arguments);
  std::string words;
  for (const std::string& each : arguments) words += each + " ";
  INFO(words);
  CHECK_FALSE(outcome.out.empty());
  CHECK(longer_than(80, outcome.out).empty());
}

TEST_CASE("Checks of every shipped machine fit 80 columns") {
  std::size_t number = 0;
  for (const char* name : millwright::shipped_machines) {
    if (sanitized && number++ % 3 > 0) continue;
    if (!sanitized) fits({"check", problems + name + ".toml", problems + name + "-bom.csv"});
    fits({"check", problems + name + ".toml", problems + name + "-bom.csv", "--full"});
  }
}

TEST_CASE("Answers, fronts, runners-up and refusals fit 80 columns") {
  fits({"solve", problems + "lifter.toml", "--alternatives", "4"});
  fits({"pareto", problems + "lifter.toml"});
  fits({"solve", problems + "lifter.toml", "--limit", "cost=10 USD"});
  fits({"explain", problems + "lifter.toml", "--limit", "cost=10 USD"});
  const std::string bill = problems + "lifter-bom.csv";
  fits({"compare", bill, bill, "--problem", problems + "lifter.toml"});
  if (sanitized) return;
  fits({"solve", problems + "rotary-table.toml", "--limit", "cost=400 USD", "--without", "A4988"});
  fits({"solve", problems + "lifter.toml", "--set", "axis.z.structure_mass=5:15:3 kg", "--minimise", "cost + 25*mass"});
}

TEST_CASE("Audits with their calculations fit 80 columns") {
  for (const char* name : {"sander", "mini-mill", "torch-table", "fdm-printer"})
    fits({"audit", problems + "papers/" + name + ".toml", "--derive"});
}

TEST_CASE("Formulas, catalogues and help fit 80 columns") {
  fits({"formulas"});
  fits({"calc", "power_screw.raising_torque", "force=6.4 kN", "mean_diameter=30 mm", "lead=8 mm", "friction=0.08"});
  fits({"catalogue", "list"});
  std::size_t number = 0;
  std::set<std::string> families;
  for (const auto& entry : std::filesystem::directory_iterator(MILLWRIGHT_SOURCE_DIR "/catalogues"))
    if (entry.is_directory()) families.insert(entry.path().filename().string());
  for (const std::string& family : families)
    if (!sanitized || number++ % 4 == 0) fits({"catalogue", "list", family});
  fits({"catalogue", "list", "--gaps"});
  fits({"catalogue", "show", "DFU2505-4"});
  fits({"catalogue", "show", "23HS22-2804S"});
  fits({"--help"});
  for (const char* verb : {"solve", "pareto", "check", "explain", "compare", "audit", "calc", "formulas", "catalogue"})
    fits({verb, "--help"});
  for (const char* verb : {"list", "show", "lint", "import"}) fits({"catalogue", verb, "--help"});
}

TEST_CASE("Option --quiet leaves the result") {
  const Workshop shop;
  shop.write("m.toml", one_slide);
  const Outcome full = shop.run({"solve", "m.toml", "--bom", "b.csv"});
  const Outcome quiet = shop.run({"solve", "m.toml", "--quiet"});
  CHECK(quiet.exit_code == 0);
  CHECK(quiet.prints("Cheapest compliant build"));
  CHECK(quiet.prints("Total: "));
  CHECK_FALSE(quiet.prints("Checks of axis"));
  CHECK_FALSE(quiet.prints("Certificate"));
  CHECK(full.out.rfind(quiet.out, 0) == 0);  // nothing else, nothing in between
  const Outcome check = shop.run({"check", "m.toml", "b.csv", "--quiet"});
  CHECK(check.prints("It satisfies every check."));
  CHECK_FALSE(check.prints("Parts"));
  const Outcome calc = shop.run({"calc",
                                 "power_screw.raising_torque",
                                 "force=6.4 kN",
                                 "mean_diameter=30 mm",
                                 "lead=8 mm",
                                 "friction=0.08",
                                 "-q"});
  CHECK(calc.out == "15.93695474 N.m\n");
  CHECK(shop.run({"formulas", "raising", "-q"}).prints("power_screw.raising_torque\n"));
  CHECK(shop.run({"audit", problems + "papers/mini-mill.toml", "-q"}).prints("63 results: "));
}

// --- on a terminal
// ------------------------------------------------------------------------------------------------------

/// What the program writes to a terminal of so many columns.
std::string on_terminal(unsigned short columns, const std::vector<std::string>& arguments, bool colour) {
  winsize size{};
  size.ws_row = 50;
  size.ws_col = columns;
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
  if (child < 0) throw std::runtime_error("no terminal");
  if (child == 0) {
    setenv("TERM", "xterm", 1);
    if (colour)
      unsetenv("NO_COLOR");
    else
      setenv("NO_COLOR", "1", 1);
    std::vector<char*> argv{const_cast<char*>(MILLWRIGHT_PROGRAM)};
    for (const std::string& each : arguments) argv.push_back(const_cast<char*>(each.c_str()));
    argv.push_back(nullptr);
    execv(MILLWRIGHT_PROGRAM, argv.data());
    _exit(127);
  }
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t got = read(terminal, buffer.data(), buffer.size()); got > 0;
       got = read(terminal, buffer.data(), buffer.size()))
    text.append(buffer.data(), static_cast<std::size_t>(got));
  close(terminal);
  int status = 0;
  waitpid(child, &status, 0);
  std::erase(text, '\r');
  return text;
}

TEST_CASE("Colour on a terminal only, and not where NO_COLOR forbids it") {
  const Workshop shop;
  const std::vector<std::string> check{"check", problems + "sander.toml", problems + "sander-bom.csv"};
  CHECK(on_terminal(80, check, true).find("\x1B[1;31m") != std::string::npos);
  CHECK(on_terminal(80, check, false).find("\x1B[") == std::string::npos);
  CHECK(shop.run(check).out.find('\x1B') == std::string::npos);
}

TEST_CASE("A terminal that is wider or narrower is made use of") {
  const Workshop shop;
  const std::vector<std::string> check{"check", problems + "sander.toml", problems + "sander-bom.csv"};
  CHECK(on_terminal(80, check, false) == shop.run(check).out);
  const std::string wide = on_terminal(150, check, false);
  CHECK(longer_than(150, wide).empty());
  CHECK_FALSE(longer_than(80, wide).empty());
  CHECK(longer_than(70, on_terminal(70, check, false)).empty());
}

TEST_CASE("Help names what is given, without the parser's own words") {
  const Workshop shop;
  for (const char* verb : {"solve", "pareto", "check", "explain", "compare", "audit", "new"}) {
    const Outcome help = shop.run({verb, "--help"});
    CAPTURE(verb, help.out);
    for (const char* word : {"REQUIRED", " TEXT", "UINT", "FLOAT", "{en"}) {
      CAPTURE(word);
      CHECK_FALSE(help.prints(word));
    }
  }
}

}  // namespace
}  // namespace millwright::app::terminal_test
