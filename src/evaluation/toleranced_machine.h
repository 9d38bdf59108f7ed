// SPDX-License-Identifier: Apache-2.0
//
// One build with figures of its parts that can be taken otherwise: its machine made anew from the chosen parts alone.
#pragma once

#include <span>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/machine_model.h"
#include "evaluation/tolerance_check.h"

namespace millwright::evaluation {

class TolerancedMachine {
 public:
  /// `build` in rows of model.problem(). The model has to outlive it.
  TolerancedMachine(const MachineModel& model, const solver::Build& build);

  [[nodiscard]] const std::vector<TolerancedFigure>& figures() const { return figures_; }
  /// Estimated figures of the chosen parts that state no tolerance.
  [[nodiscard]] std::size_t unstated() const { return unstated_; }

  /// The design with these values [SI] of the figures, evaluated from scratch.
  [[nodiscard]] Design design(std::span<const double> values) const;

  /// Of every limit how far, as a share of it, values in these intervals may exceed it: 0 is proved to be kept by all
  /// of them, more says nothing but how much is left to prove. What the figures do not touch counts as it stands.
  [[nodiscard]] std::vector<double> excesses(std::span<const scalar::Interval> values) const;

 private:
  struct Bounds {
    struct Limited {
      scalar::Interval total;
      double limit = 0.0;
    };
    std::vector<scalar::Interval> utilisation;
    std::vector<Limited> limited;  ///< totals that have a limit, but for the cost
  };
  void take_parts(const MachineModel& model, const solver::Build& build);
  void take_figures(const catalogue::Catalogue& catalogue);
  /// The chosen parts with other figures: set(table, row, column, number of the figure).
  template <class Set>
  [[nodiscard]] catalogue::Catalogue parts_with(Set&& set) const;
  [[nodiscard]] solver::Build build_in(const MachineModel& model) const;
  [[nodiscard]] Bounds bounds(std::span<const scalar::Interval> values) const;

  struct ChosenPart {
    catalogue::Part part;  ///< in the whole catalogue
    int row = 0;           ///< among the chosen parts alone
    std::vector<std::string> places;
  };
  [[nodiscard]] const ChosenPart* find(catalogue::Family family, int row) const;

  machine::Problem problem_;
  catalogue::Catalogue parts_;                  ///< the chosen ones
  solver::Build build_;                         ///< in rows of the whole machine
  std::vector<std::vector<Candidate>> chosen_;  ///< [stage][slot], of the machine that was given
  std::vector<ChosenPart> chosen_parts_;
  std::vector<TolerancedFigure> figures_;
  std::size_t unstated_ = 0;
  Bounds as_stated_;  ///< with every figure as stated; what does not differ from that is not touched
};

}  // namespace millwright::evaluation
