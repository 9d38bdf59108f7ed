// SPDX-License-Identifier: Apache-2.0
#include "evaluation/build_identity.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "evaluation/counted_parts.h"

namespace millwright::evaluation {

std::string build_identity(const MachineModel& model, const solver::Build& build) {
  CountedPartsLedger counted(model.counted_parts());
  std::vector<Candidate> candidates;
  for (std::size_t stage = 0; stage < build.stages.size(); ++stage)
    for (std::size_t slot = 0; slot < build.stages[stage].rows.size(); ++slot) {
      candidates.push_back(model.candidate(stage, slot, build.stages[stage].rows[slot]));
      for (const PartUse& use : candidates.back().parts) counted.take(use);
    }
  std::string identity = fmt::format("{}\n", build.shared.empty() ? solver::Row{0} : build.shared.front());
  std::map<std::pair<catalogue::Family, int>, double> bought;
  for (const Candidate& candidate : candidates) {
    identity += parts_name(model.catalogue(), candidate) + "\n";
    for (const PartUse& use : candidate.parts) {
      if (!use.stated.empty()) continue;
      if (use.length > 0.0) {  // nobody owns cut pieces, and which of them is ordered where is another order
        identity += fmt::format("{}\n", use.row);
        continue;
      }
      const double pieces = use.pieces() - counted.share(use).owned;
      if (pieces > 0.0) bought[{use.family, use.row}] += pieces;
    }
  }
  for (const auto& [part, pieces] : bought)
    identity += fmt::format("{} {} {}\n", static_cast<int>(part.first), part.second, pieces);
  return identity;
}

}  // namespace millwright::evaluation
