// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/commands.h"
#include "app/file_names.h"
#include "app/output.h"
#include "app/output_target.h"
#include "app/templates.h"
#include "text/nearest.h"

namespace millwright::app {

namespace {

/// The template of that name; reports if there is none.
const Template* find_template(const std::string& name, text::Diagnostics& diagnostics) {
  std::vector<std::string_view> names;
  for (const Template& each : templates()) {
    if (each.name == name) return &each;
    names.push_back(each.name);
  }
  const std::string all = fmt::format("templates: {}", fmt::join(names, ", "));
  if (name.empty())
    diagnostics.error("which machine is it to be?", "say --template mill; " + all);
  else
    diagnostics.error("there is no template " + text::in_quotes(name), text::did_you_mean(name, names, all));
  return nullptr;
}

/// What is wrong with the name of the file, as far as writing itself would not find it.
void check_name(const Options& options, text::Diagnostics& diagnostics) {
  const std::string shown = text::printable(options.problem);
  if (ending_of(options.problem) == ".json")
    diagnostics.error(shown + ": templates are TOML, and a file of this name is read as JSON", "let it end in .toml");
}

}  // namespace

int run_new(const Options& options) {
  text::Diagnostics diagnostics;
  const Template* found = find_template(options.subject, diagnostics);
  if (found != nullptr && options.problem == "-") return write_stdout(found->text) ? exit_done : exit_bad_input;
  check_name(options, diagnostics);
  if (!diagnostics.has_errors()) check_target({options.problem, OutputKind::edited, options.force}, {}, diagnostics);
  if (!diagnostics.has_errors())
    (void)write_target({options.problem, OutputKind::edited, options.force}, found->text, diagnostics);
  print(diagnostics);
  if (diagnostics.has_errors()) return exit_bad_input;
  const std::string shown = text::printable(options.problem);
  return deliver(
             options,
             fmt::format("{0}: written. 'millwright solve {0}' designs the machine; 'millwright reference' explains "
                         "every key.\n",
                         shown),
             "")
             ? exit_done
             : exit_bad_input;
}

}  // namespace millwright::app
