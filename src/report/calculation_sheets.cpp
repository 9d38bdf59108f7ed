// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "report/design_text.h"
#include "report/html.h"
#include "report/page_parts.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;
using evaluation::ElementWorksheet;

namespace {

std::string given_html(const ElementWorksheet& sheet, const MathPrinter& printer, const Texts& t) {
  std::string out;
  for (const evaluation::GivenFigure& figure : sheet.given) {
    if (!printer.uses(figure.symbol)) continue;
    out += fmt::format("<div><math><mrow>{}<mo>=</mo>{}</mrow></math> <span>{}</span></div>\n",
                       symbol_mathml(figure.symbol),
                       quantity_mathml(figure.value, scalar::Unit::of(figure.unit), 5),
                       escaped((figure.axis.empty() ? "" : figure.axis + ": ") + t.said(figure.meaning)));
  }
  return out.empty() ? out : "<h5>" + escaped(t("sheet.given")) + "</h5>\n<div class=\"given\">\n" + out + "</div>\n";
}

std::string shared_html(const MathPrinter& printer, const Texts& t) {
  std::string out;
  for (const MathLine& line : printer.shared()) out += math_line(line);
  return out.empty() ? out : "<h5>" + escaped(t("sheet.shared")) + "</h5>\n<div class=\"lines\">\n" + out + "</div>\n";
}

/// The lines of one side of a check; the last one begins with what the side is called.
std::string side_html(const MathPrinter& printer, std::size_t result, const std::string& lead) {
  std::string out;
  std::vector<MathLine> lines = printer.lines(result);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) out += math_line(lines[i]);
  lines.back().symbol = lead;
  if (lines.back().expression == lead) lines.back().expression.clear();
  return out + math_line(lines.back(), true);
}

std::string check_html(const Check& check, const MathPrinter& printer, std::size_t index, const Texts& t) {
  std::string out =
      fmt::format("<article class=\"calculation\" id=\"{}\">\n<h6><b>{}</b> {}</h6>\n<div class=\"lines\">\n",
                  calculation_id(check),
                  escaped(check.id),
                  escaped(t.said(check.title)));
  out += side_html(printer, 2 * index, symbol_mathml(check.symbol));
  out += side_html(printer, 2 * index + 1, "<mtext>" + escaped(t("sheet.limit")) + "</mtext>");
  out += "</div>\n<p class=\"verdict\">" + utilisation_bar(check) + " " +
         fmt::format("<b>{}</b> ", escaped(utilisation_text(check))) + verdict_mark(check, t);
  const auto remark = [&](const std::string& label, const std::string& text) {
    if (!text.empty()) out += fmt::format(" <span class=\"remark\">{}: {}</span>", escaped(label), escaped(text));
  };
  remark(t("sheet.worst"), t.worst(worst_text(check)));
  remark(t("sheet.set_by"), check.requirement);
  remark(t("sheet.source"), check.source);
  remark(t("sheet.note"), t.said(check.note));
  return out + "</p>\n</article>\n";
}

/// What moves and other calculations start from; `first` is the number of the first of their results.
std::string derived_html(const ElementWorksheet& sheet, const MathPrinter& printer, std::size_t first, const Texts& t) {
  std::string out;
  for (const evaluation::DerivedFigure& figure : sheet.derived) {
    const std::string move = figure.move.starts_with("move ") ? t.said(figure.move) : figure.move;
    out += fmt::format("<article class=\"calculation\">\n<h6>{}{}</h6>\n<div class=\"lines\">\n{}</div>\n</article>\n",
                       move.empty() ? move : "<b>" + escaped(move) + "</b> ",
                       escaped(t.said(figure.title)),
                       side_html(printer, first++, symbol_mathml(figure.symbol)));
  }
  return out.empty() ? out : "<h5>" + escaped(t("sheet.derived")) + "</h5>\n" + out;
}

std::string sheet_html(const ElementWorksheet& sheet, const std::vector<const Check*>& checks, const Texts& t) {
  MathPrinter printer;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    printer.add(sheet.checks[i].demand, checks[i]->value, checks[i]->unit);
    printer.add(sheet.checks[i].capacity, checks[i]->limit, checks[i]->unit);
  }
  for (const evaluation::DerivedFigure& figure : sheet.derived)
    printer.add(figure.value, scalar::Unit::of(figure.unit).from_si(figure.value.value), figure.unit);
  std::string out = fmt::format("<details class=\"sheet\" open id=\"sheet-{}-{}\">\n<summary>{}</summary>\n",
                                identifier(sheet.axis),
                                identifier(sheet.element),
                                escaped(fmt::format(fmt::runtime(t("sheet.element")), t.slot(sheet.element))));
  out += given_html(sheet, printer, t) + shared_html(printer, t);
  out += "<h5>" + escaped(t("sheet.checks")) + "</h5>\n";
  for (std::size_t i = 0; i < checks.size(); ++i) out += check_html(*checks[i], printer, i, t);
  return out + derived_html(sheet, printer, 2 * checks.size(), t) + "</details>\n";
}

}  // namespace

std::string calculation_sheets(const Design& design, const std::string& axis, const Texts& t) {
  if (design.worksheet == nullptr) return {};
  std::string out;
  for (const ElementWorksheet& sheet : design.worksheet->elements) {
    if (sheet.axis != axis) continue;
    std::vector<const Check*> checks;
    for (const Check& check : design.checks)
      if (check.axis == sheet.axis && check.element == sheet.element) checks.push_back(&check);
    if (!checks.empty() && checks.size() == sheet.checks.size()) out += sheet_html(sheet, checks, t);
  }
  return out;
}

}  // namespace millwright::report
