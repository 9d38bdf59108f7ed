// SPDX-License-Identifier: Apache-2.0
// What rows of the same maker say of one of them without that one; expected values by hand.
#include "catalogue/siblings.h"

#include <fmt/format.h>

#include <cmath>

#include "catalogue/lint.h"
#include "catalogue/plausibility.h"
#include "catalogue/table_of.h"
#include "catch.h"

namespace siblings_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

/// Carriages of 20 mm, of which only the ratings are given: part number and C each, C0 15 % apart so that none are
/// twins.
std::string carriages(const std::vector<std::pair<std::string, double>>& parts, double first_static = 30000) {
  std::string rows =
      "manufacturer,part_number,kind,series,size [mm],dynamic_load_rating [N],static_load_rating [N],"
      "price,price_per_length [1/m],currency\n";
  double c0 = first_static;
  for (const auto& [name, share] : parts) {
    rows += fmt::format("Acme,{},profile rail,AB,20,{:.6g},{:.6g},40,90,USD\n", name, share * c0, c0);
    c0 *= 1.15;
  }
  return rows;
}

}  // namespace

TEST_CASE("siblings are heard without the row that is judged") {
  Siblings siblings(2);
  std::vector<std::vector<float>> seen{{5, 1, 2, 4, 3}, {1, 2, 3}};
  siblings.add_group(seen);
  CHECK(seen[0].empty());
  // Without 5: 1, 2, 3, 4. Middle 2.5; quarters at 1.75 and 3.25; 7.5 % at 1.225 and 92.5 % at 3.775; (1 + 2/4).
  const auto without_largest = siblings.without(0, 0, 5);
  REQUIRE(without_largest);
  CHECK(without_largest->count == 4);
  CHECK(without_largest->centre == Approx(2.5));
  CHECK(without_largest->spread == Approx(1.5 * 1.5 / 1.349));
  // Without 1: 2, 3, 4, 5. A number that is not among them leaves all five: middle 3.
  CHECK(siblings.without(0, 0, 1)->centre == Approx(3.5));
  CHECK(siblings.without(0, 0, 2.5)->centre == Approx(3));
  CHECK(siblings.without(0, 0, 2.5)->count == 5);
  CHECK_FALSE(siblings.without(0, 1, 2));             // too few
  CHECK_FALSE(siblings.without(0, 0, std::nan("")));  // the row does not say
  // How far the judged one is off makes no difference: it has no part in it.
  std::vector<std::vector<float>> one{{1, 2, 3, 4, 1000}}, other{{1, 2, 3, 4, 7}};
  Siblings wide(1), narrow(1);
  wide.add_group(one);
  narrow.add_group(other);
  CHECK(wide.without(0, 0, 1000)->spread == narrow.without(0, 0, 7)->spread);
}

TEST_CASE("siblings that agree closely give away what lies within the differences between makers") {
  // C0/C of 1.45 within 13 % is usual: C times 0.79 alone is 1.8 of that. Among five that agree it is odd.
  const auto odd = [](int siblings) {
    std::vector<std::pair<std::string, double>> parts{{"X", 0.68 * 0.79}};
    for (int i = 0; i < siblings; ++i) parts.emplace_back(fmt::format("S{}", i), 0.68);
    const Table table = table_of(Family::linear_guides, carriages(parts));
    const Plausibility plausibility(table);
    for (int row = 1; row < table.rows(); ++row)
      CHECK_FALSE(plausibility.examine(row, [](std::string_view id) { return id != "load-ratings"; }));
    return plausibility.is_unusual(0, "load-ratings") &&
           plausibility.examine(0, [](std::string_view id) { return id != "load-ratings"; });
  };
  CHECK(odd(6));
  CHECK(odd(4));
  CHECK_FALSE(odd(3));  // too few to be heard
}

TEST_CASE("two bearings with the same balls do not have different ratings") {
  const auto findings = [](const std::string& rows) {
    text::Diagnostics diagnostics;
    lint(table_of(Family::linear_guides, rows), diagnostics);
    std::vector<std::string> told;
    for (const text::Diagnostic& each : diagnostics.all()) {
      if (each.message.find("which has the same size and") != std::string::npos) told.push_back(each.message);
    }
    return told;
  };
  const std::string head =
      "manufacturer,part_number,kind,size [mm],block_length [mm],dynamic_load_rating [N],static_load_rating [N],"
      "price,price_per_length [1/m],currency\n";
  const std::string bush = "Acme,LM8,linear ball bush,8,24,274,392,2,9,USD\n",
                    block = "Acme,SC8,linear ball bush block,8,30,";
  CHECK(findings(head + bush + block + "274,392,2,9,USD\n").empty());
  CHECK(findings(head + bush + block + "300,392,2,9,USD\n").empty());  // rounded otherwise
  // Of two nobody knows which is wrong.
  CHECK(
      findings(head + bush + block + "217,392,2,9,USD\n") ==
      std::vector<std::string>{"LM8: dynamic_load_rating 274 N is 1.26 times that of SC8, which has the same size and "
                               "static_load_rating [load-ratings]",
                               "SC8: dynamic_load_rating 217 N is 0.792 times that of LM8, which has the same size and "
                               "static_load_rating [load-ratings]"});
  // Of three the one that differs is.
  const auto one =
      findings(head + bush + block + "217,392,2,9,USD\n" + "Acme,SB8,supported round rail,8,30,274,392,2,9,USD\n");
  REQUIRE(one.size() == 1);
  CHECK(one.front().find("SC8: ") == 0);
  CHECK(findings(head + bush + "Other,SC8,linear ball bush block,8,30,217,392,2,9,USD\n").empty());  // another maker
  CHECK(findings(head + bush + "Acme,SC9,linear ball bush block,9,30,217,392,2,9,USD\n").empty());   // another size
}

}  // namespace siblings_test
