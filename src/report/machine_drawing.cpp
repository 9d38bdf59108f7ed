// SPDX-License-Identifier: Apache-2.0
// The machine to scale: a strip for each axis, from the tool down to the base; upright axes stand beside them. What has
// no length in the catalogues (couplings, supports) is drawn as a mark.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/html.h"
#include "report/page_parts.h"
#include "scalar/unit.h"

namespace millwright::report {

using evaluation::Design;
using evaluation::PartLine;
using machine::Axis;
using machine::MechanismKind;

namespace {

constexpr double strip_height = 86.0;  ///< px
constexpr double drawing_width = 620.0;
constexpr double label_height = 20.0;
constexpr double drive_at = 26.0;  ///< px, of the drive's line below that of the rails

/// The sizes of one axis, m.
struct Sizes {
  double stroke = 0.0, rail = 0.0, carriages = 0.0, drive = 0.0, motor = 0.042;
  [[nodiscard]] double length() const { return std::max({rail, drive + motor, stroke + carriages}); }
};

const PartLine* part_of(const Design& design, const std::string& axis, std::string_view slot) {
  for (const PartLine& part : design.parts)
    if (part.axis == axis && part.slot == slot) return &part;
  return nullptr;
}

Sizes sizes_of(const Axis& axis, const Design& design) {
  Sizes sizes;
  sizes.stroke = machine::is_rotary(axis) ? 0.0 : axis.stroke;
  const auto length = [&](std::string_view slot) {
    const PartLine* part = part_of(design, axis.name, slot);
    return part == nullptr ? 0.0 : part->length;
  };
  sizes.rail = length("guide");
  if (axis.guide) sizes.carriages = axis.guide->carriage_spacing;
  sizes.drive = axis.mechanism.kind == MechanismKind::screw  ? length("screw")
                : axis.mechanism.kind == MechanismKind::belt ? 0.5 * length("belt")
                : axis.mechanism.kind == MechanismKind::rack ? length("rack")
                                                             : 0.0;
  if (design.worksheet != nullptr)
    for (const evaluation::DriveDrawing& drive : design.worksheet->drives)
      if (drive.axis == axis.name && drive.motor_size > 0.0) sizes.motor = drive.motor_size;
  return sizes;
}

std::string millimetres(double metres) { return scalar::format(metres, scalar::Unit::of("mm"), 4); }

class Strip {
 public:
  Strip(const Axis& axis, const Sizes& sizes, double scale)
      : axis_(axis), sizes_(sizes), scale_(scale), middle_(0.5 * sizes.length() * scale) {}

  /// Rails in the middle of the strip, from the left end 0; the label is the caller's.
  std::string str() {
    if (machine::is_rotary(axis_)) return table();
    rails();
    carriages();
    drive();
    return out_;
  }

 private:
  [[nodiscard]] double px(double metres) const { return metres * scale_; }
  void rectangle(const char* css, double x, double y, double width, double height) {
    out_ += fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                        css,
                        x,
                        y,
                        std::max(width, 1.0),
                        height);
  }
  void line(const char* css, double x1, double y1, double x2, double y2) {
    out_ += fmt::format(
        "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>", css, x1, y1, x2, y2);
  }
  void circle(const char* css, double x, double y, double radius) {
    out_ += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", css, x, y, radius);
  }

  void rails() {
    const double length = px(sizes_.rail > 0.0 ? sizes_.rail : sizes_.stroke + sizes_.carriages);
    rectangle(sizes_.rail > 0.0 ? "rail" : "rail unknown", middle_ - 0.5 * length, -3.0, length, 6.0);
  }

  void carriages() {
    const double block = std::max(10.0, px(0.045));
    const double reach = 0.5 * px(sizes_.carriages);
    const auto table_at = [&](double centre, const char* css) {
      rectangle(css, centre - reach - 0.5 * block, -11.0, 2.0 * reach + block, 8.0);
    };
    const double travel = 0.5 * px(sizes_.stroke);
    table_at(middle_ - travel, "ghost");
    table_at(middle_ + travel, "ghost");
    table_at(middle_, "table");
    // The stroke, as a dimension between the two ends of the table's middle.
    const double y = -18.0;
    line("dim", middle_ - travel, y, middle_ + travel, y);
    for (const double end : {middle_ - travel, middle_ + travel}) line("dim", end, y - 4.0, end, y + 4.0);
  }

  void drive() {
    const double length = px(sizes_.drive);
    const double motor = px(sizes_.motor);
    const double left = middle_ - 0.5 * (length + motor) + motor;
    const double y = drive_at;
    switch (axis_.mechanism.kind) {
      case MechanismKind::screw:
        rectangle("screw", left, y - 2.5, length, 5.0);
        rectangle("support", left + 0.02 * length, y - 7.0, 6.0, 14.0);
        if (axis_.mechanism.ends != machine::Ends::fixed_free)
          rectangle("support", left + 0.97 * length, y - 7.0, 6.0, 14.0);
        rectangle("nut", middle_ - 9.0, y - 7.0, 18.0, 14.0);
        line("link", middle_, -3.0, middle_, y - 7.0);
        break;
      case MechanismKind::belt:
        line("belt", left, y - 6.0, left + length, y - 6.0);
        line("belt", left, y + 6.0, left + length, y + 6.0);
        circle("support", left, y, 6.0);
        circle("support", left + length, y, 6.0);
        line("link", middle_, -3.0, middle_, y - 6.0);
        break;
      case MechanismKind::rack:
        out_ += fmt::format("<line class=\"rack\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>",
                            left,
                            y,
                            left + length,
                            y);
        circle("nut", middle_, y - 9.0, 6.0);
        break;
      case MechanismKind::rotary:
        break;
    }
    const bool rides =
        axis_.mechanism.kind == MechanismKind::rack ? axis_.mechanism.motor_rides : axis_.mechanism.nut_rotates;
    const double at = rides ? middle_ + 12.0 : left - motor;
    rectangle("motor", at, y - 0.5 * motor, motor, motor);
  }

  /// A table has no size in the problem: a mark, on its motor.
  std::string table() {
    constexpr double reach = 40.0;
    const double motor = px(sizes_.motor);
    rectangle("table", middle_ - reach, -11.0, 2.0 * reach, 8.0);
    line("link", middle_, -3.0, middle_, drive_at - 0.5 * motor);
    rectangle("motor", middle_ - 0.5 * motor, drive_at - 0.5 * motor, motor, motor);
    return out_;
  }

  const Axis& axis_;
  const Sizes& sizes_;
  double scale_, middle_;
  std::string out_;
};

std::string label(const Axis& axis, const Texts& t) {
  std::string words = axis.name;
  words += machine::is_rotary(axis)                         ? ": " + t("drawing.rotary")
           : axis.direction == machine::Direction::vertical ? ": " + t("drawing.vertical")
           : axis.direction == machine::Direction::inclined ? ": " + t("drawing.inclined")
                                                            : "";
  if (!machine::is_rotary(axis)) words += fmt::format("  ⟷ {}", millimetres(axis.stroke));
  return words;
}

std::string scale_bar(double scale, double y) {
  double length = 1.0;
  for (const double candidate : {0.5, 0.2, 0.1, 0.05})
    if (candidate * scale > 140.0 || length * scale > 220.0) length = candidate;
  return fmt::format(
      "<g class=\"scale\"><line class=\"dim\" x1=\"0\" y1=\"{0:.1f}\" x2=\"{1:.1f}\" y2=\"{0:.1f}\"/>"
      "<line class=\"dim\" x1=\"0\" y1=\"{2:.1f}\" x2=\"0\" y2=\"{3:.1f}\"/>"
      "<line class=\"dim\" x1=\"{1:.1f}\" y1=\"{2:.1f}\" x2=\"{1:.1f}\" y2=\"{3:.1f}\"/>"
      "<text x=\"{4:.1f}\" y=\"{5:.1f}\">{6}</text></g>",
      y,
      length * scale,
      y - 4.0,
      y + 4.0,
      length * scale + 8.0,
      y + 4.0,
      escaped(millimetres(length)));
}

}  // namespace

std::string machine_drawing(const machine::Problem& problem, const Design& design, const Texts& t) {
  std::vector<std::pair<const Axis*, Sizes>> level;
  std::vector<std::pair<const Axis*, Sizes>> upright;
  double longest = 0.1;
  for (const std::size_t index : problem.order) {
    const Axis& axis = problem.axes[index];
    const Sizes sizes = sizes_of(axis, design);
    longest = std::max(longest, sizes.length());
    (axis.direction == machine::Direction::vertical ? upright : level).emplace_back(&axis, sizes);
  }
  const double columns = static_cast<double>(upright.size());
  const double room = drawing_width - columns * strip_height - (columns > 0.0 ? 30.0 : 0.0);
  double scale = room / longest;
  double tallest = 0.0;
  for (const auto& [axis, sizes] : upright) tallest = std::max(tallest, sizes.length());
  constexpr double highest_column = 320.0;
  if (tallest * scale > highest_column) scale = highest_column / tallest;
  const double rows = static_cast<double>(level.size()) * (strip_height + label_height);
  const double height = std::max(rows, tallest * scale + 2.0 * label_height) + 34.0;
  std::string out =
      fmt::format("<svg class=\"machine\" viewBox=\"-6 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">\n",
                  drawing_width + 12.0,
                  height,
                  escaped(t("drawing.title")));
  double y = 0.0;
  for (const auto& [axis, sizes] : level) {
    out += fmt::format("<text class=\"name\" x=\"0\" y=\"{:.1f}\">{}</text>", y + 13.0, escaped(label(*axis, t)));
    // Centred, as the axes stand on each other.
    out += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">{}</g>\n",
                       0.5 * (room - sizes.length() * scale),
                       y + label_height + 30.0,
                       Strip(*axis, sizes, scale).str());
    y += strip_height + label_height;
  }
  double x = room + 30.0;
  const double floor = std::max(rows, tallest * scale + 2.0 * label_height);
  for (const auto& [axis, sizes] : upright) {
    out += fmt::format("<g transform=\"translate({:.1f} {:.1f}) rotate(-90)\">{}</g>\n",
                       x + 34.0,
                       floor,
                       Strip(*axis, sizes, scale).str());
    out += fmt::format("<text class=\"name\" text-anchor=\"end\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>",
                       x + strip_height - 20.0,
                       floor - sizes.length() * scale - 8.0,
                       escaped(label(*axis, t)));
    x += strip_height;
  }
  out += scale_bar(scale, height - 12.0) + "</svg>\n";
  return "<figure>" + out + "<figcaption>" + escaped(t("drawing.caption")) + "</figcaption></figure>\n";
}

}  // namespace millwright::report
