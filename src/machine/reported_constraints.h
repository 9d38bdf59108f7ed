// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace millwright::machine {

/// Ids of the constraints of axes that are reported and not enforced unless the problem file says so, each once.
std::vector<std::string_view> reported_constraints();

}  // namespace millwright::machine
