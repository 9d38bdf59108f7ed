// SPDX-License-Identifier: Apache-2.0
// The shipped catalogues: they load clean, the figures are the published ones, and estimates stay marked.
#include <cmath>
#include <map>
#include <set>

#include "catalogue/catalogue.h"
#include "catalogue/column_unit.h"
#include "catalogue/lint.h"
#include "catalogue/listing.h"
#include "catch.h"
#include "temporary_folder.h"

namespace shipped_test {

using namespace millwright;
using namespace millwright::catalogue;

namespace {

const Catalogue& shipped() {
  static const Catalogue catalogue = [] {
    text::Diagnostics diagnostics;
    Catalogue loaded = Catalogue::load({std::filesystem::path(MILLWRIGHT_SOURCE_DIR) / "catalogues"}, diagnostics);
    INFO(text::format(diagnostics));
    REQUIRE(diagnostics.count() == 0);
    return loaded;
  }();
  return catalogue;
}

int row_of(Family family, const std::string& part) {
  const Found found = shipped().table(family).find(part);
  INFO(part << ": " << found.error);
  REQUIRE(found.rows.size() == 1);
  return found.rows.front();
}

struct Published {
  Family family;
  std::string part;
  std::string column;
  double value;  ///< in SI, as printed by maker or standard
};

}  // namespace

TEST_CASE("all shipped rows load without a complaint") {
  const std::map<Family, int> rows = {{Family::steppers, 174},
                                      {Family::stepper_curves, 160},
                                      {Family::ball_screws, 170},
                                      {Family::lead_screws, 49},
                                      {Family::lead_nuts, 40},
                                      {Family::threads, 26},
                                      {Family::screws, 75},
                                      {Family::support_bearings, 61},
                                      {Family::couplings, 36},
                                      {Family::linear_guides, 64},
                                      {Family::belts, 35},
                                      {Family::pulleys, 84},
                                      {Family::racks, 15},
                                      {Family::pinions, 116},
                                      {Family::drivers, 41},
                                      {Family::power_supplies, 44},
                                      {Family::extrusions, 37},
                                      {Family::steel_sections, 90},
                                      {Family::materials, 38}};
  CHECK(shipped().rows() == 1355);
  for (const auto& [family, count] : rows) {
    INFO(declaration(family).name);
    CHECK(shipped().table(family).rows() == count);
  }
}

TEST_CASE("a sample of figures is what maker and standard print") {
  constexpr double kgcm = 1e-7, mm = 1e-3, mm2 = 1e-6, MPa = 1e6, rpm = 2 * 3.14159265358979323846 / 60;
  const std::vector<Published> sample = {
      {Family::steppers, "QSH5718-76-28-189", "holding_torque", 1.89},
      {Family::steppers, "QSH5718-76-28-189", "rated_current", 2.8},
      {Family::steppers, "QSH5718-76-28-189", "phase_resistance", 1.13},
      {Family::steppers, "QSH5718-76-28-189", "phase_inductance", 3.6e-3},
      {Family::steppers, "QSH5718-76-28-189", "rotor_inertia", 480 * kgcm},
      {Family::steppers, "QSH5718-76-28-189", "detent_torque", 0.066},
      {Family::steppers, "QSH5718-76-28-189", "mass", 1.0},
      {Family::steppers, "QSH5718-76-28-189", "maximum_voltage", 75},
      {Family::ball_screws, "BNK1402-3", "root_diameter", 13 * mm},
      {Family::ball_screws, "BNK1402-3", "lead", 2 * mm},
      {Family::ball_screws, "BNK1402-3", "dynamic_load_rating", 1800},
      {Family::ball_screws, "BNK1402-3", "static_load_rating", 4300},
      {Family::ball_screws, "BNK1402-3", "dn_limit", 100000 * mm * rpm},
      {Family::ball_screws, "BNK1402-3", "lead_error_per_300mm", 18e-6},
      {Family::lead_screws, "Tr16x4", "pitch_diameter", 14 * mm},
      {Family::lead_screws, "Tr16x4", "minor_diameter", 11.5 * mm},
      {Family::lead_screws, "Tr16x4", "nut_major_diameter", 16.5 * mm},
      {Family::lead_nuts, "T8x8 POM flange", "allowable_pressure", 5 * MPa},
      {Family::lead_nuts, "T8x8 POM flange", "maximum_pv", 0.1 * MPa},
      {Family::linear_guides, "HGH20CA", "dynamic_load_rating", 17750},
      {Family::linear_guides, "HGH20CA", "static_load_rating", 27760},
      {Family::linear_guides, "HGH20CA", "rating_distance", 50e3},
      {Family::linear_guides, "HGH20CA", "rail_mass_per_length", 2.21},
      {Family::linear_guides, "HGH20CA", "radial_stiffness", 232e6},
      {Family::couplings, "ROTEX GS 14 98ShA", "rated_torque", 12.5},
      {Family::couplings, "ROTEX GS 14 98ShA", "torsional_stiffness", 171.9},
      {Family::couplings, "ROTEX GS 14 98ShA", "inertia", 5.57e-6},
      {Family::couplings, "ROTEX GS 14 98ShA", "maximum_speed", 15900 * rpm},
      {Family::power_supplies, "LRS-350-48", "output_current", 7.3},
      {Family::power_supplies, "LRS-350-48", "efficiency", 0.89},
      // DIN 867: pitch 2 pi, teeth 2.25 modules high; 20 (20 - 1.06 * 2) mm2 of steel; 159 teeth a piece.
      {Family::racks, "m2 20x20x1000 Q10", "pitch", 6.2832 * mm},
      {Family::racks, "m2 20x20x1000 Q10", "pitch_height", 18 * mm},
      {Family::racks, "m2 20x20x1000 Q10", "mass_per_length", 2.807},
      {Family::racks, "m2 20x20x1000 Q10", "piece_length", 999.03 * mm},
      {Family::pinions, "m1.5 z20 bore14", "pitch_diameter", 30 * mm},
      {Family::pinions, "m1.5 z20 bore14", "outside_diameter", 33 * mm},
      {Family::materials, "S355JR", "yield_strength", 355 * MPa},
      {Family::materials, "S355JR", "density", 7850},
      {Family::materials, "S355JR", "maximum_service_temperature", 673.15},
      {Family::materials, "S355JR", "thermal_expansion", 1.2e-5},
      {Family::steel_sections, "UPN 100", "second_moment_x", 206e-8},
      {Family::steel_sections, "UPN 100", "section_modulus_x", 41.2e-6},
      {Family::steel_sections, "UPN 100", "area", 1350 * mm2},
      {Family::steel_sections, "UPN 100", "mass_per_length", 10.6},
      {Family::threads, "M8", "pitch_diameter", 7.188 * mm},
      {Family::threads, "M8", "tensile_stress_area", 36.61 * mm2},
      {Family::screws, "ISO4762 M8 8.8", "proof_load", 21233},
      {Family::belts, "GT2-9mm", "tensile_stiffness", 25400},
      {Family::pulleys, "GT2 20T 6mm bore5", "pitch_diameter", 12.732 * mm},
      {Family::support_bearings, "BK12", "axial_stiffness", 88e6},
      {Family::drivers, "TMC2209", "rms_current", 1.7},
      {Family::extrusions, "HFS5-2020", "second_moment_x", 7400e-12},
  };
  for (const Published& each : sample) {
    INFO(each.part << " " << each.column);
    const Table& table = shipped().table(each.family);
    CHECK(table.number(each.column, row_of(each.family, each.part)) == Approx(each.value).epsilon(1e-14));
  }
  const Table& screws = shipped().table(Family::ball_screws);
  const int screw = row_of(Family::ball_screws, "BNK1402-3");
  const Price price = screws.price(screw);
  CHECK(price.piece == 222.0);
  CHECK(price.length == Approx(363.0).epsilon(1e-14));
  CHECK(price.currency == "USD");
  CHECK(screws.is_price_estimate(screw));
}

TEST_CASE("estimates stay marked") {
  const Table& motors = shipped().table(Family::steppers);
  const Column torque = column(Family::steppers, "holding_torque"), inertia = column(Family::steppers, "rotor_inertia");
  const Column resistance = column(Family::steppers, "phase_resistance"), price = column(Family::steppers, "price");
  const int paper = row_of(Family::steppers, "TPE17M-32A");  // torque and inertia as in the paper, the rest typical
  CHECK_FALSE(motors.is_estimate(paper, torque));
  CHECK_FALSE(motors.is_estimate(paper, inertia));
  CHECK(motors.is_estimate(paper, resistance));
  CHECK(motors.is_estimate(paper, price));
  CHECK(motors.tolerance(paper, price) == Approx(0.3));
  CHECK_FALSE(motors.is_estimate(paper, column(Family::steppers, "frame")));
  const int ldo = row_of(Family::steppers, "LDO-42STH48-2004AC");
  CHECK(motors.is_estimate(ldo, inertia));
  CHECK(motors.tolerance(ldo, inertia) == Approx(0.25));
  CHECK(std::isnan(motors.tolerance(ldo, torque)));
  const Table& screws = shipped().table(Family::ball_screws);
  const Column root = column(Family::ball_screws, "root_diameter");
  CHECK(screws.is_estimate(row_of(Family::ball_screws, "SFU2505-4 (generic)"), root));
  CHECK_FALSE(screws.is_estimate(row_of(Family::ball_screws, "BNK1402-3"), root));
  const Table& belts = shipped().table(Family::belts);
  CHECK(belts.is_estimate(row_of(Family::belts, "GT2-9mm"), column(Family::belts, "breaking_tension")));
  CHECK_FALSE(belts.is_estimate(row_of(Family::belts, "GT2-9mm"), column(Family::belts, "tensile_stiffness")));
  CHECK(belts.is_estimate(row_of(Family::belts, "HTD5M-15mm"), column(Family::belts, "tensile_stiffness")));
}

TEST_CASE("standing and tolerance of basis texts") {
  CHECK(standing_of("datasheet") == Standing::published);
  CHECK(standing_of("family_estimate +-25 %") == Standing::estimated);
  CHECK(standing_of("computed: d - 0.83*ball diameter") == Standing::computed);
  CHECK(standing_of("General knowledge") == Standing::remembered);
  CHECK(standing_of("") == Standing::unstated);
  CHECK(standing_of("StepperOnline list price, read 2026-09-27") == Standing::published);
  CHECK(stated_tolerance("estimate, +-40 % (genuine 5x)") == Approx(0.4));
  CHECK(stated_tolerance("\u00B1 5%") == Approx(0.05));
  CHECK(std::isnan(stated_tolerance("+-0.02..0.1 Nm")));
  CHECK(std::isnan(stated_tolerance("read 2026")));
}

TEST_CASE("every row says where it comes from") {
  for (const FamilyDeclaration& family : families) {
    const Table& table = shipped().table(family.family);
    for (int row = 0; row < table.rows(); ++row) {
      INFO(family.name << " " << table.part_number(row));
      CHECK_FALSE(table.text("source", row).empty());
      CHECK(std::set<std::string_view>{"high", "medium", "low"}.contains(table.confidence(row)));
      if (!family.priced()) continue;
      CHECK_FALSE(table.text("price_basis", row).empty());
      const Price price = table.price(row);
      CHECK((!family.priced_per_piece || price.piece > 0.0));
      CHECK((!family.priced_per_length || price.length > 0.0));
      CHECK((!family.priced_per_mass || price.mass > 0.0));
    }
  }
}

TEST_CASE("lint finds nothing impossible in the shipped catalogues") {
  text::Diagnostics diagnostics;
  const LintSummary summary =
      lint_files({std::filesystem::path(MILLWRIGHT_SOURCE_DIR) / "catalogues"}, std::nullopt, diagnostics);
  INFO(text::format(diagnostics));
  CHECK(summary.errors == 0);
  CHECK(summary.warnings <= 16);  // three makers of ball screws publish no nut mass; odd rows: seeded_faults_test.cpp
  CHECK(summary.rows == 1355);
}

TEST_CASE("every nut fits a lead screw, every curve and belt has its partner") {
  const Table& nuts = shipped().table(Family::lead_nuts);
  const Table& screws = shipped().table(Family::lead_screws);
  std::set<std::string_view> names;
  for (int row = 0; row < screws.rows(); ++row)
    names.insert({screws.part_number(row), screws.text("designation", row)});
  for (int row = 0; row < nuts.rows(); ++row) CHECK(names.contains(nuts.text("for_screw", row)));
  const Table& threads = shipped().table(Family::threads);
  const Table& fasteners = shipped().table(Family::screws);
  for (int row = 0; row < fasteners.rows(); ++row) CHECK(threads.find(fasteners.text("designation", row)));
}

TEST_CASE("list and show tell what is in the file") {
  const std::vector<FamilySummary> all = summarise(shipped());
  REQUIRE(all.size() == family_count);
  const FamilySummary& motors = all[static_cast<std::size_t>(Family::steppers)];
  CHECK(motors.rows == 174);
  CHECK(motors.manufacturers == 23);
  REQUIRE(motors.prices.size() == 2);
  CHECK(motors.prices[0].lowest == Approx(7));
  CHECK(motors.prices[0].highest == Approx(414));
  CHECK(motors.prices[0].rows + motors.prices[1].rows == 174);
  CHECK(motors.estimated_price_share > 0.9);
  CHECK(list_parts(shipped().table(Family::belts)).size() == 35);
  const FoundParts found = shipped().find("QSH5718-76-28-189");
  REQUIRE_FALSE(found.parts.empty());
  const Table& table = shipped().table(found.parts.front().family);
  const PartSheet sheet = show(table, found.parts.front().row);
  CHECK(sheet.manufacturer == "Trinamic");
  bool seen = false;
  for (const Figure& each : sheet.figures) {
    CHECK_FALSE(each.value.empty());
    if (each.column != "rotor_inertia") continue;
    seen = true;
    CHECK(each.value == "480");
    CHECK(each.unit == "g.cm2");
    CHECK(each.basis == "datasheet");
    CHECK_FALSE(each.estimate);
    CHECK(each.place.starts_with(sheet.place.substr(0, sheet.place.rfind(':'))));
  }
  CHECK(seen);
}

}  // namespace shipped_test
