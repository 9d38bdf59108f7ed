// SPDX-License-Identifier: Apache-2.0
#include "report/steering.h"

#include <fmt/format.h>

#include "report/design_text.h"
#include "scalar/unit.h"

namespace millwright::report {

namespace {

std::string limit_unit(const MachineResult& result, const machine::LimitOption& limit) {
  const auto quantity = machine::quantity_named(limit.name);
  return !quantity || *quantity == machine::Quantity::cost ? result.currency
                                                           : std::string(machine::declaration(*quantity).unit);
}

std::string limit_text(const MachineResult& result, const machine::LimitOption& limit) {
  const std::string unit = limit_unit(result, limit);
  constexpr int digits = 6;
  return unit == result.currency ? fmt::format("{:.{}g} {}", limit.value, digits, unit)
                                 : scalar::format(limit.value, scalar::Unit::of(unit == "m" ? "um" : unit), digits);
}

std::string fixed_text(const machine::BomLine& line) {
  if (!line.value) return part_name(line.manufacturer, line.part_number);
  return scalar::format(*line.value, scalar::Unit::of(machine::unit_of_setting(line.slot)));
}

}  // namespace

std::string steering_text(const MachineResult& result, const Style& style) {
  if (result.steering.empty()) return {};
  TextTable table({{""}, {""}, {"", Align::left, 60}});
  for (const machine::LimitOption& limit : result.steering.limits)
    table.add({"--limit", limit.name, limit_text(result, limit)});
  for (const machine::ExcludedPart& part : result.steering.without)
    table.add({part.said_in.empty() ? "--without" : "not available",
               part.said_in,
               part_name(part.manufacturer, part.part_number)});
  for (const machine::BomLine& line : result.steering.fixed.lines)
    table.add({"--fix", line.axis + "." + line.slot, fixed_text(line)});
  for (const std::string& setting : result.steering.settings) {
    const std::size_t is = setting.find('=');
    table.add({"--set", setting.substr(0, is), is == std::string::npos ? "" : setting.substr(is + 1)});
  }
  return style.heading("Asked for beside the problem") + "\n" + table.str(2, style) + "\n";
}

void add_steering(const MachineResult& result, Json& json) {
  if (result.steering.empty()) return;
  Json limits = Json::array();
  for (const machine::LimitOption& limit : result.steering.limits)
    limits.push_back({{"name", limit.name}, {"value", number(limit.value)}, {"unit", limit_unit(result, limit)}});
  Json without = Json::array();
  for (const machine::ExcludedPart& part : result.steering.without)
    without.push_back({{"manufacturer", part.manufacturer}, {"part_number", part.part_number}});
  for (std::size_t i = 0; i < without.size(); ++i)
    if (const std::string& place = result.steering.without[i].said_in; !place.empty())
      without[i]["not_available"] = place;
  Json fixed = Json::array();
  for (const machine::BomLine& line : result.steering.fixed.lines) {
    if (!line.value)
      fixed.push_back({{"axis", line.axis},
                       {"slot", line.slot},
                       {"manufacturer", line.manufacturer},
                       {"part_number", line.part_number}});
    else
      fixed.push_back(
          {{"axis", line.axis},
           {"name", line.slot},
           {"value", number(*line.value)},
           {"unit", machine::unit_of_setting(line.slot) == "mm" ? "m" : machine::unit_of_setting(line.slot)}});
  }
  json["steering"] = {{"limits", limits}, {"without", without}, {"fixed", fixed}};
  if (!result.steering.settings.empty()) json["steering"]["settings"] = result.steering.settings;
}

}  // namespace millwright::report
