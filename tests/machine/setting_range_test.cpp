// SPDX-License-Identifier: Apache-2.0
#include "machine/setting_range.h"

#include "catch.h"

namespace millwright::machine::setting_range_test {
namespace {

SettingRange range_of(const std::string& assignment) {
  text::Diagnostics diagnostics;
  const auto range = read_setting_range(assignment, diagnostics);
  INFO(text::format(diagnostics));
  REQUIRE(range.has_value());
  return *range;
}

TEST_CASE("A range has its ends and even steps between, each as it would be typed") {
  const SettingRange range = range_of("axis.x.moves[0].time=0.2:0.5:4 s");
  CHECK(range.path == "axis.x.moves[0].time");
  CHECK(range.unit == "s");
  CHECK(range.texts == std::vector<std::string>{"0.2 s", "0.3 s", "0.4 s", "0.5 s"});
  CHECK(range.values == std::vector<double>{0.2, 0.3, 0.4, 0.5});
}

TEST_CASE("The unit of a range stands at the end, behind both ends, or nowhere") {
  CHECK(range_of("a=1 mm/s:3 mm/s:3").texts == std::vector<std::string>{"1 mm/s", "2 mm/s", "3 mm/s"});
  CHECK(range_of("a=1:3 mm/s:2").texts == std::vector<std::string>{"1 mm/s", "3 mm/s"});
  CHECK(range_of("a= 3 : 1 : 3 ").texts == std::vector<std::string>{"3", "2", "1"});
  CHECK(range_of("a=-1e-3:1e-3:3 m").values == std::vector<double>{-1e-3, 0.0, 1e-3});
}

TEST_CASE("What is no range stays a single value") {
  for (const char* single : {"a=20 s", "a=\"1:2:3\"", "title=ratio: 3", "a=[1, 2]", "a", "reduction=generic:3:1"})
    CHECK_FALSE(is_setting_range(single));
  for (const char* range : {"a=1:2:3", "a=1:2", "a=0.2 s:0.5 s:3", "a=1:b:3", "a=1::"}) CHECK(is_setting_range(range));
}

TEST_CASE("Ranges that are none are refused") {
  for (const char* wrong : {"a=1:2",
                            "a=1:2:3:4",
                            "a=1:2:0",
                            "a=1:2:-3",
                            "a=1:2:201",
                            "a=1:1:3",
                            "a=1 s:2 mm:3",
                            "a=1::3",
                            "a=1:nan:3",
                            "a=1:inf:3",
                            "a=0.2s:0.3s:3",
                            "=1:2:3"}) {
    text::Diagnostics diagnostics;
    INFO(wrong);
    CHECK_FALSE(read_setting_range(wrong, diagnostics).has_value());
    CHECK(diagnostics.error_count() == 1);
  }
}

}  // namespace
}  // namespace millwright::machine::setting_range_test
