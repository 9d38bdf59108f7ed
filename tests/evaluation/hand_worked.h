// SPDX-License-Identifier: Apache-2.0
//
// Machines of the tiny catalogue whose checks are worked by hand: an axis to hang guides and members on, designs of
// chosen parts, and the comparison of one check.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "catch.h"
#include "evaluation/same_parts.h"
#include "evaluation/tiny_catalogue.h"

namespace millwright::hand_worked {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double g = 9.80665;

/// What guides and structure are sized for beside the load: the belt, chosen after them (the default of
/// belt_mass_allowance).
inline constexpr double belt_allowance = 0.05;

inline const catalogue::Catalogue& parts() {
  static const TinyCatalogue tiny;
  return tiny.parts();
}

/// Rows of the candidates that have all these part numbers.
inline std::vector<solver::Row> rows_of(const evaluation::SlotTable& table, const std::vector<std::string>& numbers) {
  std::vector<solver::Row> rows;
  for (solver::Row row = 0; row < table.rows(); ++row) {
    std::vector<std::string> found;
    for (const auto& use : table.candidate(row).parts)
      found.emplace_back(use.stated.empty() ? std::string(parts().table(use.family).part_number(use.row)) : use.stated);
    if (std::all_of(numbers.begin(), numbers.end(), [&](const std::string& n) {
          return std::find(found.begin(), found.end(), n) != found.end();
        }))
      rows.push_back(row);
  }
  if (rows.empty()) FAIL("no candidate " << numbers.front());
  return rows;
}

struct Chosen {
  std::string axis, element;
  std::vector<std::vector<std::string>> parts;  ///< per slot
  std::vector<double> variables;
};

/// A design of chosen parts; stages that are not named take their first rows and least variables.
inline evaluation::Design design_of(const evaluation::MachineModel& model,
                                    const std::vector<Chosen>& choices,
                                    solver::Row voltage = 0) {
  solver::Build build;
  build.shared = {voltage};
  for (const auto& entry : model.entries()) {
    solver::StageChoice stage;
    stage.rows.assign(entry.tables().size(), 0);
    for (const auto& v : entry.as_stage().variables()) stage.variables.push_back(v.lower);
    for (const Chosen& chosen : choices)
      if (chosen.axis == entry.axis && chosen.element == entry.element) {
        std::vector<std::vector<solver::Row>> rows(stage.rows.size(), {0});
        for (std::size_t slot = 0; slot < chosen.parts.size(); ++slot) {
          rows[slot] = rows_of(entry.tables()[slot], chosen.parts[slot]);
          stage.rows[slot] = rows[slot].front();
        }
        // Parts that do not fit are chosen too, to see which check says so.
        if (const auto fitting = evaluation::rows_that_fit(entry.as_stage(), build.shared, rows)) stage.rows = *fitting;
        if (!chosen.variables.empty()) stage.variables = chosen.variables;
      }
    build.stages.push_back(stage);
  }
  return model.design(build);
}

/// `axis`: empty for the first one that has the check.
inline void expect(const evaluation::Design& design,
                   const std::string& element,
                   const std::string& id,
                   double value,
                   double limit,
                   const std::string& axis = {}) {
  for (const evaluation::Check& c : design.checks) {
    if (c.id != id || c.element != element || (!axis.empty() && c.axis != axis)) continue;
    INFO(element << " " << id << " [" << c.unit << "]");
    CHECK(c.value == Approx(value).epsilon(1e-9));
    CHECK(c.limit == Approx(limit).epsilon(1e-9));
    return;
  }
  FAIL("no check " << id << " of " << element);
}

inline std::string axis_text(const std::string& direction, const std::string& guide, const std::string& members) {
  return fmt::format(R"(
[currency]
USD = 1.0
[supply]
voltage = ["24 V"]
[[axis]]
name = "x"
direction = "{}"
stroke = "500 mm"
structure_mass = "20 kg"
mechanism = {{ kind = "belt", idler_distance = "80 mm" }}
{}
[[axis.moves]]
distance = "400 mm"
time = "1 s"
force = "50 N"
dwell = "1 s"
{}
)",
                     direction,
                     guide.empty() ? std::string() : "guide = " + guide,
                     members);
}

/// That a check is not made of this design.
inline void expect_none(const evaluation::Design& design, const std::string& element, const std::string& id) {
  for (const evaluation::Check& c : design.checks) {
    INFO(element << " " << id);
    CHECK_FALSE((c.id == id && c.element == element));
  }
}

}  // namespace millwright::hand_worked
