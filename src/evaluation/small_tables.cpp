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

SlotTable coupling_table(const catalogue::Catalogue& catalogue, const PriceBook& prices) {
  // The misalignments are read by soft checks only: a coupling without them stays.
  constexpr std::size_t needed = 6;
  SlotTable result("coupling", 9);
  const Table& t = catalogue.table(Family::couplings);
  for (int row = 0; row < t.rows(); ++row) {
    const auto number = [&](catalogue::Column c) { return t.number(c, row); };
    const auto range = [&](catalogue::Column c) { return t.range(c, row); };
    const auto readings_of = [](auto figure) {
      return std::array{figure(column(Family::couplings, "inertia")),
                        figure(column(Family::couplings, "rated_torque")),
                        figure(column(Family::couplings, "torsional_stiffness")),
                        figure(column(Family::couplings, "maximum_speed")),
                        figure(column(Family::couplings, "minimum_bore")),
                        figure(column(Family::couplings, "maximum_bore")),
                        figure(column(Family::couplings, "parallel_misalignment")),
                        figure(column(Family::couplings, "angular_misalignment")),
                        figure(column(Family::couplings, "axial_misalignment"))};
    };
    const std::array<double, 9> readings = readings_of(number);
    Candidate candidate = candidate_of({{"coupling",
                                         Family::couplings,
                                         row,
                                         1.0,
                                         0.0,
                                         prices.line(t, row, 1.0, 0.0),
                                         number(column(Family::couplings, "mass"))}},
                                       0.0);
    if (t.has_ranges())
      candidate.ranges =
          candidate_ranges(readings_of(range), candidate.price, {}, range(column(Family::couplings, "mass")));
    if (is_known(std::span(readings).first(needed), candidate)) result.add(std::move(candidate), readings);
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
    const auto range = [&](catalogue::Column c) { return t.range(c, row); };
    const bool stiffness_known = !std::isnan(number(column(Family::support_bearings, "axial_stiffness")));
    const auto readings_of = [&](auto figure) {
      using T = decltype(figure(column(Family::support_bearings, "bore")));
      std::array<T, 5> readings{figure(column(Family::support_bearings, "bore")),
                                figure(column(Family::support_bearings, "permissible_axial_load")),
                                figure(column(Family::support_bearings, "axial_stiffness")),
                                figure(column(Family::support_bearings, "maximum_speed")),
                                T(block ? 1.0 : 0.0)};
      // A free end takes no thrust: no constraint reads its axial load or stiffness.
      if (!fixed) readings[1] = readings[2] = T(0.0);
      if (!stiffness_needed && !stiffness_known) readings[2] = T(0.0);
      return readings;
    };
    const std::array<double, 5> readings = readings_of(number);
    Candidate candidate = candidate_of({{slot,
                                         Family::support_bearings,
                                         row,
                                         1.0,
                                         0.0,
                                         prices.line(t, row, 1.0, 0.0),
                                         number(column(Family::support_bearings, "mass"))}},
                                       0.0);
    if (t.has_ranges())
      candidate.ranges =
          candidate_ranges(readings_of(range), candidate.price, {}, range(column(Family::support_bearings, "mass")));
    if (is_known(readings, candidate)) result.add(std::move(candidate), readings);
  }
  return result;
}

namespace {

/// Ranges of the figures of a row.
auto range_of_row(const Table& table, int row) {
  return [&table, row](catalogue::Column figure) { return table.range(figure, row); };
}

/// Of a belt round two pulleys, as numbers or as ranges, in the order of machine::BeltReading.
template <class BeltFigure, class DriveFigure, class IdlerFigure>
auto belt_readings(
    double span, double width, BeltFigure belt_figure, DriveFigure drive_figure, IdlerFigure idler_figure) {
  using T = decltype(belt_figure(column(Family::belts, "width")));
  const T drive_diameter = drive_figure(column(Family::pulleys, "pitch_diameter"));
  const T idler_diameter = idler_figure(column(Family::pulleys, "pitch_diameter"));
  const T length = 2.0 * span + 0.5 * 3.14159265358979323846 * (drive_diameter + idler_diameter);
  return std::array<T, machine::belt_reading_fields>{belt_figure(column(Family::belts, "mass_per_length")),
                                                     belt_figure(column(Family::belts, "allowable_tension")),
                                                     belt_figure(column(Family::belts, "tensile_stiffness")),
                                                     belt_figure(column(Family::belts, "minimum_pulley_teeth")),
                                                     belt_figure(column(Family::belts, "maximum_speed")),
                                                     length,
                                                     belt_figure(column(Family::belts, "mass_per_length")) * length,
                                                     T(span),
                                                     drive_figure(column(Family::pulleys, "teeth")),
                                                     drive_diameter,
                                                     drive_figure(column(Family::pulleys, "inertia")),
                                                     idler_figure(column(Family::pulleys, "inertia")),
                                                     idler_diameter,
                                                     drive_figure(column(Family::pulleys, "bore")),
                                                     T(width)};
}

}  // namespace

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
        const auto readings_of = [&](auto belt_figure, auto drive_figure, auto idler_figure) {
          return belt_readings(span, width, belt_figure, drive_figure, idler_figure);
        };
        constexpr std::size_t length_field = 5, mass_field = 6;
        const std::array<double, machine::belt_reading_fields> readings = readings_of(belt, drive, idle);
        const double length = readings[length_field], belt_mass = readings[mass_field];
        // The belt moves with the carriage (a reading of the drive) and hangs on the parent (its standing mass).
        Candidate candidate =
            candidate_of({{"belt", Family::belts, b, 1.0, length, prices.cut(belts, b, {{1.0, length}}), belt_mass},
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
        if (belts.has_ranges() || pulleys.has_ranges()) {
          constexpr catalogue::Column mass = column(Family::pulleys, "mass");
          const auto ranges = readings_of(range_of_row(belts, b), range_of_row(pulleys, d), range_of_row(pulleys, i));
          candidate.ranges = candidate_ranges(
              ranges, candidate.price, {}, ranges[mass_field] + pulleys.range(mass, d) + pulleys.range(mass, i));
        }
        if (is_known(readings, candidate)) result.add(std::move(candidate), readings);
      }
    }
  }
  return result;
}

}  // namespace millwright::evaluation
