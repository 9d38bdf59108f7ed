// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace millwright::report {

/// Of the program, kept equal to the project version of CMakeLists.txt by a test.
inline constexpr const char* program_version = "0.1.0";

}  // namespace millwright::report
