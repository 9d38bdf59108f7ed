// SPDX-License-Identifier: Apache-2.0
#include "catalogue/lint_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "catalogue/column_unit.h"

namespace millwright::catalogue {
namespace {

/// Two figures given in different units are equal up to this.
constexpr double rounding = 1e-9;

std::string shown(double value, const ColumnDeclaration& declared, int digits = 5) {
  const bool bare = declared.unit.empty() || declared.unit == "1";
  return scalar::format_number(value, digits) + (bare ? "" : " " + std::string(declared.unit));
}

/// The power of ten that brings `factor` (value / what it should be) near 1, in words; empty if there is none.
std::string power_of_ten(double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) return {};
  const double exponent = std::round(std::log10(factor));
  if (exponent == 0.0 || std::abs(std::log10(factor) - exponent) > 0.2) return {};
  const double multiple = std::pow(10.0, std::abs(exponent));
  return fmt::format("{:.0f}x too {}: wrong unit or magnitude?", multiple, exponent > 0.0 ? "large" : "small");
}

}  // namespace

double LintRow::operator()(Column column) const { return display_unit(column).from_si(table_.number(column, row_)); }

void LintRow::report(
    text::Severity severity, std::string_view rule, Column column, std::string message, std::string hint) const {
  if (!waivers_.excuse(row_, rule)) doubts_.push_back({severity, rule, column, std::move(message), std::move(hint)});
}

void LintRow::below(std::string_view rule, Column smaller, Column larger) const {
  const double a = (*this)(smaller);
  const double b = display_unit(smaller).from_si(table_.number(larger, row_));
  if (!(a >= b * (1.0 - rounding))) return;
  report(text::Severity::error,
         rule,
         smaller,
         fmt::format("{} {} is not below {} {}",
                     declaration(smaller).name,
                     shown(a, declaration(smaller)),
                     declaration(larger).name,
                     shown(b, declaration(smaller))));
}

void LintRow::at_most(std::string_view rule, Column smaller, Column larger) const {
  const double a = (*this)(smaller);
  const double b = display_unit(smaller).from_si(table_.number(larger, row_));
  if (!(a > b * (1.0 + rounding))) return;
  report(text::Severity::error,
         rule,
         smaller,
         fmt::format("{} {} is more than {} {}",
                     declaration(smaller).name,
                     shown(a, declaration(smaller)),
                     declaration(larger).name,
                     shown(b, declaration(smaller))));
}

void LintRow::agrees(
    std::string_view rule, Column column, double expected, double odd, double impossible, std::string_view why) const {
  const double value = (*this)(column);
  const double difference = std::abs(value - expected);
  if (!(difference > odd * std::abs(expected))) return;
  const bool wrong = difference > impossible * std::abs(expected);
  report(wrong ? text::Severity::error : text::Severity::warning,
         rule,
         column,
         fmt::format("{} is {}, but {} is {}",
                     declaration(column).name,
                     shown(value, declaration(column)),
                     why,
                     shown(expected, declaration(column))),
         power_of_ten(value / expected));
}

void LintRow::within(
    std::string_view rule, Column column, double value, const Band& band, std::string_view what) const {
  const bool low = value < band.odd_below;
  if (!low && !(value > band.odd_above)) return;
  const bool wrong = value < band.impossible_below || value > band.impossible_above;
  report(wrong ? text::Severity::error : text::Severity::warning,
         rule,
         column,
         fmt::format("{} is {}, usual are {} to {}",
                     what,
                     scalar::format_number(value, 4),
                     scalar::format_number(band.odd_below, 4),
                     scalar::format_number(band.odd_above, 4)),
         wrong ? fmt::format("{} is too {} for the other figures of the row: wrong unit or magnitude?",
                             declaration(column).name,
                             low ? "small" : "large")
               : std::string());
}

void LintRow::demand(std::string_view rule, Column column, bool holds, const std::string& message) const {
  if (!holds) report(text::Severity::error, rule, column, message);
}

void LintRow::expect(std::string_view rule, Column column, bool holds, const std::string& message) const {
  if (!holds) report(text::Severity::warning, rule, column, message);
}

void LintRow::magnitudes() const {
  for (std::size_t index = 0; index < column_count(table_.family()); ++index) {
    const Column each{table_.family(), static_cast<std::uint8_t>(index)};
    const ColumnDeclaration& declared = declaration(each);
    if (declared.kind != Kind::number && declared.kind != Kind::money) continue;
    if (std::isnan(table_.number(each, row_))) continue;
    const double value = (*this)(each);
    const double slack = rounding * std::abs(value);  // a limit given in another unit is still inside
    const bool low = value < declared.lower - slack;
    if (!low && !(value > declared.upper + slack)) continue;
    const double factor = low ? declared.lower / value : value / declared.upper;
    std::string hint;
    for (double power = 10.0; power <= 1e9 && hint.empty(); power *= 10.0) {
      if (factor <= power)
        hint = fmt::format("{:.0f}x too {}: wrong unit or magnitude?", power, low ? "small" : "large");
    }
    report(factor > 3.0 || value < 0.0 ? text::Severity::error : text::Severity::warning,
           "magnitude",
           each,
           fmt::format("{} {} is outside the plausible {} to {}",
                       declared.name,
                       shown(value, declared),
                       scalar::format_number(declared.lower, 4),
                       shown(declared.upper, declared)),
           hint);
  }
}

std::optional<Suspicion> LintRow::suspicion(const Plausibility& plausibility) const {
  // With other rows beside it a row may be told or not; its waiver is right as long as the figure is unusual.
  waivers_.need_where(row_, [&](std::string_view rule) { return plausibility.is_unusual(row_, rule); });
  const auto nothing = [](std::string_view) { return false; };
  std::optional<Suspicion> found = plausibility.examine(row_, nothing);
  if (!found) return found;
  bool excused = false;
  for (const std::string_view rule : found->rules) excused |= waivers_.excuse(row_, rule);
  if (!excused) return found;
  return plausibility.examine(row_, [&](std::string_view rule) { return waivers_.excuses(row_, rule); });
}

void LintRow::tell(const Suspicion& suspicion, text::Diagnostics& diagnostics) const {
  const ColumnDeclaration& declared = declaration(suspicion.column);
  std::string rules;
  bool impossible = suspicion.impossible;
  for (const std::string_view rule : suspicion.rules) rules += (rules.empty() ? "" : ", ") + std::string(rule);
  for (const Doubt& each : doubts_) {
    const bool same = std::find(suspicion.rules.begin(), suspicion.rules.end(), each.rule) != suspicion.rules.end();
    if (!same && (each.rule != "magnitude" || !(each.column == suspicion.column))) continue;
    if (!same) rules += ", magnitude";
    impossible |= each.severity == text::Severity::error;
  }
  const text::Severity severity = impossible ? text::Severity::error : text::Severity::warning;
  if (diagnostics.only_counted(severity, table_.files()[table_.file(row_)].text.get())) return;
  std::string message = fmt::format("{}: {} {} is {}, the row's other figures suggest {} to {}",
                                    text::printable(table_.part_number(row_), 60),
                                    declared.name,
                                    shown(suspicion.value, declared),
                                    times(suspicion.factor),
                                    scalar::format_number(suspicion.expected_low, 3),
                                    shown(suspicion.expected_high, declared, 3));
  std::string hint;
  if (suspicion.swapped) {
    hint = fmt::format("swapped with {}? ", declaration(*suspicion.swapped).name);
  } else if (!suspicion.cause.empty()) {
    hint = std::string(suspicion.cause) + "? ";
  }
  if (suspicion.instead) hint += fmt::format("or else {} is wrong; ", declaration(*suspicion.instead).name);
  hint += fmt::format("{}; certainty {:.0f} %", suspicion.evidence, std::min(99.0, 100.0 * suspicion.certainty));
  text::Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.where = table_.where(row_, suspicion.column);
  diagnostic.message = fmt::format("{} [{}]", message, rules);
  diagnostic.hint = std::move(hint);
  diagnostics.add(std::move(diagnostic));
}

void LintRow::conclude(const Plausibility& plausibility, text::Diagnostics& diagnostics) const {
  const std::optional<Suspicion> found = suspicion(plausibility);
  if (!found) return conclude(diagnostics);
  tell(*found, diagnostics);
  std::erase_if(doubts_, [&](const Doubt& each) {
    return std::find(found->rules.begin(), found->rules.end(), each.rule) != found->rules.end() ||
           (each.rule == "magnitude" && each.column == found->column);
  });
  conclude(diagnostics);
}

void LintRow::conclude(text::Diagnostics& diagnostics) const {
  for (Doubt& each : doubts_) {
    if (diagnostics.only_counted(each.severity, table_.files()[table_.file(row_)].text.get())) continue;
    text::Diagnostic diagnostic;
    diagnostic.severity = each.severity;
    diagnostic.where = table_.where(row_, each.column);
    diagnostic.message =
        fmt::format("{}: {} [{}]", text::printable(table_.part_number(row_), 60), each.message, each.rule);
    diagnostic.hint = std::move(each.hint);
    diagnostics.add(std::move(diagnostic));
  }
  doubts_.clear();
}

}  // namespace millwright::catalogue
