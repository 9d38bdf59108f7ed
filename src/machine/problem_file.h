// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "machine/problem.h"
#include "text/diagnostic.h"
#include "text/document.h"

namespace millwright::machine {

/// Reads a problem file (TOML, or JSON of the same structure) after applying `--set` assignments (path, value).
/// Everything wrong is reported at file:line:column with a hint; the result is empty if there was an error. Units at
/// this door, SI inside.
std::optional<Problem> read_problem(const std::filesystem::path& path,
                                    const std::vector<std::pair<std::string, std::string>>& settings,
                                    text::Diagnostics& diagnostics);

/// From a document already read.
std::optional<Problem> problem_of(const text::Document& document, text::Diagnostics& diagnostics);

}  // namespace millwright::machine
