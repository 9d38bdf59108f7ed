// SPDX-License-Identifier: Apache-2.0
//
// Coordinated moves: [[moves]] of a machine, in which several axes go along a straight line, starting and ending
// together. Speed, ramp and time are those of the path; every axis does its share of them, the direction cosine, so
// that such a move is one ordinary move of each axis.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "text/nearest.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::TableReader;

namespace {

/// What one axis does in a move of several.
struct Part {
  std::size_t axis = 0;
  double distance = 0.0;
  double force = 0.0;
  const Node* where = nullptr;
};

class CoordinatedReader {
 public:
  CoordinatedReader(bool strokes, Problem& problem, Diagnostics& diagnostics)
      : strokes_(strokes), problem_(problem), diagnostics_(diagnostics) {}

  void read(const Node& node) {
    const std::size_t before = diagnostics_.error_count();
    TableReader table(node, "coordinated move", diagnostics_);
    QuantityReader q(table, diagnostics_);
    Move path;
    path.where = node.span();
    path.name = q.required_text({"name", "of the move; new among the moves of all its axes"}, "name = \"diagonal\"");
    q.refuse({"distance"}, "each axis goes its own", "write axes = { x = \"100 mm\", y = \"50 mm\" }");
    q.refuse({"force"}, "a force acts on one axis", "write forces = { x = \"20 N\" }");
    q.refuse({"cutting"}, "a cut belongs to a move of one axis", "write forces = { x = \"20 N\" }");
    path.time = q.quantity({"time", "of the whole move; with a speed the most it may take"}, "s", Sign::positive);
    path.speed = q.quantity({"speed", "along the path"}, "mm/s", Sign::positive);
    path.acceleration_time = q.quantity(
        {"acceleration_time", "of both ramps, the same for all axes"}, "s", Sign::positive, text::Presence::required);
    path.jerk = q.quantity({"jerk", "along the path; without it the axes' own decide"}, "m/s^3", Sign::positive);
    path.dwell = q.quantity_or({"dwell", "rest after the move"}, "s", 0.0);
    if (node.is_table() && !table.has("time") && !table.has("speed"))
      diagnostics_.error(node.span(),
                         "coordinated move needs a time or a speed along its path",
                         "add time = \"1 s\" or speed = \"20 mm/s\"");
    std::vector<Part> parts = read_axes(table, q);
    read_forces(table, q, parts);
    table.finish();
    check_name(node, path, parts);
    if (diagnostics_.error_count() > before) return;
    for (const Part& part : parts) path.distance = std::hypot(path.distance, part.distance);
    take_jerk(path, parts);
    check_ramps(node, path, false, {true, true, nullptr, nullptr, {}}, {0.0, 0.0}, diagnostics_);
    // Where one of the axes goes up and down the others go there and back: together all the way.
    path.returns = std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
      return std::sin(problem_.axes[part.axis].inclination) > 1e-9;
    });
    for (const Part& part : parts) {
      path.counts_in_cycle = &part == &parts.front();
      give(path, part);
    }
  }

 private:
  std::vector<Part> read_axes(TableReader& table, QuantityReader& q) {
    std::vector<Part> parts;
    if (q.required("axes", "axes = { x = \"100 mm\", y = \"50 mm\" }") == nullptr) return parts;
    const Node* axes = table.table({"axes", "how far each axis goes"});
    if (axes == nullptr) return parts;
    if (axes->size() == 0)
      diagnostics_.error(axes->span(), "axes: no axis is named", "write axes = { x = \"100 mm\", y = \"50 mm\" }");
    TableReader distances(*axes, "axes", diagnostics_);
    QuantityReader(distances, diagnostics_)
        .describe({"*", "by the name of an axis: how far it goes"}, text::Expected::quantity, "mm", Sign::positive);
    for (const text::TableEntry& entry : axes->entries()) {
      const auto axis = find_axis(entry, "axes");
      if (!axis) continue;
      const auto distance = q.of_node(entry.value, "axes." + entry.key, "mm", Sign::positive);
      if (distance) parts.push_back({*axis, *distance, 0.0, &entry.value});
    }
    return parts;
  }

  void read_forces(TableReader& table, QuantityReader& q, std::vector<Part>& parts) {
    const Node* forces = table.table({"forces", "of the process against the motion of an axis"});
    if (forces == nullptr) return;
    const Node* axes = table.find("axes");
    TableReader values(*forces, "forces", diagnostics_);
    QuantityReader(values, diagnostics_)
        .describe({"*", "by the name of an axis of the move"}, text::Expected::quantity, "N", Sign::not_negative);
    for (const text::TableEntry& entry : forces->entries()) {
      const auto axis = find_axis(entry, "forces");
      if (!axis) continue;
      const auto force = q.of_node(entry.value, "forces." + entry.key, "N", Sign::not_negative);
      if (axes != nullptr && axes->size() > 0 && axes->find(entry.key) == nullptr)
        diagnostics_.error(entry.key_span,
                           fmt::format("forces: axis '{}' takes no part in this move", entry.key),
                           "name it in axes, or give the force to a move of its own");
      for (Part& part : parts)
        if (part.axis == *axis && force) part.force = *force;
    }
  }

  /// An axis of the problem that goes along a length.
  std::optional<std::size_t> find_axis(const text::TableEntry& entry, std::string_view key) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < problem_.axes.size(); ++i) {
      names.push_back(problem_.axes[i].name);
      if (names.back() != entry.key) continue;
      if (!is_rotary(problem_.axes[i])) return i;
      diagnostics_.error(
          entry.key_span,
          fmt::format("{}: axis '{}' turns; only axes that go along a length move together", key, entry.key),
          fmt::format("give '{}' an [[axis.moves]] of the same time", entry.key));
      return std::nullopt;
    }
    diagnostics_.error(entry.key_span,
                       fmt::format("{}: the problem has no axis {}", key, text::in_quotes(entry.key)),
                       text::did_you_mean(entry.key, names, fmt::format("axes: {}", fmt::join(names, ", "))));
    return std::nullopt;
  }

  /// The name must be new among the coordinated moves and on every axis of the move.
  void check_name(const Node& node, const Move& path, const std::vector<Part>& parts) {
    const Node* name = node.find("name");
    if (name == nullptr || path.name.empty()) return;
    const auto complain = [&](const std::string& message, const SourceSpan& first) {
      text::Diagnostic twice;
      twice.where = name->span();
      twice.message = message;
      twice.hint = "give each move its own name";
      twice.related = first;
      twice.related_message = "first here";
      diagnostics_.add(std::move(twice));
    };
    const auto [first, added] = names_.try_emplace(path.name, name->span());
    if (!added) return complain(fmt::format("name: there are two moves {}", text::in_quotes(path.name)), first->second);
    for (const Part& part : parts)
      for (const Move& own : problem_.axes[part.axis].moves)
        if (own.name == path.name)
          return complain(fmt::format("name: axis '{}' has a move {} of its own",
                                      problem_.axes[part.axis].name,
                                      text::in_quotes(path.name)),
                          own.where);
  }

  /// Without a jerk of the path, that at which no axis exceeds its own.
  void take_jerk(Move& path, const std::vector<Part>& parts) const {
    if (path.jerk) return;
    for (const Part& part : parts)
      if (const auto& own = problem_.axes[part.axis].jerk) {
        const double along = *own * path.distance / part.distance;
        path.jerk = std::min(path.jerk.value_or(along), along);
      }
  }

  void give(const Move& path, const Part& part) {
    Axis& axis = problem_.axes[part.axis];
    if (strokes_) check_travel(part.where->span(), "axes." + axis.name, part.distance, axis, diagnostics_);
    const double share = part.distance / path.distance;
    Move move = path;
    move.distance = part.distance;
    if (path.speed) move.speed = *path.speed * share;
    if (path.jerk) move.jerk = *path.jerk * share;
    move.force = part.force;
    axis.moves.push_back(std::move(move));
    settle_ramps(axis);
  }

  bool strokes_;
  Problem& problem_;
  Diagnostics& diagnostics_;
  std::map<std::string, SourceSpan> names_;
};

}  // namespace

std::set<std::string> axes_moved_together(const Node& moves) {
  std::set<std::string> names;
  for (const Node& move : moves.items())
    if (const Node* axes = move.find("axes"); axes != nullptr)
      for (const text::TableEntry& entry : axes->entries()) names.insert(entry.key);
  return names;
}

void read_coordinated_moves(const Node& moves, bool strokes, Problem& problem, Diagnostics& diagnostics) {
  CoordinatedReader reader(strokes, problem, diagnostics);
  for (const Node& node : moves.items()) reader.read(node);
}

}  // namespace millwright::machine
