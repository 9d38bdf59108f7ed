// SPDX-License-Identifier: Apache-2.0
// Results that `compare` reads, from anybody.
#include "report/recorded_build.h"

#include "catch.h"

namespace recorded_build_test {

using namespace millwright;

namespace {

std::string complaint(const std::string& json) {
  text::Diagnostics diagnostics;
  CHECK_FALSE(report::read_recorded_build(text::SourceText::from_string("r.json", json), diagnostics));
  REQUIRE(diagnostics.error_count() == 1);
  const text::Diagnostic said = diagnostics.all()[0];
  return std::to_string(said.where.line) + ":" + std::to_string(said.where.column) + " " + said.message;
}

}  // namespace

TEST_CASE("Brackets in a result that are nested too deep are refused where they are") {
  const std::string many = "nested more than 256 levels deep";
  CHECK(complaint("{\"a\":" + std::string(1000000, '[')) == "1:261 " + many);
  CHECK(complaint("{\n\"\\\"]\":" + std::string(300, '[') + std::string(300, ']') + "}") == "2:262 " + many);
  std::string objects;
  for (int i = 0; i < 300; ++i) objects += "{\"]\":";
  CHECK(complaint(objects) == "1:1281 " + many);
  CHECK(complaint("{\"a\": \"" + std::string(1000, '[') + "\"}") == "0:0 this is no result of millwright");
  std::string flat = "{\"a\":[";
  for (int i = 0; i < 1000; ++i) flat += "[],";
  CHECK(complaint(flat + "1]}") == "0:0 this is no result of millwright");
}

}  // namespace recorded_build_test
