// SPDX-License-Identifier: Apache-2.0
#include "report/alternatives.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/design_difference.h"
#include "report/design_json.h"
#include "report/design_text.h"

namespace millwright::report {

using evaluation::Design;

namespace {

/// Several builds were asked for.
bool asked(const MachineResult& result) { return result.builds_asked > 1 && !result.designs.empty(); }

const char* best_word(const MachineResult& result) {
  return result.objectives.front() == "mass" ? "lightest" : "cheapest";
}

const char* better_word(const MachineResult& result) {
  return result.objectives.front() == "mass" ? "lighter" : "cheaper";
}

/// Other parts and settings, and the same parts bought elsewhere.
std::vector<DesignDifference> changes_from(const Design& best, const Design& design) {
  std::vector<DesignDifference> changes = differences(best, design);
  const std::vector<DesignDifference> bought = purchase_differences(best, design);
  changes.insert(changes.end(), bought.begin(), bought.end());
  return changes;
}

}  // namespace

std::string alternatives_text(const MachineResult& result, const Style& style) {
  if (!asked(result)) return {};
  const Design& best = result.designs.front();
  std::string out = style.heading("Alternatives") + "\n";
  if (result.designs.size() == 1)
    return out + (result.status == Status::limit ? "  None was found before the search was ended.\n\n"
                                                 : "  There is no other compliant build.\n\n");
  TextTable table({{"", Align::right},
                   {best.currency, Align::right},
                   {"", Align::right},
                   {"kg", Align::right},
                   {"", Align::right},
                   {"differs from the best in", Align::left, 64}});
  for (std::size_t i = 1; i < result.designs.size(); ++i) {
    const Design& design = result.designs[i];
    std::vector<std::string> changes;
    for (const DesignDifference& d : changes_from(best, design))
      changes.push_back(fmt::format("{}.{} {} (was {})", d.axis, d.slot, d.short_now, d.short_before));
    table.add({fmt::format("{}{}", i + 1, i < result.proved ? "" : "?"),
               fmt::format("{:.2f}", design.cost),
               signed_text(design.cost - best.cost, 2),
               fmt::format("{:.3f}", design.mass),
               signed_text(design.mass - best.mass, 3),
               fmt::format("{}", fmt::join(changes, ", "))});
  }
  out += table.str(2, style);
  if (result.proved < result.designs.size())
    out += fmt::format("  ? found before the search was ended; {} ones may exist\n", better_word(result));
  return out + "\n";
}

std::string alternatives_certificate(const MachineResult& result, const Texts& t) {
  if (!asked(result)) return {};
  const std::size_t found = result.designs.size();
  if (result.status == Status::limit)
    return fmt::format(fmt::runtime(t("certificate.some")), result.builds_asked, result.proved);
  if (found >= result.builds_asked) {
    const std::string best = fmt::format(fmt::runtime(t(fmt::format("certificate.{}", best_word(result)))), found);
    if (!preference_counts(result)) return best;
    return best + " " + fmt::format(fmt::runtime(t("certificate.preferred")), preference_divisor(result));
  }
  return found == 1 ? t("certificate.one_build") : fmt::format(fmt::runtime(t("certificate.few_builds")), found);
}

void add_alternatives(const MachineResult& result, Json& json) {
  if (!asked(result)) return;
  const Design& best = result.designs.front();
  json["builds_asked"] = result.builds_asked;
  json["builds_proved"] = result.proved;
  json["alternatives"] = Json::array();
  for (std::size_t i = 1; i < result.designs.size(); ++i) {
    const Design& design = result.designs[i];
    Json changes = Json::array();
    for (const DesignDifference& d : changes_from(best, design))
      changes.push_back({{"axis", d.axis}, {"name", d.slot}, {"now", d.short_now}, {"before", d.short_before}});
    json["alternatives"].push_back({{"rank", i + 1},
                                    {"proved", i < result.proved},
                                    {"totals", totals_of(design)},
                                    {"changes", changes},
                                    {"build", build_of(design)},
                                    {"governing", governing_of(result, design)},
                                    {"checks", checks_json(result, design)}});
  }
}

}  // namespace millwright::report
