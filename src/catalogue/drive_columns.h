// SPDX-License-Identifier: Apache-2.0
#pragma once

// The columns of the families that drive an axis: motors, screws, nuts, couplings, belts, racks, electronics.
// number: name, unit, need, plausible range in that unit, meaning, basis column.

#include "catalogue/column.h"
#include "catalogue/cut_columns.h"

namespace millwright::catalogue::columns {

using enum Need;

inline constexpr ColumnDeclaration steppers[] = {
    text("frame", expected, "frame size class, NEMA11 to NEMA42"),
    number("frame_size", "mm", expected, 15, 150, "width of the square flange"),
    number("body_length", "mm", expected, 5, 400, "length of the body without shaft"),
    number("shaft_diameter", "mm", expected, 2, 35, "diameter of the output shaft"),
    number("step_angle", "deg", required, 0.36, 15, "angle of a full step"),
    number("holding_torque",
           "N.m",
           required,
           0.003,
           60,
           "holding torque at rated current, both phases on unless phases_on says one",
           "torque_basis"),
    number("detent_torque", "N.m", optional, 1e-4, 5, "torque without current", "torque_basis"),
    text("torque_basis", optional, "where the torques come from"),
    number("rated_current", "A", required, 0.05, 20, "rated phase current, both phases on", "electrical_basis"),
    text("current_kind", optional, "rms (maker says so) or phase (data sheet's rated phase current)"),
    number("phase_resistance", "ohm", expected, 0.05, 300, "winding resistance of a phase", "electrical_basis"),
    number("phase_inductance", "mH", expected, 0.1, 500, "winding inductance of a phase", "electrical_basis"),
    number("maximum_voltage", "V", optional, 5, 400, "limit of insulation or recommended supply", "electrical_basis"),
    text("electrical_basis", optional, "where the winding data come from"),
    number("rotor_inertia", "g.cm2", expected, 0.5, 50000, "moment of inertia of the rotor", "inertia_basis"),
    text("inertia_basis", optional, "where the rotor inertia comes from"),
    number("mass", "kg", expected, 0.02, 40, "mass of the motor", "mass_basis"),
    text("mass_basis", optional, "where the mass comes from"),
    number("phases_on", "1", optional, 1, 2, "phases energised for the stated holding torque, 1 or 2 (not given: 2)"),
};

inline constexpr ColumnDeclaration stepper_curves[] = {
    number("drive_voltage", "V", required, 5, 400, "supply voltage of the driver", {}, Identity::group),
    number("phase_current", "A", required, 0.05, 20, "set current, of the kind in current_kind", {}, Identity::group),
    text("current_kind", expected, "phase, rms, peak or peak setting"),
    text("driver", optional, "driver the curve was taken with", Identity::group),
    text("step_mode", optional, "full, half, microstep, ...", Identity::group),
    number("speed", "rpm", required, 0, 10000, "speed of the point", {}, Identity::point),
    number("torque", "N.m", required, 0, 60, "pull-out torque at that speed", "torque_basis"),
    text("torque_basis", optional, "how the point was read"),
};

inline constexpr ColumnDeclaration ball_screws[] = {
    text("series", optional, "maker's series"),
    number("nominal_diameter", "mm", required, 2, 200, "catalogue size"),
    number("outside_diameter", "mm", expected, 2, 200, "real outside diameter of the shaft"),
    number("lead", "mm", required, 0.5, 150, "travel a revolution"),
    number("starts", "1", expected, 1, 8, "number of thread starts"),
    number("ball_diameter", "mm", optional, 0.4, 30, "diameter of the balls"),
    number("pitch_circle_diameter", "mm", optional, 2, 220, "ball pitch circle"),
    number("root_diameter", "mm", required, 1.5, 200, "root diameter of the shaft", "root_basis"),
    text("root_basis", optional, "catalogue or computed"),
    number("turns_per_circuit", "1", optional, 0.5, 20, "turns of a ball circuit"),
    number("circuits", "1", optional, 1, 20, "number of ball circuits; loaded turns = turns x circuits"),
    text("nut_type", optional, "flanged single, flanged double, square, ..."),
    flag("preloaded", optional, "nut is preloaded (no backlash)"),
    number("dynamic_load_rating", "N", required, 100, 2e6, "basic dynamic axial load rating Ca for 1e6 revolutions"),
    number("static_load_rating", "N", required, 100, 6e6, "basic static axial load rating C0a"),
    number("nut_stiffness", "N/um", optional, 5, 5000, "catalogue axial rigidity of the nut", "stiffness_basis"),
    text("stiffness_basis", optional, "where the rigidity comes from"),
    number("nut_outside_diameter", "mm", optional, 4, 400, "body diameter of the nut"),
    number("flange_outside_diameter", "mm", optional, 6, 500, "flange diameter of the nut"),
    number("flange_thickness", "mm", optional, 1, 100, "flange thickness of the nut"),
    number("nut_length", "mm", optional, 4, 600, "length of the nut"),
    number("nut_mass", "kg", expected, 0.002, 100, "mass of the nut", "mass_basis"),
    number("screw_mass_per_length", "kg/m", expected, 0.02, 250, "mass of the shaft per length", "mass_basis"),
    text("mass_basis", optional, "where the masses come from"),
    text("accuracy_grade", optional, "C5, C7, C10, T7, ..."),
    number("lead_error_per_300mm", "um", expected, 1, 500, "permissible lead error over any 300 mm"),
    number("maximum_length", "mm", expected, 50, 15000, "longest shaft supplied"),
    number("dn_limit", "mm.rpm", expected, 10000, 400000, "limit of nominal diameter x speed"),
    text("process", optional, "rolled or ground"),
    stock_length,
    cutting_loss,
    cut_price,
    end_machining_price,
};

inline constexpr ColumnDeclaration lead_screws[] = {
    text("designation", expected, "standard designation, matches for_screw of a nut"),
    text("thread_form", required, "trapezoidal 30deg, square, metric 60deg"),
    number("major_diameter", "mm", required, 2, 200, "outside diameter d"),
    number("pitch", "mm", required, 0.2, 60, "pitch P"),
    number("starts", "1", required, 1, 12, "number of thread starts"),
    number("lead", "mm", required, 0.2, 150, "travel a revolution = pitch x starts"),
    number("pitch_diameter", "mm", required, 1.5, 200, "pitch (mean) diameter d2"),
    number("minor_diameter", "mm", required, 1, 200, "core diameter of the screw d3"),
    number("nut_major_diameter", "mm", optional, 2, 210, "major diameter of the nut thread D4"),
    number("nut_minor_diameter", "mm", optional, 1, 200, "minor diameter of the nut thread D1"),
    number("flank_half_angle", "deg", required, 0, 45, "half the thread angle: 15 trapezoidal, 30 metric, 0 square"),
    number("thread_height", "mm", optional, 0.05, 40, "height of the screw thread"),
    number("lead_angle", "deg", optional, 0.2, 60, "lead angle at the pitch diameter"),
    text("material", expected, "material of the screw"),
    number("yield_strength", "MPa", expected, 100, 2000, "yield strength of the screw"),
    number("screw_mass_per_length", "kg/m", expected, 0.02, 250, "mass per length"),
    number("lead_error_per_300mm", "um", expected, 5, 2000, "lead error over 300 mm"),
    number("maximum_length", "mm", expected, 50, 15000, "longest piece supplied"),
    text("standard", optional, "standard of the thread"),
    stock_length,
    cutting_loss,
    cut_price,
    end_machining_price,
};

inline constexpr ColumnDeclaration lead_nuts[] = {
    text("type", optional, "flanged, cylindrical, anti-backlash"),
    text("for_screw", required, "part_number or designation of the lead screw it runs on"),
    number("nominal_diameter", "mm", required, 2, 200, "nominal thread diameter"),
    number("lead", "mm", required, 0.2, 150, "lead of the thread"),
    text("material", expected, "material of the nut"),
    number("length", "mm", required, 2, 400, "length in mesh with the screw"),
    number("outside_diameter", "mm", optional, 4, 400, "body diameter"),
    number("flange_outside_diameter", "mm", optional, 6, 500, "flange diameter"),
    number("mass", "kg", expected, 0.001, 50, "mass of the nut"),
    number("allowable_pressure", "MPa", expected, 0.5, 60, "allowable bearing pressure of a moving thread"),
    number("maximum_pv", "MPa.m/s", expected, 0.01, 10, "limit of pressure x sliding speed"),
    number("maximum_sliding_speed", "m/s", expected, 0.05, 10, "limit of the sliding speed"),
    number("friction_dry", "1", expected, 0.03, 0.6, "coefficient of friction, dry"),
    number("friction_greased", "1", expected, 0.02, 0.5, "coefficient of friction, greased"),
    number("backlash", "mm", optional, 0, 2, "axial play"),
    number("preload_drag_torque", "N.m", optional, 0, 20, "drag of a preloaded nut"),
};

inline constexpr ColumnDeclaration couplings[] = {
    text("type", optional, "beam, jaw, bellows, rigid, ..."),
    number("outside_diameter", "mm", expected, 5, 500, "outside diameter"),
    number("length", "mm", expected, 5, 600, "overall length"),
    number("minimum_bore", "mm", required, 1, 200, "smallest bore"),
    number("maximum_bore", "mm", required, 1, 300, "largest bore"),
    number("rated_torque", "N.m", required, 0.05, 50000, "rated torque"),
    number("maximum_torque", "N.m", optional, 0.05, 100000, "momentary maximum torque"),
    number("torsional_stiffness", "N.m/rad", expected, 1, 1e7, "torsional stiffness"),
    number("inertia", "g.cm2", expected, 0.1, 1e7, "moment of inertia", "inertia_basis"),
    text("inertia_basis", optional, "where the inertia comes from"),
    number("mass", "kg", expected, 0.001, 200, "mass"),
    number("maximum_speed", "rpm", optional, 100, 100000, "maximum speed"),
    number("angular_misalignment", "deg", optional, 0, 10, "permissible angular misalignment"),
    number("parallel_misalignment", "mm", optional, 0, 10, "permissible parallel misalignment"),
    number("axial_misalignment", "mm", optional, 0, 20, "permissible axial misalignment"),
    flag("backlash_free", optional, "transmits without play"),
};

inline constexpr ColumnDeclaration belts[] = {
    text("profile", required, "tooth profile; matches the pulley's"),
    number("pitch", "mm", required, 1, 30, "tooth pitch"),
    number("width", "mm", required, 2, 400, "width"),
    text("material", optional, "body and cord"),
    number("allowable_tension", "N", required, 2, 200000, "allowable working tension of a strand"),
    number("breaking_tension", "N", optional, 10, 1e6, "breaking tension", "breaking_basis"),
    text("breaking_basis", optional, "where the breaking tension comes from"),
    number("mass_per_length", "kg/m", expected, 0.001, 20, "mass per length"),
    number("tensile_stiffness", "N", expected, 1000, 1e8, "EA: force per strain; a span L has stiffness EA/L"),
    number("pitch_line_offset", "mm", optional, 0.05, 5, "pitch line above the tooth root line of the belt"),
    number("minimum_pulley_teeth", "1", expected, 6, 60, "fewest teeth of a pulley"),
    number("maximum_speed", "m/s", optional, 1, 150, "maximum belt speed"),
    stock_length,
    cutting_loss,
    cut_price,
};

inline constexpr ColumnDeclaration pulleys[] = {
    text("type", expected, "pulley or idler"),
    text("profile", required, "tooth profile; matches the belt's"),
    number("pitch", "mm", required, 1, 30, "tooth pitch"),
    number("teeth", "1", required, 6, 400, "number of teeth"),
    number("belt_width", "mm", required, 2, 400, "widest belt"),
    number("bore", "mm", required, 1, 200, "bore"),
    number("pitch_diameter", "mm", expected, 3, 2000, "pitch diameter = teeth x pitch / pi"),
    number("outside_diameter", "mm", optional, 3, 2000, "outside diameter over the teeth"),
    number("flange_diameter", "mm", optional, 3, 2100, "flange diameter"),
    number("overall_width", "mm", optional, 3, 500, "width with hub"),
    text("material", optional, "material"),
    number("mass", "kg", expected, 0.0003, 500, "mass", "inertia_basis"),
    number("inertia", "g.cm2", expected, 0.01, 1e8, "moment of inertia", "inertia_basis"),
    text("inertia_basis", optional, "where mass and inertia come from"),
};

inline constexpr ColumnDeclaration racks[] = {
    number("module", "mm", required, 0.3, 12, "module of the teeth; matches the pinion's"),
    number("pressure_angle", "deg", required, 14, 25, "pressure angle, 20 degrees after DIN 867"),
    number("pitch", "mm", expected, 0.9, 38, "tooth pitch = module x pi"),
    number("face_width", "mm", required, 2, 200, "width of the teeth"),
    number("height", "mm", expected, 3, 200, "from the back to the tips of the teeth"),
    number("pitch_height", "mm", expected, 2, 190, "from the back to the pitch line = height - module"),
    text("material", expected, "material of the teeth"),
    text("quality", optional, "tooth quality: DIN 10 (milled), DIN 6 (ground), ..."),
    number("allowable_stress", "MPa", required, 5, 1000, "allowable static bending stress of a tooth", "stress_basis"),
    text("stress_basis", optional, "where the allowable stress comes from"),
    number("mass_per_length", "kg/m", required, 0.02, 250, "mass per length", "mass_basis"),
    text("mass_basis", optional, "where the mass comes from"),
    number("pitch_error_per_1000mm", "um", expected, 2, 2000, "accumulated pitch error over 1000 mm", "error_basis"),
    text("error_basis", optional, "where the pitch error comes from"),
    number("piece_length", "mm", required, 50, 6000, "length of a piece; longer racks are joined from whole pieces"),
};

inline constexpr ColumnDeclaration pinions[] = {
    number("module", "mm", required, 0.3, 12, "module of the teeth; matches the rack's"),
    number("pressure_angle", "deg", required, 14, 25, "pressure angle, 20 degrees after DIN 867"),
    number("teeth", "1", required, 12, 200, "number of teeth"),
    number("face_width", "mm", required, 2, 200, "width of the teeth"),
    number("bore", "mm", required, 1, 200, "bore"),
    number("pitch_diameter", "mm", expected, 4, 2000, "pitch diameter = module x teeth"),
    number("outside_diameter", "mm", expected, 4, 2000, "diameter over the tips = module x (teeth + 2)"),
    number("overall_width", "mm", optional, 2, 400, "width with hub"),
    text("material", expected, "material of the teeth"),
    number("allowable_stress", "MPa", required, 5, 1000, "allowable static bending stress of a tooth", "stress_basis"),
    text("stress_basis", optional, "where the allowable stress comes from"),
    number("mass", "kg", required, 0.0005, 500, "mass", "inertia_basis"),
    number("inertia", "g.cm2", required, 0.005, 1e8, "moment of inertia", "inertia_basis"),
    text("inertia_basis", optional, "where mass and inertia come from"),
};

inline constexpr ColumnDeclaration drivers[] = {
    text("kind", optional, "step stick, board, box, terminal, motor-mounted"),
    number("minimum_voltage", "V", expected, 2, 400, "lowest supply voltage"),
    number("maximum_voltage", "V", required, 5, 600, "absolute limit of the supply voltage"),
    number("recommended_maximum_voltage", "V", expected, 5, 600, "highest working supply voltage"),
    number("rms_current", "A", expected, 0.1, 50, "greatest RMS current per phase"),
    number("peak_current", "A", required, 0.1, 80, "greatest peak current per phase"),
    number("maximum_microsteps", "1", expected, 1, 1024, "finest microstepping, steps per full step"),
    text("interface", optional, "step/dir, UART, EtherCAT, ..."),
    flag("closed_loop", optional, "needs an encoder"),
    number("overvoltage_trip", "V", optional, 5, 800, "voltage at which it switches off"),
    number("mass", "kg", expected, 0.001, 20, "mass"),
};

inline constexpr ColumnDeclaration power_supplies[] = {
    number("output_voltage", "V", required, 3, 400, "nominal output voltage"),
    number("output_current", "A", required, 0.1, 500, "rated output current"),
    number("power", "W", required, 2, 20000, "rated output power"),
    number("adjustment_minimum", "V", optional, 2, 400, "lowest output voltage that can be set"),
    number("adjustment_maximum", "V", optional, 2, 500, "highest output voltage that can be set"),
    text("input", optional, "mains range"),
    number("efficiency", "%", expected, 50, 100, "efficiency at full load"),
    number("length", "mm", optional, 10, 1000, "length"),
    number("width", "mm", optional, 10, 1000, "width"),
    number("height", "mm", optional, 5, 1000, "height"),
    number("mass", "kg", expected, 0.02, 50, "mass"),
    number("peak_current", "A", optional, 0.1, 1000, "momentary output current"),
};

}  // namespace millwright::catalogue::columns
