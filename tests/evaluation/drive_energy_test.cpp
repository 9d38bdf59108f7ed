// SPDX-License-Identifier: Apache-2.0
// The energy of a drive's cycle, in closed form, against the integral of its input power over time.
#include <random>

#include "catch.h"
#include "evaluation/machine_stages.h"
#include "evaluation/machines.h"
#include "sanitized.h"

namespace drive_energy_test {

using namespace millwright;
using evaluation::MachineModel;
using machine::Quantity;

namespace {

/// Energy of a drive's cycle by small steps of time: speed and acceleration at each, the force, the torque by the
/// formula of its kind, and the power.
template <class Drive>
class Integrated {
 public:
  explicit Integrated(const Drive& drive) : d_(drive) {
    const machine::MotionData& motion = d_.data->motion;
    for (const machine::Move& move : motion.moves) {
      const int ways = move.returns || std::sin(motion.inclination) > 1e-9 ? 2 : 1;
      for (int way = 0; way < ways; ++way) run(move, way == 0 ? 1.0 : -1.0);
    }
  }
  [[nodiscard]] double energy() const { return energy_; }

 private:
  void run(const machine::Move& move, double up) {
    const double ramp = move.acceleration_time.value_or(d_.acceleration_time);
    const double speed = move.speed ? *move.speed : move.distance / (*move.time - ramp);
    const double time = move.distance / speed + ramp;
    constexpr int steps = 20000;
    const double dt = time / steps;
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 0.5) * dt;
      double v = speed, a = 0.0;
      if (t < ramp) v = ramp_speed(move, speed, ramp, t), a = ramp_acceleration(move, speed, ramp, t);
      if (t > time - ramp)
        v = ramp_speed(move, speed, ramp, time - t), a = -ramp_acceleration(move, speed, ramp, time - t);
      energy_ += dt * power(v, a, up, move.force);
    }
    energy_ += move.dwell * power(0.0, 0.0, 0.0, 0.0);
  }

  /// Time for which the acceleration rises, and falls: a = j t_j and v = a (t - t_j).
  static double rise(const machine::Move& move, double speed, double ramp) {
    return 0.5 * (ramp - std::sqrt(ramp * ramp - 4.0 * speed / *move.jerk));
  }
  static double ramp_acceleration(const machine::Move& move, double speed, double ramp, double t) {
    if (!move.jerk) return speed / ramp;
    return *move.jerk * std::min({t, ramp - t, rise(move, speed, ramp)});
  }
  static double ramp_speed(const machine::Move& move, double speed, double ramp, double t) {
    if (!move.jerk) return speed * t / ramp;
    const double r = rise(move, speed, ramp);
    if (t < r) return 0.5 * *move.jerk * t * t;
    if (t > ramp - r) return speed - 0.5 * *move.jerk * (ramp - t) * (ramp - t);
    return *move.jerk * r * (t - 0.5 * r);
  }

  [[nodiscard]] double power(double v, double a, double up, double process) const {
    const double force =
        mass() * (a + up * 9.80665 * std::sin(d_.data->motion.inclination)) + d_.cycle.friction_force + process;
    const double k = per_metre();
    const double omega = k * v;
    const double iron = d_.motor.holding_torque * (0.03 + 0.0005 * omega) * omega;
    const double shaft = v > 0.0 ? std::max(0.0, torque(force, k * a) * omega) : 0.0;
    return (d_.motor.copper_loss + shaft + iron) / 0.9;
  }

  [[nodiscard]] double mass() const {
    if constexpr (requires { d_.screw; })
      return d_.moved_mass;
    else
      return d_.travelling_mass;
  }
  [[nodiscard]] double per_metre() const {
    const double ratio = d_.reduction.present ? d_.reduction.ratio : 1.0;
    if constexpr (requires { d_.screw; })
      return ratio * 2.0 * 3.14159265358979323846 / d_.screw.lead;
    else
      return ratio / d_.radius;
  }
  [[nodiscard]] double torque(double force, double alpha) const {
    const double ratio = d_.reduction.present ? d_.reduction.ratio : 1.0;
    const double reducer = d_.reduction.present ? d_.reduction.efficiency : 1.0;
    if constexpr (requires { d_.screw; })
      return mechanics::actuation::screw_motor_torque(force,
                                                      d_.screw.lead,
                                                      d_.screw.efficiency,
                                                      d_.screw.reverse_efficiency,
                                                      d_.rotating_inertia,
                                                      alpha,
                                                      d_.screw.drag_torque / (ratio * reducer),
                                                      ratio,
                                                      reducer);
    else
      return mechanics::actuation::belt_motor_torque(
          force, d_.radius, d_.efficiency, d_.rotating_inertia, alpha, 0.0, ratio);
  }

  const Drive& d_;
  double energy_ = 0.0;
};

/// The energy of drives that are picked at random, against the integral.
void check_energies(machine::Problem problem) {
  problem.counted = {Quantity::energy};
  const MachineModel model(problem, shipped_catalogue());
  std::mt19937 random(5);
  int checked = 0;
  const auto check = [&](const evaluation::StageEntry& entry, const auto& stage) {
    std::vector<solver::Row> chosen;
    for (const solver::Slot& slot : stage.slots()) chosen.push_back(static_cast<solver::Row>(random()) % slot.rows);
    std::vector<double> ramp;
    for (const solver::Variable& v : stage.variables())
      ramp.push_back(v.lower + (v.upper - v.lower) * static_cast<double>(random() % 1000) / 1000.0);
    const std::vector<solver::Row> shared{0};
    const std::vector<double> state(model.problem().first_state.size(), 1.0 + checked);
    solver::Answer<double> answer;
    stage.evaluate({shared, state, chosen, ramp}, answer);
    std::vector<solver::RowsAlive> rows;
    for (const solver::Row& row : chosen) rows.emplace_back(std::span(&row, 1));
    const auto drive =
        stage.template design<double>({.shared = shared, .rows = rows, .inherited = state, .variables = ramp});
    const auto recorded = [](const machine::Move& move) { return move.profile.has_value(); };
    if (std::any_of(drive.data->motion.moves.begin(), drive.data->motion.moves.end(), recorded)) return;
    if (drive.cycle.time_ratio > 1.0) return;
    double drives = 1.0;
    for (const machine::Axis& axis : problem.axes)
      if (axis.name == entry.axis) drives = axis.mechanism.drives;
    INFO(problem.title << " " << entry.axis);
    CHECK(answer.resources[model.resource(Quantity::energy)] ==
          Approx(drives * Integrated(drive).energy()).epsilon(2e-4));
    ++checked;
  };
  for (const evaluation::StageEntry& entry : model.entries())
    std::visit(
        [&](const auto& stage) {
          if constexpr (requires { stage->motors(); })
            for (int n = 0; n < (sanitized ? 3 : 20); ++n) check(entry, *stage);
        },
        entry.stage);
  CHECK(checked > 0);
}

}  // namespace

// Without profiles, and with moves that have time for their ramps, the closed form is exact.
TEST_CASE("The energy of a cycle is the integral of the drive's input power") {
  for (const char* name : {"sander", "lifter", "rotary-table"}) check_energies(shipped_problem(name));
}

// So it is with jerk, as long as a force does not turn within a ramp: 900 N of process keep it.
TEST_CASE("The energy of jerk-limited moves, and of those that return, is the integral of the drive's input power") {
  machine::Problem problem = shipped_problem("inserter");
  int returning = 0;
  for (machine::Axis& axis : problem.axes)
    for (machine::Move& move : axis.moves) {
      if (move.profile) continue;
      CHECK(move.jerk);
      move.force = 900.0;
      move.returns = move.name == "to the board";
      returning += move.returns ? 1 : 0;
    }
  CHECK(returning == 2);
  check_energies(problem);
}

}  // namespace drive_energy_test
