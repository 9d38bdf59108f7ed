// SPDX-License-Identifier: Apache-2.0
//
// The guides of an axis as a stage of the solver. One slot: carriages with their rail.
#pragma once

#include "evaluation/screw_drive_stage.h"
#include "machine/guide_system.h"

namespace millwright::evaluation {

class GuideStage final : public ElementStage<GuideStage> {
 public:
  GuideStage(const machine::Axis& axis,
             AxisPlace place,
             const catalogue::Catalogue& catalogue,
             const PriceBook& prices);

  template <class T>
  [[nodiscard]] machine::GuideSystem<T> design(const Selection<T>& selection) const;
  template <class T>
  void answer(const Selection<T>& selection, solver::Answer<T>& out) const;
  [[nodiscard]] const machine::GuideData& data() const { return data_; }

 private:
  machine::GuideData data_;
  AxisPlace place_;
  machine::Range acceleration_time_;
  std::vector<bool> unsupported_;  ///< per row: a round shaft held at its ends
  std::vector<bool> bushings_;     ///< per row: bushings on a round shaft, held at its ends or all along
};

extern template machine::GuideSystem<double> GuideStage::design(const Selection<double>&) const;

extern template class ElementStage<GuideStage>;

}  // namespace millwright::evaluation
