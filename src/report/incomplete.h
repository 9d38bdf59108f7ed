// SPDX-License-Identifier: Apache-2.0
//
// Parts that could not be looked at, as they are told beside every answer that says what is best.
#pragma once

#include <string>
#include <vector>

#include "evaluation/incomplete_parts.h"
#include "report/json_value.h"
#include "report/page_texts.h"
#include "report/text_table.h"

namespace millwright::report {

/// How many there are of each family and what they lack; in full also which. Indented lines; empty if there are none.
std::string incomplete_text(const std::vector<evaluation::IncompleteParts>& parts,
                            const Style& style,
                            const Texts& t = Texts(Language::english));

/// The same in a page; not which.
std::string incomplete_html(const std::vector<evaluation::IncompleteParts>& parts, const Texts& t);

Json incomplete_of(const std::vector<evaluation::IncompleteParts>& parts);

}  // namespace millwright::report
