// SPDX-License-Identifier: Apache-2.0
//
// Motors with the drivers that are worth keeping for them and the currents that may be set there.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <tuple>

#include "evaluation/drive_tables.h"
#include "evaluation/driver_choices.h"
#include "evaluation/figure_reader.h"
#include "machine/word_column.h"

namespace millwright::evaluation {

using catalogue::column;
using catalogue::Family;
using catalogue::Table;

bool is_part(const catalogue::Table& table, int row, const machine::PartName& part) {
  return table.part_number(row) == part.part_number &&
         (part.manufacturer.empty() || table.manufacturer(row) == part.manufacturer);
}

CandidateDraft candidate_of(std::vector<PartUse> parts, double riding, double cabinet) {
  CandidateDraft candidate;
  candidate.parts = std::move(parts);
  for (const PartUse& part : candidate.parts) {
    candidate.price += part.price;
    candidate.mass += part.mass;
  }
  candidate.riding_mass = riding;
  candidate.standing_mass = candidate.mass - riding - cabinet;
  return candidate;
}

namespace {

/// Detent torque where the data sheet gives none: the lower end of the usual 3 to 5 % of the holding torque.
constexpr double detent_share = 0.03;

/// The holding torque with both phases at rated current, by that stated with so many phases on: the torques of two
/// phases stand at right angles, so together they give sqrt(2) times one. What is stated without saying so is taken as
/// both on, as data sheets of hybrid motors do; what is neither one nor two is not known.
double both_phases(double phases_on) {
  if (std::isnan(phases_on) || phases_on == 2.0) return 1.0;
  return phases_on == 1.0 ? std::sqrt(2.0) : std::nan("");
}

/// What is published of a motor's torque at one voltage and current: points (speed, torque).
struct CurveKey {
  double voltage, current;
  friend bool operator<(const CurveKey& a, const CurveKey& b) {
    return std::tie(a.voltage, a.current) < std::tie(b.voltage, b.current);
  }
};
using CurvePoints = std::vector<mechanics::PullOutCurve::Point>;
/// By the current as it is stated (of whatever kind), driver and step mode, of which each has its own curve.
using MeasuredCurves = std::map<std::tuple<double, std::string_view, std::string_view>, CurvePoints>;
using MotorCurves = std::map<CurveKey, MeasuredCurves>;
/// By maker and part number.
using Curves = std::map<std::pair<std::string_view, std::string_view>, MotorCurves>;

/// Peak amplitude of a current stated as `kind`.
double amplitude(double current, std::string_view kind) {
  return kind.find("rms") != std::string_view::npos ? current * std::sqrt(2.0) : current;
}

/// `torque`: of a row.
template <class Torque>
Curves read_curves(const Table& t, Torque torque) {
  Curves curves;
  for (const int row : t.rows_in_order()) {
    const CurveKey key{t.number(column(Family::stepper_curves, "drive_voltage"), row),
                       amplitude(t.number(column(Family::stepper_curves, "phase_current"), row),
                                 t.text(column(Family::stepper_curves, "current_kind"), row))};
    const std::tuple measured(t.number(column(Family::stepper_curves, "phase_current"), row),
                              t.text(column(Family::stepper_curves, "driver"), row),
                              t.text(column(Family::stepper_curves, "step_mode"), row));
    curves[{t.manufacturer(row), t.part_number(row)}][key][measured].push_back(
        {t.number(column(Family::stepper_curves, "speed"), row), torque(row)});
  }
  return curves;
}

/// Those of a motor; null where there are none.
const MotorCurves* curves_of(const Curves& curves, const Table& motors, int row) {
  const auto found = curves.find({motors.manufacturer(row), motors.part_number(row)});
  return found == curves.end() ? nullptr : &found->second;
}

bool is_curve(const CurvePoints& points) { return points.size() >= 2; }  // a single point is not one

/// The least of what was measured with several drivers and step modes: which of them is like one's own nobody knows.
mechanics::PullOutCurve least_curve(const MeasuredCurves& measured) {
  std::vector<mechanics::PullOutCurve> curves;
  for (const auto& [with, points] : measured)
    if (is_curve(points)) curves.emplace_back(points);
  return mechanics::least_of(curves);
}

/// The curves that govern: published at no more than this voltage and current; of several the one at the highest
/// voltage, then current. Null where none does.
const MotorCurves::value_type* governing(const MotorCurves& curves, double voltage, double current) {
  for (auto curve = curves.rbegin(); curve != curves.rend(); ++curve) {
    if (curve->first.voltage > voltage * (1.0 + 1e-9) || curve->first.current > current * (1.0 + 1e-9)) continue;
    if (std::ranges::any_of(curve->second, [](const auto& each) { return is_curve(each.second); })) return &*curve;
  }
  return nullptr;
}

/// All published at no less than this voltage and current.
std::vector<const MotorCurves::value_type*> above(const MotorCurves& curves, double voltage, double current) {
  std::vector<const MotorCurves::value_type*> result;
  for (const auto& curve : curves)
    if (curve.first.voltage >= voltage * (1.0 - 1e-9) && curve.first.current >= current * (1.0 - 1e-9) &&
        std::ranges::any_of(curve.second, [](const auto& each) { return is_curve(each.second); }))
      result.push_back(&curve);
  return result;
}

/// The currents that may be set for a motor, the largest first.
std::vector<double> settable_currents(const machine::Axis& axis, double rated_current) {
  if (axis.motor.currents.empty()) return {axis.require(machine::Requirement::current_factor) * rated_current};
  std::vector<double> currents = axis.motor.currents;
  std::sort(currents.begin(), currents.end(), std::greater<>());
  return currents;
}

constexpr catalogue::Column curve_torque = column(Family::stepper_curves, "torque");

/// A motor of the catalogue, without driver and voltage.
struct Motor {
  int row;
  machine::MotorFigures<double> figures;
  double shaft, mass, price;
  double frame_size;  ///< m; NaN where it is not stated
};

/// What the motor says; `figure` reads a column of its row, as a number or as an interval.
template <class Figure>
auto motor_figures(const Table& motors, int row, Figure figure) {
  using T = decltype(figure("rated_current"));
  machine::MotorFigures<T> f;
  f.holding_torque = figure("holding_torque") * both_phases(motors.number(column(Family::steppers, "phases_on"), row));
  f.detent_torque = std::isnan(motors.number(column(Family::steppers, "detent_torque"), row))
                        ? detent_share * f.holding_torque
                        : figure("detent_torque");
  f.rated_current = figure("rated_current");
  f.resistance = figure("phase_resistance");
  f.inductance = figure("phase_inductance");
  f.rotor_inertia = figure("rotor_inertia");
  f.rotor_teeth =
      std::round(2.0 * 3.14159265358979323846 / motors.number(column(Family::steppers, "step_angle"), row) / 4.0);
  return f;
}

/// Nothing if a figure is missing; then it is noted.
std::optional<Motor> motor_of(const Table& motors, int row, const PriceBook& prices, SlotTable& table) {
  std::vector<catalogue::Column> missing;
  constexpr std::array soft{column(Family::steppers, "frame_size")};
  const FigureReader number(motors, row, missing, soft);
  number("step_angle");  // of which rotor_teeth is made
  const machine::MotorFigures<double> f = motor_figures(motors, row, number);
  const Motor motor{
      row, f, number("shaft_diameter"), number("mass"), prices.line(motors, row, 1.0, 0.0), number("frame_size")};
  const bool complete = !std::isnan(f.holding_torque + f.rated_current + f.resistance + f.inductance + f.rotor_inertia +
                                    f.rotor_teeth + motor.shaft + motor.mass + motor.price);
  if (complete) return motor;
  table.note_incomplete({{Family::steppers, row}, std::move(missing)});
  return std::nullopt;
}

/// Adds a motor with the drivers that are worth keeping, at each current that may be set.
class MotorPairs {
 public:
  MotorPairs(const catalogue::Catalogue& catalogue,
             const machine::Axis& axis,
             const std::vector<double>& voltages,
             const PriceBook& prices)
      : motors_(catalogue.table(Family::steppers)),
        axis_(axis),
        voltages_(voltages),
        modelled_(std::make_shared<const AtVoltages>(AtVoltages{voltages})),
        model_share_(axis.require(axis.require.margin_of_model()) / axis.require(machine::Requirement::torque_margin)),
        driver_table_(catalogue.table(Family::drivers)),
        curve_table_(catalogue.table(Family::stepper_curves)),
        drivers_(driver_table_, axis, voltages, prices),
        curves_(read_curves(curve_table_, [&](int row) { return curve_table_.number(curve_torque, row); })) {
    for (const IncompleteRow& row : drivers_.incomplete()) table.table.note_incomplete(row);
  }

  /// Pairs are many: a table that moves while it grows touches twice the memory.
  void reserve(std::span<const Motor> motors) {
    std::size_t more = 0;
    for (const Motor& motor : motors)
      for (const double current : settable_currents(axis_, motor.figures.rated_current))
        for (const Driver* driver : drivers_.at(current).kept) more += takes(*driver) ? 1 : 0;
    table.table.reserve(table.table.rows() + more, 2);
    table.pairs.reserve(table.pairs.size() + more);
  }

  void add(const Motor& motor) {
    motor_curves_ = curves_of(curves_, motors_, motor.row);
    for (const double current : settable_currents(axis_, motor.figures.rated_current)) {
      const std::size_t first = table.table.rows();
      const DriverChoices::Choice& choice = drivers_.at(current);
      for (const Driver* driver : choice.kept)
        if (takes(*driver)) add(motor, *driver, current);
      for (std::size_t i = 0; i < choice.covered_by.size(); ++i) {
        std::vector<solver::Row> by;
        for (const std::size_t k : choice.covered_by[i]) by.push_back(static_cast<solver::Row>(first + k));
        table.table.cover(first + i, std::move(by));
      }
    }
  }

  MotorTable table{SlotTable("motor", 0), {}};
  std::optional<machine::PartName> only_driver;  ///< where every driver is kept

 private:
  [[nodiscard]] bool takes(const Driver& driver) const {
    return !only_driver || is_part(driver_table_, driver.row, *only_driver);
  }
  void add(const Motor& motor, const Driver& driver, double current) {
    MotorPair pair;
    pair.motor = motor.row;
    pair.mass = motor.mass;
    pair.shaft = motor.shaft;
    if (!std::isnan(motor.frame_size)) pair.frame_size = motor.frame_size;
    machine::MotorFigures<double> f = motor.figures;
    f.asked_current = current;
    f.driver_peak_current = driver.peak_current;
    f.driver_largest_voltage = driver.largest_voltage;
    f.driver_least_voltage = driver.least_voltage;
    pair.figures = f;
    pair.at = motor_curves_ == nullptr ? modelled_ : with_curves(std::min(driver.peak_current, current));
    CandidateDraft candidate =
        candidate_of({{"motor", Family::steppers, motor.row, 1.0, 0.0, motor.price, motor.mass},
                      {"driver", Family::drivers, driver.row, 1.0, 0.0, driver.price, driver.mass}},
                     0.0,
                     driver.mass);
    if (motors_.has_ranges() || driver_table_.has_ranges() || curve_table_.has_ranges())
      add_ranges(motor, driver, current, pair, candidate);
    if (!axis_.motor.currents.empty()) candidate.settings.push_back({"motor_current", current, "A"});
    table.table.add(std::move(candidate), {});
    table.pairs.push_back(std::move(pair));
  }

  /// The same with figures that are intervals. Which curve governs hangs on the current that is set.
  void add_ranges(
      const Motor& motor, const Driver& driver, double current, MotorPair& pair, CandidateDraft& candidate) {
    using scalar::Interval;
    const auto range = [&](const char* name) { return motors_.range(column(Family::steppers, name), motor.row); };
    MotorRanges of_pair;
    of_pair.mass = range("mass");
    of_pair.model_share = model_share_;
    machine::MotorFigures<Interval>& f = of_pair.figures;
    f = motor_figures(motors_, motor.row, range);
    f.asked_current = axis_.motor.currents.empty()
                          ? axis_.require(machine::Requirement::current_factor) * f.rated_current
                          : Interval(current);
    f.driver_peak_current = largest_amplitude(driver_table_.range(column(Family::drivers, "peak_current"), driver.row),
                                              driver_table_.range(column(Family::drivers, "rms_current"), driver.row));
    f.driver_largest_voltage = driver_table_.range(column(Family::drivers, "maximum_voltage"), driver.row);
    f.driver_least_voltage = driver_table_.range(column(Family::drivers, "minimum_voltage"), driver.row);
    AtVoltages at = *pair.at;
    for (const double v : voltages_) {
      f.voltage = v;
      take_curves(motor, v, smaller(f.driver_peak_current, f.asked_current), of_pair);
      at.ranges.push_back(of_pair);
    }
    pair.at = std::make_shared<const AtVoltages>(std::move(at));
    candidate.ranges = candidate_ranges(
        {}, candidate.price, {}, of_pair.mass, driver_table_.range(column(Family::drivers, "mass"), driver.row));
  }

  void take_curves(const Motor& motor, double voltage, const scalar::Interval& current, MotorRanges& of_pair) const {
    of_pair.published.clear();
    of_pair.model_may_govern = motor_curves_ == nullptr;
    if (motor_curves_ == nullptr) return;
    std::vector<double> currents{current.lower, current.upper};
    for (const auto& [key, points] : *motor_curves_)
      if (current.lower <= key.current && key.current <= current.upper) currents.push_back(key.current);
    // Between those of two curves the one governs and the other bounds.
    std::sort(currents.begin(), currents.end());
    for (std::size_t i = currents.size() - 1; i > 0; --i) currents.push_back(0.5 * (currents[i - 1] + currents[i]));
    const Curves lowest =
        read_curves(curve_table_, [&](int row) { return curve_table_.range(curve_torque, row).lower; });
    const Curves highest =
        read_curves(curve_table_, [&](int row) { return curve_table_.range(curve_torque, row).upper; });
    for (const double each : currents) {
      const auto* const curve = governing(*motor_curves_, voltage, each);
      const auto ceilings = above(*motor_curves_, voltage, each);
      if (curve == nullptr && ceilings.empty()) of_pair.model_may_govern = true;
      for (const Curves* at : {&lowest, &highest}) {
        const MotorCurves& moved = *curves_of(*at, motors_, motor.row);
        MotorRanges::Published published;
        if (curve != nullptr) published.curve = least_curve(moved.at(curve->first));
        std::vector<mechanics::PullOutCurve> all;
        for (const auto* ceiling : ceilings) all.push_back(least_curve(moved.at(ceiling->first)));
        if (!all.empty()) published.ceiling = mechanics::least_of(all);
        if (published.curve || published.ceiling) of_pair.published.push_back(std::move(published));
      }
    }
  }

  /// Of the motor that is added, by what it is driven with. Its drivers often have the same curves.
  std::shared_ptr<const AtVoltages> with_curves(double current) {
    AtVoltages at{voltages_};
    at.model_share = model_share_;
    for (const double v : voltages_) {
      const auto* const curve = governing(*motor_curves_, v, current);
      at.curves.push_back(curve == nullptr ? nullptr : made_of(curve->second));
      at.ceilings.push_back(ceiling_of(above(*motor_curves_, v, current)));
    }
    const auto none = [](const auto& curve) { return curve == nullptr; };
    if (std::ranges::all_of(at.curves, none) && std::ranges::all_of(at.ceilings, none)) return modelled_;
    if (curved_ == nullptr || curved_->curves != at.curves || curved_->ceilings != at.ceilings)
      curved_ = std::make_shared<const AtVoltages>(std::move(at));
    return curved_;
  }

  /// The least of some curves, made once for all pairs below it.
  std::shared_ptr<const mechanics::PullOutCurve> ceiling_of(const std::vector<const MotorCurves::value_type*>& curves) {
    if (curves.empty()) return nullptr;
    auto& made = ceilings_[curves];
    if (made != nullptr) return made;
    std::vector<mechanics::PullOutCurve> all;
    for (const auto* curve : curves) all.push_back(*made_of(curve->second));
    return made = std::make_shared<const mechanics::PullOutCurve>(mechanics::least_of(all));
  }

  /// A curve, made once for all pairs that it governs.
  std::shared_ptr<const mechanics::PullOutCurve> made_of(const MeasuredCurves& measured) {
    auto& made = made_[&measured];
    if (made == nullptr) made = std::make_shared<const mechanics::PullOutCurve>(least_curve(measured));
    return made;
  }

  const Table& motors_;
  const machine::Axis& axis_;
  const std::vector<double>& voltages_;
  std::shared_ptr<const AtVoltages> modelled_;  ///< of motors without curves
  double model_share_;
  std::shared_ptr<const AtVoltages> curved_;  ///< of the last one with some
  const Table& driver_table_;
  const Table& curve_table_;
  DriverChoices drivers_;
  Curves curves_;
  const MotorCurves* motor_curves_ = nullptr;  ///< of the motor that is added; null where there are none
  std::map<const MeasuredCurves*, std::shared_ptr<const mechanics::PullOutCurve>> made_;
  std::map<std::vector<const MotorCurves::value_type*>, std::shared_ptr<const mechanics::PullOutCurve>> ceilings_;
};

}  // namespace

MotorTable motor_table(const catalogue::Catalogue& catalogue,
                       const machine::Axis& axis,
                       const std::vector<double>& voltages,
                       const PriceBook& prices) {
  const Table& motors = catalogue.table(Family::steppers);
  MotorPairs pairs(catalogue, axis, voltages, prices);
  const auto add_motors = [&](const std::optional<machine::PartName>& only) {
    std::vector<Motor> complete;
    for (const int row : motors.rows_in_order()) {
      if (only && !is_part(motors, row, *only)) continue;
      if (!machine::word_columns::motor_frame.takes(axis.motor.frames, motors, row)) continue;
      if (const auto motor = motor_of(motors, row, prices, pairs.table.table)) complete.push_back(*motor);
    }
    pairs.reserve(complete);
    for (const Motor& motor : complete) pairs.add(motor);
  };
  if (axis.keep_every_candidate) pairs.only_driver = axis.motor.given_driver;
  add_motors(axis.motor.given);
  // What is given cannot be chosen: all others are there, to say why.
  if (pairs.table.pairs.empty() && (axis.motor.given || axis.motor.given_driver)) {
    pairs.only_driver.reset();
    add_motors(std::nullopt);
  }
  return std::move(pairs.table);
}

}  // namespace millwright::evaluation
