// SPDX-License-Identifier: Apache-2.0
#include "report/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "report/design_text.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;
using evaluation::DimensionLine;
using evaluation::PartLine;
using evaluation::Verdict;

namespace {

/// Of a figure that went through a file or another compiler.
bool alike(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

bool alike(const PartLine& a, const PartLine& b) {
  return part_name(a) == part_name(b) && alike(a.quantity, b.quantity) && alike(a.length, b.length) &&
         alike(a.price, b.price) && alike(a.mass, b.mass);
}

bool same_place(const PartLine& a, const PartLine& b) { return a.axis == b.axis && a.slot == b.slot; }
bool same_place(const DimensionLine& a, const DimensionLine& b) { return a.axis == b.axis && a.name == b.name; }
bool same_place(const Check& a, const Check& b) { return a.axis == b.axis && a.element == b.element && a.id == b.id; }

/// Pairs of what stands in the same place, each taken once, in the order of `now`; then what only `before` has.
template <class Line>
std::vector<std::pair<const Line*, const Line*>> pairs(const std::vector<Line>& before, const std::vector<Line>& now) {
  std::vector<std::pair<const Line*, const Line*>> result;
  std::set<const Line*> taken;
  for (const Line& line : now) {
    const Line* partner = nullptr;
    for (const Line& other : before)
      if (partner == nullptr && same_place(other, line) && taken.count(&other) == 0) partner = &other;
    if (partner != nullptr) taken.insert(partner);
    result.emplace_back(partner, &line);
  }
  for (const Line& line : before)
    if (taken.count(&line) == 0) result.emplace_back(&line, nullptr);
  return result;
}

bool fails(const Check& check) { return check.verdict == Verdict::violated; }
bool has_figure(const Check& check) {
  return check.verdict != Verdict::not_evaluated && !std::isnan(check.utilisation);
}

bool alike(const Check& a, const Check& b) {
  constexpr double least = 1e-4;
  if (a.verdict != b.verdict || has_figure(a) != has_figure(b)) return false;
  return !has_figure(a) || a.utilisation == b.utilisation || std::abs(a.utilisation - b.utilisation) < least;
}

/// Verdicts of what must hold, then those of what is only reported, then all others.
int rank(const CheckChange& change) {
  if (!change.turns()) return 2;
  return change.either().kind == machine::ConstraintKind::soft ? 1 : 0;
}

}  // namespace

bool CheckChange::turns() const { return (a != nullptr && fails(*a)) != (b != nullptr && fails(*b)); }

double CheckChange::change() const {
  if (a == nullptr || b == nullptr || has_figure(*a) != has_figure(*b)) return std::numeric_limits<double>::infinity();
  return !has_figure(*a) || a->utilisation == b->utilisation ? 0.0 : b->utilisation - a->utilisation;
}

std::size_t failed_checks(const Design& design) {
  return static_cast<std::size_t>(std::count_if(design.checks.begin(), design.checks.end(), [](const Check& check) {
    return fails(check) && check.kind != machine::ConstraintKind::soft;
  }));
}

Comparison compare(const ComparedBuild& a, const ComparedBuild& b) {
  Comparison result;
  for (const auto& [before, now] : pairs(a.design.parts, b.design.parts)) {
    if (before != nullptr && now != nullptr && alike(*before, *now)) {
      ++result.same_parts;
      continue;
    }
    const PartLine& place = now != nullptr ? *now : *before;
    result.parts.push_back({place.axis, place.slot, before, now});
  }
  std::stable_sort(result.parts.begin(), result.parts.end(), [](const PartChange& x, const PartChange& y) {
    // Cents decide, not what rounding left of equal prices.
    const double x_cents = std::round(100.0 * std::abs(x.price())), y_cents = std::round(100.0 * std::abs(y.price()));
    return x_cents != y_cents ? x_cents > y_cents : std::abs(x.mass()) > std::abs(y.mass());
  });
  for (const auto& [before, now] : pairs(a.design.dimensions, b.design.dimensions)) {
    if (before != nullptr && now != nullptr && alike(before->value, now->value)) continue;
    const DimensionLine& line = now != nullptr ? *now : *before;
    DimensionChange change{line.axis, line.name, line.unit, std::nullopt, std::nullopt};
    if (before != nullptr) change.a = before->value;
    if (now != nullptr) change.b = now->value;
    result.dimensions.push_back(std::move(change));
  }
  for (const auto& [before, now] : pairs(a.design.checks, b.design.checks)) {
    if (before != nullptr && now != nullptr && alike(*before, *now)) {
      ++result.same_checks;
      continue;
    }
    result.checks.push_back({before, now});
  }
  std::stable_sort(result.checks.begin(), result.checks.end(), [](const CheckChange& x, const CheckChange& y) {
    if (rank(x) != rank(y)) return rank(x) < rank(y);
    return std::abs(x.change()) > std::abs(y.change());
  });
  return result;
}

}  // namespace millwright::report
