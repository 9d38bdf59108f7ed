// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/alternatives.h"
#include "report/design_text.h"
#include "report/html.h"
#include "report/incomplete.h"
#include "report/machine_text.h"
#include "report/page.h"
#include "report/page_parts.h"
#include "report/steering.h"
#include "report/tolerance_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;
using evaluation::Verdict;

namespace {

bool is_failure(const Check& check) {
  return check.verdict == Verdict::violated && check.kind != machine::ConstraintKind::soft;
}

std::string value_cell(double value, const std::string& unit) { return escaped(shown_quantity(value, unit)); }

/// What is known of what a bill of materials leaves open, where that is not all.
std::string completion_words(const MachineResult& result, const Texts& t) {
  switch (result.completion) {
    case evaluation::Completion::best:
      return {};
    case evaluation::Completion::compliant:
      return result.completed ? " " + std::string(t("banner.completion_ended")) : std::string();
    case evaluation::Completion::refuted:
      return result.completed ? " " + std::string(t("banner.completion_refuted")) : std::string();
    case evaluation::Completion::open:
      break;
  }
  return " " + std::string(t("banner.completion_open"));
}

/// What one reads first.
std::string verdict_banner(const MachineResult& result, PageKind kind, const Texts& t) {
  const auto banner = [](const char* state, const std::string& text) {
    return fmt::format("<p class=\"banner {}\">{}</p>\n", state, escaped(text));
  };
  if (result.designs.empty())
    return result.status == Status::limit ? banner("near", t("banner.limit_none")) : banner("bad", t("banner.none"));
  const Design& design = result.designs.front();
  if (kind == PageKind::check) {
    const auto failed = std::count_if(design.checks.begin(), design.checks.end(), is_failure);
    const std::string rest = completion_words(result, t);
    return failed == 0
               ? banner("good", std::string(t("banner.satisfied")) + rest)
               : banner("bad", fmt::format(fmt::runtime(t("banner.failed")), failed, design.checks.size()) + rest);
  }
  const auto fill = [&](const char* key, auto&&... values) { return fmt::format(fmt::runtime(t(key)), values...); };
  // What is said to be best is so as builds were compared.
  const std::string compared =
      preference_counts(result) ? " " + fill("certificate.preferred", preference_divisor(result)) : std::string();
  if (kind == PageKind::pareto) {
    const bool open = result.status == Status::limit;
    return banner(open ? "near" : "good",
                  fill(open ? "banner.front_open" : "banner.front", result.designs.size()) + compared);
  }
  const bool proved = best_is_proved(result);
  return banner(proved ? "good" : "near",
                t(!proved                       ? "banner.best_so_far"
                  : robust_to_something(result) ? "banner.proved_robust"
                                                : "banner.proved") +
                    (proof_gap(result) ? " " + fill("banner.within", *proof_gap(result)) : "") + compared);
}

std::string totals_html(const Design& design, const Texts& t) {
  std::string out = "<dl class=\"totals\">\n";
  const auto add = [&](const std::string& label, const std::string& value) {
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(label), escaped(value));
  };
  for (const machine::QuantityDeclaration& each : machine::quantities()) {
    const double value = design.total(each.quantity);
    if (!std::isnan(value))
      add(t("quantity." + std::string(each.name)), quantity_text(each.quantity, value, design.currency));
  }
  add(t("summary.voltage"), scalar::format(design.supply_voltage, scalar::Unit::of("V")));
  return out + "</dl>\n";
}

/// Axis, check, value, limit and use: of a check in a table of the summary; its last cell is left to the caller.
std::vector<std::string> check_cells(
    const Design& design, const std::string& axis, const Check& check, std::string last, const Texts& t) {
  const std::string element = element_named(design, check);
  return {escaped(t.axis(axis)),
          fmt::format("<a href=\"#{}\">{}</a>", calculation_id(check), escaped(check.id)),
          escaped(t.said(check.title)) + (element.empty() ? "" : " (" + escaped(element) + ")"),
          value_cell(check.value, check.unit),
          value_cell(check.limit, check.unit),
          utilisation_bar(check) + fmt::format("<span class=\"pct\">{}</span>", escaped(utilisation_text(check))),
          std::move(last)};
}

HtmlTable check_table(const std::string& last, std::string_view css_class, const Texts& t) {
  return {"<<<>><<",
          {t("axis"), t("check.id"), t("check"), t("check.value"), t("check.limit"), t("check.used"), last},
          css_class};
}

std::string governing_table(const MachineResult& result, const Design& design, const Texts& t) {
  HtmlTable table = check_table("", "checks verdicts", t);
  for (const std::string& axis : checked_axes(result))
    if (const Check* check = design.governing(axis))
      table.add(check_cells(design, axis, *check, verdict_mark(*check, t), t));
  return table.empty() ? std::string() : "<h3>" + escaped(t("summary.governing")) + "</h3>\n" + table.str();
}

std::string failures_table(const MachineResult& result, const Design& design, const Texts& t) {
  HtmlTable table = check_table(t("check.worst"), "checks", t);
  for (const std::string& axis : checked_axes(result))
    for (const Check* check : checks_of(design, axis))
      if (is_failure(*check)) table.add(check_cells(design, axis, *check, escaped(t.worst(worst_text(*check))), t));
  return table.empty() ? std::string() : "<h3>" + escaped(t("summary.failures")) + "</h3>\n" + table.str();
}

std::string asked_for(const MachineResult& result, const Texts& t) {
  const std::string text = steering_text(result, Style{});
  const std::size_t line = text.find('\n');
  if (line == std::string::npos) return {};
  return "<h3>" + escaped(t("summary.asked")) + "</h3>\n<pre>" + escaped(text.substr(line + 1)) + "</pre>\n";
}

std::string alternatives_html(const MachineResult& result, const Texts& t) {
  const std::string text = alternatives_text(result, Style{});
  const std::size_t line = text.find('\n');
  if (line == std::string::npos) return {};
  return section("alternatives", t("alternatives"), "<pre>" + escaped(text.substr(line + 1)) + "</pre>\n");
}

std::string tolerances_html(const MachineResult& result, const Design& design, const Texts& t) {
  const std::string text = tolerances_text(result, design, Style{}, t);
  const std::size_t line = text.find('\n');
  if (line == std::string::npos) return {};
  return section("tolerances", t("tolerances"), "<pre>" + escaped(text.substr(line + 1)) + "</pre>\n");
}

std::string settings_table(const Design& design, const Texts& t) {
  HtmlTable table("<<>", {t("axis"), t("settings.name"), t("check.value")});
  for (const evaluation::DimensionLine& line : design.dimensions)
    table.add({escaped(t.axis(line.axis)),
               escaped(line.name),
               value_cell(scalar::Unit::of(line.unit == "m" ? "mm" : line.unit).from_si(line.value),
                          line.unit == "m" ? "mm" : line.unit)});
  return table.str();
}

std::string navigation(const MachineResult& result, PageKind kind, const Texts& t) {
  std::string out = "<nav>";
  const auto link = [&](const std::string& id, const std::string& words) {
    out += fmt::format("<a href=\"#{}\">{}</a> ", id, escaped(words));
  };
  link("summary", t("summary"));
  if (kind == PageKind::pareto && !result.designs.empty()) link("front", t("front"));
  if (kind != PageKind::pareto && !result.designs.empty()) {
    link("machine", t("drawing.title"));
    link("parts", t("parts"));
    for (const std::string& axis : checked_axes(result)) link("axis-" + identifier(axis), t.axis(axis));
    link("requirements", t("requirements"));
  }
  if (kind != PageKind::check) link("certificate", t("certificate"));
  return out + "</nav>\n";
}

std::vector<const Design*> designs_of(const MachineResult& result) {
  std::vector<const Design*> designs;
  for (const Design& design : result.designs) designs.push_back(&design);
  return designs;
}

std::string heading(const MachineResult& result, PageKind kind, const Texts& t) {
  const std::string title = result.title.empty() ? result.file : result.title;
  const std::string_view what = kind == PageKind::solve   ? "kind.solve"
                                : kind == PageKind::check ? "kind.check"
                                                          : "kind.pareto";
  std::string files = result.file;
  if (!result.bom_file.empty()) files += " · " + result.bom_file;
  return fmt::format("<header>\n<p class=\"kind\">{}</p>\n<h1>{}</h1>\n<p class=\"file\">{}</p>\n</header>\n",
                     escaped(t(what)),
                     escaped(title),
                     escaped(files));
}

}  // namespace

std::string machine_page(const MachineResult& result,
                         const machine::Problem& problem,
                         PageKind kind,
                         const std::string& json,
                         Language language) {
  const Texts t(language);
  std::string body = heading(result, kind, t) + navigation(result, kind, t) + "<main>\n";
  std::string summary = verdict_banner(result, kind, t);
  Json charts{{"language", code(language)}};
  if (result.designs.empty()) {
    body += section("summary", t("summary"), summary + asked_for(result, t) + nothing_section(result, t));
  } else if (kind == PageKind::pareto) {
    body += section("summary", t("summary"), summary + asked_for(result, t)) + front_section(result, t);
    charts["front"] = front_chart(result, t);
    body += basis_sections(result, result.designs.front(), t);
  } else {
    const Design& design = result.designs.front();
    summary += totals_html(design, t) + asked_for(result, t) + failures_table(result, design, t) +
               governing_table(result, design, t);
    body += section("summary", t("summary"), summary);
    body += section("machine", t("drawing.title"), machine_drawing(problem, design, t));
    body += section("parts", t("parts"), parts_table(result, design, t));
    body += section("settings", t("settings"), settings_table(design, t));
    body += alternatives_html(result, t) + axis_sections(result, design, t) + tolerances_html(result, design, t) +
            basis_sections(result, design, t);
    charts["axes"] = axis_charts(result, design, t);
  }
  body += catalogues_section(result, t);
  body += kind == PageKind::check ? incomplete_html(result.certificate.incomplete, t) : certificate_section(result, t);
  body += "</main>\n" + footer(designs_of(result), t);
  return document((result.title.empty() ? result.file : result.title) + " – Millwright", body, charts, json, t);
}

}  // namespace millwright::report
