// SPDX-License-Identifier: Apache-2.0
#include "report/explanation_conflicts.h"

#include "catch.h"

namespace explanation_conflicts_test {

using namespace millwright;

TEST_CASE("Ways out of a conflict are only called enough where one of them is") {
  evaluation::Explanation explanation;
  for (const char* name : {"--limit cost", "--limit mass"}) {
    machine::Condition condition;
    condition.axis = "machine";
    condition.name = name;
    condition.kind = machine::ConditionKind::budget;
    condition.value = 40.0;
    explanation.conditions.push_back(condition);
  }
  evaluation::Relaxation first, second;
  first.condition = 0;
  second.condition = 1;
  first.enough = second.enough = false;
  explanation.conflicts = {{{0, 1}, {first, second}}};
  const std::string none = report::conflicts_text({}, explanation, {});
  CAPTURE(none);
  CHECK(none.find("Taken alone, none of these is enough:") != std::string::npos);
  CHECK(none.find("Any one of these is enough") == std::string::npos);
  explanation.conflicts[0].ways[0].enough = true;
  const std::string one = report::conflicts_text({}, explanation, {});
  CHECK(one.find("This is enough, proved by solving") != std::string::npos);
  explanation.conflicts[0].ways[1].enough = true;
  const std::string both = report::conflicts_text({}, explanation, {});
  CHECK(both.find("Any one of these is enough, proved by solving") != std::string::npos);
}

}  // namespace explanation_conflicts_test
