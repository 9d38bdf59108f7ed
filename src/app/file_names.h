// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace millwright::app {

/// What a file's name ends with, in small letters: ".csv" of ORDER.CSV; empty without a point.
std::string ending_of(const std::string& file);

/// Makes every option of a command and of those below it that names something (a file, a folder, a family, a unit)
/// refuse the empty name: `--json "$FILE"` of a script in which FILE is not set must not pass for no --json. Options
/// that write a file of one kind refuse `-` and the endings of workbooks and documents: a build.xlsx in which there is
/// a table of text opens nowhere.
void refuse_wrong_names(CLI::App& app);

}  // namespace millwright::app
