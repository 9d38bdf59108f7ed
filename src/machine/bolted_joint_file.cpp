// SPDX-License-Identifier: Apache-2.0
//
// Joints of screws in a problem file: the pattern, the load beside that of every member, and which screws may be taken.
#include <fmt/format.h>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::TableReader;

namespace {

SourceSpan place(const Node& table, const char* key) {
  const Node* node = table.find(key);
  return node == nullptr ? table.span() : node->span();
}

/// Rows and columns need their spacing, and a load off the face the edge about which it tilts the joint.
void read_pattern(TableReader& table, QuantityReader& q, Member& member, Diagnostics& diagnostics) {
  BoltPattern& bolts = member.bolts;
  const std::size_t before = diagnostics.error_count();
  bolts.rows = q.count_or({"rows", "of screws, one above the other"}, bolts.rows, 1, 20);
  bolts.columns = q.count_or({"columns", "of screws, side by side"}, bolts.columns, 1, 20);
  const auto size = [&](const text::Key& key) { return q.quantity(key, "mm", Sign::positive).value_or(0.0); };
  bolts.row_spacing = size({"row_spacing", "from row to row"});
  bolts.column_spacing = size({"column_spacing", "from column to column"});
  bolts.edge_distance = size({"edge_distance", "from the edge about which the joint tilts to the nearest screws"});
  member.lever_arm = q.quantity_or({"lever_arm", "of the load from the face of the joint"}, "mm", 0.0);
  bolts.eccentricity =
      q.quantity_or({"eccentricity", "of the load from the middle of the pattern, along the face"}, "mm", 0.0);
  if (diagnostics.error_count() > before) return;
  const Node& node = table.node();
  const auto spaced = [&](const char* count, double pieces, const char* key, double spacing) {
    if (pieces > 1.0 && spacing <= 0.0)
      diagnostics.error(place(node, count),
                        fmt::format("{}: {} {} need their distance", count, pieces, count),
                        fmt::format("add {} = \"60 mm\"", key));
  };
  spaced("rows", bolts.rows, "row_spacing", bolts.row_spacing);
  spaced("columns", bolts.columns, "column_spacing", bolts.column_spacing);
  if (member.lever_arm > 0.0 && bolts.edge_distance <= 0.0)
    diagnostics.error(place(node, "lever_arm"),
                      "lever_arm: the load tilts the joint; about which edge?",
                      "add edge_distance = \"20 mm\", from the edge to the nearest screws");
  if (bolts.eccentricity > 0.0 && bolts.count() == 1.0)
    diagnostics.error(place(node, "eccentricity"),
                      "eccentricity: a single screw cannot keep the joint from turning",
                      "add rows or columns, or leave it out");
}

/// Keys that a joint of motors or carriages does not have: what it holds says how many there are and what loads them.
void refuse_of_held(TableReader& table, QuantityReader& q, const Member& member, Diagnostics& diagnostics) {
  const BoltPattern& bolts = member.bolts;
  if (bolts.holds == Held::burden) return;
  const bool motor = bolts.holds == Held::motor;
  q.refuse({"count"},
           motor ? "there is a joint for each motor" : "there is a joint for each carriage",
           "leave it out; rows and columns are the screws of one of them");
  q.refuse({"load_share", "eccentricity"},
           motor ? "the joint bears its motor" : "the joint bears what its carriage does",
           "leave it out, or say holds = \"axis\"");
  q.refuse({"rides"}, "that follows from what the joint holds", "leave it out");
  if (!motor)
    q.refuse({"lever_arm", "edge_distance"},
             "the load of a carriage includes all moments",
             "leave it out, or say holds = \"axis\"");
  if (motor && bolts.count() == 1.0)
    diagnostics.error(place(table.node(), "rows"),
                      "rows: a single screw cannot keep the motor from turning",
                      "flanges of stepper motors have rows = 2 and columns = 2");
}

}  // namespace

void read_bolts(TableReader& table, Member& member, Diagnostics& diagnostics) {
  QuantityReader q(table, diagnostics);
  BoltPattern& bolts = member.bolts;
  const std::string holds = table.word_or(
      {"holds", "what loads the joint: all that the axis carries, a motor at its flange, or a carriage of the guide"},
      {"axis", "motor", "guide"},
      "axis");
  bolts.holds = holds == "motor" ? Held::motor : holds == "guide" ? Held::carriage : Held::burden;
  read_pattern(table, q, member, diagnostics);
  refuse_of_held(table, q, member, diagnostics);
  bolts.pull_force = q.quantity_or({"pull_force", "straight off the face, on all joints together"}, "N", 0.0);
  bolts.friction = q.quantity_or({"friction", "of the joint: steel 0.15 dry, aluminium 0.12, painted faces 0.10"},
                                 "1",
                                 bolts.friction,
                                 Sign::positive);
  bolts.joint_constant =
      q.share_or({"joint_constant", "share of an external tension that a screw feels"}, bolts.joint_constant);
  bolts.nut_factor = q.quantity_or(
      {"nut_factor", "tightening torque over preload and diameter"}, "1", bolts.nut_factor, Sign::positive);
  bolts.tightening_torque =
      q.quantity({"tightening_torque", "without it the preload is a share of the proof load"}, "N.m", Sign::positive);
  bolts.fitted = table.boolean_or({"fitted", "screws fill their holes and carry the shear themselves"}, false);
  bolts.sizes = q.words({"sizes", "screws that may be taken (M6, M8, ...); all without it"});
  bolts.property_classes =
      q.words({"property_classes", "classes that may be taken (8.8, 10.9, A2-70, ...); all without it"});
  if (!bolts.tightening_torque)
    q.refuse(
        {"nut_factor"}, "counts only with a tightening torque", "add tightening_torque = \"10 N.m\", or leave it out");
  warn_above(table.node(),
             "friction",
             bolts.friction,
             0.3,
             "steel has 0.15 dry, aluminium 0.12, painted faces 0.10",
             diagnostics);
}

}  // namespace millwright::machine
