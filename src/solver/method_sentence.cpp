// SPDX-License-Identifier: Apache-2.0
#include "solver/method_sentence.h"

namespace millwright::solver {

std::string sentence_of(const MethodsUsed& used) {
  std::string text =
      "best-first branch and bound with outward-rounded interval bounds over row sets and boxes, labels between stages "
      "with dominance in proved directions only, every shared choice tried";
  if (used.stagewise || used.in_turn) text += "; stage by stage, with the designs of a stage found once for all labels";
  if (used.in_turn) text += "; then label by label, from the builds found that way";
  if (used.allowances) text += "; allowances that stages share at prices (Lagrangian bounds)";
  if (used.limit) text += "; what is limited at prices (Lagrangian bounds)";
  if (used.by_front) text += "; as the end of a front, of the objective and of what is limited";
  if (used.covered && used.whole_front)
    text += "; where continuous variables move the objectives the front is covered to its tolerance";
  if (used.covered)
    text += "; continuous variables that move the objective by SLSQP and Ipopt proposals inside the bound";
  if (used.among_equals == AmongEquals::all)
    text += "; of builds that are no worse the best in what is compared next, by a search of its own";
  if (used.among_equals == AmongEquals::some)
    text += "; of builds that are no worse not all were compared in what comes next";
  return text;
}

}  // namespace millwright::solver
