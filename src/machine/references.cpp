// SPDX-License-Identifier: Apache-2.0
#include "machine/references.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "text/nearest.h"

namespace millwright::machine {

namespace {

/// Words that choose among the screws must each choose one.
void check_screws(const Axis& axis,
                  const Member& member,
                  const char* key,
                  const char* column,
                  const std::vector<std::string>& words,
                  const catalogue::Table& screws,
                  text::Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (int row = 0; row < screws.rows(); ++row)
    known.emplace_back(screws.text(catalogue::column(catalogue::Family::screws, column), row));
  for (const std::string& word : words) {
    if (std::find(known.begin(), known.end(), word) != known.end()) continue;
    diagnostics.error(
        member.where,
        fmt::format(
            "axis '{}', {}: {}: no screw {} in the catalogues", axis.name, member.name, key, text::quoted(word)),
        text::did_you_mean(word, known, "'millwright catalogue list screws' shows what there is"));
  }
}

}  // namespace

bool check_references(const Problem& problem, const catalogue::Catalogue& catalogue, text::Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  const catalogue::Table& materials = catalogue.table(catalogue::Family::materials);
  for (const Axis& axis : problem.axes) {
    for (const Member& member : axis.members) {
      if (member.kind == MemberKind::bolts) {  // screws bring their own material
        const catalogue::Table& screws = catalogue.table(catalogue::Family::screws);
        const BoltPattern& bolts = member.bolts;
        check_screws(axis, member, "sizes", "designation", bolts.sizes, screws, diagnostics);
        check_screws(axis, member, "property_classes", "property_class", bolts.property_classes, screws, diagnostics);
        continue;
      }
      const catalogue::Found found = materials.find(member.material);
      if (found) continue;
      diagnostics.error(member.where,
                        fmt::format("axis '{}', {}: {}", axis.name, member.name, found.error),
                        found.hint.empty() ? "'millwright catalogue list materials' shows what there is" : found.hint);
    }
  }
  for (const catalogue::Supplier& supplier : catalogue.suppliers().suppliers) {
    if (!supplier.charges() || supplier.currency == problem.currency || problem.currencies.contains(supplier.currency))
      continue;
    diagnostics.error(
        supplier.where,
        fmt::format(
            "the problem gives no rate for {}, in which {} charges", supplier.currency, text::quoted(supplier.name)),
        fmt::format("add it to [currency]: {} = 1.1", supplier.currency));
  }
  return diagnostics.error_count() == errors;
}

}  // namespace millwright::machine
