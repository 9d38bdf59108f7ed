// SPDX-License-Identifier: Apache-2.0
#include "evaluation/driver_choices.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include "evaluation/figure_reader.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;

namespace {

/// What one driver has to be better by to make up for what does not count: less is a tie to who compares builds, and a
/// rate of exchange may be off by a rounding.
constexpr double clearly = 1.0 - 1e-9;

constexpr double rounded = 1.011;  // 2.8 A and 4 A, 1.4 A and 2 A

}  // namespace

double largest_amplitude(double peak_current, double rms_current) {
  const double sine = std::sqrt(2.0) * rms_current;
  return peak_current > rounded * sine ? sine : peak_current;
}

scalar::Interval largest_amplitude(const scalar::Interval& peak_current, const scalar::Interval& rms_current) {
  if (!std::isfinite(rms_current.lower)) return peak_current;  // not stated
  const scalar::Interval sine = std::sqrt(2.0) * rms_current;
  const bool may_limit = peak_current.upper > rounded * sine.lower;
  const bool may_say_the_same = peak_current.lower <= rounded * sine.upper;
  return {may_limit ? std::min(peak_current.lower, sine.lower) : peak_current.lower,
          std::min(peak_current.upper, (may_say_the_same ? rounded : 1.0) * sine.upper)};
}

double largest_amplitude(const catalogue::Table& drivers, int row) {
  return largest_amplitude(drivers.number(column(Family::drivers, "peak_current"), row),
                           drivers.number(column(Family::drivers, "rms_current"), row));
}

DriverChoices::DriverChoices(const catalogue::Table& drivers,
                             const machine::Axis& axis,
                             const std::vector<double>& voltages,
                             const PriceBook& prices)
    : axis_(axis), voltages_(voltages), voltage_factor_(axis.require(machine::Requirement::driver_voltage_factor)) {
  // Of a dear light one and a cheap heavy one each would be the better.
  if (!axis.cost_counts && !axis.mass_counts) throw std::logic_error("neither cost nor mass counts");
  const catalogue::Table& t = drivers;
  for (const int row : t.rows_in_order()) {
    if (t.flag(column(Family::drivers, "closed_loop"), row).value_or(false)) continue;  // needs a motor with an encoder
    std::vector<catalogue::Column> missing;
    const FigureReader number(t, row, missing);
    const double microsteps = number(column(Family::drivers, "maximum_microsteps"));
    number(column(Family::drivers, "peak_current"));  // of which the amplitude is made
    if (microsteps < axis.motor.microsteps) continue;
    const Driver d{row,
                   drivers_.size(),
                   largest_amplitude(t, row),
                   number(column(Family::drivers, "maximum_voltage")),
                   number(column(Family::drivers, "minimum_voltage")),
                   prices.line(t, row, 1.0, 0.0),
                   number(column(Family::drivers, "mass")),
                   prices.preference(t, row),
                   prices.charging_supplier(t, row)};
    const bool is_known =
        !std::isnan(microsteps + d.peak_current + d.largest_voltage + d.least_voltage + d.price + d.mass);
    is_known ? drivers_.push_back(d) : incomplete_.push_back({{Family::drivers, row}, std::move(missing)});
  }
  find_cheapest(drivers);
}

/// Who sells each of them for least; of equals the first.
void DriverChoices::find_cheapest(const catalogue::Table& drivers) {
  std::map<std::pair<std::string_view, std::string_view>, Driver*> cheapest;
  for (Driver& driver : drivers_) {
    const auto [place, is_new] =
        cheapest.try_emplace({drivers.manufacturer(driver.row), drivers.part_number(driver.row)}, &driver);
    if (is_new) continue;
    const bool cheaper = driver.price < place->second->price;
    (cheaper ? place->second : &driver)->is_cheapest = false;
    if (cheaper) place->second = &driver;
  }
}

bool DriverChoices::runs_at(const Driver& driver, double voltage) const {
  return driver.least_voltage <= voltage && voltage <= voltage_factor_ * driver.largest_voltage;
}

/// b is never better than a at this current: it gives the same, and is at least as dear, as heavy and as fussy about
/// the voltage, as far as that counts.
bool DriverChoices::covers(const Driver& a, const Driver& b, double current) const {
  if (a.row == b.row) return false;
  if (std::min(a.peak_current, current) != std::min(b.peak_current, current)) return false;
  const double worth_a = a.preference * a.price, worth_b = b.preference * b.price;
  const bool dearer = a.price > b.price || worth_a > worth_b;
  if (dearer && (axis_.cost_counts || !(a.mass < clearly * b.mass))) return false;
  if (a.mass > b.mass && (axis_.mass_counts || !(worth_a < clearly * worth_b))) return false;
  // An order more is not for nothing, and what is bought may help to reach a minimum.
  if (a.supplier != nullptr && a.supplier != b.supplier) return false;
  if (axis_.keep_covered_candidates && (a.supplier != b.supplier || !a.is_cheapest)) return false;
  if (b.supplier != nullptr && b.supplier->minimum_order > 0.0) return false;
  for (const double v : voltages_)
    if (runs_at(b, v) && !runs_at(a, v)) return false;
  return worth_a < worth_b || a.price < b.price || a.mass < b.mass || a.place < b.place;
}

bool DriverChoices::gives(const Driver& driver, double current) const {
  const std::vector<double>& stated = axis_.motor.driver_currents;
  return current <= (stated.empty() ? driver.peak_current : stated[static_cast<std::size_t>(driver.row)]);
}

/// No check holds a current that is set: what the driver does not give is never chosen. A driver that a bill names is
/// judged where it gives none of them (C-DR-CURRENT), and so is a whole build that is given.
bool DriverChoices::can_be_set(const Driver& driver, double current) const {
  const std::vector<double>& currents = axis_.motor.currents;
  if (currents.empty() || gives(driver, current)) return true;
  return axis_.keep_every_candidate &&
         !(axis_.motor.given_driver &&
           std::any_of(currents.begin(), currents.end(), [&](double other) { return gives(driver, other); }));
}

/// A driver that a bill names is judged, not passed over (C-DR-VOLT, F-DRIVER-VOLTAGE-MIN).
bool DriverChoices::possible(const Driver& driver, double current) const {
  if (!can_be_set(driver, current)) return false;
  if (axis_.keep_every_candidate || axis_.keep_every_driver) return true;
  return std::any_of(voltages_.begin(), voltages_.end(), [&](double v) { return runs_at(driver, v); });
}

const DriverChoices::Choice& DriverChoices::at(double current) {
  const auto [place, is_new] = choices_.try_emplace(current);
  if (is_new) place->second = choice_at(current);
  return place->second;
}

DriverChoices::Choice DriverChoices::choice_at(double current) const {
  Choice choice;
  for (const Driver& driver : drivers_)
    if (possible(driver, current)) choice.kept.push_back(&driver);
  if (axis_.keep_every_candidate || axis_.keep_every_driver) return choice;
  drop_covered(choice.kept, axis_.keep_covered_candidates ? axis_.most_covering : 1, current);
  if (!axis_.keep_covered_candidates) return choice;
  for (const Driver* driver : choice.kept) {
    choice.covered_by.emplace_back();
    for (std::size_t k = 0; k < choice.kept.size(); ++k)
      if (covers(*choice.kept[k], *driver, current)) choice.covered_by.back().push_back(k);
  }
  return choice;
}

/// Drops what so many others cover. One that covers another comes before it in the order taken, and what covers the one
/// covers the other. So of those that cover a driver the first so many are kept themselves: it has to be compared with
/// those kept so far only.
void DriverChoices::drop_covered(std::vector<const Driver*>& drivers, std::size_t most, double current) const {
  if (most > drivers.size()) return;
  const auto key = [&](const Driver* d) {
    return std::tuple(axis_.cost_counts ? 0.0 : d->mass, d->price, d->preference * d->price, d->mass, d->place);
  };
  std::sort(drivers.begin(), drivers.end(), [&](const Driver* a, const Driver* b) { return key(a) < key(b); });
  std::vector<const Driver*> kept;
  for (const Driver* driver : drivers) {
    std::size_t covering = 0;
    for (auto a = kept.begin(); a != kept.end() && covering < most; ++a)
      if (covers(**a, *driver, current)) ++covering;
    if (covering < most) kept.push_back(driver);
  }
  std::sort(kept.begin(), kept.end(), [](const Driver* a, const Driver* b) { return a->place < b->place; });
  drivers = std::move(kept);
}

}  // namespace millwright::evaluation
