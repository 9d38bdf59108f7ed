// SPDX-License-Identifier: Apache-2.0
//
// A machine as the solver's problem: the elements of all axes as stages, from the tools to the base, then the power
// supply. The state they hand on is the supply power, for each axis the load it has to carry so far, and how far the
// tool gives way; the supply voltage is a choice shared by all.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/ledger.h"
#include "evaluation/slot_table.h"
#include "machine/problem.h"
#include "solver/solver.h"

namespace millwright::evaluation {

class ScrewDriveStage;
class BeltDriveStage;
class RackDriveStage;
class RotaryDriveStage;
class GuideStage;
class MemberStage;
class BoltStage;
class SupplyStage;
class WholeStage;
class PriceBook;

/// Whoever looks inside includes machine_stages.h: the elements behind these names take the compiler seconds to read.
using StagePointer = std::variant<std::unique_ptr<ScrewDriveStage>,
                                  std::unique_ptr<BeltDriveStage>,
                                  std::unique_ptr<RackDriveStage>,
                                  std::unique_ptr<RotaryDriveStage>,
                                  std::unique_ptr<GuideStage>,
                                  std::unique_ptr<MemberStage>,
                                  std::unique_ptr<BoltStage>,
                                  std::unique_ptr<SupplyStage>,
                                  std::unique_ptr<WholeStage>>;

/// One stage with what it stands for.
struct StageEntry {
  std::string axis;     ///< "machine" for the supply
  std::string element;  ///< "guide", "drive", "supply", a member's name
  StagePointer stage;
  StageEntry(std::string axis, std::string element, StagePointer stage);
  StageEntry(StageEntry&&) noexcept;
  StageEntry& operator=(StageEntry&&) noexcept;
  ~StageEntry();
  [[nodiscard]] const solver::Stage& as_stage() const;
  [[nodiscard]] const std::vector<SlotTable>& tables() const;
};

/// A slot without a single candidate: the problem cannot be solved, and this says why.
struct EmptySlot {
  std::string axis, slot, reason;
};

/// (axis, slot) pairs.
using GivenSlots = std::set<std::pair<std::string, std::string>>;

class MachineModel {
 public:
  /// `given_slots`: slots that a bill of materials fills; there the problem's wishes (frames, thread forms, ...) do not
  /// count and drivers that another one beats stay, because what is given is judged as it is.
  MachineModel(const machine::Problem& problem,
               const catalogue::Catalogue& catalogue,
               const GivenSlots& given_slots = {});
  MachineModel(const MachineModel&) = delete;
  MachineModel& operator=(const MachineModel&) = delete;

  [[nodiscard]] const solver::Problem& problem() const { return solver_problem_; }
  [[nodiscard]] const machine::Problem& machine() const { return problem_; }
  [[nodiscard]] const catalogue::Catalogue& catalogue() const { return catalogue_; }
  [[nodiscard]] const std::vector<StageEntry>& entries() const { return entries_; }
  [[nodiscard]] std::vector<EmptySlot> empty_slots() const;
  /// The resource that holds a quantity; throws std::invalid_argument if the problem does not count it.
  [[nodiscard]] std::size_t resource(machine::Quantity quantity) const;

  /// Evaluates a build from scratch, stage after stage, and writes the ledger. Nothing of what the search computed is
  /// reused.
  [[nodiscard]] Design design(const solver::Build& build) const;

 private:
  void add_axis(std::size_t index, const PriceBook& prices);

  [[nodiscard]] std::optional<std::size_t> find_resource(machine::Quantity quantity) const;

  machine::Problem problem_;
  const catalogue::Catalogue& catalogue_;
  std::vector<StageEntry> entries_;
  solver::Problem solver_problem_;
};

}  // namespace millwright::evaluation
