// SPDX-License-Identifier: Apache-2.0
// Tables as makers and shops write them. Figures in SI were converted by hand: 1 ozf.in = 0.4448221615 N / 1.6 x 25.4
// mm = 0.00706155181 N.m, 1 lbf.in = 4.448221615 N x 25.4 mm = 0.112984829 N.m.
#include <algorithm>

#include "catalogue/import_table.h"
#include "catch.h"

namespace millwright::catalogue::import_test {
namespace {

constexpr const char* english =
    "ACME motors - price list 2026,,,,,,,,\n"
    ",,,,,,,,\n"
    "Brand,Model,Frame Size,Step Angle (deg),Holding Torque [oz.in],Rated Current (A),Weight (kg),Unit Price "
    "(USD),Lead wires\n"
    "ACME,007-1E5,NEMA 23,1.8,178,2.8,1.0,24.33,4\n"
    "NEMA 17 series,,,,,,,,\n"
    "ACME,007-2E5,NEMA 17,1.8,62,1.68,0.28,12.50,\"4, twisted\"\n";

TEST_CASE("A maker's table: header below titles, units in the header, part numbers stay text") {
  const Imported result = import_csv(english);
  INFO(result.complaints);
  REQUIRE(result.good);
  CHECK(result.meaning("Brand") == "manufacturer");
  CHECK(result.meaning("Model") == "part_number");
  CHECK(result.meaning("Holding Torque [oz.in]") == "holding_torque");
  CHECK(result.meaning("Weight (kg)") == "mass");
  CHECK(result.meaning("Lead wires") == "x_lead_wires");
  CHECK(result.column("Holding Torque [oz.in]").confidence > 0.9);
  CHECK(result.summary.rows == 2);
  CHECK(result.summary.left_out == 1);
  const Table table = result.table(Family::steppers);
  REQUIRE(table.rows() == 2);
  CHECK(table.part_number(0) == "007-1E5");
  CHECK(table.text("frame", 0) == "NEMA23");
  CHECK(table.number("holding_torque", 0) == Approx(178 * 0.00706155181).epsilon(1e-8));
  CHECK(table.number("step_angle", 0) == Approx(3.14159265 / 100));
  CHECK(table.price(0).piece == 24.33);
  CHECK(table.price(0).currency == "USD");
  CHECK(result.text.find("# ACME motors - price list 2026") != std::string::npos);
  CHECK(result.text.find("\"4, twisted\"") != std::string::npos);  // kept as it is
  CHECK(table.text("source", 0).find("table.csv") != std::string_view::npos);
}

TEST_CASE("Semicolons, decimal commas and a row of units") {
  const Imported result = import_csv(
      "Artikelnummer;Haltemoment;Nennstrom;Schrittwinkel;Rotortr\xC3\xA4gheitsmoment;Gewicht;Preis\n"
      ";Ncm;A;\xC2\xB0;g\xC2\xB7"
      "cm\xC2\xB2;kg;\xE2\x82\xAC\n"
      "ST5918;126,5;2,8;1,8;480;1,05;1.049,90\n"
      "ST4118;44;1,8;1,8;57;0,28;49,90\n",
      asking({{"manufacturer", "Nanotec"}}));
  INFO(result.complaints);
  REQUIRE(result.good);
  const Table table = result.table(Family::steppers);
  REQUIRE(table.rows() == 2);
  CHECK(table.manufacturer(0) == "Nanotec");
  CHECK(table.number("holding_torque", 0) == Approx(1.265));
  CHECK(table.number("rated_current", 0) == 2.8);
  CHECK(table.number("rotor_inertia", 0) == Approx(480e-7));
  CHECK(table.number("mass", 0) == 1.05);
  CHECK(table.price(0).piece == 1049.9);
  CHECK(table.price(0).currency == "EUR");
  CHECK(result.column("Haltemoment").unit_origin == UnitOrigin::units_row);
}

TEST_CASE("A row whose price is not known is in the currency of the others") {
  const std::string top = "Brand,Part No,Step angle (deg),Torque (N.m),Current (A),";
  for (const char* mapped : {"Preis netto EUR\nA,1,1.8,1.2,2.8,20\nA,2,1.8,1.2,2.8,n/a\nA,3,1.8,1.2,2.8,\n",
                             "Price\nA,1,1.8,1.2,2.8,20 EUR\nA,2,1.8,1.2,2.8,-\nA,3,1.8,1.2,2.8,\n"}) {
    const Imported result = import_csv(top + mapped);
    INFO(result.complaints);
    REQUIRE(result.good);
    CHECK(result.says("price is not known"));
    const Table table = result.table(Family::steppers);
    REQUIRE(table.rows() == 3);
    CHECK(std::isnan(table.price(1).piece));
    for (int row = 0; row < table.rows(); ++row) CHECK(table.price(row).currency == "EUR");
  }
  // What is stated for all rows does not go over what the table says of one.
  const std::string beside = top + "Price,Currency\nA,1,1.8,1.2,2.8,20,USD\nA,2,1.8,1.2,2.8,21,EUR\n";
  CHECK(import_csv(beside).table(Family::steppers).price(1).currency == "EUR");
  const Imported stated = import_csv(beside, asking({{"currency", "USD"}}));
  CHECK_FALSE(stated.good);
  CHECK(stated.says("EUR, but the currency is said to be USD for all rows"));
  // A price that says none has none.
  const Imported bare = import_csv(top + "Price\nA,1,1.8,1.2,2.8,20 EUR\nA,2,1.8,1.2,2.8,21\n");
  CHECK_FALSE(bare.good);
  CHECK(bare.says("currency is missing"));
}

TEST_CASE("Units in the cells: of one kind they stay, of several they are converted") {
  const Imported result = import_csv(
      "Brand,Part No,Step angle,Holding torque,Current,Inertia,Price\n"
      "A,1,1.8\xC2\xB0,1.26 N.m,2.8A,480 g.cm2,$ 24.33\n"
      "A,2,1.8\xC2\xB0,178 oz.in,2800 mA,0.48 kg.cm2,$ 20.10\n"
      "A,3,1.8\xC2\xB0,12 lb.in,3 A,-,19.00\n",
      asking({{"currency", "USD"}}));
  INFO(result.complaints);
  REQUIRE(result.good);
  const Table table = result.table(Family::steppers);
  CHECK(table.number("holding_torque", 0) == 1.26);
  CHECK(table.number("holding_torque", 1) == Approx(1.25695622).epsilon(1e-8));
  CHECK(table.number("holding_torque", 2) == Approx(1.35581795).epsilon(1e-8));
  CHECK(table.number("rated_current", 1) == 2.8);
  CHECK(table.number("rotor_inertia", 1) == Approx(480e-7));
  CHECK(std::isnan(table.number("rotor_inertia", 2)));
  CHECK(table.price(2).piece == 19.0);
}

TEST_CASE("A figure without a unit is not guessed") {
  const std::string table = "Brand,Part No,Step angle (deg),Torque (N.m),Current,Price (EUR)\nA,1,1.8,1.26,2.8,20\n";
  const Imported assumed = import_csv(table);
  REQUIRE(assumed.mapping);
  REQUIRE(assumed_units(*assumed.mapping).size() == 1);
  CHECK(assumed_units(*assumed.mapping)[0]->header == "Current");
  CHECK(assumed.column("Current").confidence < 0.5);
  const Imported said = import_csv(table, asking({{"unit:rated_current", "mA"}}));
  CHECK(assumed_units(*said.mapping).empty());
  CHECK(said.text.find("rated_current [mA]") != std::string::npos);
  CHECK_FALSE(said.good);  // 2.8 mA is no motor: lint
  const Imported some = import_csv(
      "Brand,Part No,Step angle (deg),Torque,Current (A),Price (EUR)\nA,1,1.8,1.26 N.m,2.8,20\nA,2,1.8,1.3,2.8,20\n");
  CHECK(some.says("table.csv:3:9: error: holding_torque: a figure without a unit"));
}

TEST_CASE("What a comma means is decided by the column, by the others, or not at all") {
  const auto table = [](const char* a, const char* b, const char* mass) {
    return std::string("Brand;Part No;Step angle (deg);Torque (N.cm);Current (A);Weight (g);Price (EUR)\n") + "A;1;1;" +
           a + ";2;" + mass + ";20\nA;2;1;" + b + ";2;" + mass + ";20\n";
  };
  const Imported by_column = import_csv(table("1,234", "98,5", "900"));
  CHECK(by_column.text.find("1.234") != std::string::npos);
  const Imported by_others = import_csv(table("126", "127", "1.050,5"));
  CHECK(by_others.text.find(",1050.5\n") != std::string::npos);
  const Imported other_column = import_csv(table("126", "12,5", "1,050"));
  CHECK(other_column.text.find(",1.050\n") != std::string::npos);
  const Imported open = import_csv(table("126", "127", "1,050"));
  CHECK_FALSE(open.good);
  CHECK(open.says(":2:13: error: mass: '1,050' may have a decimal mark or separate thousands"));
  ImportRequest request = asking();
  request.choices.mark = DecimalMark::point;
  CHECK(import_csv(table("126", "127", "1,050"), request).text.find(",1050\n") != std::string::npos);
  const Imported both = import_csv(table("12.5", "12,5", "900"));
  CHECK(both.says("holding_torque: decimal commas and decimal points in one column"));
}

TEST_CASE("A price per metre is no price of a piece, and a torque in mm is none") {
  const Imported screws = import_csv(
      "Model\td0 (mm)\tLead (mm)\tDyn. load C (kN)\tStat. load C0 (kN)\tRoot dia (mm)\tPrice EUR/m\tNut price (EUR)\n"
      "SFU1605\t16\t5\t7.65\t13.24\t12.9\t25.50\t18.90\n",
      asking({{"manufacturer", "TBI"}}, Family::ball_screws));
  INFO(screws.complaints);
  REQUIRE(screws.good);
  CHECK(screws.meaning("Price EUR/m") == "price_per_length");
  CHECK(screws.meaning("Nut price (EUR)") == "price");
  const Table table = screws.table(Family::ball_screws);
  CHECK(table.price(0).piece == 18.9);
  CHECK(table.price(0).length == 25.5);
  CHECK(table.number("dynamic_load_rating", 0) == Approx(7650.0));
  const Imported other = import_csv("Brand,Part No,Torque (mm),Current (A),Price (EUR)\nA,1,1.2,2,20\n");
  CHECK(other.meaning("Torque (mm)") == "x_torque_mm");
}

TEST_CASE("The point of an abbreviated currency is no decimal point") {
  const std::string top = "Brand,Part No,Step angle (deg),Torque (N.m),Current (A),Price\n";
  const Imported result =
      import_csv(top + "A,1,1.8,1.2,2.8,kr.500\nA,2,1.8,1.2,2.8,kr. 450\n", asking({{"currency", "SEK"}}));
  INFO(result.complaints);
  CHECK(result.text.find(",500,SEK") != std::string::npos);
  CHECK(result.text.find(",450,SEK") != std::string::npos);
}

constexpr const char* screw_top = "Model,d0 (mm),Lead (mm),Dyn. load C (kN),Stat. load C0 (kN),Root dia (mm),";
constexpr const char* screw = "16,5,7.65,13.24,12.9,";

TEST_CASE("Two prices of one row in two currencies are reported") {
  const auto import = [](const char* nut, const char* shaft) {
    return import_csv(std::string(screw_top) + nut + "," + shaft + "\nS1," + screw + "18.9,25.5\n",
                      asking({{"manufacturer", "TBI"}}, Family::ball_screws));
  };
  const Imported two = import("Price [EUR]", "Price per length [USD/m]");
  CHECK_FALSE(two.good);
  CHECK(two.says("the row's other price is in EUR"));
  const Imported one = import("Price [EUR]", "Price per length [EUR/m]");
  INFO(one.complaints);
  CHECK_FALSE(one.says("the row's other price"));
  CHECK(one.text.find("EUR") != std::string::npos);
}

TEST_CASE("A bare price per foot among prices per metre is one per foot") {
  const Imported result = import_csv(std::string(screw_top) + "Price [EUR],Price per length [EUR/ft]\nS1," + screw +
                                         "18.9,EUR 30/m\nS2," + screw + "18.9,25\n",
                                     asking({{"manufacturer", "TBI"}}, Family::ball_screws));
  INFO(result.complaints << result.text);
  CHECK(result.text.find("price_per_length [1/m]") != std::string::npos);
  CHECK(result.text.find("82.02099737") != std::string::npos);  // 25 / 0.3048
  const Imported open = import_csv(
      std::string(screw_top) + "Price [EUR],Price per length\nS1," + screw + "18.9,EUR 30/m\nS2," + screw + "18.9,25\n",
      asking({{"manufacturer", "TBI"}}, Family::ball_screws));
  CHECK(open.says("price_per_length: a figure without a unit"));
}

TEST_CASE("The price of many pieces is not taken for that of one") {
  for (const char* header : {"Price/100", "Price per 10", "Price per 100 pcs", "Price 10+"}) {
    INFO(header);
    const Imported result = import_csv(std::string("Brand,Part No,Step angle (deg),Torque (N.m),Current (A),") +
                                           header + ",Unit price (EUR)\nA,1,1.8,1.2,2.8,19,24.33\n",
                                       asking());
    REQUIRE(result.mapping);
    CHECK_FALSE(result.column(header).target.has_value());
    CHECK(result.meaning("Unit price (EUR)") == "price");
    const auto& remarks = result.mapping->remarks;
    CHECK(std::any_of(remarks.begin(), remarks.end(), [&](const std::string& remark) {
      return remark.find(header) != std::string::npos && remark.find("not taken as price") != std::string::npos;
    }));
  }
}

TEST_CASE("Three decimals behind a comma are read as the other columns tell, and no column is lost to them") {
  const Imported result = import_csv(
      "Model;Torque (Nm);Current (A);Step angle (deg);Length (mm);Weight (kg);Price (EUR)\n"
      "A1;1,260;2,8;1,8;56,000;1,100;20,50\nA2;1,890;2,8;1,8;76,500;1,600;25,90\n",
      asking({{"manufacturer", "ACT"}}));
  INFO(result.complaints << result.text);
  CHECK(result.good);
  CHECK(result.meaning("Torque (Nm)") == "holding_torque");
  CHECK(result.meaning("Length (mm)") == "body_length");
  CHECK(result.meaning("Weight (kg)") == "mass");
  CHECK(result.text.find("1.100") != std::string::npos);
  CHECK(result.text.find("1100") == std::string::npos);
}

TEST_CASE("A column that is not taken because of its figures is named, with what would take it") {
  const Imported result = import_csv(
      "Model,Torque (N.m),Current (A),Step angle (deg),Weight (kg),Price (EUR)\n"
      "A1,1.26,2.8,1.8,700,20\nA2,1.89,2.8,1.8,1100,25\n",
      asking({{"manufacturer", "ACT"}}));
  REQUIRE(result.mapping);
  CHECK_FALSE(result.column("Weight (kg)").target.has_value());
  const auto& remarks = result.mapping->remarks;
  CHECK(std::count_if(remarks.begin(), remarks.end(), [](const std::string& remark) {
          return remark.find("'Weight (kg)' looks like mass, but 2 of 2 figures are not plausible") == 0 &&
                 remark.find("--unit mass=kg") != std::string::npos;
        }) == 1);
}

TEST_CASE("The command line goes before the mapping file, and nothing is said twice") {
  const TemporaryFolder folder;
  const auto complaints = [&](const std::string& mapping, ImportRequest& request) {
    text::Diagnostics diagnostics;
    read_mapping(folder.write("m.toml", "family = \"steppers\"\n" + mapping).string(), request, diagnostics);
    return text::format(diagnostics);
  };
  const auto refusal = [](const std::vector<std::pair<std::string, std::string>>& words) {
    try {
      (void)asking(words);
      return std::string();
    } catch (const std::runtime_error& problem) {
      return std::string(problem.what());
    }
  };
  ImportRequest said = asking({{"mass", "2 kg"}, {"unit:holding_torque", "N.cm"}});
  CHECK(complaints("[columns]\nmass = { from = \"W\" }\nholding_torque = { from = \"T\", unit = \"N.m\" }\n", said)
            .empty());
  REQUIRE(said.choices.columns.size() == 1);  // the mass is constant
  CHECK(said.choices.columns[0].from == "T");
  CHECK(said.choices.columns[0].unit == "N.cm");
  ImportRequest both;
  CHECK(complaints("[constants]\nmass = \"2 kg\"\n[columns]\nmass = { from = \"W\" }\n", both)
            .find("m.toml:5:1: error: mass is among the constants and among the columns") != std::string::npos);
  ImportRequest constant = asking({{"unit:mass", "g"}});
  CHECK(complaints("[constants]\nmass = \"2 kg\"\n[columns]\nprice = { from = \"P\" }\n", constant)
            .find("the mapping file has mass as a constant") != std::string::npos);
  ImportRequest nowhere = asking({{"unit:mass", "g"}});
  CHECK(complaints("[columns]\nprice = { from = \"P\" }\n", nowhere).find("the mapping file has no column mass") !=
        std::string::npos);
  CHECK(refusal({{"mass", "2 kg"}, {"mass", "3 kg"}}).find("mass is named twice") != std::string::npos);
  CHECK(refusal({{"unit:mass", "kg"}, {"unit:mass", "g"}}).find("mass is named twice") != std::string::npos);
  CHECK(refusal({{"mass", "2 kg"}, {"unit:mass", "g"}}).find("mass is named twice") != std::string::npos);
}

TEST_CASE("Long cells above the header are no header") {
  const std::string words = " (" + std::string(80, 'x') + ")";
  const Imported result =
      import_csv("Brand" + words + ",Torque" + words + ",Current" + words +
                 "\nBrand,Part No,Step angle (deg),Torque (N.m),Current (A),Price (EUR)\nA,1,1.8,1.2,2.8,20\n");
  INFO(result.complaints);
  REQUIRE(result.mapping);
  CHECK(result.mapping->header.line == 2);
  CHECK(result.meaning("Brand") == "manufacturer");
}

TEST_CASE("Required columns that come from nowhere are named") {
  const Imported result = import_csv("Part No,Torque (N.m),Weight (kg)\nA1,1.2,1\n");
  CHECK_FALSE(result.good);
  for (const char* name : {"manufacturer", "step_angle", "rated_current", "price", "currency"})
    CHECK(result.says(std::string("nothing in the table gives ") + name));
}

TEST_CASE("Findings of lint stand at the cells of the table that was read") {
  const Imported result = import_csv(
      "Part No,Brand,Step angle (deg),Torque (N.m),Current (A),Price "
      "(EUR)\nP1,A,1.8,1.2,2.8,20\nP2,A,1.8,1260,2.8,20\nP1,A,1.8,1.2,2.8,20\n");
  INFO(result.complaints);
  CHECK_FALSE(result.good);
  CHECK(result.says("table.csv:3:10: error: P2: holding_torque 1260 N.m is outside"));
  CHECK(result.says("table.csv:4:1: error: duplicate part 'P1'"));
}

TEST_CASE("A mapping is saved and read back, for the next price list too") {
  const TemporaryFolder folder;
  const Imported first = import_csv(english);
  ImportRequest request = asking();
  const std::string saved = mapping_text(*first.mapping, request, true);
  INFO(saved);
  ImportRequest replay;
  text::Diagnostics diagnostics;
  read_mapping(folder.write("m.toml", saved).string(), replay, diagnostics);
  CHECK(text::format(diagnostics).empty());
  REQUIRE(replay.family == Family::steppers);
  // Another order, another column, other prices.
  const Imported next = import_csv(
      "Unit Price (USD),Brand,Model,Frame Size,Step Angle (deg),Colour,Holding Torque [oz.in],Rated Current (A),Weight "
      "(kg)\n"
      "26.00,ACME,007-1E5,NEMA 23,1.8,black,178,2.8,1.0\n",
      replay);
  INFO(next.complaints);
  REQUIRE(next.good);
  CHECK(next.meaning("Colour") == "x_colour");
  CHECK(next.table(Family::steppers).price(0).piece == 26.0);
  const Imported other = import_csv("Brand,Model,Torque\nACME,1,2\n", replay);
  CHECK(other.says("m.toml:"));
  CHECK(other.says("error: the table has no column 'Holding Torque [oz.in]'"));
}

TEST_CASE("Mistakes of a mapping file are reported at their places") {
  const TemporaryFolder folder;
  ImportRequest request;
  text::Diagnostics diagnostics;
  read_mapping(
      folder
          .write("m.toml",
                 "family = \"steppers\"\ncolour = 1\n[constants]\nmaker = \"A\"\nmass = \"3 mm\"\n[columns]\n"
                 "holding_torque = { from = \"T\", unit = \"kg\", decimal = \"dot\" }\nprice = { unit = \"EUR\" }\n")
          .string(),
      request,
      diagnostics);
  const std::string complaints = text::format(diagnostics);
  INFO(complaints);
  for (const char* place : {"m.toml:2:1: error",
                            "m.toml:4:1: error",
                            "m.toml:5:8: error",
                            "m.toml:7:39: error",
                            "m.toml:7:55: error",
                            "m.toml:8:"})
    CHECK(complaints.find(place) != std::string::npos);
}

TEST_CASE("Other encodings are read when they are said or certain") {
  const std::string latin =
      "Brand;Part No;Step angle (\xB0);Torque (N.m);Current (A);Price (\x80)\nA;\xD6l;1,8;1,2;2,8;20\n";
  const Imported unknown = import_csv(latin);
  CHECK(unknown.says("is not UTF-8"));
  CHECK(unknown.says("--encoding windows-1252"));
  ImportRequest request = asking();
  request.format.encoding = "windows-1252";
  const Imported said = import_csv(latin, request);
  INFO(said.complaints);
  REQUIRE(said.good);
  CHECK(said.table(Family::steppers).part_number(0) == "\xC3\x96l");
  CHECK(said.table(Family::steppers).price(0).currency == "EUR");
  std::string wide = "\xFF\xFE";
  for (const char c : std::string(
           "Brand\tPart No\tStep angle (deg)\tTorque (N.m)\tCurrent (A)\tPrice (EUR)\nA\tX1\t1.8\t1.2\t2.8\t20\n")) {
    wide += c;
    wide += '\0';
  }
  const Imported utf_16 = import_csv(wide);
  INFO(utf_16.complaints);
  REQUIRE(utf_16.good);
  CHECK(utf_16.table(Family::steppers).part_number(0) == "X1");
}

TEST_CASE("Columns whose name begins with x_ are nobody's business") {
  text::Diagnostics diagnostics;
  const Imported result = import_csv(english);
  read_table(text::SourceText::from_string("a.csv", result.text), Family::steppers, 0, diagnostics);
  CHECK(text::format(diagnostics).find("is ignored") == std::string::npos);
}

TEST_CASE("Columns that speak of a figure's source, confidence and tolerance become its companions") {
  const Imported result = import_csv(
      "Brand,Part No,Step angle (deg),Holding torque (N.cm),Torque tolerance,Holding torque source,Current (A),"
      "Rotor inertia (g.cm2),rotor_inertia_confidence,Tolerance of rotor inertia (%),Step angle tolerance,Price source,"
      "Price (EUR),Mass tolerance\n"
      "ACME,1,1.8,126,\xC2\xB1 8 %,measured 2026,2.8,480,low,10,\xC2\xB1 5 %,list,24.33,5 %\n"
      "ACME,2,1.8,44,5 N.cm,-,1.7,57,high,2.5,\xC2\xB1 5 %,list,12.50,5 %\n"
      "ACME,3,1.8,60,n/a,,1.7,70,,,\xC2\xB1 5 %,,13.50,\n");
  INFO(result.complaints);
  REQUIRE(result.good);
  CHECK(result.meaning("Torque tolerance") == "holding_torque_tolerance");
  CHECK(result.meaning("Holding torque source") == "holding_torque_source");
  CHECK(result.meaning("rotor_inertia_confidence") == "rotor_inertia_confidence");
  CHECK(result.meaning("Tolerance of rotor inertia (%)") == "rotor_inertia_tolerance");
  CHECK(result.meaning("Price source") == "price_source");
  // A step angle takes no tolerance, and of masses the table has none: kept as they are.
  CHECK(result.meaning("Step angle tolerance") == "x_step_angle_tolerance");
  CHECK(result.meaning("Mass tolerance") == "x_mass_tolerance");
  CHECK(result.column("Tolerance of rotor inertia (%)").unit == "%");
  const Table table = result.table(Family::steppers);
  REQUIRE(table.rows() == 3);
  const Column torque = column(Family::steppers, "holding_torque");
  const Column inertia = column(Family::steppers, "rotor_inertia");
  // 8 % of 1.26 N.m; 5 N.cm; of 480e-7 kg.m2 a tenth, of 57e-7 2.5 %.
  CHECK(table.half_width(0, torque) == Approx(0.08 * 1.26));
  CHECK(table.half_width(1, torque) == Approx(0.05));
  CHECK_FALSE(table.half_width(2, torque) > 0.0);
  CHECK(table.half_width(0, inertia) == Approx(0.1 * 480e-7));
  CHECK(table.half_width(1, inertia) == Approx(0.025 * 57e-7));
  CHECK(table.figure_source(0, torque) == "measured 2026");
  CHECK(table.figure_confidence(0, inertia) == "low");
  CHECK(table.figure_confidence(1, inertia) == "high");
}

TEST_CASE("Companions in German, with decimal commas, and by a mapping file that is replayed") {
  const std::string contents =
      "Artikelnummer;Haltemoment (Ncm);Haltemoment Toleranz;Quelle Haltemoment;Nennstrom (A);Schrittwinkel "
      "(deg);Preis (EUR)\n"
      "S1;126,5;\xC2\xB1 2,5 %;Datenblatt 3;2,8;1,8;49,90\n";
  ImportRequest request = asking({{"manufacturer", "Nanotec"}});
  const Imported result = import_csv(contents, request);
  INFO(result.complaints);
  REQUIRE(result.good);
  const Column torque = column(Family::steppers, "holding_torque");
  const Table table = result.table(Family::steppers);
  CHECK(table.half_width(0, torque) == Approx(0.025 * 1.265));
  CHECK(table.figure_source(0, torque) == "Datenblatt 3");
  const TemporaryFolder folder;
  const auto replayed = [&](const std::string& mapping, const std::string& prices) {
    const std::string file = folder.write("m.toml", mapping).string();
    ImportRequest again;
    text::Diagnostics diagnostics;
    read_mapping(file, again, diagnostics);
    if (diagnostics.has_errors()) throw std::runtime_error(text::format(diagnostics));
    return import_csv(prices, again);
  };
  const std::string mapping = mapping_text(*result.mapping, request, true);
  CHECK(mapping.find("holding_torque_tolerance = { from = \"Haltemoment Toleranz\" }") != std::string::npos);
  const Imported second = replayed(mapping, contents);
  INFO(second.complaints);
  REQUIRE(second.good);
  CHECK(second.text == result.text);
  // Named by somebody, with the unit of its figures.
  const std::string own =
      "family = \"steppers\"\n[constants]\nmanufacturer = \"N\"\ncurrency = \"EUR\"\n[columns]\n"
      "part_number = { from = \"A\" }\nstep_angle = { from = \"S\", unit = \"deg\" }\n"
      "holding_torque = { from = \"H\", unit = \"N.cm\" }\nrated_current = { from = \"I\", unit = \"A\" }\n"
      "price = { from = \"P\" }\nholding_torque_tolerance = { from = \"T\", unit = \"N.cm\" }\n";
  const Imported named = replayed(own, "A,S,H,I,P,T\n1,1.8,126,2.8,20,12\n");
  INFO(named.complaints);
  REQUIRE(named.good);
  CHECK(named.table(Family::steppers).half_width(0, torque) == Approx(0.12));
  const Imported missing = replayed(own, "A,S,H,I,P,Q\n1,1.8,126,2.8,20,12\n");
  CHECK_FALSE(missing.good);
  CHECK(missing.says("the table has no column 'T'"));
}

TEST_CASE("A tolerance of what takes none is kept, and is no other column") {
  for (const std::string price : {"Price (EUR)", "price_eur"})
    for (const std::string name : {"price_tolerance", "Preis Toleranz", "Tolerance of price (%)", "frame_tolerance"}) {
      const Imported result = import_csv("Brand,Part No,Step angle (deg),Torque (N.cm),Current (A)," + price + "," +
                                             name + "\nA,1,1.8,126,2.8,20,5\nA,2,1.8,126,2.8,21,10\n",
                                         asking({{"currency", "EUR"}}));
      INFO(name << " " << result.meaning(name) << result.complaints);
      REQUIRE(result.good);
      CHECK(result.meaning(price) == "price");
      CHECK(result.meaning(name).starts_with("x_"));
      CHECK(result.table(Family::steppers).price(1).piece == 21.0);
    }
  // Alone it is no price either.
  CHECK(import_csv("Brand,Part No,Step angle (deg),Torque (N.cm),Current (A),price_tolerance\nA,1,1.8,126,2.8,5\n")
            .says("nothing in the table gives price"));
}

TEST_CASE("Confidences in three languages become ours, and what is none is an error at its cell") {
  const std::string head = "Brand,Part No,Step angle (deg),Torque (N.cm),Current (A),Price (EUR),";
  for (const std::string name : {"Konfidenz", "Vertrauen", "Vertrauensw\xC3\xBCrdigkeit", "Keyakinan", "Confidence"}) {
    const Imported result =
        import_csv(head + name + "\nA,1,1.8,126,2.8,20,Hoch\nA,2,1.8,126,2.8,20,LOW\nA,3,1.8,126,2.8,20,n/a\n");
    INFO(name << result.complaints);
    REQUIRE(result.good);
    CHECK(result.meaning(name) == "confidence");
    const Table table = result.table(Family::steppers);
    CHECK(table.confidence(0) == "high");
    CHECK(table.confidence(1) == "low");
    CHECK(table.confidence(2).empty());
  }
  const Imported bad = import_csv(head + "Konfidenz\nA,1,1.8,126,2.8,20,95 %\nA,2,1.8,126,2.8,20,hihg\n");
  CHECK_FALSE(bad.good);
  CHECK(bad.says("table.csv:2:20: error: confidence: '95 %' is no confidence"));
  CHECK(bad.says("write high, medium or low"));
  CHECK(bad.says("table.csv:3:20: error: confidence: 'hihg' is no confidence"));
  CHECK(bad.says("did you mean 'high'?"));
  const Imported of_figure = import_csv(head + "Vertrauen Torque\nA,1,1.8,126,2.8,20,niedrig\n");
  INFO(of_figure.complaints);
  REQUIRE(of_figure.good);
  CHECK(of_figure.meaning("Vertrauen Torque") == "holding_torque_confidence");
  CHECK(of_figure.table(Family::steppers).figure_confidence(0, column(Family::steppers, "holding_torque")) == "low");
  CHECK(import_csv(head + "Vertrauen Torque\nA,1,1.8,126,2.8,20,5\n").says("'5' is no confidence"));
  ImportRequest request = asking();
  text::Diagnostics diagnostics;
  add_constant(request, "confidence", "lwo", {}, diagnostics);
  CHECK(text::format(diagnostics).find("confidence: 'lwo' is no confidence") != std::string::npos);
}

TEST_CASE("A header without parts below it is an error at the header") {
  const Imported alone =
      import_csv("Price list,,\nBrand,Part No,Step angle (deg),Torque (N.cm),Current (A),Price (EUR)\n");
  CHECK_FALSE(alone.good);
  CHECK(alone.summary.rows == 0);
  CHECK(alone.says("table.csv:2:1: error: there are no parts below the header"));
}

TEST_CASE("A companion that is no tolerance, or of another unit than its column, is an error at its cell") {
  const std::string head = "Brand,Part No,Step angle (deg),Torque (N.cm),Current (A),Price (EUR),Torque tolerance";
  const Imported words = import_csv(head + "\nACME,1,1.8,126,2.8,20,rough\n");
  CHECK_FALSE(words.good);
  CHECK(words.says("table.csv:2:23: error: holding_torque_tolerance: 'rough' is no tolerance"));
  const Imported both = import_csv(head + " (%)\nACME,1,1.8,126,2.8,20,5 N.cm\n");
  CHECK_FALSE(both.good);
  CHECK(both.says("has another unit than its column, %"));
  // A bare 5 is five times the figure: lint says so, nothing is guessed.
  const Imported bare = import_csv(head + "\nACME,1,1.8,126,2.8,20,5\n");
  CHECK_FALSE(bare.good);
  CHECK(bare.says("is as large as the figure itself"));
  CHECK(import_csv(head + "\nACME,1,1.8,126,2.8,20,0.05\n").good);
}

}  // namespace
}  // namespace millwright::catalogue::import_test
