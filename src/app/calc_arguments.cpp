// SPDX-License-Identifier: Apache-2.0
#include "app/calc_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/characters.h"
#include "text/nearest.h"

namespace millwright::app {

namespace {

using mechanics::Argument;
using mechanics::ArgumentKind;
using report::CalculationInput;
using scalar::Unit;

/// A word of the command line as a text with one line, so that a complaint can point into it.
struct Word {
  std::shared_ptr<const text::SourceText> text;
  std::string name;
  std::string value;
  text::SourceSpan name_span() const { return text::span_at(text, 0, name.size()); }
  text::SourceSpan value_span() const { return text::span_at(text, name.size() + 1, value.size()); }
};

std::string unit_name(const std::string& unit) { return unit.empty() || unit == "1" ? "without unit" : unit; }

std::string expected_text(const Argument& argument) {
  if (argument.kind == ArgumentKind::choice) return fmt::format("one of {}", fmt::join(argument.choices, ", "));
  const std::string unit = argument.unit == "1" ? "" : argument.unit == "any" ? " <unit>" : " " + argument.unit;
  if (argument.kind == ArgumentKind::list) return fmt::format("a list, e.g. {}='1{},2{}'", argument.name, unit, unit);
  return fmt::format("e.g. {}='1{}'", argument.name, unit);
}

class Reader {
 public:
  Reader(const mechanics::Formula& formula, text::Diagnostics& diagnostics)
      : formula_(formula), diagnostics_(diagnostics) {}

  std::optional<CalcArguments> read(const std::vector<std::string>& words) {
    const std::size_t errors = diagnostics_.error_count();
    for (const std::string& word : words) sort_in(word);
    words_.resize(formula_.arguments().size());
    CalcArguments result;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (words_[i])
        understand(i, result);
      else
        report_missing(formula_.arguments()[i]);
    }
    if (diagnostics_.error_count() == errors) check_lengths(result);
    if (diagnostics_.error_count() > errors) return std::nullopt;
    return result;
  }

 private:
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Argument& argument : formula_.arguments()) names.push_back(argument.name);
    return names;
  }

  void sort_in(const std::string& given) {
    Word word{text::SourceText::from_string("command line", given), {}, {}};
    const std::size_t equals = given.find('=');
    if (equals == std::string::npos) {
      diagnostics_.error(text::span_at(word.text, 0, given.size()),
                         text::in_quotes(given) + " is no argument: expected name=value",
                         fmt::format("arguments of {}: {}", formula_.name(), fmt::join(names(), ", ")));
      return;
    }
    word.name = given.substr(0, equals);
    word.value = given.substr(equals + 1);
    const std::vector<std::string> known = names();
    const auto at = std::find(known.begin(), known.end(), text::without_blanks(word.name, " "));
    if (at == known.end()) {
      diagnostics_.error(word.name_span(),
                         fmt::format("{} has no argument {}", formula_.name(), text::in_quotes(word.name)),
                         text::did_you_mean(word.name, known, fmt::format("arguments: {}", fmt::join(known, ", "))));
      return;
    }
    words_.resize(known.size());
    auto& slot = words_[static_cast<std::size_t>(at - known.begin())];
    if (slot)
      diagnostics_.error(word.name_span(), fmt::format("{} is given twice", word.name), "give each argument once");
    else
      slot = std::move(word);
  }

  void report_missing(const Argument& argument) {
    diagnostics_.error(fmt::format("{} is missing: {} [{}]",
                                   argument.name,
                                   argument.meaning,
                                   argument.kind == ArgumentKind::choice ? "a name" : unit_name(argument.unit)),
                       expected_text(argument));
  }

  void understand(std::size_t index, CalcArguments& result) {
    const Argument& argument = formula_.arguments()[index];
    const Word& word = *words_[index];
    CalculationInput input{.name = argument.name,
                           .symbol = argument.symbol,
                           .meaning = argument.meaning,
                           .given = std::string(text::without_blanks(word.value, " ")),
                           .values = {},
                           .word = {},
                           .is_list = argument.kind == ArgumentKind::list,
                           .unit = argument.unit};
    result.units.emplace_back();
    switch (argument.kind) {
      case ArgumentKind::choice:
        understand_choice(argument, word, input, result);
        break;
      case ArgumentKind::list:
        understand_numbers(argument, word, true, input, result);
        result.values.emplace_back(input.values);
        break;
      case ArgumentKind::number:
        understand_numbers(argument, word, false, input, result);
        result.values.emplace_back(input.values.empty() ? 0.0 : input.values.front());
        break;
    }
    if (input.unit == "any") input.unit = si_name(result.units.back());
    result.inputs.push_back(std::move(input));
  }

  void understand_choice(const Argument& argument, const Word& word, CalculationInput& input, CalcArguments& result) {
    // Dashes and underscores are one: people write either.
    const auto alike = [](std::string said) {
      std::replace(said.begin(), said.end(), '-', '_');
      return said;
    };
    std::string wanted = alike(input.given);
    const auto at =
        std::ranges::find_if(argument.choices, [&](const std::string& choice) { return alike(choice) == wanted; });
    if (at != argument.choices.end()) wanted = *at;
    if (at == argument.choices.end())
      diagnostics_.error(word.value_span(),
                         fmt::format("{}: {} is no choice", argument.name, text::in_quotes(input.given)),
                         text::did_you_mean(wanted, argument.choices, expected_text(argument)));
    input.word = wanted;
    result.values.emplace_back(static_cast<int>(at - argument.choices.begin()));
  }

  void understand_numbers(
      const Argument& argument, const Word& word, bool list, CalculationInput& input, CalcArguments& result) {
    std::size_t at = 0;
    const std::string& all = word.value;
    do {
      const std::size_t end = list ? std::min(all.find(',', at), all.size()) : all.size();
      const auto span = text::span_at(word.text, word.name.size() + 1 + at, end - at);
      std::string reason;
      const auto quantity = quantity_of(
          argument, std::string(text::without_blanks(std::string_view(all).substr(at, end - at), " ")), reason);
      if (!quantity) {
        diagnostics_.error(span, fmt::format("{}: {}", argument.name, reason), expected_text(argument));
      } else {
        input.values.push_back(quantity->si);
        result.units.back() = quantity->unit;
      }
      at = end + 1;
    } while (at <= all.size() && list);
  }

  std::optional<scalar::Quantity> quantity_of(const Argument& argument, const std::string& text, std::string& reason) {
    if (text.empty()) {
      reason = "a value is missing";
      return std::nullopt;
    }
    if (argument.unit != "any") return scalar::parse_quantity(text, Unit::of(argument.unit), reason);
    const std::size_t blank = std::min(text.find(' '), text.size());
    const auto unit = Unit::parse(std::string(text::without_blanks(std::string_view(text).substr(blank), " ")), reason);
    if (!unit || (any_ && !unit->fits(*any_, reason))) return std::nullopt;
    any_ = any_ ? any_ : unit;
    const auto number = scalar::parse_number(text.substr(0, blank), reason);
    if (!number) return std::nullopt;
    return scalar::Quantity{unit->to_si(*number), *unit};
  }

  static std::string si_name(const Unit& unit) {
    std::string reason;
    const std::string name = to_string(unit.dimension());
    return Unit::parse(name, reason) ? name : std::string("1");
  }

  /// Lists that belong together are equally long; the formula itself relies on it.
  void check_lengths(const CalcArguments& result) {
    for (std::size_t i = 0; i < formula_.arguments().size(); ++i) {
      const Argument& argument = formula_.arguments()[i];
      if (argument.same_length_as < 0) continue;
      const auto other = static_cast<std::size_t>(argument.same_length_as);
      const std::size_t expected = result.inputs[other].values.size();
      if (result.inputs[i].values.size() != expected)
        diagnostics_.error(words_[i]->value_span(),
                           fmt::format("{} has {} values, {} has {}",
                                       argument.name,
                                       result.inputs[i].values.size(),
                                       formula_.arguments()[other].name,
                                       expected),
                           "both lists have one value for each of the same things");
    }
  }

  const mechanics::Formula& formula_;
  text::Diagnostics& diagnostics_;
  std::vector<std::optional<Word>> words_;
  std::optional<Unit> any_;
};

}  // namespace

std::optional<CalcArguments> read_calc_arguments(const mechanics::Formula& formula,
                                                 const std::vector<std::string>& words,
                                                 text::Diagnostics& diagnostics) {
  return Reader(formula, diagnostics).read(words);
}

}  // namespace millwright::app
