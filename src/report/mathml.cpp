// SPDX-License-Identifier: Apache-2.0
#include "report/mathml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/html.h"

namespace millwright::report {

namespace {

using Kind = scalar::Expression::Kind;

constexpr double widest_line = 58.0;  ///< characters of a substituted expression before it is broken up
constexpr int deepest_fraction = 2;   ///< fractions within a fraction before they are broken up
constexpr int argument_digits = 5;
constexpr int result_digits = 4;

std::string row(const std::string& inner) { return "<mrow>" + inner + "</mrow>"; }
std::string number_element(const std::string& text) { return "<mn>" + escaped(text) + "</mn>"; }
std::string sign(std::string_view text) { return fmt::format("<mo>{}</mo>", text); }

/// Characters, not bytes.
double length_of(std::string_view text) {
  return static_cast<double>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

/// "1.2e-07" as 1.2·10⁻⁷.
std::string number_mathml(std::string text) {
  std::string front;
  if (!text.empty() && text.front() == '-') {
    front = sign("−");
    text.erase(0, 1);
  }
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return front + number_element(text);
  std::string exponent = text.substr(e + 1);
  const bool negative = exponent.front() == '-';
  exponent.erase(0, exponent.find_first_not_of("+-0"));
  const std::string power = negative ? row(sign("−") + number_element(exponent)) : number_element(exponent);
  const std::string ten = "<msup><mn>10</mn>" + power + "</msup>";
  const std::string mantissa = text.substr(0, e);
  return front + (mantissa == "1" ? ten : number_element(mantissa) + sign("·") + ten);
}

std::string plain_symbol(const std::string& text) {
  if (!text.empty() && text.back() == '\'')
    return "<msup>" + plain_symbol(text.substr(0, text.size() - 1)) + "<mo>′</mo></msup>";
  if (const std::size_t blank = text.find(' '); blank != std::string::npos)
    return row("<mi>" + escaped(text.substr(0, blank)) + "</mi><mspace width=\"0.17em\"/>" +
               symbol_mathml(text.substr(blank + 1)));
  return "<mi>" + escaped(text) + "</mi>";
}

std::string literal_text(double value) {
  std::string shortest = fmt::format("{}", value);
  if (shortest.size() <= 8 && shortest.find('e') == std::string::npos) return shortest;
  return scalar::format_number(value, argument_digits);
}

/// The unit of an intermediate result. What is called f counts something per second and is no angular speed, although
/// it has the dimension of one.
scalar::Unit unit_of_line(const std::string& symbol, const scalar::Expression& expression) {
  if (expression.dimension == scalar::dimension::frequency && (symbol == "f" || symbol.starts_with("f_")))
    return scalar::Unit::of("Hz");
  return scalar::readable_unit(expression.dimension, expression.value);
}

}  // namespace

std::string symbol_mathml(const std::string& symbol) {
  if (const std::size_t slash = symbol.find('/'); slash != std::string::npos)
    return row(symbol_mathml(symbol.substr(0, slash)) + sign("/") + symbol_mathml(symbol.substr(slash + 1)));
  const std::size_t bar = symbol.find('_');
  if (bar == std::string::npos || bar == 0) return plain_symbol(symbol);
  if (const std::size_t blank = symbol.find(' '); blank != std::string::npos)
    return row(symbol_mathml(symbol.substr(0, blank)) + "<mspace width=\"0.17em\"/>" +
               symbol_mathml(symbol.substr(blank + 1)));
  const std::string index = symbol.substr(bar + 1);
  return "<msub>" + plain_symbol(symbol.substr(0, bar)) + "<mi mathvariant=\"normal\">" + escaped(index) +
         "</mi></msub>";
}

std::string quantity_mathml(double si, const scalar::Unit& unit, int significant) {
  if (std::isnan(si)) return "<mtext>–</mtext>";
  const std::string shown = shown_unit(unit.name());
  std::string text = number_mathml(scalar::format_number(unit.from_si(si), significant));
  if (!shown.empty())
    text += (shown == "°" ? "" : "<mspace width=\"0.2em\"/>") + ("<mtext>" + escaped(shown) + "</mtext>");
  return text;
}

std::string MathPrinter::wrapped(const Piece& inner, Binding needed) {
  return inner.binding >= needed ? inner.text : row(sign("(") + inner.text + sign(")"));
}

MathPrinter::Piece MathPrinter::function(const std::string& symbol, const std::vector<Piece>& operands) {
  const Piece& x = operands.front();
  if (symbol == "√") return {"<msqrt>" + x.text + "</msqrt>", atom, x.width + 1.5};
  if (symbol == "∛") return {"<mroot>" + row(x.text) + "<mn>3</mn></mroot>", atom, x.width + 1.5};
  if (symbol == "|") return {row(sign("|") + x.text + sign("|")), atom, x.width + 1.0};
  if (symbol == "⌊") return {row(sign("⌊") + x.text + sign("⌋")), atom, x.width + 1.0};
  std::string text = "<mi>" + escaped(symbol) + "</mi>" + sign("(");
  double width = length_of(symbol) + 1.0;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    text += (i > 0 ? "<mo separator=\"true\">,</mo>" : "") + operands[i].text;
    width += operands[i].width + 1.0;
  }
  return {row(text + sign(")")), atom, width};
}

MathPrinter::Piece MathPrinter::composed(const Expression& expression, const std::vector<Piece>& operands) {
  const auto binary = [&](std::string_view mark, Binding own, Binding right) -> Piece {
    return {wrapped(operands[0], own) + sign(mark) + wrapped(operands[1], right),
            own,
            operands[0].width + operands[1].width + 2.5};
  };
  switch (expression.kind) {
    case Kind::add:
      return binary("+", sum, term);
    case Kind::subtract:
      return binary("−", sum, term);
    case Kind::multiply:
      return binary("·", term, term);
    case Kind::divide:
      return {"<mfrac>" + row(operands[0].text) + row(operands[1].text) + "</mfrac>",
              raised,
              std::max(operands[0].width, operands[1].width) + 0.5};
    case Kind::power:
      return {"<msup>" + row(wrapped(operands[0], atom)) + row(operands[1].text) + "</msup>",
              raised,
              operands[0].width + 0.7 * operands[1].width};
    case Kind::negate:
      return {sign("−") + wrapped(operands[0], term), sum, operands[0].width + 1.0};
    default:
      return function(expression.symbol, operands);
  }
}

/// The operand that is left where the other one changes nothing: of x + 0, 0 + x, x - 0, x * 1, 1 * x and x / 1. Such
/// are the loads and factors that a problem does not have.
MathPrinter::Pointer MathPrinter::all_that_counts(const Pointer& pointer) {
  // Formulas share what they are made of: without the memory their parts would be looked at again and again.
  if (const auto known = counting_.find(pointer.get()); known != counting_.end()) return known->second;
  kept_.push_back(pointer);
  return counting_[pointer.get()] = what_counts(pointer);
}

MathPrinter::Pointer MathPrinter::what_counts(const Pointer& pointer) {
  const auto is_literal = [](const Pointer& each, double value) {
    // A watt is no factor of one: what is rounded to whole watts is taken times it.
    const bool has_unit = each->kind == Kind::quantity && !(each->dimension == scalar::dimension::none);
    return (each->kind == Kind::number || each->kind == Kind::quantity) && each->value == value &&
           (value == 0.0 || !has_unit);
  };
  const std::vector<Pointer>& operands = pointer->operands;
  const bool is_sum = pointer->kind == Kind::add;
  const bool is_product = pointer->kind == Kind::multiply;
  const bool is_power = pointer->kind == Kind::power;
  if (is_sum || is_product || pointer->kind == Kind::subtract || pointer->kind == Kind::divide || is_power) {
    const double neutral = is_sum || pointer->kind == Kind::subtract ? 0.0 : 1.0;
    const Pointer left = all_that_counts(operands[0]);
    const Pointer right = all_that_counts(operands[1]);
    if (is_literal(right, neutral)) return left;
    if ((is_sum || is_product) && is_literal(left, neutral)) return right;
    // Nothing times something is nothing.
    if (is_product && is_literal(left, 0.0) && pointer->value == 0.0) return zero_of(pointer);
    if (is_product && is_literal(right, 0.0) && pointer->value == 0.0) return zero_of(pointer);
  }
  return pointer;
}

MathPrinter::Pointer MathPrinter::zero_of(const Pointer& pointer) {
  kept_.push_back(std::make_shared<const Expression>(
      Expression{Kind::quantity, 0.0, pointer->dimension, "", scalar::readable_unit(pointer->dimension, 0.0), {}}));
  return kept_.back();
}

MathPrinter::Printed MathPrinter::compound(const Expression& expression) {
  std::vector<Printed> operands;
  double width = 0.0;
  for (const Pointer& operand : expression.operands) {
    operands.push_back(print(operand));
    width += operands.back().numbers.width;
  }
  Printed result;
  result.fractions = expression.kind == Kind::divide ? 1 : 0;
  std::vector<Piece> symbols;
  std::vector<Piece> numbers;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const double own = operands[i].numbers.width;
    const bool break_here = expression.kind != Kind::divide && width > widest_line && 2.0 * own >= widest_line;
    const bool too_deep = expression.kind == Kind::divide && operands[i].fractions >= deepest_fraction;
    if (break_here || own > widest_line || too_deep) {
      ++fresh_;
      operands[i] = printed_[expression.operands[i].get()] =
          as_line(fmt::format("z_{}", fresh_), operands[i], *expression.operands[i]);
    }
    symbols.push_back(operands[i].symbols);
    numbers.push_back(operands[i].numbers);
    result.fractions = std::max(result.fractions, operands[i].fractions + (expression.kind == Kind::divide ? 1 : 0));
    for (const std::size_t line : operands[i].needs)
      if (std::find(result.needs.begin(), result.needs.end(), line) == result.needs.end()) result.needs.push_back(line);
  }
  result.symbols = composed(expression, symbols);
  result.numbers = composed(expression, numbers);
  return result;
}

MathPrinter::Printed MathPrinter::print(const Pointer& whole) {
  if (const auto known = printed_.find(whole.get()); known != printed_.end()) return known->second;
  kept_.push_back(whole);
  if (const Pointer counts = all_that_counts(whole); counts != whole) return printed_[whole.get()] = print(counts);
  const Pointer& pointer = whole;
  const Expression& e = *pointer;
  const auto quantity = [](double si, const scalar::Unit& unit, int digits) -> Piece {
    const std::string text = scalar::format(si, unit, digits);
    const bool blank = text.find(' ') != std::string::npos;
    return {row(quantity_mathml(si, unit, digits)), text.front() == '-' ? sum : blank ? raised : atom, length_of(text)};
  };
  Printed result;
  switch (e.kind) {
    case Kind::number: {
      const std::string text = literal_text(e.value);
      const Piece piece{row(number_mathml(text)), text.front() == '-' ? sum : atom, length_of(text)};
      result = {piece, piece, true, {}, 0};
      break;
    }
    case Kind::constant: {
      const Piece piece{"<mi>" + escaped(e.symbol) + "</mi>", atom, 1.0};
      result = {piece, piece, true, {}, 0};
      break;
    }
    case Kind::quantity: {
      const Piece piece = quantity(e.value, e.unit, argument_digits);
      result = {piece, piece, true, {}, 0};
      break;
    }
    case Kind::leaf:
      used_.insert(e.symbol);
      result = {{symbol_mathml(e.symbol), atom, length_of(e.symbol)},
                quantity(e.value, e.unit, argument_digits),
                false,
                {},
                0};
      break;
    case Kind::named:
      result = as_line(e.symbol, print(e.operands[0]), e);
      break;
    default:
      result = compound(e);
  }
  return printed_[pointer.get()] = result;
}

/// One symbol for one meaning: the second quantity of a name gets an index.
MathPrinter::Printed MathPrinter::as_line(const std::string& symbol,
                                          const Printed& meaning,
                                          const Expression& expression) {
  const scalar::Unit unit = unit_of_line(symbol, expression);
  const std::string value = row(quantity_mathml(expression.value, unit, result_digits));
  const std::string said = meaning.numbers.text + meaning.symbols.text;
  std::string unique = symbol;
  std::size_t line = lines_.size();
  for (int count = 2;; ++count) {
    const auto [place, is_new] = meanings_.try_emplace(unique, said, lines_.size());
    line = place->second.second;
    if (!is_new && place->second.first == said) break;
    if (is_new) {
      lines_.push_back({{symbol_mathml(unique),
                         meaning.plain ? std::string() : meaning.symbols.text,
                         meaning.plain || meaning.numbers.text == value ? std::string() : meaning.numbers.text,
                         value},
                        meaning.needs,
                        0,
                        false});
      break;
    }
    unique = fmt::format("{}{}{}", symbol, symbol.find('_') == std::string::npos ? "_" : ",", count);
  }
  const std::string text = scalar::format(expression.value, unit, result_digits);
  return {{symbol_mathml(unique), atom, length_of(unique)},
          {value, text.front() == '-' ? sum : raised, length_of(text)},
          false,
          {line},
          0};
}

void MathPrinter::use(std::size_t line, std::size_t result) {
  Line& used = lines_[line];
  if (used.user == result) return;
  used.shared = used.shared || used.user != 0;
  used.user = result;
  for (const std::size_t needed : std::vector<std::size_t>(used.needs)) use(needed, result);
}

void MathPrinter::add(const scalar::Traced& result, double shown_value, const std::string& unit_name) {
  Pointer pointer = result.expression();
  if (pointer == nullptr)
    pointer = std::make_shared<const Expression>(
        Expression{Kind::number, result.value, result.dimension, "", scalar::Unit(), {}});
  kept_.push_back(pointer);
  const Printed printed = print(pointer);
  const std::string unit = shown_unit(unit_name);
  const auto shown = [&](int digits) {
    std::string text =
        std::isnan(shown_value) ? "<mtext>–</mtext>" : number_mathml(scalar::format_number(shown_value, digits));
    if (!unit.empty())
      text += (unit == "°" ? "" : "<mspace width=\"0.2em\"/>") + ("<mtext>" + escaped(unit) + "</mtext>");
    return row(text);
  };
  // A figure that is given is not rounded once more: 1247.5 mm are not "1247.5 mm = 1247 mm".
  std::string value = shown(argument_digits);
  if (printed.numbers.text != value) value = shown(result_digits);
  results_.push_back({{{},
                       printed.plain ? std::string() : printed.symbols.text,
                       printed.plain || printed.numbers.text == value ? std::string() : printed.numbers.text,
                       value},
                      printed.needs,
                      pointer->kind == Kind::named});
  for (const std::size_t line : printed.needs) use(line, results_.size());
}

std::vector<MathLine> MathPrinter::lines(std::size_t result) const {
  const Result& asked = results_[result];
  std::vector<MathLine> all;
  for (const Line& line : lines_)
    if (!line.shared && line.user == result + 1) all.push_back(line.text);
  MathLine last = asked.text;
  if (asked.is_a_line && !lines_[asked.needs.front()].shared) {
    // A result that a formula named itself is the last line.
    all.pop_back();
    const MathLine& own = lines_[asked.needs.front()].text;
    last.expression = own.expression;
    last.substituted = own.substituted;
  } else if (asked.is_a_line) {
    last.substituted.clear();
  }
  all.push_back(std::move(last));
  return all;
}

std::vector<MathLine> MathPrinter::shared() const {
  std::vector<MathLine> all;
  for (const Line& line : lines_)
    if (line.shared) all.push_back(line.text);
  return all;
}

}  // namespace millwright::report
