// SPDX-License-Identifier: Apache-2.0
//
// A stage of which some slots may only take certain rows and some variables are held: what `check` does with the parts
// it is given.
#pragma once

#include <optional>
#include <vector>

#include "solver/stage.h"

namespace millwright::evaluation {

class RestrictedStage final : public solver::Stage {
 public:
  /// `allowed`: per slot of `inner` the rows that may be chosen (ascending). `held`: per variable its value, if it is
  /// held.
  RestrictedStage(const solver::Stage& inner,
                  std::vector<std::vector<solver::Row>> allowed,
                  std::vector<std::optional<double>> held);

  [[nodiscard]] const std::string& name() const override { return inner_.name(); }
  [[nodiscard]] std::span<const solver::Slot> slots() const override { return slots_; }
  [[nodiscard]] std::span<const solver::Variable> variables() const override { return variables_; }
  [[nodiscard]] std::size_t constraints() const override { return inner_.constraints(); }
  void read(std::span<const solver::Row> shared,
            std::size_t slot,
            std::span<const solver::Row> rows,
            std::vector<scalar::Interval>& readings) const override;
  void evaluate(const solver::Point& point, solver::Answer<double>& answer) const override;
  void bound(const solver::Box& box, solver::Answer<scalar::Interval>& answer) const override;
  void slopes(const solver::Box& box, solver::Input input, solver::Answer<scalar::Interval>& answer) const override;
  void gradient(const solver::Point& point, solver::Input input, solver::Answer<double>& answer) const override;
  [[nodiscard]] bool fits(std::span<const solver::Row> shared,
                          std::size_t slot_a,
                          solver::Row row_a,
                          std::size_t slot_b,
                          solver::Row row_b) const override;

  [[nodiscard]] bool may_misfit(std::size_t slot_a, std::size_t slot_b) const override {
    return inner_.may_misfit(slot_a, slot_b);
  }

  /// The choice of this stage in terms of the inner stage's rows and variables.
  [[nodiscard]] std::vector<solver::Row> inner_rows(std::span<const solver::Row> rows) const;
  [[nodiscard]] std::vector<double> inner_variables(std::span<const double> variables) const;

 private:
  struct InnerBox;
  [[nodiscard]] std::vector<solver::Row> inner_rows_of(std::size_t slot, std::span<const solver::Row> rows) const;
  [[nodiscard]] solver::Input inner_input(solver::Input input) const;

  const solver::Stage& inner_;
  std::vector<std::vector<solver::Row>> allowed_;
  std::vector<std::optional<double>> held_;
  std::vector<std::size_t> free_;  ///< indices of the variables that are not held
  std::vector<solver::Slot> slots_;
  std::vector<solver::Variable> variables_;
};

}  // namespace millwright::evaluation
