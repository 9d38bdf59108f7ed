// SPDX-License-Identifier: Apache-2.0
#include "solver/scenario_problem.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace millwright::solver {

ScenarioStage::ScenarioStage(std::vector<const Stage*> versions,
                             std::vector<std::size_t> states,
                             std::size_t resources,
                             std::vector<std::size_t> limited)
    : versions_(std::move(versions)), states_(std::move(states)), resources_(resources), limited_(std::move(limited)) {}

std::size_t ScenarioStage::constraints() const {
  std::size_t count = 0;
  for (const Stage* version : versions_) count += version->constraints();
  return count;
}

/// What every version answers, one after the other. ask(version, first state, answer).
template <class T, class Ask>
void ScenarioStage::gather(Answer<T>& answer, Ask&& ask) const {
  answer.utilisation.clear();
  answer.resources.clear();
  answer.handed_on.clear();
  Answer<T> of_version;
  std::size_t first_state = 0;
  for (std::size_t v = 0; v < versions_.size(); ++v) {
    ask(v, first_state, of_version);
    answer.utilisation.insert(answer.utilisation.end(), of_version.utilisation.begin(), of_version.utilisation.end());
    answer.handed_on.insert(answer.handed_on.end(), of_version.handed_on.begin(), of_version.handed_on.end());
    if (v == 0)
      answer.resources = of_version.resources;
    else
      for (const std::size_t each : limited_) answer.resources.push_back(of_version.resources[each]);
    first_state += states_[v];
  }
}

/// Derivatives: a state belongs to one version, and moves no other.
template <class T, class Ask>
void ScenarioStage::gather_slopes(Input input, Answer<T>& answer, Ask&& ask) const {
  gather(answer, [&](std::size_t v, std::size_t first_state, Answer<T>& of_version) {
    Input own = input;
    if (input.kind == Input::Kind::inherited) {
      if (input.index < first_state || input.index >= first_state + states_[v]) {
        of_version.utilisation.assign(versions_[v]->constraints(), T(0.0));
        of_version.resources.assign(resources_, T(0.0));
        of_version.handed_on.assign(states_[v], T(0.0));
        return;
      }
      own.index -= first_state;
    }
    ask(v, first_state, own, of_version);
  });
}

/// The readings of all versions, each headed by how many they are.
void ScenarioStage::read(std::span<const Row> shared,
                         std::size_t slot,
                         std::span<const Row> rows,
                         std::vector<Interval>& readings) const {
  readings.clear();
  std::vector<Interval> of_version;
  for (const Stage* version : versions_) {
    version->read(shared, slot, rows, of_version);
    readings.emplace_back(static_cast<double>(of_version.size()));
    readings.insert(readings.end(), of_version.begin(), of_version.end());
  }
}

/// The rows of a box as each version reads them.
struct ScenarioStage::VersionBoxes {
  VersionBoxes(std::size_t versions, const Box& box) : rows(versions) {
    for (const RowsAlive& alive : box.rows) {
      std::span<const Interval> rest = alive.readings;
      for (auto& of_version : rows) {
        if (rest.empty()) {
          of_version.emplace_back(alive.rows);
          continue;
        }
        const auto count = static_cast<std::size_t>(rest.front().lower);
        of_version.emplace_back(alive.rows, rest.subspan(1, count));
        rest = rest.subspan(1 + count);
      }
    }
  }
  std::vector<std::vector<RowsAlive>> rows;
};

void ScenarioStage::evaluate(const Point& point, Answer<double>& answer) const {
  gather(answer, [&](std::size_t v, std::size_t first, Answer<double>& of_version) {
    versions_[v]->evaluate({point.shared, point.inherited.subspan(first, states_[v]), point.rows, point.variables},
                           of_version);
  });
}

/// Box::kept counts the constraints of all versions one after the other, and so is of no use to any one of them.
void ScenarioStage::bound(const Box& box, Answer<Interval>& answer) const {
  const VersionBoxes boxes(versions_.size(), box);
  gather(answer, [&](std::size_t v, std::size_t first, Answer<Interval>& of_version) {
    versions_[v]->bound({box.shared, box.inherited.subspan(first, states_[v]), boxes.rows[v], box.variables},
                        of_version);
  });
}

void ScenarioStage::slopes(const Box& box, Input input, Answer<Interval>& answer) const {
  const VersionBoxes boxes(versions_.size(), box);
  gather_slopes(input, answer, [&](std::size_t v, std::size_t first, Input own, Answer<Interval>& of_version) {
    versions_[v]->slopes(
        {box.shared, box.inherited.subspan(first, states_[v]), boxes.rows[v], box.variables}, own, of_version);
  });
}

void ScenarioStage::gradient(const Point& point, Input input, Answer<double>& answer) const {
  gather_slopes(input, answer, [&](std::size_t v, std::size_t first, Input own, Answer<double>& of_version) {
    versions_[v]->gradient(
        {point.shared, point.inherited.subspan(first, states_[v]), point.rows, point.variables}, own, of_version);
  });
}

bool ScenarioStage::offered(std::span<const Row> shared, std::size_t slot, Row row) const {
  return std::all_of(
      versions_.begin(), versions_.end(), [&](const Stage* version) { return version->offered(shared, slot, row); });
}

/// Of a row whose versions differ in what decides it is a kind of its own, by a number that no version uses.
FitKey ScenarioStage::fit_key(std::span<const Row> shared, std::size_t slot, Row row, std::size_t other_slot) const {
  const FitKey key = versions_.front()->fit_key(shared, slot, row, other_slot);
  const bool same = std::all_of(versions_.begin(), versions_.end(), [&](const Stage* version) {
    return version->fit_key(shared, slot, row, other_slot) == key;
  });
  return same ? key : FitKey{static_cast<double>(row), -1.0};
}

bool ScenarioStage::fits(
    std::span<const Row> shared, std::size_t slot_a, Row row_a, std::size_t slot_b, Row row_b) const {
  return std::all_of(versions_.begin(), versions_.end(), [&](const Stage* version) {
    return version->fits(shared, slot_a, row_a, slot_b, row_b);
  });
}

bool ScenarioStage::may_misfit(std::size_t slot_a, std::size_t slot_b) const {
  return std::any_of(
      versions_.begin(), versions_.end(), [&](const Stage* version) { return version->may_misfit(slot_a, slot_b); });
}

ScenarioProblem::ScenarioProblem(const std::vector<const Problem*>& versions) : problem_(*versions.front()) {
  std::vector<std::size_t> states, limited;
  for (const Problem* version : versions) {
    states.push_back(version->first_state.size());
    if (version != versions.front())
      problem_.first_state.insert(problem_.first_state.end(), version->first_state.begin(), version->first_state.end());
  }
  const std::size_t resources = problem_.resources.size();
  for (std::size_t r = 0; r < resources; ++r)
    if (std::isfinite(problem_.resources[r].limit)) limited.push_back(r);
  for (std::size_t v = 1; v < versions.size(); ++v)
    for (const std::size_t each : limited) problem_.resources.push_back(versions[v]->resources[each]);
  for (std::size_t i = 0; i < problem_.stages.size(); ++i) {
    std::vector<const Stage*> of_stage;
    for (const Problem* version : versions) {
      const Stage& stage = *version->stages.at(i);
      const auto same_rows = [](const Slot& a, const Slot& b) { return a.rows == b.rows; };
      const auto slots = stage.slots(), first = versions.front()->stages[i]->slots();
      if (!std::equal(slots.begin(), slots.end(), first.begin(), first.end(), same_rows))
        throw std::invalid_argument("versions of a problem with different rows: " + stage.name());
      of_stage.push_back(&stage);
    }
    stages_.push_back(std::make_unique<ScenarioStage>(std::move(of_stage), states, resources, limited));
    problem_.stages[i] = stages_.back().get();
  }
}

}  // namespace millwright::solver
