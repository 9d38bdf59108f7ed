// SPDX-License-Identifier: Apache-2.0
// What `--minimise` says, and how the command line is complained of.
#pragma once

#include <string>

#include "app/options.h"

namespace millwright::app {

/// Prints an error of the command line, and a hint if there is one.
void complain(const std::string& message, const std::string& hint);

/// Objectives by their names, as many as the verb takes; false, after a complaint, if they are none.
bool settle_objectives(Options& options);

}  // namespace millwright::app
