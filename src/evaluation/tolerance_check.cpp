// SPDX-License-Identifier: Apache-2.0
#include "evaluation/tolerance_check.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <queue>

#include "evaluation/ledger.h"
#include "evaluation/toleranced_machine.h"

namespace millwright::evaluation {

using scalar::Interval;

const char* to_string(ToleranceVerdict verdict) {
  switch (verdict) {
    case ToleranceVerdict::none_stated:
      return "none_stated";
    case ToleranceVerdict::compliant:
      return "compliant";
    case ToleranceVerdict::broken:
      return "broken";
    case ToleranceVerdict::unsettled:
      return "unsettled";
    case ToleranceVerdict::not_asked:
      break;
  }
  return "not_asked";
}

namespace {

using Box = std::vector<Interval>;

/// Prices have no tolerances, and what is cut keeps its length as designed, so the limit of cost is no question here.
bool counts(const Check& check) { return check.kind != machine::ConstraintKind::soft && check.id != "C-SYS-COST"; }

bool complies(const Design& design) {
  return std::none_of(design.checks.begin(), design.checks.end(), [](const Check& check) {
    return counts(check) && check.verdict == Verdict::violated;
  });
}

/// Utilisations of the checks that count, in their order; what is missing or broken without a number is useless.
std::vector<double> utilisations(const Design& design) {
  std::vector<double> result;
  for (const Check& check : design.checks)
    if (counts(check))
      result.push_back(!std::isnan(check.utilisation)       ? check.utilisation
                       : check.verdict == Verdict::violated ? machine::useless_utilisation
                                                            : 0.0);
  return result;
}

using Clock = std::chrono::steady_clock;

/// Whether the time for it is up, or somebody wants it to end.
bool is_spent(const ToleranceEffort& effort, Clock::time_point begin) {
  if (effort.stop != nullptr && effort.stop->load()) return true;
  return std::chrono::duration<double>(Clock::now() - begin).count() >= effort.seconds;
}

class ToleranceSearch {
 public:
  ToleranceSearch(const TolerancedMachine& machine,
                  const ToleranceEffort& effort,
                  Clock::time_point begin,
                  ToleranceCheck& result)
      : machine_(machine), effort_(effort), begin_(begin), result_(result) {
    for (const TolerancedFigure& figure : machine.figures()) {
      stated_.push_back(figure.value);
      whole_.emplace_back(figure.value - figure.half_width, figure.value + figure.half_width);
    }
  }

  void run() {
    result_.verdict = ToleranceVerdict::compliant;
    if (is_over()) return;
    const std::vector<double> of_whole = excesses(whole_);
    if (is_proved(of_whole)) return;
    nominal_ = utilisations(evaluate(stated_));
    one_at_a_time();
    if (result_.single.empty() && !is_over()) corners();
    if (result_.single.empty() && !result_.combination && !is_over()) subdivide(of_whole);
    if (!result_.single.empty() || result_.combination) {
      result_.verdict = ToleranceVerdict::broken;
      result_.stopped = false;
    }
  }

 private:
  /// Once time is up nothing more is looked at.
  bool is_over() {
    if (!result_.stopped && is_spent(effort_, begin_)) {
      result_.stopped = true;
      result_.verdict = ToleranceVerdict::unsettled;
    }
    return result_.stopped;
  }
  std::vector<double> excesses(const Box& box) {
    ++result_.boxes;
    return machine_.excesses(box);
  }
  static bool is_proved(const std::vector<double>& excesses) {
    return std::all_of(excesses.begin(), excesses.end(), [](double excess) { return excess == 0.0; });
  }
  Design evaluate(const std::vector<double>& values) {
    ++result_.evaluations;
    return machine_.design(values);
  }

  /// What breaks with these values, if anything does.
  std::optional<ToleranceBreak> break_of(const Design& design, const std::vector<double>& values) const {
    if (complies(design)) return std::nullopt;
    ToleranceBreak found;
    for (const Check& check : design.checks)
      if (counts(check) && check.verdict == Verdict::violated &&
          (found.check.empty() || check.utilisation > found.utilisation)) {
        found.axis = check.axis;
        found.check = check.id;
        found.title = check.title;
        found.utilisation = check.utilisation;
      }
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] != stated_[i]) found.values.emplace_back(i, values[i]);
    return found;
  }

  void one_at_a_time() {
    for (std::size_t i = 0; i < stated_.size() && !is_over(); ++i) {
      std::optional<ToleranceBreak> worst;
      std::vector<std::vector<double>> ends;
      for (const double end : {whole_[i].lower, whole_[i].upper}) {
        std::vector<double> values = stated_;
        values[i] = end;
        const Design design = evaluate(values);
        ends.push_back(utilisations(design));
        const auto found = break_of(design, values);
        if (found && (!worst || found->utilisation > worst->utilisation)) worst = found;
      }
      lower_.push_back(std::move(ends[0]));
      upper_.push_back(std::move(ends[1]));
      if (!worst) continue;
      worst->from = first_break(i, worst->values.front().second);
      result_.single.push_back(std::move(*worst));
    }
    std::stable_sort(result_.single.begin(), result_.single.end(), [&](const auto& a, const auto& b) {
      return deviation(a) < deviation(b);
    });
  }

  /// How far from its stated value the figure must be to break the build, as a share of its tolerance.
  double deviation(const ToleranceBreak& single) const {
    const TolerancedFigure& figure = machine_.figures()[single.values.front().first];
    return std::abs(*single.from - figure.value) / figure.half_width;
  }

  /// Between the stated value, which is compliant, and one that is not, to a thousandth of the tolerance.
  double first_break(std::size_t figure, double broken) {
    double good = stated_[figure];
    std::vector<double> values = stated_;
    for (int halving = 0; halving < 10; ++halving) {
      values[figure] = 0.5 * (good + broken);
      (complies(evaluate(values)) ? good : broken) = values[figure];
    }
    return broken;
  }

  /// The end of every interval of a box that, alone, makes a check worse.
  std::vector<double> worst_corner(const Box& box, std::size_t check) const {
    std::vector<double> values = stated_;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double rise = upper_[i][check] - lower_[i][check];
      if (rise != 0.0)
        values[i] = rise > 0.0 ? box[i].upper : box[i].lower;
      else
        values[i] = std::clamp(stated_[i], box[i].lower, box[i].upper);
    }
    return values;
  }

  /// For every check the corner that should be worst for it, if what the figures do alone adds up to anything near.
  void corners() {
    std::vector<std::vector<double>> tried;
    for (std::size_t check = 0; check < nominal_.size() && !is_over(); ++check) {
      double worst = nominal_[check];
      for (std::size_t i = 0; i < stated_.size(); ++i)
        worst += std::max({0.0, upper_[i][check] - nominal_[check], lower_[i][check] - nominal_[check]});
      if (worst < 0.8) continue;
      const std::vector<double> values = worst_corner(whole_, check);
      if (std::find(tried.begin(), tried.end(), values) != tried.end()) continue;
      tried.push_back(values);
      keep_worse(break_of(evaluate(values), values));
    }
  }

  void keep_worse(std::optional<ToleranceBreak> found) {
    if (!found || (result_.combination && result_.combination->utilisation >= found->utilisation)) return;
    result_.combination = std::move(found);
  }

  /// How much of what is left to prove of each limit hangs on a figure: what falls away where it is as stated and all
  /// others are anything. [figure][limit]
  void find_shares(const std::vector<double>& of_whole) {
    largest_share_.assign(of_whole.size(), 0.0);
    for (std::size_t i = 0; i < stated_.size() && !is_over(); ++i) {
      Box box = whole_;
      box[i] = Interval(stated_[i]);
      std::vector<double> share = of_whole;
      const std::vector<double> left = excesses(box);
      for (std::size_t limit = 0; limit < share.size(); ++limit) {
        share[limit] = std::max(0.0, share[limit] - left[limit]);
        largest_share_[limit] = std::max(largest_share_[limit], share[limit]);
      }
      shares_.push_back(std::move(share));
    }
  }

  /// The figure whose interval has most to do with what is left to prove of a limit.
  [[nodiscard]] std::size_t figure_to_halve(const Box& box, std::size_t limit) const {
    // Of a limit that is the largest of several, one figure may hide what another one does.
    const double hidden = 1e-3 * largest_share_[limit] + 1e-9;
    std::size_t best = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < box.size(); ++i) {
      const double width = (box[i].upper - box[i].lower) / (2.0 * machine_.figures()[i].half_width);
      const double matters = width * (shares_[i][limit] + hidden);
      if (matters > most) {
        most = matters;
        best = i;
      }
    }
    return best;
  }

  /// A part of the tolerances of which something is left to prove.
  struct Piece {
    Box box;
    std::size_t limit = 0;  ///< the one that may be exceeded by most
    double excess = 0.0;
    friend bool operator<(const Piece& a, const Piece& b) { return a.excess < b.excess; }
  };
  static Piece piece_of(Box box, const std::vector<double>& excesses) {
    const auto most = std::max_element(excesses.begin(), excesses.end());
    return {std::move(box), static_cast<std::size_t>(most - excesses.begin()), *most};
  }

  /// Halves what is not proved, the pieces first that leave most to prove (near the values that break the build, if any
  /// do), until all is proved, something breaks, or the effort is spent.
  void subdivide(const std::vector<double>& of_whole) {
    std::priority_queue<Piece> open;
    open.push(piece_of(whole_, of_whole));
    if (result_.boxes + stated_.size() <= effort_.boxes) find_shares(of_whole);
    while (!open.empty() && !is_over()) {
      if (shares_.empty() || result_.boxes + 2 > effort_.boxes) {
        result_.verdict = ToleranceVerdict::unsettled;
        return;
      }
      const Piece next = open.top();
      open.pop();
      const std::size_t halved = figure_to_halve(next.box, next.limit);
      const Interval& values = next.box[halved];
      const double middle = 0.5 * (values.lower + values.upper);
      for (const Interval& half : {Interval(values.lower, middle), Interval(middle, values.upper)}) {
        Box box = next.box;
        box[halved] = half;
        const std::vector<double> left = excesses(box);
        if (is_proved(left)) continue;
        result_.combination = break_in(box);
        if (result_.combination) return;
        open.push(piece_of(std::move(box), left));
      }
    }
  }

  /// What breaks in the middle of a box or in the corner that should be worst for the check that is worst there.
  std::optional<ToleranceBreak> break_in(const Box& box) {
    std::vector<double> values;
    for (const Interval& x : box) values.push_back(0.5 * (x.lower + x.upper));
    const Design design = evaluate(values);
    if (auto found = break_of(design, values)) return found;
    const std::vector<double> here = utilisations(design);
    const auto worst = static_cast<std::size_t>(std::max_element(here.begin(), here.end()) - here.begin());
    values = worst_corner(box, worst);
    return break_of(evaluate(values), values);
  }

  const TolerancedMachine& machine_;
  const ToleranceEffort& effort_;
  Clock::time_point begin_;
  ToleranceCheck& result_;
  std::vector<double> stated_, nominal_;
  Box whole_;
  std::vector<std::vector<double>> lower_, upper_;  ///< utilisations with one figure at an end, by figure
  std::vector<std::vector<double>> shares_;         ///< see find_shares
  std::vector<double> largest_share_;               ///< of each limit
};

}  // namespace

ToleranceCheck check_tolerances(const MachineModel& model,
                                const solver::Build& build,
                                const Design& design,
                                const ToleranceEffort& effort) {
  ToleranceCheck result;
  const Clock::time_point begin = Clock::now();
  const TolerancedMachine machine(model, build);
  result.figures = machine.figures();
  result.unstated = machine.unstated();
  if (!design.satisfied())
    result.verdict = ToleranceVerdict::not_asked;
  else if (!result.figures.empty())
    ToleranceSearch(machine, effort, begin, result).run();
  return result;
}

}  // namespace millwright::evaluation
