// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/json_value.h"
#include "text/diagnostic.h"

namespace millwright::report {

/// Everything that was found, with its place.
Json findings_of(const text::Diagnostics& diagnostics);

}  // namespace millwright::report
