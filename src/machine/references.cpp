// SPDX-License-Identifier: Apache-2.0
#include "machine/references.h"

#include <fmt/format.h>

namespace millwright::machine {

bool check_references(const Problem& problem, const catalogue::Catalogue& catalogue, text::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  const catalogue::Table& materials = catalogue.table(catalogue::Family::materials);
  for (const Axis& axis : problem.axes) {
    for (const Member& member : axis.members) {
      const catalogue::Found found = materials.find(member.material);
      if (found) continue;
      diagnostics.error(member.where,
                        fmt::format("axis '{}', {}: {}", axis.name, member.name, found.error),
                        found.hint.empty() ? "'millwright catalogue list materials' shows what there is" : found.hint);
    }
  }
  return diagnostics.error_count() == errors;
}

}  // namespace millwright::machine
