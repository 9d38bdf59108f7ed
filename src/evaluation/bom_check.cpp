// SPDX-License-Identifier: Apache-2.0
//
// `check`: holds what the bill of materials gives and completes the rest. First by the solver, on the machine
// restricted to what is held: that gives the cheapest compliant completion. If there is none, by the cheapest parts
// that fit and the variables with which the fewest checks fail, so that the report can say by how much each check
// fails.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <set>

#include "evaluation/allowed_time.h"
#include "evaluation/cheapest_order.h"
#include "evaluation/held_parts.h"
#include "evaluation/machine_stages.h"
#include "evaluation/shops.h"
#include "evaluation/synthesis.h"
#include "solver/restricted_problem.h"

namespace millwright::evaluation {

namespace {

using solver::Row;

/// Settings for which the model leaves no choice open: there the bill of materials says what they are. A ramp time that
/// the problem fixes is no variable. The current that is set is what it is, whether or not the problem would set it.
void take_settings(machine::Problem& problem, const machine::BillOfMaterials& bom, const std::string& only_origin) {
  for (const machine::BomLine& line : bom.lines) {
    if (!line.value || (!only_origin.empty() && line.origin != only_origin)) continue;
    for (machine::Axis& axis : problem.axes) {
      if (axis.name != line.axis) continue;
      if (line.slot == "acceleration_time" && axis.acceleration_time.fixed())
        axis.acceleration_time = {*line.value, *line.value};
      if (line.slot == "motor_current") axis.motor.currents = {*line.value};
    }
  }
}

/// How bad a design is: how many checks it fails, then the largest utilisation, the next largest, and so on. The
/// largest alone would not do: where a part that is held fails by more, nothing would keep the rest from failing too.
std::vector<double> badness(std::vector<double> utilisations) {
  std::sort(utilisations.begin(), utilisations.end(), std::greater<>());
  const auto failing = std::count_if(utilisations.begin(), utilisations.end(), [](double u) { return u > 1.0; });
  utilisations.insert(utilisations.begin(), static_cast<double>(failing));
  return utilisations;
}

/// Variables at which `value` is least, from `best` on: coordinate search on a shrinking grid, exact enough to judge
/// by.
template <class Value>
std::vector<double> least_over(std::span<const solver::Variable> variables, std::vector<double> best, Value&& value) {
  std::vector<double> least = value(best);
  double reach = 0.5;
  for (int round = 0; round < 40; ++round) {
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const double centre = best[i];
      const double width = variables[i].upper - variables[i].lower;
      for (int k = -10; k <= 10; ++k) {
        std::vector<double> x = best;
        x[i] = std::clamp(centre + reach * width * k / 10.0, variables[i].lower, variables[i].upper);
        if (std::vector<double> u = value(x); u < least) {
          least = std::move(u);
          best = x;
        }
      }
    }
    reach *= 0.6;
  }
  return best;
}

/// Variables that make a stage least bad.
std::vector<double> least_bad_variables(const solver::Stage& stage, const solver::Point& at) {
  const auto variables = stage.variables();
  std::vector<double> middle;
  for (const solver::Variable& v : variables) middle.push_back(0.5 * (v.lower + v.upper));
  if (variables.empty()) return middle;
  solver::Answer<double> answer;
  return least_over(variables, std::move(middle), [&](const std::vector<double>& x) {
    stage.evaluate({at.shared, at.inherited, at.rows, x}, answer);
    return badness(answer.utilisation);
  });
}

/// Whether, but for the cost, everything is within its limit; `used` gets what it takes of these, and all utilisations.
bool keeps_limits(const solver::Problem& problem, const solver::Build& build, std::vector<double>& used) {
  used.clear();
  std::vector<double> state = problem.first_state, totals(problem.resources.size(), 0.0);
  solver::Answer<double> answer;
  for (std::size_t i = 0; i < build.stages.size(); ++i) {
    problem.stages[i]->evaluate({build.shared, state, build.stages[i].rows, build.stages[i].variables}, answer);
    used.insert(used.end(), answer.utilisation.begin(), answer.utilisation.end());
    for (std::size_t r = 0; r < totals.size(); ++r) totals[r] += answer.resources[r];
    state = answer.handed_on;
  }
  bool keeps = true;
  for (std::size_t r = 0; r < totals.size(); ++r) {
    if (r == cost_resource || !std::isfinite(problem.resources[r].limit)) continue;
    used.push_back(std::min(machine::useless_utilisation, totals[r] / problem.resources[r].limit));  // no number too
    keeps = keeps && !(used.back() > 1.0);
  }
  return keeps;
}

/// Parts that were taken one by one, with what the bill leaves free of the variables of each stage.
struct TakenBuild {
  solver::Build build;
  std::vector<std::vector<double>> free;
};

/// What suits each stage may take too much in all: then what suits the machine, twice over, while there is time.
void settle_for_limits(const MachineModel& model,
                       const solver::RestrictedProblem& restricted,
                       const AllowedTime& time,
                       TakenBuild& taken) {
  std::vector<double> used;
  for (int round = 0; round < 2 && !keeps_limits(model.problem(), taken.build, used); ++round)
    for (std::size_t i = 0; i < taken.free.size(); ++i) {
      const solver::RestrictedStage& stage = restricted.stage(i);
      if (taken.free[i].empty() || !(time.left() > 0.0)) continue;
      const auto take = [&](const std::vector<double>& free) {
        taken.build.stages[i].variables = stage.inner_variables(free);
      };
      taken.free[i] = least_over(stage.variables(), taken.free[i], [&](const std::vector<double>& free) {
        take(free);
        (void)keeps_limits(model.problem(), taken.build, used);
        return badness(used);
      });
      take(taken.free[i]);
    }
}

/// Rows that stand for owned pieces alone come last: there may not be enough of them.
double price_to_compare(const MachineModel& model, const Candidate& candidate) {
  for (const PartUse& use : candidate.parts)
    if (use.stated.empty() && model.catalogue().table(use.family).ownership(use.row) == catalogue::Ownership::only)
      return beyond_reach;
  return candidate.price;
}

/// Of the rows of a stage's slot that are offered: the cheapest that fits those already chosen, or if none does the
/// cheapest. Nothing where none is offered.
std::optional<Row> cheapest_fitting(const MachineModel& model,
                                    const StageEntry& entry,
                                    const solver::RestrictedStage& stage,
                                    const HeldStage& held,
                                    std::size_t slot,
                                    const std::vector<std::optional<Row>>& chosen,
                                    std::span<const Row> shared) {
  const SlotTable& table = entry.tables()[slot];
  std::vector<Row> order(held.allowed[slot].size());
  std::iota(order.begin(), order.end(), Row{0});
  std::stable_sort(order.begin(), order.end(), [&](Row a, Row b) {
    return price_to_compare(model, table.candidate(held.allowed[slot][a])) <
           price_to_compare(model, table.candidate(held.allowed[slot][b]));
  });
  std::erase_if(order, [&](Row row) { return !stage.offered(shared, slot, row); });
  for (const Row row : order) {
    bool fits = true;
    for (std::size_t other = 0; other < chosen.size() && fits; ++other)
      if (chosen[other] && other != slot) fits = stage.fits(shared, slot, row, other, *chosen[other]);
    if (fits) return row;
  }
  return order.empty() ? std::nullopt : std::optional(order.front());
}

/// The same of a belt with its two pulleys, which are one choice: what is cheap by itself may need what is dear.
void choose_belt(const MachineModel& model,
                 const StageEntry& entry,
                 const solver::RestrictedStage& stage,
                 const HeldStage& held,
                 std::vector<std::optional<Row>>& chosen,
                 std::span<const Row> shared) {
  constexpr std::size_t slots = BeltDriveStage::idler_slot + 1;
  double least = std::numeric_limits<double>::infinity();
  std::vector<Row> rows, best;
  const auto fits = [&](std::size_t slot, Row row, bool with_others) {
    for (std::size_t other = 0; other < slot; ++other)
      if (!stage.fits(shared, other, rows[other], slot, row)) return false;
    for (std::size_t other = slots; with_others && other < chosen.size(); ++other)
      if (chosen[other] && !stage.fits(shared, slot, row, other, *chosen[other])) return false;
    return true;
  };
  const std::function<void(double, bool)> add = [&](double price, bool with_others) {
    if (price >= least) return;
    const std::size_t slot = rows.size();
    if (slot == slots) {
      best = rows;
      least = price;
      return;
    }
    for (Row row = 0; row < held.allowed[slot].size(); ++row) {
      if (!stage.offered(shared, slot, row) || !fits(slot, row, with_others)) continue;
      rows.push_back(row);
      add(price + price_to_compare(model, entry.tables()[slot].candidate(held.allowed[slot][row])), with_others);
      rows.pop_back();
    }
  };
  add(0.0, true);
  if (best.empty()) add(0.0, false);
  std::copy(best.begin(), best.end(), chosen.begin());
}

/// Of a stage that is one choice, as the supply is: the cheapest row on sale that fails nothing here, or fails least.
std::optional<Row> least_bad_row(const MachineModel& model,
                                 const StageEntry& entry,
                                 const solver::RestrictedStage& stage,
                                 const HeldStage& held,
                                 std::span<const Row> shared,
                                 std::span<const double> state) {
  const SlotTable& table = entry.tables().front();
  std::optional<Row> best;
  std::vector<double> least;
  double price = 0.0;
  solver::Answer<double> answer;
  for (Row row = 0; row < held.allowed.front().size(); ++row) {
    if (!stage.offered(shared, 0, row)) continue;
    stage.evaluate({shared, state, std::span<const Row>(&row, 1), {}}, answer);
    std::vector<double> bad = badness(answer.utilisation);
    if (bad.front() == 0.0) bad = {0.0};
    const double costs = price_to_compare(model, table.candidate(held.allowed.front()[row]));
    if (best && (bad > least || (bad == least && costs >= price))) continue;
    best = row;
    least = std::move(bad);
    price = costs;
  }
  return best;
}

/// The cheapest parts that fit and that these suppliers sell, slot by slot: named slots first; the supply for what the
/// drives take. Nothing if they do not sell everything.
std::optional<TakenBuild> cheapest_build(const MachineModel& model,
                                         const HeldParts& held,
                                         const solver::RestrictedProblem& restricted,
                                         std::vector<Row> shared) {
  TakenBuild taken;
  solver::Build& build = taken.build;
  build.shared = std::move(shared);
  std::vector<double> state = model.problem().first_state;
  for (std::size_t i = 0; i < model.entries().size(); ++i) {
    const solver::RestrictedStage& stage = restricted.stage(i);
    const std::size_t slots = stage.slots().size();
    std::vector<std::optional<Row>> chosen(slots);
    const bool has_belt = std::holds_alternative<std::unique_ptr<BeltDriveStage>>(model.entries()[i].stage);
    for (const bool named : {true, false}) {
      const std::vector<bool>& given = held.stages[i].named;
      if (has_belt && named == (given[BeltDriveStage::belt_slot] && given[BeltDriveStage::pulley_slot] &&
                                given[BeltDriveStage::idler_slot]))
        choose_belt(model, model.entries()[i], stage, held.stages[i], chosen, build.shared);
      for (std::size_t slot = 0; slot < slots; ++slot)
        if (given[slot] == named && !(has_belt && slot <= BeltDriveStage::idler_slot)) {
          chosen[slot] = cheapest_fitting(model, model.entries()[i], stage, held.stages[i], slot, chosen, build.shared);
          if (!chosen[slot]) return std::nullopt;
        }
    }
    if (has_belt && !chosen[BeltDriveStage::belt_slot]) return std::nullopt;
    if (std::holds_alternative<std::unique_ptr<SupplyStage>>(model.entries()[i].stage))
      chosen.front() = least_bad_row(model, model.entries()[i], stage, held.stages[i], build.shared, state);
    std::vector<Row> rows;
    for (const auto& row : chosen) rows.push_back(*row);
    taken.free.push_back(least_bad_variables(stage, {build.shared, state, rows, {}}));
    const std::vector<double>& free = taken.free.back();
    solver::Answer<double> answer;
    stage.evaluate({build.shared, state, rows, free}, answer);
    build.stages.push_back({stage.inner_rows(rows), stage.inner_variables(free), state});
    state = answer.handed_on;
  }
  model.set_suppliers(build);
  return taken;
}

/// How bad a design is; of equally bad ones the cheaper is better.
using Badness = std::pair<std::vector<double>, double>;

Badness badness_of(const Design& design) {
  std::vector<double> utilisations;
  for (const Check& c : design.checks)
    if (c.kind != machine::ConstraintKind::soft)
      utilisations.push_back(!std::isnan(c.utilisation)       ? c.utilisation
                             : c.verdict == Verdict::violated ? machine::useless_utilisation
                                                              : 0.0);
  return {badness(std::move(utilisations)), design.cost};
}

/// Where no build complies: the one with the least bad checks, of equal ones the cheapest with its orders. Parts are
/// taken slot by slot, as these and those suppliers sell them, and then ordered where all of them together cost least.
Design least_bad(const MachineModel& model,
                 const HeldParts& held,
                 const solver::RestrictedProblem& restricted,
                 const SearchOptions& options,
                 const AllowedTime& time) {
  constexpr double at_least = 2.0;  // seconds for the orders, which are soon found, when a search took all there was
  Design best;
  Badness least{{std::numeric_limits<double>::infinity()}, 0.0};
  const AlikeRows alike(model);
  const std::vector<solver::Slot>& choices = model.problem().shared;
  const Row supplier_sets = choices.size() > shop_choice ? choices[shop_choice].rows : 1;
  for (Row voltage = 0; voltage < choices.front().rows; ++voltage) {
    std::set<std::vector<std::size_t>> seen;
    for (Row suppliers = 0; suppliers < supplier_sets; ++suppliers) {
      std::vector<Row> shared{voltage};
      if (choices.size() > shop_choice) shared.push_back(suppliers);
      auto taken = cheapest_build(model, held, restricted, shared);
      if (!taken || !seen.insert(alike.parts_of(taken->build)).second) continue;
      settle_for_limits(model, restricted, time, *taken);
      const double seconds = std::max(at_least, time.left());
      Design design = model.design(ordered_cheapest_though_failing(model, alike, options, taken->build, seconds),
                                   options.worksheets);
      Badness bad = badness_of(design);
      if (!(bad < least)) continue;
      least = std::move(bad);
      best = std::move(design);
    }
  }
  return best;
}

void report_missing(const MachineModel& model,
                    const HeldParts& held,
                    const machine::BillOfMaterials& bom,
                    std::vector<BomProblem>& problems) {
  for (std::size_t i = 0; i < model.entries().size(); ++i) {
    const StageEntry& entry = model.entries()[i];
    for (std::size_t slot = 0; slot < entry.tables().size(); ++slot) {
      if (held.stages[i].named[slot] || entry.tables()[slot].rows() == 0) continue;
      for (const std::string& part : slots_of(entry.tables()[slot])) {
        const bool given = std::any_of(bom.lines.begin(), bom.lines.end(), [&](const machine::BomLine& line) {
          return line.axis == entry.axis && line.slot == part;
        });
        if (given) continue;
        machine::SourceSpan where;  // no line is at fault
        if (!bom.lines.empty()) where = text::whole(bom.lines.back().where.text);
        problems.push_back(
            {where,
             fmt::format("axis '{}' has no {}", entry.axis, part),
             fmt::format("add a line '{},{},...' or use --complete to have it chosen", entry.axis, part)});
      }
    }
  }
}

void mark_origins(Design& design, const machine::BillOfMaterials& bom) {
  for (PartLine& part : design.parts)
    for (const machine::BomLine& line : bom.lines)
      if (line.axis == part.axis && line.slot == part.slot && line.part_number == part.part_number)
        part.origin = line.origin.empty() ? "given" : line.origin;
}

}  // namespace

BomCheck check(const machine::Problem& problem,
               const catalogue::Catalogue& catalogue,
               const machine::BillOfMaterials& bom,
               bool complete,
               const SearchOptions& options,
               const std::string& only_origin) {
  const AllowedTime time(options.time_limit_seconds);
  BomCheck result;
  machine::Problem at_voltage = problem;
  take_settings(at_voltage, bom, only_origin);
  // At the voltage that is held, where one is: a model at all of the problem's takes as much longer to make.
  if (const auto stated = stated_voltage(bom, catalogue, only_origin))
    for (const double volts : problem.supply_voltages)
      if (std::abs(volts - stated->volts) < 1e-6) at_voltage.supply_voltages = {volts};
  const MachineModel model(at_voltage, catalogue, given_slots(bom, only_origin));
  const HeldParts held = hold_parts(model, bom, only_origin);
  result.empty_slots = model.empty_slots();
  result.problems = held.problems;
  result.remarks = held.remarks;
  if (!result.empty_slots.empty() && result.problems.empty())
    for (const EmptySlot& slot : result.empty_slots)
      result.problems.push_back({machine::SourceSpan{}, slot.reason, "see 'catalogue list'"});
  if (!complete && only_origin.empty()) report_missing(model, held, bom, result.problems);
  if (!result.problems.empty()) return result;
  result.completed = std::any_of(held.stages.begin(), held.stages.end(), [](const HeldStage& s) {
    return std::find(s.named.begin(), s.named.end(), false) != s.named.end();
  });
  if (result.completed) result.incomplete = incomplete_parts(model, held);
  const solver::RestrictedProblem restricted(model.problem(), restriction_of(model, held));
  const solver::Summary summary = solver::solve(restricted.problem(), solver_options(model, options));
  if (!summary.builds.empty()) {
    const solver::Build build = restricted.whole_build(summary.builds.front());
    result.design = model.design(build, options.worksheets);
    if (options.tolerances)
      result.design.tolerances = std::make_shared<const ToleranceCheck>(check_tolerances(model, build, result.design));
    result.completion = summary.status == solver::Status::optimal ? Completion::best : Completion::compliant;
  } else {
    result.completion = summary.status == solver::Status::infeasible ? Completion::refuted : Completion::open;
    result.design = least_bad(model, held, restricted, options, time);
  }
  mark_origins(result.design, bom);
  return result;
}

}  // namespace millwright::evaluation
