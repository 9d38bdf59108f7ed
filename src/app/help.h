// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace millwright::app {

/// Kept equal to the project version of CMakeLists.txt by a test.
inline constexpr const char* version = "0.1.0";

/// Examples and notes that follow the options in the help of a verb.
std::string examples(std::string_view verb);

}  // namespace millwright::app
