// SPDX-License-Identifier: Apache-2.0
//
// The machine's power supply: the last stage. It must have the voltage that all drives were computed with and power for
// all of them.
#pragma once

#include <string>
#include <utility>

#include "evaluation/element_stage.h"
#include "evaluation/price_book.h"
#include "machine/motor_constraints.h"

namespace millwright::evaluation {

struct SupplyData {
  machine::Requirements require;
  double reserve = 1.0;
};

template <class T>
struct Supply {
  const SupplyData* data = nullptr;
  T demanded_power{};  ///< W, with reserve
  T rated_power{};
  T voltage{}, required_voltage{};
  // What only soft checks read, and the search therefore does not fill in.
  std::vector<T> motor_currents{};  ///< A, rated, of all motors; whoever knows the motors fills it in
  T rated_current{};
  std::vector<std::pair<std::string, double>> drive_powers{};  ///< W, by axis; the same holds
};

template <class Visit>
void supply_constraints(Visit&& visit) {
  using machine::always;
  using machine::Declaration;
  visit(
      Declaration{.id = "C-PSU-POWER",
                  .title = "Supply power",
                  .symbol = "P",
                  .unit = "W",
                  .source = "millwright_derivations, sum of the drive input powers",
                  .requirement = "supply_reserve"},
      always,
      [](const auto& d) { return d.demanded_power; },
      [](const auto& d) { return d.rated_power; });
  visit(
      Declaration{.id = "C-PSU-CURRENT",
                  .title = "Supply current, rule of two thirds of the motors' rated currents",
                  .symbol = "I",
                  .unit = "A",
                  .kind = machine::ConstraintKind::soft,
                  .source = "gecko_step_motor_basics"},
      always,
      [](const auto& d) { return mechanics::stepper::supply_current(std::span(std::as_const(d.motor_currents))); },
      [](const auto& d) { return d.rated_current; });
  visit(
      Declaration{.id = "F-SUPPLY-VOLTAGE",
                  .title = "Supply gives the voltage of the drives",
                  .symbol = "V",
                  .unit = "V",
                  .kind = machine::ConstraintKind::fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.required_voltage; },
      [](const auto& d) { return d.voltage; });
  visit(
      Declaration{.id = "F-SUPPLY-VOLTAGE-MAX",
                  .title = "Supply does not exceed the voltage of the drives",
                  .symbol = "V",
                  .unit = "V",
                  .kind = machine::ConstraintKind::fit,
                  .source = "millwright_derivations, fits of parts"},
      always,
      [](const auto& d) { return d.voltage; },
      [](const auto& d) { return d.required_voltage; });
}

class SupplyStage final : public ElementStage<SupplyStage> {
 public:
  SupplyStage(const std::vector<double>& voltages,
              SupplyData data,
              const catalogue::Catalogue& catalogue,
              const PriceBook& prices);

  template <class T>
  [[nodiscard]] Supply<T> design(const Selection<T>& selection) const;
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;

 private:
  std::vector<double> voltages_;
  SupplyData data_;
};

extern template Supply<double> SupplyStage::design(const Selection<double>&) const;

extern template class ElementStage<SupplyStage>;

}  // namespace millwright::evaluation
