// SPDX-License-Identifier: Apache-2.0
#include "results/json_difference.h"

#include "catch.h"

namespace millwright::results::json_difference_test {
namespace {

std::size_t count(const char* expected, const char* found) {
  std::vector<std::string> lines;
  differences(Json::parse(expected), Json::parse(found), "", lines);
  return lines.size();
}

std::size_t text_count(const char* expected, const char* found) {
  std::vector<std::string> lines;
  text_differences(expected, found, lines);
  return lines.size();
}

TEST_CASE("Results are compared by tolerance in numbers and exactly in structure") {
  CHECK(count(R"({"a": [1.0, "x"]})", R"({"a": [1.0000001, "x"]})") == 0);
  CHECK(count(R"({"a": 1.0})", R"({"a": 1.00001})") == 1);
  CHECK(count(R"({"a": 1.0})", R"({"a": "1.0"})") == 1);
  CHECK(count(R"({"a": 1.0})", R"({"a": null})") == 1);
  CHECK(count(R"({"a": 1.0})", R"({"b": 1.0})") == 2);
  CHECK(count(R"({"a": [1, 2]})", R"({"a": [1]})") == 1);
  CHECK(count(R"({"a": true})", R"({"a": false})") == 1);
  CHECK(count(R"({"a": 0.0})", R"({"a": 1e-12})") == 0);
  CHECK(count(R"({"timing_s": {"total": 1}, "a": 1})", R"({"timing_s": {"total": 9}, "a": 1})") == 0);
}

TEST_CASE("Printed tables are compared word by word, numbers to one unit of the last digit") {
  CHECK(text_count("cost  12.34 USD\n", "cost 12.35 USD\n") == 0);
  CHECK(text_count("cost  12.34 USD\n", "cost 12.36 USD\n") == 1);
  CHECK(text_count("ratio 93%\n", "ratio 92%\n") == 0);
  CHECK(text_count("part 17HS4401 x\n", "part 17HS4402 x\n") == 1);
  CHECK(text_count("cost 12.34 USD\n", "cost 12.34 EUR\n") == 1);
  CHECK(text_count("cost 12.34\n", "cost 12.34 USD\n") == 1);
  CHECK(text_count("a\n", "a\nb\n") == 1);
  CHECK(text_count("a\ntime 1.2 s\n", "a\ntime 3.4 s\n") == 0);
}

}  // namespace
}  // namespace millwright::results::json_difference_test
