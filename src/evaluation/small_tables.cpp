// SPDX-License-Identifier: Apache-2.0
//
// Couplings, support bearings.
#include <array>
#include <cmath>
#include <span>

#include "evaluation/drive_tables.h"
#include "evaluation/figure_reader.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;
using catalogue::Table;

SlotTable coupling_table(const catalogue::Catalogue& catalogue, const PriceBook& prices) {
  // The misalignments are read by soft checks only: a coupling without them stays.
  constexpr std::size_t needed = 6;
  constexpr std::array soft{column(Family::couplings, "parallel_misalignment"),
                            column(Family::couplings, "angular_misalignment"),
                            column(Family::couplings, "axial_misalignment")};
  SlotTable result("coupling", 9);
  const Table& t = catalogue.table(Family::couplings);
  for (const int row : t.rows_in_order()) {
    std::vector<catalogue::Column> missing;
    const FigureReader number(t, row, missing, soft);
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
    CandidateDraft candidate = candidate_of({{"coupling",
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
    if (result.admits(candidate, std::span(readings).first(needed), missing))
      result.add(std::move(candidate), readings);
  }
  return result;
}

SlotTable support_table(const catalogue::Catalogue& catalogue,
                        const PriceBook& prices,
                        const std::string& slot,
                        bool fixed,
                        bool stiffness_needed) {
  SlotTable result(slot, 5);
  // A free end takes no thrust: no constraint reads its axial load or stiffness.
  constexpr std::array of_thrust{column(Family::support_bearings, "axial_stiffness"),
                                 column(Family::support_bearings, "permissible_axial_load")};
  const auto soft = std::span(of_thrust).first(!fixed ? 2 : stiffness_needed ? 0 : 1);
  const Table& t = catalogue.table(Family::support_bearings);
  for (const int row : t.rows_in_order()) {
    const std::string_view role = t.text(column(Family::support_bearings, "role"), row);
    const bool block = role == "pillow block" || role == "flange block";
    if (fixed ? role != "fixed" : role != "supported" && !block) continue;
    std::vector<catalogue::Column> missing;
    const FigureReader number(t, row, missing, soft);
    const auto range = [&](catalogue::Column c) { return t.range(c, row); };
    const bool stiffness_known = !std::isnan(number(column(Family::support_bearings, "axial_stiffness")));
    const auto readings_of = [&](auto figure) {
      using T = decltype(figure(column(Family::support_bearings, "bore")));
      std::array<T, 5> readings{figure(column(Family::support_bearings, "bore")),
                                figure(column(Family::support_bearings, "permissible_axial_load")),
                                figure(column(Family::support_bearings, "axial_stiffness")),
                                figure(column(Family::support_bearings, "maximum_speed")),
                                T(block ? 1.0 : 0.0)};
      if (!fixed) readings[1] = readings[2] = T(0.0);
      if (!stiffness_needed && !stiffness_known) readings[2] = T(0.0);
      return readings;
    };
    const std::array<double, 5> readings = readings_of(number);
    CandidateDraft candidate = candidate_of({{slot,
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
    if (result.admits(candidate, readings, missing)) result.add(std::move(candidate), readings);
  }
  return result;
}

}  // namespace millwright::evaluation
