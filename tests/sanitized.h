// SPDX-License-Identifier: Apache-2.0
//
// Whether the tests run under the address sanitizer, which makes every evaluation some ten times as slow: there random
// tests take fewer instances.
#pragma once

namespace millwright {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace millwright
