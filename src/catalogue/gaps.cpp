// SPDX-License-Identifier: Apache-2.0
#include "catalogue/gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <span>

#include "catalogue/column_unit.h"

namespace millwright::catalogue {
namespace {

/// Sizes that every builder meets. `sizes` in the column's declared unit; a size is there if a row of that kind lies
/// within a hundredth of it.
struct Series {
  Family family;
  std::string_view column;
  std::string_view kind;  ///< content of kind_of, "" = any
  std::string_view kind_of;
  std::string_view what;
  std::span<const double> sizes;
  std::string_view reason;
};

constexpr double frames[] = {20.3, 28.2, 35.4, 42.3, 57, 60, 86, 110};
constexpr double ball_screws[] = {8, 10, 12, 16, 20, 25, 32};
constexpr double trapezoidal[] = {8, 10, 12, 14, 16, 18, 20, 22, 24, 28, 30, 32};
constexpr double rails[] = {15, 20, 25, 30, 35};
constexpr double miniature_rails[] = {7, 9, 12, 15};
constexpr double shafts[] = {6, 8, 10, 12, 16, 20, 25, 30};
constexpr double supported_shafts[] = {12, 16, 20, 25, 30};
constexpr double profiles[] = {20, 30, 40, 45, 80};
constexpr double supplies[] = {12, 24, 36, 48, 60, 72};
constexpr double modules[] = {1, 1.5, 2, 2.5, 3, 4};
constexpr double fasteners[] = {3, 4, 5, 6, 8, 10, 12, 16, 20};
constexpr double journals[] = {5, 6, 8, 10, 12, 15, 17, 20, 25};

constexpr Series series[] = {
    {Family::steppers,
     "frame_size",
     "",
     "",
     "motors of frame",
     frames,
     "NEMA ICS 16: frames 8, 11, 14, 17, 23, 24, 34, 42"},
    {Family::ball_screws,
     "nominal_diameter",
     "",
     "",
     "ball screws of diameter",
     ball_screws,
     "ISO 3408-2, preferred diameters up to 32 mm"},
    {Family::lead_screws,
     "major_diameter",
     "trapezoidal 30deg",
     "thread_form",
     "trapezoidal screws of diameter",
     trapezoidal,
     "ISO 2904, up to 32 mm"},
    {Family::support_bearings,
     "bore",
     "fixed",
     "role",
     "fixed supports of bore",
     journals,
     "journals of ball screws of 8 to 32 mm"},
    {Family::support_bearings,
     "bore",
     "supported",
     "role",
     "floating supports of bore",
     journals,
     "journals of ball screws of 8 to 32 mm"},
    {Family::linear_guides, "size", "profile rail", "kind", "profile rails of size", rails, "ISO 12090-1"},
    {Family::linear_guides,
     "size",
     "profile rail miniature",
     "kind",
     "miniature rails of size",
     miniature_rails,
     "ISO 12090-2"},
    {Family::linear_guides,
     "size",
     "linear ball bush",
     "kind",
     "ball bushes for shafts of",
     shafts,
     "ISO 10285, series 3"},
    {Family::linear_guides,
     "size",
     "supported round rail",
     "kind",
     "supported round rails of",
     supported_shafts,
     "ISO 10285 shafts, from 12 mm on"},
    {Family::racks, "module", "", "", "racks of module", modules, "DIN 780-1, series I"},
    {Family::screws,
     "nominal_diameter",
     "8.8",
     "property_class",
     "screws of class 8.8, M",
     fasteners,
     "ISO 261 coarse"},
    {Family::screws,
     "nominal_diameter",
     "12.9",
     "property_class",
     "screws of class 12.9, M",
     fasteners,
     "ISO 261 coarse"},
    {Family::power_supplies,
     "output_voltage",
     "",
     "",
     "power supplies of",
     supplies,
     "usual supplies of stepper drivers, 12 to 72 V"},
    {Family::extrusions, "width", "", "", "profiles of series", profiles, "T-slot series 20, 30, 40, 45 and 80"},
};

struct Belt {
  std::string_view profile;
  double width;  ///< mm
};
constexpr Belt belts[] = {{"GT2", 6},
                          {"GT2", 9},
                          {"GT3-3M", 9},
                          {"GT3-5M", 15},
                          {"HTD3M", 9},
                          {"HTD3M", 15},
                          {"HTD5M", 9},
                          {"HTD5M", 15},
                          {"HTD5M", 25},
                          {"HTD8M", 20},
                          {"HTD8M", 30},
                          {"T5", 10},
                          {"T5", 16},
                          {"T10", 16},
                          {"T10", 25},
                          {"AT5", 10},
                          {"AT5", 16},
                          {"AT10", 25}};

double shown(const Table& table, std::string_view name, int row) {
  const Column of = column(table.family(), name);
  return display_unit(of).from_si(table.number(of, row));
}

/// The holding torque as a search takes it: with one phase on it is less than with both.
double torque_of_both_phases(const Table& motors, int row) {
  return shown(motors, "holding_torque", row) * (motors.number("phases_on", row) == 1.0 ? std::sqrt(2.0) : 1.0);
}

bool equal(double a, double b) { return std::abs(a - b) <= 0.01 * b; }

std::string list_of(const std::vector<std::string>& sizes) { return fmt::format("{}", fmt::join(sizes, ", ")); }

std::string number(double value) { return scalar::format_number(value, 4); }

class Search {
 public:
  explicit Search(const Catalogue& catalogue) : catalogue_(catalogue) {}

  std::vector<Gap> all() {
    for (const Series& each : series) in_series(each);
    belt_widths();
    nuts();
    screw_supports();
    couplings();
    drivers();
    curves();
    pulleys();
    pinions();
    std::stable_sort(gaps_.begin(), gaps_.end(), [](const Gap& a, const Gap& b) { return a.family < b.family; });
    return std::move(gaps_);
  }

 private:
  const Table& table(Family family) const { return catalogue_.table(family); }

  void add(Family family, std::string_view what, std::vector<std::string> sizes, std::string reason) {
    if (sizes.empty()) return;
    std::string missing = fmt::format("{} {}", what, list_of(sizes));
    gaps_.push_back({family, std::move(missing), std::move(sizes), std::move(reason)});
  }

  static bool any(const Table& table, const std::function<bool(int)>& holds) {
    for (int row = 0; row < table.rows(); ++row)
      if (holds(row)) return true;
    return false;
  }

  /// The different values of a column, ascending, in its declared unit.
  static std::vector<double> values(const Table& table, std::string_view name) {
    std::set<double> different;
    for (int row = 0; row < table.rows(); ++row) {
      const double value = shown(table, name, row);
      if (!std::isnan(value)) different.insert(std::round(value * 1e6) / 1e6);
    }
    return {different.begin(), different.end()};
  }

  void in_series(const Series& wanted) {
    const Table& rows = table(wanted.family);
    const std::string_view unit = declaration(column(wanted.family, wanted.column)).unit;
    std::vector<std::string> sizes;
    for (const double size : wanted.sizes) {
      const bool there = any(rows, [&](int row) {
        return equal(shown(rows, wanted.column, row), size) &&
               (wanted.kind.empty() || rows.text(wanted.kind_of, row) == wanted.kind);
      });
      if (!there) sizes.push_back(fmt::format("{} {}", number(size), unit));
    }
    add(wanted.family, wanted.what, std::move(sizes), std::string(wanted.reason));
  }

  void belt_widths() {
    const Table& rows = table(Family::belts);
    std::vector<std::string> sizes;
    for (const Belt& belt : belts) {
      const bool there = any(rows, [&](int row) {
        return rows.text("profile", row).starts_with(belt.profile) && equal(shown(rows, "width", row), belt.width);
      });
      if (!there) sizes.push_back(fmt::format("{} {} mm", belt.profile, number(belt.width)));
    }
    add(Family::belts, "belts", std::move(sizes), "ISO 13050 and DIN 7721 profiles in the widths that are sold most");
  }

  void nuts() {
    const Table& screws = table(Family::lead_screws);
    const Table& rows = table(Family::lead_nuts);
    std::set<std::string_view> served;
    for (int row = 0; row < rows.rows(); ++row) served.insert(rows.text("for_screw", row));
    std::vector<std::string> sizes;
    for (int screw = 0; screw < screws.rows(); ++screw) {
      if (!served.contains(screws.part_number(screw)) && !served.contains(screws.text("designation", screw)))
        sizes.emplace_back(screws.part_number(screw));
    }
    add(Family::lead_nuts, "nuts for", std::move(sizes), "lead screws of the catalogue that no nut runs on");
  }

  /// A journal is turned onto the screw: no wider than its root, and not so much thinner that it would be the weak
  /// spot.
  void screw_supports() {
    const Table& rows = table(Family::support_bearings);
    const auto of = [&](Family family, std::string_view diameter, std::string_view root, std::string_view role) {
      const Table& screws = table(family);
      std::set<std::pair<double, std::string>> lonely;
      for (int screw = 0; screw < screws.rows(); ++screw) {
        const double core = shown(screws, root, screw);
        const bool there = any(rows, [&](int row) {
          const double bore = shown(rows, "bore", row);
          return rows.text("role", row) == role && bore <= core * 1.0001 && bore >= 0.55 * core;
        });
        const double size = shown(screws, diameter, screw);
        if (!there) lonely.emplace(size, fmt::format("{} mm (core {} mm)", number(size), number(core)));
      }
      std::vector<std::string> sizes;
      for (const auto& [size, words] : lonely) sizes.push_back(words);
      add(Family::support_bearings,
          fmt::format("{} units for {} of", role, declaration(family).title),
          std::move(sizes),
          "no bore between 0.55 of the screw's core and the core");
    };
    for (const std::string_view role : {"fixed", "supported"}) {
      of(Family::ball_screws, "nominal_diameter", "root_diameter", role);
      of(Family::lead_screws, "major_diameter", "minor_diameter", role);
    }
  }

  void couplings() {
    const Table& rows = table(Family::couplings);
    const Table& bearings = table(Family::support_bearings);
    std::set<double> ends;
    for (int row = 0; row < bearings.rows(); ++row) {
      if (bearings.text("role", row) == "fixed") ends.insert(shown(bearings, "bore", row));
    }
    std::vector<std::string> pairs, weak;
    const Table& motors = table(Family::steppers);
    for (const double shaft : values(motors, "shaft_diameter")) {
      double torque = 0.0;
      for (int row = 0; row < motors.rows(); ++row) {
        if (equal(shown(motors, "shaft_diameter", row), shaft))
          torque = std::max(torque, torque_of_both_phases(motors, row));
      }
      for (const double end : ends) {
        if (end > 2.5 * shaft || shaft > 2.5 * end) continue;  // nobody joins these
        const auto fits = [&](int row) {
          return shown(rows, "minimum_bore", row) <= std::min(shaft, end) * 1.0001 &&
                 shown(rows, "maximum_bore", row) >= std::max(shaft, end) * 0.9999;
        };
        const std::string pair = fmt::format("{} on {} mm", number(shaft), number(end));
        if (!any(rows, fits)) {
          pairs.push_back(pair);
        } else if (!any(rows, [&](int row) { return fits(row) && shown(rows, "rated_torque", row) >= torque; })) {
          weak.push_back(fmt::format("{} ({} N.m)", pair, number(torque)));
        }
      }
    }
    add(Family::couplings,
        "couplings of bores",
        std::move(pairs),
        "motor shafts and fixed supports' journals that no coupling joins");
    add(Family::couplings,
        "strong enough couplings of bores",
        std::move(weak),
        "those there are bear less than the holding torque of the strongest motor of that shaft");
  }

  void drivers() {
    const Table& rows = table(Family::drivers);
    std::vector<std::string> currents;
    double greatest = 0.0;
    for (int row = 0; row < rows.rows(); ++row) greatest = std::max(greatest, shown(rows, "peak_current", row));
    for (const double current : values(table(Family::steppers), "rated_current")) {
      if (current > greatest * 1.0001) currents.push_back(number(current) + " A");
    }
    add(Family::drivers, "drivers of", std::move(currents), "rated currents of motors above every driver's peak");
    std::vector<std::string> voltages;
    for (const double voltage : supplies) {
      const bool there = any(rows, [&](int row) {
        return shown(rows, "minimum_voltage", row) <= voltage && shown(rows, "maximum_voltage", row) >= voltage;
      });
      if (!there) voltages.push_back(number(voltage) + " V");
    }
    add(Family::drivers, "drivers at", std::move(voltages), "usual supplies, 12 to 72 V");
  }

  void curves() {
    const Table& motors = table(Family::steppers);
    const Table& rows = table(Family::stepper_curves);
    std::set<std::pair<std::string_view, std::string_view>> known;
    for (int row = 0; row < rows.rows(); ++row) known.emplace(rows.manufacturer(row), rows.part_number(row));
    std::set<std::string> with, without;
    for (int motor = 0; motor < motors.rows(); ++motor) {
      (known.contains({motors.manufacturer(motor), motors.part_number(motor)}) ? with : without)
          .insert(std::string(motors.text("frame", motor)));
    }
    std::vector<std::string> missing;
    for (const std::string& frame : without)
      if (!with.contains(frame)) missing.push_back(frame);
    add(Family::stepper_curves,
        "torque curves of",
        std::move(missing),
        "no motor of the frame has a published curve, so its torque is a model's");
  }

  void pulleys() {
    const Table& rows = table(Family::pulleys);
    const Table& sold = table(Family::belts);
    std::set<std::string> lonely;
    for (int belt = 0; belt < sold.rows(); ++belt) {
      const std::string_view profile = sold.text("profile", belt);
      const auto same = [&](std::string_view other) {  // "HTD5M PU" and "GT2 steel core" run on HTD5M and GT2
        return profile == other || profile.starts_with(std::string(other) + " ");
      };
      const bool there = any(rows, [&](int row) {
        return same(rows.text("profile", row)) && shown(rows, "belt_width", row) >= shown(sold, "width", belt) * 0.99;
      });
      if (!there) lonely.insert(fmt::format("{} {} mm", profile, number(shown(sold, "width", belt))));
    }
    add(Family::pulleys, "pulleys for", {lonely.begin(), lonely.end()}, "belts of the catalogue that run on no pulley");
    bores(Family::pulleys, "pulleys of bore");
  }

  void pinions() {
    const Table& rows = table(Family::pinions);
    std::vector<std::string> missing;
    for (const double module : values(table(Family::racks), "module")) {
      if (!any(rows, [&](int row) { return equal(shown(rows, "module", row), module); }))
        missing.push_back(number(module) + " mm");
    }
    add(Family::pinions, "pinions of module", std::move(missing), "racks of the catalogue without a pinion");
    bores(Family::pinions, "pinions of bore");
  }

  void bores(Family family, std::string_view what) {
    const Table& rows = table(family);
    std::vector<std::string> missing;
    for (const double shaft : values(table(Family::steppers), "shaft_diameter")) {
      if (!any(rows, [&](int row) { return equal(shown(rows, "bore", row), shaft); }))
        missing.push_back(number(shaft) + " mm");
    }
    add(family, what, std::move(missing), "shafts of motors of the catalogue");
  }

  const Catalogue& catalogue_;
  std::vector<Gap> gaps_;
};

}  // namespace

std::vector<Gap> find_gaps(const Catalogue& catalogue) { return Search(catalogue).all(); }

}  // namespace millwright::catalogue
