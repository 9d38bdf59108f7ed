// SPDX-License-Identifier: Apache-2.0
// Is a figure of a row odd, which one, by how much, and why? The relations of the family (relation.h) are taken
// together, as evidence: a motor of ten times the inductance is off in L/R and in L I^2 / T, one of ten times the
// resistance in L/R and in I^2 R, so the row itself says which figure is wrong.
//
// Each hypothesis (all is well; a figure is falsified by one of the usual slips, see slip.h; by any other factor; two
// figures were swapped) is given a prior and the likelihood of the row's relations under it. Relations scatter about
// their usual value by Student's t of eight degrees of freedom in the logarithm, whose long tails forgive one odd but
// honest part. A row is reported when the posterior odds of all faults together pass `certainty_to_report`; the
// certainty that is told is that posterior.
//
// Usual value and spread are those declared, or, where at least `peers_needed` rows of the table are of the same kind
// and maker (or else kind), the median of those rows and their spread: as long as that median lies within 2.5 declared
// spreads of the declared value. So a column that is wrong in every row of a file cannot vouch for itself. Where rows
// of the same series (or else of the same kind and maker, or else of the same maker) agree still better, what they say
// without the row that is judged counts instead (siblings.h).
//
// Declared prices are in US dollars or euros, which are near enough to each other. Prices in any other currency are
// compared with none but prices in it, and not at all where the table has fewer than `peers_needed` of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "catalogue/relation.h"
#include "catalogue/siblings.h"
#include "catalogue/slip.h"
#include "catalogue/table.h"

namespace millwright::catalogue {

inline constexpr double certainty_to_report = 2.0 / 3.0;
inline constexpr std::size_t peers_needed = 10;

/// What is odd about a row. Figures in declared units.
struct Suspicion {
  Column column;                  ///< the figure that is probably wrong
  std::optional<Column> swapped;  ///< it was probably swapped with this one
  std::optional<Column> instead;  ///< or else this one is wrong, not much less probably
  double value = 0.0;
  double expected_low = 0.0;  ///< where the row's other figures put it, two spreads to each side
  double expected_high = 0.0;
  double factor = 1.0;                  ///< value / what it should be
  std::string_view cause;               ///< the usual slip that explains it; "" if none does
  double certainty = 0.0;               ///< that something is wrong with the row, 0 to 1
  bool impossible = false;              ///< beyond what the relation can be
  std::vector<std::string_view> rules;  ///< the relations that are off
  std::string evidence;                 ///< the one that is farthest off, in words
};

class Plausibility {
 public:
  /// Works out what is usual among the rows of `table`, which must outlive this. Time grows linearly with the rows.
  explicit Plausibility(const Table& table);

  /// Examines a row. Relations that `excused` names are left out. Nothing if the row is in order.
  std::optional<Suspicion> examine(int row, const std::function<bool(std::string_view)>& excused) const;

  /// Whether a relation of that name is off by more than its spread in the row, told or not.
  bool is_unusual(int row, std::string_view rule) const;

 private:
  static constexpr std::size_t most = 64;  ///< relations and columns of a family

  struct Part {  ///< a term: which of the kind's columns, to what power
    std::uint8_t slot;
    double exponent;
  };
  struct Active {
    const Relation* relation;
    std::vector<Part> parts;
    std::size_t index = 0;  ///< among the relations of the family
    bool priced = false;    ///< it compares money with something else, so the currency counts
  };
  struct Kind {
    std::vector<Active> relations;
    std::vector<Column> columns;
    std::vector<std::span<const double>> numbers;
    std::vector<double> offsets;  ///< logarithm of SI to that of the declared unit
    std::vector<bool> given;      ///< columns that no relation blames
    /// For each column the relations it stands in, `slot` being the relation, with its power.
    std::vector<std::vector<Part>> of_column;
    std::size_t torque = most;       ///< the column whose figure depends on how many phases are on
    std::span<const double> phases;  ///< how many are; of that family only
  };
  struct Reference {
    double centre = 0.0;  ///< logarithms
    double spread = 1.0;
    std::size_t peers = 0;  ///< rows it was learnt from, 0 = as declared
    double least = 0.0;     ///< residuals beyond these are impossible
    double greatest = 0.0;
    [[nodiscard]] bool excludes(double residual) const { return residual < least || residual > greatest; }
  };
  struct Group {
    std::uint32_t kind = 0;
    std::vector<Reference> references;
    std::string_view currency;  ///< where that is neither USD nor EUR
  };
  using OwnPrices = std::unordered_map<const Relation*, Reference>;
  struct Evidence;  ///< the logarithms and residuals of one row

  /// Rows that are compared with each other, from the closest kin to the widest.
  struct Kinship {
    std::vector<std::uint32_t> group_of_row;
    std::vector<std::uint32_t> place_of_group;  ///< in `siblings`, none if it is too small
    Siblings siblings;
  };
  static constexpr std::uint32_t none = 0xffffffff;

  Kind make_kind(std::string_view name) const;
  void group_rows(std::vector<std::vector<int>>& rows_of_group);
  void logarithms(const Kind& kind, int row, double* logs) const;
  double with_all_phases(const Kind& kind, std::size_t slot, int row) const;
  std::vector<Reference> learn(const Kind& kind,
                               const std::vector<int>& rows,
                               const std::vector<Reference>& otherwise) const;
  OwnPrices learn_prices(const std::vector<int>& rows) const;
  static double least_spread(const Relation& relation);
  void learn_kinships();
  std::vector<std::uint32_t> groups_by_series() const;
  std::vector<std::uint32_t> groups_by_maker() const;
  Kinship learn_kinship(std::vector<std::uint32_t> group_of_row) const;
  /// The group's reference, or that of the row's closest siblings where they agree better. `sum`: the logarithm of the
  /// relation in this row.
  Reference reference_for(const Group& group, const Kind& kind, std::size_t relation, int row, double sum) const;
  struct Fault;
  static std::vector<Fault> faults_of(const Kind& kind, const Evidence& row);
  /// What speaks for a fault: expected range, rules, evidence. False if no relation does.
  static bool explain(const Kind& kind, const Evidence& row, const Fault& fault, Suspicion& found);
  static std::size_t price_in_question(const Kind& kind, const Evidence& row, std::size_t figure);
  static Suspicion describe(const Kind& kind, const Evidence& row);

  const Table& table_;
  std::vector<Kind> kinds_;
  std::vector<Group> groups_;
  std::vector<std::uint32_t> group_of_row_;
  std::vector<Kinship> kinships_;
};

}  // namespace millwright::catalogue
