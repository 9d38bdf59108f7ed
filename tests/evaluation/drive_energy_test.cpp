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
    const int directions = std::sin(motion.inclination) > 1e-9 ? 2 : 1;
    for (const machine::Move& move : motion.moves)
      for (int way = 0; way < directions; ++way) run(move, way == 0 ? 1.0 : -1.0);
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
      if (t < ramp) v = speed * t / ramp, a = speed / ramp;
      if (t > time - ramp) v = speed * (time - t) / ramp, a = -speed / ramp;
      energy_ += dt * power(v, a, up, move.force);
    }
    energy_ += move.dwell * power(0.0, 0.0, 0.0, 0.0);
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

}  // namespace

// Without jerk and profiles, and with moves that have time for their ramps, the closed form is exact.
TEST_CASE("The energy of a cycle is the integral of the drive's input power") {
  machine::Problem sander = shipped_problem("sander");
  machine::Problem lifter = shipped_problem("lifter");
  machine::Problem rotary = shipped_problem("rotary-table");
  for (machine::Problem* problem : {&sander, &lifter, &rotary}) {
    problem->counted = {Quantity::energy};
    const MachineModel model(*problem, shipped_catalogue());
    std::mt19937 random(5);
    for (const evaluation::StageEntry& entry : model.entries()) {
      std::visit(
          [&](const auto& stage) {
            if constexpr (requires { stage->motors(); }) {
              for (int n = 0; n < (sanitized ? 3 : 20); ++n) {
                std::vector<solver::Row> chosen;
                for (const solver::Slot& slot : stage->slots())
                  chosen.push_back(static_cast<solver::Row>(random()) % slot.rows);
                std::vector<double> ramp;
                for (const solver::Variable& v : stage->variables())
                  ramp.push_back(v.lower + (v.upper - v.lower) * static_cast<double>(random() % 1000) / 1000.0);
                const std::vector<solver::Row> shared{0};
                const std::vector<double> state(model.problem().first_state.size(), 1.0 + n);
                solver::Answer<double> answer;
                stage->evaluate({shared, state, chosen, ramp}, answer);
                std::vector<solver::RowsAlive> rows;
                for (const solver::Row& row : chosen) rows.emplace_back(std::span(&row, 1));
                const auto drive = stage->template design<double>(
                    {.shared = shared, .rows = rows, .inherited = state, .variables = ramp});
                if (drive.cycle.time_ratio > 1.0) continue;
                double drives = 1.0;
                for (const machine::Axis& axis : problem->axes)
                  if (axis.name == entry.axis) drives = axis.mechanism.drives;
                INFO(problem->title << " " << entry.axis);
                CHECK(answer.resources[model.resource(Quantity::energy)] ==
                      Approx(drives * Integrated(drive).energy()).epsilon(2e-4));
              }
            }
          },
          entry.stage);
    }
  }
}

}  // namespace drive_energy_test
