// SPDX-License-Identifier: Apache-2.0
#include "text/json_reader.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <utility>

#include "text/characters.h"
#include "text/utf8.h"

namespace millwright::text {

JsonReader::JsonReader(std::shared_ptr<const SourceText> text, Diagnostics& diagnostics)
    : text_(std::move(text)), bytes_(text_->contents()), diagnostics_(diagnostics) {}

void JsonReader::advance() {
  const auto byte = static_cast<unsigned char>(bytes_[now_.offset++]);
  const unsigned char next = at_end() ? 0 : static_cast<unsigned char>(bytes_[now_.offset]);
  if (byte == '\n') {
    ++now_.line;
    now_.column = 1;
  } else if (byte == '\r' && (at_end() || next == '\n')) {
    // The end of a line is one place.
  } else if ((next & 0xC0U) != 0x80U) {  // the column moves with the last byte of a character
    ++now_.column;
  }
}

void JsonReader::skip_blanks() {
  while (!at_end() && (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r')) advance();
}

SourceSpan JsonReader::span_from(const Mark& begin) const {
  if (now_.line == begin.line) return {text_, begin.line, begin.column, now_.column - begin.column};
  return {text_, begin.line, begin.column, 1};
}

bool JsonReader::fail(const Mark& place, std::string message, std::string hint) {
  diagnostics_.error({text_, place.line, place.column, 1}, "JSON: " + std::move(message), std::move(hint));
  return false;
}

std::optional<Node> JsonReader::read() {
  std::optional<Node> result;
  skip_blanks();
  const Mark begin = now_;
  if (!read_value(result)) return std::nullopt;
  if (!result) fail(begin, "nothing but null", "a file holds one object");
  skip_blanks();
  if (!at_end()) {
    fail(now_, "text after the end of the value", "a file holds one object");
    return std::nullopt;
  }
  return result;
}

bool JsonReader::read_value(std::optional<Node>& result) {
  const Mark begin = now_;
  switch (peek()) {
    case '{':
      return read_object(result);
    case '[':
      return read_array(result);
    case '"': {
      std::string value;
      if (!read_string(value)) return false;
      result = Node::make_string(span_from(begin), std::move(value));
      return true;
    }
    default:
      if (peek() == '-' || is_digit(peek())) return read_number(result);
      if (begins_name(peek())) return read_word(result);
      return fail_at_value();
  }
}

bool JsonReader::fail_at_value() {
  if (at_end()) return fail(now_, "the text ends where a value is expected");
  switch (peek()) {
    case '\'':
      return fail(now_, "a value is expected", "strings stand in double quotes");
    case '/':
    case '#':
      return fail(now_, "a value is expected", "JSON has no comments; TOML has");
    case ',':
      return fail(now_, "a value is expected", "one comma too many");
    case ']':
    case '}':
      return fail(now_, "a value is expected", "no comma before the closing bracket");
    case '+':
    case '.':
      return fail(now_, "a value is expected", "numbers begin with a digit or '-'");
    default:
      return fail(now_, "a value is expected");
  }
}

bool JsonReader::read_object(std::optional<Node>& result) {
  const Mark begin = now_;
  if (++depth_ > depth_limit) return fail(begin, "nested more than 256 levels deep");
  advance();
  Node object = Node::make_table(span_from(begin));
  skip_blanks();
  bool more = peek() != '}' || at_end();
  while (more) {
    if (!read_member(object)) return false;
    skip_blanks();
    if (at_end()) return fail(begin, "'{' is never closed");
    if (peek() != ',' && peek() != '}') return fail(now_, "',' or '}' is expected");
    more = peek() == ',';
    if (more) advance();
    skip_blanks();
  }
  advance();
  --depth_;
  object.set_span(span_from(begin));
  result = std::move(object);
  return true;
}

bool JsonReader::read_member(Node& object) {
  const Mark begin = now_;
  if (peek() == '}') return fail(now_, "a key is expected", "no comma before the closing bracket");
  if (at_end()) return fail(now_, "the text ends inside an object");
  if (peek() != '"') return fail(now_, "a key is expected", "keys stand in double quotes");
  std::string key;
  if (!read_string(key)) return false;
  SourceSpan key_span = span_from(begin);
  skip_blanks();
  if (peek() != ':') return fail(now_, "':' is expected behind the key");
  advance();
  skip_blanks();
  const Mark value_begin = now_;
  std::optional<Node> value;
  if (!read_value(value)) return false;
  if (object.find(key) != nullptr) {
    Diagnostic diagnostic;
    diagnostic.where = std::move(key_span);
    diagnostic.message = "JSON: the key " + in_quotes(key) + " stands twice in this object";
    diagnostic.related = object.key_span(key);
    diagnostic.related_message = "the first is here";
    diagnostics_.add(std::move(diagnostic));
  } else if (!value) {
    diagnostics_.error(span_from(value_begin), "null has no meaning here", "leave the key out");
  } else {
    object.put(std::move(key), std::move(key_span), std::move(*value));
  }
  return true;
}

bool JsonReader::read_array(std::optional<Node>& result) {
  const Mark begin = now_;
  if (++depth_ > depth_limit) return fail(begin, "nested more than 256 levels deep");
  advance();
  Node array = Node::make_array(span_from(begin));
  skip_blanks();
  bool more = peek() != ']' || at_end();
  while (more) {
    const Mark item_begin = now_;
    std::optional<Node> item;
    if (!read_value(item)) return false;
    if (item) {
      array.append(std::move(*item));
    } else {
      diagnostics_.error(span_from(item_begin), "null has no meaning here", "leave the element out");
    }
    skip_blanks();
    if (at_end()) return fail(begin, "'[' is never closed");
    if (peek() != ',' && peek() != ']') return fail(now_, "',' or ']' is expected");
    more = peek() == ',';
    if (more) advance();
    skip_blanks();
  }
  advance();
  --depth_;
  array.set_span(span_from(begin));
  result = std::move(array);
  return true;
}

bool JsonReader::read_string(std::string& value) {
  const Mark begin = now_;
  advance();
  while (!at_end() && peek() != '"') {
    const auto byte = static_cast<unsigned char>(peek());
    if (byte == '\n' || byte == '\r') return fail(begin, "the string is not closed in its line");
    if (byte < 0x20) return fail(now_, "a control character inside a string", "write it as an escape such as \\t");
    if (byte == '\\') {
      if (!read_escape(value, now_)) return false;
    } else {
      value.push_back(peek());
      advance();
    }
  }
  if (at_end()) return fail(begin, "the string is never closed");
  advance();
  return true;
}

bool JsonReader::read_escape(std::string& value, const Mark& at) {
  const Mark begin = at;  // `at` may be the moving place itself
  advance();
  constexpr std::string_view letters = "\"\\/bfnrt";
  constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
  const std::size_t found = at_end() ? std::string_view::npos : letters.find(peek());
  if (found != std::string_view::npos) {
    value.push_back(meanings[found]);
    advance();
    return true;
  }
  if (peek() != 'u') return fail(begin, "an unknown escape", "a backslash itself is written \\\\");
  advance();
  char32_t code = 0;
  if (!read_code_unit(code, begin)) return false;
  if (code >= 0xDC00 && code <= 0xDFFF) return fail(begin, "half of a surrogate pair");
  if (code >= 0xD800 && code <= 0xDBFF) {
    if (bytes_.substr(now_.offset, 2) != "\\u") return fail(begin, "half of a surrogate pair");
    advance();
    advance();
    char32_t low = 0;
    if (!read_code_unit(low, begin)) return false;
    if (low < 0xDC00 || low > 0xDFFF) return fail(begin, "half of a surrogate pair");
    code = 0x10000 + ((code - 0xD800) << 10U) + (low - 0xDC00);
  }
  append_utf8(value, code);
  return true;
}

/// The four hexadecimal digits of a \u escape.
bool JsonReader::read_code_unit(char32_t& value, const Mark& begin) {
  const std::string_view digits = bytes_.substr(now_.offset, 4);
  std::uint32_t parsed = 0;
  const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), parsed, 16);
  if (digits.size() < 4 || result.ec != std::errc{} || result.ptr != digits.data() + 4) {
    return fail(begin, "\\u needs four hexadecimal digits");
  }
  for (int i = 0; i < 4; ++i) advance();
  value = parsed;
  return true;
}

std::size_t JsonReader::skip_digits() {
  const std::size_t before = now_.offset;
  while (!at_end() && is_digit(peek())) advance();
  return now_.offset - before;
}

bool JsonReader::read_number(std::optional<Node>& result) {
  const Mark begin = now_;
  bool integral = true;
  if (peek() == '-') advance();
  const bool zero = peek() == '0';
  const std::size_t digits = skip_digits();
  if (digits == 0) return fail(now_, "a digit is expected");
  if (zero && digits > 1) return fail(begin, "a number with a leading zero");
  if (peek() == '.') {
    integral = false;
    advance();
    if (skip_digits() == 0) return fail(now_, "a digit is expected behind the decimal point");
  }
  if (peek() == 'e' || peek() == 'E') {
    integral = false;
    advance();
    if (peek() == '+' || peek() == '-') advance();
    if (skip_digits() == 0) return fail(now_, "a digit is expected in the exponent");
  }
  if (begins_name(peek()) || peek() == '.') return fail(now_, "a number ends here", "quantities stand in quotes");
  const std::string_view token = bytes_.substr(begin.offset, now_.offset - begin.offset);
  std::int64_t whole_number = 0;
  if (integral && std::from_chars(token.data(), token.data() + token.size(), whole_number).ec == std::errc{}) {
    result = Node::make_integer(span_from(begin), whole_number);
    return true;
  }
  double number = 0;
  const std::from_chars_result parsed = std::from_chars(token.data(), token.data() + token.size(), number);
  if (parsed.ec != std::errc{} || !std::isfinite(number)) return fail(begin, "too large or too small for a number");
  result = Node::make_number(span_from(begin), number);
  return true;
}

/// true, false and null; null leaves no result.
bool JsonReader::read_word(std::optional<Node>& result) {
  const Mark begin = now_;
  while (!at_end() && (begins_name(peek()) || is_digit(peek()))) advance();
  const std::string_view word = bytes_.substr(begin.offset, now_.offset - begin.offset);
  if (word == "null") return true;
  if (word == "true" || word == "false") {
    result = Node::make_boolean(span_from(begin), word == "true");
    return true;
  }
  const bool wrong_case = word == "True" || word == "False" || word == "TRUE" || word == "FALSE";
  return fail(begin,
              in_quotes(word) + " is no value",
              wrong_case ? "true and false are written in small letters" : "text stands in double quotes");
}

}  // namespace millwright::text
