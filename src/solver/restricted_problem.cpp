// SPDX-License-Identifier: Apache-2.0
#include "solver/restricted_problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace millwright::solver {

namespace {

std::vector<Row> all_rows(Row count) {
  std::vector<Row> rows(count);
  std::iota(rows.begin(), rows.end(), Row{0});
  return rows;
}

}  // namespace

Restriction unrestricted(const Problem& problem) {
  Restriction result;
  for (const Slot& slot : problem.shared) result.shared.push_back(all_rows(slot.rows));
  for (const Stage* stage : problem.stages) {
    StageRestriction all;
    for (const Slot& slot : stage->slots()) all.allowed.push_back(all_rows(slot.rows));
    all.held.resize(stage->variables().size());
    result.stages.push_back(std::move(all));
  }
  return result;
}

RestrictedStage::RestrictedStage(const Stage& inner, StageRestriction restriction, std::vector<std::vector<Row>> shared)
    : inner_(inner), restriction_(std::move(restriction)), shared_(std::move(shared)) {
  const auto slots = inner.slots();
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const auto left = static_cast<Row>(restriction_.allowed[i].size());
    slots_.push_back({slots[i].name, left});
    whole_.push_back(left == slots[i].rows);
  }
  const auto variables = inner.variables();
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (restriction_.held[i]) continue;
    free_.push_back(i);
    variables_.push_back(variables[i]);
  }
}

std::vector<Row> RestrictedStage::inner_rows(std::span<const Row> rows) const {
  std::vector<Row> result;
  for (std::size_t i = 0; i < rows.size(); ++i) result.push_back(restriction_.allowed[i][rows[i]]);
  return result;
}

std::vector<double> RestrictedStage::inner_variables(std::span<const double> variables) const {
  std::vector<double> result;
  std::size_t next = 0;
  for (const auto& held : restriction_.held) result.push_back(held ? *held : variables[next++]);
  return result;
}

std::vector<Row> RestrictedStage::inner_shared(std::span<const Row> shared) const {
  std::vector<Row> result;
  for (std::size_t i = 0; i < shared.size(); ++i) result.push_back(shared_[i][shared[i]]);
  return result;
}

std::vector<Row> RestrictedStage::inner_rows_of(std::size_t slot, std::span<const Row> rows) const {
  std::vector<Row> result;
  result.reserve(rows.size());
  for (const Row row : rows) result.push_back(restriction_.allowed[slot][row]);
  return result;
}

double RestrictedStage::combinations(std::span<const std::vector<Row>> rows) const {
  std::vector<std::vector<Row>> inner;
  for (std::size_t slot = 0; slot < rows.size(); ++slot) inner.push_back(inner_rows_of(slot, rows[slot]));
  return inner_.combinations(inner);
}

void RestrictedStage::read(std::span<const Row> shared,
                           std::size_t slot,
                           std::span<const Row> rows,
                           std::vector<Interval>& readings) const {
  if (whole_[slot])
    inner_.read(inner_shared(shared), slot, rows, readings);
  else
    inner_.read(inner_shared(shared), slot, inner_rows_of(slot, rows), readings);
}

/// A box in the inner stage's rows and variables, with the storage its spans point into.
struct RestrictedStage::InnerBox {
  InnerBox(const RestrictedStage& stage, const Box& box) : shared(stage.inner_shared(box.shared)) {
    rows.resize(box.rows.size());
    for (std::size_t i = 0; i < box.rows.size(); ++i) {
      if (stage.whole_[i]) {
        alive.push_back(box.rows[i]);
        continue;
      }
      const std::vector<Row>& allowed = stage.restriction_.allowed[i];
      if (box.rows[i].size() < allowed.size()) rows[i] = stage.inner_rows_of(i, box.rows[i]);
      alive.push_back(box.rows[i]);
      alive.back().rows = rows[i].empty() ? allowed : rows[i];
    }
    std::size_t next = 0;
    for (const auto& held : stage.restriction_.held)
      variables.push_back(held ? Interval(*held) : box.variables[next++]);
    inner = {shared, box.inherited, alive, variables, box.kept};
  }
  std::vector<Row> shared;
  std::vector<std::vector<Row>> rows;
  std::vector<RowsAlive> alive;
  std::vector<Interval> variables;
  Box inner;
};

Input RestrictedStage::inner_input(Input input) const {
  if (input.kind == Input::Kind::variable) input.index = free_[input.index];
  return input;
}

template <class T>
void RestrictedStage::waive(Answer<T>& answer) const {
  std::fill_n(answer.utilisation.begin(), restriction_.waived.value_or(0), T(0.0));
}

void RestrictedStage::evaluate(const Point& point, Answer<double>& answer) const {
  const auto shared = inner_shared(point.shared);
  const auto rows = inner_rows(point.rows);
  const auto variables = inner_variables(point.variables);
  inner_.evaluate({shared, point.inherited, rows, variables}, answer);
  waive(answer);
  if (!restriction_.waived) return;
  // What fails a check may hand on no number; constraints that are not waived read none of that.
  for (double& component : answer.handed_on)
    if (!std::isfinite(component)) component = 0.0;
}

void RestrictedStage::bound(const Box& box, Answer<Interval>& answer) const {
  inner_.bound(InnerBox(*this, box).inner, answer);
  waive(answer);
}

void RestrictedStage::slopes(const Box& box, Input input, Answer<Interval>& answer) const {
  inner_.slopes(InnerBox(*this, box).inner, inner_input(input), answer);
  waive(answer);
}

void RestrictedStage::gradient(const Point& point, Input input, Answer<double>& answer) const {
  const auto shared = inner_shared(point.shared);
  const auto rows = inner_rows(point.rows);
  const auto variables = inner_variables(point.variables);
  inner_.gradient({shared, point.inherited, rows, variables}, inner_input(input), answer);
  waive(answer);
}

bool RestrictedStage::offered(std::span<const Row> shared, std::size_t slot, Row row) const {
  return inner_.offered(inner_shared(shared), slot, restriction_.allowed[slot][row]);
}

bool RestrictedStage::fits(
    std::span<const Row> shared, std::size_t slot_a, Row row_a, std::size_t slot_b, Row row_b) const {
  if (restriction_.waived) return true;
  return inner_.fits(
      inner_shared(shared), slot_a, restriction_.allowed[slot_a][row_a], slot_b, restriction_.allowed[slot_b][row_b]);
}

FitKey RestrictedStage::fit_key(std::span<const Row> shared, std::size_t slot, Row row, std::size_t other_slot) const {
  return inner_.fit_key(inner_shared(shared), slot, restriction_.allowed[slot][row], other_slot);
}

RestrictedProblem::RestrictedProblem(const Problem& whole, const Restriction& restriction)
    : shared_(restriction.shared), problem_(whole) {
  for (std::size_t i = 0; i < shared_.size(); ++i) problem_.shared[i].rows = static_cast<Row>(shared_[i].size());
  for (std::size_t i = 0; i < whole.stages.size(); ++i) {
    stages_.push_back(std::make_unique<RestrictedStage>(*whole.stages[i], restriction.stages[i], shared_));
    problem_.stages[i] = stages_.back().get();
  }
}

Build RestrictedProblem::whole_build(Build build) const {
  for (std::size_t i = 0; i < build.shared.size(); ++i) build.shared[i] = shared_[i][build.shared[i]];
  for (std::size_t i = 0; i < build.stages.size(); ++i) {
    build.stages[i].rows = stages_[i]->inner_rows(build.stages[i].rows);
    build.stages[i].variables = stages_[i]->inner_variables(build.stages[i].variables);
  }
  return build;
}

}  // namespace millwright::solver
