// SPDX-License-Identifier: Apache-2.0
#include "evaluation/machine_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "evaluation/axis_stages.h"
#include "evaluation/driver_choices.h"
#include "evaluation/fixed_choices.h"
#include "evaluation/held_parts.h"
#include "evaluation/incomplete_parts.h"
#include "evaluation/machine_stages.h"
#include "evaluation/motor_shortage.h"
#include "evaluation/preferred_parts.h"
#include "evaluation/price_book.h"
#include "evaluation/same_parts.h"
#include "evaluation/short_bars.h"
#include "evaluation/what_counts.h"
#include "machine/carrying.h"

namespace millwright::evaluation {

StageEntry::StageEntry(std::string axis_name, std::string element_name, StagePointer pointer)
    : axis(std::move(axis_name)), element(std::move(element_name)), stage(std::move(pointer)) {}
StageEntry::StageEntry(StageEntry&&) noexcept = default;
StageEntry& StageEntry::operator=(StageEntry&&) noexcept = default;
StageEntry::~StageEntry() = default;

const solver::Stage& StageEntry::as_stage() const {
  return std::visit([](const auto& s) -> const solver::Stage& { return *s; }, stage);
}

const std::vector<SlotTable>& StageEntry::tables() const {
  return std::visit([](const auto& s) -> const std::vector<SlotTable>& { return s->tables(); }, stage);
}

namespace {

/// The problem without its wishes about the kinds of parts that are given.
machine::Problem without_wishes(machine::Problem problem, const GivenSlots& given) {
  for (machine::Axis& axis : problem.axes) {
    const auto has = [&](const std::string& slot) { return given.count({axis.name, slot}) > 0; };
    if (has("screw") || has("nut")) {
      axis.mechanism.ball_screws = axis.mechanism.lead_screws = true;
      axis.mechanism.thread_forms.clear();
      axis.mechanism.nut_materials.clear();
    }
    if (has("belt") || has("pulley_drive") || has("pulley_idle")) axis.mechanism.profiles.clear();
    if (has("motor")) axis.motor.frames.clear();
    axis.keep_every_candidate = axis.keep_every_candidate || has("driver");
    const auto part = [&](const std::string& slot) {
      const auto found = given.find({axis.name, slot});
      return found == given.end() ? std::nullopt : std::optional(found->second);
    };
    axis.motor.given = part("motor");
    axis.motor.given_driver = part("driver");
    if (axis.guide && has("guide")) axis.guide->kinds.clear();
    for (machine::Member& member : axis.members)
      if (has(member.name)) {
        member.section_kinds.clear();
        member.bolts.sizes.clear();
        member.bolts.property_classes.clear();
      }
  }
  return problem;
}

bool is_fixed(const machine::BillOfMaterials& fixed, const std::string& axis, const std::string& slot) {
  return std::any_of(fixed.lines.begin(), fixed.lines.end(), [&](const machine::BomLine& line) {
    return line.axis == axis && line.slot == slot;
  });
}

/// Which drivers of an axis have to stay.
void note_drivers(const catalogue::Catalogue& catalogue,
                  const PriceBook& prices,
                  const ModelOptions& options,
                  machine::Problem& problem) {
  note_what_counts(options.objectives, problem);
  const catalogue::Table& drivers = catalogue.table(catalogue::Family::drivers);
  std::vector<double> stated;
  for (int row = 0; row < drivers.rows(); ++row) stated.push_back(largest_amplitude(drivers, row));
  bool counts_drivers = false;
  for (int row = 0; row < drivers.rows(); ++row) counts_drivers = counts_drivers || prices.is_counted(drivers, row);
  // Which of two is cheaper hangs on how many are taken, and which of them is worth keeping on what tolerances move.
  const bool drivers_differ =
      !options.scenarios.empty() &&
      (drivers.has_tolerances() || catalogue.table(catalogue::Family::steppers).has_tolerances());
  for (machine::Axis& axis : problem.axes) {
    axis.keep_every_driver = axis.keep_every_driver || counts_drivers || drivers_differ;
    if (drivers_differ) axis.motor.driver_currents.assign(stated.begin(), stated.end());
    const bool keeps_all = axis.keep_covered_candidates || is_fixed(options.fixed, axis.name, "driver");
    if (!keeps_all) axis.most_covering = options.builds;
    axis.keep_covered_candidates = keeps_all || options.every_candidate;
  }
}

}  // namespace

GivenSlots given_slots(const machine::BillOfMaterials& bom, const std::string& only_origin) {
  GivenSlots given;
  for (const machine::BomLine& line : bom.lines)
    if (!line.is_dimension() && (only_origin.empty() || line.origin == only_origin))
      given.insert({{line.axis, line.slot}, {line.manufacturer, line.part_number}});
  return given;
}

MachineModel::MachineModel(const machine::Problem& given,
                           const catalogue::Catalogue& given_catalogue,
                           const GivenSlots& given_slots,
                           ModelOptions options)
    : options_(std::move(options)),
      problem_(without_wishes(given, given_slots)),
      catalogue_(given_catalogue.with_offers()),
      prices_(given, catalogue_) {
  const catalogue::Catalogue& catalogue = catalogue_;
  take_fixed_settings(problem_, options_.fixed, problems_);
  note_drivers(catalogue, prices_, options_, problem_);
  const machine::Problem& problem = problem_;
  prices_ = PriceBook(problem, catalogue);
  const PriceBook& prices = prices_;
  solver_problem_.shared.push_back({"supply_voltage", static_cast<solver::Row>(problem.supply_voltages.size())});
  solver_problem_.first_state.assign(first_load_state + problem.axes.size(), 0.0);
  solver_problem_.first_state.resize(first_load_state + problem.axes.size() + tool_states(problem).count, 0.0);
  for (std::size_t i = 0; i < problem.axes.size(); ++i)
    solver_problem_.first_state[first_load_state + i] = problem.axes[i].structure_mass + problem.axes[i].payload_mass;
  for (const std::size_t index : problem.order) add_axis(index, prices);
  double reserve = 1.0;
  for (const machine::Axis& axis : problem.axes)
    reserve = std::max(reserve, axis.require(machine::Requirement::supply_reserve));
  entries_.push_back({"machine",
                      "supply",
                      std::make_unique<SupplyStage>(
                          problem.supply_voltages, SupplyData{problem.require, reserve}, catalogue, prices)});
  const auto tool_error =
      problem.tool && problem.tool->position_error ? find_resource(machine::Quantity::position_error) : std::nullopt;
  add_spares(prices);
  bars_ = std::make_unique<StockBars>(catalogue_, prices_, problem_);
  count_parts(prices);
  std::vector<LateCharge> charges(counted_parts_.begin(), counted_parts_.end());
  std::copy_if(bars_->stocks().begin(), bars_->stocks().end(), std::back_inserter(charges), [](const BarStock& stock) {
    return stock.is_shared();
  });
  if (problem.tool || problem.limits.any() || !counted_parts_.empty() || !bars_->stocks().empty() || !shops_.empty()) {
    auto whole = std::make_unique<WholeStage>(problem, tool_error);
    whole->set_charges(std::move(charges));
    whole->set_suppliers(shops_.shops());
    whole->set_floors(shops_.floors());
    whole->set_owned_first(owned_first_);
    entries_.push_back({"machine", "whole", std::move(whole)});
  }
  const std::size_t resources =
      first_counted_resource + problem.counted.size() + (prefers() ? 1 : 0) + shops_.floors().size();
  for (const StageEntry& entry : entries_) {
    std::visit(
        [&](const auto& stage) {
          stage->set_floors(shops_.floors());
          stage->set_resources(resources);
          if (prefers()) stage->set_compared(*compared_resource_, any_preferred(catalogue, prices, stage->tables()));
        },
        entry.stage);
    solver_problem_.stages.push_back(&entry.as_stage());
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool some_out_of_reach = std::ranges::any_of(counted_parts_, &CountedPart::only_owned);
  // The bill adds its lines up in another order than the search: what costs just so much is allowed.
  const auto add_resource = [&](machine::Quantity quantity, double otherwise) {
    const std::optional<double> limit = problem.limits[quantity];
    solver_problem_.resources.push_back(
        {std::string(declaration(quantity).name), limit ? *limit * (1.0 + rounding_of_totals) : otherwise});
  };
  add_resource(machine::Quantity::cost, some_out_of_reach ? 0.5 * beyond_reach : infinity);
  add_resource(machine::Quantity::mass, infinity);
  for (const machine::Quantity quantity : problem.counted) add_resource(quantity, infinity);
  if (prefers()) solver_problem_.resources.push_back({"compared cost"});
  solver_problem_.resources.resize(resources, {"cost with minimum orders"});
  if (!options_.scenarios.empty()) add_scenarios(given, given_slots);
  if (!options_.fixed.lines.empty()) fix();
}

/// Spares cost what a piece of the candidate costs; of a guide they are carriages.
void MachineModel::add_spares(const PriceBook& prices) {
  if (problem_.spares.empty()) return;
  const auto price_of = [&](const PartUse& use) {
    if (use.family != catalogue::Family::linear_guides || !use.stated.empty()) return use.price / use.quantity;
    return prices.line(catalogue_.table(use.family), use.row, 1.0, 0.0);
  };
  for (StageEntry& entry : entries_)
    for (SlotTable& table : std::visit(
             [](auto& stage) -> auto& { return stage->change_tables(); }, entry.stage))
      for (std::size_t row = 0; row < table.rows(); ++row)
        for (PartUse& use : table.change_parts(row)) {
          use.spares = machine::spares_of(problem_, entry.axis, use.slot);
          if (!(use.spares > 0.0)) continue;
          const double more = use.spares * price_of(use);
          use.price += more;
          table.add_to_price(row, more);
        }
}

/// What of the parts has to be known at the end of the chain: pieces, and who sells them.
void MachineModel::count_parts(const PriceBook& prices) {
  std::vector<double>& state = solver_problem_.first_state;
  CountedParts counted(catalogue_, prices, state.size());
  std::vector<std::vector<PieceCount>> counts;
  for (const StageEntry& entry : entries_) {
    counts.push_back(counted.counts(entry.tables()));
    shops_.find(catalogue_, prices, entry.tables());
  }
  counted_parts_ = std::move(counted).finish();
  state.resize(state.size() + counted_parts_.size(), 0.0);
  if (options_.every_candidate) {
    std::vector<std::span<const SlotTable>> tables;
    for (const StageEntry& entry : entries_) tables.emplace_back(entry.tables());
    owned_first_ = find_owned_first(catalogue_, prices, counted_parts_, tables, state.size(), counts);
    state.resize(state.size() + owned_first_.size(), 0.0);
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) bars_->find(i, entries_[i].axis, entries_[i].tables());
  state.resize(state.size() + bars_->settle(state.size()), 0.0);
  state.resize(state.size() + shops_.settle(state.size(), options_.every_candidate), 0.0);
  for (CountedPart& part : counted_parts_) part.shop = shops_.shop_of(part.family, part.row);
  for (BarStock& stock : bars_->stocks()) stock.shop = shops_.shop_of(stock.family, stock.row);
  if (!shops_.empty()) solver_problem_.shared.push_back({"suppliers", solver::Row{1} << shops_.shops().size()});
  if (std::ranges::any_of(entries_,
                          [&](const StageEntry& entry) { return any_preferred(catalogue_, prices, entry.tables()); }))
    compared_resource_ = first_counted_resource + problem_.counted.size();
  // (Where preferred parts count less, what is missing at a shop is no part of what is compared.)
  if (!prefers()) shops_.add_floors(first_counted_resource + problem_.counted.size(), solver_problem_);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    std::visit([&](auto& stage) { bars_->reprice(i, stage->change_tables()); }, entries_[i].stage);
    const std::vector<SlotTable>& tables = entries_[i].tables();
    const auto add = [&](const std::vector<PieceCount>& more) {
      counts[i].insert(counts[i].end(), more.begin(), more.end());
    };
    add(bars_->counts(i, tables));
    if (prefers()) add(compared_prices(catalogue_, prices, tables, *compared_resource_));
    if (!shops_.empty()) add(shops_.counts(tables));
    std::stable_sort(counts[i].begin(), counts[i].end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
    std::visit(
        [&](auto& stage) {
          stage->set_piece_counts(std::move(counts[i]));
          if (!shops_.empty()) stage->set_shops(shops_.slots(catalogue_, prices, tables));
        },
        entries_[i].stage);
  }
}

void MachineModel::set_suppliers(solver::Build& build) const {
  if (shops_.empty()) return;
  SlotShops::Set needed = 0;
  for (std::size_t stage = 0; stage < build.stages.size(); ++stage)
    for (std::size_t slot = 0; slot < build.stages[stage].rows.size(); ++slot)
      needed |= shops_.needed(candidate(stage, slot, build.stages[stage].rows[slot]));
  build.shared.resize(shop_choice);
  build.shared.push_back(needed);
}

void MachineModel::add_scenarios(const machine::Problem& given, const GivenSlots& given_slots) {
  machine::Problem problem = given;
  for (std::size_t i = 0; i < problem.axes.size(); ++i) {
    problem.axes[i].keep_every_candidate = problem_.axes[i].keep_every_candidate;
    problem.axes[i].keep_every_driver = problem_.axes[i].keep_every_driver;
    problem.axes[i].keep_covered_candidates = problem_.axes[i].keep_covered_candidates;
    problem.axes[i].most_covering = problem_.axes[i].most_covering;
    problem.axes[i].motor.currents = problem_.axes[i].motor.currents;
    problem.axes[i].motor.driver_currents = problem_.axes[i].motor.driver_currents;
  }
  problem.supply_voltages = problem_.supply_voltages;
  const ModelOptions same{.objectives = options_.objectives};
  std::vector<const solver::Problem*> versions{&solver_problem_};
  for (const auto& scenario : options_.scenarios) {
    scenarios_.push_back(std::make_unique<MachineModel>(problem, *scenario, given_slots, same));
    scenarios_.back()->solver_problem_.resources[cost_resource].limit = std::numeric_limits<double>::infinity();
    if (!same_candidates(scenarios_.back()->entries_, entries_))
      throw std::logic_error("versions of a machine with other candidates");
    versions.push_back(&scenarios_.back()->solver_problem_);
  }
  scenario_problem_.emplace(versions);
}

void MachineModel::fix() {
  const HeldParts held = hold_parts(*this, options_.fixed, {}, true);
  const std::vector<BomProblem> values = values_out_of_range(*this, options_.fixed);
  problems_.insert(problems_.end(), held.problems.begin(), held.problems.end());
  problems_.insert(problems_.end(), values.begin(), values.end());
  if (!problems_.empty()) return;
  restriction_ = restriction_of(*this, held);
  restricted_.emplace(searched_problem(), restriction_);
}

Candidate MachineModel::candidate(std::size_t stage, std::size_t slot, solver::Row row) const {
  return entries_[stage].tables()[slot].candidate(restricted_ ? restriction_.stages[stage].allowed[slot][row] : row);
}

std::vector<solver::Row> MachineModel::covering_rows(std::size_t stage, std::size_t slot, solver::Row row) const {
  const SlotTable& table = entries_[stage].tables()[slot];
  const auto covering = table.covered_by(restricted_ ? restriction_.stages[stage].allowed[slot][row] : row);
  if (!restricted_) return {covering.begin(), covering.end()};
  const std::vector<solver::Row>& allowed = restriction_.stages[stage].allowed[slot];
  std::vector<solver::Row> result;
  for (const solver::Row by : covering)
    if (const auto at = std::lower_bound(allowed.begin(), allowed.end(), by); at != allowed.end() && *at == by)
      result.push_back(static_cast<solver::Row>(at - allowed.begin()));
  return result;
}

std::optional<std::size_t> MachineModel::find_resource(machine::Quantity quantity) const {
  if (quantity == machine::Quantity::cost) return cost_resource;
  if (quantity == machine::Quantity::mass) return mass_resource;
  const auto found = std::find(problem_.counted.begin(), problem_.counted.end(), quantity);
  if (found == problem_.counted.end()) return std::nullopt;
  return first_counted_resource + static_cast<std::size_t>(found - problem_.counted.begin());
}

std::size_t MachineModel::resource(machine::Quantity quantity) const {
  const auto found = find_resource(quantity);
  if (!found)
    throw std::invalid_argument(fmt::format("the problem does not count {}", machine::declaration(quantity).name));
  return *found;
}

std::size_t MachineModel::compared(machine::Quantity quantity) const {
  return quantity == machine::Quantity::cost && prefers() ? *compared_resource_ : resource(quantity);
}

void MachineModel::add_axis(std::size_t index, const PriceBook& prices) {
  const machine::Axis& axis = problem_.axes[index];
  AxisPlace place;
  place.load_state = first_load_state + index;
  if (axis.carried_by) place.parent_load_state = first_load_state + *axis.carried_by;
  place.counted.cycle_time = find_resource(machine::Quantity::cycle_time);
  place.counted.energy = find_resource(machine::Quantity::energy);
  if (!problem_.tool || !problem_.tool->position_error)
    place.counted.position_error = find_resource(machine::Quantity::position_error);
  if (problem_.tool && !machine::is_rotary(axis)) {
    place.tool = machine::tool_place(problem_, index);
    place.states = tool_states(problem_);
  }
  if (axis.guide) place.carried_forces = machine::carried_forces(problem_, index);
  for (const std::size_t below : machine::carriers(problem_, index))
    if (below != index) place.lifting_acceleration += machine::climbing_acceleration(motion_of(problem_.axes[below]));
  for (StageEntry& entry :
       axis_stages(axis, place, problem_.supply_voltages, catalogue_, prices, solver_problem_.first_state))
    entries_.push_back(std::move(entry));
}

namespace {

EmptySlot empty_slot(const MachineModel& model, const std::string& axis, const SlotTable& table) {
  const std::string& slot = table.name();
  for (const machine::Axis& each : model.machine().axes)
    if (each.name == axis && slot == "motor") {
      const MotorShortage shortage = motor_shortage(model.catalogue(), each, model.machine().supply_voltages);
      return {axis, shortage.slot, shortage.reason};
    }
  if (std::string reason = short_bars(model, axis, slot); !reason.empty()) return {axis, slot, std::move(reason)};
  std::vector<std::string> lacking;
  for (const IncompleteParts& each : incomplete_parts(model.catalogue(), table))
    lacking.push_back(
        fmt::format("{} {} lack {}",
                    each.parts.size(),
                    each.family,
                    each.missing.empty() ? "a partner or a rate" : fmt::format("{}", fmt::join(each.missing, ", "))));
  return {axis,
          slot,
          fmt::format("no catalogue row fits what axis '{}' asks of its {}{}{}",
                      axis,
                      slot,
                      lacking.empty() ? "" : "; ",
                      fmt::join(lacking, ", "))};
}

}  // namespace

std::vector<EmptySlot> MachineModel::empty_slots() const {
  std::vector<EmptySlot> result;
  for (const StageEntry& entry : entries_)
    for (const SlotTable& table : entry.tables())
      if (table.rows() == 0) result.push_back(empty_slot(*this, entry.axis, table));
  for (const StageEntry& entry : entries_)
    if (const auto* member = std::get_if<std::unique_ptr<MemberStage>>(&entry.stage);
        member != nullptr && !(*member)->missing().empty())
      result.push_back({entry.axis, entry.element, (*member)->missing()});
  return result;
}

}  // namespace millwright::evaluation
