// SPDX-License-Identifier: Apache-2.0
// The front of builds: a chart of two objectives, a table of what changes from build to build, and what the script
// needs to show the sheet of the build that is pointed at. Axes that do not change from build to build are written
// once.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "report/design_difference.h"
#include "report/design_text.h"
#include "report/html.h"
#include "report/machine_text.h"
#include "report/page_parts.h"
#include "report/tolerance_text.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Check;
using evaluation::Design;
using evaluation::PartLine;

namespace {

/// In what a build differs from the one before: "x.motor: 17HS4401S → 17HS3401S".
std::vector<std::string> changes(const Design& before, const Design& now) {
  std::vector<std::string> out;
  for (const DesignDifference& each : differences(before, now))
    out.push_back(fmt::format("{}.{}: {} → {}", each.axis, each.slot, each.before, each.now));
  return out;
}

/// Each different record once.
class Pool {
 public:
  std::size_t index(const Json& record) {
    const auto [found, is_new] =
        known_.try_emplace(record.dump(-1, ' ', false, Json::error_handler_t::replace), known_.size());
    if (is_new) records_.push_back(record);
    return found->second;
  }
  [[nodiscard]] const Json& records() const { return records_; }

 private:
  std::map<std::string, std::size_t> known_;
  Json records_ = Json::array();
};

Json part_record(const PartLine& part, const Texts& t) {
  return {t.axis(part.axis),
          t.slot(part.slot),
          part_name(part),
          scalar::format_number(part.quantity),
          part.length > 0.0 ? shown_millimetres(part.length) : "",
          fmt::format("{}{:.2f}", part.estimate ? "~" : "", part.price),
          part.mass > 0.0 ? fmt::format("{:.3f}", part.mass) : ""};
}

Json check_record(const Check& check, const Texts& t) {
  return {t.axis(check.axis),
          check.id,
          t.said(check.title),
          shown_quantity(check.value, check.unit),
          shown_quantity(check.limit, check.unit),
          number(check.utilisation),
          utilisation_text(check),
          state_of(check),
          verdict_word(check, t)};
}

}  // namespace

std::string front_section(const MachineResult& result, const Texts& t) {
  std::vector<std::string> headings{"#"};
  std::string alignment = ">";
  for (const std::string& objective : result.objectives) {
    headings.push_back(escaped(t("quantity." + objective)) + " <small>" +
                       escaped(shown_unit(objective_unit(objective, result.currency))) + "</small>");
    alignment += '>';
  }
  headings.push_back(escaped(t("front.changes")));
  HtmlTable table(alignment + "<", headings, "front");
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    const Design& design = result.designs[i];
    std::vector<std::string> cells{fmt::format("<a href=\"#build-{0}\">{0}</a>", i + 1)};
    for (const std::string& objective : result.objectives) {
      const std::string value =
          objective_text(objective, design.total(machine::objective_named(objective)), design.currency);
      cells.push_back(escaped(value.substr(0, value.find(' '))));
    }
    std::string change;
    if (i > 0)
      for (const std::string& each : changes(result.designs[i - 1], design))
        change += (change.empty() ? "" : "<br>") + escaped(each);
    cells.push_back(i == 0 ? escaped(t("front.first")) : change.empty() ? escaped(t("front.dimensions")) : change);
    table.add(cells, "", fmt::format("build-{}", i + 1));
  }
  const std::string robust = robust_front_text(result, t);
  std::string hint = t(result.status == Status::limit ? "front.hint_open" : "front.hint");
  if (preference_counts(result))
    hint += " " + fmt::format(fmt::runtime(t("certificate.preferred")), preference_divisor(result));
  return section("front",
                 t("front"),
                 (robust.empty() ? "" : "<p>" + escaped(robust) + "</p>\n") +
                     "<figure class=\"chart wide\" data-chart=\"front\"><figcaption>" + escaped(hint) +
                     "</figcaption></figure>\n<div id=\"build\" class=\"build\" aria-live=\"polite\"></div>\n" +
                     table.str());
}

Json front_chart(const MachineResult& result, const Texts& t) {
  Pool parts;
  Pool checks;
  Json builds = Json::array();
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    const Design& design = result.designs[i];
    Json build{
        {"values", Json::array()}, {"shown", Json::array()}, {"parts", Json::array()}, {"checks", Json::array()}};
    for (const std::string& objective : result.objectives) {
      const machine::Objective of = machine::objective_named(objective);
      build["values"].push_back(number(design.total(of)));
      build["shown"].push_back(objective_text(objective, design.total(of), design.currency));
    }
    for (const PartLine& part : design.parts) build["parts"].push_back(parts.index(part_record(part, t)));
    for (const std::string& axis : checked_axes(result))
      for (const Check* check : checks_of(design, axis))
        build["checks"].push_back(checks.index(check_record(*check, t)));
    build["changes"] = i == 0 ? std::vector<std::string>() : changes(result.designs[i - 1], design);
    builds.push_back(std::move(build));
  }
  Json names = Json::array();
  for (const std::string& objective : result.objectives)
    names.push_back(
        {{"name", t("quantity." + objective)}, {"unit", shown_unit(objective_unit(objective, result.currency))}});
  Json words = Json::object();
  for (const char* key : {"front.build",
                          "front.changes",
                          "front.first",
                          "front.dimensions",
                          "front.previous",
                          "front.next",
                          "axis",
                          "parts",
                          "parts.slot",
                          "parts.part",
                          "parts.quantity",
                          "parts.length",
                          "check",
                          "check.id",
                          "check.value",
                          "check.limit",
                          "check.used",
                          "axis.checks"})
    words[key] = t(key);
  return {{"objectives", names},
          {"currency", result.currency},
          {"builds", builds},
          {"parts", parts.records()},
          {"checks", checks.records()},
          {"words", words}};
}

}  // namespace millwright::report
