// SPDX-License-Identifier: Apache-2.0
//
// The grammar of unit expressions (unit.h).
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <vector>

#include "scalar/unit_definition.h"

namespace millwright::scalar {
namespace {

/// The ASCII spelling of the characters that units are written with. A superscript becomes "^" and its digits.
struct Spelling {
  std::string_view bytes;
  std::string_view plain;
};
constexpr Spelling spellings[] = {
    {"°C", "degC"},  {"℃", "degC"},     {"°F", "degF"},   {"°", "deg"},      {"µ", "u"},   {"μ", "u"},
    {"Ω", "ohm"},    {"\u2126", "ohm"}, {"·", "*"},       {"⋅", "*"},        {"∙", "*"},   {"•", "*"},
    {"×", "*"},      {"−", "-"},        {"%", "percent"}, {"‰", "permille"}, {"€", "EUR"}, {"£", "GBP"},
    {"\u00a0", " "}, {"\u2009", " "},   {"\u202f", " "}};
constexpr Spelling superscripts[] = {{"⁰", "0"},
                                     {"¹", "1"},
                                     {"²", "2"},
                                     {"³", "3"},
                                     {"⁴", "4"},
                                     {"⁵", "5"},
                                     {"⁶", "6"},
                                     {"⁷", "7"},
                                     {"⁸", "8"},
                                     {"⁹", "9"},
                                     {"⁻", "-"}};

std::string in_ascii(std::string_view text) {
  std::string plain;
  bool raised = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    std::string_view replacement = rest.substr(0, 1);
    std::size_t length = 1;
    bool raises = false;
    for (const Spelling& s : spellings) {
      if (!rest.starts_with(s.bytes)) continue;
      replacement = s.plain;
      length = s.bytes.size();
      break;
    }
    for (const Spelling& s : superscripts) {
      if (!rest.starts_with(s.bytes)) continue;
      replacement = s.plain;
      length = s.bytes.size();
      raises = true;
    }
    if (raises && !raised) plain += '^';
    raised = raises;
    plain += replacement;
    i += length;
  }
  return plain;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

struct Factor {
  std::string name;  ///< empty for a group
  UnitDefinition unit;
  double exponent = 1.0;
};

class Parser {
 public:
  Parser(std::string_view text, std::string& reason) : text_(text), reason_(reason) {}

  std::optional<UnitDefinition> whole() {
    auto unit = product(0);
    if (unit && position_ != text_.size()) return fail(fmt::format("unexpected '{}' in the unit", text_[position_]));
    return unit;
  }

 private:
  std::optional<UnitDefinition> fail(std::string why) {
    if (reason_.empty()) reason_ = std::move(why);
    return std::nullopt;
  }
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
  }
  bool skip_blanks() {
    const std::size_t start = position_;
    while (peek() == ' ') ++position_;
    return position_ > start;
  }

  enum class Join { none, multiply, divide, bad };
  Join join() {
    const bool blank = skip_blanks();
    const char c = peek();
    if (c == '\0' || c == ')') return Join::none;
    if (c == '/' || c == '*' || c == '.' || (c == '-' && is_letter(peek(1)))) {
      ++position_;
      if (c == '*' && peek() == '*') return Join::bad;
      skip_blanks();
      return c == '/' ? Join::divide : Join::multiply;
    }
    return blank && (is_letter(c) || c == '(') ? Join::multiply : Join::bad;
  }

  std::optional<UnitDefinition> product(int depth) {
    if (depth > 8) return fail("too many parentheses in the unit");
    std::vector<Factor> factors;
    bool divided = false;
    for (Join how = Join::multiply; how != Join::none; how = join()) {
      if (how == Join::bad) return fail(fmt::format("unexpected '{}' in the unit", peek() == '\0' ? '*' : peek()));
      if (how == Join::multiply && divided) {
        return fail("what stands below the line is ambiguous: write it in parentheses, W/(m·K)");
      }
      divided = divided || how == Join::divide;
      Factor factor;
      if (!read_factor(factor, depth)) return std::nullopt;
      if (how == Join::divide) factor.exponent = -factor.exponent;
      factors.push_back(std::move(factor));
      if (factors.size() > 16) return fail("too many factors in the unit");
    }
    return multiplied(factors);
  }

  bool read_factor(Factor& factor, int depth) {
    if (peek() == '(') {
      ++position_;
      skip_blanks();
      auto inner = product(depth + 1);
      if (!inner) return false;
      if (peek() != ')') return fail("a closing parenthesis is missing in the unit").has_value();
      ++position_;
      factor.unit = *inner;
    } else if (peek() == '1' && !is_digit(peek(1)) && peek(1) != '.') {
      ++position_;
      return true;
    } else if (is_letter(peek())) {
      while (is_letter(peek())) factor.name += text_[position_++];
      auto unit = named_unit(factor.name, reason_);
      if (!unit) return false;
      factor.unit = *unit;
    } else if (is_digit(peek())) {
      return fail("a unit has no number in it except as an exponent").has_value();
    } else {
      return fail(peek() == '\0'  ? "the unit ends too early"
                  : peek() == '$' ? "'$' is not unique: write USD, CAD, ..."
                                  : "unexpected character in the unit")
          .has_value();
    }
    return read_exponent(factor.exponent);
  }

  bool read_exponent(double& exponent) {
    const bool caret = peek() == '^';
    if (!caret && !is_digit(peek()) && !(peek() == '-' && is_digit(peek(1)))) return true;
    if (caret) ++position_;
    const std::size_t start = position_;
    if (peek() == '-') ++position_;
    while (is_digit(peek())) ++position_;
    if (caret && peek() == '.' && is_digit(peek(1))) {
      ++position_;
      while (is_digit(peek())) ++position_;
    }
    const char* const end = text_.data() + position_;
    const auto [read_to, error] = std::from_chars(text_.data() + start, end, exponent);
    if (error == std::errc() && read_to == end && exponent != 0.0 && std::fabs(exponent) <= 12.0) return true;
    return fail("a unit needs an exponent between -12 and 12 that is not 0").has_value();
  }

  /// In a product with an inch to the first power an ounce is a force: `oz.in` is a torque, `oz.in²` an inertia.
  static bool is_force_ounce(const Factor& factor, const std::vector<Factor>& factors) {
    if (factor.name != "oz" || factor.exponent != 1.0) return false;
    for (const Factor& other : factors) {
      if (other.name == "in" && other.exponent == 1.0) return true;
    }
    return false;
  }

  std::optional<UnitDefinition> multiplied(const std::vector<Factor>& factors) {
    if (factors.size() == 1 && factors.front().exponent == 1.0) return factors.front().unit;
    UnitDefinition result;
    for (const Factor& factor : factors) {
      if (is_force_ounce(factor, factors)) {
        const auto ounce = named_unit("ozf", reason_);
        result = combined(result, *ounce, 1.0);
      } else {
        if (!result.currency.empty() && !factor.unit.currency.empty()) return fail("two currencies in one unit");
        result = combined(result, factor.unit, factor.exponent);
      }
    }
    return result;
  }

  std::string_view text_;
  std::string& reason_;
  std::size_t position_ = 0;
};

/// x^exponent, by multiplication for whole exponents so that powers of ten stay exact.
double exact_power(double x, double exponent) {
  if (exponent != std::floor(exponent)) return std::pow(x, exponent);
  double result = 1.0;
  for (int i = 0; i < static_cast<int>(exponent); ++i) result *= x;
  return result;
}

}  // namespace

UnitDefinition combined(const UnitDefinition& a, const UnitDefinition& b, double exponent) {
  UnitDefinition result = a;
  const double size = std::fabs(exponent);
  result.dimension = a.dimension * power(b.dimension, exponent);
  result.numerator = a.numerator * exact_power(exponent > 0.0 ? b.numerator : b.denominator, size);
  result.denominator = a.denominator * exact_power(exponent > 0.0 ? b.denominator : b.numerator, size);
  result.offset = 0.0;
  result.angle = a.angle + b.angle * exponent;
  result.step = a.step + b.step * exponent;
  if (!b.currency.empty()) result.currency = b.currency;
  result.currency_exponent = a.currency_exponent + b.currency_exponent * exponent;
  return result;
}

std::optional<UnitDefinition> unit_expression(std::string_view text, std::string& reason) {
  reason.clear();
  if (text.empty() || text == "1") return UnitDefinition{};
  if (text.size() > 100) {
    reason = "too long for a unit";
    return std::nullopt;
  }
  const std::string plain = in_ascii(text);
  return Parser(plain, reason).whole();
}

}  // namespace millwright::scalar
