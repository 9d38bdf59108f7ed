// SPDX-License-Identifier: Apache-2.0
// What a problem file asks, and what of it may be eased.
#pragma once

#include <string>
#include <vector>

#include "catch.h"
#include "machine/condition.h"
#include "machine/problem_file.h"

namespace millwright {

struct StatedConditions {
  /// `name`: of the file, in places.
  StatedConditions(const std::string& name, const std::string& toml, const catalogue::Catalogue& parts) {
    text::Diagnostics diagnostics;
    const auto document = text::read_toml(text::SourceText::from_string(name, toml), diagnostics);
    REQUIRE(document.has_value());
    const auto problem = machine::problem_of(*document, diagnostics);
    INFO(text::format(diagnostics));
    REQUIRE(problem.has_value());
    asked.problem = *problem;
    conditions = machine::conditions_of(asked, *document, parts);
  }

  machine::Asked asked;
  std::vector<machine::Condition> conditions;
};

}  // namespace millwright
