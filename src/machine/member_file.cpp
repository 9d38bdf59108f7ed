// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

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

MemberKind kind_of(const std::string& word) {
  if (word == "shaft") return MemberKind::round_shaft;
  if (word == "bar") return MemberKind::rectangular_bar;
  if (word == "column") return MemberKind::column;
  if (word == "weld") return MemberKind::weld;
  return MemberKind::section_beam;
}

/// The kind by its word or, if that cannot be read, by the keys that only one kind has; none if nothing tells.
std::optional<MemberKind> read_kind(TableReader& table, QuantityReader& q) {
  if (q.required("kind", "kind = \"beam\" (or shaft, bar, column, weld)") != nullptr)
    if (const auto word = table.word("kind", {"shaft", "bar", "beam", "column", "weld"})) return kind_of(*word);
  const Node& node = table.node();
  if (node.find("diameter") != nullptr) return MemberKind::round_shaft;
  if (node.find("height") != nullptr) return MemberKind::rectangular_bar;
  if (node.find("leg") != nullptr) return MemberKind::weld;
  if (node.find("sections") != nullptr) return MemberKind::section_beam;
  return std::nullopt;
}

void read_load(QuantityReader& q, Member& member) {
  member.load_share = q.share_or("load_share", 1.0, true);
  member.extra_force = q.quantity_or("extra_force", "N", 0.0);
  member.lateral_force = q.quantity_or("lateral_force", "N", 0.0);
  member.count = q.count_or("count", 1.0, 1, 100);
}

void read_sections(TableReader& table, QuantityReader& q, Member& member, Diagnostics& diagnostics) {
  if (q.required("sections", "sections = [\"steel_sections\"]") == nullptr) return;
  member.sections = q.words("sections");
  for (const Node* node : table.list("sections")) {
    const std::string family = node->as_string().value_or("");
    if (family.empty() || family == "steel_sections" || family == "extrusions") continue;
    diagnostics.error(
        node->span(),
        fmt::format("sections: {} has none", text::quoted(family)),
        text::did_you_mean(
            family, std::vector<std::string_view>{"steel_sections", "extrusions"}, "steel_sections or extrusions"));
  }
  member.section_kinds = q.words("section_kinds");
}

/// Keys that only another kind of member has.
void refuse_others(QuantityReader& q, MemberKind kind) {
  const auto refuse = [&](std::initializer_list<std::string_view> keys, const char* others) {
    q.refuse(keys, "this kind of member has none", fmt::format("this key goes with kind = {}", others));
  };
  if (kind != MemberKind::round_shaft) refuse({"diameter", "guide"}, "\"shaft\"");
  if (kind != MemberKind::rectangular_bar) refuse({"width", "height"}, "\"bar\"");
  if (kind != MemberKind::weld) refuse({"leg", "joint_width", "joint_depth", "lever_arm"}, "\"weld\"");
  if (kind != MemberKind::section_beam && kind != MemberKind::column)
    refuse({"sections", "section_kinds"}, "\"beam\" or \"column\"");
  if (kind == MemberKind::weld) refuse({"length"}, "\"shaft\", \"bar\", \"beam\" or \"column\"");
}

void read_shape(TableReader& table, QuantityReader& q, Member& member, Diagnostics& diagnostics) {
  refuse_others(q, member.kind);
  const auto range = [&](const char* key) {
    return q.range(key, "mm", Presence::required).value_or(Range{0.01, 0.01});
  };
  const auto size = [&](const char* key) {
    return q.quantity(key, "mm", Sign::positive, Presence::required).value_or(0.01);
  };
  if (member.kind != MemberKind::weld) member.length = size("length");
  switch (member.kind) {
    case MemberKind::round_shaft:
      member.diameter = range("diameter");
      member.is_guide = table.boolean("guide").value_or(false);
      break;
    case MemberKind::rectangular_bar:
      member.width = range("width");
      member.height = range("height");
      break;
    case MemberKind::weld:
      member.leg = range("leg");
      member.joint_width = size("joint_width");
      member.joint_depth = size("joint_depth");
      member.lever_arm = q.quantity_or("lever_arm", "mm", 0.0);
      break;
    case MemberKind::section_beam:
    case MemberKind::column:
      read_sections(table, q, member, diagnostics);
      break;
  }
}

/// End fixity: the factor on Euler's load, 1/4 free at one end to 4 fixed at both.
void read_end_fixity(TableReader& table, QuantityReader& q, Member& member, Diagnostics& diagnostics) {
  const auto fixity = q.quantity("end_fixity", "1", Sign::positive);
  member.end_fixity = fixity.value_or(1.0);
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
  member.name = q.required_text("name", "name = \"beam\"");
  const auto kind = read_kind(table, q);
  member.kind = kind.value_or(MemberKind::section_beam);
  const std::string support = table.word("support", {"supported", "fixed", "cantilever"}).value_or("supported");
  member.support = support == "fixed"        ? BeamSupport::fixed
                   : support == "cantilever" ? BeamSupport::cantilever
                                             : BeamSupport::supported;
  member.material = q.required_text("material", "material = \"S235JR\", a part number of the materials catalogue");
  member.rides = table.boolean("rides").value_or(false);
  read_end_fixity(table, q, member, diagnostics);
  read_load(q, member);
  if (!kind) return member;  // nothing to judge the other keys by
  read_shape(table, q, member, diagnostics);
  table.finish();
  return member;
}

}  // namespace millwright::machine
