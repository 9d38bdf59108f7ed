// SPDX-License-Identifier: Apache-2.0
// The checks that an explanation speaks of: what sets their limits, and where their formulas come from.
#pragma once

#include <string>
#include <vector>

#include "evaluation/explanation.h"
#include "report/text_table.h"

namespace millwright::report {

/// The check of a build that is nearest to its limit, if any is near; budgets are no checks here.
const evaluation::Check* tightest_check(const evaluation::Design& design);

struct NamedCheck {
  std::string id, title;
  std::string requirement;  ///< key of the factor or limit, empty if none
  std::string source;       ///< key in sources.bib, and the place there
};

/// Those that fail or nearly do in what is told, and those whose limits are among what is asked. Each once, by id.
std::vector<NamedCheck> named_checks(const evaluation::Explanation& explanation);

std::string named_checks_text(const evaluation::Explanation& explanation, const Style& style);

}  // namespace millwright::report
