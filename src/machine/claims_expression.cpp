// SPDX-License-Identifier: Apache-2.0
#include "machine/claims_expression.h"

#include <algorithm>
#include <charconv>

#include "text/characters.h"

namespace millwright::machine {

namespace {
constexpr int deepest = 100;
constexpr std::size_t most_terms = 2000;  // numbers, names and operators; one below the other, they are walked down
}  // namespace

/// Recursive descent; the first failure stops it.
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, ClaimExpression& result, ExpressionError& error)
      : text_(text), result_(result), error_(error) {}

  bool parse() {
    result_.root_ = sum();
    if (ok_ && at() != '\0') fail("an operator (+ - * / ^) was expected here");
    return ok_;
  }

 private:
  using Operation = ClaimExpression::Operation;

  char at() {
    while (offset_ < text_.size() && text_[offset_] == ' ') ++offset_;
    return offset_ < text_.size() ? text_[offset_] : '\0';
  }
  bool take(char c) {
    if (at() != c || c == '\0') return false;
    ++offset_;
    return true;
  }
  std::size_t fail(std::string message) {
    if (ok_) error_ = {offset_, std::move(message)};
    ok_ = false;
    offset_ = text_.size();
    return 0;
  }
  std::size_t add(Operation operation, std::size_t left = 0, std::size_t right = 0, double number = 0.0) {
    if (result_.nodes_.size() == most_terms) return fail("the expression is too long");
    ClaimExpression::Node node;
    node.operation = operation;
    node.number = number;
    node.left = left;
    node.right = right;
    result_.nodes_.push_back(node);
    return result_.nodes_.size() - 1;
  }

  std::size_t sum() {
    if (++depth_ > deepest) return fail("too many brackets inside one another");
    std::size_t left = product();
    for (;;) {
      if (take('+')) {
        left = add(Operation::plus, left, product());
      } else if (take('-')) {
        left = add(Operation::minus, left, product());
      } else {
        --depth_;
        return left;
      }
    }
  }
  std::size_t product() {
    std::size_t left = power();
    for (;;) {
      if (take('*')) {
        left = add(Operation::times, left, power());
      } else if (take('/')) {
        left = add(Operation::over, left, power());
      } else {
        return left;
      }
    }
  }
  std::size_t power() {
    if (++depth_ > deepest) return fail("too many signs or powers one after another");
    std::size_t result = 0;
    if (take('-')) {
      result = negative(power());
    } else {
      result = atom();
      if (take('^')) result = add(Operation::power, result, power());
    }
    --depth_;
    return result;
  }
  /// A negative literal stays a literal, so that a length may be raised to -2.
  std::size_t negative(std::size_t operand) {
    if (!ok_ || result_.nodes_[operand].operation != Operation::number) return add(Operation::negative, operand);
    result_.nodes_[operand].number = -result_.nodes_[operand].number;
    return operand;
  }
  std::size_t atom() {
    const char c = at();
    if (take('(')) return closed(sum());
    if (text::is_digit(c) || c == '.') return number();
    if (text::begins_name(c)) return name();
    return fail(c == '\0' ? "the expression ends too early" : "a number, a name or a bracket was expected here");
  }
  std::size_t closed(std::size_t inner) {
    if (!take(')')) return fail("a closing bracket was expected here");
    return inner;
  }
  std::size_t number() {
    double value = 0.0;
    const char* begin = text_.data() + offset_;
    const auto [end, problem] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (problem != std::errc()) return fail("not a number");
    offset_ += static_cast<std::size_t>(end - begin);
    return add(Operation::number, 0, 0, value);
  }
  std::size_t name() {
    const std::size_t begin = offset_;
    while (offset_ < text_.size() && (text::begins_name(text_[offset_]) || text::is_digit(text_[offset_]))) ++offset_;
    const std::string word(text_.substr(begin, offset_ - begin));
    if (word == "pi") return add(Operation::pi);
    if (at() == '(') {
      if (word != "sqrt" && word != "cbrt") return fail("no function '" + word + "'; there are sqrt and cbrt");
      take('(');
      return add(word == "sqrt" ? Operation::square_root : Operation::cube_root, closed(sum()));
    }
    const auto known = std::find(result_.names_.begin(), result_.names_.end(), word);
    const auto index = static_cast<std::size_t>(known - result_.names_.begin());
    if (known == result_.names_.end()) result_.names_.push_back(word);
    return add(Operation::name, index);
  }

  std::string_view text_;
  ClaimExpression& result_;
  ExpressionError& error_;
  std::size_t offset_ = 0;
  int depth_ = 0;
  bool ok_ = true;
};

std::shared_ptr<const ClaimExpression> ClaimExpression::parse(std::string_view text, ExpressionError& error) {
  auto result = std::make_shared<ClaimExpression>();
  if (!ExpressionParser(text, *result, error).parse()) return nullptr;
  return result;
}

}  // namespace millwright::machine
