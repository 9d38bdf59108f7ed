// SPDX-License-Identifier: Apache-2.0
#include "report/page_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "report/design_text.h"
#include "report/html.h"
#include "report/order_list.h"
#include "report/page_assets.h"
#include "report/version.h"
#include "text/utf8.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Verdict;
using machine::ConstraintKind;

namespace {

/// A text as a string of CSS: whatever is no letter or digit, by its number.
std::string css_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ' ' || c == '.' || c == ',' ||
                       c == '-' || static_cast<unsigned char>(c) >= 0x80;
    if (plain)
      out += c;
    else
      out += fmt::format("\\{:06x}", static_cast<unsigned char>(c));
  }
  return out + "\"";
}

/// What stands below every printed page.
std::string page_margins(const std::string& title, const Texts& t) {
  return fmt::format(
      "@page {{ @bottom-left {{ content: {}; }} @bottom-right {{ content: {} \" \" counter(page) \" / \" "
      "counter(pages); }} }}\n",
      css_string(text::printable(fmt::format("{}, {}", title, program_version), 100)),
      css_string(t("footer.page")));
}

}  // namespace

std::string footer(const std::vector<const evaluation::Design*>& designs, const Texts& t) {
  std::set<std::string> dates;
  for (const evaluation::Design* design : designs)
    for (const evaluation::PartLine& part : design->parts)
      if (std::string date = price_date(part.price_basis); !date.empty()) dates.insert(std::move(date));
  std::string words = fmt::format(fmt::runtime(t("footer")), program_version);
  if (!dates.empty())
    words += " " + fmt::format(fmt::runtime(t("footer.prices")), fmt::format("{}", fmt::join(dates, ", ")));
  return "<footer>" + escaped(words) + "</footer>\n";
}

std::string document(
    const std::string& title, const std::string& body, const Json& charts, const std::string& json, const Texts& t) {
  const auto data = [](const Json& value) {
    return json_in_script(value.dump(-1, ' ', false, Json::error_handler_t::replace));
  };
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src 'unsafe-inline'; img-src data:\">\n"
      "<meta name=\"generator\" content=\"Millwright\">\n<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n",
      code(t.language()),
      escaped(title),
      page_style() + page_margins(title, t));
  out += body;
  out += "<script type=\"application/json\" id=\"charts\">" + data(charts) + "</script>\n";
  out += "<script type=\"application/json\" id=\"result\">" + data(Json::parse(json)) + "</script>\n";
  out += "<script>\n" + page_script() + "</script>\n</body>\n</html>\n";
  return out;
}

std::string section(std::string_view id, const std::string& heading, const std::string& content) {
  if (content.empty()) return {};
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, escaped(heading), content);
}

namespace {

/// "Cost <small>USD</small>" as "Cost USD".
std::string without_tags(std::string_view html) {
  std::string text;
  bool inside = false;
  for (const char c : html) {
    if (c == '<') inside = true;
    if (!inside) text += c;
    if (c == '>') inside = false;
  }
  return text;
}

}  // namespace

HtmlTable::HtmlTable(std::string_view alignment, const std::vector<std::string>& headings, std::string_view css_class)
    : alignment_(alignment), css_class_(css_class) {
  for (const std::string& heading : headings) labels_.push_back(without_tags(heading));
  for (std::size_t i = 0; i < headings.size(); ++i)
    head_ += fmt::format("<th{}>{}</th>", alignment_[i] == '>' ? " class=\"n\"" : "", headings[i]);
}

void HtmlTable::add(const std::vector<std::string>& cells, std::string_view row_class, std::string_view id) {
  rows_ += "<tr";
  if (!row_class.empty()) rows_ += fmt::format(" class=\"{}\"", row_class);
  if (!id.empty()) rows_ += fmt::format(" id=\"{}\"", id);
  rows_ += ">";
  // Stacked on a narrow screen, cells stand below each other and say what they are.
  const bool stacked = css_class_.find("stacked") != std::string::npos;
  for (std::size_t i = 0; i < cells.size(); ++i)
    rows_ += fmt::format("<td{}{}>{}</td>",
                         alignment_[i] == '>' ? " class=\"n\"" : "",
                         stacked && i > 0 && !labels_[i].empty() ? " data-label=\"" + labels_[i] + "\"" : "",
                         cells[i]);
  rows_ += "</tr>\n";
}

std::string HtmlTable::str() const {
  if (rows_.empty()) return {};
  return fmt::format("<table{}>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table>\n",
                     css_class_.empty() ? "" : " class=\"" + css_class_ + "\"",
                     head_,
                     rows_);
}

namespace {

bool breaks_design(const Check& check) {
  return check.verdict == Verdict::violated && check.kind != ConstraintKind::soft;
}

}  // namespace

const char* state_of(const Check& check) {
  constexpr double near_limit = 0.9;
  if (check.verdict == Verdict::not_evaluated || std::isnan(check.utilisation)) return "open";
  if (breaks_design(check)) return "bad";
  if (check.verdict == Verdict::violated) return "over";
  return check.utilisation > near_limit ? "near" : "good";
}

std::string verdict_word(const Check& check, const Texts& t) {
  return t(check.verdict == Verdict::satisfied       ? "verdict.ok"
           : check.verdict == Verdict::not_evaluated ? "verdict.open"
           : breaks_design(check)                    ? "verdict.fail"
                                                     : "verdict.over");
}

std::string utilisation_bar(const Check& check) {
  constexpr double full = 1.25;  // utilisation at the end of the bar
  const double share = std::isnan(check.utilisation) ? 0.0 : std::clamp(check.utilisation / full, 0.0, 1.0);
  return fmt::format("<span class=\"bar {}\"><i style=\"width:{:.1f}%\"></i></span>", state_of(check), 100.0 * share);
}

std::string verdict_mark(const Check& check, const Texts& t) {
  const std::string_view css = check.verdict == Verdict::satisfied ? "good" : state_of(check);
  return fmt::format("<span class=\"mark {}\">{}</span>", css, escaped(verdict_word(check, t)));
}

std::string calculation_id(const Check& check) {
  return "calc-" + identifier(check.axis) + "-" + identifier(check.element) + "-" + identifier(check.id);
}

std::string math_line(const MathLine& line, bool result) {
  const auto math = [](const std::string& inner) { return "<math displaystyle=\"true\">" + inner + "</math>"; };
  std::string out = result ? "<div class=\"line result\">" : "<div class=\"line\">";
  if (!line.symbol.empty()) out += "<span class=\"lhs\">" + math(line.symbol) + "</span>";
  const std::string equals = "<mo>=</mo>";
  bool first = true;
  for (const std::string* piece : {&line.expression, &line.substituted, &line.value}) {
    if (piece->empty() || (piece == &line.value && *piece == line.expression)) continue;
    out += fmt::format("<span class=\"{}\">{}</span>",
                       piece == &line.value ? "value"
                       : first              ? "first"
                                            : "next",
                       math("<mrow>" + equals + *piece + "</mrow>"));
    first = false;
  }
  return out + "</div>\n";
}

}  // namespace millwright::report
