// SPDX-License-Identifier: Apache-2.0
//
// The same machine with its parts ordered where they cost least. A search that is ended by a limit may have come upon
// good parts in a bad order: two shops' shipping where one sells everything.
#pragma once

#include <cstddef>
#include <vector>

#include "evaluation/search_options.h"
#include "solver/restricted_problem.h"

namespace millwright::evaluation {

/// Builds with their parts, dimensions and supply voltages as they are, from the suppliers of which the order costs
/// least as builds are compared (MachineModel::compared). A build stays as it is where no other order is cheaper or
/// none is found in the time there is for all, in seconds; all do where suppliers charge for nothing but their parts,
/// or where the model was made for objectives that no cost is in. Of a front those are left out that another one beats
/// then. Of the options objectives, gap and threads count.
void order_cheapest(const MachineModel& model,
                    const SearchOptions& options,
                    std::vector<solver::Build>& builds,
                    double seconds);

/// Which rows of a model differ only in who sells their parts.
class AlikeRows {
 public:
  explicit AlikeRows(const MachineModel& model);

  /// What a build consists of: the same numbers where only the sellers differ.
  [[nodiscard]] std::vector<std::size_t> parts_of(const solver::Build& build) const;
  /// Everything of a build is held but who sells its parts.
  [[nodiscard]] solver::Restriction with_parts_of(const MachineModel& model, const solver::Build& build) const;

 private:
  std::vector<std::vector<std::vector<std::size_t>>> parts_;  ///< [stage][slot][row]
};

/// A build that fails checks, whatever they are, with its parts from the suppliers of which the order costs least: as
/// builds are compared within the limit of the cost, if that can be kept, and else in money. Of what is in stock no
/// more is taken than there is. The build itself where nobody sells all of it, or time (`seconds`) is up. The model has
/// neither scenarios nor fixed parts.
solver::Build ordered_cheapest_though_failing(const MachineModel& model,
                                              const AlikeRows& alike,
                                              const SearchOptions& options,
                                              const solver::Build& build,
                                              double seconds);

}  // namespace millwright::evaluation
