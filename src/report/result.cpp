// SPDX-License-Identifier: Apache-2.0
#include "report/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "report/quantity_text.h"
#include "scalar/unit.h"

namespace millwright::report {

const char* to_string(Status status) {
  switch (status) {
    case Status::optimal:
      return "optimal";
    case Status::infeasible:
      return "infeasible";
    case Status::limit:
      return "limit";
  }
  return "";
}

bool preference_counts(const MachineResult& result) {
  return !result.designs.empty() && result.designs.front().preference &&
         std::any_of(result.objectives.begin(), result.objectives.end(), [](const std::string& name) {
           const auto terms = machine::objective_named(name).terms;
           return std::any_of(terms.begin(), terms.end(), [](const machine::ObjectiveTerm& term) {
             return term.quantity == machine::Quantity::cost;
           });
         });
}

std::string preference_divisor(const MachineResult& result) {
  return fmt::format("{:.4g}", 1.0 + result.designs.front().preference->premium);
}

bool best_is_proved(const MachineResult& result) { return result.status == Status::optimal || result.proved > 0; }

std::optional<std::string> proof_gap(const MachineResult& result) {
  constexpr double rounding = 1e-5;  // the usual gap is 1e-6
  if (result.designs.empty() || result.objectives.size() != 1 || !best_is_proved(result) || !(result.gap > rounding))
    return {};
  return percent_rounded_up(result.gap, 3);
}

std::vector<RequirementLine> used_requirements(const machine::Problem& problem, const evaluation::Design& design) {
  std::set<std::pair<std::string, std::string>> used;
  const auto braked = [&](const std::string& name) {
    return std::any_of(problem.axes.begin(), problem.axes.end(), [&](const machine::Axis& axis) {
      return axis.name == name && axis.motor.brake_torque > 0.0;
    });
  };
  const auto turns = [&](const evaluation::Check& check) {
    for (const machine::Axis& axis : problem.axes)
      for (const machine::Member& member : axis.members)
        if (axis.name == check.axis && member.name == check.element) return member.rotating;
    return false;
  };
  for (const evaluation::Check& check : design.checks) {
    if (!check.requirement.empty()) used.insert({check.requirement, check.axis});
    if (check.id == "C-SH-DIAM" && turns(check)) {
      used.insert({"shaft_bending_factor", check.axis});
      used.insert({"shaft_torsion_factor", check.axis});
    }
    // A limit may be the larger of two that need different factors: the calculation has both.
    if (check.requirement == "brake_factor")
      used.insert({check.id == "C-SCR-LOCK" ? "self_locking_factor" : "detent_factor", check.axis});
    if ((check.requirement == "detent_factor" || check.requirement == "self_locking_factor") && braked(check.axis))
      used.insert({"brake_factor", check.axis});
  }
  std::vector<RequirementLine> lines;
  for (const machine::RequirementDeclaration& declared : machine::requirements()) {
    const std::size_t first = lines.size();
    for (const machine::Axis& axis : problem.axes) {
      const std::string key(declared.key);
      if ((used.count({key, axis.name}) == 0 && used.count({key, "machine"}) == 0) ||
          !axis.require.known(declared.requirement))
        continue;
      const double value = axis.require(declared.requirement);
      const bool given = axis.require.given(declared.requirement);
      const auto same = std::find_if(
          lines.begin() + static_cast<std::ptrdiff_t>(first), lines.end(), [&](const RequirementLine& line) {
            return line.value == value && line.given == given;
          });
      if (same != lines.end())
        same->axes.push_back(axis.name);
      else
        lines.push_back({{axis.name},
                         key,
                         value,
                         std::string(declared.unit),
                         given,
                         std::string(declared.meaning),
                         std::string(declared.source)});
    }
  }
  return lines;
}

std::string shown_value(const RequirementLine& line) {
  const scalar::Unit declared = scalar::Unit::of(line.unit);
  const bool scaled = line.unit == "s" || line.unit == "m" || line.unit == "Pa";
  if (line.unit == "rad") return scalar::format(line.value, scalar::Unit::of("deg"));
  return scalar::format(line.value, scaled ? scalar::readable_unit(declared.dimension(), line.value) : declared);
}

std::vector<const evaluation::Check*> checks_of(const evaluation::Design& design, const std::string& axis) {
  std::vector<const evaluation::Check*> checks;
  for (const evaluation::Check& check : design.checks)
    if (check.axis == axis) checks.push_back(&check);
  std::stable_sort(checks.begin(), checks.end(), [](const evaluation::Check* a, const evaluation::Check* b) {
    const bool a_open = a->verdict == evaluation::Verdict::not_evaluated;
    const bool b_open = b->verdict == evaluation::Verdict::not_evaluated;
    if (a_open || b_open) return !a_open && b_open;
    return a->utilisation > b->utilisation;
  });
  return checks;
}

std::vector<std::string> checked_axes(const MachineResult& result) {
  std::vector<std::string> axes = result.axes;
  axes.emplace_back("machine");
  if (result.designs.empty()) return axes;
  const auto has_none = [&](const std::string& axis) { return checks_of(result.designs.front(), axis).empty(); };
  axes.erase(std::remove_if(axes.begin(), axes.end(), has_none), axes.end());
  return axes;
}

}  // namespace millwright::report
