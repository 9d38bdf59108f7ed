// SPDX-License-Identifier: Apache-2.0
//
// Groups of labels for which the designs of a stage are found together (candidates.h). A region is bounded once, over a
// range of states that holds those of all groups it may still matter to; here is what that says for each of them.
#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "solver/candidates.h"

namespace millwright::solver {

/// Some of the groups, as bits.
using GroupSet = std::uint32_t;
inline constexpr std::size_t most_groups = 32;

template <class Visit>
void for_each_group(GroupSet groups, Visit&& visit) {
  for (; groups != 0; groups &= groups - 1) visit(static_cast<std::size_t>(std::countr_zero(groups)));
}

class CandidateGroups {
 public:
  /// The questions, one a group, at least one and no more than `most_groups`, are about one stage, and outlive this.
  /// Neighbours are alike in their states.
  explicit CandidateGroups(std::span<const CandidateQuestion* const> questions);

  /// What bounds over a range of states say for one group that lies in it.
  struct Carried {
    /// [handed-on component]: to add to its lower and its upper bound for those at the group's reference state.
    std::vector<std::pair<double, double>> to_reference;
    /// [handed-on component]: to add to its lower bound for that over the group's own states.
    std::vector<double> to_own_states;
  };
  /// Of neighbouring groups.
  struct View {
    std::vector<Interval> states;  ///< that hold those of all
    /// [handed-on component]: to add to its lower and its upper bound for that as if nothing had been inherited.
    std::vector<std::pair<double, double>> to_own_share;
    std::size_t first = 0;
    std::vector<Carried> carried;  ///< [group - first]
    [[nodiscard]] const Carried& of(std::size_t group) const { return carried[group - first]; }
  };

  [[nodiscard]] std::size_t count() const { return questions_.size(); }
  [[nodiscard]] GroupSet all() const { return static_cast<GroupSet>((std::uint64_t{1} << count()) - 1); }
  [[nodiscard]] const CandidateQuestion& question(std::size_t group) const { return *questions_[group]; }
  /// The state of a group at which its states are compared.
  [[nodiscard]] const std::vector<double>& reference(std::size_t group) const { return references_[group]; }
  /// Of these groups, and what lies between them. Stays where it is.
  const View& view(GroupSet groups);

  /// Whether a region with these bounds may change the known front together with some label of a group.
  [[nodiscard]] bool may_matter(std::size_t group, const View& view, const Bounds& bounds) const;
  /// The least of the question's mix, with some label of the group and what must follow.
  [[nodiscard]] double least_total(std::size_t group, const View& view, const Bounds& bounds) const;
  /// The key of the best that a region with these bounds may be at the group's reference.
  void best_key(std::size_t group, const View& view, const Bounds& bounds, std::vector<double>& key) const;
  /// The same of what it adds: one for all groups.
  void best_own_key(const View& view, const Bounds& bounds, std::vector<double>& key) const;

 private:
  [[nodiscard]] Carried carry(std::size_t group, std::span<const Interval> states) const;
  [[nodiscard]] bool may_lead_on(std::size_t group, const View& view, const Bounds& bounds) const;

  std::vector<const CandidateQuestion*> questions_;
  std::vector<std::vector<double>> references_;
  std::map<std::pair<int, int>, std::unique_ptr<const View>> views_;  ///< [first, last group]
};

}  // namespace millwright::solver
