// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <new>

#include "app/commands.h"
#include "evaluation/refusal.h"

namespace {

using namespace millwright::app;

int run(const Options& options) {
  switch (options.verb) {
    case Verb::solve:
      return has_range(options) ? run_sweep(options) : run_search(options);
    case Verb::pareto:
      return run_search(options);
    case Verb::check:
      return run_check(options);
    case Verb::compare:
      return run_compare(options);
    case Verb::explain:
      return run_explain(options);
    case Verb::audit:
      return run_audit(options);
    case Verb::calc:
      return run_calc(options);
    case Verb::formulas:
      return run_formulas(options);
    case Verb::start:
      return run_new(options);
    case Verb::reference:
    case Verb::schema:
      return run_reference(options);
    case Verb::catalogue_list:
    case Verb::catalogue_show:
    case Verb::catalogue_lint:
    case Verb::catalogue_diff:
      return run_catalogue(options);
    case Verb::catalogue_import:
      return run_import(options);
  }
  return exit_bug;
}

}  // namespace

int main(int argc, char** argv) try {
  int exit_code = exit_done;
  const auto options = parse_command_line(argc, argv, exit_code);
  return options ? run(*options) : exit_code;
} catch (const std::bad_alloc&) {
  std::fputs("millwright: error: not enough memory\n", stderr);
  return exit_bug;
} catch (const millwright::evaluation::Refusal& refusal) {
  std::fprintf(stderr, "millwright: error: %s\n  hint: %s\n", refusal.what(), refusal.hint().c_str());
  return exit_bad_input;
} catch (const std::exception& problem) {
  std::fprintf(stderr,
               "millwright: this is a mistake of the program, not of your input: %s\n"
               "Please report it with the command and the files.\n",
               problem.what());
  return exit_bug;
} catch (...) {
  std::fputs("millwright: this is a mistake of the program, not of your input. Please report it.\n", stderr);
  return exit_bug;
}
