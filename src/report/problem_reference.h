// SPDX-License-Identifier: Apache-2.0
// What may stand in a problem file, for people (Markdown) and for editors (a JSON Schema), both from what the readers
// ask (machine/problem_keys.h).
#pragma once

#include <string>

namespace millwright::report {

/// One section a table; every key with what may stand there, its default and the source of that.
std::string problem_reference();

/// JSON Schema, draft 7, which editors of TOML understand. It knows keys, kinds of values, words and plain bounds; that
/// quantities have the right dimension, and everything between two keys, only the program itself can tell.
std::string problem_schema();

}  // namespace millwright::report
