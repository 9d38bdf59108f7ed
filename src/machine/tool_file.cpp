// SPDX-License-Identifier: Apache-2.0
//
// What a problem file asks of the machine as a whole: [tool], the force on the tool and how far it may give way, with
// what every axis must say for that.
#include <fmt/format.h>

#include <algorithm>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "text/nearest.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::TableReader;

std::optional<std::size_t> read_direction_name(TableReader& table, const text::Key& key) {
  const auto word = table.word(key, {"x", "y", "z"});
  if (!word) return std::nullopt;
  const auto found = std::find(direction_names.begin(), direction_names.end(), *word);
  return static_cast<std::size_t>(found - direction_names.begin());
}

void read_axis_directions(TableReader& table, Axis& axis, Diagnostics& diagnostics) {
  const bool vertical = axis.direction == Direction::vertical;
  axis.along = read_direction_name(table,
                                   {"along",
                                    "direction of the machine in which the axis travels; follows from a name x or y, "
                                    "and where the axis is vertical"});
  axis.normal = read_direction_name(table,
                                    {"normal",
                                     "direction of the machine in which its guides press; z where the axis is "
                                     "horizontal, unless its rails stand on a "
                                     "face"});
  if (axis.along && axis.direction != Direction::inclined && (*axis.along == upright) != vertical)
    diagnostics.error(table.find("along")->span(),
                      fmt::format("along: axis '{}' is {}", axis.name, vertical ? "vertical" : "horizontal"),
                      vertical ? "a vertical axis travels along z" : "a horizontal axis travels along x or y");
  if (!axis.along && vertical) axis.along = upright;
  const auto named = std::find(direction_names.begin(), direction_names.end(), axis.name);
  if (!axis.along && axis.direction == Direction::horizontal && (axis.name == "x" || axis.name == "y"))
    axis.along = static_cast<std::size_t>(named - direction_names.begin());
  const bool given = axis.normal.has_value();
  if (!axis.normal && !vertical) axis.normal = upright;
  if (given && axis.along && axis.along == axis.normal)
    diagnostics.error(table.find("normal")->span(),
                      "normal: that is the direction of the travel",
                      "the guides press across it: a horizontal axis lies on z, a vertical one leans on x or y");
}

namespace {

constexpr double usual_tool_deflection = 5e-5;  ///< m

/// What the chain from tool to workpiece asks of one axis.
void check_axis(const Node& node, const Axis& axis, const Tool& tool, Diagnostics& diagnostics) {
  const auto error = [&](const Node& where, const std::string& message, const std::string& hint) {
    diagnostics.error(where.span(), message, hint);
  };
  if (is_rotary(axis)) return;  // its bearing is taken as rigid
  if (axis.direction == Direction::inclined)
    return error(*node.find("direction"),
                 fmt::format("direction: axis '{}' is inclined, and [tool] looks along x, y and z", axis.name),
                 "leave out [tool], or take the axis as horizontal or vertical");
  if (!axis.along)
    error(node, fmt::format("along: in which direction does axis '{}' travel?", axis.name), "add along = \"x\"");
  if (tool.position_error && !axis.require.known(Requirement::position_error))
    error(node,
          fmt::format("position_error: [tool] asks for it, and axis '{}' states none", axis.name),
          "add position_error = { limit = \"0.1 mm\", over = \"300 mm\" } to [axis.require]");
  if (!axis.guide) return;
  const Node& guide = *node.find("guide");
  if (!axis.normal)
    error(guide,
          fmt::format("normal: in which direction do the guides of axis '{}' press?", axis.name),
          "add normal = \"y\" to the axis: a vertical axis leans on x or y");
  if (axis.guide->carriages < 4.0)
    error(guide, "carriages: [tool] needs the stiffness of four carriages", "a single one has no published stiffness");
  if (guide.find("tool_at") == nullptr)
    error(guide,
          fmt::format("tool_at: where is the tool, seen from the carriages of axis '{}'?", axis.name),
          "add tool_at = [\"0 mm\", \"90 mm\", \"150 mm\"]: along the travel, across it, above the guides");
}

void read_force(TableReader& table, QuantityReader& q, Tool& tool, Diagnostics& diagnostics) {
  const Node* force = q.required("force", "force = { x = \"200 N\", y = \"200 N\", z = \"100 N\" }");
  q.describe({"force", "on the tool: one for every direction, or a table of x, y and z"},
             text::Expected::quantity,
             "N",
             Sign::positive);
  text::Question by_direction;
  by_direction.key = "force";
  by_direction.expected = text::Expected::table;
  table.describe(by_direction);
  if (force == nullptr) return;
  if (!force->is_table()) {
    if (const auto all = q.of_node(*force, "force", "N", Sign::positive)) tool.force.fill(*all);
    (void)table.find("force");
    return;
  }
  const std::size_t before = diagnostics.error_count();
  TableReader inner(*force, "force of [tool]", diagnostics);
  QuantityReader components(inner, diagnostics);
  for (std::size_t i = 0; i < direction_names.size(); ++i)
    tool.force[i] =
        components.quantity_or({direction_names[i], "along that direction of the machine; 0: not asked"}, "N", 0.0);
  inner.finish();
  if (diagnostics.error_count() == before && *std::max_element(tool.force.begin(), tool.force.end()) <= 0.0)
    diagnostics.error(force->span(), "force: there is none", "write force = { x = \"200 N\" }");
}

}  // namespace

void read_tool(const Node& node, const Node* axes, Problem& problem, Diagnostics& diagnostics) {
  TableReader table(node, "[tool]", diagnostics);
  QuantityReader q(table, diagnostics);
  Tool tool;
  tool.where = node.span();
  const std::string name =
      q.required_text({"axis", "the axis that carries the tool"}, "axis = \"z\": the axis that carries the tool");
  read_force(table, q, tool, diagnostics);
  tool.deflection = q.quantity(
      {"deflection", "under each of the forces, at most; 0.05 mm where neither this nor a position_error is stated"},
      "mm",
      Sign::positive);
  tool.stiffness = q.quantity_or(
      {"stiffness", "of the tool in its holder; rigid without it"}, "N/m", tool.stiffness, Sign::positive);
  tool.position_error = q.quantity(
      {"position_error", "in any direction, with the tool pressed: deflection and the errors of the axes together"},
      "mm",
      Sign::positive);
  if (!tool.deflection && !tool.position_error) tool.deflection = usual_tool_deflection;
  table.finish();
  const auto found =
      std::find_if(problem.axes.begin(), problem.axes.end(), [&](const Axis& axis) { return axis.name == name; });
  if (found == problem.axes.end()) {
    std::vector<std::string_view> names;
    for (const Axis& axis : problem.axes) names.push_back(axis.name);
    if (!name.empty())
      diagnostics.error(table.find("axis")->span(),
                        fmt::format("axis: there is no axis {}", text::in_quotes(name)),
                        text::did_you_mean(name, names, "the name of an [[axis]]"));
  } else {
    tool.axis = static_cast<std::size_t>(found - problem.axes.begin());
  }
  for (std::size_t i = 0; i < direction_names.size(); ++i) {
    const bool travels = std::any_of(problem.axes.begin(), problem.axes.end(), [&](const Axis& axis) {
      return axis.along == i && !is_rotary(axis);
    });
    if (tool.force[i] > 0.0 && !tool.deflection && !travels)
      diagnostics.error(
          node.find("force")->span(),
          fmt::format("force: no axis travels along {}, so there is no position error", direction_names[i]),
          "add deflection = \"0.05 mm\", or leave this force out");
  }
  if (axes != nullptr && axes->size() == problem.axes.size())
    for (std::size_t i = 0; i < problem.axes.size(); ++i)
      check_axis(axes->items()[i], problem.axes[i], tool, diagnostics);
  problem.tool = tool;
  for (Axis& axis : problem.axes) axis.stiffness_counts = !is_rotary(axis);
}

}  // namespace millwright::machine
