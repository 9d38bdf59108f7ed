// SPDX-License-Identifier: Apache-2.0
#include "report/certificate_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/alternatives.h"
#include "report/incomplete.h"
#include "report/machine_text.h"
#include "report/quantity_text.h"
#include "report/tolerance_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Design;

namespace {

/// "is cheaper"
std::string better_words(const std::string& objective, const Texts& t) {
  const auto quantity = machine::objective_named(objective).single();
  return quantity ? t("certificate.better." + std::string(machine::declaration(*quantity).name))
                  : fmt::format(fmt::runtime(t("certificate.better.sum")), objective);
}

/// What preferred parts cost more than the best build without regard to them, as far as that is proved: no build costs
/// less than the bound of what was compared.
std::string premium_text(const MachineResult& result, const Texts& t) {
  const Design& design = result.designs.front();
  // What is proved is about builds that are compliant with every tolerance, not about the cheapest of all.
  if (!best_is_proved(result) || result.robust || result.objectives.front() != "cost")
    return fmt::format(fmt::runtime(t("certificate.preferred")), preference_divisor(result));
  const double more = design.cost - std::min(design.preference->compared_cost, result.lower_bound);
  constexpr double shown = 0.005;  // less is printed as nothing
  return more >= shown
             ? fmt::format(fmt::runtime(t("certificate.premium")), fmt::format("{:.2f} {}", more, design.currency))
             : t("certificate.no_premium");
}

}  // namespace

std::string certificate_text(const MachineResult& result, const Style& style, const Texts& t) {
  const Certificate& certificate = result.certificate;
  std::string out = style.heading(t("certificate")) + "\n";
  const auto fill = [&](const char* key, auto&&... values) { return fmt::format(fmt::runtime(t(key)), values...); };
  const auto line = [&](const std::string& text) { out += "  " + wrapped(text, style.width - 2, 2) + "\n"; };
  const Design* design = result.designs.empty() ? nullptr : &result.designs.front();
  const bool preferred = preference_counts(result);
  const std::string divisor = preferred ? preference_divisor(result) : std::string();
  if (result.status == Status::infeasible) {
    line(t(result.robust ? "certificate.none_robust" : "certificate.none"));
  } else if (result.objectives.size() == 1 && design != nullptr) {
    const std::string& objective = result.objectives.front();
    std::string better = better_words(objective, t);
    if (preferred) better = fill("certificate.divided", better, divisor);
    if (const auto gap = proof_gap(result)) better = fill("certificate.within", better, *gap);
    line(best_is_proved(result) ? fill(robust_to_something(result) ? "certificate.best_robust"
                                       : result.steering.empty()   ? "certificate.best"
                                                                   : "certificate.best_asked",
                                       better)
                                : fill("certificate.open",
                                       objective_bound_text(objective, result.lower_bound, design->currency),
                                       gap_percent(result.gap)));
    if (const std::string others = alternatives_certificate(result, t); !others.empty()) line(others);
    if (preferred) line(premium_text(result, t));
  } else if (result.objectives.size() > 1) {
    const double tolerance = certificate.front_tolerance;
    const bool open = result.status != Status::optimal;
    if (open && !std::isfinite(tolerance))
      line(t("certificate.front_open"));
    else if (open)
      line(fill("certificate.front_wide", percent_rounded_up(tolerance)));
    else
      line(tolerance > 0.0 ? fill("certificate.front_within", fmt::format("{:.3g}", 100.0 * tolerance))
                           : t("certificate.front"));
    if (preferred) line(fill("certificate.preferred", divisor));
  }
  if (design != nullptr && !design->all_fewest_bars) line(t("certificate.bars"));
  out += incomplete_text(certificate.incomplete, style, t);
  line(fill("certificate.combinations", scalar::format_number(certificate.combinations, 3)));
  if (!certificate.method.empty()) line(t.clauses(certificate.method));
  if (design != nullptr) line(t("certificate.again"));
  // Lines of effort begin with "time": they differ from run to run.
  return out +
         fill("certificate.effort",
              fmt::format("{:.2f}", result.timing.read),
              fmt::format("{:.2f}", result.timing.solve),
              certificate.nodes,
              certificate.evaluations) +
         "\n";
}

}  // namespace millwright::report
