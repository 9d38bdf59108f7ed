// SPDX-License-Identifier: Apache-2.0
//
// Racks and rotary tables, and the reductions of every kind of drive, in a problem file.
#include <fmt/format.h>

#include <algorithm>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "scalar/unit.h"
#include "text/nearest.h"
#include "text/number.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::Presence;
using text::TableReader;

namespace {

/// "60 USD": a number, a blank, the code of a currency.
void read_price(TableReader& table, Reduction& reduction, Diagnostics& diagnostics) {
  const Node* node = table.find({"price", "of one reduction, in a currency of the problem"});
  text::Question amount;
  amount.expected = text::Expected::amount;
  amount.key = "price";
  amount.example = "\"60 USD\"";
  table.describe(amount);
  if (node == nullptr) return;
  const std::string text = node->as_string().value_or("");
  const std::size_t blank = std::min(text.find(' '), text.size());
  const auto number = text::parse_number(std::string_view(text).substr(0, blank));
  std::string reason;
  const auto unit =
      blank < text.size() ? scalar::Unit::parse(std::string_view(text).substr(blank + 1), reason) : std::nullopt;
  if (number && *number >= 0.0 && unit && unit->kind() == scalar::UnitKind::currency &&
      unit->dimension() == scalar::dimension::none && unit->name() == unit->currency()) {
    reduction.price = *number;
    reduction.currency = unit->currency();
    return;
  }
  diagnostics.error(node->span(),
                    number && *number < 0.0 ? "price: must not be negative" : "price: an amount of money is needed",
                    "write for example \"60 USD\"");
}

/// What the output shaft of a reduction is for, or why there is none.
void read_shaft(QuantityReader& q, const Mechanism& mechanism, Reduction& reduction) {
  const auto of = [&](Presence presence) {
    reduction.shaft = q.quantity({"shaft",
                                  "diameter of the output shaft: the one that carries pinion or drive pulley; on a "
                                  "screw the one for the coupling"},
                                 "mm",
                                 Sign::positive,
                                 presence)
                          .value_or(0.014);
  };
  switch (mechanism.kind) {
    case MechanismKind::rotary:
      return q.refuse({"shaft"}, "a table has no pinion that must fit it", "leave it out");
    case MechanismKind::rack:
      if (q.required("shaft", "shaft = \"14 mm\", the output shaft that carries the pinion") != nullptr)
        of(Presence::optional);
      return;
    case MechanismKind::belt:
      if (q.required("shaft", "shaft = \"14 mm\", the output shaft that carries the drive pulley") != nullptr)
        of(Presence::optional);
      return;
    case MechanismKind::screw:
      break;
  }
  if (mechanism.nut_rotates)
    q.refuse({"shaft"}, "its last wheel sits on the nut that turns", "leave it out");
  else
    reduction.shaft = q.quantity({"shaft",
                                  "diameter of the output shaft: the one that carries pinion or drive pulley; on a "
                                  "screw the one for the coupling"},
                                 "mm",
                                 Sign::positive)
                          .value_or(0.0);
}

Reduction read_reduction(const Node& node,
                         const Mechanism& mechanism,
                         bool one_of_many,
                         const std::string& title,
                         Diagnostics& diagnostics) {
  Reduction reduction;
  reduction.where = node.span();
  TableReader table(node, title, diagnostics);
  QuantityReader q(table, diagnostics);
  if (!node.is_table()) return reduction;
  if (one_of_many || table.has("name"))
    reduction.name = q.required_text({"name", "on the bill of materials; needed where one of a list is chosen"},
                                     "name = \"3:1 belt\"");
  if (q.required("ratio", "ratio = 5") != nullptr)
    reduction.ratio =
        q.quantity_or({"ratio", "turns of the motor for one turn of the output, 1 or more"}, "1", 1.0, Sign::positive);
  if (const Node* ratio = table.find("ratio"); ratio != nullptr && reduction.ratio < 1.0)
    diagnostics.error(ratio->span(),
                      fmt::format("ratio: {:.6g} makes the output faster than the motor", reduction.ratio),
                      "turns of the motor for one turn of the output: 5 for 5:1");
  reduction.efficiency = q.share_or({"efficiency", "of the reduction"}, 0.9);
  reduction.inertia = q.quantity_or({"inertia", "at its input"}, "kg.m2", 0.0);
  reduction.backlash = q.quantity_or({"backlash", "at its output"}, "deg", 0.0);
  reduction.mass = q.quantity_or({"mass", "of one reduction"}, "kg", 0.0);
  reduction.rated_torque =
      q.quantity({"torque", "rated torque at the output; checked where it is stated"}, "N.m", Sign::positive);
  reduction.largest_speed =
      q.quantity({"speed", "largest speed of the input; checked where it is stated"}, "rpm", Sign::positive);
  reduction.stiffness =
      q.quantity({"stiffness", "at the output; counts as stiff without it"}, "N.m/rad", Sign::positive);
  read_shaft(q, mechanism, reduction);
  read_price(table, reduction, diagnostics);
  table.finish();
  return reduction;
}

/// What a list of reductions must have in common: each its own name; and on a screw, where an output shaft takes a
/// coupling that a wheel on the screw does not, all or none of them a shaft.
void check_list(const std::vector<const Node*>& nodes, const Mechanism& mechanism, Diagnostics& diagnostics) {
  const std::vector<Reduction>& all = mechanism.reductions;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (!nodes[i]->is_table()) continue;
    const auto same = std::find_if(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i), [&](const Reduction& r) {
      return !r.name.empty() && r.name == all[i].name;
    });
    if (same != all.begin() + static_cast<std::ptrdiff_t>(i)) {
      text::Diagnostic twice;
      twice.where = nodes[i]->find("name")->span();
      twice.message = fmt::format("name: two reductions are called {}", text::in_quotes(all[i].name));
      twice.hint = "give each its own name: the bill of materials tells them by it";
      twice.related = nodes[static_cast<std::size_t>(same - all.begin())]->find("name")->span();
      twice.related_message = "first here";
      diagnostics.add(std::move(twice));
    }
    if (mechanism.kind == MechanismKind::screw && (all[i].shaft > 0.0) != (all.front().shaft > 0.0))
      diagnostics.error(nodes[i]->span(),
                        "shaft: one reduction has an output shaft and another has none",
                        "with a shaft a coupling is chosen, without one the last wheel sits on the screw: list one "
                        "sort, and try the other in a second problem");
  }
}

}  // namespace

void read_reductions(TableReader& table, Mechanism& mechanism, Diagnostics& diagnostics) {
  const Node* given =
      table.find({"reduction", "between the motor and what it turns: one, or a list of which one is chosen"});
  text::Question tables;
  tables.expected = text::Expected::table_or_tables;
  tables.key = "reduction";
  table.describe(tables);
  if (given == nullptr) return;
  const std::size_t errors = diagnostics.error_count();
  const bool many = given->is_array();
  const std::vector<const Node*> nodes = table.list("reduction");
  if (many && nodes.empty())
    diagnostics.error(given->span(), "reduction: the list is empty", "list reductions, or leave the key out");
  const std::string title = "reduction in the " + table.title();
  for (const Node* node : nodes)
    mechanism.reductions.push_back(read_reduction(*node, mechanism, many, title, diagnostics));
  check_list(nodes, mechanism, diagnostics);
  for (const Node* node : nodes)
    if (diagnostics.error_count() == errors && node->is_table() && node->find("price") == nullptr)
      diagnostics.warning(node->span(),
                          title + " has no price and counts as free",
                          "add price = \"60 USD\", or \"0 USD\" if it costs nothing");
}

void read_rack(TableReader& table, Mechanism& mechanism, Diagnostics& diagnostics) {
  QuantityReader q(table, diagnostics);
  mechanism.kind = MechanismKind::rack;
  mechanism.motor_rides = table.boolean_or(
      {"motor_rides", "motor and pinion move with the axis and the rack stands; else the other way round"}, true);
  mechanism.rack_efficiency = q.share_or({"efficiency", "of the mesh of rack and pinion"}, mechanism.rack_efficiency);
  mechanism.backlash = q.quantity_or({"backlash", "of the mesh, as it is set"}, "mm", mechanism.backlash);
  warn_above(table.node(),
             "backlash",
             mechanism.backlash,
             5e-4,
             "a mesh is set to 0.05 mm to 0.2 mm, a pinion pressed on by a spring has none",
             diagnostics);
}

void read_rotary(TableReader& table, Mechanism& mechanism, Diagnostics& diagnostics) {
  mechanism.kind = MechanismKind::rotary;
  QuantityReader(table, diagnostics).refuse({"drives", "load_share"}, "a table has one motor", "leave it out");
}

bool says_rotary(const Node& axis) {
  const Node* mechanism = axis.find("mechanism");
  const Node* kind = mechanism == nullptr ? nullptr : mechanism->find("kind");
  return kind != nullptr && kind->as_string().value_or("") == "rotary";
}

void read_rotary_loads(TableReader& table, Axis& axis, Diagnostics& diagnostics) {
  QuantityReader q(table, diagnostics);
  q.refuse({"direction", "inclination"}, "a rotary axis turns, and its load is taken as balanced", "leave it out");
  q.refuse({"guide_friction", "guide_drag", "counterbalance_force"},
           "a rotary axis has none",
           "its friction is friction_torque = \"0.2 N.m\"");
  q.refuse({"guide"}, "a rotary axis has none", "the bearing of the table comes with the table");
  q.refuse({"members"}, "a rotary axis has none", "give them to the axis that carries it");
  q.refuse({"carries"}, "a rotary axis carries no axis", "let another axis carry both");
  const std::size_t before = diagnostics.error_count();
  axis.structure_mass = q.quantity_or({"structure_mass", "of the table; what carries it has to bear it"}, "kg", 0.0);
  axis.payload_mass = q.quantity_or({"payload_mass", "of the workpiece"}, "kg", 0.0);
  const bool given = q.required("structure_inertia", "structure_inertia = \"0.02 kg.m2\"") != nullptr;
  axis.inertia =
      q.quantity_or({"structure_inertia", "of the table about its axis of rotation"}, "kg.m2", 0.0, Sign::positive);
  axis.inertia += q.quantity_or({"payload_inertia", "of the workpiece about the axis of rotation"}, "kg.m2", 0.0);
  axis.friction_torque = q.quantity_or({"friction_torque", "of the bearing and seals"}, "N.m", 0.0);
  if (given && diagnostics.error_count() == before && axis.structure_mass + axis.payload_mass == 0.0)
    diagnostics.warning(table.node().find("structure_inertia")->span(),
                        fmt::format("structure_inertia: table '{}' has an inertia, but no mass", axis.name),
                        "what carries it has to bear it: structure_mass = \"3 kg\"");
}

void check_accuracy_keys(const Node& require, bool rotary, Diagnostics& diagnostics) {
  const auto refuse = [&](const char* key, const char* instead) {
    text::Question question;
    question.key = key;
    question.expected = text::Expected::not_allowed;
    if (diagnostics.listener() != nullptr) diagnostics.listener()->asked(require, question);
    if (require.find(key) == nullptr) return;
    diagnostics.error(require.key_span(key),
                      fmt::format("{}: the travel of this axis is {}", key, rotary ? "an angle" : "a length"),
                      fmt::format("write {}", instead));
  };
  if (rotary) {
    refuse("position_error", "angle_error = \"0.1 deg\"");
    refuse("position_error_over", "angle_error = \"0.1 deg\"");
    refuse("lost_motion", "lost_angle = \"0.1 deg\"");
  } else {
    refuse("angle_error", "position_error = \"0.05 mm\"");
    refuse("lost_angle", "lost_motion = \"0.05 mm\"");
  }
}

}  // namespace millwright::machine
