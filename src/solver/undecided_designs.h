// SPDX-License-Identifier: Apache-2.0
//
// What a search label by label has left undecided, so that the next one, with a finer tolerance, looks at nothing else.
//
// One label stands for many designs where variables move scores or states (labels.h). What becomes of them may stay
// undecided: a limit holds for some and not for others, or no build known settles them. Then the labels that led there
// are noted, a tree like theirs: rows and the boxes of variables that a label stands for, and what may follow it.
//
// Nothing better is missed that way. Follow a build that is better than all known by more than is tolerated through the
// search that left the tree: each part of it lies in a box of a label, or of one that is dominated by another label;
// with that one's own point in place of what stands before, the build is as good (dominance.h), so go on with it. What
// was followed ends in a build, which is not so, or is noted here. What is looked at in the next search but was settled
// in this one is no loss either: the same designs after a better label would be better than what they were settled by
// (or as good, where two labels are equal to the last digit in every score and state).
#pragma once

#include <map>
#include <vector>

#include "solver/labels.h"

namespace millwright::solver {

class UndecidedDesigns {
 public:
  using Origin = OpenBox::Origin;

  /// Nothing is decided.
  UndecidedDesigns() : followers_(1) {}
  static constexpr Origin everything = 0;

  /// What is left after the first label.
  [[nodiscard]] Origin root() const { return static_cast<Origin>(followers_.size() > 1 ? 1 : everything); }

  /// The boxes in which a design is undecided that follows labels of these origins, each with the origin of what comes
  /// of it; no sides: the whole box.
  [[nodiscard]] std::vector<OpenBox> boxes(const std::vector<Origin>& origins, const std::vector<Row>& rows) const;

  /// A new origin; the first one is the root.
  Origin add_origin();
  void add(Origin origin, const std::vector<Row>& rows, OpenBox box);

 private:
  std::vector<std::map<std::vector<Row>, std::vector<OpenBox>>> followers_;  ///< [origin]
};

}  // namespace millwright::solver
