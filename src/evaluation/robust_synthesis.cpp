// SPDX-License-Identifier: Apache-2.0
//
// `--robust`: constraints are added scenario by scenario, each a set of values that broke the best build so far.
#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/allowed_time.h"
#include "evaluation/longer_bars.h"
#include "evaluation/synthesis.h"
#include "evaluation/toleranced_machine.h"

namespace millwright::evaluation {

namespace {

using catalogue::Catalogue;
using Values = std::vector<std::pair<std::size_t, double>>;

/// Sets of values after which it is left unsettled.
constexpr std::size_t most_scenarios = 12;
constexpr std::size_t most_scenarios_of_fronts = 40;

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

/// Whether two builds were broken by the same values of the same figures.
bool same_values(const ToleranceCheck& a, const Values& in_a, const ToleranceCheck& b, const Values& in_b) {
  const auto same = [&](const std::pair<std::size_t, double>& x, const std::pair<std::size_t, double>& y) {
    const TolerancedFigure& figure = a.figures[x.first];
    const TolerancedFigure& other = b.figures[y.first];
    return figure.family == other.family && figure.row == other.row && figure.column == other.column &&
           x.second == y.second;
  };
  return in_a.size() == in_b.size() && std::equal(in_a.begin(), in_a.end(), in_b.begin(), same);
}

/// Of the builds found, the values that break them, the same ones once.
class Breaks {
 public:
  Breaks(const MachineModel& model, const Synthesis& found) {
    for (std::size_t i = 0; i < found.designs.size(); ++i) {
      if (!found.designs[i].tolerances) continue;  // of a single objective only the best is asked
      const ToleranceCheck& check = *found.designs[i].tolerances;
      unsettled_ = unsettled_ || check.verdict == ToleranceVerdict::unsettled;
      if (check.verdict != ToleranceVerdict::broken) continue;
      any_ = true;
      if (all_.size() == most_at_once) continue;
      Values values = breaking_values(model, found.builds[i], check);
      const bool known = std::any_of(all_.begin(), all_.end(), [&](const auto& each) {
        return same_values(*each.first, each.second, check, values);
      });
      if (!known) all_.emplace_back(&check, std::move(values));
    }
  }
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] bool unsettled() const { return unsettled_; }
  [[nodiscard]] const std::vector<std::pair<const ToleranceCheck*, Values>>& all() const { return all_; }

 private:
  /// Each makes the search longer, and what breaks one build of a front mostly breaks its neighbours.
  static constexpr std::size_t most_at_once = 4;

  std::vector<std::pair<const ToleranceCheck*, Values>> all_;
  bool any_ = false, unsettled_ = false;
};

/// Builds that break, or may, are what nothing beats: of those that hold nothing is known by that.
void leave_open(Synthesis& found) {
  found.status = solver::Status::limit;
  found.front_tolerance = std::numeric_limits<double>::infinity();
}

void leave_out_broken(Synthesis& front) {
  for (std::size_t i = front.designs.size(); i-- > 0;) {
    if (front.designs[i].tolerances->verdict != ToleranceVerdict::broken) continue;
    front.designs.erase(front.designs.begin() + static_cast<std::ptrdiff_t>(i));
    front.builds.erase(front.builds.begin() + static_cast<std::ptrdiff_t>(i));
  }
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
  const bool is_front = options.objectives.size() > 1;
  ModelOptions with = model_options;
  const AllowedTime time(options.time_limit_seconds);
  for (;;) {
    how.time_limit_seconds = time.left();
    const MachineModel model(problem, catalogue, {}, with);
    Synthesis found = synthesise(model, how);
    found.nodes += result.best.nodes;
    found.evaluations += result.best.evaluations;
    found.seconds = time.used();
    result.best = std::move(found);
    result.scenarios = with.scenarios.size();
    if (result.best.designs.empty()) return result;
    if (with.scenarios.empty()) result.without = objective_of(result.best, how);
    const Breaks breaks(model, result.best);
    if (!breaks.any()) {
      if (breaks.unsettled()) leave_open(result.best);
      return result;
    }
    const std::size_t most = is_front ? most_scenarios_of_fronts : most_scenarios;
    const bool stopped = (options.stop != nullptr && options.stop->load()) || time.left() == 0.0;
    if (result.best.status == solver::Status::limit || with.scenarios.size() >= most || stopped) {
      leave_open(result.best);
      if (is_front) leave_out_broken(result.best);
      return result;
    }
    for (const auto& [check, values] : breaks.all())
      with.scenarios.push_back(scenario(catalogue.with_offers(), *check, values));
  }
}

}  // namespace millwright::evaluation
