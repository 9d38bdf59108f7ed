// SPDX-License-Identifier: Apache-2.0
#include "app/objective_option.h"

#include <fmt/format.h>

#include <cstdio>
#include <set>

#include "app/output.h"
#include "machine/objective.h"
#include "text/diagnostic.h"

namespace millwright::app {

void complain(const std::string& message, const std::string& hint) {
  fmt::print(stderr, "millwright: error: {}\n", message);
  if (!hint.empty()) fmt::print(stderr, "  hint: {}\n", hint);
}

bool settle_objectives(Options& options) {
  text::Diagnostics diagnostics;
  for (std::string& objective : options.objectives) {
    constexpr std::string_view option = "--minimise ";
    machine::ObjectiveFault fault;
    if (const auto read = machine::parse_objective(objective, fault)) {
      objective = read->name();
      continue;
    }
    const auto typed = text::SourceText::from_string("command line", std::string(option) + objective);
    diagnostics.error(text::span_at(typed, option.size() + fault.offset, fault.length), fault.message, fault.hint);
  }
  if (diagnostics.has_errors()) {
    print(diagnostics);
    return false;
  }
  if ((options.verb == Verb::solve || options.verb == Verb::explain) && options.objectives.size() > 1) {
    complain(fmt::format("{} minimises one objective", options.verb == Verb::solve ? "solve" : "explain"),
             "'millwright pareto' gives the front of two");
    return false;
  }
  if (options.verb != Verb::pareto) return true;
  if (options.objectives.empty()) options.objectives = {"cost", "mass"};
  for (const std::string& objective : options.objectives)
    if (!machine::objective_named(objective).single()) {
      complain("a front is of plain quantities, and " + text::in_quotes(objective) + " is a weighted sum",
               "'millwright solve' minimises weighted sums");
      return false;
    }
  const std::set<std::string> different(options.objectives.begin(), options.objectives.end());
  if (different.size() < 2 || different.size() > 3 || different.size() < options.objectives.size()) {
    complain("a front has two or three different objectives", "write --minimise cost,mass");
    return false;
  }
  return true;
}

}  // namespace millwright::app
