// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/commands.h"
#include "app/output.h"
#include "report/calculation.h"
#include "report/json.h"
#include "text/nearest.h"

namespace millwright::app {

namespace {

std::string for_comparison(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(c));
  });
  return text;
}

/// "critical speed" finds critical_speed and CRITICAL-SPEED.
bool mentions(const mechanics::Formula& formula, const std::string& word) {
  for (const std::string* text : {&formula.name(), &formula.title(), &formula.handbook_id()})
    if (for_comparison(*text).find(word) != std::string::npos) return true;
  return false;
}

}  // namespace

int run_formulas(const Options& options) {
  text::Diagnostics diagnostics;
  std::vector<const mechanics::Formula*> chosen;
  for (const mechanics::Formula& formula : mechanics::formulas())
    if (mentions(formula, for_comparison(options.subject))) chosen.push_back(&formula);
  if (chosen.empty()) {
    std::vector<std::string> names;
    for (const mechanics::Formula& formula : mechanics::formulas()) {
      names.push_back(formula.name());
      names.push_back(formula.name().substr(formula.name().find('.') + 1));
      names.emplace_back(formula.element());
    }
    diagnostics.error("no formula has " + text::in_quotes(options.subject) + " in its name, title or handbook id",
                      text::did_you_mean(options.subject, names, "'millwright formulas' lists all"));
  }
  outputs_are_writable(options, diagnostics);
  print(diagnostics);
  if (diagnostics.has_errors()) return exit_bad_input;
  const report::Style style = output_style(options);
  std::string text;
  for (const mechanics::Formula* formula : chosen)
    text += report::formula_text(*formula, style) + (style.brief ? "" : "\n");
  if (!style.brief) text += fmt::format("{} formula{}\n", chosen.size(), chosen.size() == 1 ? "" : "s");
  return deliver(options, text, report::formulas_json(chosen)) ? exit_done : exit_bad_input;
}

}  // namespace millwright::app
