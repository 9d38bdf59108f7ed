// SPDX-License-Identifier: Apache-2.0
#include "evaluation/same_parts.h"

#include <algorithm>

#include "evaluation/machine_stages.h"

namespace millwright::evaluation {

bool same_candidate(const Candidate& a, const Candidate& b) {
  return a.form == b.form &&
         std::ranges::equal(a.parts,
                            b.parts,
                            [](const PartUse& x, const PartUse& y) {
                              return x.slot == y.slot && x.family == y.family && x.row == y.row && x.stated == y.stated;
                            }) &&
         std::ranges::equal(a.settings, b.settings);
}

namespace {

bool add_row_that_fits(const solver::Stage& stage,
                       std::span<const solver::Row> shared,
                       const std::vector<std::vector<solver::Row>>& lists,
                       std::vector<solver::Row>& chosen) {
  const std::size_t slot = chosen.size();
  if (slot == lists.size()) return true;
  for (const solver::Row row : lists[slot]) {
    bool fits = true;
    for (std::size_t other = 0; other < slot && fits; ++other)
      fits = stage.fits(shared, other, chosen[other], slot, row);
    if (!fits) continue;
    chosen.push_back(row);
    if (add_row_that_fits(stage, shared, lists, chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

}  // namespace

std::optional<std::vector<solver::Row>> rows_that_fit(const solver::Stage& stage,
                                                      std::span<const solver::Row> shared,
                                                      const std::vector<std::vector<solver::Row>>& lists) {
  std::vector<solver::Row> chosen;
  return add_row_that_fits(stage, shared, lists, chosen) ? std::optional(chosen) : std::nullopt;
}

bool same_candidates(const std::vector<StageEntry>& a, const std::vector<StageEntry>& b) {
  const auto same_table = [](const SlotTable& x, const SlotTable& y) {
    if (x.rows() != y.rows()) return false;
    for (std::size_t row = 0; row < x.rows(); ++row)
      if (!same_candidate(x.candidate(row), y.candidate(row))) return false;
    return true;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const StageEntry& x, const StageEntry& y) {
    return std::equal(x.tables().begin(), x.tables().end(), y.tables().begin(), y.tables().end(), same_table);
  });
}

std::optional<solver::Build> same_parts_in(const MachineModel& to,
                                           const MachineModel& from,
                                           const solver::Build& build) {
  if (to.entries().size() != from.entries().size() || !to.problems().empty() || !to.empty_slots().empty())
    return std::nullopt;
  solver::Build result = build;
  const double voltage = from.machine().supply_voltages[build.shared.front()];
  const auto& voltages = to.machine().supply_voltages;
  const auto found = std::find(voltages.begin(), voltages.end(), voltage);
  if (found == voltages.end()) return std::nullopt;
  result.shared.front() = static_cast<solver::Row>(found - voltages.begin());
  for (std::size_t stage = 0; stage < build.stages.size(); ++stage) {
    const solver::Stage& there = *to.problem().stages[stage];
    for (std::size_t slot = 0; slot < build.stages[stage].rows.size(); ++slot) {
      const Candidate& wanted = from.candidate(stage, slot, build.stages[stage].rows[slot]);
      const solver::Row count = there.slots()[slot].rows;
      solver::Row row = 0;
      while (row < count && !same_candidate(to.candidate(stage, slot, row), wanted)) ++row;
      if (row == count) return std::nullopt;
      result.stages[stage].rows[slot] = row;
    }
    const auto variables = there.variables();
    if (variables.size() != build.stages[stage].variables.size()) return std::nullopt;
    for (std::size_t v = 0; v < variables.size(); ++v)
      result.stages[stage].variables[v] =
          std::clamp(build.stages[stage].variables[v], variables[v].lower, variables[v].upper);
  }
  to.set_suppliers(result);
  return result;
}

}  // namespace millwright::evaluation
