// SPDX-License-Identifier: Apache-2.0
//
// A bill of materials as people keep it: CSV `axis,slot,manufacturer,part_number,quantity,length,value[,origin]`. A
// line names a part for a slot, or a dimension or setting by its value ("x,acceleration_time,,,,,0.2 s"); the axis
// `machine` holds what is shared.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine/problem.h"
#include "text/diagnostic.h"

namespace millwright::machine {

struct BomLine {
  std::string axis, slot, manufacturer, part_number;
  std::optional<double> quantity;
  std::optional<double> length;  ///< m
  std::optional<double> value;   ///< SI, of a dimension or setting
  std::string origin;            ///< "paper", "ours", or empty
  SourceSpan where;              ///< the part number, or the value
  [[nodiscard]] bool is_dimension() const { return value.has_value(); }
};

struct BillOfMaterials {
  std::string file;
  std::vector<BomLine> lines;
};

/// Reads a BOM. Reported with place and hint: unknown axis or slot of the problem (nearest known one), a slot given
/// twice, a length or value without unit or of the wrong dimension, neither part nor value, missing columns. Parts are
/// looked up by the caller.
std::optional<BillOfMaterials> read_bill_of_materials(std::shared_ptr<const text::SourceText> text,
                                                      const Problem& problem,
                                                      text::Diagnostics& diagnostics);

/// Slots an axis of the problem has ("screw", "nut", ..., the names of its members), and its settings
/// ("acceleration_time", "shaft.diameter").
std::vector<std::string> slot_names(const Axis& axis);
std::vector<std::string> setting_names(const Axis& axis);

/// Unit that the value of a setting is given in.
std::string_view unit_of_setting(const std::string& name);

}  // namespace millwright::machine
