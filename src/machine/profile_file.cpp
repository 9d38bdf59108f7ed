// SPDX-License-Identifier: Apache-2.0
//
// A measured profile: a CSV file with a time, a position or a speed, and maybe a force, units in its header.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "scalar/unit.h"
#include "text/csv.h"
#include "text/nearest.h"

namespace millwright::machine {

using text::CsvColumn;
using text::CsvTable;
using text::Diagnostics;
using text::Node;

namespace {

constexpr std::size_t least_samples = 3;
constexpr double least_step = 1e-9;  // s

/// A column of a recording, and the unit that is expected of it.
struct ColumnQuantity {
  std::string name, unit;
};

class ProfileReader {
 public:
  ProfileReader(const CsvTable& table, bool rotary, Diagnostics& diagnostics)
      : table_(table), rotary_(rotary), diagnostics_(diagnostics) {}

  std::optional<MeasuredProfile> read() {
    if (!find_columns()) return std::nullopt;
    if (table_.row_count() < least_samples) {
      diagnostics_.error(
          table_.header_span(),
          fmt::format("the profile has {} sample{}", table_.row_count(), table_.row_count() == 1 ? "" : "s"),
          "a motion takes at least 3: where it starts, where it is fast, where it ends");
      return std::nullopt;
    }
    const std::size_t before = diagnostics_.error_count();
    const std::vector<double> times = column(time_);
    const std::vector<double> motion = column(position_.known() ? position_ : speed_);
    const std::vector<double> forces = force_.known() ? column(force_) : std::vector<double>();
    if (diagnostics_.error_count() > before || !ascending(times)) return std::nullopt;
    const std::vector<double> speeds = position_.known() ? speeds_of_positions(times, motion) : motion;
    if (!usual(speeds)) return std::nullopt;
    MeasuredProfile profile = measured_profile(times, speeds, forces);
    if (position_.known()) {
      const auto [lowest, highest] = std::minmax_element(motion.begin(), motion.end());
      profile.extent = *highest - *lowest;
    }
    if (!gets_going(profile)) return std::nullopt;
    warn_of_motion_at_ends(speeds, profile.peak_speed);
    return profile;
  }

 private:
  struct Found {
    ColumnQuantity quantity;
    std::optional<std::size_t> place = std::nullopt;
    scalar::Unit unit = {};
    [[nodiscard]] bool known() const { return place.has_value(); }
  };

  /// "time [s]"
  static std::string header_cell(const Found& found) {
    return fmt::format("{} [{}]", found.quantity.name, found.quantity.unit);
  }

  bool find_columns() {
    bool good = true;
    Found* const all[] = {&time_, &position_, &speed_, &force_};
    std::vector<std::string> names;
    for (const Found* each : all) names.push_back(each->quantity.name);
    for (std::size_t i = 0; i < table_.columns().size(); ++i) {
      const CsvColumn& header = table_.columns()[i];
      const auto match =
          std::find_if(std::begin(all), std::end(all), [&](const Found* f) { return f->quantity.name == header.name; });
      if (match != std::end(all)) {
        good = take(i, **match) && good;
        continue;
      }
      diagnostics_.error(header.name_span,
                         fmt::format("a profile has no column {}", text::in_quotes(header.name)),
                         text::did_you_mean(header.name, names, fmt::format("columns: {}", fmt::join(names, ", "))));
      good = false;
    }
    return good && complete();
  }

  bool complete() {
    if (!time_.known())
      diagnostics_.error(
          table_.header_span(),
          "the profile has no column 'time'",
          fmt::format("the header is {},{},{}", header_cell(time_), header_cell(speed_), header_cell(force_)));
    if (!position_.known() && !speed_.known())
      diagnostics_.error(
          table_.header_span(),
          fmt::format("the profile has no column '{}' or '{}'", position_.quantity.name, speed_.quantity.name),
          fmt::format("the header is {},{},{}", header_cell(time_), header_cell(speed_), header_cell(force_)));
    if (position_.known() && speed_.known())
      diagnostics_.error(
          table_.columns()[*speed_.place].name_span,
          fmt::format("the profile has both '{}' and '{}'", position_.quantity.name, speed_.quantity.name),
          "leave one out: the better measured one stays");
    return time_.known() && position_.known() != speed_.known();
  }

  bool take(std::size_t place, Found& found) {
    const CsvColumn& header = table_.columns()[place];
    found.place = place;
    std::string reason = "the column has no unit";
    const auto unit = header.unit ? scalar::Unit::parse(*header.unit, reason) : std::nullopt;
    if (unit && unit->fits(scalar::Unit::of(found.quantity.unit), reason)) {
      found.unit = *unit;
      return true;
    }
    diagnostics_.error(header.unit ? header.unit_span : header.name_span,
                       fmt::format("{}: {}", header.name, reason),
                       fmt::format("write {}", header_cell(found)));
    return false;
  }

  /// A column in SI; the first empty cell is reported, and every one that is no number.
  std::vector<double> column(const Found& found) {
    const std::size_t before = diagnostics_.error_count();
    std::vector<double> values = table_.number_column(*found.place, diagnostics_);
    if (diagnostics_.error_count() > before) return values;
    const UsualValues limits = usual_values(found.quantity.unit);
    for (std::size_t row = 0; row < values.size(); ++row) {
      const double value = found.unit.to_si(values[row]);
      QuantityFault fault;
      if (std::isnan(value)) {
        fault.message = "the cell is empty";
        fault.hint = "every sample has all its values; leave out the row, or the column";
      } else if (std::abs(value) <= limits.largest || check_magnitude(value, found.quantity.unit, Sign::any, fault)) {
        values[row] = value;
        continue;
      }
      diagnostics_.error(
          table_.cell_span(row, *found.place), fmt::format("{}: {}", found.quantity.name, fault.message), fault.hint);
      break;
    }
    return values;
  }

  bool ascending(const std::vector<double>& times) {
    for (std::size_t row = 1; row < times.size(); ++row) {
      if (times[row] - times[row - 1] >= least_step) continue;
      diagnostics_.error(table_.cell_span(row, *time_.place),
                         times[row] > times[row - 1] ? "time: less than 1 ns after the sample before"
                                                     : "time: not after the sample before",
                         "samples are in the order of their times, each later than the one before");
      return false;
    }
    return true;
  }

  /// Differences of positions may be faster than any machine though no position is out of the world.
  bool usual(const std::vector<double>& speeds) {
    for (std::size_t row = 0; row < speeds.size(); ++row) {
      QuantityFault fault;
      if (check_magnitude(speeds[row], speed_.quantity.unit, Sign::any, fault)) continue;
      diagnostics_.error(table_.row_span(row),
                         fmt::format("the speed at this sample is {}", fault.message),
                         "are the units of time and position right?");
      return false;
    }
    return true;
  }

  /// What brings the axis to the first speed and what stops it from the last one is in no force of the recording. A log
  /// of positions has a little speed where it stands.
  void warn_of_motion_at_ends(const std::vector<double>& speeds, double peak_speed) {
    constexpr double noise = 0.02;
    const auto warn = [&](std::size_t row, const char* words, const char* missing) {
      if (std::abs(speeds[row]) <= noise * peak_speed) return;
      diagnostics_.warning(
          table_.row_span(row),
          fmt::format("the recording {} in motion, at {:.3g} % of its largest speed: what {} the axis is in no torque",
                      words,
                      100.0 * std::abs(speeds[row]) / peak_speed,
                      missing),
          "record from standstill to standstill, with a few samples at rest");
    };
    warn(0, "begins", "starts");
    warn(speeds.size() - 1, "ends", "stops");
  }

  bool gets_going(const MeasuredProfile& profile) {
    if (profile.phases.empty()) {
      diagnostics_.error(table_.header_span(), "nothing moves in the profile", "record a motion, not a standstill");
      return false;
    }
    const double least = 1e-9 * profile.peak_speed / profile.time;
    if (std::any_of(profile.phases.begin(), profile.phases.end(), [&](const ProfilePhase& phase) {
          return phase.acceleration > least;
        }))
      return true;
    diagnostics_.error(table_.header_span(),
                       "nothing gets faster in the profile",
                       "record the motion from standstill on, with its ramp up");
    return false;
  }

  const CsvTable& table_;
  bool rotary_;
  Diagnostics& diagnostics_;
  Found time_{{"time", "s"}};
  Found position_{rotary_ ? ColumnQuantity{"angle", "deg"} : ColumnQuantity{"position", "mm"}};
  Found speed_{rotary_ ? ColumnQuantity{"speed", "rpm"} : ColumnQuantity{"speed", "mm/s"}};
  Found force_{rotary_ ? ColumnQuantity{"torque", "N.m"} : ColumnQuantity{"force", "N"}};
};

}  // namespace

std::optional<MeasuredProfile> read_profile(const Node& node,
                                            bool rotary,
                                            const std::filesystem::path& folder,
                                            Diagnostics& diagnostics) {
  const auto name = node.as_string();
  if (!name || name->empty()) {
    diagnostics.error(node.span(),
                      fmt::format("profile: {} where the name of a file is needed",
                                  name ? "an empty text" : text::describe(node.kind())),
                      "write profile = \"profile.csv\", beside the problem file");
    return std::nullopt;
  }
  Diagnostics loading;
  const auto source = text::SourceText::load((folder / *name).string(), loading);
  if (source == nullptr) {
    for (const text::Diagnostic& each : loading.all())
      diagnostics.error(node.span(),
                        fmt::format("profile: {} {}", text::in_quotes((folder / *name).string(), 100), each.message),
                        each.hint.empty() ? "the name is relative to the folder of the problem file" : each.hint);
    return std::nullopt;
  }
  const std::size_t before = diagnostics.error_count();
  const CsvTable table = text::read_csv(source, diagnostics);
  if (diagnostics.error_count() > before) return std::nullopt;
  if (table.columns().empty()) {
    diagnostics.error(text::whole(source), "the profile is empty", "the header is time [s],speed [mm/s]");
    return std::nullopt;
  }
  return ProfileReader(table, rotary, diagnostics).read();
}

}  // namespace millwright::machine
