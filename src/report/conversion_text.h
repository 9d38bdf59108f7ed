// SPDX-License-Identifier: Apache-2.0
// What is said of prices that were converted: from what, at which rate, of which day.
#pragma once

#include <string>

#include "evaluation/ledger.h"

namespace millwright::report {

/// "1 EUR = 1.08 USD (2026-01-15)", "1 EUR = 1.08 USD (date not stated)" with `no_date` in those words.
std::string rate_text(const evaluation::Conversion& conversion,
                      const std::string& currency,
                      const std::string& no_date = "date not stated");

/// The rate that prices stated in a currency were converted at; null for what was not converted.
const evaluation::Conversion* conversion_from(const evaluation::Design& design, const std::string& stated_currency);

/// Its `rate_text`; empty for what was not converted.
std::string rate_of(const evaluation::Design& design, const std::string& stated_currency);

/// "45.00 EUR": a price of the design in the currency it was stated in; empty for what was not converted.
std::string stated_price(const evaluation::Design& design, const std::string& stated_currency, double price);

/// "Converted at 1 EUR = 1.08 USD (2026-01-15): y.motor 45.00 EUR, shipping from Shop A 12.00 EUR", a line for each
/// rate; empty if everything is stated in the design's currency.
std::string conversion_lines(const evaluation::Design& design, std::size_t width);

}  // namespace millwright::report
