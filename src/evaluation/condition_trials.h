// SPDX-License-Identifier: Apache-2.0
//
// A machine solved again and again with some of what is asked of it changed.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/explanation.h"

namespace millwright::evaluation {

/// Thrown when a solve ended without proof: nothing more can be said.
struct TimeIsUp {};

/// Thrown when only this question took too long.
struct Unsettled {};

class ConditionTrials {
 public:
  ConditionTrials(const machine::Asked& asked,
                  const catalogue::Catalogue& whole,
                  const std::vector<machine::Condition>& conditions,
                  const SearchOptions& options,
                  ExplanationProgress progress,
                  double patience = usual_patience);

  using Change = std::function<void(machine::Asked&)>;

  /// The best build by the options' objective with a change of what is asked; none if nothing is compliant. Throws
  /// TimeIsUp. `tolerances`: with the check of its stated tolerances.
  std::optional<Design> best(const std::string& what, const Change& change, bool tolerances = false);
  /// The same with no more time than the patience; throws Unsettled too.
  std::optional<Design> best_soon(const std::string& what, const Change& change);
  /// The same by another objective.
  std::optional<Design> best_by(const std::string& objective, const std::string& what, const Change& change);
  /// Whether anything is compliant: the first build that is found is enough.
  bool possible(const std::string& what, const Change& change);
  /// Whether all conditions of a set can be met together, the others lifted. Asked once for each set.
  bool possible(const ConditionSet& imposed);

  /// Independent questions at the same time: ask(i) for every i < count, each then solved by a single thread. Throws
  /// what one of them threw, after all of them.
  void at_once(std::size_t count, const std::function<void(std::size_t)>& ask);

  /// Lifts all that are not in the (ascending) set.
  void lift_others(const ConditionSet& imposed, machine::Asked& asked) const;
  [[nodiscard]] ConditionSet all() const;

  /// A solve of the caller's own: counts it, and returns the options with the time that is left, or the patience.
  SearchOptions begin(const std::string& what, bool patiently = true);
  /// After a solve that ended without proof: throws TimeIsUp if there is no time for others either.
  void check_time() const;
  /// The parts that may be used.
  const catalogue::Catalogue& catalogue_for(const machine::Asked& asked);
  [[nodiscard]] const machine::Asked& asked() const { return asked_; }
  [[nodiscard]] const std::vector<machine::Condition>& conditions() const { return conditions_; }
  [[nodiscard]] std::size_t solves() const { return solves_; }
  [[nodiscard]] double seconds() const;

 private:
  std::optional<Design> solve(const SearchOptions& options, const Change& change);
  [[nodiscard]] double left() const { return options_.time_limit_seconds - seconds(); }

  const machine::Asked& asked_;
  const catalogue::Catalogue& whole_;
  const std::vector<machine::Condition>& conditions_;
  SearchOptions options_;
  ExplanationProgress progress_;
  double patience_;
  double started_ = 0.0;
  std::size_t solves_ = 0;
  bool at_once_ = false;
  std::mutex mutex_;  ///< of what follows, and of the progress
  std::map<ConditionSet, bool> known_;
  std::map<std::string, std::unique_ptr<catalogue::Catalogue>> catalogues_;  ///< by what is left out
};

}  // namespace millwright::evaluation
