// SPDX-License-Identifier: Apache-2.0
//
// Couplings, support bearings, belts with pulleys.
#include <array>
#include <cmath>

#include "evaluation/drive_tables.h"
#include "machine/belt_drive.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;
using catalogue::Table;

namespace {
bool known(std::span<const double> values, const Candidate& candidate) {
  return std::none_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }) &&
         !std::isnan(candidate.price) && !std::isnan(candidate.mass);
}
}  // namespace

SlotTable coupling_table(const catalogue::Catalogue& catalogue, const PriceBook& prices) {
  // The misalignments are read by soft checks only: a coupling without them stays.
  constexpr std::size_t needed = 6;
  SlotTable result("coupling", 9);
  const Table& t = catalogue.table(Family::couplings);
  for (int row = 0; row < t.rows(); ++row) {
    const auto number = [&](catalogue::Column c) { return t.number(c, row); };
    const std::array<double, 9> readings{number(column(Family::couplings, "inertia")),
                                         number(column(Family::couplings, "rated_torque")),
                                         number(column(Family::couplings, "torsional_stiffness")),
                                         number(column(Family::couplings, "maximum_speed")),
                                         number(column(Family::couplings, "minimum_bore")),
                                         number(column(Family::couplings, "maximum_bore")),
                                         number(column(Family::couplings, "parallel_misalignment")),
                                         number(column(Family::couplings, "angular_misalignment")),
                                         number(column(Family::couplings, "axial_misalignment"))};
    Candidate candidate = candidate_of({{"coupling",
                                         Family::couplings,
                                         row,
                                         1.0,
                                         0.0,
                                         prices.line(t, row, 1.0, 0.0),
                                         number(column(Family::couplings, "mass"))}},
                                       0.0);
    if (known(std::span(readings).first(needed), candidate)) result.add(std::move(candidate), readings);
  }
  return result;
}

SlotTable support_table(const catalogue::Catalogue& catalogue,
                        const PriceBook& prices,
                        const std::string& slot,
                        bool fixed,
                        bool stiffness_needed) {
  SlotTable result(slot, 5);
  const Table& t = catalogue.table(Family::support_bearings);
  for (int row = 0; row < t.rows(); ++row) {
    const std::string_view role = t.text(column(Family::support_bearings, "role"), row);
    const bool block = role == "pillow block" || role == "flange block";
    if (fixed ? role != "fixed" : role != "supported" && !block) continue;
    const auto number = [&](catalogue::Column c) { return t.number(c, row); };
    std::array<double, 5> readings{number(column(Family::support_bearings, "bore")),
                                   number(column(Family::support_bearings, "permissible_axial_load")),
                                   number(column(Family::support_bearings, "axial_stiffness")),
                                   number(column(Family::support_bearings, "maximum_speed")),
                                   block ? 1.0 : 0.0};
    // A free end takes no thrust: no constraint reads its axial load or stiffness.
    if (!fixed) readings[1] = readings[2] = 0.0;
    if (!stiffness_needed && std::isnan(readings[2])) readings[2] = 0.0;
    Candidate candidate = candidate_of({{slot,
                                         Family::support_bearings,
                                         row,
                                         1.0,
                                         0.0,
                                         prices.line(t, row, 1.0, 0.0),
                                         number(column(Family::support_bearings, "mass"))}},
                                       0.0);
    if (known(readings, candidate)) result.add(std::move(candidate), readings);
  }
  return result;
}

SlotTable belt_table(const catalogue::Catalogue& catalogue, const machine::Axis& axis, const PriceBook& prices) {
  SlotTable result("belt", machine::belt_reading_fields);
  const Table& belts = catalogue.table(Family::belts);
  const Table& pulleys = catalogue.table(Family::pulleys);
  const double span =
      axis.stroke + 2.0 * axis.require(machine::Requirement::overtravel) + axis.mechanism.idler_distance;
  for (int b = 0; b < belts.rows(); ++b) {
    const std::string_view profile = belts.text(column(Family::belts, "profile"), b);
    if (!axis.mechanism.profiles.empty() &&
        std::find(axis.mechanism.profiles.begin(), axis.mechanism.profiles.end(), profile) ==
            axis.mechanism.profiles.end())
      continue;
    const double width = belts.number(column(Family::belts, "width"), b);
    const auto same_pulley = [&](int p, int q) {  // whoever sells it
      return pulleys.part_number(p) == pulleys.part_number(q) && pulleys.manufacturer(p) == pulleys.manufacturer(q);
    };
    const auto runs = [&](int p) {
      return pulleys.text(column(Family::pulleys, "profile"), p) == profile &&
             std::abs(pulleys.number(column(Family::pulleys, "belt_width"), p) - width) < 1e-6;
    };
    for (int d = 0; d < pulleys.rows(); ++d) {
      if (!runs(d) || pulleys.text(column(Family::pulleys, "type"), d) == "idler") continue;
      for (int i = 0; i < pulleys.rows(); ++i) {
        // An idler: a plain idler, or the same pulley once more on a bearing.
        if (!runs(i) || (pulleys.text(column(Family::pulleys, "type"), i) != "idler" && !same_pulley(i, d))) continue;
        const auto belt = [&](catalogue::Column c) { return belts.number(c, b); };
        const auto drive = [&](catalogue::Column c) { return pulleys.number(c, d); };
        const auto idle = [&](catalogue::Column c) { return pulleys.number(c, i); };
        const double drive_diameter = drive(column(Family::pulleys, "pitch_diameter"));
        const double idler_diameter = idle(column(Family::pulleys, "pitch_diameter"));
        const double length = 2.0 * span + 0.5 * 3.14159265358979323846 * (drive_diameter + idler_diameter);
        const double belt_mass = belt(column(Family::belts, "mass_per_length")) * length;
        const std::array<double, machine::belt_reading_fields> readings{
            belt(column(Family::belts, "mass_per_length")),
            belt(column(Family::belts, "allowable_tension")),
            belt(column(Family::belts, "tensile_stiffness")),
            belt(column(Family::belts, "minimum_pulley_teeth")),
            belt(column(Family::belts, "maximum_speed")),
            length,
            belt_mass,
            span,
            drive(column(Family::pulleys, "teeth")),
            drive_diameter,
            drive(column(Family::pulleys, "inertia")),
            idle(column(Family::pulleys, "inertia")),
            idler_diameter,
            drive(column(Family::pulleys, "bore")),
            width};
        // The belt moves with the carriage (a reading of the drive) and hangs on the parent (its standing mass).
        Candidate candidate =
            candidate_of({{"belt", Family::belts, b, 1.0, length, prices.line(belts, b, 0.0, length), belt_mass},
                          {"pulley_drive",
                           Family::pulleys,
                           d,
                           1.0,
                           0.0,
                           prices.line(pulleys, d, 1.0, 0.0),
                           drive(column(Family::pulleys, "mass"))},
                          {"pulley_idle",
                           Family::pulleys,
                           i,
                           1.0,
                           0.0,
                           prices.line(pulleys, i, 1.0, 0.0),
                           idle(column(Family::pulleys, "mass"))}},
                         0.0);
        if (known(readings, candidate)) result.add(std::move(candidate), readings);
      }
    }
  }
  return result;
}

}  // namespace millwright::evaluation
