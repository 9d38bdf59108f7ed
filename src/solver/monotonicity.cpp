// SPDX-License-Identifier: Apache-2.0
#include "solver/monotonicity.h"

#include <algorithm>
#include <cmath>

namespace millwright::solver {
namespace {

/// Slopes smaller than this are rounding residue of a slope that is zero: no double moves by them.
constexpr double nothing = 1e-200;

/// A part of the box of a question: `region` and the range of inherited states.
struct Part {
  Region region;
  std::vector<Interval> inherited;
};

bool is_zero(const Interval& slope) { return slope.lower >= -nothing && slope.upper <= nothing; }

/// The claim to be proved: a direction of one component.
class Claim {
 public:
  Claim(const MonotonicityQuestion& question, std::size_t component, Direction direction)
      : question_(question), component_(component), direction_(direction) {}

  bool prove(Desk& desk) const;

 private:
  /// +1 when the slope has to be >= 0, -1 when <= 0, 0 when it has to vanish.
  [[nodiscard]] bool right(const Interval& slope, int sign) const {
    if (direction_ == Direction::irrelevant || sign == 0) return is_zero(slope);
    const int wanted = direction_ == Direction::smaller_is_better ? sign : -sign;
    return wanted > 0 ? slope.lower >= -nothing : slope.upper <= nothing;
  }
  [[nodiscard]] bool holds(const Part& part, Desk& desk) const;
  [[nodiscard]] bool split(const Part& part, Part& left, Part& right) const;

  const MonotonicityQuestion& question_;
  std::size_t component_;
  Direction direction_;
};

int sign_of(Direction next) {
  switch (next) {
    case Direction::smaller_is_better:
      return 1;
    case Direction::larger_is_better:
      return -1;
    default:
      return 0;
  }
}

bool Claim::holds(const Part& part, Desk& desk) const {
  const Stage& stage = *question_.stage;
  const auto& values = desk.bound(stage, question_.shared, part.inherited, part.region);
  if (worst_lower(values.utilisation) > 1.0) return true;
  thread_local std::vector<bool> satisfied;
  satisfied.assign(values.utilisation.size(), false);
  for (std::size_t c = 0; c < satisfied.size(); ++c) satisfied[c] = values.utilisation[c].upper <= 1.0;
  const Input input{Input::Kind::inherited, component_};
  const auto& slopes = desk.slopes(stage, question_.shared, part.inherited, part.region, input);
  for (std::size_t c = 0; c < satisfied.size(); ++c) {
    if (!satisfied[c] && !right(slopes.utilisation[c], 1)) return false;
  }
  for (std::size_t r = 0; r < slopes.resources.size(); ++r) {
    if (question_.criteria->reads(r) && !right(slopes.resources[r], 1)) return false;
  }
  for (std::size_t s = 0; s < slopes.handed_on.size(); ++s) {
    if (question_.next[s] != Direction::irrelevant && !right(slopes.handed_on[s], sign_of(question_.next[s]))) {
      return false;
    }
  }
  return true;
}

double relative_width(const Interval& now, const Interval& whole) {
  const double all = whole.upper - whole.lower;
  if (!std::isfinite(all)) return now.upper > now.lower ? 1.0 : 0.0;
  return all > 0.0 ? (now.upper - now.lower) / all : 0.0;
}

void halve(const Interval& whole, Interval& left, Interval& right) {
  const double cut = middle(whole);
  left = {whole.lower, cut};
  right = {cut, whole.upper};
}

/// Halves what is still largest relative to the whole question; false when nothing is left to split.
bool Claim::split(const Part& part, Part& left, Part& right) const {
  constexpr double smallest = 1e-3;  // a narrower interval will not decide what this one did not
  double largest = smallest;
  std::size_t choice = 0;
  const std::size_t slots = part.region.rows.size();
  const std::size_t variables = part.region.variables.size();
  const auto offer = [&](double size, std::size_t index) {
    if (size > largest) {
      largest = size;
      choice = index + 1;
    }
  };
  for (std::size_t s = 0; s < slots; ++s) {
    const double size = static_cast<double>(part.region.rows[s]->size());
    if (size > 1.0) offer(size / static_cast<double>(question_.region->rows[s]->size()), s);
  }
  for (std::size_t v = 0; v < variables; ++v) {
    offer(relative_width(part.region.variables[v], question_.region->variables[v]), slots + v);
  }
  for (std::size_t i = 0; i < part.inherited.size(); ++i) {
    offer(relative_width(part.inherited[i], question_.inherited[i]), slots + variables + i);
  }
  if (choice == 0) return false;
  left = part;
  right = part;
  const std::size_t index = choice - 1;
  if (index < slots) {
    const std::vector<Row>& rows = *part.region.rows[index];
    const auto cut = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
    left.region.rows[index] = std::make_shared<const std::vector<Row>>(rows.begin(), cut);
    right.region.rows[index] = std::make_shared<const std::vector<Row>>(cut, rows.end());
  } else if (index < slots + variables) {
    const std::size_t v = index - slots;
    halve(part.region.variables[v], left.region.variables[v], right.region.variables[v]);
  } else {
    const std::size_t i = index - slots - variables;
    halve(part.inherited[i], left.inherited[i], right.inherited[i]);
  }
  return true;
}

bool Claim::prove(Desk& desk) const {
  std::vector<Part> open;
  open.push_back({*question_.region, {question_.inherited.begin(), question_.inherited.end()}});
  // That something has no influence at all is seen at once or not at all.
  const std::size_t limit = direction_ == Direction::irrelevant ? 1 : question_.node_limit;
  for (std::size_t nodes = 0; !open.empty(); ++nodes) {
    if (nodes >= limit) return false;
    const Part part = std::move(open.back());
    open.pop_back();
    if (holds(part, desk)) continue;
    Part left;
    Part right;
    if (!split(part, left, right)) return false;
    open.push_back(std::move(left));
    open.push_back(std::move(right));
  }
  return true;
}

}  // namespace

Direction prove_direction(const MonotonicityQuestion& question, std::size_t component, Desk& desk) {
  for (const Direction direction : {Direction::irrelevant, Direction::smaller_is_better, Direction::larger_is_better}) {
    if (Claim(question, component, direction).prove(desk)) return direction;
  }
  return Direction::equal_only;
}

bool moves_feasibility_only(const MonotonicityQuestion& question, std::size_t variable, Desk& desk) {
  const Input input{Input::Kind::variable, variable};
  const auto& slopes = desk.slopes(*question.stage, question.shared, question.inherited, *question.region, input);
  for (std::size_t r = 0; r < slopes.resources.size(); ++r) {
    if (question.criteria->reads(r) && !is_zero(slopes.resources[r])) return false;
  }
  for (std::size_t s = 0; s < slopes.handed_on.size(); ++s) {
    if (question.next[s] != Direction::irrelevant && !is_zero(slopes.handed_on[s])) return false;
  }
  return true;
}

}  // namespace millwright::solver
