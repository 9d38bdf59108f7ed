// SPDX-License-Identifier: Apache-2.0
#include "evaluation/condition_trials.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "solver/crew.h"

namespace millwright::evaluation {

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

ConditionTrials::ConditionTrials(const machine::Asked& asked,
                                 const catalogue::Catalogue& whole,
                                 const std::vector<machine::Condition>& conditions,
                                 const SearchOptions& options,
                                 ExplanationProgress progress,
                                 double patience)
    : asked_(asked),
      whole_(whole),
      conditions_(conditions),
      options_(options),
      progress_(std::move(progress)),
      patience_(patience),
      started_(now()) {
  options_.builds = 1;
  options_.worksheets = options_.tolerances = false;
}

double ConditionTrials::seconds() const { return now() - started_; }

const catalogue::Catalogue& ConditionTrials::catalogue_for(const machine::Asked& asked) {
  if (asked.without.empty()) return whole_;
  std::string key;
  std::vector<catalogue::Part> dropped;
  for (const machine::ExcludedPart& part : asked.without) {
    key += part.manufacturer + '\n' + part.part_number + '\n';
    dropped.insert(dropped.end(), part.rows.begin(), part.rows.end());
  }
  const std::lock_guard lock(mutex_);
  std::unique_ptr<catalogue::Catalogue>& known = catalogues_[key];
  if (!known) {
    known = std::make_unique<catalogue::Catalogue>(whole_);
    known->drop(dropped);
  }
  return *known;
}

void ConditionTrials::check_time() const {
  if (left() <= 0.0 || (options_.stop != nullptr && options_.stop->load())) throw TimeIsUp{};
}

SearchOptions ConditionTrials::begin(const std::string& what, bool patiently) {
  SearchOptions options = options_;
  {
    const std::lock_guard lock(mutex_);
    if (progress_) progress_(solves_, what);
    options.price_limits = solves_ == 0;  // to find one takes many searches: too many for each of a hundred trials
    ++solves_;
  }
  if (at_once_) options.threads = 1;
  check_time();
  options.time_limit_seconds = patiently ? left() : std::min(left(), patience_);
  return options;
}

std::optional<Design> ConditionTrials::solve(const SearchOptions& options, const Change& change) {
  machine::Asked asked = asked_;
  if (change) change(asked);
  asked.problem.counted = machine::counted_quantities(options.objectives);
  const MachineModel model(
      asked.problem, catalogue_for(asked), {}, {.fixed = asked.fixed, .objectives = options.objectives});
  if (!model.problems().empty()) return std::nullopt;
  Synthesis found = synthesise(model, options);
  if (found.status == solver::Status::limit) {
    check_time();
    throw Unsettled{};
  }
  if (found.designs.empty()) return std::nullopt;
  return std::move(found.designs.front());
}

std::optional<Design> ConditionTrials::best(const std::string& what, const Change& change, bool tolerances) {
  SearchOptions options = begin(what);
  options.tolerances = tolerances;
  return solve(options, change);
}

std::optional<Design> ConditionTrials::best_soon(const std::string& what, const Change& change) {
  return solve(begin(what, false), change);
}

std::optional<Design> ConditionTrials::best_by(const std::string& objective,
                                               const std::string& what,
                                               const Change& change) {
  SearchOptions options = begin(what);
  options.objectives = {objective};
  return solve(options, change);
}

bool ConditionTrials::possible(const std::string& what, const Change& change) {
  SearchOptions options = begin(what);
  options.objectives = {"cost"};
  options.gap = 1.0;
  return solve(options, change).has_value();
}

bool ConditionTrials::possible(const ConditionSet& imposed) {
  const auto known = known_.find(imposed);
  if (known != known_.end()) return known->second;
  const bool answer = possible("what contradicts what", [&](machine::Asked& asked) { lift_others(imposed, asked); });
  known_.emplace(imposed, answer);
  return answer;
}

void ConditionTrials::at_once(std::size_t count, const std::function<void(std::size_t)>& ask) {
  if (count < 2) {
    for (std::size_t i = 0; i < count; ++i) ask(i);
    return;
  }
  at_once_ = true;
  solver::Crew crew(static_cast<unsigned>(std::min<std::size_t>(std::max(1U, options_.threads), count)));
  try {
    crew.run(count, [&](std::size_t item, unsigned) { ask(item); });
  } catch (...) {
    at_once_ = false;
    throw;
  }
  at_once_ = false;
}

void ConditionTrials::lift_others(const ConditionSet& imposed, machine::Asked& asked) const {
  for (std::size_t i = 0; i < conditions_.size(); ++i)
    if (!std::binary_search(imposed.begin(), imposed.end(), i)) conditions_[i].lift(asked);
}

ConditionSet ConditionTrials::all() const {
  ConditionSet result(conditions_.size());
  std::iota(result.begin(), result.end(), std::size_t{0});
  return result;
}

}  // namespace millwright::evaluation
