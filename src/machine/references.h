// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/catalogue.h"
#include "machine/problem.h"
#include "text/diagnostic.h"

namespace millwright::machine {

/// Whether everything that the problem names in the catalogues exists there: the materials of its members, the sizes
/// and property classes of its screws. What does not is reported at the member, with the nearest name. Parts that are
/// not for sale because their currency has no rate are warned of.
bool check_references(const Problem& problem, const catalogue::Catalogue& catalogue, text::Diagnostics& diagnostics);

}  // namespace millwright::machine
