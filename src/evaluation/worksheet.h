// SPDX-License-Identifier: Apache-2.0
//
// What stands behind the figures of one design, for a report: how both sides of every check come about, on numbers that
// remember their formulas, and what is drawn of each drive. Made only when it is asked for.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scalar/traced.h"

namespace millwright::evaluation {

/// One part of a sum.
struct Contribution {
  std::string what;
  double value = 0.0;  ///< in the unit of the sum
};

/// A figure that a calculation starts from: of a part, of the problem, or from another calculation.
struct GivenFigure {
  std::string symbol, meaning;
  double value = 0.0;  ///< SI
  std::string unit;    ///< to show it in
  std::string axis;    ///< from the calculation of whose drive it comes; empty for other figures
};

/// A figure that moves or other calculations start from and that is not a side of a check.
struct DerivedFigure {
  std::string move;  ///< to which it belongs; empty if to none
  std::string title, symbol, unit;
  scalar::Traced value;
};

/// Demand and capacity of one check.
struct CheckSides {
  std::string id;
  scalar::Traced demand, capacity;
};

/// The calculation of one element: a drive, a guide, a member, the supply, the machine as a whole.
struct ElementWorksheet {
  std::string axis, element;
  std::vector<GivenFigure> given;  ///< by their symbols; not all are used in every calculation
  std::vector<CheckSides> checks;  ///< in the order in which Design::checks has those of this element
  std::vector<DerivedFigure> derived;
};

/// One phase of the duty cycle at the motor.
struct DrivePhase {
  std::string name;
  double motor_speed = 0.0;   ///< rad/s, the largest in the phase
  double motor_torque = 0.0;  ///< N.m, as a magnitude
  double torque_ratio = 0.0;  ///< over the torque that is available at that speed; 0 where it cannot govern
  bool may_govern = true;     ///< whether C-ST-TORQUE looks at it
};

/// Speed and position over time, one point after the other; straight lines of speed between them.
struct MotionPoint {
  double time = 0.0, speed = 0.0, position = 0.0;  ///< s; m or rad
};

/// What is drawn of a drive.
struct DriveDrawing {
  std::string axis;
  bool rotary = false;
  double stroke = 0.0;  ///< m or rad
  std::vector<MotionPoint> motion;
  bool dwells_shortened = false;  ///< in `motion`, so that the moves can be seen beside long dwells
  std::vector<DrivePhase> phases;
  std::vector<std::pair<double, double>> pull_out;  ///< rad/s, N.m: torque that is available at a speed
  double motor_size = 0.0;                          ///< m, side of its flange
  double torque_margin = 1.0;                       ///< permitted share of it
  bool torque_is_estimate = false;                  ///< no published curve
  std::vector<Contribution> compliance;             ///< along the travel, um/kN (rotary: none), part by part
};

struct Worksheet {
  std::vector<ElementWorksheet> elements;
  std::vector<DriveDrawing> drives;
};

}  // namespace millwright::evaluation
