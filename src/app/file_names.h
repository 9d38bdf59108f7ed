// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace millwright::app {

/// Makes every option of a command and of those below it that names something (a file, a folder, a family, a unit)
/// refuse the empty name: `--json "$FILE"` of a script in which FILE is not set must not pass for no --json. Options
/// that write a file of one kind refuse `-` and the endings of workbooks and documents: a build.xlsx in which there is
/// a table of text opens nowhere.
void refuse_wrong_names(CLI::App& app);

}  // namespace millwright::app
