// SPDX-License-Identifier: Apache-2.0
// What is said about figures that are only known within a tolerance (evaluation/tolerance_check.h).
#pragma once

#include <string>

#include "evaluation/explanation.h"
#include "report/page_texts.h"
#include "report/result.h"
#include "report/text_table.h"

namespace millwright::report {

/// The verdict in a line or two, then what breaks the build. "" where it was not asked for.
std::string tolerances_text(const MachineResult& result,
                            const evaluation::Design& design,
                            const Style& style,
                            const Texts& t = Texts(Language::english));

/// Whether it was asked to hold within tolerances, and the best design has any.
bool robust_to_something(const MachineResult& result);

/// What --robust says of a whole front; empty without it.
std::string robust_front_text(const MachineResult& result, const Texts& t);

/// Of `explain`: which figure would break the build, and what would be chosen if one were at an end of its tolerance.
std::string tolerance_choices_text(const MachineResult& result,
                                   const evaluation::Explanation& explanation,
                                   const Style& style);

/// "rotor_inertia 82 g.cm2 ±25 %".
std::string figure_text(const evaluation::TolerancedFigure& figure);

}  // namespace millwright::report
