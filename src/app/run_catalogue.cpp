// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "app/commands.h"
#include "app/machine_input.h"
#include "app/output.h"
#include "catalogue/gaps.h"
#include "catalogue/lint.h"
#include "report/catalogue_gaps.h"
#include "report/catalogue_text.h"
#include "report/json.h"
#include "text/nearest.h"

namespace millwright::app {

namespace {

using catalogue::Catalogue;
using catalogue::Family;

/// The family of that name; reports if there is none.
std::optional<Family> family_of(const std::string& name, text::Diagnostics& diagnostics) {
  if (const auto family = catalogue::find_family(name)) return family;
  std::vector<std::string_view> names;
  for (const catalogue::FamilyDeclaration& each : catalogue::families) names.push_back(each.name);
  diagnostics.error("there is no part family " + text::quoted(name),
                    text::did_you_mean(name, names, fmt::format("families: {}", fmt::join(names, ", "))));
  return std::nullopt;
}

std::optional<Catalogue> load(const Options& options, text::Diagnostics& diagnostics) {
  auto loaded = Catalogue::load(catalogue_places(options.catalogues, diagnostics), diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return loaded;
}

int list(const Options& options) {
  text::Diagnostics diagnostics;
  outputs_are_writable(options, diagnostics);
  std::optional<Family> family;
  if (!options.subject.empty()) family = family_of(options.subject, diagnostics);
  const auto loaded = load(options, diagnostics);
  print(diagnostics);
  if (!loaded) return exit_bad_input;
  bool delivered = false;
  if (options.gaps) {
    std::vector<catalogue::Gap> gaps = catalogue::find_gaps(*loaded);
    std::erase_if(gaps, [&](const catalogue::Gap& gap) { return family && gap.family != *family; });
    delivered = deliver(options, report::gaps_text(gaps, output_style(options)), report::gaps_json(gaps));
  } else if (family) {
    const auto parts = catalogue::list_parts(loaded->table(*family));
    delivered = deliver(
        options, report::parts_list_text(parts, output_style(options)), report::parts_json(options.subject, parts));
  } else {
    const auto families = catalogue::summarise(*loaded);
    delivered =
        deliver(options, report::families_text(families, output_style(options)), report::families_json(families));
  }
  return delivered ? exit_done : exit_bad_input;
}

int show(const Options& options) {
  text::Diagnostics diagnostics;
  outputs_are_writable(options, diagnostics);
  const auto loaded = load(options, diagnostics);
  std::vector<catalogue::PartSheet> sheets;
  for (const std::string& word : loaded ? options.words : std::vector<std::string>()) {
    const catalogue::FoundParts found = loaded->find(word, options.manufacturer);
    if (found.parts.empty()) diagnostics.error(found.error, found.hint);
    for (const catalogue::Part& part : found.parts)
      sheets.push_back(catalogue::show(loaded->table(part.family), part.row));
  }
  print(diagnostics);
  if (diagnostics.has_errors()) return exit_bad_input;
  std::string text;
  for (const catalogue::PartSheet& sheet : sheets)
    text += (text.empty() ? "" : "\n") + report::sheet_text(sheet, output_style(options));
  return deliver(options, text, report::sheets_json(sheets)) ? exit_done : exit_bad_input;
}

/// The findings are the answer, so they go to standard output.
int lint(const Options& options) {
  text::Diagnostics diagnostics;
  std::optional<Family> family;
  if (!options.subject.empty()) family = family_of(options.subject, diagnostics);
  outputs_are_writable(options, diagnostics);
  if (diagnostics.has_errors()) {
    print(diagnostics);
    return exit_bad_input;
  }
  const std::vector<std::filesystem::path> places(options.words.begin(), options.words.end());
  const catalogue::LintSummary summary = catalogue::lint_files(places, family, diagnostics);
  const std::string text = text::format(diagnostics) + fmt::format("{} file{}, {} row{}: {} error{}, {} warning{}\n",
                                                                   summary.files,
                                                                   summary.files == 1 ? "" : "s",
                                                                   summary.rows,
                                                                   summary.rows == 1 ? "" : "s",
                                                                   summary.errors,
                                                                   summary.errors == 1 ? "" : "s",
                                                                   summary.warnings,
                                                                   summary.warnings == 1 ? "" : "s");
  const std::string json = report::lint_json(diagnostics, summary.files, summary.rows);
  return deliver(options, text, json) && !diagnostics.has_errors() ? exit_done : exit_bad_input;
}

}  // namespace

int run_catalogue(const Options& options) {
  if (options.verb == Verb::catalogue_list) return list(options);
  if (options.verb == Verb::catalogue_show) return show(options);
  return lint(options);
}

}  // namespace millwright::app
