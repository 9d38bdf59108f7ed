// SPDX-License-Identifier: Apache-2.0
//
// "tolerances": verdict (none_stated, compliant, broken, unsettled, not_asked), the figures with a stated tolerance,
// and what breaks the build; values in the figure's unit.
#include "report/tolerance_json.h"

#include "catalogue/column_unit.h"

namespace millwright::report {

using evaluation::ToleranceBreak;
using evaluation::ToleranceCheck;
using evaluation::TolerancedFigure;

namespace {

double shown(const TolerancedFigure& figure, double si) { return catalogue::display_unit(figure.column).from_si(si); }

Json figure_of(const TolerancedFigure& figure) {
  return Json{{"family", catalogue::declaration(figure.family).name},
              {"part", figure.part},
              {"places", figure.places},
              {"column", catalogue::declaration(figure.column).name},
              {"unit", catalogue::declaration(figure.column).unit},
              {"value", number(shown(figure, figure.value))},
              {"half_width", number(shown(figure, figure.half_width))},
              {"tolerance", number(figure.share())},
              {"estimate", figure.estimate},
              {"basis", figure.basis}};
}

Json break_of(const ToleranceBreak& each, const std::vector<TolerancedFigure>& figures) {
  Json values = Json::array();
  for (const auto& [figure, value] : each.values)
    values.push_back({{"figure", figure}, {"value", number(shown(figures[figure], value))}});
  return Json{{"values", values},
              {"from", each.from ? number(shown(figures[each.values.front().first], *each.from)) : Json()},
              {"axis", each.axis},
              {"check", each.check},
              {"utilisation", number(each.utilisation)}};
}

const char* outcome_name(evaluation::FigureEnd::Outcome outcome) {
  using Outcome = evaluation::FigureEnd::Outcome;
  if (outcome == Outcome::same) return "same";
  return outcome == Outcome::nothing ? "nothing_compliant" : "other";
}

}  // namespace

void add_tolerances(const MachineResult& result, const evaluation::Design& design, Json& json) {
  if (!design.tolerances) return;
  const ToleranceCheck& check = *design.tolerances;
  Json figures = Json::array(), breaks = Json::array();
  for (const TolerancedFigure& figure : check.figures) figures.push_back(figure_of(figure));
  for (const ToleranceBreak& each : check.single) breaks.push_back(break_of(each, check.figures));
  if (check.combination) breaks.push_back(break_of(*check.combination, check.figures));
  json["tolerances"] = Json{{"verdict", to_string(check.verdict)},
                            {"figures", figures},
                            {"breaks", breaks},
                            {"estimates_without", check.unstated}};
  if (check.stopped) json["tolerances"]["stopped"] = true;  // unsettled because time was up
  if (result.robust)
    json["tolerances"]["robust"] = {{"sets_of_values", result.robust_scenarios},
                                    {"objective_without", number(result.robust_without)}};
}

void add_tolerances(const MachineResult& result, const evaluation::Explanation& explanation, Json& json) {
  if (!explanation.design || !explanation.design->tolerances) return;
  add_tolerances(result, *explanation.design, json);
  Json ends = Json::array();
  for (const evaluation::FigureEnd& end : explanation.ends)
    ends.push_back({{"figure", end.figure},
                    {"value", number(shown(explanation.design->tolerances->figures[end.figure], end.value))},
                    {"outcome", outcome_name(end.outcome)},
                    {"worse", number(end.worse)},
                    {"changes", end.changes}});
  json["tolerances"]["ends"] = std::move(ends);
  json["tolerances"]["ends_not_tried"] = explanation.ends_not_tried;
}

}  // namespace millwright::report
