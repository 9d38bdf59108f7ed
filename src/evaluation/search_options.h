// SPDX-License-Identifier: Apache-2.0
//
// What is asked of a search of a machine's builds, and what that is to the solver.
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "evaluation/machine_model.h"

namespace millwright::evaluation {

struct SearchOptions {
  /// By name (machine/objective.h): one to solve, two or more, of one quantity each, for a front.
  std::vector<std::string> objectives{"cost"};
  double gap = 1e-6;
  double front_tolerance = 1e-3;  ///< of a front that free dimensions move; no finer than the gap
  double time_limit_seconds = std::numeric_limits<double>::infinity();
  unsigned threads = 1;
  std::size_t builds = 1;  ///< of one objective: the best, the second best, ...; more need a model with every candidate
  bool worksheets = false;  ///< with the calculation behind every check of the designs
  /// Whether the best design, or every one of a front, holds for every value within the stated tolerances; what the
  /// time or the stop leaves unasked is unsettled.
  bool tolerances = false;
  const std::atomic<bool>* stop = nullptr;
  /// Asked by a front that was stopped before it was done: whether it may go on for a part of the time it has taken, as
  /// it may when it was stopped for want of memory that is there again. It takes `stop` back then.
  std::function<bool()> resume = {};
  std::function<void(const solver::Progress&)> progress;
  bool confirm = true;       ///< as solver::Options::confirm
  bool price_limits = true;  ///< as solver::Options::price_limits
};

/// The solver's options for these. Throws std::invalid_argument when an objective asks for what the model does not
/// count (machine::Problem::counted) or was not made for (ModelOptions::objectives), or a front for a weighted sum.
solver::Options solver_options(const MachineModel& model, const SearchOptions& options);

/// Whether this is the same for every build: a cycle of moves that take a stated time, or ramps that are given.
bool is_the_same_for_all(const MachineModel& model, std::string_view objective);

/// Whether an objective tells none of the builds of a front in three objectives apart: those of the front in the other
/// two are those in all three.
bool is_left_out(const MachineModel& model, const SearchOptions& options, std::string_view objective);

}  // namespace millwright::evaluation
