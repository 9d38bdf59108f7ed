// SPDX-License-Identifier: Apache-2.0
//
// Racks of the length that an axis needs, and pinions.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "evaluation/drive_tables.h"
#include "evaluation/figure_reader.h"
#include "machine/rack_drive.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;
using catalogue::Table;

SlotTable rack_table(const catalogue::Catalogue& catalogue, const machine::Axis& axis, const PriceBook& prices) {
  SlotTable result("rack", machine::rack_reading_fields);
  const Table& t = catalogue.table(Family::racks);
  const double travel = axis.stroke + 2.0 * axis.require(machine::Requirement::overtravel);
  const bool error_counts = axis.require.known(machine::Requirement::position_error);
  for (const int row : t.rows_in_order()) {
    constexpr std::array soft{column(Family::racks, "pitch_error_per_1000mm")};
    std::vector<catalogue::Column> missing;
    const FigureReader number(t, row, missing, std::span(soft).first(error_counts ? 0 : 1));
    const double module = number(column(Family::racks, "module"));
    const double piece = number(column(Family::racks, "piece_length"));
    // At both ends of the travel a tooth beyond the pinion's axis is in mesh.
    const double needed = travel + 2.0 * 3.14159265358979323846 * module;
    // A remainder of less than a tenth of a tooth is not worth another piece.
    const double pieces = std::max(1.0, std::ceil((needed - 0.3 * module) / piece));
    constexpr catalogue::Column pitch_error = column(Family::racks, "pitch_error_per_1000mm");  // m over 1 m
    const bool no_error = !error_counts && std::isnan(number(pitch_error));
    const auto readings_of = [&](auto figure) {
      using T = decltype(figure(pitch_error));
      return std::array<T, machine::rack_reading_fields>{
          T(module),
          figure(column(Family::racks, "pressure_angle")),
          figure(column(Family::racks, "face_width")),
          figure(column(Family::racks, "allowable_stress")),
          no_error ? T(0.0) : figure(pitch_error),
          pieces * piece * figure(column(Family::racks, "mass_per_length"))};
    };
    const std::array<double, machine::rack_reading_fields> readings = readings_of(number);
    const double mass = readings.back();
    CandidateDraft candidate = candidate_of(
        {{"rack", Family::racks, row, pieces, piece, prices.line(t, row, 0.0, pieces * piece), mass}}, 0.0);
    if (t.has_ranges()) {
      const auto ranges = readings_of([&](catalogue::Column c) { return t.range(c, row); });
      candidate.ranges = candidate_ranges(ranges, candidate.price, {}, ranges.back());
    }
    if (result.admits(candidate, readings, missing)) result.add(std::move(candidate), readings);
  }
  return result;
}

SlotTable pinion_table(const catalogue::Catalogue& catalogue, const PriceBook& prices) {
  SlotTable result("pinion", machine::pinion_reading_fields);
  const Table& t = catalogue.table(Family::pinions);
  for (const int row : t.rows_in_order()) {
    std::vector<catalogue::Column> missing;
    const FigureReader number(t, row, missing);
    const double mass = number(column(Family::pinions, "mass"));
    const auto readings_of = [](auto figure) {
      return std::array{figure(column(Family::pinions, "module")),
                        figure(column(Family::pinions, "pressure_angle")),
                        figure(column(Family::pinions, "teeth")),
                        figure(column(Family::pinions, "face_width")),
                        figure(column(Family::pinions, "bore")),
                        figure(column(Family::pinions, "allowable_stress")),
                        figure(column(Family::pinions, "mass")),
                        figure(column(Family::pinions, "inertia"))};
    };
    const std::array<double, machine::pinion_reading_fields> readings = readings_of(number);
    CandidateDraft candidate =
        candidate_of({{"pinion", Family::pinions, row, 1.0, 0.0, prices.line(t, row, 1.0, 0.0), mass}}, 0.0);
    if (t.has_ranges())
      candidate.ranges = candidate_ranges(readings_of([&](catalogue::Column c) { return t.range(c, row); }),
                                          candidate.price,
                                          {},
                                          t.range(column(Family::pinions, "mass"), row));
    if (result.admits(candidate, readings, missing)) result.add(std::move(candidate), readings);
  }
  return result;
}

}  // namespace millwright::evaluation
