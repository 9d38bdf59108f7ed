// SPDX-License-Identifier: Apache-2.0
#include "evaluation/ledger.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/bill_ledger.h"
#include "evaluation/drive_drawing.h"
#include "evaluation/machine_model.h"
#include "evaluation/machine_stages.h"
#include "evaluation/motor_torque.h"
#include "evaluation/outside_validity.h"
#include "evaluation/traced_elements.h"
#include "machine/axis_motion.h"
#include "scalar/unit.h"

namespace millwright::evaluation {

using machine::Applies;
using machine::ConstraintKind;
using machine::WorstPhase;

bool Design::satisfied() const {
  return std::none_of(checks.begin(), checks.end(), [](const Check& c) {
    return c.kind != ConstraintKind::soft && c.verdict == Verdict::violated;
  });
}

double Design::total(machine::Quantity quantity) const {
  if (quantity == machine::Quantity::cost) return cost;
  if (quantity == machine::Quantity::mass) return mass;
  for (const CountedTotal& each : counted)
    if (each.quantity == quantity) return each.value;
  return std::numeric_limits<double>::quiet_NaN();
}

double Design::total(const machine::Objective& objective) const {
  double sum = 0.0;
  for (const machine::ObjectiveTerm& term : objective.terms) sum += term.weight * total(term.quantity);
  return sum;
}

double Design::compared(const machine::Objective& objective) const {
  double sum = total(objective);
  for (const machine::ObjectiveTerm& term : objective.terms)
    if (term.quantity == machine::Quantity::cost && preference) sum += term.weight * (preference->compared_cost - cost);
  return sum;
}

const Check* Design::governing(const std::string& axis) const {
  const Check* worst = nullptr;
  for (const Check& check : checks)
    if (check.axis == axis && check.kind == ConstraintKind::hard &&
        (worst == nullptr || check.utilisation > worst->utilisation))
      worst = &check;
  return worst;
}

namespace {

template <class Element>
concept HasPhases = requires(const Element& e) {
  e.torque_ratios;
};

template <class Element>
concept HasCarriages = requires(const Element& e) {
  e.carriage_loads;
};

template <class Element>
concept HasMotor = requires(const Element& e) {
  e.motor.rated_current;
};

/// Whether a quantity is largest under the force at which the axis stands (machine::standing_load).
template <class Element>
bool stands_at_worst(const Element& element, WorstPhase worst) {
  if (!(element.cycle.standing_force > 0.0)) return false;
  if (worst == WorstPhase::force) return element.largest_force > element.driven_force;
  if (worst == WorstPhase::output_torque) return element.standing_torque >= element.output_torque;
  return false;
}

/// The phase in which the quantity of a constraint is largest, or what of the cycle it is about.
template <class Element>
std::string worst_phase(const Element& element, WorstPhase worst) {
  if (worst == WorstPhase::cycle) return "whole cycle";
  if (worst == WorstPhase::steady) return "constant speed";
  if (worst == WorstPhase::standstill) return "standstill";
  const auto of_largest = [&](const std::vector<double>& values) -> std::string {
    const auto best =
        std::max_element(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    if constexpr (HasCarriages<Element> || HasPhases<Element>) {
      if (best != values.end())
        return machine::phase_names(element.data->motion)[static_cast<std::size_t>(best - values.begin())];
    }
    return {};
  };
  if constexpr (HasCarriages<Element>) {
    if (worst == WorstPhase::load) return of_largest(element.carriage_loads);
  }
  if constexpr (HasPhases<Element>) {
    if (stands_at_worst(element, worst)) return "standstill";
    if (worst == WorstPhase::force || worst == WorstPhase::driven_force) return of_largest(element.axial_forces);
    if (worst == WorstPhase::torque || worst == WorstPhase::output_torque) return of_largest(element.motor_torques);
    if (worst == WorstPhase::torque_ratio) return of_largest(element.torque_ratios);
    if (worst == WorstPhase::speed) return of_largest(element.angular_speeds);
  }
  return {};
}

/// The position that the formula of a constraint takes, in words.
template <class Element>
std::string worst_position(const Element& element, machine::WorstPlace place) {
  using machine::WorstPlace;
  bool both_ends_fixed = false;
  constexpr bool has_nut = requires { element.data->both_ends_fixed; };
  if constexpr (has_nut) both_ends_fixed = element.data->both_ends_fixed;
  auto held = machine::BeamSupport::supported;
  if constexpr (requires { element.data->member.support; }) held = element.data->member.support;
  const bool cantilever = held == machine::BeamSupport::cantilever;
  switch (place) {
    case WorstPlace::nut_far:
      return has_nut ? "nut farthest from the fixed bearing" : "";
    case WorstPlace::nut_softest:
      return !has_nut ? "" : both_ends_fixed ? "nut between the bearings" : "nut farthest from the fixed bearing";
    case WorstPlace::long_belt:
      return "longest free belt";
    case WorstPlace::drive_pulley:
      return "carriage at the drive pulley";
    case WorstPlace::mid_span:
      return cantilever ? "tip" : "mid-span";
    case WorstPlace::most_bent:
      if (held == machine::BeamSupport::fixed) return "clamp, load at a third of the span";
      return cantilever ? "clamp" : "mid-span";
    case WorstPlace::travel_ends:
      return "every axis at the end of its travel";
    case WorstPlace::none:
      break;
  }
  return {};
}

/// The contributions to an error budget, in the unit of the check.
template <class Element>
std::vector<Contribution> contributions(const Element& element, std::string_view id, const scalar::Unit& unit) {
  std::vector<Contribution> result;
  if constexpr (requires { error_budget(element); }) {
    if (id == "C-ACC-TOTAL" || id == "C-ROT-TOTAL")
      error_budget(element).visit([&](std::string_view what, double error) {
        result.push_back({std::string(what), unit.from_si(error)});
      });
  }
  return result;
}

template <class Element>
class CheckVisitor {
 public:
  CheckVisitor(const Element& element, const StageEntry& entry, std::vector<Check>& out, ValidityLedger& outside)
      : element_(element), entry_(entry), out_(out), outside_(outside) {}

  template <class When, class Demand, class Capacity>
  void operator()(const machine::Declaration& declaration, When when, Demand demand, Capacity capacity) {
    if (when(element_) != Applies::yes) return;
    mechanics::ValidityWatch watch;
    const double value = demand(element_);
    const double limit = capacity(element_);
    outside_.take(watch, entry_.axis, entry_.element, declaration.id);
    add(declaration, value, limit);
  }

 private:
  void add(const machine::Declaration& declaration, double value, double limit) {
    Check check;
    check.axis = entry_.axis;
    check.element = entry_.element;
    check.id = declaration.id;
    check.title = declaration.title;
    check.symbol = declaration.symbol;
    const bool enforced = declaration.kind == ConstraintKind::soft && element_.data->require.enforces(declaration.id);
    check.kind = enforced ? ConstraintKind::hard : declaration.kind;
    check.unit = declaration.unit;
    check.source = declaration.source;
    if constexpr (HasMotor<Element>)
      check.requirement = machine::limiting_requirement(element_, declaration);
    else
      check.requirement = declaration.requirement;
    std::string reason;
    const auto unit = scalar::Unit::parse(declaration.unit, reason);
    check.value = unit ? unit->from_si(value) : value;
    check.limit = unit ? unit->from_si(limit) : limit;
    const bool known = !std::isnan(value) && !std::isnan(limit);
    const double most = declaration.held_by_limit ? 1.0 + 2.0 * rounding_of_totals : 1.0;
    check.utilisation = known ? utilisation(value, limit) : std::numeric_limits<double>::quiet_NaN();
    check.verdict = !known                      ? Verdict::not_evaluated
                    : check.utilisation <= most ? Verdict::satisfied
                                                : Verdict::violated;
    if (enforced && !known) {
      check.verdict = Verdict::violated;
      check.note = "enforced, and a figure of a part is missing";
    }
    check.phase = worst_phase(element_, declaration.worst);
    check.position = worst_position(element_, declaration.place);
    if (unit) check.contributions = contributions(element_, declaration.id, *unit);
    out_.push_back(std::move(check));
  }

  const Element& element_;
  const StageEntry& entry_;
  std::vector<Check>& out_;
  ValidityLedger& outside_;
};

/// How many drives, each with its motor, an axis has.
std::size_t drives_of(const machine::Problem& problem, const std::string& axis) {
  for (const machine::Axis& each : problem.axes)
    if (each.name == axis) return static_cast<std::size_t>(each.mechanism.drives);
  return 0;
}

/// What the drives before the supply ask of it.
struct DriveInputs {
  std::vector<double> motor_currents;
  std::vector<std::pair<std::string, double>> powers;

  template <class Drive>
  void take(const machine::Problem& problem, const std::string& axis, const Drive& drive) {
    const std::size_t drives = drives_of(problem, axis);
    motor_currents.insert(motor_currents.end(), drives, drive.motor.rated_current);
    powers.insert(powers.end(), drives, {axis, drive.input_power});
  }
  void give(Supply<double>& supply) const {
    supply.motor_currents = motor_currents;
    supply.drive_powers = powers;
  }
};

/// Speed [rad/s] and available torque [N.m] of a motor in the phase that asks for most of the torque that is there; 0
/// for what has no motor.
struct GoverningPhase {
  double speed = 0.0, available = 0.0;
};

template <class Element>
GoverningPhase governing_phase(const Element& element) {
  if constexpr (HasMotor<Element>) {
    const auto worst = std::max_element(element.torque_ratios.begin(), element.torque_ratios.end());
    if (worst != element.torque_ratios.end()) {
      const double speed = element.angular_speeds[static_cast<std::size_t>(worst - element.torque_ratios.begin())];
      return {speed, element.available_torque(speed)};
    }
  }
  return {};
}

/// Marks a motor, and the torque checks, whose torque at speed is the winding model's and not a published curve's.
template <class DriveStage>
void mark_estimated_torque(const DriveStage& stage,
                           const solver::StageChoice& choice,
                           solver::Row voltage,
                           const GoverningPhase& governing,
                           Design& design) {
  const auto origin = torque_origin(
      stage.motors().pairs()[choice.rows[DriveStage::motor_slot]], voltage, governing.speed, governing.available);
  if (origin == TorqueOrigin::published) return;
  const std::string axis = stage.name().substr(0, stage.name().find('.'));
  for (PartLine& part : design.parts)
    if (part.axis == axis && part.slot == "motor") part.estimate = true;
  for (Check& check : design.checks)
    if (check.axis == axis && check.id == "C-ST-TORQUE") {
      check.note = note_of(origin);
      if (origin != TorqueOrigin::bounded)
        check.requirement =
            machine::requirements()[static_cast<std::size_t>(stage.data().require.margin_of_model())].key;
    }
}

/// The element of a stage; what its formulas leave of their ranges goes into the ledger. A screw's readings come from a
/// table that was filled long before: here they are made once more.
template <class Stage>
auto watched_element(const Stage& stage,
                     const Selection<double>& selection,
                     const StageEntry& entry,
                     ValidityLedger& outside) {
  mechanics::ValidityWatch watch;
  auto element = stage.template design<double>(selection);
  if constexpr (std::is_same_v<Stage, ScrewDriveStage>)
    (void)stage.reading_anew(selection.rows[ScrewDriveStage::screw_slot].front());
  outside.take(watch, entry.axis, entry.element, {});
  return element;
}

/// The calculation of an element, and what is drawn of it if it is a drive.
template <class Stage, class Element>
void add_worksheet(const Stage& stage,
                   const Element& element,
                   const StageEntry& entry,
                   const ChosenRows& chosen,
                   Worksheet& worksheet) {
  ElementWorksheet sheet{entry.axis, entry.element, {}, {}, {}};
  if constexpr (HasPhases<Element>) {
    write_calculation(stage, element, chosen, sheet);
    worksheet.drives.push_back(drawing_of(element, entry.axis));
    const MotorPair& motor = stage.motors().pairs()[chosen.rows[Stage::motor_slot]];
    worksheet.drives.back().torque_is_estimate = motor.curve_at(chosen.voltage) == nullptr;
    worksheet.drives.back().motor_size = motor.frame_size;
  } else {
    write_calculation(element, sheet);
  }
  worksheet.elements.push_back(std::move(sheet));
}

std::string unit_of_variable(const std::string& name) { return name == "acceleration_time" ? "s" : "m"; }

void add_dimensions(const StageEntry& entry, const solver::StageChoice& choice, Design& design) {
  const std::string prefix = entry.element == "drive" ? "" : entry.element + ".";
  std::size_t v = 0;
  for (const solver::Variable& each : entry.as_stage().variables())
    design.dimensions.push_back({entry.axis, prefix + each.name, choice.variables[v++], unit_of_variable(each.name)});
}

void state_voltage(double voltage, Design& design) {
  design.supply_voltage = voltage;
  design.dimensions.push_back({"machine", "supply_voltage", voltage, "V"});
}

void name_currency(Design& design) {
  for (Check& check : design.checks)
    if (check.id == "C-SYS-COST") check.unit = design.currency;
}

}  // namespace

Design MachineModel::design(const solver::Build& found, bool with_worksheet) const {
  const solver::Build build = whole_build(found);
  Design design;
  design.currency = problem_.currency;
  for (const machine::Quantity quantity : problem_.counted) design.counted.push_back({quantity, 0.0});
  if (prefers()) design.preference = {*problem_.preference, 0.0};
  const solver::Row voltage = build.shared.empty() ? 0 : build.shared.front();
  state_voltage(problem_.supply_voltages[voltage], design);
  std::vector<double> state = solver_problem_.first_state;
  DriveInputs inputs;
  ValidityLedger outside;
  BillLedger bill(*this, build, counted_parts_, shops_, design);
  const auto worksheet = with_worksheet ? std::make_shared<Worksheet>() : nullptr;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const StageEntry& entry = entries_[i];
    const solver::StageChoice& choice = build.stages[i];
    std::vector<RowsAlive> rows;
    for (const solver::Row& row : choice.rows) rows.emplace_back(std::span(&row, 1));
    const Selection<double> selection{
        .shared = build.shared, .rows = rows, .inherited = state, .variables = choice.variables};
    solver::Answer<double> answer;
    entry.as_stage().evaluate({build.shared, state, choice.rows, choice.variables}, answer);
    GoverningPhase governing;
    for (CountedTotal& each : design.counted) each.value += answer.resources[resource(each.quantity)];
    std::visit(
        [&](const auto& stage) {
          using Kind = std::remove_cvref_t<decltype(*stage)>;
          auto element = watched_element(*stage, selection, entry, outside);
          if constexpr (HasMotor<decltype(element)>) inputs.take(problem_, entry.axis, element);
          governing = governing_phase(element);
          if constexpr (std::is_same_v<Kind, SupplyStage>) inputs.give(element);
          if constexpr (std::is_same_v<Kind, WholeStage>) {
            bill.charge_orders();
            for (const auto& each : machine::quantities())
              element.totals[static_cast<std::size_t>(each.quantity)] = design.total(each.quantity);
          }
          CheckVisitor visitor(element, entry, design.checks, outside);
          constraints_of<Kind>()(visitor);
          if constexpr (std::is_same_v<Kind, WholeStage>) name_currency(design);
          if (worksheet) add_worksheet(*stage, element, entry, {choice.rows, voltage}, *worksheet);
          if constexpr (std::is_same_v<Kind, MemberStage>) {
            if (stage->tables().empty()) bill.add_custom_member(entry, element);
          }
        },
        entry.stage);
    bill.add_parts(entry, choice.rows);
    add_dimensions(entry, choice, design);
    std::visit(
        [&](const auto& stage) {
          if constexpr (requires { stage->motors(); })
            mark_estimated_torque(*stage, choice, voltage, governing, design);
          if constexpr (requires { stage->tell_flange(selection, answer.handed_on); })
            stage->tell_flange(selection, answer.handed_on);
        },
        entry.stage);
    state = answer.handed_on;
  }
  bill.finish();
  outside.write(design);
  design.worksheet = worksheet;
  return design;
}

}  // namespace millwright::evaluation
