// SPDX-License-Identifier: Apache-2.0
#include "text/diagnostic.h"

#include <random>

#include "catch.h"
#include "text/utf8.h"

namespace diagnostic_test {

using namespace millwright::text;

namespace {
Diagnostic make(Severity severity, SourceSpan where, std::string message, std::string hint = {}) {
  Diagnostic result;
  result.severity = severity;
  result.where = std::move(where);
  result.message = std::move(message);
  result.hint = std::move(hint);
  return result;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}
}  // namespace

TEST_CASE("an error is printed as a compiler prints it") {
  const auto text = SourceText::from_string("steppers/x.csv", "part,torque\nA,1O.5\n");
  CHECK(format(make(Severity::error, {text, 2, 3, 4}, "not a number", "letter O where a zero was meant")) ==
        "steppers/x.csv:2:3: error: not a number\n"
        "    2 | A,1O.5\n"
        "      |   ^~~~ hint: letter O where a zero was meant\n");
}

TEST_CASE("the caret stands under its character after tabs and wide letters") {
  const auto text = SourceText::from_string("f", "\tµm = x\n日本x\n");
  CHECK(lines_of(format(make(Severity::warning, {text, 1, 7, 1}, "m"))) ==
        std::vector<std::string>{"f:1:7: warning: m", "    1 |     µm = x", "      |          ^"});
  CHECK(lines_of(format(make(Severity::note, {text, 2, 2, 2}, "m"))) ==
        std::vector<std::string>{"f:2:2: note: m", "    2 | 日本x", "      |   ^~~"});
}

TEST_CASE("messages and hints are folded to a width, lines of the source are not") {
  const std::string source =
      "   12 | voltage = [ \"24 V\", \"36 V\", \"48 V\" ] # of what is in the drawer now, and more";
  const std::string text =
      "problem.toml:12:1: error: the voltage of the supply is not one that the catalogue sells\n" + source + "\n" +
      "      | ^~~~~~~ hint: state voltages of power supplies that are in the catalogue, or add one\n"
      "1 error\n";
  CHECK(folded(text, 200) == text);
  CHECK(folded(text, 60) ==
        "problem.toml:12:1: error: the voltage of the supply is not\n"
        "    one that the catalogue sells\n" +
            source +
            "\n"
            "      | ^~~~~~~ hint: state voltages of power supplies that\n"
            "                are in the catalogue, or add one\n"
            "1 error\n");
  // Far to the right a hint goes on at the margin; a word that is too long stays whole.
  const std::string far =
      "      |" + std::string(40, ' ') + "^ hint: add an_uncommonly_long_name_of_a_key that is known\n";
  CHECK(folded(far, 60) ==
        "      |" + std::string(40, ' ') + "^ hint: add\n        an_uncommonly_long_name_of_a_key that is known\n");
  CHECK(folded("", 60).empty());
}

TEST_CASE("a related place becomes a note") {
  const auto text = SourceText::from_string("f", "a = 1\na = 2\n");
  Diagnostic diagnostic = make(Severity::error, {text, 2, 1, 1}, "duplicate key 'a'");
  diagnostic.related = SourceSpan{text, 1, 1, 1};
  diagnostic.related_message = "first defined here";
  CHECK(format(diagnostic) ==
        "f:2:1: error: duplicate key 'a'\n    2 | a = 2\n      | ^\n"
        "f:1:1: note: first defined here\n    1 | a = 1\n      | ^\n");
}

TEST_CASE("errors without a line or a text") {
  const auto text = SourceText::from_string("missing.toml", "");
  CHECK(format(make(Severity::error, whole(text), "gone", "look elsewhere")) ==
        "missing.toml: error: gone\n      hint: look elsewhere\n");
  Diagnostics diagnostics;
  diagnostics.error("unknown option '--x'");
  CHECK(format(diagnostics) == "error: unknown option '--x'\n1 error\n");
}

TEST_CASE("long lines are cut around the caret") {
  std::string line;
  for (int i = 0; i < 400; ++i) line += std::to_string(i) + ",";
  const auto text = SourceText::from_string("f", line + "\n");
  for (const int column :
       {1, 2, 50, 99, 100, 101, 130, 700, static_cast<int>(line.size()) - 1, static_cast<int>(line.size())}) {
    const auto lines = lines_of(format(make(Severity::error, {text, 1, column, 3}, "m")));
    REQUIRE(lines.size() == 3);
    CHECK(lines[1].size() <= 8 + 106);
    const std::size_t caret = lines[2].find('^');
    REQUIRE(caret < lines[1].size());
    CHECK(lines[1][caret] == line[static_cast<std::size_t>(column) - 1]);
  }
  const auto first = lines_of(format(make(Severity::error, {text, 1, 1, 5000}, "m")));
  CHECK(first[1].substr(0, 12) == "    1 | 0,1,");
  CHECK(first[1].substr(first[1].size() - 3) == "...");
  CHECK(first[2].size() <= first[1].size());
}

TEST_CASE("nothing a file contains reaches the terminal as a control sequence") {
  const auto text = SourceText::from_string("f\x1B[2J", std::string("a\x1B[31m\0\xFF\x7Fz\xE2\x80\xAE", 13));
  Diagnostics diagnostics;
  diagnostics.error({text, 1, 7, 1}, "message \x1B[31m", "hint \x07");
  const std::string printed = format(diagnostics);
  for (const char c : printed) CHECK((c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != '\x7F')));
  CHECK(printed.find("a\\x1B[31m\\x00\\xFF\\x7Fz<U+202E>") != std::string::npos);
  CHECK(in_quotes("a\tb") == "'a\\x09b'");
  CHECK(in_quotes(std::string(100, 'x'), 5) == "'xxxxx...'");
}

TEST_CASE("spans outside the text are printed without harm") {
  std::mt19937 generator(5);
  const auto text = SourceText::from_string("f", "αβγ\r\n\x80\x80,\n\tx");
  for (int round = 0; round < 2000; ++round) {
    const auto number = [&] { return static_cast<int>(generator() % 12) - 3; };
    const SourceSpan span{text, number(), number(), number()};
    Diagnostic diagnostic = make(Severity::error, span, "m", "h");
    diagnostic.related = span;
    CHECK_FALSE(format(diagnostic).empty());
  }
}

TEST_CASE("diagnostics are sorted by place, files in order of first complaint") {
  const auto a = SourceText::from_string("z.csv", "1\n2\n3\n");
  const auto b = SourceText::from_string("a.csv", "1\n");
  Diagnostics diagnostics;
  diagnostics.error({a, 3, 1, 1}, "third");
  diagnostics.error({b, 1, 1, 1}, "other file");
  diagnostics.warning({a, 2, 4, 1}, "second");
  diagnostics.error({a, 2, 1, 1}, "first");
  diagnostics.error({a, 2, 1, 1}, "first");
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : diagnostics.all()) messages.push_back(diagnostic.message);
  CHECK(messages == std::vector<std::string>{"first", "second", "third", "other file"});
  CHECK(diagnostics.error_count() == 3);
  CHECK(diagnostics.warning_count() == 1);
  CHECK(diagnostics.count() == 4);
  CHECK(diagnostics.has_errors());
}

TEST_CASE("a file that is wrong everywhere is cut short, warnings never crowd out errors") {
  const auto text = SourceText::from_string("f", std::string(1000, '\n'));
  const auto other = SourceText::from_string("g", "x");
  Diagnostics diagnostics(5);
  for (int i = 0; i < 100; ++i) diagnostics.warning({text, 1, i + 1, 1}, "w");
  CHECK_FALSE(diagnostics.is_full(text.get()));
  for (int i = 0; i < 200; ++i) diagnostics.error({text, i + 1, 1, 1}, "e");
  diagnostics.error({other, 1, 1, 1}, "elsewhere");
  CHECK(diagnostics.is_full(text.get()));
  CHECK_FALSE(diagnostics.is_full(other.get()));
  const auto all = diagnostics.all();
  REQUIRE(all.size() == 12);
  CHECK(all[10].message == "... and 290 more");
  CHECK(format(all[10]) == "f: note: ... and 290 more\n");
  CHECK(all[11].message == "elsewhere");
  CHECK(diagnostics.error_count() == 201);
}

}  // namespace diagnostic_test
