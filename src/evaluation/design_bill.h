// SPDX-License-Identifier: Apache-2.0
//
// A design as somebody would write it down: the bill of materials that `check` reads.
#pragma once

#include "evaluation/ledger.h"
#include "machine/bill_of_materials.h"

namespace millwright::evaluation {

/// Every part with its count and length, every dimension and setting with its value. Without what is made to measure,
/// which its dimensions tell, and without a reduction that has no name, of which there is only one.
[[nodiscard]] machine::BillOfMaterials bill_of(const Design& design);

}  // namespace millwright::evaluation
