// SPDX-License-Identifier: Apache-2.0
//
// Other solvers on the stack family, each in a process of its own with a time limit: whatever it does, the table goes
// on. A peer reports every better design that it finds and, at the end, whether it claims the last one to be optimal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/stack_model.h"

namespace stack::peers {

/// What is chosen for an axis; rows of the instance's tables.
struct Choice {
  std::uint32_t screw = 0, motor = 0;
  double ramp = 0.0;  ///< acceleration time [s]
};
using Design = std::vector<Choice>;  ///< [axis]

/// A screw and a motor on a certain axis, and the largest moved mass that they can carry at their best ramp: what of
/// the physics a solver must know that is given a table instead.
struct Pair {
  std::uint32_t screw = 0, motor = 0;
  double cost = 0.0, mass = 0.0, capacity = 0.0;
};
struct Table {
  std::vector<std::vector<Pair>> all;     ///< [axis], ascending in cost; those that carry the axis itself
  std::vector<std::vector<Pair>> useful;  ///< [axis]: those that no other beats in cost, mass and capacity
};
Table make_table(const Instance& instance);

/// The best ramp for a pair and what it can carry with it; minus infinity if nothing.
std::pair<double, double> best_ramp(const Axis& axis, const double* screw, const double* motor);

struct Question {
  const Instance& instance;
  const Table& table;
  double seconds;
  std::filesystem::path folder;  ///< for generated models
};

/// Said by a peer to the process that waits for it.
class Report {
 public:
  explicit Report(int to) : to_(to) {}
  /// A design, better than those before.
  void found(const Design& design) const;
  /// The latest is claimed to be optimal.
  void claim() const;

 private:
  int to_;
};

struct Peer {
  std::string name;
  std::string package;  ///< that brings it; empty: it is always there
  bool available = true;
  std::function<void(const Question&, const Report&)> run;
};

struct Outcome {
  std::optional<Design> design;
  bool claimed = false, crashed = false, stopped = false;
  double seconds = 0.0;        ///< until it ended or was ended
  double found_seconds = 0.0;  ///< until its last design
};
Outcome run_isolated(const Peer& peer, const Question& question);

/// Whether a program is on the path.
bool on_path(const std::string& program);
/// Runs a command and hands over its lines as they come.
void each_line(const std::string& command, const std::function<void(const std::string&)>& line);

/// How much the worst constraint is exceeded by (0 and less: a design), cost and mass: by the exact model itself.
struct Worth {
  double excess = 0.0, cost = 0.0, mass = 0.0;
};
Worth worth_of(const Instance& instance, const Design& design);

Peer brute_force();
Peer cbc(bool useful_only);
Peer minizinc_table(bool useful_only);
Peer minizinc_physics();
Peer bonmin(const std::string& algorithm);
Peer pagmo(const std::string& algorithm);
Peer isres();

}  // namespace stack::peers
