// SPDX-License-Identifier: Apache-2.0
#include "machine/spares_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "text/nearest.h"
#include "text/table_reader.h"

namespace millwright::machine {

namespace {

constexpr double most_spares = 1000.0;

void keep_unique(std::vector<std::string>& names) {
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
}

/// Every key that may stand there.
std::vector<std::string> keys_of(const Problem& problem) {
  std::vector<std::string> all{"supply"}, of_axes{"machine.supply"};
  for (const Axis& axis : problem.axes)
    for (const std::string& slot : catalogue_slots(axis)) {
      all.push_back(slot);
      of_axes.push_back(axis.name + "." + slot);
    }
  keep_unique(all);
  all.insert(all.end(), of_axes.begin(), of_axes.end());
  return all;
}

}  // namespace

std::vector<std::string> catalogue_slots(const Axis& axis) {
  std::vector<std::string> slots;
  for (const Member& member : axis.members) {
    const bool chosen = member.kind == MemberKind::bolts || member.kind == MemberKind::section_beam ||
                        member.kind == MemberKind::column || member.kind == MemberKind::portal_frame;
    if (chosen) slots.push_back(member.name);
  }
  if (axis.guide) slots.emplace_back("guide");
  const Mechanism& mechanism = axis.mechanism;
  switch (mechanism.kind) {
    case MechanismKind::screw:
      slots.insert(slots.end(), {"screw", "nut", "support_fixed"});
      if (mechanism.ends != Ends::fixed_free) slots.emplace_back("support_free");
      if (has_coupling(mechanism)) slots.emplace_back("coupling");
      break;
    case MechanismKind::belt:
      slots.insert(slots.end(), {"belt", "pulley_drive", "pulley_idle"});
      break;
    case MechanismKind::rack:
      slots.insert(slots.end(), {"rack", "pinion"});
      break;
    case MechanismKind::rotary:
      break;
  }
  slots.insert(slots.end(), {"motor", "driver"});
  if (!mechanism.reductions.empty()) slots.emplace_back("reduction");
  return slots;
}

double spares_of(const Problem& problem, std::string_view axis, std::string_view slot) {
  double pieces = 0.0;
  for (const Spare& spare : problem.spares)
    if (spare.slot == slot && (spare.axis.empty() || spare.axis == axis)) pieces += spare.pieces;
  return pieces;
}

void read_spares(const text::Node& node, Problem& problem, text::Diagnostics& diagnostics) {
  text::Question pieces;
  pieces.key = "*";
  pieces.meaning =
      "by the slot, of every axis that has it, or \"axis.slot\": pieces bought beside those that the machine takes";
  pieces.expected = text::Expected::integer;
  pieces.least = 0.0;
  pieces.most = most_spares;
  pieces.example = "1";
  text::TableReader(node, "[spares]", diagnostics).describe(pieces);
  const std::vector<std::string> keys = keys_of(problem);
  for (const text::TableEntry& entry : node.entries()) {
    if (entry.value.is_table()) {
      diagnostics.error(entry.key_span,
                        fmt::format("spares: {} holds a table where a number of pieces is needed", entry.key),
                        fmt::format("a slot of one axis stands in quotes: \"{}.motor\" = 1", entry.key));
      continue;
    }
    const auto number = entry.value.as_number();
    if (!number || *number < 0.0 || *number > most_spares || *number != std::floor(*number)) {
      diagnostics.error(entry.value.span(),
                        fmt::format("spares: {} is no number of pieces", entry.key),
                        fmt::format("write a whole number: {} = 1", entry.key));
      continue;
    }
    if (std::find(keys.begin(), keys.end(), entry.key) == keys.end()) {
      diagnostics.error(entry.key_span,
                        fmt::format("spares: nothing is chosen from a catalogue for {}", text::in_quotes(entry.key)),
                        text::did_you_mean(entry.key, keys, fmt::format("known: {}", fmt::join(keys, ", "))));
      continue;
    }
    const std::size_t dot = entry.key.rfind('.');
    Spare spare;
    if (dot != std::string::npos) spare.axis = entry.key.substr(0, dot);
    spare.slot = dot == std::string::npos ? entry.key : entry.key.substr(dot + 1);
    spare.pieces = *number;
    if (spare.pieces > 0.0) problem.spares.push_back(std::move(spare));
  }
}

}  // namespace millwright::machine
