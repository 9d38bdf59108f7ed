// SPDX-License-Identifier: Apache-2.0
//
// From catalogue rows to the candidates of a drive's slots, with everything filtered out that can never be compliant on
// this axis because it lacks a figure a hard check needs, or because two parts of one candidate do not go together.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/price_book.h"
#include "evaluation/slot_table.h"
#include "machine/motor.h"
#include "machine/problem.h"
#include "machine/screw.h"
#include "mechanics/torque_curve.h"

namespace millwright::evaluation {

struct ScrewTable {
  /// A row's shaft and nut.
  struct Pair {
    std::uint32_t shaft = 0, nut = 0;  ///< in `shafts` and `nuts`
  };
  SlotTable table;
  std::vector<machine::ScrewKind> kinds;              ///< per row
  std::vector<Pair> pairs;                            ///< per row: there are many more pairs than shafts and nuts
  std::vector<machine::ScrewFigures<double>> shafts;  ///< of a ball screw with all that its nut adds
  std::vector<machine::ScrewFigures<double>> nuts;    ///< of lead nuts: their own figures only
  std::array<machine::ScrewSite, 2> sites;            ///< [kind]: what the axis adds
  [[nodiscard]] const machine::ScrewSite& site(std::size_t row) const {
    return sites[static_cast<std::size_t>(kinds[row])];
  }
  /// What does not depend on the nut.
  [[nodiscard]] const machine::ScrewFigures<double>& shaft(std::size_t row) const { return shafts[pairs[row].shaft]; }
  /// All figures of a row, for the calculation sheet.
  [[nodiscard]] machine::ScrewFigures<double> figures(std::size_t row) const;
};
ScrewTable screw_table(const catalogue::Catalogue& catalogue, const machine::Axis& axis, const PriceBook& prices);

/// A motor with its driver at one voltage of which figures are intervals.
struct MotorRanges {
  machine::MotorFigures<scalar::Interval> figures;
  /// What may govern the torque beside the model alone: a curve, and what bounds the model, as in AtVoltages; each pair
  /// of them once at its lowest and once at its highest.
  struct Published {
    std::optional<mechanics::PullOutCurve> curve, ceiling;
  };
  std::vector<Published> published;
  bool model_may_govern = false;
  scalar::Interval mass;     ///< kg, of the motor
  double model_share = 1.0;  ///< as in AtVoltages
};

/// What motors with their drivers have at each supply voltage of the problem: the same for many of them.
struct AtVoltages {
  std::vector<double> voltages;  ///< V
  /// Published, per voltage, null where the model governs; empty where it does at all of them.
  std::vector<std::shared_ptr<const mechanics::PullOutCurve>> curves = {};
  /// The least of what was published at as much voltage and current or more: less of either gives no more torque. Per
  /// voltage, null where nothing was; empty where `curves` is.
  std::vector<std::shared_ptr<const mechanics::PullOutCurve>> ceilings = {};
  std::vector<MotorRanges> ranges = {};  ///< per voltage; empty where every figure is what it is
  /// Beside curves the model counts as an estimate: so much of it that the margin of a published torque leaves what
  /// that of an estimate would.
  double model_share = 1.0;
};

/// A motor with a driver at each supply voltage of the problem.
struct MotorPair {
  int motor = 0;                          ///< row in the catalogue
  double mass = 0.0;                      ///< kg, of the motor: the driver is in its cabinet
  double shaft = 0.0;                     ///< m
  double frame_size = 0.0;                ///< m
  machine::MotorFigures<double> figures;  ///< at no voltage
  std::shared_ptr<const AtVoltages> at;

  [[nodiscard]] machine::MotorFigures<double> figures_at(std::size_t voltage) const {
    machine::MotorFigures<double> result = figures;
    result.voltage = at->voltages[voltage];
    return result;
  }
  /// Null where the model governs.
  [[nodiscard]] const mechanics::PullOutCurve* curve_at(std::size_t voltage) const {
    return at->curves.empty() ? nullptr : at->curves[voltage].get();
  }
  /// What bounds the model from above; null where nothing does.
  [[nodiscard]] const mechanics::PullOutCurve* ceiling_at(std::size_t voltage) const {
    return at->ceilings.empty() ? nullptr : at->ceilings[voltage].get();
  }
  /// Whether the model alone says what the torque is, so that the margin is that of an estimate.
  [[nodiscard]] bool is_modelled(std::size_t voltage) const {
    return curve_at(voltage) == nullptr && ceiling_at(voltage) == nullptr;
  }
  [[nodiscard]] std::span<const MotorRanges> ranges() const { return at->ranges; }
};
struct MotorTable {
  SlotTable table;               ///< no readings of its own: they depend on the voltage
  std::vector<MotorPair> pairs;  ///< per row
};
MotorTable motor_table(const catalogue::Catalogue& catalogue,
                       const machine::Axis& axis,
                       const std::vector<double>& voltages,
                       const PriceBook& prices);

/// Whether a hard check of this axis reads the axial stiffness of nut and bearings, so that they must have one.
bool stiffness_matters(const machine::Axis& axis);

/// Fields of machine::CouplingReading, in order.
SlotTable coupling_table(const catalogue::Catalogue& catalogue, const PriceBook& prices);
/// Fields of machine::SupportReading, in order. `fixed`: takes thrust.
SlotTable support_table(const catalogue::Catalogue& catalogue,
                        const PriceBook& prices,
                        const std::string& slot,
                        bool fixed,
                        bool stiffness_needed);
/// Fields of machine::RackReading, in order: racks as long as the axis needs, in whole pieces.
SlotTable rack_table(const catalogue::Catalogue& catalogue, const machine::Axis& axis, const PriceBook& prices);
/// Fields of machine::PinionReading, in order.
SlotTable pinion_table(const catalogue::Catalogue& catalogue, const PriceBook& prices);

/// A candidate with these parts; `riding` kg of them move with the axis and `cabinet` kg burden no axis.
CandidateDraft candidate_of(std::vector<PartUse> parts, double riding, double cabinet = 0.0);

/// Whether a row of the catalogue is this part, whoever sells it.
bool is_part(const catalogue::Table& table, int row, const machine::PartName& part);

}  // namespace millwright::evaluation
