// SPDX-License-Identifier: Apache-2.0
//
// The moves of an axis in a problem file, and whether its stroke and its ramps allow them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "scalar/unit.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::Presence;
using text::TableReader;

namespace {

constexpr double rounding = 1.0 + 1e-12;  // quantities that were written in different units

std::string seconds(double time) { return scalar::format(time, scalar::Unit::of("s")); }

/// A cut gives the move its force and its speed, the feed.
void read_process(
    TableReader& table, QuantityReader& q, const std::string& title, Move& move, Diagnostics& diagnostics) {
  const Node* node = table.table({"cutting", "what the tool does in this move; gives it its force and its speed"});
  if (node == nullptr) return;
  q.refuse({"force"}, "the cut gives the force already", "leave out force or cutting");
  q.refuse({"speed"}, "the feed of the cut is the speed already", "leave out speed; feed_per_tooth sets the feed");
  move.cutting = read_cutting(*node, "cutting of " + title, diagnostics);
  if (!move.cutting) return;
  move.force = move.cutting->largest_force();
  move.speed = move.cutting->feed_speed();
}

/// A move that was measured has nothing else but its name and a dwell.
bool read_measured(TableReader& table,
                   QuantityReader& q,
                   bool rotary,
                   const std::filesystem::path& folder,
                   Move& move,
                   Diagnostics& diagnostics) {
  const Node* node = table.find(
      {"profile", "a CSV file beside the problem with a measured motion, instead of distance, time, speed and force"});
  text::Question file;
  file.expected = text::Expected::text;
  file.key = "profile";
  file.example = "\"motion.csv\"";
  table.describe(file);
  if (node == nullptr) return false;
  q.refuse({"distance", "time", "speed", "acceleration_time", "jerk"},
           "the measured profile says how the axis moves",
           "leave it out, or leave out profile");
  q.refuse({"force", "torque", "cutting"},
           "the measured profile says what acts on the axis",
           fmt::format("give the file a column {}", rotary ? "torque [N.m]" : "force [N]"));
  move.profile = read_profile(*node, rotary, folder, diagnostics);
  return true;
}

/// Of a rotary axis distances are angles and forces torques.
Move read_move(
    const Node& node, const Axis& axis, const MoveLimits& limits, const std::string& title, Diagnostics& diagnostics) {
  const bool rotary = is_rotary(axis);
  Move move;
  move.where = node.span();
  TableReader table(node, title, diagnostics);
  QuantityReader q(table, diagnostics);
  move.name = table.string({"name", "for reports"}).value_or("");
  move.dwell = q.quantity_or({"dwell", "rest after the move"}, "s", 0.0);
  if (read_measured(table, q, rotary, limits.folder, move, diagnostics)) {
    table.finish();
    return move;
  }
  move.distance = q.quantity({"distance", "from rest to rest; of a rotary axis an angle"},
                             rotary ? "rad" : "mm",
                             Sign::positive,
                             Presence::required)
                      .value_or(1.0);
  move.time = q.quantity({"time", "of the whole move; with a speed the most it may take"}, "s", Sign::positive);
  move.speed = q.quantity({"speed", "of the constant part"}, rotary ? "rpm" : "mm/s", Sign::positive);
  move.acceleration_time =
      q.quantity({"acceleration_time", "of both ramps of this move, instead of the axis's"}, "s", Sign::positive);
  move.jerk = q.quantity({"jerk", "rounds the ramps of this move"}, rotary ? "rad/s^3" : "m/s^3", Sign::positive);
  if (!move.jerk) move.jerk = axis.jerk;
  if (rotary) q.refuse({"force"}, "a table is turned against a torque", "write torque = \"2 N.m\"");
  move.force = rotary ? q.quantity_or({"torque", "of the process, against the motion"}, "N.m", 0.0)
                      : q.quantity_or({"force", "of the process, against the motion"}, "N", 0.0);
  if (rotary)
    q.refuse({"cutting"}, "cuts along a length only", "give the table the torque of the cut: torque = \"2 N.m\"");
  else
    read_process(table, q, title, move, diagnostics);
  if (node.is_table() && !table.has("time") && !table.has("speed") && !table.has("cutting"))
    diagnostics.error(node.span(),
                      fmt::format("{} needs a time or a speed", title),
                      fmt::format("add time = \"1 s\" or speed = \"20 {}\"", rotary ? "rpm" : "mm/s"));
  table.finish();
  return move;
}

/// The longest ramp with which the move can be done as its time and speed want it.
double longest_ramp(const Move& move) {
  if (!move.speed) return *move.time / 2.0;
  const double cruising = move.distance / *move.speed;
  return move.time ? std::min(cruising, *move.time - cruising) : cruising;
}

class MoveCheck {
 public:
  MoveCheck(const Node& node, const Move& move, bool rotary, const MoveLimits& limits, Diagnostics& diagnostics)
      : node_(node), move_(move), rotary_(rotary), limits_(limits), diagnostics_(diagnostics) {}

  /// The shortest ramp that the axis's range or the move's own ramp allows must fit.
  void ramps(const Range& range) {
    const double ramp = move_.acceleration_time.value_or(range.lower);
    if (longest_ramp(move_) * rounding >= ramp) return jerk(range);
    if (move_.speed && move_.time && move_.distance / *move_.speed + ramp > *move_.time * rounding) {
      complain("time",
               fmt::format("the move cannot be done in {}: at {} and with ramps of {} it takes {}",
                           seconds(*move_.time),
                           speed(),
                           seconds(ramp),
                           seconds(move_.distance / *move_.speed + ramp)),
               "allow more time, more speed or shorter ramps");
    } else if (move_.speed) {
      complain(
          "speed",
          fmt::format("{} is never reached: ramps of {} take longer than the distance allows", speed(), seconds(ramp)),
          fmt::format("make acceleration_time {} or less, or lower the speed", seconds(longest_ramp(move_))));
    } else {
      complain(
          "time",
          fmt::format(
              "the move is faster than its ramps allow: two ramps of {} in {}", seconds(ramp), seconds(*move_.time)),
          fmt::format("make acceleration_time {} or less, or allow more time", seconds(longest_ramp(move_))));
    }
  }

 private:
  /// The longest ramp there is time for must be long enough for the jerk: 2 sqrt(v/j).
  void jerk(const Range& range) {
    if (!move_.jerk) return;
    const double ramp = std::min(longest_ramp(move_), move_.acceleration_time.value_or(range.upper));
    const double reached = move_.speed ? *move_.speed : move_.distance / (*move_.time - ramp);
    const double needed = 2.0 * std::sqrt(reached / *move_.jerk);
    if (needed <= ramp * rounding) return;
    const scalar::Unit unit = scalar::Unit::of(rotary_ ? "rad/s^3" : "m/s^3");
    complain("jerk",
             fmt::format("at {} a ramp to {} takes {}, and there is time for {}",
                         scalar::format(*move_.jerk, unit),
                         scalar::format(reached, scalar::Unit::of(rotary_ ? "rpm" : "mm/s")),
                         seconds(needed),
                         seconds(ramp)),
             fmt::format("allow {} or more, longer ramps or less speed",
                         scalar::format(1.0005 * 4.0 * reached / (ramp * ramp), unit)));
  }

  std::string speed() const { return scalar::format(*move_.speed, scalar::Unit::of(rotary_ ? "rpm" : "mm/s")); }

  void complain(const char* key, const std::string& message, const std::string& hint) {
    text::Diagnostic diagnostic;
    const Node* said = node_.find(key);
    if (said == nullptr && std::string_view(key) == "jerk") said = limits_.jerk_given;
    if (said == nullptr) said = node_.find("cutting");
    diagnostic.where = said != nullptr ? said->span() : node_.span();
    diagnostic.message = fmt::format("{}: {}", key, message);
    diagnostic.hint = hint;
    const Node* own = node_.find("acceleration_time");
    const Node* ramps = own != nullptr ? own : limits_.ramps_given;
    if (ramps != nullptr) {
      diagnostic.related = ramps->span();
      diagnostic.related_message = "ramps given here";
    } else {
      diagnostic.hint += "; without acceleration_time ramps of 0.05 s to 0.5 s are assumed";
    }
    diagnostics_.add(std::move(diagnostic));
  }

  const Node& node_;
  const Move& move_;
  bool rotary_;
  const MoveLimits& limits_;
  Diagnostics& diagnostics_;
};

/// A range of ramps of which a part is of no use, because a move has no time for it.
void warn_of_idle_ramps(const std::vector<const Move*>& moves,
                        const Axis& axis,
                        const Node* given,
                        Diagnostics& diagnostics) {
  if (given == nullptr || axis.acceleration_time.fixed() || !given->is_array()) return;
  const Move* tightest = nullptr;
  double limit = axis.acceleration_time.upper;
  for (const Move* move : moves) {
    if (!uses_chosen_ramp(*move) || longest_ramp(*move) * rounding >= limit) continue;
    limit = longest_ramp(*move);
    tightest = move;
  }
  if (tightest == nullptr || limit * rounding < axis.acceleration_time.lower) return;
  text::Diagnostic diagnostic;
  diagnostic.severity = text::Severity::warning;
  diagnostic.where = given->at(1).span();
  diagnostic.message =
      fmt::format("acceleration_time: a move of axis '{}' has no time for ramps above {}", axis.name, seconds(limit));
  diagnostic.hint = fmt::format("end the range at \"{}\"", seconds(limit));
  diagnostic.related = tightest->where;
  diagnostic.related_message = "this move";
  diagnostics.add(std::move(diagnostic));
}

/// Whether the ramps and the stroke of its axis allow a move.
void check_move(
    const Node& node, const Move& move, const MoveLimits& limits, const Axis& axis, Diagnostics& diagnostics) {
  if (move.profile) {
    // Sums of speeds have a rounding of their own.
    if (limits.stroke)
      check_travel(node.find("profile")->span(), "profile", move.profile->extent * (1.0 - 1e-9), axis, diagnostics);
    return;
  }
  if (limits.ramps) check_ramps(node, move, is_rotary(axis), limits, axis.acceleration_time, diagnostics);
  if (limits.stroke) check_travel(node.find("distance")->span(), "distance", move.distance, axis, diagnostics);
}

}  // namespace

void check_ramps(const Node& node,
                 const Move& move,
                 bool rotary,
                 const MoveLimits& limits,
                 const Range& ramps,
                 Diagnostics& diagnostics) {
  MoveCheck(node, move, rotary, limits, diagnostics).ramps(ramps);
}

void check_travel(
    const SourceSpan& where, std::string_view what, double travel, const Axis& axis, Diagnostics& diagnostics) {
  if (travel <= axis.stroke * rounding) return;
  const scalar::Unit unit = scalar::Unit::of(is_rotary(axis) ? "deg" : "mm");
  diagnostics.error(where,
                    fmt::format("{}: {} is longer than the stroke of axis '{}', {}",
                                what,
                                scalar::format(travel, unit, 6),
                                axis.name,
                                scalar::format(axis.stroke, unit, 6)),
                    "lengthen the stroke or shorten the move");
}

void settle_ramps(Axis& axis) {
  const bool chosen = std::any_of(axis.moves.begin(), axis.moves.end(), uses_chosen_ramp);
  if (!chosen && !axis.moves.empty()) axis.acceleration_time.upper = axis.acceleration_time.lower;
}

void read_moves(const Node& moves, const MoveLimits& limits, Axis& axis, Diagnostics& diagnostics) {
  if (moves.size() == 0)
    diagnostics.error(moves.span(), fmt::format("axis '{}' has no moves", axis.name), "add an [[axis.moves]]");
  std::map<std::string, SourceSpan> names;
  std::vector<bool> sound;
  for (const Node& node : moves.items()) {
    const std::size_t before = diagnostics.error_count();
    axis.moves.push_back(read_move(node, axis, limits, fmt::format("move of axis '{}'", axis.name), diagnostics));
    const Move& move = axis.moves.back();
    sound.push_back(diagnostics.error_count() == before);
    if (sound.back()) check_move(node, move, limits, axis, diagnostics);
    const Node* name = node.find("name");
    if (name == nullptr || move.name.empty()) continue;
    const auto [first, added] = names.try_emplace(move.name, name->span());
    if (added) continue;
    text::Diagnostic twice;
    twice.where = name->span();
    twice.message = fmt::format("name: axis '{}' has two moves {}", axis.name, text::in_quotes(move.name));
    twice.hint = "give each move its own name, or none";
    twice.related = first->second;
    twice.related_message = "first here";
    diagnostics.add(std::move(twice));
  }
  std::vector<const Move*> readable;
  for (std::size_t i = 0; i < axis.moves.size(); ++i)
    if (sound[i]) readable.push_back(&axis.moves[i]);
  if (std::any_of(axis.moves.begin(), axis.moves.end(), [](const Move& move) { return move.profile.has_value(); }))
    settle_ramps(axis);
  if (limits.ramps) warn_of_idle_ramps(readable, axis, limits.ramps_given, diagnostics);
}

}  // namespace millwright::machine
