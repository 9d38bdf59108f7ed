// SPDX-License-Identifier: Apache-2.0
//
// Belts with their pulleys. A belt is as long as its pulleys are large, so that it is a candidate once for every pair
// of sizes that can turn it: how many pulleys are on sale in each size does not matter to it. (A pulley of which the
// diameter has a tolerance is a size of its own.) A pulley may turn at the far end too, on a bearing; then it is bought
// twice, and stands in the slot of the drive pulley with its second piece. No pulley is left for the idler's slot then,
// which has a candidate without parts for that.
#pragma once

#include <cstdint>
#include <vector>

#include "evaluation/drive_tables.h"

namespace millwright::evaluation {

/// What tells which belts and pulleys run together.
struct BeltFit {
  static constexpr std::int32_t none = -1, same = -2;
  std::int32_t drive = none;  ///< profile, width, teeth and diameter of the drive pulley
  std::int32_t idler = none;  ///< profile, width and diameter of the idler; `same` where it is the drive pulley again
  friend bool operator==(const BeltFit&, const BeltFit&) = default;
};

struct BeltTables {
  SlotTable belts, pulleys, idlers;
  std::vector<BeltFit> belt_fits;        ///< per row
  std::vector<BeltFit> pulley_fits;      ///< per row; idler is `same` or `none`
  std::vector<std::int32_t> idlers_fit;  ///< per row: BeltFit::idler
  [[nodiscard]] bool runs(std::size_t belt, std::size_t pulley) const {
    return belt_fits[belt].drive == pulley_fits[pulley].drive && brings_idler(pulley) == has_same(belt);
  }
  [[nodiscard]] bool turns(std::size_t belt, std::size_t idler) const {
    return belt_fits[belt].idler == idlers_fit[idler];
  }
  [[nodiscard]] bool goes_with(std::size_t pulley, std::size_t idler) const {
    return brings_idler(pulley) == (idlers_fit[idler] == BeltFit::same);
  }
  /// How many profiles and sizes there are among a belt, a pulley and an idler: over all of these rows, at the least
  /// and at the most. Not looked into where there are many.
  [[nodiscard]] scalar::Interval kinds(std::span<const solver::Row> some_belts,
                                       std::span<const solver::Row> some_pulleys,
                                       std::span<const solver::Row> some_idlers) const;
  [[nodiscard]] bool brings_idler(std::size_t pulley) const { return pulley_fits[pulley].idler == BeltFit::same; }
  [[nodiscard]] bool has_same(std::size_t belt) const { return belt_fits[belt].idler == BeltFit::same; }

  /// Readings, in order: of machine::BeltReading all that the belt and the sizes of its pulleys say; of the drive
  /// pulley its inertia, its bore and the inertia of its second piece; of the idler its inertia.
  enum BeltField : std::size_t {
    mass_per_length,
    allowable_tension,
    specific_stiffness,
    least_teeth,
    largest_speed,
    belt_length,
    belt_mass,
    span,
    teeth,
    pitch_diameter,
    idler_diameter,
    width,
    belt_fields
  };
  enum PulleyField : std::size_t { pulley_inertia, bore, second_inertia, pulley_fields };
  enum IdlerField : std::size_t { idler_inertia, idler_fields };
};
BeltTables belt_tables(const catalogue::Catalogue& catalogue, const machine::Axis& axis, const PriceBook& prices);

}  // namespace millwright::evaluation
