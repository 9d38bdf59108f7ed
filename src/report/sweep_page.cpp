// SPDX-License-Identifier: Apache-2.0
// The page of a sweep: what is minimised over the value that was set, and where the cycle time moves too, cost against
// speed. The charts are plain SVG: they print, and need no script.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/design_text.h"
#include "report/html.h"
#include "report/incomplete.h"
#include "report/machine_text.h"
#include "report/page_parts.h"
#include "report/quantity_text.h"
#include "report/steering.h"
#include "report/sweep.h"

namespace millwright::report {

namespace {

struct Mark {
  double x = 0.0, y = 0.0;  ///< y is NaN where there is no build
  bool proved = true;
  std::string title;
};

/// Round numbers in and around a range, about five of them.
struct Ticks {
  double first = 0.0, step = 1.0;
  int count = 0;
  Ticks(double lower, double upper) {
    if (!(upper > lower)) {
      const double room = lower == 0.0 ? 1.0 : 0.05 * std::abs(lower);
      lower -= room;
      upper += room;
    }
    const double rough = (upper - lower) / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    step = 10.0 * power;
    for (const double nice : {5.0, 2.0, 1.0})
      if (nice * power >= rough) step = nice * power;
    first = std::floor(lower / step) * step;
    count = static_cast<int>(std::ceil((upper - first) / step - 1e-9)) + 1;
  }
  [[nodiscard]] double value(int i) const { return first + i * step; }
  [[nodiscard]] double last() const { return value(count - 1); }
};

class Chart {
 public:
  Chart(std::vector<Mark> marks, std::string x_label, std::string y_label)
      : marks_(std::move(marks)),
        x_label_(std::move(x_label)),
        y_label_(std::move(y_label)),
        x_(range(&Mark::x)),
        y_(range(&Mark::y)) {}

  std::string svg() const {
    std::string out = fmt::format(
        "<figure class=\"sweep\"><svg viewBox=\"0 0 {} {}\" width=\"{}\" role=\"img\" aria-label=\"{}\" "
        "style=\"max-width:100%;height:auto;font-size:12px;fill:var(--ink)\">\n",
        width,
        height,
        width,
        escaped(y_label_ + " / " + x_label_));
    for (int i = 0; i < x_.count; ++i) out += vertical(x_.value(i));
    for (int i = 0; i < y_.count; ++i) out += horizontal(y_.value(i));
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                       0.5 * (left + width - right),
                       height - 6,
                       escaped(x_label_));
    out += fmt::format("<text x=\"{}\" y=\"14\">{}</text>\n", 4, escaped(y_label_));
    for (const Mark& mark : marks_) out += point(mark);
    return out + "</svg></figure>\n";
  }

 private:
  static constexpr int width = 760, height = 330, left = 70, right = 24, top = 28, bottom = 44;

  Ticks range(double Mark::*of) const {
    double lower = HUGE_VAL;
    double upper = -HUGE_VAL;
    for (const Mark& mark : marks_) {
      if (std::isnan(mark.*of)) continue;
      lower = std::min(lower, mark.*of);
      upper = std::max(upper, mark.*of);
    }
    return upper < lower ? Ticks(0.0, 1.0) : Ticks(lower, upper);
  }
  double across(double x) const { return left + (x - x_.first) / (x_.last() - x_.first) * (width - left - right); }
  double up(double y) const {
    return height - bottom - (y - y_.first) / (y_.last() - y_.first) * (height - top - bottom);
  }
  std::string vertical(double x) const {
    return fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"var(--rule)\"/>"
        "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:.6g}</text>\n",
        across(x),
        top,
        height - bottom,
        height - bottom + 16,
        x);
  }
  std::string horizontal(double y) const {
    return fmt::format(
        "<line x1=\"{1}\" x2=\"{2}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\" stroke=\"var(--rule)\"/>"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:.6g}</text>\n",
        up(y),
        left,
        width - right,
        left - 6,
        up(y) + 4.0,
        y);
  }
  std::string point(const Mark& mark) const {
    const std::string title = "<title>" + escaped(mark.title) + "</title>";
    if (std::isnan(mark.y)) {
      const double x = across(mark.x);
      const double y = height - bottom - 8.0;
      return fmt::format(
          "<path class=\"none\" d=\"M{:.1f} {:.1f} l8 8 m0 -8 l-8 8\" stroke=\"var(--bad)\" "
          "stroke-width=\"2\">{}</path>\n",
          x - 4.0,
          y - 4.0,
          title);
    }
    return fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\" stroke=\"var(--accent)\" "
        "stroke-width=\"1.5\">{}</circle>\n",
        across(mark.x),
        up(mark.y),
        mark.proved ? "var(--accent)" : "white",
        title);
  }

  std::vector<Mark> marks_;
  std::string x_label_, y_label_;
  Ticks x_, y_;
};

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, shown_unit(unit));
}

std::string objective_name(const std::string& objective, const Texts& t) {
  return machine::objective_named(objective).single() ? t("quantity." + objective) : objective;
}

/// In the unit that the objective is shown in.
double shown_objective(const SweepPoint& point, const std::string& objective) {
  const auto* design = point.design();
  if (design == nullptr) return std::nan("");
  const double value = design->total(machine::objective_named(objective));
  return objective == "position_error" ? 1e6 * value : value;
}

std::string charts(const Sweep& sweep, const Texts& t) {
  const MachineResult& first = sweep.first();
  const std::string& objective = first.objectives.front();
  const std::string unit = objective == "position_error" ? "um" : objective_unit(objective, first.currency);
  const std::string y_label = with_unit(objective_name(objective, t), unit);
  std::vector<Mark> by_value;
  std::vector<Mark> by_time;
  double shortest = HUGE_VAL;
  double longest = 0.0;
  for (const SweepPoint& point : sweep.points) {
    const auto* design = point.design();
    const std::string title =
        point.text + ": " +
        (design == nullptr
             ? no_build_reason(point)
             : objective_text(objective, design->total(machine::objective_named(objective)), first.currency));
    by_value.push_back({point.value, shown_objective(point, objective), point.proved(), title});
    if (design == nullptr) continue;
    by_time.push_back({point.cycle_time, shown_objective(point, objective), point.proved(), title});
    shortest = std::min(shortest, point.cycle_time);
    longest = std::max(longest, point.cycle_time);
  }
  std::string out = Chart(by_value, with_unit(sweep.path, sweep.unit), y_label).svg();
  if (longest > shortest * (1.0 + 1e-9) && objective != "cycle_time") {
    std::stable_sort(by_time.begin(), by_time.end(), [](const Mark& a, const Mark& b) { return a.x < b.x; });
    out += "<h3>" + escaped(t("sweep.speed")) + "</h3>\n" +
           Chart(by_time, with_unit(t("quantity.cycle_time"), "s"), y_label).svg();
  }
  const bool preferred = std::any_of(sweep.points.begin(), sweep.points.end(), [](const SweepPoint& point) {
    return preference_counts(point.result);
  });
  return out + "<p class=\"hint\">" + escaped(t("sweep.hint")) +
         (preferred ? " " + escaped(t("sweep.preferred")) : std::string()) + "</p>\n";
}

std::string proof_mark(const SweepPoint& point, const Texts& t) {
  const char* key = point.proved() ? "sweep.proved" : "sweep.open";
  const bool open = !point.proved() || proof_gap(point.result);
  const std::string gap = open && point.design() != nullptr && std::isfinite(point.result.gap)
                              ? fmt::format(" ({} %)", percent_rounded_up(point.result.gap))
                              : std::string();
  return fmt::format("<span class=\"mark {}\">{}</span>", point.proved() ? "good" : "near", escaped(t(key) + gap));
}

std::string table(const Sweep& sweep, const Texts& t) {
  const MachineResult& first = sweep.first();
  const std::string& objective = first.objectives.front();
  const bool own_column = has_own_column(objective);
  const std::vector<machine::Quantity> further = further_columns(sweep);
  std::vector<std::string> headings{escaped(sweep.path)};
  if (own_column) headings.push_back(escaped(objective_name(objective, t)));
  for (const machine::Quantity quantity : further)
    headings.push_back(escaped(objective_name(std::string(machine::declaration(quantity).name), t)));
  for (const std::string& each : {escaped(t("quantity.cost")) + " <small>" + escaped(first.currency) + "</small>",
                                  escaped(t("quantity.mass")) + " <small>kg</small>",
                                  escaped(t("quantity.cycle_time")) + " <small>s</small>",
                                  escaped(t("sweep.proof")),
                                  escaped(t("front.changes"))})
    headings.push_back(each);
  const std::string sides = std::string((own_column ? 5 : 4) + further.size(), '>') + "<<";
  HtmlTable table(sides, headings, "sweep stacked");
  const std::vector<std::string> changes = sweep_changes(sweep);
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    const SweepPoint& point = sweep.points[i];
    const auto* design = point.design();
    std::vector<std::string> cells{escaped(point.text)};
    if (own_column)
      cells.push_back(
          design == nullptr
              ? "–"
              : escaped(objective_text(objective, design->total(machine::objective_named(objective)), first.currency)));
    for (const machine::Quantity quantity : further)
      cells.push_back(design == nullptr ? "–" : escaped(counted_text(point, quantity)));
    cells.push_back(design == nullptr ? "–" : fmt::format("{:.2f}", design->cost));
    cells.push_back(design == nullptr ? "–" : fmt::format("{:.3f}", design->mass));
    cells.push_back(design == nullptr ? "–" : fmt::format("{:.4g}", point.cycle_time));
    cells.push_back(proof_mark(point, t));
    cells.push_back(escaped(design == nullptr ? no_build_reason(point) : changes[i]));
    table.add(cells);
  }
  return table.str();
}

}  // namespace

std::string sweep_page(const Sweep& sweep, const std::string& json, Language language) {
  const Texts t(language);
  const MachineResult& first = sweep.first();
  const std::string title = first.title.empty() ? first.file : first.title;
  std::string body =
      fmt::format("<header>\n<p class=\"kind\">{}</p>\n<h1>{}</h1>\n<p class=\"file\">{}</p>\n</header>\n<main>\n",
                  escaped(t("kind.sweep")),
                  escaped(title),
                  escaped(first.file));
  const std::string asked = steering_text(first, Style{});
  if (const std::size_t line = asked.find('\n'); line != std::string::npos)
    body += "<h3>" + escaped(t("summary.asked")) + "</h3>\n<pre>" + escaped(asked.substr(line + 1)) + "</pre>\n";
  std::vector<const evaluation::Design*> designs;
  for (const SweepPoint& point : sweep.points)
    if (point.design() != nullptr) designs.push_back(point.design());
  body += section("sweep", t("sweep"), charts(sweep, t) + table(sweep, t) + incomplete_html(incomplete_in(sweep), t));
  body += "</main>\n" + footer(designs, t);
  return document(title + " – Millwright", body, Json{{"language", code(language)}}, json, t);
}

}  // namespace millwright::report
