// SPDX-License-Identifier: Apache-2.0
// The command line as plain data.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace millwright::app {

enum class Verb {
  solve,
  pareto,
  check,
  compare,
  explain,
  audit,
  calc,
  formulas,
  start,
  reference,
  schema,
  catalogue_list,
  catalogue_show,
  catalogue_lint,
  catalogue_diff,
  catalogue_import
};

/// Exit codes of the program.
enum ExitCode : int {
  exit_done = 0,       ///< done and compliant
  exit_failed = 1,     ///< no compliant design, or a check failed; catalogues that differ
  exit_bad_input = 2,  ///< everything wrong has been reported
  exit_limit = 3,      ///< a limit was reached before the proof was complete
  exit_bug = 70        ///< our own mistake
};

/// Of `catalogue import`.
struct ImportOptions {
  std::string file;
  std::string output;
  std::string mapping;
  std::string save_mapping;
  std::vector<std::string> constants;  ///< column=value
  std::vector<std::string> units;      ///< column=unit
  std::string decimal, sheet, encoding, separator;
  bool yes = false;
};

struct Options {
  Verb verb = Verb::solve;
  // every verb
  std::string json;             ///< file to write, "-" for standard output, empty for none
  std::string report;           ///< page to write, empty for none
  std::string language = "en";  ///< of the page
  bool quiet = false;
  bool full = false;                    ///< of solve: every check, requirement and assumption
  std::vector<std::string> catalogues;  ///< overlay folders
  // machines
  std::string problem;
  std::vector<std::string> settings;    ///< path=value
  std::vector<std::string> limits;      ///< cost=value, mass=value
  std::vector<std::string> without;     ///< parts that may not be used
  std::vector<std::string> fixed;       ///< axis.slot=part or value
  std::vector<std::string> objectives;  ///< by name, see machine/objective.h; empty = the problem file's
  unsigned builds = 1;                  ///< of solve: the best, the second best, ...
  double gap = 1e-6;
  double front_tolerance = 1e-3;
  double time_limit = std::numeric_limits<double>::infinity();  ///< s
  double memory_limit = 0.0;                                    ///< GB, 0 = most of what there is
  unsigned threads = 0;                                         ///< 0 = one per core
  std::string bom;                                              ///< written by solve, read by check
  std::string csv;                                              ///< table of a range, empty for none
  std::string order;                                            ///< list of what to buy, .csv or .xlsx; empty for none
  std::string write_lock;                                       ///< file to write, empty for none
  std::string locked;                                           ///< lock that has to hold, empty for none
  bool complete = false;
  std::string hold_origin;
  bool robust = false;        ///< of solve and check: for every value within the stated tolerances
  bool force = false;         ///< overwrite files that are there
  std::string first, second;  ///< of compare: results or bills of materials; of catalogue diff: catalogues
  // audit, calc, formulas, catalogue
  std::string subject;             ///< claims file, formula, word, family or template
  std::vector<std::string> words;  ///< arguments, parts or files
  bool derive = false;
  bool gaps = false;  ///< of catalogue list: what is missing
  std::string unit;
  std::string manufacturer;
  ImportOptions import;
};

/// What the command line asks for; or nothing and the exit code, after help, the version or complaints were printed.
std::optional<Options> parse_command_line(int argc, char** argv, int& exit_code);

}  // namespace millwright::app
