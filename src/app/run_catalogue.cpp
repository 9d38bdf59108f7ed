// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/machine_input.h"
#include "app/output.h"
#include "catalogue/gaps.h"
#include "catalogue/inventory.h"
#include "catalogue/lint.h"
#include "report/catalogue_difference.h"
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
  diagnostics.error("there is no part family " + text::in_quotes(name),
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
    catalogue::Inventory inventory = catalogue::inventory(*loaded);
    if (!inventory.layers.empty()) inventory.layers.front().place = "catalogues";
    delivered = deliver(options,
                        report::families_text(families, inventory, output_style(options)),
                        report::families_json(families, inventory));
  }
  return delivered ? exit_done : exit_bad_input;
}

int show(const Options& options) {
  text::Diagnostics diagnostics;
  outputs_are_writable(options, diagnostics);
  const auto loaded = load(options, diagnostics);
  std::vector<catalogue::PartSheet> sheets;
  for (const std::string& word : loaded ? options.words : std::vector<std::string>()) {
    const catalogue::FoundParts found =
        options.manufacturer.empty() ? loaded->find_named(word) : loaded->find(word, options.manufacturer);
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
  text::Diagnostics unused;  // without the shipped parts a stock file may still name its own
  const catalogue::LintSummary summary =
      catalogue::lint_files(places, family, diagnostics, catalogue_places({}, unused));
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

/// What the places are called that make one catalogue.
std::string name_of(const std::vector<std::filesystem::path>& places) {
  std::string name;
  for (const std::filesystem::path& place : places) name += (name.empty() ? "" : " + ") + place.string();
  return name;
}

/// Two catalogues; or, with one word, what that adds to and changes in those it would be put on.
int diff(const Options& options) {
  text::Diagnostics diagnostics;
  outputs_are_writable(options, diagnostics);
  std::optional<Family> family;
  if (!options.subject.empty()) family = family_of(options.subject, diagnostics);
  std::vector<std::filesystem::path> places[2];
  if (options.second.empty()) {
    places[0] = places[1] = catalogue_places(options.catalogues, diagnostics);
    places[1].emplace_back(options.first);
  } else {
    places[0] = {options.first};
    places[1] = {options.second};
    if (!options.catalogues.empty())
      diagnostics.error("--catalogue: both catalogues are named", "leave it out, or name one: what is put on top");
  }
  Catalogue sides[2];
  // What two folders say of parts need not be of parts that they hold themselves.
  for (int i = 0; i < 2; ++i)
    sides[i] = options.second.empty() ? Catalogue::load(places[i], diagnostics)
                                      : Catalogue::load_parts(places[i], diagnostics);
  std::vector<catalogue::FileDifference> files;
  if (!family && !diagnostics.has_errors()) files = catalogue::overlay_difference(places[0], places[1], diagnostics);
  print(diagnostics);
  if (diagnostics.has_errors()) return exit_bad_input;
  const report::ComparedCatalogue a{name_of(places[0]), &sides[0]}, b{name_of(places[1]), &sides[1]};
  const auto families = catalogue::difference(sides[0], sides[1], family);
  if (!deliver(options,
               report::catalogue_difference_text(a, b, families, files, output_style(options)),
               report::catalogue_difference_json(a, b, families, files)))
    return exit_bad_input;
  const auto is_equal = [](const auto& each) { return each.equal(); };
  const bool equal =
      std::all_of(families.begin(), families.end(), is_equal) && std::all_of(files.begin(), files.end(), is_equal);
  return equal ? exit_done : exit_failed;
}

}  // namespace

int run_catalogue(const Options& options) {
  if (options.verb == Verb::catalogue_list) return list(options);
  if (options.verb == Verb::catalogue_show) return show(options);
  if (options.verb == Verb::catalogue_diff) return diff(options);
  return lint(options);
}

}  // namespace millwright::app
