// SPDX-License-Identifier: Apache-2.0
// What is said of parts that are cut: the bars they come from, and what work on pieces costs.
#pragma once

#include <string>

#include "evaluation/ledger.h"
#include "report/text_table.h"

namespace millwright::report {

/// "2 bars of 2000 mm, left over 310 + 45 mm".
std::string bars_text(const evaluation::BarPurchase& purchase);
/// "Cut from 1 bar of 2000 mm, left over 310 mm: Acme Tr10x2 (x.screw 356 + y.screw 456)", for each part.
std::string bars_lines(const evaluation::Design& design, const Style& style);
/// "Of these prices, in USD: 4.50 for cutting to length, 32.00 for machining screw ends"; empty where neither is paid.
std::string work_text(const evaluation::Design& design);

/// What is assumed of the ends of screws, and of what is left of a bar: keys of the page's texts.
const char* machining_assumption(const evaluation::Design& design);
const char* length_assumption(const evaluation::Design& design);

}  // namespace millwright::report
