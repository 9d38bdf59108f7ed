// SPDX-License-Identifier: Apache-2.0
#include "report/design_difference.h"

#include <algorithm>

#include "report/design_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Design;
using evaluation::DimensionLine;
using evaluation::PartLine;

namespace {

constexpr const char* no_choice = "–";

/// Choices among values, not dimensions that follow from the parts.
bool is_choice(const DimensionLine& line) { return line.name == "supply_voltage" || line.name == "motor_current"; }

const PartLine* part_at(const Design& design, const PartLine& place) {
  const auto found = std::find_if(design.parts.begin(), design.parts.end(), [&](const PartLine& part) {
    return part.axis == place.axis && part.slot == place.slot;
  });
  return found == design.parts.end() ? nullptr : &*found;
}

const DimensionLine* setting_at(const Design& design, const DimensionLine& place) {
  const auto found = std::find_if(design.dimensions.begin(), design.dimensions.end(), [&](const DimensionLine& line) {
    return line.axis == place.axis && line.name == place.name;
  });
  return found == design.dimensions.end() ? nullptr : &*found;
}

/// Of a slot that at least one of both fills.
void add(const PartLine* before, const PartLine* now, std::vector<DesignDifference>& result) {
  const PartLine& place = now != nullptr ? *now : *before;
  DesignDifference difference{place.axis, place.slot, no_choice, no_choice, no_choice, no_choice};
  if (before != nullptr) difference.before = part_name(*before);
  if (now != nullptr) difference.now = part_name(*now);
  if (difference.before == difference.now) return;
  const bool same_number = before != nullptr && now != nullptr && before->part_number == now->part_number;
  if (before != nullptr) difference.short_before = same_number ? difference.before : before->part_number;
  if (now != nullptr) difference.short_now = same_number ? difference.now : now->part_number;
  result.push_back(std::move(difference));
}

std::string value_of(const DimensionLine* line) {
  return line == nullptr ? no_choice : scalar::format(line->value, scalar::Unit::of(line->unit));
}

void add(const DimensionLine* before, const DimensionLine* now, std::vector<DesignDifference>& result) {
  const DimensionLine& place = now != nullptr ? *now : *before;
  if (!is_choice(place) || (before != nullptr && now != nullptr && before->value == now->value)) return;
  const std::string was = value_of(before), is = value_of(now);
  result.push_back({place.axis, place.name, was, is, was, is});
}

}  // namespace

std::vector<DesignDifference> purchase_differences(const Design& before, const Design& now) {
  const auto source_of = [](const PartLine& part) -> std::string {
    if (part.owned > 0.0 && part.owned >= part.quantity + part.spares) return "in stock";
    return part.supplier.empty() ? "as the catalogue offers it" : "from " + part.supplier;
  };
  std::vector<DesignDifference> result;
  for (const PartLine& part : now.parts) {
    const PartLine* there = part_at(before, part);
    if (there == nullptr || part_name(*there) != part_name(part)) continue;
    const std::string was = source_of(*there), is = source_of(part);
    if (was != is)
      result.push_back({part.axis,
                        part.slot,
                        part_name(*there) + " " + was,
                        part_name(part) + " " + is,
                        part.part_number + " " + was,
                        part.part_number + " " + is});
  }
  return result;
}

std::vector<DesignDifference> differences(const Design& before, const Design& now) {
  std::vector<DesignDifference> result;
  for (const PartLine& part : now.parts) add(part_at(before, part), &part, result);
  for (const PartLine& part : before.parts)
    if (part_at(now, part) == nullptr) add(&part, nullptr, result);
  for (const DimensionLine& line : now.dimensions) add(setting_at(before, line), &line, result);
  for (const DimensionLine& line : before.dimensions)
    if (setting_at(now, line) == nullptr) add(&line, nullptr, result);
  return result;
}

}  // namespace millwright::report
