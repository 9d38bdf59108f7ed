// SPDX-License-Identifier: Apache-2.0
#include "machine/cutting_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machine/axis_file.h"
#include "machine/quantity_reader.h"
#include "scalar/unit.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::Presence;
using text::TableReader;

double CuttingProcess::feed_speed() const { return cutting_feed<double>(*this); }

double CuttingProcess::teeth_in_cut() const {
  constexpr double turn = 2.0 * 3.14159265358979323846;
  constexpr double rounding = 1e-9;  // a full slot holds half of the teeth, not one more
  const double engaged = std::acos(std::clamp(1.0 - 2.0 * width / diameter, -1.0, 1.0));
  return std::max(1.0, std::ceil(teeth * engaged / turn - rounding));
}

double CuttingProcess::largest_force() const { return cutting_force<double>(*this); }

namespace {

/// Specific cutting force at 1 mm and its exponent: the upper end of what the groups of materials show, sharp tool.
struct CutMaterial {
  std::string_view name;
  double unit_specific_force, exponent;
};
constexpr CutMaterial cut_materials[] = {
    {"unalloyed steel", 1700e6, 0.25},
    {"alloy steel", 1950e6, 0.25},
    {"stainless steel", 2000e6, 0.21},
    {"grey iron", 1100e6, 0.28},
    {"aluminium", 700e6, 0.25},
    {"brass", 700e6, 0.25},
    {"plastic", 250e6, 0.20},
};

void read_material(TableReader& table, QuantityReader& q, CuttingProcess& process) {
  const Node* given = table.find("specific_force");
  if (given != nullptr) {
    q.refuse({"material"}, "the specific force is given as well", "leave one out");
    process.unit_specific_force =
        q.quantity({"specific_force", "at a chip of 1 mm, instead of a material"}, "Pa", Sign::positive).value_or(1e9);
    process.exponent =
        q.share_or({"exponent", "how the specific force falls with the thickness of the chip"}, process.exponent, true);
    return;
  }
  q.refuse({"exponent"}, "a material has its own", "this key goes with specific_force");
  if (q.required("material", "material = \"aluminium\", or specific_force = \"700 N/mm^2\" at a chip of 1 mm") ==
      nullptr)
    return;
  std::vector<std::string> names;
  for (const CutMaterial& material : cut_materials) names.emplace_back(material.name);
  process.material = table.word({"material", "what is cut"}, names).value_or("");
  for (const CutMaterial& material : cut_materials) {
    if (material.name != process.material) continue;
    process.unit_specific_force = material.unit_specific_force;
    process.exponent = material.exponent;
  }
}

}  // namespace

std::optional<CuttingProcess> read_cutting(const Node& node, const std::string& title, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.error_count();
  CuttingProcess process;
  TableReader table(node, title, diagnostics);
  if (!node.is_table()) return std::nullopt;
  QuantityReader q(table, diagnostics);
  const auto size = [&](const text::Key& key) {
    return q.quantity(key, "mm", Sign::positive, Presence::required).value_or(0.001);
  };
  read_material(table, q, process);
  process.depth = size({"depth", "of the cut, along the axis of the cutter"});
  const std::size_t sizes = diagnostics.error_count();
  process.width = size({"width", "of the cut, across the feed; at most the diameter"});
  process.diameter = size({"diameter", "of the cutter"});
  const bool sized = diagnostics.error_count() == sizes;
  process.feed_per_tooth = size({"feed_per_tooth", "of the cutter"});
  process.teeth = q.count_or({"teeth", "of the cutter"}, process.teeth, 1, 100);
  (void)q.required("teeth", "teeth = 2");
  process.cutting_speed =
      q.quantity({"cutting_speed", "of the teeth"}, "m/s", Sign::positive, Presence::required).value_or(1.0);
  process.force_ratio = q.share_or(
      {"force_ratio", "force along this axis over the cutting force; 0.3 to 0.5 along the tool"}, process.force_ratio);
  process.spindle_power =
      q.quantity({"spindle_power", "at the speed of the cut; checked where it is stated"}, "W", Sign::positive)
          .value_or(0.0);
  if (sized && process.width > process.diameter * (1.0 + 1e-12))
    diagnostics.error(table.find("width")->span(),
                      fmt::format("width: a cutter of {} cannot cut as wide as {}",
                                  scalar::format(process.diameter, scalar::Unit::of("mm"), 6),
                                  scalar::format(process.width, scalar::Unit::of("mm"), 6)),
                      "at most the diameter, which is a full slot");
  table.finish();
  if (diagnostics.error_count() > before) return std::nullopt;
  return process;
}

}  // namespace millwright::machine
