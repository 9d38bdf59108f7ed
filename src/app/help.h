// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "report/version.h"

namespace millwright::app {

inline constexpr const char* version = report::program_version;

/// Examples and notes that follow the options in the help of a verb.
std::string examples(std::string_view verb);

}  // namespace millwright::app
