// SPDX-License-Identifier: Apache-2.0
//
// The drivers of the catalogue that are worth keeping for motors of an axis. Drivers that give a motor the same current
// differ only in price, mass and the voltages they bear: those that are dearer or heavier than another that bears at
// least the same voltages are left out, or marked as covered by it (and left out where as many cover it as builds are
// asked for). Where nothing that is asked reads the total mass (Axis::mass_counts), the cheaper one is the better one,
// and the mass decides only between equals; and the other way round.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/price_book.h"
#include "evaluation/slot_table.h"
#include "machine/problem.h"
#include "scalar/interval.h"

namespace millwright::evaluation {

/// Largest amplitude of the current that a driver gives [A]: its peak current or, where that is less, the peak of a
/// sine of its greatest RMS current; NaN where no peak current is stated. Makers round both figures: as long as they
/// say the same within about a hundredth (1.1 %: 1.4 A and 2 A) the peak current counts.
double largest_amplitude(double peak_current, double rms_current);
/// Every such amplitude.
scalar::Interval largest_amplitude(const scalar::Interval& peak_current, const scalar::Interval& rms_current);
/// Of a row of the catalogue.
double largest_amplitude(const catalogue::Table& drivers, int row);

struct Driver {
  int row;
  std::size_t place;  ///< in the order of rows (Table::rows_in_order)
  double peak_current, largest_voltage, least_voltage, price, mass;
  double preference = 1.0;                        ///< of its price, where builds are compared
  const catalogue::Supplier* supplier = nullptr;  ///< where an order costs more than the driver
  bool is_cheapest = true;                        ///< of those who sell it
};

class DriverChoices {
 public:
  /// Axis and voltages have to outlive it.
  DriverChoices(const catalogue::Table& drivers,
                const machine::Axis& axis,
                const std::vector<double>& voltages,
                const PriceBook& prices);

  struct Choice {
    std::vector<const Driver*> kept;                   ///< by their places
    std::vector<std::vector<std::size_t>> covered_by;  ///< [kept], where covered ones are kept; else empty
  };
  /// For motors that this current [A] is set for; found once, since most motors have the current of some other one.
  const Choice& at(double current);

  /// Rows of drivers that lack a figure that a check reads, or a price.
  [[nodiscard]] std::span<const IncompleteRow> incomplete() const { return incomplete_; }
  /// Whether a driver bears this voltage [V].
  [[nodiscard]] bool runs_at(const Driver& driver, double voltage) const;

 private:
  [[nodiscard]] bool covers(const Driver& a, const Driver& b, double current) const;
  void find_cheapest(const catalogue::Table& drivers);
  /// Of the currents that are listed.
  [[nodiscard]] bool gives(const Driver& driver, double current) const;
  [[nodiscard]] bool can_be_set(const Driver& driver, double current) const;
  [[nodiscard]] bool possible(const Driver& driver, double current) const;
  [[nodiscard]] Choice choice_at(double current) const;
  void drop_covered(std::vector<const Driver*>& drivers, std::size_t most, double current) const;

  const machine::Axis& axis_;
  const std::vector<double>& voltages_;
  double voltage_factor_;
  std::vector<Driver> drivers_;
  std::vector<IncompleteRow> incomplete_;
  std::map<double, Choice> choices_;  ///< [current]
};

}  // namespace millwright::evaluation
