// SPDX-License-Identifier: Apache-2.0
#include "report/conversion_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/text_table.h"

namespace millwright::report {

using evaluation::Conversion;
using evaluation::Design;

std::string rate_text(const Conversion& conversion, const std::string& currency, const std::string& no_date) {
  return fmt::format("1 {} = {} {} ({})",
                     conversion.currency,
                     conversion.rate,  // as it was stated: no digit is dropped
                     currency,
                     conversion.date.empty() ? no_date : conversion.date);
}

const Conversion* conversion_from(const Design& design, const std::string& stated_currency) {
  const auto found = std::find_if(design.conversions.begin(), design.conversions.end(), [&](const Conversion& each) {
    return each.currency == stated_currency;
  });
  return found == design.conversions.end() ? nullptr : &*found;
}

std::string rate_of(const Design& design, const std::string& stated_currency) {
  const Conversion* conversion = conversion_from(design, stated_currency);
  return conversion == nullptr ? std::string() : rate_text(*conversion, design.currency);
}

std::string stated_price(const Design& design, const std::string& stated_currency, double price) {
  const Conversion* conversion = conversion_from(design, stated_currency);
  return conversion == nullptr ? std::string() : fmt::format("{:.2f} {}", price / conversion->rate, stated_currency);
}

std::string conversion_lines(const Design& design, std::size_t width) {
  std::string out;
  for (const Conversion& conversion : design.conversions) {
    std::string line;
    const auto add = [&](const std::string& what, const std::string& stated_currency, double price) {
      if (stated_currency == conversion.currency && price > 0.0)
        line += fmt::format("{}{} {}", line.empty() ? "" : ", ", what, stated_price(design, stated_currency, price));
    };
    for (const evaluation::PartLine& part : design.parts)
      add(part.axis + "." + part.slot, part.stated_currency, part.price);
    for (const evaluation::ShopOrder& order : design.orders) {
      add("shipping from " + order.supplier, order.stated_currency, order.shipping_fee);
      add("filling up the order from " + order.supplier, order.stated_currency, order.top_up);
    }
    out += "  " + wrapped(fmt::format("Converted at {}: {}", rate_text(conversion, design.currency), line), width, 4) +
           "\n";
  }
  return out;
}

}  // namespace millwright::report
