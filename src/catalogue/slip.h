// SPDX-License-Identifier: Apache-2.0
// The slips that people make when they copy a figure from a data sheet, each as the factor by which it falsifies it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "catalogue/family.h"

namespace millwright::catalogue {

/// A figure that is `factor` times what it should be, and what has probably happened. `weight`: how often this is the
/// reason, of all wrong figures of such columns.
struct Slip {
  double factor;
  double weight;
  std::string_view words;
};

/// The slips that a column invites (a torque with one phase on), those that its unit makes possible, then those of any
/// figure (decimal point, doubled, halved).
std::span<const Slip> slips(Column column);

/// "10 times too large", "2.45 times too small" for a factor above or below 1.
std::string times(double factor);

}  // namespace millwright::catalogue
