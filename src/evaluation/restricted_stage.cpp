// SPDX-License-Identifier: Apache-2.0
#include "evaluation/restricted_stage.h"

namespace millwright::evaluation {

using scalar::Interval;
using solver::Row;

RestrictedStage::RestrictedStage(const solver::Stage& inner,
                                 std::vector<std::vector<Row>> allowed,
                                 std::vector<std::optional<double>> held)
    : inner_(inner), allowed_(std::move(allowed)), held_(std::move(held)) {
  const auto slots = inner.slots();
  for (std::size_t i = 0; i < slots.size(); ++i)
    slots_.push_back({slots[i].name, static_cast<Row>(allowed_[i].size())});
  const auto variables = inner.variables();
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (held_[i]) continue;
    free_.push_back(i);
    variables_.push_back(variables[i]);
  }
}

std::vector<Row> RestrictedStage::inner_rows(std::span<const Row> rows) const {
  std::vector<Row> result;
  for (std::size_t i = 0; i < rows.size(); ++i) result.push_back(allowed_[i][rows[i]]);
  return result;
}

std::vector<double> RestrictedStage::inner_variables(std::span<const double> variables) const {
  std::vector<double> result;
  for (std::size_t i = 0, next = 0; i < held_.size(); ++i) result.push_back(held_[i] ? *held_[i] : variables[next++]);
  return result;
}

std::vector<Row> RestrictedStage::inner_rows_of(std::size_t slot, std::span<const Row> rows) const {
  std::vector<Row> result;
  result.reserve(rows.size());
  for (const Row row : rows) result.push_back(allowed_[slot][row]);
  return result;
}

void RestrictedStage::read(std::span<const Row> shared,
                           std::size_t slot,
                           std::span<const Row> rows,
                           std::vector<Interval>& readings) const {
  inner_.read(shared, slot, inner_rows_of(slot, rows), readings);
}

/// A box in the inner stage's rows and variables, with the storage its spans point into.
struct RestrictedStage::InnerBox {
  InnerBox(const RestrictedStage& stage, const solver::Box& box) {
    rows.resize(box.rows.size());
    for (std::size_t i = 0; i < box.rows.size(); ++i) {
      rows[i] = stage.inner_rows_of(i, box.rows[i]);
      alive.emplace_back(rows[i], box.rows[i].readings);
    }
    for (std::size_t i = 0, next = 0; i < stage.held_.size(); ++i)
      variables.push_back(stage.held_[i] ? Interval(*stage.held_[i]) : box.variables[next++]);
    inner = {box.shared, box.inherited, alive, variables};
  }
  std::vector<std::vector<Row>> rows;
  std::vector<solver::RowsAlive> alive;
  std::vector<Interval> variables;
  solver::Box inner;
};

solver::Input RestrictedStage::inner_input(solver::Input input) const {
  if (input.kind == solver::Input::Kind::variable) input.index = free_[input.index];
  return input;
}

void RestrictedStage::evaluate(const solver::Point& point, solver::Answer<double>& answer) const {
  const auto rows = inner_rows(point.rows);
  const auto variables = inner_variables(point.variables);
  inner_.evaluate({point.shared, point.inherited, rows, variables}, answer);
}

void RestrictedStage::bound(const solver::Box& box, solver::Answer<Interval>& answer) const {
  inner_.bound(InnerBox(*this, box).inner, answer);
}

void RestrictedStage::slopes(const solver::Box& box, solver::Input input, solver::Answer<Interval>& answer) const {
  inner_.slopes(InnerBox(*this, box).inner, inner_input(input), answer);
}

void RestrictedStage::gradient(const solver::Point& point, solver::Input input, solver::Answer<double>& answer) const {
  const auto rows = inner_rows(point.rows);
  const auto variables = inner_variables(point.variables);
  inner_.gradient({point.shared, point.inherited, rows, variables}, inner_input(input), answer);
}

bool RestrictedStage::fits(
    std::span<const Row> shared, std::size_t slot_a, Row row_a, std::size_t slot_b, Row row_b) const {
  return inner_.fits(shared, slot_a, allowed_[slot_a][row_a], slot_b, allowed_[slot_b][row_b]);
}

}  // namespace millwright::evaluation
