// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/design_text.h"
#include "report/html.h"
#include "report/page_parts.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Contribution;
using evaluation::Design;
using evaluation::DriveDrawing;

namespace {

const DriveDrawing* drawing_of(const Design& design, const std::string& axis) {
  if (design.worksheet == nullptr) return nullptr;
  for (const DriveDrawing& drawing : design.worksheet->drives)
    if (drawing.axis == axis) return &drawing;
  return nullptr;
}

/// A frame that the script fills.
std::string chart_frame(const std::string& kind, const std::string& axis, const std::string& title) {
  return fmt::format(
      "<figure class=\"chart\" data-chart=\"{}\" data-axis=\"{}\"><figcaption>{}</figcaption></figure>\n",
      kind,
      escaped(axis),
      escaped(title));
}

/// Parts of a sum as one bar, with its legend. `limit`: where it is marked, NaN = nowhere.
std::string stacked_bar(
    const std::vector<Contribution>& parts, double total, double limit, const std::string& unit, const Texts& t) {
  double sum = 0.0;
  for (const Contribution& part : parts) sum += std::max(part.value, 0.0);
  const double full = std::max({sum, total, std::isnan(limit) ? 0.0 : limit}) * 1.02;
  if (!(full > 0.0)) return {};
  std::string bar;
  std::string legend;
  std::size_t index = 0;
  for (const Contribution& part : parts) {
    const std::string colour = fmt::format("c{}", index++ % 8);
    const std::string value = shown_quantity(part.value, unit, 3);
    if (part.value > 0.0)
      bar += fmt::format("<i class=\"{}\" style=\"width:{:.2f}%\" title=\"{}: {}\"></i>",
                         colour,
                         100.0 * part.value / full,
                         escaped(t.said(part.what)),
                         escaped(value));
    legend +=
        fmt::format("<li><i class=\"{}\"></i>{} <b>{}</b></li>", colour, escaped(t.said(part.what)), escaped(value));
  }
  if (!std::isnan(limit))
    bar += fmt::format("<em style=\"left:{:.2f}%\"><span>{} {}</span></em>",
                       100.0 * limit / full,
                       escaped(t("check.limit")),
                       escaped(shown_quantity(limit, unit, 4)));
  return "<div class=\"stack\">" + bar + "</div>\n<ul class=\"legend\">" + legend + "</ul>\n";
}

std::string budgets(const Design& design, const std::string& axis, const Texts& t) {
  std::string out;
  for (const Check& check : design.checks) {
    if (check.axis != axis || check.contributions.empty()) continue;
    out += fmt::format("<div><h4>{}: {} {}</h4>\n",
                       escaped(t("axis.errors")),
                       escaped(shown_quantity(check.value, check.unit)),
                       verdict_mark(check, t));
    out += stacked_bar(check.contributions, check.value, check.limit, check.unit, t) + "</div>\n";
  }
  const DriveDrawing* drawing = drawing_of(design, axis);
  if (drawing != nullptr && !drawing->compliance.empty()) {
    double sum = 0.0;
    for (const Contribution& part : drawing->compliance) sum += part.value;
    out += fmt::format("<div><h4>{}: {} ({})</h4>\n",
                       escaped(t("axis.stiffness")),
                       escaped(shown_quantity(1e3 / sum, "N/um", 3)),
                       escaped(shown_quantity(sum, "um/kN", 3)));
    out += stacked_bar(drawing->compliance, sum, std::nan(""), "um/kN", t) + "</div>\n";
  }
  return out.empty() ? out : "<div class=\"budgets\">\n" + out + "</div>\n";
}

std::string checks_table(const Design& design, const std::string& axis, const Texts& t) {
  HtmlTable table("<<>>><<",
                  {t("check.id"), t("check"), t("check.value"), t("check.limit"), t("check.unit"), t("check.used"), ""},
                  "checks verdicts of-axis");
  for (const Check* check : checks_of(design, axis)) {
    std::string title = escaped(t.said(check->title));
    if (const std::string element = element_named(design, *check); !element.empty())
      title += " (" + escaped(element) + ")";
    if (!worst_text(*check).empty()) title += "<small>" + escaped(t.worst(worst_text(*check))) + "</small>";
    if (!check->note.empty()) title += "<small class=\"note\">" + escaped(t.said(check->note)) + "</small>";
    const auto number = [](double value) {
      return std::isnan(value) ? std::string("–") : escaped(scalar::format_number(value, 4));
    };
    table.add(
        {fmt::format("<a href=\"#{}\">{}</a>{}",
                     calculation_id(*check),
                     escaped(check->id),
                     check->kind == machine::ConstraintKind::soft ? "*" : ""),
         title,
         number(check->value),
         number(check->limit),
         escaped(shown_unit(check->unit)),
         utilisation_bar(*check) + fmt::format("<span class=\"pct\">{}</span>", escaped(utilisation_text(*check))),
         verdict_mark(*check, t)});
  }
  return "<h3>" + escaped(t("axis.checks")) + "</h3>\n" + table.str() + "<p class=\"hint\">" + escaped(t("axis.soft")) +
         "</p>\n";
}

Json motion_of(const DriveDrawing& drawing) {
  Json points = Json::array();
  const double scale = drawing.rotary ? 180.0 / 3.14159265358979323846 : 1e3;
  for (const evaluation::MotionPoint& point : drawing.motion)
    points.push_back({number(point.time), number(scale * point.speed), number(scale * point.position)});
  return points;
}

}  // namespace

std::string axis_sections(const MachineResult& result, const Design& design, const Texts& t) {
  std::string out;
  for (const std::string& axis : checked_axes(result)) {
    std::string content;
    if (const DriveDrawing* drawing = drawing_of(design, axis)) {
      content += "<div class=\"charts\">\n";
      if (drawing->motion.size() > 1)
        content +=
            chart_frame("motion", axis, t("axis.motion") + (drawing->dwells_shortened ? "; " + t("axis.dwells") : ""));
      content += chart_frame(
          "torque",
          axis,
          t(drawing->torque_is_estimate ? "axis.torque_estimate" : "axis.torque") + "; " + t("axis.hollow"));
      content += "</div>\n";
    }
    content += checks_table(design, axis, t) + budgets(design, axis, t);
    const std::string sheets = calculation_sheets(design, axis, t);
    if (!sheets.empty())
      content += "<div class=\"sheets\">\n<h3>" + escaped(t("sheet")) + "</h3>\n" + sheets + "</div>\n";
    out += section("axis-" + identifier(axis),
                   axis == "machine" ? t("axis.whole") : fmt::format(fmt::runtime(t("axis.title")), axis),
                   content);
  }
  return out;
}

Json axis_charts(const MachineResult&, const Design& design, const Texts& t) {
  Json axes = Json::array();
  if (design.worksheet == nullptr) return axes;
  for (const DriveDrawing& drawing : design.worksheet->drives) {
    Json phases = Json::array();
    const auto rpm = scalar::Unit::of("rpm");
    for (const evaluation::DrivePhase& phase : drawing.phases)
      phases.push_back({{"name", t.worst(phase.name)},
                        {"rpm", number(rpm.from_si(phase.motor_speed))},
                        {"torque", number(phase.motor_torque)},
                        {"ratio", number(phase.torque_ratio)},
                        {"governs", phase.may_govern}});
    Json curve = Json::array();
    for (const auto& [speed, torque] : drawing.pull_out) curve.push_back({number(rpm.from_si(speed)), number(torque)});
    axes.push_back({{"axis", drawing.axis},
                    {"length_unit", drawing.rotary ? "°" : "mm"},
                    {"motion", motion_of(drawing)},
                    {"phases", phases},
                    {"pull_out", curve},
                    {"margin", number(drawing.torque_margin)},
                    {"estimate", drawing.torque_is_estimate}});
  }
  Json words = Json::object();
  for (const char* key : {"chart.time",
                          "chart.speed",
                          "chart.position",
                          "chart.motor_speed",
                          "chart.torque",
                          "chart.pull_out",
                          "chart.permitted",
                          "chart.phase"})
    words[key] = t(key);
  return {{"drives", axes}, {"words", words}};
}

}  // namespace millwright::report
