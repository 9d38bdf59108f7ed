// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
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
///     and with a relation or a bound beyond "above zero", watch_validity<T>(...) as the formula's first line, so that
///     a design that leaves the range is found out (validity_watch.h);
///  3. add the source to sources.bib and at least one independent value to tests/mechanics/check_values.csv.
/// Derivative, interval, dimension, trace and monotone signs are then tested without further ado.
namespace millwright::mechanics {

/// An argument as it is written down, in literals. Only add_formula makes strings of them: what stands in this header
/// is compiled once for each of hundreds of formulas.
struct ArgumentText {
  const char* name = "";
  const char* symbol = "";
  const char* unit = "";
  const char* meaning = "";
  ArgumentKind kind = ArgumentKind::number;
  Monotone monotone = Monotone::unknown;
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  std::optional<std::pair<double, double>> typical = {};
  bool whole = false;
  std::initializer_list<const char*> choices = {};  // lives as long as the define(...) it is written in
  int same_length_as = -1;
};

/// What the chained words of quantity(...), list(...) and choice(...) have in common.
template <class Self>
struct ArgumentSpec : ArgumentText {
  constexpr Self& rising() {
    monotone = Monotone::rising;
    return self();
  }
  constexpr Self& falling() {
    monotone = Monotone::falling;
    return self();
  }
  /// The formula is stated for lower <= value <= upper only (SI). Default: everything above zero.
  constexpr Self& between(double low, double high) {
    lower = low;
    upper = high;
    return self();
  }
  constexpr Self& at_least(double low) {
    lower = low;
    return self();
  }
  constexpr Self& any_sign() { return at_least(-std::numeric_limits<double>::infinity()); }
  /// Everyday range for tests (SI); by default taken from the unit.
  constexpr Self& typical(double low, double high) {
    ArgumentText::typical = {low, high};
    return self();
  }
  /// Of a list: as long as the list that is argument number `index` (0-based).
  constexpr Self& as_long_as(int index) {
    same_length_as = index;
    return self();
  }

 private:
  constexpr Self& self() { return static_cast<Self&>(*this); }
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

constexpr NumberSpec quantity(const char* name, const char* symbol, const char* unit, const char* meaning) {
  return {{{.name = name, .symbol = symbol, .unit = unit, .meaning = meaning}}};
}

/// A whole number of things (teeth, starts, bolts). The formula itself takes it as any other number.
constexpr NumberSpec count(const char* name, const char* symbol, const char* meaning) {
  NumberSpec spec = quantity(name, symbol, "1", meaning);
  spec.at_least(1).typical(1, 60).whole = true;
  return spec;
}

/// `std::span<const T>`.
constexpr ListSpec list_of(const char* name, const char* symbol, const char* unit, const char* meaning) {
  return {{{.name = name, .symbol = symbol, .unit = unit, .meaning = meaning, .kind = ArgumentKind::list}}};
}

/// An enumeration whose enumerators count from 0 and are called `names`, in order.
template <class Enum>
constexpr ChoiceSpec<Enum> choice(const char* name,
                                  const char* symbol,
                                  const char* meaning,
                                  std::initializer_list<const char*> names) {
  return {{{.name = name, .symbol = symbol, .meaning = meaning, .kind = ArgumentKind::choice, .choices = names}}};
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
struct EvaluatorsFor;
template <class Function, class... T, class... Spec>
struct EvaluatorsFor<Function, scalar::ScalarList<T...>, Spec...> {
  static constexpr Formula::Evaluators value{&call<T, T, Function, Spec...>...};
};

Formula& add_formula(FormulaList& list,
                     const FormulaHeader& header,
                     std::span<const ArgumentText* const> arguments,
                     const Formula::Evaluators& evaluators);
}  // namespace detail

/// What define() returns, so that validity conditions can be chained to it.
template <class... Spec>
class Definition {
 public:
  explicit Definition(Formula& formula) : formula_(formula) {}

  /// `condition` takes the arguments as the formula does, on double, and tells whether the formula holds there.
  template <class Condition>
  Definition& valid_when(const char* text, Condition) {
    formula_.add_condition(text, &detail::call<bool, double, Condition, Spec...>);
    return *this;
  }

 private:
  Formula& formula_;
};

/// Registers a formula. `function` is a captureless generic lambda that forwards to the template function.
template <class Function, class... Spec>
Definition<Spec...> define(FormulaList& list, const FormulaHeader& header, Function, const Spec&... arguments) {
  const std::array<const ArgumentText*, sizeof...(Spec)> texts{&arguments...};
  return Definition<Spec...>(
      detail::add_formula(list, header, texts, detail::EvaluatorsFor<Function, scalar::AllScalars, Spec...>::value));
}

}  // namespace millwright::mechanics
