// SPDX-License-Identifier: Apache-2.0
#include "app/output.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "app/file_names.h"
#include "app/output_target.h"
#include "catalogue/file_names.h"
#include "report/order_files.h"

namespace millwright::app {

namespace {

/// Columns of the terminal that an output is; 80 where it is none, so that what is written does not hang on who
/// writes it.
std::size_t output_width(int output = STDOUT_FILENO) {
  constexpr std::size_t usual = 80;
  constexpr std::size_t least = 60;  // tables of numbers do not go below
  constexpr std::size_t most = 160;  // lines that are longer are hard to read
  winsize size{};
  if (isatty(output) == 0 || ioctl(output, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return std::clamp<std::size_t>(size.ws_col, least, most);
}

}  // namespace

report::Style output_style(const Options& options) {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool wanted =
      (no_colour == nullptr || *no_colour == '\0') && (terminal != nullptr && std::string_view(terminal) != "dumb");
  return report::Style{.colour = wanted && isatty(STDOUT_FILENO) != 0,
                       .width = output_width(),
                       .brief = options.quiet,
                       .full = options.full};
}

void print(const text::Diagnostics& diagnostics) {
  std::string text = text::format(diagnostics);
  // Whoever reads a file or a pipe expects one line a message.
  if (isatty(STDERR_FILENO) != 0) text = text::folded(text, output_width(STDERR_FILENO));
  std::fwrite(text.data(), 1, text.size(), stderr);
}

bool write_stdout(std::string_view text) {
  const bool good = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!good) fmt::print(stderr, "millwright: error: standard output cannot be written\n");
  return good;
}

namespace {

/// Whether the lines are what another program reads (a schema, Markdown) or point at characters: those stay as they
/// are.
bool has_lines_of_its_own(Verb verb) {
  return verb == Verb::catalogue_lint || verb == Verb::schema || verb == Verb::reference;
}

}  // namespace

bool deliver(const Options& options, const std::string& text, const std::string& json, const std::string& page) {
  text::Diagnostics failures;
  bool good = options.report.empty() || write_target({options.report, OutputKind::page, options.force}, page, failures);
  const bool only_json = options.json == "-";
  if (!options.json.empty() && !only_json)
    good = write_target({options.json, OutputKind::json, options.force}, json, failures) && good;
  // What was computed is shown even if a file of it could not be written.
  if (only_json)
    good = write_stdout(json) && good;
  else
    good = write_stdout(has_lines_of_its_own(options.verb) ? text : report::fitted(text, output_width())) && good;
  print(failures);
  return good;
}

namespace {

bool is_workbook(const std::string& file) { return ending_of(file) == ".xlsx"; }

/// The files of `--order`: a workbook, or a table and beside it the cutting list.
std::vector<std::string> order_files(const std::string& file) {
  if (file.empty()) return {};
  if (is_workbook(file)) return {file};
  const std::filesystem::path path(file);
  return {file, (path.parent_path() / (path.stem().string() + "-cutting.csv")).string()};
}

}  // namespace

bool write_order(const Options& options, const evaluation::Design& design, const std::string& title) {
  if (options.order.empty()) return true;
  const report::OrderList list = report::order_list(design, title);
  text::Diagnostics failures;
  const auto write = [&](const std::string& file, const std::string& contents) {
    write_target({file, OutputKind::edited, options.force}, contents, failures);
  };
  if (is_workbook(options.order)) {
    if (const auto workbook = report::order_xlsx(list, failures)) write(options.order, *workbook);
  } else {
    const std::vector<std::string> files = order_files(options.order);
    write(files[0], report::order_csv(list));
    write(files[1], report::cutting_csv(list));
  }
  print(failures);
  return !failures.has_errors();
}

report::Language page_language(const Options& options) {
  return report::language_of(options.language).value_or(report::Language::english);
}

namespace {

/// A catalogue's files, which a result must not be written over.
void add_files_of(const std::string& place, std::vector<std::string>& files) {
  namespace fs = std::filesystem;
  constexpr int deepest = 1;  // a folder a family
  std::error_code problem;
  if (!fs::is_directory(place, problem)) {
    files.push_back(place);
    return;
  }
  fs::recursive_directory_iterator each(place, fs::directory_options::skip_permission_denied, problem);
  for (const fs::recursive_directory_iterator end; !problem && each != end; each.increment(problem)) {
    if (each.depth() >= deepest) each.disable_recursion_pending();
    if (catalogue::is_csv_name(each->path())) files.push_back(each->path().string());
  }
}

}  // namespace

namespace {

std::vector<OutputTarget> targets_of(const Options& options) {
  std::vector<OutputTarget> targets;
  const auto add = [&](const std::string& file, OutputKind kind) {
    if (!file.empty()) targets.push_back({file, kind, options.force});
  };
  if (options.json != "-") add(options.json, OutputKind::json);
  if (options.verb == Verb::solve) add(options.bom, OutputKind::edited);
  add(options.report, OutputKind::page);
  add(options.csv, OutputKind::edited);
  add(options.write_lock, OutputKind::lock);
  for (const std::string& each : order_files(options.order)) add(each, OutputKind::edited);
  return targets;
}

std::vector<std::string> sources_of(const Options& options) {
  std::vector<std::string> sources{options.problem, options.locked};
  if (options.verb == Verb::check) sources.push_back(options.bom);
  if (options.verb == Verb::audit) sources.push_back(options.subject);
  if (options.verb == Verb::compare || options.verb == Verb::catalogue_diff)
    for (const std::string& place : {options.first, options.second}) add_files_of(place, sources);
  if (options.verb == Verb::catalogue_lint)
    for (const std::string& place : options.words) add_files_of(place, sources);
  for (const std::string& place : options.catalogues) add_files_of(place, sources);
  return sources;
}

}  // namespace

bool outputs_are_writable(const Options& options, text::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  if (!options.order.empty()) {
    const std::string kind = ending_of(options.order);
    if (kind != ".csv" && kind != ".xlsx")
      diagnostics.error(fmt::format("--order: {} is neither a .csv nor an .xlsx file", text::printable(options.order)),
                        "write for example --order order.xlsx");
  }
  const std::vector<OutputTarget> targets = targets_of(options);
  const std::vector<std::string> sources = sources_of(options);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const auto is_same = [&](const OutputTarget& other) { return is_same_file(other.file, targets[i].file); };
    if (std::any_of(targets.begin(), targets.begin() + static_cast<std::ptrdiff_t>(i), is_same))
      diagnostics.error(fmt::format("{}: two outputs cannot go to one file", text::printable(targets[i].file)),
                        "name another file for one of them");
    else
      check_target(targets[i], sources, diagnostics);
  }
  return diagnostics.error_count() == errors;
}

void spare_sources(const Options& options, const std::vector<std::string>& places, text::Diagnostics& diagnostics) {
  std::vector<std::string> sources;
  for (const std::string& place : places) add_files_of(place, sources);
  for (const OutputTarget& target : targets_of(options))
    for (const std::string& source : sources)
      if (is_same_file(source, target.file))
        diagnostics.error(fmt::format("{}: cannot be written: it is read too", text::printable(target.file)),
                          "name another file for the output");
}

}  // namespace millwright::app
