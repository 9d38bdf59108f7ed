// SPDX-License-Identifier: Apache-2.0
//
// For the certificate: by which methods an answer was found.
#pragma once

#include <string>

namespace millwright::solver {

/// Builds no worse than the answer: `some` were compared in what comes next where a search was cut short; `all`, by a
/// search of its own, where continuous variables move the objective. (Else searches compare all of them on the way.)
enum class AmongEquals { not_looked_for, some, all };

struct MethodsUsed {
  bool covered = false;      ///< continuous variables move the objectives
  bool whole_front = false;  ///< there are several, and the search was not ended before
  bool stagewise = false;    ///< stagewise_search.h
  bool in_turn = false;      ///< first stagewise_search.h, then, from the builds found, branch_and_bound.h
  bool allowances = false;   ///< rest_plane.h
  bool by_front = false;     ///< of a single objective and a resource that is limited (SolveRun::settle_by_front)
  AmongEquals among_equals = AmongEquals::not_looked_for;
  bool limit = false;  ///< limit_prices.cpp
};

std::string sentence_of(const MethodsUsed& used);

}  // namespace millwright::solver
