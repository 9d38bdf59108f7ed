// SPDX-License-Identifier: Apache-2.0
#include "machine/limits_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "machine/option_word.h"
#include "machine/quantity_reader.h"
#include "scalar/unit.h"
#include "text/nearest.h"
#include "text/number.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::TableReader;

namespace {

std::vector<std::string> currencies_of(const Problem& problem) {
  std::vector<std::string> codes{problem.currency};
  for (const auto& [code, rate] : problem.currencies)
    if (code != problem.currency) codes.push_back(code);
  return codes;
}

/// Where the letters begin that stand right behind an amount (400EUR), if they may be a currency; else npos.
std::size_t letters_at_end(const std::string& text) {
  constexpr std::size_t code = 3;
  std::size_t from = text.size();
  while (from > 0 && std::isalpha(static_cast<unsigned char>(text[from - 1])) != 0) --from;
  return from > 0 && text.size() - from >= code ? from : std::string::npos;
}

/// An amount in a currency of the problem, in its own; with `bare` the currency may be left out.
std::optional<double> read_amount(const std::string& text, const Problem& problem, bool bare, QuantityFault& fault) {
  const std::size_t blank = std::min({text.find(' '), letters_at_end(text), text.size()});
  const std::string number = text.substr(0, blank);
  const std::size_t unit = std::min(text.find_first_not_of(' ', blank), text.size());
  const std::string currency = text.substr(unit);
  fault.length = number.size();
  fault.hint = fmt::format("write for example {} {}", 400, problem.currency);
  const auto amount = text::parse_number(number);
  if (!amount) {
    fault.message = text::in_quotes(number) + " is not a number";
    fault.hint = number.find(',') == std::string::npos
                     ? text::number_hint(number, text::NumberPlace::alone)
                     : "decimals have a point, and nothing stands between thousands: write for example 1200.50";
    return std::nullopt;
  }
  if (!(*amount > 0.0)) {
    fault.message = *amount < 0.0 ? "must not be negative" : "must be greater than zero";
    return std::nullopt;
  }
  if (currency == problem.currency || (currency.empty() && bare)) return amount;
  if (const auto rate = problem.currencies.find(currency); rate != problem.currencies.end())
    return *amount * rate->second.rate;
  fault.offset = unit;
  fault.length = currency.size();
  fault.message = fmt::format("the problem has no rate for {}", text::in_quotes(currency));
  const std::vector<std::string> codes = currencies_of(problem);
  fault.hint = text::did_you_mean(currency, codes, fmt::format("its currencies: {}", fmt::join(codes, ", ")));
  return std::nullopt;
}

void tighten(std::optional<double>& limit, double value) { limit = std::min(limit.value_or(value), value); }

}  // namespace

void read_limits(const Node& node, Problem& problem, Diagnostics& diagnostics) {
  TableReader table(node, "[limits]", diagnostics);
  QuantityReader q(table, diagnostics);
  if (node.size() == 0)
    diagnostics.error(
        node.span(), "limits: the table is empty", "write cost = \"400 USD\", mass = \"12 kg\" or another of its keys");
  for (const QuantityDeclaration& each : quantities())
    if (each.quantity != Quantity::cost)
      problem.limits[each.quantity] = q.quantity({each.name, each.meaning}, each.unit, Sign::positive);
  text::Question amount;
  amount.expected = text::Expected::amount;
  amount.key = "cost";
  amount.meaning = declaration(Quantity::cost).meaning;
  amount.example = "\"400 USD\"";
  table.describe(amount);
  if (const Node* cost = table.find("cost"); cost != nullptr) {
    QuantityFault fault;
    problem.limits[Quantity::cost] = read_amount(cost->as_string().value_or(""), problem, false, fault);
    if (!problem.limits[Quantity::cost])
      diagnostics.error(cost->span(),
                        "cost: needs an amount above zero in a currency of the problem",
                        fmt::format("write cost = \"400 {}\"", problem.currency));
  }
  table.finish();
}

std::vector<LimitOption> add_limits(const std::vector<std::string>& words, Problem& problem, Diagnostics& diagnostics) {
  std::vector<std::string_view> names;
  for (const QuantityDeclaration& each : quantities()) names.push_back(each.name);
  const std::string example = fmt::format("--limit cost='400 {}' or --limit mass='12 kg'", problem.currency);
  std::vector<OptionWord> given;
  std::vector<LimitOption> limits;
  for (const std::string& text : words) {
    const auto word = read_option_word("--limit", text, example, diagnostics);
    if (!word) continue;
    const auto quantity = quantity_named(word->name);
    if (!quantity) {
      diagnostics.error(word->name_span(),
                        fmt::format("there is no limit of {}", text::in_quotes(word->name)),
                        text::did_you_mean(word->name, names, fmt::format("limits: {}", fmt::join(names, ", "))));
      continue;
    }
    const auto same =
        std::find_if(given.begin(), given.end(), [&](const OptionWord& other) { return other.name == word->name; });
    if (same != given.end()) {
      text::Diagnostic twice;
      twice.where = word->name_span();
      twice.message = fmt::format("the limit of {} is given twice", word->name);
      twice.hint = "give each limit once";
      twice.related = same->name_span();
      twice.related_message = "first given here";
      diagnostics.add(std::move(twice));
      continue;
    }
    given.push_back(*word);
    QuantityFault fault;
    if (const auto reason = uncountable(problem, *quantity)) {
      diagnostics.error(word->name_span(), reason->message, reason->hint);
      continue;
    }
    const QuantityDeclaration& declared = declaration(*quantity);
    const bool cost = *quantity == Quantity::cost;
    const auto value = cost ? read_amount(word->value, problem, true, fault)
                            : read_quantity(word->value, declared.unit, Sign::positive, fault);
    if (value) {
      tighten(problem.limits[*quantity], *value);
      limits.push_back({word->name, *value});
      continue;
    }
    if (fault.hint.starts_with("write for example"))
      fault.hint = fmt::format("write for example --limit {}='{}{}'",
                               declared.name,
                               declared.limit_example,
                               cost ? " " + problem.currency : std::string());
    diagnostics.error(
        word->value_span(fault.offset, fault.length), fmt::format("{}: {}", word->name, fault.message), fault.hint);
  }
  return limits;
}

}  // namespace millwright::machine
