// SPDX-License-Identifier: Apache-2.0
#include "app/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/file_names.h"
#include "app/help.h"
#include "app/help_formatter.h"
#include "app/import_options.h"
#include "app/name_lists.h"
#include "app/objective_option.h"
#include "app/output.h"
#include "app/validators.h"
#include "report/page_texts.h"
#include "text/diagnostic.h"
#include "text/nearest.h"

namespace millwright::app {

namespace {

constexpr const char* shared_group = "Common options";

void common(CLI::Option* option, const char* type) { option->type_name(type)->group(shared_group); }

void add_output_options(CLI::App& verb, Options& options) {
  verb.add_option(
          "--json", options.json, "write the result as JSON to FILE; - : to standard output, nothing else there")
      ->type_name("FILE|-")
      ->group(shared_group);
  verb.add_flag("--force",
                options.force,
                "overwrite files that are there; without it only results are renewed (JSON, pages, locks)")
      ->group(shared_group);
  verb.add_flag("--quiet,-q", options.quiet, "the result only: no progress, no calculations, no remarks")
      ->group(shared_group);
}

void add_report_options(CLI::App& verb, Options& options) {
  CLI::Option* const report = verb.add_option("--report",
                                              options.report,
                                              "write a page that shows and explains the result: drawings, parts, every "
                                              "calculation; complete in one file, to read or print");
  report->type_name("FILE.html")->group(shared_group);
  common(verb.add_option("--language", options.language, "of the page: en, or id (Indonesian)")
             ->needs(report)
             ->check(CLI::IsMember(report::language_codes())),
         "CODE");
}

/// One value per occurrence: `--catalogue a b` must leave b alone.
void add_list_option(
    CLI::App& verb, const char* name, std::vector<std::string>& list, const char* type, const char* text) {
  verb.add_option(name, list, text)->type_name(type)->allow_extra_args(false)->group(shared_group);
}

void add_catalogue_option(CLI::App& verb, Options& options) {
  add_list_option(verb,
                  "--catalogue",
                  options.catalogues,
                  "DIR",
                  "parts of your own on top of the shipped ones, what is in stock, who sells what (repeatable)");
}

void add_lock_options(CLI::App& verb, Options& options) {
  common(
      verb.add_option("--write-lock",
                      options.write_lock,
                      "write the SHA-256 of every file that the result rests on, and prices and figures of its parts"),
      "FILE.lock");
  common(verb.add_option("--locked", options.locked, "stop, and say what changed, if such a file no longer holds"),
         "FILE.lock");
}

void add_machine_options(CLI::App& verb, Options& options, bool with_page = true) {
  verb.add_option("PROBLEM", options.problem, "problem file (.toml or .json)")->required();
  add_output_options(verb, options);
  if (with_page) add_report_options(verb, options);
  add_catalogue_option(verb, options);
  add_lock_options(verb, options);
  add_list_option(verb,
                  "--set",
                  options.settings,
                  "PATH=VALUE",
                  "change the problem, e.g. axis.x.stroke='800 mm' (repeatable); of 'solve' one may be a range, "
                  "'0.2:0.5:7 s': the best build at each of 7 values");
  add_list_option(
      verb,
      "--limit",
      options.limits,
      "NAME=VALUE",
      "what the whole machine may take at most: cost='400 USD', mass='12 kg', cycle_time='8 s', energy='150 J', "
      "position_error='0.2 mm' (repeatable)");
  add_list_option(verb, "--without", options.without, "PART", "a part that may not be used anywhere (repeatable)");
  common(verb.add_option("--threads", options.threads, "threads to search with; the answer does not depend on it")
             ->check(CLI::Range(1U, 1024U)),
         "N");
  common(verb.add_option("--time-limit", options.time_limit, "stop after so many seconds with the best build so far")
             ->check(positive),
         "S");
  common(
      verb.add_option("--memory-limit", options.memory_limit, "stop when so many GB are taken (80 % of all there is)")
          ->check(positive),
      "GB");
  common(
      verb.add_option("--gap", options.gap, "relative gap at which the proof counts as complete (1e-6; at least 1e-10)")
          ->check(share),
      "G");
}

void add_fix_option(CLI::App& verb, Options& options) {
  add_list_option(verb,
                  "--fix",
                  options.fixed,
                  "AXIS.SLOT=PART",
                  "decide a part or setting beforehand, e.g. x.motor=17HS4401S, x.acceleration_time='0.2 s', "
                  "machine.supply_voltage='24 V' (repeatable)");
}

void add_order_option(CLI::App& verb, Options& options) {
  verb.add_option("--order",
                  options.order,
                  "write what to buy: equal parts of all axes in one line, with totals, and a cutting list; "
                  "of a .csv the cutting list is FILE-cutting.csv")
      ->type_name("FILE.csv|.xlsx");
}

/// `cost,mass` in one word; what they are is looked at when the line has been read.
void add_objectives(CLI::App& verb, std::vector<std::string>& list, const std::string& text) {
  verb.add_option("--minimise,--minimize", list, text)->type_name("OBJECTIVE")->delimiter(',')->allow_extra_args(false);
}

struct VerbEntry {
  CLI::App* app;
  Verb verb;
};

class CommandLine {
 public:
  explicit CommandLine(Options& options) : options_(options) {
    app_.name("millwright");
    app_.formatter(std::make_shared<HelpFormatter>());
    app_.set_version_flag("--version", std::string("millwright ") + version);
    app_.require_subcommand(1);
    app_.footer(examples("millwright"));
    add_new();
    add_machine_verbs();
    add_explain();
    add_compare();
    add_other_verbs();
    add_catalogue_verbs();
    refuse_wrong_names(app_);
  }

  CLI::App& app() { return app_; }

  Verb verb() const {
    for (const VerbEntry& entry : verbs_)
      if (entry.app->parsed()) return entry.verb;
    return Verb::solve;
  }

  /// Names of the verbs, or of the options that this command line's verb has.
  std::vector<std::string> names(bool of_options) {
    std::vector<std::string> names;
    const CLI::App* deepest = &app_;
    while (!deepest->get_subcommands().empty()) deepest = deepest->get_subcommands().front();
    if (of_options) {
      for (const CLI::Option* option : deepest->get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    } else {
      for (const CLI::App* sub : deepest->get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(sub->get_name());
    }
    return names;
  }

 private:
  CLI::App& add(CLI::App& parent, const char* name, Verb verb, const char* text) {
    CLI::App& sub = *parent.add_subcommand(name, text);
    sub.footer(examples(name));
    verbs_.push_back({&sub, verb});
    return sub;
  }

  void add_new() {
    CLI::App& start = add(app_, "new", Verb::start, "a commented problem file to begin with");
    start.add_option("FILE", options_.problem, "file to write (.toml; - prints it)")->required();
    start.add_option("--template", options_.subject, fmt::format("the machine to begin with: {}", all_templates()))
        ->type_name("NAME");
    start.add_flag("--force", options_.force, "overwrite the file if it is there");
  }

  void add_full_flag(CLI::App& verb) {
    verb.add_flag("--full", options_.full, "print every check, all requirements and assumptions too");
  }

  void add_machine_verbs() {
    CLI::App& solve =
        add(app_, "solve", Verb::solve, "the cheapest (lightest, fastest, ...) compliant build, with proof");
    add_machine_options(solve, options_);
    add_fix_option(solve, options_);
    add_objectives(solve,
                   options_.objectives,
                   fmt::format("{}, or a weighted sum (default: as the problem says)", all_quantities()));
    solve.add_option("--bom", options_.bom, "write the build as a bill of materials, which 'check' reads")
        ->type_name("FILE.csv");
    add_order_option(solve, options_);
    add_full_flag(solve);
    solve.add_option("--csv", options_.csv, "with --set over a range: write the table")->type_name("FILE.csv");
    solve
        .add_option(
            "--alternatives", options_.builds, "the best K builds, not only the best one (1 to 100); by cost or mass")
        ->type_name("K")
        ->check(CLI::Range(1U, 100U));
    solve.add_flag(
        "--robust", options_.robust, "compliant for every value within the tolerances that the catalogues state");
    CLI::App& pareto = add(app_,
                           "pareto",
                           Verb::pareto,
                           "all builds that no other build beats in cost and mass (or whatever is minimised)");
    add_machine_options(pareto, options_);
    add_fix_option(pareto, options_);
    add_objectives(
        pareto, options_.objectives, fmt::format("two or three of {} (default: cost,mass)", all_quantities()));
    pareto
        .add_option("--front-tolerance",
                    options_.front_tolerance,
                    "where free dimensions move the front: relative, by how much a build may beat it (0.001)")
        ->type_name("F")
        ->check(share);
    pareto.add_flag("--robust",
                    options_.robust,
                    "the front of builds that are compliant for every value within the tolerances that the catalogues "
                    "state");
    CLI::App& check = add(app_, "check", Verb::check, "does what I plan to buy work?");
    add_machine_options(check, options_);
    check.add_option("BOM", options_.bom, "bill of materials (.csv)")->required();
    add_order_option(check, options_);
    check.add_flag("--robust",
                   options_.robust,
                   "exit code 1 unless compliant for every value within the tolerances that the catalogues state");
    add_full_flag(check);
    check.add_flag("--complete", options_.complete, "choose what the bill of materials leaves open");
    check.add_option("--hold-origin", options_.hold_origin, "hold only the lines of this origin, choose the rest")
        ->type_name("ORIGIN");
  }

  void add_explain() {
    CLI::App& explain = add(app_,
                            "explain",
                            Verb::explain,
                            "why nothing is compliant and what would help; or what is forced and what each thing "
                            "that is asked costs");
    add_machine_options(explain, options_, false);
    add_fix_option(explain, options_);
    add_objectives(explain, options_.objectives, "by which builds are best (default: as the problem says)");
  }

  void add_compare() {
    CLI::App& compare = add(app_, "compare", Verb::compare, "two builds side by side: totals, parts, checks");
    compare.add_option("A", options_.first, "a result that --json wrote, or a bill of materials (.csv)")->required();
    compare.add_option("B", options_.second, "the same")->required();
    compare
        .add_option("--problem",
                    options_.problem,
                    "problem file that bills of materials are judged by (default: the one that a result names)")
        ->type_name("FILE");
    compare.add_flag("--complete", options_.complete, "choose what a bill of materials leaves open");
    add_output_options(compare, options_);
    add_catalogue_option(compare, options_);
    add_lock_options(compare, options_);
    add_list_option(compare,
                    "--set",
                    options_.settings,
                    "PATH=VALUE",
                    "change the problem that bills of materials are judged by (repeatable)");
  }

  void add_other_verbs() {
    CLI::App& audit =
        add(app_, "audit", Verb::audit, "printed results of a published calculation against recomputed ones");
    audit.add_option("CLAIMS", options_.subject, "claims file (.toml or .json)")->required();
    audit.add_flag("--derive", options_.derive, "show each calculation");
    add_output_options(audit, options_);
    add_report_options(audit, options_);
    CLI::App& calc = add(app_, "calc", Verb::calc, "one formula, with its derivation");
    calc.add_option("FORMULA", options_.subject, "name or handbook id, see 'millwright formulas'")->required();
    calc.add_option("ARGUMENTS", options_.words, "name=value with unit, e.g. force='6.4 kN' loads='100 N,80 N'");
    calc.add_option("--unit", options_.unit, "unit of the result")->type_name("UNIT");
    calc.add_flag("--derive", options_.derive, "show the derivation (it always is)");
    add_output_options(calc, options_);
    CLI::App& formulas = add(app_, "formulas", Verb::formulas, "the formulas: arguments, units, validity, source");
    formulas.add_option("WORD", options_.subject, "only those with this word in name, title or handbook id");
    add_output_options(formulas, options_);
    add(app_, "reference", Verb::reference, "every key of the problem file: units, defaults, sources (Markdown)");
    add(app_, "schema", Verb::schema, "the same for editors: a JSON Schema of the problem file");
  }

  void add_catalogue_verbs() {
    CLI::App& catalogue = *app_.add_subcommand("catalogue", "what can be bought");
    catalogue.require_subcommand(1);
    catalogue.footer(examples("catalogue"));
    CLI::App& list = add(catalogue, "list", Verb::catalogue_list, "the part families, or the parts of one");
    list.add_option("FAMILY", options_.subject, "e.g. steppers");
    list.add_flag("--gaps", options_.gaps, "what is missing: usual sizes that no row has, parts without a partner");
    CLI::App& show = add(catalogue, "show", Verb::catalogue_show, "all that is known about a part");
    show.add_option("PART", options_.words, "part number")->required();
    show.add_option("--manufacturer", options_.manufacturer, "its maker")->type_name("NAME");
    CLI::App& lint = add(catalogue, "lint", Verb::catalogue_lint, "is this catalogue file sane?");
    lint.add_option("FILES", options_.words, "catalogue files or folders")->required();
    lint.add_option("--family", options_.subject, "their family, where neither folder nor header tells")
        ->type_name("FAMILY");
    add_import_options(add(catalogue, "import", Verb::catalogue_import, "a maker's or shop's table as ours"), options_);
    CLI::App& diff = add(catalogue, "diff", Verb::catalogue_diff, "what changed between two catalogues");
    diff.add_option("A", options_.first, "catalogue folder or file; without B, what goes on top of the shipped parts")
        ->required();
    diff.add_option("B", options_.second, "the same, newer");
    diff.add_option("--family", options_.subject, "only this one")->type_name("FAMILY");
    for (CLI::App* sub : {&list, &show, &lint, &diff}) {
      add_output_options(*sub, options_);
      if (sub != &lint) add_catalogue_option(*sub, options_);
    }
  }

  Options& options_;
  CLI::App app_{"Designs the drives of machines, exactly and with the calculation shown."};
  std::vector<VerbEntry> verbs_;
};

/// The first word, past options, that is not a verb where one has to stand.
std::optional<std::string> misspelt_verb(CommandLine& line, int argc, char** argv) {
  const std::vector<std::string> verbs = line.names(false);
  if (argc < 2) {
    complain("a command is missing",
             fmt::format("commands: {}; 'millwright --help' explains them", fmt::join(verbs, ", ")));
    return "";
  }
  if (argv[1][0] == '-') return std::nullopt;
  const std::string first = argv[1];
  if (std::find(verbs.begin(), verbs.end(), first) == verbs.end()) {
    complain("there is no command " + text::in_quotes(first),
             text::did_you_mean(first, verbs, fmt::format("commands: {}", fmt::join(verbs, ", "))));
    return first;
  }
  if (first != "catalogue" || argc < 3 || argv[2][0] == '-') return std::nullopt;
  const std::vector<std::string> inner{"list", "show", "lint", "diff", "import"};
  if (std::find(inner.begin(), inner.end(), argv[2]) != inner.end()) return std::nullopt;
  complain("there is no command 'catalogue " + text::printable(argv[2]) + "'",
           text::did_you_mean(argv[2], inner, "commands: catalogue list, show, lint, diff, import"));
  return first;
}

std::string first_unknown_option(int argc, char** argv, const std::vector<std::string>& known) {
  for (int i = 1; i < argc; ++i) {
    const std::string word(argv[i], std::min(std::string_view(argv[i]).find('='), std::string_view(argv[i]).size()));
    if (word.rfind("--", 0) == 0 && std::find(known.begin(), known.end(), word) == known.end()) return word;
  }
  return {};
}

void complain_of(const CLI::ParseError& error, CommandLine& line, int argc, char** argv) {
  const std::vector<std::string> known = line.names(true);
  const std::string unknown = first_unknown_option(argc, argv, known);
  if (unknown.empty()) {
    complain(text::printable(error.what()), "'millwright --help' and 'millwright COMMAND --help' show what there is");
  } else {
    complain("there is no option " + text::in_quotes(unknown),
             text::did_you_mean(unknown, known, fmt::format("options: {}", fmt::join(known, ", "))));
  }
}

}  // namespace

std::optional<Options> parse_command_line(int argc, char** argv, int& exit_code) {
  Options options;
  CommandLine line(options);
  exit_code = exit_bad_input;
  if (misspelt_verb(line, argc, argv)) return std::nullopt;
  try {
    line.app().parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    exit_code = line.app().exit(success);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    complain_of(error, line, argc, argv);
    return std::nullopt;
  }
  options.verb = line.verb();
  if (!settle_objectives(options)) return std::nullopt;
  exit_code = exit_done;
  return options;
}

}  // namespace millwright::app
