// SPDX-License-Identifier: Apache-2.0
// A small sound problem, and variants of it in which «marks» show the very characters that a complaint must point at.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catch.h"
#include "machine/problem_file.h"
#include "text/document.h"

namespace problem_text {

using namespace millwright;

inline const std::string sound = R"(title = "Two axes"
[objective]
minimise = "cost"
[currency]
USD = 1.0
EUR = { rate = 1.08, date = 2026-01-15 }
[supply]
voltage = ["24 V", "48 V"]
[require]
life = "20000 h"
[[axis]]
name = "x"
carries = ["y"]
direction = "horizontal"
stroke = "700 mm"
structure_mass = "16 kg"
guide_friction = 0.1
acceleration_time = ["0.05 s", "0.5 s"]
mechanism = { kind = "screw", screw = ["ball_screws", "lead_screws"], ends = "fixed-free" }
motor = { from = "steppers", frame = ["NEMA17"], microsteps = 16 }
guide = { rails = 2, carriages = 4, carriage_spacing = "200 mm", rail_spacing = "250 mm" }
[[axis.moves]]
name = "sand"
distance = "700 mm"
time = "36 s"
[axis.require]
position_error = { limit = "0.05 mm", over = "300 mm" }
[[axis.members]]
name = "beam"
kind = "beam"
length = "500 mm"
material = "S235JR"
sections = ["steel_sections"]
[[axis]]
name = "y"
stroke = "250 mm"
structure_mass = "4 kg"
mechanism = { kind = "belt", profiles = ["GT2"], efficiency = 0.95 }
[[axis.moves]]
distance = "100 mm"
speed = "20 mm/s"
)";

struct Place {
  int line = 0, column = 0, length = 0;
};

/// Takes the marks out of `text` and says where they stood; an empty pair of marks is a place without a length.
inline Place take_marks(std::string& text) {
  constexpr std::string_view open = "«", close = "»";
  const std::size_t begin = text.find(open);
  REQUIRE(begin != std::string::npos);
  const auto characters = [&](std::size_t from, std::size_t to) {
    int count = 0;
    for (std::size_t i = from; i < to; ++i) count += (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U ? 1 : 0;
    return count;
  };
  Place place;
  place.line = 1;
  std::size_t line_begin = 0;
  for (std::size_t i = 0; i < begin; ++i)
    if (text[i] == '\n') {
      ++place.line;
      line_begin = i + 1;
    }
  place.column = characters(line_begin, begin) + 1;
  text.erase(begin, open.size());
  const std::size_t end = text.find(close, begin);
  REQUIRE(end != std::string::npos);
  text.erase(end, close.size());
  place.length = characters(begin, end);
  return place;
}

inline std::string replaced(std::string text, const std::string& old, const std::string& with) {
  const std::size_t at = text.find(old);
  INFO("there is no '" << old << "' in the problem");
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), with);
}

struct Outcome {
  std::optional<machine::Problem> problem;
  text::Diagnostics diagnostics;
};

inline Outcome read(const std::string& contents, const std::string& name = "problem.toml") {
  Outcome outcome;
  const auto source = text::SourceText::from_string(name, contents);
  const auto document = name.ends_with(".json") ? text::read_json(source, outcome.diagnostics)
                                                : text::read_toml(source, outcome.diagnostics);
  if (document) outcome.problem = machine::problem_of(*document, outcome.diagnostics);
  return outcome;
}

struct Case {
  std::string old, with;      ///< replaced in the sound problem; `with` has the marks
  std::string message, hint;  ///< parts of what is said
  text::Severity severity = text::Severity::error;
};

inline void check_place(const text::Diagnostic& said, const Place& place, const Case& expected) {
  CHECK(said.where.line == place.line);
  CHECK(said.where.column == place.column);
  if (place.length > 0) CHECK(said.where.length == place.length);
  CHECK(said.severity == expected.severity);
  CHECK(said.message.find(expected.message) != std::string::npos);
  CHECK(said.hint.find(expected.hint) != std::string::npos);
  CHECK_FALSE(said.hint.empty());
}

/// Exactly one complaint, at the marks, in these words; a problem comes out if and only if it was no error.
inline void check(const Case& expected, const std::string& base = sound) {
  std::string contents = replaced(base, expected.old, expected.with);
  const Place place = take_marks(contents);
  const Outcome outcome = read(contents);
  INFO(expected.with << "\n" << text::format(outcome.diagnostics));
  CHECK(outcome.problem.has_value() == (expected.severity != text::Severity::error));
  REQUIRE(outcome.diagnostics.count() == 1);
  check_place(outcome.diagnostics.all().front(), place, expected);
}

}  // namespace problem_text
