// SPDX-License-Identifier: Apache-2.0
#include "report/tolerance_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "catalogue/column_unit.h"
#include "report/design_text.h"
#include "report/machine_text.h"

namespace millwright::report {

using evaluation::ToleranceBreak;
using evaluation::ToleranceCheck;
using evaluation::TolerancedFigure;
using evaluation::ToleranceVerdict;

namespace {

std::string value_text(const TolerancedFigure& figure, double value) {
  return scalar::format(value, catalogue::display_unit(figure.column));
}

std::string deviation_text(const TolerancedFigure& figure, double value) {
  return fmt::format("{:+.3g} %", 100.0 * (value - figure.value) / std::abs(figure.value));
}

std::string_view name_of(const TolerancedFigure& figure) { return catalogue::declaration(figure.column).name; }

std::string figures_word(std::size_t count) { return fmt::format("{} figure{}", count, count == 1 ? "" : "s"); }

/// "x C-ST-RMS comes to 108 % of its limit".
std::string failure_text(const ToleranceBreak& each) {
  const std::string use = each.utilisation < machine::useless_utilisation
                              ? fmt::format("comes to {:.1f} % of its limit", 100.0 * each.utilisation)
                              : "fails";
  return fmt::format("{} {} ({}) {}", each.axis, each.check, each.title, use);
}

std::string single_text(const TolerancedFigure& figure, const ToleranceBreak& each) {
  const double worst = each.values.front().second;
  return fmt::format("{} ({}) {}{}: compliant up to about {} ({}); at {} {}",
                     figure.part,
                     fmt::join(figure.places, ", "),
                     figure_text(figure),
                     figure.estimate ? ", an estimate" : "",
                     value_text(figure, *each.from),
                     deviation_text(figure, *each.from),
                     value_text(figure, worst),
                     failure_text(each));
}

std::string combination_text(const ToleranceCheck& check, const ToleranceBreak& each) {
  std::string values;
  for (const auto& [index, value] : each.values)
    values += fmt::format("{}{} {} {}",
                          values.empty() ? "" : ", ",
                          check.figures[index].part,
                          name_of(check.figures[index]),
                          deviation_text(check.figures[index], value));
  return fmt::format("together {}: {}", values, failure_text(each));
}

std::string verdict_text(const ToleranceCheck& check, const Style& style) {
  const std::string figures = figures_word(check.figures.size());
  switch (check.verdict) {
    case ToleranceVerdict::none_stated:
      return "No figure of the chosen parts states a tolerance.";
    case ToleranceVerdict::compliant:
      return fmt::format("{} for every value within the stated tolerances of {}, proved with intervals.",
                         style.good("Compliant"),
                         figures);
    case ToleranceVerdict::broken:
      return check.single.empty()
                 ? fmt::format("{} for every value within the stated tolerances of {}; no single one breaks it.",
                               style.bad("Not compliant"),
                               figures)
                 : fmt::format("{} for every value within the stated tolerances: {} of {} can break it alone.",
                               style.bad("Not compliant"),
                               check.single.size(),
                               figures);
    case ToleranceVerdict::unsettled:
      return fmt::format(
          "Not settled whether it is compliant for every value within the stated tolerances of {}: "
          "neither proved nor refuted in {} pieces.",
          figures,
          check.boxes);
    case ToleranceVerdict::not_asked:
      break;
  }
  return "Not asked: it fails with the figures as they stand.";
}

std::string robust_text(const MachineResult& result, const evaluation::Design& design) {
  if (!result.robust) return {};
  const std::string& objective = result.objectives.front();
  std::string text = result.status == Status::optimal
                         ? "No build that is compliant for every value within the stated tolerances is better"
                         : "Whether a better build is compliant for every value within the stated tolerances is open";
  if (result.robust_scenarios == 0) return text + ".";
  const double more = design.total(machine::objective_named(objective)) - result.robust_without;
  const bool equal = std::abs(more) <= 1e-5 * std::abs(result.robust_without);
  text += equal ? "; with the figures as they stand none is better either"
                : fmt::format("; with the figures as they stand the best is {} better",
                              objective_text(objective, more, design.currency));
  return text + fmt::format(
                    ". {} set{} of values {} asked of every part on the way; ramps, dimensions and settings are "
                    "the same for all values.",
                    result.robust_scenarios,
                    result.robust_scenarios == 1 ? "" : "s",
                    result.robust_scenarios == 1 ? "was" : "were");
}

}  // namespace

std::string figure_text(const TolerancedFigure& figure) {
  return fmt::format("{} {} ±{:.3g} %", name_of(figure), value_text(figure, figure.value), 100.0 * figure.share());
}

std::string tolerances_text(const MachineResult& result, const evaluation::Design& design, const Style& style) {
  if (!design.tolerances) return {};
  const ToleranceCheck& check = *design.tolerances;
  std::string out = style.heading("Tolerances") + "\n";
  const auto line = [&](const std::string& text, std::size_t indent = 2) {
    out += std::string(indent, ' ') + wrapped(text, style.width - indent, indent) + "\n";
  };
  std::string verdict = verdict_text(check, style);
  if (check.unstated > 0)
    verdict += fmt::format(" No tolerance is stated for {} that {} estimated: taken as {}.",
                           figures_word(check.unstated),
                           check.unstated == 1 ? "is" : "are",
                           check.unstated == 1 ? "it stands" : "they stand");
  line(verdict);
  for (const ToleranceBreak& each : check.single) line(single_text(check.figures[each.values.front().first], each), 4);
  if (check.combination) line(combination_text(check, *check.combination), 4);
  if (const std::string robust = robust_text(result, design); !robust.empty()) line(robust);
  return out + "\n";
}

std::string tolerance_choices_text(const MachineResult& result,
                                   const evaluation::Explanation& explanation,
                                   const Style& style) {
  if (!explanation.design) return {};
  std::string out = tolerances_text(result, *explanation.design, style);
  if (explanation.ends.empty() && explanation.ends_not_tried == 0) return out;
  const auto& figures = explanation.design->tolerances->figures;
  const auto line = [&](const std::string& text) { out += "  " + wrapped(text, style.width - 2, 4) + "\n"; };
  std::size_t same = 0;
  out += style.heading("What would be chosen if an estimated figure were at an end of its tolerance") + "\n";
  for (const evaluation::FigureEnd& end : explanation.ends) {
    const TolerancedFigure& figure = figures[end.figure];
    const std::string what = fmt::format("{} {} {} ({}):",
                                         figure.part,
                                         name_of(figure),
                                         value_text(figure, end.value),
                                         deviation_text(figure, end.value));
    if (end.outcome == evaluation::FigureEnd::Outcome::same)
      ++same;
    else if (end.outcome == evaluation::FigureEnd::Outcome::nothing)
      line(what + " nothing would be compliant");
    else
      line(fmt::format("{} {} ({:+.4g} {})",
                       what,
                       fmt::join(end.changes, ", "),
                       end.worse,
                       objective_unit(explanation.objective, result.currency)));
  }
  if (same > 0)
    line(fmt::format("At {} end{} of tolerances the same parts would be chosen.", same, same == 1 ? "" : "s"));
  if (explanation.ends_not_tried > 0)
    line(fmt::format("{} ends took too long or were not tried.", explanation.ends_not_tried));
  return out + "\n";
}

}  // namespace millwright::report
