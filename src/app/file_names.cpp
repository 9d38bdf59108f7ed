// SPDX-License-Identifier: Apache-2.0
#include "app/file_names.h"

#include <filesystem>
#include <set>
#include <string>

#include "text/characters.h"

namespace millwright::app {

std::string ending_of(const std::string& file) {
  return text::lower_case(std::filesystem::path(file).extension().string());
}

namespace {

CLI::Validator ending_as(const std::string& kind) {
  const auto complaint = [kind](const std::string& name) -> std::string {
    static const std::set<std::string> known{".xlsx", ".xls", ".ods", ".pdf", ".docx", ".md", ".json", ".html"};
    const std::string ending = ending_of(name);
    const bool is_other = name == "-" || (known.contains(ending) && ending != kind);
    return is_other ? name + ": a " + kind + " file is expected here" : "";
  };
  return CLI::Validator(complaint, "");
}

}  // namespace

void refuse_wrong_names(CLI::App& app) {
  static const std::set<std::string> of_names{"DIR", "NAME", "ORIGIN", "UNIT", "FAMILY"};
  static const std::set<std::string> written{"--bom", "--csv", "--report"};  // others say themselves what they may be
  const auto not_empty = [](const std::string& name) { return std::string(name.empty() ? "the name is empty" : ""); };
  for (CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    if (option->get_positional()) continue;
    if (type.starts_with("FILE") || of_names.contains(type)) option->check(not_empty);
    if (written.contains(option->get_name())) option->check(ending_as(type.substr(std::string("FILE").size())));
  }
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) refuse_wrong_names(*sub);
}

}  // namespace millwright::app
