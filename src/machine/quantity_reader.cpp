// SPDX-License-Identifier: Apache-2.0
#include "machine/quantity_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "scalar/unit.h"
#include "text/number.h"

namespace millwright::machine {

using text::Expected;
using text::Key;
using text::Node;
using text::Presence;

namespace {

constexpr UsualValues usual[] = {
    {"mm", "700 mm", 1e-9, 1e3},
    {"m", "0.05 mm", 1e-9, 1e3},
    {"s", "0.2 s", 1e-6, 1e10},  // up to the service lives that people wish for
    {"kg", "16 kg", 1e-9, 1e6},
    {"N", "60 N", 1e-9, 1e8},
    {"N.m", "0.5 N.m", 1e-9, 1e6},
    {"mm/s", "20 mm/s", 1e-9, 1e3},
    {"m/s", "200 m/min", 1e-9, 1e3},
    {"m/s^3", "50 m/s^3", 1e-6, 1e9},
    {"rad/s^3", "500 rad/s^3", 1e-6, 1e9},
    {"V", "24 V", 1e-3, 1e3},
    {"A", "2 A", 1e-3, 1e3},
    {"deg", "30 deg", 1e-9, 10.0},
    {"rad", "90 deg", 1e-9, 1e5},
    {"rpm", "30 rpm", 1e-9, 1e4},
    {"kg.m2", "0.02 kg.m2", 1e-12, 1e5},
    {"N.m/rad", "500 N.m/rad", 1e-3, 1e9},
    {"Hz", "30 kHz", 1e-3, 1e9},
    {"Pa", "80 N/mm^2", 1.0, 1e12},
    {"rad/m", "0.3 deg/m", 1e-9, 1e3},
    {"rad", "0.5 deg", 1e-9, 10.0},
    {"K", "5 K", 1e-6, 1e4},
    {"N/m", "20 N/um", 1e-3, 1e12},
    {"m2/N", "1e-15 m2/N", 1e-25, 1.0},
    {"W", "500 W", 1e-3, 1e6},
    {"J", "150 J", 1e-6, 1e9},
    {"1", "1", 1e-9, 1e9},
};

std::string quoted_unless_number(std::string_view unit, std::string_view example) {
  return unit == "1" ? std::string(example) : fmt::format("\"{}\"", example);
}

std::string without_end(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == ';' || text.back() == ':')) text.remove_suffix(1);
  return std::string(text);
}

/// What the unit reader says in one sentence is a complaint and, mostly, an advice.
void take_apart(const std::string& reason, QuantityFault& fault) {
  for (const std::string_view seam : {", did you mean", "; ", ": write"}) {
    const std::size_t at = reason.find(seam);
    if (at == std::string::npos) continue;
    fault.message = without_end(std::string_view(reason).substr(0, at));
    fault.hint = reason.substr(at + 2);
    return;
  }
  fault.message = reason;
}

/// Which bytes of the text are meant: the number if it is none, else the unit, or the one name in it that is unknown.
void locate(std::string_view text, const std::string& reason, QuantityFault& fault) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  const std::size_t blank = std::min(text.find(' ', begin), text.size());
  const std::size_t unit = std::min(text.find_first_not_of(" \t", blank), text.size());
  const std::size_t end = std::max(text.find_last_not_of(" \t") + 1, unit);
  std::string ignored;
  const bool number = scalar::parse_number(text.substr(begin, blank - begin), ignored).has_value();
  fault.offset = number && unit < end ? unit : begin;
  fault.length = (number && unit < end ? end : blank) - fault.offset;
  constexpr std::string_view unknown = "unknown unit '";
  const std::size_t name = reason.find(unknown);
  if (!number || name == std::string::npos) return;
  const std::size_t from = name + unknown.size();
  const std::string word = reason.substr(from, reason.find('\'', from) - from);
  const std::size_t at = word.empty() ? std::string_view::npos : text.find(word, unit);
  if (at == std::string_view::npos) return;
  fault.offset = at;
  fault.length = word.size();
}

std::string_view first_word(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return text.substr(0, text.find(' '));
}

/// Letters and signs that look like those of a number: 7OO, −5.
std::optional<std::string> look_alike(std::string_view text) {
  const std::string_view number = first_word(text);
  if (number.empty() || text::parse_number(number)) return std::nullopt;
  std::string hint = text::number_hint(number, text::NumberPlace::alone);
  if (hint.starts_with("letter") || hint.starts_with("a minus sign")) return hint;
  return std::nullopt;
}

}  // namespace

std::string as_written(double value, std::string_view unit) {
  if (!std::isfinite(value)) return {};
  if (unit == "1") return fmt::format("{:.6g}", value);
  const double size = std::fabs(value);
  const std::string_view shown = unit == "m" && size < 1.0      ? "mm"
                                 : unit == "s" && size >= 3600. ? "h"
                                 : unit == "rad"                ? "deg"
                                 : unit == "rad/m"              ? "deg/m"
                                 : unit == "Pa"                 ? "N/mm^2"
                                                                : unit;
  return fmt::format("\"{}\"", scalar::format(value, scalar::Unit::of(shown), 6));
}

UsualValues usual_values(std::string_view unit) {
  for (const UsualValues& values : usual)
    if (values.unit == unit) return values;
  return {unit, "", 0.0, std::numeric_limits<double>::max()};
}

bool check_magnitude(double value, std::string_view unit, Sign sign, QuantityFault& fault) {
  const UsualValues values = usual_values(unit);
  const scalar::Unit shown = scalar::Unit::of(unit);
  const scalar::Unit large = unit.starts_with("mm") ? scalar::Unit::of(unit.substr(1)) : shown;
  fault.hint = fmt::format("write for example {}", quoted_unless_number(unit, values.example));
  if (sign != Sign::any && value < 0.0) {
    fault.message = "must not be negative";
  } else if (sign == Sign::positive && value == 0.0) {
    fault.message = "must be greater than zero";
  } else if (!(std::fabs(value) <= values.largest)) {
    fault.message = "more than any machine has";
    fault.hint = fmt::format("at most {}: is it the right unit?", scalar::format(values.largest, large));
  } else if (sign == Sign::positive && value < values.smallest) {
    fault.message = "less than any machine has";
    fault.hint = fmt::format("at least {}: is it the right unit?", scalar::format(values.smallest, shown));
  } else {
    return true;
  }
  return false;
}

std::optional<double> read_quantity(std::string_view text, std::string_view unit, Sign sign, QuantityFault& fault) {
  std::string reason;
  const scalar::Unit expected = scalar::Unit::of(unit);
  if (const auto quantity = scalar::parse_quantity(text, expected, reason)) {
    if (check_magnitude(quantity->si, unit, sign, fault)) return quantity->si;
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    fault.offset = begin;
    fault.length = std::min(text.find_first_of(" \t", begin), text.size()) - begin;
    return std::nullopt;
  }
  take_apart(reason, fault);
  if (const auto advice = look_alike(text)) {
    fault.message = fmt::format("'{}' is not a number", first_word(text));
    fault.hint = *advice;
  } else if (fault.hint.empty()) {
    fault.hint = fmt::format("write for example {}", quoted_unless_number(unit, usual_values(unit).example));
  }
  locate(text, reason, fault);
  return std::nullopt;
}

text::Question QuantityReader::question(const Key& key, Expected expected, std::string_view unit, Sign sign) const {
  text::Question asked;
  asked.expected = expected;
  asked.key = key.name;
  asked.meaning = key.meaning;
  asked.unit = unit;
  asked.example = quoted_unless_number(unit, usual_values(unit).example);
  if (sign != Sign::any) asked.least = 0.0;
  asked.above_least = sign == Sign::positive;
  return asked;
}

void QuantityReader::describe_with(double fallback, text::Question asked) const {
  if (!table_.heard()) return;
  const bool stands_for_missing = asked.above_least && fallback <= asked.least;  // a value that may not be given
  if (!stands_for_missing) asked.fallback = as_written(fallback, asked.unit);
  table_.describe(asked);
}

void QuantityReader::describe(const Key& key, Expected expected, std::string_view unit, Sign sign) const {
  if (table_.heard()) table_.describe(question(key, expected, unit, sign));
}

std::optional<double> QuantityReader::of_node(
    const Node& node, std::string_view what, std::string_view unit, Sign sign, std::string_view example) {
  const bool plain = unit == "1";
  QuantityFault fault;
  const auto usual_hint = [&] {
    return fmt::format("write for example {}",
                       example.empty() ? quoted_unless_number(unit, usual_values(unit).example) : std::string(example));
  };
  // The unit's example, or the limit of any number, says nothing of this key.
  const auto hint = [&] {
    const bool general = fault.hint.starts_with("write for example ") || fault.hint.starts_with("at most ");
    return general && !example.empty() ? usual_hint() : fault.hint;
  };
  if (node.is_number() && diagnostics_.has_error_at(node.span())) return std::nullopt;  // not a finite number
  if (node.is_number()) {
    if (plain && check_magnitude(*node.as_number(), unit, sign, fault)) return node.as_number();
    if (!plain) {
      fault.message = "a bare number where a unit is needed";
      const UsualValues values = usual_values(unit);
      fault.hint = fmt::format("write \"{} {}\"",
                               *node.as_number(),
                               values.unit == "m"     ? "mm"
                               : values.unit == "rad" ? "deg"
                                                      : values.unit);
    }
    diagnostics_.error(node.span(), fmt::format("{}: {}", what, fault.message), hint());
    return std::nullopt;
  }
  if (!node.is_string()) {
    diagnostics_.error(node.span(),
                       fmt::format("{}: {} where a {} is needed",
                                   what,
                                   text::describe(node.kind()),
                                   plain ? "number" : "quantity with a unit"),
                       usual_hint());
    return std::nullopt;
  }
  const std::string words = *node.as_string();
  if (const auto value = read_quantity(words, unit, sign, fault)) return value;
  diagnostics_.error(node.part_span(fault.offset, std::max<std::size_t>(fault.length, 1)),
                     fmt::format("{}: {}", what, fault.message),
                     hint());
  return std::nullopt;
}

std::optional<double> QuantityReader::quantity(const Key& key, std::string_view unit, Sign sign, Presence presence) {
  describe(key, Expected::quantity, unit, sign);
  const Node* node =
      presence == Presence::required
          ? required(key.name, fmt::format("{} = {}", key.name, quoted_unless_number(unit, usual_values(unit).example)))
          : table_.find(key.name);
  if (node == nullptr) return std::nullopt;
  return of_node(*node, key.name, unit, sign);
}

double QuantityReader::quantity_or(const Key& key, std::string_view unit, double fallback, Sign sign) {
  describe_with(fallback, question(key, Expected::quantity, unit, sign));
  return quantity(key, unit, sign).value_or(fallback);
}

double QuantityReader::share_or(const Key& key, double fallback, bool zero) {
  const Sign sign = zero ? Sign::not_negative : Sign::positive;
  text::Question asked = question(key, Expected::quantity, "1", sign);
  asked.most = 1.0;
  describe_with(fallback, std::move(asked));
  const Node* node = table_.find(key.name);
  const auto percent = [](double share) { return fmt::format("{:.6g} or \"{:.6g} %\"", share, 100.0 * share); };
  const std::string example = percent(fallback > 0.0 && fallback < 1.0 ? fallback : 0.8);
  const auto value = node == nullptr ? std::nullopt : of_node(*node, key.name, "1", sign, example);
  if (!value) return fallback;
  if (*value <= 1.0) return *value;
  // A bare 5 is most likely meant as percent.
  const bool meant_percent = node->is_number() && *value >= 2.0 && *value <= 100.0;
  const double share = meant_percent ? 0.01 * *value : 0.8;
  diagnostics_.error(node->span(),
                     fmt::format("{}: a share is at most 1, this is {:.6g}", key.name, *value),
                     fmt::format("{:.6g} percent are {}", 100.0 * share, percent(share)));
  return fallback;
}

double QuantityReader::count_or(const Key& key, double fallback, int least, int most) {
  text::Question asked = question(key, Expected::integer, "1", Sign::any);
  asked.least = least;
  asked.most = most;
  describe_with(fallback, std::move(asked));
  const Node* node = table_.find(key.name);
  const auto value = node == nullptr ? std::nullopt : of_node(*node, key.name, "1", Sign::any);
  if (!value) return fallback;
  if (*value == std::floor(*value) && *value >= least && *value <= most) return *value;
  diagnostics_.error(
      node->span(),
      fmt::format("{}: a whole number from {} to {} is needed, this is {:.6g}", key.name, least, most, *value),
      fmt::format("write for example {}", fallback));
  return fallback;
}

std::optional<Range> QuantityReader::range(const Key& key, std::string_view unit, Presence presence) {
  describe(key, Expected::range, unit, Sign::positive);
  const std::string_view example = usual_values(unit).example;
  const Node* node = presence == Presence::required ? required(key.name, fmt::format("{} = \"{}\"", key.name, example))
                                                    : table_.find(key.name);
  if (node == nullptr) return std::nullopt;
  if (!node->is_array()) {
    const auto value = of_node(*node, key.name, unit, Sign::positive);
    if (!value) return std::nullopt;
    return Range{*value, *value};
  }
  if (node->size() != 2) {
    diagnostics_.error(node->span(),
                       fmt::format("{}: a range has two ends, this list has {}", key.name, node->size()),
                       fmt::format("write [\"1 {}\", \"2 {}\"]", unit, unit));
    return std::nullopt;
  }
  const auto lower = of_node(node->at(0), key.name, unit, Sign::positive);
  const auto upper = of_node(node->at(1), key.name, unit, Sign::positive);
  if (!lower || !upper) return std::nullopt;
  if (*lower > *upper) {
    diagnostics_.error(node->span(), fmt::format("{}: the lower end is above the upper end", key.name), "swap the two");
    return std::nullopt;
  }
  return Range{*lower, *upper};
}

std::vector<double> QuantityReader::choices(const Key& key, std::string_view unit) {
  describe(key, Expected::quantities, unit, Sign::positive);
  const Node* given = table_.find(key.name);
  if (given != nullptr && given->is_array() && given->size() == 0)
    diagnostics_.error(given->span(),
                       fmt::format("{}: the list is empty", key.name),
                       fmt::format("write for example {} = [\"{}\"]", key.name, usual_values(unit).example));
  std::vector<double> values;
  std::vector<const Node*> nodes;
  for (const Node* node : table_.list(key.name)) {
    const auto value = of_node(*node, key.name, unit, Sign::positive);
    if (!value) continue;
    const auto same = std::find_if(
        values.begin(), values.end(), [&](double other) { return std::abs(other - *value) <= 1e-9 * *value; });
    if (same == values.end()) {
      values.push_back(*value);
      nodes.push_back(node);
      continue;
    }
    text::Diagnostic twice;
    twice.where = node->span();
    twice.message = fmt::format("{}: {:.6g} {} is there twice", key.name, *value, unit);
    twice.hint = "leave one out";
    twice.related = nodes[static_cast<std::size_t>(same - values.begin())]->span();
    twice.related_message = "first here";
    diagnostics_.add(std::move(twice));
  }
  return values;
}

}  // namespace millwright::machine
