// SPDX-License-Identifier: Apache-2.0
// `--set PATH=FROM:TO:COUNT UNIT`: a value of the problem file that goes over a range.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/diagnostic.h"

namespace millwright::machine {

/// A range has so many values at most: each is a problem to solve.
inline constexpr std::size_t most_range_values = 200;

struct SettingRange {
  std::string path;                ///< "axis.x.moves[0].time"
  std::string unit;                ///< as typed, empty for plain numbers
  std::vector<double> values;      ///< in that unit, evenly spaced, both ends among them
  std::vector<std::string> texts;  ///< what each would be typed as, "0.2 s"
};

/// Whether an assignment of `--set` is meant as a range: numbers, each perhaps with a unit, between colons.
bool is_setting_range(const std::string& assignment);

/// Reads `axis.x.moves[0].time=0.2:0.5:7 s`; the unit stands at the end, or behind both ends. Reported, at the option:
/// a count that is missing or not from 2 to most_range_values, ends that are equal or no numbers, units that differ.
std::optional<SettingRange> read_setting_range(const std::string& assignment, text::Diagnostics& diagnostics);

}  // namespace millwright::machine
