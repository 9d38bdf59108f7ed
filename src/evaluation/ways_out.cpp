// SPDX-License-Identifier: Apache-2.0
#include "evaluation/ways_out.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "evaluation/synthesis.h"
#include "machine/error_budget.h"

namespace millwright::evaluation {

namespace {

using machine::Requirement;

/// Whether a check eases with the required position error of its axis.
bool is_position_error(const UnmetCheck& check) {
  constexpr std::string_view ids[] = {"C-ACC-TOTAL", "C-ACC-RES", "C-BS-LEAD", "C-BT-STIFF"};
  return std::find(std::begin(ids), std::end(ids), check.id) != std::end(ids);
}

/// One attempt after the other: the required position errors of some axes times a factor.
class Loosening {
 public:
  Loosening(const MachineModel& model, const std::vector<UnmetCheck>& unmet, const SearchOptions& options, bool mapped)
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
    SearchOptions options = options_;
    ModelOptions of_model = model_.options();
    of_model.objectives = options.objectives;
    const MachineModel model(changed, model_.catalogue(), {}, of_model);
    options.time_limit_seconds = std::max(0.0, options_.time_limit_seconds - spent_);
    Synthesis synthesis = synthesise(model, options);
    spent_ += synthesis.seconds;
    if (synthesis.status == solver::Status::limit) timed_out_ = true;
    if (synthesis.designs.empty() || timed_out_) return std::nullopt;
    return std::move(synthesis.designs.front());
  }

  [[nodiscard]] bool timed_out() const { return timed_out_; }
  [[nodiscard]] double spent() const { return spent_; }

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
  double spent_ = 0.0;  ///< s, on solving
  std::vector<std::size_t> axes_;
};

/// The least factor, to 1 %, at which something is compliant, and the cheapest build then. When time is up, the least
/// found so far.
std::optional<WayOut> least_relaxation(Loosening& relaxation) {
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
  SearchOptions left = options;
  for (const bool mapped : {false, true}) {
    Loosening relaxation(model, unmet, left, mapped);
    if (!relaxation.makes_sense()) continue;
    if (auto way = least_relaxation(relaxation)) result.push_back(std::move(*way));
    left.time_limit_seconds = std::max(0.0, left.time_limit_seconds - relaxation.spent());
  }
  return result;
}

}  // namespace millwright::evaluation
