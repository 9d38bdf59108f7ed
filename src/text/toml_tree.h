// SPDX-License-Identifier: Apache-2.0
// toml++ behind our own tree, so that one file only pays for its headers.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "text/diagnostic.h"
#include "text/node.h"
#include "text/source_text.h"

namespace millwright::text {

/// Parses `toml` and gives every node its place in `shown`, which has the same lines and columns but may differ in its
/// characters. Reports the first syntax error, and every number that is not finite.
std::optional<Node> parse_toml_tree(std::string_view toml,
                                    const std::shared_ptr<const SourceText>& shown,
                                    Diagnostics& diagnostics);

}  // namespace millwright::text
