// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/options.h"

namespace millwright::app {

/// The options of `catalogue import`.
void add_import_options(CLI::App& verb, Options& options);

}  // namespace millwright::app
