// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "text/nearest.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::Presence;
using text::TableReader;

namespace {

constexpr std::pair<std::string_view, MemberKind> member_kinds[] = {{"shaft", MemberKind::round_shaft},
                                                                    {"bar", MemberKind::rectangular_bar},
                                                                    {"beam", MemberKind::section_beam},
                                                                    {"column", MemberKind::column},
                                                                    {"weld", MemberKind::weld},
                                                                    {"plate", MemberKind::plate},
                                                                    {"portal_frame", MemberKind::portal_frame},
                                                                    {"bolts", MemberKind::bolts}};

/// The kind by its word or, if that cannot be read, by the keys that only one kind has; none if nothing tells.
std::optional<MemberKind> read_kind(TableReader& table, QuantityReader& q) {
  if (q.required("kind", "kind = \"beam\" (or shaft, bar, column, weld, plate, portal_frame, bolts)") != nullptr) {
    std::vector<std::string> words;
    for (const auto& [word, kind] : member_kinds) words.emplace_back(word);
    if (const auto word = table.word({"kind", "what it is"}, words))
      return std::find_if(
                 std::begin(member_kinds), std::end(member_kinds), [&](const auto& k) { return k.first == *word; })
          ->second;
  }
  const Node& node = table.node();
  if (node.find("thickness") != nullptr) return MemberKind::plate;
  if (node.find("rows") != nullptr) return MemberKind::bolts;
  if (node.find("diameter") != nullptr) return MemberKind::round_shaft;
  if (node.find("height") != nullptr)
    return node.find("sections") != nullptr ? MemberKind::portal_frame : MemberKind::rectangular_bar;
  if (node.find("leg") != nullptr) return MemberKind::weld;
  if (node.find("sections") != nullptr) return MemberKind::section_beam;
  return std::nullopt;
}

void read_load(QuantityReader& q, Member& member) {
  member.load_share =
      q.share_or({"load_share", "of the weight that the axis carries; the rest rests on something else"}, 1.0, true);
  member.extra_force =
      q.quantity_or({"extra_force", "downwards, beside the weight of what the axis carries"}, "N", 0.0);
  member.lateral_force = q.quantity_or({"lateral_force", "level, across the member"}, "N", 0.0);
  member.torque = q.quantity_or({"torque", "that twists the members"}, "N.m", 0.0);
  member.count = q.count_or({"count", "equal members that share the load"}, 1.0, 1, 100);
}

void read_sections(TableReader& table, QuantityReader& q, Member& member, Diagnostics& diagnostics) {
  member.section_kinds =
      q.words({"section_kinds", "words in the kind of section (channel, square hollow, ...); all without it"});
  if (q.required("sections", "sections = [\"steel_sections\"]") == nullptr) return;
  member.sections = q.words({"sections", "families a section may come from"}, {"steel_sections", "extrusions"});
  for (const Node* node : table.list("sections")) {
    const std::string family = node->as_string().value_or("");
    if (family.empty() || family == "steel_sections" || family == "extrusions") continue;
    diagnostics.error(
        node->span(),
        fmt::format("sections: {} has none", text::in_quotes(family)),
        text::did_you_mean(
            family, std::vector<std::string_view>{"steel_sections", "extrusions"}, "steel_sections or extrusions"));
  }
}

/// Keys that only other kinds of member have.
void refuse_others(QuantityReader& q, MemberKind kind) {
  using enum MemberKind;
  const auto only =
      [&](std::initializer_list<MemberKind> owners, std::initializer_list<std::string_view> keys, const char* words) {
        if (std::find(owners.begin(), owners.end(), kind) == owners.end())
          q.refuse(keys, "this kind of member has none", fmt::format("this key goes with kind = {}", words));
      };
  only({round_shaft}, {"diameter", "guide", "rotating", "surface", "notch_factor"}, "\"shaft\"");
  only({rectangular_bar, plate}, {"width"}, "\"bar\" or \"plate\"");
  only({rectangular_bar, portal_frame}, {"height"}, "\"bar\" or \"portal_frame\"");
  only({plate}, {"thickness"}, "\"plate\"");
  only({column, portal_frame}, {"end_fixity"}, "\"column\" or \"portal_frame\"");
  only({weld}, {"leg", "joint_width", "joint_depth"}, "\"weld\"");
  only({weld, bolts}, {"lever_arm"}, "\"weld\" or \"bolts\"");
  only({section_beam, column, portal_frame}, {"sections", "section_kinds"}, "\"beam\", \"column\" or \"portal_frame\"");
  only({round_shaft, rectangular_bar, section_beam}, {"torque"}, "\"shaft\", \"bar\" or \"beam\"");
  only({round_shaft, rectangular_bar, plate, section_beam, portal_frame, bolts},
       {"lateral_force"},
       "\"shaft\", \"bar\", \"plate\", \"beam\", \"portal_frame\" or \"bolts\"");
  only({bolts},
       {"holds",
        "rows",
        "columns",
        "row_spacing",
        "column_spacing",
        "edge_distance",
        "eccentricity",
        "pull_force",
        "friction",
        "joint_constant",
        "nut_factor",
        "tightening_torque",
        "fitted",
        "sizes",
        "property_classes"},
       "\"bolts\"");
  if (kind == weld || kind == bolts)
    q.refuse({"length"},
             "this kind of member has none",
             "this key goes with kind = \"shaft\", \"bar\", \"beam\", \"column\", \"plate\" or \"portal_frame\"");
  if (kind == bolts) q.refuse({"material"}, "screws have their own", "choose by property_classes = [\"8.8\"]");
  if (kind == column)
    q.refuse({"support"}, "this kind of member has none", "end_fixity says how the ends of a column are held");
  if (kind == portal_frame || kind == weld || kind == bolts)
    q.refuse({"support"},
             "this kind of member has none",
             "a portal is clamped at its feet, welds and bolts hold by themselves");
}

/// A shaft that turns under its load is checked for fatigue, as far as the size factor of the endurance limit is known.
void read_rotation(TableReader& table, QuantityReader& q, Member& member, bool sized, Diagnostics& diagnostics) {
  constexpr double smallest = 2.79e-3, largest = 51e-3, rounding = 1e-12;  // m
  member.rotating = table.boolean_or({"rotating", "turns under its load, so that fatigue counts"}, false);
  if (!member.rotating)
    q.refuse({"surface", "notch_factor"}, "counts only for a shaft that turns", "add rotating = true, or leave it out");
  const std::string surface = table.word_or({"surface", "how the surface of a rotating shaft was made"},
                                            {"ground", "machined", "hot_rolled", "forged"},
                                            "machined");
  member.surface = surface == "ground"       ? SurfaceFinish::ground
                   : surface == "hot_rolled" ? SurfaceFinish::hot_rolled
                   : surface == "forged"     ? SurfaceFinish::forged
                                             : SurfaceFinish::machined;
  const auto notch = q.quantity(
      {"notch_factor", "on the stress amplitude of a rotating shaft: 1 without notch, a shoulder 1.7, a keyway 2.1"},
      "1",
      Sign::positive);
  member.notch_factor = notch.value_or(1.0);
  if (notch && *notch < 1.0)
    diagnostics.error(table.find("notch_factor")->span(),
                      fmt::format("notch_factor: {:.6g} would make a notch stronger than none", *notch),
                      "1 without notch; a shoulder about 1.7, a keyway about 2.1");
  if (member.rotating && sized &&
      (member.diameter.lower < smallest * (1.0 - rounding) || member.diameter.upper > largest * (1.0 + rounding)))
    diagnostics.error(table.find("diameter")->span(),
                      "diameter: the fatigue of rotating shafts is known from 2.79 mm to 51 mm only",
                      "narrow the range, or leave out rotating");
}

void read_shape(TableReader& table, QuantityReader& q, Member& member, Diagnostics& diagnostics) {
  refuse_others(q, member.kind);
  const std::size_t before = diagnostics.error_count();
  const auto range = [&](const text::Key& key) {
    return q.range(key, "mm", Presence::required).value_or(Range{0.01, 0.01});
  };
  const auto size = [&](const text::Key& key) {
    return q.quantity(key, "mm", Sign::positive, Presence::required).value_or(0.01);
  };
  if (member.kind != MemberKind::weld && member.kind != MemberKind::bolts)
    member.length = size({"length", "free span; of a plate between the rails, of a portal that of its beam"});
  switch (member.kind) {
    case MemberKind::round_shaft:
      member.diameter = range({"diameter", "one value, or a range to choose from"});
      member.is_guide = table.boolean_or({"guide", "carriages run on it: the checks are those of guide shafts"}, false);
      read_rotation(table, q, member, diagnostics.error_count() == before, diagnostics);
      break;
    case MemberKind::rectangular_bar:
      member.width = range({"width", "one value, or a range to choose from"});
      member.height = range({"height", "one value, or a range to choose from"});
      break;
    case MemberKind::weld:
      member.leg = range({"leg", "of the fillet: one value, or a range to choose from"});
      member.joint_width = size({"joint_width", "of the rectangle that the weld runs around"});
      member.joint_depth = size({"joint_depth", "of the rectangle that the weld runs around"});
      member.lever_arm = q.quantity_or({"lever_arm", "of the load from the joint"}, "mm", 0.0);
      break;
    case MemberKind::plate:
      member.plate_width = size({"width", "across the span"});
      member.thickness = range({"thickness", "one value, or a range to choose from"});
      break;
    case MemberKind::portal_frame:
      member.column_height = size({"height", "of the columns"});
      read_sections(table, q, member, diagnostics);
      break;
    case MemberKind::section_beam:
    case MemberKind::column:
      read_sections(table, q, member, diagnostics);
      break;
    case MemberKind::bolts:
      read_bolts(table, member, diagnostics);
      break;
  }
}

/// End fixity: the factor on Euler's load, 1/4 free at one end to 4 fixed at both.
void read_end_fixity(TableReader& table, QuantityReader& q, Member& member, Diagnostics& diagnostics) {
  const auto fixity = q.quantity(
      {"end_fixity",
       "factor on Euler's load: 0.25 free at one end, 1 hinged at both, 2 fixed and hinged, 4 fixed at both"},
      "1",
      Sign::positive);
  member.end_fixity = fixity.value_or(member.kind == MemberKind::portal_frame ? 0.25 : 1.0);
  if (!fixity || (*fixity >= 0.25 && *fixity <= 4.0)) return;
  diagnostics.error(table.find("end_fixity")->span(),
                    fmt::format("end_fixity: {:.6g} is not between 0.25 and 4", *fixity),
                    "0.25 free at one end, 1 hinged at both, 2 fixed and hinged, 4 fixed at both");
}

}  // namespace

Member read_member(const Node& node, const std::string& axis, Diagnostics& diagnostics) {
  Member member;
  member.where = node.span();
  TableReader table(node, fmt::format("member of axis '{}'", axis), diagnostics);
  if (!node.is_table()) return member;
  QuantityReader q(table, diagnostics);
  member.name =
      q.required_text({"name", "its slot in bills of materials: beam, column, shaft, weld"}, "name = \"beam\"");
  const auto kind = read_kind(table, q);
  member.kind = kind.value_or(MemberKind::section_beam);
  const std::string support =
      table.word_or({"support", "how its ends are held"}, {"supported", "fixed", "cantilever"}, "supported");
  member.support = support == "fixed"        ? BeamSupport::fixed
                   : support == "cantilever" ? BeamSupport::cantilever
                                             : BeamSupport::supported;
  if (kind != MemberKind::bolts)
    member.material = q.required_text({"material", "a part number of the family materials"},
                                      "material = \"S235JR\", a part number of the materials catalogue");
  member.rides = table.boolean_or({"rides", "moves with the axis instead of standing on what carries it"}, false);
  member.along = read_direction_name(
      table, {"along", "direction of the machine in which it lies; the travel of its axis without it"});
  read_end_fixity(table, q, member, diagnostics);
  read_load(q, member);
  if (!kind) return member;  // nothing to judge the other keys by
  read_shape(table, q, member, diagnostics);
  table.finish();
  return member;
}

}  // namespace millwright::machine
