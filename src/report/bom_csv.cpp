// SPDX-License-Identifier: Apache-2.0
#include "report/bom_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scalar/unit.h"

namespace millwright::report {
namespace {

/// The verdict of a check beside its limit might not survive a change of the last bit of a ramp, all others do.
/// (Whether parts fit each other hangs on no ramp, and 36 V at a driver for 36 V is at the limit.)
bool hangs_on_bits(const evaluation::Design& design) {
  constexpr double beside = 1e-9;
  return std::any_of(design.checks.begin(), design.checks.end(), [](const evaluation::Check& check) {
    return std::abs(check.utilisation - 1.0) <= beside && check.kind != machine::ConstraintKind::fit;
  });
}

/// 0.3 s for 0.30000000000000004 s, the middle of a range, which nobody would write; what has many digits keeps them.
/// What is chosen from a list (volts, amperes) is as the problem states it.
std::string setting_quantity(double si, const std::string& unit, bool every_bit) {
  const std::string exact = fmt::format("{}", si);
  const std::string near = fmt::format("{:.15g}", si);
  constexpr std::size_t noise = 3;  // digits
  return (every_bit || unit != "s" || near.size() + noise > exact.size() ? exact : near) + " " + unit;
}

}  // namespace

std::string csv_cell(std::string_view text) {
  const bool plain = text.find_first_of(",;\"\r\n") == std::string_view::npos &&
                     (text.empty() || (text.front() != ' ' && text.back() != ' ' && text.front() != '#'));
  if (plain) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string exact_quantity(double si, std::string_view unit, std::string_view si_unit) {
  const scalar::Unit shown = scalar::Unit::of(unit);
  const double near = shown.from_si(si);
  for (const double value :
       {std::round(near * 1e6) / 1e6, near, std::nextafter(near, -HUGE_VAL), std::nextafter(near, HUGE_VAL)})
    if (shown.to_si(value) == si) return fmt::format("{} {}", value, unit);
  return fmt::format("{} {}", si, si_unit);
}

std::string bom_csv(const evaluation::Design& design) {
  std::string out = "axis,slot,manufacturer,part_number,quantity,length,value\n";
  for (const evaluation::PartLine& part : design.parts) {
    // A member made to measure is told by its dimensions below; its material stands in the problem.
    // So does a reduction without a name, of which there is only one.
    const bool unnamed = part.family.empty() && part.manufacturer.empty();
    if (part.family == "materials" || unnamed) continue;
    out += fmt::format("{},{},{},{},{},{},\n",
                       csv_cell(part.axis),
                       csv_cell(part.slot),
                       csv_cell(part.manufacturer),
                       csv_cell(part.part_number),
                       part.quantity,
                       part.length > 0.0 ? scalar::format(part.length, scalar::Unit::of("mm"), 7) : "");
  }
  const bool every_bit = hangs_on_bits(design);
  for (const evaluation::DimensionLine& line : design.dimensions) {
    const std::string value =
        line.unit == "m" ? exact_quantity(line.value, "mm", "m") : setting_quantity(line.value, line.unit, every_bit);
    out += fmt::format("{},{},,,,,{}\n", csv_cell(line.axis), csv_cell(line.name), csv_cell(value));
  }
  return out;
}

}  // namespace millwright::report
