// SPDX-License-Identifier: Apache-2.0
#include "catalogue/import_number.h"
#include "catalogue/import_names.h"
#include "catalogue/import_unit.h"
#include "catch.h"

namespace millwright::catalogue::import_number_test {
namespace {

TEST_CASE("What the marks of a number tell") {
  using enum MarkEvidence;
  const std::pair<const char*, MarkEvidence> cases[] = {{"126", none},
                                                        {"12,6", comma},
                                                        {"12.6", point},
                                                        {"0,125", comma},
                                                        {"0.125", point},
                                                        {"1,234", ambiguous},
                                                        {"1.234", ambiguous},
                                                        {"12,345", ambiguous},
                                                        {"1234,567", comma},
                                                        {"1.234,50", comma},
                                                        {"1,234.50", point},
                                                        {"1,234,567", point},
                                                        {"1.234.567", comma},
                                                        {"-1,234", ambiguous},
                                                        {"1.2e3", point},
                                                        {"1 234,5", comma},
                                                        {"1'234.567", point},
                                                        {"1.2,3.4", contradictory},
                                                        {"1,2345", comma}};
  for (const auto& [number, expected] : cases) {
    INFO(number);
    CHECK(mark_evidence(number) == expected);
  }
}

TEST_CASE("Numbers of shops with our decimal point, and nothing that is none") {
  const auto comma = [](const char* number) { return plain_number(number, DecimalMark::comma); };
  const auto point = [](const char* number) { return plain_number(number, DecimalMark::point); };
  CHECK(comma("1,234") == "1.234");
  CHECK(point("1,234") == "1234");
  CHECK(comma("1.234,50") == "1234.50");
  CHECK(point("1,234,567.8") == "1234567.8");
  CHECK(point("1 234.5") == "1234.5");
  CHECK(point("1'234") == "1234");
  CHECK(point("1\xE2\x80\xAF"
              "234,5")
            .empty());
  CHECK(comma("1\xC2\xA0"
              "234,5") == "1234.5");
  CHECK(point("\xE2\x88\x92"
              "2.5") == "-2.5");
  CHECK(point("+2.50") == "2.50");
  CHECK(comma(",5") == "0.5");
  CHECK(point("1.2e-3") == "1.2e-3");
  CHECK(point("12,34").empty());  // thousands stand in threes
  CHECK(point("1,23,456").empty());
  CHECK(comma("1,5,5").empty());
  CHECK(comma("1.5").empty());
  CHECK(point("1.234,5").empty());
  CHECK(point(std::string(5000, '7').c_str()).empty());
}

TEST_CASE("A cell is cut into number and unit") {
  const auto cut = [](const char* cell) {
    const CellParts parts = cut_cell(cell);
    return std::string(parts.before) + "|" + std::string(parts.number) + "|" + std::string(parts.after);
  };
  CHECK(cut("1.26 N.m") == "|1.26|N.m");
  CHECK(cut("2.8A") == "|2.8|A");
  CHECK(cut("178 oz.in") == "|178|oz.in");
  CHECK(cut("EUR 24,33") == "EUR|24,33|");
  CHECK(cut("$19") == "$|19|");
  CHECK(cut("-0.5 mm") == "|-0.5|mm");
  CHECK(cut("10 000 mm") == "|10 000|mm");
  CHECK(cut("2e3N") == "|2e3|N");
  CHECK(cut("5 eV") == "|5|eV");
  CHECK(cut("1.8\xC2\xB0") == "|1.8|\xC2\xB0");
  CHECK(cut("24-48 V") == "|24|-48 V");
  CHECK(cut("none") == "||none");
  CHECK(cut(".5 mm") == "|.5|mm");
  CHECK(cut("EUR .50") == "EUR|.50|");
  CHECK(cut("-,5") == "|-,5|");
  CHECK(cut("kr.500") == "kr.|500|");  // the point of an abbreviation
  CHECK(cut("Rp.150000") == "Rp.|150000|");
  CHECK(cut("$.50") == "$.|50|");  // "$." is no currency: refused, not guessed
}

TEST_CASE("Units of shops, only where they fit") {
  const auto unit = [](const char* words, const char* name) {
    std::string reason;
    const auto found = shop_unit(words, column(Family::steppers, name), reason);
    return found ? found->unit + (found->currency.empty() ? "" : "|" + found->currency) : "no";
  };
  CHECK(unit("N.cm", "holding_torque") == "N.cm");
  CHECK(unit("nm", "holding_torque") == "N.m");  // and no nanometre
  CHECK(unit("oz-in", "holding_torque") == "oz-in");
  CHECK(unit("kg.cm", "holding_torque") == "kgf.cm");
  CHECK(unit("lb.in", "holding_torque") == "lbf.in");
  CHECK(unit("gcm\xC2\xB2", "rotor_inertia") == "g.cm2");
  CHECK(unit("(KG)", "mass") == "kg");
  CHECK(unit("A/phase", "rated_current") == "A");
  CHECK(unit("\xCE\xA9", "phase_resistance") == "\xCE\xA9");
  CHECK(unit("VDC", "maximum_voltage") == "V");
  CHECK(unit("mm", "holding_torque") == "no");
  CHECK(unit("xyz", "mass") == "no");
  CHECK(unit("EUR", "price") == "|EUR");
  CHECK(unit("\xE2\x82\xAC/pcs", "price") == "|EUR");
  CHECK(unit("$", "price") == "|?");
  CHECK(unit("kr.", "price") == "|?");
  CHECK(unit("Rp.", "price") == "|IDR");
  CHECK(unit("$.", "price") == "no");
  CHECK(unit("EUR/m", "price_per_length") == "1/m|EUR");
  CHECK(unit("EUR", "price_per_length") == "no");
  CHECK(unit("mm", "price") == "no");
}

TEST_CASE("Headers name columns by their words") {
  const auto match = [](const char* header, const char* name) {
    return name_match(words_of(header), column(Family::steppers, name));
  };
  CHECK(match("Holding Torque", "holding_torque") == 1.0);
  CHECK(match("HoldingTorque", "holding_torque") == 1.0);
  CHECK(match("Haltemoment", "holding_torque") > 0.9);
  CHECK(match("Artikel-Nr.", "part_number") > 0.9);
  CHECK(match("Max. holding torque", "holding_torque") > 0.7);
  CHECK(match("Detent torque", "holding_torque") < match("Detent torque", "detent_torque"));
  CHECK(match("Lead wires", "mass") == 0.0);
  CHECK(match("", "mass") == 0.0);
}

TEST_CASE("A header cell of many words is no likeness, and one that holds a quantity says so") {
  const Column torque = column(Family::steppers, "holding_torque");
  CHECK(name_match(words_of("holding torque holds when the motor stands still"), torque) == 0.0);
  CHECK(name_match(words_of("holding torgue"), torque) == 0.75);  // one letter wrong
  for (const char* header : {"Price/100", "Price per 10", "Price 10+", "Price per 100pcs", "Preis 2-9"})
    CHECK(has_quantity(header));
  for (const char* header : {"Price", "Price/1", "Price 1+", "Price (EUR)"}) CHECK_FALSE(has_quantity(header));
}

}  // namespace
}  // namespace millwright::catalogue::import_number_test
