// SPDX-License-Identifier: Apache-2.0
//
// What may stand in a problem file: every table with its keys, as the readers themselves ask for them. They are run
// over small files that are made up for it, each with one more key than the file in which a reader first asked for that
// key, until no question is new. So nothing is declared twice, and a key that no reader asks for cannot be here.
#pragma once

#include <string>
#include <vector>

#include "text/question.h"

namespace millwright::machine {

/// A key of a table.
struct ProblemKey {
  std::string name;  ///< "*" for any name (of an axis, of a currency)
  std::string meaning;
  std::vector<text::Question> forms;  ///< what may stand there; more than one where it may be written in several ways
  bool required = false;              ///< in every file
};

/// The keys of one kind of a table: of a mechanism with kind = "belt", of an axis that turns.
struct ProblemTableKind {
  std::string name;  ///< "belt"; empty where there is but one
  std::vector<ProblemKey> keys;
};

struct ProblemTable {
  std::string path;  ///< axis.moves; empty for the outermost. Lists are not told from tables
  std::vector<ProblemTableKind> kinds;
  bool told_by_own_kind = false;  ///< by its key `kind`; else by the mechanism of the axis: an axis turns or does not
};

/// The kind of an axis, and of its moves, whose mechanism is a rotary one, and of the others.
inline constexpr const char* axis_that_turns = "rotary";
inline constexpr const char* axis_that_goes = "straight";

/// All tables, each before those inside it.
std::vector<ProblemTable> problem_tables();

/// Whether such a key may hold a table, or several.
bool holds_tables(const text::Question& form);

}  // namespace millwright::machine
