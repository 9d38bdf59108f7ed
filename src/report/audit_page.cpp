// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "report/html.h"
#include "report/page.h"
#include "report/page_parts.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::AuditReport;
using evaluation::AuditRow;
using evaluation::AuditVerdict;

namespace {

const char* state(AuditVerdict verdict) {
  switch (verdict) {
    case AuditVerdict::agrees:
    case AuditVerdict::rounding:
      return "good";
    case AuditVerdict::unit:
      return "near";
    case AuditVerdict::differs:
      return "bad";
    case AuditVerdict::missing_input:
      return "open";
  }
  return "";
}

std::string mark(AuditVerdict verdict) {
  return fmt::format("<span class=\"mark {}\">{}</span>", state(verdict), to_string(verdict));
}

std::string page_number(const std::optional<double>& value) {
  return value ? scalar::format_number(*value, 6) : std::string("–");
}

std::string computed_on_page(const AuditRow& row) {
  const std::string unit = shown_unit(row.unit);
  return page_number(row.computed) + (row.computed && !unit.empty() ? " " + unit : "");
}

std::string remark_cell(const std::string& text) {
  return text.empty() ? std::string() : "<small>" + escaped(text) + "</small>";
}

std::string row_id(const AuditRow& row) { return "row-" + identifier(row.id); }

std::string counts_html(const AuditReport& report, const Texts& t) {
  std::string bar;
  std::string legend;
  for (const AuditVerdict verdict : {AuditVerdict::agrees,
                                     AuditVerdict::rounding,
                                     AuditVerdict::unit,
                                     AuditVerdict::differs,
                                     AuditVerdict::missing_input}) {
    const int count = report.count(verdict);
    if (count > 0)
      bar += fmt::format("<i class=\"{} v-{}\" style=\"width:{:.2f}%\"></i>",
                         state(verdict),
                         to_string(verdict),
                         100.0 * count / static_cast<double>(report.rows.size()));
    legend += fmt::format("<li><i class=\"{0} v-{1}\"></i>{1} <b>{2}</b> <small>{3}</small></li>",
                          state(verdict),
                          to_string(verdict),
                          count,
                          escaped(t(fmt::format("audit.{}", to_string(verdict)))));
  }
  return "<div class=\"stack\">" + bar + "</div>\n<ul class=\"legend\">" + legend + "</ul>\n";
}

std::string derivation_html(const AuditRow& row, const Texts& t) {
  std::string out = fmt::format(
      "<article class=\"calculation\" id=\"{}\">\n<h6><b>{}</b> {} <code>{}</code></h6>\n<div class=\"lines\">\n",
      row_id(row),
      escaped(row.id),
      escaped(row.quantity),
      escaped(row.formula));
  MathPrinter printer;
  for (const evaluation::AuditTrace& trace : row.traces)
    printer.add(trace.value, trace.unit.from_si(trace.value.value), trace.unit.name());
  for (const MathLine& line : printer.shared()) out += math_line(line);
  for (std::size_t i = 0; i < row.traces.size(); ++i) {
    std::vector<MathLine> lines = printer.lines(i);
    lines.back().symbol = symbol_mathml(row.traces[i].symbol);
    for (const MathLine& line : lines) out += math_line(line, &line == &lines.back());
  }
  out += "</div>\n<p class=\"verdict\">" + mark(row.verdict);
  const auto remark = [&](const std::string& label, const std::string& text) {
    if (!text.empty()) out += fmt::format(" <span class=\"remark\">{}: {}</span>", escaped(label), escaped(text));
  };
  remark(t("audit.printed"), row.printed_text);
  remark(t("audit.computed"), computed_on_page(row));
  remark(t("audit.missing"), row.missing);
  remark(t("audit.factor"), row.factor_name);
  for (const std::string& violation : row.violations) remark(t("outside"), violation);
  return out + "</p>\n</article>\n";
}

}  // namespace

std::string audit_page(const AuditReport& report, const std::string& file, const std::string& json, Language language) {
  const Texts t(language);
  std::string body =
      fmt::format("<header>\n<p class=\"kind\">{}</p>\n<h1>{}</h1>\n<p class=\"file\">{} · {}</p>\n</header>\n<main>\n",
                  escaped(t("kind.audit")),
                  escaped(report.title),
                  escaped(file),
                  escaped(report.source));
  HtmlTable table("<<<>>><<",
                  {t("axis"),
                   "id",
                   t("audit.quantity"),
                   t("audit.printed"),
                   t("audit.computed"),
                   t("audit.ratio"),
                   t("audit.verdict"),
                   ""},
                  "stacked");
  for (const AuditRow& row : report.rows)
    table.add({escaped(row.axis),
               fmt::format("<a href=\"#{}\">{}</a>", row_id(row), escaped(row.id)),
               escaped(row.quantity),
               escaped(row.printed_text),
               escaped(computed_on_page(row)),
               page_number(row.ratio),
               mark(row.verdict),
               remark_cell(row.missing.empty() ? row.factor_name : row.missing)});
  body += section("summary",
                  t("summary"),
                  "<p>" + escaped(fmt::format(fmt::runtime(t("audit.count")), report.rows.size())) + "</p>\n" +
                      counts_html(report, t));
  body += section("results", t("audit.results"), table.str());
  std::string sheets;
  for (const AuditRow& row : report.rows) sheets += derivation_html(row, t);
  body += section("sheet", t("sheet"), sheets);
  body += "</main>\n" + footer({}, t);
  return document(report.title + " – Millwright", body, Json{{"language", code(language)}}, json, t);
}

}  // namespace millwright::report
