// SPDX-License-Identifier: Apache-2.0
#include "app/machine_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/output.h"
#include "catalogue/location.h"
#include "machine/choosing_words.h"
#include "machine/problem_file.h"
#include "machine/references.h"
#include "machine/setting_range.h"
#include "text/document.h"

namespace millwright::app {

namespace {

/// Counts what the command line asks for, instead of what the problem file does.
void count_objectives(const std::vector<std::string>& objectives,
                      machine::Problem& problem,
                      text::Diagnostics& diagnostics) {
  problem.counted = machine::counted_quantities(objectives);
  for (const machine::Quantity quantity : problem.counted)
    if (const auto reason = machine::uncountable(problem, quantity))
      diagnostics.error("--minimise: " + reason->message, reason->hint);
}

/// Ranges have been resolved where there may be any.
bool is_single(const std::string& setting, text::Diagnostics& diagnostics) {
  if (!machine::is_setting_range(setting)) return true;
  diagnostics.error(fmt::format("--set {}: only 'solve' takes a range", text::printable(setting)), "give it one value");
  return false;
}

/// Says at the `catalogues` of a problem file which of them do not exist beside it. True if all do.
bool find_catalogues(const text::Document& document, text::Diagnostics& diagnostics) {
  const text::Node* catalogues = document.root().find("catalogues");
  if (catalogues == nullptr) return true;
  const auto folder = std::filesystem::path(document.text()->path()).parent_path();
  bool all = true;
  const auto look = [&](const text::Node& node) {
    const auto name = node.as_string();  // what is no word has been refused
    std::error_code unknown;
    if (!name || std::filesystem::exists(folder / *name, unknown)) return;
    diagnostics.error(node.span(),
                      fmt::format("there is no catalogue {}", text::in_quotes((folder / *name).string(), 200)),
                      "a folder beside the problem file that holds steppers/, ball_screws/, ...");
    all = false;
  };
  if (catalogues->is_array())
    for (const text::Node& node : catalogues->items()) look(node);
  else
    look(*catalogues);
  return all;
}

/// The measured motions of moves, as the problem names them.
void find_profiles(const text::Node& node, bool in_moves, std::vector<std::string>& names) {
  for (const text::TableEntry& each : node.entries()) {
    const auto name = each.value.as_string();
    if (in_moves && each.key == "profile" && name && std::find(names.begin(), names.end(), *name) == names.end())
      names.push_back(*name);
    find_profiles(each.value, in_moves || each.key == "moves", names);
  }
  for (const text::Node& each : node.items()) find_profiles(each, in_moves, names);
}

/// The last one would win, and a report would state both.
bool is_set_once(const std::vector<std::string>& settings, text::Diagnostics& diagnostics) {
  std::set<std::string> paths;
  bool good = true;
  for (const std::string& setting : settings) {
    const std::string path = setting.substr(0, setting.find('='));
    if (paths.insert(path).second) continue;
    diagnostics.error(fmt::format("--set {} is given twice", text::printable(path)), "leave one out");
    good = false;
  }
  return good;
}

std::optional<machine::Problem> read_problem(const Options& options,
                                             std::optional<text::Document>& document,
                                             text::Diagnostics& diagnostics) {
  document = text::read_document(options.problem, diagnostics);
  if (!document) return std::nullopt;
  bool good = is_set_once(options.settings, diagnostics);
  for (const std::string& setting : options.settings)
    good = is_single(setting, diagnostics) && document->set(setting, diagnostics) && good;
  auto problem = machine::problem_of(*document, diagnostics);
  good = find_catalogues(*document, diagnostics) && good;
  if (!good || !problem) return std::nullopt;
  if (!options.objectives.empty()) count_objectives(options.objectives, *problem, diagnostics);
  return problem;
}

}  // namespace

std::vector<std::filesystem::path> catalogue_places(const std::vector<std::string>& overlays,
                                                    text::Diagnostics& diagnostics) {
  std::vector<std::filesystem::path> places;
  if (auto shipped = catalogue::shipped_catalogues(); !shipped.empty())
    places.push_back(std::move(shipped));
  else
    diagnostics.error("the shipped catalogues are not found",
                      "set MILLWRIGHT_CATALOGUES to the folder that holds steppers/, ball_screws/, ...");
  for (const std::string& overlay : overlays) places.emplace_back(overlay);
  return places;
}

std::vector<std::string> profile_names(const text::Document& document) {
  std::vector<std::string> names;
  find_profiles(document.root(), false, names);
  return names;
}

std::optional<MachineInput> read_machine(const Options& options, text::Diagnostics& diagnostics) {
  std::optional<text::Document> document;
  auto problem = read_problem(options, document, diagnostics);
  std::vector<std::string> overlays;
  if (problem) {
    const auto folder = std::filesystem::path(options.problem).parent_path();
    for (const std::string& each : problem->catalogues) overlays.push_back((folder / each).string());
  }
  overlays.insert(overlays.end(), options.catalogues.begin(), options.catalogues.end());
  const auto places = catalogue_places(overlays, diagnostics);
  const std::size_t errors = diagnostics.error_count();
  auto catalogue = catalogue::Catalogue::load(places, diagnostics);
  if (!problem) return std::nullopt;
  std::vector<std::string> read;
  for (const std::filesystem::path& place : places) read.push_back(place.string());
  for (const std::string& name : profile_names(*document))
    read.push_back((std::filesystem::path(options.problem).parent_path() / name).string());
  spare_sources(options, read, diagnostics);
  machine::Steering steering;
  steering.settings = options.settings;
  if (diagnostics.error_count() == errors) {  // else parts may seem unknown that only could not be read
    machine::check_references(*problem, catalogue, diagnostics);
    machine::note_idle_words(*problem, *document, catalogue, diagnostics);
    steering.without = machine::read_excluded(options.without, *problem, catalogue, diagnostics);
    machine::exclude_unavailable(catalogue, steering.without);
    steering.fixed = machine::read_fixed(options.fixed, *problem, catalogue, steering.without, diagnostics);
  }
  steering.limits = machine::add_limits(options.limits, *problem, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::vector<catalogue::Part> dropped;
  for (const machine::ExcludedPart& part : steering.without)
    dropped.insert(dropped.end(), part.rows.begin(), part.rows.end());
  MachineInput input{std::move(*problem), std::move(catalogue), std::move(steering), std::move(document), std::nullopt};
  if (!dropped.empty()) {
    input.whole_catalogue = input.catalogue;
    input.catalogue.drop(dropped);
  }
  return input;
}

void shorten_places(evaluation::Design& design) {
  const std::string shipped = catalogue::shipped_catalogues().string() + "/";
  for (evaluation::PartLine& part : design.parts)
    if (part.where.rfind(shipped, 0) == 0) part.where = "catalogues/" + part.where.substr(shipped.size());
}

}  // namespace millwright::app
