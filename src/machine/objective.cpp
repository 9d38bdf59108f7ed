// SPDX-License-Identifier: Apache-2.0
#include "machine/objective.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "machine/problem.h"
#include "text/characters.h"
#include "text/diagnostic.h"
#include "text/nearest.h"
#include "text/number.h"

namespace millwright::machine {

namespace {

constexpr std::array<QuantityDeclaration, quantity_count> declarations{
    {{Quantity::cost,
      "cost",
      "",
      "Cheapest",
      "is cheaper",
      "of everything that is chosen, in a currency of the problem",
      "C-SYS-COST",
      "400"},
     {Quantity::mass, "mass", "kg", "Lightest", "is lighter", "of everything that is chosen", "C-SYS-MASS", "12 kg"},
     {Quantity::cycle_time,
      "cycle_time",
      "s",
      "Fastest",
      "is faster",
      "of all moves of all axes, with their dwells, one after the other",
      "C-SYS-CYCLE",
      "8 s"},
     {Quantity::energy,
      "energy",
      "J",
      "Most frugal",
      "takes less energy, as it is estimated",
      "that the drives take for their own moves in a cycle, as it is estimated",
      "C-SYS-ENERGY",
      "150 J"},
     {Quantity::position_error,
      "position_error",
      "m",
      "Most exact",
      "is more exact",
      "the error budgets of all axes together, or those of the tool",
      "C-SYS-ERROR",
      "0.2 mm"}}};

std::vector<std::string_view> quantity_names() {
  std::vector<std::string_view> names;
  for (const QuantityDeclaration& each : declarations) names.push_back(each.name);
  return names;
}

/// Reads terms one by one; the first fault ends it.
class ObjectiveReader {
 public:
  ObjectiveReader(std::string_view text, ObjectiveFault& fault) : text_(text), fault_(fault) {}

  std::optional<Objective> read() {
    Objective objective;
    for (;;) {
      const auto term = read_term(objective);
      if (!term) return std::nullopt;
      objective.terms.push_back(*term);
      skip_blanks();
      if (at_ == text_.size()) return objective;
      if (text_[at_] == '*')
        return fail(at_, rest_of_word(), "a weight stands before its quantity", "write for example 25*mass");
      if (text_[at_] == '-')
        return fail(at_, 1, "quantities add up: there is no minus", "every quantity is better when it is smaller");
      if (text_[at_] != '+')
        return fail(at_, rest_of_word(), "'+' is expected here", "write for example cost + 25*mass");
      ++at_;
    }
  }

 private:
  std::nullopt_t fail(std::size_t offset, std::size_t length, std::string message, std::string hint) {
    fault_ = {offset, length, std::move(message), std::move(hint)};
    return std::nullopt;
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  /// Bytes up to the next blank or sign, at least one where there is one.
  [[nodiscard]] std::size_t rest_of_word() const {
    const std::size_t end = std::min(text_.find_first_of(" \t+*", at_ + 1), text_.size());
    return at_ < text_.size() ? end - at_ : 0;
  }

  std::optional<ObjectiveTerm> read_term(const Objective& before) {
    ObjectiveTerm term;
    skip_blanks();
    if (at_ < text_.size() && (text::is_digit(text_[at_]) || text_[at_] == '.' || text_[at_] == '-')) {
      const auto weight = read_weight();
      if (!weight) return std::nullopt;
      term.weight = *weight;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && (text::begins_name(text_[at_]) || (at_ > begin && text::is_digit(text_[at_])))) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    const std::string all = fmt::format("quantities: {}", fmt::join(quantity_names(), ", "));
    if (word.empty()) return fail(begin, rest_of_word(), "the name of a quantity is expected here", all);
    const auto found = std::find_if(
        declarations.begin(), declarations.end(), [&](const QuantityDeclaration& d) { return d.name == word; });
    if (found == declarations.end())
      return fail(begin,
                  word.size(),
                  fmt::format("there is no quantity {}", text::in_quotes(word)),
                  text::did_you_mean(word, quantity_names(), all));
    term.quantity = found->quantity;
    for (const ObjectiveTerm& other : before.terms)
      if (other.quantity == term.quantity)
        return fail(begin, word.size(), fmt::format("{} is there twice", word), "add its weights up");
    return term;
  }

  /// A number above 0 and the '*' behind it.
  std::optional<double> read_weight() {
    const std::size_t begin = at_;
    if (text_[at_] == '-') ++at_;
    while (at_ < text_.size() && (text::is_digit(text_[at_]) || text_[at_] == '.' || text_[at_] == ',')) ++at_;
    // An exponent, if digits follow: else it is the name of a quantity.
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      std::size_t digits = at_ + 1;
      if (digits < text_.size() && (text_[digits] == '+' || text_[digits] == '-')) ++digits;
      if (digits < text_.size() && text::is_digit(text_[digits])) {
        at_ = digits;
        while (at_ < text_.size() && text::is_digit(text_[at_])) ++at_;
      }
    }
    const std::string_view number = text_.substr(begin, at_ - begin);
    const auto value = text::parse_number(number);
    if (!value)
      return fail(begin,
                  number.size(),
                  fmt::format("{} is not a number", text::in_quotes(number)),
                  text::number_hint(number, text::NumberPlace::alone));
    constexpr double least = 1e-12, most = 1e12;
    if (!(*value >= least && *value <= most))
      return fail(begin,
                  number.size(),
                  *value > 0.0 ? "a weight lies between 1e-12 and 1e12" : "a weight must be greater than zero",
                  "a weight is worth of one unit: 25*mass takes a kilogram for 25");
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != '*')
      return fail(at_ < text_.size() ? at_ : begin,
                  at_ < text_.size() ? rest_of_word() : number.size(),
                  "'*' and a quantity are expected behind a weight",
                  "weights are plain numbers: write for example 25*mass");
    ++at_;
    skip_blanks();
    return value;
  }

  std::string_view text_;
  ObjectiveFault& fault_;
  std::size_t at_ = 0;
};

}  // namespace

std::span<const QuantityDeclaration> quantities() { return declarations; }

const QuantityDeclaration& declaration(Quantity quantity) {
  return declarations.at(static_cast<std::size_t>(quantity));
}

std::optional<Quantity> quantity_named(std::string_view name) {
  const auto* const found = std::ranges::find(declarations, name, &QuantityDeclaration::name);
  if (found == declarations.end()) return std::nullopt;
  return found->quantity;
}

bool is_limit_of_machine(std::string_view check_id) {
  return std::ranges::find(declarations, check_id, &QuantityDeclaration::limit_id) != declarations.end();
}

bool QuantityLimits::any() const {
  return std::ranges::any_of(values_, [](const auto& limit) { return limit.has_value(); });
}

std::string Objective::name() const {
  std::string text;
  for (const ObjectiveTerm& term : terms) {
    if (!text.empty()) text += " + ";
    if (term.weight != 1.0) text += fmt::format("{}*", term.weight);
    text += declaration(term.quantity).name;
  }
  return text;
}

std::optional<Quantity> Objective::single() const {
  if (terms.size() != 1 || terms.front().weight != 1.0) return std::nullopt;
  return terms.front().quantity;
}

bool Objective::counts(Quantity quantity) const {
  return std::ranges::any_of(terms, [&](const ObjectiveTerm& term) { return term.quantity == quantity; });
}

std::optional<Objective> parse_objective(std::string_view text, ObjectiveFault& fault) {
  return ObjectiveReader(text, fault).read();
}

Objective objective_named(const std::string& name) {
  ObjectiveFault fault;
  auto objective = parse_objective(name, fault);
  if (!objective) throw std::invalid_argument(fmt::format("objective '{}': {}", name, fault.message));
  return *std::move(objective);
}

std::vector<Quantity> counted_quantities(const std::vector<std::string>& names) {
  std::vector<Quantity> counted;
  for (const std::string& name : names)
    for (const ObjectiveTerm& term : objective_named(name).terms)
      if (term.quantity != Quantity::cost && term.quantity != Quantity::mass) counted.push_back(term.quantity);
  std::sort(counted.begin(), counted.end());
  counted.erase(std::unique(counted.begin(), counted.end()), counted.end());
  return counted;
}

std::optional<Uncountable> uncountable(const Problem& problem, Quantity quantity) {
  if (quantity != Quantity::position_error) return std::nullopt;
  if (problem.tool && problem.tool->position_error) return std::nullopt;
  const std::string example = "position_error = { limit = \"0.1 mm\", over = \"300 mm\" }";
  bool travels = false;
  for (const Axis& axis : problem.axes) {
    if (is_rotary(axis)) continue;
    travels = true;
    if (!axis.require.known(Requirement::position_error))
      return Uncountable{fmt::format("position_error: axis '{}' has no error budget", axis.name),
                         fmt::format("add {} to its [axis.require], with a limit that is not to be exceeded", example)};
  }
  if (!travels) return Uncountable{"position_error: no axis goes along a length", "ask for another quantity"};
  return std::nullopt;
}

bool cycle_time_hangs_on_ramp(const Axis& axis) {
  return !axis.acceleration_time.fixed() && std::any_of(axis.moves.begin(), axis.moves.end(), [](const Move& move) {
    return move.counts_in_cycle && move.speed && uses_chosen_ramp(move);
  });
}

}  // namespace millwright::machine
