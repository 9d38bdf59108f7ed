// SPDX-License-Identifier: Apache-2.0
//
// An element of the machine (a drive, a guide, a member) as a stage of the solver. Derived stages build their element's
// design on any scalar from a selection of rows, variables and inherited state; the constraints come from the element's
// one declaration.
//
//   evaluate = the design on double, bound = on Interval, slopes = on Dual<Interval>, gradient = on Dual<double>.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/counted_parts.h"
#include "evaluation/shops.h"
#include "evaluation/slot_table.h"
#include "machine/constraint.h"
#include "solver/stage.h"

namespace millwright::evaluation {

/// What is chosen, on a scalar.
template <class T>
struct Selection {
  std::span<const solver::Row> shared;
  Alive rows;
  std::vector<T> inherited;
  std::vector<T> variables;
  std::uint64_t kept = 0;  ///< as solver::Box::kept
};

/// Indices of the resources that every stage has; behind them stands what objectives count beside (CountedResources),
/// and last what is compared in place of the cost where some parts are preferred (preferred_parts.h).
enum ResourceIndex : std::size_t { cost_resource = 0, mass_resource = 1, first_counted_resource = 2 };

/// Index of the supply power in the state vector; loads of the axes follow it.
inline constexpr std::size_t power_state = 0;
inline constexpr std::size_t first_load_state = 1;

/// demand over capacity; a capacity of nothing is a large finite utilisation.
inline double utilisation(double demand, double capacity) {
  if (demand <= 0.0 && capacity >= 0.0) return 0.0;
  if (!(capacity > 0.0)) return machine::useless_utilisation;
  const double u = solver::without_rounding(demand / capacity);
  return u < machine::useless_utilisation ? u : machine::useless_utilisation;
}

scalar::Interval utilisation(const scalar::Interval& demand, const scalar::Interval& capacity);

/// Derivatives. Where the demand may be below zero the utilisation rests at 0, and so may its slope.
inline scalar::Dual<double, 1> utilisation(const scalar::Dual<double, 1>& demand,
                                           const scalar::Dual<double, 1>& capacity) {
  const double u = utilisation(demand.value, capacity.value);
  return u == 0.0 || u == machine::useless_utilisation ? scalar::Dual<double, 1>(u) : demand / capacity;
}
inline scalar::Dual<scalar::Interval, 1> utilisation(const scalar::Dual<scalar::Interval, 1>& demand,
                                                     const scalar::Dual<scalar::Interval, 1>& capacity) {
  scalar::Dual<scalar::Interval, 1> u = demand / capacity;
  if (demand.value.lower <= 0.0) u.slope[0] = hull(u.slope[0], scalar::Interval(0.0));
  if (capacity.value.lower <= 0.0) u.slope[0] = scalar::Interval::entire();
  return u;
}

/// Takes the constraints of an element one by one and keeps those the search must hold.
template <class T, class Element>
class UtilisationVisitor {
 public:
  /// `kept`: as solver::Box::kept. `out` has a place for each of them, from its beginning.
  UtilisationVisitor(const Element& element, std::uint64_t kept, std::vector<T>& out)
      : element_(element), kept_(kept), out_(out) {}
  template <class When, class Demand, class Capacity>
  void operator()(const machine::Declaration& declaration, When when, Demand demand, Capacity capacity) {
    if (!machine::is_searched(declaration, element_.data->require)) return;
    const bool is_kept = ((kept_ >> (next_ % 64)) & 1U) != 0;
    T& used = out_[next_++];
    const machine::Applies applies = is_kept ? machine::Applies::no : when(element_);
    if (applies == machine::Applies::yes)
      used = utilisation(demand(element_), capacity(element_));
    else
      used = applies == machine::Applies::no ? T(0.0) : anything();
  }

 private:
  static T anything() {
    if constexpr (std::is_constructible_v<T, scalar::Interval>) {
      T whole = T(scalar::Interval(0.0, scalar::rounding::infinity));
      if constexpr (!std::is_same_v<T, scalar::Interval>) whole.slope[0] = scalar::Interval::entire();
      return whole;
    } else {
      return T(0.0);
    }
  }
  const Element& element_;
  std::uint64_t kept_;
  std::vector<T>& out_;
  std::size_t next_ = 0;
};

/// CRTP base. Derived has `slot_tables`, `name_`, `variables_`, `constraint_count_` and
///   template <class T> void answer(const Selection<T>&, solver::Answer<T>&) const.
template <class Derived>
class ElementStage : public solver::Stage {
 public:
  [[nodiscard]] const std::string& name() const final { return name_; }
  [[nodiscard]] std::span<const solver::Slot> slots() const final { return slots_; }
  [[nodiscard]] std::span<const solver::Variable> variables() const final { return variables_; }
  [[nodiscard]] std::size_t constraints() const final { return constraint_count_; }
  [[nodiscard]] const std::vector<SlotTable>& tables() const { return tables_; }
  /// Where nothing misfits. Stages with `fits` say what it reads.
  [[nodiscard]] solver::FitKey fit_key(std::span<const solver::Row>,
                                       std::size_t,
                                       solver::Row,
                                       std::size_t) const override {
    return {};
  }
  /// How many resources the machine has: before the stage is asked for the first time.
  void set_resources(std::size_t count) { resources_ = count; }

  /// To add to their prices: before the stage is asked for the first time.
  [[nodiscard]] std::vector<SlotTable>& change_tables() { return tables_; }
  /// What its slots take of counted parts, by slot: before the stage is asked for the first time.
  void set_piece_counts(std::vector<PieceCount> counts) { piece_counts_ = std::move(counts); }

  /// Where the compared cost is counted, and whether piece counts hold that of the stage's rows; else it is the cost.
  /// Before the stage is asked for the first time.
  void set_compared(std::size_t resource, bool by_rows) {
    compared_resource_ = resource;
    compared_by_rows_ = by_rows;
  }

  /// Where floors of the cost are counted: before the stage is asked for the first time.
  void set_floors(const std::vector<CostFloor>& floors) {
    for (const CostFloor& floor : floors)
      if (std::none_of(piece_counts_.begin(), piece_counts_.end(), [&](const PieceCount& count) {
            return count.is_resource && count.state == floor.resource;
          }))
        costs_.push_back(floor.resource);
  }

  /// Who sells the rows of its slots: before the stage is asked for the first time.
  void set_shops(std::vector<SlotShops> shops) { shops_ = std::move(shops); }
  [[nodiscard]] bool offered(std::span<const solver::Row> shared, std::size_t slot, solver::Row row) const final {
    return shops_.empty() || shops_[slot].offered(shared[shop_choice], row);
  }

  /// The table's fields, the totals, what `read_more` of the derived stage adds, then the piece counts of the slot.
  void read(std::span<const solver::Row> shared,
            std::size_t slot,
            std::span<const solver::Row> rows,
            std::vector<scalar::Interval>& readings) const final {
    const SlotTable& table = tables_[slot];
    readings.clear();
    if (table.has_ranges())
      read_ranges(table, rows, readings);
    else
      read_numbers(table, rows, readings);
    const auto& derived = static_cast<const Derived&>(*this);
    if constexpr (requires { derived.read_more(shared, slot, rows, readings); })
      derived.read_more(shared, slot, rows, readings);
    for (const PieceCount& count : piece_counts_)
      if (count.slot == slot) readings.push_back(range_of(rows, [&](solver::Row row) { return count.of_row[row]; }));
  }

  /// As the derived stage says (`own_reads_shared`): tables, totals and piece counts are the same everywhere, what
  /// `read_more` adds may not be.
  [[nodiscard]] bool reads_shared(std::size_t slot) const final {
    const auto& derived = static_cast<const Derived&>(*this);
    if constexpr (requires { derived.own_reads_shared(slot); }) return derived.own_reads_shared(slot);
    return requires(std::vector<scalar::Interval> readings) { derived.read_more({}, slot, {}, readings); };
  }

  /// Of slots whose rows the derived stage says the kinds of (`row_kind_of`: all that it reads of a row by its number):
  /// the table's fields and the totals.
  [[nodiscard]] std::size_t graded_readings(std::size_t slot) const final {
    const auto& derived = static_cast<const Derived&>(*this);
    if constexpr (requires { derived.row_kind_of(slot, solver::Row{}); }) {
      if (tables_[slot].has_ranges() || !derived.row_kind_of(slot, 0)) return 0;
      return tables_[slot].width();
    }
    return 0;
  }
  [[nodiscard]] std::size_t row_kind(std::size_t slot, solver::Row row) const final {
    const auto& derived = static_cast<const Derived&>(*this);
    if constexpr (requires { derived.row_kind_of(slot, row); }) return derived.row_kind_of(slot, row).value_or(row);
    return row;
  }

  static void read_numbers(const SlotTable& table,
                           std::span<const solver::Row> rows,
                           std::vector<scalar::Interval>& readings) {
    append_ranges(
        rows, table.width(), [&](solver::Row row) { return table.numbers(row); }, readings);
  }

  static void read_ranges(const SlotTable& table,
                          std::span<const solver::Row> rows,
                          std::vector<scalar::Interval>& readings) {
    for (std::size_t field = 0; field < table.fields(); ++field)
      readings.push_back(hull_of_ranges(rows, [&](solver::Row row) { return table.range(row, field); }));
    for (std::size_t i = 0; i < total_count; ++i)
      readings.push_back(
          hull_of_ranges(rows, [&](solver::Row row) { return table.range(row, static_cast<Total>(i)); }));
  }

  void evaluate(const solver::Point& point, solver::Answer<double>& answer) const final {
    std::vector<RowsAlive> rows;
    const auto selection = point_selection<double>(point, rows);
    ask(selection, answer);
    for (double& u : answer.utilisation)
      if (std::isnan(u)) u = machine::useless_utilisation;
  }

  void bound(const solver::Box& box, solver::Answer<scalar::Interval>& answer) const final {
    Selection<scalar::Interval> selection = box_selection<scalar::Interval>(box);
    selection.kept = box.kept;
    ask(selection, answer);
  }

  void slopes(const solver::Box& box, solver::Input input, solver::Answer<scalar::Interval>& answer) const final {
    using T = scalar::Dual<scalar::Interval, 1>;
    Selection<T> selection = box_selection<T>(box);
    std::vector<RowsAlive> rows;
    if (input.kind == solver::Input::Kind::reading) {
      rows.assign(box.rows.begin(), box.rows.end());
      rows[input.slot].with_respect_to = input.index;
      selection.rows = rows;
    } else {
      seed(selection, input);
    }
    solver::Answer<T> duals;
    ask(selection, duals);
    slopes_of(duals, answer);
  }

  void gradient(const solver::Point& point, solver::Input input, solver::Answer<double>& answer) const final {
    using T = scalar::Dual<double, 1>;
    std::vector<RowsAlive> rows;
    Selection<T> selection = point_selection<T>(point, rows);
    seed(selection, input);
    solver::Answer<T> duals;
    ask(selection, duals);
    slopes_of(duals, answer);
  }

 protected:
  std::string name_;
  std::vector<SlotTable> tables_;
  std::vector<solver::Slot> slots_;
  std::vector<solver::Variable> variables_;
  std::size_t constraint_count_ = 0;
  std::size_t resources_ = first_counted_resource;
  std::vector<PieceCount> piece_counts_;
  std::size_t compared_resource_ = cost_resource;
  bool compared_by_rows_ = false;
  std::vector<std::size_t> costs_;  ///< resources that are the same as the cost here
  std::vector<SlotShops> shops_;    ///< empty, or one per slot

  void finish_slots() {
    slots_.clear();
    for (const SlotTable& table : tables_) slots_.push_back({table.name(), static_cast<solver::Row>(table.rows())});
  }

  /// Of the candidates chosen.
  template <class T>
  T total(const Selection<T>& selection, Total what) const {
    T sum = T(0.0);
    for (std::size_t slot = 0; slot < tables_.size(); ++slot) {
      const SlotTable& table = tables_[slot];
      sum = sum + hull_of<T>(selection.rows[slot],
                             table.fields() + static_cast<std::size_t>(what),
                             [&](solver::Row row) { return table.total(row, what); });
    }
    return sum;
  }

 private:
  template <class T>
  void ask(const Selection<T>& selection, solver::Answer<T>& answer) const {
    answer.utilisation.resize(constraint_count_);
    answer.resources.assign(resources_, T(0.0));
    answer.handed_on.assign(selection.inherited.begin(), selection.inherited.end());
    static_cast<const Derived&>(*this).template answer<T>(selection, answer);
    if constexpr (!requires { Derived::compares_itself; }) {
      if (compared_resource_ != cost_resource && !compared_by_rows_)
        answer.resources[compared_resource_] = answer.resources[cost_resource];
      for (const std::size_t resource : costs_) answer.resources[resource] = answer.resources[cost_resource];
    }
    if (!piece_counts_.empty()) count_pieces(selection, answer);
  }

  /// Readings of piece counts are the last of their slot's.
  template <class T>
  void count_pieces(const Selection<T>& selection, solver::Answer<T>& answer) const {
    for (auto first = piece_counts_.begin(); first != piece_counts_.end();) {
      const auto last =
          std::find_if(first, piece_counts_.end(), [&](const PieceCount& each) { return each.slot != first->slot; });
      const RowsAlive& rows = selection.rows[first->slot];
      std::size_t reading = rows.readings.size() - (rows.readings.empty() ? 0 : static_cast<std::size_t>(last - first));
      for (; first != last; ++first, ++reading) {
        T& sum = first->is_resource ? answer.resources[first->state] : answer.handed_on[first->state];
        sum = sum + hull_of<T>(rows, reading, [&](solver::Row row) { return first->of_row[row]; });
      }
    }
  }

  template <class T>
  static Selection<T> point_selection(const solver::Point& point, std::vector<RowsAlive>& rows) {
    rows.reserve(point.rows.size());
    for (const solver::Row& row : point.rows) rows.emplace_back(std::span(&row, 1));
    Selection<T> selection{.shared = point.shared, .rows = rows, .inherited = {}, .variables = {}};
    selection.inherited.assign(point.inherited.begin(), point.inherited.end());
    selection.variables.assign(point.variables.begin(), point.variables.end());
    return selection;
  }

  template <class T>
  static Selection<T> box_selection(const solver::Box& box) {
    Selection<T> selection{.shared = box.shared, .rows = box.rows, .inherited = {}, .variables = {}};
    selection.inherited.assign(box.inherited.begin(), box.inherited.end());
    selection.variables.assign(box.variables.begin(), box.variables.end());
    return selection;
  }

  template <class T>
  static void seed(Selection<T>& selection, solver::Input input) {
    T& x = input.kind == solver::Input::Kind::variable ? selection.variables[input.index]
                                                       : selection.inherited[input.index];
    x.slope[0] = decltype(x.value)(1.0);
  }

  template <class B>
  static void slopes_of(const solver::Answer<scalar::Dual<B, 1>>& duals, solver::Answer<B>& answer) {
    const auto take = [](const auto& from, auto& to) {
      to.clear();
      for (const auto& x : from) to.push_back(x.slope[0]);
    };
    take(duals.utilisation, answer.utilisation);
    take(duals.resources, answer.resources);
    take(duals.handed_on, answer.handed_on);
  }
};

}  // namespace millwright::evaluation
