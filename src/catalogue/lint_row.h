// SPDX-License-Identifier: Apache-2.0
// What a plausibility rule sees: the figures of one row in their declared units, and three kinds of doubt.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "catalogue/plausibility.h"
#include "catalogue/table.h"
#include "catalogue/waivers.h"
#include "text/diagnostic.h"

namespace millwright::catalogue {

/// A range outside of which a derived quantity is odd (a warning), and one outside of which it is impossible (an
/// error).
struct Band {
  double impossible_below;
  double odd_below;
  double odd_above;
  double impossible_above;
};

/// One row under examination. Figures are in the unit of their declaration, NaN if not known; a doubt that involves a
/// NaN is not raised. `rule` is a short name that a row's `waiver` column can name to be excused. Doubts are kept until
/// `conclude`.
class LintRow {
 public:
  LintRow(const Table& table, int row, Waivers& waivers) : table_(table), row_(row), waivers_(waivers) {}

  double operator()(Column column) const;
  std::string_view text(Column column) const { return table_.text(column, row_); }

  /// error if smaller >= larger
  void below(std::string_view rule, Column smaller, Column larger) const;
  /// error if smaller > larger
  void at_most(std::string_view rule, Column smaller, Column larger) const;
  /// The column must equal `expected` (said to be `why`): a warning beyond the relative difference `odd`, an error
  /// beyond `impossible`.
  void agrees(
      std::string_view rule, Column column, double expected, double odd, double impossible, std::string_view why) const;
  /// A quantity worked out from several columns must lie in the band; blames `column`.
  void within(std::string_view rule, Column column, double value, const Band& band, std::string_view what) const;
  /// `holds` false is an error.
  void demand(std::string_view rule, Column column, bool holds, const std::string& message) const;
  /// `holds` false is a warning.
  void expect(std::string_view rule, Column column, bool holds, const std::string& message) const;

  /// Every number of the row against its declared plausible range.
  void magnitudes() const;

  /// Tells what was found, with what the relations say of the row; that takes the place of findings it explains.
  void conclude(const Plausibility& plausibility, text::Diagnostics& diagnostics) const;
  /// Tells what was found.
  void conclude(text::Diagnostics& diagnostics) const;

 private:
  struct Doubt {
    text::Severity severity;
    std::string_view rule;
    Column column;
    std::string message;
    std::string hint;
  };
  void report(
      text::Severity severity, std::string_view rule, Column column, std::string message, std::string hint = {}) const;
  std::optional<Suspicion> suspicion(const Plausibility& plausibility) const;
  void tell(const Suspicion& suspicion, text::Diagnostics& diagnostics) const;

  const Table& table_;
  int row_;
  Waivers& waivers_;
  mutable std::vector<Doubt> doubts_;
};

/// The rules of the families that drive an axis; does nothing for other families.
void lint_drive(Family family, const LintRow& row);
/// The rules of the families that hold and guide.
void lint_structure(Family family, const LintRow& row);
/// Standard designations ("Tr16x4", "M8x1", "SFU1605") against the row's figures.
void lint_designation(Family family, const LintRow& row);

}  // namespace millwright::catalogue
