// SPDX-License-Identifier: Apache-2.0
//
// What numbers on the command line must be. CLI11's own checks tell the largest number there is in 300 digits, and nan
// is in any of their ranges.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace millwright::app {

/// `is_good` of the number; `what` completes "... is not a number ...".
inline CLI::Validator number_that(bool (*is_good)(double), const char* what) {
  const auto complaint = [is_good, what](const std::string& text) {
    double value = 0.0;
    const bool good = CLI::detail::lexical_cast(text, value) && is_good(value);
    return good ? std::string() : text + " is not a number " + what;
  };
  return CLI::Validator(complaint, "");
}

inline const CLI::Validator positive = number_that([](double x) { return x > 0.0 && std::isfinite(x); }, "above 0");
inline const CLI::Validator share = number_that([](double x) { return x >= 0.0 && x <= 1.0; }, "from 0 to 1");

}  // namespace millwright::app
