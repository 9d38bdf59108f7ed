// SPDX-License-Identifier: Apache-2.0
#include "machine/currency_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "machine/quantity_reader.h"
#include "scalar/unit.h"
#include "text/table_reader.h"

namespace millwright::machine {

using text::Diagnostics;
using text::Node;
using text::TableReader;

namespace {

constexpr double smallest_rate = 1e-7;
constexpr double largest_rate = 1e7;

/// Year, month and day exist, as in 2026-01-15.
bool is_date(std::string_view word) {
  int part[3] = {0, 0, 0};
  constexpr std::size_t begin[3] = {0, 5, 8};
  constexpr std::size_t length[3] = {4, 2, 2};
  if (word.size() != 10 || word[4] != '-' || word[7] != '-') return false;
  for (int i = 0; i < 3; ++i) {
    const std::string_view digits = word.substr(begin[i], length[i]);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), part[i]);
    if (error != std::errc() || end != digits.data() + digits.size()) return false;
  }
  const auto [year, month, day] = part;
  constexpr int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (month < 1 || month > 12) return false;
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  return day >= 1 && day <= days[month - 1] + (month == 2 && leap ? 1 : 0);
}

bool is_code(const std::string& key) {
  std::string ignored;
  const auto unit = scalar::Unit::parse(key, ignored);
  return unit && unit->kind() == scalar::UnitKind::currency && unit->currency() == key;
}

class CurrencyReader {
 public:
  CurrencyReader(Problem& problem, Diagnostics& diagnostics) : problem_(problem), diagnostics_(diagnostics) {}

  void read(const Node& node) {
    describe_codes(node);
    if (node.size() == 0) {
      diagnostics_.error(node.span(), "currency: the table is empty", "write USD = 1.0, or leave [currency] out");
      return;
    }
    const std::size_t before = diagnostics_.error_count();
    for (const text::TableEntry& entry : node.entries()) read_one(entry);
    if (own_ == nullptr && diagnostics_.error_count() == before)
      diagnostics_.error(node.span(),
                         "currency: none has the rate 1",
                         "the rates say what each currency is worth in one of them, whose own rate is 1: USD = 1.0");
  }

 private:
  /// Every code is a key: a rate, or a table of rate and date.
  void describe_codes(const Node& node) {
    text::Question rate;
    rate.key = "*";
    rate.meaning = "by its code of three letters: what one unit is worth in the currency of the report";
    rate.expected = text::Expected::number;
    rate.least = smallest_rate;
    rate.most = largest_rate;
    rate.example = "1.08";
    const TableReader table(node, "[currency]", diagnostics_);
    table.describe(rate);
    rate.expected = text::Expected::table;
    table.describe(rate);
  }

  void read_one(const text::TableEntry& entry) {
    check_code(entry);
    CurrencyRate rate;
    const Node* number = &entry.value;
    if (entry.value.is_table()) {
      const std::string title = fmt::format("currency {}", entry.key);
      TableReader table(entry.value, title, diagnostics_);
      QuantityReader q(table, diagnostics_);
      number = q.required({"rate", "what one unit is worth in the currency of the report"}, "rate = 1.08");
      text::Question rate_question;
      rate_question.key = "rate";
      rate_question.expected = text::Expected::number;
      rate_question.least = smallest_rate;
      rate_question.most = largest_rate;
      table.describe(rate_question);
      text::Question date_question;
      date_question.key = "date";
      date_question.expected = text::Expected::date;
      date_question.example = "2026-01-15";
      table.describe(date_question);
      if (const Node* date = table.find({"date", "of the rate"}); date != nullptr)
        rate.date = read_date(*date, entry.key);
      table.finish();
      if (number == nullptr) return;
    }
    if (!number->is_number()) {
      diagnostics_.error(number->span(),
                         fmt::format("{}: {} where a rate is needed", entry.key, text::describe(number->kind())),
                         fmt::format("write {} = {{ rate = 1.08, date = 2026-01-15 }}", entry.key));
      return;
    }
    rate.rate = *number->as_number();
    if (!(rate.rate >= smallest_rate && rate.rate <= largest_rate)) {
      diagnostics_.error(number->span(),
                         fmt::format("{}: {:.6g} is no rate of exchange", entry.key, rate.rate),
                         fmt::format("what one {} is worth in the problem's currency, greater than zero", entry.key));
      return;
    }
    if (rate.rate == 1.0) take_as_own(entry.key, *number);
    problem_.currencies[entry.key] = rate;
  }

  void check_code(const text::TableEntry& entry) {
    if (is_code(entry.key)) return;
    std::string upper = entry.key;
    std::transform(
        upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    diagnostics_.error(entry.key_span,
                       fmt::format("currency: {} is no currency that is known here", text::in_quotes(entry.key)),
                       is_code(upper) ? fmt::format("did you mean '{}'?", upper)
                                      : "three capital letters, such as USD, EUR, GBP, CNY");
  }

  /// The one currency in which everything is added up.
  void take_as_own(const std::string& key, const Node& number) {
    if (own_ == nullptr) {
      own_ = &number;
      problem_.currency = key;
      return;
    }
    text::Diagnostic second;
    second.where = number.span();
    second.message = fmt::format("{}: a second currency with the rate 1", key);
    second.hint = "only the currency in which costs are added up has the rate 1; at par write 1.0001 or so";
    second.related = own_->span();
    second.related_message = fmt::format("{} is it already", problem_.currency);
    diagnostics_.add(std::move(second));
  }

  std::string read_date(const Node& node, const std::string& key) {
    std::string word = node.as_date().value_or(node.as_string().value_or(""));
    if (is_date(word)) return word;
    diagnostics_.error(node.span(), fmt::format("{}: date is not a date", key), "write date = 2026-01-15");
    return "";
  }

  Problem& problem_;
  Diagnostics& diagnostics_;
  const Node* own_ = nullptr;
};

}  // namespace

void read_currencies(const Node& node, Problem& problem, Diagnostics& diagnostics) {
  CurrencyReader(problem, diagnostics).read(node);
}

}  // namespace millwright::machine
