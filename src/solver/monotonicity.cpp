// SPDX-License-Identifier: Apache-2.0
#include "solver/monotonicity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace millwright::solver {
namespace {

/// Slopes smaller than this are rounding residue of a slope that is zero: no double moves by them.
constexpr double nothing = 1e-200;

/// A part of the box of a question: `region` and the range of inherited states.
struct Part {
  Region region;
  std::vector<Interval> inherited;
  double share = 1.0;           ///< of the whole: halved by every split
  std::optional<double> doubt;  ///< if it has been looked at
};

/// Whether a proof that has come so far is not worth more effort: where it succeeds it takes its parts at a steady
/// pace. What is given up counts as not proved, so that nothing hangs on this but time.
class Pace {
 public:
  [[nodiscard]] bool has_stalled(std::size_t nodes, double proved) {
    constexpr std::size_t interval = 100;
    constexpr double too_little = 1e-3, half = 0.5, growth = 1.01;
    if (nodes == 0 || nodes % interval != 0) return false;
    const bool stalled = proved < too_little || (proved < half && proved < growth * latest_);
    latest_ = proved;
    return stalled;
  }

 private:
  double latest_ = 0.0;
};

bool is_zero(const Interval& slope) { return slope.lower >= -nothing && slope.upper <= nothing; }

/// The claim to be proved: a direction of one component of the state, or of one reading.
class Claim {
 public:
  Claim(const MonotonicityQuestion& question, Input input, Direction direction)
      : question_(question), input_(input), direction_(direction) {}

  bool prove(Desk& desk);
  /// See below; of slopes that are known, too.
  [[nodiscard]] double doubt(const Answer<Interval>& slopes, const Part& part, Desk& desk) const;

 private:
  void find_influences(Desk& desk);
  /// +1 when the slope has to be >= 0, -1 when <= 0, 0 when it has to vanish.
  [[nodiscard]] bool right(const Interval& slope, int sign) const {
    if (direction_ == Direction::irrelevant || sign == 0) return is_zero(slope);
    const int wanted = direction_ == Direction::smaller_is_better ? sign : -sign;
    return wanted > 0 ? slope.lower >= -nothing : slope.upper <= nothing;
  }
  /// 0 when `right`, else above 0 and at most 1: how much of the slope is on the wrong side.
  [[nodiscard]] double wrong_share(const Interval& slope, int sign) const;
  [[nodiscard]] double doubt(const Part& part, Desk& desk) const;
  [[nodiscard]] bool split(const Part& part, Part& left, Part& right, Desk& desk) const;

  const MonotonicityQuestion& question_;
  Input input_;
  Direction direction_;
  std::vector<bool> influences_;  ///< [inherited component]: some utilisation depends on it
};

/// Halving a state component that no utilisation depends on proves nothing; there are many of them in a long chain.
void Claim::find_influences(Desk& desk) {
  for (std::size_t i = 0; i < question_.inherited.size(); ++i) {
    const Input input{Input::Kind::inherited, i};
    const auto& slopes = desk.slopes(*question_.stage, question_.shared, question_.inherited, *question_.region, input);
    influences_.push_back(i == input_.index ||
                          !std::all_of(slopes.utilisation.begin(), slopes.utilisation.end(), is_zero));
  }
}

double Claim::wrong_share(const Interval& slope, int sign) const {
  if (right(slope, sign)) return 0.0;
  if (direction_ == Direction::irrelevant || sign == 0) return 1.0;
  const int wanted = direction_ == Direction::smaller_is_better ? sign : -sign;
  const double wrong = wanted > 0 ? -slope.lower : slope.upper;
  const double good = std::max(wanted > 0 ? slope.upper : -slope.lower, 0.0);
  return std::isfinite(wrong) && std::isfinite(good) ? wrong / (wrong + good) : 1.0;
}

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

/// While a range is wide its slopes say little, whatever is halved; what makes it narrower is on the way to a proof.
double spread(const Interval& utilisation) {
  constexpr double weight = 0.1, least = 1e-3, most = 1e9;
  return weight * std::log10(std::clamp(utilisation.upper, least, most) / std::clamp(utilisation.lower, least, most));
}

/// How far the claim is from proved over the part: 0 when it holds there, else a share of wrong slope for each
/// constraint, resource or state that stands against it, and how wide such a constraint's range is.
double Claim::doubt(const Part& part, Desk& desk) const {
  return doubt(desk.slopes(*question_.stage, question_.shared, part.inherited, part.region, input_), part, desk);
}

double Claim::doubt(const Answer<Interval>& slopes, const Part& part, Desk& desk) const {
  double sum = 0.0;
  for (std::size_t r = 0; r < slopes.resources.size(); ++r) {
    if (question_.criteria->reads(r)) sum += wrong_share(slopes.resources[r], 1);
  }
  for (std::size_t s = 0; s < slopes.handed_on.size(); ++s) {
    if (question_.next[s] != Direction::irrelevant) sum += wrong_share(slopes.handed_on[s], sign_of(question_.next[s]));
  }
  thread_local std::vector<double> wrong;  // [constraint]
  wrong.clear();
  for (const Interval& slope : slopes.utilisation) wrong.push_back(wrong_share(slope, 1));
  const auto is_right = [](double share) { return share == 0.0; };
  if (sum == 0.0 && std::all_of(wrong.begin(), wrong.end(), is_right)) return 0.0;

  const auto& values = desk.bound(*question_.stage, question_.shared, part.inherited, part.region);
  if (worst_lower(values.utilisation) > 1.0) return 0.0;
  // Between equals the worst utilisation decides: a row that another one stands in for has to be no better in any.
  const bool all_count = input_.kind == Input::Kind::reading;
  for (std::size_t c = 0; c < wrong.size(); ++c) {
    if (wrong[c] > 0.0 && (all_count || !(values.utilisation[c].upper <= 1.0)))
      sum += wrong[c] + spread(values.utilisation[c]);
  }
  return sum;
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

/// One of the inputs of a part, cut in two.
void halve(const MonotonicityQuestion& question, const Part& part, std::size_t index, Part& left, Part& right) {
  left = part;
  left.doubt.reset();
  right = left;
  const std::size_t slots = part.region.rows.size();
  const std::size_t variables = part.region.variables.size();
  if (index < slots) {
    const RowHalves::Halves& halves = question.halves->of(index, part.region.rows[index]);
    left.region.rows[index] = halves.left;
    right.region.rows[index] = halves.right;
  } else if (index < slots + variables) {
    const std::size_t v = index - slots;
    halve(part.region.variables[v], left.region.variables[v], right.region.variables[v]);
  } else {
    const std::size_t i = index - slots - variables;
    halve(part.inherited[i], left.inherited[i], right.inherited[i]);
  }
}

/// Halves what leaves the least doubt, the largest among equals; false when nothing is left to split.
bool Claim::split(const Part& part, Part& left, Part& right, Desk& desk) const {
  constexpr double smallest = 1e-3;  // a narrower interval will not decide what this one did not
  const std::size_t slots = part.region.rows.size();
  const std::size_t variables = part.region.variables.size();
  double best = std::numeric_limits<double>::infinity();
  bool found = false;
  const auto offer = [&](double size, std::size_t index) {
    if (!(size > smallest)) return;
    Part first;
    Part second;
    halve(question_, part, index, first, second);
    first.doubt = doubt(first, desk);
    second.doubt = doubt(second, desk);
    const double value = *first.doubt + *second.doubt - 1e-6 * size;
    if (found && !(value < best)) return;
    found = true;
    best = value;
    left = std::move(first);
    right = std::move(second);
  };
  for (std::size_t s = 0; s < slots; ++s) {
    const double size = static_cast<double>(part.region.rows[s]->size());
    if (size > 1.0) offer(size / static_cast<double>(question_.region->rows[s]->size()), s);
  }
  for (std::size_t v = 0; v < variables; ++v) {
    offer(relative_width(part.region.variables[v], question_.region->variables[v]), slots + v);
  }
  for (std::size_t i = 0; i < part.inherited.size(); ++i) {
    if (influences_[i]) offer(relative_width(part.inherited[i], question_.inherited[i]), slots + variables + i);
  }
  if (!found) return false;
  left.share = right.share = 0.5 * part.share;
  return true;
}

bool Claim::prove(Desk& desk) {
  Pace pace;
  double proved = 0.0;
  std::vector<Part> open;
  open.push_back({*question_.region, {question_.inherited.begin(), question_.inherited.end()}, 1.0, std::nullopt});
  // That something has no influence at all is seen at once or not at all.
  const std::size_t limit = direction_ == Direction::irrelevant ? 1 : question_.node_limit;
  for (std::size_t nodes = 0; !open.empty(); ++nodes) {
    if (pace.has_stalled(nodes, proved)) return false;
    const Part part = std::move(open.back());
    open.pop_back();
    if ((part.doubt ? *part.doubt : doubt(part, desk)) == 0.0) {
      proved += part.share;
      continue;
    }
    if (nodes + 1 >= limit) return false;
    Part left;
    Part right;
    if (influences_.empty()) find_influences(desk);
    if (!split(part, left, right, desk)) return false;
    open.push_back(std::move(left));
    open.push_back(std::move(right));
  }
  return true;
}

}  // namespace

const RowHalves::Halves& RowHalves::of(std::size_t slot, const RowSet& whole) {
  Halves& known = known_[{slot, whole.get()}];
  if (known.whole == nullptr) {
    if (found_.insert(slot).second) find_(slot, profile_);
    RowProfile::Split split = profile_.split_slot(*whole, slot);
    known = {whole, std::move(split.left), std::move(split.right)};
  }
  return known;
}

namespace {

constexpr Direction directions[] = {Direction::irrelevant, Direction::smaller_is_better, Direction::larger_is_better};

}  // namespace

Direction prove_direction(const MonotonicityQuestion& question, std::size_t component, Desk& desk) {
  for (const Direction direction : directions) {
    if (Claim(question, {Input::Kind::inherited, component}, direction).prove(desk)) return direction;
  }
  return Direction::equal_only;
}

Direction prove_reading_direction(std::span<const MonotonicityQuestion> questions,
                                  std::size_t slot,
                                  std::size_t reading,
                                  Desk& desk) {
  const Input input{Input::Kind::reading, reading, slot};
  std::vector<Answer<Interval>> slopes;  // copied: what is asked next is answered in the same place
  for (const MonotonicityQuestion& question : questions)
    slopes.push_back(desk.slopes(*question.stage, question.shared, question.inherited, *question.region, input));
  const auto holds = [&](std::size_t i, Direction direction) {
    const MonotonicityQuestion& question = questions[i];
    const Part whole{*question.region, {question.inherited.begin(), question.inherited.end()}, 1.0, std::nullopt};
    return Claim(question, input, direction).doubt(slopes[i], whole, desk) == 0.0;
  };
  for (const Direction direction : directions) {
    std::size_t proved = 0;
    while (proved < questions.size() && holds(proved, direction)) ++proved;
    if (proved == questions.size()) return direction;
  }
  return Direction::equal_only;
}

Moved what_moves(const MonotonicityQuestion& question, std::size_t variable, Desk& desk) {
  const Input input{Input::Kind::variable, variable};
  const auto& slopes = desk.slopes(*question.stage, question.shared, question.inherited, *question.region, input);
  Moved moved;
  for (std::size_t r = 0; r < slopes.resources.size(); ++r)
    moved.scores = moved.scores || (question.criteria->reads(r) && !is_zero(slopes.resources[r]));
  for (std::size_t s = 0; s < slopes.handed_on.size(); ++s)
    if (question.next[s] != Direction::irrelevant && !is_zero(slopes.handed_on[s])) {
      moved.states.push_back(s);
      moved.in_steps = moved.in_steps && !slopes.handed_on[s].is_bounded();
    }
  return moved;
}

}  // namespace millwright::solver
