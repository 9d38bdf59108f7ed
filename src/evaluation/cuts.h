// SPDX-License-Identifier: Apache-2.0
// What of a part is cut from stock that is sold by length or mass, and what of its price that is.
#pragma once

#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/ledger.h"
#include "evaluation/slot_table.h"
#include "machine/problem.h"

namespace millwright::evaluation {

/// The pieces to cut for a part of an axis: its length is that of one piece, and of a guide's line that of one rail.
/// Empty for whole pieces, among them racks, which are joined.
std::vector<Cut> cuts_of(const machine::Problem& problem, const PartUse& use, const std::string& axis_name);

/// How many ends of a screw of this axis are machined for a bearing.
double machined_ends(const machine::Axis& axis);

}  // namespace millwright::evaluation
