// SPDX-License-Identifier: Apache-2.0
#include "report/explanation_checks.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;
using evaluation::Explanation;
using machine::Condition;

namespace {

class Collector {
 public:
  void add_named(const NamedCheck& check) {
    const auto same = [&](const NamedCheck& each) { return each.id == check.id; };
    if (std::none_of(checks_.begin(), checks_.end(), same)) checks_.push_back(check);
  }
  void add(const Check& check) { add_named({check.id, check.title, check.requirement, check.source}); }
  void add(const Check* check) {
    if (check != nullptr) add(*check);
  }
  /// Those of a design whose limit is this condition.
  void add_limited_by(const Condition& condition, const Design& design) {
    for (const Check& check : design.checks)
      if (!check.requirement.empty() && check.requirement == condition.name) add(check);
  }
  std::vector<NamedCheck> take() {
    std::sort(checks_.begin(), checks_.end(), [](const NamedCheck& a, const NamedCheck& b) { return a.id < b.id; });
    return std::move(checks_);
  }

 private:
  std::vector<NamedCheck> checks_;
};

}  // namespace

const Check* tightest_check(const Design& design) {
  constexpr double near_limit = 0.95;
  const Check* tightest = nullptr;
  for (const Check& check : design.checks) {
    const bool counts = check.kind == machine::ConstraintKind::hard && std::isfinite(check.utilisation) &&
                        check.utilisation < 1.0 && !machine::is_limit_of_machine(check.id);
    if (counts && (tightest == nullptr || check.utilisation > tightest->utilisation)) tightest = &check;
  }
  return tightest == nullptr || tightest->utilisation < near_limit ? nullptr : tightest;
}

std::vector<NamedCheck> named_checks(const Explanation& explanation) {
  Collector found;
  for (const evaluation::UnmetCheck& check : explanation.unmet)
    found.add_named({check.id, check.title, check.requirement, check.source});
  for (const evaluation::Conflict& conflict : explanation.conflicts)
    for (const evaluation::Relaxation& way : conflict.ways) {
      for (const Check& check : way.broken) found.add(check);
      if (!way.design) continue;
      found.add(tightest_check(*way.design));
      for (const std::size_t i : conflict.conditions) found.add_limited_by(explanation.conditions[i], *way.design);
    }
  if (explanation.design) {
    std::set<std::string> axes;
    for (const Check& check : explanation.design->checks) axes.insert(check.axis);
    for (const std::string& axis : axes) found.add(explanation.design->governing(axis));
    for (const Check& check : explanation.holding) found.add(check);
    for (const evaluation::Price& price : explanation.prices)
      found.add_limited_by(explanation.conditions[price.condition], *explanation.design);
  }
  return found.take();
}

std::string named_checks_text(const Explanation& explanation, const Style& style) {
  TextTable table({{"check"}, {"", Align::left, 25}, {"limit set by", Align::left, 18}, {"source", Align::left, 20}});
  for (const NamedCheck& check : named_checks(explanation))
    table.add({check.id, check.title, check.requirement, check.source});
  if (table.empty()) return {};
  return style.heading("The checks behind this") + "\n" + table.str(2, style) +
         "  Their calculation, with numbers: --report FILE.html of solve or check\n\n";
}

}  // namespace millwright::report
