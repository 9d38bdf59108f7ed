// SPDX-License-Identifier: Apache-2.0
//
// The one list of the numbers a formula runs on.
#pragma once

#include <concepts>
#include <type_traits>

#include "scalar/dimensioned.h"
#include "scalar/dual.h"
#include "scalar/interval.h"
#include "scalar/traced.h"

namespace millwright::scalar {

template <class... T>
struct ScalarList {
  static constexpr int size = sizeof...(T);
  template <class S>
  static constexpr bool contains = (std::is_same_v<S, T> || ...);
};

using AllScalars = ScalarList<double, Dual<double>, Interval, Dual<Interval>, Traced, Dimensioned>;

/// Calls `function.template operator()<T>()` for every scalar, in the order of the list.
template <class Function, class... T>
constexpr void for_each_scalar(ScalarList<T...>, Function&& function) {
  (function.template operator()<T>(), ...);
}
template <class Function>
constexpr void for_each_scalar(Function&& function) {
  for_each_scalar(AllScalars{}, function);
}

/// A type a formula can be instantiated with: any B and N for Dual, the other scalars of the list.
template <class T>
struct IsScalar : std::bool_constant<AllScalars::contains<T>> {};
template <class B, int N>
struct IsScalar<Dual<B, N>> : IsScalar<B> {};
template <class T>
concept Scalar = IsScalar<std::remove_cvref_t<T>>::value;

}  // namespace millwright::scalar

// clang-format off
/// Calls `instantiate(T)`, a macro that holds explicit instantiations, for every scalar of AllScalars:
///     #define instantiate(T) template T raising_torque(const T&, const T&);
///     MILLWRIGHT_FOR_EACH_SCALAR(instantiate)
#define MILLWRIGHT_FOR_EACH_SCALAR(instantiate)                   \
  instantiate(double)                                             \
  instantiate(::millwright::scalar::Dual<double>)                 \
  instantiate(::millwright::scalar::Interval)                     \
  instantiate(::millwright::scalar::Dual<::millwright::scalar::Interval>) \
  instantiate(::millwright::scalar::Traced)                       \
  instantiate(::millwright::scalar::Dimensioned)
// clang-format on
