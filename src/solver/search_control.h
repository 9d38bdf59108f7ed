// SPDX-License-Identifier: Apache-2.0
//
// What all parts of one solve share: the options, the threads with their desks, the clock, the counters.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/box.h"
#include "solver/crew.h"
#include "solver/solver.h"

namespace millwright::solver {

class SearchControl {
 public:
  explicit SearchControl(const Options& options)
      : options_(options),
        crew_(options.threads < 1 ? 1 : options.threads),
        desks_(crew_.size()),
        start_(std::chrono::steady_clock::now()),
        reported_(start_) {}

  std::uint64_t nodes = 0;
  std::uint64_t earlier_nodes = 0;  ///< of searches that this one began; they have limits of their own

  [[nodiscard]] const Options& options() const { return options_; }
  Crew& crew() { return crew_; }
  Desk& desk(unsigned thread) { return desks_[thread]; }
  [[nodiscard]] double seconds() const { return since(start_); }
  [[nodiscard]] bool time_is_up() const {
    if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) return true;
    if (nodes > options_.most_nodes) return true;
    return options_.time_limit_seconds < 1e300 && seconds() >= options_.time_limit_seconds;
  }
  /// What a front is to be covered to by now: what was asked for, or, where it widens, more with every part of the time
  /// that is used up.
  [[nodiscard]] double tolerance_of_front() const {
    constexpr double widest = 0.2;  // of what is wider still, little would be proved
    const double asked = options_.tolerance_of_front();
    if (!options_.widens || !(asked < widest)) return asked;
    const double used = std::max(seconds() / options_.time_limit_seconds,
                                 static_cast<double>(nodes) / static_cast<double>(options_.most_nodes));
    return asked * std::pow(widest / asked, std::clamp(used, 0.0, 1.0));
  }
  /// False when time was up before `preparation`, which asks the first desk, was done.
  template <class Preparation>
  bool while_there_is_time(Preparation&& preparation) {
    Desk& asked = desk(0);
    asked.interrupt = [this] { return time_is_up(); };
    bool done = true;
    try {
      preparation();
    } catch (const OutOfTime&) {
      done = false;
    }
    asked.interrupt = nullptr;
    return done;
  }
  [[nodiscard]] std::uint64_t evaluations() const {
    std::uint64_t sum = 0;
    for (const Desk& desk : desks_) sum += desk.bounds + desk.evaluations;
    return sum;
  }
  /// Says which part of the problem is at work: nothing in it is below `here`, and nothing below `elsewhere` in what is
  /// still to be done.
  void enter(double here, double elsewhere) {
    here_ = here;
    elsewhere_ = elsewhere;
  }
  /// Progress of the whole, now and then; `lower_bound()` is of the part at work, and is asked when it is told.
  template <class Bound>
  void report(Bound&& lower_bound, double incumbent) {
    if (!options_.progress || since(reported_) < options_.progress_interval_seconds) return;
    reported_ = std::chrono::steady_clock::now();
    // What was proved once stays proved.
    proved_ = std::max(proved_, std::min({std::max(lower_bound(), here_), elsewhere_, incumbent}));
    options_.progress(Progress{proved_, incumbent, seconds(), nodes + earlier_nodes});
  }
  /// From a method that knows no bound of its own.
  void report(double incumbent) {
    report([this] { return here_; }, incumbent);
  }

 private:
  using Instant = std::chrono::steady_clock::time_point;
  static double since(Instant then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
  }

  const Options& options_;
  Crew crew_;
  std::vector<Desk> desks_;
  Instant start_, reported_;
  double here_ = -std::numeric_limits<double>::infinity();
  double elsewhere_ = std::numeric_limits<double>::infinity();
  double proved_ = -std::numeric_limits<double>::infinity();
};

}  // namespace millwright::solver
