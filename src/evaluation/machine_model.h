// SPDX-License-Identifier: Apache-2.0
//
// A machine as the solver's problem: the elements of all axes as stages, from the tools to the base, then the power
// supply. The state they hand on is the supply power, for each axis the load it has to carry so far, and how far the
// tool gives way; the supply voltage is a choice shared by all.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "catalogue/catalogue.h"
#include "evaluation/counted_parts.h"
#include "evaluation/ledger.h"
#include "evaluation/owned_first.h"
#include "evaluation/price_book.h"
#include "evaluation/shops.h"
#include "evaluation/slot_table.h"
#include "evaluation/stock_bars.h"
#include "machine/bill_of_materials.h"
#include "machine/problem.h"
#include "solver/restricted_problem.h"
#include "solver/scenario_problem.h"
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

/// A part or setting of a bill of materials that cannot be used as it stands.
struct BomProblem {
  machine::SourceSpan where;
  std::string message, hint;
};

/// The parts of a bill of materials by (axis, slot).
using GivenSlots = std::map<std::pair<std::string, std::string>, machine::PartName>;
/// Of its lines of this origin, or of all.
GivenSlots given_slots(const machine::BillOfMaterials& bom, const std::string& only_origin = {});

/// What is asked of a model beside its problem.
struct ModelOptions {
  machine::BillOfMaterials fixed = {};  ///< parts and settings that every build has; the problem's wishes still count
  /// Other catalogues of the same rows, with other figures, that every build has to be compliant with too. They must
  /// outlive the model.
  std::vector<std::shared_ptr<const catalogue::Catalogue>> scenarios = {};
  bool every_candidate = false;  ///< also candidates that another one covers: no best build has one, the next best may
  /// How many builds are asked for: what as many others cover is in none of them, and is left out even so.
  std::size_t builds = std::numeric_limits<std::size_t>::max();
  /// What builds of it are compared by (SearchOptions::objectives): a driver that is worse by that is left out, or
  /// covered, whatever else speaks for it. Empty: by anything.
  std::vector<std::string> objectives = {};
};

class MachineModel {
 public:
  /// `given_slots`: slots that a bill of materials fills; there the problem's wishes (frames, thread forms, ...) do not
  /// count and drivers that another one beats stay, because what is given is judged as it is. Motors and drivers other
  /// than those given are left out, if these are in the catalogues.
  MachineModel(const machine::Problem& problem,
               const catalogue::Catalogue& catalogue,
               const GivenSlots& given_slots = {},
               ModelOptions options = {});
  MachineModel(const MachineModel&) = delete;
  MachineModel& operator=(const MachineModel&) = delete;

  /// With what is fixed; builds are in its rows.
  [[nodiscard]] const solver::Problem& problem() const {
    return restricted_ ? restricted_->problem() : searched_problem();
  }
  [[nodiscard]] const machine::Problem& machine() const { return problem_; }
  /// With a row for every offer of a part.
  [[nodiscard]] const catalogue::Catalogue& catalogue() const { return catalogue_; }
  [[nodiscard]] std::span<const CountedPart> counted_parts() const { return counted_parts_; }
  [[nodiscard]] const Shops& shops() const { return shops_; }
  [[nodiscard]] const PriceBook& prices() const { return prices_; }
  [[nodiscard]] const std::vector<StageEntry>& entries() const { return entries_; }
  /// What pieces are cut from where whole bars are sold.
  [[nodiscard]] const StockBars& bars() const { return *bars_; }
  [[nodiscard]] std::vector<EmptySlot> empty_slots() const;
  [[nodiscard]] const ModelOptions& options() const { return options_; }
  /// The candidate of a row of problem().
  [[nodiscard]] Candidate candidate(std::size_t stage, std::size_t slot, solver::Row row) const;
  /// Rows of problem() that are never worse than this one by the objectives (solver/alternatives.h); known with
  /// `every_candidate`.
  [[nodiscard]] std::vector<solver::Row> covering_rows(std::size_t stage, std::size_t slot, solver::Row row) const;
  /// Makes the set of suppliers of a build, in rows of problem(), those that its parts are bought from.
  void set_suppliers(solver::Build& build) const;
  /// Why something cannot be fixed; then nothing is.
  [[nodiscard]] const std::vector<BomProblem>& problems() const { return problems_; }
  /// The resource by which builds are compared in a quantity: of the cost, where a part that could be chosen is
  /// preferred, that in which preferred parts count less. Throws as resource() does.
  [[nodiscard]] std::size_t compared(machine::Quantity quantity) const;
  /// Whether there is such a part.
  [[nodiscard]] bool prefers() const { return compared_resource_.has_value(); }
  /// The resource that holds a quantity; throws std::invalid_argument if the problem does not count it.
  [[nodiscard]] std::size_t resource(machine::Quantity quantity) const;

  /// A build in the rows of the stages themselves, where something is fixed.
  [[nodiscard]] solver::Build whole_build(const solver::Build& build) const {
    return restricted_ ? restricted_->whole_build(build) : build;
  }

  /// Evaluates a build from scratch, stage after stage, and writes the ledger. Nothing of what the search computed is
  /// reused. `with_worksheet`: with the calculation behind every check too.
  [[nodiscard]] Design design(const solver::Build& build, bool with_worksheet = false) const;

 private:
  void add_spares(const PriceBook& prices);
  void count_parts(const PriceBook& prices);
  void add_axis(std::size_t index, const PriceBook& prices);
  void fix();
  void add_scenarios(const machine::Problem& given, const GivenSlots& given_slots);
  [[nodiscard]] const solver::Problem& searched_problem() const {
    return scenario_problem_ ? scenario_problem_->problem() : solver_problem_;
  }

  ModelOptions options_;
  std::vector<BomProblem> problems_;
  [[nodiscard]] std::optional<std::size_t> find_resource(machine::Quantity quantity) const;

  machine::Problem problem_;
  const catalogue::Catalogue& catalogue_;
  PriceBook prices_;
  std::vector<StageEntry> entries_;
  std::vector<CountedPart> counted_parts_;
  std::vector<OwnedFirst> owned_first_;
  std::optional<std::size_t> compared_resource_;
  std::unique_ptr<StockBars> bars_;  ///< looks at what stands above
  Shops shops_;
  solver::Problem solver_problem_;
  std::vector<std::unique_ptr<MachineModel>> scenarios_;
  std::optional<solver::ScenarioProblem> scenario_problem_;
  solver::Restriction restriction_;  ///< with something fixed
  std::optional<solver::RestrictedProblem> restricted_;
};

}  // namespace millwright::evaluation
