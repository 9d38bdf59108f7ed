// SPDX-License-Identifier: Apache-2.0
// The arguments of `calc`: words of the command line become values of a formula's arguments.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanics/formula.h"
#include "report/calculation.h"
#include "text/diagnostic.h"

namespace millwright::app {

/// Values in the order of the formula's arguments, as understood.
struct CalcArguments {
  std::vector<mechanics::ArgumentValue<double>> values;
  std::vector<report::CalculationInput> inputs;
  std::vector<scalar::Unit> units;  ///< in which each was given
};

/// Reads `name=value` words: "force=6.4 kN", lists "loads=100 N,80 N", enumerators "ends=fixed_supported". Reported are
/// unknown names (with the nearest), names given twice, values that do not fit, and what is missing. The place of a
/// complaint is in a text of its own that shows the word.
std::optional<CalcArguments> read_calc_arguments(const mechanics::Formula& formula,
                                                 const std::vector<std::string>& words,
                                                 text::Diagnostics& diagnostics);

}  // namespace millwright::app
