// SPDX-License-Identifier: Apache-2.0
//
// For the certificate: by which methods an answer was found.
#pragma once

#include <string>

namespace millwright::solver {

/// Builds no worse than the answer, where a search of its own looks for the best of them in what is compared next.
enum class AmongEquals { not_looked_for, some, all };

struct MethodsUsed {
  bool priced = false;      ///< continuous variables move the objectives
  bool front = false;       ///< there are several
  bool stagewise = false;   ///< frontier.h
  bool in_turn = false;     ///< first frontier.h, then, from the builds found, branch_and_bound.h
  bool allowances = false;  ///< rest_plane.h
  bool by_front = false;    ///< of a single objective and a resource that is limited (SolveRun::settle_by_front)
  AmongEquals among_equals = AmongEquals::not_looked_for;  ///< SolveRun::best_among_equals
};

std::string sentence_of(const MethodsUsed& used);

}  // namespace millwright::solver
