// SPDX-License-Identifier: Apache-2.0
#include "report/tolerance_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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

template <class... Values>
std::string filled(const Texts& t, std::string_view key, const Values&... values) {
  return fmt::format(fmt::runtime(t(key)), values...);
}

std::string figures_word(std::size_t count, const Texts& t) {
  return filled(t, count == 1 ? "tolerances.figure" : "tolerances.figures", count);
}

/// "x C-ST-RMS comes to 108 % of its limit".
std::string failure_text(const ToleranceBreak& each, const Texts& t) {
  const std::string use = each.utilisation < machine::useless_utilisation
                              ? filled(t, "tolerances.comes_to", fmt::format("{:.1f}", 100.0 * each.utilisation))
                              : t("tolerances.fails");
  return fmt::format("{} {} ({}) {}", each.axis, each.check, t.said(each.title), use);
}

std::string single_text(const TolerancedFigure& figure, const ToleranceBreak& each, const Texts& t) {
  const double worst = each.values.front().second;
  return filled(t,
                "tolerances.single",
                figure.part,
                fmt::format("{}", fmt::join(figure.places, ", ")),
                figure_text(figure),
                figure.estimate ? t("tolerances.estimate") : std::string(),
                value_text(figure, *each.from),
                deviation_text(figure, *each.from),
                value_text(figure, worst),
                failure_text(each, t));
}

std::string combination_text(const ToleranceCheck& check, const ToleranceBreak& each, const Texts& t) {
  std::string values;
  for (const auto& [index, value] : each.values)
    values += fmt::format("{}{} {} {}",
                          values.empty() ? "" : ", ",
                          check.figures[index].part,
                          name_of(check.figures[index]),
                          deviation_text(check.figures[index], value));
  return filled(t, "tolerances.together", values, failure_text(each, t));
}

std::string verdict_text(const ToleranceCheck& check, const Style& style, const Texts& t) {
  const std::string figures = figures_word(check.figures.size(), t);
  switch (check.verdict) {
    case ToleranceVerdict::none_stated:
      return t("tolerances.none");
    case ToleranceVerdict::compliant:
      return filled(t, "tolerances.compliant", style.good(t("tolerances.good")), figures);
    case ToleranceVerdict::broken:
      return check.single.empty()
                 ? filled(t, "tolerances.broken_together", style.bad(t("tolerances.bad")), figures)
                 : filled(t, "tolerances.broken", style.bad(t("tolerances.bad")), check.single.size(), figures);
    case ToleranceVerdict::unsettled:
      if (check.stopped) return filled(t, "tolerances.stopped", figures);
      return filled(t, "tolerances.unsettled", figures, check.boxes);
    case ToleranceVerdict::not_asked:
      break;
  }
  return t("tolerances.not_asked");
}

std::string robust_text(const MachineResult& result, const evaluation::Design& design, const Texts& t) {
  if (!result.robust) return {};
  const std::string& objective = result.objectives.front();
  std::string text = t(result.status == Status::optimal ? "tolerances.robust" : "tolerances.robust_open");
  if (result.robust_scenarios == 0) return text + ".";
  const double more = design.total(machine::objective_named(objective)) - result.robust_without;
  const bool equal = std::abs(more) <= 1e-5 * std::abs(result.robust_without);
  text += "; ";
  text += equal ? t("tolerances.robust_same")
                : filled(t,
                         more < 0.0 ? "tolerances.robust_less" : "tolerances.robust_costs",
                         objective_text(objective, std::abs(more), design.currency));
  return text + ". " +
         filled(
             t, result.robust_scenarios == 1 ? "tolerances.scenario" : "tolerances.scenarios", result.robust_scenarios);
}

}  // namespace

bool robust_to_something(const MachineResult& result) {
  if (!result.robust) return false;
  return std::any_of(result.designs.begin(), result.designs.end(), [](const evaluation::Design& design) {
    return design.tolerances && design.tolerances->verdict != ToleranceVerdict::none_stated;
  });
}

std::string robust_front_text(const MachineResult& result, const Texts& t) {
  if (!result.robust || result.designs.empty()) return {};
  if (!robust_to_something(result)) return t("tolerances.front_none");
  const auto unsettled = std::count_if(result.designs.begin(), result.designs.end(), [](const auto& design) {
    return design.tolerances && design.tolerances->verdict == ToleranceVerdict::unsettled;
  });
  std::string text = unsettled > 0 ? filled(t, "tolerances.front_open", unsettled) : t("tolerances.front");
  std::vector<std::size_t> stopped;
  for (std::size_t i = 0; i < result.designs.size(); ++i)
    if (result.designs[i].tolerances && result.designs[i].tolerances->stopped) stopped.push_back(i + 1);
  if (!stopped.empty())
    text += " " + filled(t, "tolerances.front_stopped", fmt::format("{}", fmt::join(stopped, ", ")));
  if (result.robust_scenarios > 0)
    text += " " + filled(t,
                         result.robust_scenarios == 1 ? "tolerances.scenario" : "tolerances.scenarios",
                         result.robust_scenarios);
  return text;
}

std::string figure_text(const TolerancedFigure& figure) {
  return fmt::format("{} {} ±{:.3g} %", name_of(figure), value_text(figure, figure.value), 100.0 * figure.share());
}

std::string tolerances_text(const MachineResult& result,
                            const evaluation::Design& design,
                            const Style& style,
                            const Texts& t) {
  if (!design.tolerances) return {};
  const ToleranceCheck& check = *design.tolerances;
  std::string out = style.heading(t("tolerances")) + "\n";
  const auto line = [&](const std::string& text, std::size_t indent = 2) {
    out += std::string(indent, ' ') + wrapped(text, style.width - indent, indent) + "\n";
  };
  std::string verdict = verdict_text(check, style, t);
  if (check.unstated > 0)
    verdict += " " + filled(t,
                            check.unstated == 1 ? "tolerances.unstated_one" : "tolerances.unstated",
                            figures_word(check.unstated, t));
  line(verdict);
  for (const ToleranceBreak& each : check.single)
    line(single_text(check.figures[each.values.front().first], each, t), 4);
  if (check.combination) line(combination_text(check, *check.combination, t), 4);
  if (check.verdict != ToleranceVerdict::none_stated)
    if (const std::string robust = robust_text(result, design, t); !robust.empty()) line(robust);
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
