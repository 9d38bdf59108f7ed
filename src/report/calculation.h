// SPDX-License-Identifier: Apache-2.0
// One formula evaluated for given arguments, as plain data, and its text.
#pragma once

#include <string>
#include <vector>

#include "mechanics/formula.h"
#include "report/text_table.h"
#include "scalar/traced.h"
#include "scalar/unit.h"

namespace millwright::report {

/// An argument as it was understood.
struct CalculationInput {
  std::string name;
  std::string symbol;
  std::string meaning;
  std::string given;           ///< as typed
  std::vector<double> values;  ///< SI; several for a list, none for a word
  std::string word;            ///< name of an enumerator
  bool is_list = false;
  std::string unit;  ///< SI unit of the values
};

struct Calculation {
  const mechanics::Formula* formula = nullptr;
  std::vector<CalculationInput> inputs;
  double value = 0.0;  ///< SI
  scalar::Unit unit;   ///< to show the value in
  scalar::Unit si_unit;
  std::vector<scalar::DerivationLine> derivation;
  std::vector<std::string> warnings;  ///< stated limits that the arguments break
};

/// Inputs, derivation, value and warnings.
std::string calculation_text(const Calculation& calculation, const Style& style);

/// One formula with its arguments, validity and source.
std::string formula_text(const mechanics::Formula& formula, const Style& style);

}  // namespace millwright::report
