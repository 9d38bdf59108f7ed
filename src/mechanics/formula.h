// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "scalar/scalars.h"

/// The registry of formulas: what exists, what it needs, where it holds and where it comes from.
///
/// A formula is a template function in the header of its machine element (`power_screw.h`). It is registered once,
/// in `<element>_formulas.cpp`, by one `define(...)` (see formula_definition.h, which also tells how to add one).
/// From that one entry come `calc`, `formulas`, the audit and the consistency tests, on every scalar of
/// scalar/scalars.h.
namespace millwright::mechanics {

/// The value of one argument: a number, a list of numbers, or the index of an enumerator.
template <class T>
using ArgumentValue = std::variant<T, std::vector<T>, int>;

enum class ArgumentKind { number, list, choice };

/// How the result answers to a growing argument, all others held, inside the stated validity and while no argument is
/// negative. Tested, not proved: a proof over a box takes the sign of Dual<Interval>.
enum class Monotone { unknown, rising, falling };

/// One argument of a formula. `lower` and `upper` state where the formula holds, in SI (zero excluded where the
/// formula divides by it); `typical_lower` and `typical_upper` are a plausible range of everyday machines, from
/// which tests draw their points. The unit `any` stands for whatever the caller uses, the same in all arguments.
struct Argument {
  std::string name;
  std::string symbol;
  std::string unit;
  std::string meaning;
  ArgumentKind kind = ArgumentKind::number;
  Monotone monotone = Monotone::unknown;
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  double typical_lower = 0.0;
  double typical_upper = 0.0;
  bool whole = false;                // a count
  std::vector<std::string> choices;  // names of the enumerators, in order, when kind is choice
  int same_length_as = -1;           // of a list: index of the argument whose length it shares
};

/// A relation between arguments that has to hold for the formula to hold.
struct Validity {
  using Holds = bool (*)(std::span<const ArgumentValue<double>>);
  std::string text;
  Holds holds;
};

/// A stated limit that given values break. `index` tells the limits of one formula apart, `excess` is how far a value
/// lies beyond its bound (0 for relations).
struct BrokenLimit {
  std::size_t index = 0;
  double excess = 0.0;
  std::string sentence;
};

/// What the person who registers a formula writes about it. `source` is "key, place; key, place" with keys of
/// sources.bib. `display_unit` is given where people do not read the SI unit.
template <class Text>
struct FormulaText {
  Text name = {};
  Text handbook_id = {};
  Text symbol = {};
  Text unit = {};
  Text display_unit = {};
  Text title = {};
  Text source = {};
  Text validity = {};
};
/// Literals: hundreds of registrations that built strings would take the compiler minutes.
using FormulaHeader = FormulaText<std::string_view>;

template <class T>
using Evaluator = T (*)(std::span<const ArgumentValue<T>>);

namespace detail {
template <class List>
struct EvaluatorsOf;
template <class... T>
struct EvaluatorsOf<scalar::ScalarList<T...>> {
  using type = std::tuple<Evaluator<T>...>;
};
}  // namespace detail

class Formula {
 public:
  using Evaluators = detail::EvaluatorsOf<scalar::AllScalars>::type;

  Formula(const FormulaHeader& header, std::vector<Argument> arguments, const Evaluators& evaluators);

  const std::string& name() const { return header_.name; }
  const std::string& handbook_id() const { return header_.handbook_id; }
  const std::string& symbol() const { return header_.symbol; }
  const std::string& unit() const { return header_.unit; }
  const std::string& display_unit() const { return header_.display_unit; }
  const std::string& title() const { return header_.title; }
  const std::string& source() const { return header_.source; }
  const std::string& validity() const { return header_.validity; }
  const std::vector<Argument>& arguments() const { return arguments_; }
  const std::vector<Validity>& conditions() const { return conditions_; }

  /// The machine element, "power_screw" of "power_screw.raising_torque".
  std::string_view element() const;

  /// Keys of sources.bib that `source()` names.
  std::vector<std::string> source_keys() const;

  /// Result in SI on the scalar T. Throws std::invalid_argument when number or kind of the values do not match.
  template <class T>
  T evaluate(std::span<const ArgumentValue<T>> values) const {
    check_shape(values.size(), [&](std::size_t i) { return values[i].index(); });
    return std::get<Evaluator<T>>(evaluators_)(values);
  }
  template <class T>
  T evaluate(const std::vector<ArgumentValue<T>>& values) const {
    return evaluate<T>(std::span<const ArgumentValue<T>>(values));
  }

  /// Whether anything is stated beyond "above zero" (of a count: at least one).
  bool has_limits() const;

  /// Each stated limit that these values break; empty where the formula holds.
  std::vector<BrokenLimit> broken_limits(std::span<const ArgumentValue<double>> values) const;
  /// The same, in one sentence each.
  std::vector<std::string> violations(std::span<const ArgumentValue<double>> values) const;

  void add_condition(std::string_view text, Validity::Holds holds);

 private:
  template <class IndexOf>
  void check_shape(std::size_t count, IndexOf index_of) const {
    if (count != arguments_.size()) fail_count(count);
    for (std::size_t i = 0; i < count; ++i)
      if (index_of(i) != static_cast<std::size_t>(arguments_[i].kind)) fail_kind(i);
  }
  [[noreturn]] void fail_count(std::size_t count) const;
  [[noreturn]] void fail_kind(std::size_t index) const;

  FormulaText<std::string> header_;
  std::vector<Argument> arguments_;
  std::vector<Validity> conditions_;
  Evaluators evaluators_;
};

/// Every formula, element by element in the order of the elements' headers. Built at the first call.
const std::vector<Formula>& formulas();

/// By project name ("power_screw.raising_torque") or handbook id ("SCREW-TORQUE-RAISE"); nullptr when unknown.
const Formula* find_formula(std::string_view name_or_handbook_id);

}  // namespace millwright::mechanics
