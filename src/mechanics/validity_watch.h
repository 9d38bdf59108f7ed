// SPDX-License-Identifier: Apache-2.0
//
// Whether the formulas behind a design hold where the design uses them. A formula that is stated for a limited range
// announces its arguments in its first line:
//
//   watch_validity<T>("power_screw.raising_torque", force, mean_diameter, lead, friction);
//
// That is nothing on every scalar but double, and on double the test of one pointer unless somebody watches. Which
// limits there are stands in the register (formula.h) only; a test holds the announcements against it.
#pragma once

#include <initializer_list>
#include <span>
#include <type_traits>

namespace millwright::mechanics {

/// An argument as it is announced: a number, a list, or the index of an enumerator.
struct WatchedArgument {
  enum class Kind { number, list, choice } kind = Kind::number;
  double number = 0.0;
  std::span<const double> list = {};
  int choice = 0;
};

/// Hears every announcement of its thread from its construction to its end. The youngest watch alone hears.
class FormulaWatch {
 public:
  FormulaWatch();
  FormulaWatch(const FormulaWatch&) = delete;
  FormulaWatch& operator=(const FormulaWatch&) = delete;
  virtual ~FormulaWatch();

  /// A formula, by its name in the register, is being evaluated.
  virtual void called(const char* formula, std::initializer_list<WatchedArgument> arguments) = 0;

 private:
  FormulaWatch* before_;
};

namespace detail {

constinit inline thread_local FormulaWatch* current_watch = nullptr;

inline WatchedArgument watched(double x) { return {.number = x}; }
inline WatchedArgument watched(std::span<const double> list) {
  return {.kind = WatchedArgument::Kind::list, .list = list};
}
template <class Enum>
requires std::is_enum_v<Enum> WatchedArgument watched(Enum choice) {
  return {.kind = WatchedArgument::Kind::choice, .choice = static_cast<int>(choice)};
}

}  // namespace detail

/// The scalar on which announcements are heard.
template <class T>
inline constexpr bool is_watched = std::is_same_v<T, double>;

template <class T, class... Argument>
void watch_validity([[maybe_unused]] const char* formula, [[maybe_unused]] const Argument&... arguments) {
  if constexpr (is_watched<T>)
    if (detail::current_watch != nullptr) detail::current_watch->called(formula, {detail::watched(arguments)...});
}

}  // namespace millwright::mechanics
