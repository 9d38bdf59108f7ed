// SPDX-License-Identifier: Apache-2.0
#include "evaluation/unmet_checks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>

#include "evaluation/machine_stages.h"
#include "evaluation/synthesis.h"

namespace millwright::evaluation {

using scalar::Interval;
using solver::Row;

namespace {

/// Declarations of the constraints that the search holds, in the order of a stage's utilisations.
std::vector<machine::Declaration> searched(const StageEntry& entry, const machine::Problem& problem) {
  const machine::Requirements* require = &problem.require;
  for (const machine::Axis& axis : problem.axes)
    if (axis.name == entry.axis) require = &axis.require;
  std::vector<machine::Declaration> result;
  std::visit(
      [&](const auto& stage) {
        using Kind = std::remove_cvref_t<decltype(*stage)>;
        auto collect = [&](const machine::Declaration& declaration, auto&&, auto&&, auto&&) {
          if (machine::is_searched(declaration, *require)) result.push_back(declaration);
        };
        constraints_of<Kind>()(collect);
      },
      entry.stage);
  return result;
}

/// All that one stage can be, with one supply voltage and every state that can reach it.
class StageBounds {
 public:
  StageBounds(const solver::Stage& stage, Row voltage, const std::vector<Interval>& inherited)
      : stage_(stage), shared_{voltage}, inherited_(inherited) {
    for (const solver::Slot& slot : stage.slots()) {
      all_.emplace_back(slot.rows);
      std::iota(all_.back().begin(), all_.back().end(), Row{0});
    }
    for (const std::vector<Row>& rows : all_) alive_.emplace_back(rows);
    for (const solver::Variable& variable : stage.variables()) variables_.emplace_back(variable.lower, variable.upper);
    stage.bound(box(), whole_);
  }

  [[nodiscard]] const std::vector<Interval>& handed_on() const { return whole_.handed_on; }

  /// Below which no utilisation comes: of all rows together, or of every row of the slot that says most.
  [[nodiscard]] std::vector<double> least() {
    std::vector<double> result;
    for (const Interval& u : whole_.utilisation) result.push_back(known(u.lower));
    solver::Answer<Interval> answer;
    for (std::size_t slot = 0; slot < all_.size(); ++slot) {
      std::vector<double> of_slot(result.size(), scalar::rounding::infinity);
      for (const Row& row : all_[slot]) {
        alive_[slot] = std::span<const Row>(&row, 1);
        stage_.bound(box(), answer);
        for (std::size_t i = 0; i < of_slot.size(); ++i)
          of_slot[i] = std::min(of_slot[i], known(answer.utilisation[i].lower));
      }
      alive_[slot] = all_[slot];
      for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::max(result[i], of_slot[i]);
    }
    return result;
  }

 private:
  /// What is not a number proves nothing.
  static double known(double lower) { return std::isnan(lower) ? 0.0 : lower; }
  [[nodiscard]] solver::Box box() const { return {shared_, inherited_, alive_, variables_}; }

  const solver::Stage& stage_;
  std::vector<Row> shared_;
  std::vector<Interval> inherited_;
  std::vector<std::vector<Row>> all_;
  std::vector<std::span<const Row>> alive_;
  std::vector<Interval> variables_;
  solver::Answer<Interval> whole_;
};

/// The least utilisations of every stage with one supply voltage.
std::vector<std::vector<double>> least_with(const MachineModel& model, Row voltage) {
  std::vector<Interval> state;
  for (const double x : model.problem().first_state) state.emplace_back(x);
  std::vector<std::vector<double>> result;
  for (const solver::Stage* stage : model.problem().stages) {
    StageBounds bounds(*stage, voltage, state);
    result.push_back(bounds.least());
    state = bounds.handed_on();
  }
  return result;
}

}  // namespace

std::vector<UnmetCheck> unmet_checks(const MachineModel& model) {
  std::vector<std::vector<double>> least;
  for (Row voltage = 0; voltage < model.machine().supply_voltages.size(); ++voltage) {
    std::vector<std::vector<double>> with = least_with(model, voltage);
    if (least.empty()) least = with;
    for (std::size_t i = 0; i < least.size(); ++i)
      for (std::size_t k = 0; k < least[i].size(); ++k) least[i][k] = std::min(least[i][k], with[i][k]);
  }
  std::vector<UnmetCheck> result;
  for (std::size_t i = 0; i < least.size(); ++i) {
    const StageEntry& entry = model.entries()[i];
    const std::vector<machine::Declaration> declarations = searched(entry, model.machine());
    for (std::size_t k = 0; k < least[i].size(); ++k)
      if (least[i][k] > 1.0)
        result.push_back({entry.axis,
                          entry.element,
                          std::string(declarations[k].id),
                          std::string(declarations[k].title),
                          std::string(declarations[k].requirement),
                          least[i][k]});
  }
  return result;
}

namespace {

using machine::Requirement;

/// Whether a check eases with the required position error of its axis.
bool is_position_error(const UnmetCheck& check) {
  constexpr std::string_view ids[] = {"C-ACC-TOTAL", "C-ACC-RES", "C-BS-LEAD", "C-BT-STIFF"};
  return std::find(std::begin(ids), std::end(ids), check.id) != std::end(ids);
}

class Watch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One attempt after the other: the required position errors of some axes times a factor.
class Relaxation {
 public:
  Relaxation(const MachineModel& model, const std::vector<UnmetCheck>& unmet, const SearchOptions& options, bool mapped)
      : model_(model), options_(options), problem_(model.machine()), mapped_(mapped) {
    options_.objectives = {"cost"};
    for (const UnmetCheck& check : unmet) relax(check.axis);
  }

  /// Not where everything is mapped already and the question is what can be had as made.
  [[nodiscard]] bool makes_sense() const { return mapped_ || !all_mapped_; }

  /// The cheapest build with errors of `factor` times those required; nothing if there is none, or time is up.
  std::optional<Design> solve(double factor) {
    machine::Problem changed = problem_;
    for (const std::size_t i : axes_)
      changed.axes[i].require.set(Requirement::position_error,
                                  factor * problem_.axes[i].require(Requirement::position_error));
    const MachineModel model(changed, model_.catalogue());
    SearchOptions options = options_;
    options.time_limit_seconds = std::max(0.0, options_.time_limit_seconds - watch_.seconds());
    Synthesis synthesis = synthesise(model, options);
    if (synthesis.status == solver::Status::limit) timed_out_ = true;
    if (synthesis.designs.empty() || timed_out_) return std::nullopt;
    return std::move(synthesis.designs.front());
  }

  [[nodiscard]] bool timed_out() const { return timed_out_; }

  [[nodiscard]] WayOut way_out(double factor, const Design& design) const {
    WayOut way;
    way.mapped = mapped_;
    way.least = !timed_out_;
    way.cost = design.cost;
    way.mass = design.mass;
    way.currency = design.currency;
    for (const std::size_t i : axes_) {
      const machine::Axis& axis = problem_.axes[i];
      const double from = axis.require(Requirement::position_error);
      way.changes.push_back({axis.name, from, factor * from, machine::accuracy_travel(axis.require, axis.stroke)});
    }
    return way;
  }

 private:
  void relax(const std::string& axis) {
    for (std::size_t i = 0; i < problem_.axes.size(); ++i) {
      if (problem_.axes[i].name != axis || std::count(axes_.begin(), axes_.end(), i) > 0) continue;
      axes_.push_back(i);
      machine::Requirements& require = problem_.axes[i].require;
      if (require.known(Requirement::mapped_lead_error)) continue;
      all_mapped_ = false;
      if (mapped_) require.set(Requirement::mapped_lead_error, machine::usual_mapped_lead_error);
    }
  }

  const MachineModel& model_;
  SearchOptions options_;
  machine::Problem problem_;
  bool mapped_;
  bool all_mapped_ = true;
  bool timed_out_ = false;
  std::vector<std::size_t> axes_;
  Watch watch_;
};

/// The least factor, to 1 %, at which something is compliant, and the cheapest build then. When time is up, the least
/// found so far.
std::optional<WayOut> least_relaxation(Relaxation& relaxation) {
  constexpr double precision = 1.01, hopeless = 1e3;
  double refused = 1.0, accepted = 1.0;
  std::optional<Design> design = relaxation.solve(accepted);
  for (double step = 1.25; !design; step *= step) {
    if (relaxation.timed_out() || accepted > hopeless) return std::nullopt;
    refused = accepted;
    accepted *= step;
    design = relaxation.solve(accepted);
  }
  while (accepted / refused > precision) {
    const double middle = std::sqrt(accepted * refused);
    std::optional<Design> found = relaxation.solve(middle);
    if (relaxation.timed_out()) break;
    (found ? accepted : refused) = middle;
    if (found) design = std::move(found);
  }
  return relaxation.way_out(accepted, *design);
}

}  // namespace

std::vector<WayOut> ways_out(const MachineModel& model,
                             const std::vector<UnmetCheck>& unmet,
                             const SearchOptions& options) {
  std::vector<WayOut> result;
  if (unmet.empty() || !std::all_of(unmet.begin(), unmet.end(), is_position_error)) return result;
  const Watch watch;
  for (const bool mapped : {false, true}) {
    SearchOptions left = options;
    left.time_limit_seconds = std::max(0.0, options.time_limit_seconds - watch.seconds());
    Relaxation relaxation(model, unmet, left, mapped);
    if (!relaxation.makes_sense()) continue;
    if (auto way = least_relaxation(relaxation)) result.push_back(std::move(*way));
  }
  return result;
}

}  // namespace millwright::evaluation
