// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/page_texts.h"
#include "report/result.h"
#include "report/text_table.h"

namespace millwright::report {

/// What is proved, what that does not cover, and how the answer was found.
std::string certificate_text(const MachineResult& result,
                             const Style& style,
                             const Texts& t = Texts(Language::english));

}  // namespace millwright::report
