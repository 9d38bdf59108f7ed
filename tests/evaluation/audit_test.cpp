// SPDX-License-Identifier: Apache-2.0
#include "evaluation/audit.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "catch.h"
#include "mechanics/formula.h"

namespace audit_test {

using namespace millwright;
using evaluation::AuditReport;
using evaluation::AuditRow;
using evaluation::AuditVerdict;

namespace {
const std::vector<std::string> papers = {"mini-mill", "sander", "torch-table", "fdm-printer"};

machine::ClaimsFile claims_of(const std::string& paper) {
  text::Diagnostics diagnostics;
  auto file =
      machine::read_claims(std::string(MILLWRIGHT_SOURCE_DIR) + "/problems/papers/" + paper + ".toml", diagnostics);
  INFO(text::format(diagnostics));
  REQUIRE(file.has_value());
  REQUIRE(diagnostics.count() == 0);
  return *file;
}

const AuditReport& report_of(const std::string& paper) {
  static std::map<std::string, AuditReport> reports;
  auto known = reports.find(paper);
  if (known == reports.end()) known = reports.emplace(paper, evaluation::audit(claims_of(paper), true)).first;
  return known->second;
}

const AuditRow& row_of(const std::string& paper, const std::string& id) {
  const auto& rows = report_of(paper).rows;
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const AuditRow& row) { return row.id == id; });
  REQUIRE(found != rows.end());
  return *found;
}

struct Reference {
  std::string paper, axis, id;
  double value = 0.0;
};

std::vector<Reference> references() {
  std::ifstream file(std::string(MILLWRIGHT_SOURCE_DIR) + "/tests/evaluation/paper_reference.csv");
  std::vector<Reference> result;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#' || line.rfind("machine,", 0) == 0) continue;
    std::istringstream cells(line);
    Reference reference;
    std::string value;
    std::getline(cells, reference.paper, ',');
    std::getline(cells, reference.axis, ',');
    std::getline(cells, reference.id, ',');
    std::getline(cells, value);
    reference.value = std::stod(value);
    result.push_back(reference);
  }
  return result;
}

/// A claim without a calculation: judge() looks at the printed number and the units only.
machine::Claim claim(const std::string& printed, const std::string& read_as = "") {
  std::string reason;
  const auto value = machine::parse_printed(printed, reason);
  INFO(printed << ": " << reason);
  REQUIRE(value.has_value());
  machine::Claim result;
  result.id = "X01";
  result.printed = *value;
  if (!read_as.empty()) result.read_as = scalar::Unit::of(read_as);
  return result;
}

/// Verdict on `printed` where the right value is `computed` and the line, as printed, gives `line` (both in SI).
AuditVerdict verdict(const std::string& printed, double computed, double line) {
  return evaluation::judge(claim(printed), computed, line).verdict;
}
AuditVerdict verdict(const std::string& printed, double computed) { return verdict(printed, computed, computed); }

/// The factor found between `printed` and a line worth `line` (SI); 0 where none is.
double factor(const std::string& printed, double line) {
  const machine::Claim c = claim(printed);
  const auto found = evaluation::named_factor(c.printed, c.printed.unit, line);
  return found ? found->factor : 0.0;
}
std::string factor_name(const std::string& printed, double line) {
  const machine::Claim c = claim(printed);
  const auto found = evaluation::named_factor(c.printed, c.printed.unit, line);
  return found ? found->name : "";
}
constexpr double pi = std::numbers::pi;
constexpr double gravity = 9.80665;
}  // namespace

TEST_CASE("every result of the four papers that can be computed is computed correctly") {
  const auto all = references();
  REQUIRE(all.size() == 250);
  int compared = 0;
  for (const Reference& reference : all) {
    const AuditRow& row = row_of(reference.paper, reference.id);
    INFO(reference.paper << " " << reference.axis << " " << reference.id << " " << row.formula);
    CHECK(row.axis == reference.axis);
    REQUIRE(row.computed.has_value());
    const double si = scalar::Unit::of(row.unit).to_si(*row.computed);
    CHECK(std::fabs(si - reference.value) <= 1e-6 * std::fabs(reference.value));
    CHECK(row.verdict != AuditVerdict::missing_input);
    ++compared;
  }
  CHECK(compared == 250);
}

TEST_CASE("all 269 printed results are there, and what cannot be computed says what is missing") {
  const std::map<std::string, std::size_t> sizes = {
      {"mini-mill", 63}, {"sander", 117}, {"torch-table", 61}, {"fdm-printer", 28}};
  int missing = 0;
  for (const std::string& paper : papers) {
    const AuditReport& report = report_of(paper);
    CHECK(report.rows.size() == sizes.at(paper));
    for (const AuditRow& row : report.rows) {
      INFO(paper << " " << row.id);
      CHECK((row.verdict == AuditVerdict::missing_input) == !row.missing.empty());
      CHECK((row.verdict == AuditVerdict::unit) == row.factor.has_value());
      CHECK((row.verdict == AuditVerdict::unit) == !row.factor_name.empty());
      CHECK(row.violations.empty());
      CHECK(row.where.line > 0);
      missing += row.verdict == AuditVerdict::missing_input ? 1 : 0;
    }
  }
  CHECK(missing == 269 - 250);
}

TEST_CASE("each paper is in the bibliography") {
  std::ifstream file(std::string(MILLWRIGHT_SOURCE_DIR) + "/src/mechanics/sources.bib");
  std::stringstream bibliography;
  bibliography << file.rdbuf();
  for (const std::string& paper : papers) {
    INFO(paper);
    CHECK(bibliography.str().find("{" + report_of(paper).source + ",") != std::string::npos);
  }
}

TEST_CASE("the known errors of the papers are found for what they are") {
  SECTION("watts printed as kilowatts, and the share of it that is a unit") {
    const AuditRow& power = row_of("mini-mill", "X18");
    CHECK(power.verdict == AuditVerdict::unit);
    CHECK(*power.factor == Approx(1000));
    CHECK(power.factor_name == "1000: printed kW, is W");
    CHECK(power.printed_text == "0.57 kW");
    CHECK(*power.line_value == Approx(0.03643 * 2 * pi * 150 / 60 / 1000));
    CHECK(*power.ratio == Approx(570 / 5.520482499));
  }
  SECTION("kgf*mm printed as N*m") {
    for (const char* id : {"X20", "Y20", "Z20"}) {
      const AuditRow& moment = row_of("mini-mill", id);
      CHECK(moment.verdict == AuditVerdict::unit);
      CHECK(*moment.factor == Approx(1000 / gravity));
    }
  }
  SECTION("a slip by ten in r/min is a slip") { CHECK(row_of("mini-mill", "X17").verdict == AuditVerdict::differs); }
  SECTION("a volume per time printed as an area per time") {
    CHECK(row_of("sander", "S03").verdict == AuditVerdict::unit);
    CHECK(*row_of("sander", "S03").factor == 1.0);
    CHECK(row_of("sander", "S04").verdict == AuditVerdict::differs);
  }
  SECTION("mm^4 divided once by 1000") {
    CHECK(row_of("sander", "T09").verdict == AuditVerdict::unit);
    CHECK(*row_of("sander", "T09").factor == Approx(1e9));
  }
  SECTION("two digits swapped are no rounding, although they are within five per cent") {
    CHECK(row_of("torch-table", "X08").verdict == AuditVerdict::differs);
    CHECK(row_of("torch-table", "S04").verdict == AuditVerdict::differs);
  }
  SECTION("pi = 3.14 is rounding") { CHECK(row_of("sander", "S01").verdict == AuditVerdict::rounding); }
  SECTION("the impossible negative buckling load is not judged, but an indicative value is shown") {
    CHECK(row_of("fdm-printer", "Y04").verdict == AuditVerdict::missing_input);
    CHECK(*row_of("fdm-printer", "Y04").computed == Approx(12557.54206));
    CHECK(*row_of("fdm-printer", "Z04").computed == Approx(13913.91744));
    CHECK_FALSE(row_of("fdm-printer", "X08").computed.has_value());
  }
}

TEST_CASE("a derivation ends in the computed value") {
  for (const std::string& paper : papers) {
    for (const AuditRow& row : report_of(paper).rows) {
      if (!row.computed) continue;
      INFO(paper << " " << row.id);
      REQUIRE_FALSE(row.derivation.empty());
      CHECK(row.derivation.back().value == Approx(scalar::Unit::of(row.unit).to_si(*row.computed)).epsilon(1e-14));
      CHECK_FALSE(row.derivation.back().substituted.empty());
    }
  }
  CHECK(evaluation::audit(claims_of("fdm-printer"), false).rows[3].derivation.empty());
}

TEST_CASE("agrees means to half a unit of the last printed digit") {
  CHECK(verdict("0.0700 N", 0.07004) == AuditVerdict::agrees);
  CHECK(verdict("0.0700 N", 0.07006) == AuditVerdict::rounding);
  CHECK(verdict("0.07 N", 0.0749) == AuditVerdict::agrees);
  CHECK(verdict("0.07 N", 0.0751) == AuditVerdict::differs);
  SECTION("exactly half way agrees with both neighbours") {
    CHECK(verdict("0.1 N", 0.15) == AuditVerdict::agrees);
    CHECK(verdict("0.2 N", 0.15) == AuditVerdict::agrees);
    CHECK(verdict("2.5 mm", 0.00255) == AuditVerdict::agrees);
  }
  SECTION("zeros before the point are digits") {
    CHECK(verdict("150 N", 150.4) == AuditVerdict::agrees);
    CHECK(verdict("150 N", 150.6) == AuditVerdict::rounding);
    CHECK(verdict("12600 N", 12601.0) == AuditVerdict::rounding);
  }
  SECTION("an exponent moves the last digit") {
    CHECK(verdict("36.25e-6 kg*m^2", 36.254e-6) == AuditVerdict::agrees);
    CHECK(verdict("36.25e-6 kg*m^2", 36.256e-6) == AuditVerdict::rounding);
    CHECK(verdict("72.85e6 N/m^2", 72.854e6) == AuditVerdict::agrees);
    CHECK(verdict("4e3 N", 4499.0) == AuditVerdict::agrees);
  }
  SECTION("negative numbers and zero") {
    CHECK(verdict("-0.02 N*m", -0.0249) == AuditVerdict::agrees);
    CHECK(verdict("-0.02 N*m", 0.02) == AuditVerdict::differs);
    CHECK(verdict("0.00 N", 0.004) == AuditVerdict::agrees);
    CHECK(verdict("0 N", 0.6) == AuditVerdict::differs);
  }
}

TEST_CASE("rounding means within one per cent of the computed value") {
  CHECK(verdict("99.01 N", 100.0) == AuditVerdict::rounding);
  CHECK(verdict("98.99 N", 100.0) == AuditVerdict::differs);
  CHECK(verdict("101.00 N", 100.0) == AuditVerdict::rounding);
  CHECK(verdict("101.01 N", 100.0) == AuditVerdict::differs);
  CHECK(verdict("-99.5 N", -100.0) == AuditVerdict::rounding);
}

TEST_CASE("unit is judged against the line, and after agrees and rounding") {
  CHECK(verdict("0.57 kW", 5.52, 0.5722) == AuditVerdict::unit);
  CHECK(verdict("0.57 kW", 5.52) == AuditVerdict::differs);
  // Right within 1 %, although 1000 times a line that is itself wrong.
  CHECK(verdict("570 W", 571.0, 0.57) == AuditVerdict::rounding);
  // Within 1 % of a factor, but not to the printed digits: a slip.
  CHECK(verdict("0.5700 kW", 0.5722) == AuditVerdict::differs);
  CHECK(verdict("0.5700 kW", 0.57004) == AuditVerdict::unit);
}

TEST_CASE("nothing is judged where something is missing or not finite") {
  machine::Claim incomplete = claim("5 N");
  CHECK(evaluation::judge(incomplete, std::nullopt, std::nullopt).verdict == AuditVerdict::missing_input);
  incomplete.missing = "the load";
  CHECK(evaluation::judge(incomplete, 5.0, 5.0).verdict == AuditVerdict::missing_input);
  CHECK(verdict("5.0 N", std::nan("")) == AuditVerdict::differs);
  CHECK(verdict("5.0 N", INFINITY) == AuditVerdict::differs);
  CHECK(verdict("5.0 N", 0.0) == AuditVerdict::differs);
}

TEST_CASE("a number read in another dimension is at best a wrong unit") {
  const machine::Claim removal = claim("4 mm^2/s", "mm^3/s");
  CHECK(evaluation::judge(removal, 4e-9, 4e-9).verdict == AuditVerdict::unit);
  CHECK(evaluation::judge(removal, 4e-9, 4e-9).factor->name == "printed mm^2/s, is mm^3/s");
  CHECK(evaluation::judge(removal, 8e-9, 8e-9).verdict == AuditVerdict::differs);
}

TEST_CASE("each named factor is found and named") {
  CHECK(factor("0.57 kW", 0.57) == Approx(1000));
  CHECK(factor_name("0.57 kW", 0.57) == "1000: printed kW, is W");
  CHECK(factor("13500 N", 13.5) == Approx(1000));
  CHECK(factor("57.4 kgf", 57.4) == Approx(gravity));
  CHECK(factor_name("57.4 kgf", 57.4) == "9.80665: printed kgf, is N");
  CHECK(factor("4441.44 N*m", 4441.44 * gravity / 1000) == Approx(1000 / gravity));
  CHECK(factor("12.5 rad/s", 12.5 * 2 * pi) == Approx(1 / (2 * pi)));
  CHECK(factor("12.5 rev/s", 12.5) == Approx(2 * pi));
  CHECK(factor("150 r/min", 150.0) == Approx(2 * pi / 60));
  CHECK(factor("1.31 m/s", 1.31 / 60) == Approx(60));
  CHECK(factor("2.5 h", 2.5 * 60) == Approx(60));
  CHECK(factor("23.0 s", 23.0 * 3600) == Approx(1.0 / 3600));
  CHECK(factor("5.73 deg", 5.73) == Approx(pi / 180));
  CHECK(factor("36.2 kg*m^2", 36.2e-4) == Approx(1e4));
  CHECK(factor("25 m", 0.025) == Approx(1000));
  CHECK(factor("25 mm", 0.25) == Approx(0.1));
  CHECK(factor("62.7 N/mm^2", 62.7) == Approx(1e6));
  CHECK(factor("6.4 N/mm^2", 6.4 * gravity * 1e6) == Approx(1 / gravity));
  CHECK(factor("5267.268 m^4", 5.267268e-6) == Approx(1e9));
  CHECK(factor("97 percent", 97.0) == Approx(0.01));
  SECTION("bare factors, where the usual units do not show them") {
    CHECK(factor("12.0 N*m", 12.0 * 60) == Approx(1.0 / 60));
    CHECK(factor("75.4 N*m", 12.0) == Approx(2 * pi));
    CHECK(factor("118 kg", 118 / gravity) == Approx(gravity));
  }
}

TEST_CASE("what is not a named factor is none") {
  CHECK(factor("150 r/min", 2 * pi * 25) == 0.0);  // 1500 r/min: a lost digit
  CHECK(factor("20 N", 5.0) == 0.0);
  CHECK(factor("20 kg", 20.0) == 0.0);  // the line itself
  CHECK(factor("0.5 kW", 0.5) == 0.0);  // one digit proves nothing
  CHECK(factor("0.570 kW", 0.574) == 0.0);
  CHECK(factor("60 mm", 1e-3) == 0.0);  // no minute in a length
  CHECK(factor("60", 1.0) == 0.0);
  CHECK(factor("1000", 1.0) == 0.0);
  CHECK(factor("0 kW", 0.0) == 0.0);
  CHECK(factor("20 N", INFINITY) == 0.0);
}

}  // namespace audit_test
