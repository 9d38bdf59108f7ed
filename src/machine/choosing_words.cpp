// SPDX-License-Identifier: Apache-2.0
#include "machine/choosing_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "machine/condition_places.h"
#include "machine/word_column.h"
#include "scalar/unit.h"
#include "text/nearest.h"

namespace millwright::machine {

namespace {

using catalogue::Family;

/// One list of words, and what it is compared with.
struct Choosing {
  const Axis& axis;
  std::string slot;                    ///< of the bill of materials
  std::vector<std::string_view> path;  ///< of the list, in the table of its axis or member
  const std::vector<std::string>& words;
  WordColumn column;
  std::string_view part;         ///< what the catalogues lack where they lack the word: "motor of frame"
  std::string_view member = {};  ///< in whose table the list stands; else in that of the axis
};

std::vector<Choosing> choosing_of(const Axis& axis) {
  std::vector<Choosing> lists;
  const Mechanism& mechanism = axis.mechanism;
  lists.push_back({axis, "motor", {"motor", "frame"}, axis.motor.frames, word_columns::motor_frame, "motor of frame"});
  lists.push_back({axis,
                   "screw",
                   {"mechanism", "thread_forms"},
                   mechanism.thread_forms,
                   word_columns::thread_form,
                   "lead screw of form"});
  lists.push_back({axis,
                   "nut",
                   {"mechanism", "nut_materials"},
                   mechanism.nut_materials,
                   word_columns::nut_material,
                   "nut of material"});
  lists.push_back(
      {axis, "belt", {"mechanism", "profiles"}, mechanism.profiles, word_columns::belt_profile, "belt of profile"});
  if (axis.guide)
    lists.push_back({axis, "guide", {"guide", "kinds"}, axis.guide->kinds, word_columns::guide_kind, "guide of kind"});
  for (const Member& member : axis.members) {
    const auto add = [&](const char* key, const auto& words, const WordColumn& column, const char* part) {
      lists.push_back({axis, member.name, {key}, words, column, part, member.name});
    };
    add("section_kinds", member.section_kinds, word_columns::section_kind, "section of kind");
    if (member.kind != MemberKind::bolts) continue;
    add("sizes", member.bolts.sizes, word_columns::screw_size, "screw");
    add("property_classes", member.bolts.property_classes, word_columns::property_class, "screw");
  }
  return lists;
}

/// "a, b, c", of many the first few.
std::string listed(const std::set<std::string_view>& words) {
  constexpr std::size_t most = 12;
  std::vector<std::string> shown;
  for (const std::string_view word : words) {
    if (shown.size() == most) break;
    shown.push_back(text::printable(word, 40));
  }
  return fmt::format("{}{}", fmt::join(shown, ", "), words.size() > most ? ", ..." : "");
}

std::vector<std::string_view> words_of(std::string_view cell) {
  std::vector<std::string_view> words;
  while (!cell.empty()) {
    const std::size_t end = std::min(cell.find(' '), cell.size());
    if (end > 0) words.push_back(cell.substr(0, end));
    cell.remove_prefix(std::min(end + 1, cell.size()));
  }
  return words;
}

/// Where the path of the list begins.
const text::Node* table_of(const Choosing& list, const text::Node* axis) {
  if (list.member.empty()) return axis;
  const text::Node* const members = Places::find(axis, {"members"});
  if (members == nullptr) return nullptr;
  for (const text::Node& member : members->items())
    if (const text::Node* name = member.find("name"); name != nullptr && name->as_string() == list.member)
      return &member;
  return nullptr;
}

bool any_row_has(const std::string& word, const Choosing& list, const catalogue::Table& table) {
  for (int row = 0; row < table.rows(); ++row)
    if (list.column.takes(word, list.column.text(table, row))) return true;
  return false;
}

/// The nearest that some row has, or all of them.
std::string hint_for(const std::string& word, const Choosing& list, const catalogue::Table& table) {
  std::set<std::string_view> known;
  for (int row = 0; row < table.rows(); ++row) known.insert(list.column.text(table, row));
  known.erase("");
  std::vector<std::string_view> meant(known.begin(), known.end());
  for (const std::string_view cell : known) {
    if (list.column.whole) break;
    const std::vector<std::string_view> parts = words_of(cell);
    meant.insert(meant.end(), parts.begin(), parts.end());
  }
  return text::did_you_mean(word, meant, known.empty() ? "" : "they have " + listed(known));
}

void note_idle(const Choosing& list,
               const text::Node* node,
               const text::SourceSpan& otherwise,
               const catalogue::Table& table,
               text::Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < list.words.size(); ++i) {
    const std::string& word = list.words[i];
    if (any_row_has(word, list, table)) continue;
    const bool in_array = node != nullptr && node->is_array() && i < node->items().size();
    diagnostics.warning(in_array          ? node->items()[i].span()
                        : node != nullptr ? node->span()
                                          : otherwise,
                        fmt::format("axis '{}'{}: {}: the catalogues have no {} {}",
                                    list.axis.name,
                                    list.member.empty() ? "" : fmt::format(", {}", list.member),
                                    list.path.back(),
                                    list.part,
                                    text::in_quotes(word)),
                        hint_for(word, list, table));
  }
}

/// Families of which a slot takes one kind of part or another.
struct Kind {
  Family family;
  bool taken;
  std::string_view name;
};

std::vector<Kind> kinds_of(const Axis& axis, const std::string& slot) {
  if (slot == "screw" && axis.mechanism.kind == MechanismKind::screw)
    return {{Family::ball_screws, axis.mechanism.ball_screws, "ball screws"},
            {Family::lead_screws, axis.mechanism.lead_screws, "lead screws"}};
  if (slot == "nut" && axis.mechanism.kind == MechanismKind::screw)
    return {{Family::ball_screws, axis.mechanism.ball_screws, "nuts of ball screws"},
            {Family::lead_nuts, axis.mechanism.lead_screws, "nuts of lead screws"}};
  for (const Member& member : axis.members) {
    if (member.name != slot || member.sections.empty()) continue;
    const auto taken = [&](const char* family) {
      return std::find(member.sections.begin(), member.sections.end(), family) != member.sections.end();
    };
    return {{Family::steel_sections, taken("steel_sections"), "steel sections"},
            {Family::extrusions, taken("extrusions"), "extrusions"}};
  }
  return {};
}

/// In which the problem leaves a setting free; nothing where it is none of them, or where no move takes the ramp.
std::optional<Range> range_of(const Axis& axis, const std::string& setting) {
  if (setting == "acceleration_time") {
    const bool any =
        std::any_of(axis.moves.begin(), axis.moves.end(), [](const Move& m) { return uses_chosen_ramp(m); });
    return any ? std::optional(axis.acceleration_time) : std::nullopt;
  }
  for (const Member& member : axis.members) {
    const auto is = [&](MemberKind kind, const char* dimension) {
      return member.kind == kind && setting == fmt::format("{}.{}", member.name, dimension);
    };
    if (is(MemberKind::round_shaft, "diameter")) return member.diameter;
    if (is(MemberKind::rectangular_bar, "width")) return member.width;
    if (is(MemberKind::rectangular_bar, "height")) return member.height;
    if (is(MemberKind::weld, "leg")) return member.leg;
    if (is(MemberKind::plate, "thickness")) return member.thickness;
  }
  return std::nullopt;
}

/// What the currents are that may be set, where they are listed and this is none of them.
std::string not_set(double current, const Axis& axis) {
  const auto shown = [](double value) { return scalar::format(value, scalar::Unit::of("A"), 6); };
  std::vector<std::string> listed;
  for (const double each : axis.motor.currents) {
    if (std::fabs(each - current) <= 1e-9 * each) return {};
    listed.push_back(shown(each));
  }
  if (listed.empty()) return {};
  return fmt::format("is {}, and the problem takes {}", shown(current), fmt::join(listed, ", "));
}

/// A value that the problem does not leave open, and what it leaves open; empty otherwise.
std::string out_of_range(const BomLine& line, const Axis& axis) {
  if (line.slot == "motor_current") return not_set(*line.value, axis);
  constexpr double rounding = 1e-9;
  const std::optional<Range> range = range_of(axis, line.slot);
  if (!range || (*line.value >= range->lower * (1.0 - rounding) && *line.value <= range->upper * (1.0 + rounding)))
    return {};
  const auto shown = [&](double value) {
    return scalar::format(value, scalar::Unit::of(unit_of_setting(line.slot)), 6);
  };
  return fmt::format(
      "is {}, and the problem takes {}",
      shown(*line.value),
      range->fixed() ? shown(range->lower) : fmt::format("{} to {}", shown(range->lower), shown(range->upper)));
}

/// Of a line: what it is that the problem does not take, and what it takes; empty if it takes it.
std::string unwanted(const BomLine& line, const Axis& axis, const catalogue::Catalogue& catalogue) {
  if (line.is_dimension()) return out_of_range(line, axis);
  const auto row_in = [&](Family family) {
    const catalogue::Table& table = catalogue.table(family);
    const catalogue::Found found = table.find(line.part_number, line.manufacturer);
    const bool is_it = found && !found.rows.empty() && table.part_number(found.rows.front()) == line.part_number;
    return is_it ? found.rows.front() : -1;
  };
  const std::vector<Kind> kinds = kinds_of(axis, line.slot);
  for (const Kind& kind : kinds)
    if (!kind.taken && row_in(kind.family) >= 0 &&
        std::none_of(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.taken && row_in(k.family) >= 0; }))
      return fmt::format("is one of the {}, which the problem does not take", kind.name);
  for (const Choosing& list : choosing_of(axis)) {
    if (list.slot != line.slot || list.words.empty()) continue;
    const int row = row_in(list.column.family);
    if (row < 0) continue;
    const std::string_view cell = list.column.text(catalogue.table(list.column.family), row);
    if (!list.column.takes(list.words, cell))
      return fmt::format("is {}, and the problem takes {} ({})",
                         cell.empty() ? "of no known kind" : text::printable(cell, 40),
                         listed({list.words.begin(), list.words.end()}),
                         list.path.back());
  }
  return {};
}

}  // namespace

void note_idle_words(const Problem& problem,
                     const text::Document& document,
                     const catalogue::Catalogue& catalogue,
                     text::Diagnostics& diagnostics) {
  const Places places(document);
  for (std::size_t i = 0; i < problem.axes.size(); ++i)
    for (const Choosing& list : choosing_of(problem.axes[i])) {
      if (list.column.family == Family::screws) continue;  // these are errors (check_references)
      const text::Node* node = table_of(list, places.axis(i));
      for (const std::string_view key : list.path) node = Places::find(node, {key});
      note_idle(list, node, problem.axes[i].where, catalogue.table(list.column.family), diagnostics);
    }
}

void note_unwanted_lines(const BillOfMaterials& bom,
                         const std::string& only_origin,
                         const Problem& problem,
                         const catalogue::Catalogue& catalogue,
                         text::Diagnostics& diagnostics) {
  for (const BomLine& line : bom.lines) {
    if (!only_origin.empty() && line.origin != only_origin) continue;
    for (const Axis& axis : problem.axes) {
      if (axis.name != line.axis) continue;
      const std::string fault = unwanted(line, axis, catalogue);
      if (fault.empty()) continue;
      diagnostics.warning(line.where,
                          fmt::format("axis '{}', {}: {} {}",
                                      axis.name,
                                      line.slot,
                                      line.is_dimension() ? std::string("this") : text::printable(line.part_number, 60),
                                      fault),
                          "it is checked as it is; solve would not choose it");
    }
  }
}

}  // namespace millwright::machine
