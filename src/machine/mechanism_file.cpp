// SPDX-License-Identifier: Apache-2.0
//
// The parts of an axis in a problem file: mechanism, motor, guide.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "text/nearest.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::TableReader;

namespace {

void read_screw_families(TableReader& table, QuantityReader& q, Mechanism& mechanism, Diagnostics& diagnostics) {
  const Node* given = q.required("screw", "screw = [\"ball_screws\", \"lead_screws\"]");
  if (given == nullptr) return;
  (void)q.words({"screw", "families to choose from"}, {"ball_screws", "lead_screws"});
  for (const Node* word : table.list("screw")) {
    const std::string family = word->as_string().value_or("");
    if (family == "ball_screws")
      mechanism.ball_screws = true;
    else if (family == "lead_screws")
      mechanism.lead_screws = true;
    else if (!family.empty())
      diagnostics.error(
          word->span(),
          fmt::format("screw: {} is no kind of screw", text::in_quotes(family)),
          text::did_you_mean(
              family, std::vector<std::string_view>{"ball_screws", "lead_screws"}, "ball_screws or lead_screws"));
  }
}

void read_screw(TableReader& table, QuantityReader& q, Mechanism& mechanism, Diagnostics& diagnostics) {
  read_screw_families(table, q, mechanism, diagnostics);
  mechanism.thread_forms =
      q.words({"thread_forms", "forms of lead screws that may be taken (trapezoidal, ...); all without it"});
  mechanism.nut_materials = q.words({"nut_materials", "words in the material of a lead screw's nut; all without it"});
  const std::string ends = table.word_or({"ends", "how the screw is held, motor end first"},
                                         {"fixed-free", "supported-supported", "fixed-supported", "fixed-fixed"},
                                         "fixed-supported");
  mechanism.ends = ends == "fixed-free"            ? Ends::fixed_free
                   : ends == "supported-supported" ? Ends::supported_supported
                   : ends == "fixed-fixed"         ? Ends::fixed_fixed
                                                   : Ends::fixed_supported;
  mechanism.end_allowance = q.quantity_or(
      {"end_allowance", "length of the screw beside stroke, nut and overtravel: both journals and the coupling side"},
      "mm",
      mechanism.end_allowance);
  mechanism.greased = table.boolean_or({"greased", "friction of sliding nuts: greased or dry"}, true);
  mechanism.thread_friction = q.quantity(
      {"thread_friction", "of sliding nuts, instead of what the catalogue says of each"}, "1", Sign::positive);
  mechanism.ball_friction = q.quantity_or(
      {"ball_friction", "of the balls of a ball screw, 0.003 to 0.01"}, "1", mechanism.ball_friction, Sign::positive);
  mechanism.preload_fraction =
      q.share_or({"preload", "of a ball nut, as a share of its dynamic load rating"}, 0.0, true);
  mechanism.length =
      q.quantity({"length", "supported length of the screw, instead of having it worked out"}, "mm", Sign::positive);
  mechanism.nut_rotates =
      table.word_or({"rotating", "what turns: the screw, or the nut with the motor riding on the axis"},
                    {"screw", "nut"},
                    "screw") == "nut";
  if (!mechanism.nut_rotates)
    q.refuse({"nut_inertia"}, "the screw turns, not its nut", "write rotating = \"nut\", or leave it out");
  else if (q.required("nut_inertia", "nut_inertia = \"2 kg.cm2\", of the nut with the wheel on it") != nullptr)
    mechanism.nut_inertia = q.quantity_or(
        {"nut_inertia", "of the nut and the wheel on it; needed where the nut turns"}, "kg.m2", 0.0, Sign::positive);
  const Node& node = table.node();
  warn_above(node,
             "thread_friction",
             mechanism.thread_friction.value_or(0.0),
             0.5,
             "metal on metal has 0.1 to 0.2, dry plastic up to 0.4",
             diagnostics);
  warn_above(node, "ball_friction", mechanism.ball_friction, 0.05, "rolling balls have 0.003 to 0.01", diagnostics);
  warn_above(node,
             "preload",
             mechanism.preload_fraction,
             0.2,
             "a share of the dynamic load rating, usually up to 0.1",
             diagnostics);
}

/// How many drives push side by side, and what the most loaded of them takes.
void read_drives(QuantityReader& q, Mechanism& mechanism, const Node& node, Diagnostics& diagnostics) {
  mechanism.drives = q.count_or({"drives", "equal drives side by side, each with its own motor"}, 1.0, 1, 8);
  const double equal = 1.0 / mechanism.drives;
  mechanism.load_share = q.share_or(
      {"load_share", "of mass and forces that the most loaded of the drives takes; equal shares without it"}, equal);
  if (const Node* share = node.find("load_share"); share != nullptr && mechanism.load_share < equal * (1.0 - 1e-9))
    diagnostics.error(
        share->span(),
        fmt::format("load_share: {} drives of which the most loaded takes only {:.4g} of the load",
                    mechanism.drives,
                    mechanism.load_share),
        fmt::format(
            "it is at least 1/{} = {:.4g}; more where the load stands off the middle", mechanism.drives, equal));
}

/// Reports the keys of the other kinds of mechanism; efficiency is one of belts and racks.
void refuse_of_others(QuantityReader& q, const std::string& kind) {
  const std::string because = fmt::format("a {} has none", kind == "rotary" ? "rotary table" : kind);
  if (kind != "screw")
    q.refuse({"screw",
              "ends",
              "thread_forms",
              "nut_materials",
              "end_allowance",
              "greased",
              "thread_friction",
              "ball_friction",
              "preload",
              "length",
              "rotating",
              "nut_inertia"},
             because,
             "this key goes with kind = \"screw\"");
  if (kind != "belt") q.refuse({"profiles", "idler_distance"}, because, "this key goes with kind = \"belt\"");
  if (kind != "rack") q.refuse({"motor_rides", "backlash"}, because, "this key goes with kind = \"rack\"");
  if (kind == "screw" || kind == "rotary")
    q.refuse({"efficiency"}, because, "this key goes with kind = \"belt\" or \"rack\"");
}

/// Without a readable kind, what else is there tells which one was meant.
std::string guessed_kind(const Node& node) {
  const bool belt =
      node.find("profiles") != nullptr || node.find("efficiency") != nullptr || node.find("idler_distance") != nullptr;
  if (node.find("motor_rides") != nullptr) return "rack";
  if (belt && node.find("screw") == nullptr) return "belt";
  return node.find("screw") != nullptr ? "screw" : "";
}

}  // namespace

void warn_above(const Node& table,
                std::string_view key,
                double value,
                double usual,
                const std::string& hint,
                Diagnostics& diagnostics) {
  const Node* node = table.find(key);
  if (node == nullptr || value <= usual) return;
  diagnostics.warning(node->span(), fmt::format("{}: {:.6g} is unusually high", key, value), hint);
}

Mechanism read_mechanism(const Node& node, const std::string& title, Diagnostics& diagnostics) {
  Mechanism mechanism;
  mechanism.where = node.span();
  TableReader table(node, title, diagnostics);
  QuantityReader q(table, diagnostics);
  if (!node.is_table()) return mechanism;
  const bool has_kind = q.required("kind", "kind = \"screw\" or kind = \"belt\", \"rack\", \"rotary\"") != nullptr;
  const auto said = has_kind
                        ? table.word({"kind", "what turns the motor into travel"}, {"screw", "belt", "rack", "rotary"})
                        : std::nullopt;
  const std::string kind = said.value_or(guessed_kind(node));
  if (kind.empty()) return mechanism;  // nothing to judge the other keys by
  refuse_of_others(q, kind);
  if (kind != "rotary") read_drives(q, mechanism, node, diagnostics);
  if (kind == "screw") {
    read_screw(table, q, mechanism, diagnostics);
  } else if (kind == "belt") {
    mechanism.kind = MechanismKind::belt;
    mechanism.profiles = q.words({"profiles", "belts that may be taken (GT2, HTD5M, ...); all without it"});
    mechanism.belt_efficiency = q.share_or({"efficiency", "of the belt drive"}, mechanism.belt_efficiency);
    mechanism.idler_distance =
        q.quantity_or({"idler_distance", "distance of the pulleys beyond stroke and carriage"}, "mm", 0.0);
  } else if (kind == "rack") {
    read_rack(table, mechanism, diagnostics);
  } else {
    read_rotary(table, mechanism, diagnostics);
  }
  read_reductions(table, mechanism, diagnostics);
  table.finish();
  return mechanism;
}

MotorChoice read_motor(const Node& node, const std::string& title, Diagnostics& diagnostics) {
  MotorChoice motor;
  motor.where = node.span();
  TableReader table(node, title, diagnostics);
  QuantityReader q(table, diagnostics);
  (void)table.word({"from", "the family of motors"}, {"steppers"});
  motor.frames = q.words({"frame", "sizes that may be mounted, NEMA17, NEMA23, ...; all without it"});
  for (const Node* frame : table.list("frame")) {
    const std::string word = frame->as_string().value_or("NEMA17");
    const auto digit = [](unsigned char c) { return std::isdigit(c) != 0; };
    if (word.empty() || diagnostics.has_error_at(frame->span()) ||
        (word.starts_with("NEMA") && word.size() > 4 && std::all_of(word.begin() + 4, word.end(), digit)))
      continue;
    const auto begin = std::find_if(word.begin(), word.end(), digit);
    const std::string size(begin, std::find_if_not(begin, word.end(), digit));
    diagnostics.error(frame->span(),
                      fmt::format("frame: {} is no motor frame", text::in_quotes(word)),
                      word.find(',') != std::string::npos
                          ? "several are a list: [\"NEMA17\", \"NEMA23\"]"
                          : fmt::format("write \"NEMA{}\", without blank", size.empty() ? "23" : size));
  }
  motor.currents = q.choices(
      {"current", "peak currents that may be set at the driver; else the rated one, times current_factor"}, "A");
  motor.microsteps = q.count_or({"microsteps", "of the driver, a power of two"}, motor.microsteps, 1, 256);
  const auto steps = static_cast<unsigned>(motor.microsteps);
  if ((steps & (steps - 1)) != 0)
    diagnostics.error(table.find("microsteps")->span(),
                      fmt::format("microsteps: {} is no power of two", steps),
                      "drivers divide a full step by 1, 2, 4, 8, 16, 32, 64, 128 or 256");
  motor.brake_torque = q.quantity_or({"brake_torque", "of a holding brake; none without it"}, "N.m", 0.0);
  table.finish();
  return motor;
}

namespace {

/// What only bushings on round shafts ask for.
void read_bushings(TableReader& table, QuantityReader& q, GuideChoice& guide, Diagnostics& diagnostics) {
  guide.self_aligning = table.boolean_or({"self_aligning", "bushings that follow the slope of their shaft"}, false);
  guide.drive_offset =
      q.quantity({"drive_offset", "of the line of the drive from the shaft, across it: do bushings jam?"}, "mm");
  guide.bushing_friction =
      q.quantity({"bushing_friction", "of plain bushings, instead of what the catalogue says"}, "1", Sign::positive);
  if (!guide.drive_offset)
    q.refuse({"bushing_friction"},
             "tells whether bushings jam, which takes the drive's offset as well",
             "add drive_offset = \"40 mm\", from the shaft to the drive's line, or leave it out");
  warn_above(table.node(),
             "bushing_friction",
             guide.bushing_friction.value_or(0.0),
             0.5,
             "ball bushings have 0.002 to 0.003, plain polymer bushings 0.05 to 0.25",
             diagnostics);
}

}  // namespace

/// Three lengths: along the travel, across it, above the guides.
void read_tool_at(TableReader& table, QuantityReader& q, GuideChoice& guide, Diagnostics& diagnostics) {
  const Node* node = table.find(
      {"tool_at",
       "of the tool from the middle of the carriages: along the travel, across it, above the guides; for [tool]"});
  q.describe("tool_at", text::Expected::three_quantities, "mm", Sign::any);
  if (node == nullptr) return;
  if (!node->is_array() || node->size() != 3) {
    diagnostics.error(node->span(),
                      "tool_at: needs three lengths",
                      "along the travel, across it, above the guides: [\"0 mm\", \"90 mm\", \"150 mm\"]");
    return;
  }
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < at.size(); ++i)
    at[i] = q.of_node(node->items()[i], "tool_at", "mm", Sign::any).value_or(0.0);
  guide.tool_at = at;
}

GuideChoice read_guide(const Node& node, const std::string& title, Diagnostics& diagnostics) {
  GuideChoice guide;
  guide.where = node.span();
  TableReader table(node, title, diagnostics);
  QuantityReader q(table, diagnostics);
  (void)table.word({"from", "the family of guides"}, {"linear_guides"});
  guide.kinds = q.words(
      {"kinds", "words in the kind (profile rail, profile rail miniature, bush, supported, ...); all without it"});
  const std::size_t before = diagnostics.error_count();
  guide.carriages = q.count_or({"carriages", "in all: 4 on two rails, or 1 on one"}, guide.carriages, 1, 4);
  guide.rails = q.count_or(
      {"rails", "two for four carriages, one for a single one"}, guide.carriages == 1.0 ? 1.0 : guide.rails, 1, 2);
  const bool counted = diagnostics.error_count() == before;
  const auto spacing = [&](const text::Key& key) { return q.quantity_or(key, "mm", 0.0); };
  guide.carriage_spacing = spacing({"carriage_spacing", "from carriage to carriage along the travel"});
  guide.rail_spacing = spacing({"rail_spacing", "from rail to rail"});
  const bool spaced = diagnostics.error_count() == before;
  guide.load_offset_x =
      q.quantity_or({"load_offset_x", "of the moved weight from the middle of the carriages, along the travel"},
                    "mm",
                    0.0,
                    Sign::any);
  guide.load_offset_y =
      q.quantity_or({"load_offset_y", "of the moved weight from the middle of the carriages, across the travel"},
                    "mm",
                    0.0,
                    Sign::any);
  guide.load_height = q.quantity_or(
      {"load_height", "of the moved mass above the line of the drive; before the rails where they stand on a face"},
      "mm",
      0.0,
      Sign::any);
  guide.load_height_stated = table.has("load_height");
  guide.force_height =
      q.quantity_or({"force_height", "of the process force above the carriages"}, "mm", 0.0, Sign::any);
  read_tool_at(table, q, guide, diagnostics);
  read_bushings(table, q, guide, diagnostics);
  const auto place = [&](const char* key) {
    const Node* value = table.find(key);
    return value == nullptr ? node.span() : value->span();
  };
  const bool four = guide.carriages == 4.0;
  if (counted && !four && guide.carriages != 1.0)
    diagnostics.error(place("carriages"),
                      fmt::format("carriages: a guide has 4 or 1, not {}", guide.carriages),
                      "four carriages on two rails, or a single one that takes the moments itself");
  else if (counted && guide.rails != (four ? 2.0 : 1.0))
    diagnostics.error(place("rails"),
                      fmt::format("rails: {} with {} carriage{}", guide.rails, guide.carriages, four ? "s" : ""),
                      "four carriages run on two rails, a single one on one");
  for (const char* key : {"carriage_spacing", "rail_spacing"})
    if (spaced && four && (key[0] == 'c' ? guide.carriage_spacing : guide.rail_spacing) <= 0.0)
      diagnostics.error(place(key),
                        fmt::format("{}: four carriages need it", key),
                        fmt::format("add {} = \"200 mm\", the distance {} the travel",
                                    key,
                                    key[0] == 'c' ? "between carriages along" : "between rails across"));
  table.finish();
  return guide;
}

}  // namespace millwright::machine
