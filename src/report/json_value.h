// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace millwright::report {

using Json = nlohmann::ordered_json;

/// JSON has neither infinity nor NaN.
inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
inline Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

/// The beginning of every result.
inline Json result_of(std::string_view command) {
  return Json{{"schema", "millwright.result/1"}, {"command", command}};
}

/// Indented text with a line end. Bytes that are no UTF-8 (file names may hold any) are replaced, never an error.
inline std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace millwright::report
