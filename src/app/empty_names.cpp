// SPDX-License-Identifier: Apache-2.0
#include "app/empty_names.h"

#include <CLI/CLI.hpp>
#include <set>
#include <string>

namespace millwright::app {

void refuse_empty_names(CLI::App& app) {
  static const std::set<std::string> of_names{"DIR", "NAME", "ORIGIN", "UNIT", "FAMILY"};
  const auto not_empty = [](const std::string& name) { return std::string(name.empty() ? "the name is empty" : ""); };
  for (CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    if ((type.starts_with("FILE") || of_names.contains(type)) && !option->get_positional()) option->check(not_empty);
  }
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) refuse_empty_names(*sub);
}

}  // namespace millwright::app
