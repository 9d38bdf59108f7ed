// SPDX-License-Identifier: Apache-2.0
//
// What a unit means; shared by the files that implement unit.h and by nobody else.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scalar/dimension.h"
#include "scalar/unit.h"

namespace millwright::scalar {

/// SI value = value * numerator / denominator + offset. Two whole numbers convert decimal and inch units with a single
/// rounding: 7 mm is exactly the double 0.007.
struct UnitDefinition {
  std::string name;
  Dimension dimension;
  double numerator = 1.0;
  double denominator = 1.0;
  double offset = 0.0;
  double angle = 0.0;  ///< exponent of the radian
  double step = 0.0;   ///< exponent of the step (motor step, pulse)
  std::string currency;
  double currency_exponent = 0.0;
  UnitKind kind = UnitKind::plain;
};

/// The unit a single name stands for, prefixes included ("mm", "kgf", "rpm"). On failure the reason, with a hint.
/// Not thread-safe: the caller holds the lock.
std::optional<UnitDefinition> named_unit(std::string_view name, std::string& reason);

/// A whole unit expression. Not thread-safe: the caller holds the lock.
std::optional<UnitDefinition> unit_expression(std::string_view text, std::string& reason);

/// a * b^exponent. Offsets are dropped: within an expression a degree is a difference. Kinds are not set.
UnitDefinition combined(const UnitDefinition& a, const UnitDefinition& b, double exponent);

/// The kind that follows from dimension, angle, step, currency and offset.
UnitKind kind_of(const UnitDefinition& unit);

}  // namespace millwright::scalar
