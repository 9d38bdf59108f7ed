// SPDX-License-Identifier: Apache-2.0
//
// Several versions of one problem that a build has to satisfy all: the same slots, variables and constraints, other
// numbers. A build chooses rows and variables once; every version has its own state and its own constraints; resources
// count by the first version, and limits hold in every one.
#pragma once

#include <memory>
#include <vector>

#include "solver/stage.h"

namespace millwright::solver {

class ScenarioStage final : public Stage {
 public:
  /// `states`: how long the state of each version is. `limited`: resources with a limit, which are counted once more
  /// for every version but the first. All versions must have the same slots and variables.
  ScenarioStage(std::vector<const Stage*> versions,
                std::vector<std::size_t> states,
                std::size_t resources,
                std::vector<std::size_t> limited);

  [[nodiscard]] const std::string& name() const override { return versions_.front()->name(); }
  [[nodiscard]] std::span<const Slot> slots() const override { return versions_.front()->slots(); }
  [[nodiscard]] std::span<const Variable> variables() const override { return versions_.front()->variables(); }
  [[nodiscard]] std::size_t constraints() const override;
  void read(std::span<const Row> shared,
            std::size_t slot,
            std::span<const Row> rows,
            std::vector<Interval>& readings) const override;
  void evaluate(const Point& point, Answer<double>& answer) const override;
  void bound(const Box& box, Answer<Interval>& answer) const override;
  void slopes(const Box& box, Input input, Answer<Interval>& answer) const override;
  void gradient(const Point& point, Input input, Answer<double>& answer) const override;
  [[nodiscard]] bool fits(
      std::span<const Row> shared, std::size_t slot_a, Row row_a, std::size_t slot_b, Row row_b) const override;
  [[nodiscard]] bool may_misfit(std::size_t slot_a, std::size_t slot_b) const override;
  [[nodiscard]] bool offered(std::span<const Row> shared, std::size_t slot, Row row) const override;
  [[nodiscard]] FitKey fit_key(std::span<const Row> shared,
                               std::size_t slot,
                               Row row,
                               std::size_t other_slot) const override;
  [[nodiscard]] double combinations(std::span<const std::vector<Row>> rows) const override {
    return versions_.front()->combinations(rows);
  }

 private:
  template <class T, class Ask>
  void gather(Answer<T>& answer, Ask&& ask) const;
  template <class T, class Ask>
  void gather_slopes(Input input, Answer<T>& answer, Ask&& ask) const;
  struct VersionBoxes;

  std::vector<const Stage*> versions_;
  std::vector<std::size_t> states_;
  std::size_t resources_;
  std::vector<std::size_t> limited_;
};

class ScenarioProblem {
 public:
  /// Refers to the stages of the versions. Throws std::invalid_argument if they have not the same slots and variables.
  explicit ScenarioProblem(const std::vector<const Problem*>& versions);
  [[nodiscard]] const Problem& problem() const { return problem_; }

 private:
  std::vector<std::unique_ptr<ScenarioStage>> stages_;
  Problem problem_;
};

}  // namespace millwright::solver
