// SPDX-License-Identifier: Apache-2.0
#include "evaluation/belt_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

#include "evaluation/figure_reader.h"
#include "machine/word_column.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;
using catalogue::Table;

namespace {

constexpr catalogue::Column pulley_diameter = column(Family::pulleys, "pitch_diameter");
constexpr catalogue::Column pulley_mass = column(Family::pulleys, "mass");

/// Pulleys of one size, as far as a belt is concerned.
struct PulleySize {
  std::string profile;
  double belt_width = 0.0;   ///< m
  double teeth = 0.0;        ///< 0 of an idler
  double diameter = 0.0;     ///< m
  int own = -1;              ///< row of a pulley of which the diameter may be off: it is a size of its own
  scalar::Interval range{};  ///< of the diameter
  friend bool operator<(const PulleySize& a, const PulleySize& b) {
    return std::tie(a.profile, a.belt_width, a.teeth, a.diameter, a.own) <
           std::tie(b.profile, b.belt_width, b.teeth, b.diameter, b.own);
  }
};

/// Sizes by their numbers, in the order in which they are first met.
class PulleySizes {
 public:
  std::int32_t number_of(const PulleySize& size) {
    const auto [found, is_new] = numbers_.try_emplace(size, static_cast<std::int32_t>(sizes_.size()));
    if (is_new) sizes_.push_back(size);
    return found->second;
  }
  [[nodiscard]] const std::vector<PulleySize>& sizes() const { return sizes_; }

 private:
  std::map<PulleySize, std::int32_t> numbers_;
  std::vector<PulleySize> sizes_;
};

/// Of a belt round two pulleys, as numbers or as ranges, in the order of BeltTables::BeltField.
template <class T, class Figure>
auto belt_readings(double span, double width, const T& teeth, const T& drive, const T& idler, Figure figure) {
  const T length = 2.0 * span + 0.5 * std::numbers::pi * (drive + idler);
  const T mass_per_length = figure(column(Family::belts, "mass_per_length"));
  return std::array<T, BeltTables::belt_fields>{mass_per_length,
                                                figure(column(Family::belts, "allowable_tension")),
                                                figure(column(Family::belts, "tensile_stiffness")),
                                                figure(column(Family::belts, "minimum_pulley_teeth")),
                                                figure(column(Family::belts, "maximum_speed")),
                                                length,
                                                mass_per_length * length,
                                                T(span),
                                                teeth,
                                                drive,
                                                idler,
                                                T(width)};
}

class BeltTablesMaker {
 public:
  BeltTablesMaker(const catalogue::Catalogue& catalogue, const machine::Axis& axis, const PriceBook& prices)
      : belts_(catalogue.table(Family::belts)),
        pulleys_(catalogue.table(Family::pulleys)),
        axis_(axis),
        prices_(prices),
        span_(axis.stroke + 2.0 * axis.require(machine::Requirement::overtravel) + axis.mechanism.idler_distance) {
    result_.belts = SlotTable("belt", BeltTables::belt_fields);
    result_.pulleys = SlotTable("pulley_drive", BeltTables::pulley_fields);
    result_.idlers = SlotTable("pulley_idle", BeltTables::idler_fields);
  }

  BeltTables make() {
    for (const int row : pulleys_.rows_in_order())
      if (is_idler(row))
        add_idler(row);
      else
        add_pulley(row);
    add_pulleys_with_second();
    result_.idlers.add(CandidateDraft{}, std::array<double, BeltTables::idler_fields>{});
    result_.idlers_fit.push_back(BeltFit::same);
    for (const int row : belts_.rows_in_order())
      if (machine::word_columns::belt_profile.takes(axis_.mechanism.profiles, belts_, row)) add_belt(row);
    if (result_.belts.rows() > 0) leave_out_what_no_belt_needs();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_idler(int row) const { return pulleys_.text(column(Family::pulleys, "type"), row) == "idler"; }

  using Missing = std::vector<catalogue::Column>;

  [[nodiscard]] PulleySize size_of(int row, bool with_teeth, Missing& missing) const {
    const FigureReader number(pulleys_, row, missing);
    PulleySize size{std::string(pulleys_.text(column(Family::pulleys, "profile"), row)),
                    number("belt_width"),
                    with_teeth ? number("teeth") : 0.0,
                    number(pulley_diameter)};
    size.range = pulleys_.range(pulley_diameter, row);
    if (pulleys_.half_width(row, pulley_diameter) > 0.0 || size.range.lower < size.range.upper) size.own = row;
    return size;
  }

  [[nodiscard]] PartUse use_of(const char* slot, int row, Missing& missing) const {
    const double mass = FigureReader(pulleys_, row, missing)(pulley_mass);
    return {slot, Family::pulleys, row, 1.0, 0.0, prices_.line(pulleys_, row, 1.0, 0.0), mass};
  }

  void add_idler(int row) {
    Missing missing;
    const auto readings = std::array{FigureReader(pulleys_, row, missing)("inertia")};
    CandidateDraft candidate = candidate_of({use_of("pulley_idle", row, missing)}, 0.0);
    const PulleySize size = size_of(row, false, missing);
    if (!result_.idlers.admits(candidate, readings, missing, size.diameter)) return;
    if (pulleys_.has_ranges())
      candidate.ranges = candidate_ranges(std::array{pulleys_.range(column(Family::pulleys, "inertia"), row)},
                                          candidate.price,
                                          {},
                                          pulleys_.range(pulley_mass, row));
    result_.idlers.add(std::move(candidate), readings);
    result_.idlers_fit.push_back(idlers_.number_of(size));
  }

  /// `second`: the row of the piece at the far end, or nothing.
  void add_pulley(int row, std::optional<int> second = std::nullopt) {
    constexpr catalogue::Column inertia = column(Family::pulleys, "inertia");
    const auto readings_of = [&](auto figure) {
      using T = decltype(figure(inertia, row));
      return std::array<T, BeltTables::pulley_fields>{figure(inertia, row),
                                                      figure(column(Family::pulleys, "bore"), row),
                                                      second ? figure(inertia, *second) : T(0.0)};
    };
    const auto range = [&](catalogue::Column figure, int of) { return pulleys_.range(figure, of); };
    Missing missing;
    const auto readings =
        readings_of([&](catalogue::Column figure, int of) { return FigureReader(pulleys_, of, missing)(figure); });
    std::vector<PartUse> parts{use_of("pulley_drive", row, missing)};
    if (second) parts.push_back(use_of("pulley_idle", *second, missing));
    CandidateDraft candidate = candidate_of(std::move(parts), 0.0);
    const PulleySize size = size_of(row, true, missing);
    if (!result_.pulleys.admits(candidate, readings, missing, size.diameter + size.teeth)) return;
    if (pulleys_.has_ranges())
      candidate.ranges =
          candidate_ranges(readings_of(range),
                           candidate.price,
                           {},
                           range(pulley_mass, row) + (second ? range(pulley_mass, *second) : scalar::Interval(0.0)));
    result_.pulleys.add(std::move(candidate), readings);
    result_.pulley_fits.push_back({drives_.number_of(size), second ? BeltFit::same : BeltFit::none});
  }

  /// Once more on a bearing, whoever sells the second one.
  void add_pulleys_with_second() {
    std::map<std::pair<std::string_view, std::string_view>, std::vector<int>> same;
    for (const int row : pulleys_.rows_in_order())
      if (!is_idler(row)) same[{pulleys_.manufacturer(row), pulleys_.part_number(row)}].push_back(row);
    for (const int row : pulleys_.rows_in_order())
      if (!is_idler(row))
        for (const int second : same[{pulleys_.manufacturer(row), pulleys_.part_number(row)}]) add_pulley(row, second);
  }

  void add_belt(int row) {
    const std::string_view profile = belts_.text(column(Family::belts, "profile"), row);
    const double width = belts_.number(column(Family::belts, "width"), row);
    const auto runs = [&](const PulleySize& size) {
      return size.profile == profile && std::abs(size.belt_width - width) < 1e-6;
    };
    for (std::size_t drive = 0; drive < drives_.sizes().size(); ++drive) {
      const PulleySize& size = drives_.sizes()[drive];
      if (!runs(size)) continue;
      add_belt(row, size, size, {static_cast<std::int32_t>(drive), BeltFit::same});
      for (std::size_t idler = 0; idler < idlers_.sizes().size(); ++idler)
        if (runs(idlers_.sizes()[idler]))
          add_belt(
              row, size, idlers_.sizes()[idler], {static_cast<std::int32_t>(drive), static_cast<std::int32_t>(idler)});
    }
  }

  void add_belt(int row, const PulleySize& drive, const PulleySize& idler, BeltFit fit) {
    const double width = belts_.number(column(Family::belts, "width"), row);
    Missing missing;
    const auto readings =
        belt_readings(span_, width, drive.teeth, drive.diameter, idler.diameter, FigureReader(belts_, row, missing));
    const double length = readings[BeltTables::belt_length];
    // The belt moves with the carriage (a reading of the drive) and hangs on the parent (its standing mass).
    CandidateDraft candidate = candidate_of({{"belt",
                                              Family::belts,
                                              row,
                                              1.0,
                                              length,
                                              prices_.cut(belts_, row, {{1.0, length}}),
                                              readings[BeltTables::belt_mass]}},
                                            0.0);
    // By numbers of sizes: figures may differ between versions of a machine.
    candidate.form = fmt::format("{} {}", fit.drive, fit.idler);
    if (!result_.belts.admits(candidate, readings, missing)) return;
    if (belts_.has_ranges() || pulleys_.has_ranges()) {
      const auto ranges = belt_readings(
          span_, width, scalar::Interval(drive.teeth), drive.range, idler.range, [&](catalogue::Column figure) {
            return belts_.range(figure, row);
          });
      candidate.ranges = candidate_ranges(ranges, candidate.price, {}, ranges[BeltTables::belt_mass]);
    }
    result_.belts.add(std::move(candidate), readings);
    result_.belt_fits.push_back(fit);
  }

  void leave_out_what_no_belt_needs() {
    std::set<std::pair<std::int32_t, bool>> pulleys;
    std::set<std::int32_t> idlers{BeltFit::same};
    for (const BeltFit& fit : result_.belt_fits) {
      pulleys.insert({fit.drive, fit.idler == BeltFit::same});
      idlers.insert(fit.idler);
    }
    const auto keep = [](auto& fits, SlotTable& table, auto&& is_needed) {
      table.filter([&](std::size_t row) { return is_needed(fits[row]); });
      std::erase_if(fits, [&](const auto& fit) { return !is_needed(fit); });
    };
    keep(result_.pulley_fits, result_.pulleys, [&](const BeltFit& fit) {
      return pulleys.contains({fit.drive, fit.idler == BeltFit::same});
    });
    keep(result_.idlers_fit, result_.idlers, [&](std::int32_t fit) { return idlers.contains(fit); });
  }

  const Table& belts_;
  const Table& pulleys_;
  const machine::Axis& axis_;
  const PriceBook& prices_;
  double span_;  ///< m
  PulleySizes drives_, idlers_;
  BeltTables result_;
};

}  // namespace

scalar::Interval BeltTables::kinds(std::span<const solver::Row> some_belts,
                                   std::span<const solver::Row> some_pulleys,
                                   std::span<const solver::Row> some_idlers) const {
  constexpr std::size_t many = 64;
  scalar::Interval result(1.0);
  const auto add = [&](std::span<const solver::Row> others, auto&& go_together) {
    bool never = true, always = true;
    if (some_belts.size() * others.size() > many)
      never = always = false;
    else
      for (const solver::Row belt : some_belts)
        for (const solver::Row other : others) (go_together(belt, other) ? never : always) = false;
    result.lower += never ? 1.0 : 0.0;
    result.upper += always ? 0.0 : 1.0;
  };
  add(some_pulleys, [&](solver::Row belt, solver::Row pulley) { return runs(belt, pulley); });
  add(some_idlers, [&](solver::Row belt, solver::Row idler) { return turns(belt, idler); });
  return result;
}

BeltTables belt_tables(const catalogue::Catalogue& catalogue, const machine::Axis& axis, const PriceBook& prices) {
  return BeltTablesMaker(catalogue, axis, prices).make();
}

}  // namespace millwright::evaluation
