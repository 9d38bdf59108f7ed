// SPDX-License-Identifier: Apache-2.0
// Many part numbers say how large the part is: a thread's designation its diameter and pitch (ISO 965-1, ISO 2904),
// and ball screws, by a custom that most makers keep, two digits of diameter and two of lead (SFU1605, BNK1402).
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "catalogue/lint_row.h"

namespace millwright::catalogue {
namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }

/// Takes a number off the front of `text`; NaN if there is none.
double take_number(std::string_view& text) {
  double value = std::nan("");
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (problem != std::errc()) return std::nan("");
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// "M8x1", "Tr16x4", "Tr16x8(P4)": diameter, and what follows the x if anything does.
void lint_thread_designation(const LintRow& row, std::string_view text, Column diameter, Column pitch) {
  if (text.starts_with("Tr")) {
    text.remove_prefix(2);
  } else if (text.starts_with("M")) {
    text.remove_prefix(1);
  } else {
    return;
  }
  const double size = take_number(text);
  row.agrees("designation", diameter, size, 0.001, 0.05, "the diameter in its designation");
  if (!text.starts_with("x")) return;
  text.remove_prefix(1);
  row.agrees("designation", pitch, take_number(text), 0.001, 0.05, "the figure in its designation");
}

void lint_ball_screw_number(const LintRow& row, std::string_view text) {
  std::size_t letters = 0;
  while (letters < text.size() && std::isupper(static_cast<unsigned char>(text[letters])) != 0) ++letters;
  if (letters != 3) return;
  text.remove_prefix(3);
  std::size_t digits = 0;
  while (digits < text.size() && digit(text[digits])) ++digits;
  if (digits != 4 && !(digits == 5 && text.front() == '0')) return;
  if (digits == 5) text.remove_prefix(1);
  const double diameter = 10 * (text[0] - '0') + (text[1] - '0');
  const double lead = 10 * (text[2] - '0') + (text[3] - '0');
  if (diameter < 4 || lead < 1) return;
  row.agrees("designation",
             column(Family::ball_screws, "nominal_diameter"),
             diameter,
             0.001,
             10,
             "the diameter that its part number seems to name");
  row.agrees("designation",
             column(Family::ball_screws, "lead"),
             lead,
             0.001,
             10,
             "the lead that its part number seems to name");
}

}  // namespace

void lint_designation(Family family, const LintRow& row) {
  const auto of = [family](std::string_view name) { return column(family, name); };
  switch (family) {
    case Family::threads:
      return lint_thread_designation(row, row.text(of("part_number")), of("nominal_diameter"), of("pitch"));
    case Family::screws:
      return lint_thread_designation(row, row.text(of("designation")), of("nominal_diameter"), of("pitch"));
    case Family::lead_screws:
      return lint_thread_designation(row, row.text(of("designation")), of("major_diameter"), of("lead"));
    case Family::ball_screws:
      return lint_ball_screw_number(row, row.text(of("part_number")));
    default:
      return;
  }
}

}  // namespace millwright::catalogue
