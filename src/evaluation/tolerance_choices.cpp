// SPDX-License-Identifier: Apache-2.0
#include "evaluation/tolerance_choices.h"

#include <fmt/format.h>

#include <cmath>

namespace millwright::evaluation {

namespace {

/// "x.motor 17HS4401S" for every part that the other build has instead.
std::vector<std::string> changes_of(const Design& from, const Design& to) {
  std::vector<std::string> changes;
  for (const PartLine& part : to.parts) {
    const bool kept = std::any_of(from.parts.begin(), from.parts.end(), [&](const PartLine& other) {
      return other.axis == part.axis && other.slot == part.slot && other.manufacturer == part.manufacturer &&
             other.part_number == part.part_number;
    });
    if (!kept) changes.push_back(fmt::format("{}.{} {}", part.axis, part.slot, part.part_number));
  }
  return changes;
}

/// The best build with another value of one figure.
FigureEnd end_of(ConditionTrials& trials, const Explanation& known, std::size_t index, double value) {
  const TolerancedFigure& figure = known.design->tolerances->figures[index];
  const SearchOptions options =
      trials.begin(fmt::format("{} {}", figure.part, catalogue::declaration(figure.column).name), false);
  machine::Problem problem = trials.asked().problem;
  problem.counted = machine::counted_quantities(options.objectives);
  catalogue::Catalogue parts = trials.catalogue_for(trials.asked()).with_offers();
  catalogue::Table& table = parts.changeable_table(figure.family);
  for (int row = 0; row < table.rows(); ++row)  // whoever sells it
    if (table.same_part(row, table, figure.row, catalogue::Identity::point))
      table.set_number(row, figure.column, value);
  const MachineModel model(problem, parts, {}, {.fixed = trials.asked().fixed});
  const Synthesis found = synthesise(model, options);
  if (found.status == solver::Status::limit) {
    trials.check_time();
    throw Unsettled{};
  }
  FigureEnd end{index, value, FigureEnd::Outcome::nothing, 0.0, {}};
  if (found.designs.empty()) return end;
  const Design& best = found.designs.front();
  const machine::Objective objective = machine::objective_named(known.objective);
  end.worse = best.compared(objective) - known.design->compared(objective);
  end.changes = changes_of(*known.design, best);
  end.outcome = end.changes.empty() ? FigureEnd::Outcome::same : FigureEnd::Outcome::other;
  return end;
}

}  // namespace

void find_figure_ends(ConditionTrials& trials, double seconds, Explanation& result) {
  if (!result.design->tolerances) return;
  const auto& figures = result.design->tolerances->figures;
  const double until = trials.seconds() + seconds;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (!figures[i].estimate) continue;
    for (const double sign : {-1.0, 1.0}) {
      if (trials.seconds() > until) {
        ++result.ends_not_tried;
        continue;
      }
      try {
        result.ends.push_back(end_of(trials, result, i, figures[i].value + sign * figures[i].half_width));
      } catch (const Unsettled&) {
        ++result.ends_not_tried;
      }
    }
  }
}

}  // namespace millwright::evaluation
