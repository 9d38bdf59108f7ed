// SPDX-License-Identifier: Apache-2.0
//
// `--robust`: constraints are added scenario by scenario, each a set of values that broke the best build so far.
#include <algorithm>
#include <cmath>

#include "evaluation/longer_bars.h"
#include "evaluation/synthesis.h"
#include "evaluation/toleranced_machine.h"

namespace millwright::evaluation {

namespace {

using catalogue::Catalogue;
using Values = std::vector<std::pair<std::size_t, double>>;

/// Rounds after which it is left unsettled.
constexpr std::size_t most_scenarios = 12;

/// All values that broke the build one at a time, if they do so together too: one scenario then says what each says.
Values breaking_values(const MachineModel& model, const solver::Build& build, const ToleranceCheck& check) {
  if (check.single.empty()) return check.combination->values;
  if (check.single.size() > 1) {
    const TolerancedMachine machine(model, build);
    std::vector<double> values;
    for (const TolerancedFigure& figure : machine.figures()) values.push_back(figure.value);
    Values all;
    for (const ToleranceBreak& each : check.single) {
      const auto& [figure, value] = each.values.front();
      values[figure] = value;
      all.push_back(each.values.front());
    }
    if (!machine.design(values).satisfied()) return all;
  }
  const auto worst = std::max_element(check.single.begin(), check.single.end(), [](const auto& a, const auto& b) {
    return a.utilisation < b.utilisation;
  });
  return worst->values;
}

/// The catalogue with these values, and the same figure of every other part as far off in the same direction: whatever
/// is chosen next is asked the same. The build that was broken has exactly the values that broke it.
std::shared_ptr<const Catalogue> scenario(const Catalogue& catalogue,
                                          const ToleranceCheck& check,
                                          const Values& values) {
  auto result = std::make_shared<Catalogue>(catalogue);
  for (const auto& [index, value] : values) {
    const TolerancedFigure& figure = check.figures[index];
    const double share = (value - figure.value) / figure.half_width;
    const catalogue::Table& table = catalogue.table(figure.family);
    for (int row = 0; row < table.rows(); ++row) {
      const bool chosen = std::any_of(check.figures.begin(), check.figures.end(), [&](const TolerancedFigure& each) {
        return each.family == figure.family && each.column == figure.column &&
               std::find(each.rows.begin(), each.rows.end(), row) != each.rows.end();
      });
      const double half_width = table.half_width(row, figure.column);
      if (!chosen && half_width > 0.0)
        result->changeable_table(figure.family)
            .set_number(row, figure.column, table.number(figure.column, row) + share * half_width);
    }
  }
  for (const auto& [index, value] : values) {
    const TolerancedFigure& figure = check.figures[index];
    for (int row = 0; row < catalogue.table(figure.family).rows(); ++row)
      if (catalogue.table(figure.family)
              .same_part(row, catalogue.table(figure.family), figure.row, catalogue::Identity::point))
        result->changeable_table(figure.family).set_number(row, figure.column, value);
  }
  lengthen_bars(*result);
  return result;
}

double objective_of(const Synthesis& synthesis, const SearchOptions& options) {
  return synthesis.designs.front().total(machine::objective_named(options.objectives.front()));
}

}  // namespace

RobustSynthesis synthesise_robustly(const machine::Problem& problem,
                                    const Catalogue& catalogue,
                                    const ModelOptions& model_options,
                                    const SearchOptions& options) {
  RobustSynthesis result;
  result.without = std::nan("");
  SearchOptions how = options;
  how.tolerances = true;
  ModelOptions with = model_options;
  double seconds = 0.0;
  for (;;) {
    how.time_limit_seconds = std::max(0.0, options.time_limit_seconds - seconds);
    const MachineModel model(problem, catalogue, {}, with);
    Synthesis found = synthesise(model, how);
    found.nodes += result.best.nodes;
    found.evaluations += result.best.evaluations;
    seconds += found.seconds;
    found.seconds = seconds;
    result.best = std::move(found);
    result.scenarios = with.scenarios.size();
    if (result.best.designs.empty()) return result;
    if (with.scenarios.empty()) result.without = objective_of(result.best, how);
    const ToleranceCheck& check = *result.best.designs.front().tolerances;
    if (check.verdict != ToleranceVerdict::broken) {
      if (check.verdict == ToleranceVerdict::unsettled) result.best.status = solver::Status::limit;
      return result;
    }
    if (result.best.status == solver::Status::limit || with.scenarios.size() == most_scenarios ||
        (options.stop != nullptr && options.stop->load())) {
      result.best.status = solver::Status::limit;
      return result;
    }
    const Values values = breaking_values(model, result.best.builds.front(), check);
    with.scenarios.push_back(scenario(catalogue.with_offers(), check, values));
  }
}

}  // namespace millwright::evaluation
