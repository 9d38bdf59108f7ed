// SPDX-License-Identifier: Apache-2.0
//
// A problem of which some slots and shared choices may only take certain rows and some variables are held: the same
// stages, seen through a wrapper that numbers what is left anew.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "solver/solver.h"

namespace millwright::solver {

/// What is left of one stage.
struct StageRestriction {
  std::vector<std::vector<Row>> allowed;    ///< per slot the rows that may be chosen, ascending
  std::vector<std::optional<double>> held;  ///< per variable its value, if it is held
  /// Of a design that is taken as it is, whatever it fails: the first so many constraints count as kept, and all parts
  /// as fitting.
  std::optional<std::size_t> waived = {};
};

/// What is left of a problem.
struct Restriction {
  std::vector<std::vector<Row>> shared;  ///< per shared choice the rows that may be chosen, ascending
  std::vector<StageRestriction> stages;
};

/// All rows, nothing held.
Restriction unrestricted(const Problem& problem);

class RestrictedStage final : public Stage {
 public:
  RestrictedStage(const Stage& inner, StageRestriction restriction, std::vector<std::vector<Row>> shared);

  [[nodiscard]] const std::string& name() const override { return inner_.name(); }
  [[nodiscard]] std::span<const Slot> slots() const override { return slots_; }
  [[nodiscard]] std::span<const Variable> variables() const override { return variables_; }
  [[nodiscard]] std::size_t constraints() const override { return inner_.constraints(); }
  void read(std::span<const Row> shared,
            std::size_t slot,
            std::span<const Row> rows,
            std::vector<Interval>& readings) const override;
  [[nodiscard]] bool reads_shared(std::size_t slot) const override { return inner_.reads_shared(slot); }
  [[nodiscard]] std::size_t graded_readings(std::size_t slot) const override { return inner_.graded_readings(slot); }
  [[nodiscard]] std::size_t row_kind(std::size_t slot, Row row) const override {
    return inner_.row_kind(slot, restriction_.allowed[slot][row]);
  }
  void evaluate(const Point& point, Answer<double>& answer) const override;
  void bound(const Box& box, Answer<Interval>& answer) const override;
  void slopes(const Box& box, Input input, Answer<Interval>& answer) const override;
  void gradient(const Point& point, Input input, Answer<double>& answer) const override;
  [[nodiscard]] bool offered(std::span<const Row> shared, std::size_t slot, Row row) const override;
  [[nodiscard]] bool fits(
      std::span<const Row> shared, std::size_t slot_a, Row row_a, std::size_t slot_b, Row row_b) const override;

  [[nodiscard]] FitKey fit_key(std::span<const Row> shared,
                               std::size_t slot,
                               Row row,
                               std::size_t other_slot) const override;
  [[nodiscard]] bool may_misfit(std::size_t slot_a, std::size_t slot_b) const override {
    return !restriction_.waived && inner_.may_misfit(slot_a, slot_b);
  }
  [[nodiscard]] double combinations(std::span<const std::vector<Row>> rows) const override;

  /// The choice of this stage in terms of the inner stage's rows and variables.
  [[nodiscard]] std::vector<Row> inner_rows(std::span<const Row> rows) const;
  [[nodiscard]] std::vector<double> inner_variables(std::span<const double> variables) const;
  [[nodiscard]] std::vector<Row> inner_shared(std::span<const Row> shared) const;

 private:
  struct InnerBox;
  [[nodiscard]] std::vector<Row> inner_rows_of(std::size_t slot, std::span<const Row> rows) const;
  [[nodiscard]] Input inner_input(Input input) const;
  template <class T>
  void waive(Answer<T>& answer) const;

  const Stage& inner_;
  StageRestriction restriction_;
  std::vector<std::vector<Row>> shared_;
  std::vector<bool> whole_;        ///< per slot: all of its rows are allowed
  std::vector<std::size_t> free_;  ///< indices of the variables that are not held
  std::vector<Slot> slots_;
  std::vector<Variable> variables_;
};

/// The problem that is left. Refers to the stages of the whole one.
class RestrictedProblem {
 public:
  RestrictedProblem(const Problem& whole, const Restriction& restriction);

  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] Problem& problem() { return problem_; }
  [[nodiscard]] const RestrictedStage& stage(std::size_t index) const { return *stages_[index]; }
  /// A build of what is left, in rows and variables of the whole problem.
  [[nodiscard]] Build whole_build(Build build) const;

 private:
  std::vector<std::vector<Row>> shared_;
  std::vector<std::unique_ptr<RestrictedStage>> stages_;
  Problem problem_;
};

}  // namespace millwright::solver
