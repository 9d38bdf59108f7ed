// SPDX-License-Identifier: Apache-2.0
#include "evaluation/toleranced_machine.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "catalogue/companions.h"
#include "evaluation/ledger.h"
#include "evaluation/longer_bars.h"
#include "evaluation/same_parts.h"

namespace millwright::evaluation {

using catalogue::Catalogue;
using catalogue::Column;
using catalogue::Family;
using catalogue::Table;
using scalar::Interval;

namespace {

bool same(const Interval& a, const Interval& b) {
  const auto equal = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return equal(a.lower, b.lower) && equal(a.upper, b.upper);
}

}  // namespace

TolerancedMachine::TolerancedMachine(const MachineModel& model, const solver::Build& build)
    : problem_(model.machine()) {
  // What is chosen stays, whatever another driver would cost.
  for (machine::Axis& axis : problem_.axes) {
    axis.keep_every_candidate = axis.keep_covered_candidates = true;
    axis.motor.driver_currents.clear();  // rows of a catalogue with more parts
  }
  take_parts(model, build);
  take_figures(model.catalogue());
  build_ = model.whole_build(build);
  if (figures_.empty()) return;
  std::vector<Interval> stated;
  for (const TolerancedFigure& figure : figures_) stated.emplace_back(figure.value);
  as_stated_ = bounds(stated);
}

const TolerancedMachine::ChosenPart* TolerancedMachine::find(Family family, int row) const {
  for (const ChosenPart& each : chosen_parts_)
    if (each.part.family == family && each.part.row == row) return &each;
  return nullptr;
}

void TolerancedMachine::take_parts(const MachineModel& model, const solver::Build& build) {
  const auto take = [&](Family family, int row, const std::string& place) {
    for (ChosenPart& each : chosen_parts_)
      if (each.part.family == family && each.part.row == row) {
        each.places.push_back(place);
        return;
      }
    chosen_parts_.push_back({{family, row}, 0, {place}});
  };
  const Table& curves = model.catalogue().table(Family::stepper_curves);
  for (std::size_t stage = 0; stage < model.entries().size(); ++stage) {
    const StageEntry& entry = model.entries()[stage];
    chosen_.emplace_back();
    for (std::size_t slot = 0; slot < entry.tables().size(); ++slot) {
      const Candidate& candidate = model.candidate(stage, slot, build.stages[stage].rows[slot]);
      chosen_.back().push_back(candidate);
      for (const PartUse& use : candidate.parts) {
        if (!use.stated.empty()) continue;
        const std::string place = entry.axis + "." + std::string(use.slot);
        take(use.family, use.row, place);
        if (use.family != Family::steppers) continue;
        const Table& motors = model.catalogue().table(Family::steppers);
        for (const int row : curves.rows_in_order())
          if (curves.part_number(row) == motors.part_number(use.row) &&
              curves.manufacturer(row) == motors.manufacturer(use.row))
            take(Family::stepper_curves, row, place);
      }
    }
  }
  std::vector<catalogue::Part> kept;
  for (const ChosenPart& each : chosen_parts_) kept.push_back(each.part);
  // Materials are looked up by name; they have no tolerances.
  std::erase_if(kept, [](const catalogue::Part& part) { return part.family == Family::materials; });
  for (int row = 0; row < model.catalogue().table(Family::materials).rows(); ++row)
    kept.push_back({Family::materials, row});
  parts_ = model.catalogue().only(kept);
  for (ChosenPart& each : chosen_parts_)
    each.row = static_cast<int>(std::count_if(chosen_parts_.begin(), chosen_parts_.end(), [&](const ChosenPart& other) {
      return other.part.family == each.part.family && other.part.row < each.part.row;
    }));
}

void TolerancedMachine::take_figures(const Catalogue& catalogue) {
  for (const ChosenPart& chosen : chosen_parts_) {
    const Family family = chosen.part.family;
    const int row = chosen.part.row;
    const Table& table = catalogue.table(family);
    for (std::size_t index = 0; index < catalogue::column_count(family); ++index) {
      const Column column{family, static_cast<std::uint8_t>(index)};
      if (!catalogue::takes_tolerance(column) || std::isnan(table.number(column, row))) continue;
      const double half_width = table.half_width(row, column);
      if (std::isnan(half_width) && table.is_estimate(row, column)) ++unstated_;
      if (!(half_width > 0.0)) continue;
      const auto known = std::find_if(figures_.begin(), figures_.end(), [&](const TolerancedFigure& each) {
        return each.family == family && each.column == column &&
               table.same_part(row, table, each.row, catalogue::Identity::point);
      });
      if (known != figures_.end()) {
        known->rows.push_back(row);
        known->places.insert(known->places.end(), chosen.places.begin(), chosen.places.end());
        continue;
      }
      TolerancedFigure figure{
          family, row, {row}, column, {}, chosen.places, table.number(column, row), half_width, {}, {}};
      figure.part = std::string(table.manufacturer(row)) + " " + std::string(table.part_number(row));
      figure.estimate = table.is_estimate(row, column);
      figure.basis = table.basis(row, column);
      figures_.push_back(std::move(figure));
    }
  }
}

solver::Build TolerancedMachine::build_in(const MachineModel& model) const {
  solver::Build build = build_;
  build.stages.resize(model.problem().stages.size());  // without suppliers nothing may be left for the last one to do
  for (std::size_t stage = 0; stage < build.stages.size(); ++stage) {
    std::vector<std::vector<solver::Row>> rows;
    for (std::size_t slot = 0; slot < chosen_[stage].size(); ++slot) {
      const Candidate& wanted = chosen_[stage][slot];
      const SlotTable& table = model.entries()[stage].tables()[slot];
      const auto is_wanted = [&](const Candidate& candidate) {
        return std::ranges::equal(candidate.settings, wanted.settings) &&
               std::ranges::equal(candidate.parts, wanted.parts, [&](const PartUse& here, const PartUse& there) {
                 if (here.slot != there.slot || here.stated != there.stated) return false;
                 if (!here.stated.empty()) return true;
                 return here.family == there.family && here.row == find(there.family, there.row)->row;
               });
      };
      rows.emplace_back();
      for (std::size_t row = 0; row < table.rows(); ++row)
        if (is_wanted(table.candidate(row))) rows.back().push_back(static_cast<solver::Row>(row));
    }
    std::vector<solver::Row> first;
    for (const std::vector<solver::Row>& of_slot : rows) {
      if (of_slot.empty()) throw std::logic_error("a chosen part is no candidate of its own machine");
      first.push_back(of_slot.front());
    }
    // Of a part in several forms that which the others need; what fits no more with these figures fails a check.
    build.stages[stage].rows = rows_that_fit(*model.problem().stages[stage], build.shared, rows).value_or(first);
  }
  model.set_suppliers(build);  // of the parts that are left there may be other ones, in another order
  return build;
}

template <class Set>
Catalogue TolerancedMachine::parts_with(Set&& set) const {
  Catalogue parts = parts_;
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    const TolerancedFigure& figure = figures_[i];
    for (const int row : figure.rows)
      set(parts.changeable_table(figure.family), find(figure.family, row)->row, figure.column, i);
  }
  lengthen_bars(parts);
  return parts;
}

Design TolerancedMachine::design(std::span<const double> values) const {
  const Catalogue parts = parts_with(
      [&](Table& table, int row, Column column, std::size_t i) { table.set_number(row, column, values[i]); });
  const MachineModel model(problem_, parts);
  return model.design(build_in(model));
}

TolerancedMachine::Bounds TolerancedMachine::bounds(std::span<const Interval> values) const {
  const Catalogue parts =
      parts_with([&](Table& table, int row, Column column, std::size_t i) { table.set_range(row, column, values[i]); });
  const MachineModel model(problem_, parts);
  const solver::Build build = build_in(model);
  Bounds result;
  std::vector<Interval> totals(model.problem().resources.size(), Interval(0.0));
  std::vector<Interval> state(model.problem().first_state.begin(), model.problem().first_state.end());
  for (std::size_t i = 0; i < build.stages.size(); ++i) {
    const solver::Stage& stage = *model.problem().stages[i];
    const solver::StageChoice& choice = build.stages[i];
    std::vector<std::vector<Interval>> readings(choice.rows.size());
    std::vector<solver::RowsAlive> rows;
    for (std::size_t slot = 0; slot < choice.rows.size(); ++slot) {
      const std::span<const solver::Row> row(&choice.rows[slot], 1);
      stage.read(build.shared, slot, row, readings[slot]);
      rows.emplace_back(row, readings[slot]);
    }
    const std::vector<Interval> variables(choice.variables.begin(), choice.variables.end());
    solver::Answer<Interval> answer;
    stage.bound({build.shared, state, rows, variables}, answer);
    result.utilisation.insert(result.utilisation.end(), answer.utilisation.begin(), answer.utilisation.end());
    for (std::size_t r = 0; r < totals.size(); ++r) totals[r] = totals[r] + answer.resources[r];
    state = answer.handed_on;
  }
  for (const machine::QuantityDeclaration& each : machine::quantities())
    if (const auto limit = problem_.limits[each.quantity]; limit && each.quantity != machine::Quantity::cost)
      result.limited.push_back({totals[model.resource(each.quantity)], *limit});
  return result;
}

std::vector<double> TolerancedMachine::excesses(std::span<const Interval> values) const {
  const Bounds here = bounds(values);
  // What no figure touches is known to the last digits; where nothing is known nothing is proved.
  const auto untouched = [](const Interval& now, const Interval& as_stated) {
    constexpr double known = 1e-6;
    return same(now, as_stated) && now.upper - now.lower <= known * std::max(1.0, std::abs(now.upper));
  };
  std::vector<double> result;
  const auto take = [&](const Interval& now, const Interval& as_stated, double limit) {
    const bool is_kept = now.upper <= limit || untouched(now, as_stated);
    const double excess = now.upper / limit - 1.0;
    result.push_back(is_kept ? 0.0 : excess < machine::useless_utilisation ? excess : machine::useless_utilisation);
  };
  for (std::size_t i = 0; i < here.utilisation.size(); ++i) take(here.utilisation[i], as_stated_.utilisation[i], 1.0);
  for (std::size_t i = 0; i < here.limited.size(); ++i)
    take(here.limited[i].total, as_stated_.limited[i].total, here.limited[i].limit);
  return result;
}

}  // namespace millwright::evaluation
