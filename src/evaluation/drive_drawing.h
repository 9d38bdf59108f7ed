// SPDX-License-Identifier: Apache-2.0
//
// What a report draws of a drive: its motion over time, torque over speed, and how it gives way.
#pragma once

#include <limits>

#include "evaluation/machine_stages.h"
#include "evaluation/worksheet.h"

namespace millwright::evaluation {

/// Speed and position over one cycle, up and down where gravity acts, with dwells of at most `longest_dwell` [s]. Empty
/// where a move is a recording that was gathered: then its phases are known and no longer their order.
std::vector<MotionPoint> motion_over_time(const machine::MotionData& motion,
                                          double acceleration_time,
                                          double longest_dwell = std::numeric_limits<double>::infinity());

/// Without what only the motor's row says: its size, and whether its torque is an estimate.
DriveDrawing drawing_of(const machine::ScrewDrive<double>& drive, const std::string& axis);
DriveDrawing drawing_of(const machine::BeltDrive<double>& drive, const std::string& axis);
DriveDrawing drawing_of(const machine::RackDrive<double>& drive, const std::string& axis);
DriveDrawing drawing_of(const machine::RotaryDrive<double>& drive, const std::string& axis);

}  // namespace millwright::evaluation
