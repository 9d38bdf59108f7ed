// SPDX-License-Identifier: Apache-2.0
// The lifter that is shipped, a machine of one motor: what overlays do to it is read from the result in JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/program.h"
#include "catch.h"

namespace millwright::app {

using Json = nlohmann::json;

inline const std::string lifter = MILLWRIGHT_SOURCE_DIR "/problems/lifter.toml";

/// What `solve` answers, with more words on the command line.
inline Json solved(const Workshop& shop, const std::vector<std::string>& more) {
  std::vector<std::string> words{"solve", lifter, "--json", "-"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = shop.run(words);
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

inline double cost(const Json& result) { return result.at("totals").at("cost").at("value").get<double>(); }

/// The line of a slot, null if there is none.
inline Json part(const Json& result, const std::string& slot) {
  for (const Json& each : result.at("build").at("parts"))
    if (each.at("slot") == slot) return each;
  return nullptr;
}
inline Json motor(const Json& result) { return part(result, "motor"); }

}  // namespace millwright::app
