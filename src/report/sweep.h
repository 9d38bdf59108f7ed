// SPDX-License-Identifier: Apache-2.0
// What `solve` finds when a value of the problem goes over a range (`--set PATH=FROM:TO:COUNT UNIT`): the best build at
// each value, as table, CSV, JSON and page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/page_texts.h"
#include "report/result.h"
#include "report/text_table.h"

namespace millwright::report {

/// The outcome at one value.
struct SweepPoint {
  double value = 0.0;       ///< in the unit of the sweep
  std::string text;         ///< "0.2 s"
  MachineResult result;     ///< of solve at this value
  double cycle_time = 0.0;  ///< s, of the build; NaN without one
  bool solved = true;       ///< false: the search was ended before it was its turn
  const evaluation::Design* design() const { return result.designs.empty() ? nullptr : &result.designs.front(); }
  /// The answer, be it a build or that there is none, is proved.
  bool proved() const { return solved && result.status != Status::limit; }
};

struct Sweep {
  std::string path, unit;
  std::vector<SweepPoint> points;
  Timing timing;
  /// What is limited of the whole machine, or part of what is minimised.
  std::vector<machine::Quantity> counted = {};
  /// Title, file, currency, objective and what was asked for are those of every point.
  const MachineResult& first() const { return points.front().result; }
};

/// Why there is no build, in one line: slots without candidates, checks that fail whatever is chosen. Empty if there is
/// a build.
std::string no_build_reason(const SweepPoint& point);

/// Whether an objective has no column that every sweep has: cost, mass and cycle time have theirs.
bool has_own_column(const std::string& objective);

/// What else is counted (Sweep::counted) and has no column yet.
std::vector<machine::Quantity> further_columns(const Sweep& sweep);

/// "585.64 J": of the build at a value; empty without one.
std::string counted_text(const SweepPoint& point, machine::Quantity quantity);

/// What could not be looked at for some of the values: a setting may decide what is asked.
std::vector<evaluation::IncompleteParts> incomplete_in(const Sweep& sweep);

/// In what each build differs from that of the last value that had one: "x.motor 17HS4401S, ...". Empty for the first.
std::vector<std::string> sweep_changes(const Sweep& sweep);

std::string sweep_text(const Sweep& sweep, const Style& style);
std::string sweep_csv(const Sweep& sweep);
std::string sweep_json(const Sweep& sweep);
/// `json` goes into the page.
std::string sweep_page(const Sweep& sweep, const std::string& json, Language language);

}  // namespace millwright::report
