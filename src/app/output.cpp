// SPDX-License-Identifier: Apache-2.0
#include "app/output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "text/output_file.h"

namespace millwright::app {

report::Style output_style() {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool wanted =
      (no_colour == nullptr || *no_colour == '\0') && (terminal != nullptr && std::string_view(terminal) != "dumb");
  return report::Style{.colour = wanted && isatty(STDOUT_FILENO) != 0};
}

void print(const text::Diagnostics& diagnostics) {
  const std::string text = text::format(diagnostics);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

namespace {

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
  return write_stdout(text);
}

report::Language page_language(const Options& options) {
  return report::language_of(options.language).value_or(report::Language::english);
}

bool outputs_are_writable(const Options& options, text::Diagnostics& diagnostics) {
  namespace fs = std::filesystem;
  std::vector<std::string> targets;
  if (!options.json.empty() && options.json != "-") targets.push_back(options.json);
  if (options.verb == Verb::solve && !options.bom.empty()) targets.push_back(options.bom);
  if (!options.report.empty()) targets.push_back(options.report);
  const std::size_t errors = diagnostics.error_count();
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (std::find(targets.begin(), targets.begin() + static_cast<std::ptrdiff_t>(i), targets[i]) !=
        targets.begin() + static_cast<std::ptrdiff_t>(i))
      diagnostics.error(fmt::format("{}: two outputs cannot go to one file", text::printable(targets[i])),
                        "name another file for one of them");
  for (const std::string& target : targets) {
    std::error_code failure;
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
  return diagnostics.error_count() == errors;
}

}  // namespace millwright::app
