// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace millwright::report {

/// The SHA-256 of a lock without its line `seal = "..."` and without carriage returns, which a checkout may add. It
/// tells an edited file from one that the program wrote; it protects from nobody who wants to forge one.
std::string seal_of(std::string_view contents);

}  // namespace millwright::report
