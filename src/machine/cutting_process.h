// SPDX-License-Identifier: Apache-2.0
//
// Peripheral milling as a move's process: what the cutter does fixes the feed, the force along the axis and the power
// at the spindle. Written in a move as
//
//     cutting = { material = "aluminium", depth = "2 mm", width = "3 mm", feed_per_tooth = "0.05 mm", teeth = 2,
//                 diameter = "6 mm", cutting_speed = "200 m/min", spindle_power = "500 W" }
#pragma once

#include <string>

#include "mechanics/cutting.h"

namespace millwright::machine {

struct CuttingProcess {
  std::string material;              ///< a group of materials, empty if the specific force is given
  double unit_specific_force = 0.0;  ///< Pa, of a chip of 1 mm (Kienzle's k_c1.1)
  double exponent = 0.25;            ///< by which the specific force falls with the thickness of the chip
  double depth = 0.0;                ///< m, along the cutter
  double width = 0.0;                ///< m, radial engagement
  double feed_per_tooth = 0.0;       ///< m
  double teeth = 2.0;
  double diameter = 0.0;       ///< m, of the cutter
  double cutting_speed = 0.0;  ///< m/s
  double force_ratio = 1.0;    ///< force on this axis over the tangential force
  double spindle_power = 0.0;  ///< W that the spindle has; 0 = not stated

  /// m/s along the axis.
  [[nodiscard]] double feed_speed() const;
  /// How many teeth can be in the cut at once.
  [[nodiscard]] double teeth_in_cut() const;
  /// N along the axis, at its largest: every tooth in the cut at its thickest chip.
  [[nodiscard]] double largest_force() const;
};

/// Feed along the axis [m/s], from the cutting speed at the edge.
template <class T>
T cutting_feed(const CuttingProcess& process) {
  using namespace scalar;
  const T spindle = named(
      "ω_s",
      2.0 * in_unit<T>(process.cutting_speed, dimension::speed) / in_unit<T>(process.diameter, dimension::length));
  return mechanics::cutting::feed_speed(
      in_unit<T>(process.feed_per_tooth, dimension::length), T(process.teeth), spindle);
}

/// Force along the axis [N], at its largest: every tooth in the cut at its thickest chip.
template <class T>
T cutting_force(const CuttingProcess& process) {
  using namespace scalar;
  namespace ct = mechanics::cutting;
  const auto length = [](double metres) { return in_unit<T>(metres, dimension::length); };
  const T tooth = named("F_z",
                        ct::peak_tooth_force(in_unit<T>(process.unit_specific_force, dimension::pressure),
                                             T(process.exponent),
                                             length(process.depth),
                                             length(process.feed_per_tooth),
                                             length(process.width),
                                             length(process.diameter)));
  return ct::axis_force(T(process.teeth_in_cut() * tooth), T(process.force_ratio));
}

/// Power at the cutting edges [W], of a sharp tool, by the mean thickness of the chip.
template <class T>
T cutting_power(const CuttingProcess& process) {
  using namespace scalar;
  namespace ct = mechanics::cutting;
  const auto length = [](double metres) { return in_unit<T>(metres, dimension::length); };
  const T right_angle = 0.5 * pi<T>();
  const T thickness =
      named("h_m",
            ct::mean_chip_thickness(
                length(process.feed_per_tooth), length(process.width), length(process.diameter), right_angle));
  const T specific =
      named("k_c",
            ct::specific_cutting_force(
                in_unit<T>(process.unit_specific_force, dimension::pressure), thickness, T(process.exponent), T(0.0)));
  const T removal = named(
      "Q", ct::removal_rate(length(process.depth), length(process.width), T(named("v_f", cutting_feed<T>(process)))));
  return ct::cutting_power(specific, removal);
}

}  // namespace millwright::machine
