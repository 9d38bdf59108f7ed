// SPDX-License-Identifier: Apache-2.0
//
// A stage from tables and one generic function: the shortest way to give the search a model.
//
//   const Columns screws{"screw", {"root_diameter", "price"}, {...row by row...}};
//   const auto stage = model_stage("z", {&screws, &motors}, {{"acceleration_time", 0.02, 0.5}}, 9,
//                                  [](const auto& in, auto& out) {
//                                    const auto root = in.row(0, 0);  // slot, column
//                                    out.utilisation.push_back(force / root);
//                                    ...
//                                  });
//
// The function is called with numbers for a design, with intervals for a set of designs, and with both and their
// derivatives; it fills utilisations, resources and the state handed on, always as many. It must not branch on values
// other than through the functions of the scalar room.
#pragma once

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "scalar/dual.h"
#include "scalar/interval.h"
#include "solver/stage.h"

namespace millwright::solver {

/// A table of numbers, row by row.
struct Columns {
  std::string name;
  std::size_t width = 0;        ///< numbers in a row
  std::vector<double> numbers;  ///< width * rows
  [[nodiscard]] Row rows() const { return static_cast<Row>(numbers.size() / width); }
  [[nodiscard]] const double* row(Row index) const { return numbers.data() + index * width; }
};

/// What a model reads, on a scalar: `row(slot, column)`, `variable(i)`, `state(i)`; `shared(i)` is the row chosen of a
/// shared choice.
template <class T>
class ModelInput {
 public:
  static constexpr std::size_t most_slots = 8;
  using Number = std::
      conditional_t<std::is_same_v<T, double> || std::is_same_v<T, scalar::Dual<double, 1>>, double, scalar::Interval>;

  ModelInput(std::span<const Row> shared, std::span<const T> state, std::span<const T> variables)
      : shared_(shared), state_(state), variables_(variables) {}

  [[nodiscard]] T row(std::size_t slot, std::size_t column) const {
    T number(rows_[slot][column]);
    if constexpr (std::is_same_v<T, scalar::Dual<scalar::Interval, 1>>)
      if (by_.kind == Input::Kind::reading && slot == by_.slot && column == by_.index) number.slope[0] = 1.0;
    return number;
  }
  [[nodiscard]] const T& variable(std::size_t i) const { return variables_[i]; }
  [[nodiscard]] const T& state(std::size_t i) const { return state_[i]; }
  [[nodiscard]] Row shared(std::size_t i) const { return shared_[i]; }

  void set_row(std::size_t slot, const Number* numbers) { rows_[slot] = numbers; }
  /// Slopes are asked for by this, if it is a reading.
  void differentiate_by(const Input& input) { by_ = input; }

 private:
  Input by_;
  const Number* rows_[most_slots] = {};
  std::span<const Row> shared_;
  std::span<const T> state_;
  std::span<const T> variables_;
};

/// See the head of this file. The tables must outlive the stage.
template <class Model>
class ModelStage final : public Stage {
 public:
  /// Throws std::invalid_argument for more slots than a model may have.
  ModelStage(std::string name,
             std::vector<const Columns*> tables,
             std::vector<Variable> variables,
             std::size_t constraints,
             Model model)
      : name_(std::move(name)),
        tables_(std::move(tables)),
        variables_(std::move(variables)),
        constraints_(constraints),
        model_(std::move(model)) {
    if (tables_.size() > ModelInput<double>::most_slots) throw std::invalid_argument("too many slots in " + name_);
    for (const Columns* table : tables_) slots_.push_back({table->name, table->rows()});
  }

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] std::span<const Slot> slots() const override { return slots_; }
  [[nodiscard]] std::span<const Variable> variables() const override { return variables_; }
  [[nodiscard]] std::size_t constraints() const override { return constraints_; }

  [[nodiscard]] bool may_misfit(std::size_t, std::size_t) const override { return false; }

  /// A model sees nothing of a row but its columns.
  [[nodiscard]] std::size_t graded_readings(std::size_t slot) const override { return tables_[slot]->width; }
  [[nodiscard]] std::size_t row_kind(std::size_t, Row) const override { return 0; }

  [[nodiscard]] bool reads_shared(std::size_t) const override { return false; }

  /// The hull of each column.
  void read(std::span<const Row>,
            std::size_t slot,
            std::span<const Row> rows,
            std::vector<Interval>& readings) const override {
    const Columns& table = *tables_[slot];
    const double* first = table.row(rows.front());
    readings.assign(first, first + table.width);
    for (const Row row : rows.subspan(1)) {
      const double* numbers = table.row(row);
      for (std::size_t column = 0; column < table.width; ++column) {
        readings[column].lower = std::min(readings[column].lower, numbers[column]);
        readings[column].upper = std::max(readings[column].upper, numbers[column]);
      }
    }
  }

  void evaluate(const Point& point, Answer<double>& answer) const override {
    ModelInput<double> input(point.shared, point.inherited, point.variables);
    set_rows(input, point.rows);
    ask(input, answer);
    for (double& u : answer.utilisation) u = without_rounding(u);
  }

  void bound(const Box& box, Answer<Interval>& answer) const override {
    ModelInput<Interval> input(box.shared, box.inherited, box.variables);
    std::vector<std::vector<Interval>> read_here;
    set_rows(input, box, read_here);
    ask(input, answer);
    for (Interval& u : answer.utilisation) u = without_rounding(u);
  }

  void slopes(const Box& box, Input with_respect_to, Answer<Interval>& answer) const override {
    using T = scalar::Dual<Interval, 1>;
    std::vector<T> state(box.inherited.begin(), box.inherited.end());
    std::vector<T> variables(box.variables.begin(), box.variables.end());
    seed(with_respect_to, state, variables);
    ModelInput<T> input(box.shared, state, variables);
    input.differentiate_by(with_respect_to);
    std::vector<std::vector<Interval>> read_here;
    set_rows(input, box, read_here);
    differentiate(input, answer);
  }

  void gradient(const Point& point, Input with_respect_to, Answer<double>& answer) const override {
    using T = scalar::Dual<double, 1>;
    std::vector<T> state(point.inherited.begin(), point.inherited.end());
    std::vector<T> variables(point.variables.begin(), point.variables.end());
    seed(with_respect_to, state, variables);
    ModelInput<T> input(point.shared, state, variables);
    set_rows(input, point.rows);
    differentiate(input, answer);
  }

 private:
  template <class T>
  void set_rows(ModelInput<T>& input, std::span<const Row> rows) const {
    for (std::size_t slot = 0; slot < rows.size(); ++slot) input.set_row(slot, tables_[slot]->row(rows[slot]));
  }
  template <class T>
  void set_rows(ModelInput<T>& input, const Box& box, std::vector<std::vector<Interval>>& read_here) const {
    for (std::size_t slot = 0; slot < box.rows.size(); ++slot) {
      if (box.rows[slot].readings.empty()) {
        if (read_here.empty()) read_here.resize(box.rows.size());
        read(box.shared, slot, box.rows[slot].rows, read_here[slot]);
        input.set_row(slot, read_here[slot].data());
      } else {
        input.set_row(slot, box.rows[slot].readings.data());
      }
    }
  }
  template <class T>
  void ask(const ModelInput<T>& input, Answer<T>& answer) const {
    answer.utilisation.clear();
    answer.resources.clear();
    answer.handed_on.clear();
    model_(input, answer);
  }
  template <class T>
  static void seed(Input with_respect_to, std::vector<T>& state, std::vector<T>& variables) {
    if (with_respect_to.kind == Input::Kind::reading) return;
    const bool variable = with_respect_to.kind == Input::Kind::variable;
    (variable ? variables : state)[with_respect_to.index].slope[0] = 1.0;
  }
  template <class B>
  void differentiate(const ModelInput<scalar::Dual<B, 1>>& input, Answer<B>& answer) const {
    Answer<scalar::Dual<B, 1>> duals;
    ask(input, duals);
    const auto take = [](const auto& from, auto& to) {
      to.clear();
      for (const auto& x : from) to.push_back(x.slope[0]);
    };
    take(duals.utilisation, answer.utilisation);
    take(duals.resources, answer.resources);
    take(duals.handed_on, answer.handed_on);
  }

  std::string name_;
  std::vector<const Columns*> tables_;
  std::vector<Slot> slots_;
  std::vector<Variable> variables_;
  std::size_t constraints_ = 0;
  Model model_;
};

template <class Model>
ModelStage<Model> model_stage(std::string name,
                              std::vector<const Columns*> tables,
                              std::vector<Variable> variables,
                              std::size_t constraints,
                              Model model) {
  return {std::move(name), std::move(tables), std::move(variables), constraints, std::move(model)};
}

}  // namespace millwright::solver
