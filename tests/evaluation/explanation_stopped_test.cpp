// SPDX-License-Identifier: Apache-2.0
// An explanation that is ended: nothing that was not found out goes unsaid.
#include <atomic>

#include "evaluation/explanation.h"
#include "evaluation/hand_worked.h"

namespace explanation_stopped_test {

using namespace millwright;
using evaluation::Explanation;

TEST_CASE("When it is stopped, each condition is priced, costs nothing, or is said to be open") {
  const catalogue::Catalogue& parts = hand_worked::parts();
  text::Diagnostics diagnostics;
  std::string axis = hand_worked::axis_text("horizontal", "", "[axis.require]\ninertia_ratio = 100\n");
  axis.replace(axis.find("1 s"), 3, "3 s");  // a light drive is enough for it
  axis.replace(axis.find("50 N"), 4, "10 N");
  const auto document = text::read_toml(text::SourceText::from_string("axis.toml", axis), diagnostics);
  REQUIRE(document.has_value());
  const auto problem = machine::problem_of(*document, diagnostics);
  REQUIRE(problem.has_value());
  machine::Asked asked;
  asked.problem = *problem;
  const auto conditions = machine::conditions_of(asked, *document, parts);
  bool all_open = false, some_open = false;
  for (int last = 1;; last += 1 + last / 4) {
    std::atomic<bool> stop{false};
    std::atomic<int> solves{0};
    evaluation::SearchOptions options;
    options.stop = &stop;
    const auto stop_at_last = [&](std::size_t /*solves*/, const std::string& /*what*/) {
      if (++solves >= last) stop = true;
    };
    const Explanation found = evaluation::explain(asked, parts, conditions, options, stop_at_last);
    if (found.status != solver::Status::limit) break;
    if (!found.design) continue;
    INFO(last);
    CHECK(found.prices.size() + found.unsettled.size() + found.costless == conditions.size());
    all_open = all_open || found.unsettled.size() == conditions.size();
    some_open = some_open || (!found.unsettled.empty() && found.unsettled.size() < conditions.size());
  }
  CHECK(all_open);
  CHECK(some_open);
}

}  // namespace explanation_stopped_test
