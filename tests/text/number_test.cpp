// SPDX-License-Identifier: Apache-2.0
#include "text/number.h"

#include <cstdlib>
#include <random>

#include "catch.h"

namespace number_test {

using namespace millwright::text;

TEST_CASE("numbers as people type them") {
  CHECK(parse_number("12.5") == 12.5);
  CHECK(parse_number(" \t-3e-3 ") == -0.003);
  CHECK(parse_number("+7") == 7.0);
  CHECK(parse_number(".5") == 0.5);
  CHECK(parse_number("5.") == 5.0);
  CHECK(parse_number("1E6") == 1e6);
  CHECK(parse_number("0") == 0.0);
  CHECK(parse_number("1,5", DecimalMark::point_or_comma) == 1.5);
  CHECK(parse_number("-1,5e3", DecimalMark::point_or_comma) == -1500.0);
}

TEST_CASE("what is no number is refused") {
  for (const char* text : {"",
                           " ",
                           "+",
                           "-",
                           "+-1",
                           "--1",
                           "1,5",
                           "1.5.2",
                           "1e",
                           "e5",
                           "0x10",
                           "inf",
                           "-inf",
                           "nan",
                           "NaN",
                           "infinity",
                           "1e999",
                           "1 2",
                           "1_000",
                           "12 mm",
                           "1e5.5",
                           "\xC2\xA0"
                           "1"}) {
    INFO(text);
    CHECK_FALSE(parse_number(text));
  }
  CHECK_FALSE(parse_number("1,234.5", DecimalMark::point_or_comma));
  CHECK_FALSE(parse_number("1,2,3", DecimalMark::point_or_comma));
  CHECK_FALSE(parse_number(std::string(10000000, '7')));
  CHECK_FALSE(parse_number(std::string("1\0", 2)));
}

TEST_CASE("values equal those of strtod") {
  std::mt19937_64 generator(4);
  for (int round = 0; round < 20000; ++round) {
    std::string text = std::to_string(static_cast<long long>(generator()));
    text.insert(text.size() - generator() % text.size() % 15, ".");
    if (generator() % 2 == 0) text += "e" + std::to_string(static_cast<int>(generator() % 500) - 250);
    if (text.find("-.") != std::string::npos) continue;
    const auto value = parse_number(text);
    INFO(text);
    REQUIRE(value);
    REQUIRE(*value == std::strtod(text.c_str(), nullptr));
  }
}

TEST_CASE("hints say what was probably meant") {
  CHECK(number_hint("1O.5") == "letter O where a zero was meant: 10.5");
  CHECK(number_hint("2o") == "letter O where a zero was meant: 20");
  CHECK(number_hint("l2") == "letter l where a one was meant: 12");
  CHECK(number_hint("1,5") == "decimal comma: write 1.5, or separate the cells of this file by ;");
  CHECK(number_hint("1,234,567") == "no thousands separators: 1234567");
  CHECK(number_hint("1,234.5") == "no thousands separators: 1234.5");
  CHECK(number_hint("1.234,5") == "no thousands separators: 1234.5");
  CHECK(number_hint("1.234.567") == "no thousands separators: 1234567");
  CHECK(number_hint("12 500") == "no thousands separators: 12500");
  CHECK(number_hint("12'500") == "no thousands separators: 12500");
  CHECK(number_hint("12\u00A0500") == "no thousands separators: 12500");
  CHECK(number_hint("\u22125") == "a minus sign of typesetting: write -5");
  CHECK(number_hint("12.5 mm") == "unit in the cell 'mm': units stand in the header, in brackets; write 12.5");
  CHECK(number_hint("8µm") == "unit in the cell 'µm': units stand in the header, in brackets; write 8");
  CHECK(number_hint("20%") == "unit in the cell '%': units stand in the header, in brackets; write 20");
  CHECK(number_hint("n/a") == "leave the cell empty where a value is missing");
  CHECK(number_hint("-") == "leave the cell empty where a value is missing");
  CHECK(number_hint("#DIV/0!") == "an error value of a spreadsheet: compute it anew or leave the cell empty");
  CHECK(number_hint("1e999") == "too large or too small for a number");
  // By itself, as a value of an option, it is in no cell.
  CHECK(number_hint("12.5 mm", NumberPlace::alone) == "without 'mm': write 12.5");
  CHECK(number_hint("1,5", NumberPlace::alone) == "decimal comma: write 1.5");
  CHECK(number_hint("nan", NumberPlace::alone) == "write digits with a decimal point, such as 12.5 or 1.2e-3");
  CHECK(number_hint("about ten") == "write digits with a decimal point, such as 12.5 or 1.2e-3");
  CHECK(number_hint(std::string(10000000, '7')) == "10000000 characters are no number");
  CHECK(number_hint("<5") == "write digits with a decimal point, such as 12.5 or 1.2e-3");
}

TEST_CASE("a hint is found for any bytes") {
  std::mt19937 generator(9);
  const std::string letters = "0123456789.,;-+eEOlI '#%/\xC2\xA0\xE2\x88\x92\0nainf";
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (auto i = generator() % 12; i > 0; --i) text += letters[generator() % letters.size()];
    if (text.find_first_not_of(" ") == std::string::npos) text = "x";
    CHECK_FALSE(number_hint(text).empty());
  }
  CHECK_FALSE(number_hint("").empty());
}

}  // namespace number_test
