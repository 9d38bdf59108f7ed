// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/family.h"
#include "scalar/unit.h"

namespace millwright::catalogue {

/// The declared unit of a column (dimensionless for texts, flags and prices per piece); looked up once a program.
const scalar::Unit& display_unit(Column column);

}  // namespace millwright::catalogue
