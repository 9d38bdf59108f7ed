// SPDX-License-Identifier: Apache-2.0
// Two builds of one machine side by side: totals, parts that changed, checks that are used differently.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/ledger.h"
#include "report/text_table.h"

namespace millwright::report {

/// One of both, with where its figures come from.
struct ComparedBuild {
  std::string file;
  std::string origin;  ///< "as recorded by solve of m.toml", "a bill of materials, computed now with m.toml"
  std::string title;   ///< of the problem
  std::vector<std::string> axes;
  evaluation::Design design;
};

/// A slot that is filled differently: another part, or the same in another number, length, price or mass. Null where a
/// build has nothing there. The pointers are into the builds.
struct PartChange {
  std::string axis, slot;
  const evaluation::PartLine* a = nullptr;
  const evaluation::PartLine* b = nullptr;
  [[nodiscard]] double price() const { return (b != nullptr ? b->price : 0.0) - (a != nullptr ? a->price : 0.0); }
  [[nodiscard]] double mass() const { return (b != nullptr ? b->mass : 0.0) - (a != nullptr ? a->mass : 0.0); }
};

/// A dimension or setting of another value; nothing where a build has none.
struct DimensionChange {
  std::string axis, name, unit;  ///< SI
  std::optional<double> a, b;
};

/// A check that is used differently, or that only one of both has.
struct CheckChange {
  const evaluation::Check* a = nullptr;
  const evaluation::Check* b = nullptr;
  [[nodiscard]] const evaluation::Check& either() const { return b != nullptr ? *b : *a; }
  /// Fails in one and not in the other.
  [[nodiscard]] bool turns() const;
  /// By how much more of the limit b uses; infinite where only one of both has a figure.
  [[nodiscard]] double change() const;
};

struct Comparison {
  std::vector<PartChange> parts;            ///< the largest difference in price first, then in mass
  std::vector<DimensionChange> dimensions;  ///< in the order of b
  std::vector<CheckChange> checks;          ///< those that fail in one only first, then the largest change
  std::size_t same_parts = 0;
  std::size_t same_checks = 0;  ///< used alike, to a hundredth of a percent of the limit
};

/// The builds must live as long as what is returned.
Comparison compare(const ComparedBuild& a, const ComparedBuild& b);

/// Hard checks that fail.
std::size_t failed_checks(const evaluation::Design& design);

std::string comparison_text(const ComparedBuild& a, const ComparedBuild& b, const Style& style);
std::string comparison_json(const ComparedBuild& a, const ComparedBuild& b);

}  // namespace millwright::report
