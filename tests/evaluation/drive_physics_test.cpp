// SPDX-License-Identifier: Apache-2.0
// What must hold of any drive, whichever the parts: heavier is never easier, slower is never harder on the motor, a
// published curve counts only where it was measured.
#include <algorithm>
#include <map>
#include <random>

#include "catch.h"
#include "evaluation/machine_stages.h"
#include "evaluation/machines.h"
#include "evaluation/random_boxes.h"

namespace drive_physics_test {

using namespace millwright;
using evaluation::MachineModel;
using evaluation::ScrewDriveStage;
using evaluation::Selection;

namespace {

const MachineModel& sander() {
  static const MachineModel model(shipped_problem("sander"), shipped_catalogue());
  return model;
}

const ScrewDriveStage& drive_of(const std::string& axis) {
  for (const auto& entry : sander().entries())
    if (entry.axis == axis && entry.element == "drive") return *std::get<std::unique_ptr<ScrewDriveStage>>(entry.stage);
  throw std::runtime_error("no axis " + axis);
}

machine::ScrewDrive<double> design_of(const ScrewDriveStage& stage, const SampledPoint& p) {
  std::vector<solver::RowsAlive> rows;
  for (const Row& row : p.rows) rows.emplace_back(std::span(&row, 1));
  return stage.design<double>({.shared = p.shared, .rows = rows, .inherited = p.inherited, .variables = p.variables});
}

double utilisation_of(const machine::ScrewDrive<double>& d, std::string_view id) {
  double result = -1.0;
  machine::screw_drive_constraints([&](const machine::Declaration& declaration, auto, auto demand, auto capacity) {
    if (declaration.id == id) result = demand(d) / capacity(d);
  });
  return result;
}

}  // namespace

TEST_CASE("A heavier load is never easier for a horizontal drive") {
  const ScrewDriveStage& stage = drive_of("x");
  BoxSampler sampler(stage, 3, sander().problem().first_state.size(), 21);
  for (int n = 0; n < 3000; ++n) {
    const SampledPoint light = sampler.point(sampler.box());
    SampledPoint heavy = light;
    for (double& load : heavy.inherited) load *= 1.0 + sampler.uniform();
    const auto a = design_of(stage, light), b = design_of(stage, heavy);
    for (const char* id : {"C-ST-TORQUE", "C-ST-80", "C-ST-INERTIA", "C-SCR-VM", "F-SUPPORT-LOAD", "C-CP-TORQUE"}) {
      INFO(id);
      REQUIRE(utilisation_of(a, id) <= utilisation_of(b, id) * (1.0 + 1e-12));
    }
    REQUIRE(a.input_power <= b.input_power);
  }
}

// With the speed given, the ramp changes nothing but the acceleration.
TEST_CASE("A longer ramp to the same speed never asks for more torque") {
  machine::Problem problem = shipped_problem("sander");
  for (machine::Axis& axis : problem.axes)
    for (machine::Move& move : axis.moves) {
      move.time.reset();
      move.speed = 0.01;
    }
  const MachineModel model(problem, shipped_catalogue());
  const auto& stage = *std::get<std::unique_ptr<ScrewDriveStage>>(model.entries()[2].stage);
  REQUIRE(stage.name() == "x.drive");
  BoxSampler sampler(stage, 3, model.problem().first_state.size(), 22);
  for (int n = 0; n < 2000; ++n) {
    const SampledPoint quick = sampler.point(sampler.box());
    SampledPoint slow = quick;
    slow.variables[0] *= 1.0 + sampler.uniform();
    const auto a = design_of(stage, quick), b = design_of(stage, slow);
    REQUIRE(b.largest_torque <= a.largest_torque * (1.0 + 1e-12));
    REQUIRE(utilisation_of(b, "C-ST-TORQUE") <= utilisation_of(a, "C-ST-TORQUE") * (1.0 + 1e-12));
    REQUIRE(a.peak_speed == b.peak_speed);
  }
}

TEST_CASE("Shipped motors: a curve governs at or above its voltage and current, and bounds the model below them") {
  machine::Problem problem = shipped_problem("sander");
  for (machine::Axis& axis : problem.axes) axis.require = {};  // the sander states a margin of its own
  const MachineModel model(problem, shipped_catalogue());
  const auto& motors = std::get<std::unique_ptr<ScrewDriveStage>>(model.entries()[2].stage)->motors();
  const catalogue::Table& curves = shipped_catalogue().table(catalogue::Family::stepper_curves);
  const catalogue::Table& steppers = shipped_catalogue().table(catalogue::Family::steppers);
  const auto& voltages = sander().machine().supply_voltages;
  std::size_t governed = 0, modelled = 0, bounded = 0;
  for (Row row = 0; row < motors.pairs().size(); ++row) {
    const auto& pair = motors.pairs()[row];
    const int motor = motors.pairs()[row].motor;
    for (std::size_t v = 0; v < voltages.size(); ++v) {
      const solver::RowsAlive alive{std::span(&row, 1)};
      const auto reading = motors.reading<double>(alive, v);
      REQUIRE(reading.current == std::min(pair.figures_at(v).driver_peak_current, pair.figures_at(v).rated_current));
      // Is there a published point of this motor within voltage and current, and are there some at more of both?
      int points = 0;
      std::map<std::pair<double, double>, std::vector<std::pair<double, double>>> above;
      for (int p = 0; p < curves.rows(); ++p) {
        if (curves.part_number(p) != steppers.part_number(motor) ||
            curves.manufacturer(p) != steppers.manufacturer(motor))
          continue;
        const bool rms =
            curves.text(catalogue::column(catalogue::Family::stepper_curves, "current_kind"), p).find("rms") !=
            std::string_view::npos;
        const double amplitude = curves.number("phase_current", p) * (rms ? std::sqrt(2.0) : 1.0);
        points += curves.number("drive_voltage", p) <= voltages[v] * (1.0 + 1e-9) &&
                  amplitude <= reading.current * (1.0 + 1e-9);
        if (curves.number("drive_voltage", p) >= voltages[v] * (1.0 - 1e-9) &&
            amplitude >= reading.current * (1.0 - 1e-9))
          above[{curves.number("drive_voltage", p), amplitude}].emplace_back(curves.number("speed", p),
                                                                             curves.number("torque", p));
      }
      if (points == 0) REQUIRE(pair.curve_at(v) == nullptr);
      if (pair.curve_at(v) != nullptr) REQUIRE(points >= 2);
      const bool is_bounded = std::ranges::any_of(above, [](const auto& each) { return each.second.size() > 1; });
      REQUIRE(reading.torque_margin == (pair.curve_at(v) != nullptr || is_bounded ? 0.7 : 0.5));
      if (pair.curve_at(v) == nullptr)
        for (const auto& [key, published] : above)
          for (const auto& [speed, torque] : published)
            if (published.size() > 1) {
              REQUIRE(motors.torque<double>(alive, v, speed) <= torque * (1.0 + 1e-9));
              ++bounded;
            }
      ++(pair.curve_at(v) != nullptr ? governed : modelled);
      // Torque is never negative where a design uses it, and beyond a curve never above its last point.
      if (pair.curve_at(v) != nullptr) {
        const double end = pair.curve_at(v)->last_speed();
        REQUIRE(motors.torque<double>(alive, v, 1.01 * end) <= pair.curve_at(v)->points().back().torque);
        REQUIRE(motors.torque<double>(alive, v, 0.5 * end) == (*pair.curve_at(v))(0.5 * end));
      }
    }
  }
  CHECK(governed > 0);
  CHECK(modelled > 0);
  CHECK(bounded > 0);
}

TEST_CASE("Bounds of the torque of many motors hold at and beyond the edges of their table") {
  const auto& motors = drive_of("x").motors();
  std::mt19937 random(5);
  std::vector<Row> alive;
  for (Row row = 0; row < motors.pairs().size(); row += 7) alive.push_back(row);
  const auto uniform = [&] { return static_cast<double>(random() >> 8U) / 16777216.0; };
  for (int n = 0; n < 2000; ++n) {
    const double lower = 1e-3 * std::pow(1e7, uniform());
    const Interval speed(lower, lower * std::pow(30.0, uniform() * uniform()));
    const std::size_t v = static_cast<std::size_t>(n) % 3;
    const Interval bound = motors.torque<Interval>(alive, v, speed);
    for (const double omega : {speed.lower, 0.5 * (speed.lower + speed.upper), speed.upper})
      for (const Row row : alive) {
        const solver::RowsAlive one{std::span(&row, 1)};
        const double torque = motors.torque<double>(one, v, omega);
        REQUIRE(bound.lower <= torque);
        REQUIRE(torque <= bound.upper);
      }
  }
}

}  // namespace drive_physics_test
