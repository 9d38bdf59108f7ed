// SPDX-License-Identifier: Apache-2.0
//
// One axis of a problem file. Its mechanism, motor and guide are read by mechanism_file.cpp, its moves by
// move_file.cpp, its structure by member_file.cpp.
#include "machine/axis_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "machine/guide_system.h"
#include "machine/name_reader.h"
#include "machine/quantity_reader.h"
#include "scalar/unit.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::Presence;
using text::TableReader;

namespace {

constexpr double right_angle = 1.57079632679489662;
constexpr double long_stroke = 10.0;  // m

SourceSpan place(const TableReader& table, std::string_view key) {
  const Node* node = table.node().find(key);
  return node == nullptr ? table.node().span() : node->span();
}

void read_direction(TableReader& table, QuantityReader& q, Axis& axis, Diagnostics& diagnostics) {
  const std::vector<std::string> directions{"horizontal", "vertical", "inclined"};
  const std::string direction = table.word_or({"direction", "of the travel"}, directions, "horizontal");
  const Node* said = table.find("direction");
  const bool wrong =
      said != nullptr &&
      std::find(directions.begin(), directions.end(), said->as_string().value_or("")) == directions.end();
  const auto inclination = q.quantity(
      {"inclination", "of an inclined axis, from 0 deg, level, to 90 deg, upright"}, "deg", Sign::not_negative);
  axis.direction = direction == "vertical"   ? Direction::vertical
                   : direction == "inclined" ? Direction::inclined
                                             : Direction::horizontal;
  axis.inclination = axis.direction == Direction::vertical   ? right_angle
                     : axis.direction == Direction::inclined ? inclination.value_or(0.0)
                                                             : 0.0;
  if (wrong) return;
  const bool inclined = axis.direction == Direction::inclined;
  if (inclined && !table.has("inclination"))
    diagnostics.error(place(table, "direction"), "direction: inclined by how much?", "add inclination = \"30 deg\"");
  if (!inclined && table.has("inclination"))
    diagnostics.error(place(table, "inclination"),
                      fmt::format("inclination: the axis is {}", direction),
                      "write direction = \"inclined\", or leave the inclination out");
  if (inclined && axis.inclination > right_angle * (1.0 + 1e-12))
    diagnostics.error(
        place(table, "inclination"), "inclination: more than upright", "from 0 deg, horizontal, to 90 deg, vertical");
}

void read_loads(TableReader& table, QuantityReader& q, Axis& axis, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.error_count();
  axis.structure_mass =
      q.quantity_or({"structure_mass",
                     "what moves with the axis and is not chosen here: slide, table, cables; chosen parts add theirs"},
                    "kg",
                    0.0);
  axis.payload_mass = q.quantity_or({"payload_mass", "tool or workpiece"}, "kg", 0.0);
  const bool masses = diagnostics.error_count() == before;
  axis.guide_friction = q.quantity_or(
      {"guide_friction",
       "coefficient on the weight that presses on the guides: rails 0.003 to 0.01, plain slides 0.05 to 0.2"},
      "1",
      0.0);
  axis.guide_drag = q.quantity_or({"guide_drag", "friction whatever the load: seals, wipers, hoses"}, "N", 0.0);
  axis.counterbalance_force =
      q.quantity_or({"counterbalance_force", "of a spring that carries a part of a vertical axis"}, "N", 0.0);
  warn_above(table.node(),
             "guide_friction",
             axis.guide_friction,
             0.5,
             "rails have 0.003 to 0.01, plain slides 0.05 to 0.2",
             diagnostics);
  if (masses && axis.structure_mass + axis.payload_mass == 0.0)
    diagnostics.warning(place(table, "structure_mass"),
                        fmt::format("structure_mass: nothing of axis '{}' has a mass but its chosen parts", axis.name),
                        "give the mass of the slide or table: structure_mass = \"5 kg\"");
  if (axis.inclination == 0.0 && axis.counterbalance_force > 0.0)
    diagnostics.warning(place(table, "counterbalance_force"),
                        "counterbalance_force: a horizontal axis has no weight to balance",
                        "leave it out, or write direction = \"vertical\"");
}

/// Slots and settings that every axis or the machine has; a member of that name would hide them.
bool is_reserved(const std::string& name) {
  constexpr std::string_view reserved[] = {"screw",
                                           "nut",
                                           "motor",
                                           "driver",
                                           "coupling",
                                           "support_fixed",
                                           "support_free",
                                           "guide",
                                           "belt",
                                           "pulley_drive",
                                           "pulley_idle",
                                           "rack",
                                           "pinion",
                                           "reduction",
                                           "supply",
                                           "supply_voltage",
                                           "acceleration_time",
                                           "machine"};
  return std::find(std::begin(reserved), std::end(reserved), name) != std::end(reserved);
}

/// One joint for each motor, or for each carriage.
void count_joints(const Axis& axis, const Node& node, Member& member, Diagnostics& diagnostics) {
  if (member.kind != MemberKind::bolts || member.bolts.holds == Held::burden) return;
  if (member.bolts.holds == Held::motor) {
    member.count = axis.mechanism.drives;
    return;
  }
  member.rides = true;  // the slide is screwed to its carriages
  if (axis.guide)
    member.count = axis.guide->carriages;
  else
    diagnostics.error(node.find("holds")->span(),
                      fmt::format("holds: axis '{}' has no guide that is chosen here", axis.name),
                      "add guide = { ... } to the axis, or say holds = \"axis\"");
}

void read_members(const Node& members, Axis& axis, Diagnostics& diagnostics) {
  std::map<std::string, SourceSpan> names;
  for (const Node& node : members.items()) {
    axis.members.push_back(read_member(node, axis.name, diagnostics));
    count_joints(axis, node, axis.members.back(), diagnostics);
    const Node* name = node.find("name");
    if (name == nullptr || !check_name(*name, "a member", diagnostics)) continue;
    const std::string& word = axis.members.back().name;
    if (is_reserved(word)) {
      diagnostics.error(name->span(),
                        fmt::format("name: a member cannot be called '{}'", word),
                        "a slot of the axis has that name; call it after what it is: beam, column, shaft, weld");
      continue;
    }
    const auto [first, added] = names.try_emplace(word, name->span());
    if (added) continue;
    text::Diagnostic twice;
    twice.where = name->span();
    twice.message = fmt::format("name: axis '{}' has two members '{}'", axis.name, word);
    twice.hint = "give each member its own name";
    twice.related = first->second;
    twice.related_message = "first here";
    diagnostics.add(std::move(twice));
  }
}

/// What is set at the driver is said once: as currents, or as a share of each motor's rated one.
void check_current_keys(const Node& axis, Diagnostics& diagnostics) {
  const auto key = [&](const char* table, const char* name) -> const Node* {
    const Node* inner = axis.find(table);
    return inner == nullptr || !inner->is_table() ? nullptr : inner->find(name);
  };
  const Node* factor = key("require", "current_factor");
  const Node* current = key("motor", "current");
  if (factor == nullptr || current == nullptr) return;
  text::Diagnostic both;
  both.where = factor->span();
  both.message = "current_factor: the motor's current is given, so that there is nothing to multiply";
  both.hint = "leave one of the two out";
  both.related = current->span();
  both.related_message = "given here";
  diagnostics.add(std::move(both));
}

void read_parts(TableReader& table, QuantityReader& q, Axis& axis, Diagnostics& diagnostics) {
  const std::string of = fmt::format(" of axis '{}'", axis.name);
  if (q.required("mechanism", "mechanism = { kind = \"screw\", screw = [\"lead_screws\"] }") != nullptr)
    if (const Node* mechanism = table.table({"mechanism", "what turns the motor into travel"}); mechanism != nullptr)
      axis.mechanism = read_mechanism(*mechanism, "mechanism" + of, diagnostics);
  if (const Node* motor = table.table({"motor", "which motors may be taken"}); motor != nullptr)
    axis.motor = read_motor(*motor, "motor" + of, diagnostics);
  if (const Node* guide = table.table({"guide", "what the axis slides on; without it guides are not chosen here"});
      guide != nullptr)
    axis.guide = read_guide(*guide, "guide" + of, diagnostics);
  if (const Node* members = table.array({"members", "structure that carries the axis and is sized by the search"});
      members != nullptr)
    read_members(*members, axis, diagnostics);
  if (const Node* require = table.table({"require", "what this axis must keep"}); require != nullptr)
    read_requirements(*require, "[axis.require]" + of, axis.require, diagnostics);
  if (const Node* require = table.find("require"); require != nullptr)
    check_accuracy_keys(*require, is_rotary(axis), diagnostics);
  check_current_keys(table.node(), diagnostics);
}

void check_stroke(TableReader& table, const Axis& axis, Diagnostics& diagnostics) {
  if (axis.stroke > long_stroke)
    diagnostics.warning(
        place(table, "stroke"),
        fmt::format("stroke: {} is a long way for a machine tool", scalar::format(axis.stroke, scalar::Unit::of("m"))),
        "is it meant in mm?");
  if (axis.mechanism.length && *axis.mechanism.length < axis.stroke)
    diagnostics.error(table.find("mechanism")->find("length")->span(),
                      fmt::format("length: the screw is shorter than the stroke of axis '{}'", axis.name),
                      "the supported length is stroke, nut and overtravel; leave it out to have it worked out");
}

}  // namespace

Axis read_axis(const Node& node, const AxisSurroundings& around, Diagnostics& diagnostics) {
  Axis axis;
  axis.where = node.span();
  axis.require = around.require;
  const Node* name = node.find("name");
  const std::string known_as = name == nullptr ? "" : name->as_string().value_or("");
  TableReader table(node, known_as.empty() ? "axis" : fmt::format("axis '{}'", known_as), diagnostics);
  QuantityReader q(table, diagnostics);
  axis.name = q.required_text(
      {"name", "letter, then letters, digits, _ and -; stands in bills of materials and in --set"}, "name = \"x\"");
  if (name != nullptr) (void)check_name(*name, "an axis", diagnostics);
  if (!says_rotary(node))
    axis.carries = table.strings({"carries", "axes that ride on this one: their masses and chosen parts are its load"});
  const bool rotary = says_rotary(node);
  if (!rotary) {
    read_direction(table, q, axis, diagnostics);
    read_axis_directions(table, axis, diagnostics);
  }
  const auto stroke = q.quantity({"stroke", "usable travel; of a rotary axis an angle"},
                                 rotary ? "rad" : "mm",
                                 Sign::positive,
                                 Presence::required);
  axis.stroke = stroke.value_or(0.1);
  if (rotary)
    read_rotary_loads(table, axis, diagnostics);
  else
    read_loads(table, q, axis, diagnostics);
  const auto ramps = q.range(
      {"acceleration_time", "duration of each ramp: one value, or a range to choose from; 0.05 s to 0.5 s without it"},
      "s");
  axis.acceleration_time = ramps.value_or(axis.acceleration_time);
  axis.jerk = q.quantity({"jerk", "rounds the ramps of all moves that state no jerk of their own"},
                         rotary ? "rad/s^3" : "m/s^3",
                         Sign::positive);
  read_parts(table, q, axis, diagnostics);
  if (stroke && !rotary) check_stroke(table, axis, diagnostics);
  if (axis.guide && rails_on_face(axis) && !axis.guide->load_height_stated)
    diagnostics.warning(
        axis.guide->where,
        "guide: its rails stand on a face, so that the load hangs before them; how far is not said",
        "add load_height, from the rails to the centre of what moves; \"0 mm\" if it hangs in their plane");
  const Node* given = table.find("acceleration_time");
  const bool others = around.together.count(axis.name) > 0 && !table.has("moves");
  if (!others && q.required("moves", "an [[axis.moves]] with distance and time") != nullptr)
    if (const Node* moves = table.array({"moves", "what the axis does in a cycle"}); moves != nullptr)
      read_moves(*moves,
                 {stroke.has_value(), given == nullptr || ramps.has_value(), given, table.find("jerk"), around.folder},
                 axis,
                 diagnostics);
  table.finish();
  return axis;
}

}  // namespace millwright::machine
