// SPDX-License-Identifier: Apache-2.0
//
// The part of the table of page_texts.cpp that says what is proved.
#pragma once

#include <vector>

#include "report/page_texts.h"

namespace millwright::report {

/// In both languages.
std::vector<PageText> certificate_texts();

}  // namespace millwright::report
