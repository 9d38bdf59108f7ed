// SPDX-License-Identifier: Apache-2.0
#include "evaluation/drive_drawing.h"

#include <algorithm>
#include <cmath>

namespace millwright::evaluation {

namespace {

using machine::MotionData;
using machine::Move;

/// A path of even accelerations, drawn point by point.
class Path {
 public:
  explicit Path(std::vector<MotionPoint>& points) : points_(points) { points_.push_back({}); }

  /// To another speed in that time; `sign`: which way the axis goes.
  void go(double speed, double duration, double sign) {
    if (!(duration > 0.0)) return;
    const MotionPoint from = points_.back();
    const double before = std::abs(from.speed);
    constexpr int steps = 6;  // the position is a parabola
    const int count = before == speed ? 1 : steps;
    for (int i = 1; i <= count; ++i) {
      const double share = i / static_cast<double>(count);
      const double now = before + share * (speed - before);
      points_.push_back(
          {from.time + share * duration, sign * now, from.position + sign * 0.5 * (before + now) * share * duration});
    }
  }

 private:
  std::vector<MotionPoint>& points_;
};

/// One way of a move with two equal ramps.
void go_one_way(Path& path, const Move& move, double ramp, double sign) {
  const double speed = move.speed ? *move.speed : move.distance / std::max(*move.time - ramp, 1e-3 * *move.time);
  const double constant = std::max(0.0, move.distance / speed - ramp);
  if (!move.jerk) {
    path.go(speed, ramp, sign);
    path.go(speed, constant, sign);
    path.go(0.0, ramp, sign);
    return;
  }
  // Acceleration rises in t_j, stays for t_c and falls in t_j.
  const double even = std::sqrt(std::max(0.0, ramp * ramp - 4.0 * speed / *move.jerk));
  const double changing = 0.5 * (ramp - even);
  const double peak = 2.0 * speed / (ramp + even);
  const auto speed_at = [&](double t) {
    const double slope = changing > 0.0 ? peak / changing : 0.0;
    if (t < changing) return 0.5 * slope * t * t;
    if (t < changing + even) return 0.5 * peak * changing + peak * (t - changing);
    const double left = ramp - t;
    return speed - 0.5 * slope * left * left;
  };
  constexpr int steps = 24;
  for (int i = 1; i <= steps; ++i) path.go(speed_at(ramp * i / steps), ramp / steps, sign);
  path.go(speed, constant, sign);
  for (int i = steps - 1; i >= 0; --i) path.go(i == 0 ? 0.0 : speed_at(ramp * i / steps), ramp / steps, sign);
}

/// The recorded phases in their order.
bool go_recorded(Path& path, const machine::MeasuredProfile& profile) {
  if (profile.phases.size() > machine::exact_phases) return false;
  for (const machine::ProfilePhase& phase : profile.phases) {
    const double sign = phase.backwards ? -1.0 : 1.0;
    const double change = std::abs(phase.acceleration) * phase.duration;
    const double slow = std::max(0.0, phase.speed - change);
    path.go(phase.acceleration < 0.0 ? phase.speed : slow, 1e-9, sign);
    path.go(phase.acceleration < 0.0 ? slow : phase.speed, phase.duration, sign);
  }
  return true;
}

template <class Drive>
DriveDrawing drawing(const Drive& d, const std::string& axis) {
  DriveDrawing result;
  result.axis = axis;
  result.rotary = d.data->motion.rotary;
  result.stroke = d.data->stroke;
  double dwell = 0.0;
  double longest = 0.0;
  for (const Move& move : d.data->motion.moves) {
    dwell += machine::runs(d.data->motion, move) * move.dwell;
    longest = std::max(longest, move.dwell);
  }
  constexpr double dwell_share = 0.25;  // of the moving time, for one dwell
  const double shown = dwell_share * (d.cycle.total_time - dwell);
  result.dwells_shortened = dwell > d.cycle.total_time - dwell && longest > shown;
  result.motion = result.dwells_shortened ? motion_over_time(d.data->motion, d.acceleration_time, shown)
                                          : motion_over_time(d.data->motion, d.acceleration_time);
  const std::vector<std::string> names = machine::phase_names(d.data->motion);
  double fastest = d.peak_speed;
  for (std::size_t i = 0; i < d.motor_torques.size(); ++i) {
    result.phases.push_back({names[i],
                             d.angular_speeds[i],
                             std::abs(d.motor_torques[i]),
                             d.torque_ratios[i],
                             d.cycle.phases[i].may_govern});
    fastest = std::max(fastest, d.angular_speeds[i]);
  }
  constexpr int samples = 96;
  constexpr double beyond = 1.4;
  for (int i = 0; i <= samples; ++i) {
    const double speed = beyond * fastest * i / samples;
    result.pull_out.emplace_back(speed, d.available_torque(speed));
  }
  result.torque_margin = d.motor.torque_margin;
  return result;
}

constexpr double um_per_kilonewton = 1e9;  // of one m/N

void add_compliance(DriveDrawing& to, const char* what, double metres_per_newton) {
  if (std::isfinite(metres_per_newton) && metres_per_newton > 0.0)
    to.compliance.push_back({what, um_per_kilonewton * metres_per_newton});
}

/// Of what turns: the reduction and the motor's field, over the travel of one radian of the output.
template <class Drive>
void add_turning(DriveDrawing& to, const Drive& d, double travel) {
  if (d.reduction.present) add_compliance(to, "reduction", travel * travel * d.reduction.compliance);
  add_compliance(to, "motor's field", travel * travel * d.reduction.reflected(1.0 / machine::motor_stiffness(d.motor)));
}

}  // namespace

std::vector<MotionPoint> motion_over_time(const MotionData& motion, double acceleration_time, double longest_dwell) {
  std::vector<MotionPoint> points;
  Path path(points);
  for (const Move& move : motion.moves) {
    for (int run = 0; run < machine::runs(motion, move); ++run) {
      if (!move.profile)
        go_one_way(path, move, move.acceleration_time.value_or(acceleration_time), run == 0 ? 1.0 : -1.0);
      else if (!go_recorded(path, *move.profile))
        return {};
      path.go(0.0, std::min(move.dwell, longest_dwell), 1.0);
    }
  }
  return points;
}

DriveDrawing drawing_of(const machine::ScrewDrive<double>& d, const std::string& axis) {
  DriveDrawing result = drawing(d, axis);
  const double travel = d.screw.lead / (2.0 * std::numbers::pi);
  const double held = 1.0 / machine::held_stiffness(d);
  add_compliance(result, "screw and thrust bearings", held);
  if (d.ball() == machine::Applies::yes)
    add_compliance(result, "nut", 1.0 / machine::least_axial_stiffness(d, machine::working_force(d)) - held);
  const double twist = 1.0 / machine::torsional_stiffness(d) - (d.reduction.present ? d.reduction.compliance : 0.0);
  add_compliance(result, "twist of screw and coupling", travel * travel * twist);
  add_turning(result, d, travel);
  return result;
}

DriveDrawing drawing_of(const machine::BeltDrive<double>& d, const std::string& axis) {
  DriveDrawing result = drawing(d, axis);
  add_compliance(result, "belt", 1.0 / machine::belt_stiffness(d));
  add_turning(result, d, d.radius);
  return result;
}

DriveDrawing drawing_of(const machine::RackDrive<double>& d, const std::string& axis) {
  DriveDrawing result = drawing(d, axis);
  add_turning(result, d, d.radius);
  return result;
}

DriveDrawing drawing_of(const machine::RotaryDrive<double>& d, const std::string& axis) { return drawing(d, axis); }

}  // namespace millwright::evaluation
