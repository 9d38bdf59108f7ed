// SPDX-License-Identifier: Apache-2.0
//
// Where a design leaves the ranges that its formulas are stated for, gathered element by element.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "evaluation/ledger.h"
#include "mechanics/outside_validity.h"

namespace millwright::evaluation {

/// Each limit of a formula once for each element, with the values that break it most.
class ValidityLedger {
 public:
  /// `constraint`: id of the constraint during which was watched; empty for what all of an element's checks share.
  void take(const mechanics::ValidityWatch& watch,
            const std::string& axis,
            const std::string& element,
            std::string_view constraint);
  void write(Design& design) const;

 private:
  struct Entry {
    std::string axis, element, constraint;
    mechanics::LeftRange left;
  };
  std::vector<Entry> entries_;
  std::set<const mechanics::Formula*> formulas_;
};

}  // namespace millwright::evaluation
