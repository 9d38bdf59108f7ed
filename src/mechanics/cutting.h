// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mechanics/validity_watch.h"
#include "scalar/elementary.h"

/// Process loads: milling, drilling, grinding, sanding, extruding. Everything in SI.
/// Valid, besides what a formula says: sharp tool, stationary cutting.
namespace millwright::mechanics::cutting {

using namespace scalar;

/// Speed of the cutting edge (m/s). [sandvik_milling]
template <class T>
T cutting_speed(const T& diameter, const T& spindle_speed) {
  return diameter * spindle_speed / 2.0;
}

/// Feed speed from the feed per tooth (m/s). [sandvik_milling]
template <class T>
T feed_speed(const T& feed_per_tooth, const T& teeth, const T& spindle_speed) {
  return feed_per_tooth * teeth * spindle_speed / (2.0 * pi<T>());
}

/// Mean chip thickness in peripheral milling over the arc of engagement (m). Valid: engagement at most the diameter.
/// [sandvik_milling]
template <class T>
T mean_chip_thickness(const T& feed_per_tooth, const T& radial_engagement, const T& diameter, const T& entering_angle) {
  watch_validity<T>("cutting.mean_chip_thickness", feed_per_tooth, radial_engagement, diameter, entering_angle);
  const T engagement_angle = named("φ_s", acos(1.0 - 2.0 * radial_engagement / diameter));
  return 2.0 * feed_per_tooth * radial_engagement * sin(entering_angle) / (diameter * engagement_angle);
}

/// Specific cutting force after Kienzle (Pa). At 1 mm: steel 1500 to 1950 MPa, stainless 1800 to 2000, grey iron 800 to
/// 1100, aluminium 350 to 700, brass 550 to 700, plastics 150 to 250; exponent about 0.25. Worn tools 30 % more.
/// [sandvik_milling]
template <class T>
T specific_cutting_force(const T& unit_specific_force,
                         const T& chip_thickness,
                         const T& exponent,
                         const T& rake_angle) {
  watch_validity<T>("cutting.specific_cutting_force", unit_specific_force, chip_thickness, exponent, rake_angle);
  return unit_specific_force * pow(chip_thickness / in_unit<T>(1e-3, dimension::length), -exponent) *
         (1.0 - 1.8 * rake_angle / pi<T>());
}

/// Volume removed per time (m³/s). [sandvik_milling]
template <class T>
T removal_rate(const T& axial_depth, const T& radial_engagement, const T& feed_speed) {
  return axial_depth * radial_engagement * feed_speed;
}

/// Cutting power (W). [sandvik_milling]
template <class T>
T cutting_power(const T& specific_cutting_force, const T& removal_rate) {
  return specific_cutting_force * removal_rate;
}

/// Time mean of the tangential cutting force (N). [sandvik_milling]
template <class T>
T mean_tangential_force(const T& cutting_power, const T& cutting_speed) {
  return cutting_power / cutting_speed;
}

/// Largest tangential force of one tooth in peripheral milling (N); times the teeth in cut if there are several. The
/// helix is left out, on the safe side. Valid: engagement at most the diameter. [sandvik_milling]
template <class T>
T peak_tooth_force(const T& unit_specific_force,
                   const T& exponent,
                   const T& axial_depth,
                   const T& feed_per_tooth,
                   const T& radial_engagement,
                   const T& diameter) {
  watch_validity<T>("cutting.peak_tooth_force",
                    unit_specific_force,
                    exponent,
                    axial_depth,
                    feed_per_tooth,
                    radial_engagement,
                    diameter);
  const T cosine = named("cos φ_s", 1.0 - 2.0 * radial_engagement / diameter);
  const T thickness = named("h_max", T(where_below(cosine, T(0.0), feed_per_tooth, [&](const T& positive) -> T {
                              return feed_per_tooth * sqrt(1.0 - square(positive));
                            })));
  return specific_cutting_force(unit_specific_force, thickness, exponent, T(0.0)) * axial_depth * thickness;
}

/// Torque at the spindle (N·m). [sandvik_milling]
template <class T>
T spindle_torque(const T& cutting_power, const T& spindle_speed) {
  return cutting_power / spindle_speed;
}

/// Force on an axis as a share of the tangential force (N): table axes 1, along the tool 0.3 to 0.5. [altintas2012]
template <class T>
T axis_force(const T& tangential_force, const T& force_ratio) {
  return force_ratio * tangential_force;
}

/// Feed force of a drill (N). [sandvik_milling]
template <class T>
T drill_thrust(const T& specific_cutting_force,
               const T& diameter,
               const T& feed_per_revolution,
               const T& half_point_angle) {
  watch_validity<T>("cutting.drill_thrust", specific_cutting_force, diameter, feed_per_revolution, half_point_angle);
  return 0.5 * specific_cutting_force * diameter / 2.0 * feed_per_revolution * sin(half_point_angle);
}

/// Equivalent chip thickness in grinding (m). [sander, eq. 4]
template <class T>
T equivalent_chip_thickness(const T& depth_of_cut, const T& feed_speed, const T& wheel_speed) {
  return depth_of_cut * feed_speed / wheel_speed;
}

/// Tangential grinding force (N); the specific force belongs to 1 µm of equivalent chip thickness. Very material
/// dependent. [sander, eq. 5]
template <class T>
T grinding_force(const T& specific_tangential_force,
                 const T& equivalent_chip_thickness,
                 const T& exponent,
                 const T& active_width) {
  return specific_tangential_force * pow(equivalent_chip_thickness / in_unit<T>(1e-6, dimension::length), exponent) *
         active_width;
}

/// Tangential force of a sanding wheel or pad (N). Friction 0.3 to 0.6, pressure 5 to 40 kPa. [millwright_derivations,
/// definition]
template <class T>
T sanding_force(const T& friction, const T& contact_pressure, const T& contact_area) {
  watch_validity<T>("cutting.sanding_force", friction, contact_pressure, contact_area);
  return friction * contact_pressure * contact_area;
}

/// Pressure drop of melt in a nozzle land (Pa). Entry loss adds about as much. Valid: Newtonian melt, laminar.
/// [bird_stewart_lightfoot2002, 2.3]
template <class T>
T extrusion_pressure(const T& viscosity, const T& land_length, const T& flow_rate, const T& nozzle_diameter) {
  return 128.0 * viscosity * land_length * flow_rate / (pi<T>() * pow(nozzle_diameter, 4.0));
}

/// Force that pushes filament against the melt pressure (N). Valid: no slip of the filament drive.
/// [millwright_derivations, definition]
template <class T>
T extrusion_force(const T& pressure, const T& filament_diameter) {
  return pressure * pi<T>() * square(filament_diameter) / 4.0;
}

/// Volume removed per time in traverse grinding (m³/s). [sander, eq. 2]
template <class T>
T grinding_removal_rate(const T& depth_of_cut, const T& axial_feed, const T& overlap, const T& feed_speed) {
  watch_validity<T>("cutting.grinding_removal_rate", depth_of_cut, axial_feed, overlap, feed_speed);
  return depth_of_cut * axial_feed * overlap * feed_speed;
}

/// Power of the equivalent chip thickness in micrometres by which grinding forces grow. [sander, eq. 5]
template <class T>
T chip_thickness_factor(const T& equivalent_chip_thickness, const T& exponent) {
  return pow(equivalent_chip_thickness / in_unit<T>(1e-6, dimension::length), exponent);
}

/// Tangential grinding force per active width (N/m); the constant belongs to 1 µm of equivalent chip thickness.
/// [sander, eq. 5]
template <class T>
T specific_grinding_force(const T& specific_tangential_force, const T& equivalent_chip_thickness, const T& exponent) {
  return specific_tangential_force * chip_thickness_factor(equivalent_chip_thickness, exponent);
}

/// Normal grinding force per active width (N/m). [sander, eq. 6]
template <class T>
T specific_normal_force(const T& specific_tangential_force,
                        const T& friction,
                        const T& equivalent_chip_thickness,
                        const T& exponent) {
  watch_validity<T>(
      "cutting.specific_normal_force", specific_tangential_force, friction, equivalent_chip_thickness, exponent);
  return specific_tangential_force / friction * chip_thickness_factor(equivalent_chip_thickness, exponent);
}

/// Grinding force over the active width (N). [sander, eq. 7]
template <class T>
T force_of_width(const T& specific_force, const T& active_width) {
  return specific_force * active_width;
}

}  // namespace millwright::mechanics::cutting
