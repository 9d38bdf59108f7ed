// SPDX-License-Identifier: Apache-2.0
//
// What a label makes superfluous: by hand, without slack and with a tenth of the totals.
#include "solver/dominance.h"

#include <cmath>
#include <deque>

#include "catch.h"

namespace dominance_test {

namespace {

using namespace millwright::solver;

enum Score : std::size_t { cost, mass, tie };

/// Cost and mass are the objectives, and something decides between equals. Of the state less is better.
class Labels {
 public:
  explicit Labels(double slack, double mass_limit = infinity) {
    criteria_.objectives = 2;
    criteria_.ties = 1;
    criteria_.weight = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    criteria_.limit = {infinity, mass_limit, infinity};
    set_.emplace(criteria_, directions_, store_, Dominating::point, slack);
  }

  const Label& add(std::vector<double> score, double state, double utilisation = 0.5) {
    Label label;
    label.score = label.score_lower = std::move(score);
    label.state = {state};
    label.enclosure = {Interval(state)};
    label.utilisation = utilisation;
    store_.push_back(std::move(label));
    set_->add(static_cast<std::uint32_t>(store_.size() - 1));
    return store_.back();
  }
  [[nodiscard]] bool dominate(std::vector<double> score,
                              double state,
                              double utilisation = 0.5,
                              std::vector<double> total = {20.0, 4.0, 0.0}) const {
    const std::vector<Interval> states{Interval(state)};
    return set_->dominates({score, states, utilisation}, total);
  }

 private:
  Criteria criteria_;
  std::vector<Direction> directions_{Direction::smaller_is_better};
  std::deque<Label> store_;
  std::optional<LabelSet> set_;
};

TEST_CASE("A label makes superfluous what is no better in anything") {
  Labels labels(0.0);
  labels.add({10.0, 2.0, 5.0}, 1.0);
  CHECK(labels.dominate({10.5, 2.0, 0.0}, 1.0));
  CHECK(labels.dominate({10.0, 2.0, 5.0}, 1.0));
  CHECK(labels.dominate({10.0, 2.0, 6.0}, 1.5));
  CHECK_FALSE(labels.dominate({10.0, 2.0, 4.0}, 1.0));       // wins the tie
  CHECK_FALSE(labels.dominate({10.0, 2.0, 5.0}, 1.0, 0.4));  // likewise
  CHECK_FALSE(labels.dominate({9.9999, 3.0, 9.0}, 2.0));
  CHECK_FALSE(labels.dominate({11.0, 3.0, 9.0}, 0.9999));
}

TEST_CASE("With slack objectives may be better by a part of the whole, and nothing else") {
  Labels labels(0.1);
  labels.add({10.0, 2.0, 5.0}, 1.0);
  CHECK(labels.dominate({8.01, 1.61, 0.0}, 1.0));
  CHECK_FALSE(labels.dominate({7.99, 2.0, 9.0}, 1.0));
  CHECK_FALSE(labels.dominate({10.0, 1.59, 9.0}, 1.0));
  CHECK_FALSE(labels.dominate({12.0, 3.0, 9.0}, 0.9999));
  CHECK(labels.dominate({10.0, 2.0, 5.0}, 1.0, 0.4));
  CHECK_FALSE(labels.dominate({10.0, 2.0, 4.0}, 1.0));  // equals still win the tie
  // Nothing is known of a total that is only known to be more than something negative.
  CHECK_FALSE(labels.dominate({9.0, 2.0, 9.0}, 1.0, 0.5, {-20.0, 4.0, 0.0}));
}

TEST_CASE("What has a limit has no slack: what exceeds it could stand for what keeps it") {
  Labels labels(0.1, 4.1);
  labels.add({10.0, 2.0, 5.0}, 1.0);
  CHECK(labels.dominate({8.01, 2.0, 9.0}, 1.0));
  CHECK_FALSE(labels.dominate({10.0, 1.99, 9.0}, 1.0));
}

TEST_CASE("A label is forgotten only for one that is as good without slack") {
  Labels labels(0.1);
  const Label& known = labels.add({10.0, 2.0, 5.0}, 1.0);
  labels.add({8.5, 2.0001, 5.0}, 1.0);
  CHECK(known.alive);
  labels.add({9.9, 2.0, 5.0}, 1.0);
  CHECK_FALSE(known.alive);
}

}  // namespace

}  // namespace dominance_test
