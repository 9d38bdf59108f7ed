// SPDX-License-Identifier: Apache-2.0
//
// What candidates.h promises, against every design of a small stage: whatever is feasible for a label and may lead on
// to something is covered by a candidate of the label's group, whether the groups are asked about together or alone.
#include "solver/candidates.h"

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <random>

#include "catch.h"
#include "sanitized.h"
#include "solver/model_stage.h"
#include "solver/rest_curve.h"
#include "solver/rest_plane.h"

namespace candidates_test {

namespace {

using namespace millwright::solver;

constexpr double infinity = std::numeric_limits<double>::infinity();
enum Column : std::size_t { price, mass, strength, power, patience, columns };

/// A head whose rows make the labels, the stage that is asked about, and a tail that decides what leads on. State: a
/// load, and for some a power, of which the tail needs little, much, or neither too little nor too much.
struct Chain {
  explicit Chain(unsigned seed) : rng(seed) {
    const auto one_in = [&](unsigned n) { return rng() % n == 0; };
    const bool with_power = !one_in(3), timed = one_in(2), ballast = one_in(4), stepped = one_in(2), least = one_in(2);
    const bool little = with_power && !one_in(4), much = with_power && (!little || one_in(3));
    const double load_gain = one_in(2) ? 1.0 : 0.6, power_gain = one_in(3) ? -0.5 : 1.0;
    const double power_by_load = 0.4 * (static_cast<double>(rng() % 3) - 1.0), drag = one_in(2) ? 0.0 : 0.2;
    const double price_of_load = one_in(3) ? 0.3 : 0.0;
    const std::vector<const Columns*> parts{&table(4 + rng() % 4), &table(4 + rng() % 5)};
    const auto add = [&](auto stage) {
      problem.stages.push_back(stages.emplace_back(std::make_unique<decltype(stage)>(std::move(stage))).get());
    };
    add(model_stage("head", {&table(40)}, {}, 1, [=](const auto& in, auto& out) {
      out.utilisation.push_back(0.0 * in.row(0, mass));
      out.resources.assign({in.row(0, price), in.row(0, mass)});
      out.handed_on.push_back(in.row(0, strength) * 0.4);
      if (with_power) out.handed_on.push_back(in.row(0, power));
    }));
    const auto middle = [=](const auto& in, auto& out) {
      using millwright::scalar::floor_of;
      const auto own_load = in.state(0) + in.row(0, mass);
      const auto steps = -3.0 * floor_of(-(0.4 * in.row(1, power) + own_load) / 3.0);
      const auto load = with_power ? own_load + drag * in.state(1) : own_load;
      out.utilisation.push_back((timed ? load * (1.0 + 0.1 / in.variable(0)) : load) / in.row(1, strength));
      if (timed) out.utilisation.push_back(in.variable(0) * (1.0 + 0.1 * load) / in.row(1, patience));
      if (ballast) out.utilisation.push_back(0.4 * in.row(1, strength) / load);
      const auto paid = in.row(0, price) + in.row(1, price) + price_of_load * in.state(0);
      out.resources.assign({paid, in.row(0, mass) + in.row(1, mass)});
      const auto carried = load_gain * in.state(0) + out.resources[1];
      out.handed_on.push_back(stepped && !with_power ? carried + steps : carried);
      if (!with_power) return;
      const auto drawn = power_gain * in.state(1) + power_by_load * in.state(0);
      out.handed_on.push_back(drawn + (stepped ? 0.7 * steps : in.row(1, power)));
    };
    const auto count = [](auto... flags) { return (std::size_t{1} + ... + (flags ? 1U : 0U)); };
    const std::vector<Variable> times(timed ? 1 : 0, {"time", 0.1, 1.0});
    add(model_stage("middle", parts, times, count(timed, ballast), middle));
    add(model_stage("tail", {&table(4)}, {}, count(least, little, much), [=](const auto& in, auto& out) {
      out.utilisation.push_back(in.state(0) / (0.8 * in.row(0, strength)));
      if (least) out.utilisation.push_back(0.2 * in.row(0, strength) / in.state(0));
      if (little) out.utilisation.push_back(in.state(1) / (2.0 * in.row(0, power)));
      if (much) out.utilisation.push_back((20.0 - in.state(1)) / (2.0 * in.row(0, power)));
      out.resources.assign({in.row(0, price), in.row(0, mass)});
      for (std::size_t c = 0; c < (with_power ? 2U : 1U); ++c) out.handed_on.push_back(in.state(c));
    }));
    problem.first_state.assign(with_power ? 2 : 1, 0.0);
    problem.resources = {{"price"}, {"mass"}};
  }
  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(rng()) / 4294967296.0; }
  const Columns& table(std::size_t rows) {
    Columns& made = *tables.emplace_back(std::make_unique<Columns>(Columns{"table", columns, {}}));
    for (std::size_t row = 0; row < rows; ++row) {
      const double size = uniform(1.0, 5.0), light = uniform(0.7, 2.5), watts = uniform(1.5, 2.5) * size;
      for (const double x : {3.0 * size * light, size / light, uniform(4.0, 6.0) * size, watts, uniform(0.3, 2.0)})
        made.numbers.push_back(std::ceil(x / unit) * unit);
    }
    return made;
  }

  std::mt19937 rng;
  const double unit = rng() % 2 == 0 ? 1.0 : 1e-3;  ///< whole numbers tie: else no two states are equal
  Problem problem;
  std::vector<std::unique_ptr<Columns>> tables;
  std::vector<std::unique_ptr<Stage>> stages;
};

/// At a state, feasible at some value of a grid of the variable.
struct Design {
  Pair score;
  std::vector<double> handed_on;
  std::vector<Pair> totals = {};  ///< with a label and every feasible tail
};
using Designs = std::map<std::vector<Row>, Design>;
struct Label {
  std::vector<double> state;
  Pair score;
  Designs designs;  ///< of the middle stage
};
using Labels = std::vector<Label>;
struct Counts {
  std::size_t compared = 0, left_out = 0, useless = 0, universal = 0, others = 0, inexact = 0, rests = 0, vectors = 0,
              mixed = 0, soon = 0, varying = 0, beaten_before_ties = 0;
  std::array<std::size_t, 4> directions = {};  ///< [Direction]
};
bool is_feasible(const Answer<double>& answer) { return std::ranges::max(answer.utilisation) <= 1.0; }
double value_of(const Mix& mix, const Pair& score) { return mix.first * score.first + mix.second * score.second; }
bool below(const std::vector<Pair>& all, const Pair& p) { return below_staircase(all, p.first, p.second); }
bool at_least(double a, double b) { return a >= b - 1e-9 * (1.0 + std::fabs(b)); }

class Trial {
 public:
  Trial(bool totals, Counts& counts, unsigned seed) : by_totals_(totals), counts_(counts), chain_(seed) {}
  void run(const Options& options) {
    criteria_ = make_criteria(chain_.problem, options);
    plans_ = make_plans(chain_.problem, {}, criteria_, desk_);
    if (plans_.empty()) return;
    for (const StagePlan& plan : plans_) forms_.push_back(find_state_form(plan, desk_));
    REQUIRE((forms_[1].additive && !plan().any_moves_outcome));  // else nobody asks for candidates
    counts_.varying += forms_[1].scores_vary() ? 1 : 0;
    for (std::size_t h = 0; h < plan().after.size(); ++h) {
      ++counts_.directions.at(static_cast<std::size_t>(plan().after[h]));
      counts_.inexact += !forms_[1].exact[h] && plan().after[h] != Direction::irrelevant ? 1 : 0;
    }
    for (const auto& [row, head] : designs_of(0, chain_.problem.first_state))
      if (bearable(plans_[0], head.handed_on)) add_label(head.handed_on, head.score);
    std::sort(labels_.begin(), labels_.end(), [](const Label& a, const Label& b) { return a.state < b.state; });
    if (totals_.empty()) return;
    if (by_totals_) find_rests();
    const Comparison comparison(criteria_, plan().after, Compared::everything);
    for (const std::size_t count : {1U, 2U, 3U, 8U}) compare(std::min(count, labels_.size()), comparison);
  }

 private:
  [[nodiscard]] const StagePlan& plan() const { return plans_[1]; }
  [[nodiscard]] Pair pair_of(std::span<const double> score) const { return {score[0], criteria_.second(score)}; }
  /// By asking for nothing but single designs.
  [[nodiscard]] Designs designs_of(std::size_t index, const std::vector<double>& state) const {
    const Stage& stage = *chain_.problem.stages[index];
    Designs designs;
    std::vector<Row> rows(stage.slots().size(), 0);
    for (std::size_t slot = 0; slot < rows.size();) {
      for (double time = 0.1; time <= 1.0; time += 0.05) {
        const std::vector<double> values(stage.variables().size(), time);
        Answer<double> answer;
        stage.evaluate({{}, state, rows, values}, answer);
        if (!is_feasible(answer)) continue;
        designs[rows] = {pair_of(answer.resources), answer.handed_on};
        break;  // time moves neither score nor state
      }
      for (slot = 0; slot < rows.size() && ++rows[slot] == stage.slots()[slot].rows; ++slot) rows[slot] = 0;
    }
    return designs;
  }
  void add_label(const std::vector<double>& state, const Pair& score) {
    Label& label = labels_.emplace_back(Label{state, score, designs_of(1, state)});
    for (auto& [rows, design] : label.designs) {
      const Pair sum{score.first + design.score.first, score.second + design.score.second};
      for (const auto& [row, tail] : designs_of(2, design.handed_on))
        design.totals.push_back({sum.first + tail.score.first, sum.second + tail.score.second});
      totals_.insert(totals_.end(), design.totals.begin(), design.totals.end());
    }
  }
  /// A staircase a little above the best totals, and what must follow on what is handed on.
  void find_rests() {
    const bool front = criteria_.objectives > 1;
    find_rest_curves(plans_, std::vector<double>(criteria_.size(), infinity), CurveEffort::thorough(), desk_);
    RestPlanes planes(chain_.problem, plans_, forms_, desk_);
    for (const Mix& mix : {Mix{1.0, 0.0}, Mix{1.0, front ? 2.0 : 0.0}}) {
      const Pair best = std::ranges::min(totals_, {}, [&](const Pair& total) { return value_of(mix, total); });
      planes.find(mix, value_of(mix, best));
      corners_.push_back({1.2 * best.first, front ? 1.2 * best.second : infinity});
    }
    corners_ = upper_staircase(corners_);
    counts_.rests += plan().curves.size() + plan().planes.size() + plan().stairs.size();
    CHECK(planes.find_vectors(corners_));  // the best are below some corner
    counts_.vectors += plan().vectors.add.empty() ? 0 : 1;
  }
  /// What the labels and all that follows come to, coordinate by coordinate.
  void ask_vectors(const Labels& labels, CandidateQuestion& question) {
    const RestVectors& rest = plan().vectors;
    if (rest.add.empty()) return;
    const std::vector<double> nothing(labels.front().state.size(), 0.0);
    VectorSet all(rest.add.dimensions());
    for (const Label& label : labels) {
      std::vector<double> vector{label.score.first, label.score.second};
      for (const std::vector<double>& use : rest.use) {
        double taken = 0.0;
        for (std::size_t h = 0; h < use.size(); ++h) taken += use[h] * forms_[1].change(h, nothing, label.state);
        vector.push_back(taken);
      }
      all.add(vector);
    }
    const std::size_t most = 1 + chain_.rng() % 20;  // few: they stand for others
    question.total_vectors = {
        rest.limit, rest.use, sum_of_vectors(lower_vectors(all, most), rest.add, 2 * most, [](auto) { return true; })};
    if (criteria_.objectives < 2) return;
    question.mix = Mix{1.0, 3.0};
    ++counts_.mixed;
  }
  /// As the search asks (stagewise_chunks.cpp).
  void ask_totals(const Labels& labels, CandidateQuestion& question) const {
    const auto least = [&](const Mix& mix, const std::vector<double>& weight) {
      double value = infinity;
      for (const Label& label : labels) {
        double sum = value_of(mix, label.score);
        for (std::size_t h = 0; h < weight.size(); ++h)
          sum += weight[h] * forms_[1].change(h, std::vector<double>(weight.size(), 0.0), label.state);
        value = std::min(value, sum);
      }
      return value - 1e-11 * std::fabs(value);
    };
    question.totals = plan().planes;
    question.total_stairs = plan().stairs;
    for (RestPlane& plane : question.totals) plane.constant += least(plane.mix, plane.weight);
    for (RestStairs& stairs : question.total_stairs) {
      stairs.constant += least(stairs.mix, stairs.weight);
      stairs.limit = stairs.limit * (1.0 + 1e-11) - least({0.0, 0.0}, stairs.use);
    }
    question.corners = corners_;
    question.least = {least({1.0, 0.0}, {}), least({0.0, 1.0}, {})};
  }
  CandidateQuestion ask(const Labels& labels, const Comparison& comparison) {
    CandidateQuestion question;
    question.plan = &plan();
    question.form = &forms_[1];
    question.comparison = &comparison;
    question.useful = question.corners = {{infinity, infinity}};
    for (const double own : labels.front().state) question.states.emplace_back(own);
    for (const Label& label : labels)
      for (std::size_t c = 0; c < label.state.size(); ++c)
        question.states[c] = hull(question.states[c], Interval(label.state[c]));
    if (by_totals_) ask_totals(labels, question);
    if (by_totals_) ask_vectors(labels, question);
    if (by_totals_ || chain_.rng() % 2 == 0) return question;
    const Pair corner{chain_.uniform(15.0, 40.0), chain_.uniform(1.5, 8.0)};
    question.useful = upper_staircase({{chain_.uniform(10.0, 25.0), infinity}, corner});
    return question;
  }
  void compare(std::size_t count, const Comparison& comparison) {
    std::vector<Labels> groups(count);
    for (std::size_t i = 0; i < labels_.size(); ++i) groups[i * count / labels_.size()].push_back(labels_[i]);
    std::deque<CandidateQuestion> questions;
    std::vector<const CandidateQuestion*> asked;
    for (const Labels& labels : groups) asked.push_back(&questions.emplace_back(ask(labels, comparison)));
    const std::vector<CandidateSet> together = find_candidates(asked, desk_);
    for (std::size_t g = 0; g < count; ++g) {
      INFO("group " << g << " of " << count);
      for (const CandidateSet& set : {together.at(g), find_candidates(std::span(&asked[g], 1), desk_).at(0)}) {
        CHECK(set.complete);
        for (const Candidate& candidate : set.candidates) ++(candidate.universal ? counts_.universal : counts_.others);
        for (const Label& label : groups[g]) check_coverage(label, questions[g], check(label, set));
      }
    }
    questions.front().node_limit = 1 + chain_.rng() % 30;  // what is found soon need not be all, but it is true
    const std::vector<CandidateSet> soon = find_candidates(asked, desk_);
    for (std::size_t g = 0; g < count; ++g) {
      counts_.soon += soon.at(g).candidates.size();
      for (const Label& label : groups[g]) check(label, soon[g]);
    }
  }
  /// Whether candidates are what they are said to be. What those that are feasible for the label are worth there.
  std::map<std::vector<Row>, std::vector<double>> check(const Label& label, const CandidateSet& set) {
    std::map<std::vector<Row>, std::vector<double>> worths;
    for (const Candidate& candidate : set.candidates) {
      Answer<double> answer;
      plan().stage->evaluate({{}, label.state, candidate.rows, candidate.variables}, answer);
      if (candidate.universal && !is_feasible(answer)) FAIL("not universal");
      std::vector<double> score(criteria_.size());
      criteria_.scores<double>(answer.resources, score);
      for (std::size_t k = 0; k < score.size(); ++k)
        if (!at_least(score[k], candidate.score[k]) || !at_least(candidate.most_score[k], score[k]))
          FAIL("adds more or less");
      for (std::size_t h = 0; h < answer.handed_on.size(); ++h) {
        const double on = answer.handed_on[h] - forms_[1].change(h, set.reference, label.state);
        if (!at_least(on, candidate.least[h]) || !at_least(candidate.most[h], on)) FAIL("hands on more or less");
      }
      if (candidate.universal || label.designs.contains(candidate.rows))
        worths[candidate.rows] = worth_of({pair_of(answer.resources), answer.handed_on});
    }
    return worths;
  }
  void check_coverage(const Label& label,
                      const CandidateQuestion& question,
                      const std::map<std::vector<Row>, std::vector<double>>& worths) {
    for (const auto& [rows, design] : label.designs) {
      const auto leads_on = [&](const Pair& total) { return below(corners_, total); };
      const bool matters = by_totals_ ? std::ranges::any_of(design.totals, leads_on)
                                      : bearable(plan(), design.handed_on) && below(question.useful, design.score);
      ++(matters ? counts_.compared : counts_.useless);
      if (!matters) continue;
      counts_.left_out += worths.contains(rows) ? 0 : 1;
      const std::vector<double> worth = worth_of(design);
      const auto covers = [&](const auto& other) { return std::ranges::equal(worth, other.second, at_least); };
      if (std::ranges::any_of(worths, covers)) continue;
      // What is better in the objective need not be as good in what decides between equals.
      const auto wins = [&](const auto& other) {
        return other.second[0] < worth[0] &&
               std::ranges::equal(std::span(worth).subspan(2), std::span(other.second).subspan(2), at_least);
      };
      if (criteria_.ties == 0 || std::ranges::none_of(worths, wins)) FAIL("not covered");
      ++counts_.beaten_before_ties;
    }
  }
  /// All that can still matter, so that smaller is better.
  [[nodiscard]] std::vector<double> worth_of(const Design& design) const {
    std::vector<double> worth{design.score.first, design.score.second};
    for (std::size_t h = 0; h < design.handed_on.size(); ++h) {
      const auto is = [&](Direction d) { return plan().after[h] == d || plan().after[h] == Direction::equal_only; };
      if (is(Direction::smaller_is_better)) worth.push_back(design.handed_on[h]);
      if (is(Direction::larger_is_better)) worth.push_back(-design.handed_on[h]);
    }
    return worth;
  }
  bool by_totals_;  ///< what matters is told by totals below a staircase, not by own shares
  Counts& counts_;
  Chain chain_;
  Criteria criteria_;
  Desk desk_;
  std::vector<StagePlan> plans_;
  std::vector<StateForm> forms_;
  Labels labels_;
  std::vector<Pair> totals_, corners_;
};

}  // namespace

TEST_CASE("The candidates of groups of labels cover every design that matters to one") {
  for (const bool totals : {false, true}) {
    const std::size_t chains = millwright::sanitized ? 12 : 60;
    const std::size_t seeds = totals ? 3 * chains : chains;  // few designs matter by totals
    Counts counts;
    for (unsigned seed = 0; seed < seeds; ++seed) {
      INFO("seed " << seed << (totals ? ", by totals" : ", by own shares"));
      Options options;
      if (seed % 3 == 1) options.objectives = {0, 1};
      if (seed % 3 == 2) options.ties = {1};
      Trial(totals, counts, seed).run(options);
    }
    CHECK(counts.compared > 100 * seeds);
    CHECK(std::min(counts.left_out, counts.useless) > counts.compared / 20);
    CHECK(std::min(counts.universal, counts.others) > 20 * seeds);
    CHECK(counts.inexact > seeds / 4);
    CHECK(std::min(counts.varying, counts.beaten_before_ties) > seeds / 10);
    CHECK(counts.soon > 10 * seeds);
    CHECK(std::ranges::min(std::span(counts.directions).subspan(1)) > seeds / 10);
    CHECK(counts.rests >= (totals ? seeds : 0));
    CHECK(2 * counts.vectors >= (totals ? seeds / 20 : 0));
    CHECK(counts.mixed >= (totals && !millwright::sanitized ? seeds / 10 : 0));  // there are few in the first chains
  }
}

}  // namespace candidates_test
