// SPDX-License-Identifier: Apache-2.0
// Whether two results say the same: structure and words exactly, numbers by tolerance.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace millwright::results {

using Json = nlohmann::ordered_json;

/// Relative, and absolute below 1e-9: other compilers and libraries may differ in the last digits, not more.
inline bool same_number(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b)) ||
         std::max(std::abs(a), std::abs(b)) < 1e-9;
}

/// Members that tell how the answer was found and not what it is: they may change without a different answer.
inline bool is_effort(const std::string& key) {
  static const std::set<std::string> keys = {"timing_s", "nodes", "evaluations", "method"};
  return keys.count(key) != 0;
}

/// Appends one line for each difference between `expected` and `found`, with the JSON path where it is.
inline void differences(const Json& expected,
                        const Json& found,
                        const std::string& path,
                        std::vector<std::string>& lines) {
  if (expected.is_number() && found.is_number()) {
    if (!same_number(expected.get<double>(), found.get<double>()))
      lines.push_back(path + ": " + expected.dump() + " became " + found.dump());
  } else if (expected.is_object() && found.is_object()) {
    for (const auto& [key, value] : expected.items()) {
      if (is_effort(key)) continue;
      if (found.contains(key))
        differences(value, found.at(key), path + "/" + key, lines);
      else
        lines.push_back(path + "/" + key + " is gone");
    }
    for (const auto& [key, value] : found.items())
      if (!is_effort(key) && !expected.contains(key)) lines.push_back(path + "/" + key + " is new");
  } else if (expected.is_array() && found.is_array()) {
    if (expected.size() != found.size())
      lines.push_back(path + ": " + std::to_string(expected.size()) + " entries became " +
                      std::to_string(found.size()));
    for (std::size_t i = 0; i < std::min(expected.size(), found.size()); ++i)
      differences(expected[i], found[i], path + "/" + std::to_string(i), lines);
  } else if (expected != found) {
    lines.push_back(path + ": " + expected.dump() + " became " + found.dump());
  }
}

/// Printed words: equal, or both numbers that differ by no more than one unit in the last printed place.
inline bool same_word(const std::string& expected, const std::string& found) {
  if (expected == found) return true;
  char* end_expected = nullptr;
  char* end_found = nullptr;
  const double a = std::strtod(expected.c_str(), &end_expected);
  const double b = std::strtod(found.c_str(), &end_found);
  if (end_expected == expected.c_str() || end_found == found.c_str() || std::string(end_expected) != end_found)
    return false;
  const std::size_t point = expected.find('.');
  const std::size_t digits_end = static_cast<std::size_t>(end_expected - expected.c_str());
  const double decimals = point == std::string::npos ? 0.0 : static_cast<double>(digits_end - point - 1);
  const bool exponent = expected.find_first_of("eE") < digits_end;
  return exponent ? std::abs(a - b) <= 1e-3 * std::abs(a) : std::abs(a - b) <= 1.01 * std::pow(10.0, -decimals);
}

/// Compares printed text word by word; a line that begins with "time" tells how long it took and is left out.
inline void text_differences(const std::string& expected, const std::string& found, std::vector<std::string>& lines) {
  const auto kept_lines = [](const std::string& text) {
    std::vector<std::string> kept;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
      if (line.rfind("time", 0) != 0) kept.push_back(line);
    return kept;
  };
  const std::vector<std::string> before = kept_lines(expected);
  const std::vector<std::string> now = kept_lines(found);
  if (before.size() != now.size())
    lines.push_back(std::to_string(before.size()) + " lines became " + std::to_string(now.size()));
  for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i) {
    std::istringstream words_before(before[i]);
    std::istringstream words_now(now[i]);
    std::string a;
    std::string b;
    bool same = true;
    while (same) {
      const bool more_before = static_cast<bool>(words_before >> a);
      const bool more_now = static_cast<bool>(words_now >> b);
      same = more_before == more_now && (!more_before || same_word(a, b));
      if (!more_before) break;
    }
    if (!same) lines.push_back("line " + std::to_string(i + 1) + ": " + before[i] + "\n      became: " + now[i]);
  }
}

}  // namespace millwright::results
