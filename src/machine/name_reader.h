// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "machine/quantity_reader.h"
#include "text/diagnostic.h"
#include "text/node.h"

namespace millwright::machine {

/// Whether the text of `node` may name `what` ("an axis", "a member"): names are columns of bills of materials and
/// steps of `--set` paths, so they consist of letters, digits, `_` and `-` and begin with a letter. Reports the first
/// character that does not fit. Empty or no text: false, and nothing is reported (the reader of the key does).
bool check_name(const text::Node& node, const std::string& what, text::Diagnostics& diagnostics);

}  // namespace millwright::machine
