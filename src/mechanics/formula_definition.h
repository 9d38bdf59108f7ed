// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

#include "mechanics/formula.h"

/// For the `<element>_formulas.cpp` files only: one `define(...)` registers a formula for every scalar.
///
/// To add a formula:
///  1. write it in the element's header, `template <class T> T lead(const T& pitch, const T& starts)`;
///  2. add to the element's `<element>_formulas.cpp`
///       define(list, {.name = "power_screw.lead", .handbook_id = "SCREW-LEAD", .symbol = "l", .unit = "m",
///                     .title = "Lead of a multi-start thread", .source = "khurmi_gupta2005, section 17.2"},
///              [](const auto&... x) { return power_screw::lead(x...); },
///              quantity("pitch", "p", "m", "pitch").rising(), count("starts", "starts", "number of starts").rising())
///           .valid_when("pitch < major_diameter", [](double pitch, double starts) { ... });    // if there is any
///  3. add the source to sources.bib and at least one independent value to tests/mechanics/check_values.csv.
/// Derivative, interval, dimension, trace and monotone signs are then tested without further ado.
namespace millwright::mechanics {

/// What the chained words of quantity(...), list(...) and choice(...) have in common.
template <class Self>
struct ArgumentSpec : Argument {
  Self rising() {
    return with([](Argument& a) { a.monotone = Monotone::rising; });
  }
  Self falling() {
    return with([](Argument& a) { a.monotone = Monotone::falling; });
  }
  /// The formula is stated for lower <= value <= upper only (SI). Default: everything above zero.
  Self between(double low, double high) {
    return with([&](Argument& a) { a.lower = low, a.upper = high; });
  }
  Self at_least(double low) {
    return with([&](Argument& a) { a.lower = low; });
  }
  Self any_sign() {
    return with([](Argument& a) { a.lower = -std::numeric_limits<double>::infinity(); });
  }
  /// Everyday range for tests (SI); by default taken from the unit.
  Self typical(double low, double high) {
    return with([&](Argument& a) { a.typical_lower = low, a.typical_upper = high; });
  }
  /// Of a list: as long as the list that is argument number `index` (0-based).
  Self as_long_as(int index) {
    return with([&](Argument& a) { a.same_length_as = index; });
  }

 private:
  template <class Change>
  Self with(Change change) {
    change(*this);
    return static_cast<Self&>(*this);
  }
};

struct NumberSpec : ArgumentSpec<NumberSpec> {
  template <class T>
  static const T& pick(const ArgumentValue<T>& value) {
    return *std::get_if<T>(&value);
  }
};

struct ListSpec : ArgumentSpec<ListSpec> {
  template <class T>
  static std::span<const T> pick(const ArgumentValue<T>& value) {
    return *std::get_if<std::vector<T>>(&value);
  }
};

template <class Enum>
struct ChoiceSpec : ArgumentSpec<ChoiceSpec<Enum>> {
  template <class T>
  static Enum pick(const ArgumentValue<T>& value) {
    return static_cast<Enum>(*std::get_if<int>(&value));
  }
};

namespace detail {
/// Everyday range of a unit, for arguments that name none.
std::pair<double, double> typical_range(std::string_view unit);

/// Fills in what every argument has.
void describe(
    Argument& argument, std::string name, std::string symbol, std::string unit, std::string meaning, ArgumentKind kind);
}  // namespace detail

inline NumberSpec quantity(std::string name, std::string symbol, std::string unit, std::string meaning) {
  NumberSpec spec;
  detail::describe(spec, std::move(name), std::move(symbol), std::move(unit), std::move(meaning), ArgumentKind::number);
  return spec;
}

/// A whole number of things (teeth, starts, bolts). The formula itself takes it as any other number.
inline NumberSpec count(std::string name, std::string symbol, std::string meaning) {
  NumberSpec spec = quantity(std::move(name), std::move(symbol), "1", std::move(meaning)).at_least(1).typical(1, 60);
  spec.whole = true;
  return spec;
}

/// `std::span<const T>`.
inline ListSpec list_of(std::string name, std::string symbol, std::string unit, std::string meaning) {
  ListSpec spec;
  detail::describe(spec, std::move(name), std::move(symbol), std::move(unit), std::move(meaning), ArgumentKind::list);
  return spec;
}

/// An enumeration whose enumerators count from 0 and are called `names`, in order.
template <class Enum>
ChoiceSpec<Enum> choice(std::string name, std::string symbol, std::string meaning, std::vector<std::string> names) {
  ChoiceSpec<Enum> spec;
  Argument& argument = spec;
  detail::describe(argument, std::move(name), std::move(symbol), "", std::move(meaning), ArgumentKind::choice);
  argument.choices = std::move(names);
  return spec;
}

using FormulaList = std::vector<Formula>;

namespace detail {
/// Calls the captureless lambda `Function` with the values in the types that the argument specs stand for.
template <class Result, class T, class Function, class... Spec>
Result call(std::span<const ArgumentValue<T>> values) {
  return [&]<std::size_t... I>(std::index_sequence<I...>)->Result {
    return Function{}(Spec::template pick<T>(values[I])...);
  }
  (std::index_sequence_for<Spec...>{});
}

template <class Function, class List, class... Spec>
struct MakeEvaluators;
template <class Function, class... T, class... Spec>
struct MakeEvaluators<Function, scalar::ScalarList<T...>, Spec...> {
  static Formula::Evaluators make() { return {&call<T, T, Function, Spec...>...}; }
};
}  // namespace detail

/// What define() returns, so that validity conditions can be chained to it.
template <class... Spec>
class Definition {
 public:
  explicit Definition(Formula& formula) : formula_(formula) {}

  /// `condition` takes the arguments as the formula does, on double, and tells whether the formula holds there.
  template <class Condition>
  Definition& valid_when(std::string text, Condition) {
    formula_.add_condition({std::move(text), &detail::call<bool, double, Condition, Spec...>});
    return *this;
  }

 private:
  Formula& formula_;
};

/// Registers a formula. `function` is a captureless generic lambda that forwards to the template function.
template <class Function, class... Spec>
Definition<Spec...> define(FormulaList& list, FormulaHeader header, Function, Spec... arguments) {
  auto evaluators = detail::MakeEvaluators<Function, scalar::AllScalars, Spec...>::make();
  list.emplace_back(std::move(header), std::vector<Argument>{std::move(arguments)...}, evaluators);
  return Definition<Spec...>(list.back());
}

}  // namespace millwright::mechanics
