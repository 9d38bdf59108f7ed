// SPDX-License-Identifier: Apache-2.0
//
// Parts that no build of a machine has because a figure that a check reads, or a price, is missing in the catalogues.
// What is proved is proved without them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "evaluation/machine_model.h"

namespace millwright::evaluation {

struct HeldParts;  // held_parts.h

/// Parts of one family that lack the same.
struct IncompleteParts {
  std::string family;
  /// Columns that were asked for in vain, while all that can be chosen in their place has a figure there; those of
  /// another family as "materials.yield_strength". None: what is missing stands in no column (a rate for its currency),
  /// or its every partner lacks something.
  std::vector<std::string> missing;
  std::vector<std::string> parts;  ///< "Mean Well LRS-50-24", in ascending order
  std::size_t known = 0;           ///< parts of the whole family in the catalogues
};

/// Of all slots but those that are fixed (ModelOptions::fixed): by families in their order, those without any left out,
/// and within a family the more frequent first. A part is told if it cannot be chosen in some slot that would permit
/// it. Of those that can only be bought as a pair (a screw, and a nut that runs on it) these are also parts whose every
/// partner lacks something. A part that several offer is complete if one offer is.
std::vector<IncompleteParts> incomplete_parts(const MachineModel& model);

/// The same of the slots that a bill of materials leaves open. A pair is open as long as one of both is.
std::vector<IncompleteParts> incomplete_parts(const MachineModel& model, const HeldParts& held);

/// What several of these say together: each part once, with all that it lacks in one of them.
std::vector<IncompleteParts> united(std::span<const IncompleteParts> all);

/// The same of one slot.
std::vector<IncompleteParts> incomplete_parts(const catalogue::Catalogue& catalogue, const SlotTable& slot);

}  // namespace millwright::evaluation
