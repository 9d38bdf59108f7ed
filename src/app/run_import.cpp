// SPDX-License-Identifier: Apache-2.0
// catalogue import: somebody's table becomes a file of ours, after it was shown how it is read.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/commands.h"
#include "app/output.h"
#include "app/output_target.h"
#include "catalogue/file_names.h"
#include "catalogue/import_mapping_file.h"
#include "catalogue/import_write.h"
#include "report/import_text.h"

namespace millwright::app {

namespace {

using catalogue::ImportMapping;
using catalogue::ImportRequest;

/// `name=value` of an option; reports if there is no name.
template <class Add>
void add_assignments(const char* option,
                     const std::vector<std::string>& words,
                     ImportRequest& request,
                     text::Diagnostics& diagnostics,
                     const Add& add) {
  for (const std::string& word : words) {
    const auto typed = text::SourceText::from_string("command line", std::string(option) + " " + word);
    const std::size_t begin = std::string_view(option).size() + 1;
    const text::SourceSpan where = text::span_at(typed, begin, word.size());
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      diagnostics.error(
          where, "a column, '=' and a value are wanted", std::string("for example ") + option + " mass=kg");
    else
      add(request,
          std::string_view(word).substr(0, equals),
          std::string_view(word).substr(equals + 1),
          where,
          diagnostics);
  }
}

ImportRequest request_of(const Options& options, text::Diagnostics& diagnostics) {
  const ImportOptions& said = options.import;
  ImportRequest request;
  if (!options.subject.empty()) {
    const auto typed = text::SourceText::from_string("command line", "--family " + options.subject);
    request.family =
        catalogue::family_named(options.subject, text::span_at(typed, 9, options.subject.size()), diagnostics);
  }
  request.format.sheet = said.sheet;
  request.format.encoding = said.encoding;
  request.format.separator = said.separator == "tab"         ? '\t'
                             : said.separator == "semicolon" ? ';'
                             : said.separator == "comma"     ? ','
                                                             : '\0';
  if (!said.decimal.empty())
    request.choices.mark = said.decimal == "comma" ? catalogue::DecimalMark::comma : catalogue::DecimalMark::point;
  // What the command line says goes before the file; but only the file may know the family.
  ImportRequest from_file = request;
  if (!said.mapping.empty()) catalogue::read_mapping(said.mapping, from_file, diagnostics);
  if (!request.family) request.family = from_file.family;
  if (!request.family) {
    if (!diagnostics.has_errors())
      diagnostics.error("which parts are these?",
                        "say --family steppers; 'millwright catalogue list' shows the families");
    return request;
  }
  add_assignments("--constant", said.constants, request, diagnostics, catalogue::add_constant);
  add_assignments("--unit", said.units, request, diagnostics, catalogue::add_unit);
  if (!said.mapping.empty() && !diagnostics.has_errors()) catalogue::read_mapping(said.mapping, request, diagnostics);
  request.choices.family = *request.family;
  return request;
}

bool ask(const std::string& question) {
  fmt::print("{} [y/N] ", question);
  std::fflush(stdout);
  const int first = std::getchar();
  for (int c = first; c != '\n' && c != EOF;) c = std::getchar();
  return first == 'y' || first == 'Y';
}

/// Units that nobody said, with the options that would say them.
void report_assumed(const ImportMapping& mapping, text::Diagnostics& diagnostics) {
  for (const catalogue::SourceColumn* column : catalogue::assumed_units(mapping)) {
    const std::string_view name = catalogue::declaration(*column->target).name;
    diagnostics.error(column->span,
                      fmt::format("nothing says the unit of {}", name),
                      fmt::format("say --unit {}={}, if that is its unit", name, column->unit));
  }
}

/// A unit of a column that the table does not have may be a mistake, or meant for other price lists.
void report_idle_units(const ImportRequest& request, const ImportMapping& mapping, text::Diagnostics& diagnostics) {
  for (const catalogue::GivenColumn& given : request.choices.columns) {
    const auto is_of = [&](const catalogue::SourceColumn& column) { return column.target == given.target; };
    if (!given.from.empty() || std::any_of(mapping.columns.begin(), mapping.columns.end(), is_of)) continue;
    diagnostics.warning(given.where,
                        fmt::format("no column of the table is read as {}", catalogue::declaration(given.target).name),
                        "this unit changes nothing");
  }
}

/// A file that no catalogue folder would be read with is not what is wanted.
void check_name(const std::string& output, text::Diagnostics& diagnostics) {
  if (output.empty() || catalogue::is_csv_name(output)) return;
  diagnostics.error(fmt::format("--output {}: a catalogue file ends in .csv", text::printable(output)),
                    "for example --output my-parts/steppers/motors.csv");
}

enum class Consent { given, asked_for, none };

Consent consent_of(const Options& options) {
  if (options.import.yes || !options.import.mapping.empty()) return Consent::given;
  if (options.json == "-") return Consent::none;  // nobody is asked where a program listens
  return isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0 ? Consent::asked_for : Consent::none;
}

class Import {
 public:
  explicit Import(const Options& options) : options_(options), said_(options.import) {}

  int run() {
    outcome_.file = said_.file;
    const int code = import();
    if (mapping_) outcome_.mapping = &*mapping_;
    if (options_.json.empty() || !json_is_writable_) return code;
    const std::string json = report::import_json(outcome_, diagnostics_);
    if (only_json()) {
      std::fwrite(json.data(), 1, json.size(), stdout);
      return std::fflush(stdout) == 0 ? code : exit_bad_input;
    }
    text::Diagnostics failures;
    const bool written = write_target({options_.json, OutputKind::json, options_.force}, json, failures);
    print(failures);
    return written ? code : exit_bad_input;
  }

 private:
  [[nodiscard]] bool only_json() const { return options_.json == "-"; }

  /// Of the outputs that are given, no two may be one file.
  void check_targets() {
    const std::vector<std::string> sources = {said_.file, said_.mapping};
    for (const std::string& file : {said_.output, said_.save_mapping})
      if (!file.empty()) check_target(target(file), sources, diagnostics_);
    if (is_same_file(said_.output, said_.save_mapping))
      diagnostics_.error("--output and --save-mapping cannot be one file");
    if (options_.json.empty() || only_json()) return;
    json_is_writable_ = check_target({options_.json, OutputKind::json, options_.force}, sources, diagnostics_);
    for (const std::string& file : {said_.output, said_.save_mapping})
      if (is_same_file(options_.json, file)) {
        diagnostics_.error("--json cannot be one file with --output or --save-mapping");
        json_is_writable_ = false;
      }
  }

  int import() {
    request_ = request_of(options_, diagnostics_);
    check_name(said_.output, diagnostics_);
    check_targets();
    if (diagnostics_.has_errors()) return stop();
    const auto sheet = catalogue::load_sheet(said_.file, request_.format, diagnostics_);
    if (!sheet) return stop();
    mapping_ = catalogue::propose_mapping(*sheet, request_.choices, diagnostics_);
    if (!mapping_) return stop();
    report_idle_units(request_, *mapping_, diagnostics_);
    show(report::import_text(*mapping_, output_style(options_)));
    const Consent consent = said_.output.empty() ? Consent::none : consent_of(options_);
    if (consent == Consent::given) report_assumed(*mapping_, diagnostics_);
    if (diagnostics_.has_errors()) {
      print(diagnostics_);
      return fail(*mapping_);
    }
    return write(*sheet, *mapping_, consent);
  }

  OutputTarget target(const std::string& file) const { return {file, OutputKind::edited, options_.force}; }

  int stop() {
    print(diagnostics_);
    return exit_bad_input;
  }

  /// After errors, which are printed: nothing is left behind, unless the mapping is all that was asked for.
  int fail(const ImportMapping& mapping) {
    if (said_.output.empty())
      (void)save(mapping, false);
    else if (!said_.save_mapping.empty() && !options_.quiet)
      fmt::print(stderr,
                 "{} was not written either; without --output it is, to be edited.\n",
                 text::printable(said_.save_mapping));
    return exit_bad_input;
  }

  void show(const std::string& text) const {
    if (options_.quiet || only_json()) return;
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
  }

  bool save(const ImportMapping& mapping, bool confirmed) {
    if (said_.save_mapping.empty()) return true;
    text::Diagnostics failures;
    const bool saved =
        write_target(target(said_.save_mapping), catalogue::mapping_text(mapping, request_, confirmed), failures);
    print(failures);
    if (saved) show(fmt::format("{}: mapping written.\n", text::printable(said_.save_mapping)));
    return saved;
  }

  int write(const catalogue::ImportSheet& sheet, const ImportMapping& mapping, Consent consent) {
    std::unique_ptr<text::OutputFile> file;
    if (consent != Consent::none) file = open_target(target(said_.output), diagnostics_);
    if (consent != Consent::none && !file) return stop();
    bool written = true;
    const auto summary = catalogue::write_import(
        sheet, mapping, [&](std::string_view lines) { return written = !file || file->append(lines); }, diagnostics_);
    print(diagnostics_);
    if (diagnostics_.has_errors() || !written) {
      if (!options_.quiet) fmt::print(stderr, "Nothing was written: mend the table, or change how it is read.\n");
      return fail(mapping);
    }
    if (consent == Consent::asked_for) {
      const std::size_t assumed = catalogue::assumed_units(mapping).size();
      const std::string shown = text::printable(said_.output);
      const std::string doubt = assumed == 0 ? "" : fmt::format(" ({} units are assumed)", assumed);
      if (!ask(fmt::format("Write {} rows to {}{}?", summary.rows, shown, doubt))) consent = Consent::none;
    }
    if (consent == Consent::none) {
      if (!save(mapping, false)) return exit_bad_input;
      fmt::print(stderr,
                 "Nothing was written{}.\n",
                 said_.output.empty() ? ": say --output FILE.csv, and --yes if it is read as it should be"
                                      : ": not confirmed; say --yes if it is read as it should be");
      return exit_failed;
    }
    if (!file->commit()) return stop();
    outcome_.written = said_.output;
    outcome_.rows_written = summary.rows;
    outcome_.lines_left_out = summary.left_out;
    if (!save(mapping, true)) return exit_bad_input;
    const auto lines_of = [](std::size_t count, std::string_view word) {
      return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
    };
    show(fmt::format("{}: {} written{}.\n",
                     text::printable(said_.output),
                     lines_of(summary.rows, "row"),
                     summary.left_out == 0 ? "" : ", " + lines_of(summary.left_out, "line") + " left out"));
    return exit_done;
  }

  const Options& options_;
  const ImportOptions& said_;
  text::Diagnostics diagnostics_;
  ImportRequest request_;
  std::optional<ImportMapping> mapping_;
  report::ImportOutcome outcome_;
  bool json_is_writable_ = true;
};

}  // namespace

int run_import(const Options& options) { return Import(options).run(); }

}  // namespace millwright::app
