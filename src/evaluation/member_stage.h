// SPDX-License-Identifier: Apache-2.0
//
// A structure member as a stage of the solver: a slot of catalogue sections, or free dimensions as variables with a
// price per mass.
#pragma once

#include "evaluation/screw_drive_stage.h"
#include "machine/member_compliance.h"
#include "machine/member_constraints.h"

namespace millwright::evaluation {

class MemberStage final : public ElementStage<MemberStage> {
 public:
  MemberStage(const machine::Axis& axis,
              const machine::Member& member,
              AxisPlace place,
              const catalogue::Catalogue& catalogue,
              const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::StructureMember<T> design(const Selection<T>& selection) const;
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;
  [[nodiscard]] const machine::MemberData& data() const { return data_; }
  /// Why the member cannot be computed, empty if it can: its material is unknown or lacks a figure.
  [[nodiscard]] const std::string& missing() const { return missing_; }

 private:
  void take_material(const catalogue::Table& materials, const PriceBook& prices);
  [[nodiscard]] bool asks_for_twist() const;
  void take_fatigue(const catalogue::Table& materials, int row);
  void take_sections(const catalogue::Catalogue& catalogue, const PriceBook& prices);

  machine::MemberData data_;
  AxisPlace place_;
  std::string missing_;
};

extern template machine::StructureMember<double> MemberStage::design(const Selection<double>&) const;

extern template class ElementStage<MemberStage>;

}  // namespace millwright::evaluation
