// SPDX-License-Identifier: Apache-2.0
//
// The part of the table of page_texts.cpp that sweeps and audits need.
#pragma once

#include <vector>

#include "report/page_texts.h"

namespace millwright::report {

/// In both languages.
std::vector<PageText> sweep_and_audit_texts();

}  // namespace millwright::report
