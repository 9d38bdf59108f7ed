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

#include "app/lock.h"
#include "report/order_files.h"
#include "text/output_file.h"

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

namespace {

/// Whether the lines are what another program reads (a schema, Markdown) or point at characters: those stay as they
/// are.
bool has_lines_of_its_own(Verb verb) {
  return verb == Verb::catalogue_lint || verb == Verb::schema || verb == Verb::reference;
}

bool write_stdout(const std::string& text) {
  const bool good = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!good) fmt::print(stderr, "millwright: error: standard output cannot be written\n");
  return good;
}

}  // namespace

bool deliver(const Options& options, const std::string& text, const std::string& json, const std::string& page) {
  text::Diagnostics failures;
  if (!options.report.empty() && !text::write_file_atomically(options.report, page, failures)) {
    print(failures);
    return false;
  }
  if (options.json == "-") return write_stdout(json);
  text::Diagnostics diagnostics;
  if (!options.json.empty() && !text::write_file_atomically(options.json, json, diagnostics)) {
    print(diagnostics);
    return false;
  }
  return write_stdout(has_lines_of_its_own(options.verb) ? text : report::fitted(text, output_width()));
}

namespace {

bool is_workbook(const std::string& file) { return std::filesystem::path(file).extension() == ".xlsx"; }

/// The files of `--order`: a workbook, or a table and beside it the cutting list.
std::vector<std::string> order_files(const std::string& file) {
  if (file.empty() || is_workbook(file)) return {file};
  const std::filesystem::path path(file);
  return {file, (path.parent_path() / (path.stem().string() + "-cutting.csv")).string()};
}

}  // namespace

bool write_order(const Options& options, const evaluation::Design& design, const std::string& title) {
  if (options.order.empty()) return true;
  const report::OrderList list = report::order_list(design, title);
  text::Diagnostics failures;
  if (is_workbook(options.order)) {
    if (const auto workbook = report::order_xlsx(list, failures))
      text::write_file_atomically(options.order, *workbook, failures);
  } else {
    const std::vector<std::string> files = order_files(options.order);
    text::write_file_atomically(files[0], report::order_csv(list), failures);
    text::write_file_atomically(files[1], report::cutting_csv(list), failures);
  }
  print(failures);
  return !failures.has_errors();
}

report::Language page_language(const Options& options) {
  return report::language_of(options.language).value_or(report::Language::english);
}

namespace {

/// Reports why the file could not be written, or must not be: it is one of those that are read.
void check_target(const std::string& target, const std::vector<std::string>& sources, text::Diagnostics& diagnostics) {
  namespace fs = std::filesystem;
  std::error_code failure;
  if (std::any_of(sources.begin(), sources.end(), [&](const std::string& source) {
        return fs::equivalent(source, target, failure);
      }))
    diagnostics.error(fmt::format("{}: cannot be written: it is read too", text::printable(target)),
                      "name another file for the output");
  const fs::path parent = fs::path(target).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder, failure))
    diagnostics.error(
        fmt::format(
            "{}: cannot be written: there is no folder {}", text::printable(target), text::quoted(folder.string())),
        "make the folder first");
  else if (access(folder.c_str(), W_OK) != 0)
    diagnostics.error(fmt::format("{}: cannot be written: no right to write in its folder", text::printable(target)));
  else if (fs::is_directory(target, failure))
    diagnostics.error(fmt::format("{}: cannot be written: it is a folder", text::printable(target)));
}

}  // namespace

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
    if (each->path().extension() == ".csv") files.push_back(each->path().string());
  }
}

}  // namespace

bool outputs_are_writable(const Options& options, text::Diagnostics& diagnostics) {
  namespace fs = std::filesystem;
  std::vector<std::string> targets;
  if (!options.json.empty() && options.json != "-") targets.push_back(options.json);
  if (options.verb == Verb::solve && !options.bom.empty()) targets.push_back(options.bom);
  if (!options.report.empty()) targets.push_back(options.report);
  if (!options.csv.empty()) targets.push_back(options.csv);
  if (!options.write_lock.empty()) targets.push_back(options.write_lock);
  const std::size_t errors = diagnostics.error_count();
  if (!options.write_lock.empty()) may_hold_lock(options.write_lock, diagnostics);
  if (!options.order.empty()) {
    const std::string kind = fs::path(options.order).extension().string();
    if (kind != ".csv" && kind != ".xlsx")
      diagnostics.error(fmt::format("--order: {} is neither a .csv nor an .xlsx file", text::printable(options.order)),
                        "write for example --order order.xlsx");
    for (const std::string& each : order_files(options.order)) targets.push_back(each);
  }
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (std::find(targets.begin(), targets.begin() + static_cast<std::ptrdiff_t>(i), targets[i]) !=
        targets.begin() + static_cast<std::ptrdiff_t>(i))
      diagnostics.error(fmt::format("{}: two outputs cannot go to one file", text::printable(targets[i])),
                        "name another file for one of them");
  std::vector<std::string> sources{options.problem, options.locked};
  if (options.verb == Verb::check) sources.push_back(options.bom);
  if (options.verb == Verb::compare || options.verb == Verb::catalogue_diff)
    sources.insert(sources.end(), {options.first, options.second});
  for (const std::string& place : options.catalogues) add_files_of(place, sources);
  for (const std::string& target : targets) check_target(target, sources, diagnostics);
  return diagnostics.error_count() == errors;
}

}  // namespace millwright::app
