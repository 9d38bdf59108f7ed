// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "catch.h"
#include "machine/claims.h"
#include "machine/claims_expression.h"
#include "machine/claims_value.h"
#include "text/document.h"

namespace claims_file_test {

using namespace millwright;
using machine::ClaimExpression;
using machine::ClaimsFile;

namespace {
struct Outcome {
  std::optional<ClaimsFile> file;
  text::Diagnostics diagnostics;
};

Outcome read(const std::string& contents) {
  Outcome outcome;
  const auto source = text::SourceText::from_string("claims.toml", contents);
  if (const auto document = text::read_toml(source, outcome.diagnostics)) {
    outcome.file = machine::read_claims(*document, outcome.diagnostics);
  }
  return outcome;
}

const std::string head = "title = 'A screw'\n[inputs.x]\nload = '100 N'\ndiameter = '10 mm'\nmu = 0.1\n";

/// A file with one claim, whose lines after id (line 8) are `lines`.
Outcome claim(const std::string& lines) { return read(head + "[[claim]]\naxis = 'x'\nid = 'X01'\n" + lines + "\n"); }

/// Exactly one error, there, with these words in message or hint.
void check_error(const Outcome& outcome, int line, int column, const std::string& words) {
  INFO(text::format(outcome.diagnostics));
  CHECK_FALSE(outcome.file.has_value());
  REQUIRE(outcome.diagnostics.count() == 1);
  const text::Diagnostic only = outcome.diagnostics.all().front();
  CHECK(only.where.line == line);
  CHECK(only.where.column == column);
  CHECK((only.message + " " + only.hint).find(words) != std::string::npos);
}

const std::string stress = "quantity = 'stress'\nprinted = '1.27 MPa'\nformula = 'power_screw.axial_stress'\n";

double evaluate(const std::string& expression, const std::vector<double>& values = {}) {
  machine::ExpressionError error;
  const auto parsed = ClaimExpression::parse(expression, error);
  INFO(expression << ": " << error.message);
  REQUIRE(parsed);
  REQUIRE(parsed->names().size() == values.size());
  return parsed->evaluate<double>(values);
}

std::pair<std::size_t, std::string> failure(const std::string& expression) {
  machine::ExpressionError error;
  const auto parsed = ClaimExpression::parse(expression, error);
  INFO(expression);
  CHECK_FALSE(parsed);
  return {error.offset, error.message};
}
}  // namespace

TEST_CASE("a claim is read with its operands") {
  const Outcome outcome =
      read(head +
           "[[derived]]\naxis = 'x'\nid = 'core'\nexpression = 'diameter - 2 * depth'\ninputs = { depth = '1 mm' }\n"
           "[[claim]]\naxis = 'x'\nid = 'X01'\nquantity = 'stress'\nprinted = '1.99 N/mm^2'\n"
           "formula = 'power_screw.axial_stress'\n"
           "inputs = { force = { input = 'load' }, core_diameter = { from = 'core' } }\n"
           "line = { core_diameter = '10 mm' }\n"
           "[[claim]]\naxis = 'y'\nid = 'Y01'\nquantity = 'torque'\nprinted = '0.5 N*m'\n"
           "formula = 'arithmetic.value'\ninputs = { value = { printed = 'Y01' } }\n");
  INFO(text::format(outcome.diagnostics));
  REQUIRE(outcome.file);
  machine::ClaimValues values(*outcome.file);
  const machine::Claim& first = outcome.file->claims.at(0);
  // 4 * 100 N / (pi * (8 mm)^2), and the same on 10 mm.
  CHECK(values.row("X01", {}).value == Approx(400 / (M_PI * 64e-6)));
  CHECK(values.value(*first.line, "x").value == Approx(400 / (M_PI * 100e-6)));
  CHECK(values.row("Y01", {}).value == 0.5);
  CHECK(first.printed.half_digit == Approx(0.005));
}

TEST_CASE("a printed number says how exact it is") {
  std::string reason;
  const auto check = [&](const std::string& text, double number, double half_digit, int digits) {
    INFO(text);
    const auto value = machine::parse_printed(text, reason);
    REQUIRE(value);
    CHECK(value->number == Approx(number));
    CHECK(value->half_digit == Approx(half_digit));
    CHECK(value->significant_digits == digits);
  };
  check("0.0700 mm", 0.07, 0.00005, 3);
  check("150 r/min", 150, 0.5, 3);
  check("36.25e-6 kg*m^2", 36.25e-6, 0.5e-8, 4);
  check("9.74E+5", 9.74e5, 500, 3);
  check("-0.02 N*m", -0.02, 0.005, 1);
  check("0 N", 0, 0.5, 0);
  check("10.0", 10, 0.05, 3);
  for (const char* bad : {"", "N", "1,5 N", "1.5 zz", "1.5 N 2", "1O5 N", "nan N", "1e400 N", "1e-400", "0x10 N"}) {
    INFO(bad);
    reason.clear();
    CHECK_FALSE(machine::parse_printed(bad, reason));
    CHECK_FALSE(reason.empty());
  }
}

TEST_CASE("mistakes in one block are reported at their place") {
  const std::string good = stress + "inputs = { force = '100 N', core_diameter = '10 mm' }";
  CHECK(claim(good).file);
  check_error(claim("quantity = 'q'\nprinted = '1 N'\nformula = 'power_screw.axial_stres'"), 11, 11, "axial_stress");
  check_error(claim(stress + "inputs = { force = '1 N', core_diametr = '1 mm' }"), 12, 27, "core_diameter");
  check_error(claim(stress + "inputs = { force = '100 N' }"), 11, 11, "core_diameter");
  check_error(claim(stress + "inputs = { force = '100 N', core_diameter = '10 kg' }"), 12, 45, "core_diameter");
  check_error(claim(stress + "inputs = { force = '100 N', core_diameter = 10 }"), 12, 45, "core_diameter");
  check_error(claim(stress + "inputs = { force = '100 N', core_diameter = '1O mm' }"), 12, 45, "1O");
  check_error(claim(stress + "inputs = { force = ['100 N'], core_diameter = '1 mm' }"), 12, 20, "not a list");
  check_error(claim(stress + "inputs = { force = true, core_diameter = '1 mm' }"), 12, 20, "quantity");
  check_error(claim(good + "\nnote = 'x'"), 13, 1, "unknown key");
  check_error(claim(good + "\nlines = {}"), 13, 1, "'line'");
  check_error(claim(good + "\nread_as = 'kPa'"), 13, 11, "another dimension");
  check_error(claim(good + "\nread_as = 'zz^2'"), 13, 11, "not a unit");
  check_error(claim(good + "\nline = { force = '1 N', lead = '2 mm' }"), 13, 25, "no argument");
  check_error(claim(good + "\nexpression = '1'"), 13, 1, "not both");
  check_error(claim("quantity = 'q'\nprinted = '1 N'"), 6, 1, "what is missing");
  check_error(claim("quantity = 'q'\nprinted = '1,5 N'\nmissing = 'm'"), 10, 11, "printed value");
  check_error(claim("quantity = 'q'\nprinted = 5\nmissing = 'm'"), 10, 11, "text is wanted");
  check_error(claim("printed = '5 N'\nmissing = 'm'"), 6, 1, "quantity");
}

TEST_CASE("lists and choices must be what the formula wants") {
  const std::string rms = "quantity = 'q'\nprinted = '1 N*m'\nformula = 'stepper.rms_torque'\n";
  CHECK(claim(rms + "inputs = { torques = ['1 N*m', '2 N*m'], durations = ['1 s', '3 s'] }").file);
  check_error(claim(rms + "inputs = { torques = ['1 N*m', '2 N*m'], durations = ['1 s'] }"), 12, 54, "as many");
  check_error(claim(rms + "inputs = { torques = '1 N*m', durations = ['1 s'] }"), 12, 22, "a list");
  check_error(claim(rms + "inputs = { torques = [], durations = ['1 s'] }"), 12, 22, "a list");
  check_error(claim(rms + "inputs = { torques = ['1 N*m', '2 N'], durations = ['1 s', '3 s'] }"), 12, 32, "torques");
  const std::string core = "quantity = 'q'\nprinted = '1 mm'\nformula = 'power_screw.core_diameter'\n";
  check_error(claim(core + "inputs = { form = 'sqare', major_diameter = '9 mm', pitch = '2 mm' }"), 12, 19, "'square'");
}

TEST_CASE("names must exist, and no row may be computed from itself") {
  const std::string value = "quantity = 'q'\nprinted = '1 N'\nformula = 'arithmetic.value'\n";
  check_error(claim(value + "inputs = { value = { input = 'lod' } }"), 12, 20, "'load'");
  check_error(claim(value + "inputs = { value = { input = 'load', axis = 'y' } }"), 12, 20, "axis y");
  check_error(claim(value + "inputs = { value = { from = 'X1' } }"), 12, 20, "'X01'");
  check_error(claim(value + "inputs = { value = { printed = 'X02' } }"), 12, 20, "'X01'");
  check_error(claim(value + "inputs = { value = { from = 'X02', input = 'load' } }"), 12, 20, "one of");
  check_error(claim(value + "inputs = { value = { form = 'X02' } }"), 12, 22, "'from'");
  check_error(claim(value + "inputs = { value = { from = 'X01' } }"), 8, 6, "itself");
  check_error(claim("quantity = 'q'\nprinted = '1 N'\nexpression = 'X01 + load'"), 8, 6, "itself");
  check_error(claim("quantity = 'q'\nprinted = '1 N'\nexpression = 'load * lod'"), 11, 14, "'load'");
  check_error(claim("quantity = 'q'\nprinted = '1 N'\nexpression = 'load * b'\ninputs = { a = 1 }"), 12, 12, "'a'");
  check_error(read(head + "[[claim]]\naxis = 'x'\nid = 'A'\nquantity = 'q'\nprinted = '1 N'\nmissing = 'm'\n"
                          "[[claim]]\naxis = 'x'\nid = 'A'\nquantity = 'q'\nprinted = '1 N'\nmissing = 'm'\n"),
              14,
              6,
              "twice");
  check_error(read(head + "[[claim]]\naxis = 'x'\nid = 'A'\nquantity = 'q'\nprinted = '1 N'\nmissing = 'm'\n"
                          "[[claim]]\naxis = 'x'\nid = 'B'\nquantity = 'q'\nprinted = '1 N'\nexpression = 'A'\n"),
              17,
              14,
              "printed");
}

TEST_CASE("dimensions must fit") {
  check_error(claim("quantity = 'q'\nprinted = '1 N'\nexpression = 'load + diameter'"), 11, 14, "sum");
  check_error(claim("quantity = 'q'\nprinted = '1 N*m'\nexpression = 'load'"), 11, 14, "read_as");
  check_error(claim("quantity = 'q'\nprinted = '1 N'\nexpression = 'diameter^mu'"), 11, 14, "power");
  check_error(
      claim("quantity = 'q'\nprinted = '1 N'\nexpression = 'load'\nline = { expression = 'mu' }"), 12, 23, "read_as");
  CHECK(claim("quantity = 'q'\nprinted = '1 m'\nread_as = 'N'\nexpression = 'load'").file);
}

TEST_CASE("revolutions and radians per second are no cycles per second, though their dimension is one") {
  const std::string speed =
      "\nformula = 'ball_screw.mean_speed'\ninputs = { angular_speeds = ['2000 rpm'], durations = ['1 s'] }";
  check_error(claim("quantity = 'q'\nprinted = '209.44 Hz'" + speed), 11, 11, "does not fit");
  CHECK(claim("quantity = 'q'\nprinted = '209.44 rad/s'" + speed).file);
  CHECK(claim("quantity = 'q'\nprinted = '2000 rpm'" + speed).file);
  const std::string turn = "\nformula = 'power_screw.lead_angle'\ninputs = { lead = '4 mm', mean_diameter = '14 mm' }";
  CHECK(claim("quantity = 'q'\nprinted = '0.0907'" + turn).file);  // of an angle a bare number is in radians
  CHECK(claim("quantity = 'q'\nprinted = '209.44 Hz'\nread_as = 'rad/s'" + speed).file);
}

TEST_CASE("a file that is no claims file says so") {
  check_error(read("title = 'x'\n"), 0, 0, "[[claim]]");
  check_error(read("title = 'x'\nclaim = 5\n"), 2, 9, "[[claim]]");
  check_error(read("title = 'x'\nclaim = [5]\n"), 2, 10, "[[claim]]");
  const std::string claims = "[[claim]]\naxis = 'x'\nid = 'A'\nquantity = 'q'\nprinted = '1 N'\nmissing = 'm'\n";
  CHECK(read("title = 'x'\n" + claims).file);
  check_error(read(claims), 1, 1, "title");
  check_error(read("title = 'x'\ninputs = 3\n" + claims), 2, 10, "table");
  check_error(read("title = 'x'\n[inputs]\nload = '3 N'\n" + claims), 3, 8, "by axis");
  check_error(read("title = 'x'\n[inputs.x]\nload = '3 Nn'\n" + claims), 3, 8, "3 Nn");
  check_error(read("title = 'x'\n[input.x]\nload = '3 N'\n" + claims), 2, 2, "'inputs'");
  text::Diagnostics diagnostics;
  CHECK_FALSE(machine::read_claims("/no/such/claims.toml", diagnostics));
  CHECK(diagnostics.error_count() == 1);
}

TEST_CASE("every mistake of a file is reported, not the first only") {
  const Outcome outcome = read(
      "title = 'x'\n[[claim]]\naxis = 'x'\nid = 'A'\nquantity = 'q'\nprinted = '1 zz'\nformula = 'no.such'\n"
      "[[claim]]\naxis = 'x'\nquantity = 'q'\nprinted = '1 N'\nmissing = 'm'\nfoo = 1\n");
  INFO(text::format(outcome.diagnostics));
  CHECK(outcome.diagnostics.error_count() == 4);
}

TEST_CASE("a long chain of rows is refused, not fatal") {
  std::string contents = "title = 'x'\n[inputs.x]\nstart = 1\n";
  for (int i = 0; i < 3000; ++i) {
    contents += "[[derived]]\naxis = 'x'\nid = 'r" + std::to_string(i) + "'\nexpression = '" +
                (i == 2999 ? std::string("start") : "r" + std::to_string(i + 1)) + "'\n";
  }
  contents += "[[claim]]\naxis = 'x'\nid = 'A'\nquantity = 'q'\nprinted = '1'\nexpression = 'r0'\n";
  const Outcome outcome = read(contents);
  CHECK_FALSE(outcome.file);
  CHECK(outcome.diagnostics.error_count() > 0);
}

TEST_CASE("expressions follow the usual precedence") {
  CHECK(evaluate("1 + 2 * 3") == 7);
  CHECK(evaluate("(1 + 2) * 3") == 9);
  CHECK(evaluate("8 / 4 / 2") == 1);
  CHECK(evaluate("8 - 4 - 2") == 2);
  CHECK(evaluate("2^3^2") == 512);
  CHECK(evaluate("-2^2") == -4);
  CHECK(evaluate("2^-1") == 0.5);
  CHECK(evaluate("2 * -3") == -6);
  CHECK(evaluate("sqrt(16) + cbrt(27) + 1.5e1") == Approx(22));
  CHECK(evaluate("pi") == Approx(M_PI));
  CHECK(evaluate("a * b + a", {3, 4}) == 15);
  CHECK(evaluate("  .5*4 ") == 2);
}

TEST_CASE("what is no expression is refused at its place") {
  CHECK(failure("").first == 0);
  CHECK(failure("1 +").first == 3);
  CHECK(failure("1 + * 2").first == 4);
  CHECK(failure("(1 + 2").first == 6);
  CHECK(failure("1 2").first == 2);
  CHECK(failure("a b").first == 2);
  CHECK(failure("sin(1)").second.find("sin") != std::string::npos);
  CHECK(failure("1 & 2").first == 2);
  CHECK(failure(".").first == 0);
  CHECK(failure(std::string(100000, '(')).second.find("brackets") != std::string::npos);
  CHECK(failure(std::string(100000, '-')).second.find("signs") != std::string::npos);
  std::string sum = "1";
  for (int i = 0; i < 900; ++i) sum += "+1";
  CHECK(evaluate(sum) == 901);
  for (int i = 0; i < 200000; ++i) sum += "+1";
  CHECK(failure(sum).second == "the expression is too long");
}

}  // namespace claims_file_test
