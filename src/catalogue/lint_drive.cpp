// SPDX-License-Identifier: Apache-2.0
// Plausibility rules for motors, screws, nuts, couplings, belts, pulleys, racks, pinions and electronics. Figures are
// in declared units (mm, N, N.m, A, mH, g.cm2, kg); the bands come from geometry, steel's density and the spread of
// published parts.
#include <array>
#include <cmath>
#include <numbers>

#include "catalogue/lint_row.h"

namespace millwright::catalogue {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double steel = 7.85e-6;  // kg/mm3

double square(double x) { return x * x; }

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

void lint_winding(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::steppers, name); };
  constexpr Column hold = of("holding_torque"), current = of("rated_current"), resistance = of("phase_resistance");
  constexpr Column inductance = of("phase_inductance");
  const double loss = 2 * square(row(current)) * row(resistance);
  row.within("copper-loss", resistance, loss, {0.2, 1, 150, 1000}, "copper loss at rated current in W");
  const double time = row(inductance) / row(resistance);
  row.within("time-constant", inductance, time, {0.1, 0.25, 20, 60}, "electrical time constant L/R in ms");
  // Torque constant squared over inductance grows with the torque of the motor, whatever the winding: K^2 / (L T).
  const double constant = square(row(hold) / row(current)) / (row(inductance) * 1e-3 * row(hold));
  row.within("torque-constant", inductance, constant, {3, 8, 160, 400}, "(T/I)^2 / (L T) in SI units");
}

void lint_stepper(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::steppers, name); };
  constexpr Column frame = of("frame_size"), length = of("body_length"), step = of("step_angle");
  constexpr Column hold = of("holding_torque"), inertia = of("rotor_inertia"), mass = of("mass"),
                   detent = of("detent_torque");
  lint_frame(row);
  lint_winding(row);
  const double steps = 360.0 / row(step);
  const bool divides = !(std::abs(steps - std::round(steps)) > 1e-6 * steps);
  const bool usual = !(std::abs(steps - 200.0) > 1e-6 && std::abs(steps - 400.0) > 1e-6);
  row.demand("step-angle", step, divides, "the step angle does not divide a revolution");
  row.expect("step-angle", step, usual, "a hybrid stepper has 1.8 or 0.9 degrees a step");
  row.below("detent-torque", detent, hold);
  const double detent_share = row(detent) / row(hold);
  row.within("detent-torque", detent, detent_share, {0, 0.005, 0.25, 1e9}, "detent torque / holding torque");
  row.below("shaft-diameter", of("shaft_diameter"), frame);
  const double volume = square(row(frame)) * row(length) * 1e-6;  // dm3
  row.within("motor-mass", mass, row(mass) / volume, {1.0, 2.0, 6.5, 7.85}, "mass / bulk volume in kg/dm3");
  row.within("holding-torque", hold, row(hold) / volume, {0.4, 1.2, 20, 40}, "torque / bulk volume in N.m/dm3");
  const double rotor =
      std::pow(32.0 * row(inertia) * 0.1 / (pi * steel * row(length)), 0.25) / row(frame);  // from kg.mm2
  row.within("rotor-inertia", inertia, rotor, {0.27, 0.34, 0.68, 0.85}, "diameter of an equal steel rotor / frame");
}

void lint_ball_screw(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::ball_screws, name); };
  constexpr Column nominal = of("nominal_diameter"), outside = of("outside_diameter"), root = of("root_diameter"),
                   lead = of("lead");
  constexpr Column dynamic = of("dynamic_load_rating"), fixed = of("static_load_rating"),
                   per_length = of("screw_mass_per_length");
  constexpr Column nut_mass = of("nut_mass"), nut_outside = of("nut_outside_diameter"), nut_length = of("nut_length");
  row.below("root-diameter", root, outside);
  row.below("root-diameter", root, nominal);
  row.within(
      "root-diameter", root, row(root) / row(nominal), {0.4, 0.65, 0.99, 1e9}, "root diameter / nominal diameter");
  row.agrees("outside-diameter", outside, row(nominal), 0.1, 0.5, "the nominal diameter");
  row.within("load-ratings", fixed, row(fixed) / row(dynamic), {0.5, 1.0, 6, 12}, "C0 / C");
  row.within("load-ratings",
             dynamic,
             row(dynamic) / square(row(nominal)),
             {1, 3, 150, 500},
             "C / nominal diameter squared in N/mm2");
  row.within("lead", lead, row(lead) / row(nominal), {0.03, 0.08, 3.2, 10}, "lead / nominal diameter");
  const double shaft = pi / 4 * square((row(outside) + row(root)) / 2) * steel * 1e3;  // kg/m
  row.agrees("screw-mass", per_length, shaft, 0.3, 2, "a steel shaft of the mean diameter");
  const double nut = pi / 4 * (square(row(nut_outside)) - square(row(outside))) * row(nut_length) * steel;
  row.within("nut-mass", nut_mass, row(nut_mass) / nut, {0.2, 0.6, 5, 20}, "nut mass / its steel body without flange");
  row.below("nut-diameter", outside, nut_outside);
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
             std::atan(row(lead) / (pi * row(mean))) * 180 / pi,
             0.005,
             0.05,
             "atan(lead / (pi pitch diameter))");
  row.within("thread-height",
             of("thread_height"),
             row(of("thread_height")) / row(pitch),
             {0.2, 0.4, 0.75, 1.5},
             "thread height / pitch");
  const double rod = pi / 4 * square(row(mean)) * steel * 1e3;
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
  constexpr Column pv = of("maximum_pv"), pressure = of("allowable_pressure"), speed = of("maximum_sliding_speed");
  row.below("nut-diameter", of("nominal_diameter"), of("outside_diameter"));
  row.below("nut-diameter", of("outside_diameter"), of("flange_outside_diameter"));
  row.at_most("friction", of("friction_greased"), of("friction_dry"));
  row.within("pv-limit",
             pv,
             row(pv) / (row(pressure) * row(speed)),
             {0.001, 0.01, 1.0, 10},
             "PV limit / (pressure limit x speed limit)");
}

void lint_coupling(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::couplings, name); };
  constexpr Column outside = of("outside_diameter"), mass = of("mass"), inertia = of("inertia"),
                   rated = of("rated_torque");
  row.at_most("bore", of("minimum_bore"), of("maximum_bore"));
  row.below("bore", of("maximum_bore"), outside);
  row.at_most("maximum-torque", rated, of("maximum_torque"));
  const double cylinder = row(mass) * square(row(outside)) / 8 * 10;  // kg.mm2 -> g.cm2
  row.within("inertia",
             inertia,
             row(inertia) / cylinder,
             {0.2, 0.6, 1.8, 2.0},
             "inertia / that of a solid cylinder of that mass");
  const double volume = pi / 4 * square(row(outside)) * row(of("length"));
  row.within("coupling-mass", mass, row(mass) / volume * 1e6, {0.3, 0.8, 7, 8}, "mass / envelope in kg/dm3");
  row.within("rated-torque",
             rated,
             row(rated) / std::pow(row(outside), 3) * 1e6,
             {4, 20, 2000, 2e4},
             "torque / diameter cubed in kPa");
  row.within("stiffness",
             of("torsional_stiffness"),
             row(of("torsional_stiffness")) / row(rated),
             {1, 4, 5000, 50000},
             "torsional stiffness / rated torque");
}

void lint_belt(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::belts, name); };
  constexpr Column allowable = of("allowable_tension"), per_length = of("mass_per_length"),
                   stiffness = of("tensile_stiffness");
  row.below("breaking-tension", allowable, of("breaking_tension"));
  row.within("belt-strain",
             stiffness,
             row(allowable) / row(stiffness) * 100,
             {0.01, 0.04, 1.2, 5},
             "strain at the allowable tension in %");
  const double envelope = row(of("width")) * row(of("pitch")) * 1e-3;  // dm3/m at a thickness of one pitch
  row.within("belt-mass",
             per_length,
             row(per_length) / envelope,
             {0.05, 0.2, 1.8, 6},
             "mass / (width x pitch x length) in kg/dm3");
}

void lint_pulley(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::pulleys, name); };
  constexpr Column outside = of("outside_diameter"), inertia = of("inertia"), mass = of("mass"), teeth = of("teeth");
  row.agrees(
      "pitch-diameter", of("pitch_diameter"), row(teeth) * row(of("pitch")) / pi, 0.002, 0.02, "teeth x pitch / pi");
  row.below("outside-diameter", outside, of("pitch_diameter"));
  row.below("bore", of("bore"), outside);
  row.below("flange-diameter", outside, of("flange_diameter"));
  row.demand("teeth", teeth, !(row(teeth) != std::round(row(teeth))), "the number of teeth is not whole");
  const double cylinder = row(mass) * square(row(outside)) / 8 * 10;
  row.within("inertia",
             inertia,
             row(inertia) / cylinder,
             {0.2, 0.5, 2.0, 3.0},
             "inertia / that of a solid cylinder of that mass");
  const double volume = pi / 4 * square(row(outside)) * row(of("overall_width"));
  row.within(
      "pulley-mass", mass, row(mass) / volume * 1e6, {0.2, 0.6, 8, 20}, "mass / cylinder of that size in kg/dm3");
}

/// Teeth after DIN 867: as high as 2.25 modules, as thick as a gap at the pitch line. Between root and tip they fill
/// 1.19 modules of a full bar, so that a rack has the section width * (height - 1.06 * module).
void lint_rack(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::racks, name); };
  constexpr Column module = of("module"), width = of("face_width"), height = of("height"), mass = of("mass_per_length");
  row.agrees("tooth-pitch", of("pitch"), row(module) * pi, 0.002, 0.02, "module x pi");
  row.agrees("pitch-line", of("pitch_height"), row(height) - row(module), 0.01, 0.1, "height less the module");
  row.within("root-geometry", height, row(height) / row(module), {2.25, 5, 25, 60}, "height / module");
  row.within("face-width", width, row(width) / row(module), {1, 4, 25, 60}, "face width / module");
  const double bar = row(width) * (row(height) - 1.06 * row(module)) * steel * 1e3;  // kg/m
  row.agrees("rack-mass", mass, bar, 0.25, 0.95, "a steel bar of that width and height less its gaps");
  const double count = row(of("piece_length")) / (row(module) * pi);
  row.expect("piece-length",
             of("piece_length"),
             !(std::abs(count - std::round(count)) > 0.03),
             "the piece has no whole number of teeth and cannot be joined to the next");
}

void lint_pinion(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::pinions, name); };
  constexpr Column module = of("module"), teeth = of("teeth"), width = of("face_width"), bore = of("bore"),
                   pitch = of("pitch_diameter"), mass = of("mass"), inertia = of("inertia");
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
  row.within("face-width", width, row(width) / row(module), {1, 4, 25, 60}, "face width / module");
  const double ring = square(row(pitch)) - square(row(bore));
  const double body = pi / 4 * ring * row(width) * steel;
  row.within("pinion-mass", mass, row(mass) / body, {0.05, 0.5, 3, 10}, "mass / its steel body without hub");
  const double cylinder = row(mass) * (square(row(pitch)) + square(row(bore))) / 8 * 10;
  row.within("inertia", inertia, row(inertia) / cylinder, {0.2, 0.4, 1.3, 2}, "inertia / that of a ring of that mass");
}

void lint_driver(const LintRow& row) {
  constexpr auto of = [](std::string_view name) { return column(Family::drivers, name); };
  row.below("voltage-range", of("minimum_voltage"), of("maximum_voltage"));
  row.at_most("voltage-range", of("recommended_maximum_voltage"), of("maximum_voltage"));
  row.at_most("voltage-range", of("maximum_voltage"), of("overvoltage_trip"));
  row.at_most("rms-current", of("rms_current"), of("peak_current"));
  row.within("rms-current",
             of("peak_current"),
             row(of("peak_current")) / row(of("rms_current")),
             {1, 1.2, 2.5, 6},
             "peak current / RMS current");
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
