// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace millwright::catalogue {

/// The names of all rules that a row can be excused from: those that compare figures of a row exactly (lint_drive.cpp,
/// lint_structure.cpp) and the relations. Each once, in no order.
const std::vector<std::string_view>& rule_names();

}  // namespace millwright::catalogue
