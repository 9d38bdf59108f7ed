// SPDX-License-Identifier: Apache-2.0
#include "evaluation/motor_shortage.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "evaluation/driver_choices.h"
#include "machine/word_column.h"
#include "scalar/unit.h"

namespace millwright::evaluation {

namespace {

using catalogue::Family;

std::string in_unit(double value, const char* unit) { return scalar::format(value, scalar::Unit::of(unit), 4); }

/// "NEMA17 or NEMA23"; empty for none.
std::string either(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, " or ")); }

std::string volts(const std::vector<double>& voltages) {
  std::vector<std::string> words;
  for (const double v : voltages) words.push_back(in_unit(v, "V"));
  return either(words);
}

/// Leaves those that fit; true if any does.
template <class Fits>
bool narrow(std::vector<int>& rows, Fits&& fits) {
  std::erase_if(rows, [&](int row) { return !fits(row); });
  return !rows.empty();
}

/// Why no driver is left, asked one after the other; empty where some is.
std::string driver_shortage(const catalogue::Table& drivers,
                            const machine::Axis& axis,
                            const std::vector<double>& voltages) {
  std::vector<int> rows;
  for (int row = 0; row < drivers.rows(); ++row)
    if (!drivers.flag(catalogue::column(Family::drivers, "closed_loop"), row).value_or(false)) rows.push_back(row);
  if (rows.empty()) return "the catalogues have no driver for motors without an encoder";
  const auto most = [&](const char* name, const std::vector<int>& of) {
    double result = 0.0;
    for (const int row : of) result = std::max(result, drivers.number(name, row));
    return result;
  };
  const std::vector<int> all = rows;
  if (!narrow(rows, [&](int row) { return drivers.number("maximum_microsteps", row) >= axis.motor.microsteps; }))
    return fmt::format("no driver makes {:.6g} microsteps of a step, those of the catalogues make {:.6g} at most",
                       axis.motor.microsteps,
                       most("maximum_microsteps", all));
  const double factor = axis.require(machine::Requirement::driver_voltage_factor);
  double least = std::numeric_limits<double>::infinity();
  for (const int row : rows) least = std::min(least, drivers.number("minimum_voltage", row));
  const std::string range = fmt::format("those that do what is asked otherwise take {} to {}",
                                        in_unit(least, "V"),
                                        in_unit(factor * most("maximum_voltage", rows), "V"));
  const auto runs = [&](int row) {
    return std::any_of(voltages.begin(), voltages.end(), [&](double v) {
      return drivers.number("minimum_voltage", row) <= v && v <= factor * drivers.number("maximum_voltage", row);
    });
  };
  if (!narrow(rows, runs)) return fmt::format("no driver runs at the supply's {}: {}", volts(voltages), range);
  const std::vector<double>& currents = axis.motor.currents;
  const double smallest = currents.empty() ? 0.0 : *std::min_element(currents.begin(), currents.end());
  const std::vector<int> running = rows;
  double most_current = 0.0;
  for (const int row : running) most_current = std::max(most_current, largest_amplitude(drivers, row));
  if (!narrow(rows, [&](int row) { return largest_amplitude(drivers, row) >= smallest; }))
    return fmt::format("no driver that runs at the supply's {} gives {}: {} at most",
                       volts(voltages),
                       in_unit(smallest, "A"),
                       in_unit(most_current, "A"));
  return {};
}

}  // namespace

MotorShortage motor_shortage(const catalogue::Catalogue& catalogue,
                             const machine::Axis& axis,
                             const std::vector<double>& voltages) {
  const catalogue::Table& motors = catalogue.table(Family::steppers);
  const std::vector<std::string>& frames = axis.motor.frames;
  bool any = false;
  for (int row = 0; row < motors.rows() && !any; ++row)
    any = machine::word_columns::motor_frame.takes(frames, motors, row);
  if (!any)
    return {"motor",
            frames.empty() ? "the catalogues have no motor" : fmt::format("the catalogues have no {}", either(frames))};
  if (std::string reason = driver_shortage(catalogue.table(Family::drivers), axis, voltages); !reason.empty())
    return {"driver", std::move(reason)};
  return {"motor", fmt::format("no catalogue row fits what axis '{}' asks of its motor and driver", axis.name)};
}

}  // namespace millwright::evaluation
