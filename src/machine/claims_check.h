// SPDX-License-Identifier: Apache-2.0
//
// What a claims file must satisfy as a whole, once every block has been read.
#pragma once

#include "machine/claims.h"

namespace millwright::machine {

/// Reports names that nothing defines (with the nearest that exists), rows that depend on themselves, operands and
/// results of the wrong dimension. Afterwards, without errors, every calculation can be evaluated.
void check_claims(const ClaimsFile& file, text::Diagnostics& diagnostics);

}  // namespace millwright::machine
