// SPDX-License-Identifier: Apache-2.0
// Rules that compare figures of a row exactly, for motors, screws, nuts, couplings, belts, pulleys, racks, pinions and
// electronics. Figures are in declared units (mm, N, N.m, A, mH, g.cm2, kg); what only usually holds is in relation.h.
#include <array>
#include <cmath>
#include <numbers>

#include "catalogue/lint_row.h"
#include "scalar/elementary.h"

namespace millwright::catalogue {
namespace {

constexpr double steel = 7.85e-6;  // kg/mm3

void lint_frame(const LintRow& row) {
  struct Frame {
    std::string_view name;
    double width;
  };
  static constexpr std::array<Frame, 9> frames = {{{"NEMA8", 20.3},
                                                   {"NEMA11", 28.2},
                                                   {"NEMA14", 35.4},
                                                   {"NEMA16", 39.2},
                                                   {"NEMA17", 42.4},
                                                   {"NEMA23", 57.0},
                                                   {"NEMA24", 60.0},
                                                   {"NEMA34", 86.0},
                                                   {"NEMA42", 110.0}}};
  constexpr Column name = column(Family::steppers, "frame");
  constexpr Column size = column(Family::steppers, "frame_size");
  for (const Frame& frame : frames) {
    if (row.text(name) == frame.name)
      row.agrees("frame-size", size, frame.width, 0.05, 0.5, "the flange of that frame");
  }
}

void lint_stepper(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::steppers, name); };
  constexpr Column step = of("step_angle"), phases = of("phases_on");
  lint_frame(row);
  const double steps = 360.0 / row(step);
  const bool divides = !(std::abs(steps - std::round(steps)) > 1e-6 * steps);
  const bool usual = !(std::abs(steps - 200.0) > 1e-6 && std::abs(steps - 400.0) > 1e-6);
  row.demand("step-angle", step, divides, "the step angle does not divide a revolution");
  row.expect("step-angle", step, usual, "a hybrid stepper has 1.8 or 0.9 degrees a step");
  row.demand("phases-on",
             phases,
             !(row(phases) < 1 || (row(phases) > 1 && row(phases) < 2) || row(phases) > 2),
             "a holding torque is stated with one or with two phases on");
  row.below("detent-torque", of("detent_torque"), of("holding_torque"));
  row.below("shaft-diameter", of("shaft_diameter"), of("frame_size"));
}

void lint_ball_screw(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::ball_screws, name); };
  constexpr Column nominal = of("nominal_diameter"), outside = of("outside_diameter"), root = of("root_diameter"),
                   lead = of("lead");
  row.below("root-diameter", root, outside);
  row.below("root-diameter", root, nominal);
  row.agrees("outside-diameter", outside, row(nominal), 0.1, 0.5, "the nominal diameter");
  const double shaft = std::numbers::pi / 4 * scalar::square((row(outside) + row(root)) / 2) * steel * 1e3;  // kg/m
  row.agrees("screw-mass", of("screw_mass_per_length"), shaft, 0.3, 2, "a steel shaft of the mean diameter");
  row.below("nut-diameter", outside, of("nut_outside_diameter"));
  constexpr Column fixed = of("static_load_rating");
  row.expect("load-ratings",
             fixed,
             !(row(fixed) < row(of("dynamic_load_rating"))),
             "the static rating is below the dynamic one: swapped?");
  row.at_most("ball-diameter", of("ball_diameter"), lead);
}

void lint_lead_screw(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::lead_screws, name); };
  constexpr Column major = of("major_diameter"), mean = of("pitch_diameter"), minor = of("minor_diameter"),
                   pitch = of("pitch");
  constexpr Column lead = of("lead"), starts = of("starts"), angle = of("lead_angle"),
                   half_angle = of("flank_half_angle");
  row.below("root-diameter", minor, mean);
  row.below("root-diameter", mean, major);
  row.agrees("lead-starts", lead, row(pitch) * row(starts), 1e-6, 1e-3, "pitch x starts");
  row.at_most("nut-thread", major, of("nut_major_diameter"));
  row.at_most("nut-thread", minor, of("nut_minor_diameter"));
  row.agrees("lead-angle",
             angle,
             std::atan(row(lead) / (std::numbers::pi * row(mean))) * 180 / std::numbers::pi,
             0.005,
             0.05,
             "atan(lead / (pi pitch diameter))");
  const double rod = std::numbers::pi / 4 * scalar::square(row(mean)) * steel * 1e3;
  row.agrees("screw-mass", of("screw_mass_per_length"), rod, 0.3, 2, "a steel rod of the pitch diameter");
  const std::string_view form = row.text(of("thread_form"));
  const double expected = form.starts_with("trapezoidal") ? 15
                          : form.starts_with("metric")    ? 30
                          : form.starts_with("square")    ? 0
                                                          : row(half_angle);
  row.demand("flank-angle",
             half_angle,
             !(std::abs(row(half_angle) - expected) > 0.01),
             "the flank angle is not that of the thread form");
}

void lint_lead_nut(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::lead_nuts, name); };
  row.below("nut-diameter", of("nominal_diameter"), of("outside_diameter"));
  row.below("nut-diameter", of("outside_diameter"), of("flange_outside_diameter"));
  row.at_most("friction", of("friction_greased"), of("friction_dry"));
}

void lint_coupling(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::couplings, name); };
  row.at_most("bore", of("minimum_bore"), of("maximum_bore"));
  row.below("bore", of("maximum_bore"), of("outside_diameter"));
  row.at_most("maximum-torque", of("rated_torque"), of("maximum_torque"));
}

void lint_belt(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::belts, name); };
  row.below("breaking-tension", of("allowable_tension"), of("breaking_tension"));
}

void lint_pulley(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::pulleys, name); };
  constexpr Column outside = of("outside_diameter"), teeth = of("teeth");
  row.agrees("pitch-diameter",
             of("pitch_diameter"),
             row(teeth) * row(of("pitch")) / std::numbers::pi,
             0.002,
             0.02,
             "teeth x pitch / pi");
  row.below("outside-diameter", outside, of("pitch_diameter"));
  row.below("bore", of("bore"), outside);
  row.below("flange-diameter", outside, of("flange_diameter"));
  row.demand("teeth", teeth, !(row(teeth) != std::round(row(teeth))), "the number of teeth is not whole");
}

/// Teeth after DIN 867: as high as 2.25 modules, as thick as a gap at the pitch line. Between root and tip they fill
/// 1.19 modules of a full bar, so that a rack has the section width * (height - 1.06 * module).
void lint_rack(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::racks, name); };
  constexpr Column module = of("module"), width = of("face_width"), height = of("height"), mass = of("mass_per_length");
  row.agrees("tooth-pitch", of("pitch"), row(module) * std::numbers::pi, 0.002, 0.02, "module x pi");
  row.agrees("pitch-line", of("pitch_height"), row(height) - row(module), 0.01, 0.1, "height less the module");
  row.within("root-geometry", height, row(height) / row(module), {2.25, 5, 25, 60}, "height / module");
  const double bar = row(width) * (row(height) - 1.06 * row(module)) * steel * 1e3;  // kg/m
  row.agrees("rack-mass", mass, bar, 0.25, 0.95, "a steel bar of that width and height less its gaps");
  const double count = row(of("piece_length")) / (row(module) * std::numbers::pi);
  row.expect("piece-length",
             of("piece_length"),
             !(std::abs(count - std::round(count)) > 0.03),
             "the piece has no whole number of teeth and cannot be joined to the next");
}

void lint_pinion(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::pinions, name); };
  constexpr Column module = of("module"), teeth = of("teeth"), bore = of("bore"), pitch = of("pitch_diameter");
  row.demand("teeth", teeth, !(row(teeth) != std::round(row(teeth))), "the number of teeth is not whole");
  row.agrees("pitch-diameter", pitch, row(module) * row(teeth), 0.002, 0.02, "module x teeth");
  row.agrees("outside-diameter",
             of("outside_diameter"),
             row(module) * (row(teeth) + 2),
             0.01,
             0.1,
             "module x (teeth + 2); more where the profile is shifted");
  const double root = row(module) * (row(teeth) - 2.5);
  row.demand("root-geometry", bore, !(row(bore) >= root), "the bore is as wide as the root circle");
  row.expect("root-geometry",
             bore,
             !(row(bore) < root && (root - row(bore)) / 2 < row(module)),
             "less than a module of wall between bore and tooth roots");
}

void lint_driver(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::drivers, name); };
  row.below("voltage-range", of("minimum_voltage"), of("maximum_voltage"));
  row.at_most("voltage-range", of("recommended_maximum_voltage"), of("maximum_voltage"));
  row.at_most("voltage-range", of("maximum_voltage"), of("overvoltage_trip"));
  row.at_most("rms-current", of("rms_current"), of("peak_current"));
}

void lint_power_supply(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::power_supplies, name); };
  constexpr Column voltage = of("output_voltage"), current = of("output_current"), power = of("power");
  row.agrees("supply-power", power, row(voltage) * row(current), 0.03, 0.2, "voltage x current");
  row.at_most("adjustment", of("adjustment_minimum"), voltage);
  row.at_most("adjustment", voltage, of("adjustment_maximum"));
  row.at_most("peak-current", current, of("peak_current"));
}

}  // namespace

void lint_drive(Family family, const LintRow& row) {
  switch (family) {
    case Family::steppers:
      return lint_stepper(row);
    case Family::ball_screws:
      return lint_ball_screw(row);
    case Family::lead_screws:
      return lint_lead_screw(row);
    case Family::lead_nuts:
      return lint_lead_nut(row);
    case Family::couplings:
      return lint_coupling(row);
    case Family::belts:
      return lint_belt(row);
    case Family::pulleys:
      return lint_pulley(row);
    case Family::racks:
      return lint_rack(row);
    case Family::pinions:
      return lint_pinion(row);
    case Family::drivers:
      return lint_driver(row);
    case Family::power_supplies:
      return lint_power_supply(row);
    default:
      return;
  }
}

}  // namespace millwright::catalogue
