// SPDX-License-Identifier: Apache-2.0
// Commented problem files to begin with (app/templates/*.toml), built into the program.
#pragma once

#include <span>
#include <string_view>

namespace millwright::app {

struct Template {
  std::string_view name;  ///< mill, sander, ...
  std::string_view text;  ///< TOML
};

/// All of them, by name.
std::span<const Template> templates();

}  // namespace millwright::app
