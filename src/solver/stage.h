// SPDX-License-Identifier: Apache-2.0
//
// What the search knows of a problem.
//
// A problem is a chain of stages. Each stage has slots (tables of which one row is chosen), continuous variables, and
// constraints written as utilisations (demand/capacity, satisfied when <= 1). It receives a state vector from the stage
// before it, adds to the resources (cost, mass, ...: additive, smaller is better) and hands a new state vector on. A
// few choices are shared by all stages; the search tries every combination of them.
//
//     shared choices ------------+----------------+----------------+
//                                v                v                v
//     first state --> [ stage 0 ] --state--> [ stage 1 ] --state--> [ stage 2 ] --> ...
//                       slots, variables, constraints, resources
//
// Proofs rest on three questions that a stage answers:
//   evaluate  one design: exact utilisations, resources and the state handed on;
//   bound     a set of designs (row sets times intervals): intervals that contain every member's answer;
//   slopes    a set of designs: intervals that contain every member's derivatives with respect to one continuous input.
// Nothing about the direction in which anything matters is assumed: monotonicity is proved from `slopes` or not used.
// `fits` and `offered` say what may be chosen. All else (`read`, `fit_key`, `row_kind`, `graded_readings`, ...) makes
// the search faster, and what it is where a stage does not say is always right. `gradient` serves local solvers, whose
// points count only once they have been evaluated.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "scalar/interval.h"

namespace millwright::solver {

using scalar::Interval;
using scalar::rounding::infinity;
using Row = std::uint32_t;

/// A table of which exactly one row is chosen.
struct Slot {
  std::string name;
  Row rows = 0;
};

/// A continuous design variable in SI with its bounds.
struct Variable {
  std::string name;
  double lower = 0.0;
  double upper = 0.0;
};

/// One design of one stage. `shared` holds the chosen row of every shared choice.
struct Point {
  std::span<const Row> shared;
  std::span<const double> inherited;  ///< state handed on by the stage before
  std::span<const Row> rows;          ///< one per slot
  std::span<const double> variables;  ///< one per continuous variable
};

/// The rows alive of one slot, ascending, never empty, with what the stage reads of them (`Stage::read`; no readings:
/// it was not asked).
struct RowsAlive {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::span<const Row> rows;
  std::span<const Interval> readings = {};
  std::size_t with_respect_to = none;  ///< the reading by which slopes are asked for

  RowsAlive() = default;
  RowsAlive(std::span<const Row> alive, std::span<const Interval> read = {})  // NOLINT(google-explicit-constructor)
      : rows(alive), readings(read) {}
  RowsAlive(const std::vector<Row>& alive) : rows(alive) {}  // NOLINT(google-explicit-constructor)

  operator std::span<const Row>() const { return rows; }  // NOLINT(google-explicit-constructor)
  [[nodiscard]] std::size_t size() const { return rows.size(); }
  [[nodiscard]] Row front() const { return rows.front(); }
  [[nodiscard]] Row operator[](std::size_t i) const { return rows[i]; }
  [[nodiscard]] auto begin() const { return rows.begin(); }
  [[nodiscard]] auto end() const { return rows.end(); }
};

/// A set of designs of one stage: all combinations of the rows alive and all values in the intervals.
struct Box {
  std::span<const Row> shared;  ///< shared choices are always fixed
  std::span<const Interval> inherited;
  std::span<const RowsAlive> rows;  ///< of each slot
  std::span<const Interval> variables;
  /// Bit c % 64: constraint c is known to be kept by every design in it. `bound` may say [0, 0] of its utilisation
  /// instead of working it out.
  std::uint64_t kept = 0;
};

/// A utilisation above 1 by no more than sums of decimals are rounded by in binary is 1: 24 W with a reserve of 2.2 are
/// 52.8 W, and in binary a little more. The search takes states as equal that are the same sum in another order
/// (criteria.h), so a stage must let all of them keep a limit, or none.
inline double without_rounding(double utilisation) {
  constexpr double most = 1.0 + 1e-12;
  return utilisation > 1.0 && utilisation <= most ? 1.0 : utilisation;
}
inline Interval without_rounding(const Interval& utilisation) {
  return {without_rounding(utilisation.lower), without_rounding(utilisation.upper)};
}

/// What a stage answers. T is double for a design and Interval for a set of designs or for slopes.
template <class T>
struct Answer {
  std::vector<T> utilisation;  ///< one per constraint; satisfied when <= 1 (see without_rounding)
  std::vector<T> resources;    ///< one per resource of the problem; this stage's own share
  std::vector<T> handed_on;    ///< the state for the next stage, as long as `inherited`
};

/// With respect to what a slope is taken.
struct Input {
  enum class Kind { variable, inherited, reading } kind = Kind::variable;
  std::size_t index = 0;
  std::size_t slot = 0;  ///< of a reading
};

/// What decides which rows of another slot a row fits: rows with equal keys fit the same ones.
struct FitKey {
  double first = 0.0, second = 0.0;
  friend bool operator==(const FitKey& a, const FitKey& b) = default;
};

/// A part of the problem with its own choices. Implementations are immutable and may be called from several threads.
class Stage {
 public:
  virtual ~Stage() = default;

  [[nodiscard]] virtual const std::string& name() const = 0;
  [[nodiscard]] virtual std::span<const Slot> slots() const = 0;
  [[nodiscard]] virtual std::span<const Variable> variables() const = 0;
  [[nodiscard]] virtual std::size_t constraints() const = 0;

  /// Exact answer for one design. A quantity that cannot be computed makes its utilisation 1e9 or more (never NaN).
  /// What a design that keeps every constraint hands on and adds to the resources is finite.
  virtual void evaluate(const Point& point, Answer<double>& answer) const = 0;

  /// Intervals that contain what this stage reads of every one of these rows (a column's smallest and largest number,
  /// say). The search asks once for each set of rows that it makes and hands the answer back with every question about
  /// it; how many intervals there are, and what they mean, is the stage's own affair. To find out what each matters to,
  /// `bound` is asked about parts of them too (row_profile.h); of such answers nothing is proved. Default: none.
  virtual void read(std::span<const Row> /*shared*/,
                    std::size_t /*slot*/,
                    std::span<const Row> /*rows*/,
                    std::vector<Interval>& readings) const {
    readings.clear();
  }
  /// Whether what `read` says of rows of a slot hangs on the shared choices: if not, long tables are read once for all
  /// of them. Default: it may.
  [[nodiscard]] virtual bool reads_shared(std::size_t /*slot*/) const { return true; }

  /// Intervals that contain the answers of every design in the box.
  virtual void bound(const Box& box, Answer<Interval>& answer) const = 0;

  /// Intervals that contain the derivatives of every answer with respect to `input`, over the box.
  virtual void slopes(const Box& box, Input input, Answer<Interval>& answer) const = 0;

  /// How many of a slot's readings, from the first on, are quantities of a row that `slopes` can be asked about: all
  /// that tells rows of one kind (`row_kind`) with equal other readings apart. Rows that others are proved to be at
  /// least as good as are left out (row_dominance.h). Default: none, then no two rows are compared.
  [[nodiscard]] virtual std::size_t graded_readings(std::size_t /*slot*/) const { return 0; }
  /// See `graded_readings`. Default: every row is of a kind of its own.
  [[nodiscard]] virtual std::size_t row_kind(std::size_t /*slot*/, Row row) const { return row; }

  /// Exact derivatives at one design, by a variable or an inherited state: the same as `slopes` on a degenerate box,
  /// but in double (for local solvers).
  virtual void gradient(const Point& point, Input input, Answer<double>& answer) const = 0;

  /// Whether a row can be chosen at all with these shared choices. The search looks at no other; `evaluate` and `bound`
  /// may say about others what they like. Default: all can.
  [[nodiscard]] virtual bool offered(std::span<const Row> /*shared*/, std::size_t /*slot*/, Row /*row*/) const {
    return true;
  }

  /// Whether two rows of two slots can never be in one design together (a fit that needs nothing else). The search uses
  /// it to discard combinations early; `bound` must agree. Default: everything may fit.
  [[nodiscard]] virtual bool fits(std::span<const Row> /*shared*/,
                                  std::size_t /*slot_a*/,
                                  Row /*row_a*/,
                                  std::size_t /*slot_b*/,
                                  Row /*row_b*/) const {
    return true;
  }
  /// What `fits` reads of a row when it is asked about another slot: catalogues hold many parts of one bore, and only
  /// one of them is asked about. Default: every row is a kind of its own.
  [[nodiscard]] virtual FitKey fit_key(std::span<const Row> /*shared*/,
                                       std::size_t /*slot*/,
                                       Row row,
                                       std::size_t /*other_slot*/) const {
    return {static_cast<double>(row), 0.0};
  }
  /// Whether `fits` can say no about two slots at all; if not, the search need not ask about every pair of rows.
  [[nodiscard]] virtual bool may_misfit(std::size_t /*slot_a*/, std::size_t /*slot_b*/) const { return true; }

  /// How many designs these rows of each slot make, to be reported. Default: every row with every other one. A stage
  /// that has one part as several rows, of which the rest of the design leaves one, counts it once.
  [[nodiscard]] virtual double combinations(std::span<const std::vector<Row>> rows) const {
    double product = 1.0;
    for (const std::vector<Row>& of_slot : rows) product *= static_cast<double>(of_slot.size());
    return product;
  }
};

/// Something additive over stages: cost, mass, power... Smaller is better.
struct Resource {
  std::string name;
  double limit = std::numeric_limits<double>::infinity();  ///< total must not exceed this
};

/// Says that the total of `resource` is never less than that of `bound`, whatever is chosen. So what a stage adds
/// according to its state can be bounded by sums to which it adds nothing of the kind.
struct Floor {
  std::size_t resource = 0;
  std::size_t bound = 0;
};

/// A whole problem: stages from the tool to the base.
struct Problem {
  std::vector<Slot> shared;          ///< choices every stage sees
  std::vector<double> first_state;   ///< what the first stage inherits
  std::vector<const Stage*> stages;  ///< not owned
  std::vector<Resource> resources;   ///< every stage's answer has one entry for each
  std::vector<Floor> floors = {};
  /// Components of the state that are read for nothing but to make a total the largest of its floors and of what the
  /// stages before have added to it. Of two designs whose totals and floors are no larger, neither need be compared in
  /// these.
  std::vector<std::size_t> states_in_floors = {};
};

}  // namespace millwright::solver
