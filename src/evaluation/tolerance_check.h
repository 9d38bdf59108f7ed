// SPDX-License-Identifier: Apache-2.0
//
// Whether a build stays compliant when figures of its parts are off by the tolerances that the catalogues state for
// them. Worst case, not likelihood: every combination of values within the tolerances counts. A figure belongs to a
// part of the catalogue: wherever the machine takes that part it has the same value. Dimensions, ramps and settings
// stay as designed.
//
// Compliant means proved: intervals that enclose every value keep every limit, over the whole box of tolerances or over
// every piece into which it was cut. Not compliant means shown: values were found with which a check fails when the
// machine is evaluated with them.
#pragma once

#include <atomic>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "catalogue/family.h"
#include "solver/solver.h"

namespace millwright::evaluation {

class MachineModel;
struct Design;

/// A figure with a stated tolerance.
struct TolerancedFigure {
  catalogue::Family family{};
  int row = 0;              ///< in the catalogue of the model
  std::vector<int> rows{};  ///< with those that sell the same part otherwise: it is taken from one or several of them
  catalogue::Column column{};
  std::string part;                 ///< maker and part number
  std::vector<std::string> places;  ///< "x.motor"
  double value = 0.0;               ///< SI
  double half_width = 0.0;          ///< SI
  bool estimate = false;
  std::string basis;  ///< what the catalogue says about where the figure comes from
  [[nodiscard]] double share() const { return half_width / (value < 0.0 ? -value : value); }
};

/// Values within the tolerances with which a check fails.
struct ToleranceBreak {
  std::vector<std::pair<std::size_t, double>> values;  ///< figure and value [SI], of those that are not as stated
  std::optional<double>
      from;  ///< of a single figure: about the value next to the stated one that breaks the build [SI]
  std::string axis, check, title;  ///< the check that fails by most
  double utilisation = 0.0;        ///< of that check
};

enum class ToleranceVerdict {
  none_stated,  ///< no figure of the chosen parts has a tolerance
  compliant,    ///< for every value within the stated tolerances
  broken,
  unsettled,  ///< neither proved nor refuted within the effort
  not_asked   ///< the build fails as it stands
};
const char* to_string(ToleranceVerdict verdict);

struct ToleranceCheck {
  ToleranceVerdict verdict = ToleranceVerdict::none_stated;
  std::vector<TolerancedFigure> figures;
  std::vector<ToleranceBreak> single;         ///< figures that break the build alone, the others as stated
  std::optional<ToleranceBreak> combination;  ///< where none does alone
  std::size_t unstated = 0;     ///< estimated figures of the chosen parts without a tolerance: taken as they stand
  std::size_t evaluations = 0;  ///< of the machine with other values
  std::size_t boxes = 0;        ///< pieces of the tolerances that were bounded
  bool stopped = false;         ///< it is unsettled because time was up
};

/// At most; beyond it is unsettled, unless something that breaks the build was found before.
struct ToleranceEffort {
  std::size_t boxes = 4000;
  double seconds = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* stop = nullptr;
};

/// `build` in rows of model.problem(), `design` what it amounts to.
ToleranceCheck check_tolerances(const MachineModel& model,
                                const solver::Build& build,
                                const Design& design,
                                const ToleranceEffort& effort = {});

}  // namespace millwright::evaluation
