// SPDX-License-Identifier: Apache-2.0
// What to order, of a design made by hand: every figure expected here is worked out in a comment beside it.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

#include "catch.h"
#include "report/conversion_text.h"
#include "report/order_files.h"
#include "report/order_list.h"

namespace millwright::report::order_test {
namespace {

using evaluation::PartLine;

PartLine part(const char* axis, const char* slot, const char* family, const char* maker, const char* number) {
  PartLine line;
  line.axis = axis;
  line.slot = slot;
  line.family = family;
  line.manufacturer = maker;
  line.part_number = number;
  return line;
}

PartLine motor(const char* axis, double quantity) {
  PartLine line = part(axis, "motor", "steppers", "Maker", "M1");
  line.quantity = quantity;
  line.price = 9.5 * quantity;
  line.supplier = "B shop";
  line.price_basis = "B shop list price, read 2026-09-27 (index id 20261234)";
  return line;
}

/// Carriages at 8, rails at 20 a metre.
PartLine guide(const char* axis, double carriages, double rails, double length) {
  PartLine line = part(axis, "guide", "linear_guides", "Rails Ltd", "R20");
  line.quantity = carriages;
  line.length = length;
  line.cuts = {{rails, length}};
  line.length_price = 20.0 * rails * length;
  line.price = 8.0 * carriages + line.length_price;
  line.supplier = "A shop";
  line.price_basis = "estimate 2024-2026 street price, +-30 %";
  line.price_estimate = true;
  return line;
}

/// Two axes: x with four carriages on two rails of 0.6 m, a motor, a shaft made to measure and a nut with a hostile
/// name; y with two carriages on one rail of 0.35 m and two motors.
evaluation::Design two_axes() {
  evaluation::Design design;
  design.currency = "USD";
  PartLine shaft = part("x", "spindle", "materials", "generic", "C45");
  shaft.quantity = 2.0;
  shaft.length = 0.25;
  shaft.cuts = {{2.0, 0.25}};
  shaft.mass = 0.8;
  shaft.price = 1.2;
  PartLine nut = part("x", "nut", "lead_nuts", "-2+3", "=HYPERLINK(\"http://x\",\"y\")");
  nut.price = 4.0;
  nut.paper_only = true;
  design.parts = {motor("x", 1.0), guide("x", 4.0, 2.0, 0.6), shaft, nut, motor("y", 2.0), guide("y", 2.0, 1.0, 0.35)};
  design.dimensions = {{"x", "spindle.diameter", 0.0125, "m"}, {"y", "spindle.diameter", 0.5, "m"}};
  // 3 motors 28.5, 6 carriages 48, rails 1.55 m 31, shaft 1.2, nut 4
  design.cost = 112.7;
  return design;
}

const OrderLine& line_of(const OrderList& list, const std::string& description) {
  for (const OrderLine& line : list.lines)
    if (line.description == description) return line;
  throw std::runtime_error("no line " + description);
}

TEST_CASE("Order list: equal parts of all axes are one line, carriages and rails are two") {
  const OrderList list = order_list(two_axes(), "Two axes");
  REQUIRE(list.lines.size() == 5);
  const OrderLine& motors = line_of(list, "stepper motor");
  CHECK(motors.quantity == 3.0);
  CHECK(motors.unit == "pcs");
  CHECK(motors.unit_price == Approx(9.5));
  CHECK(motors.total == Approx(28.5));
  CHECK(motors.price_date == "2026-09-27");
  CHECK_FALSE(motors.price_estimate);
  CHECK(motors.used_for == "x.motor, y.motor");
  const OrderLine& carriages = line_of(list, "guide carriage");
  CHECK(carriages.quantity == 6.0);
  CHECK(carriages.total == Approx(48.0));
  CHECK(carriages.price_date == "2024-2026");
  CHECK(carriages.price_estimate);
  const OrderLine& rails = line_of(list, "guide rail");
  CHECK(rails.unit == "m");
  CHECK(rails.quantity == Approx(2.0 * 0.6 + 0.35));
  CHECK(rails.unit_price == Approx(20.0));
  CHECK(rails.total == Approx(31.0));
  const OrderLine& bar = line_of(list, "bar stock");
  CHECK(bar.unit == "kg");
  CHECK(bar.quantity == Approx(0.8));
  CHECK(bar.unit_price == Approx(1.5));
}

TEST_CASE(
    "Order list: a part known only from a paper is to be verified before it is bought, not where it is in stock") {
  evaluation::Design design = two_axes();
  CHECK(line_of(order_list(design, ""), "lead screw nut").paper_only);
  CHECK_FALSE(line_of(order_list(design, ""), "stepper motor").paper_only);
  PartLine& nut = design.parts[3];
  nut.owned = 1.0;
  nut.price = 0.0;
  const OrderLine line = line_of(order_list(design, ""), "lead screw nut");
  CHECK(line.supplier == in_stock);
  CHECK_FALSE(line.paper_only);
}

TEST_CASE("Order list: reductions that a problem states are told apart by their prices") {
  evaluation::Design design;
  for (const double price : {70.0, 70.0, 45.0}) {
    PartLine line = part("x", "reduction", "", "", "as the problem states it");
    line.quantity = 2.0;
    line.price = 2.0 * price;
    design.parts.push_back(line);
  }
  const OrderList list = order_list(design, "");
  REQUIRE(list.lines.size() == 2);
  CHECK(list.lines[0].quantity == 4.0);
  CHECK(list.lines[0].total == Approx(280.0));
  CHECK(list.lines[0].description == "reduction, as the problem says");
  CHECK(list.lines[0].part_number.empty());
}

TEST_CASE("Order list: by supplier, those without one last, then by kind as the catalogues") {
  const OrderList list = order_list(two_axes(), "Two axes");
  std::vector<std::string> order;
  for (const OrderLine& line : list.lines) order.push_back(line.supplier + "/" + line.description);
  CHECK(order ==
        std::vector<std::string>{
            "A shop/guide carriage", "A shop/guide rail", "B shop/stepper motor", "/lead screw nut", "/bar stock"});
  REQUIRE(list.supplier_totals.size() == 3);
  CHECK(list.supplier_totals[0].total == Approx(79.0));  // 48 + 31
  CHECK(list.supplier_totals[1].total == Approx(28.5));
  CHECK(list.supplier_totals[2].total == Approx(5.2));  // 1.2 + 4
  CHECK(list.total == Approx(112.7));
}

TEST_CASE("Order list: one part number at two prices, or of two shops, stays two lines") {
  evaluation::Design design = two_axes();
  design.parts[4].price = 2.0 * 9.0;
  CHECK(order_list(design, "").lines.size() == 6);
  design = two_axes();
  design.parts[4].supplier = "C shop";
  CHECK(order_list(design, "").lines.size() == 6);
}

// The motors come from B shop, which asks 5 for shipping and 40 at least: 28.5 + 5 + 11.5 = 45. With them 112.7 + 16.5.
TEST_CASE("Order list: shipping and what lacks of a minimum stand beside the lines of their supplier") {
  evaluation::Design design = two_axes();
  design.orders = {{"B shop", 28.5, 5.0, 40.0, 11.5}};
  design.cost += 16.5;
  const OrderList list = order_list(design, "");
  REQUIRE(list.supplier_totals.size() == 3);
  CHECK(list.supplier_totals[0].charged() == Approx(79.0));
  CHECK(list.supplier_totals[1].total == Approx(28.5));
  CHECK(list.supplier_totals[1].charged() == Approx(45.0));
  const std::string csv = order_csv(list);
  CHECK(csv.find(",,,\"Shipping, B shop\",,,,,USD,,,5,,,\n") != std::string::npos);
  CHECK(csv.find(",,,\"To the minimum order of 40 USD, B shop\",,,,,USD,,,11.5,,,\n") != std::string::npos);
  CHECK(csv.find(",,,\"Total, B shop\",,,,,USD,,,45,,,\n") != std::string::npos);
  CHECK(csv.find(",,,Total,,,,,USD,,,129.2,,,\n") != std::string::npos);
}

// One of a part with two spares from A shop, which sells packs of two at 18; one from B shop for 8.
TEST_CASE("Order list: what is bought of a part is settled supplier by supplier") {
  evaluation::Design design;
  for (const char* axis : {"x", "y"}) {
    PartLine line = part(axis, "coupling", "couplings", "Maker", "C1");
    line.supplier = axis == std::string("x") ? "A shop" : "B shop";
    line.quantity = 1.0;
    line.spares = axis == std::string("x") ? 2.0 : 0.0;
    line.price = axis == std::string("x") ? 36.0 : 8.0;
    design.parts.push_back(line);
  }
  design.purchases = {{"couplings", "Maker", "C1", "A shop", 3.0, 0.0, 4.0, 36.0}};
  design.cost = 44.0;
  const OrderList list = order_list(design, "");
  REQUIRE(list.lines.size() == 2);
  CHECK(list.lines[0].quantity == 4.0);
  CHECK(list.lines[0].total == 36.0);
  CHECK(list.lines[0].used_for == "x.coupling and 2 spare, 1 left over");
  CHECK(list.lines[1].quantity == 1.0);
  CHECK(list.lines[1].total == 8.0);
}

TEST_CASE("Cutting list: every piece with its place, the sum of each stock part") {
  const OrderList list = order_list(two_axes(), "Two axes");
  CHECK(cutting_csv(list) ==
        "stock,manufacturer,part_number,axis,slot,section,count,length [mm],sum [mm],bar\n"
        "bar stock,generic,C45,x,spindle,diameter 12.5 mm,2,250,500,\n"
        "bar stock,generic,C45,,,sum,2,,500,\n"
        "guide rail,Rails Ltd,R20,x,guide,,2,600,1200,\n"
        "guide rail,Rails Ltd,R20,y,guide,,1,350,350,\n"
        "guide rail,Rails Ltd,R20,,,sum,3,,1550,\n");
}

// Rails of x (600 mm, two) and y (350 mm) from bars of 1 m at 20 a metre: 600 + 350 of one and 600 of another, 3 mm
// lost at each cut; each piece is cut for 0.5, and both ends of a screw sold by the metre are machined for 4 each.
TEST_CASE("Order and cutting list: whole bars, what is cut from each, and work on pieces") {
  evaluation::Design design = two_axes();
  for (PartLine& line : design.parts) {
    if (line.slot != "guide") continue;
    line.from_bars = true;
    line.cut_price = 0.5;
    double pieces = 0.0, metres = 0.0;
    for (const evaluation::Cut& cut : line.cuts) {
      pieces += cut.count;
      metres += cut.count * cut.length;
    }
    line.price -= line.length_price;
    line.length_price = metres / 1.55 * 40.0 + pieces * 0.5;
    line.price += line.length_price;
  }
  design.bars = {{"linear_guides", "Rails Ltd", "R20", "A shop", 1.0, 0.003, 20.0, {}}};
  design.bars[0].bars = {{{{"x", "guide", 0.6}, {"y", "guide", 0.35}}, 0.044}, {{{"x", "guide", 0.6}}, 0.397}};
  PartLine screw = part("x", "screw", "lead_screws", "Maker", "Tr10x2");
  screw.cuts = {{1.0, 0.5}};
  screw.cutting_loss = 0.002;
  screw.end_price = 4.0;
  screw.ends = 2.0;
  screw.price = screw.length_price = 0.502 * 10.0 + 8.0;
  design.parts.push_back(screw);
  const OrderList list = order_list(design, "");
  const std::string csv = order_csv(list);
  CHECK(csv.find("2,2,pcs,\"guide rail, bar of 1000 mm\",Rails Ltd,R20,A shop,20,USD,2024-2026,estimate,40,") !=
        std::string::npos);
  CHECK(csv.find(",3,pcs,\"guide rail, cut to length\",Rails Ltd,R20,A shop,0.5,USD,2024-2026,estimate,1.5,") !=
        std::string::npos);
  CHECK(csv.find(",0.502,m,lead screw,Maker,Tr10x2,,10,USD,,,5.02,x.screw,,\n") != std::string::npos);
  CHECK(csv.find(",2,pcs,\"lead screw, end machined\",Maker,Tr10x2,,4,USD,,,8,x.screw,,\n") != std::string::npos);
  CHECK(cutting_csv(list) ==
        "stock,manufacturer,part_number,axis,slot,section,count,length [mm],sum [mm],bar\n"
        "bar stock,generic,C45,x,spindle,diameter 12.5 mm,2,250,500,\n"
        "bar stock,generic,C45,,,sum,2,,500,\n"
        "guide rail,Rails Ltd,R20,x,guide,,1,600,600,1\n"
        "guide rail,Rails Ltd,R20,y,guide,,1,350,350,1\n"
        "guide rail,Rails Ltd,R20,x,guide,,1,600,600,2\n"
        "guide rail,Rails Ltd,R20,,,sum,3,,1550,\"2 bars of 1000 mm, left over 44 + 397 mm\"\n"
        "lead screw,Maker,Tr10x2,x,screw,,1,500,500,\n"
        "lead screw,Maker,Tr10x2,,,sum,1,,500,\n");
}

TEST_CASE("Order list as CSV: totals without a number, no text becomes a formula") {
  const std::string csv = order_csv(order_list(two_axes(), "Two axes"));
  CHECK(
      csv ==
      "line,quantity,unit,description,manufacturer,part_number,supplier,unit_price,currency,price_date,price_is,total,"
      "used_for,verify,converted_at\n"
      "1,6,pcs,guide carriage,Rails Ltd,R20,A shop,8,USD,2024-2026,estimate,48,\"x.guide, y.guide\",,\n"
      "2,1.55,m,guide rail,Rails Ltd,R20,A shop,20,USD,2024-2026,estimate,31,\"x.guide, y.guide\",,\n"
      "3,3,pcs,stepper motor,Maker,M1,B shop,9.5,USD,2026-09-27,,28.5,\"x.motor, y.motor\",,\n"
      "4,1,pcs,lead screw nut,'-2+3,\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\",,4,USD,,,4,x.nut,known only from a "
      "paper,\n"
      "5,0.8,kg,bar stock,generic,C45,,1.5,USD,,,1.2,x.spindle,,\n"
      ",,,\"Total, A shop\",,,,,USD,,,79,,,\n"
      ",,,\"Total, B shop\",,,,,USD,,,28.5,,,\n"
      ",,,\"Total, supplier not stated\",,,,,USD,,,5.2,,,\n"
      ",,,Total,,,,,USD,,,112.7,,,\n");
}

// The motors are stated at 3.80 EUR and cost 9.50 USD each, at a rate of 2.5; so is the shipping of 2 EUR.
TEST_CASE("Order list: what was converted says from which currency, at which rate of which day") {
  evaluation::Design design = two_axes();
  for (PartLine& line : design.parts)
    if (line.slot == "motor") line.stated_currency = "EUR";
  evaluation::ShopOrder order{"B shop", 28.5, 5.0, 0.0, 0.0};
  order.stated_currency = "EUR";
  design.orders = {order};
  design.conversions = {{"EUR", 2.5, "2026-01-15"}};
  const std::string csv = order_csv(order_list(design, ""));
  CHECK(csv.find("28.5,\"x.motor, y.motor\",,1 EUR = 2.5 USD (2026-01-15)\n") != std::string::npos);
  CHECK(csv.find("\"Shipping, B shop\",,,,,USD,,,5,,,1 EUR = 2.5 USD (2026-01-15)\n") != std::string::npos);
  CHECK(csv.find("48,\"x.guide, y.guide\",,\n") != std::string::npos);
  CHECK(conversion_lines(design, 200) ==
        "  Converted at 1 EUR = 2.5 USD (2026-01-15): x.motor 3.80 EUR, y.motor 7.60 EUR, shipping from B shop 2.00 "
        "EUR\n");
  // The same motor, half of them from the same shop in its own currency: one line each, for each has its own rate.
  design.parts[0].stated_currency.clear();
  CHECK(order_list(design, "").lines.size() == 6);
  design.conversions.front().date.clear();
  CHECK(order_csv(order_list(design, "")).find("1 EUR = 2.5 USD (date not stated)") != std::string::npos);
  CHECK(conversion_lines(two_axes(), 200).empty());
}

TEST_CASE("Nothing to buy is an empty list, not an error") {
  evaluation::Design nothing;
  nothing.currency = "EUR";
  const OrderList list = order_list(nothing, "");
  CHECK(order_csv(list).find(",,,Total,,,,,EUR,,,0,,,\n") != std::string::npos);
  text::Diagnostics diagnostics;
  CHECK(order_xlsx(list, diagnostics).has_value());
}

TEST_CASE("Date of a price: the day, else the years, that its basis names") {
  CHECK(price_date("StepperOnline list price, read 2026-09-27 (machine-frame-lab)") == "2026-09-27");
  CHECK(price_date("estimate 2024-2026 street price, +-30 %") == "2024-2026");
  CHECK(price_date("Leadshine US price of motor M2 item, 2026 (index id 63516944091)") == "2026");
  CHECK(price_date("part 12020-4, index 20261").empty());
  CHECK(price_date("").empty());
}

// --- the workbook
// ------------------------------------------------------------------------------------------------------

/// One member of a zip file, by a program that knows nothing of ours.
std::string unzipped(const std::string& archive, const std::string& member) {
  const std::string command = "unzip -p '" + archive + "' '" + member + "'";
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  REQUIRE(pclose(pipe) == 0);
  return text;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return {};
  const std::size_t first = at + begin.size();
  return text.substr(first, text.find(end, first) - first);
}

std::vector<std::string> shared_texts(const std::string& xml) {
  std::vector<std::string> texts;
  for (std::size_t at = xml.find("<si>"); at != std::string::npos; at = xml.find("<si>", at + 1))
    texts.push_back(between(xml.substr(xml.find("<t", at)), ">", "</t>"));
  return texts;
}

struct Cell {
  std::string value, formula;
};

/// The cells of a sheet by their names, "B2".
std::map<std::string, Cell> cells_of(const std::string& archive, int sheet) {
  const std::vector<std::string> texts = shared_texts(unzipped(archive, "xl/sharedStrings.xml"));
  const std::string xml = unzipped(archive, "xl/worksheets/sheet" + std::to_string(sheet) + ".xml");
  std::map<std::string, Cell> cells;
  for (std::size_t at = xml.find("<c r="); at != std::string::npos; at = xml.find("<c r=", at + 1)) {
    const std::string cell = xml.substr(at, xml.find("</c>", at) - at);
    const bool is_text = cell.substr(0, cell.find('>')).find("t=\"s\"") != std::string::npos;
    const std::string value = between(cell, "<v>", "</v>");
    cells[between(cell, "r=\"", "\"")] = {is_text ? texts.at(std::stoul(value)) : value, between(cell, "<f>", "</f>")};
  }
  return cells;
}

class WorkbookOfTwoAxes {
 public:
  WorkbookOfTwoAxes() {
    std::string pattern = (std::filesystem::temp_directory_path() / "millwright-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
    text::Diagnostics diagnostics;
    const auto bytes = order_xlsx(order_list(two_axes(), "Two axes"), diagnostics);
    REQUIRE(bytes.has_value());
    std::ofstream(file(), std::ios::binary) << *bytes;
  }
  ~WorkbookOfTwoAxes() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  WorkbookOfTwoAxes(const WorkbookOfTwoAxes&) = delete;
  WorkbookOfTwoAxes& operator=(const WorkbookOfTwoAxes&) = delete;
  std::string file() const { return (folder_ / "order.xlsx").string(); }

 private:
  std::filesystem::path folder_;
};

TEST_CASE("Order list as workbook: the same lines, with live totals") {
  const WorkbookOfTwoAxes book;
  const auto cells = cells_of(book.file(), 1);
  const auto value = [&](const char* name) { return cells.at(name).value; };
  CHECK(value("A1") == "line");
  CHECK(value("D2") == "guide carriage");
  CHECK(value("B2") == "6");
  CHECK(value("K2") == "estimate");
  CHECK(std::stod(value("H3")) == Approx(20.0));
  CHECK(value("D4") == "stepper motor");
  CHECK(value("G4") == "B shop");
  CHECK(value("I4") == "USD");
  CHECK(value("J4") == "2026-09-27");
  CHECK(std::stod(value("L4")) == Approx(28.5));
  CHECK(cells.at("L4").formula == "B4*H4");
  // Lines 1 to 5 are rows 2 to 6, the totals stand below a blank row.
  // The nut is known only from a paper, the motors are not.
  CHECK(value("N1") == "verify");
  CHECK(value("N5") == "known only from a paper");
  CHECK(cells.count("N4") == 0);
  CHECK(value("D8") == "Total, A shop");
  CHECK(cells.at("L8").formula == "SUM(L2:L3)");
  CHECK(std::stod(value("L8")) == Approx(79.0));
  CHECK(cells.at("L9").formula == "SUM(L4:L4)");
  CHECK(cells.at("L10").formula == "SUM(L5:L6)");
  CHECK(value("D11") == "Total");
  CHECK(cells.at("L11").formula == "SUM(L2:L6)");
  CHECK(std::stod(value("L11")) == Approx(112.7));
}

TEST_CASE("Order list as workbook: a text that looks like a formula is a text") {
  const WorkbookOfTwoAxes book;
  const auto cells = cells_of(book.file(), 1);
  CHECK(cells.at("E5").value == "-2+3");
  CHECK(cells.at("F5").value.rfind("=HYPERLINK(", 0) == 0);
  CHECK(cells.at("F5").formula.empty());
}

TEST_CASE("Order list as workbook: the cutting list is the second sheet") {
  const WorkbookOfTwoAxes book;
  CHECK(unzipped(book.file(), "xl/workbook.xml").find("name=\"Cutting list\"") != std::string::npos);
  const auto cells = cells_of(book.file(), 2);
  CHECK(cells.at("F2").value == "diameter 12.5 mm");
  CHECK(std::stod(cells.at("I3").value) == Approx(500.0));
  CHECK(cells.at("D4").value == "x");
  CHECK(std::stod(cells.at("H4").value) == Approx(600.0));
  CHECK(cells.at("I4").formula == "G4*H4");
  CHECK(cells.at("I6").formula == "SUM(I4:I5)");
  CHECK(std::stod(cells.at("I6").value) == Approx(1550.0));
}

}  // namespace
}  // namespace millwright::report::order_test
