// SPDX-License-Identifier: Apache-2.0
#include "solver/alternatives.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <queue>
#include <set>
#include <stdexcept>

#include "solver/criteria.h"
#include "solver/neighbours.h"
#include "solver/restricted_problem.h"
#include "solver/row_worth.h"
#include "solver/solve_run.h"

namespace millwright::solver {

namespace {

/// What the order of builds goes by, as far as bounds know it: objective, then the ties.
using Key = std::vector<double>;

/// A part of the problem: which choices are held at a row, and which rows are excluded of the others. Choices are the
/// shared ones, then the slots of all stages.
struct PartOfProblem {
  Key lower;  ///< of everything in it; once it is solved, of its best build
  std::vector<std::optional<Row>> held;
  std::vector<std::vector<Row>> excluded;  ///< ascending
  std::optional<Build> best;               ///< when it is solved
  std::uint64_t order = 0;
};

class AlternativeSearch {
 public:
  AlternativeSearch(const Problem& problem,
                    const Options& options,
                    std::size_t count,
                    const CoveringRows& covering,
                    const BuildIdentity& identity)
      : problem_(problem),
        options_(options),
        count_(count),
        covering_(covering),
        identity_(identity),
        neighbours_(problem),
        directions_(problem, options),
        start_(std::chrono::steady_clock::now()) {
    if (!options.weights.empty() || options.objectives.size() != 1)
      throw std::invalid_argument("best_builds needs a single objective without weights");
    objective_ = options.objectives.front();
    for (const Slot& slot : problem.shared) rows_.push_back(slot.rows);
    for (std::size_t i = 0; i < problem.stages.size(); ++i)
      for (std::size_t slot = 0; slot < problem.stages[i]->slots().size(); ++slot) {
        place_.push_back({i, slot});
        rows_.push_back(problem.stages[i]->slots()[slot].rows);
      }
  }

  Alternatives run() {
    PartOfProblem whole;
    whole.lower = Key(1 + options_.ties.size(), -infinity);
    whole.held.resize(rows_.size());
    whole.excluded.resize(rows_.size());
    push(std::move(whole));
    while (!queue_.empty() && result_.builds.size() < count_) {
      PartOfProblem part = pop();
      if (part.lower.front() > ceiling()) break;  // so is everything behind it
      if (part.best) {
        split(part);
      } else if (!solve_part(part)) {
        result_.status = Status::limit;
        break;
      }
    }
    return finish();
  }

 private:
  struct Later {
    /// Parts that may still hold something as good come before a build: it must not overtake them in the ties.
    bool operator()(const PartOfProblem& a, const PartOfProblem& b) const {
      if (a.lower != b.lower) return a.lower > b.lower;
      if (a.best.has_value() != b.best.has_value()) return a.best.has_value();
      return a.order > b.order;
    }
  };

  void push(PartOfProblem part) {
    part.order = order_++;
    queue_.push(std::move(part));
  }
  PartOfProblem pop() {
    PartOfProblem part = queue_.top();
    queue_.pop();
    return part;
  }

  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  [[nodiscard]] Key key_of(const std::vector<double>& resources) const {
    Key key{rounded(resources[objective_])};
    for (const std::size_t tie : options_.ties) key.push_back(rounded(resources[tie]));
    return key;
  }

  [[nodiscard]] static std::vector<Row> choices_of(const Build& build) {
    std::vector<Row> choices = build.shared;
    for (const StageChoice& stage : build.stages) choices.insert(choices.end(), stage.rows.begin(), stage.rows.end());
    return choices;
  }

  [[nodiscard]] std::string identity_of(const Build& build) const {
    if (identity_) return identity_(build);
    const std::vector<Row> choices = choices_of(build);
    std::string identity(choices.size() * sizeof(Row), '\0');
    std::memcpy(identity.data(), choices.data(), identity.size());
    return identity;
  }

  /// What the last of the best builds known is worth: nothing dearer is asked for.
  [[nodiscard]] double limit() const { return known_worth_.size() < count_ ? infinity : known_worth_.back(); }

  /// The limit with room for sums in another order, and for a build that is within the gap of the best of its part.
  [[nodiscard]] double ceiling() const {
    const double most = limit();
    return std::isfinite(most) ? most + (1e-9 + 2.0 * options_.gap) * std::fabs(most) : most;
  }

  void know(const Build& build, double worth) {
    if (worth >= limit() || !known_.insert(identity_of(build)).second) return;
    known_worth_.insert(std::upper_bound(known_worth_.begin(), known_worth_.end(), worth), worth);
    if (known_worth_.size() > count_) known_worth_.pop_back();
  }

  /// The rows of a choice that are left in a part, without those that need not be looked at.
  [[nodiscard]] std::vector<Row> allowed(const PartOfProblem& part, std::size_t choice) const {
    if (part.held[choice]) return {*part.held[choice]};
    std::vector<Row> left;
    const std::vector<Row>& excluded = part.excluded[choice];
    const auto is_left = [&](Row row) { return !std::binary_search(excluded.begin(), excluded.end(), row); };
    for (Row row = 0; row < rows_[choice]; ++row)
      if (is_left(row) && !is_covered(choice, row, is_left)) left.push_back(row);
    return left;
  }

  template <class IsLeft>
  [[nodiscard]] bool is_covered(std::size_t choice, Row row, const IsLeft& is_left) const {
    if (!covering_ || choice < problem_.shared.size()) return false;
    const auto [stage, slot] = place_[choice - problem_.shared.size()];
    const std::vector<Row> better = covering_(stage, slot, row);
    return std::any_of(better.begin(), better.end(), is_left);
  }

  /// What is left of a part, without what is too dear to be asked for; empty when some choice has no row left.
  [[nodiscard]] std::optional<Restriction> restriction_of(const PartOfProblem& part) const {
    std::vector<std::vector<Row>> left;
    for (std::size_t choice = 0; choice < rows_.size(); ++choice) left.push_back(allowed(part, choice));
    drop_dear(left);
    Restriction restriction = unrestricted(problem_);
    for (std::size_t choice = 0; choice < rows_.size(); ++choice) {
      if (left[choice].empty()) return std::nullopt;
      if (choice < problem_.shared.size()) {
        restriction.shared[choice] = std::move(left[choice]);
      } else {
        const auto [stage, slot] = place_[choice - problem_.shared.size()];
        restriction.stages[stage].allowed[slot] = std::move(left[choice]);
      }
    }
    return restriction;
  }

  /// What is known of the stages, in the rows of what is left of a part.
  [[nodiscard]] DirectionsOf known_in(const Restriction& restriction) {
    return [this, &restriction](std::span<const Row> shared, Desk& desk) {
      std::vector<Row> combination;
      for (std::size_t i = 0; i < shared.size(); ++i) combination.push_back(restriction.shared[i][shared[i]]);
      return directions_.of(combination, desk);
    };
  }

  /// Rows with which no build is worth asking for, at any combination of shared choices that is left.
  void drop_dear(std::vector<std::vector<Row>>& left) const {
    const double most = ceiling();
    if (!worth_known_ || !std::isfinite(most)) return;
    const std::size_t shared = problem_.shared.size();
    std::vector<const RowWorth*> possible;
    for (const RowWorth& worth : worth_) {
      bool there = worth.least <= most;
      for (std::size_t i = 0; i < shared; ++i)
        there = there && std::binary_search(left[i].begin(), left[i].end(), worth.shared[i]);
      if (there) possible.push_back(&worth);
    }
    for (std::size_t choice = 0; choice < left.size(); ++choice)
      std::erase_if(left[choice], [&](Row row) {
        return std::none_of(possible.begin(), possible.end(), [&](const RowWorth* worth) {
          if (choice < shared) return worth->shared[choice] == row;
          const auto [stage, slot] = place_[choice - shared];
          return worth->rows[stage][slot][row] <= most;
        });
      });
  }

  /// Lower bounds for every row, from those of the problem without covered rows: these are worth no less than the rows
  /// that cover them.
  void find_worths(const RestrictedProblem& whole, const Restriction& restriction) {
    Options options = options_;
    options.time_limit_seconds -= seconds();
    worth_ = row_worths(whole.problem(), options, ceiling(), evaluations_, known_in(restriction));
    worth_known_ = !worth_.empty();
    for (RowWorth& worth : worth_) {
      for (std::size_t i = 0; i < worth.shared.size(); ++i) worth.shared[i] = restriction.shared[i][worth.shared[i]];
      for (std::size_t i = 0; i < place_.size(); ++i) {
        const auto [stage, slot] = place_[i];
        const std::vector<Row>& allowed = restriction.stages[stage].allowed[slot];
        std::vector<double> all(rows_[problem_.shared.size() + i], -infinity);
        for (std::size_t row = 0; row < allowed.size(); ++row) all[allowed[row]] = worth.rows[stage][slot][row];
        if (covering_ && allowed.size() < all.size())
          for (Row row = 0; row < all.size(); ++row) {
            if (std::binary_search(allowed.begin(), allowed.end(), row)) continue;
            for (const Row by : covering_(stage, slot, row))
              if (std::binary_search(allowed.begin(), allowed.end(), by)) all[row] = std::max(all[row], all[by]);
          }
        worth.rows[stage][slot] = std::move(all);
      }
    }
  }

  /// Solves the part and puts it back with its best build, if it has one within the limit. False when time is up.
  bool solve_part(PartOfProblem& part) {
    const bool whole = result_.parts == 0;
    Options options = options_;
    options.time_limit_seconds -= seconds();
    options.confirm = options.confirm && whole;
    if (!whole && options.time_limit_seconds <= 0.0) return false;
    if (options_.progress && !whole)
      options.progress = [this, &part](const Progress& progress) {
        options_.progress({part.lower.front(), limit(), seconds(), nodes_ + progress.nodes});
      };
    const std::optional<Restriction> restriction = restriction_of(part);
    if (!restriction) return true;
    RestrictedProblem restricted(problem_, *restriction);
    double& most = restricted.problem().resources[objective_].limit;
    most = std::min(most, ceiling());
    const auto tables = std::make_shared<TableMemory>();
    tables->known_directions = known_in(*restriction);
    const auto scope = whole ? SolveRun::Scope::all : SolveRun::Scope::unpriced;  // a part is not worth many searches
    Summary summary = SolveRun(restricted.problem(), options, scope, tables).run();
    nodes_ += summary.nodes;
    evaluations_ += summary.evaluations;
    ++result_.parts;
    for (Build& build : summary.builds) {
      build = restricted.whole_build(std::move(build));
      know(build, rounded(build.resources[objective_]));
    }
    if (whole) result_.first = summary;
    if (summary.status == Status::limit) {
      for (const Build& build : summary.builds) unproved_.push_back(build);
      return false;
    }
    if (summary.builds.empty()) return true;
    part.best = std::move(summary.builds.front());
    part.lower = key_of(part.best->resources);
    if (neighbours_asked_ < count_) look_around(*part.best);
    if (whole && count_ > 1) find_worths(restricted, *restriction);
    push(std::move(part));
    return true;
  }

  /// Feasible builds next to one that was found.
  void look_around(const Build& build) {
    ++neighbours_asked_;
    neighbours_.visit(build, objective_, [&](const Build& next) {
      know(next, rounded(next.resources[objective_]));
      return limit();
    });
  }

  /// The best build of the part is the next one; what is left of the part is divided.
  void split(PartOfProblem& part) {
    const std::vector<Row> best = choices_of(*part.best);
    if (listed_.insert(identity_of(*part.best)).second) result_.builds.push_back(*std::move(part.best));
    PartOfProblem rest;
    rest.lower = part.lower;
    rest.held = part.held;
    rest.excluded = part.excluded;
    std::vector<PartOfProblem> parts;
    for (std::size_t choice = 0; choice < best.size(); ++choice) {
      if (part.held[choice]) continue;
      PartOfProblem next = rest;
      std::vector<Row>& excluded = next.excluded[choice];
      excluded.insert(std::upper_bound(excluded.begin(), excluded.end(), best[choice]), best[choice]);
      if (excluded.size() < rows_[choice]) parts.push_back(std::move(next));
      rest.held[choice] = best[choice];
    }
    // The small ones first: what they hold tightens the limit for the large ones.
    for (std::size_t i = parts.size(); i-- > 0;) push(std::move(parts[i]));
  }

  Alternatives finish() {
    result_.proved = result_.builds.size();
    if (result_.status == Status::limit) {
      for (; !queue_.empty(); queue_.pop())
        if (queue_.top().best) unproved_.push_back(*queue_.top().best);
    } else if (!result_.builds.empty()) {
      result_.status = Status::optimal;
    }
    sort(result_.builds);
    sort(unproved_);
    for (Build& build : unproved_) {
      if (result_.builds.size() < count_ && listed_.insert(identity_of(build)).second)
        result_.builds.push_back(std::move(build));
    }
    result_.first.nodes = nodes_;
    result_.first.evaluations = evaluations_;
    result_.first.seconds = seconds();
    return std::move(result_);
  }

  void sort(std::vector<Build>& builds) const {
    std::sort(builds.begin(), builds.end(), [&](const Build& a, const Build& b) {
      const Key key_a = key_of(a.resources), key_b = key_of(b.resources);
      if (key_a != key_b) return key_a < key_b;
      if (a.worst_utilisation != b.worst_utilisation) return a.worst_utilisation < b.worst_utilisation;
      return choices_of(a) < choices_of(b);
    });
  }

  struct Place {
    std::size_t stage = 0, slot = 0;
  };

  const Problem& problem_;
  const Options& options_;
  std::size_t count_;
  const CoveringRows& covering_;
  const BuildIdentity& identity_;
  Neighbours neighbours_;
  ProvedDirections directions_;
  std::chrono::steady_clock::time_point start_;
  std::size_t objective_ = 0;
  std::vector<Row> rows_;     ///< per choice
  std::vector<Place> place_;  ///< per slot of a stage, in the order of the choices
  std::priority_queue<PartOfProblem, std::vector<PartOfProblem>, Later> queue_;
  std::uint64_t order_ = 0;
  std::set<std::string> known_;      ///< identities of feasible builds
  std::set<std::string> listed_;     ///< of those in the result
  std::vector<double> known_worth_;  ///< upper bounds of their objectives, ascending, no more than are asked for
  std::vector<Build> unproved_;      ///< found in a part that was not settled
  std::vector<RowWorth> worth_;      ///< of the whole problem, in its rows
  bool worth_known_ = false;
  std::size_t neighbours_asked_ = 0;
  std::uint64_t nodes_ = 0, evaluations_ = 0;
  Alternatives result_;
};

}  // namespace

Alternatives best_builds(const Problem& problem,
                         const Options& options,
                         std::size_t count,
                         const CoveringRows& covering,
                         const BuildIdentity& identity) {
  return AlternativeSearch(problem, options, count, covering, identity).run();
}

}  // namespace millwright::solver
